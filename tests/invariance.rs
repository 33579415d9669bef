//! What must not change an answer, for random stacks.
//!
//! Goal: answers depend on the bodies, not on how they are written: not on units, on slices, on layers of no thickness,
//! on which of two equal materials is named; and every answer is admissible.
//!
//! ```text
//!    P (_) R                 P (_) R
//!   ██████████ h            ██████████ h/3      1 to 3 layers, h 0.2 to 5, μ 0.2 to 5, ν 0 to 1/2, βh -3 to 3,
//!   ██████████       =      ----------          bonded or loose, on a half-plane or on a rigid base,
//!   ██████████              ██████████ 2h/3     a/H about 0.01 to 1
//!   ══╤════╤══              ══╤════╤══
//! ```
use std::f64::consts::PI;

use crate::closed_forms::{Elastic, hertz};
use crate::support::innermost_end;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{RngSeed, TestRunner};
use recede::selftest::{Ply, Ranges, Scenario, ScenarioUnits, scene_of_any_kind};
use recede::{Interface, Model, Plane, Punch, Scene, Solution, Stack};

use crate::scenario::{Solve, curved_scenario, cut, difference, homogeneous, scenario};

/// Two answers, each within its tolerance of 1e-10.
const SAME: f64 = 1e-10;

fn config() -> ProptestConfig {
    let rng_seed = RngSeed::Fixed(20_211);
    ProptestConfig { cases: 48, failure_persistence: None, max_shrink_iters: 32, rng_seed, ..ProptestConfig::default() }
}

/// Fails unless two scenarios have the same answer, after lengths and pressures of the first are multiplied by factors.
fn scaled(found: &Scenario, [length, pressure]: [f64; 2], expected: &Scenario) -> Result<(), TestCaseError> {
    let expected = expected.solve_in_test()?;
    let difference = difference(&found.solve()?, length, pressure, &expected);
    prop_assert!(difference < SAME, "differ by {difference:e}");
    Ok(())
}

/// Fails unless two scenarios have the same answer.
fn same(found: &Scenario, expected: &Scenario) -> Result<(), TestCaseError> {
    scaled(found, [1.0, 1.0], expected)
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn units(scenario in scenario(), length in -300.0..300.0f64, modulus in -300.0..300.0f64, binary in any::<bool>()) {
        // powers of two change no digit, others do
        let factor = |exponent: f64| if binary { exponent.round().exp2() } else { (exponent / 10.0).exp() };
        let (length, modulus) = (factor(length / 5.0), factor(modulus / 5.0));
        let other = scenario.clone().in_units(ScenarioUnits { length, stress: modulus });
        scaled(&other, [length.recip(), modulus.recip()], &scenario)?;
    }

    #[test]
    fn a_parabola_is_known_by_force_times_radius(scenario in scenario(), factor in 0.01..100.0f64) {
        let scenario = Scenario { cylinder: false, ..scenario };
        let other = Scenario { radius: scenario.radius * factor, force: scenario.force / factor, ..scenario.clone() };
        scaled(&other, [1.0, factor], &scenario)?;
    }

    #[test]
    fn cutting_a_layer_in_two(scenario in scenario(), which in any::<prop::sample::Index>(), share in 0.01..0.99f64) {
        let mut other = scenario.clone();
        let which = which.index(other.layers.len());
        let parts = cut(&other.layers[which], share);
        other.layers.splice(which..=which, parts);
        same(&other, &scenario)?;
    }

    #[test]
    fn equal_slices(scenario in homogeneous(), slices in 2..20usize) {
        let mut other = scenario.clone();
        let whole = other.layers.remove(0);
        let slice = Ply { thickness: whole.thickness / slices as f64, receding: false, ..whole.clone() };
        let lowest = Ply { receding: whole.receding, ..slice.clone() };
        other.layers.splice(0..0, std::iter::repeat_n(slice, slices - 1).chain([lowest]));
        same(&other, &scenario)?;
    }

    #[test]
    fn layers_of_no_thickness(
        scenario in scenario(),
        nothing in scenario(),
        which in any::<prop::sample::Index>(),
        receding in any::<bool>(),
    ) {
        // an interface divided by a layer that is not there: it is receding if either part is
        let mut other = scenario.clone();
        let which = which.index(other.layers.len());
        let mut nothing = Ply { thickness: 0.0, ..nothing.layers[0].clone() };
        let above = &mut other.layers[which];
        if above.receding {
            (above.receding, nothing.receding) = [(true, receding), (receding, true)][usize::from(nothing.receding)];
        } else {
            nothing.receding = false;
        }
        other.layers.insert(which + 1, nothing.clone());
        // and one on top, below which nothing can open
        other.layers.insert(0, nothing);
        let expected = scenario.solve_in_test()?;
        prop_assert_eq!(difference(&other.solve()?, 1.0, 1.0, &expected), 0.0);
    }

    #[test]
    fn grading_that_vanishes(scenario in homogeneous(), positive in any::<bool>()) {
        let expected = scenario.solve_in_test()?;
        for (steepness, allowed) in [(0.0, SAME), (1e-300, SAME), (1e-12, SAME), (1e-6, 1e-5)] {
            let mut other = scenario.clone();
            let steepness = if positive { steepness } else { -steepness };
            other.layers.iter_mut().for_each(|layer| layer.steepness = Some(steepness));
            let difference = difference(&other.solve()?, 1.0, 1.0, &expected);
            prop_assert!(difference < allowed, "for βh = {steepness:e} differ by {difference:e}");
        }
    }

    #[test]
    fn loose_layers_are_known_by_their_plane_modulus(scenario in homogeneous(), poisson in prop::array::uniform4(0.0..=0.5)) {
        let loose = |mut scenario: Scenario| {
            scenario.plane = Plane::Strain;
            scenario.layers.iter_mut().for_each(|layer| layer.receding = true);
            scenario
        };
        let scenario = loose(scenario);
        let mut other = scenario.clone();
        for (layer, poisson) in other.layers.iter_mut().zip(poisson) {
            layer.modulus *= (1.0 - poisson) / (1.0 - layer.poisson);
            layer.poisson = poisson;
        }
        other.base = other.base.map(|(modulus, old)| (modulus * (1.0 - poisson[3]) / (1.0 - old), poisson[3]));
        same(&other, &scenario)?;
    }

    #[test]
    fn plane_stress_is_plane_strain_with_another_poisson_ratio(scenario in scenario()) {
        let stress = Scenario { plane: Plane::Stress, ..scenario };
        let mut strain = Scenario { plane: Plane::Strain, ..stress.clone() };
        let other = |poisson: f64| poisson / (1.0 + poisson);
        strain.layers.iter_mut().for_each(|layer| layer.poisson = other(layer.poisson));
        strain.base = strain.base.map(|(modulus, poisson)| (modulus, other(poisson)));
        same(&strain, &stress)?;
    }

    #[test]
    fn one_material_bonded_to_itself_is_a_half_plane(scenario in homogeneous()) {
        let mut scenario = scenario;
        let (modulus, poisson) = (scenario.layers[0].modulus, scenario.layers[0].poisson);
        for layer in &mut scenario.layers {
            *layer = Ply { modulus, poisson, receding: false, ..layer.clone() };
        }
        scenario.base = Some((modulus, poisson));
        let material = match scenario.plane {
            Plane::Strain => Elastic::plane_strain(modulus, poisson),
            Plane::Stress => Elastic::plane_stress(modulus, poisson),
        };
        let exact = match scenario.cylinder {
            true => hertz::cylinder(material, scenario.radius, scenario.force).unwrap(),
            false => hertz::parabola(material, scenario.radius, scenario.force),
        };
        let solution = scenario.solve()?;
        let [contact] = solution.contacts() else { panic!("one contact") };
        prop_assert!((contact.half_length().unwrap() / exact.half_length() - 1.0).abs() < SAME);
        prop_assert!((contact.central_pressure / exact.central_pressure() - 1.0).abs() < SAME);
    }

    #[test]
    fn more_force_makes_a_longer_contact(scenario in scenario(), more in 1.001..2.0f64) {
        let pressed = Scenario { force: more * scenario.force, ..scenario.clone() };
        let [less, more] = [scenario.solve_in_test()?, pressed.solve_in_test()?];
        prop_assert!(less.contacts()[0].half_length().unwrap() < more.contacts()[0].half_length().unwrap());
    }

    #[test]
    fn every_answer_is_admissible(scenario in scenario()) {
        let solution = scenario.solve_in_test()?;
        let stack = Stack::from_items(scenario.plane, &scenario.items().unwrap()).unwrap();
        let labels: Vec<Interface> = solution.contacts().iter().map(|contact| contact.interface).collect();
        prop_assert_eq!(labels, stack.contacts());
        let largest = solution.contacts().iter().fold(0.0, |p: f64, contact| p.max(contact.central_pressure));
        for contact in solution.contacts() {
            let a = contact.half_length().unwrap();
            // p(a cos φ) sin φ is smooth and periodic: equidistant places integrate it
            let places = 1200;
            let angle = |k: usize| PI * (k as f64 + 0.5) / f64::from(places);
            let pressures: Vec<f64> = (0..places as usize).map(|k| contact.pressure(a * angle(k).cos())).collect();
            let weighted = pressures.iter().enumerate().map(|(k, p)| p * angle(k).sin());
            let resultant = weighted.sum::<f64>() * a * PI / f64::from(places);
            prop_assert!((resultant / scenario.force - 1.0).abs() < 1e-11, "{resultant} is not {}", scenario.force);
            prop_assert!((contact.resultant / scenario.force - 1.0).abs() < 1e-12);
            prop_assert!(pressures.iter().all(|p| *p > -1e-7 * largest));
            prop_assert_eq!(contact.pressure(1.001 * a), 0.0);
        }
        prop_assert!(solution.min_pressure() > -1e-7 * largest);
        prop_assert!(solution.min_gap() > -1e-7 * scenario.thickness());
    }
}

#[test]
fn random_stacks_of_curved_kinds_are_solved() {
    let mut runner = TestRunner::new(config());
    for _ in 0..300 {
        let scenario = curved_scenario().new_tree(&mut runner).unwrap().current();
        scenario.solve().unwrap_or_else(|error| panic!("{error}: {scenario:#?}"));
    }
}

#[test]
fn contacts_are_numbered_as_written() {
    let layer = |thickness, receding| Ply { thickness, modulus: 1.0, poisson: 0.25, steepness: None, receding };
    let scenario = Scenario {
        plane: Plane::Strain,
        layers: vec![layer(1.0, false), layer(0.0, false), layer(1.0, true), layer(1.0, true)],
        base: Some((1.0, 0.25)),
        cylinder: true,
        radius: 500.0,
        force: 0.002,
    };
    let solution = scenario.solve().unwrap();
    let labels: Vec<String> = solution.contacts().iter().map(|contact| contact.interface.to_string()).collect();
    assert_eq!(labels, ["punch", "3|4", "4|5"]);
}

/// Powers of two next to these powers of ten change no digit of a number.
fn binary(power: i32) -> f64 {
    (f64::from(power) * std::f64::consts::LOG2_10).round().exp2()
}

/// Units of length and of stress.
const UNITS: [[i32; 2]; 4] = [[60, 0], [-60, 9], [10, -60], [-7, 60]];

/// The largest relative difference of two answers, of which `found` is in other units; less than the errors that both claim.
fn in_units(found: &Solution, ScenarioUnits { length, stress }: ScenarioUnits, expected: &Solution) -> f64 {
    assert_eq!(found.contacts().len(), expected.contacts().len());
    let pairs = found.contacts().iter().zip(expected.contacts());
    let one = pairs.map(|(found, expected)| {
        let peak = if expected.central_pressure.is_finite() {
            (found.central_pressure / stress / expected.central_pressure - 1.0).abs()
                - expected.central_pressure_error / expected.central_pressure
        } else {
            f64::from(found.central_pressure != expected.central_pressure)
        };
        let ((end, error), (found, _)) = (innermost_end(expected), innermost_end(found));
        let ends = if end * length == found { 0.0 } else { (found / (end * length) - 1.0).abs() };
        peak.max(ends - error / end)
    });
    one.fold((found.force() / (length * stress) / expected.force() - 1.0).abs(), f64::max)
}

#[test]
fn scenes_of_all_kinds_are_the_same_in_all_units() {
    let solve = |number: u64, units: ScenarioUnits| {
        let scene = scene_of_any_kind(&Ranges { units, ..Ranges::moderate() }, 11, number).unwrap();
        (Model::new(scene.stack().unwrap()).and_then(|model| model.press(&scene.top, scene.force)), scene)
    };
    for number in 0..60 {
        let (expected, _) = solve(number, ScenarioUnits::default());
        let [length, stress] = UNITS[number as usize % UNITS.len()].map(binary);
        let units = ScenarioUnits { length, stress };
        let (found, scene) = solve(number, units);
        match (found, expected) {
            (Ok(found), Ok(expected)) => {
                let difference = in_units(&found, units, &expected);
                assert!(difference < 1e-12, "{number}: differ by {difference:e}: {}", scene.to_ron());
                assert_eq!(found.warnings().len(), expected.warnings().len(), "{number}: {}", scene.to_ron());
            }
            (Err(found), Err(expected)) => {
                assert_eq!(
                    std::mem::discriminant(&found),
                    std::mem::discriminant(&expected),
                    "{number}: {found} {expected}"
                );
            }
            (found, expected) => panic!("{number}: {found:?} {expected:?}: {}", scene.to_ron()),
        }
    }
}

#[test]
fn half_planes_alone_are_the_same_in_all_units() {
    // [length] and [stress] are the units
    let bases = [
        "HalfPlane(shear_modulus: 2[stress], poisson: 0.25)",
        "GradedHalfPlane(shear_modulus: 2[stress], poisson: 0.3, beta: 0.4[1/length])",
        "PowerHalfPlane(shear_modulus: 2[stress], poisson: 0.3, length: 3[length], exponent: 0.5)",
    ];
    let punches = [
        "punch: Parabola(radius: 7[length])",
        "punch: Cylinder(radius: 7[length])",
        "punch: Wedge(slope: 0.01)",
        "punch: Power(exponent: 4, half_width: 1[length], height: 0.05[length])",
        "punch: RoundedFlat(half_width: 0.5[length], radius: 9[length])",
        "punch: Flat(half_width: 0.5[length])",
        "punch: ElasticCylinder(radius: 20[length], shear_modulus: 3[stress], poisson: 0.2)",
        "load: Uniform(half_width: 0.3[length])",
    ];
    for (base, punch) in bases.iter().flat_map(|base| punches.iter().map(move |punch| (base, punch))) {
        let solve = |[length, stress]: [i32; 2]| {
            let text = format!("Scene(geometry: PlaneStrain, {punch}, force: 0.02[force], stack: [{base}])");
            let text = text.replace("[length]", &format!("e{length}")).replace("[1/length]", &format!("e{}", -length));
            let text =
                text.replace("[stress]", &format!("e{stress}")).replace("[force]", &format!("e{}", length + stress));
            recede::solve(&Scene::from_ron(&text).unwrap()).unwrap_or_else(|error| panic!("{text}: {error}"))
        };
        let expected = solve([0, 0]);
        for power in UNITS.into_iter().chain([[3, 0], [-1, 0], [1, 0]]) {
            let [length, stress] = power.map(|power| 10f64.powi(power));
            let units = ScenarioUnits { length, stress };
            let difference = in_units(&solve(power), units, &expected);
            assert!(difference < 1e-12, "{base} {punch} {power:?}: differ by {difference:e}");
        }
    }
}

#[test]
fn a_half_plane_is_solved_however_large_or_small_the_contact() {
    let model = |modulus: f64| {
        let ground = recede::HalfPlane::new(modulus, 0.25).unwrap();
        Model::new(Stack::builder(Plane::Strain).layer(ground).build().unwrap()).unwrap()
    };
    for (radius, force, modulus) in
        [(1e10, 1e10, 1.0), (1e100, 1e60, 1e-30), (1e-200, 1e-190, 1.0), (1e-100, 1e140, 1e150), (1e150, 1e130, 1.0)]
    {
        let solution = model(modulus).press(Punch::parabola(radius).unwrap(), force).unwrap();
        // a² = 4 P R (1 − ν)/(2πμ), without a number beyond those of doubles
        let expected = radius.sqrt() * (force / modulus * 1.5 / PI).sqrt();
        let found = solution.contacts()[0].half_length().unwrap();
        assert!((found / expected - 1.0).abs() < 1e-12, "{radius:e} {force:e}: {found:e} {expected:e}");
    }
}
