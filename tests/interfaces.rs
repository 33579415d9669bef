//! Interfaces that join layers without bonding them.
//!
//! Goal: sliding layers and springs are what closed forms and the limits of one another say; stresses and jumps inside are
//! those that the interface allows; and all reports know them.
use crate::closed_forms::{Elastic, strip};
use proptest::prelude::*;
use recede::{
    BaseChain, BlockSystem, Exponential, FreeChain, HalfPlane, Homogeneous, Model, Plane, Punch, Scene, Solution,
    Spring, Stack, StackBuilder, StackProblem, Wave, Winkler,
};

fn wave(wavenumber: f64) -> Wave {
    Wave { wavenumber, modulus: 1.0, plane: Plane::Strain }
}

fn begin() -> StackBuilder {
    Stack::builder(Plane::Strain)
}

fn strip_of(thickness: f64, modulus: f64) -> Homogeneous {
    Homogeneous::new(thickness, modulus, 0.25).unwrap()
}

fn base(stack: StackBuilder, wavenumber: f64) -> f64 {
    BaseChain::of(&BlockSystem::new(&stack.build().unwrap())).flexibility(&wave(wavenumber)).unwrap()
}

fn close(found: f64, expected: f64, error: f64, what: &str) {
    assert!((found / expected - 1.0).abs() <= error, "{what}: {found:e}, expected {expected:e}");
}

fn wavenumbers() -> impl Iterator<Item = f64> {
    (-28..=16).map(|k| 10f64.powf(0.25 * f64::from(k)))
}

#[test]
fn a_strip_that_slides_on_a_rigid_base_is_half_of_a_strip_pressed_from_both_sides() {
    let material = Elastic::plane_strain(1.0, 0.25);
    for wavenumber in wavenumbers() {
        let found = base(begin().layer(strip_of(0.7, 1.0)).sliding().rigid(), wavenumber);
        close(found, strip::equal_loads(material, 1.4, wavenumber), 1e-12, &format!("{wavenumber}"));
    }
}

#[test]
fn a_strip_that_slides_on_a_half_plane_is_what_both_do_alone() {
    let (upper, lower) = (Elastic::plane_strain(1.0, 0.25), Elastic::plane_strain(0.3, 0.25));
    for wavenumber in wavenumbers() {
        let (h, ground) = (0.7, lower.flexibility());
        let own = strip::own_face(upper, h, wavenumber);
        let other = strip::other_face(upper, h, wavenumber);
        // the pressure between is what other/(own + ground) of a pressure on top presses through; own² − other² as
        // a product, so that long waves do not cancel
        let both = strip::equal_loads(upper, h, wavenumber) * strip::opposite_loads(upper, h, wavenumber);
        let expected = (both + own * ground) / (own + ground);
        assert!((own * own - other * other - both).abs() <= 1e-9 * own * own);
        let ground = HalfPlane::new(0.3, 0.25).unwrap();
        let found = base(begin().layer(strip_of(h, 1.0)).sliding().layer(ground), wavenumber);
        close(found, expected, 1e-11, &format!("{wavenumber}"));
    }
}

#[test]
fn springs_on_a_rigid_base_are_those_of_winkler() {
    for wavenumber in wavenumbers() {
        let strip = || begin().layer(strip_of(0.7, 1.0));
        let springs = Winkler::new(0.2).unwrap();
        let found = base(strip().spring(Spring::new(0.2, None).unwrap()).rigid(), wavenumber);
        close(found, base(strip().bonded().support(springs), wavenumber), 1e-12, "springs");
        let found = base(strip().spring(Spring::new(0.2, Some(0.1)).unwrap()).rigid(), wavenumber);
        let sticking = springs.sticking(0.1).unwrap();
        close(found, base(strip().bonded().support(sticking), wavenumber), 1e-12, "springs that stick");
    }
}

/// Three layers joined in some way, free or on a half-plane.
fn three(join: &dyn Fn(StackBuilder) -> StackBuilder) -> [StackBuilder; 2] {
    let graded = Exponential::new(0.5, 1.0, 0.3, 1.5).unwrap();
    let layers = join(join(begin().layer(strip_of(0.7, 3.0))).layer(graded)).layer(strip_of(1.1, 0.4));
    [join(layers.clone()).layer(HalfPlane::new(2.0, 0.3).unwrap()), layers.receding().rigid()]
}

fn free(stack: &Stack, wavenumber: f64) -> [f64; 5] {
    let c = FreeChain::all(&BlockSystem::new(stack))[0].flexibility(&wave(wavenumber)).unwrap();
    [c.top, c.coupling, c.bottom, c.equal_top, c.equal_bottom]
}

#[test]
fn plates_that_slide_on_each_other_are_what_each_does_alone() {
    // nothing but bending resists long waves: these reach far deeper than the plates' thickness tells
    let ground = Elastic::plane_strain(0.3, 0.25).flexibility();
    for (count, thickness, moduli) in [(100, 0.02, [1.0, 1.0]), (300, 0.01, [1.0, 30.0]), (40, 0.3, [5.0, 0.1])] {
        let plates = || (0..count).map(|i| moduli[i % 2]);
        for wavenumber in (-20..=48).map(|k| 10f64.powf(0.125 * f64::from(k))) {
            let below = |below: f64, modulus: f64| {
                let plate = Elastic::plane_strain(modulus, 0.25);
                let own = strip::own_face(plate, thickness, wavenumber);
                let both = strip::equal_loads(plate, thickness, wavenumber)
                    * strip::opposite_loads(plate, thickness, wavenumber);
                (both + own * below) / (own + below)
            };
            let moduli: Vec<f64> = plates().collect();
            let expected = moduli.iter().rev().copied().fold(ground, below);
            let on_plates =
                moduli.iter().fold(begin(), |stack, modulus| stack.layer(strip_of(thickness, *modulus)).sliding());
            let found = base(on_plates.layer(HalfPlane::new(0.3, 0.25).unwrap()), wavenumber);
            close(found, expected, 1e-11, &format!("{count} plates at {wavenumber}"));
        }
    }
}

#[test]
fn stiff_springs_are_bonds_or_let_slide() {
    for wavenumber in wavenumbers() {
        let stiffness = 1e14 * wavenumber.max(1.0);
        for (joined, tangential, allowed) in [
            (three(&StackBuilder::bonded), Some(stiffness), 1e-9),
            (three(&StackBuilder::sliding), None, 1e-9),
            (three(&StackBuilder::sliding), Some(1e-14 * wavenumber.powi(3).min(wavenumber)), 1e-9),
        ] {
            let springs = three(&|stack| stack.spring(Spring::new(stiffness, tangential).unwrap()));
            let what = format!("{wavenumber} {tangential:?}");
            close(base(springs[0].clone(), wavenumber), base(joined[0].clone(), wavenumber), allowed, &what);
            let [found, expected] =
                [&springs, &joined].map(|stacks| free(&stacks[1].clone().build().unwrap(), wavenumber));
            for (found, expected) in found.iter().zip(&expected) {
                let error = (found - expected).abs();
                assert!(error <= allowed * expected.abs() + 1e-15, "{what}: {found:e} {expected:e}");
            }
        }
    }
}

#[test]
fn a_stack_upside_down_is_the_same() {
    let springs = || Spring::new(0.8, Some(0.05)).unwrap();
    let layers = [strip_of(0.7, 3.0), strip_of(0.1, 20.0), strip_of(1.1, 0.4)];
    let [a, b, c] = layers;
    let up = begin().layer(a).sliding().layer(b).spring(springs()).layer(c).receding().rigid().build().unwrap();
    let down = begin().layer(c).spring(springs()).layer(b).sliding().layer(a).receding().rigid().build().unwrap();
    for wavenumber in wavenumbers() {
        let ([top, coupling, bottom, equal_top, equal_bottom], turned) =
            (free(&up, wavenumber), free(&down, wavenumber));
        let expected = [-bottom, coupling, -top, -equal_bottom, -equal_top];
        for (found, expected) in turned.into_iter().zip(expected) {
            assert!((found - expected).abs() <= 1e-11 * expected.abs() + 1e-15, "{wavenumber}: {found:e} {expected:e}");
        }
    }
}

/// Springs that resist no motion along the face do not feel whether they are told so once or twice.
#[test]
fn springs_without_shear_stiffness_carry_no_shear_however_they_are_joined() {
    let (k, normal) = (0.2, 0.7);
    let springs = |k: f64| Winkler::new(k).unwrap();
    let bed = |join: &dyn Fn(StackBuilder) -> StackBuilder, k: f64| {
        let stack = join(begin().layer(strip_of(0.4, 1.0)).bonded().layer(strip_of(0.6, 2.0))).support(springs(k));
        press_and_look(stack)
    };
    let bonded = bed(&|stack| stack.bonded(), k);
    let sliding = bed(&|stack| stack.sliding(), k);
    let in_series = bed(&|stack| stack.spring(Spring::new(normal, None).unwrap()), k);
    let softer = bed(&|stack| stack.bonded(), (1.0 / k + 1.0 / normal).recip());
    for (found, expected) in sliding.into_iter().chain(in_series).zip(bonded.into_iter().chain(softer)) {
        close(found, expected, 1e-10, "half-length, pressure, stress, displacement");
    }
}

/// Half-length and pressure under a punch, a stress and a displacement inside.
fn press_and_look(stack: StackBuilder) -> [f64; 4] {
    let (model, solution) = solve(stack);
    let inside = model.field(&solution).unwrap().at(0.3, 0.9).unwrap();
    let top = &solution.contacts()[0];
    [top.half_length().unwrap(), top.central_pressure, inside.sigma_xx, inside.v]
}

#[test]
fn plates_that_slide_bend_each_by_itself() {
    let bend = |h: f64, modulus: f64| Elastic::plane_strain(modulus, 0.25).plane_modulus() * h.powi(3) / 12.0;
    let stack =
        begin().layer(strip_of(0.7, 3.0)).sliding().layer(strip_of(1.1, 0.4)).receding().rigid().build().unwrap();
    let lambda = 1e-6f64;
    let [top, coupling, ..] = free(&stack, lambda);
    let expected = 1.0 / ((bend(0.7, 3.0) + bend(1.1, 0.4)) * lambda.powi(3));
    close(top, expected, 1e-11, "top");
    close(-coupling, expected, 1e-11, "coupling");
}

fn solve(stack: StackBuilder) -> (Model, Solution) {
    let model = Model::new(stack.build().unwrap()).unwrap();
    let solution = model.press(Punch::cylinder(100.0).unwrap(), 0.01).unwrap();
    assert_eq!(solution.warnings(), []);
    (model, solution)
}

#[test]
fn contacts_on_slices_that_slide_are_found_to_ten_digits() {
    let ground = || HalfPlane::new(0.5, 0.3).unwrap();
    let strips = |join: &dyn Fn(StackBuilder) -> StackBuilder| {
        join(begin().layer(strip_of(0.4, 1.0))).layer(strip_of(0.6, 2.0)).receding().layer(ground())
    };
    let half_lengths = |stack: StackBuilder| -> Vec<f64> {
        let (_, solution) = solve(stack);
        assert!(
            solution.contacts().iter().all(|c| c.half_length_error().unwrap() < 1e-10 * c.half_length().unwrap()),
            "{solution:?}"
        );
        solution.contacts().iter().map(|contact| contact.half_length().unwrap()).collect()
    };
    let springs = |normal: f64, tangential: f64| {
        half_lengths(strips(&|stack| stack.spring(Spring::new(normal, Some(tangential)).unwrap())))
    };
    let (bonded, sliding) = (half_lengths(strips(&StackBuilder::bonded)), half_lengths(strips(&StackBuilder::sliding)));
    // what slides bends more easily, and lifts off earlier
    assert!(sliding[1] < bonded[1], "{sliding:?} {bonded:?}");
    for (found, expected) in springs(1e12, 1e12).iter().zip(&bonded).chain(springs(1e12, 1e-20).iter().zip(&sliding)) {
        close(*found, *expected, 1e-9, "half-length");
    }
    let between = springs(1e12, 1.0);
    assert!(bonded[0] < between[0] && between[0] < sliding[0], "{sliding:?} {between:?} {bonded:?}");
}

#[test]
fn inside_stresses_and_jumps_are_those_that_the_interfaces_allow() {
    let (normal, tangential) = (3.0, 0.8);
    let stack = begin()
        .layer(strip_of(0.3, 1.0))
        .sliding()
        .layer(strip_of(0.5, 2.0))
        .spring(Spring::new(normal, Some(tangential)).unwrap())
        .layer(strip_of(0.4, 1.5))
        .receding()
        .layer(strip_of(0.5, 1.0))
        .spring(Spring::new(normal, Some(tangential)).unwrap())
        .layer(strip_of(0.3, 2.0))
        .sliding()
        .layer(HalfPlane::new(0.5, 0.3).unwrap());
    let (model, solution) = solve(stack);
    let field = model.field(&solution).unwrap();
    let peak = solution.contacts()[0].central_pressure;
    for x in [0.0, 0.2, 0.9, 2.0] {
        for (depth, layers, springs) in
            [(0.3, [1, 2], false), (0.8, [2, 3], true), (1.7, [4, 5], true), (2.0, [5, 6], false)]
        {
            let [above, below] = layers.map(|layer| field.at_layer(x, depth, layer).unwrap());
            let same = |a: f64, b: f64, what: &str| {
                assert!((a - b).abs() < 1e-8 * peak, "{what} at {x}, {depth}: {a:e} {b:e}");
            };
            same(above.sigma_yy, below.sigma_yy, "σ_yy");
            same(above.sigma_xy, below.sigma_xy, "σ_xy");
            if springs {
                same(above.sigma_yy, normal * (above.v - below.v), "normal springs");
                same(above.sigma_xy, tangential * (above.u - below.u), "tangential springs");
            } else {
                same(above.v, below.v, "v");
                same(above.sigma_xy, 0.0, "friction");
            }
        }
    }
}

const SCENE: &str = "Scene(geometry: PlaneStrain, punch: Parabola(radius: 500), force: 0.002, stack: [
    Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Sliding,
    Homogeneous(thickness: 1, shear_modulus: 1, poisson: 0.25), Spring(normal: 2, tangential: 0.5),
    HalfPlane(shear_modulus: 1, poisson: 0.25)])";

#[test]
fn scenes_name_them_draw_them_and_print_them() {
    let scene = Scene::from_ron(SCENE).unwrap();
    let stack = scene.stack().unwrap();
    assert_eq!(scene.paths()[8..10], ["interface[2].normal", "interface[2].tangential"]);
    let softer = scene.with("interface[2].normal", 1.5).unwrap();
    assert!(softer.to_ron().contains("Spring(normal: 1.5, tangential: 0.5),\n"), "{}", softer.to_ron());
    insta::assert_snapshot!(stack.drawing(None, None), @r"
    ┌──────────────────────────────────────────────────────────────────┐
    │ 1 Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25) │
    ├──────────────────────────── sliding ─────────────────────────────┤
    │ 2 Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25) │
    ├───────────────────── springs 2.0, along 0.5 ─────────────────────┤
    │ 3 HalfPlane(shear_modulus: 1.0, poisson: 0.25)                   │
    │╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱╱│
    ");
    insta::assert_snapshot!(BlockSystem::new(&stack), @r"
    10 conditions for 10 amplitudes
    ┌──────────────────┬───────────────┬─────────────────────────┬─────────────┬───────┐
    │                  ┆ 1 Homogeneous ┆      2 Homogeneous      ┆ 3 HalfPlane ┆       │
    │                  ┆     C1..C4    ┆          C5..C8         ┆   C9..C10   ┆       │
    ╞══════════════════╪═══════════════╪═════════════════════════╪═════════════╪═══════╡
    │ punch S          ┆    +S(top)    ┆                         ┆             ┆ = -p0 │
    │ punch T          ┆    +T(top)    ┆                         ┆             ┆  = 0  │
    │ 1|2 T above      ┆   +T(bottom)  ┆                         ┆             ┆  = 0  │
    │ 1|2 V continuous ┆   +V(bottom)  ┆         -V(top)         ┆             ┆  = 0  │
    │ 1|2 S continuous ┆   +S(bottom)  ┆         -S(top)         ┆             ┆  = 0  │
    │ 1|2 T below      ┆               ┆         +T(top)         ┆             ┆  = 0  │
    │ 2|3 U springs    ┆               ┆ +kt·U(bottom)-T(bottom) ┆  -kt·U(top) ┆  = 0  │
    │ 2|3 V springs    ┆               ┆ +kn·V(bottom)-S(bottom) ┆  -kn·V(top) ┆  = 0  │
    │ 2|3 S continuous ┆               ┆        +S(bottom)       ┆   -S(top)   ┆  = 0  │
    │ 2|3 T continuous ┆               ┆        +T(bottom)       ┆   -T(top)   ┆  = 0  │
    └──────────────────┴───────────────┴─────────────────────────┴─────────────┴───────┘
    ");
    let latex = BlockSystem::new(&stack).to_latex();
    assert!(latex.contains(r"+k_n \mathbf{V}_{2}^{b}-\mathbf{S}_{2}^{b} & -k_n \mathbf{V}_{3}^{t}"), "{latex}");
}

#[test]
fn without_the_layer_between_jumps_add_up() {
    let spring = |normal| Spring::new(normal, None).unwrap();
    let stack = begin().layer(strip_of(1.0, 1.0)).spring(spring(2.0)).layer(strip_of(0.0, 1.0)).spring(spring(2.0));
    let merged = begin().layer(strip_of(1.0, 1.0)).spring(spring(1.0));
    let [found, expected] = [stack, merged].map(|stack| stack.rigid().build().unwrap());
    assert_eq!(found.base().joints(), expected.base().joints());
    // springs cannot end on a face that comes loose, or under the punch
    let loose =
        begin().layer(strip_of(1.0, 1.0)).spring(spring(2.0)).layer(strip_of(0.0, 1.0)).receding().rigid().build();
    assert!(matches!(loose.unwrap_err().problem(), StackProblem::LooseSprings(_)));
    let above =
        begin().layer(strip_of(0.0, 1.0)).spring(spring(2.0)).layer(strip_of(1.0, 1.0)).bonded().rigid().build();
    assert_eq!(above.unwrap_err().item(), Some(1));
    let sliding = begin().layer(strip_of(1.0, 1.0)).sliding().layer(strip_of(0.0, 1.0)).receding().rigid().build();
    assert_eq!(sliding.unwrap().laminates().len(), 1);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn slices_of_what_slides_are_one_layer(share in 0.1..0.9f64, h in 0.2..3.0f64, modulus in 0.1..10.0f64) {
        let whole = begin().layer(strip_of(1.0, 1.0)).sliding().layer(strip_of(h, modulus)).receding().rigid();
        let cut = begin().layer(strip_of(1.0, 1.0)).sliding()
            .layer(strip_of(share * h, modulus)).bonded().layer(strip_of((1.0 - share) * h, modulus)).receding().rigid();
        let [whole, cut] = [whole, cut].map(|stack| stack.build().unwrap());
        for wavenumber in wavenumbers().step_by(3) {
            for (found, expected) in free(&cut, wavenumber).into_iter().zip(free(&whole, wavenumber)) {
                prop_assert!((found - expected).abs() <= 2e-11 * expected.abs() + 3e-15 / wavenumber, "{} {:e} {:e}", wavenumber, found, expected);
            }
        }
    }
}
