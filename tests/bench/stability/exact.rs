//! The flexibility in multiple precision, straight from the state equations.
use std::f64::consts::LN_2;

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;

use super::Case;

type Real = FBig<HalfEven, 2>;
type Matrix = [[Real; 4]; 4];

/// Bits of every number: long waves take 110 of them, short ones 2 λH/ln 2.
const BITS: usize = 1200;
/// Terms of the exponential series of a matrix of norm below 1/2.
const TERMS: usize = 160;
/// Beyond this λh the strip responds like a half-plane of its material.
const THICK: f64 = 60.0;

/// λμ₁C_tt of a free strip bonded to a graded layer of the same thickness, κ = 2.
pub fn flexibility(case: &Case, lambda: f64) -> f64 {
    let Case { thickness, beta, kappa } = *case;
    if lambda * thickness > THICK {
        return 0.25 * (1.0 + kappa);
    }
    let (lambda, beta, h, kappa) = (real(lambda), real(beta), real(thickness), real(kappa));
    let strip = exponential(state_matrix(&lambda, &real(0.0), &kappa), &h);
    let graded = exponential(state_matrix(&lambda, &beta, &kappa), &h);
    // stresses are those over the shear modulus at the same depth: no shear, no pressure on the lower face
    let all = product(&strip, &graded);
    let [[_, _], [vu, vv]] = part(&all, 0);
    let [[su, sv], [tu, tv]] = part(&all, 2);
    let determinant = &su * &tv - &sv * &tu;
    // S = 1, T = 0 on the upper face
    let (u, v) = (&tv / &determinant, -(&tu / &determinant));
    (lambda * (vu * u + vv * v)).to_f64().value()
}

fn real(x: f64) -> Real {
    Real::try_from(x).expect("finite").with_precision(BITS).value()
}

/// d(U, V, S/μ, T/μ)/dy = M (U, V, S/μ, T/μ) with μ = exp(−βy).
fn state_matrix(lambda: &Real, beta: &Real, kappa: &Real) -> Matrix {
    let (zero, one) = (real(0.0), real(1.0));
    let sum = kappa + &one;
    let coupling = (real(3.0) - kappa) / &sum * lambda;
    let normal = (kappa - &one) / &sum;
    let axial = real(8.0) * lambda * lambda / &sum;
    [
        [zero.clone(), lambda.clone(), zero.clone(), one],
        [-&coupling, zero.clone(), normal, zero.clone()],
        [zero.clone(), zero.clone(), beta.clone(), -lambda.clone()],
        [axial, zero, coupling, beta.clone()],
    ]
}

/// exp(M h): series for a small part of h, then squared.
fn exponential(matrix: Matrix, h: &Real) -> Matrix {
    let norm = matrix.iter().flatten().map(|m| (m * h).to_f64().value().abs()).fold(0.0, f64::max);
    let squarings = ((4.0 * norm).max(1.0).ln() / LN_2).ceil() as u32 + 1;
    let step = h / real(f64::from(squarings).exp2());
    let small = matrix.map(|row| row.map(|m| m * &step));
    let mut sum = identity();
    for term in (1..=TERMS).rev() {
        // 1 + M/1 (1 + M/2 (1 + ...))
        let scaled = small.clone().map(|row| row.map(|m| m / real(term as f64)));
        sum = product(&scaled, &sum);
        for (i, row) in sum.iter_mut().enumerate() {
            row[i] += real(1.0);
        }
    }
    for _ in 0..squarings {
        sum = product(&sum, &sum);
    }
    sum
}

fn identity() -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| real(if i == j { 1.0 } else { 0.0 })))
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..4).fold(real(0.0), |sum, k| sum + &a[i][k] * &b[k][j])))
}

/// Two rows of the columns that belong to the displacements.
fn part(matrix: &Matrix, row: usize) -> [[Real; 2]; 2] {
    std::array::from_fn(|i| std::array::from_fn(|j| matrix[row + i][j].clone()))
}
