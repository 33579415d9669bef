//! Laws of mechanics for layers that weights press together and that come apart beside what presses on them.
//!
//! Goal: without knowing a single number, openings are where mechanics says: they do not depend on units, move and are mirrored with loads and punches, are the same under a weight and under the
//! pressure on top that presses as much, carry the force, and begin at the critical force.
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{RngSeed, TestRunner};
use recede::{Error, Interface, Laminate, Model, Options, Scene, Solution};

/// Random scenes, and how many of them may have no solution.
const SCENES: usize = 8;
const REFUSED: usize = SCENES / 4;
/// Two answers, beyond their own estimates, over the length of an opening or the largest pressure.
const SAME: f64 = 1e-8;
/// Tighter than the answers are compared: gaps next to graded faces have fewer digits than ends.
const TOLERANCE: f64 = 1e-12;

/// A layer: thickness, shear modulus, its kind, by how much it is graded, or stiffer along than across, and its specific weight.
#[derive(Clone, Debug)]
struct Ply {
    thickness: f64,
    modulus: f64,
    kind: Kind,
    by: f64,
    weight: f64,
    is_loose: bool,
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    Homogeneous,
    Exponential,
    Orthotropic,
}

/// Half-widths of uniform loads, or radii of parabolic punches, their places, and their shares of the force.
#[derive(Clone, Debug)]
struct Presses {
    are_punches: bool,
    each: Vec<[f64; 3]>,
}

/// Layers on a half-plane of this modulus, or on a rigid base, and what presses on them.
#[derive(Clone, Debug)]
struct Pile {
    layers: Vec<Ply>,
    base: Option<f64>,
    on_top: f64,
    presses: Presses,
}

/// What x, lengths and stresses become: x to sign · length · x + by.
#[derive(Clone, Copy, Debug)]
struct Image {
    sign: f64,
    by: f64,
    length: f64,
    stress: f64,
}

const ITSELF: Image = Image { sign: 1.0, by: 0.0, length: 1.0, stress: 1.0 };

impl Image {
    fn of(&self, x: f64) -> f64 {
        self.sign * self.length * x + self.by
    }
}

impl Pile {
    /// The scene under a force, as an image has it.
    fn scene(&self, force: f64, image: &Image) -> Scene {
        let Image { length, stress, .. } = *image;
        let layer = |ply: &Ply| {
            let (thickness, modulus) = (ply.thickness * length, ply.modulus * stress);
            let size = format!("thickness: {thickness:?}, specific_weight: {:?}", ply.weight * stress / length);
            let isotropic = format!("{size}, shear_modulus: {modulus:?}, poisson: 0.3");
            let below = if ply.is_loose { "Receding" } else { "Bonded" };
            match ply.kind {
                Kind::Homogeneous => format!("Homogeneous({isotropic}), {below}"),
                Kind::Exponential => format!("Exponential({isotropic}, beta: {:?}), {below}", ply.by / thickness),
                Kind::Orthotropic => {
                    let [along, across] = [2.0 * modulus * (2.5 + ply.by), 2.0 * modulus];
                    let young = format!("young: (x: {along:?}, y: {across:?}, z: {across:?})");
                    format!(
                        "Orthotropic({size}, {young}, shear_modulus: {modulus:?}, poisson: (xy: 0.2, xz: 0.2, yz: 0.2)), {below}"
                    )
                }
            }
        };
        let layers = self.layers.iter().map(layer).collect::<Vec<_>>().join(", ");
        let base = self.base.map_or("Rigid".to_owned(), |modulus| {
            format!("HalfPlane(shear_modulus: {:?}, poisson: 0.3)", modulus * stress)
        });
        let (list, name) = if self.presses.are_punches {
            ("punches", "shape: Parabola(radius")
        } else {
            ("loads", "load: Uniform(half_width")
        };
        let press = |[size, at, share]: &[f64; 3]| {
            let (size, force) = (size * length, share * force * length * stress);
            format!("({name}: {size:?}), at: {:?}, force: {force:?})", image.of(*at))
        };
        let presses = self.presses.each.iter().map(press).collect::<Vec<_>>().join(", ");
        let on_top = self.on_top * stress;
        let text = format!(
            "Scene(geometry: PlaneStrain, pressure_on_top: {on_top:?}, {list}: [{presses}], stack: [{layers}, {base}])"
        );
        Scene::from_ron(&text).unwrap()
    }

    /// Solved under a force.
    fn under(&self, force: f64, image: &Image) -> Result<Answer, Error> {
        let scene = self.scene(force, image);
        let model = Model::new(scene.stack()?)?;
        let solution = model.press_with(&scene.top, scene.force, &Options { tolerance: TOLERANCE })?;
        Ok(Answer { scene, model, solution })
    }

    /// The force under which it begins to come apart, told by the solution under another one; none if it never does.
    fn critical_force(&self) -> Result<Option<f64>, Error> {
        let own = self.under(20.0, &ITSELF)?;
        Ok(own.model.separation(&own.scene.top, &own.solution)?.map(|own| own.critical_force))
    }

    fn has_openings(&self, force: f64) -> bool {
        let solution = self.under(force, &ITSELF).unwrap().solution;
        solution.closed().iter().any(|own| !own.openings.is_empty())
    }
}

struct Answer {
    scene: Scene,
    model: Model,
    solution: Solution,
}

impl Answer {
    /// The pressures on an interface at places along it.
    fn along(&self, interface: Interface, places: &[f64]) -> Vec<f64> {
        let profile = self.model.profile(&self.scene.top, &self.solution, places).unwrap();
        profile.contacts.into_iter().find(|own| own.interface == interface).unwrap().pressure
    }

    /// The depth of a closed interface.
    fn depth(&self, number: usize) -> f64 {
        self.model.stack().laminates()[..=number].iter().map(Laminate::thickness).sum()
    }

    fn openings(&self) -> usize {
        self.solution.closed().iter().map(|own| own.openings.len()).sum()
    }
}

fn piles() -> impl Strategy<Value = (Pile, f64)> {
    let kind = prop_oneof![Just(Kind::Homogeneous), Just(Kind::Exponential), Just(Kind::Orthotropic)];
    let layer = (0.4..1.5f64, 0.3..3.0f64, kind, -1.0..1.0f64, 0.3..2.0f64).prop_map(
        |(thickness, modulus, kind, by, weight)| Ply { thickness, modulus, kind, by, weight, is_loose: false },
    );
    let layers = prop::collection::vec(layer, 1..=3);
    let presses = (any::<bool>(), -1.0..1.0f64, 2.0..4.0f64, 0.3..0.7f64, [0.2..0.6f64, 0.2..0.6f64], 1..=2usize)
        .prop_map(|(are_punches, at, apart, share, sizes, count)| {
            // a punch this blunt touches about as far under the forces at which layers come apart
            let size = |k: usize| if are_punches { 5e-3 * sizes[k] } else { sizes[k] };
            let each = match count {
                1 => vec![[size(0), at, 1.0]],
                _ => vec![[size(0), at, share], [size(1), at + apart, 1.0 - share]],
            };
            Presses { are_punches, each }
        });
    let base = prop::option::of(0.3..3.0f64);
    (layers, base, presses, [0..3usize, 0..3usize], 1.05..2.5f64).prop_map(
        |(mut layers, base, presses, loose, ratio)| {
            let count = layers.len();
            loose.into_iter().for_each(|one| layers[one % count].is_loose = true);
            (Pile { layers, base, on_top: 0.0, presses }, ratio)
        },
    )
}

/// Scenes with openings, under forces above their critical ones, and what they are solved to.
fn opened(seed: u64) -> Vec<(Pile, f64, Answer)> {
    let config = ProptestConfig { rng_seed: RngSeed::Fixed(seed), ..ProptestConfig::default() };
    let mut runner = TestRunner::new(config);
    let all: Vec<(Pile, f64)> = (0..SCENES).map(|_| piles().new_tree(&mut runner).unwrap().current()).collect();
    let (mut solved, mut refused) = (Vec::new(), Vec::new());
    for (pile, ratio) in all {
        let of = |critical: f64| {
            let force = ratio * critical;
            pile.under(force, &ITSELF).map(|answer| (force, answer))
        };
        match pile.critical_force().and_then(|critical| critical.map(of).transpose()) {
            Ok(Some((force, answer))) => solved.push((pile, force, answer)),
            // a laminate that lateral strain bends down on a rigid base
            Ok(None) => refused.push(format!("never comes apart: {pile:?}")),
            Err(Error::NoSolution(reason)) => refused.push(format!("{reason}: {pile:?}")),
            Err(other) => panic!("{other}: {pile:?}"),
        }
    }
    assert!(refused.len() <= REFUSED, "{}", refused.join("\n"));
    solved
}

/// An answer, and another one that has to be its image.
struct Pair<'a> {
    here: &'a Answer,
    image: Image,
    there: &'a Answer,
}

impl Pair<'_> {
    fn near(&self, found: f64, expected: f64, error: f64) {
        let text =
            || format!("{:?} of\n{}\nis not\n{}", self.image, self.here.scene.to_ron(), self.there.scene.to_ron());
        assert!((found - expected).abs() <= error, "{found:e} is not {expected:e} within {error:e}: {}", text());
    }

    /// Ends with their estimated errors.
    fn ends(&self, here: [f64; 4], there: [f64; 4]) {
        let [left, right, left_error, right_error] = here;
        let error = (left_error.max(right_error) + SAME * (right - left)) * self.image.length;
        let mut expected = [left, right].map(|x| self.image.of(x));
        expected.sort_by(f64::total_cmp);
        self.near(there[0], expected[0], error + there[2]);
        self.near(there[1], expected[1], error + there[3]);
    }

    /// As many intervals from left to right, or from right to left.
    fn all<T: Clone>(&self, here: &[T], there: &[T]) -> Vec<(T, T)> {
        assert_eq!(here.len(), there.len(), "{:?} of {}", self.image, self.here.scene.to_ron());
        let mut there = there.to_vec();
        if self.image.sign < 0.0 {
            there.reverse();
        }
        here.iter().cloned().zip(there).collect()
    }

    fn contacts(&self) {
        let Self { here, image, there } = self;
        for (one, other) in here.solution.contacts().iter().zip(there.solution.contacts()) {
            for (own, found) in self.all(one.intervals(), other.intervals()) {
                self.ends(
                    [own.left, own.right, own.left_error, own.right_error],
                    [found.left, found.right, found.left_error, found.right_error],
                );
                for x in [0.2, 0.5, 0.7].map(|part| own.left + part * (own.right - own.left)) {
                    let expected = one.pressure(x) * image.stress;
                    self.near(other.pressure(image.of(x)), expected, SAME * one.peak().pressure * image.stress);
                }
            }
        }
        assert_eq!(here.solution.closed().len(), there.solution.closed().len());
    }

    fn openings(&self) {
        let Self { here, image, there } = self;
        for (one, other) in here.solution.closed().iter().zip(there.solution.closed()) {
            self.near(other.weight, one.weight * image.stress, SAME * other.weight);
            for (own, found) in self.all(&one.openings, &other.openings) {
                self.ends(
                    [own.left, own.right, own.left_error, own.right_error],
                    [found.left, found.right, found.left_error, found.right_error],
                );
                self.near(found.largest_gap, own.largest_gap * image.length, SAME * found.largest_gap);
                for x in [0.1, 0.3, 0.6].map(|part| own.left + part * (own.right - own.left)) {
                    let expected = one.gap(x) * image.length;
                    self.near(other.gap(image.of(x)), expected, SAME * own.largest_gap * image.length);
                }
            }
        }
    }

    /// Pressures beside an opening of the first interface, as fields have them.
    fn pressures(&self) {
        let Self { here, image, there } = self;
        let one = &here.solution.closed()[0];
        let places = one.openings.first().map_or([-1.0, 1.0], |own| [own.right, own.left]);
        let beside = [places[0] + 0.3, places[1] - 0.2];
        let expected = here.along(one.interface, &beside);
        let found = there.along(one.interface, &beside.map(|x| image.of(x)));
        for (found, expected) in found.into_iter().zip(expected) {
            self.near(found, expected * image.stress, SAME * one.weight.max(expected) * image.stress);
        }
    }
}

/// Fails unless the contacts and openings of another answer are the images of an answer.
fn are_images(here: &Answer, image: Image, there: &Answer) {
    let pair = Pair { here, image, there };
    pair.contacts();
    pair.openings();
    pair.pressures();
}

#[test]
fn openings_do_not_depend_on_units() {
    for (k, (pile, force, own)) in (0..).zip(opened(1)) {
        let (length, stress) = (f64::exp(1.7 * f64::from(k % 9 - 4)), f64::exp(2.3 * f64::from(k % 7 - 3)));
        let image = Image { length, stress, ..ITSELF };
        are_images(&own, image, &pile.under(force, &image).unwrap());
    }
}

#[test]
fn openings_move_and_are_mirrored_with_what_presses() {
    for (k, (pile, force, own)) in (0..).zip(opened(2)) {
        let by = 1.3 * f64::from(k) - 4.7;
        let turned = if k % 2 == 0 { (-1.0, 0.0) } else { (-1.0, by) };
        for (sign, by) in [(1.0, by), turned] {
            let image = Image { sign, by, ..ITSELF };
            are_images(&own, image, &pile.under(force, &image).unwrap());
        }
    }
}

/// Whether the uppermost layer has weight, or what it weighs presses on top of it, or half of each.
#[test]
fn a_weight_on_top_opens_layers_as_its_pressure_does() {
    for (k, (mut pile, ..)) in opened(3).into_iter().enumerate() {
        pile.layers.iter_mut().skip(1).for_each(|ply| ply.weight = 0.0);
        let force = 1.5 * pile.critical_force().unwrap().unwrap();
        let own = pile.under(force, &ITSELF).unwrap();
        assert!(own.openings() > 0);
        let Ply { weight, thickness, .. } = pile.layers[0];
        let share = [1.0, 0.5][k % 2];
        pile.on_top = share * weight * thickness;
        pile.layers[0].weight = (1.0 - share) * weight;
        are_images(&own, ITSELF, &pile.under(force, &ITSELF).unwrap());
    }
}

/// Nodes between 0 and 1 and their weights by Fejér's first rule.
fn rule() -> impl Iterator<Item = (f64, f64)> {
    const NODES: i32 = 16;
    let angle = |k: i32| std::f64::consts::PI * (f64::from(k) + 0.5) / f64::from(NODES);
    let part = |j: i32, angle: f64| 2.0 * f64::cos(f64::from(2 * j) * angle) / f64::from(4 * j * j - 1);
    let weight = move |angle: f64| (1.0 - (1..=NODES / 2).map(|j| part(j, angle)).sum::<f64>()) / f64::from(NODES);
    (0..NODES).map(move |k| (0.5 - 0.5 * angle(k).cos(), weight(angle(k))))
}

/// Places to one side of the end of an opening, next to which pressures are like roots, with their lengths: pieces of about the same length as far as something is near, and then a number
/// of longer ones, each three times as long as the one before.
fn outwards(end: f64, side: f64, near: f64, length: f64, more: i32) -> Vec<(f64, f64)> {
    let count = (near / length).ceil();
    let mut edges: Vec<f64> = (0..=count as usize).map(|k| near * k as f64 / count).collect();
    edges.extend((1..=more).map(|k| near + length * (3f64.powi(k) - 1.0)));
    let piece = |(number, edge): (usize, &[f64])| {
        let (from, width) = (edge[0], edge[1] - edge[0]);
        let place = move |(s, weight): (f64, f64)| {
            let (s, weight) = if number == 0 { (s * s, 2.0 * s * weight) } else { (s, weight) };
            (end + side * (from + width * s), width * weight)
        };
        rule().map(place).collect::<Vec<_>>()
    };
    edges.windows(2).enumerate().flat_map(piece).collect()
}

/// Places beside openings.
fn beside(openings: &[[f64; 2]], presses: &Presses, length: f64) -> Vec<(f64, f64)> {
    const MORE: i32 = 7;
    let at = presses.each.iter().map(|one| one[1]);
    let (first, last) = (at.clone().fold(f64::INFINITY, f64::min), at.fold(f64::NEG_INFINITY, f64::max));
    let [[from, _], .., [_, to]] = [openings[0], openings[openings.len() - 1]];
    let mut all = outwards(from, -1.0, (from - first).max(0.0) + length, length, MORE);
    all.extend(outwards(to, 1.0, (last - to).max(0.0) + length, length, MORE));
    for pair in openings.windows(2) {
        let half = 0.5 * (pair[1][0] - pair[0][1]);
        all.extend(outwards(pair[0][1], 1.0, half, length, 0));
        all.extend(outwards(pair[1][0], -1.0, half, length, 0));
    }
    all
}

/// The integral of the pressure less the weight is the force.
#[test]
fn closed_interfaces_carry_the_force() {
    for (pile, force, own) in opened(4).into_iter().step_by(2) {
        for (number, closed) in own.solution.closed().iter().enumerate() {
            let mut openings: Vec<[f64; 2]> = closed.openings.iter().map(|one| [one.left, one.right]).collect();
            let mut carried = -closed.weight * openings.iter().map(|one| one[1] - one[0]).sum::<f64>();
            if openings.is_empty() {
                openings.push([pile.presses.each[0][1]; 2]);
            }
            let all = beside(&openings, &pile.presses, own.depth(number));
            let (x, lengths): (Vec<f64>, Vec<f64>) = all.into_iter().unzip();
            // what is beyond falls like the fourth power of the distance, or faster
            let (mut error, mut beyond, mut farthest) = (SAME * force, 0.0, 0.0);
            for ((pressure, x), length) in own.along(closed.interface, &x).into_iter().zip(x).zip(lengths) {
                let more = pressure - closed.weight;
                carried += more * length;
                error += SAME * more.abs() * length;
                if x.abs() > farthest {
                    (farthest, beyond) = (x.abs(), more.abs() * x.abs());
                }
            }
            let text = || format!("{} of {}", closed.interface, own.scene.to_ron());
            assert!((carried - force).abs() < error + beyond, "{carried} is not {force} at {}", text());
        }
    }
}

#[test]
fn layers_come_apart_at_their_critical_force() {
    for (pile, ..) in opened(5) {
        let critical = pile.critical_force().unwrap().unwrap();
        assert!(!pile.has_openings(0.99 * critical) && pile.has_openings(1.01 * critical), "{critical} {pile:?}");
    }
}

/// By bisection between forces that know nothing of the critical one.
#[test]
fn the_critical_force_is_found_by_its_openings() {
    let all = opened(6);
    for are_punches in [false, true] {
        let (pile, ..) = all.iter().find(|(pile, ..)| pile.presses.are_punches == are_punches).unwrap();
        let (mut below, mut above) = (1e-3, 1e6);
        while above / below > 1.0 + 1e-7 {
            let middle = f64::sqrt(below * above);
            if pile.has_openings(middle) { above = middle } else { below = middle }
        }
        let critical = pile.critical_force().unwrap().unwrap();
        assert!((critical / above - 1.0).abs() < 1e-6, "{critical} {above} {pile:?}");
    }
}
