//! Graded and orthotropic layers: the laws, the limits in which they are simpler layers, and how they are read.
use recede_layers::conformance;
use recede_layers::tree::Node;
use recede_layers::{
    ClosedForm, EngineeringConstants, Exponential, FaceStates, Flexibility, Graded, GradedHalfPlane, HalfPlane,
    Homogeneous, Isotropic, Layer, Orthotropic, OrthotropicHalfPlane, Plane, Poisson, Positive, PowerHalfPlane,
    Profile, Registry, Support, Wave, Winkler, graded, layer_laws,
};

const PLANES: [Plane; 2] = [Plane::Strain, Plane::Stress];
const WAVENUMBERS: [f64; 14] = [1e-8, 1e-5, 1e-3, 0.1, 0.5, 1.0, 1.3, 2.5, 6.0, 20.0, 70.0, 300.0, 1e4, 1e8];

fn graded_by(shear_modulus: Profile<Positive>) -> Graded {
    Graded::new(1.0, shear_modulus, constant(0.25)).expect("legal")
}

fn constant(poisson: f64) -> Profile<Poisson> {
    Profile::linear(poisson, poisson).expect("legal")
}

fn table(rows: &[(f64, f64)]) -> Graded {
    graded_by(Profile::table(rows).expect("legal"))
}

/// Fibres along the layer: two real roots, far apart.
fn ply() -> EngineeringConstants {
    EngineeringConstants::new([140.0, 10.0, 10.0], [0.3, 0.3, 0.4], 5.0).expect("legal")
}

/// A large shear modulus: complex roots.
fn stiff_in_shear() -> EngineeringConstants {
    EngineeringConstants::new([1.0, 2.0, 1.5], [0.2, 0.1, 0.2], 3.0).expect("legal")
}

layer_laws!(graded_power, graded_by(Profile::power(2.0, 0.3, 1.7).expect("legal")));
layer_laws!(graded_softening_power, graded_by(Profile::power(2.0, 0.05, -2.0).expect("legal")));
layer_laws!(graded_linear, graded_by(Profile::linear(1.0, 7.0).expect("legal")));
layer_laws!(graded_sigmoid, graded_by(Profile::sigmoid(1.0, 9.0, 0.4, 0.05).expect("legal")));
layer_laws!(graded_table, table(&[(0.0, 1.0), (0.2, 4.0), (0.6, 2.0), (1.0, 9.0)]));
layer_laws!(graded_skin, table(&[(0.0, 5.0), (0.001, 1.0), (1.0, 2.0)]));
layer_laws!(
    graded_in_both,
    Graded::new(2.0, Profile::exponential(3.0, -1.0).expect("legal"), Profile::linear(0.5, 0.1).expect("legal"))
        .expect("legal")
);
layer_laws!(
    graded_by_a_function,
    Graded::with(0.5, |d| Isotropic { shear_modulus: 1.0 + d * d, poisson: 0.3 - 0.2 * d }).expect("legal")
);
layer_laws!(orthotropic_ply, Orthotropic::new(0.7, ply()).expect("legal"));
layer_laws!(orthotropic_stiff_in_shear, Orthotropic::new(0.7, stiff_in_shear()).expect("legal"));
layer_laws!(orthotropic_ground, OrthotropicHalfPlane::new(ply()));
layer_laws!(orthotropic_ground_stiff_in_shear, OrthotropicHalfPlane::new(stiff_in_shear()));
layer_laws!(graded_ground, GradedHalfPlane::new(2.0, 0.3, 0.7).expect("legal"));
layer_laws!(soil, PowerHalfPlane::new(2.0, 0.3, 0.1, 0.8).expect("legal"));
layer_laws!(compacted, PowerHalfPlane::new(2.0, 0.3, 0.1, -0.4).expect("legal"));
layer_laws!(hardly_carrying, PowerHalfPlane::new(2.0, 0.1, 3.0, -0.95).expect("legal"));
layer_laws!(graded_incompressible_ground, GradedHalfPlane::new(2.0, 0.5, 3.0).expect("legal"));

fn flexibility(layer: &dyn Layer, wave: &Wave) -> [f64; 5] {
    let Flexibility { top, coupling, bottom, equal_top, equal_bottom } = layer.flexibility(wave).expect("finite");
    [top, coupling, bottom, equal_top, equal_bottom]
}

/// The largest difference of flexibilities, in parts of the faces' own ones; of responses to equal loads, what the laws
/// grant.
fn difference(one: &dyn Layer, two: &dyn Layer) -> f64 {
    let mut largest = 0.0f64;
    for plane in PLANES {
        for wavenumber in WAVENUMBERS {
            let wave = Wave { wavenumber, modulus: 2.0, plane };
            let [a, b] = [one, two].map(|layer| flexibility(layer, &wave));
            let mean = (b[0] * b[2]).abs().sqrt();
            for (k, scale) in [(0, b[0].abs()), (1, mean), (2, b[2].abs())] {
                largest = largest.max((a[k] - b[k]).abs() / scale);
            }
            let equal = b[3].abs().max(b[4].abs());
            let rounding = conformance::ROUNDING * wavenumber.powi(2).min(1.0) * b[0].abs().max(b[2].abs());
            for k in [3, 4] {
                let excess = ((a[k] - b[k]).abs() - rounding).max(0.0);
                largest = largest.max(1e-3 * excess / equal);
            }
        }
    }
    largest
}

#[test]
fn an_exponential_profile_is_an_exponential_layer() {
    for poisson in [0.0, 0.25, 0.5] {
        for beta in [-20.0, -8.0, -1.0, 1e-6, 0.5, 1.0, 8.0, 20.0] {
            let profile = Profile::exponential(3.0, beta).expect("legal");
            let graded = Graded::new(1.0, profile, constant(poisson)).expect("legal");
            let exponential = Exponential::new(1.0, 3.0, poisson, beta).expect("legal");
            let difference = difference(&graded, &exponential);
            assert!(difference < 1e-11, "ν = {poisson}, β = {beta}: {difference:e}");
        }
    }
}

#[test]
fn a_profile_that_does_not_vary_is_a_homogeneous_layer() {
    let homogeneous = Homogeneous::new(1.0, 3.0, 0.25).expect("legal");
    for profile in [
        Profile::linear(3.0, 3.0),
        Profile::power(3.0, 0.1, 0.0),
        Profile::sigmoid(3.0, 3.0, 0.5, 0.01),
        Profile::table(&[(0.0, 3.0), (0.3, 3.0), (2.0, 3.0)]),
    ] {
        let difference = difference(&graded_by(profile.expect("legal")), &homogeneous);
        assert!(difference < 1e-12, "{difference:e}");
    }
}

#[test]
fn a_table_of_a_smooth_profile_approaches_it() {
    // piecewise linear: the error falls with the square of the number of rows
    let smooth = graded_by(Profile::exponential(1.0, 2.0).expect("legal"));
    let errors = [8, 16, 32].map(|n: u32| {
        let rows: Vec<(f64, f64)> =
            (0..=n).map(|k| f64::from(k) / f64::from(n)).map(|d| (d, (2.0 * d).exp())).collect();
        let wave = Wave { wavenumber: 3.0, modulus: 1.0, plane: Plane::Strain };
        (flexibility(&table(&rows), &wave)[0] / flexibility(&smooth, &wave)[0] - 1.0).abs()
    });
    assert!(errors[0] < 0.01 && errors.windows(2).all(|pair| (3.8..4.2).contains(&(pair[0] / pair[1]))), "{errors:?}");
}

#[test]
fn kinks_are_found_by_those_who_do_not_know_of_them() {
    // the same table, once with its kinks told, once as a function
    let rows = [(0.0, 1.0), (0.25, 4.0), (0.6, 2.0), (1.0, 9.0)];
    let told = table(&rows);
    let profile = Profile::<Positive>::table(&rows).expect("legal");
    let found = Graded::with(1.0, move |d| Isotropic { shear_modulus: profile.at(d, 1.0), poisson: 0.25 });
    let difference = difference(&told, &found.expect("legal"));
    assert!(difference < 1e-11, "{difference:e}");
}

#[test]
fn orthotropic_layers_become_isotropic_ones() {
    for poisson in [0.0, 0.25, 0.45] {
        let young = 2.0 * (1.0 + poisson);
        let isotropic = Homogeneous::new(1.0, 1.0, poisson).expect("legal");
        // roots coincide at 0, are real on one side of it and complex on the other
        for distance in [-1e-3, -1e-6, -1e-9, -1e-12, 0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3] {
            let constants = EngineeringConstants::new([young; 3], [poisson; 3], 1.0 + distance).expect("legal");
            let layer = Orthotropic::new(1.0, constants).expect("legal");
            let difference = difference(&layer, &isotropic);
            assert!(difference < 4.0 * distance.abs() + 1e-12, "ν = {poisson}, {distance:e}: {difference:e}");
            for plane in PLANES {
                let [a, b] = [
                    OrthotropicHalfPlane::new(constants).face_states(&Wave { wavenumber: 3.0, modulus: 2.0, plane }),
                    HalfPlane::new(1.0, poisson).expect("legal").face_states(&Wave {
                        wavenumber: 3.0,
                        modulus: 2.0,
                        plane,
                    }),
                ]
                .map(|states| compliance(&states));
                assert!((a / b - 1.0).abs() < 2.0 * distance.abs() + 1e-14, "{distance:e}: {a} {b}");
            }
        }
    }
}

/// λμ₀V of a half-plane under S = 1, T = 0.
fn compliance(states: &FaceStates) -> f64 {
    let FaceStates::HalfPlane { top } = states else { panic!("one face") };
    let determinant = top[(2, 0)] * top[(3, 1)] - top[(2, 1)] * top[(3, 0)];
    (top[(1, 0)] * top[(3, 1)] - top[(1, 1)] * top[(3, 0)]) / determinant
}

#[test]
fn a_graded_half_plane_without_grading_is_a_half_plane() {
    for poisson in [-0.5, 0.0, 0.25, 0.5] {
        let plain = HalfPlane::new(3.0, poisson).expect("legal");
        for beta in [0.0, 1e-300, 1e-12, 1e-6, 1e-3] {
            let graded = GradedHalfPlane::new(3.0, poisson, beta).expect("legal");
            let power = PowerHalfPlane::new(3.0, poisson, 1.0, beta).expect("legal");
            for plane in PLANES {
                let wave = Wave { wavenumber: 2.0, modulus: 5.0, plane };
                let layers: [&dyn Layer; 3] = [&graded, &power, &plain];
                let [a, b, c] = layers.map(|layer| compliance(&layer.face_states(&wave)));
                for found in [a, b] {
                    assert!((found / c - 1.0).abs() < beta + 1e-14, "ν = {poisson}, β = {beta}: {found} {c}");
                }
            }
        }
    }
}

#[test]
fn a_graded_half_plane_is_a_thick_exponential_layer() {
    for (poisson, beta) in [(0.25, 1.0), (0.4, 5.0), (0.0, 30.0)] {
        let ground: &dyn Layer = &GradedHalfPlane::new(3.0, poisson, beta).expect("legal");
        let layer = Exponential::new(40.0 / beta, 3.0, poisson, beta).expect("legal");
        for wavenumber in [2.0, 7.0, 1e3] {
            let wave = Wave { wavenumber: beta * wavenumber, modulus: 2.0, plane: Plane::Strain };
            let (a, b) = (compliance(&ground.face_states(&wave)), flexibility(&layer, &wave)[0]);
            assert!((a / b - 1.0).abs() < 1e-13, "β = {beta}, λ = {wavenumber}: {a} {b}");
        }
    }
}

#[test]
fn what_is_remembered_changes_no_digit() {
    let layers: [std::sync::Arc<dyn Layer>; 5] = [
        std::sync::Arc::new(Homogeneous::new(0.7, 1.0, 0.25).expect("legal")),
        // too steep for a closed form of long waves inside
        std::sync::Arc::new(Exponential::new(1.0, 1.0, 0.25, -21.5).expect("legal")),
        std::sync::Arc::new(table(&[(0.0, 1.0), (0.2, 4.0), (1.0, 9.0)])),
        std::sync::Arc::new(Orthotropic::new(0.7, ply()).expect("legal")),
        std::sync::Arc::new(graded_by(Profile::sigmoid(1.0, 9.0, 0.4, 0.05).expect("legal"))),
    ];
    for layer in layers {
        let remembering = graded::Remembering::of(layer.clone());
        for plane in PLANES {
            for wavenumber in WAVENUMBERS.into_iter().rev().chain(WAVENUMBERS) {
                for modulus in [1.0, 3.0] {
                    let wave = Wave { wavenumber, modulus, plane };
                    assert_eq!(layer.face_states(&wave), remembering.face_states(&wave));
                    let depths = [0.0, 0.11, 0.35, 0.6];
                    assert_eq!(layer.states(&wave, &depths), remembering.states(&wave, &depths));
                }
            }
        }
    }
}

#[test]
fn depths_inside_that_were_among_others_before_find_the_same_fields() {
    let layer: std::sync::Arc<dyn Layer> = std::sync::Arc::new(table(&[(0.0, 1.0), (0.2, 4.0), (1.0, 9.0)]));
    let remembering = graded::Remembering::of(layer.clone());
    for wavenumber in [0.3, 4.0, 60.0] {
        let wave = Wave { wavenumber, modulus: 1.0, plane: Plane::Strain };
        // stresses on both faces from the amplitudes, so that their choice does not matter
        let inside = |layer: &dyn Layer, depths: &[f64]| {
            let states = layer.states(&wave, depths);
            let FaceStates::Finite { top, bottom, .. } = states.faces else { panic!("two faces") };
            let rows = nalgebra::Matrix4::from_fn(|i, j| if i < 2 { top[(i + 2, j)] } else { bottom[(i, j)] });
            let amplitudes = rows.lu().solve(&nalgebra::Vector4::new(1.0, 0.0, 0.5, 0.1)).expect("determined");
            states.inside.iter().map(|state| state.columns * amplitudes).collect::<Vec<_>>()
        };
        inside(&*remembering, &[0.1, 0.5, 0.8]);
        let (found, expected) = (inside(&*remembering, &[0.5, 0.8]), inside(&*layer, &[0.5, 0.8]));
        for (found, expected) in found.iter().zip(&expected) {
            assert!((found - expected).amax() < 1e-9 * expected.amax().max(1.0), "{wavenumber}: {found} {expected}");
        }
    }
}

/// What a scene may say of each layer that ships.
const WRITTEN: [(&str, &str); 8] = [
    ("Homogeneous", "(thickness: 1.5, shear_modulus: 2.5, poisson: 0.25)"),
    ("Exponential", "(thickness: 1.5, shear_modulus: 2.5, poisson: 0.25, beta: 0.75)"),
    ("Graded", "(thickness: 1.5, shear_modulus: Power(surface: 2.5, length: 0.5, exponent: 1.25), poisson: 0.25)"),
    (
        "Orthotropic",
        "(thickness: 1.5, young: (x: 14.5, y: 1.25, z: 1.5), poisson: (xy: 0.25, xz: 0.35, yz: 0.45), shear_modulus: 0.5)",
    ),
    ("HalfPlane", "(shear_modulus: 2.5, poisson: 0.25)"),
    ("GradedHalfPlane", "(shear_modulus: 2.5, poisson: 0.25, beta: 0.75)"),
    ("PowerHalfPlane", "(shear_modulus: 2.5, poisson: 0.25, length: 0.5, exponent: 0.75)"),
    (
        "OrthotropicHalfPlane",
        "(young: (x: 14.5, y: 1.25, z: 1.5), poisson: (xy: 0.25, xz: 0.35, yz: 0.45), shear_modulus: 0.5)",
    ),
];

/// A text in RON.
fn node(text: &str) -> Node {
    Node::from_ron(text).expect("RON")
}

#[test]
fn keys_are_equal_if_all_parameters_are() {
    let registry = Registry::default();
    for (name, text) in WRITTEN {
        let entry = registry.get(name).expect("registered");
        let read = |text: &str| (entry.read)(&node(text)).expect("legal").layer().expect("a layer").clone();
        let layer = read(text);
        assert!(layer.key().is_some() && layer.key() == read(text).key(), "{name}");
        for plane in PLANES {
            assert_eq!(conformance::same_key(&*layer, &*read(text), plane), Ok(()), "{name}");
        }
        // every number in turn, changed by its last digit or so
        let numbers = text.match_indices(|c: char| c.is_ascii_digit() || c == '.').map(|(at, _)| at);
        let starts = numbers.filter(|at| !text[..*at].ends_with(|c: char| c.is_ascii_digit() || c == '.'));
        for start in starts.collect::<Vec<_>>() {
            let length = text[start..].find([',', ')']).expect("something follows");
            let number: f64 = text[start..start + length].parse().expect("a number");
            let changed = format!("{}{:?}{}", &text[..start], number.next_up(), &text[start + length..]);
            assert_ne!(layer.key(), read(&changed).key(), "{changed}");
        }
    }
    let keys: std::collections::HashSet<_> = WRITTEN
        .iter()
        .map(|(name, text)| {
            (registry.get(name).expect("registered").read)(&node(text)).expect("legal").layer().expect("a layer").key()
        })
        .collect();
    assert_eq!(keys.len(), WRITTEN.len(), "types differ");
}

/// A layer read by its registered name, and how it is written in drawings.
fn read(name: &str, fields: &str) -> Result<String, String> {
    let registry = Registry::default();
    let entry = registry.get(name).expect("registered");
    let read = (entry.read)(&node(fields)).map(|layer| layer.notation());
    read.map(|n| format!("{}({})", n.kind, n.parameters)).map_err(|error| {
        let field = error.field.as_deref().unwrap_or("-");
        format!("{field}: {error}")
    })
}

#[test]
fn layers_are_written_as_they_are_read() {
    for (name, fields) in [
        ("Graded", "(thickness: 1.0, shear_modulus: Power(surface: 1.0, length: 1.0, exponent: 0.5), poisson: 0.25)"),
        ("Graded", "(thickness: 1.0, shear_modulus: Linear(top: 1.0, bottom: 2.0), poisson: 0.25)"),
        ("Graded", "(thickness: 1.0, shear_modulus: Exponential(surface: 1e-7, beta: -2.0), poisson: 0.25)"),
        (
            "Graded",
            "(thickness: 1.0, shear_modulus: Table([(0.0, 1.0), (0.5, 3.0), (1.0, 1.0)]), \
             poisson_profile: Sigmoid(top: 0.1, bottom: 0.3, centre: 0.5, width: 0.1))",
        ),
        ("Graded", "(thickness: 2.0, young: RelativeTable([(0.0, 1.0), (0.5, 3.0), (1.0, 1.0)]), poisson: 0.25)"),
        (
            "Orthotropic",
            "(thickness: 1.0, young: (x: 140.0, y: 10.0, z: 10.0), poisson: (xy: 0.3, xz: 0.3, yz: 0.4), \
             shear_modulus: 5.0)",
        ),
        (
            "OrthotropicHalfPlane",
            "(young: (x: 140.0, y: 10.0, z: 10.0), poisson: (xy: 0.3, xz: 0.3, yz: 0.4), shear_modulus: 5.0)",
        ),
        ("GradedHalfPlane", "(shear_modulus: 1.0, poisson: 0.25, beta: 0.5)"),
        ("PowerHalfPlane", "(shear_modulus: 1.0, poisson: 0.25, length: 2.0, exponent: 0.5)"),
        ("Winkler", "(stiffness: 2.0)"),
        ("Winkler", "(stiffness: 2.0, shear_stiffness: 0.5)"),
    ] {
        let written = read(name, fields).expect(fields);
        assert_eq!(written, format!("{name}{fields}"));
    }
}

#[test]
fn wrong_layers_are_refused() {
    for (name, fields, message) in [
        (
            "Graded",
            "(thickness: 1.0, shear_modulus: Linear(top: 1.0, bottom: -2.0), poisson: 0.25)",
            "shear_modulus.bottom: found -2.0, allowed is a finite number > 0",
        ),
        (
            "Graded",
            "(thickness: 1.0, shear_modulus: Table([(0.0, 1.0), (0.5, 0.0)]), poisson: 0.25)",
            "shear_modulus: found 0.0, allowed is a finite number > 0",
        ),
        (
            "Graded",
            "(thickness: 1.0, shear_modulus: Table([(0.0, 1.0), (0.5, 3.0)]), poisson: 0.25)",
            "-: shear_modulus: the table ends at depth 0.5; allowed is the thickness, 1.0, or more",
        ),
        (
            "Graded",
            "(thickness: 1.0, shear_modulus: Table([(0.1, 1.0), (1.0, 3.0)]), poisson: 0.25)",
            "shear_modulus: the table begins at depth 0.1; allowed is 0",
        ),
        (
            "Graded",
            "(thickness: 1.0, shear_modulus: Linear(top: 1.0, bottom: 2.0))",
            "-: found none of `poisson` and `poisson_profile`; allowed is one of them",
        ),
        (
            "Graded",
            "(thickness: 1.0, shear_modulus: Exponential(surface: 1.0, beta: 40.0), poisson: 0.25)",
            "-: shear_modulus varies by a factor of 2.3538526683702e17; allowed is 1e13 or less",
        ),
        (
            "GradedHalfPlane",
            "(shear_modulus: 1.0, poisson: 0.25, beta: -0.5)",
            "beta: found -0.5, allowed is a finite number >= 0 (a half-plane that softens without end carries no force)",
        ),
        (
            "OrthotropicHalfPlane",
            "(young: (x: 1.0, y: 4.0, z: 1.0), poisson: (xy: 0.6, xz: 0.3, yz: 0.4), shear_modulus: 5.0)",
            "-: poisson.xy: found 0.6, allowed is -0.5 < poisson.xy < 0.5",
        ),
    ] {
        assert_eq!(read(name, fields), Err(message.to_owned()));
    }
}

#[test]
fn springs_are_a_support() {
    for springs in [Winkler::new(0.3), Winkler::new(0.3).and_then(|springs| springs.sticking(2.0))] {
        let springs = springs.expect("legal");
        for plane in PLANES {
            assert_eq!(conformance::support(&springs, plane), Ok(()));
        }
    }
}

#[test]
fn a_support_that_drives_what_lies_on_it_is_caught() {
    #[derive(Debug)]
    struct Spoiled(fn(&mut nalgebra::Matrix4x2<f64>));
    impl Support for Spoiled {
        fn face_states(&self, wave: &Wave) -> nalgebra::Matrix4x2<f64> {
            let mut states =
                Winkler::new(0.3).and_then(|springs| springs.sticking(2.0)).expect("legal").face_states(wave);
            self.0(&mut states);
            states
        }
    }
    for (spoil, said) in [
        ((|states| states[(2, 1)] *= -1.0) as fn(&mut nalgebra::Matrix4x2<f64>), "U T + V S of one state"),
        (|states| states[(1, 0)] += 0.5, "U₁T₂ − T₁U₂"),
        (|states| states[(0, 0)] = f64::NAN, "a number of a state"),
        (|states| states.fill_column(1, 0.0), "the largest number of a state"),
    ] {
        let violation = conformance::support(&Spoiled(spoil), Plane::Strain).expect_err(said);
        assert!(violation.quantity.starts_with(said), "{violation}");
    }
}
