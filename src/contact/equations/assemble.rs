//! The Galerkin equations of all contacts at given half-lengths: a symmetric matrix and a right-hand side.
//!
//! The elastic energy of a laminate between the contacts u = p̂_i and v = p̂_(i+1) is
//!
//! C_tt u² + 2 C_tb uv + C_bb v² = (C_tt + C_tb) u² + (C_bb + C_tb) v² − C_tb (u − v)²,
//!
//! in which no term is large for long waves unless u and v differ. So the energy of all is Σ (g∞ + unit) p̂_i² for the
//! contacts and Σ coupling (p̂_i − p̂_(i+1))² for the laminates, and the unknowns of a contact are what it has more than
//! the contact above: always for the first mode, where that is zero by equilibrium, and for all modes of contacts with a
//! laminate between them that bends much more easily than it is squeezed.
//!
//! Everything is per unit of P' = P/(μ₀L): p̂_i = (2P'/ζ) Σ_m y_im ψ_im(ζ), y_i0 = 1.

use std::ops::Range;

use faer::Mat;

use crate::contact::integrals::basis::Basis;
use crate::contact::integrals::columns::Columns;
use crate::contact::integrals::layout::Layout;
use crate::contact::integrals::products::{product, symmetric_product};
use crate::contact::integrals::tail::Weights;
use crate::contact::problem::rows::Slopes;
use crate::contact::problem::support::Support;

/// The equations of one stack, one layout and one set of half-lengths.
pub(crate) struct Equations<'a> {
    pub(super) layout: &'a Layout,
    pub(super) bases: &'a [Basis],
    /// Modes solved for, per contact, the first included.
    modes: &'a [usize],
    /// Per laminate between contacts: whether all modes below it are counted from those above it.
    strong: &'a [bool],
    /// Where mode m of contact i stands: first modes first.
    place: Vec<Vec<usize>>,
    /// Modes of contact i less the modes of contact i + 1 where the latter are counted from the former, at the rows of the
    /// coupling; else the modes of contact i.
    differences: Vec<Columns>,
    /// What the edge singularity at the corners of a punch adds to the pressure of each contact.
    pub(super) edges: Vec<Option<EdgePressure>>,
}

/// What a singular pressure with the intensity q, 1 on a half-plane, adds to a contact.
pub(super) struct EdgePressure {
    /// q.
    pub(super) intensity: f64,
    /// Its transform per unit of q.
    pub(super) rows: Rows,
}

/// Transforms at the rows of one contact.
pub(crate) type Rows = Vec<f64>;

impl<'a> Equations<'a> {
    pub(crate) fn new(
        layout: &'a Layout,
        bases: &'a [Basis],
        modes: &'a [usize],
        strong: &'a [bool],
        support: &Support,
    ) -> Self {
        let mut place: Vec<Vec<usize>> = modes.iter().map(|modes| Vec::with_capacity(*modes)).collect();
        let mut next = 0;
        for m in 0..modes.iter().copied().max().unwrap_or(0) {
            for (place, modes) in place.iter_mut().zip(modes) {
                if m < *modes {
                    place.push(next);
                    next += 1;
                }
            }
        }
        let edge = |(i, basis): (usize, &Basis)| {
            support.intensity(i).map(|intensity| EdgePressure { intensity, rows: basis.edges() })
        };
        let edges = bases.iter().enumerate().map(edge).collect();
        let mut equations = Self { layout, bases, modes, strong, place, differences: Vec::new(), edges };
        equations.differences = (0..strong.len()).map(|i| equations.difference(i)).collect();
        equations
    }

    pub(crate) fn contacts(&self) -> usize {
        self.bases.len()
    }

    /// Unknowns and known first modes together.
    pub(crate) fn size(&self) -> usize {
        self.modes.iter().sum()
    }

    /// Where mode m of contact i stands.
    pub(crate) fn place(&self, i: usize, m: usize) -> usize {
        self.place[i][m]
    }

    pub(crate) fn modes(&self, i: usize) -> usize {
        self.modes[i]
    }

    /// Whether mode m of contact i + 1 is counted from mode m of contact i.
    fn links(&self, i: usize, m: usize) -> bool {
        m == 0 || self.strong[i] && m < self.modes[i].min(self.modes[i + 1])
    }

    /// The contacts whose mode m is part of mode m of contact i.
    fn chain(&self, i: usize, m: usize) -> Range<usize> {
        let mut first = i;
        while first > 0 && self.links(first - 1, m) {
            first -= 1;
        }
        first..i + 1
    }

    fn difference(&self, i: usize) -> Columns {
        let (upper, lower) = (&self.bases[i], &self.bases[i + 1]);
        let rows = self.layout.coupling[i].rows();
        let mut difference = Columns::zeros(rows, self.modes[i]);
        for m in 0..self.modes[i] {
            let column = difference.column_mut(m);
            if self.links(i, m) {
                for (value, (u, v)) in column.iter_mut().zip(upper.value(m).iter().zip(lower.value(m))) {
                    *value = u - v;
                }
            } else {
                column.copy_from_slice(&upper.value(m)[..rows]);
            }
            if m == 0 {
                // long waves see the resultant only, which is the same in all contacts and cancels
                for (value, (zeta, (u, v))) in column.iter_mut().zip(
                    self.layout.zeta.iter().zip(upper.transform_minus_one.iter().zip(lower.transform_minus_one.iter())),
                ) {
                    *value = 0.5 * zeta * (u - v);
                }
            }
        }
        difference
    }

    /// The matrix, its lower half.
    pub(crate) fn matrix(&self) -> Mat<f64> {
        let size = self.size();
        let mut matrix = Mat::zeros(size, size);
        for (i, basis) in self.bases.iter().enumerate() {
            let mut gram = symmetric_product(basis.values(self.modes[i]), &self.layout.own[i].unit);
            for m in 0..self.modes[i] {
                gram.column_mut(m)[m] += self.cauchy(i, m);
            }
            self.add_symmetric(&mut matrix, &gram, |m| self.chain(i, m));
        }
        for (i, weights) in self.layout.coupling.iter().enumerate().filter(|(_, weights)| weights.rows() > 0) {
            self.add_coupling(&mut matrix, i, weights);
        }
        matrix
    }

    /// Adds what the laminate between the contacts i and i + 1 makes of their differences.
    fn add_coupling(&self, matrix: &mut Mat<f64>, i: usize, weights: &Weights) {
        let upper = self.differences[i].part(0..self.modes[i]);
        let gram = symmetric_product(upper, weights);
        self.add_symmetric(matrix, &gram, |m| self.chain(i, m));
        let lower = self.bases[i + 1].values(self.modes[i + 1]);
        let gram = symmetric_product(lower, weights);
        self.add_symmetric(matrix, &gram, |_| i + 1..i + 2);
        let gram = product(upper, weights, lower);
        for n in 0..self.modes[i + 1] {
            let column = self.place(i + 1, n);
            for (m, value) in gram.column(n).iter().enumerate() {
                for row in self.chain(i, m).map(|k| self.place(k, m)) {
                    matrix[(row.max(column), row.min(column))] -= value;
                }
            }
        }
    }

    /// Adds a symmetric block (its lower half) to the modes of all contacts in the chain of its own.
    fn add_symmetric(&self, matrix: &mut Mat<f64>, block: &Columns, chain: impl Fn(usize) -> Range<usize>) {
        for n in 0..block.rows() {
            let columns = chain(n);
            for m in n..block.rows() {
                let rows = chain(m);
                for row in rows.clone().map(|i| self.place(i, m)) {
                    for column in columns.clone().map(|i| self.place(i, n)) {
                        if row >= column {
                            matrix[(row, column)] += block.column(n)[m];
                        }
                    }
                }
            }
        }
    }

    /// g∞ ∫ ψ² dζ/ζ.
    pub(crate) fn cauchy(&self, i: usize, m: usize) -> f64 {
        self.layout.twin.diagonal(self.layout.own[i].limit, m, self.bases[i].half_length)
    }

    /// Whether all modes of some contact are counted from the modes of the contact above.
    pub(crate) fn has_strong(&self) -> bool {
        self.strong.contains(&true)
    }

    /// How large the terms are of which the differences of modes that are counted from those above consist, in a sum of rows
    /// with these weights: a laminate that bends easily makes much of what rounding leaves of the differences. `diagonal` is
    /// the diagonal of the matrix.
    pub(crate) fn difference_rounding(&self, weights: &[f64], modes: &[Vec<f64>], diagonal: &[f64]) -> f64 {
        let laminate = |i: usize| {
            let below = |m: usize| self.place(i + 1, m);
            let both = self.modes[i].min(self.modes[i + 1]);
            let energy = |amplitude: &dyn Fn(usize) -> f64| {
                (1..both).map(|m| amplitude(m).powi(2) * diagonal[below(m)]).sum::<f64>().sqrt()
            };
            energy(&|m| weights[below(m)]) * energy(&|m| modes[i][m])
        };
        (0..self.strong.len()).filter(|i| self.strong[*i]).map(laminate).sum()
    }

    /// What the unknowns, in the order of the matrix, are as modes of each contact.
    pub(crate) fn modes_of(&self, unknowns: &[f64]) -> Vec<Vec<f64>> {
        let mut modes: Vec<Vec<f64>> = Vec::with_capacity(self.contacts());
        for i in 0..self.contacts() {
            let own = |m: usize| unknowns[self.place(i, m)];
            let above = |m: usize| if i > 0 && self.links(i - 1, m) { modes[i - 1][m] } else { 0.0 };
            let sum = (0..self.modes(i)).map(|m| own(m) + above(m)).collect();
            modes.push(sum);
        }
        modes
    }

    /// The inverse of [`Self::modes_of`], for the modes that are solved for.
    pub(crate) fn unknowns_of(&self, modes: &[Vec<f64>]) -> Vec<f64> {
        let mut unknowns = vec![0.0; self.size()];
        for (i, own) in modes.iter().enumerate() {
            for (m, y) in own.iter().enumerate().take(self.modes[i]) {
                let above = if i > 0 && self.links(i - 1, m) { modes[i - 1][m] } else { 0.0 };
                unknowns[self.place(i, m)] = y - above;
            }
        }
        unknowns
    }

    /// Derivatives of the rows of all contacts, matrix · modes − right-hand side, with respect to ln a of each contact in
    /// turn, or to the intensity of its edge singularity. `modes` may be more than are solved for, and so are the rows
    /// then.
    pub(crate) fn derivatives(&self, modes: &[Vec<f64>], slopes: &[Option<Slopes>]) -> Vec<Vec<Rows>> {
        let n = self.contacts();
        let Transforms { pressures, jumps } = self.fields(modes);
        let mut derivatives = Vec::with_capacity(n);
        let counts: Vec<usize> = modes.iter().map(Vec::len).collect();
        for by in 0..n {
            if let Some(rows) = self.edge_rows(by, &counts) {
                derivatives.push(rows);
                continue;
            }
            let mut rows: Vec<Rows> = counts.iter().map(|count| vec![0.0; *count]).collect();
            let basis = &self.bases[by];
            let count = counts[by];
            // the tests of this contact change ...
            let response = self.response(by, &pressures[by], &jumps);
            let tested = basis.test(&response, count);
            basis.add_tested_slopes(&response, &tested, &mut rows[by]);
            // ... and so does its pressure
            let change = basis.combine_slopes(&modes[by], &pressures[by]);
            let response = self.spread(by, &change, &mut rows);
            basis.add_tested(1.0, &response, &mut rows[by]);
            for (m, row) in rows[by].iter_mut().enumerate() {
                *row -= 2.0 * self.layout.twin.norm * self.cauchy(by, m) * modes[by][m];
                if let Some(slopes) = &slopes[by] {
                    *row -= slopes.load_slope(m);
                }
            }
            derivatives.push(rows);
        }
        derivatives
    }

    /// Adds to the rows of its neighbours what a change of the pressure of contact `by` does to them; what the kernels make of
    /// it at the contact itself.
    pub(super) fn spread(&self, by: usize, change: &[f64], rows: &mut [Rows]) -> Rows {
        let mut response = self.layout.own[by].unit.over(self.bases[by].rows(), change);
        let above = by.checked_sub(1).map(|above| (above, above));
        let below = (by + 1 < self.contacts()).then_some((by, by + 1));
        for (laminate, other) in above.into_iter().chain(below) {
            let coupling = &self.layout.coupling[laminate];
            coupling.add_times(1.0, change, &mut response);
            let there = coupling.over(self.bases[other].rows(), change);
            self.bases[other].add_tested(-1.0, &there, &mut rows[other]);
        }
        response
    }

    /// Adds factor · rows of each contact in the order of the matrix: an unknown is tested in all contacts whose modes it is part of.
    pub(crate) fn add_rows(&self, factor: f64, rows: &[Rows], ordered: &mut [f64]) {
        for (i, rows) in rows.iter().enumerate() {
            for (m, row) in rows.iter().enumerate().take(self.modes[i]) {
                for k in self.chain(i, m) {
                    ordered[self.place(k, m)] += factor * row;
                }
            }
        }
    }

    /// Tests a response of contact i with its first `count` modes.
    pub(crate) fn test(&self, i: usize, response: &[f64], count: usize) -> Vec<f64> {
        self.bases[i].test(response, count)
    }

    /// p̂_i − p̂_(i+1) at the rows of the coupling, of the modes that are solved for.
    fn jump(&self, i: usize, unknowns: &[f64], modes: &[Vec<f64>]) -> Rows {
        let own: Vec<f64> = (0..self.modes(i + 1)).map(|m| -unknowns[self.place(i + 1, m)]).collect();
        let count = self.modes[i].min(modes[i].len());
        let mut jump = self.differences[i].part(0..count).combine(&modes[i][..count]);
        self.bases[i + 1].values(own.len()).add_combined(&own, &mut jump);
        self.add_edge(i, &mut jump);
        jump
    }

    /// What all modes make, and what neighbours differ by. `modes` may be more than are solved for.
    fn fields(&self, modes: &[Vec<f64>]) -> Transforms {
        let n = self.contacts();
        let solved = |i: usize| self.modes[i].min(modes[i].len());
        let unknowns = self.unknowns_of(modes);
        let mut pressures: Vec<Rows> =
            (0..n).map(|i| self.bases[i].combine_from(solved(i), &modes[i][solved(i)..])).collect();
        let jump = |i: usize| {
            let mut jump = self.jump(i, &unknowns, modes);
            let between = pressures[i].iter().zip(pressures[i + 1].iter());
            jump.iter_mut().zip(between).for_each(|(jump, (u, v))| *jump += u - v);
            jump
        };
        let jumps = (0..n - 1).map(jump).collect();
        for (i, pressure) in pressures.iter_mut().enumerate() {
            self.bases[i].values(solved(i)).add_combined(&modes[i][..solved(i)], pressure);
            self.add_edge(i, pressure);
        }
        Transforms { pressures, jumps }
    }

    /// What the kernels make of a pressure and of the jumps to its neighbours.
    fn response(&self, i: usize, pressure: &[f64], jumps: &[Rows]) -> Rows {
        let mut response = self.layout.own[i].unit.over(self.bases[i].rows(), pressure);
        for (laminate, sign) in i.checked_sub(1).map(|above| (above, -1.0)).into_iter().chain([(i, 1.0)]) {
            if let (Some(weights), Some(jump)) = (self.layout.coupling.get(laminate), jumps.get(laminate)) {
                weights.add_times(sign, jump, &mut response);
            }
        }
        response
    }

    /// The slope transforms of all contacts, weights included and g∞ left out: what the kernels make of the modes.
    /// `modes` may be more than are solved for.
    pub(crate) fn responses(&self, modes: &[Vec<f64>]) -> Vec<Rows> {
        let Transforms { pressures, jumps } = self.fields(modes);
        pressures.iter().enumerate().map(|(i, pressure)| self.response(i, pressure, &jumps)).collect()
    }
}

/// Transforms at the rows of each contact.
struct Transforms {
    /// p̂_i.
    pressures: Vec<Rows>,
    /// p̂_i − p̂_(i+1) at the rows of the coupling.
    jumps: Vec<Rows>,
}
