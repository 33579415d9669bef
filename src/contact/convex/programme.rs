//! The quadratic programme: pressures that do not pull, gaps that do not overlap, and of each element one of both.
//!
//! Exchanging all elements at once that violate one or the other ends after a few steps as a rule. Where that goes round
//! in circles, elements are let touch one by one, and freed again as soon as they would pull, so that the energy falls
//! with every step and the programme ends for certain (Lawson and Hanson 1974).
use std::ops::Range;

use faer::linalg::solvers::{Llt, Solve};
use faer::{Mat, Side};

use super::energy::Energy;

/// Steps without fewer violations that are allowed.
const PATIENCE: usize = 8;
/// Operations at most, about: each step costs the cube of the number of elements.
const WORK: f64 = 2e10;
/// Violations below this part of the largest value are rounding.
const ROUNDING: f64 = 1e-9;

/// The programme of one grid.
pub(super) struct Programme<'a> {
    energy: &'a Energy,
}

/// A value for each element of each contact.
type Elements<T> = Vec<Vec<T>>;

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
            own.iter_mut().enumerate().for_each(|(e, touches)| *touches &= !self.is_barred(i, e));
        }
        let (mut fewest, mut patience) = (contacts * elements + 1, PATIENCE);
        loop {
            let (pressure, gap) = Equilibrium::new(self.energy, &touching).solve()?;
            let mut wrong = Vec::new();
            for i in 0..contacts {
                let little = ROUNDING * largest(&pressure[i]);
                let pulls = (0..elements).filter(|e| touching[i][*e] && pressure[i][*e] < -little);
                wrong.extend(pulls.chain(self.overlaps(i, &touching[i], &gap[i])).map(|e| (i, e)));
            }
            if wrong.is_empty() {
                return Some((touching, self.forces(pressure)));
            }
            if wrong.len() < fewest {
                (fewest, patience) = (wrong.len(), PATIENCE);
            } else if patience > 0 {
                patience -= 1;
            } else {
                return self.descend(pressure);
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
                own.iter_mut().enumerate().filter(|(e, _)| !self.is_barred(i, *e)).for_each(|(_, p)| *p = 1.0);
                resultant = self.resultant(own);
            }
            own.iter_mut().for_each(|p| *p /= resultant);
        }
        let mut touching: Elements<bool> =
            pressure.iter().map(|own| own.iter().map(|pressure| *pressure > 0.0).collect()).collect();
        let size = self.energy.contacts() * self.energy.elements();
        // elements that were let touch last, and those that pulled at once: what they overlapped was rounding
        let mut last: Vec<(usize, usize)> = Vec::new();
        let mut rejected: Vec<(usize, usize)> = Vec::new();
        for _ in 0..(WORK / (size as f64).powi(3)) as usize {
            let (wanted, gap) = Equilibrium::new(self.energy, &touching).solve()?;
            // as far towards equilibrium as nothing pulls
            let mut step = 1.0f64;
            for (own, wanted) in pressure.iter().zip(&wanted) {
                let pulling = own.iter().zip(wanted).filter(|(_, wanted)| **wanted < 0.0);
                step = pulling.fold(step, |step, (p, wanted)| step.min(p / (p - wanted)));
            }
            for (i, ((own, wanted), touching)) in pressure.iter_mut().zip(&wanted).zip(&mut touching).enumerate() {
                let little = ROUNDING * largest(wanted);
                for (e, ((p, wanted), touches)) in own.iter_mut().zip(wanted).zip(touching).enumerate() {
                    *p += step * (wanted - *p);
                    if step < 1.0 && *wanted < 0.0 && *p <= little {
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
                let overlaps = self.overlaps(i, touching, &gap[i]).filter(|e| !rejected.contains(&(i, *e)));
                if let Some(worst) = overlaps.min_by(|e, f| gap[i][*e].total_cmp(&gap[i][*f])) {
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

    fn is_barred(&self, i: usize, e: usize) -> bool {
        i == 0 && self.energy.barred[e]
    }

    /// Elements of contact i where bodies overlap.
    fn overlaps(&self, i: usize, touching: &[bool], gap: &[f64]) -> impl Iterator<Item = usize> {
        let little = ROUNDING * largest(gap);
        (0..gap.len()).filter(move |e| !touching[*e] && !self.is_barred(i, *e) && gap[*e] < -little)
    }

    fn resultant(&self, pressure: &[f64]) -> f64 {
        pressure.iter().zip(&self.energy.resultants).map(|(p, resultant)| p * resultant).sum()
    }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()))
}

/// Pressures if given elements touch and others do not. As in [`super::super::galerkin`], the unknowns of a contact are
/// what it has more than the contact above where both touch, since laminates may bend so easily that both are nearly
/// the same.
struct Equilibrium<'a> {
    energy: &'a Energy,
    touching: &'a Elements<bool>,
    /// Number of the unknown of each element that touches.
    place: Elements<usize>,
    size: usize,
}

impl<'a> Equilibrium<'a> {
    fn new(energy: &'a Energy, touching: &'a Elements<bool>) -> Self {
        let mut size = 0;
        let number = |touches: &bool| {
            size += usize::from(*touches);
            size - usize::from(*touches)
        };
        let mut number = number;
        let place = touching.iter().map(|own| own.iter().map(&mut number).collect()).collect();
        Self { energy, touching, place, size }
    }

    /// The contacts whose unknowns add up to the pressure of contact i at an element.
    fn chain(&self, i: usize, e: usize) -> Range<usize> {
        let mut first = i;
        while first > 0 && self.touching[first - 1][e] {
            first -= 1;
        }
        if self.touching[i][e] { first..i + 1 } else { i..i }
    }

    /// Unknowns of the pressure difference p_i − p_(i+1) at an element, and their sign.
    fn jump(&self, i: usize, e: usize) -> (Range<usize>, f64) {
        if self.touching[i + 1][e] { (i + 1..i + 2, -1.0) } else { (self.chain(i, e), 1.0) }
    }

    fn matrix(&self) -> Mat<f64> {
        let Energy { unit, coupling, .. } = self.energy;
        let mut matrix = Mat::zeros(self.size, self.size);
        let mut add = |block: &Mat<f64>, unknowns: &dyn Fn(usize) -> (Range<usize>, f64)| {
            let all: Vec<(Vec<usize>, f64)> = (0..block.ncols())
                .map(|e| {
                    let (contacts, sign) = unknowns(e);
                    (contacts.map(|i| self.place[i][e]).collect(), sign)
                })
                .collect();
            for (f, (columns, right)) in all.iter().enumerate() {
                for (e, (rows, left)) in all.iter().enumerate() {
                    for column in columns {
                        for row in rows.iter().filter(|row| *row >= column) {
                            matrix[(*row, *column)] += left * right * block[(e, f)];
                        }
                    }
                }
            }
        };
        for (i, block) in unit.iter().enumerate() {
            add(block, &|e| (self.chain(i, e), 1.0));
        }
        for (i, block) in coupling.iter().enumerate() {
            add(block, &|e| self.jump(i, e));
        }
        matrix
    }

    /// A value of each contact's elements summed up for each unknown.
    fn gather(&self, i: usize, values: &[f64], sum: &mut [f64]) {
        for (e, value) in values.iter().enumerate() {
            for k in self.chain(i, e) {
                sum[self.place[k][e]] += value;
            }
        }
    }

    /// Pressures, and gaps where bodies do not touch; `None` if the equations cannot be solved in double precision.
    fn solve(&self) -> Option<(Elements<f64>, Elements<f64>)> {
        let Energy { linear, resultants, .. } = self.energy;
        let n = self.energy.contacts();
        let factor: Llt<f64> = self.matrix().llt(Side::Lower).ok()?;
        // unknowns that respond to each body's approach, and to the load
        let mut sides = Mat::<f64>::zeros(self.size, n + 1);
        for (i, linear) in linear.iter().enumerate() {
            self.gather(i, resultants, sides.col_as_slice_mut(i));
            self.gather(i, linear, sides.col_as_slice_mut(n));
        }
        let responses = factor.solve(&sides);
        let resultant = |i: usize, c: usize| -> f64 {
            sides.col_as_slice(i).iter().zip(responses.col_as_slice(c)).map(|(m, u)| m * u).sum()
        };
        let stiffness = Mat::from_fn(n, n, resultant);
        let missing = Mat::from_fn(n, 1, |i, _| 1.0 + resultant(i, n));
        let approach = stiffness.partial_piv_lu().solve(missing);
        let unknowns: Vec<f64> = (0..self.size)
            .map(|k| (0..n).map(|i| responses[(k, i)] * approach[(i, 0)]).sum::<f64>() - responses[(k, n)])
            .collect();
        let elements = 0..self.energy.elements();
        let sum = |contacts: Range<usize>, e: usize| -> f64 { contacts.map(|i| unknowns[self.place[i][e]]).sum() };
        let pressure: Elements<f64> =
            (0..n).map(|i| elements.clone().map(|e| sum(self.chain(i, e), e)).collect()).collect();
        let jump = |i: usize, e: usize| {
            let (contacts, sign) = self.jump(i, e);
            sign * sum(contacts, e)
        };
        let jumps: Elements<f64> = (0..n - 1).map(|i| elements.clone().map(|e| jump(i, e)).collect()).collect();
        let mut gap = linear.clone();
        for i in 0..n {
            add_product(1.0, &self.energy.unit[i], &pressure[i], &mut gap[i]);
        }
        for (i, jump) in jumps.iter().enumerate() {
            add_product(1.0, &self.energy.coupling[i], jump, &mut gap[i]);
            add_product(-1.0, &self.energy.coupling[i], jump, &mut gap[i + 1]);
        }
        for (i, gap) in gap.iter_mut().enumerate() {
            for (gap, resultant) in gap.iter_mut().zip(resultants) {
                *gap = *gap / resultant - approach[(i, 0)];
            }
        }
        let finite = pressure.iter().chain(&gap).flatten().all(|value| value.is_finite());
        finite.then_some((pressure, gap))
    }
}

fn add_product(sign: f64, matrix: &Mat<f64>, vector: &[f64], sum: &mut [f64]) {
    for (e, value) in vector.iter().enumerate().filter(|(_, value)| **value != 0.0) {
        sum.iter_mut().zip(matrix.col_as_slice(e)).for_each(|(sum, entry)| *sum += sign * value * entry);
    }
}
