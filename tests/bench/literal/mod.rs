//! The method of the paper on double contact, taken literally: four kernels integrated each for itself between two
//! cut-offs, eqs. (2.20), (2.25); Chebyshev-Gauss collocation, eqs. (3.3a, b); Newton's downhill method until the
//! resultants, eqs. (3.3c, d), are met to 1e-5. The transforms are tabulated once. The equations are assembled in two ways, as
//! they are written ([`collocate`]) and by matrix products ([`vectorised::collocate`]), which give the same answer.
pub mod determinants;
pub mod vectorised;

use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector};
use recede::numeric::quadrature::rule;

/// What the paper leaves open, or states.
#[derive(Clone, Copy)]
pub struct Settings {
    /// N, even.
    pub nodes: usize,
    /// Cut-offs of the wavenumber, times the thickness.
    pub low: f64,
    pub high: f64,
    /// Residual of the resultants.
    pub residual: f64,
}

impl Settings {
    /// The paper states the residual; 40 nodes and these cut-offs give its tables' errors.
    pub const USUAL: Self = Self { nodes: 40, low: 1e-2, high: 50.0, residual: 1e-5 };
}

/// Transforms of a stack: λμC of each contact's gap, and between neighbours.
pub trait Transforms {
    /// Responses of the gaps to their own pressures, and of the upper and the lower one of each pair of neighbours to the
    /// pressure of the other.
    fn at(&self, lambda: f64) -> (Vec<f64>, Vec<[f64; 2]>);
    /// Limits of the former for large wavenumbers, a_0 and b_0.
    fn limits(&self) -> Vec<f64>;
}

/// Half-lengths and pressures at x = 0.
pub struct Answer {
    pub half_lengths: Vec<f64>,
    pub peaks: Vec<f64>,
    pub iterations: usize,
    pub converged: bool,
}

/// What is solved: the punch has the slope `slope`, the force is P/μ, and Newton's method starts from `start`.
pub struct Problem<'a> {
    pub transforms: &'a dyn Transforms,
    pub slope: &'a dyn Fn(f64) -> f64,
    pub force: f64,
    pub start: &'a [f64],
}

/// A way to assemble and solve the collocation equations at given half-lengths, with a number of nodes: P(s_k) of every
/// contact, and the residuals of the resultants.
pub type Collocation = fn(&Problem, &Table, &[f64], usize) -> (Vec<Vec<f64>>, Vec<f64>);

/// The transforms at all wavenumbers, times the weights of the integration.
pub struct Table {
    lambda: Vec<f64>,
    own: Vec<Vec<f64>>,
    coupling: Vec<[Vec<f64>; 2]>,
    limits: Vec<f64>,
}

impl Table {
    /// Eight Gauss points on panels that double in width up to 1/4, and are 1/2 wide from there on.
    fn new(transforms: &dyn Transforms, settings: &Settings) -> Self {
        let limits = transforms.limits();
        let n = limits.len();
        let mut table = Self {
            lambda: Vec::new(),
            own: vec![Vec::new(); n],
            coupling: vec![[Vec::new(), Vec::new()]; n - 1],
            limits,
        };
        let mut edge = settings.low;
        while edge < settings.high {
            let next = (2.0 * edge).min(edge + 0.5).min(settings.high);
            for (lambda, weight) in rule(8).on(edge, next) {
                let (own, coupling) = transforms.at(lambda);
                table.lambda.push(lambda);
                for (i, value) in own.iter().enumerate() {
                    table.own[i].push(weight * (value / table.limits[i] - 1.0));
                }
                for (table, values) in table.coupling.iter_mut().zip(coupling) {
                    (0..2).for_each(|side| table[side].push(weight * values[side]));
                }
            }
            edge = next;
        }
        table
    }

    fn integral(&self, weights: &[f64], u: f64) -> f64 {
        weights.iter().zip(&self.lambda).map(|(w, lambda)| w * (lambda * u).sin()).sum()
    }
}

impl Answer {
    /// Half-length and pressure at x = 0 of one contact after the other.
    pub fn values(&self) -> Vec<f64> {
        self.half_lengths.iter().zip(&self.peaks).flat_map(|(a, p)| [*a, *p]).collect()
    }
}

/// The largest difference between the pressures that the two ways of assembling find at the half-lengths of the start,
/// relative to the largest pressure of the contact.
pub fn difference(problem: &Problem, settings: &Settings) -> f64 {
    let table = Table::new(problem.transforms, settings);
    let [one, other] = [collocate, vectorised::collocate]
        .map(|way: Collocation| way(problem, &table, problem.start, settings.nodes).0);
    let apart = |(one, other): (&Vec<f64>, &Vec<f64>)| {
        let largest = one.iter().fold(0.0, |m: f64, p| m.max(p.abs()));
        let off = one.iter().zip(other).map(|(p, q)| (p - q).abs() / largest);
        // not a number is a difference
        off.fold(0.0, |m: f64, off| if off.is_nan() { f64::INFINITY } else { m.max(off) })
    };
    one.iter().zip(&other).map(apart).fold(0.0, f64::max)
}

/// Newton's downhill method in the half-lengths.
pub fn solve(problem: &Problem, settings: &Settings, collocation: Collocation) -> Answer {
    let table = Table::new(problem.transforms, settings);
    let collocate = |half_lengths: &[f64]| collocation(problem, &table, half_lengths, settings.nodes);
    let norm = |e: &[f64]| e.iter().fold(0.0, |m: f64, e| m.max(e.abs()));
    let mut half_lengths = problem.start.to_vec();
    let (mut unknown, mut residuals) = collocate(&half_lengths);
    let mut iterations = 1;
    while norm(&residuals) > settings.residual && iterations < 200 {
        let n = half_lengths.len();
        let mut jacobian = DMatrix::zeros(n, n);
        for by in 0..n {
            let mut moved = half_lengths.clone();
            moved[by] *= 1.0 + 1e-6;
            let changed = collocate(&moved).1;
            iterations += 1;
            for i in 0..n {
                jacobian[(i, by)] = (changed[i] - residuals[i]) / (1e-6 * half_lengths[by]);
            }
        }
        let Some(step) = jacobian.lu().solve(&DVector::from_vec(residuals.clone())) else { break };
        // downhill: half the step until the residual falls
        let mut shorten = 1.0;
        loop {
            let trial: Vec<f64> = half_lengths.iter().zip(step.iter()).map(|(a, d)| a - shorten * d).collect();
            if trial.iter().all(|a| *a > 0.0) {
                let (found, left) = collocate(&trial);
                iterations += 1;
                if norm(&left) < norm(&residuals) {
                    (half_lengths, unknown, residuals) = (trial, found, left);
                    break;
                }
            }
            shorten *= 0.5;
            if shorten < 1e-4 {
                let peaks = peaks(&unknown, settings.nodes);
                return Answer { half_lengths, peaks, iterations, converged: false };
            }
        }
    }
    let converged = norm(&residuals) <= settings.residual;
    Answer { half_lengths, peaks: peaks(&unknown, settings.nodes), iterations, converged }
}

/// P(s_k) of every contact from eqs. (3.3a, b), and the residuals of eqs. (3.3c, d).
pub fn collocate(problem: &Problem, table: &Table, half_lengths: &[f64], nodes: usize) -> (Vec<Vec<f64>>, Vec<f64>) {
    let n = half_lengths.len();
    let s: Vec<f64> = (1..=nodes).map(|k| (PI * k as f64 / (nodes + 1) as f64).cos()).collect();
    // j = N/2 + 1, x = 0, holds by itself
    let r: Vec<f64> = (1..=nodes + 1)
        .filter(|j| *j != nodes / 2 + 1)
        .map(|j| (PI * (2 * j - 1) as f64 / (2 * (nodes + 1)) as f64).cos())
        .collect();
    let weight = |k: usize| (1.0 - s[k] * s[k]) / (nodes + 1) as f64;
    let mut matrix = DMatrix::zeros(n * nodes, n * nodes);
    let mut right = DVector::zeros(n * nodes);
    for i in 0..n {
        let a = half_lengths[i];
        for (j, r) in r.iter().enumerate() {
            let row = i * nodes + j;
            for k in 0..nodes {
                let own = 1.0 / (r - s[k]) + a * table.integral(&table.own[i], a * (r - s[k]));
                matrix[(row, i * nodes + k)] = weight(k) * table.limits[i] * own;
                for l in [i.wrapping_sub(1), i + 1] {
                    if l >= n {
                        continue;
                    }
                    let b = half_lengths[l];
                    let other = b * table.integral(&table.coupling[i.min(l)][usize::from(l < i)], a * r - b * s[k]);
                    matrix[(row, l * nodes + k)] = weight(k) * other;
                }
            }
            if i == 0 {
                right[row] = (problem.slope)(a * r);
            }
        }
    }
    let solution = matrix.lu().solve(&right).unwrap_or_else(|| DVector::from_element(n * nodes, f64::NAN));
    let unknown: Vec<Vec<f64>> = (0..n).map(|i| solution.rows(i * nodes, nodes).iter().copied().collect()).collect();
    let residual = |i: usize| {
        PI * half_lengths[i] / problem.force * (0..nodes).map(|k| weight(k) * unknown[i][k]).sum::<f64>() - 1.0
    };
    let residuals = (0..n).map(residual).collect();
    (unknown, residuals)
}

/// The pressures at s = 0, per unit of the shear modulus, from the polynomials through P(s_k).
fn peaks(unknown: &[Vec<f64>], nodes: usize) -> Vec<f64> {
    let step = PI / (nodes + 1) as f64;
    let coefficient = |p: &[f64], j: usize| {
        let sum: f64 = (1..=nodes).map(|k| (step * k as f64).sin() * (step * (j * k) as f64).sin() * p[k - 1]).sum();
        2.0 / (nodes + 1) as f64 * sum
    };
    unknown.iter().map(|p| (1..=nodes).map(|j| coefficient(p, j) * (0.5 * PI * j as f64).sin()).sum()).collect()
}
