//! The quadratic programme: no tension, no penetration, and one of pressure and gap zero on each element.
//!
//! Exchanging all elements at once that violate one or the other ends after a few steps as a rule. Where sets of elements
//! return, the last element alone is exchanged until fewer violate them than ever before, so that the method ends for certain (Júdice and Pires 1994).
use crate::contact::problem::accuracy::PATIENCE;
use crate::contact::programme::constraints::{Carried, Constraint};
use crate::contact::programme::energy::Energy;
use crate::contact::programme::equilibrium::{Elements, Equilibrium, State};
use crate::numeric::longest;

/// The programme of one grid.
pub(super) struct Programme<'a> {
    energy: &'a Energy,
}

/// Its solution.
pub(super) struct Solved {
    /// Which elements of each contact touch, and the forces on all, over what weights press with.
    pub(super) touching: Elements<bool>,
    pub(super) forces: Elements<f64>,
    /// The gaps of elements that do not touch, per unit of P'.
    pub(super) gaps: Elements<f64>,
    /// The approach or rotation that goes with each constraint, and where nothing is even the moment of all that presses on the stack.
    pub(super) moved: Vec<f64>,
}

impl<'a> Programme<'a> {
    pub(super) fn new(energy: &'a Energy) -> Self {
        Self { energy }
    }

    /// From a guess of which elements touch; `None` if rounding is too large.
    pub(super) fn solve(&self, mut touching: Elements<bool>) -> Option<Solved> {
        for (own, inadmissible) in touching.iter_mut().zip(&self.energy.inadmissible) {
            own.iter_mut().zip(inadmissible).for_each(|(touches, inadmissible)| *touches &= !inadmissible);
        }
        let (mut fewest, mut chances, mut work) = (usize::MAX, PATIENCE, 0.0);
        // each step costs the cube of the number of elements
        while work < 5e9 {
            let number = |own: &Vec<bool>| own.iter().filter(|touches| **touches).count() as f64;
            work += touching.iter().map(|own| number(own).powi(3)).sum::<f64>();
            let state = Equilibrium::new(self.energy, &touching).solve()?;
            let wrong = self.wrong(&touching, &state);
            let Some(last) = wrong.last() else {
                return Some(self.solved(touching, state));
            };
            if wrong.len() < fewest {
                (fewest, chances) = (wrong.len(), PATIENCE);
            }
            let all = chances > 0;
            chances = chances.saturating_sub(1);
            for (i, e) in if all { &wrong[..] } else { std::slice::from_ref(last) } {
                touching[*i][*e] = !touching[*i][*e];
            }
            if all {
                self.hold(&mut touching, &state);
            }
        }
        None
    }

    /// Lets the element with the largest pressure touch where otherwise none would that carries a resultant.
    fn hold(&self, touching: &mut Elements<bool>, state: &State) {
        for Constraint { contact, weights, .. } in &self.energy.constraints {
            let (touching, pressures) = (&mut touching[*contact], &state.pressures[*contact]);
            let mut carrying = (0..weights.len()).filter(|e| weights[*e] != 0.0);
            if carrying.clone().any(|e| touching[e]) {
                continue;
            }
            let over = |e: usize| pressures[e] - self.energy.apart[*contact][e];
            // elements that did not touch before have no pressure
            let pressed = carrying.clone().filter(|e| over(*e) != 0.0).max_by(|a, b| over(*a).total_cmp(&over(*b)));
            if let Some(e) = pressed.or_else(|| carrying.next()) {
                touching[e] = true;
            }
        }
    }

    /// Elements that touch and are in tension, and others with penetration, with the numbers of their contacts.
    fn wrong(&self, touching: &Elements<bool>, state: &State) -> Vec<(usize, usize)> {
        let of = |(i, touching): (usize, &Vec<bool>)| {
            let (pressures, gaps, terms) = (&state.pressures[i], &state.gaps[i], &state.terms[i]);
            let apart = &self.energy.apart[i];
            // smaller parts of the largest pressure, and of the terms of a gap, are zero
            let rounding = 1e-10;
            let zero = rounding * longest(pressures.iter().copied());
            let is_wrong = |e: &usize| match touching[*e] {
                true => pressures[*e] - apart[*e] < -zero,
                false => !self.energy.inadmissible[i][*e] && gaps[*e] < -rounding * terms[*e],
            };
            (0..touching.len()).filter(is_wrong).map(|e| (i, e)).collect::<Vec<_>>()
        };
        touching.iter().enumerate().flat_map(of).collect()
    }

    /// By how much the slope of the gap of each contact grows since bodies turn, under every punch and then under each of some punches more; none where all is even.
    pub(super) fn rotations(&self, solved: &Solved) -> Vec<(f64, Vec<(usize, f64)>)> {
        let Some(turning) = &self.energy.turning else { return Vec::new() };
        let moment = solved.moved[self.energy.constraints.len()];
        let pressure = |i: usize, e: usize| solved.forces[i][e] / self.energy.resultants[e];
        // what pressures are compared with turns, too
        let compared = |i: usize| {
            let mut sum = turning.square[i] * moment + turning.given[i];
            for e in 0..self.energy.elements() {
                let own = pressure(i, e);
                sum += (turning.linear[i][e] + turning.beside[i][e]) * own;
                if i > 0 {
                    sum += turning.coupling[i - 1][e] * (own - pressure(i - 1, e));
                }
                if i + 1 < self.energy.contacts() {
                    sum += turning.coupling[i][e] * (own - pressure(i + 1, e));
                }
            }
            sum
        };
        let of = |i: usize| {
            let own = self.energy.constraints.iter().zip(&solved.moved).filter(|(own, _)| own.contact == i);
            let (mut all, mut each) = (-compared(i), Vec::new());
            for (constraint, moved) in own {
                match constraint.kind {
                    Carried::Resultant(_) => {}
                    Carried::Moment(punch, _) => each.push((punch, -moved)),
                    Carried::WholeMoment => all -= moved,
                }
            }
            (all, each)
        };
        (0..self.energy.contacts()).map(of).collect()
    }

    fn solved(&self, touching: Elements<bool>, State { pressures: mut forces, gaps, moved, .. }: State) -> Solved {
        for own in &mut forces {
            own.iter_mut().zip(&self.energy.resultants).for_each(|(p, resultant)| *p *= resultant);
        }
        Solved { touching, forces, gaps, moved }
    }
}
