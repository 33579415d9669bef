//! Punches that press at once, as they are written.
use std::fmt;

use recede_layers::{Finite, Positive, described};
use serde::{Deserialize, Deserializer, Serialize};

use super::force::Force;
use super::punch::Punch;
use super::text::written;
use super::value::{ListError, ValueError, check_list};
use crate::geometry::Geometry;

/// Punches that press on the top face at once, each anywhere on x, from left to right.
///
/// Pressed with a force that is not [`Self::force`], each has its part of it in the ratio of the forces here.
///
/// ```
/// use recede::{Pressed, Punch, Punches, Tilt, Top};
/// let block = Pressed::new(Punch::flat(0.5)?, 3.0, 0.001, Tilt::Free { eccentricity: 0.1 })?;
/// let roller = Pressed::new(Punch::cylinder(100.0)?, 0.0, 0.003, Tilt::None)?;
/// let punches = Punches::new(&[block, roller])?;
/// let parts: Vec<(f64, f64)> = punches.parts().map(|(pressed, part)| (pressed.at(), part)).collect();
/// assert_eq!((parts, punches.force()), (vec![(0.0, 0.75), (3.0, 0.25)], 0.004));
/// assert_eq!(
///     punches.to_string(),
///     "[(shape: Cylinder(radius: 100.0), at: 0.0, force: 0.003), \
///      (shape: Flat(half_width: 0.5), at: 3.0, force: 0.001, tilt: Free(eccentricity: 0.1))]"
/// );
/// assert!(punches.alone().is_none() && Top::from(punches).punch().is_none());
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Punches(pub(super) Vec<Pressed>);

/// One of several punches.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Written", into = "Written")]
pub struct Pressed {
    /// The profile, x counted from the tip.
    shape: Punch,
    /// The place of the tip on x, in length.
    at: Finite,
    /// The force on it, per unit length out of the plane, or what is expected of it.
    pub(super) force: Positive,
    /// What the force is found for, if it is not given.
    prescribed: Option<Force>,
    /// Whether the punch turns.
    tilt: Tilt,
}

/// One of several punches as it is written.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    shape: Punch,
    at: Finite,
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "number")]
    force: Option<Positive>,
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "number")]
    depth: Option<Positive>,
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "number")]
    left: Option<Finite>,
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "number")]
    right: Option<Finite>,
    #[serde(default, skip_serializing_if = "Tilt::is_none")]
    tilt: Tilt,
}

/// So far from its tip a punch is as steep as anywhere.
const FAR: f64 = 1e100;

/// Whether a punch turns, by small angles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Tilt {
    /// The punch cannot turn.
    #[default]
    None,
    /// The punch is turned by this small angle, in radians, which is added to its slope, and cannot turn farther.
    Fixed(#[serde(deserialize_with = "finite")] f64),
    /// The punch turns freely until the pressures under it have the moment of its force.
    Free {
        /// How far to the right of its tip its force acts, in length.
        #[serde(deserialize_with = "finite")]
        eccentricity: f64,
    },
}

/// A number, where there may be none.
fn number<'de, D: Deserializer<'de>, N: Deserialize<'de>>(deserializer: D) -> Result<Option<N>, D::Error> {
    N::deserialize(deserializer).map(Some)
}

/// A finite number, as it is read.
fn finite<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    Finite::deserialize(deserializer).map(Finite::get)
}

impl Tilt {
    /// The angle by which a punch is turned, in radians, if it is prescribed: 0 if it cannot turn.
    pub fn angle(self) -> Option<f64> {
        match self {
            Self::None => Some(0.0),
            Self::Fixed(angle) => Some(angle),
            Self::Free { .. } => None,
        }
    }

    fn is_none(&self) -> bool {
        *self == Self::None
    }

    fn checked(self) -> Result<Self, ValueError> {
        let (quantity, number) = match self {
            Self::None => return Ok(self),
            Self::Fixed(angle) => ("tilt", angle),
            Self::Free { eccentricity } => ("eccentricity", eccentricity),
        };
        ValueError::checked::<Finite>(quantity, number).map(|_| self)
    }
}

impl Pressed {
    /// A punch with the place of its tip on x, in length, the force on it > 0, per unit length out of the plane, or what the force is found for, and whether it turns.
    ///
    /// ```
    /// use recede::{Force, Pressed, Punch, Tilt};
    /// let roller = Pressed::new(Punch::cylinder(100.0)?, 3.0, Force::ForRight(3.2), Tilt::None)?;
    /// assert_eq!(roller.pressed_by(), Force::ForRight(3.2));
    /// assert!(Pressed::new(Punch::cylinder(100.0)?, 3.0, Force::ForHalfLength(0.2), Tilt::None).is_err());
    /// # Ok::<(), recede::ValueError>(())
    /// ```
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if a number is not legal; [`ValueError::List`] for [`Force::ForHalfLength`] and [`Force::OfEach`].
    pub fn new(shape: Punch, at: f64, force: impl Into<Force>, tilt: Tilt) -> Result<Self, ValueError> {
        let (at, force) = (ValueError::checked("at", at)?, force.into().checked()?);
        let (force, prescribed) = match force {
            Force::Given(force) => (ValueError::checked("force", force)?, None),
            Force::ForDepth(_) | Force::ForLeft(_) | Force::ForRight(_) => (Positive::ONE, Some(force)),
            Force::ForHalfLength(_) | Force::OfEach => return Err(ListError::Pressed(0).into()),
        };
        Ok(Self { shape, at, force, prescribed, tilt: tilt.checked()? })
    }

    /// The profile, x counted from the tip.
    pub fn shape(&self) -> &Punch {
        &self.shape
    }

    /// Where the tip is on x, in length.
    pub fn at(&self) -> f64 {
        self.at.get()
    }

    /// The force, per unit length out of the plane; 1 where it is to be found.
    pub fn force(&self) -> f64 {
        self.force.get()
    }

    /// The force, or what is prescribed in its place.
    pub fn pressed_by(&self) -> Force {
        self.prescribed.unwrap_or(Force::Given(self.force()))
    }

    /// Whether one of its sides falls from the tip on, without end, over a face on which the slope of the gap grows by a curvature times x more.
    pub(crate) fn falls(&self, curvature: f64) -> bool {
        let (shape, angle) = (self.shape.shape(), self.tilt.angle().unwrap_or(0.0));
        let [left, right] = shape.ends();
        let slope = |x: f64| shape.slope(x) + curvature * x + angle;
        right.is_infinite() && slope(FAR) <= 0.0 || left.is_infinite() && slope(-FAR) >= 0.0
    }

    /// Whether it turns.
    pub fn tilt(&self) -> Tilt {
        self.tilt
    }

    /// Whether the tip is at x = 0, and the punch is not turned.
    fn is_upright(&self) -> bool {
        self.at() == 0.0 && self.tilt.angle() == Some(0.0)
    }

    /// The two ends of its flat part, or twice the place of its tip: an interval that no other punch can touch, whatever the forces.
    pub(crate) fn face(&self) -> [f64; 2] {
        let half = self.shape.shape().flat();
        [self.at() - half, self.at() + half]
    }

    /// The shape and the place of the punch, for messages.
    fn name(&self) -> String {
        format!("{} at {:?}", self.shape.label(Geometry::PlaneStrain), self.at())
    }

    /// Checks the punch as the one of this number in the list.
    fn check(&self, number: usize) -> Result<(), ListError> {
        match (&self.shape, self.tilt) {
            (Punch::Flat { half_width }, Tilt::Free { eccentricity }) if eccentricity.abs() >= half_width.get() => {
                Err(ListError::Eccentricity { number, eccentricity, half_width: half_width.get() })
            }
            _ => Ok(()),
        }
    }
}

impl Punches {
    /// Punches, in any order.
    ///
    /// # Errors
    /// [`ValueError::List`] if there are none or too many, if two of them overlap, if the force on one that may turn lies outside
    /// of its corners, if one of several is elastic, or if the sum of the forces is not finite.
    pub fn new(punches: &[Pressed]) -> Result<Self, ValueError> {
        Ok(punches.to_vec().try_into()?)
    }

    /// The sum of all forces, per unit length out of the plane.
    pub fn force(&self) -> f64 {
        self.0.iter().map(Pressed::force).sum()
    }

    /// The punches from left to right with their parts of the force, which are 1 together.
    pub fn parts(&self) -> impl Iterator<Item = (&Pressed, f64)> {
        let force = self.force();
        self.0.iter().map(move |pressed| (pressed, pressed.force() / force))
    }

    /// The punch, if it is one at x = 0 that is not turned, and of which nothing is prescribed here.
    pub fn alone(&self) -> Option<&Punch> {
        match &self.0[..] {
            [pressed] if pressed.is_upright() && pressed.prescribed.is_none() => Some(&pressed.shape),
            _ => None,
        }
    }

    /// What presses all of them: the sum of their forces, or what stands beside each.
    pub(crate) fn pressed_by(&self) -> Force {
        if self.are_prescribed() { Force::OfEach } else { Force::Given(self.force()) }
    }

    /// Whether the force of a punch is to be found.
    pub(crate) fn are_prescribed(&self) -> bool {
        self.0.iter().any(|pressed| pressed.prescribed.is_some())
    }

    /// The same punches with these forces, as far as numbers reach: given ones, and in place of what is expected of others.
    pub(crate) fn with_forces(&self, forces: impl Iterator<Item = f64>) -> Self {
        let of = |(pressed, force): (&Pressed, f64)| {
            let force = Positive::try_from(force.clamp(f64::MIN_POSITIVE, f64::MAX)).unwrap_or(pressed.force);
            Pressed { force, ..pressed.clone() }
        };
        Self(self.0.iter().zip(forces).map(of).collect())
    }

    /// The same punches with forces that are given, whatever they were pressed by.
    pub(crate) fn given(&self, forces: impl Iterator<Item = f64>) -> Self {
        let mut all = self.with_forces(forces);
        all.0.iter_mut().for_each(|pressed| pressed.prescribed = None);
        all
    }

    /// The punch, if it is an even one by itself that is not turned, wherever its tip is.
    pub(crate) fn even(&self) -> Option<&Punch> {
        match &self.0[..] {
            [Pressed { shape, tilt, .. }] if tilt.angle() == Some(0.0) && shape.is_even() => Some(shape),
            _ => None,
        }
    }
}

impl fmt::Display for Punches {
    /// As they are written in a scene: one at x = 0 that is not turned as a punch.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.alone() {
            Some(punch) => punch.fmt(f),
            None => f.write_str(&written(&self.0)),
        }
    }
}

impl From<Punch> for Punches {
    /// One punch at x = 0.
    fn from(shape: Punch) -> Self {
        Self(vec![Pressed { shape, at: Finite::ZERO, force: Positive::ONE, prescribed: None, tilt: Tilt::None }])
    }
}

impl TryFrom<Written> for Pressed {
    type Error = ValueError;

    fn try_from(Written { shape, at, force, depth, left, right, tilt }: Written) -> Result<Self, ValueError> {
        let given = [
            force.map(|force| Force::Given(force.get())),
            depth.map(|depth| Force::ForDepth(depth.get())),
            left.map(|left| Force::ForLeft(left.get())),
            right.map(|right| Force::ForRight(right.get())),
        ];
        let given: Vec<Force> = given.into_iter().flatten().collect();
        let [one] = given[..] else { return Err(ListError::Pressed(given.len()).into()) };
        Self::new(shape, at.get(), one, tilt)
    }
}

impl From<Pressed> for Written {
    fn from(Pressed { shape, at, force, prescribed, tilt }: Pressed) -> Self {
        let (depth, left, right) = match prescribed {
            Some(Force::ForDepth(depth)) => (Positive::try_from(depth).ok(), None, None),
            Some(Force::ForLeft(left)) => (None, Finite::try_from(left).ok(), None),
            Some(Force::ForRight(right)) => (None, None, Finite::try_from(right).ok()),
            _ => (None, None, None),
        };
        Self { shape, at, force: prescribed.is_none().then_some(force), depth, left, right, tilt }
    }
}

impl TryFrom<Vec<Pressed>> for Punches {
    type Error = ListError;

    fn try_from(punches: Vec<Pressed>) -> Result<Self, ListError> {
        check_list("punches", punches.len(), 0.0)?;
        let mut numbered: Vec<(usize, Pressed)> = (1..).zip(punches).collect();
        numbered.iter().try_for_each(|(number, pressed)| pressed.check(*number))?;
        let elastic = numbered.iter().find(|(_, pressed)| pressed.shape.material().is_some());
        if let Some(&(number, _)) = elastic.filter(|(_, own)| numbered.len() > 1 || !own.is_upright()) {
            return Err(ListError::Elastic(number));
        }
        numbered.sort_by(|(_, one), (_, other)| one.at().total_cmp(&other.at()));
        // where any two overlap, two neighbours do
        let mut neighbours = numbered.windows(2).map(|pair| [&pair[0], &pair[1]]);
        if let Some(mut pair) = neighbours.find(|[left, right]| left.1.face()[1] >= right.1.face()[0]) {
            pair.sort_by_key(|(number, _)| *number);
            return Err(ListError::Overlap { numbers: pair.map(|one| one.0), names: pair.map(|one| one.1.name()) });
        }
        let punches = Self(numbered.into_iter().map(|(_, pressed)| pressed).collect());
        check_list("punches", punches.0.len(), punches.force()).map(|()| punches)
    }
}

described!(Punches in
    "[(shape: ..., at: x, force: P, tilt: ...), ...], one or more punches with the places x of their tips and forces P > 0, or in place of a force `depth`, `left` or `right`");
