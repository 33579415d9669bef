//! Pressures at given half-lengths, and how far these are from equilibrium, with derivatives.
use faer::linalg::solvers::{Llt, PartialPivLu, Solve};
use faer::{Mat, Side};

use super::galerkin::{Equations, Transform, order};

/// How often the iterated modes are computed: each time they feel what the last round added.
const SWEEPS: usize = 3;

/// Solved equations: pressures at given half-lengths, and how far these are from equilibrium.
pub(super) struct Pressures {
    /// y_ij of contact i, j = 1, 3, ...; those beyond the modes solved for are iterated ones.
    pub(super) modes: Vec<Vec<f64>>,
    /// What is left of the rows k = 1.
    pub(super) residual: Vec<f64>,
    /// Its derivative with respect to the logarithms of the half-lengths.
    pub(super) jacobian: Mat<f64>,
    /// d y_ij / d ln a_m: `sensitivity[m][i][j]`.
    pub(super) sensitivity: Vec<Vec<Vec<f64>>>,
    /// By how much modes beyond those solved for change the residual; already contained in `residual`.
    pub(super) correction: Vec<f64>,
    /// By how much the residual would still change if the iteration of those modes went on, estimated.
    pub(super) unsettled_residual: Vec<f64>,
    /// By how much the pressures at x = 0 would, at most, per unit of μ₀P'.
    pub(super) unsettled_pressure: Vec<f64>,
}

/// The matrix of the rows and modes from 3 on, factorised. Symmetric and positive definite up to quadrature.
enum Factor {
    Cholesky(Llt<f64>),
    Lu(PartialPivLu<f64>),
}

impl Factor {
    fn new(matrix: &Mat<f64>) -> Self {
        match matrix.llt(Side::Lower) {
            Ok(cholesky) => Self::Cholesky(cholesky),
            Err(_) => Self::Lu(matrix.partial_piv_lu()),
        }
    }

    fn solve(&self, right: &Mat<f64>) -> Mat<f64> {
        match self {
            Self::Cholesky(factor) => factor.solve(right),
            Self::Lu(factor) => factor.solve(right),
        }
    }
}

/// Per contact, per mode.
type Modes = Vec<Vec<f64>>;

/// Solves the equations, with `iterated` modes in all for each contact: those beyond the solved ones follow row by row
/// (iterated Galerkin, Sloan 1976), since the dominant part of each row is its own diagonal g∞/(2k), and act back on the
/// solved ones.
pub(super) fn solve(equations: &Equations, iterated: &[usize]) -> Pressures {
    let n = equations.contacts();
    let solver = Solver { equations, factor: Factor::new(&equations.matrix()) };
    let unit: Vec<Transform> = (0..n).map(|i| equations.unit_slopes(i)).collect();
    let higher = solver.solve(|i, m| equations.punch(i, m) - equations.test(i, &unit[i], m));
    let beyond = (0..n).map(|i| vec![0.0; iterated[i].saturating_sub(equations.modes(i))]).collect();
    let mut state = State { slopes: unit, higher, beyond };
    solver.add(&mut state.slopes, &state.higher, |_| 1);
    let plain = solver.residual(&state.slopes);
    let unsettled = if state.beyond.iter().all(Vec::is_empty) {
        Unsettled { residual: vec![0.0; n], pressure: vec![0.0; n] }
    } else {
        solver.iterate(&mut state)
    };
    let residual = solver.residual(&state.slopes);
    let (jacobian, sensitivity) = solver.derivatives(&state);
    let all = |i: usize| {
        let solved = std::iter::once(2.0 / equations.half_length(i)).chain(state.higher[i].iter().copied());
        solved.chain(state.beyond[i].iter().copied()).collect()
    };
    Pressures {
        modes: (0..n).map(all).collect(),
        correction: residual.iter().zip(&plain).map(|(full, plain)| full - plain).collect(),
        residual,
        jacobian,
        sensitivity,
        unsettled_residual: unsettled.residual,
        unsettled_pressure: unsettled.pressure,
    }
}

/// Modes and what they do to the slopes.
struct State {
    /// Slope transforms of all contacts.
    slopes: Vec<Transform>,
    /// Modes solved for, from j = 3 on.
    higher: Modes,
    /// Modes that follow row by row.
    beyond: Modes,
}

/// What the iteration has left undone.
struct Unsettled {
    residual: Vec<f64>,
    pressure: Vec<f64>,
}

struct Solver<'a> {
    equations: &'a Equations<'a>,
    factor: Factor,
}

impl Solver<'_> {
    /// Solves for the modes from 3 on with the given right-hand sides (contact, mode).
    fn solve(&self, right: impl Fn(usize, usize) -> f64) -> Modes {
        let (offsets, size) = self.equations.offsets();
        let modes = |i: usize| 1..self.equations.modes(i);
        let mut column = Mat::zeros(size, 1);
        for (i, offset) in offsets.iter().enumerate() {
            for m in modes(i) {
                column[(offset + m - 1, 0)] = right(i, m);
            }
        }
        let solution = self.factor.solve(&column);
        let split = |(i, offset): (usize, &usize)| modes(i).map(|m| solution[(offset + m - 1, 0)]).collect();
        offsets.iter().enumerate().map(split).collect()
    }

    /// Adds to the slopes of all contacts what modes, the first of which is `first`, cause.
    fn add(&self, slopes: &mut [Transform], modes: &Modes, first: impl Fn(usize) -> usize) {
        for (by, modes) in modes.iter().enumerate() {
            let pressure = self.equations.transform(by, modes, first(by), false);
            for i in self.near(by) {
                self.equations.add_response(&mut slopes[i], i, by, &pressure);
            }
        }
    }

    /// A contact and its neighbours.
    fn near(&self, contact: usize) -> std::ops::Range<usize> {
        contact.saturating_sub(1)..(contact + 2).min(self.equations.contacts())
    }

    /// The rows k = 1.
    fn residual(&self, slopes: &[Transform]) -> Vec<f64> {
        let equations = self.equations;
        let cauchy = |i: usize| equations.limit(i) / equations.half_length(i);
        let row = |(i, slopes): (usize, &Transform)| equations.test(i, slopes, 0) + cauchy(i) - equations.punch(i, 0);
        slopes.iter().enumerate().map(row).collect()
    }

    /// The modes beyond those solved for, from the rows of their own.
    fn iterate(&self, state: &mut State) -> Unsettled {
        let equations = self.equations;
        let n = equations.contacts();
        let solved = |i: usize| equations.modes(i);
        // what the last rounds changed
        let mut residuals = vec![self.residual(&state.slopes)];
        let mut pressures: Vec<Vec<f64>> = Vec::new();
        for _ in 0..SWEEPS {
            let mut news: Modes = Vec::with_capacity(n);
            for i in 0..n {
                let slopes = &state.slopes[i];
                let update = |(k, old): (usize, &mut f64)| {
                    let m = solved(i) + k;
                    let row = equations.punch(i, m) - equations.test(i, slopes, m);
                    let new = row * 2.0 * order(m) / equations.limit(i);
                    new - std::mem::replace(old, new)
                };
                news.push(state.beyond[i].iter_mut().enumerate().map(update).collect());
            }
            let mut extra: Vec<Transform> = (0..n).map(|i| equations.nothing(i)).collect();
            self.add(&mut extra, &news, solved);
            let change = self.solve(|i, m| -equations.test(i, &extra[i], m));
            self.add(&mut state.slopes, &news, solved);
            self.add(&mut state.slopes, &change, |_| 1);
            for (y, dy) in state.higher.iter_mut().flatten().zip(change.iter().flatten()) {
                *y += dy;
            }
            residuals.push(self.residual(&state.slopes));
            let size = |(i, news): (usize, &Vec<f64>)| -> f64 {
                news.iter().enumerate().map(|(k, y)| (y / order(solved(i) + k)).abs()).sum()
            };
            pressures.push(news.iter().enumerate().map(size).collect());
        }
        // a geometric series goes on with the ratio of its last terms
        let rest = |before: f64, last: f64| if last < before { last * last / (before - last) } else { last };
        let change = |k: usize, i: usize| (residuals[k][i] - residuals[k - 1][i]).abs();
        Unsettled {
            residual: (0..n).map(|i| rest(change(SWEEPS - 1, i), change(SWEEPS, i))).collect(),
            pressure: (0..n)
                .map(|i| rest(pressures[SWEEPS - 2][i], pressures[SWEEPS - 1][i]) / std::f64::consts::PI)
                .collect(),
        }
    }

    /// Derivatives of the residual and of the modes with respect to ln a of each contact in turn.
    fn derivatives(&self, state: &State) -> (Mat<f64>, Vec<Modes>) {
        let equations = self.equations;
        let n = equations.contacts();
        let mut jacobian = Mat::zeros(n, n);
        let mut sensitivity = Vec::with_capacity(n);
        for by in 0..n {
            let pressure = equations.transform(by, &state.higher[by], 1, true);
            let mut change: Vec<Transform> = (0..n).map(|i| equations.nothing(i)).collect();
            for i in self.near(by) {
                change[i] = equations.unit_slopes_change(i, by);
                equations.add_response(&mut change[i], i, by, &pressure);
            }
            let row = |i: usize, m: usize| -> f64 {
                let own = || equations.test_slope(i, &state.slopes[i], m) - equations.punch_slope(i, m);
                equations.test(i, &change[i], m) + if i == by { own() } else { 0.0 }
            };
            let response = self.solve(|i, m| -row(i, m));
            let mut moved: Vec<Transform> = (0..n).map(|i| equations.nothing(i)).collect();
            self.add(&mut moved, &response, |_| 1);
            for i in 0..n {
                jacobian[(i, by)] = row(i, 0) + equations.test(i, &moved[i], 0);
            }
            jacobian[(by, by)] -= equations.limit(by) / equations.half_length(by);
            let first = |i: usize| if i == by { -2.0 / equations.half_length(i) } else { 0.0 };
            let with_first = |(i, response): (usize, Vec<f64>)| std::iter::once(first(i)).chain(response).collect();
            sensitivity.push(response.into_iter().enumerate().map(with_first).collect());
        }
        (jacobian, sensitivity)
    }
}
