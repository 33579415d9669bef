//! Stresses of layers with eigenstrains and weights before anything else presses, and how eigenstrains bend the laminates.
//!
//! Far from all ends a laminate whose layers would have the strains t along it if they were free is strained by e₀ + κ (d − d_n) at the depth d, so that the stresses w (e₀ + κ (d − d_n) − t)
//! have neither a resultant nor a moment; w is the modulus of a stretched plate. Layers that slide on each other have resultants of their own, and one moment. What is joined to the base
//! stays flat, and what is bonded to it is not stretched. A pressure p on the layers counts with the strain that it makes in a free layer. Sources: Stoney 1909, Timoshenko 1925.
use recede_layers::{Layer, Material};

use super::weight::weight;
use super::{Group, Joint, Placed, Stack};
use crate::geometry::Geometry;
use crate::numeric::quadrature::rule;

/// Gauss points between two depths where a material is not smooth: enough for moduli that vary over the layer by many powers of ten.
const POINTS: usize = 64;
/// Curvatures that would strain a laminate by a smaller part of its eigenstrains are rounding.
const ROUNDING: f64 = 1e-13;

/// The strains of all layers against their own eigenstrains.
#[derive(Clone, Debug, Default)]
pub(crate) struct Residual {
    /// By how much the slope of each free laminate grows with x, in 1/length: positive if its edges bend up.
    pub(crate) curvatures: Vec<f64>,
    /// Of each layer, half-planes among them.
    pub(crate) layers: Vec<ResidualStrain>,
}

/// How a layer is strained before anything presses but weights.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ResidualStrain {
    /// The strain along it at its top face, and what that grows by with the depth.
    strain: [f64; 2],
    /// The pressure on its top face, of a pressure on top of the stack and of the weights of layers above.
    pressure: f64,
}

/// What layers that are bonded to each other are, in moments about the top of the body: ∫ w dⁿ, and ∫ w t dⁿ.
#[derive(Clone, Copy, Default)]
struct Moments {
    stiffness: [f64; 3],
    free: [f64; 2],
}

impl Stack {
    /// The strains of all layers; `None` if no layer has an eigenstrain, and nothing presses.
    pub(crate) fn residual(&self) -> Option<Residual> {
        let is_strained = |placed: &Placed| placed.layer.eigenstrain() != 0.0 || weight(placed) != 0.0;
        if self.pressure_on_top == 0.0 && !self.groups().any(|group| group.layers().any(is_strained)) {
            return None;
        }
        let (mut residual, mut pressure) = (Residual::default(), self.pressure_on_top);
        for (i, group) in self.groups().enumerate() {
            // what weights press together is as flat as the gaps below, and what is joined to the base is not stretched
            let [bends, is_free] = [i < self.loose(), i < self.laminates.len()];
            residual.curvatures.push(residual_of(
                &group,
                [bends, is_free],
                self.geometry,
                &mut pressure,
                &mut residual.layers,
            ));
        }
        Some(residual)
    }
}

/// Adds the strains of the layers of a body under a pressure, which grows by their weights, and returns the curvature of its upper face.
fn residual_of(
    group: &Group,
    [bends, is_free]: [bool; 2],
    geometry: Geometry,
    pressure: &mut f64,
    strains: &mut Vec<ResidualStrain>,
) -> f64 {
    // layers that do not slide on each other
    let mut parts: Vec<(Moments, usize, f64)> = vec![Default::default()];
    let (mut top, mut tops) = (0.0, Vec::new());
    let mut joints = group.joints().iter();
    for placed in group.layers() {
        if let Some((moments, count, pressed_to)) = parts.last_mut() {
            (*count, *pressed_to) = (*count + 1, placed.pressed_to);
            moments.add(&*placed.layer, top, *pressure, geometry);
        }
        tops.push((top, *pressure));
        *pressure += weight(placed);
        top += placed.layer.thickness().unwrap_or(0.0);
        if joints.next().is_some_and(slides) {
            parts.push(Default::default());
        }
    }
    let largest = group.layers().map(|placed| placed.layer.eigenstrain().abs()).fold(0.0, f64::max);
    let [moment, rigidity] =
        parts.iter().map(|(moments, ..)| moments.bending()).fold([0.0; 2], |[a, b], [c, d]| [a + c, b + d]);
    let is_bent = (moment / rigidity * top).abs() > ROUNDING * largest;
    let count = parts.len();
    let mut tops = tops.into_iter();
    let mut curvatures = Vec::with_capacity(count);
    for (k, (moments, layers, pressed_to)) in parts.into_iter().enumerate() {
        let Moments { stiffness: [whole, first, _], free: [resultant, _] } = moments;
        let curvature = match bends {
            true if is_bent => moment / rigidity,
            true => 0.0,
            false => pressed_to,
        };
        curvatures.push(curvature);
        // what is bonded to the base is not stretched
        let (mean, about) = if !is_free && k + 1 == count { (0.0, 0.0) } else { (resultant / whole, first / whole) };
        let of = |(top, pressure): (f64, f64)| ResidualStrain {
            strain: [mean + curvature * (top - about), curvature],
            pressure,
        };
        strains.extend(tops.by_ref().take(layers).map(of));
    }
    curvatures.first().copied().unwrap_or(0.0)
}

/// Whether layers slide on each other at a joint.
fn slides(joint: &Joint) -> bool {
    joint.tangential == 0.0
}

impl Moments {
    fn add(&mut self, layer: &dyn Layer, top: f64, pressure: f64, geometry: Geometry) {
        let Some(thickness) = layer.thickness() else { return };
        let mut ends = layer.kinks();
        ends.extend([0.0, thickness]);
        ends.sort_by(f64::total_cmp);
        for (depth, weight) in ends.windows(2).flat_map(|pair| rule(POINTS).on(pair[0], pair[1])) {
            let material = layer.material(depth, geometry.plane());
            let [stiffness, mut free] = stretched(layer, &material, geometry);
            free += material.coupling * (pressure + layer.specific_weight() * depth) / stiffness;
            let d = top + depth;
            let own = weight * stiffness;
            self.stiffness.iter_mut().zip([1.0, d, d * d]).for_each(|(sum, power)| *sum += own * power);
            self.free.iter_mut().zip([1.0, d]).for_each(|(sum, power)| *sum += own * free * power);
        }
    }

    /// Moment of the eigenstrains, and rigidity, about the neutral axis.
    fn bending(&self) -> [f64; 2] {
        let ([whole, first, second], [resultant, moment]) = (self.stiffness, self.free);
        if whole == 0.0 { [0.0; 2] } else { [moment - resultant * first / whole, second - first * first / whole] }
    }
}

/// The modulus w of a stretched plate, and the strain t along it that it would have if it were free; about an axis it is stretched in all directions.
fn stretched(layer: &dyn Layer, material: &Material, geometry: Geometry) -> [f64; 2] {
    let poisson = material.out_of_plane.map_or(0.0, |[along, _]| along);
    let (stiffness, free) = (material.axial_stiffness, layer.eigenstrain());
    match geometry {
        Geometry::PlaneStrain => [stiffness, (1.0 + poisson) * free],
        Geometry::PlaneStress => [stiffness, free],
        Geometry::Axisymmetric => [(1.0 + poisson) * stiffness, free],
    }
}

/// The stresses along a layer, across it, and out of the plane or about the axis, at a depth where it is strained so much.
pub(crate) fn residual_stress(
    layer: &dyn Layer,
    material: &Material,
    geometry: Geometry,
    ResidualStrain { strain: [strain, growth], pressure }: ResidualStrain,
    depth: f64,
) -> [f64; 3] {
    let [stiffness, free] = stretched(layer, material, geometry);
    let across = -(pressure + layer.specific_weight() * depth);
    let along = stiffness * (strain + growth * depth - free) + material.coupling * across;
    let poisson = material.out_of_plane.map_or(f64::NAN, |[along, _]| along);
    let out = match geometry {
        Geometry::PlaneStrain if layer.eigenstrain() == 0.0 => match material.out_of_plane {
            Some([by_along, by_across]) => by_along * along + by_across * across,
            None => f64::NAN,
        },
        // nothing is strained out of the plane, where Young's modulus is known of isotropic materials only
        Geometry::PlaneStrain if material.is_isotropic() => {
            poisson * (along + across) - (1.0 - poisson * poisson) * material.axial_stiffness * layer.eigenstrain()
        }
        Geometry::PlaneStrain => f64::NAN,
        Geometry::PlaneStress => 0.0,
        Geometry::Axisymmetric => along,
    };
    [along, across, out]
}
