//! Flat punches and spheres on layers that are bonded to a rigid base, and a wheel on a pavement.
use std::f64::consts::PI;

use recede::{Error, Force, Geometry, HalfPlane, Homogeneous, Load, Model, Point, Punch, Stack};

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
        numbers.push(Number::new(format!("a/h = {a}"), "κ, ν = 0.45", soft, kappa(0.45, a)?));
        if let Some(published) = incompressible {
            numbers.push(Number::new(format!("a/h = {a}"), "κ, ν = 0.5", published, kappa(0.5, a)?));
        }
    }
    Ok(Table {
        title: "A flat punch on cartilage: Hayes, Keer, Herrmann and Mockros 1972",
        about: "\
The factor κ of the stiffness F = 2aκ E δ/(1 − ν²) of a layer bonded to a rigid base under a flat-ended cylinder of radius a, from tables used for
cartilage and muscle. Their errors grow with the width of the punch. Here: `geometry: Axisymmetric`, `punch: Flat`.",
        within: vec![("κ, ν = 0.45", 3e-2), ("κ, ν = 0.5", 1e-2)],
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
The formula that corrects forces in atomic force microscopy for the stiff support of a thin incompressible sample bonded to it: the force in relation to
Hertz's F∞ = 16/9 E √R δ^(3/2) is 1 + 1.133χ + 1.283χ² + 0.769χ³ + 0.0975χ⁴ with χ = √(Rδ)/h. These are the first terms of a series in contact radius over
thickness; where this ratio is not small the force is too low, and a modulus found with it too high. Here: `punch: Parabola` and `depth`.",
        within: vec![("F/F∞", 0.17)],
        numbers,
    })
}

/// Strains under the middle of the wheel by BISAR, KENLAYER and GAMES, in 10⁻⁶: the horizontal one at the bottom of the first layer, the vertical ones on
/// top of the second and of the third.
const PAVEMENT: [(&str, bool, [&str; 3]); 6] = [
    ("BISAR, bonded", false, ["-100.5", "251.7", "185.0"]),
    ("KENLAYER, bonded", false, ["-100.5", "251.6", "185.3"]),
    ("GAMES, bonded", false, ["-100.5", "251.6", "185.1"]),
    ("BISAR, sliding", true, ["-120", "1", "217"]),
    ("KENLAYER, sliding", true, ["-120", "1", "216"]),
    ("GAMES, sliding", true, ["-119", "11", "217"]),
];

pub fn amadeus() -> Result<Table, Error> {
    let shear = |young: f64, poisson: f64| 0.5 * young / (1.0 + poisson);
    let layer = |thickness: f64, young: f64, poisson: f64| Homogeneous::new(thickness, shear(young, poisson), poisson);
    let mut numbers = Vec::new();
    for (of, slides, published) in PAVEMENT {
        let stack = Stack::builder(Geometry::Axisymmetric).layer(layer(260.0, 5000.0, 0.35)?);
        let stack = if slides { stack.sliding() } else { stack.bonded() };
        let stack = stack.layer(layer(500.0, 200.0, 0.4)?).bonded();
        let stack = stack.layer(HalfPlane::new(shear(50.0, 0.45), 0.45)?).build()?;
        let (model, radius) = (Model::new(stack)?, 150.8);
        let solution = model.press(recede::Top::from(Load::uniform(radius)?), 0.7 * PI * radius * radius)?;
        let field = model.field(&solution)?;
        let places = [(260.0, 1, 5000.0), (260.0, 2, 200.0), (760.0, 3, 50.0)];
        for (i, ((depth, layer, young), published)) in places.into_iter().zip(published).enumerate() {
            let point = field.at_layer(0.0, depth, layer)?;
            let error = 3e6 / young * field.stress_error(&Point { x: 0.0, depth, layer: Some(layer) })?;
            // compression is positive there
            let strain = -1e6 * if i == 0 { point.eps_xx } else { point.eps_yy };
            let quantity = ["ε_r, layer 1", "ε_z, layer 2", "ε_z, layer 3"][i];
            let quantity = if i == 1 && slides { "ε_z, layer 2 (sliding)" } else { quantity };
            numbers.push(Number::new(of, quantity, published, (strain, error)));
        }
    }
    Ok(Table {
        title: "A wheel on a pavement: Amadeus 2000",
        about: "\
A European project's comparison of programs for pavements, as quoted by Skar and Andersen 2020: strains in 10⁻⁶, compression positive, under the middle of a wheel of 0.7 MPa on a disc of
radius 150.8 mm; 260 mm of E = 5000 MPa, 500 mm of 200 MPa on 50 MPa, with ν = 0.35, 0.40, 0.45; all bonded, or with the first interface sliding.
Below the sliding interface the contributions of pressure and radial stress to the vertical strain nearly cancel, hence the large relative difference. Here: `load: Uniform(radius: 150.8)`, `Sliding`.",
        within: vec![("ε_r, layer 1", 6e-3), ("ε_z, layer 2", 5e-4), ("ε_z, layer 3", 3e-3), ("ε_z, layer 2 (sliding)", 20.0)],
        numbers,
    })
}
