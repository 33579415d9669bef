//! The quadratic programme: no tension, no penetration, and one of pressure and gap zero on each element.
//!
//! Exchanging all elements at once that violate one or the other ends after a few steps as a rule. Where that goes round
//! in circles, elements are let touch one by one, and freed again as soon as they would be in tension, so that the energy falls
//! with every step and the programme ends for certain (Lawson and Hanson 1974).
use crate::contact::problem::iteration::Progress;
use crate::contact::programme::constraints::{Carried, Constraint};
use crate::contact::programme::energy::Energy;
use crate::contact::programme::equilibrium::{Elements, Equilibrium, State};
use crate::numeric::longest;

/// Operations at most, about: each step costs the cube of the number of elements.
const WORK: f64 = 2e10;
/// Pressures below this part of the largest are zero.
const ROUNDING: f64 = 1e-10;

/// The programme of one grid.
pub(super) struct Programme<'a> {
    energy: &'a Energy,
}

/// Its solution.
pub(super) struct Solved {
    /// Which elements of each contact touch, and the forces on them.
    pub(super) touching: Elements<bool>,
    pub(super) forces: Elements<f64>,
    /// The approach or rotation that goes with each constraint, and where nothing is even the moment of all that presses on the stack.
    pub(super) moved: Vec<f64>,
}

impl<'a> Programme<'a> {
    pub(super) fn new(energy: &'a Energy) -> Self {
        Self { energy }
    }

    /// From a guess of which elements touch; `None` if rounding is too large.
    pub(super) fn solve(&self, mut touching: Elements<bool>) -> Option<Solved> {
        let (contacts, elements) = (self.energy.contacts(), self.energy.elements());
        for (i, own) in touching.iter_mut().enumerate() {
            own.iter_mut().enumerate().for_each(|(e, touches)| *touches &= !self.is_inadmissible(i, e));
        }
        let mut progress = Progress::default();
        loop {
            let state = Equilibrium::new(self.energy, &touching).solve()?;
            let pressure = &state.pressures;
            let mut wrong = Vec::new();
            for i in 0..contacts {
                let zero = ROUNDING * longest(pressure[i].iter().copied());
                let tensile = (0..elements).filter(|e| touching[i][*e] && pressure[i][*e] < -zero);
                wrong.extend(tensile.chain(self.penetrations(i, &touching[i], &state)).map(|e| (i, e)));
            }
            if wrong.is_empty() {
                return Some(self.solved(touching, state.pressures, state.moved));
            }
            if !progress.goes_on(wrong.len() as f64) {
                return self.descend(state.pressures);
            }
            for (i, e) in wrong {
                touching[i][e] = !touching[i][e];
            }
        }
    }

    /// Pressures without tension that carry what they have to, near some others.
    fn feasible(&self, mut pressure: Elements<f64>) -> Elements<f64> {
        let Energy { constraints, resultants, turning, .. } = self.energy;
        pressure.iter_mut().flatten().for_each(|p| *p = p.max(0.0));
        let mut whole = turning.as_ref().and_then(|turning| turning.moment);
        let mut group = &resultants[..];
        for Constraint { contact, weights, kind } in constraints {
            let own = &mut pressure[*contact];
            match (kind, whole) {
                (Carried::Resultant(value), _) => {
                    group = weights;
                    let belongs = |e: usize| weights[e] != 0.0 && !self.is_inadmissible(*contact, e);
                    if sum(own, weights) <= 0.0 {
                        own.iter_mut().enumerate().filter(|(e, _)| belongs(*e)).for_each(|(_, p)| *p = 1.0);
                    }
                    let factor = value / sum(own, weights);
                    own.iter_mut().enumerate().filter(|(e, _)| belongs(*e)).for_each(|(_, p)| *p *= factor);
                }
                (Carried::Moment(_, value), _) => self.shift(*contact, own, [group, weights], *value),
                (Carried::WholeMoment, Some(value)) => self.shift(*contact, own, [resultants, weights], value),
                (Carried::WholeMoment, None) => whole = Some(sum(own, weights)),
            }
        }
        pressure
    }

    /// Gives the pressure of a group of elements a moment, by more of it on an element beyond the line of action.
    fn shift(&self, contact: usize, own: &mut [f64], [resultants, moments]: [&[f64]; 2], value: f64) {
        let (resultant, missing) = (sum(own, resultants), value - sum(own, moments));
        let beyond = |e: &usize| moments[*e] / resultants[*e] * resultant - value;
        let is_beyond =
            |e: &usize| resultants[*e] != 0.0 && !self.is_inadmissible(contact, *e) && beyond(e) * missing > 0.0;
        // twice as far beyond it as the pressure is from it
        let nearest = |a: &usize, b: &usize| {
            let [a, b] = [a, b].map(|e| (beyond(e) - 2.0 * missing).abs());
            a.total_cmp(&b)
        };
        let Some(e) = (0..own.len()).filter(is_beyond).min_by(nearest) else { return };
        let part = missing / (beyond(&e) + missing);
        own.iter_mut().zip(resultants).filter(|(_, own)| **own != 0.0).for_each(|(p, _)| *p *= 1.0 - part);
        own[e] += part * resultant / resultants[e];
    }

    /// The same from pressures to begin with, the energy falling with every step.
    fn descend(&self, pressure: Elements<f64>) -> Option<Solved> {
        let mut pressure = self.feasible(pressure);
        let mut touching: Elements<bool> =
            pressure.iter().map(|own| own.iter().map(|pressure| *pressure > 0.0).collect()).collect();
        // elements that were let touch last, and those in tension at once: their penetration was rounding
        let mut last: Vec<(usize, usize)> = Vec::new();
        let mut rejected: Vec<(usize, usize)> = Vec::new();
        let mut work = 0.0;
        while work < WORK {
            work +=
                touching.iter().map(|own| (own.iter().filter(|touches| **touches).count() as f64).powi(3)).sum::<f64>();
            let state = Equilibrium::new(self.energy, &touching).solve()?;
            let wanted = &state.pressures;
            // as far towards equilibrium as nothing is in tension
            let mut step = 1.0f64;
            for (own, wanted) in pressure.iter().zip(wanted) {
                let tensile = own.iter().zip(wanted).filter(|(_, wanted)| **wanted < 0.0);
                step = tensile.fold(step, |step, (p, wanted)| step.min(p / (p - wanted)));
            }
            for (i, ((own, wanted), touching)) in pressure.iter_mut().zip(wanted).zip(&mut touching).enumerate() {
                let zero = ROUNDING * longest(wanted.iter().copied());
                for (e, ((p, wanted), touches)) in own.iter_mut().zip(wanted).zip(touching).enumerate() {
                    *p += step * (wanted - *p);
                    if step < 1.0 && *wanted < 0.0 && *p <= zero {
                        (*p, *touches) = (0.0, false);
                        rejected.extend(last.iter().filter(|last| **last == (i, e)));
                    }
                }
            }
            if step < 1.0 {
                continue;
            }
            last.clear();
            let mut done = true;
            for (i, touching) in touching.iter_mut().enumerate() {
                let penetrations = self.penetrations(i, touching, &state).filter(|e| !rejected.contains(&(i, *e)));
                if let Some(worst) = penetrations.min_by(|e, f| state.gaps[i][*e].total_cmp(&state.gaps[i][*f])) {
                    touching[worst] = true;
                    last.push((i, worst));
                    done = false;
                }
            }
            if done {
                return Some(self.solved(touching, pressure, state.moved));
            }
        }
        None
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

    fn solved(&self, touching: Elements<bool>, mut forces: Elements<f64>, moved: Vec<f64>) -> Solved {
        for own in &mut forces {
            own.iter_mut().zip(&self.energy.resultants).for_each(|(p, resultant)| *p *= resultant);
        }
        Solved { touching, forces, moved }
    }

    fn is_inadmissible(&self, i: usize, e: usize) -> bool {
        self.energy.inadmissible[i][e]
    }

    /// Elements of contact i with penetration.
    fn penetrations(&self, i: usize, touching: &[bool], state: &State) -> impl Iterator<Item = usize> {
        let (gaps, terms) = (&state.gaps[i], &state.terms[i]);
        (0..gaps.len())
            .filter(move |e| !touching[*e] && !self.is_inadmissible(i, *e) && gaps[*e] < -ROUNDING * terms[*e])
    }
}

fn sum(pressure: &[f64], weights: &[f64]) -> f64 {
    pressure.iter().zip(weights).map(|(p, weight)| p * weight).sum()
}
