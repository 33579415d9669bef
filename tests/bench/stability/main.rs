//! Draws the pictures of docs/stability.md: how many digits are left by formulas that are right on paper.
//!
//! ```text
//! cargo bench --bench stability -- docs/pictures
//! ```
mod cutoff;
mod exact;
mod naive;
mod picture;

use std::error::Error;
use std::path::PathBuf;

use picture::{Curve, Diagram, draw};
use recede::{BlockSystem, Exponential, FreeChain, Homogeneous, Options, Plane, Scene, Stack, Wave};

/// A homogeneous strip bonded to a graded layer of the same thickness; μ = 1 in the strip and at the upper face of the
/// layer.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// Thickness of either.
    pub thickness: f64,
    /// The modulus of the layer falls like exp(−βy) upwards.
    pub beta: f64,
    /// κ of both.
    pub kappa: f64,
}

/// βh of the layer.
const STEEPNESS: [f64; 4] = [0.0, 1e-6, 1.0, 8.0];
/// Wavenumbers per decade.
const PER_DECADE: i32 = 6;

fn main() -> Result<(), Box<dyn Error>> {
    // cargo adds `--bench`
    let folder = std::env::args().skip(1).find(|argument| !argument.starts_with("--")).map(PathBuf::from);
    let folder = folder.ok_or("which folder are the pictures to be written to?")?;
    let diagrams: Vec<Diagram> = STEEPNESS.into_iter().map(flexibility).collect::<Result<_, _>>()?;
    draw(&folder.join("stability_flexibility.svg"), &diagrams, 2)?;
    Ok(draw(&folder.join("stability_cutoff.svg"), &[cut_off()?], 1)?)
}

/// Relative error of λC_tt over λH.
fn flexibility(steepness: f64) -> Result<Diagram, Box<dyn Error>> {
    let case = Case { thickness: 1.0, beta: steepness, kappa: 2.0 };
    let stack = Stack::builder(Plane::Strain)
        .layer(Homogeneous::new(case.thickness, 1.0, 0.25)?)
        .bonded()
        .layer(Exponential::new(case.thickness, 1.0, 0.25, case.beta)?)
        .receding()
        .rigid()
        .build()?;
    let chain = FreeChain::all(&BlockSystem::new(&stack)).remove(0);
    let ours = |lambda: f64| {
        let wave = Wave { wavenumber: lambda, modulus: 1.0, plane: Plane::Strain };
        chain.flexibility(&wave).map_or(f64::NAN, |flexibility| flexibility.top)
    };
    let mut curves: [Vec<(f64, f64)>; 3] = Default::default();
    for step in -8 * PER_DECADE..=8 * PER_DECADE {
        let relative = 10f64.powf(f64::from(step) / f64::from(PER_DECADE));
        let lambda = relative / (2.0 * case.thickness);
        let truth = exact::flexibility(&case, lambda);
        let found = [naive::by_determinants(&case, lambda), naive::by_elimination(&case, lambda), ours(lambda)];
        for (curve, found) in curves.iter_mut().zip(found) {
            curve.push((relative, (found / truth - 1.0).abs()));
        }
    }
    for (name, curve) in ["determinants", "elimination", "recede"].into_iter().zip(&curves) {
        let good = |limit: f64| {
            let inside = curve.iter().filter(|(_, error)| *error < limit).map(|(x, _)| *x);
            let ends = inside.fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), x| (low.min(x), high.max(x)));
            if ends.1 == 0.0 { "nowhere".to_owned() } else { format!("{:.1e} to {:.1e}", ends.0, ends.1) }
        };
        let worst = curve.iter().fold(0.0, |worst: f64, (_, e)| if e.is_nan() { f64::INFINITY } else { worst.max(*e) });
        println!("βh = {steepness}: {name}: error at most {worst:.1e}; below 1e-6 {}", good(1e-6));
    }
    let [determinants, elimination, ours] = curves;
    Ok(Diagram {
        title: format!("βh = {steepness:?}"),
        x: -8..8,
        y: -17..1,
        x_name: "λH",
        y_name: "relative error of λC",
        curves: vec![
            Curve { name: "determinants", points: determinants },
            Curve { name: "elimination, unscaled", points: elimination },
            Curve { name: "recede", points: ours },
        ],
    })
}

/// Relative error of the receding half-length over the lowest wavenumber.
fn cut_off() -> Result<Diagram, Box<dyn Error>> {
    let scene = Scene::from_ron(cutoff::SCENE)?;
    let options = Options { tolerance: 1e-12 };
    let solution = recede::Model::new(scene.stack()?)?.press_with(&scene.top, scene.force, &options)?;
    let [punch, receding] = solution.contacts() else { return Err("two contacts".into()) };
    let mut points = Vec::new();
    for step in -16..=-1 {
        let lowest = 10f64.powf(0.5 * f64::from(step));
        let found =
            cutoff::receding_half_length(lowest, [punch.half_length().unwrap(), receding.half_length().unwrap()]);
        let error = found.map_or(f64::NAN, |found| (found / receding.half_length().unwrap() - 1.0).abs());
        println!("lowest wavenumber {lowest:.1e}: error of b {error:.1e}");
        points.push((lowest, error));
    }
    Ok(Diagram {
        title: "receding half-length b, kernels cut off".to_owned(),
        x: -8..0,
        y: -10..0,
        x_name: "lowest wavenumber times thickness",
        y_name: "relative error of b",
        curves: vec![Curve { name: "b", points }],
    })
}
