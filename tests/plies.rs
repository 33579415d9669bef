//! Layers left to the general body may lie loose on bodies much thicker than they are.
use proptest::prelude::*;
use recede::layers::Layer;
use recede::{
    BlockSystem, EngineeringConstants, FreeChain, Graded, HalfPlane, Homogeneous, Isotropic, Item, Material, Model,
    Orthotropic, Plane, Profile, Punch, Stack, Wave,
};

/// A material of one's own, the same at all depths, that no closed form tells.
#[derive(Debug)]
struct Own {
    thickness: f64,
    material: Material,
}

impl Layer for Own {
    fn thickness(&self) -> Option<f64> {
        Some(self.thickness)
    }

    fn material(&self, _depth: f64, _plane: Plane) -> Material {
        self.material
    }
}

fn rubber(thickness: f64) -> Homogeneous {
    Homogeneous::new(thickness, 1.0, 0.45).unwrap()
}

fn loose(layer: Item, rubber: Homogeneous) -> Stack {
    Stack::builder(Plane::Strain).item(layer).receding().layer(rubber).bonded().rigid().build().unwrap()
}

fn resolved(stack: Stack, what: &str) -> Model {
    Model::new(stack).unwrap_or_else(|error| panic!("{what}: {error}"))
}

fn half_lengths(model: &Model) -> Vec<f64> {
    let solution = model.press(Punch::parabola(1000.0).unwrap(), 1e-3).unwrap();
    solution.contacts().iter().map(|contact| contact.reach()).collect()
}

fn ply(thickness: f64, shear_modulus: f64) -> Orthotropic {
    let constants = EngineeringConstants::new([135.0, 10.0, 10.0], [0.3, 0.3, 0.4], shear_modulus).unwrap();
    Orthotropic::new(thickness, constants).unwrap()
}

#[test]
fn a_ply_of_any_shear_modulus_lies_on_rubber() {
    for k in 0..200 {
        let shear_modulus = 1.0 + 19.0 * f64::from(k) / 199.0;
        let model = resolved(loose(Item::layer(ply(0.125, shear_modulus)), rubber(10.0)), &format!("{shear_modulus}"));
        if k % 40 == 0 {
            let half_lengths = half_lengths(&model);
            assert!(half_lengths.iter().all(|length| *length > 0.4 && *length < 1.0), "{half_lengths:?}");
        }
    }
}

#[test]
fn a_ply_that_shears_easily_lies_on_a_half_plane() {
    // the ratio of the decay lengths of its fields is 30 E_x/G
    for shear_modulus in [1.0, 0.0119, 0.011, 1e-3, 1e-5] {
        let constants = EngineeringConstants::new([10.0, 1.0, 1.0], [0.3; 3], shear_modulus).unwrap();
        for joint in [Item::Receding, Item::Bonded, Item::Sliding] {
            let stack = Stack::builder(Plane::Strain).layer(Orthotropic::new(1.0, constants).unwrap()).item(joint);
            resolved(stack.layer(HalfPlane::new(1.0, 0.3).unwrap()).build().unwrap(), &format!("{shear_modulus}"));
        }
    }
}

#[test]
fn any_layer_of_the_general_body_lies_on_rubber() {
    let of = |shear_modulus: f64| Isotropic { shear_modulus, poisson: 0.3 };
    let modulus: [fn(f64) -> f64; 4] = [
        |_| 1.0,
        // symmetric about mid-depth, but for rounding
        |d| 1.0 + (d - 0.0625) * (d - 0.0625),
        |d| 1.0 + d,
        // as stiff below as above
        |d| 1.0 + 100.0 * d * d * (0.125 - d),
    ];
    let graded = modulus.map(|modulus| Item::layer(Graded::with(0.125, move |depth| of(modulus(depth))).unwrap()));
    let poisson = || Profile::linear(0.3, 0.3).unwrap();
    let table = Profile::table(&[(0.0, 2.0), (0.04, 1.0), (0.085, 1.0), (0.125, 2.0)]).unwrap();
    let power = Profile::power(1.0, 0.1, -0.5).unwrap();
    let written = [table, power].map(|profile| Item::layer(Graded::new(0.125, profile, poisson()).unwrap()));
    let own = Item::layer(Own { thickness: 0.125, material: ply(0.125, 5.0).material(0.0, Plane::Strain) });
    for layer in graded.into_iter().chain(written).chain([own]) {
        for thickness in [1.0, 10.0, 100.0] {
            let stack = loose(layer.clone(), rubber(thickness));
            resolved(stack.clone(), &stack.to_string());
        }
    }
}

#[test]
fn isotropic_constants_and_one_material_in_a_function_make_a_homogeneous_layer() {
    let isotropic = Isotropic { shear_modulus: 2.0, poisson: 0.3 };
    let constants = EngineeringConstants::new([5.2; 3], [0.3; 3], 2.0).unwrap();
    let expected = half_lengths(&resolved(
        loose(Item::layer(Homogeneous::new(0.125, 2.0, 0.3).unwrap()), rubber(10.0)),
        "homogeneous",
    ));
    for layer in [
        Item::layer(Orthotropic::new(0.125, constants).unwrap()),
        Item::layer(Graded::with(0.125, move |_| isotropic).unwrap()),
        Item::layer(Own { thickness: 0.125, material: isotropic.material(Plane::Strain) }),
    ] {
        let found = half_lengths(&resolved(loose(layer, rubber(10.0)), "one material"));
        assert!(found.iter().zip(&expected).all(|(one, other)| (one / other - 1.0).abs() < 1e-11), "{found:?}");
    }
}

/// A ply of any constants and thickness.
fn random() -> impl Strategy<Value = (f64, EngineeringConstants)> {
    let modulus = || (-1.0..2.5f64).prop_map(|power| 10f64.powf(power));
    let numbers = (-3.0..0.5f64, [modulus(), modulus(), modulus()], modulus(), [-0.4..0.6f64, -0.4..0.6, -0.4..0.6]);
    numbers.prop_filter_map("a legal material", |(thickness, [x, y, z], shear_modulus, [xy, xz, yz])| {
        let poisson = [xy * (x / y).sqrt(), xz * (x / z).sqrt(), yz * (y / z).sqrt()];
        let constants = EngineeringConstants::new([x, y, z], poisson, shear_modulus).ok()?;
        Some((10f64.powf(thickness), constants))
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_plies_lie_on_rubber((thickness, constants) in random()) {
        let layer = Item::layer(Orthotropic::new(thickness, constants).unwrap());
        let model = Model::new(loose(layer, rubber(10.0)));
        prop_assert!(model.is_ok(), "{}", model.unwrap_err());
    }

    /// Flexibilities of a ply and of two halves of it bonded to each other.
    #[test]
    fn cutting_a_ply_changes_nothing((thickness, constants) in random()) {
        let chain = |parts: &[f64]| {
            let layer = |part: &f64| Item::layer(Orthotropic::new(part * thickness, constants).unwrap());
            let first = Stack::builder(Plane::Strain).item(layer(&parts[0]));
            let stack = parts[1..].iter().fold(first, |stack, part| stack.bonded().item(layer(part)));
            FreeChain::all(&BlockSystem::new(&stack.receding().rigid().build().unwrap())).remove(0)
        };
        let (whole, parts) = (chain(&[1.0]), [chain(&[0.5, 0.5]), chain(&[0.2, 0.5, 0.3])]);
        for k in -32..=16 {
            let z = 10f64.powf(0.25 * f64::from(k));
            let wave = Wave { wavenumber: z / thickness, modulus: 1.0, plane: Plane::Strain };
            let expected = whole.flexibility(&wave).unwrap();
            for parts in &parts {
                let found = parts.flexibility(&wave).unwrap();
                let mean = (expected.top * expected.bottom).abs().sqrt();
                prop_assert!((found.top / expected.top - 1.0).abs() < 1e-11, "{z:e} {} {}", found.top, expected.top);
                prop_assert!((found.bottom / expected.bottom - 1.0).abs() < 1e-11, "{z:e}");
                prop_assert!((found.coupling - expected.coupling).abs() < 1e-11 * mean, "{z:e}");
                // layers on each other have the rounding error of bending
                let lost = 1e-13 * mean * z.min(1.0).powi(2);
                prop_assert!((found.equal_top - expected.equal_top).abs() <= 1e-11 * expected.equal_top + lost, "{z:e}");
            }
        }
    }
}
