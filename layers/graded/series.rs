//! The transfer matrix through a slice, as a power series in ζ = λδ: computed once, evaluated for every wavenumber.
use nalgebra::{Matrix4, SMatrix, SVector};

use super::points::Points;
use super::rule::{NODES, RULE};

/// Longest slice, in units of the material's shortest decay length.
pub(super) const LENGTH: f64 = 2.0;
/// Terms of each entry: up to ζ s = 2, with s the fastest rate, the next one, 2^29/29!, is below rounding, and so is
/// what a double root makes of it.
const TERMS: usize = 14;

/// X − 1 for the transfer matrix X from the bottom to the top of a slice. Since U and S depend on V and T only, and
/// these on those, entries between the two pairs are odd in ζ and all others even.
#[derive(Debug)]
pub(super) struct Series {
    /// Of ζ, ζ³, ... between the pairs and of ζ², ζ⁴, ... within them, in powers of `fastest` ζ.
    terms: [Matrix4<f64>; TERMS],
    fastest: f64,
}

type Values = SVector<f64, NODES>;

impl Series {
    /// Term by term by Picard iteration: X − 1 = ζ ∫ A X dt on Gauss points.
    pub fn new(points: &Points) -> Self {
        let unit = points.fastest.recip();
        let [shear, coupling, normal, axial] =
            [&points.shear, &points.coupling, &points.normal, &points.axial].map(|values| values * unit);
        let mut terms = [Matrix4::zeros(); TERMS];
        for column in 0..4 {
            let mut field: [Values; 4] = std::array::from_fn(|i| Values::repeat(if i == column { 1.0 } else { 0.0 }));
            let mut even = matches!(column, 0 | 2);
            for term in 0..2 * TERMS {
                let [u, v, s, t] = &field;
                // what depends on the one pair is of the other pair
                let (pair, rates) = if even {
                    (
                        [1, 3],
                        [
                            normal.component_mul(s) - coupling.component_mul(u),
                            axial.component_mul(u) + coupling.component_mul(s),
                        ],
                    )
                } else {
                    ([0, 2], [v * unit + shear.component_mul(t), -t * unit])
                };
                for (i, rate) in pair.into_iter().zip(rates) {
                    terms[term / 2][(i, column)] = (RULE.weights * rate)[0];
                    field[i] = RULE.integral * rate;
                }
                even = !even;
            }
        }
        Self { terms, fastest: points.fastest }
    }

    /// X − 1 at ζ. On a slice that is too long for the series it is no number.
    pub fn at(&self, zeta: f64) -> Matrix4<f64> {
        let z = self.fastest * zeta;
        if z > LENGTH {
            return Matrix4::repeat(f64::NAN);
        }
        let square = z * z;
        let mut sum = self.terms[TERMS - 1];
        for term in self.terms[..TERMS - 1].iter().rev() {
            sum = sum * square + term;
        }
        let powers = SMatrix::<f64, 4, 4>::from_fn(|i, j| if (i + j) % 2 == 0 { square } else { z });
        sum.component_mul(&powers)
    }
}
