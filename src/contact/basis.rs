//! The transformed pressure modes of one contact at all nodes.
//!
//! p(x) = √(1 − s²) Σ c_j U_(j−1)(s), s = x/a, j odd, has the transform Σ y_j J_j(ζa)/ζ. The tests T_k/√(1 − s²) turn
//! sin ζx into J_k(ζa). So all integrals need J_j(ζa) for odd j, and Newton's method its derivative with respect to
//! ln a, z J_j' = z (J_(j−1) − J_(j+1))/2.
use num_complex::Complex64;

use crate::numeric::bessel;

use super::layout::{Layout, Own};

/// One column of values per mode, j = 1, 3, 5, ...
pub(super) struct Table {
    rows: usize,
    value: Vec<f64>,
    slope: Vec<f64>,
}

impl Table {
    fn new(rows: usize, modes: usize) -> Self {
        Self { rows, value: vec![0.0; rows * modes], slope: vec![0.0; rows * modes] }
    }

    pub(super) fn rows(&self) -> usize {
        self.rows
    }

    /// All basis functions, column by column.
    pub(super) fn columns(&self) -> &[f64] {
        &self.value
    }

    /// The basis function of mode `m` (order 2m + 1) at every node.
    pub(super) fn value(&self, m: usize) -> &[f64] {
        &self.value[m * self.rows..(m + 1) * self.rows]
    }

    /// Its derivative with respect to ln a.
    pub(super) fn slope(&self, m: usize) -> &[f64] {
        &self.slope[m * self.rows..(m + 1) * self.rows]
    }
}

/// The modes of one contact.
pub(super) struct Basis {
    /// Half-length in units of L.
    pub(super) half_length: f64,
    /// J_j(ζa) at the real wavenumbers.
    pub(super) real: Table,
    /// 2 J_1(z)/z − 1: the unit pressure's transform less its resultant.
    pub(super) deficit: Vec<f64>,
    /// Its derivative with respect to ln a, −2 J_2(z).
    pub(super) deficit_slope: Vec<f64>,
    /// The two halves of the split products in the tail, row by row, to be used with `tail_weights`.
    pub(super) tail: Table,
    /// Weights of the rows of `tail`.
    pub(super) tail_weights: Vec<f64>,
}

impl Basis {
    pub(super) fn new(layout: &Layout, own: &Own, half_length: f64, modes: usize) -> Self {
        let arguments: Vec<f64> = layout.zeta[..own.reach].iter().map(|zeta| zeta * half_length).collect();
        let rows = arguments.len();
        let orders = 2 * modes + 1;
        let mut j = vec![0.0; orders.max(3) * rows];
        bessel::table(orders.max(3), &arguments, &mut j);
        let mut real = Table::new(rows, modes);
        for m in 0..modes {
            let order = |n: usize| &j[n * rows..(n + 1) * rows];
            real.value[m * rows..(m + 1) * rows].copy_from_slice(order(2 * m + 1));
            let (below, above) = (order(2 * m), order(2 * m + 2));
            for (i, slope) in real.slope[m * rows..(m + 1) * rows].iter_mut().enumerate() {
                *slope = 0.5 * arguments[i] * (below[i] - above[i]);
            }
        }
        let deficit = arguments.iter().zip(&j[rows..]).map(|(z, j1)| bessel::jinc_deficit_from(*z, *j1)).collect();
        let deficit_slope = j[2 * rows..3 * rows].iter().map(|j2| -2.0 * j2).collect();
        let (tail, tail_weights) = Self::tail(own, half_length, modes);
        Self { half_length, real, deficit, deficit_slope, tail, tail_weights }
    }

    fn tail(own: &Own, half_length: f64, modes: usize) -> (Table, Vec<f64>) {
        let tail = &own.tail;
        let (smooth, turned) = (tail.smooth.len(), tail.turned.len());
        let mut table = Table::new(2 * (smooth + turned), modes);
        if table.rows == 0 {
            return (table, Vec::new());
        }
        let mut weights = Vec::with_capacity(table.rows);
        weights.extend(&tail.smooth_weights);
        weights.extend(&tail.smooth_weights);
        weights.extend(std::iter::repeat_n(1.0, turned));
        weights.extend(std::iter::repeat_n(-1.0, turned));

        let orders = 2 * modes + 1;
        let arguments: Vec<f64> = tail.smooth.iter().map(|zeta| zeta * half_length).collect();
        let (mut j, mut y) = (vec![0.0; orders * smooth], vec![0.0; orders * smooth]);
        bessel::jy_table(orders, &arguments, &mut j, &mut y);
        let paths: Vec<Complex64> = tail.turned.iter().map(|zeta| zeta * half_length).collect();
        let mut h = vec![Complex64::ZERO; orders * turned];
        bessel::hankel_table(orders, &paths, &mut h);
        let factors: Vec<Complex64> =
            (0..turned).map(|i| (Complex64::I * paths[i] + tail.lift[i]).exp() * tail.turned_roots[i]).collect();
        for m in 0..modes {
            let start = m * table.rows;
            let (value, slope) = (&mut table.value[start..], &mut table.slope[start..]);
            for (half, part) in [&j, &y].into_iter().enumerate() {
                for i in 0..smooth {
                    let at = |n: usize| part[n * smooth + i];
                    value[half * smooth + i] = at(2 * m + 1);
                    slope[half * smooth + i] = 0.5 * arguments[i] * (at(2 * m) - at(2 * m + 2));
                }
            }
            for i in 0..turned {
                let at = |n: usize| h[n * turned + i] * factors[i];
                let (v, s) = (at(2 * m + 1), 0.5 * paths[i] * (at(2 * m) - at(2 * m + 2)));
                let row = 2 * smooth + i;
                (value[row], value[row + turned]) = (v.re, v.im);
                (slope[row], slope[row + turned]) = (s.re, s.im);
            }
        }
        (table, weights)
    }
}
