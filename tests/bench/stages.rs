//! Times of single stages: flexibilities, kernels, contact.
//!
//! `cargo bench --bench stages`
use std::hint::black_box;
use std::path::Path;

use criterion::{Criterion, criterion_group, criterion_main};
use recede::{BaseChain, FreeChain, HalfPlane, Homogeneous, Method, Model, Options, Plane, Punch, Scene, Stack, Wave};

const SCENES: [(&str, &str); 3] =
    [("strip", "table1_R500_load1000"), ("graded", "full_beta-1_R500"), ("two_strips", "two_strips_loose")];

fn read(name: &str) -> Scene {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/data/scenes/{name}.ron"));
    Scene::read(file).expect("a scene of the project")
}

fn stages(criterion: &mut Criterion) {
    for (short, name) in SCENES {
        let scene = read(name);
        let stack = scene.stack().expect("a stack");
        let model = Model::new(stack.clone()).expect("a model");
        let laminate = FreeChain::new(&stack.laminates()[0], stack.plane());
        let mut group = criterion.benchmark_group(short);
        group.sample_size(20);
        let wave = Wave { wavenumber: 1.7, modulus: 1.0, plane: stack.plane() };
        group.bench_function("flexibility", |b| b.iter(|| laminate.flexibility(black_box(&wave))));
        group.bench_function("kernels", |b| b.iter(|| Model::new(stack.clone())));
        group.bench_function("press", |b| b.iter(|| model.press(&scene.punch, black_box(scene.force))));
        let options = Options { tolerance: 1e-6, method: Method::Collocation };
        group.bench_function("collocation to 1e-6", |b| {
            b.iter(|| model.press_with(&scene.punch, black_box(scene.force), &options));
        });
        group.finish();
    }
}

/// What each skip saves: the same answer with and without it.
fn skips(criterion: &mut Criterion) {
    let strip = |thickness: f64, modulus: f64| Homogeneous::new(thickness, modulus, 0.25).expect("a layer");
    let ground = || HalfPlane::new(1.0, 0.25).expect("a half-plane");
    let mut group = criterion.benchmark_group("skips");
    group.sample_size(20);

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
    group.bench_function("half-plane", |b| b.iter(|| kernels(&half_plane)));
    group.bench_function("ten slices of one material, merged", |b| b.iter(|| kernels(&merged)));
    group.bench_function("ten slices of one material, not merged", |b| b.iter(|| kernels(&apart)));

    // a hundred layers in pairs; the others differ by what no answer shows
    let pairs = |difference: f64| {
        let layer = |i: usize| strip(0.01, [1.0, 2.0][i % 2] * (1.0 + difference * i as f64));
        let stack =
            (1..100).fold(Stack::builder(Plane::Strain).layer(layer(0)), |stack, i| stack.bonded().layer(layer(i)));
        stack.bonded().layer(ground()).build().expect("a stack")
    };
    let [alike, unlike] = [0.0, 1e-15].map(pairs);
    group.bench_function("fifty pairs of layers", |b| b.iter(|| kernels(&alike)));
    group.bench_function("fifty pairs of layers, no two alike", |b| b.iter(|| kernels(&unlike)));

    // a wave that reaches a tenth of a hundred layers, and one that reaches all
    let layers = (1..100).fold(Stack::builder(Plane::Strain).layer(strip(0.1, 1.0)), |stack, i| {
        stack.bonded().layer(strip(0.1, [1.0, 2.0][i % 2] * (1.0 + 1e-15 * i as f64)))
    });
    let layers = layers.bonded().layer(ground()).build().expect("a stack");
    let chain = BaseChain::new(layers.base());
    for (name, wavenumber) in [("a hundred layers, short wave", 40.0), ("a hundred layers, longest wave cut", 3.9)] {
        let wave = Wave { wavenumber, modulus: 1.0, plane: Plane::Strain };
        group.bench_function(name, |b| b.iter(|| chain.flexibility(black_box(&wave))));
    }

    // a thick layer uncouples the contacts on its faces but for long waves, a thin one does not
    for (name, thickness) in [("thick leaf between", 10.0), ("thin leaf between", 0.1)] {
        let stack = Stack::builder(Plane::Strain).layer(strip(1.0, 1.0)).receding().layer(strip(thickness, 1.0));
        let model = Model::new(stack.receding().layer(ground()).build().expect("a stack")).expect("a model");
        let punch = Punch::parabola(500.0).expect("a punch");
        group.bench_function(name, |b| b.iter(|| model.press(&punch, black_box(0.002))));
    }
    group.finish();
}

criterion_group!(benches, stages, skips);
criterion_main!(benches);
