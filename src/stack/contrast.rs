//! Ratios of moduli: a stack whose ratio is beyond double precision, and beyond any two materials, is rejected.
use recede_layers::{Layer, Material, Plane};

use super::{MAX_CONTRAST, Placed, Stack, StackError, StackProblem};

/// Depths at which the material of a layer is evaluated, in parts of the thickness, besides its kinks.
const DEPTHS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// Rejects moduli whose ratio is larger than [`MAX_CONTRAST`], with the item of the layer that has the largest one.
/// Of a half-plane only the face counts: deeper down a graded one may have any modulus. A punch comes before all layers.
pub(super) fn check(stack: &Stack, punch: Option<Material>) -> Result<(), StackError> {
    let punch = punch.map(|material| (None, moduli(&material)));
    let of_second = stack.second.iter().flat_map(|second| layers(second)).map(|(_, moduli)| (None, moduli));
    let layers = layers(stack).map(|(placed, moduli)| (Some(placed), moduli));
    let bodies: Vec<(Option<&Placed>, [f64; 2])> = punch.into_iter().chain(of_second).chain(layers).collect();
    let softest = bodies.iter().reduce(|first, other| if other.1[0] < first.1[0] { other } else { first });
    let stiffest = bodies.iter().reduce(|first, other| if other.1[1] > first.1[1] { other } else { first });
    let (Some((soft, [least, _])), Some((stiff, [_, most]))) = (softest, stiffest) else { return Ok(()) };
    let ratio = most / least;
    if ratio <= MAX_CONTRAST || ratio.is_nan() {
        return Ok(());
    }
    // the punch has no number
    let [soft_number, stiff_number] = [soft, stiff].map(|body| body.map(|placed| placed.number));
    let name = |body: &Option<&Placed>| body.map_or("the punch".to_owned(), Placed::name);
    let soft = if soft_number == stiff_number { "elsewhere in the same layer".to_owned() } else { name(soft) };
    Err(StackError::of_layer(stiff_number.unwrap_or(1), StackProblem::Contrast { stiff: name(stiff), soft, ratio }))
}

/// The layers of a stack with their moduli.
fn layers(stack: &Stack) -> impl Iterator<Item = (&Placed, [f64; 2])> {
    let all = stack.groups().flat_map(|group| group.layers());
    all.map(|placed| (placed, range(placed, stack.plane())))
}

/// The smallest and the largest modulus of a layer.
fn range(placed: &Placed, plane: Plane) -> [f64; 2] {
    let layer: &dyn Layer = &*placed.layer;
    let Some(thickness) = layer.thickness() else { return moduli(&layer.material(0.0, plane)) };
    let inside = layer.kinks().into_iter().filter(|depth| (0.0..=thickness).contains(depth));
    let depths = DEPTHS.iter().map(|part| part * thickness).chain(inside);
    depths
        .map(|depth| moduli(&layer.material(depth, plane)))
        .fold([f64::INFINITY, 0.0], |[least, most], [low, high]| [least.min(low), most.max(high)])
}

/// The smaller and the larger of c66 and c11 − c12²/c22.
fn moduli(material: &Material) -> [f64; 2] {
    let (shear, axial) = (material.shear_compliance.recip(), material.axial_stiffness);
    [shear.min(axial), shear.max(axial)]
}

#[cfg(test)]
mod tests {
    use recede_layers::{Exponential, GradedHalfPlane, HalfPlane, Homogeneous};

    use super::*;
    use crate::stack::StackBuilder;

    fn refused(stack: StackBuilder) -> Option<(String, Option<usize>)> {
        stack.build().err().map(|error| (error.to_string(), error.item()))
    }

    #[test]
    fn ratios_of_moduli_have_a_limit_whatever_the_units() {
        for unit in [1e-200, 1.0, 1e200] {
            let strip = |modulus: f64| Homogeneous::new(1.0, modulus * unit, 0.25).unwrap();
            let on = |modulus: f64| Stack::builder(Plane::Strain).layer(strip(modulus)).receding();
            let ground = || HalfPlane::new(unit, 0.25).unwrap();
            assert_eq!(refused(on(1e14).layer(ground())), None);
            assert_eq!(refused(on(1e-14).layer(ground())), None);
            let (message, item) = refused(on(1e-16).layer(ground())).unwrap();
            assert!(message.starts_with("layer 2 (HalfPlane) is 2.7e16 times as stiff as layer 1 (Homogeneous)"));
            assert_eq!(item, Some(2));
            let (message, item) = refused(on(1e16).layer(ground())).unwrap();
            assert!(
                message.ends_with("as stiff as layer 2 (HalfPlane); allowed is a ratio of at most 1e15"),
                "{message}"
            );
            assert_eq!(item, Some(0));
        }
    }

    #[test]
    fn the_whole_of_a_layer_counts_but_only_the_face_of_a_half_plane() {
        let steep = |beta: f64| Stack::builder(Plane::Strain).layer(Exponential::new(1.0, 1.0, 0.25, beta).unwrap());
        assert_eq!(refused(steep(30.0).bonded().rigid()), None);
        let (message, _) = refused(steep(-86.5).bonded().rigid()).unwrap();
        assert!(message.contains("elsewhere in the same layer"), "{message}");
        let ground = GradedHalfPlane::new(1.0, 0.25, 1e3).unwrap();
        assert_eq!(refused(Stack::builder(Plane::Strain).layer(ground)), None);
    }

    #[test]
    fn an_elastic_punch_counts() {
        let stack = Stack::builder(Plane::Strain).layer(HalfPlane::new(1.0, 0.25).unwrap()).build().unwrap();
        let check = |modulus| stack.check_punch(&recede_layers::Isotropic { shear_modulus: modulus, poisson: 0.3 });
        assert!(check(1e14).is_ok() && check(1e-14).is_ok());
        assert!(check(1e17).unwrap_err().to_string().starts_with("the punch is"));
        assert!(check(1e-17).unwrap_err().to_string().contains("as stiff as the punch; allowed"));
    }
}
