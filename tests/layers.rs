//! Solved scenes with every layer type: what is the same body has the same contacts, however it is written.
//!
//! ```text
//!        P                    cut anywhere and bonded again, a layer is the same layer;
//!     ___↓___                 a base is the same base with its uppermost part written as a layer;
//!   ░░░░░░░░░░░  h₁           in a limit a layer is the simpler one;
//!   ▒▒▒▒▒▒▒▒▒▒▒  h₂           on springs there is a closed form
//! ```
use recede::layers::{Poisson, Positive};
use recede::{
    BaseChain, BlockSystem, ClosedForm, EngineeringConstants, Exponential, Force, Graded, GradedHalfPlane, HalfPlane,
    Homogeneous, Isotropic, Model, Orthotropic, OrthotropicHalfPlane, Plane, PowerHalfPlane, Profile, Punch, Stack,
    StackBuilder, Wave, Winkler,
};

/// Half-lengths of ten digits.
const SAME: f64 = 1e-9;

fn stack() -> StackBuilder {
    Stack::builder(Plane::Strain)
}

fn half_lengths(stack: StackBuilder) -> Vec<f64> {
    let model = Model::new(stack.build().expect("a legal stack")).expect("a kernel");
    let solution = model.press(Punch::parabola(300.0).expect("legal"), 0.003).expect("a solution");
    solution.contacts().iter().map(|contact| contact.half_length().unwrap()).collect()
}

#[track_caller]
fn assert_same(one: StackBuilder, other: StackBuilder, tolerance: f64) {
    let (one, other) = (half_lengths(one), half_lengths(other));
    assert_eq!(one.len(), other.len());
    for (a, b) in one.iter().zip(&other) {
        assert!((a / b - 1.0).abs() < tolerance, "{one:?} {other:?}");
    }
}

fn ground() -> HalfPlane {
    HalfPlane::new(1.0, 0.25).expect("legal")
}

fn constant(poisson: f64) -> Profile<Poisson> {
    Profile::linear(poisson, poisson).expect("legal")
}

fn graded(thickness: f64, shear_modulus: Profile<Positive>) -> Graded {
    Graded::new(thickness, shear_modulus, constant(0.3)).expect("legal")
}

/// The part of a profile in modulus and Poisson's ratio from one depth to another.
fn part(from: f64, to: f64) -> Graded {
    let material = move |depth: f64| Isotropic {
        shear_modulus: 1.0 + 2.0 * (from + depth) + (3.0 * (from + depth)).sin().powi(2),
        poisson: 0.4 - 0.2 * (from + depth),
    };
    Graded::with(to - from, material).expect("legal")
}

#[test]
fn a_graded_layer_cut_in_two_is_the_same() {
    let whole = stack().layer(part(0.0, 1.0)).receding().layer(ground());
    let cut = stack().layer(part(0.0, 0.3)).bonded().layer(part(0.3, 1.0)).receding().layer(ground());
    assert_same(whole, cut, SAME);
}

#[test]
fn a_table_is_a_stack_of_linear_layers() {
    let table = graded(1.0, Profile::table(&[(0.0, 1.0), (0.2, 3.0), (1.0, 2.0)]).expect("legal"));
    let linear = |thickness, top, bottom| graded(thickness, Profile::linear(top, bottom).expect("legal"));
    let stacked = stack().layer(linear(0.2, 1.0, 3.0)).bonded().layer(linear(0.8, 3.0, 2.0));
    assert_same(stack().layer(table).receding().layer(ground()), stacked.receding().layer(ground()), SAME);
}

#[test]
fn an_exponential_profile_is_an_exponential_layer() {
    let profile = graded(1.0, Profile::exponential(2.0, -1.5).expect("legal"));
    let exponential = Exponential::new(1.0, 2.0, 0.3, -1.5).expect("legal");
    let on = |base: StackBuilder| base.bonded().layer(ground());
    assert_same(on(stack().layer(profile.clone())), on(stack().layer(exponential)), SAME);
    let on = |base: StackBuilder| base.receding().layer(ground());
    assert_same(on(stack().layer(profile)), on(stack().layer(exponential)), SAME);
}

#[test]
fn a_skin_at_the_face_is_a_layer_of_its_own() {
    // a kink a hundredth of the thickness below the face
    let table = graded(1.0, Profile::table(&[(0.0, 5.0), (0.01, 1.0), (1.0, 1.0)]).expect("legal"));
    let skin = graded(0.01, Profile::linear(5.0, 1.0).expect("legal"));
    let core = Homogeneous::new(0.99, 1.0, 0.3).expect("legal");
    let layered = stack().layer(skin).bonded().layer(core);
    assert_same(stack().layer(table).receding().layer(ground()), layered.receding().layer(ground()), SAME);
}

fn isotropic(shear_modulus: f64, poisson: f64) -> EngineeringConstants {
    let young = 2.0 * shear_modulus * (1.0 + poisson);
    EngineeringConstants::new([young; 3], [poisson; 3], shear_modulus).expect("legal")
}

fn ply() -> EngineeringConstants {
    EngineeringConstants::new([14.0, 1.0, 1.0], [0.3, 0.3, 0.4], 0.5).expect("legal")
}

#[test]
fn an_orthotropic_stack_becomes_an_isotropic_one() {
    let strip = Homogeneous::new(1.0, 2.0, 0.3).expect("legal");
    let plain = || stack().layer(strip).receding().layer(HalfPlane::new(1.0, 0.2).expect("legal"));
    // coinciding roots, and roots that nearly do
    for factor in [1.0, 1.0 + 1e-12, 1.0 - 1e-12] {
        let layer = Orthotropic::new(1.0, isotropic(2.0 * factor, 0.3)).expect("legal");
        let base = OrthotropicHalfPlane::new(isotropic(1.0 * factor, 0.2));
        assert_same(stack().layer(layer).receding().layer(base), plain(), SAME);
    }
}

#[test]
fn an_orthotropic_half_plane_is_one_with_a_layer_of_the_same() {
    let base = || OrthotropicHalfPlane::new(ply());
    let layer = |thickness| Orthotropic::new(thickness, ply()).expect("legal");
    assert_same(stack().layer(base()), stack().layer(layer(0.3)).bonded().layer(base()), SAME);
    let cut = stack().layer(layer(0.4)).bonded().layer(layer(0.6)).receding().layer(base());
    assert_same(stack().layer(layer(1.0)).receding().layer(base()), cut, SAME);
}

#[test]
fn a_graded_half_plane_is_one_with_a_layer_of_the_same() {
    let strip = Homogeneous::new(1.0, 4.0, 0.25).expect("legal");
    let base = |depth: f64| GradedHalfPlane::new((0.5 * depth).exp(), 0.3, 0.5).expect("legal");
    let layer = Exponential::new(0.7, 1.0, 0.3, 0.5).expect("legal");
    assert_same(
        stack().layer(strip).receding().layer(base(0.0)),
        stack().layer(strip).receding().layer(layer).bonded().layer(base(0.7)),
        SAME,
    );
    assert_same(stack().layer(base(0.0)), stack().layer(layer).bonded().layer(base(0.7)), SAME);
}

#[test]
fn soil_is_soil_with_a_layer_of_the_same() {
    let strip = Homogeneous::new(1.0, 4.0, 0.25).expect("legal");
    for exponent in [0.5, -0.3, -0.8] {
        let base = |depth: f64| {
            let modulus = (1.0 + depth / 2.0f64).powf(exponent);
            PowerHalfPlane::new(modulus, 0.3, 2.0 + depth, exponent).expect("legal")
        };
        let layer = graded(0.7, Profile::power(1.0, 2.0, exponent).expect("legal"));
        assert_same(
            stack().layer(strip).receding().layer(base(0.0)),
            stack().layer(strip).receding().layer(layer).bonded().layer(base(0.7)),
            SAME,
        );
    }
}

/// Far below its surface the ground has no length of its own: then a line load P makes a contact a with P ∝ a^(2 + m).
#[test]
fn long_contacts_on_soil_follow_a_power_law() {
    for exponent in [0.5, 0.2, 0.0, -0.3, -0.6] {
        let base = PowerHalfPlane::new(1.0, 0.3, 1e-6, exponent).expect("legal");
        let model = Model::new(stack().layer(base).build().expect("legal")).expect("kernels");
        let force = |half_length: f64| {
            let force = Force::ForHalfLength(half_length);
            model.press(Punch::parabola(1e3).expect("legal"), force).expect("a contact").force()
        };
        let power = (force(40.0) / force(20.0)).log2();
        assert!((power - 2.0 - exponent).abs() < 1e-3, "{exponent}: {power}");
    }
}

#[test]
fn a_base_that_hardly_stiffens_is_a_half_plane() {
    let strip = Homogeneous::new(1.0, 4.0, 0.25).expect("legal");
    let on = |base: StackBuilder| half_lengths(base);
    let plain = on(stack().layer(strip).receding().layer(ground()));
    for exponent in [0.0, 1e-9, 1e-6] {
        let graded = GradedHalfPlane::new(1.0, 0.25, exponent).expect("legal");
        let power = PowerHalfPlane::new(1.0, 0.25, 1.0, exponent).expect("legal");
        for found in
            [on(stack().layer(strip).receding().layer(graded)), on(stack().layer(strip).receding().layer(power))]
        {
            for (a, b) in found.iter().zip(&plain) {
                assert!((a / b - 1.0).abs() < 3.0 * exponent + SAME, "{exponent}: {found:?} {plain:?}");
            }
        }
    }
}

#[test]
fn springs_have_a_closed_form() {
    // the free strip, and under it S = k V: C = C_tt + C_tb C_bt/(1/k − C_bb)
    let strip = Homogeneous::new(0.8, 2.0, 0.3).expect("legal");
    for stiffness in [1e-6, 0.1, 3.0, 1e6] {
        let stack = stack().layer(strip).bonded().support(Winkler::new(stiffness).expect("legal")).build();
        let chain = BaseChain::of(&BlockSystem::new(&stack.expect("legal")));
        for wavenumber in [1e-3, 0.1, 1.0, 4.0, 30.0] {
            let wave = Wave { wavenumber, modulus: 2.0, plane: Plane::Strain };
            let c = strip.flexibility(&wave).expect("finite");
            let springs = wavenumber * wave.modulus / stiffness;
            let bending = c.coupling * c.coupling / (springs - c.bottom);
            let expected = c.top - bending;
            let found = chain.flexibility(&wave).expect("finite");
            // what springs leave of the free strip's motion
            let tolerance = 1e-12 * expected + 1e-14 * c.top;
            assert!((found - expected).abs() < tolerance, "k = {stiffness}, λ = {wavenumber}: {found} {expected}");
        }
    }
}

#[test]
fn a_strip_cut_in_two_lies_on_springs_as_before() {
    let strip = |thickness| Homogeneous::new(thickness, 2.0, 0.3).expect("legal");
    for springs in [Winkler::new(0.3), Winkler::new(0.3).and_then(|springs| springs.sticking(0.1))] {
        let springs = springs.expect("legal");
        let cut = stack().layer(strip(0.4)).bonded().layer(strip(0.6)).bonded().support(springs);
        assert_same(stack().layer(strip(1.0)).bonded().support(springs), cut, SAME);
        let loose = || stack().layer(strip(0.5)).receding();
        let cut = loose().layer(strip(0.4)).bonded().layer(strip(0.6)).bonded().support(springs);
        assert_same(loose().layer(strip(1.0)).bonded().support(springs), cut, SAME);
    }
}

#[test]
fn stiff_springs_that_stick_are_rigid() {
    let strip = || stack().layer(Homogeneous::new(1.0, 2.0, 0.3).expect("legal")).bonded();
    let stiff = Winkler::new(1e12).and_then(|springs| springs.sticking(1e12)).expect("legal");
    assert_same(strip().support(stiff), strip().rigid(), SAME);
}

#[test]
fn nothing_lies_loose_on_springs() {
    let springs = || Winkler::new(1.0).expect("legal");
    let strip = Homogeneous::new(1.0, 2.0, 0.3).expect("legal");
    let alone = stack().support(springs()).build().expect_err("refused");
    assert_eq!(alone.to_string(), "nothing is bonded to layer 1 (Winkler)");
    let error = stack().layer(strip).receding().support(springs()).build().expect_err("refused");
    assert_eq!(error.to_string(), "nothing is bonded to layer 2 (Winkler)");
    assert!(error.hint().is_some());
}

/// No wavenumber is large enough for the kernels where a material has no slope next to a contact: the layer is named at once.
#[test]
fn a_face_without_a_slope_is_refused_and_named() {
    let rough = |bottom: bool| {
        let material = move |depth: f64| {
            let distance = if bottom { 1.0 - depth } else { depth };
            Isotropic { shear_modulus: 1.0 + distance.sqrt(), poisson: 0.3 }
        };
        Graded::with(1.0, material).expect("legal")
    };
    let strip = || Homogeneous::new(1.0, 1.0, 0.25).expect("legal");
    let refused = |stack: StackBuilder| Model::new(stack.build().expect("a stack")).err().map(|e| e.to_string());
    let under_punch = refused(stack().layer(rough(false)).bonded().layer(ground())).expect("a rough top");
    assert!(under_punch.contains("material of layer 1 (Graded) varies next to its top face"), "{under_punch}");
    assert!(under_punch.contains("power 0.50"), "{under_punch}");
    let above = refused(stack().layer(strip()).bonded().layer(rough(true)).receding().layer(ground()));
    assert!(above.expect("a rough bottom").contains("layer 2 (Graded) varies next to its bottom face"));
    // inside a body it is no hindrance
    let inside = stack().layer(strip()).bonded().layer(rough(false)).bonded().layer(ground());
    assert_eq!(half_lengths(inside).len(), 1);
}
