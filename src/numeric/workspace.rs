//! Storage of tables that are not needed any more, for the tables that follow.
use std::collections::BTreeMap;
use std::sync::Mutex;

/// Longer tables are given back: their storage costs less than what is done with them.
const LONGEST: usize = 1 << 21;

/// Storage that is used again: the system would have to clear new memory page by page, and contacts next to graded layers would take 1.3 times
/// the time. As many tables are kept as there were at once, by how many numbers they have room for.
#[derive(Debug, Default)]
pub(crate) struct Workspace(Mutex<BTreeMap<usize, Vec<Vec<f64>>>>);

impl Workspace {
    /// A table of this length, to be overwritten.
    pub(crate) fn take(&self, length: usize) -> Vec<f64> {
        let shortest = |kept: &mut BTreeMap<usize, Vec<Vec<f64>>>| {
            let room = kept.range(length..).next().map(|(room, _)| *room);
            // where none is long enough the longest one gives way to one that is
            let own = room.map_or_else(|| kept.keys().next_back().copied(), Some)?;
            let tables = kept.get_mut(&own)?;
            let table = tables.pop();
            if tables.is_empty() {
                kept.remove(&own);
            }
            table.filter(|_| room.is_some())
        };
        let kept = self.0.lock().ok().and_then(|mut kept| shortest(&mut kept));
        let mut numbers = kept.unwrap_or_else(|| vec![0.0; length]);
        numbers.resize(length, 0.0);
        numbers
    }

    /// Keeps storage for the next table.
    pub(crate) fn keep(&self, numbers: Vec<f64>) {
        if let Ok(mut kept) = self.0.lock()
            && numbers.capacity() <= LONGEST
        {
            kept.entry(numbers.capacity()).or_default().push(numbers);
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
