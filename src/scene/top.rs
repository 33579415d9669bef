//! What presses on the top face: a punch, or pressures that are given.
use std::fmt;

use recede_layers::Isotropic;

use super::load::Load;
use super::loads::Loads;
use super::punch::Punch;
use super::round::RoundLoad;
use super::text::Written;
use crate::geometry::Geometry;

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
    /// A punch, under which the contact is to be found.
    Punch(Punch),
    /// Pressures that are given.
    Loads(Loads),
}

impl Top {
    /// The punch, if one presses.
    pub fn punch(&self) -> Option<&Punch> {
        if let Self::Punch(punch) = self { Some(punch) } else { None }
    }

    /// The loads, if the pressure is given.
    pub fn loads(&self) -> Option<&Loads> {
        if let Self::Loads(loads) = self { Some(loads) } else { None }
    }

    /// The material of an elastic punch; `None` if it is rigid, and for loads.
    pub fn material(&self) -> Option<Isotropic> {
        self.punch().and_then(Punch::material)
    }

    /// The name of the field of a scene in which it stands.
    pub(super) fn field(&self) -> &'static str {
        match self {
            Self::Punch(_) => "punch",
            Self::Loads(loads) if loads.alone().is_some() => "load",
            Self::Loads(_) => "loads",
        }
    }

    /// As it is written in a scene of this geometry: in an axisymmetric one a cylinder is a sphere, and half-widths are radii.
    pub fn written_in(&self, geometry: Geometry) -> String {
        match self {
            Self::Punch(punch) => punch.written_in(geometry),
            Self::Loads(loads) => match loads.alone() {
                Some(load) if geometry.is_axisymmetric() => Written(RoundLoad::of(load)).to_string(),
                _ => self.to_string(),
            },
        }
    }

    /// The same, or its name alone if that is long.
    pub fn label(&self, geometry: Geometry) -> String {
        if let Self::Loads(loads) = self
            && loads.alone().is_none()
        {
            return match loads.parts().count() {
                1 => "1 load".to_owned(),
                count => format!("{count} loads"),
            };
        }
        shortened(self.written_in(geometry))
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
            Self::Punch(punch) => punch.fmt(f),
            Self::Loads(loads) => loads.fmt(f),
        }
    }
}

impl From<Punch> for Top {
    fn from(punch: Punch) -> Self {
        Self::Punch(punch)
    }
}

impl From<Loads> for Top {
    fn from(loads: Loads) -> Self {
        Self::Loads(loads)
    }
}

impl From<Load> for Top {
    /// One load about x = 0.
    fn from(load: Load) -> Self {
        Self::Loads(load.into())
    }
}

impl<T: Clone + Into<Self>> From<&T> for Top {
    fn from(top: &T) -> Self {
        top.clone().into()
    }
}
