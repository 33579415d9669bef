//! Interpolation by polynomials: from Gauss nodes, and as Chebyshev series.

use super::longest;
use super::quadrature::{self, SIZES, rule};
use num_complex::Complex64;
use std::f64::consts::PI;
use std::ops::{Add, Mul, Sub};
use std::sync::{LazyLock, OnceLock};

/// Gauss-Legendre nodes of a panel, the unit in which functions of the wavenumber are sampled.
pub const PANEL: usize = 16;

/// How many of the highest coefficients stand for all that are missing.
const TAIL: usize = 3;

/// Weights of the barycentric formula for distinct nodes, the largest of magnitude one.
///
/// Source: Berrut and Trefethen 2004, (3.2).
pub fn barycentric_weights(nodes: &[f64]) -> Vec<f64> {
    let (lo, hi) = nodes.iter().fold((f64::MAX, f64::MIN), |(lo, hi), &x| (x.min(lo), x.max(hi)));
    // Distances in quarters of the span: their products neither overflow nor underflow.
    let scale = 4.0 / (hi - lo);
    let mut weights: Vec<f64> = nodes
        .iter()
        .enumerate()
        .map(|(j, x)| {
            let others = nodes.iter().enumerate().filter(|(k, _)| *k != j);
            1.0 / others.fold(1.0, |product, (_, y)| product * (x - y) * scale)
        })
        .collect();
    let largest = longest(weights.iter().copied());
    weights.iter_mut().for_each(|w| *w /= largest);
    weights
}

/// The values at `x` of the polynomials that are 1 at one node and 0 at the others: their scalar product with the
/// values of a function at the nodes interpolates the function. Exact at the nodes.
pub fn interpolation_row(nodes: &[f64], weights: &[f64], x: f64, row: &mut [f64]) {
    let mut sum = 0.0;
    for j in 0..row.len().min(nodes.len()).min(weights.len()) {
        let pull = weights[j] / (x - nodes[j]);
        if pull.is_infinite() {
            row.fill(0.0);
            row[j] = 1.0;
            return;
        }
        row[j] = pull;
        sum += pull;
    }
    row.iter_mut().for_each(|r| *r /= sum);
}

/// What the values at the nodes of `rule(PANEL)` contribute to the value at x, −1 ≤ x ≤ 1, of the polynomial through them.
pub fn panel_row(x: f64) -> [f64; PANEL] {
    static WEIGHTS: LazyLock<Vec<f64>> = LazyLock::new(|| barycentric_weights(&rule(PANEL).nodes));
    let mut row = [0.0; PANEL];
    interpolation_row(&rule(PANEL).nodes, &WEIGHTS, x, &mut row);
    row
}

/// Interpolation from the nodes of `rule(PANEL)` to some places: `matrix[j * places.len() + i]` is what the value at panel node `j` contributes
/// at place `i`.
pub fn panel_columns(places: &[f64]) -> Vec<f64> {
    let mut columns = vec![0.0; PANEL * places.len()];
    for (i, x) in places.iter().enumerate() {
        panel_row(*x).into_iter().enumerate().for_each(|(j, value)| columns[j * places.len() + i] = value);
    }
    columns
}

/// The same to the nodes of `rule(n)`.
pub fn panel_matrix(n: usize) -> &'static [f64] {
    static MATRICES: [OnceLock<Vec<f64>>; SIZES.len()] = [const { OnceLock::new() }; SIZES.len()];
    MATRICES[quadrature::position(n)].get_or_init(|| panel_columns(&rule(n).nodes))
}

/// How well a panel resolves a function: the last Legendre coefficients relative to the largest one, from the values at
/// the nodes of `rule(PANEL)`. Infinite if a value is not finite, zero if all values are zero.
pub fn legendre_tail(values_at_rule16: &[f64; PANEL]) -> f64 {
    // Row j is what the value at x_j contributes to the coefficients of all P_l: (l + 1/2) w_j P_l(x_j).
    static ANALYSIS: LazyLock<[[f64; PANEL]; PANEL]> = LazyLock::new(|| {
        let rule = rule(PANEL);
        let mut below = [0.0; PANEL];
        let mut here = [1.0; PANEL];
        let mut rows = [[0.0; PANEL]; PANEL];
        for l in 0..PANEL {
            rows.iter_mut().enumerate().for_each(|(j, row)| row[l] = (l as f64 + 0.5) * rule.weights[j] * here[j]);
            let (a, b) = ((2 * l + 1) as f64 / (l + 1) as f64, l as f64 / (l + 1) as f64);
            let above = std::array::from_fn(|j| a * rule.nodes[j] * here[j] - b * below[j]);
            (below, here) = (here, above);
        }
        rows
    });
    let mut coefficients = [0.0; PANEL];
    for (row, value) in ANALYSIS.iter().zip(values_at_rule16) {
        coefficients.iter_mut().zip(row).for_each(|(coefficient, part)| *coefficient += part * value);
    }
    tail(&coefficients)
}

/// The last coefficients relative to the largest.
fn tail(coefficients: &[f64]) -> f64 {
    let all = longest(coefficients.iter().copied());
    let last = longest(coefficients.iter().rev().take(TAIL).copied());
    if all.is_infinite() { f64::INFINITY } else { last / all.max(f64::MIN_POSITIVE) }
}

/// The `n` points of [lo, hi] that a [`Series`] is made from, ascending: the extrema of a Chebyshev polynomial, ends
/// included (the middle if `n` is 1).
pub fn points(lo: f64, hi: f64, n: usize) -> Vec<f64> {
    let last = n.saturating_sub(1);
    let point = |k: usize| match k {
        _ if last == 0 => 0.5 * (lo + hi),
        0 => lo,
        _ if k == last => hi,
        _ => 0.5 * (lo + hi) - 0.5 * (hi - lo) * cos_pi(k, last),
    };
    (0..n).map(point).collect()
}

/// A function on the interval [lo, hi] as a sum of Chebyshev polynomials.
///
/// ```
/// use recede::numeric::chebyshev::Series;
/// let log = Series::of(1.0, 2.0, 24, f64::ln);
/// assert!((log.eval(1.5) - 1.5f64.ln()).abs() < 1e-15);
/// assert!(log.tail() < 1e-14);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    lo: f64,
    hi: f64,
    coefficients: Vec<f64>,
}

impl Series {
    /// The polynomial that takes the given values at `points(lo, hi, values.len())`.
    pub fn from_values_at_points(lo: f64, hi: f64, values: &[f64]) -> Self {
        let last = values.len().saturating_sub(1);
        if last == 0 {
            return Self { lo, hi, coefficients: values.to_vec() };
        }
        let cosines: Vec<f64> = (0..2 * last).map(|k| cos_pi(k, last)).collect();
        let ends = |k: usize| if k == 0 || k == last { 0.5 } else { 1.0 };
        let coefficient = |j: usize| {
            let terms = values.iter().rev().enumerate();
            let sum: f64 = terms.map(|(k, v)| ends(k) * v * cosines[j * k % (2 * last)]).sum();
            2.0 / last as f64 * ends(j) * sum
        };
        Self { lo, hi, coefficients: (0..=last).map(coefficient).collect() }
    }

    /// The polynomial through `n` values of a function.
    pub fn of(lo: f64, hi: f64, n: usize, function: impl FnMut(f64) -> f64) -> Self {
        let values: Vec<f64> = points(lo, hi, n).into_iter().map(function).collect();
        Self::from_values_at_points(lo, hi, &values)
    }

    /// The sum at `x`. Outside the interval this is an extrapolation.
    pub fn eval(&self, x: f64) -> f64 {
        clenshaw(&self.coefficients, ((x - self.lo) + (x - self.hi)) / (self.hi - self.lo), 0.0)
    }

    /// The sum at a complex `z`: the analytic continuation as long as `z` is within the ellipse of convergence.
    /// Rounding errors of high coefficients grow there.
    pub fn eval_complex(&self, z: Complex64) -> Complex64 {
        clenshaw(&self.coefficients, ((z - self.lo) + (z - self.hi)) / (self.hi - self.lo), Complex64::ZERO)
    }

    /// The factors of the powers t, t², ... of the way t from lo to hi, which is 1 at hi.
    pub fn powers<const N: usize>(&self) -> [f64; N] {
        // T_k(2t − 1) as a polynomial
        let (mut before, mut here) = (vec![0.0; N + 1], vec![0.0; N + 1]);
        (before[0], here[0], here[1]) = (1.0, -1.0, 2.0);
        let mut sum = [0.0; N];
        for coefficient in self.coefficients.iter().skip(1) {
            sum.iter_mut().zip(&here[1..]).for_each(|(sum, power)| *sum += coefficient * power);
            let next = |n: usize| {
                let raised = n.checked_sub(1).map_or(0.0, |n| here[n]);
                4.0 * raised - 2.0 * here[n] - before[n]
            };
            let next: Vec<f64> = (0..=N).map(next).collect();
            before = std::mem::replace(&mut here, next);
        }
        sum
    }

    /// The derivative.
    pub fn derivative(&self) -> Self {
        let scale = 2.0 / (self.hi - self.lo);
        let count = self.coefficients.len();
        // c'_(k−1) = c'_(k+1) + 2k c_k, and half of it for k = 1
        let mut coefficients = vec![0.0; count + 1];
        for k in (1..count).rev() {
            coefficients[k - 1] = coefficients[k + 1] + 2.0 * k as f64 * scale * self.coefficients[k];
        }
        coefficients[0] *= 0.5;
        coefficients.truncate(count.saturating_sub(1).max(1));
        Self { coefficients, ..*self }
    }

    /// The size of the last coefficients relative to the largest: an estimate of the relative error.
    pub fn tail(&self) -> f64 {
        tail(&self.coefficients)
    }
}

/// cos(pi k/n), symmetric to the last bit.
fn cos_pi(k: usize, n: usize) -> f64 {
    let k = k.min(2 * n - k);
    (PI * (n as f64 - 2.0 * k as f64) / (2.0 * n as f64)).sin()
}

/// Clenshaw's sum of c_j T_j(t).
fn clenshaw<T>(coefficients: &[f64], t: T, zero: T) -> T
where
    T: Copy + Add<f64, Output = T> + Mul<T, Output = T> + Mul<f64, Output = T> + Sub<T, Output = T>,
{
    let Some((first, rest)) = coefficients.split_first() else {
        return zero;
    };
    let (mut here, mut above) = (zero, zero);
    for &c in rest.iter().rev() {
        (here, above) = (t * here * 2.0 - above + c, here);
    }
    t * here - above + *first
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: f64, b: f64, tolerance: f64) {
        assert!((a - b).abs() <= tolerance, "{a:e} is not {b:e}: off by {:e}", a - b);
    }

    #[test]
    fn interpolation_is_exact_at_the_nodes_and_for_polynomials() {
        let nodes = &rule(PANEL).nodes;
        let weights = barycentric_weights(nodes);
        let mut row = [0.0; PANEL];
        for (i, &x) in nodes.iter().enumerate() {
            interpolation_row(nodes, &weights, x, &mut row);
            assert!(row.iter().enumerate().all(|(j, &r)| r == f64::from(u8::from(i == j))));
        }
        for x in [-1.0, -0.99, 0.0, 1e-320, 0.3, 0.9999, 1.0, nodes[3].next_up(), nodes[9].next_down()] {
            interpolation_row(nodes, &weights, x, &mut row);
            for degree in [0, 1, 7, 15] {
                let value = row.iter().zip(nodes).map(|(r, t)| r * t.powi(degree)).sum();
                close(value, x.powi(degree), 2e-15);
            }
        }
    }

    #[test]
    fn a_series_tells_its_first_powers() {
        let polynomial = |x: f64| 3.0 - (x - 2.0) + 0.5 * (x - 2.0).powi(2) - 0.25 * (x - 2.0).powi(5);
        let [first, second, third] = Series::of(2.0, 4.0, 8, polynomial).powers();
        close(first, -2.0, 1e-13);
        close(second, 2.0, 1e-12);
        close(third, 0.0, 1e-11);
    }

    #[test]
    fn weights_do_not_depend_on_the_length_unit() {
        let nodes = points(-1.0, 1.0, 200);
        let scaled: Vec<f64> = nodes.iter().map(|x| 1e-200 * x).collect();
        for (a, b) in barycentric_weights(&nodes).into_iter().zip(barycentric_weights(&scaled)) {
            close(a, b, 1e-12);
        }
        assert_eq!(barycentric_weights(&[2.0]), [1.0]);
    }

    #[test]
    fn panel_matrix_carries_values_to_every_rule() {
        for n in SIZES {
            let mut values = vec![0.0; n];
            for (column, t) in panel_matrix(n).chunks_exact(n).zip(&rule(PANEL).nodes) {
                values.iter_mut().zip(column).for_each(|(value, part)| *value += part * t.sin());
            }
            for (value, x) in values.into_iter().zip(&rule(n).nodes) {
                close(value, x.sin(), 2e-15);
            }
        }
    }

    #[test]
    fn tails_tell_resolved_from_unresolved() {
        let tail_of = |f: &dyn Fn(f64) -> f64| legendre_tail(&std::array::from_fn(|i| f(rule(PANEL).nodes[i])));
        assert_eq!(tail_of(&|_| 0.0), 0.0);
        assert_eq!(tail_of(&|_| f64::NAN), f64::INFINITY);
        assert!(tail_of(&|x| x.cos()) < 1e-12);
        assert!(tail_of(&|x| 1e-300 * (30.0 * x).cos()) > 1e-2);
        assert!(tail_of(&|x| 1.0 / (x * x + 0.01)) > 1e-2);
    }

    #[test]
    fn series_evaluates_on_and_off_the_axis() {
        let (lo, hi) = (0.5, 3.0);
        let series = Series::of(lo, hi, 24, |x| (2.0 * x).sin() / x);
        for x in points(lo, hi, 57) {
            close(series.eval(x), (2.0 * x).sin() / x, 3e-15);
        }
        let z = Complex64::new(1.2, 0.3);
        assert!((series.eval_complex(z) - (2.0 * z).sin() / z).norm() < 1e-14);
    }

    #[test]
    fn points_include_the_ends_and_are_symmetric() {
        let p = points(-2.0, 2.0, 9);
        assert_eq!((p[0], p[4], p[8]), (-2.0, 0.0, 2.0));
        assert!(p.windows(2).all(|w| w[0] < w[1]));
        assert!((0..9).all(|k| p[k] == -p[8 - k]));
        assert_eq!(points(1.0, 2.0, 1), [1.5]);
        assert!(points(1.0, 2.0, 0).is_empty());
    }
}
