//! A layer cut into slices, for one wavenumber.
use nalgebra::Matrix4;

use super::BodyProfile;
use super::rule::NODES;
use super::tree::{From, Tree};

/// Consecutive slices from one face on.
pub(super) struct Slices {
    pub list: Vec<Slice>,
    /// How far they reach from that face.
    pub depth: f64,
}

impl Slices {
    /// How many slices lie between the top face, from which they begin, and one of the depths at which the layer was cut.
    pub fn above(&self, depth: f64) -> usize {
        self.list.partition_point(|slice| slice.to <= depth)
    }

    /// The same between the bottom face and a depth.
    pub fn below(&self, depth: f64) -> usize {
        self.list.partition_point(|slice| slice.from >= depth)
    }
}

pub(super) struct Slice {
    pub thickness: f64,
    /// Depth at which it begins.
    pub from: f64,
    /// Depth at which it ends.
    pub to: f64,
    /// In units of the material's shortest decay length.
    pub length: f64,
    /// Mean shear compliance, in units of the [`Tree`]'s modulus.
    pub softness: f64,
    /// State at the top from the state at the bottom, less identity.
    pub transfer: Matrix4<f64>,
}

impl BodyProfile<'_> {
    /// Slices from a face on to the other one or to where `felt` decay lengths are passed; in a half-plane also
    /// to where the material is so stiff that it does not move.
    pub(super) fn slices(&self, tree: &Tree, wavenumber: f64, from: From, felt: f64) -> Slices {
        let mut slices = Slices { list: Vec::new(), depth: 0.0 };
        let (mut decay, mut softest) = (0.0, 0.0_f64);
        let modulus = tree.modulus(self);
        tree.parts(self, wavenumber, from, |part| {
            let points = part.points(self, modulus);
            let zeta = wavenumber * part.thickness;
            slices.depth += part.thickness;
            decay += zeta * points.slowest;
            if self.thickness.is_none() {
                softest = softest.max(points.shear[NODES - 1]);
                decay = decay.max(0.5 * (softest / points.shear[0]).ln());
            }
            slices.list.push(Slice {
                thickness: part.thickness,
                from: part.from,
                to: part.to,
                length: zeta * points.fastest,
                softness: points.shear.mean(),
                transfer: part.series(points, tree).at(zeta),
            });
            decay < felt
        });
        if decay < felt {
            slices.depth = self.thickness.unwrap_or(slices.depth);
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

    #[test]
    fn a_slice_and_its_inverse_compose_to_nothing() {
        let material =
            |depth: f64| Isotropic { shear_modulus: (0.8 * depth).exp(), poisson: 0.3 }.material(Plane::Strain);
        let profile = BodyProfile { thickness: Some(1.0), material: &material, kinks: &[] };
        let slices = profile.slices(&Tree::default(), 0.5, From::Top, FELT);
        let transfer = slices.list[0].transfer;
        let back = inverse(&transfer);
        assert!((transfer + back + back * transfer).amax() < 1e-15);
    }

    #[test]
    fn slices_are_counted() {
        // one slice for each half; βδ < 1 in a slice; thick: thirty decay lengths from a face, however thick the layer
        let count = |beta: f64, wavenumber: f64| {
            let layer = Exponential::new(1.0, 1.0, 0.25, beta).expect("legal");
            let material = |depth| layer.material(depth, Plane::Strain);
            let profile = BodyProfile { thickness: Some(1.0), material: &material, kinks: &[] };
            profile.slices(&Tree::default(), wavenumber, From::Top, FELT).list.len()
        };
        assert_eq!([count(0.0, 1e-8), count(0.0, 1.0), count(30.0, 1e-8)], [2, 2, 32]);
        assert!([1e3, 1e8, 1e150].map(|wavenumber| count(1.0, wavenumber)).iter().all(|n| (15..=31).contains(n)));
    }

    #[test]
    fn what_was_asked_before_makes_no_difference() {
        let material =
            |depth: f64| Isotropic { shear_modulus: 1.0 + depth.sin(), poisson: 0.3 }.material(Plane::Strain);
        let profile = BodyProfile { thickness: Some(2.0), material: &material, kinks: &[0.7] };
        let tree = Tree::default();
        for wavenumber in [30.0, 0.1, 1e5, 3.0, 30.0] {
            let [used, fresh] =
                [&tree, &Tree::default()].map(|tree| profile.slices(tree, wavenumber, From::Bottom, FELT).list);
            assert!(used.iter().zip(&fresh).all(|(a, b)| a.transfer == b.transfer) && used.len() == fresh.len());
        }
    }
}
