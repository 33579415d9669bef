//! Times of single stages: flexibilities, kernels, contact.
//!
//! `cargo bench --bench stages`
use std::hint::black_box;
use std::path::Path;

use criterion::{Criterion, criterion_group, criterion_main};
use recede::{FreeChain, Method, Model, Options, Scene, Wave};

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

criterion_group!(benches, stages);
criterion_main!(benches);
