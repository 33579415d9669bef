//! Flat punches and spheres on layers that are bonded to a rigid base.
use recede::{Error, Force, Geometry, Homogeneous, Model, Punch, Stack};

use super::{Number, Table};

/// κ at a/h for ν = 0.45 and 0.5, as in circulation.
const HAYES: [(f64, &str, Option<&str>); 15] = [
    (0.2, "1.252", Some("1.281")),
    (0.4, "1.599", Some("1.683")),
    (0.6, "2.031", Some("2.211")),
    (0.8, "2.532", Some("2.855")),
    (1.0, "3.085", Some("3.609")),
    (1.5, "4.638", Some("5.970")),
    (2.0, "6.380", Some("9.069")),
    (2.5, "8.265", None),
    (3.0, "10.26", None),
    (3.5, "12.32", None),
    (4.0, "14.45", None),
    (5.0, "18.80", None),
    (6.0, "23.23", None),
    (7.0, "27.69", None),
    (8.0, "32.15", None),
];

/// A layer of unit thickness and modulus.
fn bonded_layer(poisson: f64) -> Result<Model, Error> {
    let layer = Homogeneous::new(1.0, 1.0, poisson)?;
    Model::new(Stack::builder(Geometry::Axisymmetric).layer(layer).bonded().rigid().build()?)
}

pub fn hayes() -> Result<Table, Error> {
    let mut numbers = Vec::new();
    let kappa = |poisson: f64, a: f64| -> Result<(f64, f64), Error> {
        let (model, punch) = (bonded_layer(poisson)?, Punch::flat(a)?);
        let approach = model.approach(&punch, &model.press(&punch, 1.0)?)?;
        // κ = F (1 − ν²)/(2 a E δ), E = 2(1 + ν)μ
        let value = (1.0 - poisson) / (4.0 * a * approach.value);
        Ok((value, value * approach.error / approach.value))
    };
    for (a, soft, incompressible) in HAYES {
        numbers.push(Number::new(format!("ν = 0.45, a/h = {a}"), "κ", soft, kappa(0.45, a)?));
        if let Some(published) = incompressible {
            numbers.push(Number::new(format!("ν = 0.5, a/h = {a}"), "κ (ν = 0.5)", published, kappa(0.5, a)?));
        }
    }
    Ok(Table {
        title: "A flat punch on cartilage: Hayes, Keer, Herrmann and Mockros 1972",
        about: "\
The factor κ of the stiffness of a layer bonded to a rigid base under a flat-ended cylinder of radius a, F = 2aκ E δ/(1 − ν²), as tables in circulation among those who
indent cartilage and muscle have it. The wider the punch, the more they are
off. Here: `geometry: Axisymmetric` and
`punch: Flat`.",
        within: vec![("κ", 3e-2), ("κ (ν = 0.5)", 1e-2)],
        numbers,
    })
}

pub fn dimitriadis() -> Result<Table, Error> {
    let (radius, model) = (100.0, bonded_layer(0.5)?);
    let punch = Punch::parabola(radius)?;
    let mut numbers = Vec::new();
    for chi in [0.1, 0.3, 0.5, 0.7, 1.0_f64] {
        // χ = √(Rδ)/h; E = 3μ
        let depth = chi * chi / radius;
        let solution = model.press(&punch, Force::ForDepth(depth))?;
        let hertz = 16.0 / 3.0 * radius.sqrt() * depth.powf(1.5);
        let published = 1.0 + chi * (1.133 + chi * (1.283 + chi * (0.769 + chi * 0.0975)));
        let computed = (solution.force() / hertz, solution.force_error() / hertz);
        numbers.push(Number::new(format!("χ = {chi}"), "F/F∞", &format!("{published:.4}"), computed));
    }
    Ok(Table {
        title: "A sphere on a soft layer: Dimitriadis, Horkay, Maresca, Kachar and Chadwick 2002",
        about: "\
The formula by which forces in atomic force microscopy are corrected for the stiff support of a thin sample: the force on an incompressible layer bonded to it, in relation to
Hertz's F∞ = 16/9 E √R δ^(3/2), is 1 + 1.133χ + 1.283χ² + 0.769χ³ + 0.0975χ⁴ with χ = √(Rδ)/h; evaluated here. It is the beginning of a series in the contact radius over
the thickness, and gives forces that are too low where that is not small: moduli found with it are too large by as much. Here: `punch: Parabola` and `depth`.",
        within: vec![("F/F∞", 0.17)],
        numbers,
    })
}
