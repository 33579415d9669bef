//! Random scenes with punches that are several, turned, or pressed beside their tips.
use proptest::prelude::*;

use super::kinds::scene_of_any_kind;
use super::scenario::Scenario;
use super::strategy::{Ranges, drawn, scenes};
use crate::errors::Error;
use crate::scene::{Pressed, Punch, Punches, Scene, Tilt, Top, ValueError};

/// Punches at most.
const MOST: usize = 4;

/// Of one punch: its kind and tilt, and numbers from 0 to 1 for its size, its distance from the one before, and its angle or the place of its force.
type Drawn = (usize, usize, [f64; 3]);

/// One of the scenes of all kinds, with one to four punches of other kinds in place of what presses there: the same seed and number give the same scene.
///
/// # Errors
/// None in practice.
pub fn scene_with_punches(ranges: &Ranges, seed: u64, number: u64) -> Result<Scene, Error> {
    let numbers = prop::array::uniform3(0.0..=1.0f64);
    let all = prop::collection::vec((0..6usize, 0..3usize, numbers), 1..=MOST);
    // the stack is the one of the scene of this number
    let (scenario, drawn) = drawn(&(scenes(ranges), all), seed, number);
    let scene = scene_of_any_kind(ranges, seed, number)?;
    let punches = punches(&scenario, &drawn)?;
    let force = punches.force();
    Ok(Scene::new(scenario.plane, Top::from(punches), force, scene.stack))
}

/// Punches that are about as wide as the contact of the scenario's on a half-plane, one beside the other.
fn punches(scenario: &Scenario, drawn: &[Drawn]) -> Result<Punches, ValueError> {
    let share = scenario.force / drawn.len() as f64;
    let mut all = Vec::new();
    let mut at = 0.0;
    for (kind, tilt, [size, apart, aside]) in drawn {
        let radius = scenario.radius * (0.5 + size);
        let width = (scenario.force * radius / scenario.layers[0].modulus).sqrt().min(0.5 * radius);
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
        all.push(Pressed::new(punch, at, share, tilt)?);
        at += width * (4.0 + 8.0 * apart);
    }
    Punches::new(&all)
}
