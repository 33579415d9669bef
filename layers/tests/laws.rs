//! The laws of `conformance`, put to the layers that ship, to layers of one's own, and to layers that break them.
use proptest::prelude::*;
use recede_layers::conformance::{self, LAWS};
use recede_layers::{
    ClosedForm, Exponential, FaceStates, Flexibility, HalfPlane, Homogeneous, Isotropic, Key, Layer, LayerStates,
    Material, Notation, Plane, Wave, layer_laws,
};

const PLANES: [Plane; 2] = [Plane::Strain, Plane::Stress];
const POISSON: [f64; 7] = [-0.9, -0.3, 0.0, 0.25, 0.45, 0.499999, 0.5];
const STEEPNESS: [f64; 9] = [1e-300, 1e-12, 1e-6, 1e-3, 0.5, 1.0, 4.0, 8.0, 30.0];

fn homogeneous(poisson: f64) -> Homogeneous {
    Homogeneous::new(2.0, 3.0, poisson).expect("legal")
}

fn exponential(steepness: f64) -> Exponential {
    Exponential::new(1.0, 3.0, 0.25, steepness).expect("legal")
}

fn examine(layer: &dyn Layer) {
    for plane in PLANES {
        if let Err(violations) = conformance::examine(layer, plane) {
            let list: String = violations.iter().map(|violation| format!("\n  {violation}")).collect();
            panic!("{layer:?}{list}");
        }
    }
}

#[test]
fn homogeneous_layers() {
    POISSON.iter().for_each(|poisson| examine(&homogeneous(*poisson)));
}

#[test]
fn half_planes() {
    POISSON.iter().for_each(|poisson| examine(&HalfPlane::new(3.0, *poisson).expect("legal")));
}

#[test]
fn exponential_layers() {
    for poisson in [-0.9, 0.0, 0.25, 0.5] {
        for steepness in STEEPNESS.into_iter().flat_map(|b| [b, -b]) {
            examine(&Exponential::new(2.0, 3.0, poisson, 0.5 * steepness).expect("legal"));
        }
    }
}

#[test]
fn a_layer_that_is_not_there() {
    examine(&Homogeneous::new(0.0, 1.0, 0.25).expect("legal"));
    examine(&Exponential::new(0.0, 1.0, 0.25, 1.0).expect("legal"));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 16, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_exponential_layer(
        poisson in -0.95..=0.5f64,
        steepness in -30.0..30.0f64,
        log_thickness in -6.0..6.0f64,
        log_modulus in -9.0..12.0f64,
    ) {
        let thickness = 10f64.powf(log_thickness);
        let layer = Exponential::new(thickness, 10f64.powf(log_modulus), poisson, steepness / thickness)?;
        for plane in PLANES {
            prop_assert_eq!(conformance::examine(&layer, plane), Ok(()));
        }
    }

    #[test]
    fn any_homogeneous_layer(poisson in -0.99..=0.5f64, log_thickness in -6.0..6.0f64, log_modulus in -9.0..12.0f64) {
        let layer = Homogeneous::new(10f64.powf(log_thickness), 10f64.powf(log_modulus), poisson)?;
        for plane in PLANES {
            prop_assert_eq!(conformance::examine(&layer, plane), Ok(()));
        }
    }
}

/// A layer of one's own, by material only: orthotropic, and stiffer towards one face.
#[derive(Debug)]
struct Fibres {
    thickness: Option<f64>,
    stiffening: f64,
}

impl Layer for Fibres {
    fn thickness(&self) -> Option<f64> {
        self.thickness
    }

    fn material(&self, depth: f64, _: Plane) -> Material {
        // stiffnesses of a fibre composite, fibres along x, in units of its shear modulus
        let (c11, c12, c22, c66) = (30.0, 1.2, 2.5, 1.0);
        let scale = 1.0 + self.stiffening * (3.0 * depth).tanh();
        Material {
            shear_compliance: 1.0 / (c66 * scale),
            normal_compliance: 1.0 / (c22 * scale),
            coupling: c12 / c22,
            axial_stiffness: (c11 - c12 * c12 / c22) * scale,
            out_of_plane: None,
        }
    }

    fn notation(&self) -> Notation {
        Notation { kind: "Fibres", parameters: String::new() }
    }
}

layer_laws!(fibres, Fibres { thickness: Some(0.7), stiffening: 4.0 });
layer_laws!(fibres_uniform, Fibres { thickness: Some(0.7), stiffening: 0.0 });
layer_laws!(fibres_below_everything, Fibres { thickness: None, stiffening: -0.8 });
layer_laws!(strip, homogeneous(0.25));
layer_laws!(ground, HalfPlane::new(1.0, 0.5).expect("legal"));

/// A layer spoiled in one way.
#[derive(Debug)]
struct Spoiled<L> {
    sound: L,
    states: fn(&mut FaceStates, z: f64),
    flexibility: fn(&mut Flexibility, z: f64),
    modulus: fn(depth: f64) -> f64,
}

impl<L: Layer> Spoiled<L> {
    fn new(sound: L) -> Self {
        Self { sound, states: |_, _| (), flexibility: |_, _| (), modulus: |_| 1.0 }
    }

    fn z(&self, wave: &Wave) -> f64 {
        wave.wavenumber * self.thickness().unwrap_or(1.0)
    }
}

impl<L: Layer> Layer for Spoiled<L> {
    fn thickness(&self) -> Option<f64> {
        self.sound.thickness()
    }

    fn material(&self, depth: f64, plane: Plane) -> Material {
        let factor = (self.modulus)(depth);
        let mut material = self.sound.material(depth, plane);
        material.shear_compliance /= factor;
        material.normal_compliance /= factor;
        material.axial_stiffness *= factor;
        material
    }

    fn notation(&self) -> Notation {
        self.sound.notation()
    }

    fn closed_form(&self) -> Option<&dyn ClosedForm> {
        Some(self)
    }
}

impl<L: Layer> ClosedForm for Spoiled<L> {
    fn face_states(&self, wave: &Wave) -> FaceStates {
        let sound: &dyn Layer = &self.sound;
        let mut states = sound.face_states(wave);
        (self.states)(&mut states, self.z(wave));
        states
    }

    fn flexibility(&self, wave: &Wave) -> Option<Flexibility> {
        let sound: &dyn Layer = &self.sound;
        let mut flexibility = sound.flexibility(wave)?;
        (self.flexibility)(&mut flexibility, self.z(wave));
        Some(flexibility)
    }
}

/// Names of the laws that a layer breaks.
fn broken(layer: &dyn Layer) -> Vec<&'static str> {
    conformance::examine(layer, Plane::Strain).err().into_iter().flatten().map(|violation| violation.law).collect()
}

fn assert_breaks(laws: &[&str], layer: &dyn Layer) {
    let found = broken(layer);
    for law in laws {
        assert!(LAWS.iter().any(|(name, _)| name == law), "{law} is no law");
        assert!(found.contains(law), "{law} should be broken, but only these are: {found:?}");
    }
}

/// A strip whose shear on the bottom face has the wrong sign.
fn wrong_sign(states: &mut FaceStates, _: f64) {
    if let FaceStates::Finite { bottom, .. } = states {
        bottom.row_mut(3).neg_mut();
    }
}

#[test]
fn a_wrong_sign_is_caught() {
    let layer = Spoiled { states: wrong_sign, ..Spoiled::new(homogeneous(0.25)) };
    assert_breaks(&["reciprocity", "general_body", "uniform_pressure"], &layer);
}

#[test]
fn a_lack_of_reciprocity_is_caught() {
    let states = |states: &mut FaceStates, _| {
        if let FaceStates::Finite { top, .. } = states {
            top[(1, 0)] += 1e-6 * top.amax();
        }
    };
    assert_breaks(&["reciprocity", "general_body"], &Spoiled { states, ..Spoiled::new(exponential(2.0)) });
    let states = |states: &mut FaceStates, _| {
        if let FaceStates::HalfPlane { top } = states {
            top[(0, 0)] *= 1.0 + 1e-6;
        }
    };
    let ground = Spoiled { states, ..Spoiled::new(HalfPlane::new(1.0, 0.25).expect("legal")) };
    assert_breaks(&["reciprocity", "general_body"], &ground);
}

#[test]
fn work_out_of_nothing_is_caught() {
    // all stresses reversed: reciprocal, but loads are pulled along by what they push
    let states = |states: &mut FaceStates, _| match states {
        FaceStates::Finite { top, bottom, .. } => {
            top.rows_mut(2, 2).neg_mut();
            bottom.rows_mut(2, 2).neg_mut();
        }
        FaceStates::HalfPlane { top } => top.rows_mut(2, 2).neg_mut(),
    };
    let flexibility = |c: &mut Flexibility, _| {
        for number in [&mut c.top, &mut c.coupling, &mut c.bottom, &mut c.equal_top, &mut c.equal_bottom] {
            *number = -*number;
        }
    };
    let strip = Spoiled { states, flexibility, ..Spoiled::new(homogeneous(0.25)) };
    assert_breaks(&["positive_energy", "general_body", "long_wave", "short_wave"], &strip);
    let ground = Spoiled { states, ..Spoiled::new(HalfPlane::new(1.0, 0.25).expect("legal")) };
    assert_breaks(&["positive_energy", "short_wave", "split_in_two"], &ground);
    // faces that feel each other more than themselves
    let flexibility = |c: &mut Flexibility, z| c.coupling *= if z > 0.5 { 3.0 } else { 1.0 };
    assert_breaks(&["positive_energy"], &Spoiled { flexibility, ..Spoiled::new(homogeneous(0.25)) });
}

#[test]
fn a_wrong_modulus_at_the_bottom_is_caught() {
    let modulus = |depth: f64| 1.0 + 1e-3 * (depth - 1.0).max(0.0).powi(3);
    let layer = Spoiled { modulus, ..Spoiled::new(homogeneous(0.25)) };
    assert_breaks(&["general_body", "long_wave", "short_wave", "mirror", "split_in_two"], &layer);
    assert!(!broken(&layer).contains(&"reciprocity"), "it is a layer, but another one");
}

#[test]
fn numbers_that_are_none_are_caught() {
    let states = |states: &mut FaceStates, z: f64| {
        if let FaceStates::Finite { top, .. } = states {
            // cosh λh instead of decaying exponentials
            top.column_mut(0).scale_mut(z.exp());
        }
    };
    assert_breaks(&["finite"], &Spoiled { states, ..Spoiled::new(homogeneous(0.25)) });
    let flexibility = |c: &mut Flexibility, z: f64| c.top = if z < 1e-120 { f64::NAN } else { c.top };
    assert_breaks(&["finite"], &Spoiled { flexibility, ..Spoiled::new(homogeneous(0.25)) });
}

#[test]
fn fewer_than_four_fields_are_caught() {
    let states = |states: &mut FaceStates, _| {
        if let FaceStates::Finite { top, bottom, .. } = states {
            for face in [top, bottom] {
                let copied = face.column(0).into_owned();
                face.set_column(1, &copied);
            }
        }
    };
    assert_breaks(&["general_body"], &Spoiled { states, ..Spoiled::new(homogeneous(0.25)) });
}

#[test]
fn a_deviation_from_uniform_pressure_without_its_digits_is_caught() {
    let states = |states: &mut FaceStates, _| {
        if let FaceStates::Finite { uniform, .. } = states {
            uniform[1] *= 1.0 + 1e-5;
        }
    };
    assert_breaks(&["uniform_pressure"], &Spoiled { states, ..Spoiled::new(homogeneous(0.25)) });
    let states = |states: &mut FaceStates, _| {
        if let FaceStates::Finite { uniform, .. } = states {
            // 1 + δ − 1 instead of δ
            uniform.iter_mut().for_each(|state| *state = state.add_scalar(1.0).add_scalar(-1.0));
        }
    };
    assert_breaks(&["uniform_pressure"], &Spoiled { states, ..Spoiled::new(homogeneous(0.25)) });
}

#[test]
fn a_body_held_by_nothing_visible_is_caught() {
    // a spring to the ground, as stiff as the plate is at λh = 1e-2: C no longer grows
    let flexibility = |c: &mut Flexibility, z: f64| {
        let held = (1e-2 / z).powi(3).max(1.0);
        for number in [&mut c.top, &mut c.coupling, &mut c.bottom] {
            *number /= held;
        }
    };
    assert_breaks(&["free_body", "long_wave"], &Spoiled { flexibility, ..Spoiled::new(homogeneous(0.25)) });
    let flexibility = |c: &mut Flexibility, _| c.equal_top += 1e-6 * c.top;
    assert_breaks(&["free_body", "long_wave"], &Spoiled { flexibility, ..Spoiled::new(exponential(1.0)) });
}

#[test]
fn swapped_faces_are_caught() {
    let flexibility = |c: &mut Flexibility, _| (c.top, c.bottom) = (-c.bottom, -c.top);
    assert_breaks(&["mirror", "short_wave"], &Spoiled { flexibility, ..Spoiled::new(exponential(1.0)) });
}

#[test]
fn fields_of_another_depth_are_caught() {
    #[derive(Debug)]
    struct Displaced(Homogeneous);
    impl Layer for Displaced {
        fn thickness(&self) -> Option<f64> {
            self.0.thickness()
        }
        fn material(&self, depth: f64, plane: Plane) -> Material {
            self.0.material(depth, plane)
        }
        fn notation(&self) -> Notation {
            self.0.notation()
        }
        fn closed_form(&self) -> Option<&dyn ClosedForm> {
            Some(self)
        }
    }
    impl ClosedForm for Displaced {
        fn face_states(&self, wave: &Wave) -> FaceStates {
            self.0.face_states(wave)
        }
        fn states(&self, wave: &Wave, depths: &[f64]) -> Option<LayerStates> {
            let depths: Vec<f64> = depths.iter().map(|depth| depth * (1.0 - 1e-5 * (2.0 - depth))).collect();
            self.0.states(wave, &depths)
        }
    }
    assert_breaks(&["inside"], &Displaced(homogeneous(0.25)));
    assert!(!broken(&Displaced(homogeneous(0.25))).contains(&"general_body"), "its faces are right");
}

#[test]
fn a_key_that_leaves_out_a_parameter_is_caught() {
    #[derive(Debug)]
    struct Forgetful(Homogeneous);
    impl Layer for Forgetful {
        fn thickness(&self) -> Option<f64> {
            self.0.thickness()
        }
        fn material(&self, depth: f64, plane: Plane) -> Material {
            self.0.material(depth, plane)
        }
        fn key(&self) -> Option<Key> {
            Some(Key::of::<Self>().with([2.0]))
        }
    }
    let [soft, stiff] = [0.1, 0.3].map(|poisson| Forgetful(homogeneous(poisson)));
    let violation = conformance::same_key(&soft, &stiff, Plane::Strain).expect_err("the ratio is left out");
    assert_eq!((violation.law, violation.quantity), ("identity", "material of what has the same key"));
    assert!(!broken(&soft).contains(&"identity"), "one layer alone cannot tell");
}

#[test]
fn a_violation_tells_where() {
    let layer = Spoiled { states: wrong_sign, ..Spoiled::new(homogeneous(0.25)) };
    let violation = conformance::reciprocity(&layer, Plane::Strain).expect_err("wrong sign");
    let text = violation.to_string();
    assert!(text.starts_with("reciprocity: U₁T₂ − T₁U₂ + V₁S₂ − S₁V₂ of two columns at wavenumber 5e-9"), "{text}");
}

#[test]
fn an_isotropic_layer_of_ones_own_is_the_shipped_one() {
    #[derive(Debug)]
    struct Mine(Exponential);
    impl Layer for Mine {
        fn thickness(&self) -> Option<f64> {
            self.0.thickness()
        }
        fn material(&self, depth: f64, plane: Plane) -> Material {
            let shear_modulus = 3.0 * (-2.0 * depth).exp();
            Isotropic { shear_modulus, poisson: 0.25 }.material(plane)
        }
        fn notation(&self) -> Notation {
            self.0.notation()
        }
    }
    let layer = Mine(exponential(-2.0));
    for wavenumber in [1e-8, 1e-3, 0.3, 1.0, 3.0, 20.0, 1e5] {
        let wave = Wave { wavenumber, modulus: 1.0, plane: Plane::Strain };
        let layers: [&dyn Layer; 2] = [&layer, &layer.0];
        let [mine, shipped] = layers.map(|layer| layer.flexibility(&wave).expect("finite"));
        for (a, b) in [(mine.top, shipped.top), (mine.bottom, shipped.bottom), (mine.equal_top, shipped.equal_top)] {
            assert!((a / b - 1.0).abs() < 1e-12, "λ = {wavenumber}: {a:e} ≠ {b:e}");
        }
    }
}
