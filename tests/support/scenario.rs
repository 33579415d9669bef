//! Random scenes of moderate numbers, and what a test does with them.
use proptest::prelude::*;
use recede::selftest::{Ply, Ranges, Scenario, scenes};
use recede::{Error, Item, Model, Options, Solution};

/// Number of depths at which the material of a layer is evaluated.
const PARTS: usize = 100;
/// Laminates that bend more than this by themselves are left out.
const STRAIGHT: f64 = 0.05;
/// Laminates that bend down more than about 0.1 need not lift off from a rigid base at all.
const LIFTS_OFF: f64 = 0.08;

/// A layer cut in two, the upper part having this share of the thickness.
pub fn cut(layer: &Ply, share: f64) -> [Ply; 2] {
    let steepness = |share: f64| layer.steepness.map(|steepness| steepness * share);
    let upper =
        Ply { thickness: share * layer.thickness, steepness: steepness(share), receding: false, ..layer.clone() };
    let lower = Ply {
        thickness: (1.0 - share) * layer.thickness,
        modulus: layer.modulus * steepness(share).unwrap_or(0.0).exp(),
        steepness: steepness(1.0 - share),
        ..layer.clone()
    };
    [upper, lower]
}

/// How much a free laminate bends as a whole where both its faces are pressed, compared with how far a line load
/// spreads in it; positive where its ends go down.
///
/// Pressure makes a layer longer. If this bends the ends down more than the spreading load bends them up, a laminate
/// does not lift off from what it lies on, or touches it again further out.
fn bending_under_equal_loads(scenario: &Scenario) -> f64 {
    let laminates = scenario.layers.split_inclusive(|layer| layer.receding);
    let bending = laminates.filter(|laminate| laminate.last().is_some_and(|layer| layer.receding)).map(|laminate| {
        let (mut height, mut stiffness, mut stiffness_moment, mut push, mut push_moment) = (0.0, 0.0, 0.0, 0.0, 0.0);
        for layer in laminate {
            let Ok(Item::Layer(body)) = layer.item() else { continue };
            for part in 0..PARTS {
                let depth = layer.thickness * (part as f64 + 0.5) / PARTS as f64;
                let material = body.material(depth, scenario.plane);
                let (share, y) = (layer.thickness / PARTS as f64, -height - depth);
                stiffness += share * material.axial_stiffness;
                stiffness_moment += share * material.axial_stiffness * y;
                push += share * material.coupling;
                push_moment += share * material.coupling * y;
            }
            height += layer.thickness;
        }
        (push_moment - push * stiffness_moment / stiffness) / height.powi(2)
    });
    bending.fold(0.0, |largest: f64, one| if one.abs() > largest.abs() { one } else { largest })
}

/// What a test asks of a scenario.
pub trait Solve {
    /// Solves it.
    ///
    /// # Errors
    /// Those of the solver.
    fn solve(&self) -> Result<Solution, Error>;

    /// Solves it within a test.
    ///
    /// # Errors
    /// Those of the solver.
    fn solve_in_test(&self) -> Result<Solution, TestCaseError> {
        self.solve().map_err(|error| TestCaseError::fail(error.to_string()))
    }
}

/// Tighter than the answers are compared.
const TOLERANCE: f64 = 1e-11;

impl Solve for Scenario {
    fn solve(&self) -> Result<Solution, Error> {
        let scene = self.scene()?;
        let options = Options { tolerance: TOLERANCE };
        Model::new(scene.stack()?)?.press_with(&scene.top, scene.force, &options)
    }
}

/// One to three layers on a half-plane or a rigid base, pressed so that a/H is about 0.01 to 1; none that bends so much
/// by itself that its contact has more than one part, or no end.
pub fn scenario() -> impl Strategy<Value = Scenario> {
    let straight = |scenario: &Scenario| bending_under_equal_loads(scenario).abs() < STRAIGHT;
    scenes(&Ranges::moderate()).prop_filter("bends by itself", straight)
}

/// The same, with layers that may bend so much that a contact has more than one part.
pub fn curved_scenario() -> impl Strategy<Value = Scenario> {
    let lifts_off = |scenario: &Scenario| bending_under_equal_loads(scenario) < LIFTS_OFF;
    scenes(&Ranges::moderate()).prop_filter("does not lift off", lifts_off)
}

/// The same without graded layers.
pub fn homogeneous() -> impl Strategy<Value = Scenario> {
    scenario().prop_map(|mut scenario| {
        scenario.layers.iter_mut().for_each(|layer| layer.steepness = None);
        scenario
    })
}

/// Largest relative difference of half-lengths and of pressures, where those of `found` are multiplied by factors.
pub fn difference(found: &Solution, length: f64, pressure: f64, expected: &Solution) -> f64 {
    let pairs = found.contacts().iter().zip(expected.contacts());
    assert_eq!(found.contacts().len(), expected.contacts().len());
    let one = pairs.map(|(found, expected)| {
        let half_lengths = (found.half_length().unwrap() * length / expected.half_length().unwrap() - 1.0).abs();
        let at = |s: f64| {
            let found = found.pressure(s * found.half_length().unwrap()) * pressure;
            (found - expected.pressure(s * expected.half_length().unwrap())).abs() / expected.central_pressure
        };
        // the tolerance is one on half-lengths and on the peak pressure, whose series is averaged: the plain series depends on the highest modes
        let peaks = (found.central_pressure * pressure / expected.central_pressure - 1.0).abs();
        let anywhere = [0.0, 0.3, 0.6, 0.9].map(|s| 1e-3 * at(s));
        anywhere.into_iter().fold(half_lengths.max(peaks), f64::max)
    });
    one.fold(0.0, f64::max)
}
