//! A layer cut into slices.
use nalgebra::Matrix4;

use super::Profile;
use super::points::Points;
use super::rule::NODES;
use crate::Wave;

/// Slices around a jump of the material are halved down to this part of the thickness.
const THINNEST: f64 = 1e-14;
/// A material that is still not resolved after so many slices is taken as it is.
const MANY: usize = 10_000;

/// Consecutive slices from the top face down to `depth`.
pub(super) struct Slices {
    pub list: Vec<Slice>,
    /// The depth at which each slice ends.
    ends: Vec<f64>,
    pub depth: f64,
}

impl Slices {
    /// How many slices lie above one of the depths at which the layer was cut.
    pub fn above(&self, depth: f64) -> usize {
        self.ends.partition_point(|end| *end <= depth)
    }
}

pub(super) struct Slice {
    pub thickness: f64,
    /// In units of the material's shortest decay length.
    pub length: f64,
    /// Mean shear compliance, times μ₀.
    pub softness: f64,
    /// State at the top from the state at the bottom, less identity.
    pub transfer: Matrix4<f64>,
}

impl Profile<'_> {
    /// Slices from the top face down to the bottom or to where `felt` decay lengths are passed; in a half-plane also
    /// to where the material is so stiff that it does not move. At the `cuts`, depths in ascending order, slices end.
    pub(super) fn slices(&self, wave: &Wave, felt: f64, cuts: &[f64]) -> Slices {
        let end = self.thickness.unwrap_or(f64::INFINITY);
        let largest = (1.0 / wave.wavenumber).min(0.5 * end);
        let thinnest = THINNEST * largest;
        let mut slices = Slices { list: Vec::new(), ends: Vec::new(), depth: 0.0 };
        let (mut decay, mut softest) = (0.0, 0.0_f64);
        let mut guess = largest;
        let mut cuts = cuts.iter().copied().peekable();
        while slices.depth < end && decay < felt {
            while cuts.next_if(|cut| *cut <= slices.depth).is_some() {}
            let stop = cuts.peek().map_or(end, |cut| cut.min(end));
            let left = stop - slices.depth;
            // what is left is shared evenly if a second slice would do
            let mut thickness = if guess >= left { left } else { guess.min(0.5 * left).max(thinnest.min(left)) };
            let mut points = Points::new(self, wave, slices.depth, thickness);
            while !points.resolved(wave.wavenumber * thickness) && thickness > thinnest && slices.list.len() < MANY {
                thickness *= 0.5;
                points = Points::new(self, wave, slices.depth, thickness);
            }
            slices.depth = if thickness >= left { stop } else { slices.depth + thickness };
            slices.ends.push(slices.depth);
            let zeta = wave.wavenumber * thickness;
            decay += zeta * points.slowest();
            if self.thickness.is_none() {
                softest = softest.max(points.shear[NODES - 1]);
                decay = decay.max(0.5 * (softest / points.shear[0]).ln());
            }
            slices.list.push(Slice {
                thickness,
                length: zeta * points.fastest(),
                softness: points.shear.mean(),
                transfer: points.transfer(zeta),
            });
            guess = (2.0 * thickness).min(largest);
        }
        slices
    }
}

/// X⁻¹ − 1 from X − 1, entry by entry: reciprocity makes X symplectic, X⁻¹ = Ω⁻¹ Xᵀ Ω, with the pairs (U, T), (V, S).
pub(crate) fn inverse(transfer: &Matrix4<f64>) -> Matrix4<f64> {
    let sign = |i: usize| if i < 2 { 1.0 } else { -1.0 };
    Matrix4::from_fn(|i, j| sign(i) * sign(j) * transfer[(3 - j, 3 - i)])
}

#[cfg(test)]
mod tests {
    use super::super::FELT;
    use super::*;
    use crate::{Exponential, Isotropic, Layer, Plane};

    fn wave(wavenumber: f64) -> Wave {
        Wave { wavenumber, modulus: 1.0, plane: Plane::Strain }
    }

    #[test]
    fn a_slice_and_its_inverse_compose_to_nothing() {
        let material =
            |depth: f64| Isotropic { shear_modulus: (0.8 * depth).exp(), poisson: 0.3 }.material(Plane::Strain);
        let profile = Profile { thickness: Some(1.0), material: &material };
        let transfer = Points::new(&profile, &wave(0.5), 0.0, 1.0).transfer(0.5);
        let back = inverse(&transfer);
        assert!((transfer + back + back * transfer).amax() < 1e-15);
    }

    #[test]
    fn slices_are_counted() {
        // one slice for each half; βδ < 1 in a slice; thick: thirty decay lengths from a face, however thick the layer
        let count = |beta: f64, wavenumber: f64| {
            let layer = Exponential::new(1.0, 1.0, 0.25, beta).expect("legal");
            let material = |depth| layer.material(depth, Plane::Strain);
            let profile = Profile { thickness: Some(1.0), material: &material };
            profile.slices(&wave(wavenumber), FELT, &[]).list.len()
        };
        assert_eq!([count(0.0, 1e-8), count(0.0, 1.0), count(30.0, 1e-8)], [2, 2, 33]);
        assert!([1e3, 1e8, 1e150].map(|wavenumber| count(1.0, wavenumber)).iter().all(|n| (60..=61).contains(n)));
    }
}
