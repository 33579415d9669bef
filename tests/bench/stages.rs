//! Times of single stages: flexibilities, kernels, contact.
//!
//! `cargo bench --bench stages`; with `-- NAME`, only those whose name has this in it.
use std::hint::black_box;
use std::path::Path;

#[path = "work_precision/timing.rs"]
mod timing;

use recede::{BaseChain, BlockSystem, FreeChain, HalfPlane, Homogeneous, Model, Plane, Punch, Scene, Stack, Wave};
use timing::{seconds, time};

const SCENES: [(&str, &str); 3] =
    [("strip", "table1_R500_load1000"), ("graded", "full_beta-1_R500"), ("two_strips", "two_strips_loose")];

fn read(name: &str) -> Scene {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/data/scenes/{name}.ron"));
    Scene::read(file).expect("a scene of the project")
}

fn main() {
    // cargo itself adds `--bench`
    let wanted: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let all = Stages { wanted };
    stages(&all);
    weights(&all);
    skips(&all);
}

/// What is to be timed.
struct Stages {
    wanted: Vec<String>,
}

impl Stages {
    /// Prints the median time of a call, with the processor to itself.
    fn time<T>(&self, name: &str, call: impl FnMut() -> T) {
        if self.wanted.is_empty() || self.wanted.iter().any(|wanted| name.contains(wanted)) {
            println!("{name:<60} {:>10}", seconds(time(call).0));
        }
    }
}

fn stages(all: &Stages) {
    for (short, name) in SCENES {
        let scene = read(name);
        let stack = scene.stack().expect("a stack");
        let model = Model::new(stack.clone()).expect("a model");
        let laminate = FreeChain::all(&BlockSystem::new(&stack)).remove(0);
        let name = |stage: &str| format!("{short}: {stage}");
        let wave = Wave { wavenumber: 1.7, modulus: 1.0, plane: stack.plane() };
        all.time(&name("flexibility"), || laminate.flexibility(black_box(&wave)));
        all.time(&name("kernels"), || Model::new(stack.clone()));
        all.time(&name("press"), || model.press(&scene.top, black_box(scene.force)));
        let solution = model.press(&scene.top, scene.force).expect("a solution");
        all.time(&name("collocation"), || model.collocate(&scene.top, black_box(&solution)));
    }
}

/// What an opening costs: slabs under forces that lift them off their bases, with their weights and without.
fn weights(all: &Stages) {
    const SLABS: [(&str, &str, &str); 3] = [
        (
            "load",
            "load: Uniform(half_width: 0.1), force: 1.2",
            "Homogeneous(thickness: 0.2, young: 30000.0, poisson: 0.2WEIGHT)",
        ),
        (
            "roller",
            "punch: Cylinder(radius: 50.0), force: 1.2",
            "Homogeneous(thickness: 0.2, young: 30000.0, poisson: 0.2WEIGHT)",
        ),
        (
            "graded slab",
            "load: Uniform(half_width: 0.1), force: 1.2",
            "Exponential(thickness: 0.2, shear_modulus: 12000.0, poisson: 0.2, beta: 2.0WEIGHT)",
        ),
    ];
    for (name, top, slab) in SLABS {
        for (kind, weight) in [("with its weight", ", specific_weight: 0.024"), ("without", "")] {
            let slab = slab.replace("WEIGHT", weight);
            let scene = Scene::from_ron(&format!(
                "Scene(geometry: PlaneStrain, {top}, stack: [{slab}, Receding, HalfPlane(young: 100.0, poisson: 0.35)])"
            ));
            let scene = scene.expect("a scene");
            let stack = scene.stack().expect("a stack");
            let model = Model::new(stack.clone()).expect("a model");
            let name = |stage: &str| format!("{name} {kind}: {stage}");
            all.time(&name("kernels"), || Model::new(stack.clone()));
            all.time(&name("press"), || model.press(&scene.top, black_box(scene.force)));
        }
    }
}

/// What each skip saves: the same answer with and without it.
fn skips(all: &Stages) {
    let strip = |thickness: f64, modulus: f64| Homogeneous::new(thickness, modulus, 0.25).expect("a layer");
    let ground = || HalfPlane::new(1.0, 0.25).expect("a half-plane");

    // ten slices of the half-plane's own material; the others differ by what no answer shows
    let slices = |difference: f64| {
        let slice = |i: usize| strip(0.1, 1.0 + difference * (i % 2) as f64);
        let stack =
            (1..10).fold(Stack::builder(Plane::Strain).layer(slice(1)), |stack, i| stack.bonded().layer(slice(i)));
        stack.bonded().layer(ground()).build().expect("a stack")
    };
    let half_plane = Stack::builder(Plane::Strain).layer(ground()).build().expect("a stack");
    let kernels = |stack: &Stack| Model::new(stack.clone());
    let [merged, apart] = [0.0, 1e-14].map(slices);
    all.time("half-plane", || kernels(&half_plane));
    all.time("ten slices of one material, merged", || kernels(&merged));
    all.time("ten slices of one material, not merged", || kernels(&apart));

    // a hundred layers in pairs; the others differ by what no answer shows
    let pairs = |difference: f64| {
        let layer = |i: usize| strip(0.01, [1.0, 2.0][i % 2] * (1.0 + difference * i as f64));
        let stack =
            (1..100).fold(Stack::builder(Plane::Strain).layer(layer(0)), |stack, i| stack.bonded().layer(layer(i)));
        stack.bonded().layer(ground()).build().expect("a stack")
    };
    let [alike, unlike] = [0.0, 1e-15].map(pairs);
    all.time("fifty pairs of layers", || kernels(&alike));
    all.time("fifty pairs of layers, no two alike", || kernels(&unlike));

    // a wave that reaches a tenth of a hundred layers, and one that reaches all
    let layers = (1..100).fold(Stack::builder(Plane::Strain).layer(strip(0.1, 1.0)), |stack, i| {
        stack.bonded().layer(strip(0.1, [1.0, 2.0][i % 2] * (1.0 + 1e-15 * i as f64)))
    });
    let layers = layers.bonded().layer(ground()).build().expect("a stack");
    let chain = BaseChain::of(&BlockSystem::new(&layers));
    for (name, wavenumber) in [("a hundred layers, short wave", 40.0), ("a hundred layers, longest wave cut", 3.9)] {
        let wave = Wave { wavenumber, modulus: 1.0, plane: Plane::Strain };
        all.time(name, || chain.flexibility(black_box(&wave)));
    }

    // a thick layer uncouples the contacts on its faces but for long waves, a thin one does not
    for (name, thickness) in [("thick leaf between", 10.0), ("thin leaf between", 0.1)] {
        let stack = Stack::builder(Plane::Strain).layer(strip(1.0, 1.0)).receding().layer(strip(thickness, 1.0));
        let model = Model::new(stack.receding().layer(ground()).build().expect("a stack")).expect("a model");
        let punch = Punch::parabola(500.0).expect("a punch");
        all.time(name, || model.press(&punch, black_box(0.002)));
    }
}
