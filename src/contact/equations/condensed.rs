//! Pressures at given half-lengths, how far these are from equilibrium, and Newton's step from there.
//!
//! The rows of the first modes are what is left over, one for each unknown half-length: the residual of Newton's method.
//! With the Cholesky factor L of the other rows and β = L⁻¹ (columns of the first modes), a residual (r, r') in the first
//! and the other rows leaves r − β · L⁻¹r' once the other modes have given way.
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{cholesky_in_place, cholesky_in_place_scratch};
use faer::linalg::solvers::DenseSolveCore;
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Mat, MatMut, MatRef, Par, Spec};

use crate::contact::equations::assemble::{Equations, Rows};
use crate::contact::problem::modes::{Modes, order};
use crate::contact::problem::rows::Slopes;
use crate::numeric::dot;

/// The equations about a set of half-lengths, factorised.
pub(crate) struct Linearised {
    factor: Factor,
    /// β, a column for each contact.
    beta: Mat<f64>,
    /// The inverse of the derivative of the residual with respect to the logarithms of the half-lengths.
    inverse: Mat<f64>,
    /// d y_im / d ln a_k: `sensitivity[k][i][m]`.
    sensitivity: Vec<Modes>,
    pub(crate) influences: Influences,
}

/// Sensitivities of half-lengths and of pressures at x = 0 to rounding and to each other.
pub(crate) struct Influences {
    /// What rounding may change in the logarithms of the half-lengths.
    pub(crate) rounding: Vec<f64>,
    /// By how much the logarithm of each half-length changes with the logarithm of each other one, if it alone gives way to it.
    pub(crate) lengths: Mat<f64>,
    /// The same for the logarithm of the pressure in the middle of each contact.
    pub(crate) peaks: Mat<f64>,
}

/// Modes of all contacts, y_im with y_i0 = 1, and Newton's step in the unknowns of their ends.
pub(crate) struct Pressures {
    pub(crate) modes: Modes,
    pub(crate) step: Vec<f64>,
    /// What is left in the rows of the first modes.
    pub(crate) residuals: Vec<f64>,
}

/// The rows of the first modes and of the others, before and after elimination of the latter.
struct Eliminated {
    factor: Factor,
    /// β, a column for each contact.
    beta: Mat<f64>,
    /// L⁻¹ of what the known first modes and the load leave in the other rows.
    gamma: Vec<f64>,
    /// First column of the rows of the first modes.
    known: Vec<f64>,
    /// Diagonal of the matrix.
    diagonal: Vec<f64>,
    /// What edge singularities make of the rows of the first modes.
    edges: Vec<f64>,
}

/// Solves the equations for the pressures, and Newton's method for the `free` ends; `None` if they cannot be solved in double
/// precision.
pub(crate) fn solve(
    equations: &Equations,
    slopes: &[Option<Slopes>],
    free: &[usize],
) -> Option<(Pressures, Linearised)> {
    let n = equations.contacts();
    let eliminated = eliminate(equations, slopes)?;
    let Eliminated { factor, beta, gamma, known, edges, .. } = &eliminated;
    let mut unknowns = factor.back(gamma);
    // equal resultants: the first modes of the contacts below do not differ from the uppermost one
    unknowns[0] = 1.0;
    let modes = equations.modes_of(&unknowns);
    let mut derivatives = Mat::zeros(equations.size(), n);
    for (by, rows) in equations.derivatives(&modes, slopes).iter().enumerate() {
        equations.add_rows(1.0, rows, derivatives.col_as_slice_mut(by));
    }
    factor.down(derivatives.as_mut().subrows_mut(n, equations.size() - n));
    let moved = |by: usize| &derivatives.col_as_slice(by)[n..];
    let jacobian = Mat::from_fn(n, n, |i, by| derivatives[(i, by)] - dot(beta.col_as_slice(i), moved(by)));
    let inverse = inverse_of(&jacobian, free)?;
    let residual = |i: usize| {
        let row = known[i] + edges[i] - slopes[i].as_ref().map_or(0.0, |slopes| slopes.load(0));
        row - dot(beta.col_as_slice(i), gamma)
    };
    let residuals: Vec<f64> = (0..n).map(residual).collect();
    let sensitivity: Vec<Modes> = (0..n).map(|by| equations.modes_of(&factor.back(moved(by)))).collect();
    let influences = influences(equations, &eliminated, &modes, &jacobian, &inverse, &sensitivity);
    let Eliminated { factor, beta, .. } = eliminated;
    let linearised = Linearised { factor, beta, inverse, sensitivity, influences };
    let pressures = Pressures { modes, step: linearised.step(&residuals), residuals };
    let finite = pressures.step.iter().chain(pressures.modes.iter().flatten()).all(|value| value.is_finite());
    finite.then_some((pressures, linearised))
}

/// Eliminates all modes but the first ones.
fn eliminate(equations: &Equations, slopes: &[Option<Slopes>]) -> Option<Eliminated> {
    let (n, size) = (equations.contacts(), equations.size());
    let higher = size - n;
    let matrix = equations.matrix();
    // columns of the first modes, and the load
    let mut columns = Mat::zeros(higher, n + 1);
    columns.as_mut().subcols_mut(0, n).copy_from(matrix.as_ref().submatrix(n, 0, higher, n));
    let known: Vec<f64> = (0..n).map(|i| matrix[(i, 0)]).collect();
    let diagonal: Vec<f64> = (0..size).map(|k| matrix[(k, k)]).collect();
    let factor = Factor::new(matrix, n)?;
    for (i, slopes) in slopes.iter().enumerate() {
        let Some(slopes) = slopes else { continue };
        for m in 1..equations.modes(i) {
            columns[(equations.place(i, m) - n, n)] = slopes.load(m);
        }
    }
    let counts: Vec<usize> = (0..n).map(|i| equations.modes(i)).collect();
    let edges = equations.edge_load(&counts);
    for k in 0..higher {
        columns[(k, n)] -= edges[n + k];
    }
    factor.down(columns.as_mut());
    let gamma = columns.col_as_slice(0).iter().zip(columns.col_as_slice(n)).map(|(known, load)| known - load).collect();
    columns.truncate(higher, n);
    let beta = columns;
    Some(Eliminated { factor, beta, gamma, known, diagonal, edges })
}

/// The inverse of the rows and columns of the ends that are free; 0 for the others, which have neither a row nor a step.
fn inverse_of(jacobian: &Mat<f64>, free: &[usize]) -> Option<Mat<f64>> {
    let unknown = Mat::from_fn(free.len(), free.len(), |i, by| jacobian[(free[i], free[by])]);
    let solved = unknown.partial_piv_lu().inverse();
    let is_finite = (0..free.len()).all(|by| solved.col_as_slice(by).iter().all(|value| value.is_finite()));
    if !is_finite {
        return None;
    }
    let mut inverse = Mat::zeros(jacobian.nrows(), jacobian.ncols());
    for (by, column) in free.iter().enumerate() {
        free.iter().enumerate().for_each(|(i, row)| inverse[(*row, *column)] = solved[(i, by)]);
    }
    Some(inverse)
}

/// Sensitivities of half-lengths and pressures at x = 0.
fn influences(
    equations: &Equations,
    eliminated: &Eliminated,
    modes: &Modes,
    jacobian: &Mat<f64>,
    inverse: &Mat<f64>,
    sensitivity: &[Modes],
) -> Influences {
    let n = equations.contacts();
    let Eliminated { factor, beta, gamma, known, diagonal, .. } = eliminated;
    let lengths = Mat::from_fn(n, n, |i, by| (jacobian[(i, by)] / jacobian[(i, i)]).abs());
    let differences = |i: usize| {
        let mut weights = factor.back(beta.col_as_slice(i));
        weights[i] = 1.0;
        equations.difference_rounding(&weights, modes, diagonal)
    };
    let size = |i: usize| {
        let terms: f64 = beta.col_as_slice(i).iter().zip(gamma).map(|(b, g)| (b * g).abs()).sum();
        let differences = if equations.has_strong() { differences(i) } else { 0.0 };
        f64::EPSILON * (terms + known[i].abs() + differences)
    };
    let sizes: Vec<f64> = (0..n).map(size).collect();
    let rounding = (0..n).map(|i| (0..n).map(|k| inverse[(i, k)].abs() * sizes[k]).sum()).collect();
    let sum = |modes: &[f64]| modes.iter().enumerate().map(|(m, y)| y / order(m)).sum::<f64>();
    let peak = |i: usize, by: usize| {
        // a pressure is its modes over the half-length
        let own = if by == i { 1.0 } else { 0.0 };
        (sum(&sensitivity[by][i]) / sum(&modes[i]) - own).abs()
    };
    let peaks = Mat::from_fn(n, n, peak);
    Influences { rounding, lengths, peaks }
}

/// The Cholesky factor L of all rows and columns of a matrix but the first, in its place.
struct Factor {
    matrix: Mat<f64>,
    first: usize,
}

impl Factor {
    fn new(mut matrix: Mat<f64>, first: usize) -> Option<Self> {
        let higher = matrix.nrows() - first;
        let mut memory = MemBuffer::new(cholesky_in_place_scratch::<f64>(higher, Par::Seq, Spec::default()));
        let stack = MemStack::new(&mut memory);
        let part = matrix.as_mut().submatrix_mut(first, first, higher, higher);
        cholesky_in_place(part, Default::default(), Par::Seq, stack, Spec::default()).ok()?;
        Some(Self { matrix, first })
    }

    fn lower(&self) -> MatRef<'_, f64> {
        let higher = self.matrix.nrows() - self.first;
        self.matrix.as_ref().submatrix(self.first, self.first, higher, higher)
    }

    /// L⁻¹ right, in its place.
    fn down(&self, right: MatMut<'_, f64>) {
        solve_lower_triangular_in_place(self.lower(), right, Par::Seq);
    }

    /// Unknowns: first modes 0, then −L⁻ᵀ right.
    fn back(&self, right: &[f64]) -> Vec<f64> {
        let mut unknowns = vec![0.0; self.matrix.nrows()];
        let higher = &mut unknowns[self.first..];
        higher.iter_mut().zip(right).for_each(|(unknown, right)| *unknown = -right);
        let higher = MatMut::from_column_major_slice_mut(higher, right.len(), 1);
        solve_upper_triangular_in_place(self.lower().transpose(), higher, Par::Seq);
        unknowns
    }
}

/// How far half-lengths have moved, in the logarithm, since the tables were made, and what that does to the rows: the
/// square of the way is left out.
#[derive(Default)]
pub(crate) struct Drift {
    pub(crate) shift: Vec<f64>,
    /// Derivatives of the rows: `derivatives[k][i][m]`.
    pub(crate) derivatives: Vec<Vec<Rows>>,
}

impl Drift {
    fn add_to(&self, i: usize, rows: &mut [f64]) {
        for (shift, derivatives) in self.shift.iter().zip(&self.derivatives) {
            rows.iter_mut().zip(derivatives[i].iter()).for_each(|(row, derivative)| *row += shift * derivative);
        }
    }
}

/// What one [`Linearised::sweep`] changed.
pub(crate) struct Sweep {
    /// The step still to be taken in the logarithms of the half-lengths.
    pub(crate) step: Vec<f64>,
    /// Changes of the modes, Σ |Δy_m|/order per contact.
    pub(crate) changes: Vec<f64>,
}

impl Linearised {
    /// Newton's step for what is left in the rows of the first modes.
    fn step(&self, residuals: &[f64]) -> Vec<f64> {
        let n = residuals.len();
        (0..n).map(|i| -(0..n).map(|k| self.inverse[(i, k)] * residuals[k]).sum::<f64>()).collect()
    }

    /// By how much a step of contact i alone would change the pressures in the middle of all contacts, and by how much what is
    /// left in its row would change the half-lengths of others, relative.
    pub(crate) fn sensitivity(&self, i: usize, pressures: &Pressures) -> f64 {
        let peaks = self.influences.peaks.col_as_slice(i).iter().map(|peak| peak * pressures.step[i].abs());
        let others = (0..pressures.step.len()).filter(|k| *k != i);
        let lengths = others.map(|k| (self.inverse[(k, i)] * pressures.residuals[i]).abs());
        // NaN counts as infinitely sensitive
        peaks.chain(lengths).fold(0.0, |most: f64, other| if other.is_nan() { f64::INFINITY } else { most.max(other) })
    }

    /// Moves modes along with a step.
    pub(crate) fn follow(&self, modes: &mut Modes, step: &[f64]) {
        for (step, sensitivity) in step.iter().zip(&self.sensitivity) {
            for (modes, sensitivity) in modes.iter_mut().zip(sensitivity) {
                modes.iter_mut().zip(sensitivity).for_each(|(y, dy)| *y += step * dy);
            }
        }
    }

    /// One iterated Galerkin sweep at half-lengths nearby, with more modes than are solved for: those follow row by row
    /// (Sloan 1976), since the dominant part of each row is its own diagonal; the others, and the
    /// half-lengths, from what is left in their rows.
    pub(crate) fn sweep(
        &self,
        equations: &Equations,
        slopes: &[Option<Slopes>],
        drift: &Drift,
        modes: &mut Modes,
    ) -> Sweep {
        let n = equations.contacts();
        let responses = equations.responses(modes);
        let mut changes = vec![0.0; n];
        let mut rows: Vec<Rows> = Vec::with_capacity(n);
        for (i, response) in responses.iter().enumerate() {
            let mut own = equations.test(i, response, modes[i].len());
            for (m, row) in own.iter_mut().enumerate() {
                let load = slopes[i].as_ref().map_or(0.0, |slopes| slopes.load(m));
                *row += equations.own_row(i, m, modes[i][m]) - load;
            }
            drift.add_to(i, &mut own);
            for m in equations.modes(i)..own.len() {
                let change = -own[m] / equations.cauchy(i, m);
                modes[i][m] += change;
                changes[i] += change.abs() / order(m);
            }
            rows.push(own);
        }
        let mut left = vec![0.0; equations.size()];
        equations.add_rows(1.0, &rows, &mut left);
        let (first, others) = left.split_at_mut(n);
        self.factor.down(MatMut::from_column_major_slice_mut(others, equations.size() - n, 1));
        let residuals: Vec<f64> = (0..n).map(|i| first[i] - dot(self.beta.col_as_slice(i), others)).collect();
        let lower = equations.modes_of(&self.factor.back(others));
        for ((modes, lower), change) in modes.iter_mut().zip(lower).zip(&mut changes) {
            for (m, (y, dy)) in modes.iter_mut().zip(lower).enumerate() {
                *y += dy;
                *change += dy.abs() / order(m);
            }
        }
        Sweep { step: self.step(&residuals), changes }
    }
}
