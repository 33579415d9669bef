//! The quadratic programme: no tension, no penetration, and one of pressure and gap zero on each element.
//!
//! Exchanging all elements at once that violate one or the other ends after a few steps as a rule. Where that goes round
//! in circles, elements are let touch one by one, and freed again as soon as they would be in tension, so that the energy falls
//! with every step and the programme ends for certain (Lawson and Hanson 1974).
use crate::contact::problem::iteration::Progress;
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

impl<'a> Programme<'a> {
    pub(super) fn new(energy: &'a Energy) -> Self {
        Self { energy }
    }

    /// Which elements of each contact touch, and the forces on them, from a guess, or else from all; `None` if
    /// rounding is too large.
    pub(super) fn solve(&self, guess: Option<Elements<bool>>) -> Option<(Elements<bool>, Elements<f64>)> {
        let (contacts, elements) = (self.energy.contacts(), self.energy.elements());
        let mut touching = guess.unwrap_or_else(|| vec![vec![true; elements]; contacts]);
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
                return Some((touching, self.forces(state.pressures)));
            }
            if !progress.goes_on(wrong.len() as f64) {
                return self.descend(state.pressures);
            }
            for (i, e) in wrong {
                touching[i][e] = !touching[i][e];
            }
        }
    }

    /// The same from pressures to begin with, the energy falling with every step.
    fn descend(&self, mut pressure: Elements<f64>) -> Option<(Elements<bool>, Elements<f64>)> {
        for (i, own) in pressure.iter_mut().enumerate() {
            own.iter_mut().for_each(|p| *p = p.max(0.0));
            let mut resultant = self.resultant(own);
            if resultant <= 0.0 {
                own.iter_mut().enumerate().filter(|(e, _)| !self.is_inadmissible(i, *e)).for_each(|(_, p)| *p = 1.0);
                resultant = self.resultant(own);
            }
            own.iter_mut().for_each(|p| *p /= resultant);
        }
        let mut touching: Elements<bool> =
            pressure.iter().map(|own| own.iter().map(|pressure| *pressure > 0.0).collect()).collect();
        let size = self.energy.contacts() * self.energy.elements();
        // elements that were let touch last, and those in tension at once: their penetration was rounding
        let mut last: Vec<(usize, usize)> = Vec::new();
        let mut rejected: Vec<(usize, usize)> = Vec::new();
        for _ in 0..(WORK / (size as f64).powi(3)) as usize {
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
                return Some((touching, self.forces(pressure)));
            }
        }
        None
    }

    fn forces(&self, mut pressure: Elements<f64>) -> Elements<f64> {
        for own in &mut pressure {
            own.iter_mut().zip(&self.energy.resultants).for_each(|(p, resultant)| *p *= resultant);
        }
        pressure
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

    fn resultant(&self, pressure: &[f64]) -> f64 {
        pressure.iter().zip(&self.energy.resultants).map(|(p, resultant)| p * resultant).sum()
    }
}
