//! The material at the Gauss points of a slice, and whether they resolve it.
use nalgebra::SVector;

use super::BodyProfile;
use super::rule::{ENDS, NODES, RULE};
use super::surface::Coefficients;
use crate::Material;

/// A material counts as resolved when the last Legendre coefficients on a slice are this small: their squares, which
/// is what Gauss points leave, are below rounding.
const RESOLVED: f64 = 1e-9;
/// The polynomial through the Gauss points must also meet the material at the ends of a slice, as closely as this: a
/// thin skin or a jump might hide there.
const MET: f64 = 1e-8;

/// The material at the Gauss points of a slice, from the bottom up, in units of a modulus.
#[derive(Debug, PartialEq)]
pub(super) struct Points {
    pub shear: SVector<f64, NODES>,
    pub coupling: SVector<f64, NODES>,
    pub normal: SVector<f64, NODES>,
    pub axial: SVector<f64, NODES>,
    /// Whether the slice is short enough for the variation of the material.
    pub resolved: bool,
    /// How fast the fastest field varies with ζ = λy: the modulus of the larger root, see [`Material::squared_roots`].
    pub fastest: f64,
    /// See [`Material::slowest_decay`].
    pub slowest: f64,
}

impl Points {
    pub fn new(profile: &BodyProfile, modulus: f64, depth: f64, thickness: f64) -> Self {
        let at = |t: f64| (profile.material)(depth + (1.0 - t) * thickness);
        let materials = RULE.nodes.map(at);
        let coefficients = |material: Material| Coefficients::new(&material, modulus);
        let points = materials.map(coefficients);
        let ends = ENDS.map(at).map(coefficients);
        let values = |pick: fn(&Coefficients) -> f64| SVector::from_iterator(points.iter().map(pick));
        let (shear, coupling) = (values(|point| point.m), values(|point| point.c));
        let (normal, axial) = (values(|point| point.d), values(|point| point.e));
        let smooth = |f: &SVector<f64, NODES>, pick: fn(&Coefficients) -> f64, floor: f64| {
            let size = f.amax().max(floor);
            let missed = RULE.ends * f - SVector::from(ends.each_ref().map(pick));
            (RULE.highest * f).amax() <= RESOLVED * size && missed.amax() <= MET * size
        };
        let resolved = smooth(&shear, |end| end.m, 0.0)
            && smooth(&axial, |end| end.e, 0.0)
            && smooth(&coupling, |end| end.c, 1.0)
            && smooth(&normal, |end| end.d, shear.amax());
        // a wave that meets the stiffest and the softest place of the slice at once is faster than any in it
        let worst = Material {
            shear_compliance: shear.max(),
            normal_compliance: normal.max(),
            coupling: coupling.min(),
            axial_stiffness: axial.max(),
            out_of_plane: None,
        };
        let fastest = worst.squared_roots().iter().fold(1.0, |s: f64, root| s.max(root.norm().sqrt()));
        let slowest = materials.iter().map(Material::slowest_decay).fold(f64::INFINITY, f64::min);
        Self { shear, coupling, normal, axial, resolved, fastest, slowest }
    }

    /// Whether the material is the same, to the last digit, at all points.
    pub fn are_all(&self, Coefficients { m, c, d, e }: &Coefficients) -> bool {
        [(&self.shear, m), (&self.coupling, c), (&self.normal, d), (&self.axial, e)]
            .iter()
            .all(|(values, value)| values.iter().all(|found| found == *value))
    }
}
