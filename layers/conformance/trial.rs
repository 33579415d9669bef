//! One law put to one layer: what is compared with what, and how closely.
use nalgebra::{Matrix2, Matrix4, Matrix4x2};

use super::{DIGITS, EQUAL_LOADS, ROUNDING, Violation};
use crate::{FaceStates, Flexibility, Layer, Plane, State, Wave, solve_equilibrated};

/// λh at which layers are examined (λ itself, for one without a thickness).
pub(super) const USUAL: [f64; 16] =
    [1e-8, 1e-6, 1e-4, 1e-3, 1e-2, 0.05, 0.2, 0.7, 0.99, 1.6, 2.5, 6.0, 17.0, 45.0, 300.0, 1e8];
/// λh at which nothing but finite numbers is expected.
pub(super) const EXTREME: [f64; 9] = [1e-150, 1e-100, 1e-50, 1e-20, 1e-12, 1e12, 1e50, 1e100, 1e150];

/// One law put to one layer.
pub(super) struct Trial<'a> {
    law: &'static str,
    pub layer: &'a dyn Layer,
    pub plane: Plane,
    pub thickness: Option<f64>,
    /// Some modulus of the layer, so that the laws do not depend on units.
    pub modulus: f64,
}

impl<'a> Trial<'a> {
    /// `None` if the layer has no thickness at all: then there is nothing to be examined.
    pub fn new(law: &'static str, layer: &'a dyn Layer, plane: Plane) -> Option<Self> {
        let thickness = layer.thickness();
        let modulus = layer.material(0.5 * thickness.unwrap_or(0.0), plane).shear_compliance.recip();
        (thickness != Some(0.0)).then_some(Self { law, layer, plane, thickness, modulus })
    }

    pub fn wave(&self, z: f64) -> Wave {
        Wave { wavenumber: z / self.thickness.unwrap_or(1.0), modulus: self.modulus, plane: self.plane }
    }

    pub fn violation(&self, quantity: &'static str, wave: &Wave, [found, expected, tolerance]: [f64; 3]) -> Violation {
        Violation {
            law: self.law,
            quantity,
            plane: self.plane,
            wavenumber: wave.wavenumber,
            found,
            expected,
            tolerance,
        }
    }

    pub fn exceeds(&self, quantity: &'static str, wave: &Wave, found: f64, least: f64) -> Result<(), Violation> {
        if found > least { Ok(()) } else { Err(self.violation(quantity, wave, [found, least, 0.0])) }
    }

    pub fn equal(
        &self,
        quantity: &'static str,
        wave: &Wave,
        found: f64,
        expected: f64,
        tolerance: f64,
    ) -> Result<(), Violation> {
        // not "difference > tolerance", which a NaN would pass
        let holds = (found - expected).abs() <= tolerance;
        if holds { Ok(()) } else { Err(self.violation(quantity, wave, [found, expected, tolerance])) }
    }

    pub fn solved<T>(&self, wave: &Wave, solution: Option<T>) -> Result<T, Violation> {
        solution.ok_or_else(|| self.violation("a response to loads on the faces", wave, [f64::NAN; 3]))
    }

    pub fn flexibility(&self, wave: &Wave) -> Result<Flexibility, Violation> {
        self.solved(wave, self.layer.flexibility(wave))
    }

    pub fn of(&self, wave: &Wave, states: &FaceStates) -> Result<Flexibility, Violation> {
        self.solved(wave, Flexibility::of_face_states(states))
    }

    /// (U, V) from (S, T) at the face of a half-plane.
    pub fn surface(&self, wave: &Wave, states: &FaceStates) -> Result<Matrix2<f64>, Violation> {
        let FaceStates::HalfPlane { top } = states else { return self.solved(wave, None) };
        self.solved(wave, flexibility_of_half_plane(top))
    }

    /// Every column of `states` does, by reciprocity, no net work with any column of `others`: since these are all
    /// fields that there are, it is one of them.
    pub fn members(
        &self,
        wave: &Wave,
        quantity: &'static str,
        states: &FaceStates,
        others: &FaceStates,
    ) -> Result<(), Violation> {
        match (states, others) {
            (
                FaceStates::Finite { top, bottom, .. },
                FaceStates::Finite { top: other_top, bottom: other_bottom, .. },
            ) => {
                // what thick layers hand from face to face, squared, is below rounding
                let thick = wave.wavenumber * self.thickness.unwrap_or(0.0) > 1.0;
                let unfelt = if thick { f64::EPSILON * ROUNDING } else { 0.0 };
                for (upper, lower) in top.column_iter().zip(bottom.column_iter()) {
                    for (other_upper, other_lower) in other_top.column_iter().zip(other_bottom.column_iter()) {
                        let (upper, lower) = (upper.into_owned(), lower.into_owned());
                        let (other_upper, other_lower) = (other_upper.into_owned(), other_lower.into_owned());
                        let size = size(&upper, &other_upper).max(size(&lower, &other_lower));
                        let both = size_over(&[upper, lower], &[other_upper, other_lower]);
                        let [at_top, at_bottom] = [work(&upper, &other_upper), work(&lower, &other_lower)];
                        self.equal(quantity, wave, at_top, at_bottom, DIGITS * size + unfelt * both)?;
                    }
                }
                Ok(())
            }
            (FaceStates::HalfPlane { top }, FaceStates::HalfPlane { top: other_top }) => {
                for one in top.column_iter() {
                    for other in other_top.column_iter() {
                        let (one, other) = (one.into_owned(), other.into_owned());
                        self.equal(quantity, wave, work(&one, &other), 0.0, DIGITS * size(&one, &other))?;
                    }
                }
                Ok(())
            }
            _ => Err(self.violation("number of faces", wave, [f64::NAN; 3])),
        }
    }

    pub fn same(&self, wave: &Wave, found: &Flexibility, expected: &Flexibility) -> Result<(), Violation> {
        let mean = (expected.top * expected.bottom).abs().sqrt();
        let tolerance = DIGITS * expected.coupling.abs() + ROUNDING * mean;
        self.equal("C_tb", wave, found.coupling, expected.coupling, tolerance)?;
        self.same_but_coupling(wave, found, expected)
    }

    pub fn same_but_coupling(&self, wave: &Wave, found: &Flexibility, expected: &Flexibility) -> Result<(), Violation> {
        self.equal("C_tt", wave, found.top, expected.top, DIGITS * expected.top.abs())?;
        self.equal("C_bb", wave, found.bottom, expected.bottom, DIGITS * expected.bottom.abs())?;
        self.same_equal(wave, found, expected)
    }

    /// Responses to equal loads.
    pub fn same_equal(&self, wave: &Wave, found: &Flexibility, expected: &Flexibility) -> Result<(), Violation> {
        let z = wave.wavenumber * self.thickness.unwrap_or(0.0);
        let lost = ROUNDING * (1.0f64).min(z * z) * expected.top.abs().max(expected.bottom.abs());
        let tolerance = EQUAL_LOADS * expected.equal_top.abs().max(expected.equal_bottom.abs()) + lost;
        for (quantity, x, y) in [
            ("C_tt + C_tb", found.equal_top, expected.equal_top),
            ("C_bt + C_bb", found.equal_bottom, expected.equal_bottom),
        ] {
            self.equal(quantity, wave, x, y, tolerance)?;
        }
        Ok(())
    }

    pub fn same_surface(&self, wave: &Wave, found: &Matrix2<f64>, expected: &Matrix2<f64>) -> Result<(), Violation> {
        let tolerance = DIGITS * expected.amax();
        for (quantity, i, j) in [("U under S", 0, 0), ("U under T", 0, 1), ("V under S", 1, 0), ("V under T", 1, 1)] {
            self.equal(quantity, wave, found[(i, j)], expected[(i, j)], tolerance)?;
        }
        Ok(())
    }
}

/// U₁T₂ − T₁U₂ + V₁S₂ − S₁V₂.
pub(crate) fn work(one: &State, two: &State) -> f64 {
    one[0] * two[3] - one[3] * two[0] + one[1] * two[2] - one[2] * two[1]
}

/// The size of [`work`] if none of its terms happened to vanish.
fn size(one: &State, two: &State) -> f64 {
    size_over(&[*one], &[*two])
}

/// The same, whichever of some states is the largest.
pub(crate) fn size_over(ones: &[State], twos: &[State]) -> f64 {
    let largest = |states: &[State], parts: [usize; 2]| {
        states.iter().flat_map(|state| parts.map(|i| state[i].abs())).fold(0.0, f64::max)
    };
    let (displacements, stresses) = ([0, 1], [2, 3]);
    largest(ones, displacements) * largest(twos, stresses) + largest(ones, stresses) * largest(twos, displacements)
}

/// Rows S, T of the top face and S, T of the bottom face.
pub(super) fn stress_rows(top: &Matrix4<f64>, bottom: &Matrix4<f64>) -> Matrix4<f64> {
    Matrix4::from_rows(&[top.row(2), top.row(3), bottom.row(2), bottom.row(3)])
}

fn flexibility_of_half_plane(top: &Matrix4x2<f64>) -> Option<Matrix2<f64>> {
    let stress: Matrix2<f64> = top.fixed_rows::<2>(2).into_owned();
    Some(top.fixed_rows::<2>(0) * solve_equilibrated(stress, Matrix2::identity())?)
}
