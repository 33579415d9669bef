//! One row of a sweep, and what is kept for later ones.
use std::collections::VecDeque;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use super::{Probe, Row, Sweep};
use crate::errors::Error;
use crate::field::{Field, FieldError, FieldPoint, SpacePoint};
use crate::model::Model;
use crate::scene::{Change, Owner, Scene, Top};
use crate::solution::Solution;
use crate::stack::Stack;

/// Models that are kept for later rows, at most.
const KEPT: usize = 512;
/// Fewer where they have more numbers than these in all, 256 MB of them: then some are made more than once.
const MOST_NUMBERS: usize = 1 << 25;

/// Forces per stack and punch from which on solutions are interpolated, each of which takes the solutions of a dozen forces nearby.
const MANY: usize = 100;

/// A value that is computed once for many rows; rows that need it wait.
type KeptSlot<T> = Arc<OnceLock<Result<Arc<T>, Error>>>;

/// The last things made, by the bits of the values that they were made for.
#[derive(Debug)]
pub(super) struct Kept<T> {
    slots: Mutex<VecDeque<(Vec<u64>, KeptSlot<T>)>>,
    numbers: fn(&T) -> usize,
}

impl<T> Kept<T> {
    /// Nothing; `numbers` says how many numbers something stores, about.
    pub(super) fn new(numbers: fn(&T) -> usize) -> Self {
        Self { slots: Mutex::default(), numbers }
    }

    /// The thing made for these changes; made now if it is not kept.
    fn get(&self, changes: &[Change], make: impl FnOnce() -> Result<T, Error>) -> Result<Arc<T>, Error> {
        let key = changes.iter().map(|(_, value)| value.to_bits()).collect();
        self.slot(key).get_or_init(|| make().map(Arc::new)).clone()
    }

    fn slot(&self, key: Vec<u64>) -> KeptSlot<T> {
        let mut slots = self.slots.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, slot)) = slots.iter().rev().find(|(found, _)| *found == key) {
            return Arc::clone(slot);
        }
        let numbers =
            |slot: &KeptSlot<T>| slot.get().and_then(|made| made.as_ref().ok()).map_or(0, |made| (self.numbers)(made));
        let mut all: usize = slots.iter().map(|(_, slot)| numbers(slot)).sum();
        while slots.len() >= KEPT || all > MOST_NUMBERS {
            let Some((_, oldest)) = slots.pop_front() else { break };
            all -= numbers(&oldest).min(all);
        }
        let slot = KeptSlot::default();
        slots.push_back((key, Arc::clone(&slot)));
        slot
    }
}

impl Sweep {
    /// Solves one row; its numbers do not depend on what was solved before.
    pub(super) fn row(&self, index: usize) -> Row {
        let values = self.values(index);
        let solved = self.solve_row(&values);
        let found = solved.as_ref().ok();
        let asked = found.filter(|_| self.extremes || !self.probes.is_empty());
        let field = asked.map(|(model, _, solution)| model.field(solution));
        Row {
            approach: found.filter(|_| self.approach).map(|(model, top, solution)| model.approach(top, solution)),
            extremes: field
                .as_ref()
                .filter(|_| self.extremes)
                .map(|field| field.as_ref().map_err(Clone::clone)?.extremes()),
            probes: field.filter(|_| !self.probes.is_empty()).map(|field| self.probed(&field?)),
            result: solved.map(|(.., solution)| solution),
            index,
            values,
        }
    }

    /// What the field has at the points that are asked for.
    fn probed(&self, field: &Field) -> Result<Vec<f64>, FieldError> {
        let points: Vec<SpacePoint> = self.probes.iter().map(|probe| probe.point).collect();
        let found = field.points_in_space(&points)?;
        let of = |(probe, point): (&Probe, &FieldPoint)| probe.quantity.of_in(point, field.coordinates());
        Ok(self.probes.iter().zip(&found).map(of).collect())
    }

    fn solve_row(&self, values: &[f64]) -> Result<(Arc<Model>, Top, Solution), Error> {
        let changes = self.slots.iter().zip(values.iter().copied());
        let (of_stack, others): (Vec<Change>, Vec<Change>) =
            changes.partition(|(slot, _)| matches!(slot.owner, Owner::Item(_) | Owner::PressureOnTop));
        // a model, or the error in its place, must not depend on the row that came first
        let model = self.models.get(&of_stack, || {
            let Scene { geometry, pressure_on_top, stack, .. } = self.scene.with_changes(&of_stack)?;
            let stack = Stack::from_items_under(geometry, pressure_on_top, &stack)?;
            let model = Model::new(stack)?;
            Ok(if self.values_of(|owner| owner == Owner::Force) >= MANY { model.for_many_loads() } else { model })
        })?;
        let Scene { top, force, .. } = self.scene.with_changes(&others)?;
        let solution = model.press_with(&top, force, &self.options)?;
        Ok((model, top, solution))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_kept_is_bounded_in_number_and_size() {
        for (numbers, most) in [(1, KEPT), (MOST_NUMBERS / 10, 12), (2 * MOST_NUMBERS, 1)] {
            let kept = Kept::new(|numbers: &usize| *numbers);
            for key in 0..2 * KEPT as u64 {
                let made = kept.slot(vec![key]).get_or_init(|| Ok(Arc::new(numbers))).clone();
                assert_eq!(*made.unwrap(), numbers);
                assert!(kept.slots.lock().unwrap().len() <= most);
            }
            // the last one is there
            assert!(kept.slot(vec![2 * KEPT as u64 - 1]).get().is_some());
        }
    }
}
