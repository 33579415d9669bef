//! Times with targets: cold scenes, one more load, many layers, and the bare minimum of work.
use std::fmt::Write as _;
use std::path::Path;

use faer::Mat;
use faer::linalg::solvers::Solve;
use recede::numeric::bessel;
use recede::{BaseChain, BlockSystem, FreeChain, Model, Punch, Scene, Solution, Stack, Wave};

use super::cases::bonded_layers;
use super::timing::{seconds, time};

/// Multiples of it fill an interval evenly, if whole numbers do not count.
const GOLDEN: f64 = 0.618_033_988_749_895;

/// Writes the table.
pub fn table(text: &mut String) {
    let mut line = |line: String| writeln!(text, "{line}").expect("a string takes all");
    line("### Stages\n\n| what | time |\n|---|---|".to_owned());
    for (what, name) in [
        ("strip on a half-plane, cold", "table1_R500_load1000"),
        ("strip and graded layer on a half-plane, cold", "full_beta-1_R500"),
    ] {
        let scene = read(name);
        let (cold, solution) = time(|| recede::solve(&scene).expect("a solution"));
        line(format!("| {what} | {} |", seconds(cold)));
        let model = Model::new(scene.stack().expect("a stack")).expect("a model");
        // never the same load twice in a row, up to a quarter more
        let mut part = 0.0;
        let mut force = || {
            part = (part + GOLDEN) % 1.0;
            solution.force() * (1.0 + 0.25 * part)
        };
        let (more, _) = time(|| model.press(&scene.top, force()).expect("a solution"));
        line(format!("| the same, one more load on the prepared model | {} |", seconds(more)));
        let for_many = model.clone().for_many_loads();
        let (more, _) = time(|| for_many.press(&scene.top, force()).expect("a solution"));
        line(format!("| the same, one more of many loads | {} |", seconds(more)));
        let least = bare_minimum(model.stack(), &solution);
        line(format!("| the same, cold, over the bare minimum ({}); target 3 | {:.1} |", seconds(least), cold / least));
    }
    let layered = |count: usize, difference: f64| {
        let punch = Punch::cylinder(500.0).expect("a punch");
        let stack = || bonded_layers(count, difference);
        time(|| Model::new(stack()).and_then(|model| model.press(&punch, 0.002)).expect("a solution")).0
    };
    let [ten, hundred, thousand] = [10, 100, 1000].map(|count| layered(count, 0.0));
    for (count, time) in [(10, ten), (100, hundred), (1000, thousand)] {
        line(format!("| {count} bonded layers on a half-plane, cold | {} |", seconds(time)));
    }
    line(format!("| 1000 layers over 10; target 50 | {:.1} |", thousand / ten));
    line(format!("| 1000 layers over 100 | {:.1} |", thousand / hundred));
    let unlike = layered(1000, 1e-12);
    line(format!("| 1000 bonded layers, no two of them alike, cold | {} |", seconds(unlike)));
}

fn read(name: &str) -> Scene {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/data/scenes/{name}.ron"));
    Scene::read(file).expect("a scene of the project")
}

/// Time of what cannot be avoided: the flexibilities at as many wavenumbers as the solver took, the Bessel functions of all
/// modes there for the final half-lengths, once, and one factorisation for the final number of modes.
fn bare_minimum(stack: &Stack, solution: &Solution) -> f64 {
    let plane = stack.plane();
    let system = BlockSystem::new(stack);
    let (chains, base) = (FreeChain::all(&system), BaseChain::of(&system));
    let length = stack.total_thickness();
    let wavenumbers: Vec<f64> = (0..solution.wavenumbers())
        .map(|k| 64.0 * (k as f64 + 0.5) / (solution.wavenumbers() as f64 * length))
        .collect();
    let flexibilities = time(|| {
        let at = |wavenumber: f64| {
            let wave = Wave { wavenumber, modulus: 1.0, plane };
            let laminates = chains.iter().map(|chain| chain.flexibility(&wave).map_or(0.0, |c| c.top + c.equal_top));
            laminates.sum::<f64>() + base.flexibility(&wave).unwrap_or(0.0)
        };
        wavenumbers.iter().map(|wavenumber| at(*wavenumber)).sum::<f64>()
    });
    let orders = 2 * solution.modes() + 1;
    let bessel = time(|| {
        let mut values = vec![0.0; orders * wavenumbers.len()];
        for contact in solution.contacts() {
            let arguments: Vec<f64> =
                wavenumbers.iter().map(|wavenumber| wavenumber * contact.half_length().unwrap()).collect();
            bessel::table(orders, &arguments, &mut values);
        }
        values
    });
    let size = solution.contacts().len() * solution.modes();
    let matrix = Mat::from_fn(size, size, |i, j| if i == j { 2.0 } else { 1.0 / ((i + j + 1) * size) as f64 });
    let right = Mat::<f64>::from_fn(size, 1, |i, _| i as f64);
    let factorisation = time(|| matrix.partial_piv_lu().solve(&right));
    flexibilities.0 + bessel.0 + factorisation.0
}
