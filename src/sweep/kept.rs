//! One row of a sweep, and what is kept for later ones.
use std::collections::VecDeque;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use super::{Row, Sweep};
use crate::error::Error;
use crate::model::Model;
use crate::scene::Owner;
use crate::solution::Solution;

/// Models and punches that are kept for later rows.
const KEPT: usize = 512;

/// From so many rows per stack on it pays to keep answers to start from.
const MANY: usize = 100;

/// What is made once for many rows, and waited for by whoever needs it.
type Slot<T> = Arc<OnceLock<Result<Arc<T>, Error>>>;

/// The last things made, by their numbers: models of stacks, or punches.
#[derive(Debug)]
pub(super) struct Kept<T>(Mutex<VecDeque<(usize, Slot<T>)>>);

impl<T> Default for Kept<T> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<T> Kept<T> {
    /// What has this number; made if it is not kept.
    fn get(&self, key: usize, make: impl FnOnce() -> Result<T, Error>) -> Result<Arc<T>, Error> {
        self.slot(key).get_or_init(|| make().map(Arc::new)).clone()
    }

    fn slot(&self, key: usize) -> Slot<T> {
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
    /// Solves one row; its numbers do not depend on what was solved before.
    pub(super) fn row(&self, index: usize) -> Row {
        let values = self.values(index);
        let result = self.solve_row(index, &values);
        Row { index, values, result }
    }

    fn solve_row(&self, index: usize, values: &[f64]) -> Result<Solution, Error> {
        let changes: Vec<_> = self.slots.iter().zip(values.iter().copied()).collect();
        let stack = self.key(index, |owner| matches!(owner, Owner::Item(_)));
        let many = self.rows / self.stacks() >= MANY;
        let model = self.models.get(stack, || {
            let model = Model::new(self.stack(stack)?)?;
            Ok(if many { model.for_many_loads() } else { model })
        })?;
        let punch = self.key(index, |owner| *owner == Owner::Punch);
        let punch = self.punches.get(punch, || {
            // what is kept, or why it is none, must not depend on the row that came first
            let own: Vec<_> = changes.iter().copied().filter(|(slot, _)| slot.owner == Owner::Punch).collect();
            self.scene.punch_with(&own)
        })?;
        let force = self.scene.force_with(&changes)?;
        model.press_with(&punch, force, &self.options)
    }

    /// Number of the combination of values that a row has on the axes of some owners.
    fn key(&self, index: usize, of: impl Fn(&Owner) -> bool) -> usize {
        let (mut rest, mut key, mut place) = (index, 0, 1);
        for (axis, slot) in self.axes.iter().zip(&self.slots).rev() {
            let count = axis.count();
            if of(&slot.owner) {
                key += rest % count * place;
                place *= count;
            }
            rest /= count;
        }
        key
    }
}
