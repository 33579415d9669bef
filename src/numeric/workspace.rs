//! Storage of tables that are not needed any more, for the tables that follow.
use std::sync::Mutex;

/// Longer tables are given back: their storage costs less than what is done with them.
const LONGEST: usize = 1 << 21;

/// Storage that is used again: the system would have to clear new memory page by page, and contacts next to graded layers would take 1.3 times
/// the time. As many tables are kept as there were at once.
#[derive(Debug, Default)]
pub(crate) struct Workspace(Mutex<Vec<Vec<f64>>>);

impl Workspace {
    /// A table of this length, to be overwritten.
    pub(crate) fn take(&self, length: usize) -> Vec<f64> {
        let shortest_long_enough = |kept: &mut Vec<Vec<f64>>| {
            let long_enough = kept.iter().enumerate().filter(|(_, numbers)| numbers.capacity() >= length);
            let place = long_enough.min_by_key(|(_, numbers)| numbers.capacity()).map(|(place, _)| place);
            // a shorter one gives way to one that is long enough
            kept.pop_if(|_| place.is_none());
            place.map(|place| kept.swap_remove(place))
        };
        let Some(mut numbers) = self.0.lock().ok().and_then(|mut kept| shortest_long_enough(&mut kept)) else {
            return vec![0.0; length];
        };
        numbers.resize(length, 0.0);
        numbers
    }

    /// Keeps storage for the next table.
    pub(crate) fn keep(&self, numbers: Vec<f64>) {
        if let Ok(mut kept) = self.0.lock()
            && numbers.capacity() <= LONGEST
        {
            kept.push(numbers);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn storage_is_used_again() {
        let workspace = Workspace::default();
        let first = workspace.take(100);
        let place = first.as_ptr();
        workspace.keep(first);
        let second = workspace.take(90);
        assert_eq!((second.as_ptr(), second.len()), (place, 90));
        workspace.keep(vec![0.0; LONGEST + 1]);
        assert_eq!(workspace.take(7).capacity(), 7);
    }
}
