//! Punches on the top face, or the given pressures in their place.
use std::fmt;

use recede_layers::{Isotropic, Positive};

use super::load::Load;
use super::loads::Loads;
use super::punch::Punch;
use super::punches::Punches;
use crate::geometry::Geometry;
use crate::solution::Interface;

/// Longest text of a punch in a label.
const LONGEST: usize = 80;

/// What presses on the top face.
///
/// ```
/// use recede::{Load, Punch, Top};
/// let [punch, load] = [Top::from(Punch::parabola(500.0)?), Top::from(Load::Line)];
/// assert!(punch.punch().is_some() && load.loads().is_some_and(|loads| loads.is_even()));
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Top {
    /// Punches, under which the contacts are to be found; most often one at x = 0.
    Punches(Punches),
    /// Pressures that are given.
    Loads(Loads),
}

impl Top {
    /// The punch, if one presses at x = 0 that is not turned.
    pub fn punch(&self) -> Option<&Punch> {
        self.punches().and_then(Punches::alone)
    }

    /// The punches, be it one, if the pressure is not given.
    pub fn punches(&self) -> Option<&Punches> {
        if let Self::Punches(punches) = self { Some(punches) } else { None }
    }

    /// The loads, if the pressure is given.
    pub fn loads(&self) -> Option<&Loads> {
        if let Self::Loads(loads) = self { Some(loads) } else { None }
    }

    /// The material of an elastic punch; `None` if it is rigid, and for loads.
    pub fn material(&self) -> Option<Isotropic> {
        self.even_punch().and_then(Punch::material)
    }

    /// The punch, if it is an even one by itself that is not turned, wherever its tip is.
    pub(crate) fn even_punch(&self) -> Option<&Punch> {
        self.punches().and_then(Punches::even)
    }

    /// Whether all that presses is its own mirror image about the place where the force acts.
    pub(crate) fn is_even(&self) -> bool {
        match self {
            Self::Punches(punches) => punches.even().is_some(),
            Self::Loads(loads) => loads.centre().is_some(),
        }
    }

    /// Where the force acts on x, in length: the centre of even loads, or else the mean of the places, each with its part of the force.
    pub(crate) fn middle(&self) -> f64 {
        match self {
            Self::Punches(punches) => punches.parts().map(|(pressed, part)| part * pressed.at()).sum(),
            Self::Loads(loads) => loads.centre().unwrap_or_else(|| loads.parts().map(|(_, at, part)| part * at).sum()),
        }
    }

    /// How many punches or loads stand in a list, each with its force; `None` for one about x = 0, which has none of its own.
    fn listed(&self) -> Option<usize> {
        match self {
            Self::Punches(punches) => punches.alone().is_none().then(|| punches.parts().count()),
            Self::Loads(loads) => loads.alone().is_none().then(|| loads.parts().count()),
        }
    }

    /// The words for one punch or load, and for several.
    fn names(&self) -> [&'static str; 2] {
        if self.loads().is_some() { ["load", "loads"] } else { ["punch", "punches"] }
    }

    /// The name of the field of a scene in which it stands.
    pub(super) fn field(&self) -> &'static str {
        self.names()[usize::from(self.listed().is_some())]
    }

    /// The sum of the forces of punches, or of loads.
    pub(crate) fn force(&self) -> f64 {
        match self {
            Self::Punches(punches) => punches.force(),
            Self::Loads(loads) => loads.force(),
        }
    }

    /// As it is written with this sum of forces in a plane scene; `None` for one punch and one load, which have none of their own.
    pub(super) fn written_with(&self, force: f64) -> Option<String> {
        self.listed()?;
        let (mut all, factor) = (self.clone(), force / self.force());
        // as far as numbers reach
        let scale = |own: &mut Positive| {
            *own = Positive::try_from((factor * own.get()).clamp(f64::MIN_POSITIVE, f64::MAX)).unwrap_or(*own);
        };
        match &mut all {
            Self::Punches(Punches(list)) => list.iter_mut().for_each(|pressed| scale(&mut pressed.force)),
            Self::Loads(Loads(list)) => list.iter_mut().for_each(|placed| scale(&mut placed.force)),
        }
        Some(all.to_string())
    }

    /// The name of a contact of the stack below: `load` in place of `punch` under loads.
    pub fn contact_name(&self, interface: Interface) -> String {
        match (interface, self) {
            (Interface::Punch, Self::Loads(_)) => "load".to_owned(),
            _ => interface.to_string(),
        }
    }

    /// As it is written in a scene of this geometry: in an axisymmetric one a cylinder is a sphere, and half-widths are radii.
    pub fn written_in(&self, geometry: Geometry) -> String {
        let load = self.loads().and_then(Loads::alone).map(|load| load.written_in(geometry));
        load.or_else(|| Some(self.punch()?.written_in(geometry))).unwrap_or_else(|| self.to_string())
    }

    /// The punch or load as it is written, or its name alone if that is long; of several their number.
    pub fn label(&self, geometry: Geometry) -> String {
        match self.listed() {
            Some(count) => format!("{count} {}", self.names()[usize::from(count != 1)]),
            None => shortened(self.written_in(geometry)),
        }
    }
}

impl Punch {
    /// As it is written in a scene of this geometry, or its name alone if that is long.
    pub(crate) fn label(&self, geometry: Geometry) -> String {
        shortened(self.written_in(geometry))
    }
}

/// A text, or its name alone if it is long.
fn shortened(text: String) -> String {
    match text.split_once('(') {
        Some((name, _)) if text.chars().count() > LONGEST => format!("{name}(...)"),
        _ => text,
    }
}

impl fmt::Display for Top {
    /// As it is written in a plane scene.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Punches(punches) => punches.fmt(f),
            Self::Loads(loads) => loads.fmt(f),
        }
    }
}

impl From<Punches> for Top {
    fn from(punches: Punches) -> Self {
        Self::Punches(punches)
    }
}

impl From<Loads> for Top {
    fn from(loads: Loads) -> Self {
        Self::Loads(loads)
    }
}

impl From<Punch> for Top {
    /// One punch at x = 0.
    fn from(punch: Punch) -> Self {
        Punches::from(punch).into()
    }
}

impl From<Load> for Top {
    /// One load about x = 0.
    fn from(load: Load) -> Self {
        Loads::from(load).into()
    }
}

impl<T: Clone + Into<Self>> From<&T> for Top {
    fn from(top: &T) -> Self {
        top.clone().into()
    }
}
