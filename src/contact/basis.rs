//! The transformed pressure modes of one contact at all nodes.
//!
//! p(x) = √(1 − s²) Σ c_j U_(j−1)(s), s = x/a, j odd, has the transform (2P/ζ) Σ y_j ψ_j(ζ) with ψ_j = J_j(ζa)/a and
//! y_1 = 1. The tests T_k/√(1 − s²) turn sin ζx into J_k(ζa). So all integrals need ψ_j for odd j, and Newton's method
//! the derivative with respect to ln a, z (J_(j−1) − J_(j+1))/(2a) − ψ_j, z = ζa: the even orders of the same table.
use faer::MatRef;
use num_complex::Complex64;

use crate::numeric::bessel;
use crate::numeric::buffer::Buffer;

use super::given::Given;
use super::layout::Layout;
use super::tail::Tail;

/// The modes of one contact: a row for each real wavenumber, then two for each node of the tail.
pub(super) struct Basis {
    /// Half-length in units of L.
    pub(super) half_length: f64,
    /// 2 J_1(z)/z − 1 at the real wavenumbers: the unit pressure's transform less its resultant.
    pub(super) deficit: Buffer,
    rows: usize,
    /// J_n/a for n = 0, 1, ..., 2·modes, column by column.
    table: Buffer,
    /// z at the real wavenumbers and at the smooth nodes of the tail, twice.
    arguments: Buffer,
    /// z on the turned path.
    paths: Vec<Complex64>,
}

impl Basis {
    /// The modes of contact `i` at one half-length.
    pub(super) fn new(layout: &Layout, i: usize, half_length: f64, modes: usize) -> Self {
        let (tail, reach) = (layout.tail(i), layout.own[i].reach);
        let rows = reach + tail.rows();
        let mut arguments: Buffer = layout.zeta[..reach].iter().map(|zeta| zeta * half_length).collect();
        let orders = 2 * modes + 1;
        let mut table = Buffer::any(orders * rows);
        bessel::scaled_table(orders, &arguments, half_length.recip(), rows, &mut table);
        let j1 = &table[rows..rows + reach];
        let deficit =
            arguments.iter().zip(j1).map(|(z, j1)| bessel::jinc_deficit_from(*z, *j1 * half_length)).collect();
        let paths: Vec<Complex64> = tail.turned.iter().map(|zeta| zeta * half_length).collect();
        if rows > reach {
            let smooth: Vec<f64> = tail.smooth.iter().map(|zeta| zeta * half_length).collect();
            fill_tail(tail, half_length, &smooth, &paths, reach, rows, &mut table);
            arguments.extend(smooth.iter().copied());
            arguments.extend(smooth.iter().copied());
        }
        Self { half_length, deficit, rows, table, arguments, paths }
    }

    /// The only mode of a given pressure on top, whatever its transform. Its half-length is not varied, so that the even
    /// orders do not matter.
    pub(super) fn given(layout: &Layout, given: &Given) -> Self {
        let zeta = &layout.zeta[..layout.own[0].reach];
        let deficit: Buffer = zeta.iter().map(|zeta| given.deficit(*zeta)).collect();
        let rows = zeta.len();
        let mut table = Buffer::zeros(3 * rows);
        for ((value, zeta), deficit) in table[rows..].iter_mut().zip(zeta).zip(deficit.iter()) {
            *value = 0.5 * zeta * (1.0 + deficit);
        }
        let arguments = zeta.iter().map(|zeta| zeta * given.half_length).collect();
        Self { half_length: given.half_length, deficit, rows, table, arguments, paths: Vec::new() }
    }

    /// −z J_2(z)/(2a) in every row: of p = (P/πa) [1/√(1 − s²) − 2 √(1 − s²)], the pressure next to sharp corners less a unit
    /// pressure of the same resultant.
    pub(super) fn corners(&self) -> Buffer {
        let mut corners = Buffer::of(&self.table[2 * self.rows..3 * self.rows]);
        self.scale(&mut corners, false);
        corners.iter_mut().for_each(|value| *value = -*value);
        corners
    }

    /// Number of rows.
    pub(super) fn rows(&self) -> usize {
        self.rows
    }

    /// ψ of the first `count` modes, rows by modes.
    pub(super) fn values(&self, count: usize) -> MatRef<'_, f64> {
        MatRef::from_column_major_slice_with_stride(&self.table[self.rows..], self.rows, count, 2 * self.rows)
    }

    /// ψ of mode `m` (order 2m + 1) in every row.
    pub(super) fn value(&self, m: usize) -> &[f64] {
        &self.table[(2 * m + 1) * self.rows..(2 * m + 2) * self.rows]
    }

    /// J_n/a of the first `count` even orders n = 0, 2, ..., rows by orders.
    fn even(&self, count: usize) -> MatRef<'_, f64> {
        MatRef::from_column_major_slice_with_stride(&self.table, self.rows, count, 2 * self.rows)
    }

    /// Σ_m y_m ψ_m in every row.
    pub(super) fn combine(&self, y: &[f64]) -> Buffer {
        times(self.values(y.len()), y)
    }

    /// Σ_m y_m ψ_m for the modes from number `first` on, in every row.
    pub(super) fn combine_from(&self, first: usize, y: &[f64]) -> Buffer {
        if y.is_empty() {
            return Buffer::zeros(self.rows);
        }
        times(self.values(first + y.len()).subcols(first, y.len()), y)
    }

    /// The derivative of [`Self::combine`] with respect to ln a.
    pub(super) fn combine_slopes(&self, y: &[f64], combined: &[f64]) -> Buffer {
        // Σ y_m (E_m − E_(m+1)), E the even orders
        let mut differences = Buffer::zeros(y.len() + 1);
        for (m, y) in y.iter().enumerate() {
            differences[m] += y;
            differences[m + 1] -= y;
        }
        let mut slopes = times(self.even(differences.len()), &differences);
        self.scale(&mut slopes, false);
        slopes.iter_mut().zip(combined).for_each(|(slope, value)| *slope -= value);
        slopes
    }

    /// Σ over the rows of `s` ψ_m, for the first `count` modes.
    pub(super) fn test(&self, s: &[f64], count: usize) -> Buffer {
        times(self.values(count).transpose(), s)
    }

    /// Σ over the rows of `s` times the derivative of ψ_m with respect to ln a, where `tested` is [`Self::test`].
    pub(super) fn test_slopes(&self, s: &[f64], tested: &[f64]) -> Buffer {
        let mut scaled = Buffer::of(s);
        self.scale(&mut scaled, true);
        let even = times(self.even(tested.len() + 1).transpose(), &scaled);
        even.windows(2).zip(tested).map(|(even, value)| even[0] - even[1] - value).collect()
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

/// J/a, Y/a and both parts of H/a in the rows of the tail.
fn fill_tail(
    tail: &Tail,
    half_length: f64,
    smooth: &[f64],
    paths: &[Complex64],
    first: usize,
    rows: usize,
    table: &mut [f64],
) {
    let orders = table.len() / rows;
    let scale = half_length.recip();
    let (mut j, mut y) = (Buffer::any(orders * smooth.len()), Buffer::any(orders * smooth.len()));
    bessel::jy_table(orders, smooth, &mut j, &mut y);
    let mut h = vec![Complex64::ZERO; orders * paths.len()];
    bessel::hankel_table(orders, paths, &mut h);
    let factors = paths.iter().zip(&tail.lift);
    let factors: Vec<Complex64> = factors.map(|(z, lift)| (Complex64::I * z + lift).exp() * scale).collect();
    for (n, column) in table.chunks_exact_mut(rows).enumerate() {
        let (count, turned) = (smooth.len(), paths.len());
        let (js, rest) = column[first..].split_at_mut(count);
        let (ys, rest) = rest.split_at_mut(count);
        let (re, im) = rest.split_at_mut(turned);
        let parts = js.iter_mut().zip(&j[n * count..]).chain(ys.iter_mut().zip(&y[n * count..]));
        parts.for_each(|(out, value)| *out = value * scale);
        for (i, (h, factor)) in h[n * turned..(n + 1) * turned].iter().zip(&factors).enumerate() {
            let value = h * factor;
            (re[i], im[i]) = (value.re, value.im);
        }
    }
}

/// matrix · vector.
pub(super) fn times(matrix: MatRef<'_, f64>, vector: &[f64]) -> Buffer {
    let mut product = Buffer::any(matrix.nrows());
    let out = faer::MatMut::from_column_major_slice_mut(&mut product, matrix.nrows(), 1);
    let vector = MatRef::from_column_major_slice(vector, vector.len(), 1);
    faer::linalg::matmul::matmul(out, faer::Accum::Replace, matrix, vector, 1.0, faer::Par::Seq);
    product
}
