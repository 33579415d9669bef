//! Half-planes of all kinds with no layer above them.
//!
//! Goal: a stack without a length of its own has the fields of the same body drawn as a layer on a half-plane.
//!
//! ```text
//!        ___                         ___
//!   ────────────   1            ────────────   1   the same material down to the depth h
//!                          =    ════════════
//!    graded                      2                 the rest of the half-plane, bonded to it
//! ```
use std::sync::Arc;

use recede::{
    Exponential, GradedHalfPlane, HalfPlane, Homogeneous, Isotropic, Item, Layer, Material, Model, Plane,
    PowerHalfPlane, Punch, Solution, Stack,
};

/// Parts of the pressure at x = 0 that stresses of two drawings of one body may differ by, inside and on the loaded face.
const INSIDE: f64 = 1e-8;
const ON_FACE: f64 = 1e-6;
/// Depths of the cut.
const CUTS: [f64; 3] = [0.02, 0.5, 30.0];

/// The upper part of a [`PowerHalfPlane`] of modulus 1 and Poisson's ratio 0.3.
#[derive(Debug)]
struct PowerLayer {
    thickness: f64,
    length: f64,
    exponent: f64,
}

impl Layer for PowerLayer {
    fn thickness(&self) -> Option<f64> {
        Some(self.thickness)
    }

    fn material(&self, depth: f64, plane: Plane) -> Material {
        let shear_modulus = (1.0 + depth / self.length).powf(self.exponent);
        Isotropic { shear_modulus, poisson: 0.3 }.material(plane)
    }
}

fn pressed(stack: Stack) -> (Model, Solution) {
    let model = Model::new(stack).expect("resolved");
    let solution = model.press(Punch::parabola(40.0).expect("legal"), 0.02).expect("solved");
    (model, solution)
}

/// Contacts, stresses and the largest shear stress of one half-plane and of the same body cut at a depth.
fn compare(whole: impl Layer, cut: impl Fn(f64) -> Stack) {
    let what = format!("{whole:?}");
    let (model, solution) = pressed(Stack::builder(Plane::Strain).layer(whole).build().expect("legal"));
    let field = model.field(&solution).expect("its own");
    let contact = &solution.contacts()[0];
    let peak = contact.pressure(0.0);
    for depth in CUTS {
        let (other_model, other) = pressed(cut(depth));
        let half_length = other.contacts()[0].half_length().unwrap();
        assert!(
            (half_length / contact.half_length().unwrap() - 1.0).abs() < 1e-9,
            "{what}, cut at {depth}: {half_length}"
        );
        let same = other_model.field(&other).expect("its own");
        for (x, y) in [(0.0, 0.0), (0.0, 0.3), (0.4, 0.1), (0.5, 1.7), (3.0, 0.2), (1.0, 40.0)] {
            let (found, expected) = (field.at(x, y).expect("inside"), same.at(x, y).expect("inside"));
            let pairs = [
                (found.sigma_xx, expected.sigma_xx),
                (found.sigma_yy, expected.sigma_yy),
                (found.sigma_xy, expected.sigma_xy),
            ];
            for (found, expected) in pairs {
                let error = (found - expected).abs();
                let allowed = if y > 0.0 { INSIDE } else { ON_FACE };
                assert!(error < allowed * peak, "{what}, cut at {depth}, at {x}, {y}: {found} {expected}");
            }
        }
        let [found, expected] = [&field, &same].map(|field| field.max_shear().expect("found").value);
        assert!((found / expected - 1.0).abs() < 1e-6, "{what}, cut at {depth}: {found} {expected}");
    }
}

#[test]
fn an_exponential_half_plane_may_be_cut() {
    for beta in [1e-3, 0.5, 20.0] {
        compare(GradedHalfPlane::new(1.0, 0.3, beta).expect("legal"), |h| {
            // as deep as it is not yet rigid
            let h = h.min(20.0 / beta);
            let top = Exponential::new(h, 1.0, 0.3, beta).expect("legal");
            let below = GradedHalfPlane::new((beta * h).exp(), 0.3, beta).expect("legal");
            Stack::builder(Plane::Strain).layer(top).bonded().layer(below).build().expect("legal")
        });
    }
}

#[test]
fn a_half_plane_graded_by_a_power_law_may_be_cut() {
    for (length, exponent) in [(1.0, 0.5), (0.01, 0.3), (50.0, 3.0), (1.0, -0.5), (3.0, -0.8)] {
        compare(PowerHalfPlane::new(1.0, 0.3, length, exponent).expect("legal"), |h| {
            let at_cut = (1.0 + h / length).powf(exponent);
            let below = PowerHalfPlane::new(at_cut, 0.3, length + h, exponent).expect("legal");
            let top = PowerLayer { thickness: h, length, exponent };
            Stack::builder(Plane::Strain).layer(top).bonded().layer(below).build().expect("legal")
        });
    }
}

#[test]
fn layers_of_no_thickness_change_nothing() {
    let bases: [Arc<dyn Layer>; 3] = [
        Arc::new(HalfPlane::new(1.0, 0.3).unwrap()),
        Arc::new(GradedHalfPlane::new(1.0, 0.3, 0.5).unwrap()),
        Arc::new(PowerHalfPlane::new(1.0, 0.3, 1.0, 0.5).unwrap()),
    ];
    for base in bases {
        let base = || Item::Layer(Arc::clone(&base));
        let (bare_model, bare) = pressed(Stack::builder(Plane::Strain).item(base()).build().unwrap());
        let nothing = Homogeneous::new(0.0, 7.0, 0.1).unwrap();
        let with_nothing = Stack::builder(Plane::Strain).layer(nothing).receding().item(base());
        let (model, solution) = pressed(with_nothing.build().unwrap());
        assert_eq!(solution.contacts().len(), 1);
        assert_eq!(solution.contacts()[0].half_length().unwrap(), bare.contacts()[0].half_length().unwrap());
        let [found, expected] =
            [model.field(&solution), bare_model.field(&bare)].map(|f| f.unwrap().max_shear().unwrap());
        assert_eq!((found.value, found.x, found.depth), (expected.value, expected.x, expected.depth));
    }
}
