//! The publications: what they print, and the problems that they solve.
use recede::{
    Contact, Error, Field, HalfPlane, Homogeneous, Load, Model, Plane, Point, Punch, Solution, Stack, StackBuilder,
};

use super::super::paper::{self, Row};
use super::axisymmetric::{amadeus, dimitriadis, hayes};
use super::{Number, Table};

/// The search for the largest shear stress ends where parabolas through the values no longer move it.
const SEARCH: f64 = 1e-4;

/// All tables.
///
/// # Errors
/// Those of solving the problems.
pub fn tables() -> Result<Vec<Table>, Error> {
    let (strip, graded) = (paper::table("table1")?, paper::table("table2")?);
    Ok(vec![
        table1(&strip),
        kahya(&strip),
        table2(&graded),
        filon()?,
        timoshenko()?,
        johnson()?,
        roark()?,
        nafems()?,
        das()?,
        hayes()?,
        dimitriadis()?,
        amadeus()?,
    ])
}

fn entry(row: &Row) -> String {
    let graded = row.entry.graded.map_or(String::new(), |beta| format!("βh = {beta}, "));
    format!("{graded}R/h = {}, μh/P = {}", row.entry.radius, row.entry.load)
}

/// a/h and b/h, as printed with four decimals.
fn half_lengths(row: &Row, a: f64, b: f64) -> [Number; 2] {
    [("a/h", a, 0), ("b/h", b, 1)].map(|(quantity, published, i)| {
        Number::new(entry(row), quantity, &format!("{published:.4}"), (row.computed[i], row.errors[i]))
    })
}

fn table1(rows: &[Row]) -> Table {
    Table {
        title: "A strip on a half-plane: Table 1 of the source paper",
        about: "\
Half-lengths a under a rigid cylinder of radius R and b of the receding contact; strip and half-plane have the same modulus μ, and ν = 1/4, in plane strain
(`examples/scenes/table1_strip_half_plane.ron`). The paper ends its iteration when both resultants are met to 1e-5, which
hardly constrains b. As the load falls, b has to fall towards 1.3242, its value under a line load; the printed b for R/h = 10 does not.",
        within: vec![("a/h", 1e-3), ("b/h", 8.5e-3)],
        numbers: rows.iter().flat_map(|row| half_lengths(row, row.entry.a, row.entry.b)).collect(),
    }
}

fn kahya(rows: &[Row]) -> Table {
    let numbers = rows.iter().filter_map(|row| row.entry.kahya.map(|(a, b)| half_lengths(row, a, b)));
    Table {
        title: "The same by Kahya et al.",
        about: "\
The column \"Kahya\" of the same table, from an earlier paper. Small residuals of the resultants do not show that b is right.",
        within: vec![("a/h", 1e-3), ("b/h", 8.5e-3)],
        numbers: numbers.flatten().collect(),
    }
}

fn table2(rows: &[Row]) -> Table {
    let numbers = rows.iter().flat_map(|row| {
        let [a, b] = half_lengths(row, row.entry.a, row.entry.b);
        [a, Number { misprinted: row.entry.misprinted_b, ..b }]
    });
    Table {
        title: "A graded layer on a half-plane: Table 2 of the source paper",
        about: "\
The shear modulus of the layer is μ₃ exp(βd) at the depth d below its top face; at the top face it equals the modulus of the half-plane
(`examples/scenes/table2_graded_half_plane.ron`). These cylinders are parabolas to seven digits, and
under a parabola only the product of force and radius matters: the entries R/h = 250, μh/P = 500 and R/h = 500, μh/P = 1000 have to agree, but with βh = 0.001 they are
printed as b/h = 1.4198 and 1.3978. With βh = 1, 1.3554 is a misprint.",
        within: vec![("a/h", 6e-3), ("b/h", 1.1e-2)],
        numbers: numbers.collect(),
    }
}

fn stack() -> StackBuilder {
    Stack::builder(Plane::Strain)
}

fn press(stack: StackBuilder, top: impl Into<recede::Top>, force: f64) -> Result<(Solution, Field), Error> {
    let model = Model::new(stack.build()?)?;
    let solution = model.press(top, force)?;
    let field = model.field(&solution)?;
    Ok((solution, field))
}

fn filon() -> Result<Table, Error> {
    // a layer that slides on a rigid base without opening is the upper half of one twice as thick
    let layer = stack().layer(Homogeneous::new(1.0, 1.0, 0.25)?).sliding().rigid();
    let (_, field) = press(layer, recede::Top::from(Load::Line), 1.0)?;
    let stress = |x: f64| field.at(x, 1.0).map(|point| point.sigma_yy);
    let (mut compressed, mut stretched) = (1.0, 2.0);
    while stretched - compressed > 1e-12 {
        let middle = 0.5 * (compressed + stretched);
        if stress(middle)? < 0.0 { compressed = middle } else { stretched = middle }
    }
    let slope = (stress(compressed + 1e-3)? - stress(compressed - 1e-3)?) / 2e-3;
    let error = field.stress_error(&Point { x: compressed, depth: 1.0, layer: None })? / slope;
    Ok(Table {
        title: "Where a layer has to lift off: Filon 1903",
        about: "\
The distance from opposite line loads on both faces of an infinite layer of thickness 2h beyond which the stress across the middle plane is a tension, as quoted by Barber 2018, chapter 11. The
integral for this stress, ∫ (sinh u + u cosh u)/(sinh 2u + 2u) cos(ux/h) du over u > 0, vanishes at x = 1.337922 h. Here: a layer on
`Sliding`, `Rigid` under `load: Line`. If the layer may lift off, the contact ends at 0.857 h.",
        within: vec![("x/h", 1e-2)],
        numbers: vec![Number::new("tension begins", "x/h", "1.35", (compressed, error))],
    })
}

/// A parabola on a half-plane.
struct Hertz {
    force: f64,
    radius: f64,
    /// Young's modulus, and Poisson's ratio.
    material: (f64, f64),
}

impl Hertz {
    fn solve(&self) -> Result<(Contact, Field), Error> {
        let (young, poisson) = self.material;
        let ground = HalfPlane::new(0.5 * young / (1.0 + poisson), poisson)?;
        let (solution, field) = press(stack().layer(ground), &Punch::parabola(self.radius)?, self.force)?;
        Ok((solution.contacts()[0].clone(), field))
    }
}

/// Half-length and pressure at x = 0, each divided by its scale.
fn lengths_and_pressures(contact: &Contact, length: f64, pressure: f64) -> [(f64, f64); 2] {
    let half_length = contact.half_length().unwrap_or(f64::NAN);
    let error = contact.half_length_error().unwrap_or(f64::NAN);
    [
        (half_length / length, error / length),
        (contact.central_pressure / pressure, contact.central_pressure_error / pressure),
    ]
}

/// The largest shear stress and its depth under a parabola, in the pressure at x = 0 and the half-length.
fn largest_shear() -> Result<[(f64, f64); 2], Error> {
    let (contact, field) = Hertz { force: 0.002, radius: 500.0, material: (1.0, 0.3) }.solve()?;
    let found = field.max_shear()?;
    let (stress, depth) = (found.value / contact.central_pressure, found.depth / contact.reach());
    Ok([(stress, SEARCH * stress * SEARCH), (depth, SEARCH * depth)])
}

fn timoshenko() -> Result<Table, Error> {
    // two cylinders of radius 2 R are a parabola of radius R on a half-plane of half the plane modulus E/(1 − ν²)
    let (young, poisson) = (0.5, 0.3);
    let (contact, _) = Hertz { force: 1e-3, radius: 1.0, material: (young, poisson) }.solve()?;
    // P' R₁ R₂/(E (R₁ + R₂)) with E = 1 and R₁ R₂/(R₁ + R₂) = 1
    let [length, pressure] = lengths_and_pressures(&contact, 1e-3f64.sqrt(), 1e-3f64.sqrt());
    let [shear, depth] = largest_shear()?;
    Ok(Table {
        title: "Two cylinders: Timoshenko and Goodier 1951",
        about: "\
Two cylinders of radii R₁ and R₂ of one material with ν = 0.3, pressed together by P' per unit length; half-length b, largest pressure q₀, largest shear stress τ.
The closed form of McEwen 1949 also gives 0.30028 q₀ at the depth 0.78615 b: 0.304 is wrong in its third digit.",
        within: vec![("value (b)", 2e-3), ("value (q₀)", 1e-3), ("value (τ)", 1.5e-2), ("value (depth)", 1e-2)],
        numbers: vec![
            Number::new("b/√(P'R₁R₂/(E(R₁+R₂)))", "value (b)", "1.52", length),
            Number::new("q₀/√(P'E(R₁+R₂)/(R₁R₂))", "value (q₀)", "0.418", pressure),
            Number::new("τ/q₀", "value (τ)", "0.304", shear),
            Number::new("its depth/b", "value (depth)", "0.78", depth),
        ],
    })
}

fn johnson() -> Result<Table, Error> {
    let [shear, depth] = largest_shear()?;
    Ok(Table {
        title: "Below a cylinder: Johnson 1985",
        about: "\
Section 4.2(c): largest shear stress under a line contact, p₀ the pressure at x = 0, a the half-length. The depth is cut off, not rounded.",
        within: vec![("τ/p₀", 2e-3), ("depth/a", 1e-2)],
        numbers: vec![
            Number::new("largest shear stress", "τ/p₀", "0.30", shear),
            Number::new("largest shear stress", "depth/a", "0.78", depth),
        ],
    })
}

fn roark() -> Result<Table, Error> {
    let radius = 0.5; // of a cylinder of diameter D = 1
    let modulus = |plane_modulus: f64, poisson: f64| (plane_modulus * (1.0 - poisson * poisson), poisson);
    let p = 1e-3f64;
    // C_E = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂ = 1; and both bodies with E = 1, ν = 0.3
    let (any, _) = Hertz { force: p, radius, material: modulus(1.0, 0.3) }.solve()?;
    let (same, _) = Hertz { force: p, radius, material: (0.5, 0.3) }.solve()?;
    let mut numbers = Vec::new();
    for (of, contact, published) in
        [("any materials", any, ["1.60", "0.798"]), ("E₁ = E₂, ν = 0.3", same, ["2.15", "0.591"])]
    {
        let [length, pressure] = lengths_and_pressures(&contact, 0.5 * p.sqrt(), p.sqrt());
        numbers.push(Number::new(of, "b", published[0], length));
        numbers.push(Number::new(of, "σ", published[1], pressure));
    }
    Ok(Table {
        title: "A cylinder on a flat plate: Young and Budynas 2002 (Roark)",
        about: "\
Table 14.1: a cylinder of diameter D pressed by p per unit length; *width* b of the contact in units of √(p D C), largest pressure σ in units of √(p/(D C)) with
C = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂, or 1/E for C in the second case.",
        within: vec![("b", 3e-3), ("σ", 1e-3)],
        numbers,
    })
}

fn nafems() -> Result<Table, Error> {
    let (force, radius) = (35e3, 50.0);
    let steel = (210e3, 0.3);
    let aluminium = (70e3, 0.3);
    let shear = |(young, poisson): (f64, f64)| 0.5 * young / (1.0 + poisson);
    let plane = |(young, poisson): (f64, f64)| young / (1.0 - poisson * poisson);
    let both = plane(steel) * plane(aluminium) / (plane(steel) + plane(aluminium)) * (1.0 - 0.09);
    let (parabola, _) = Hertz { force, radius, material: (both, 0.3) }.solve()?;
    let roller = Punch::elastic_cylinder(radius, shear(steel), steel.1)?;
    let (circle, _) = press(stack().layer(HalfPlane::new(shear(aluminium), aluminium.1)?), &roller, force)?;
    let mut numbers = Vec::new();
    for (of, contact) in [("Hertz's parabola", &parabola), ("the circle itself", &circle.contacts()[0])] {
        let [length, pressure] = lengths_and_pressures(contact, 1.0, 1.0);
        numbers.push(Number::new(of, "a, mm", "6.21", length));
        numbers.push(Number::new(of, "p₀, N/mm²", "3585.37", pressure));
    }
    Ok(Table {
        title: "A steel roller on aluminium: NAFEMS, Konter 2006",
        about: "\
The first contact benchmark: a steel cylinder, R = 50 mm, E = 210 GPa, on an aluminium block, E = 70 GPa, both with ν = 0.3, pressed by 35 kN per mm of length. The published values are
Hertz's, for a parabola, although a/R is 0.12; under a circle that deforms like a half-plane (`ElasticCylinder`) the contact is shorter and the pressure higher.",
        within: vec![("a, mm", 4e-3), ("p₀, N/mm²", 4e-3)],
        numbers,
    })
}

/// What a table of influence values prints, and where.
type Printed = (f64, f64, &'static str);
/// Δσ z/q below a line load, at x/z.
const LINE: [(f64, &str); 8] = [
    (0.0, "0.637"),
    (0.1, "0.624"),
    (0.2, "0.589"),
    (0.3, "0.536"),
    (0.5, "0.407"),
    (0.8, "0.237"),
    (1.0, "0.159"),
    (2.0, "0.025"),
];
/// Δσ/q below a strip of the width B, at 2x/B and 2z/B.
const STRIP: [Printed; 8] = [
    (0.0, 0.5, "0.959"),
    (0.0, 1.0, "0.818"),
    (0.0, 1.5, "0.668"),
    (0.0, 2.0, "0.550"),
    (0.0, 3.0, "0.396"),
    (0.0, 4.0, "0.306"),
    (0.0, 5.0, "0.248"),
    (1.2, 0.8, "0.338"),
];

fn das() -> Result<Table, Error> {
    let ground = || -> Result<StackBuilder, Error> { Ok(stack().layer(HalfPlane::new(1.0, 0.3)?)) };
    let (_, line) = press(ground()?, recede::Top::from(Load::Line), 1.0)?;
    let (_, strip) = press(ground()?, recede::Top::from(Load::uniform(1.0)?), 2.0)?;
    let stress = |field: &Field, x: f64, depth: f64| -> Result<(f64, f64), Error> {
        let error = field.stress_error(&Point { x, depth, layer: None })?;
        Ok((-field.at(x, depth)?.sigma_yy, error))
    };
    let mut numbers = Vec::new();
    for (x, published) in LINE {
        numbers.push(Number::new(format!("line load, x/z = {x}"), "Δσ (line load)", published, stress(&line, x, 1.0)?));
    }
    for (x, depth, published) in STRIP {
        let of = format!("strip, 2x/B = {x}, 2z/B = {depth}");
        numbers.push(Number::new(of, "Δσ (strip)", published, stress(&strip, x, depth)?));
    }
    Ok(Table {
        title: "Vertical stress in soil: Das and Sobhan 2018",
        about: "\
The increase Δσ of the vertical stress at depth z, in units of q/z below a line load q per unit length, in units of q below a strip of width B with the
pressure q. Here: `load: Line` and `load: Uniform` on `HalfPlane`.",
        within: vec![("Δσ (line load)", 2e-2), ("Δσ (strip)", 2e-3)],
        numbers,
    })
}
