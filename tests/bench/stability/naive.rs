//! The flexibility as one would write it down: amplitudes of exponentials measured from one depth, and either Cramer's
//! rule or one elimination.
//!
//! The system is that of a paper on the double contact of a strip and a graded layer, its appendix letter by letter:
//! eight conditions (S and T on the upper face; S, T, U, V where the layers are bonded; S and T on the lower face) for
//! the amplitudes C_1..C_4 of the strip and C_5..C_8 of the graded layer, with
//!
//! ```text
//! m = (β ± √(β² + 4λ² ∓ 4iβλ √((3 − κ)/(1 + κ))))/2        s = ((κ − 1) m (m − β) − λ² (κ + 1))/(iλ (2m − β(κ − 1)))
//! ```
use nalgebra::{Complex, DMatrix, DVector};

use super::Case;

type C = Complex<f64>;
const I: C = C::new(0.0, 1.0);

/// By determinants, D_1k/D.
pub fn by_determinants(case: &Case, lambda: f64) -> f64 {
    let system = system(case, lambda);
    let whole = system.determinant();
    let amplitudes: Vec<C> = (0..4)
        .map(|k| {
            let sign = if k % 2 == 0 { -1.0 } else { 1.0 };
            system.clone().remove_row(0).remove_column(k).determinant() / whole * sign
        })
        .collect();
    flexibility(case, lambda, &amplitudes)
}

/// By elimination with pivots, without any scaling.
pub fn by_elimination(case: &Case, lambda: f64) -> f64 {
    let mut load = DVector::zeros(8);
    load[0] = C::new(-1.0, 0.0);
    system(case, lambda)
        .lu()
        .solve(&load)
        .map_or(f64::NAN, |solution| flexibility(case, lambda, &solution.as_slice()[..4]))
}

/// λμ₁C_tt, which the paper calls −A.
fn flexibility(case: &Case, lambda: f64, c: &[C]) -> f64 {
    let Case { thickness: h, kappa, .. } = *case;
    let growing = (c[0] * lambda + c[1] * (lambda * h - kappa)) * (lambda * h).exp();
    let decaying = (c[2] * lambda + c[3] * (lambda * h + kappa)) * (-lambda * h).exp();
    -(I * (growing - decaying)).re
}

fn system(case: &Case, lambda: f64) -> DMatrix<C> {
    let Case { thickness: h, beta, kappa } = *case;
    let real = |x: f64| C::new(x, 0.0);
    let (up, down) = ((lambda * h).exp(), (-lambda * h).exp());
    let z = lambda * h;
    #[rustfmt::skip]
    let strip = [
        [I * 2.0 * lambda * up, -I * (1.0 + kappa - 2.0 * z) * up, I * 2.0 * lambda * down, I * (1.0 + kappa + 2.0 * z) * down],
        [real(2.0 * lambda * up), real((1.0 - kappa + 2.0 * z) * up), real(-2.0 * lambda * down), real((1.0 - kappa - 2.0 * z) * down)],
        [-I * 2.0 * lambda * (kappa - 1.0), I * (kappa * kappa - 1.0), -I * 2.0 * lambda * (kappa - 1.0), I * (1.0 - kappa * kappa)],
        [real(-2.0 * lambda), real(kappa - 1.0), real(2.0 * lambda), real(kappa - 1.0)],
        [real(-1.0), real(0.0), real(-1.0), real(0.0)],
        [-I, I * kappa / lambda, I, I * kappa / lambda],
    ];
    let root = (real(beta * beta + 4.0 * lambda * lambda)
        - I * 4.0 * beta * lambda * ((3.0 - kappa) / (1.0 + kappa)).sqrt())
    .sqrt();
    let (m1, m2) = ((root + beta) * 0.5, (-root + beta) * 0.5);
    let mut system = DMatrix::zeros(8, 8);
    for (i, row) in strip.iter().enumerate() {
        for (k, value) in row.iter().enumerate() {
            system[(i, k)] = *value;
        }
    }
    for (k, m) in [m1, m2, m1.conj(), m2.conj()].into_iter().enumerate() {
        let s = (m * (m - beta) * (kappa - 1.0) - lambda * lambda * (kappa + 1.0))
            / (I * lambda * (m * 2.0 - beta * (kappa - 1.0)));
        let normal = -I * lambda * (3.0 - kappa) + m * s * (1.0 + kappa);
        let shear = m - I * lambda * s;
        let lower = (-m * h).exp();
        for (i, value) in [normal, shear, real(1.0), s, normal * lower, shear * lower].into_iter().enumerate() {
            system[(i + 2, k + 4)] = value;
        }
    }
    system
}
