//! Vectors whose storage is used again.
//!
//! A contact is solved with some hundred short vectors, one after the other: each thread keeps their storage.
use std::cell::RefCell;
use std::ops::{Deref, DerefMut};

/// Longer vectors are not kept: their storage costs less than what is done with them.
const LONGEST: usize = 1 << 20;
/// Numbers kept per power of two of the length; one vector at least.
const KEPT: usize = 1 << 17;
const CLASSES: usize = LONGEST.trailing_zeros() as usize + 1;

thread_local! {
    static FREE: RefCell<[Vec<Vec<f64>>; CLASSES]> = const { RefCell::new([const { Vec::new() }; CLASSES]) };
}

/// A vector of numbers, which leaves its storage to the next one.
#[derive(Debug, Default)]
pub(crate) struct Buffer(Vec<f64>);

impl Buffer {
    /// One with room for `length` numbers, and anything in it.
    fn with_room(length: usize) -> Self {
        if length == 0 || length > LONGEST {
            return Self(Vec::with_capacity(length));
        }
        let class = length.next_power_of_two().trailing_zeros() as usize;
        let free = FREE.try_with(|free| free.borrow_mut()[class].pop()).unwrap_or_default();
        Self(free.unwrap_or_else(|| Vec::with_capacity(1 << class)))
    }

    /// So many numbers, to be overwritten.
    pub(crate) fn any(length: usize) -> Self {
        let mut buffer = Self::with_room(length);
        buffer.0.resize(length, 0.0);
        buffer
    }

    /// So many zeros.
    pub(crate) fn zeros(length: usize) -> Self {
        let mut buffer = Self::any(length);
        buffer.fill(0.0);
        buffer
    }

    /// These numbers.
    pub(crate) fn of(values: &[f64]) -> Self {
        let mut buffer = Self::any(values.len());
        buffer.copy_from_slice(values);
        buffer
    }

    /// Makes it longer with zeros, or shorter.
    pub(crate) fn resize(&mut self, length: usize) {
        if length > self.0.capacity() {
            let mut longer = Self::zeros(length);
            longer[..self.len()].copy_from_slice(&self.0);
            *self = longer;
        }
        self.0.resize(length, 0.0);
    }
}

impl Drop for Buffer {
    fn drop(&mut self) {
        let capacity = self.0.capacity();
        if capacity == 0 || capacity > LONGEST {
            return;
        }
        // what was not asked for here may have any capacity
        let class = capacity.ilog2() as usize;
        let own = std::mem::take(&mut self.0);
        let _ = FREE.try_with(|free| {
            let free = &mut free.borrow_mut()[class];
            if free.is_empty() || free.len() << class < KEPT {
                free.push(own);
            }
        });
    }
}

impl Deref for Buffer {
    type Target = [f64];

    fn deref(&self) -> &[f64] {
        &self.0
    }
}

impl DerefMut for Buffer {
    fn deref_mut(&mut self) -> &mut [f64] {
        &mut self.0
    }
}

impl Clone for Buffer {
    fn clone(&self) -> Self {
        Self::of(&self.0)
    }
}

impl Extend<f64> for Buffer {
    fn extend<I: IntoIterator<Item = f64>>(&mut self, values: I) {
        self.0.extend(values);
    }
}

impl FromIterator<f64> for Buffer {
    fn from_iter<I: IntoIterator<Item = f64>>(values: I) -> Self {
        let values = values.into_iter();
        let mut buffer = Self::with_room(values.size_hint().0);
        buffer.0.clear();
        buffer.0.extend(values);
        buffer
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn storage_is_used_again_and_what_is_in_it_is_not() {
        let mut first = Buffer::zeros(100);
        first.fill(7.0);
        let place = first.as_ptr();
        drop(first);
        let mut second = Buffer::zeros(90);
        assert_eq!((second.as_ptr(), second.len()), (place, 90));
        assert!(second.iter().all(|value| *value == 0.0));
        second.resize(200);
        assert_eq!((second.len(), second[199]), (200, 0.0));
        assert_eq!(&*Buffer::of(&[1.0, 2.0]), &*(1..3).map(f64::from).collect::<Buffer>());
        assert!(Buffer::zeros(0).is_empty());
        assert_eq!(Buffer::zeros(LONGEST + 1).clone().len(), LONGEST + 1);
    }
}
