//! Chunks of rows: what is solved in one go, by whomever.
use std::collections::VecDeque;
use std::ops::Range;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use super::{Row, Sweep};
use crate::error::Error;
use crate::model::Model;
use crate::scene::Owner;
use crate::solution::Solution;

/// Rows of a chunk, at most: more would keep one thread busy when the others have finished.
const LONGEST: usize = 32;
/// So many chunks there are at least, if there are as many rows.
const FEWEST: usize = 64;
/// Models that are kept for later rows.
const KEPT: usize = 512;

/// The evaluation of one stack, waited for by whoever needs it.
type Slot = Arc<OnceLock<Result<Arc<Model>, Error>>>;

/// The models of the last stacks by their numbers.
#[derive(Debug, Default)]
pub(super) struct Models(Mutex<VecDeque<(usize, Slot)>>);

impl Models {
    /// The place of the model of stack `key`.
    fn slot(&self, key: usize) -> Slot {
        let mut slots = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, slot)) = slots.iter().rev().find(|(found, _)| *found == key) {
            return Arc::clone(slot);
        }
        if slots.len() == KEPT {
            slots.pop_front();
        }
        let slot = Slot::default();
        slots.push_back((key, Arc::clone(&slot)));
        slot
    }
}

impl Sweep {
    /// Rows of a chunk; depends on the grid alone.
    fn chunk(&self) -> usize {
        (self.rows / FEWEST).clamp(1, LONGEST)
    }

    /// The chunks that have rows from `first` on.
    pub(super) fn chunks_from(&self, first: usize) -> Range<usize> {
        let chunk = self.chunk();
        (first / chunk).min(self.rows.div_ceil(chunk))..self.rows.div_ceil(chunk)
    }

    /// Solves the rows of one chunk, one after the other.
    pub(super) fn solve_chunk(&self, chunk: usize) -> Vec<Row> {
        let rows = chunk * self.chunk()..self.rows.min((chunk + 1) * self.chunk());
        rows.map(|index| {
            let values = self.values(index);
            let result = self.solve_row(index, &values);
            Row { index, values, result }
        })
        .collect()
    }

    fn solve_row(&self, index: usize, values: &[f64]) -> Result<Solution, Error> {
        let changes: Vec<_> = self.slots.iter().zip(values.iter().copied()).collect();
        let model = self.model(index)?;
        let punch = self.scene.punch_with(&changes)?;
        let force = self.scene.force_with(&changes)?;
        model.press_with(&punch, force, &self.options)
    }

    /// The model of a row.
    fn model(&self, index: usize) -> Result<Arc<Model>, Error> {
        let key = self.stack_key(index);
        let slot = self.models.slot(key);
        slot.get_or_init(|| Model::new(self.stack(key)?).map(Arc::new)).clone()
    }

    /// Number of the stack of a row.
    fn stack_key(&self, index: usize) -> usize {
        let (mut rest, mut key, mut place) = (index, 0, 1);
        for (axis, slot) in self.axes.iter().zip(&self.slots).rev() {
            let count = axis.values().len();
            if matches!(slot.owner, Owner::Item(_)) {
                key += rest % count * place;
                place *= count;
            }
            rest /= count;
        }
        key
    }
}
