//! Integrals beyond the turning points.
//!
//! Beyond a wavenumber R past the turning points, Ra > order, products of two modes split,
//! J_k(ζa) J_j(ζa) = ½ Re(H_k H̄_j) + ½ Re(H_k H_j). The first part does not oscillate, the second decays in
//! the upper half of the complex plane, where its path is turned.
use std::ops::Range;

use num_complex::Complex64;

use crate::contact::problem::twin::Twin;
use crate::kernel::Kernel;
use crate::numeric::bessel::{self, Wanted};
use crate::numeric::chebyshev::Series;
use crate::numeric::quadrature::{LARGEST, laguerre_rule, rule};
use crate::numeric::vector::vectorised;
use crate::numeric::workspace::Workspace;

/// Nodes whose Bessel functions are made together: no number depends on it, but tables of many more do not stay in the cache of the processor.
pub(crate) const TOGETHER: usize = 64;
/// No admissible scene was seen to need more wavenumbers, nor more than half as many smooth nodes of tails. Twice as many: scenes whose
/// contacts are thousands of thicknesses long take twice the time until they are solved to fewer digits.
pub(crate) const MOST_WAVENUMBERS: usize = 16_000;
/// Points of the polynomial that continues a kernel into the complex plane.
const CONTINUED: usize = 28;

/// Past the turning point of the highest order, and where Hankel's expansion holds for half-lengths nearby.
pub(crate) fn turning(orders: usize) -> f64 {
    1.3 * orders as f64 + 22.0
}

/// Points per stretch of the part of a tail that does not oscillate: the phases of H_k and H_j, equal far out, still
/// turn against each other by 0.4 (k − j) near the turning point, R, and less the farther out.
fn smooth_points(orders: usize, near: f64) -> usize {
    24 + (orders as f64 / 6.0 * near) as usize
}

/// Nodes beyond R.
#[derive(Default)]
pub(crate) struct Tail {
    /// Nodes of ½ Re(H_k H̄_j) = ½ (J J + Y Y).
    pub(crate) smooth: Vec<f64>,
    /// Their weights dζ/ζ, ½ included.
    smooth_weights: Vec<f64>,
    /// Nodes of ½ Re(H_k H_j) on the path into the complex plane.
    pub(crate) turned: Vec<Complex64>,
    /// s/2 there: H e^(s/2) is of size one.
    pub(crate) lift: Vec<f64>,
    /// Their weights dζ/ζ, ½ included.
    turned_weights: Vec<Complex64>,
    /// R.
    from: f64,
}

impl Tail {
    /// For an interval of a contact, and Bessel functions up to the given order: beyond `to` the kernel is nothing, or a polynomial in 1/ζ next to a graded face. `None` if
    /// that takes too many nodes.
    pub(crate) fn new(
        (kernel, contact): (&Kernel, usize),
        half_length: f64,
        orders: usize,
        [from, to]: [f64; 2],
    ) -> Option<Self> {
        let twin = Twin::of(kernel.geometry());
        let mut tail = Self { from, ..Self::default() };
        let mut reached = from;
        for panel in kernel.panels.iter().filter(|panel| panel.to > from && panel.from < to) {
            let points = smooth_points(orders, from / reached);
            if tail.smooth.len() + points > MOST_WAVENUMBERS / 2 {
                return None;
            }
            let parts = points.div_ceil(LARGEST);
            let width = (panel.to - reached) / parts as f64;
            for part in 0..parts {
                let start = reached + width * part as f64;
                tail.add(twin, rule(points.div_ceil(parts)).on(start, start + width));
            }
            reached = panel.to;
        }
        if !kernel.asymptote(contact).is_constant() {
            // ζ = start/u
            let nodes = rule(smooth_points(orders, from / reached)).on(0.0, 1.0);
            tail.add(twin, nodes.map(|(u, weight)| (reached / u, weight * reached / (u * u))));
        }
        // on the path into the complex plane
        let laguerre = laguerre_rule(32);
        for (s, weight) in laguerre.nodes.iter().zip(&laguerre.weights) {
            let zeta = Complex64::new(from, 0.5 * s / half_length);
            tail.turned.push(zeta);
            tail.lift.push(0.5 * s);
            let weight = Complex64::new(0.0, 0.25 * weight / half_length);
            tail.turned_weights.push(if twin == Twin::Round { weight } else { weight / zeta });
        }
        Some(tail)
    }

    fn add(&mut self, twin: Twin, nodes: impl Iterator<Item = (f64, f64)>) {
        for (zeta, weight) in nodes {
            self.smooth.push(zeta);
            self.smooth_weights.push(0.5 * weight / zeta * twin.measure(zeta));
        }
    }

    /// Adds the weights of a kernel, which is known on the real axis, to those it has at real wavenumbers.
    pub(crate) fn extend(&self, weights: &mut Weights, kernel: impl Fn(f64) -> f64) {
        let first = weights.plain.len();
        weights.plain.extend(self.smooth.iter().zip(&self.smooth_weights).map(|(zeta, weight)| weight * kernel(*zeta)));
        weights.plain.extend_from_within(first..);
        if self.turned.is_empty() {
            return;
        }
        let continued = Series::of(0.55 * self.from, 2.2 * self.from, CONTINUED, &kernel);
        let turned = self.turned.iter().zip(&self.turned_weights);
        weights.turned.extend(turned.map(|(zeta, weight)| weight * continued.eval_complex(*zeta)));
    }

    /// Rows of the tail.
    pub(crate) fn rows(&self) -> usize {
        2 * (self.smooth.len() + self.turned.len())
    }

    /// J, Y and both parts of H in its rows, from row number `first` of `rows` on, for an interval of one half-length: `scale` times the `wanted` orders
    /// below `orders`, one column after the other.
    pub(crate) fn tabulate(
        &self,
        workspace: &Workspace,
        (half_length, scale): (f64, f64),
        (wanted, orders): (Wanted, usize),
        (first, rows): (usize, usize),
        values: &mut [f64],
    ) {
        let (count, turned) = (self.smooth.len(), self.turned.len());
        let all: Vec<usize> = (0..orders).collect();
        for (start, some) in (0..).step_by(TOGETHER).zip(self.smooth.chunks(TOGETHER)) {
            let some: Vec<f64> = some.iter().map(|zeta| zeta * half_length).collect();
            let length = some.len();
            let [mut j, mut y] = [0, 1].map(|_| workspace.take(orders * length));
            bessel::jy_table(wanted.kind(), orders, &some, &mut j, &mut y);
            for (&n, column) in wanted.of(&all).zip(values.chunks_exact_mut(rows)) {
                for (place, values) in [(first + start, &j), (first + count + start, &y)] {
                    let values = &values[n * length..(n + 1) * length];
                    column[place..place + length].iter_mut().zip(values).for_each(|(out, value)| *out = value * scale);
                }
            }
            [j, y].into_iter().for_each(|table| workspace.keep(table));
        }
        let paths: Vec<Complex64> = self.turned.iter().map(|zeta| zeta * half_length).collect();
        // what exp(−iz) H_n is multiplied by
        let factors = paths.iter().zip(&self.lift).map(|(z, lift)| (Complex64::I * z + lift).exp() * scale);
        let factors: Vec<Complex64> = factors.collect();
        let mut h = vec![Complex64::ZERO; orders * turned];
        bessel::hankel_table(wanted.kind(), orders, &paths, &mut h);
        for (&n, column) in wanted.of(&all).zip(values.chunks_exact_mut(rows)) {
            let (re, im) = column[first + 2 * count..].split_at_mut(turned);
            for (i, (h, factor)) in h[n * turned..(n + 1) * turned].iter().zip(&factors).enumerate() {
                let value = h * factor;
                (re[i], im[i]) = (value.re, value.im);
            }
        }
    }

    /// Multiplies values in its rows by the wavenumbers.
    pub(crate) fn times_wavenumbers(&self, values: &mut [f64]) {
        let (plain, turned) = values.split_at_mut(2 * self.smooth.len());
        plain.iter_mut().zip(self.smooth.iter().chain(&self.smooth)).for_each(|(value, zeta)| *value *= zeta);
        let (real, imaginary) = turned.split_at_mut(self.turned.len());
        for ((re, im), zeta) in real.iter_mut().zip(imaginary).zip(&self.turned) {
            let product = Complex64::new(*re, *im) * zeta;
            (*re, *im) = (product.re, product.im);
        }
    }
}

/// Weights of one kernel at the rows of a contact: real wavenumbers, J and Y at the smooth nodes, and both parts of H on
/// the turned path.
#[derive(Default)]
pub(crate) struct Weights {
    /// Of all real rows.
    pub(crate) plain: Vec<f64>,
    /// Of the turned path, where Re(w H_k H_j) is wanted.
    turned: Vec<Complex64>,
}

impl Weights {
    /// Rows that they cover, the first of all.
    pub(crate) fn rows(&self) -> usize {
        self.plain.len() + 2 * self.turned.len()
    }

    /// The rows that they cover: some real ones after the other, and last the turned path.
    pub(crate) fn blocks(&self, most: usize) -> impl Iterator<Item = Range<usize>> + use<> {
        let (plain, rows) = (self.plain.len(), self.rows());
        let real = (0..plain).step_by(most).map(move |first| first..plain.min(first + most));
        real.chain((plain < rows).then_some(plain..rows))
    }

    /// Weights · all rows.
    pub(crate) fn weighted(&self, rows: &[f64]) -> Vec<f64> {
        let mut weighted = vec![0.0; self.rows()];
        for block in self.blocks(self.rows().max(1)) {
            self.times(block.clone(), &rows[block.clone()], &mut weighted[block]);
        }
        weighted
    }

    /// Weights · rows of one of the [`Self::blocks`].
    pub(crate) fn times(&self, block: Range<usize>, rows: &[f64], out: &mut [f64]) {
        if block.start == self.plain.len() {
            out.fill(0.0);
            return self.add_turned(1.0, rows, out);
        }
        vectorised(
            #[inline(always)]
            || {
                for ((out, weight), row) in out.iter_mut().zip(&self.plain[block]).zip(rows) {
                    *out = weight * row;
                }
            },
        );
    }

    /// Adds factor · weights · rows of the turned path.
    fn add_turned(&self, factor: f64, rows: &[f64], out: &mut [f64]) {
        for (k, weight) in self.turned.iter().enumerate() {
            let (re, im) = (k, self.turned.len() + k);
            let value = (weight * Complex64::new(rows[re], rows[im])).conj();
            out[re] += factor * value.re;
            out[im] += factor * value.im;
        }
    }
}
