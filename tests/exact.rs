//! Closed forms and published constants.
//!
//! Goal: half-planes of one material, whatever they are made of, are Hertz's; strips under a punch that is hardly
//! longer than a line have the receding contacts of the literature.
//!
//! ```text
//!          P   (_)  R                        P  ↓  a → 0                 source: Johnson 1985; Gladwell 1976;
//!   ░░░░░░░░░░░░░░░░░░░░              ██████████████████████ h          constants to twelve digits from a
//!   ░░░░░░░░░░░░░░░░░░░░              ‾‾‾‾‾‾‾╤═════╤‾‾‾‾‾‾‾‾            multiple-precision evaluation
//!   a² = P R (κ+1)/(2πμ)              ░░░░░░░  2b   ░░░░░░░░
//! ```
use std::f64::consts::{FRAC_PI_2, PI};

use crate::closed_forms::{Elastic, hertz, line_load};
use recede::{
    BlockSystem, Contact, Exponential, FreeChain, HalfPlane, Homogeneous, Load, Model, Plane, Punch, Solution, Stack,
    StackBuilder, Wave,
};

fn press(stack: StackBuilder, punch: Punch, force: f64) -> Solution {
    Model::new(stack.build().unwrap()).unwrap().press(&punch, force).unwrap()
}

/// One contact like that of a half-plane.
fn compare(found: &Solution, exact: hertz::Contact, half_length: f64, pressure: f64) {
    let [contact] = found.contacts() else { panic!("one contact") };
    let off = contact.half_length().unwrap() / exact.half_length() - 1.0;
    assert!(off.abs() < half_length, "half-length off by {off:e}");
    let largest = exact.central_pressure();
    for s in [0.0, 0.2, 0.5, 0.8, 0.95, 0.999] {
        let x = s * exact.half_length().min(contact.half_length().unwrap());
        let off = (contact.pressure(x) - exact.pressure(x)) / largest;
        assert!(off.abs() < pressure, "pressure at {s} a off by {off:e}");
    }
    assert!((contact.pressure(0.0) / contact.central_pressure - 1.0).abs() < 1e-13);
    assert!((contact.resultant / exact.force() - 1.0).abs() < 1e-12);
}

#[test]
fn a_parabola_on_a_half_plane() {
    for plane in [Plane::Strain, Plane::Stress] {
        for (modulus, poisson, radius, force) in
            [(1.0, 0.25, 500.0, 0.002), (80e9, 0.5, 0.01, 1e6), (1e-3, 0.0, 1e4, 1.0)]
        {
            let material = match plane {
                Plane::Strain => Elastic::plane_strain(modulus, poisson),
                Plane::Stress => Elastic::plane_stress(modulus, poisson),
            };
            let stack = Stack::builder(plane).layer(HalfPlane::new(modulus, poisson).unwrap());
            let found = press(stack, Punch::parabola(radius).unwrap(), force);
            compare(&found, hertz::parabola(material, radius, force), 1e-13, 1e-12);
        }
    }
}

#[test]
fn a_cylinder_on_a_half_plane() {
    let material = Elastic::plane_strain(2.0, 0.3);
    for half_length in [1e-4, 0.01, 0.1, 0.5, 0.8, 0.95] {
        let force = hertz::cylinder_force(material, 1.0, half_length).unwrap();
        let stack = Stack::builder(Plane::Strain).layer(HalfPlane::new(2.0, 0.3).unwrap());
        let found = press(stack, Punch::cylinder(1.0).unwrap(), force);
        compare(&found, hertz::cylinder(material, 1.0, force).unwrap(), 1e-9, 1e-7);
    }
}

#[test]
fn layers_of_one_material_on_a_half_plane_of_it() {
    let material = Elastic::plane_strain(3.0, 0.3);
    let ground = || HalfPlane::new(3.0, 0.3).unwrap();
    let strip = |h| Homogeneous::new(h, 3.0, 0.3).unwrap();
    let flat = |h, beta| Exponential::new(h, 3.0, 0.3, beta).unwrap();
    let builder = || Stack::builder(Plane::Strain);
    let stacks = [
        ("a coating", builder().layer(strip(1.0)).bonded()),
        ("a graded coating that is not graded", builder().layer(flat(1.0, 0.0)).bonded()),
        ("a graded coating that hardly is", builder().layer(flat(1.0, 1e-300)).bonded()),
        ("a thin coating", builder().layer(strip(1e-4)).bonded()),
        (
            "three layers",
            builder().layer(strip(0.2)).bonded().layer(flat(0.5, 0.0)).bonded().layer(strip(0.01)).bonded(),
        ),
    ];
    for (name, stack) in stacks {
        for half_length in [0.02, 0.3, 2.0] {
            println!("{name}, a = {half_length}");
            let punch = Punch::cylinder(100.0).unwrap();
            let force = hertz::cylinder_force(material, 100.0, half_length).unwrap();
            let found = press(stack.clone().layer(ground()), punch, force);
            compare(&found, hertz::cylinder(material, 100.0, force).unwrap(), 1e-10, 1e-9);
        }
    }
}

#[test]
fn tension_begins_where_the_integral_of_filon_vanishes() {
    // Filon 1903: the stress across the middle of a layer of thickness 2h between two line loads, h = 1
    let stress = |x: f64| {
        let (count, step) = (40_000, 1e-3);
        let part = |u: f64| (u.sinh() + u * u.cosh()) / ((2.0 * u).sinh() + 2.0 * u) * (u * x).cos();
        -(0..count).map(|k| part((f64::from(k) + 0.5) * step)).sum::<f64>() * step * 2.0 / PI
    };
    let stack = Stack::builder(Plane::Strain).layer(strip((3.0, 0.3))).sliding().rigid().build().unwrap();
    let model = Model::new(stack).unwrap();
    let solution = model.press(recede::Top::from(Load::Line), 1.0).unwrap();
    let field = model.field(&solution).unwrap();
    for x in [0.0, 0.5, 1.337_922, 2.0] {
        let (found, expected) = (field.at(x, 1.0).unwrap().sigma_yy, stress(x));
        assert!((found - expected).abs() < 1e-6, "{x}: {found} {expected}");
    }
    assert!(stress(1.337_92) < 0.0 && stress(1.337_93) > 0.0);
}

/// Shear modulus and Poisson's ratio.
type Material = (f64, f64);

fn strip((shear_modulus, poisson): Material) -> Homogeneous {
    Homogeneous::new(1.0, shear_modulus, poisson).unwrap()
}

/// The receding contact of a strip of thickness h = 1 on a base (`None` is rigid) under a parabola so sharp that
/// a ≈ 1e-5 h.
fn line_loaded(material: Material, base: Option<Material>) -> Contact {
    let stack = Stack::builder(Plane::Strain).layer(strip(material)).receding();
    let stack = match base {
        Some((shear_modulus, poisson)) => stack.layer(HalfPlane::new(shear_modulus, poisson).unwrap()),
        None => stack.rigid(),
    };
    let flexibility = Elastic::plane_strain(material.0, material.1).flexibility();
    let (radius, half_length) = (1e-3, 1e-5f64);
    let force = FRAC_PI_2 * half_length.powi(2) / (flexibility * radius);
    let solution = press(stack, Punch::parabola(radius).unwrap(), force);
    let [punch, receding] = solution.contacts() else { panic!("two contacts") };
    // so small a contact is Hertz's, but for the bending of the strip
    assert!((punch.half_length().unwrap() / half_length - 1.0).abs() < 1e-6, "{punch:?}");
    receding.clone()
}

#[test]
fn a_line_load_on_a_strip() {
    // only k = [μ₁/(1 − ν₁)]/[μ₂/(1 − ν₂)] counts
    let cases = [
        ((1.0, 0.25), None, line_load::RIGID_BASE),
        ((7.0, 0.5), None, line_load::RIGID_BASE),
        ((1.0, 0.25), Some((1.0, 0.25)), line_load::EQUAL_MODULI),
        ((1.0, 0.5), Some((2.0, 0.0)), line_load::EQUAL_MODULI),
        ((4.0, 0.25), Some((1.0, 0.25)), line_load::STRIP_FOUR_TIMES_STIFFER),
        ((1.0, 0.5), Some((0.375, 0.25)), line_load::STRIP_FOUR_TIMES_STIFFER),
    ];
    for (strip, base, exact) in cases {
        let b = line_loaded(strip, base).half_length().unwrap();
        let off = b / exact - 1.0;
        println!("b/h = {b:.12}, known {exact:.12}, off by {off:.1e}");
        assert!(off.abs() < 1e-9, "{b} is not {exact}: off by {off:e}");
    }
}

/// b/h of a strip k times as stiff as its base.
fn recession(k: f64) -> f64 {
    line_loaded((k, 0.25), Some((1.0, 0.25))).half_length().unwrap()
}

#[test]
fn a_line_load_on_strips_soft_and_stiff() {
    for exponent in -6..=14 {
        let k = 10f64.powf(0.5 * f64::from(exponent));
        let (b, formula) = (recession(k), line_load::approximate_half_length(1.0, k));
        assert!((b / formula - 1.0).abs() < 4e-4, "k = {k}: {b} is not near {formula}");
    }
}

#[test]
fn a_stiff_strip_is_a_beam() {
    // b/(h k^(1/3)) tends to its limit like k^(-2/3)
    let off = |k: f64| recession(k) / (k.cbrt() * line_load::BEAM) - 1.0;
    let (stiff, stiffer) = (off(1e4), off(1e7));
    assert!(stiffer.abs() < 2e-6, "{stiffer:e}");
    assert!((95.0..105.0).contains(&(stiff / stiffer)), "{stiff:e}, then {stiffer:e}");
}

/// The pressure at x below a line load P = 1 if the strip nowhere lifts off from a rigid base.
fn pressure_without_lifting(stack: &Stack) -> impl Fn(f64) -> f64 + use<> {
    let chain = FreeChain::all(&BlockSystem::new(stack)).remove(0);
    let (places, step) = (4000, 0.01);
    // V = 0 at the bottom: C_bt S_top + C_bb S_bottom = 0
    let transform = |wavenumber: f64| {
        let wave = Wave { wavenumber, modulus: 1.0, plane: stack.plane() };
        let flexibility = chain.flexibility(&wave).unwrap();
        flexibility.coupling / flexibility.bottom
    };
    let transforms: Vec<(f64, f64)> =
        (0..places).map(|k| (k as f64 + 0.5) * step).map(|lambda| (lambda, transform(lambda))).collect();
    move |x| transforms.iter().map(|(lambda, p)| p * (lambda * x).cos()).sum::<f64>() * step / PI
}

/// The smallest of these.
fn smallest_pressure_without_lifting(stack: &Stack) -> f64 {
    let pressure = pressure_without_lifting(stack);
    (0..80).map(|k| pressure(0.1 * f64::from(k))).fold(f64::INFINITY, f64::min)
}

#[test]
fn a_strip_that_bends_down_enough_never_lifts_off() {
    // under pressure its soft upper part gets longer than its stiff lower part can follow
    let graded = |beta: f64| {
        let layer = Exponential::new(1.0, 1.0, 0.5, beta).unwrap();
        Stack::builder(Plane::Strain).layer(layer).receding().rigid().build().unwrap()
    };
    let press = |beta| Model::new(graded(beta)).unwrap().press(Punch::parabola(100.0).unwrap(), 1e-6);
    assert!(smallest_pressure_without_lifting(&graded(1.5)) < -1e-5);
    assert!(press(1.5).is_ok());
    assert!(smallest_pressure_without_lifting(&graded(1.8)) > 0.0);
    // it has no end, so none is found, and nothing else depends on it: the pressure is that without lifting
    let fading = press(1.8).unwrap();
    let below = &fading.contacts()[1];
    assert_eq!(below.half_length().unwrap(), below.half_length_error().unwrap());
    assert!(fading.warnings()[0].message.contains("no end of the contact 1|2 was found"), "{:?}", fading.warnings());
    for x in [0.0, 0.7, 2.0] {
        let expected = 1e-6 * pressure_without_lifting(&graded(1.8))(x);
        assert!((below.pressure(x) / expected - 1.0).abs() < 1e-4, "{x}: {} {expected}", below.pressure(x));
    }
}

#[test]
fn a_stiff_half_plane_is_a_rigid_base() {
    for punch in [Punch::cylinder(500.0).unwrap(), Punch::cylinder(10.0).unwrap()] {
        let strip = || Stack::builder(Plane::Strain).layer(strip((1.0, 0.25))).receding();
        let rigid = press(strip().rigid(), punch.clone(), 0.002);
        let mut last = f64::INFINITY;
        for modulus in [1e3, 1e6, 1e9, 1e12] {
            let stiff = press(strip().layer(HalfPlane::new(modulus, 0.25).unwrap()), punch.clone(), 0.002);
            let off = |(a, b): (&Contact, &Contact)| {
                (a.half_length().unwrap() / b.half_length().unwrap() - 1.0)
                    .abs()
                    .max((a.central_pressure / b.central_pressure - 1.0).abs())
            };
            let off = stiff.contacts().iter().zip(rigid.contacts()).map(off).fold(0.0, f64::max);
            assert!(off < 3.0 / modulus + 1e-10, "modulus {modulus:e}: off by {off:e}");
            assert!(off < last || off < 1e-10);
            last = off;
        }
    }
}
