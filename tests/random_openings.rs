//! Random slabs that their weights press together, under two loads or two rollers: openings at any of their interfaces.
//!
//! Goal: fields, which know nothing of the equations of openings, say that layers are apart in openings and press on each other everywhere else; what is mirrored has the mirror image
//! of each opening, and twice the forces on twice the weights have the same ones.
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use recede::{ClosedInterface, Field, Model, Opening, Scene, Solution};

const WEIGHT: f64 = 1e-6;
/// Of pressures and gaps, over the largest ones there are.
const ERROR: f64 = 1e-6;

/// A layer by the kind of its material, its thickness, modulus and weight.
type Slab = (usize, f64, f64, f64);

#[derive(Clone, Debug)]
struct Slabs {
    slabs: Vec<Slab>,
    ground: f64,
    rolled: bool,
    forces: [f64; 2],
    apart: f64,
}

fn slabs() -> impl Strategy<Value = Slabs> {
    let power = |from: f64, to: f64| (from..to).prop_map(|power| 10f64.powf(power));
    let slab = (0..3usize, power(-0.3, 0.3), power(-1.0, 1.0), power(-0.3, 0.3));
    let forces = [power(1.5, 3.5), power(1.5, 3.5)];
    (prop::collection::vec(slab, 1..=3), power(-2.0, 1.5), any::<bool>(), forces, power(0.3, 1.3))
        .prop_map(|(slabs, ground, rolled, forces, apart)| Slabs { slabs, ground, rolled, forces, apart })
}

impl Slabs {
    /// With forces and weights times a factor; the mirror image if `side` is −1.
    fn scene(&self, factor: f64, side: f64) -> Scene {
        let slab = |(kind, thickness, modulus, weight): &Slab| {
            let weight = factor * WEIGHT * weight;
            match kind {
                0 => format!(
                    "Exponential(thickness: {thickness:?}, shear_modulus: {modulus:?}, poisson: 0.2, beta: {:?}, specific_weight: {weight:?})",
                    1.0 / thickness
                ),
                1 => format!(
                    "Orthotropic(thickness: {thickness:?}, young: (x: {:?}, y: {modulus:?}, z: {modulus:?}), poisson: (xy: 0.2, xz: 0.2, yz: 0.2), shear_modulus: {:?}, specific_weight: {weight:?})",
                    3.0 * modulus,
                    0.4 * modulus
                ),
                _ => format!(
                    "Homogeneous(thickness: {thickness:?}, shear_modulus: {modulus:?}, poisson: 0.3, specific_weight: {weight:?})"
                ),
            }
        };
        let slabs: Vec<String> = self.slabs.iter().map(slab).collect();
        let [first, second] = self.forces.map(|force| factor * WEIGHT * force);
        let tops = match self.rolled {
            true => [300.0, 500.0].map(|radius| format!("shape: Parabola(radius: {:?})", radius / factor)),
            false => ["load: Line", "load: Uniform(half_width: 0.3)"].map(str::to_owned),
        };
        let both = [
            format!("({}, at: 0, force: {first:?})", tops[0]),
            format!("({}, at: {:?}, force: {second:?})", tops[1], side * self.apart),
        ];
        let both = if side > 0.0 { both.join(", ") } else { format!("{}, {}", both[1], both[0]) };
        let top = if self.rolled { format!("punches: [{both}]") } else { format!("loads: [{both}]") };
        let ground = format!("HalfPlane(shear_modulus: {:?}, poisson: 0.3)", self.ground);
        Scene::from_ron(&format!(
            "Scene(geometry: PlaneStrain, {top}, stack: [{}, Receding, {ground}])",
            slabs.join(", Receding, ")
        ))
        .unwrap()
    }
}

fn pressed(scene: &Scene) -> (Model, Solution) {
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press(&scene.top, scene.force).unwrap_or_else(|error| panic!("{error}\n{}", scene.to_ron()));
    (model, solution)
}

/// The ends of all openings, with the estimates of their errors, by interfaces; of the mirror image if `side` is −1.
fn ends(solution: &Solution, side: f64) -> Vec<Vec<[f64; 2]>> {
    let of = |own: &ClosedInterface| {
        let ends = own.openings.iter().flat_map(|one| [[one.left, one.left_error], [one.right, one.right_error]]);
        let mut ends: Vec<[f64; 2]> = ends.map(|[x, error]| [side * x, error]).collect();
        ends.sort_by(|a, b| a[0].total_cmp(&b[0]));
        ends
    };
    solution.closed().iter().map(of).collect()
}

/// The gaps between two layers at a depth, and the pressures there.
fn between(field: &Field, xs: &[f64], depth: f64, above: usize) -> Vec<[f64; 2]> {
    let [one, other] = [above, above + 1].map(|layer| field.grid_of_layer(layer, xs, &[depth]).unwrap());
    let both = one.points().iter().zip(other.points());
    both.map(|(one, other)| [one.v - other.v, -0.5 * (one.sigma_yy + other.sigma_yy)]).collect()
}

fn same(one: &Solution, other: &Solution, side: f64) -> Result<(), TestCaseError> {
    let (one, other) = (ends(one, side), ends(other, 1.0));
    for (one, other) in one.iter().zip(&other) {
        prop_assert_eq!(one.len(), other.len());
        for ([a, one], [b, other]) in one.iter().zip(other) {
            // the tolerance, or what the estimates admit
            prop_assert!((a - b).abs() <= 1e-10 * b.abs() + 10.0 * (one + other), "{} {} {} {}", a, b, one, other);
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 8, rng_seed: RngSeed::Fixed(3), max_shrink_iters: 0, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn layers_are_apart_in_openings_and_nowhere_else(slabs in slabs()) {
        let scene = slabs.scene(1.0, 1.0);
        let (model, solution) = pressed(&scene);
        let field = model.field(&solution).unwrap();
        let mut depth = 0.0;
        for (number, own) in solution.closed().iter().enumerate() {
            depth += slabs.slabs[number].1;
            let size = slabs.forces.iter().sum::<f64>() * WEIGHT / depth;
            let widest = own.openings.iter().fold(0.0, |most: f64, one| most.max(one.largest_gap));
            let inside = |one: &Opening| [0.1, 0.4, 0.6, 0.9].map(|part| one.left + part * (one.right - one.left));
            let places: Vec<f64> = own.openings.iter().flat_map(inside).collect();
            for (x, [gap, pressure]) in places.iter().zip(between(&field, &places, depth, number + 1)) {
                prop_assert!(gap > 0.0 && gap <= widest * (1.0 + ERROR), "{} {} {}\n{}", x, gap, widest, scene.to_ron());
                prop_assert!(pressure.abs() < ERROR * size, "{} {}\n{}", x, pressure, scene.to_ron());
            }
            let ends = ends(&solution, 1.0).swap_remove(number);
            let far = ends.iter().fold(slabs.apart, |far, [x, _]| far.max(x.abs())) + 4.0;
            let is_closed = |x: &f64| own.openings.iter().all(|one| *x < one.left || *x > one.right);
            let steps = (0..=24).map(|k| far * (f64::from(k) / 12.0 - 1.0));
            let beside = ends.iter().flat_map(|[x, _]| [x - 1e-3, x + 1e-3]);
            let places: Vec<f64> = steps.chain(beside).filter(is_closed).collect();
            for (x, [gap, pressure]) in places.iter().zip(between(&field, &places, depth, number + 1)) {
                prop_assert!(pressure > -ERROR * size, "{} {}\n{}", x, pressure, scene.to_ron());
                prop_assert!(gap.abs() <= ERROR * widest.max(WEIGHT), "{} {}\n{}", x, gap, scene.to_ron());
            }
        }
    }

    #[test]
    fn openings_are_mirrored_and_scaled_with_what_presses(slabs in slabs()) {
        let (_, own) = pressed(&slabs.scene(1.0, 1.0));
        let (_, mirrored) = pressed(&slabs.scene(1.0, -1.0));
        same(&own, &mirrored, -1.0)?;
        let (_, scaled) = pressed(&slabs.scene(2.0, 1.0));
        same(&own, &scaled, 1.0)?;
    }
}
