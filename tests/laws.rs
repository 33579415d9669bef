//! Laws of mechanics for punches anywhere on random stacks.
//!
//! Goal: without knowing a single number, contacts are where mechanics says: they move with the punches and are mirrored with them, without symmetry they are the contacts of the
//! solver for even contacts, bonded stacks obey Betti's theorem, and strips of the pressure of a punch press what lies below as the punch does.
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use recede::{
    Exponential, HalfPlane, Homogeneous, Load, Loads, Model, Plane, Pressed, Punch, Punches, Solution, Stack, Tilt,
};

/// A layer: thickness, shear modulus, and beta times the thickness, 0 if it is homogeneous.
type Drawn = [f64; 3];

fn layers() -> impl Strategy<Value = Vec<Drawn>> {
    let layer = (0.4..1.5f64, 0.3..3.0f64, prop_oneof![Just(0.0), -1.0..1.0f64]);
    prop::collection::vec(layer.prop_map(|(thickness, modulus, graded)| [thickness, modulus, graded]), 1..=3)
}

/// The layers on each other, bonded but for the interface below layer number `loose`, on a half-plane or a rigid base.
fn model(layers: &[Drawn], loose: Option<usize>, is_rigid: bool) -> Model {
    let mut stack = Stack::builder(Plane::Strain);
    for (number, [thickness, modulus, graded]) in layers.iter().enumerate() {
        let placed = match graded {
            0.0 => stack.layer(Homogeneous::new(*thickness, *modulus, 0.3).unwrap()),
            _ => stack.layer(Exponential::new(*thickness, *modulus, 0.3, graded / thickness).unwrap()),
        };
        stack = if Some(number) == loose { placed.receding() } else { placed.bonded() };
    }
    let stack = if is_rigid { stack.rigid() } else { stack.layer(HalfPlane::new(0.8, 0.3).unwrap()) };
    Model::new(stack.build().unwrap()).unwrap()
}

/// A punch that is not turned: radius, place, force.
type Parabola = [f64; 3];

fn press(model: &Model, all: &[Parabola]) -> Solution {
    let pressed = |[radius, at, force]: &Parabola| {
        Pressed::new(Punch::parabola(*radius).unwrap(), *at, *force, Tilt::None).unwrap()
    };
    let punches = Punches::new(&all.iter().map(pressed).collect::<Vec<_>>()).unwrap();
    model.press(&punches, punches.force()).unwrap()
}

/// The places sign · x + by.
fn images(sign: f64, by: f64, all: &[Parabola]) -> Vec<Parabola> {
    all.iter().map(|[radius, at, force]| [*radius, sign * at + by, *force]).collect()
}

/// Whether the contacts of another solution are at sign · x + by.
fn are_images(here: &Solution, (sign, by): (f64, f64), there: &Solution) -> Result<(), TestCaseError> {
    let count = here.contacts().len();
    prop_assert_eq!(count, there.contacts().len());
    for (number, (contact, other)) in here.contacts().iter().zip(there.contacts()).enumerate() {
        let mut expected: Vec<[f64; 2]> =
            contact.intervals().iter().map(|own| [own.left, own.right].map(|x| sign * x + by)).collect();
        expected.iter_mut().for_each(|ends| ends.sort_by(f64::total_cmp));
        expected.sort_by(|a, b| a[0].total_cmp(&b[0]));
        prop_assert_eq!(expected.len(), other.intervals().len());
        for ([left, right], interval) in expected.into_iter().zip(other.intervals()) {
            let size = right - left;
            for (found, expected) in [(interval.left, left), (interval.right, right)] {
                prop_assert!((found - expected).abs() < 1e-10 * size, "contact {number}: {found} is not {expected}");
            }
            for part in [0.25, 0.5, 0.8] {
                let x = left + part * size;
                let [found, expected] = [other.pressure(x), contact.pressure(sign * (x - by))];
                let error = (found / expected - 1.0).abs();
                prop_assert!(error < 2e-10, "contact {number} at {x}: {found} is not {expected}");
            }
        }
    }
    Ok(())
}

/// ∫ f dx over a part of an interval, x = middle + half cos θ, by Simpson's rule in θ: f is like a square root at the ends of the interval.
fn integral([left, right]: [f64; 2], [from, to]: [f64; 2], f: impl Fn(f64) -> f64) -> f64 {
    const PANELS: usize = 64;
    let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
    let angle = |x: f64| ((x - middle) / half).clamp(-1.0, 1.0).acos();
    let (first, width) = (angle(to), (angle(from) - angle(to)) / PANELS as f64);
    let of = |k: usize| {
        let theta = first + width * k as f64;
        let weight = if k == 0 || k == PANELS { 1.0 } else { 2.0 + 2.0 * (k % 2) as f64 };
        weight * f(middle + half * theta.cos()) * half * theta.sin()
    };
    width / 3.0 * (0..=PANELS).map(of).sum::<f64>()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 6, rng_seed: RngSeed::Fixed(11), ..ProptestConfig::default() })]

    #[test]
    fn contacts_move_and_are_mirrored_with_punches(
        layers in layers(), loose in 0..3usize, is_rigid: bool, apart in 1.0..3.0f64, by in -20.0..20.0f64
    ) {
        let model = model(&layers, Some(loose % layers.len()), is_rigid);
        let all = [[60.0, -0.5 * apart, 2e-3], [90.0, 0.5 * apart, 1e-3]];
        let here = press(&model, &all);
        for image in [(1.0, by), (-1.0, 0.0)] {
            are_images(&here, image, &press(&model, &images(image.0, image.1, &all)))?;
        }
    }

    #[test]
    fn one_punch_makes_even_contacts_wherever_it_is(layers in layers(), loose in 0..3usize, is_rigid: bool, at in -9.0..9.0f64) {
        let model = model(&layers, Some(loose % layers.len()), is_rigid);
        let even = model.press(Punch::parabola(80.0).unwrap(), 2e-3).unwrap();
        are_images(&even, (1.0, at), &press(&model, &[[80.0, at, 2e-3]]))?;
    }

    /// Betti's theorem: of two states of one body the pressures of each do the same work on the displacements of the other.
    #[test]
    fn two_states_of_a_bonded_stack_are_reciprocal(layers in layers(), apart in 1.0..3.0f64) {
        let model = model(&layers, None, true);
        let one = press(&model, &[[50.0, -apart, 2e-3], [90.0, 1.0, 1e-3]]);
        let other = press(&model, &[[70.0, 0.2, 1e-3], [60.0, 1.0 + apart, 3e-3]]);
        let work = |of: &Solution, on: &Solution| -> f64 {
            let (field, contact) = (model.field(on).unwrap(), &of.contacts()[0]);
            let of = |ends| integral(ends, ends, |x| contact.pressure(x) * field.at(x, 0.0).unwrap().v);
            contact.intervals().iter().map(|own| of([own.left, own.right])).sum()
        };
        let [own, others] = [work(&one, &other), work(&other, &one)];
        prop_assert!((own / others - 1.0).abs() < 1e-8, "{own} is not {others}");
    }

    /// Strips of the pressure under two punches make the same contact below: what is missing falls like the square of their width.
    #[test]
    fn strips_of_a_pressure_press_as_the_punches_do(layers in layers(), is_rigid: bool, apart in 1.5..3.0f64) {
        let model = model(&layers, Some(layers.len() - 1), is_rigid);
        let pressed = press(&model, &[[60.0, 0.0, 2e-3], [90.0, apart, 1e-3]]);
        let [above, below] = [&pressed.contacts()[0], &pressed.contacts()[1]];
        let strips = |count: usize| {
            let of = |ends: [f64; 2]| -> Vec<(Load, f64, f64)> {
                let width = (ends[1] - ends[0]) / count as f64;
                let strip = |k: usize| {
                    let from = ends[0] + width * k as f64;
                    let force = integral(ends, [from, from + width], |x| above.pressure(x));
                    (Load::uniform(0.5 * width).unwrap(), from + 0.5 * width, force)
                };
                (0..count).map(strip).collect()
            };
            let all: Vec<(Load, f64, f64)> =
                above.intervals().iter().flat_map(|own| of([own.left, own.right])).collect();
            let loads = Loads::new(&all).unwrap();
            model.press(&loads, loads.force()).unwrap()
        };
        let missing = |count: usize| {
            let solution = strips(count);
            let pairs = solution.contacts()[1].intervals().iter().zip(below.intervals());
            pairs.fold(0.0, |most: f64, (own, expected)| most.max((own.left - expected.left).abs() / expected.right.abs()))
        };
        let [few, many] = [8, 16].map(missing);
        prop_assert!(many < 2e-3 && (3.0..5.3).contains(&(few / many)), "{few} {many}");
    }
}
