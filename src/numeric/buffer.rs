//! Vectors whose storage is used again.
//!
//! A contact is solved with some hundred short vectors, one after the other: each thread keeps their storage.
use std::cell::RefCell;
use std::ops::{Deref, DerefMut};

/// Longer vectors are not kept: their storage costs less than what is done with them.
const LONGEST: usize = 1 << 18;
/// Numbers kept per power of two of the length; one vector at least.
const KEPT: usize = 1 << 17;
const CLASSES: usize = LONGEST.trailing_zeros() as usize + 1;

thread_local! {
    static FREE: RefCell<[Vec<Vec<f64>>; CLASSES]> = const { RefCell::new([const { Vec::new() }; CLASSES]) };
}

/// A vector of numbers, which leaves its storage to the next one.
#[derive(Debug, Default)]
pub(crate) struct Buffer {
    /// Longer than the vector, as a rule: what is beyond need not be cleared to be used again.
    storage: Vec<f64>,
    length: usize,
}

impl Buffer {
    /// One with room for `length` numbers, none of them in it.
    fn with_room(length: usize) -> Self {
        let storage = if length == 0 {
            Vec::new()
        } else if length > LONGEST {
            vec![0.0; length]
        } else {
            let class = length.next_power_of_two().trailing_zeros() as usize;
            let free = FREE.try_with(|free| free.borrow_mut()[class].pop()).unwrap_or_default();
            free.unwrap_or_else(|| vec![0.0; 1 << class])
        };
        Self { storage, length: 0 }
    }

    /// So many numbers, to be overwritten.
    pub(crate) fn any(length: usize) -> Self {
        let mut buffer = Self::with_room(length);
        buffer.length = length;
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
        let before = self.length;
        self.make_room(length);
        self.length = length;
        if length > before {
            self[before..].fill(0.0);
        }
    }

    fn make_room(&mut self, length: usize) {
        if length > self.storage.len() {
            let mut longer = Self::with_room(length);
            longer.storage[..self.length].copy_from_slice(self);
            // what is left is kept
            std::mem::swap(&mut self.storage, &mut longer.storage);
        }
    }
}

impl Drop for Buffer {
    fn drop(&mut self) {
        let room = self.storage.len();
        if room == 0 || room > LONGEST {
            return;
        }
        let class = room.ilog2() as usize;
        let own = std::mem::take(&mut self.storage);
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
        &self.storage[..self.length]
    }
}

impl DerefMut for Buffer {
    fn deref_mut(&mut self) -> &mut [f64] {
        &mut self.storage[..self.length]
    }
}

impl Clone for Buffer {
    fn clone(&self) -> Self {
        Self::of(self)
    }
}

impl Extend<f64> for Buffer {
    fn extend<I: IntoIterator<Item = f64>>(&mut self, values: I) {
        let values = values.into_iter();
        self.make_room(self.length + values.size_hint().0);
        values.for_each(|value| {
            // an iterator may have more than it says
            if self.length == self.storage.len() {
                self.make_room(2 * self.length + 1);
            }
            self.storage[self.length] = value;
            self.length += 1;
        });
    }
}

impl FromIterator<f64> for Buffer {
    fn from_iter<I: IntoIterator<Item = f64>>(values: I) -> Self {
        let mut buffer = Self::default();
        buffer.extend(values);
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
        let odd = |limit: usize| (0..limit).filter(|k| k % 2 == 1).map(|k| k as f64);
        assert_eq!(odd(900).collect::<Buffer>().to_vec(), odd(900).collect::<Vec<f64>>());
        assert_eq!(&*Buffer::of(&[1.0, 2.0]), &*(1..3).map(f64::from).collect::<Buffer>());
        assert!(Buffer::zeros(0).is_empty());
        assert_eq!(Buffer::zeros(LONGEST + 1).clone().len(), LONGEST + 1);
    }
}
