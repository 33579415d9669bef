//! Pressures if given elements touch and others do not.
//!
//! As in the equations of [`crate::contact::intervals`], the unknowns u of a contact are what it has more than the contact above where both
//! touch, since laminates may bend so easily that both are nearly the same: p_(i+1) = p_i + u_(i+1), and where contact i
//! does not touch p_(i+1) = u_(i+1). The energy of all that lies below a contact depends on its pressure alone, so contacts are
//! eliminated from below (dynamic programming): ½ pᵀ S_i p − g_iᵀ p is the least energy from contact i on downwards. That
//! takes one block per contact where a matrix of all unknowns would have one for each pair.
use faer::linalg::matmul::matmul;
use faer::linalg::solvers::{Llt, Solve};
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Accum, Mat, MatRef, Par, Side};

use crate::contact::programme::constraints::Carried;
use crate::contact::programme::energy::Energy;
use crate::numeric::dot;

/// A value for each element of each contact.
pub(super) type Elements<T> = Vec<Vec<T>>;

/// What follows if given elements of each contact touch.
pub(super) struct Equilibrium<'a> {
    energy: &'a Energy,
    /// The elements of each contact that touch.
    elements: Elements<usize>,
    /// The pressures on all other elements; none on elements that touch.
    apart: Elements<f64>,
    /// What these and the punch do to the gaps of each contact, and the magnitudes of all that this is the sum of.
    linear: Elements<f64>,
    terms: Elements<f64>,
}

/// What comes of it, for each element of each contact.
pub(super) struct State {
    pub(super) pressures: Elements<f64>,
    /// Where bodies do not touch; next to nothing where they do.
    pub(super) gaps: Elements<f64>,
    /// The magnitudes of all that a gap is the sum of: a gap is known to a rounding of these.
    pub(super) terms: Elements<f64>,
    /// The approach or rotation that goes with each constraint, and where nothing is even the moment of all that presses on the stack.
    pub(super) moved: Vec<f64>,
}

/// How the unknowns of a contact follow from the pressure above: u = gain p + own, a column for each right-hand side.
struct Response {
    gain: Mat<f64>,
    own: Mat<f64>,
}

/// The least energy of all from a contact on downwards.
struct Below {
    /// S.
    stiffness: Mat<f64>,
    /// g, a column for each right-hand side.
    load: Mat<f64>,
}

impl<'a> Equilibrium<'a> {
    pub(super) fn new(energy: &'a Energy, touching: &Elements<bool>) -> Self {
        let number = |own: &Vec<bool>| (0..own.len()).filter(|e| own[*e]).collect();
        let none = |(apart, touches): (&f64, &bool)| if *touches { 0.0 } else { *apart };
        let of = |(apart, own): (&Vec<f64>, &Vec<bool>)| apart.iter().zip(own).map(none).collect();
        let apart: Elements<f64> = energy.apart.iter().zip(touching).map(of).collect();
        let between = |pair: &[Vec<f64>]| pair[0].iter().zip(&pair[1]).map(|(above, own)| above - own).collect();
        let jumps: Elements<f64> = apart.windows(2).map(between).collect();
        let mut linear = energy.linear.clone();
        let mut terms: Elements<f64> = linear.iter().map(|own| own.iter().map(|value| value.abs()).collect()).collect();
        energy.add_pressures(&apart, &jumps, [&mut linear, &mut terms]);
        Self { energy, elements: touching.iter().map(number).collect(), apart, linear, terms }
    }

    /// What each constraint does to contact i, a unit approach or rotation, then a unit moment, and what the punch does in the last column, for the elements that touch.
    fn load(&self, i: usize) -> Mat<f64> {
        let Energy { constraints, turning, .. } = self.energy;
        let of = |e: usize, c: usize| match (constraints.get(c), turning) {
            (Some(own), _) => own.weight(i, e),
            (None, Some(turning)) if c == constraints.len() => -turning.linear[i][e],
            _ => self.linear[i][e],
        };
        let columns = constraints.len() + usize::from(turning.is_some()) + 1;
        Mat::from_fn(self.elements[i].len(), columns, |k, c| of(self.elements[i][k], c))
    }

    /// Eliminates contact i + 1: what it makes of a pressure on contact i, and the energy that is left.
    fn eliminate(&self, i: usize, below: &Below) -> Option<(Response, Below)> {
        let (unit, coupling) = (&self.energy.unit[i], &self.energy.coupling[i]);
        let (upper, lower) = (&self.elements[i], &self.elements[i + 1]);
        let Below { stiffness, load } = below;
        // where the pressure of an element goes on below, and where it is a jump
        let place: Vec<Option<usize>> = upper.iter().map(|e| lower.binary_search(e).ok()).collect();
        let own = Mat::from_fn(lower.len(), lower.len(), |k, l| coupling[(lower[k], lower[l])] + stiffness[(k, l)]);
        let factor = own.llt(Side::Lower).ok()?;
        drop(own);
        let mut gain = Mat::from_fn(lower.len(), upper.len(), |k, l| match place[l] {
            Some(l) => -stiffness[(k, l)],
            None => coupling[(lower[k], upper[l])],
        });
        let mut own = load.clone();
        solve_lower_triangular_in_place(factor.L(), gain.as_mut(), Par::Seq);
        solve_lower_triangular_in_place(factor.L(), own.as_mut(), Par::Seq);
        let mut left = Mat::from_fn(upper.len(), upper.len(), |k, l| {
            let (e, f) = (upper[k], upper[l]);
            unit[(e, f)]
                + match (place[k], place[l]) {
                    (Some(k), Some(l)) => stiffness[(k, l)],
                    (None, None) => coupling[(e, f)],
                    _ => 0.0,
                }
        });
        matmul(left.as_mut(), Accum::Add, gain.transpose(), gain.as_ref(), -1.0, Par::Seq);
        let mut passed = self.load(i);
        for (k, place) in place.iter().enumerate() {
            if let Some(place) = place {
                (0..load.ncols()).for_each(|c| passed[(k, c)] += load[(*place, c)]);
            }
        }
        matmul(passed.as_mut(), Accum::Add, gain.transpose(), own.as_ref(), 1.0, Par::Seq);
        let upper = factor.L().transpose();
        solve_upper_triangular_in_place(upper, gain.as_mut(), Par::Seq);
        solve_upper_triangular_in_place(upper, own.as_mut(), Par::Seq);
        Some((Response { gain, own }, Below { stiffness: left, load: passed }))
    }

    /// The unknowns of each contact's elements that touch, a column for each right-hand side; `None` if the equations
    /// cannot be solved in double precision.
    fn unknowns(&self) -> Option<Vec<Mat<f64>>> {
        let last = self.energy.contacts() - 1;
        let unit = &self.energy.unit[last];
        let own = &self.elements[last];
        let mut below = Below {
            stiffness: Mat::from_fn(own.len(), own.len(), |k, l| unit[(own[k], own[l])]),
            load: self.load(last),
        };
        let mut responses = Vec::with_capacity(last);
        for i in (0..last).rev() {
            let (response, next) = self.eliminate(i, &below)?;
            responses.push(response);
            below = next;
        }
        let factor: Llt<f64> = below.stiffness.llt(Side::Lower).ok()?;
        let mut unknowns = vec![factor.solve(&below.load)];
        let mut pressure = unknowns[0].clone();
        for (i, Response { gain, mut own }) in responses.into_iter().rev().enumerate() {
            matmul(own.as_mut(), Accum::Add, gain.as_ref(), pressure.as_ref(), 1.0, Par::Seq);
            pressure = self.add_above(i, pressure.as_ref(), own.clone());
            unknowns.push(own);
        }
        Some(unknowns)
    }

    /// The pressure of contact i + 1 from the pressure of contact i and the unknowns.
    fn add_above(&self, i: usize, above: MatRef<'_, f64>, mut unknowns: Mat<f64>) -> Mat<f64> {
        for (k, e) in self.elements[i + 1].iter().enumerate() {
            if let Ok(place) = self.elements[i].binary_search(e) {
                (0..above.ncols()).for_each(|c| unknowns[(k, c)] += above[(place, c)]);
            }
        }
        unknowns
    }

    /// The approach or rotation that goes with each constraint, and the whole moment, from how unknowns respond to them.
    fn moved(&self, responses: &[Mat<f64>]) -> Vec<f64> {
        let Energy { constraints, turning, .. } = self.energy;
        let n = constraints.len() + usize::from(turning.is_some());
        let mut rows = Mat::<f64>::zeros(n, n + 1);
        let mut pressure = Mat::zeros(0, 0);
        for (i, unknowns) in responses.iter().enumerate() {
            pressure = match i.checked_sub(1) {
                Some(above) => self.add_above(above, pressure.as_ref(), unknowns.clone()),
                None => unknowns.clone(),
            };
            for c in 0..=n {
                let sum = |weight: &dyn Fn(usize) -> f64| -> f64 {
                    self.elements[i].iter().zip(pressure.col_as_slice(c)).map(|(e, p)| weight(*e) * p).sum()
                };
                for (row, own) in constraints.iter().enumerate().filter(|(_, own)| own.contact == i) {
                    rows[(row, c)] += sum(&|e| own.weights[e]);
                }
                if let Some(turning) = turning {
                    rows[(n - 1, c)] += sum(&|e| turning.linear[i][e]);
                }
            }
        }
        let mut known = Mat::from_fn(n, 1, |row, _| rows[(row, n)]);
        for (row, own) in constraints.iter().enumerate() {
            known[(row, 0)] -= dot(&own.weights, &self.apart[own.contact]);
            match own.kind {
                Carried::Resultant(value) | Carried::Moment(_, value) => known[(row, 0)] += value,
                Carried::WholeMoment => {
                    rows[(row, n - 1)] -= 1.0;
                    rows[(n - 1, row)] += 1.0;
                }
            }
        }
        if let Some(turning) = turning {
            rows[(n - 1, n - 1)] += turning.square.iter().sum::<f64>();
            known[(n - 1, 0)] -=
                turning.linear.iter().zip(&self.apart).map(|(own, apart)| dot(own, apart)).sum::<f64>();
            if let Some(moment) = turning.moment {
                (0..n).for_each(|c| rows[(n - 1, c)] = if c + 1 == n { 1.0 } else { 0.0 });
                known[(n - 1, 0)] = moment;
            }
        }
        rows.subcols(0, n).partial_piv_lu().solve(known).col_as_slice(0).to_vec()
    }

    /// Pressures and gaps; `None` if the equations cannot be solved in double precision.
    pub(super) fn solve(&self) -> Option<State> {
        let Energy { resultants, constraints, turning, .. } = self.energy;
        let contacts = self.energy.contacts();
        let responses = self.unknowns()?;
        let moved = self.moved(&responses);
        let n = moved.len();
        let mut pressures = vec![vec![0.0; self.energy.elements()]; contacts];
        let (mut gaps, mut terms) = (self.linear.clone(), self.terms.clone());
        if let (Some(turning), Some(moment)) = (turning, moved.last()) {
            let all = gaps.iter_mut().flatten().zip(terms.iter_mut().flatten()).zip(turning.linear.iter().flatten());
            all.for_each(|((gap, terms), linear)| {
                *gap += moment * linear;
                *terms += (moment * linear).abs();
            });
        }
        let mut jumps: Elements<f64> = Vec::new();
        for (i, responses) in responses.iter().enumerate() {
            let mut jump = if i > 0 { pressures[i - 1].clone() } else { Vec::new() };
            for (k, e) in self.elements[i].iter().enumerate() {
                let unknown = (0..n).map(|c| responses[(k, c)] * moved[c]).sum::<f64>() - responses[(k, n)];
                let mut above = 0.0;
                if i > 0 {
                    jump[*e] = -unknown;
                    above = pressures[i - 1][*e];
                }
                pressures[i][*e] = above + unknown;
            }
            if i > 0 {
                jumps.push(jump);
            }
        }
        self.energy.add_pressures(&pressures, &jumps, [&mut gaps, &mut terms]);
        let all = pressures.iter_mut().flatten().zip(self.apart.iter().flatten());
        all.for_each(|(pressure, apart)| *pressure += apart);
        for (i, (gaps, terms)) in gaps.iter_mut().zip(&mut terms).enumerate() {
            for (e, ((gap, terms), resultant)) in gaps.iter_mut().zip(terms).zip(resultants).enumerate() {
                let all = constraints.iter().enumerate().map(|(c, own)| own.weight(i, e) * moved[c]);
                let [sum, size] = all.fold([0.0; 2], |[sum, size], own| [sum + own, size + own.abs()]);
                *gap = (*gap - sum) / resultant;
                *terms = (*terms + size) / resultant;
            }
        }
        let finite = pressures.iter().chain(&gaps).flatten().chain(&moved).all(|value| value.is_finite());
        finite.then_some(State { pressures, gaps, terms, moved })
    }
}

impl Energy {
    /// Adds what pressures do to gaps, and its magnitude to their terms; `jumps` are what the pressure of a contact is more than the one below.
    fn add_pressures(&self, pressures: &Elements<f64>, jumps: &Elements<f64>, [gaps, terms]: [&mut Elements<f64>; 2]) {
        for (i, (coupling, jump)) in self.coupling.iter().zip(jumps).enumerate() {
            add_product(1.0, coupling, jump, &mut gaps[i], &mut terms[i]);
            add_product(-1.0, coupling, jump, &mut gaps[i + 1], &mut terms[i + 1]);
        }
        for (i, (unit, pressures)) in self.unit.iter().zip(pressures).enumerate() {
            add_product(1.0, unit, pressures, &mut gaps[i], &mut terms[i]);
        }
    }
}

fn add_product(sign: f64, matrix: &Mat<f64>, vector: &[f64], sum: &mut [f64], terms: &mut [f64]) {
    for (e, value) in vector.iter().enumerate().filter(|(_, value)| **value != 0.0) {
        for ((sum, terms), entry) in sum.iter_mut().zip(terms.iter_mut()).zip(matrix.col_as_slice(e)) {
            *sum += sign * value * entry;
            *terms += (value * entry).abs();
        }
    }
}
