//! A scene as plain numbers, which a test may change before it is solved.
use recede_layers::{Exponential, HalfPlane, Homogeneous, Plane};

use crate::errors::Error;
use crate::scene::{Item, Punch, Scene, ValueError};

/// A layer, and the interface below it.
#[derive(Clone, Debug, PartialEq)]
pub struct Ply {
    /// Thickness h, in length.
    pub thickness: f64,
    /// Shear modulus at the top face, in stress.
    pub modulus: f64,
    /// Poisson's ratio, dimensionless.
    pub poisson: f64,
    /// βh of a graded layer, dimensionless; `None` for a homogeneous one.
    pub steepness: Option<f64>,
    /// Whether it is free to lift off from what is below.
    pub receding: bool,
}

/// Units in terms of those that random scenes are drawn in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScenarioUnits {
    /// What a length 1 becomes.
    pub length: f64,
    /// What a stress 1 becomes.
    pub stress: f64,
}

impl Default for ScenarioUnits {
    fn default() -> Self {
        Self { length: 1.0, stress: 1.0 }
    }
}

/// A punch on layers on a base.
#[derive(Clone, Debug, PartialEq)]
pub struct Scenario {
    /// Plane strain or plane stress.
    pub plane: Plane,
    /// The layers from the top down.
    pub layers: Vec<Ply>,
    /// Shear modulus and Poisson's ratio of the half-plane; `None` is a rigid base.
    pub base: Option<(f64, f64)>,
    /// Whether the punch is a circle rather than a parabola.
    pub cylinder: bool,
    /// Radius of the punch, in length.
    pub radius: f64,
    /// Line load, force per unit length out of plane.
    pub force: f64,
}

impl Ply {
    /// The layer as it stands in a stack.
    ///
    /// # Errors
    /// [`Error::Layer`] if a number is not legal.
    pub fn item(&self) -> Result<Item, Error> {
        let Self { thickness, modulus, poisson, .. } = *self;
        Ok(match self.steepness {
            None => Item::layer(Homogeneous::new(thickness, modulus, poisson)?),
            Some(_) if thickness == 0.0 => Item::layer(Exponential::new(0.0, modulus, poisson, 1.0)?),
            Some(steepness) => Item::layer(Exponential::new(thickness, modulus, poisson, steepness / thickness)?),
        })
    }
}

impl Scenario {
    /// The items of the stack.
    ///
    /// # Errors
    /// [`Error::Layer`] if a number is not legal.
    pub fn items(&self) -> Result<Vec<Item>, Error> {
        let mut items = Vec::new();
        for layer in &self.layers {
            items.extend([layer.item()?, if layer.receding { Item::Receding } else { Item::Bonded }]);
        }
        items.push(match self.base {
            Some((modulus, poisson)) => Item::layer(HalfPlane::new(modulus, poisson)?),
            None => Item::Rigid,
        });
        Ok(items)
    }

    /// The punch.
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if the radius is not legal.
    pub fn punch(&self) -> Result<Punch, ValueError> {
        if self.cylinder { Punch::cylinder(self.radius) } else { Punch::parabola(self.radius) }
    }

    /// The scene.
    ///
    /// # Errors
    /// [`Error::Layer`] or [`Error::Value`] if a number is not legal.
    pub fn scene(&self) -> Result<Scene, Error> {
        Ok(Scene::new(self.plane, self.punch()?, self.force, self.items()?))
    }

    /// The same in other units.
    #[must_use]
    pub fn in_units(mut self, ScenarioUnits { length, stress }: ScenarioUnits) -> Self {
        self.radius *= length;
        self.force *= length * stress;
        for layer in &mut self.layers {
            layer.thickness *= length;
            layer.modulus *= stress;
        }
        self.base = self.base.map(|(modulus, poisson)| (modulus * stress, poisson));
        self
    }

    /// Thickness of all layers, in length.
    pub fn thickness(&self) -> f64 {
        self.layers.iter().map(|layer| layer.thickness).sum()
    }
}
