//! What a scene does not need is not computed, and the answer is the same as if it were.
//!
//! Goal: neighbours of one material are solved for as one layer, layers that a wave does not reach are skipped, and a
//! scene tells how much was. What would be computed without a skip is computed here: by layers that do not tell that they
//! continue, and by bodies that end where the wave does.
//!
//! ```text
//!      P (_) R                  P (_) R
//!   ██████████  μ            ██████████  μ
//!   ----------        =      ██████████        five slices, one layer, or a half-plane
//!   ██████████  μ            ██████████
//!   ══╤════╤══               ══╤════╤══
//! ```
use recede::{
    BlockSystem, ClosedForm, EngineeringConstants, Exponential, FreeChain, Graded, HalfPlane, Homogeneous, Item, Layer,
    Material, Model, Orthotropic, Plane, Profile, Punch, Solution, Stack, StackBuilder, Wave,
};

/// Two ways to compute the same, each to its last digits.
const SAME: f64 = 1e-12;

/// A layer that claims neither to continue nor, by a key, to be the same as another one.
#[derive(Debug)]
struct Apart<L>(L);

impl<L: Layer> Layer for Apart<L> {
    fn thickness(&self) -> Option<f64> {
        self.0.thickness()
    }

    fn material(&self, depth: f64, plane: Plane) -> Material {
        self.0.material(depth, plane)
    }

    fn kinks(&self) -> Vec<f64> {
        self.0.kinks()
    }

    fn closed_form(&self) -> Option<&dyn ClosedForm> {
        self.0.closed_form()
    }
}

fn strip(thickness: f64, modulus: f64) -> Homogeneous {
    Homogeneous::new(thickness, modulus, 0.25).expect("legal")
}

fn ground() -> HalfPlane {
    HalfPlane::new(1.0, 0.25).expect("legal")
}

fn press(stack: StackBuilder) -> Solution {
    let model = Model::new(stack.build().expect("a stack")).expect("a model");
    model.press(Punch::parabola(500.0).expect("a punch"), 0.002).expect("a solution")
}

fn builder() -> StackBuilder {
    Stack::builder(Plane::Strain)
}

/// Layers bonded to each other, then what `below` adds.
fn bonded<L: Layer>(layers: impl IntoIterator<Item = L>, below: fn(StackBuilder) -> StackBuilder) -> StackBuilder {
    let mut layers = layers.into_iter();
    let first = builder().layer(layers.next().expect("a layer"));
    below(layers.fold(first, |stack, layer| stack.bonded().layer(layer)))
}

/// Fails unless both have the same contacts.
fn same(name: &str, found: &Solution, expected: &Solution) {
    assert_eq!(found.contacts().len(), expected.contacts().len(), "{name}");
    for (found, expected) in found.contacts().iter().zip(expected.contacts()) {
        for (found, expected) in [
            (found.half_length().unwrap(), expected.half_length().unwrap()),
            (found.central_pressure, expected.central_pressure),
        ] {
            assert!((found / expected - 1.0).abs() < SAME, "{name}: {found:?} and {expected:?}");
        }
    }
}

#[test]
fn equal_neighbours_are_one_layer() {
    let loose = |stack: StackBuilder| stack.receding().layer(ground());
    let rigid = |stack: StackBuilder| stack.bonded().rigid();
    let slices = [0.1, 0.3, 0.05, 0.35, 0.2];
    let (apart, merged) = (
        press(bonded(slices.map(|h| Apart(strip(h, 2.0))), loose)),
        press(bonded(slices.map(|h| strip(h, 2.0)), loose)),
    );
    assert_eq!((apart.stats().merged, merged.stats().merged), (0, 4));
    same("slices", &merged, &apart);
    same("slices", &merged, &press(bonded([strip(1.0, 2.0)], loose)));
    assert!(4 * merged.stats().layers < apart.stats().layers);

    for (name, beta) in [("softer", -1.5), ("stiffer", 2.0)] {
        let part = |from: f64, to: f64| Exponential::new(to - from, f64::exp(beta * from), 0.25, beta).expect("legal");
        let parts = || [part(0.0, 0.3), part(0.3, 0.4), part(0.4, 1.0)];
        for below in [loose, rigid] {
            let (apart, merged) = (press(bonded(parts().map(Apart), below)), press(bonded(parts(), below)));
            assert_eq!((apart.stats().merged, merged.stats().merged), (0, 2), "{name}");
            same(name, &merged, &apart);
        }
    }

    let wood = EngineeringConstants::new([12.0, 0.8, 0.5], [0.4, 0.45, 0.6], 0.7).expect("legal");
    let ply = |thickness| Orthotropic::new(thickness, wood).expect("legal");
    let (apart, merged) =
        (press(bonded([Apart(ply(0.5)), Apart(ply(0.5))], loose)), press(bonded([ply(0.5), ply(0.5)], loose)));
    assert_eq!(merged.stats().merged, 1);
    same("plies", &merged, &apart);
}

#[test]
fn one_material_on_itself_is_a_half_plane_and_costs_as_much() {
    let on_itself = |stack: StackBuilder| stack.bonded().layer(ground());
    let merged = press(bonded([strip(0.5, 1.0), strip(1.0, 1.0), strip(0.2, 1.0)], on_itself));
    let half_plane = press(builder().layer(ground()));
    let apart = press(bonded([0.5, 1.0, 0.2].map(|h| Apart(strip(h, 1.0))), on_itself));
    assert_eq!(merged.stats().merged, 3);
    assert_eq!(merged.contacts(), half_plane.contacts(), "bit by bit");
    assert_eq!(recede::Stats { merged: 0, ..merged.stats().clone() }, *half_plane.stats());
    same("half-plane", &merged, &apart);
}

#[test]
fn what_is_merged_is_shown_as_written() {
    let stack = || bonded([strip(0.5, 1.0), strip(0.25, 1.0)], |stack| stack.bonded().layer(ground()));
    let model = Model::new(stack().build().expect("a stack")).expect("a model");
    assert_eq!(model.stack().base().layers().len(), 2);
    assert!(model.stack().to_string().contains("2 Homogeneous(thickness: 0.25"));
    let solution = model.press(Punch::parabola(500.0).expect("a punch"), 0.002).expect("a solution");
    let field = model.field(&solution).unwrap();
    let layers: Vec<(usize, [f64; 2])> = field.layers().collect();
    assert_eq!(layers[..2], [(1, [0.0, 0.5]), (2, [0.5, 0.75])]);
    assert_eq!(field.at(0.1, 0.6).expect("inside").layer, 2);
    // contacts are between layers as they are numbered in the scene
    let two = || [strip(0.5, 1.0), strip(0.25, 1.0)];
    let loose = bonded(two(), |stack| stack.receding().layer(strip(1.0, 2.0)).bonded().layer(ground()));
    assert_eq!(press(loose).contacts()[1].interface.to_string(), "2|3");
}

#[test]
fn layers_that_a_wave_does_not_reach_do_not_matter() {
    let thickness = 0.1;
    let layer = |i: usize| Item::layer(strip(thickness, [1.0, 3.0, 0.5][i % 3]));
    let chain = |count: usize| {
        let stack = (1..count).fold(builder().item(layer(0)), |stack, i| stack.bonded().item(layer(i)));
        let stack = stack.receding().rigid().build().expect("a stack");
        FreeChain::all(&BlockSystem::new(&stack)).remove(0)
    };
    let whole = chain(60);
    for z in [2.1, 3.3, 4.9, 8.0, 13.0, 30.0] {
        // the last number of layers of which all are evaluated: the coupling of the faces does not vanish
        let all = (2.0 * 40.0 / z) as usize;
        let wave = Wave { wavenumber: z / thickness, modulus: 1.0, plane: Plane::Strain };
        let [found, expected] = [&whole, &chain(all)].map(|chain| chain.flexibility(&wave).expect("finite"));
        assert!((found.top / expected.top - 1.0).abs() < 1e-14, "λh = {z}: {} and {}", found.top, expected.top);
    }
}

/// Of a sequence that is repeated one is evaluated: the same answer as with layers no two of which are alike.
#[test]
fn repetitions_do_not_change_the_answer() {
    let sheets = |difference: f64| {
        let sheet = |i: usize| strip(0.02, [1.0, 30.0][i % 2] * (1.0 + difference * i as f64));
        let stack = (1..50).fold(builder().layer(sheet(0)), |stack, i| stack.bonded().layer(sheet(i)));
        press(stack.receding().layer(ground()))
    };
    let [alike, unlike] = [0.0, 1e-15].map(sheets);
    assert!(alike.stats().repeated > 0 && unlike.stats().repeated == 0);
    for (found, expected) in alike.contacts().iter().zip(unlike.contacts()) {
        let off = (found.half_length().unwrap() / expected.half_length().unwrap() - 1.0).abs();
        assert!(off < 1e-12, "{}: {off:e}", found.interface);
    }
}

/// The same for layers that the general body integrates: what remembers its integrals passes on which layers are alike.
#[test]
fn repetitions_of_layers_without_closed_forms_are_evaluated_once() {
    #[derive(Clone)]
    enum Kind {
        Ply(Orthotropic),
        Table(Graded),
        Strip(Homogeneous),
    }
    let item = |kind: Kind, known: bool| match (kind, known) {
        (Kind::Ply(layer), true) => Item::layer(layer),
        (Kind::Ply(layer), false) => Item::layer(Apart(layer)),
        (Kind::Table(layer), true) => Item::layer(layer),
        (Kind::Table(layer), false) => Item::layer(Apart(layer)),
        (Kind::Strip(layer), true) => Item::layer(layer),
        (Kind::Strip(layer), false) => Item::layer(Apart(layer)),
    };
    let ply = |young, poisson| {
        let constants = EngineeringConstants::new(young, poisson, 1.0).expect("legal");
        Kind::Ply(Orthotropic::new(0.02, constants).expect("legal"))
    };
    let [along, across] = [([20.0, 2.0, 2.0], [0.3, 0.3, 0.25]), ([2.0, 2.0, 20.0], [0.25, 0.03, 0.03])]
        .map(|(young, poisson)| ply(young, poisson));
    let modulus = Profile::table(&[(0.0, 1.0), (0.005, 4.0), (0.02, 2.0)]).expect("legal");
    let table = Graded::new(0.02, modulus, Profile::linear(0.3, 0.3).expect("legal")).expect("legal");
    let same_function = Graded::with(0.02, |depth| recede::Isotropic { shear_modulus: 1.0 + depth, poisson: 0.3 });
    let same_function = Kind::Table(same_function.expect("legal"));
    for (name, sequence) in [
        ("0/90", vec![along.clone(), across.clone()]),
        ("tables", vec![Kind::Table(table.clone())]),
        ("mixed", vec![along, Kind::Table(table), Kind::Strip(strip(0.01, 3.0)), across]),
        ("functions", vec![same_function]),
    ] {
        let press = |known: bool| {
            let sheet = |i: usize| item(sequence[i % sequence.len()].clone(), known);
            let stack = (1..48).fold(builder().item(sheet(0)), |stack, i| stack.bonded().item(sheet(i)));
            press(stack.receding().layer(ground()))
        };
        let [alike, unlike] = [true, false].map(press);
        let [stats, all] = [&alike, &unlike].map(|solution| solution.stats());
        assert_eq!((all.repeated, stats.layers + stats.repeated), (0, all.layers), "{name}");
        assert!(4 * stats.repeated > stats.layers, "{name}: {stats:?}");
        same(name, &alike, &unlike);
    }
}

#[test]
fn what_was_skipped_is_counted() {
    let count = 40;
    let stack = (1..count)
        .fold(builder().layer(strip(0.025, 1.0)), |stack, i| stack.bonded().layer(strip(0.025, [1.0, 2.0][i % 2])));
    let stats = press(stack.receding().layer(ground())).stats().clone();
    assert_eq!((stats.dropped, stats.merged), (0, 0));
    assert_eq!(stats.layers + stats.repeated + stats.below_decay_depth, count * stats.wavenumbers);
    assert!(
        3 * stats.below_decay_depth > stats.layers + stats.repeated && 2 * stats.repeated > stats.layers,
        "{stats:?}"
    );
    let none = || strip(0.0, 7.0);
    let stats =
        press(builder().layer(none()).bonded().layer(strip(1.0, 1.0)).receding().layer(ground())).stats().clone();
    assert_eq!((stats.dropped, stats.merged), (1, 0));
    assert_eq!((stats.below_decay_depth, stats.uncoupled > 0), (0, true));
}
