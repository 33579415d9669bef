//! The law of layers that are one body cut in two, put to the pairs that ship and to layers that claim too much.
use std::sync::Arc;

use recede_layers::conformance::{self, one_body};
use recede_layers::{
    EngineeringConstants, Exponential, HalfPlane, Homogeneous, Layer, Material, Orthotropic, OrthotropicHalfPlane,
    Plane,
};

const PLANES: [Plane; 2] = [Plane::Strain, Plane::Stress];

fn part(thickness: f64, modulus: f64, beta: f64) -> Exponential {
    Exponential::new(thickness, modulus, 0.3, beta).expect("legal")
}

fn assert_one(above: &dyn Layer, below: &dyn Layer) {
    assert!(above.continues(below).is_some(), "{above:?} {below:?}");
    for plane in PLANES {
        assert_eq!(one_body(above, below, plane), Ok(()), "{above:?} {below:?}");
    }
}

#[test]
fn pairs_that_ship() {
    let strip = |thickness| Homogeneous::new(thickness, 2.0, 0.3).expect("legal");
    assert_one(&strip(1.0), &strip(0.01));
    assert_one(&strip(0.3), &strip(20.0));
    assert_one(&strip(0.3), &HalfPlane::new(2.0, 0.3).expect("legal"));
    for beta in [-20.0, -1.0, -1e-9, 0.0, 0.5, 12.0] {
        assert_one(&part(1.0, 3.0, beta), &part(0.6, 3.0 * f64::exp(beta), beta));
    }
    let ply = EngineeringConstants::new([20.0, 2.0, 3.0], [0.3, 0.25, 0.2], 1.0).expect("legal");
    let fibres = |thickness| Orthotropic::new(thickness, ply).expect("legal");
    assert_one(&fibres(0.5), &fibres(1.5));
    assert_one(&fibres(0.5), &OrthotropicHalfPlane::new(ply));
    // those that are two say nothing
    assert!(strip(1.0).continues(&part(1.0, 2.0, 0.0)).is_none());
    assert_eq!(one_body(&strip(1.0), &part(1.0, 2.0, 0.0), Plane::Strain), Ok(()));
    for beta in [-30.0, -1.0, 0.0, 1e-9, 0.7, 12.0] {
        let above = part(1.0, 3.0, beta);
        assert!(above.continues(&part(2.0, 3.0 * f64::exp(beta) * (1.0 + 1e-12), beta)).is_none());
        assert!(above.continues(&part(2.0, 3.0 * f64::exp(beta), beta + 0.1)).is_none());
    }
    assert!(part(3.0, 1.0, 30.0).continues(&part(1.0, f64::exp(90.0), 30.0)).is_none(), "too steep for one layer");
}

/// An exponential layer that takes whatever lies below for its own continuation.
#[derive(Debug)]
struct Greedy {
    own: Exponential,
    thickness: f64,
}

impl Layer for Greedy {
    fn thickness(&self) -> Option<f64> {
        self.own.thickness()
    }
    fn material(&self, depth: f64, plane: Plane) -> Material {
        self.own.material(depth, plane)
    }
    fn continues(&self, _: &dyn Layer) -> Option<Arc<dyn Layer>> {
        Some(Arc::new(part(self.thickness, 3.0, -1.0)))
    }
}

#[test]
fn layers_that_claim_too_much_are_caught() {
    let greedy = |thickness| Greedy { own: part(1.0, 3.0, -1.0), thickness };
    let broken = |layer: &dyn Layer| {
        let violations = conformance::examine(layer, Plane::Strain).expect_err("it is not one body");
        violations.iter().map(|violation| (violation.law, violation.quantity)).collect::<Vec<_>>()
    };
    // the grading begins anew below the cut
    assert_eq!(broken(&greedy(2.0)), [("continues", "material")]);
    assert_eq!(broken(&greedy(3.0)), [("continues", "thickness")]);
    assert_eq!(one_body(&greedy(2.0), &part(1.0, 3.0 * f64::exp(-1.0), -1.0), Plane::Strain), Ok(()));
}
