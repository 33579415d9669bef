//! One row of a sweep, and what is kept for later ones.
use std::collections::VecDeque;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use super::{Row, Sweep};
use crate::approach::{Approach, ApproachError};
use crate::errors::Error;
use crate::field::{Extremes, FieldError};
use crate::model::Model;
use crate::scene::{Owner, Top};
use crate::solution::Solution;

/// Models, and punches or loads, that are kept for later rows, at most.
const KEPT: usize = 512;
/// Fewer where they have more numbers than these in all, 256 MB of them: then some are made more than once.
const MOST_NUMBERS: usize = 1 << 25;

/// Rows per stack from which on a table of solutions to start from saves time.
const MANY: usize = 100;

/// A value that is computed once for many rows; rows that need it wait.
type Slot<T> = Arc<OnceLock<Result<Arc<T>, Error>>>;

/// The last things made, by their numbers: models of stacks, or what presses on them.
#[derive(Debug)]
pub(super) struct Kept<T>(Mutex<VecDeque<(usize, Slot<T>)>>);

impl<T> Default for Kept<T> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

/// How many numbers something stores, about.
pub(super) trait Size {
    fn numbers(&self) -> usize;
}

impl Size for Model {
    fn numbers(&self) -> usize {
        self.stored_numbers()
    }
}

impl Size for Top {
    /// A table of the most rows, and the curve through them.
    fn numbers(&self) -> usize {
        10_000
    }
}

impl<T: Size> Kept<T> {
    /// What has this number; made if it is not kept.
    fn get(&self, key: usize, make: impl FnOnce() -> Result<T, Error>) -> Result<Arc<T>, Error> {
        self.slot(key).get_or_init(|| make().map(Arc::new)).clone()
    }

    fn slot(&self, key: usize) -> Slot<T> {
        let mut slots = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, slot)) = slots.iter().rev().find(|(found, _)| *found == key) {
            return Arc::clone(slot);
        }
        let numbers = |slot: &Slot<T>| slot.get().and_then(|made| made.as_ref().ok()).map_or(0, |made| made.numbers());
        let mut all: usize = slots.iter().map(|(_, slot)| numbers(slot)).sum();
        while slots.len() >= KEPT || all > MOST_NUMBERS {
            let Some((_, oldest)) = slots.pop_front() else { break };
            all -= numbers(&oldest).min(all);
        }
        let slot = Slot::default();
        slots.push_back((key, Arc::clone(&slot)));
        slot
    }
}

/// A row with a solution, and what else was asked for.
struct Solved {
    solution: Solution,
    approach: Option<Result<Approach, ApproachError>>,
    extremes: Option<Result<Extremes, FieldError>>,
}

impl Sweep {
    /// Solves one row; its numbers do not depend on what was solved before.
    pub(super) fn row(&self, index: usize) -> Row {
        let values = self.values(index);
        match self.solve_row(index, &values) {
            Ok(Solved { solution, approach, extremes }) => {
                Row { index, values, result: Ok(solution), approach, extremes }
            }
            Err(error) => Row { index, values, result: Err(error), approach: None, extremes: None },
        }
    }

    fn solve_row(&self, index: usize, values: &[f64]) -> Result<Solved, Error> {
        let changes: Vec<_> = self.slots.iter().zip(values.iter().copied()).collect();
        let stack = self.key(index, |owner| matches!(owner, Owner::Item(_)));
        let many = self.rows / self.stacks() >= MANY;
        let model = self.models.get(stack, || {
            let model = Model::new(self.stack(stack)?)?;
            Ok(if many { model.for_many_loads() } else { model })
        })?;
        let top = self.key(index, |owner| *owner == Owner::Top);
        let top = self.tops.get(top, || {
            // what is kept, or why it is none, must not depend on the row that came first
            let own: Vec<_> = changes.iter().copied().filter(|(slot, _)| slot.owner == Owner::Top).collect();
            Ok(self.scene.varied(&own)?.top)
        })?;
        let pressing: Vec<_> = changes.into_iter().filter(|(slot, _)| !matches!(slot.owner, Owner::Item(_))).collect();
        let force = self.scene.varied(&pressing)?.force;
        let solution = model.press_with(&*top, force, &self.options)?;
        let approach = self.has_approach().then(|| model.approach(&*top, &solution));
        let extremes = || model.field(&solution).and_then(|field| field.extremes());
        let extremes = self.has_extremes().then(extremes);
        Ok(Solved { solution, approach, extremes })
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

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Debug)]
    struct Numbers(usize);

    impl Size for Numbers {
        fn numbers(&self) -> usize {
            self.0
        }
    }

    #[test]
    fn what_is_kept_is_bounded_in_number_and_size() {
        for (numbers, most) in [(1, KEPT), (MOST_NUMBERS / 10, 12), (2 * MOST_NUMBERS, 1)] {
            let kept = Kept::default();
            for key in 0..2 * KEPT {
                assert_eq!(kept.get(key, || Ok(Numbers(numbers))).unwrap().0, numbers);
                assert!(kept.0.lock().unwrap().len() <= most);
            }
            // the last one is there
            assert!(kept.get(2 * KEPT - 1, || unreachable!("kept")).is_ok());
        }
    }
}
