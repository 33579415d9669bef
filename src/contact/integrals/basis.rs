//! The transformed pressure modes of one contact at all nodes.
//!
//! p(x) = √(1 − s²) Σ c_j U_(j−1)(s), s = x/a, j odd, has the transform (2P/ζ) Σ y_j ψ_j(ζ) with ψ_j = J_j(ζa)/a and
//! y_1 = 1. The tests T_k/√(1 − s²) turn sin ζx into J_k(ζa). So all integrals need ψ_j for odd j, and Newton's method
//! the derivative with respect to ln a, z (J_(j−1) − J_(j+1))/(2a) − ψ_j, z = ζa, in which even orders are sums of odd ones,
//! J_n = z (J_(n−1) + J_(n+1))/(2n), but for J_0.
use std::sync::Arc;

use num_complex::Complex64;

use crate::contact::integrals::columns::{ColumnRange, Columns};
use crate::contact::integrals::layout::Layout;
use crate::contact::problem::Problem;
use crate::contact::problem::load::Given;
use crate::contact::problem::twin::Twin;
use crate::numeric::bessel::{self, Wanted};
use crate::numeric::vector::vectorised;
use crate::numeric::workspace::Workspace;

/// The modes of one contact: a row for each real wavenumber, then two for each node of the tail.
pub(crate) struct Basis {
    /// Half-length in units of L.
    pub(crate) half_length: f64,
    /// 2 J_1(z)/z − 1 at the real wavenumbers: the unit pressure's transform less its resultant.
    pub(crate) transform_minus_one: Vec<f64>,
    /// J_n/a for n = 0, 1, 3, 5, ..., one odd order more than there are modes.
    table: Columns,
    /// z at the real wavenumbers and at the smooth nodes of the tail, twice.
    arguments: Vec<f64>,
    /// z on the turned path.
    paths: Vec<Complex64>,
    twin: Twin,
}

impl Basis {
    /// The first `modes` modes of each contact of a problem.
    pub(crate) fn all(layout: &Layout, problem: &Problem, half_lengths: &[f64], modes: &[usize]) -> Vec<Self> {
        let workspace = &problem.kernel.workspace;
        let own = |(i, (a, modes)): (usize, (&f64, &usize))| match problem.sides[i].given() {
            Some(given) => Self::given(layout, i, given),
            None => Self::new(layout, i, *a, *modes, workspace),
        };
        half_lengths.iter().zip(modes).enumerate().map(own).collect()
    }

    /// The modes of contact `i` at one half-length.
    fn new(layout: &Layout, i: usize, half_length: f64, modes: usize, workspace: &Arc<Workspace>) -> Self {
        let (tail, reach) = (layout.tail(i), layout.own[i].reach);
        let mut arguments = Vec::with_capacity(reach + 2 * tail.smooth.len());
        for zeta in [&layout.zeta[..reach], &tail.smooth, &tail.smooth] {
            arguments.extend(zeta.iter().map(|zeta| zeta * half_length));
        }
        let paths: Vec<Complex64> = tail.turned.iter().map(|zeta| zeta * half_length).collect();
        let twin = layout.twin;
        let (rows, orders, scale) = (reach + tail.rows(), 2 * modes + 2, twin.norm / half_length);
        let wanted = Wanted::ZERO_AND_ODD.of_kind(twin.bessel);
        let mut table = Columns::new(rows, wanted.below(orders), workspace);
        bessel::scaled_orders(orders, wanted, &arguments[..reach], scale, rows, &mut table.values);
        let transform_minus_one = Vec::new();
        let mut basis = Self { half_length, transform_minus_one, table, arguments, paths, twin };
        if rows > reach {
            tail.tabulate((half_length, scale), (wanted, orders), (reach, rows), &mut basis.table.values);
        }
        if let Some(scales) = twin.scales() {
            let columns = basis.table.values.chunks_exact_mut(rows.max(1)).skip(1);
            columns.zip(scales).for_each(|(column, scale)| column.iter_mut().for_each(|value| *value *= scale));
            let transform = basis.arguments[..reach].iter().map(|z| bessel::spherical_jinc_minus_one(*z));
            basis.transform_minus_one = transform.collect();
            return basis;
        }
        let mut transform_minus_one = vec![0.0; reach];
        vectorised(
            #[inline(always)]
            || {
                for ((transform_minus_one, z), j1) in
                    transform_minus_one.iter_mut().zip(basis.arguments.iter()).zip(basis.value(0))
                {
                    *transform_minus_one = bessel::jinc_minus_one_from(*z, *j1 * half_length);
                }
            },
        );
        basis.transform_minus_one = transform_minus_one;
        basis
    }

    /// The only mode of the given pressure of contact `i`, whatever its transform. Its half-length is not varied, so that
    /// other orders do not matter.
    fn given(layout: &Layout, i: usize, given: &Given) -> Self {
        let zeta = &layout.zeta[..layout.own[i].reach];
        let transform_minus_one: Vec<f64> = zeta.iter().map(|zeta| given.transform_minus_one(*zeta)).collect();
        let mut table = Columns::zeros(zeta.len(), 3);
        for ((value, zeta), transform_minus_one) in
            table.column_mut(1).iter_mut().zip(zeta).zip(transform_minus_one.iter())
        {
            *value = 0.5 * zeta * (1.0 + transform_minus_one);
        }
        let arguments = zeta.iter().map(|zeta| zeta * given.half_length).collect();
        let (half_length, paths, twin) = (given.half_length, Vec::new(), layout.twin);
        Self { half_length, transform_minus_one, table, arguments, paths, twin }
    }

    /// −z J_2(z)/(2a) in every row: of p = (P/πa) [1/√(1 − s²) − 2 √(1 − s²)], the pressure next to sharp corners less a unit
    /// pressure of the same resultant.
    pub(crate) fn edges(&self) -> Vec<f64> {
        let factor = -1.0 / ((2.0 + self.twin.shift) * self.twin.norm);
        let third = self.twin.scales().map_or(1.0, |scales| scales[1].recip());
        let sum = |(j1, j3): (&f64, &f64)| factor * (j1 + third * j3);
        let mut edges: Vec<f64> = self.value(0).iter().zip(self.value(1)).map(sum).collect();
        self.scale(&mut edges, false);
        self.scale(&mut edges, false);
        edges
    }

    /// Number of rows.
    pub(crate) fn rows(&self) -> usize {
        self.table.rows()
    }

    /// ψ of the first `count` modes, and of one more that may be asked for.
    pub(crate) fn values(&self, count: usize) -> ColumnRange<'_> {
        self.table.part(1..count + 1)
    }

    /// ψ of mode `m` (order 2m + 1) in every row.
    pub(crate) fn value(&self, m: usize) -> &[f64] {
        self.table.column(m + 1)
    }

    /// J_0/a in every row.
    fn zeroth(&self) -> &[f64] {
        self.table.column(0)
    }

    /// Σ_m y_m ψ_m in every row.
    pub(crate) fn combine(&self, y: &[f64]) -> Vec<f64> {
        self.values(y.len()).combine(y)
    }

    /// Σ_m y_m ψ_m for the modes from number `first` on, in every row.
    pub(crate) fn combine_from(&self, first: usize, y: &[f64]) -> Vec<f64> {
        self.values(first + y.len()).part(first..first + y.len()).combine(y)
    }

    /// Σ over the rows of `s` ψ_m, for the first `count` modes.
    pub(crate) fn test(&self, s: &[f64], count: usize) -> Vec<f64> {
        self.values(count).test(s)
    }

    /// Adds factor · [`Self::test`], with as many modes as there are rows.
    pub(crate) fn add_tested(&self, factor: f64, s: &[f64], rows: &mut [f64]) {
        self.values(rows.len()).add_tested(factor, s, rows);
    }

    /// The derivative of [`Self::combine`] with respect to ln a.
    pub(crate) fn combine_slopes(&self, y: &[f64], combined: &[f64]) -> Vec<f64> {
        // (z/2) Σ d_m J_2m, d_m = y_m − y_(m−1), and J_2m = (z/2) (J_(2m−1) + J_(2m+1))/(2m) but for the first
        let scaled = self.twin.scales().map(|_| self.twin.scaled(y));
        let y = scaled.as_deref().unwrap_or(y);
        let mut odd = vec![0.0; y.len() + 1];
        for m in 1..=y.len() {
            let part = (y.get(m).unwrap_or(&0.0) - y[m - 1]) / ((2 * m) as f64 + self.twin.shift);
            odd[m - 1] += part;
            odd[m] += part;
        }
        self.unscale(&mut odd);
        let mut slopes = self.combine(&odd);
        self.scale(&mut slopes, false);
        slopes.iter_mut().zip(self.zeroth()).for_each(|(slope, zeroth)| *slope += y[0] * zeroth);
        self.scale(&mut slopes, false);
        let norm = self.twin.norm;
        slopes.iter_mut().zip(combined).for_each(|(slope, value)| *slope -= norm * value);
        slopes
    }

    /// Adds Σ over the rows of `s` times the derivative of ψ_m with respect to ln a, where `tested` is [`Self::test`].
    pub(crate) fn add_tested_slopes(&self, s: &[f64], tested: &[f64], rows: &mut [f64]) {
        let mut scaled = s.to_vec();
        self.scale(&mut scaled, true);
        let zeroth: f64 = self.zeroth().iter().zip(scaled.iter()).map(|(zeroth, s)| zeroth * s).sum();
        self.scale(&mut scaled, true);
        let mut odd = self.test(&scaled, tested.len() + 1);
        self.unscale(&mut odd);
        let (shift, norm) = (self.twin.shift, self.twin.norm);
        let even = |m: usize| if m == 0 { zeroth } else { (odd[m - 1] + odd[m]) / ((2 * m) as f64 + shift) };
        let slope = |(m, value): (usize, &f64)| self.twin.scale(m) * (even(m) - even(m + 1)) - norm * value;
        rows.iter_mut().zip(tested.iter().enumerate().map(slope)).for_each(|(row, slope)| *row += slope);
    }

    /// Divides by the factors of the modes.
    fn unscale(&self, modes: &mut [f64]) {
        if let Some(scales) = self.twin.scales() {
            modes.iter_mut().zip(scales).for_each(|(value, scale)| *value /= scale);
        }
    }

    /// Multiplies by z/2 in every row; `adjoint` on the side of the tests.
    fn scale(&self, rows: &mut [f64], adjoint: bool) {
        let (plain, turned) = rows.split_at_mut(self.arguments.len());
        plain.iter_mut().zip(self.arguments.iter()).for_each(|(value, z)| *value *= 0.5 * z);
        let (real, imaginary) = turned.split_at_mut(self.paths.len());
        for ((re, im), z) in real.iter_mut().zip(imaginary).zip(&self.paths) {
            let half = 0.5 * if adjoint { z.conj() } else { *z };
            let product = Complex64::new(*re, *im) * half;
            (*re, *im) = (product.re, product.im);
        }
    }
}
