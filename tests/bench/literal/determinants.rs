//! The paper's kernels: its eight boundary conditions, filled in with numbers and solved at one wavenumber.
use nalgebra::{Complex, DMatrix, DVector};

use super::Transforms;

type C = Complex<f64>;

const I: C = C::new(0.0, 1.0);

/// Strip (thickness `h1`) bonded to an exponentially graded layer (`h2`), on a half-plane; either layer may be missing. The
/// shear modulus is 1 at the top of the graded layer and in the strip, `mu3` in the half-plane.
#[derive(Clone, Copy)]
pub struct Paper {
    pub h1: f64,
    pub h2: f64,
    pub beta: f64,
    pub kappa: f64,
    pub mu3: f64,
}

/// λ times the displacements of the two faces under the pressures p and q on them, positive towards the body's inside.
pub struct Response {
    pub top_by_p: f64,
    pub top_by_q: f64,
    pub bottom_by_p: f64,
    pub bottom_by_q: f64,
}

impl Paper {
    /// k_1 ... k_4 before the inverse transform: eqs. (2.20), (2.21), multiplied out so that stresses are in units of the
    /// strip's modulus and both rows are compliances.
    pub fn response(&self, lambda: f64) -> Response {
        let Self { h1, h2, kappa, beta, .. } = *self;
        let roots = self.roots(lambda);
        let (strip, graded) = (strip(lambda, h1, kappa), graded(lambda, h2, kappa, &roots));
        let (has_strip, has_graded) = (h1 > 0.0, h2 > 0.0);
        // the matrix D of the appendix; a layer that is missing takes its columns and four rows with it
        let mut rows: Vec<Vec<C>> = Vec::new();
        let empty = [C::new(0.0, 0.0); 4];
        let mut row = |a: [C; 4], b: [C; 4]| {
            let mut row = Vec::new();
            if has_strip {
                row.extend(a);
            }
            if has_graded {
                row.extend(b);
            }
            rows.push(row);
        };
        match (has_strip, has_graded) {
            (true, true) => {
                row(strip[0], empty);
                row(strip[1], empty);
                for k in 0..4 {
                    row(strip[2 + k], graded[k]);
                }
                row(empty, graded[4]);
                row(empty, graded[5]);
            }
            (true, false) => (0..4).for_each(|k| row(strip[k], empty)),
            _ => [0, 1, 4, 5].into_iter().for_each(|k| row(empty, graded[k])),
        }
        let size = rows.len();
        let matrix = DMatrix::from_fn(size, size, |r, c| rows[r][c]);
        let factors = matrix.lu();
        let zero = C::new(0.0, 0.0);
        // D_1k/D and D_7k/D, signs included
        let amplitudes = |loaded: usize, load: f64| -> DVector<C> {
            let right = DVector::from_fn(size, |r, _| if r == loaded { C::new(-load, 0.0) } else { zero });
            factors.solve(&right).unwrap_or_else(|| DVector::from_element(size, C::new(f64::NAN, 0.0)))
        };
        // which units the loaded rows are in: σ/μ₁ in the strip, (κ − 1) σ/μ in the graded layer, and −(κ − 1) σ/μ₁ at the
        // strip's lower face
        let top_load = if has_strip { 1.0 } else { kappa - 1.0 };
        let bottom_load = if has_graded { (kappa - 1.0) * (-beta * h2).exp() } else { 1.0 - kappa };
        let by_p = amplitudes(0, top_load);
        let by_q = amplitudes(size - 2, bottom_load);
        let strip_v = |c: &DVector<C>, y: f64| {
            I * ((lambda * c[0] + (lambda * y - kappa) * c[1]) * (lambda * y).exp()
                - (lambda * c[2] + (lambda * y + kappa) * c[3]) * (-lambda * y).exp())
        };
        let graded_v = |c: &DVector<C>, y: f64| {
            let first = size - 4;
            (0..4).map(|k| lambda * c[first + k] * roots[k].1 * (roots[k].0 * y).exp()).sum::<C>()
        };
        let top = |c: &DVector<C>| if has_strip { strip_v(c, h1) } else { graded_v(c, 0.0) };
        let bottom = |c: &DVector<C>| if has_graded { graded_v(c, -h2) } else { strip_v(c, 0.0) };
        Response {
            top_by_p: -top(&by_p).re,
            top_by_q: -top(&by_q).re,
            bottom_by_p: bottom(&by_p).re,
            bottom_by_q: bottom(&by_q).re,
        }
    }

    /// m_k and s_k, eqs. (2.7) and (2.8).
    fn roots(&self, lambda: f64) -> [(C, C); 4] {
        let Self { beta, kappa, .. } = *self;
        let discriminant =
            C::new(beta * beta + 4.0 * lambda * lambda, -4.0 * beta * lambda * ((3.0 - kappa) / (1.0 + kappa)).sqrt());
        let (m1, m2) = (0.5 * (beta + discriminant.sqrt()), 0.5 * (beta - discriminant.sqrt()));
        [m1, m2, m1.conj(), m2.conj()].map(|m| {
            let above = (kappa - 1.0) * m * m - beta * (kappa - 1.0) * m - lambda * lambda * (kappa + 1.0);
            (m, above / (I * lambda * (2.0 * m - beta * (kappa - 1.0))))
        })
    }
}

impl Transforms for Paper {
    fn at(&self, lambda: f64) -> (Vec<f64>, Vec<[f64; 2]>) {
        let response = self.response(lambda);
        let half_plane = (1.0 + self.kappa) / (4.0 * self.mu3);
        (vec![response.top_by_p, response.bottom_by_q + half_plane], vec![[response.top_by_q, response.bottom_by_p]])
    }

    fn limits(&self) -> Vec<f64> {
        let a0 = (1.0 + self.kappa) / 4.0;
        vec![a0, a0 * ((-self.beta * self.h2).exp() + self.mu3.recip())]
    }
}

/// D', the strip's columns.
fn strip(lambda: f64, h1: f64, kappa: f64) -> [[C; 4]; 6] {
    let (l, k) = (lambda, kappa);
    let (up, down) = ((l * h1).exp(), (-l * h1).exp());
    let real = |re: f64| C::new(re, 0.0);
    [
        [2.0 * l * up * I, -(1.0 + k - 2.0 * l * h1) * up * I, 2.0 * l * down * I, (1.0 + k + 2.0 * l * h1) * down * I],
        [2.0 * l * up, (1.0 - k + 2.0 * l * h1) * up, -2.0 * l * down, (1.0 - k - 2.0 * l * h1) * down].map(real),
        [-2.0 * l * (k - 1.0) * I, (k * k - 1.0) * I, -2.0 * l * (k - 1.0) * I, (1.0 - k * k) * I],
        [-2.0 * l, k - 1.0, 2.0 * l, k - 1.0].map(real),
        [-1.0, 0.0, -1.0, 0.0].map(real),
        [-I, k / l * I, I, k / l * I],
    ]
}

/// D'', the graded layer's.
fn graded(lambda: f64, h2: f64, kappa: f64, roots: &[(C, C); 4]) -> [[C; 4]; 6] {
    let normal = roots.map(|(m, s)| -lambda * (3.0 - kappa) * I + (1.0 + kappa) * m * s);
    let shear = roots.map(|(m, s)| m - lambda * s * I);
    let at_bottom = |row: [C; 4]| std::array::from_fn(|k| row[k] * (-roots[k].0 * h2).exp());
    [normal, shear, [C::new(1.0, 0.0); 4], roots.map(|(_, s)| s), at_bottom(normal), at_bottom(shear)]
}
