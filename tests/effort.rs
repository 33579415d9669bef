//! The effort for fixed scenes, in counts that no noise can change: a lost convergence rate, a cache that is not used or
//! an allocation in a loop shows here before anybody waits for it.
//!
//! # When a test of this file fails
//!
//! It says which count of which scene has grown. If what was changed was not meant to cost more, find out why it does:
//! `recede solve SCENE --stats` prints the counts, `cargo bench --bench stages` the times of the stages. If it is worth its
//! cost, or costs less, write the new count into the table; all are printed.
use std::path::Path;
use std::process::{Command, Stdio};

use allocation_counter::measure;
use recede::{Homogeneous, Item, Model, Plane, Punch, Scene, Stack, Stats};

/// Counts may be larger by this part, and by 2 besides: rounding differs between processors.
const MARGIN: f64 = 0.05;
/// Instructions, and allocations, of which libraries and compilers decide, may be larger by this part.
const LOOSE: f64 = 0.3;

/// What one cold solution took.
#[derive(Debug, PartialEq)]
struct Effort {
    /// Wavenumbers at which the stack was evaluated.
    wavenumbers: usize,
    /// Layers evaluated there.
    layers: usize,
    /// Wavenumbers of all integrals, those of their tails included.
    interpolated: usize,
    /// Systems factorised.
    factorisations: usize,
    /// Newton steps and sweeps, all refinement levels together.
    steps: usize,
    /// Allocations while the kernels are made, and while the contact is solved.
    allocations: [usize; 2],
}

impl Effort {
    fn of(stack: Stack, punch: impl Into<recede::Top>, force: f64) -> Self {
        // tables that are made once for all scenes do not count
        let top = &punch.into();
        let solve = || Model::new(stack.clone()).and_then(|model| model.press(top, force)).expect("a solution");
        let solution = solve();
        let mut model = None;
        let kernels = measure(|| model = Some(Model::new(stack.clone())));
        let model = model.expect("made").expect("a model");
        let contact = measure(|| drop(model.press(top, force)));
        let Stats { wavenumbers, layers, interpolated, factorisations, .. } = *solution.stats();
        let allocations = [kernels, contact].map(|counted| counted.count_total as usize);
        Self { wavenumbers, layers, interpolated, factorisations, steps: solution.newton_steps(), allocations }
    }

    /// Which counts are larger than those allowed.
    fn over(&self, allowed: &Self) -> Vec<String> {
        let pairs = [
            ("wavenumbers evaluated", self.wavenumbers, allowed.wavenumbers, MARGIN),
            ("layers evaluated", self.layers, allowed.layers, MARGIN),
            ("wavenumbers interpolated", self.interpolated, allowed.interpolated, MARGIN),
            ("factorisations", self.factorisations, allowed.factorisations, MARGIN),
            ("Newton steps", self.steps, allowed.steps, MARGIN),
            ("allocations for the kernels", self.allocations[0], allowed.allocations[0], LOOSE),
            ("allocations for the contact", self.allocations[1], allowed.allocations[1], LOOSE),
        ];
        let over = pairs
            .into_iter()
            .filter(|(_, found, allowed, margin)| *found as f64 > *allowed as f64 * (1.0 + margin) + 2.0);
        over.map(|(what, found, allowed, _)| format!("{found} {what}, allowed are about {allowed}")).collect()
    }
}

fn file(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/data/scenes/{name}.ron")).display().to_string()
}

fn of_scene(name: &str) -> Effort {
    let scene = Scene::read(file(name)).expect("a scene of the project");
    Effort::of(scene.stack().expect("a stack"), &scene.top, scene.force.given().unwrap())
}

/// 100 layers, stiff and soft ones in turn, on a half-plane of their own.
fn of_a_hundred_layers() -> Effort {
    let layer = |i: usize| Item::layer(Homogeneous::new(0.01, [1.0, 2.0][i % 2], 0.25).expect("a layer"));
    let stack = (1..100).fold(Stack::builder(Plane::Strain).item(layer(0)), |stack, i| stack.bonded().item(layer(i)));
    let ground = recede::HalfPlane::new(1.0, 0.25).expect("a half-plane");
    let stack = stack.receding().layer(ground).build().expect("a stack");
    Effort::of(stack, Punch::cylinder(500.0).expect("a punch"), 0.002)
}

#[test]
fn no_scene_takes_more_than_it_did() {
    let cases = [
        (
            "table1_R500_load1000",
            of_scene("table1_R500_load1000"),
            Effort {
                wavenumbers: 290,
                layers: 290,
                interpolated: 232,
                factorisations: 1,
                steps: 4,
                allocations: [157, 3470],
            },
        ),
        (
            "full_beta-1_R500",
            of_scene("full_beta-1_R500"),
            Effort {
                wavenumbers: 258,
                layers: 516,
                interpolated: 568,
                factorisations: 2,
                steps: 6,
                allocations: [162, 6629],
            },
        ),
        (
            "two_strips_loose",
            of_scene("two_strips_loose"),
            Effort {
                wavenumbers: 355,
                layers: 676,
                interpolated: 240,
                factorisations: 2,
                steps: 5,
                allocations: [189, 5245],
            },
        ),
        (
            "a hundred layers",
            of_a_hundred_layers(),
            Effort {
                wavenumbers: 450,
                layers: 11876,
                interpolated: 1340,
                factorisations: 2,
                steps: 8,
                allocations: [1515, 13432],
            },
        ),
    ];
    let mut over = Vec::new();
    for (name, found, allowed) in &cases {
        println!("{name}: {found:?}");
        over.extend(found.over(allowed).into_iter().map(|what| format!("{name}: {what}")));
    }
    assert!(over.is_empty(), "more effort than before; the head of this file says what to do\n{}", over.join("\n"));
}

#[test]
fn one_more_of_many_loads_solves_no_equations() {
    for name in ["table1_R500_load1000", "full_beta-1_R500", "two_strips_loose"] {
        let scene = Scene::read(file(name)).expect("a scene of the project");
        let model = Model::new(scene.stack().expect("a stack")).expect("a model").for_many_loads();
        for part in [1.0, 1.1, 0.9] {
            let solution = model.press(&scene.top, part * scene.force.given().unwrap()).expect("a solution");
            let (factorisations, steps) = (solution.stats().factorisations, solution.newton_steps());
            assert!(factorisations == 0 && steps == 0, "{name}: {factorisations} factorisations, {steps} steps");
        }
    }
}

/// Where valgrind is not installed nothing is counted.
#[test]
fn the_command_takes_no_more_instructions() {
    const MILLIONS: f64 = 33.0;
    let scene = file("full_beta-1_R500");
    let run = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null", env!("CARGO_BIN_EXE_recede"), "solve", &scene])
        .stdin(Stdio::null())
        .output();
    let Ok(output) = run else {
        println!("skipped: valgrind is not installed");
        return;
    };
    let said = String::from_utf8_lossy(&output.stderr);
    let collected = said.lines().find_map(|line| line.split("Collected :").nth(1)?.trim().parse::<f64>().ok());
    let millions = 1e-6 * collected.unwrap_or_else(|| panic!("no count of instructions in\n{said}"));
    println!("{millions:.1} million instructions");
    assert!(
        millions < MILLIONS * (1.0 + LOOSE),
        "{millions:.1} million instructions, allowed are about {MILLIONS}; the head of this file says what to do"
    );
}
