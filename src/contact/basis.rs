//! The transformed pressure modes of one contact at all nodes.
//!
//! p(x) = √(1 − s²) Σ c_j U_(j−1)(s), s = x/a, j odd, has the transform (2P/ζ) Σ y_j ψ_j(ζ) with ψ_j = J_j(ζa)/a and
//! y_1 = 1. The tests T_k/√(1 − s²) turn sin ζx into J_k(ζa). So all integrals need ψ_j for odd j, and Newton's method
//! the derivative with respect to ln a, z (J_(j−1) − J_(j+1))/(2a) − ψ_j, z = ζa: the even orders of the same table.
use faer::MatRef;
use num_complex::Complex64;

use crate::numeric::bessel::{self, Wanted};
use crate::numeric::buffer::Buffer;

use super::given::Given;
use super::layout::Layout;

/// Nodes of a tail whose Bessel functions are made together.
const TOGETHER: usize = 512;

/// The modes of one contact: a row for each real wavenumber, then two for each node of the tail.
pub(super) struct Basis {
    /// Half-length in units of L.
    pub(super) half_length: f64,
    /// 2 J_1(z)/z − 1 at the real wavenumbers: the unit pressure's transform less its resultant.
    pub(super) deficit: Buffer,
    /// Real wavenumbers.
    reach: usize,
    rows: usize,
    /// Orders below this are those of the modes and of their derivatives.
    orders: usize,
    /// J_n/a for n = 0, 1, ..., 2·modes, column by column; only odd n where memory is short.
    table: Buffer,
    /// Whether even n are left out.
    odd: bool,
    /// z at the real wavenumbers and at the smooth nodes of the tail, twice.
    arguments: Buffer,
    /// z on the turned path.
    paths: Vec<Complex64>,
    /// What exp(−iz) H_n is multiplied by there.
    factors: Vec<Complex64>,
}

impl Basis {
    /// The modes of contact `i` at one half-length.
    pub(super) fn new(layout: &Layout, i: usize, half_length: f64, modes: usize) -> Self {
        let (tail, reach) = (layout.tail(i), layout.own[i].reach);
        let mut arguments: Buffer = layout.zeta[..reach].iter().map(|zeta| zeta * half_length).collect();
        for _ in 0..2 {
            arguments.extend(tail.smooth.iter().map(|zeta| zeta * half_length));
        }
        let paths: Vec<Complex64> = tail.turned.iter().map(|zeta| zeta * half_length).collect();
        let factors = paths.iter().zip(&tail.lift);
        let factors = factors.map(|(z, lift)| (Complex64::I * z + lift).exp() * half_length.recip()).collect();
        let (rows, orders, odd) = (reach + tail.rows(), 2 * modes + 1, layout.is_large());
        let (deficit, table) = (Buffer::default(), Buffer::default());
        let mut basis = Self { half_length, deficit, reach, rows, orders, table, odd, arguments, paths, factors };
        basis.table = basis.tabulate(if odd { Wanted::ODD } else { Wanted::ALL });
        basis.deficit = (basis.arguments[..reach].iter().zip(basis.value(0)))
            .map(|(z, j1)| bessel::jinc_deficit_from(*z, *j1 * half_length))
            .collect();
        basis
    }

    /// J_n/a of some orders, column by column.
    fn tabulate(&self, wanted: Wanted) -> Buffer {
        let (rows, reach) = (self.rows, self.reach);
        let entries = wanted.below(self.orders) * rows;
        let mut table = if self.odd { Buffer::exactly(entries) } else { Buffer::any(entries) };
        let scale = self.half_length.recip();
        bessel::scaled_orders(self.orders, wanted, &self.arguments[..reach], scale, rows, &mut table);
        if rows > reach {
            self.tabulate_tail(wanted, &mut table);
        }
        table
    }

    /// J/a, Y/a and both parts of H/a in the rows of the tail.
    fn tabulate_tail(&self, wanted: Wanted, table: &mut [f64]) {
        let (first, orders, scale) = (self.reach, self.orders, self.half_length.recip());
        let (count, turned) = ((self.arguments.len() - first) / 2, self.paths.len());
        let smooth = &self.arguments[first..first + count];
        let all: Vec<usize> = (0..orders).collect();
        for (start, some) in (0..).step_by(TOGETHER).zip(smooth.chunks(TOGETHER)) {
            let length = some.len();
            let (mut j, mut y) = (Buffer::any(orders * length), Buffer::any(orders * length));
            bessel::jy_table(orders, some, &mut j, &mut y);
            for (&n, column) in wanted.of(&all).zip(table.chunks_exact_mut(self.rows)) {
                for (place, values) in [(first + start, &j), (first + count + start, &y)] {
                    let values = &values[n * length..(n + 1) * length];
                    column[place..place + length].iter_mut().zip(values).for_each(|(out, value)| *out = value * scale);
                }
            }
        }
        let mut h = vec![Complex64::ZERO; orders * turned];
        bessel::hankel_table(orders, &self.paths, &mut h);
        for (&n, column) in wanted.of(&all).zip(table.chunks_exact_mut(self.rows)) {
            let (re, im) = column[first + 2 * count..].split_at_mut(turned);
            for (i, (h, factor)) in h[n * turned..(n + 1) * turned].iter().zip(&self.factors).enumerate() {
                let value = h * factor;
                (re[i], im[i]) = (value.re, value.im);
            }
        }
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
        let (half_length, paths, factors) = (given.half_length, Vec::new(), Vec::new());
        Self { half_length, deficit, reach: rows, rows, orders: 3, table, odd: false, arguments, paths, factors }
    }

    /// −z J_2(z)/(2a) in every row: of p = (P/πa) [1/√(1 − s²) − 2 √(1 − s²)], the pressure next to sharp corners less a unit
    /// pressure of the same resultant.
    pub(super) fn corners(&self) -> Buffer {
        let mut corners = Buffer::of(self.even_orders().column(1));
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
        let (first, stride) = if self.odd { (0, 1) } else { (1, 2) };
        MatRef::from_column_major_slice_with_stride(
            &self.table[first * self.rows..],
            self.rows,
            count,
            stride * self.rows,
        )
    }

    /// ψ of mode `m` (order 2m + 1) in every row.
    pub(super) fn value(&self, m: usize) -> &[f64] {
        let column = if self.odd { m } else { 2 * m + 1 };
        &self.table[column * self.rows..(column + 1) * self.rows]
    }

    /// Even orders: part of the table, or made for as long as they are used.
    pub(super) fn even_orders(&self) -> EvenOrders<'_> {
        EvenOrders { basis: self, made: self.odd.then(|| self.tabulate(Wanted::EVEN)) }
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

    /// Σ over the rows of `s` ψ_m, for the first `count` modes.
    pub(super) fn test(&self, s: &[f64], count: usize) -> Buffer {
        times(self.values(count).transpose(), s)
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

/// J_n/a of even orders n, from which derivatives with respect to ln a are made.
pub(super) struct EvenOrders<'a> {
    basis: &'a Basis,
    /// Column by column, if they are not part of the table.
    made: Option<Buffer>,
}

impl EvenOrders<'_> {
    /// The first `count` orders n = 0, 2, ..., rows by orders.
    fn first(&self, count: usize) -> MatRef<'_, f64> {
        let rows = self.basis.rows;
        match &self.made {
            Some(made) => MatRef::from_column_major_slice(&made[..count * rows], rows, count),
            None => MatRef::from_column_major_slice_with_stride(&self.basis.table, rows, count, 2 * rows),
        }
    }

    /// Order 2m in every row.
    fn column(&self, m: usize) -> &[f64] {
        let rows = self.basis.rows;
        match &self.made {
            Some(made) => &made[m * rows..(m + 1) * rows],
            None => &self.basis.table[2 * m * rows..(2 * m + 1) * rows],
        }
    }

    /// The derivative of [`Basis::combine`] with respect to ln a.
    pub(super) fn combine_slopes(&self, y: &[f64], combined: &[f64]) -> Buffer {
        // Σ y_m (E_m − E_(m+1)), E the even orders
        let mut differences = Buffer::zeros(y.len() + 1);
        for (m, y) in y.iter().enumerate() {
            differences[m] += y;
            differences[m + 1] -= y;
        }
        let mut slopes = times(self.first(differences.len()), &differences);
        self.basis.scale(&mut slopes, false);
        slopes.iter_mut().zip(combined).for_each(|(slope, value)| *slope -= value);
        slopes
    }

    /// Σ over the rows of `s` times the derivative of ψ_m with respect to ln a, where `tested` is [`Basis::test`].
    pub(super) fn test_slopes(&self, s: &[f64], tested: &[f64]) -> Buffer {
        let mut scaled = Buffer::of(s);
        self.basis.scale(&mut scaled, true);
        let even = times(self.first(tested.len() + 1).transpose(), &scaled);
        even.windows(2).zip(tested).map(|(even, value)| even[0] - even[1] - value).collect()
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
