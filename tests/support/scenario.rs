//! Random stacks under a punch, as plain numbers that a test may change before it solves them.
use std::f64::consts::FRAC_PI_2;

use proptest::prelude::*;
use recede::{Error, Exponential, HalfPlane, Homogeneous, Item, Model, NoSolution, Plane, Punch, Solution, Stack};

/// A layer is looked at in so many depths.
const PARTS: usize = 100;
/// Laminates that bend more than this by themselves are left out.
const STRAIGHT: f64 = 0.05;
/// Laminates that bend down more than about 0.1 need not lift off from a rigid base at all.
const LIFTS_OFF: f64 = 0.08;

/// A layer, and the interface below it.
#[derive(Clone, Debug)]
pub struct Layer {
    /// Thickness.
    pub thickness: f64,
    /// Shear modulus at the top face.
    pub modulus: f64,
    /// Poisson's ratio.
    pub poisson: f64,
    /// βh of a graded layer, `None` for a homogeneous one.
    pub steepness: Option<f64>,
    /// Whether it is free to lift off from what is below.
    pub receding: bool,
}

/// A punch on layers on a base.
#[derive(Clone, Debug)]
pub struct Scenario {
    /// Plane strain or plane stress.
    pub plane: Plane,
    /// The layers from the top down.
    pub layers: Vec<Layer>,
    /// Shear modulus and Poisson's ratio of the half-plane; `None` is a rigid base.
    pub base: Option<(f64, f64)>,
    /// Whether the punch is a circle rather than a parabola.
    pub cylinder: bool,
    /// Radius of the punch.
    pub radius: f64,
    /// Line load.
    pub force: f64,
}

impl Layer {
    /// The layer as it stands in a stack.
    pub fn item(&self) -> Item {
        let Self { thickness, modulus, poisson, .. } = *self;
        match self.steepness {
            None => Item::layer(Homogeneous::new(thickness, modulus, poisson).unwrap()),
            Some(_) if thickness == 0.0 => Item::layer(Exponential::new(0.0, modulus, poisson, 1.0).unwrap()),
            Some(steepness) => {
                Item::layer(Exponential::new(thickness, modulus, poisson, steepness / thickness).unwrap())
            }
        }
    }

    /// The interface below it.
    pub fn interface(&self) -> Item {
        if self.receding { Item::Receding } else { Item::Bonded }
    }

    /// The layer cut in two, the upper part having this share of the thickness.
    pub fn cut(&self, share: f64) -> [Self; 2] {
        let steepness = |share: f64| self.steepness.map(|steepness| steepness * share);
        let upper =
            Self { thickness: share * self.thickness, steepness: steepness(share), receding: false, ..self.clone() };
        let lower = Self {
            thickness: (1.0 - share) * self.thickness,
            modulus: self.modulus * steepness(share).unwrap_or(0.0).exp(),
            steepness: steepness(1.0 - share),
            ..self.clone()
        };
        [upper, lower]
    }
}

impl Scenario {
    /// The items of the stack.
    pub fn items(&self) -> Vec<Item> {
        let base = match self.base {
            Some((modulus, poisson)) => Item::layer(HalfPlane::new(modulus, poisson).unwrap()),
            None => Item::Rigid,
        };
        self.layers.iter().flat_map(|layer| [layer.item(), layer.interface()]).chain([base]).collect()
    }

    /// The punch.
    pub fn punch(&self) -> Punch {
        if self.cylinder { Punch::cylinder(self.radius) } else { Punch::parabola(self.radius) }.unwrap()
    }

    /// Thickness of all layers.
    pub fn thickness(&self) -> f64 {
        self.layers.iter().map(|layer| layer.thickness).sum()
    }

    /// How much a free laminate bends as a whole where both its faces are pressed, compared with how far a line load
    /// spreads in it; positive where its ends go down.
    ///
    /// Pressure makes a layer longer. If this bends the ends down more than the spreading load bends them up, a laminate
    /// does not lift off from what it lies on, or touches it again further out.
    fn bending_under_equal_loads(&self) -> f64 {
        let laminates = self.layers.split_inclusive(|layer| layer.receding);
        let bending =
            laminates.filter(|laminate| laminate.last().is_some_and(|layer| layer.receding)).map(|laminate| {
                let (mut height, mut stiffness, mut stiffness_moment, mut push, mut push_moment) =
                    (0.0, 0.0, 0.0, 0.0, 0.0);
                for layer in laminate {
                    let Item::Layer(body) = layer.item() else { continue };
                    for part in 0..PARTS {
                        let depth = layer.thickness * (part as f64 + 0.5) / PARTS as f64;
                        let material = body.material(depth, self.plane);
                        let (share, y) = (layer.thickness / PARTS as f64, -height - depth);
                        stiffness += share * material.axial_stiffness;
                        stiffness_moment += share * material.axial_stiffness * y;
                        push += share * material.coupling;
                        push_moment += share * material.coupling * y;
                    }
                    height += layer.thickness;
                }
                (push_moment - push * stiffness_moment / stiffness) / height.powi(2)
            });
        bending.fold(0.0, |largest: f64, one| if one.abs() > largest.abs() { one } else { largest })
    }

    /// Solves it.
    ///
    /// # Errors
    /// Those of the solver.
    pub fn solve(&self) -> Result<Solution, Error> {
        solve(self.plane, &self.items(), &self.punch(), self.force)
    }

    /// Solves it, or looks for another one if a contact has more than one part.
    ///
    /// # Errors
    /// Those of the solver.
    pub fn solve_if_in_one_part(&self) -> Result<Solution, TestCaseError> {
        self.solve().map_err(|error| match error {
            Error::NoSolution(NoSolution::Tension { .. } | NoSolution::Overlap { .. }) => {
                TestCaseError::reject("a contact has more than one part")
            }
            _ => TestCaseError::fail(error.to_string()),
        })
    }
}

/// Solves a stack of items.
///
/// # Errors
/// Those of the solver.
pub fn solve(plane: Plane, items: &[Item], punch: &Punch, force: f64) -> Result<Solution, Error> {
    Model::new(Stack::from_items(plane, items)?)?.press(punch, force)
}

fn layer() -> impl Strategy<Value = Layer> {
    let steepness = prop_oneof![Just(None), (-3.0..3.0f64).prop_map(Some)];
    (0.2..5.0f64, 0.2..5.0f64, 0.0..=0.5f64, steepness, any::<bool>()).prop_map(
        |(thickness, modulus, poisson, steepness, receding)| Layer { thickness, modulus, poisson, steepness, receding },
    )
}

/// One to three layers on a half-plane or a rigid base, pressed so that a/H is about 0.01 to 1; none that bends so much
/// by itself that its contact has more than one part, or no end.
pub fn scenario() -> impl Strategy<Value = Scenario> {
    any_scenario().prop_filter("bends by itself", |scenario| scenario.bending_under_equal_loads().abs() < STRAIGHT)
}

/// The same, with layers that may bend so much that a contact has more than one part.
pub fn curved_scenario() -> impl Strategy<Value = Scenario> {
    any_scenario().prop_filter("does not lift off", |scenario| scenario.bending_under_equal_loads() < LIFTS_OFF)
}

fn any_scenario() -> impl Strategy<Value = Scenario> {
    let base = prop_oneof![2 => (0.2..5.0f64, 0.0..=0.5f64).prop_map(Some), 1 => Just(None)];
    let plane = prop_oneof![Just(Plane::Strain), Just(Plane::Stress)];
    let wide = (0.01f64.ln()..0.0).prop_map(f64::exp);
    (prop::collection::vec(layer(), 1..=3), base, plane, any::<bool>(), 20.0..500.0f64, wide).prop_map(
        |(layers, base, plane, cylinder, blunt, wide)| {
            let thickness: f64 = layers.iter().map(|layer| layer.thickness).sum();
            let radius = blunt * thickness;
            // as if the top layer were all
            let force = FRAC_PI_2 * (wide * thickness).powi(2) * layers[0].modulus / radius;
            Scenario { plane, layers, base, cylinder, radius, force }
        },
    )
}

/// The same without graded layers.
pub fn homogeneous() -> impl Strategy<Value = Scenario> {
    scenario().prop_map(|mut scenario| {
        scenario.layers.iter_mut().for_each(|layer| layer.steepness = None);
        scenario
    })
}

/// Largest relative difference of half-lengths and of pressures, where those of `found` are multiplied by factors.
pub fn difference(found: &Solution, length: f64, pressure: f64, expected: &Solution) -> f64 {
    let pairs = found.contacts().iter().zip(expected.contacts());
    assert_eq!(found.contacts().len(), expected.contacts().len());
    let one = pairs.map(|(found, expected)| {
        let half_lengths = (found.half_length * length / expected.half_length - 1.0).abs();
        let at = |s: f64| {
            let found = found.pressure(s * found.half_length) * pressure;
            (found - expected.pressure(s * expected.half_length)).abs() / expected.peak_pressure
        };
        // the tolerance is one on half-lengths and on the pressure at x = 0: elsewhere the highest modes are felt
        let elsewhere = [0.3, 0.6, 0.9].map(|s| 1e-3 * at(s));
        elsewhere.into_iter().fold(half_lengths.max(at(0.0)), f64::max)
    });
    one.fold(0.0, f64::max)
}
