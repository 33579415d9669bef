//! Random scenes with punches, loads, layers, interfaces and bases of all kinds, and with several punches at once.
use proptest::prelude::*;
use recede_layers::{
    EngineeringConstants, Graded, GradedHalfPlane, HalfPlane, Homogeneous, Loaded, Orthotropic, Plane, PowerHalfPlane,
    Profile, Winkler,
};

use super::scenario::{Ply, Scenario};
use super::strategy::{Ranges, drawn, scenes};
use crate::errors::Error;
use crate::geometry::Geometry;
use crate::scene::{Force, Item, Load, Loads, Pressed, Punch, Punches, Scene, Spring, Tilt, Top, ValueError};

/// In a table the punch ends at this many times the half-length that is aimed at.
const TABLE_ENDS: f64 = 6.0;
const ROWS: usize = 16;
/// Punches at most.
const MOST: usize = 4;
/// Gaps are no steeper than this, above which linear elasticity is an approximation only.
const STEEPEST: f64 = 0.3;
/// Of rollers with a smaller number for their size the place where the contact ends is prescribed.
const HELD: f64 = 0.25;

/// The kinds in place of a parabola, of layers, of bonds, and of a half-plane; a number beyond the kinds changes nothing.
#[derive(Clone, Debug)]
struct Kinds {
    punch: usize,
    layers: Vec<(usize, f64)>,
    joints: Vec<(usize, f64, f64)>,
    base: usize,
    /// A number from 0 to 1 that every kind makes something else of.
    share: f64,
}

fn kinds(ranges: &Ranges) -> impl Strategy<Value = Kinds> + use<> {
    let stiffness = -3.0..3.0f64;
    let joint = (0..6usize, stiffness.clone(), stiffness);
    let joints = prop::collection::vec(joint, *ranges.layers.end());
    let layers = prop::collection::vec((0..12usize, -1.0..1.0f64), *ranges.layers.end());
    let all = (0..16usize, joints, 0..10usize, 0.0..=1.0f64, layers);
    all.prop_map(|(punch, joints, base, share, layers)| Kinds { punch, layers, joints, base, share })
}

/// One of the [`scenes`] with punches, loads, interfaces and bases of all kinds: the same seed and number give the same
/// scene, whatever else is drawn.
///
/// # Errors
/// [`Error::Value`] or [`Error::Layer`] if a number is no longer finite in the units of the ranges.
pub fn scene_of_any_kind(ranges: &Ranges, seed: u64, number: u64) -> Result<Scene, Error> {
    let (scenario, kinds) = drawn(&(scenes(ranges), kinds(ranges)), seed, number);
    let width = contact_width(&scenario, scenario.radius);
    kinds.scene(&scenario, (kinds.top(&scenario)?, scenario.force), width, ranges.units.stress)
}

/// One of the scenes of all kinds, with one to four punches of other kinds in place of what presses there: the same seed and number give the same scene.
///
/// # Errors
/// None in practice.
pub fn scene_with_punches(ranges: &Ranges, seed: u64, number: u64) -> Result<Scene, Error> {
    let numbers = prop::array::uniform3(0.0..=1.0f64);
    let all = prop::collection::vec((0..6usize, 0..3usize, numbers), 1..=MOST);
    // the stack is the one of the scene of this number
    let (scenario, kinds) = drawn(&(scenes(ranges), kinds(ranges)), seed, number);
    let (_, drawn) = drawn(&(scenes(ranges), all), seed, number);
    let punches = punches(&scenario, &drawn)?;
    let (force, width) = (punches.pressed_by(), contact_width(&scenario, scenario.radius));
    let span = punches.parts().fold(width, |span, (pressed, _)| span.max(pressed.at()));
    kinds.scene(&scenario, (Top::from(punches), force), span, ranges.units.stress)
}

/// The same scene about an axis, with several loads about axes of their own or, where layers come apart, the last one as a ring, and layers and a base of isotropic
/// materials in place of orthotropic ones, as stiff against shear.
pub fn about_axis(mut scene: Scene) -> Scene {
    scene.geometry = Geometry::Axisymmetric;
    if let Top::Loads(loads) = &scene.top
        && loads.alone().is_none()
    {
        let ring = loads.parts().last().map(|(load, at, _)| Load::ring(at, load.half_width().max(1e-3 * at)));
        let apart = |(load, at, share): (&Load, f64, f64)| (load.clone(), [at, share * at], share * loads.force());
        let apart = Loads::about_axes(&loads.parts().map(apart).collect::<Vec<_>>()).map(Top::from);
        let is_loose = scene.stack.iter().any(|item| matches!(item, Item::Receding | Item::RecedingGap(_)));
        scene.top = match apart {
            Ok(apart) if !is_loose => apart,
            _ => ring.and_then(Result::ok).unwrap_or(Load::Line).into(),
        };
    }
    for item in &mut scene.stack {
        if matches!(&*item, Item::RecedingGap(gap) if gap.shape().even_curvature().is_none()) {
            *item = Item::Receding;
        }
        let Item::Layer(layer) = &*item else { continue };
        let modulus = layer.material(0.0, Plane::Strain).shear_compliance.recip();
        let isotropic = match (layer.notation().kind, layer.thickness()) {
            ("Orthotropic", Some(thickness)) => Homogeneous::new(thickness, modulus, 0.2).map(Item::layer),
            ("OrthotropicHalfPlane", None) => HalfPlane::new(modulus, 0.2).map(Item::layer),
            _ => continue,
        };
        // the numbers belong to a legal layer
        *item = isotropic.unwrap_or_else(|_| item.clone());
    }
    scene
}

impl Kinds {
    /// What presses on the layers as far out as a distance.
    fn scene(
        &self,
        scenario: &Scenario,
        (top, force): (Top, impl Into<Force>),
        span: f64,
        stress: f64,
    ) -> Result<Scene, Error> {
        let items = self.items(scenario, span, stress)?;
        let pressure_on_top = self.pressure_on_top(scenario, &items);
        let mut scene = Scene::new(scenario.plane, top, force, items);
        scene.pressure_on_top = pressure_on_top;
        Ok(scene)
    }

    /// A punch of about the curvature of the scenario's, over the contact that this has on a half-plane, or loads.
    fn top(&self, scenario: &Scenario) -> Result<Top, ValueError> {
        let (radius, share) = (scenario.radius, self.share);
        let width = contact_width(scenario, radius);
        let height = 0.5 * width * width / radius;
        let punch = match self.punch {
            0 => Punch::wedge(width / radius),
            1 => Punch::power(1.0 + 5.0 * share, width, height),
            2 => Punch::polynomial(width, &[height, share * height, 0.3 * height]),
            3 => Punch::rounded_flat(share * width, radius),
            4 => {
                let row = |i: usize| {
                    let s = TABLE_ENDS * i as f64 / ROWS as f64;
                    (s * width, height * s * s * (1.0 + 0.2 * share * s))
                };
                Punch::table(&(0..=ROWS).map(row).collect::<Vec<_>>())
            }
            5 => Punch::elastic_cylinder(radius, scenario.layers[0].modulus * 10f64.powf(6.0 * share - 3.0), 0.3),
            6 => return Ok(Load::Line.into()),
            7 => return Load::uniform(width).map(Top::from),
            8 => return Load::parabolic(width).map(Top::from),
            9 => return Load::elliptic(width).map(Top::from),
            10 => Punch::flat(width),
            11 => return self.several(width).map(Top::from),
            // lowest on either side of x = 0
            12 => Punch::polynomial(width, &[-share * height, height]),
            _ => scenario.punch(),
        };
        punch.map(Top::from)
    }

    /// Two strips and a line on one side, and every second time their mirror images.
    fn several(&self, width: f64) -> Result<Loads, ValueError> {
        let part = 0.5 * width;
        let strips =
            [(Load::parabolic(part)?, 0.5 * part, 0.1 + self.share), (Load::uniform(part)?, self.share * width, 1.0)];
        let is_mirrored = (10.0 * self.share).fract() < 0.5;
        let mut loads = vec![(Load::Line, 0.0, 0.1)];
        for (load, at, force) in strips {
            loads.extend(is_mirrored.then(|| (load.clone(), -at, force)));
            loads.push((load, at, force));
        }
        Loads::new(&loads)
    }

    /// Loose layers are pressed together in some scenes.
    fn pressure_on_top(&self, scenario: &Scenario, items: &[Item]) -> f64 {
        match self.joints.first() {
            Some((3, normal, _)) if items.iter().any(Item::is_receding) => pressed_with(scenario, *normal / 3.0),
            _ => 0.0,
        }
    }

    /// The items of the stack, with this unit of stress. Gaps are no steeper than small slopes allow, parabolic ones as far out as loads press: layers would roll on these, or bend into them, by large angles.
    fn items(&self, scenario: &Scenario, span: f64, stress: f64) -> Result<Vec<Item>, Error> {
        let mut items = scenario.items()?;
        let plies = scenario.layers.iter().zip(&self.layers);
        for (item, (ply, (kind, power))) in items.iter_mut().step_by(2).zip(plies) {
            *item = match kind {
                0 => Item::layer(graded(ply, *power)?),
                1 => Item::layer(orthotropic(ply, *power)?),
                _ => continue,
            };
        }
        for (item, (kind, normal, tangential)) in items.iter_mut().skip(1).step_by(2).zip(&self.joints) {
            let parabola = |radius: f64| Punch::parabola(radius.max(span / STEEPEST));
            // per thickness and modulus of the whole
            let stiffness = |power: &f64| stress * 10f64.powf(*power) / scenario.thickness();
            *item = match (&item, kind) {
                (Item::Bonded, 0) => Item::Sliding,
                (Item::Bonded, 1) => Item::Spring(Spring::new(stiffness(normal), None)?),
                (Item::Bonded, 2) => Item::Spring(Spring::new(stiffness(normal), Some(stiffness(tangential)))?),
                // apart from the start
                (Item::Receding, 0) => Item::RecedingGap(parabola(scenario.radius * 10f64.powf(*normal))?),
                (Item::Receding, 1) => {
                    let half_width = scenario.thickness() * 10f64.powf(tangential / 3.0);
                    let depth = (half_width * half_width / scenario.radius).min(STEEPEST * half_width);
                    Item::RecedingGap(Punch::dent(depth, half_width)?)
                }
                _ => continue,
            };
        }
        // some layers have a weight
        for (item, (kind, power)) in items.iter_mut().step_by(2).zip(&self.layers) {
            if let (Item::Layer(layer), 3) = (&*item, kind)
                && let Some(thickness) = layer.thickness().filter(|thickness| *thickness > 0.0)
            {
                let weight = pressed_with(scenario, *power) / thickness;
                *item = Item::layer(Loaded::of(layer.clone()).with_specific_weight(weight));
            }
        }
        // where nothing is loose, layers may be strained in any direction
        if !items.iter().any(Item::is_receding) {
            for (item, (kind, power)) in items.iter_mut().step_by(2).zip(&self.layers) {
                if let (Item::Layer(layer), 2) = (&*item, kind)
                    && layer.thickness().is_some()
                {
                    *item = Item::layer(Loaded::of(layer.clone()).with_eigenstrain(1e-3 * power));
                }
            }
        }
        let loose = matches!(items.get(items.len().saturating_sub(2)), Some(item) if item.is_receding());
        if let (Some((modulus, poisson)), Some(last)) = (scenario.base, items.last_mut()) {
            let length = scenario.thickness();
            *last = match self.base {
                0 if !loose => Item::support(Winkler::new(modulus / length)?),
                1 => Item::layer(GradedHalfPlane::new(modulus, poisson, self.share / length)?),
                2 => Item::layer(PowerHalfPlane::new(modulus, poisson, length, 1.5 * self.share - 0.5)?),
                _ => return Ok(items),
            };
        }
        Ok(items)
    }
}

/// A pressure with which layers are pressed together: the force is some tens to some thousands of times what presses on a length of the thickness, by a power from −1 to 1.
fn pressed_with(scenario: &Scenario, power: f64) -> f64 {
    scenario.force / (scenario.thickness() * 10f64.powf(2.5 + 1.5 * power))
}

/// From the modulus at the top face to another one by a smooth step.
fn graded(ply: &Ply, power: f64) -> Result<Graded, Error> {
    let Ply { thickness, modulus, poisson, .. } = *ply;
    let step = Profile::sigmoid(modulus, modulus * 10f64.powf(power), 0.5 * thickness, 0.2 * thickness)?;
    Ok(Graded::new(thickness, step, Profile::linear(poisson, 0.5 * poisson)?)?)
}

/// Stiffer or softer along the layers than across them.
fn orthotropic(ply: &Ply, power: f64) -> Result<Orthotropic, Error> {
    let young = 2.5 * ply.modulus;
    let constants = EngineeringConstants::new([young * 3f64.powf(power), young, young], [0.2; 3], ply.modulus)?;
    Ok(Orthotropic::new(ply.thickness, constants)?)
}

/// Of one punch: its kind and tilt, and numbers from 0 to 1 for its size, its distance from the one before, and its angle or the place of its force.
type Drawn = (usize, usize, [f64; 3]);

/// Punches that are about as wide as the contact of the scenario's on a half-plane, one beside the other.
fn punches(scenario: &Scenario, drawn: &[Drawn]) -> Result<Punches, ValueError> {
    let share = scenario.force / drawn.len() as f64;
    let mut all = Vec::new();
    let mut at = 0.0;
    for (kind, tilt, [size, apart, aside]) in drawn {
        let radius = scenario.radius * (0.5 + size);
        let width = contact_width(scenario, radius);
        let (punch, slope) = match kind {
            0 => (Punch::flat(0.5 * width)?, width / radius),
            1 => (Punch::wedge(width / radius)?, 0.7 * width / radius),
            2 => (Punch::uneven_wedge(width / radius, 2.0 * width / radius)?, 0.7 * width / radius),
            3 => (Punch::rounded_flat(0.5 * width, radius)?, width / radius),
            4 => (Punch::cylinder(radius)?, width / radius),
            _ => (Punch::parabola(radius)?, width / radius),
        };
        let aside = 2.0 * aside - 1.0;
        let tilt = match tilt {
            0 => Tilt::Fixed(aside * slope),
            1 => Tilt::Free { eccentricity: 0.4 * aside * width },
            _ => Tilt::None,
        };
        // the place where the contact ends is prescribed of some rollers
        let is_held = *kind > 3 && tilt.angle().is_none_or(|angle| angle == 0.0) && *size < HELD;
        let force = if is_held { Force::ForRight(at + 0.7 * width) } else { Force::Given(share) };
        all.push(Pressed::new(punch, at, force, tilt)?);
        at += width * (4.0 + 8.0 * apart);
    }
    Punches::new(&all)
}

/// Half-length of about the contact that a punch of this radius has on a half-plane, no longer than half of the radius.
fn contact_width(scenario: &Scenario, radius: f64) -> f64 {
    (scenario.force * radius / scenario.layers[0].modulus).sqrt().min(0.5 * radius)
}
