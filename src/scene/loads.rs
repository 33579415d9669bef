//! Given pressures that press at once, as they are written.
use std::fmt;

use recede_layers::{Finite, Positive, described};
use serde::{Deserialize, Serialize};

use super::load::Load;
use super::round::RoundLoad;
use super::text::written;
use super::value::{ListError, ValueError, check_list};
use crate::geometry::Geometry;

/// Narrowest half-width of a ring in terms of its radius: as the difference of two discs it has so many digits less.
const NARROWEST: f64 = 1e-4;

/// Loads that press on the top face at once, each anywhere on x. They may overlap.
///
/// Pressed with a force that is not [`Self::force`], each has its part of it in the ratio of the forces here.
///
/// ```
/// use recede::{HalfPlane, Load, Loads, Model, Plane, Stack};
/// let model = Model::new(Stack::builder(Plane::Strain).layer(HalfPlane::new(1.0, 0.25)?).build()?)?;
/// let loads = Loads::new(&[(Load::Line, -0.5, 0.2), (Load::uniform(0.2)?, 1.0, 0.8)])?;
/// let solution = model.press(&loads, loads.force())?;
/// let [line, strip] = solution.contacts()[0].intervals() else { unreachable!() };
/// assert_eq!((line.left, line.right, strip.left, strip.right), (-0.5, -0.5, 0.8, 1.2));
/// assert_eq!((line.force, strip.force, strip.centroid), (0.2, 0.8, 1.0));
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Loads(pub(super) Vec<PlacedLoad>);

/// One of several loads.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlacedLoad {
    /// The pressure about its middle.
    load: Load,
    /// The place of the middle on x, in length.
    at: Finite,
    /// The resultant, force per unit length out of the plane.
    pub(super) force: Positive,
    /// The other coordinate of the middle, in length, of a load about an axis of its own.
    #[serde(skip)]
    y: Option<Finite>,
}

/// One of several loads about axes of their own, as it is written.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PlacedRoundLoad {
    load: RoundLoad,
    at: (Finite, Finite),
    force: Positive,
}

impl From<PlacedRoundLoad> for PlacedLoad {
    fn from(PlacedRoundLoad { load, at: (at, y), force }: PlacedRoundLoad) -> Self {
        Self { load: load.into(), at, force, y: Some(y) }
    }
}

impl From<&PlacedLoad> for PlacedRoundLoad {
    fn from(PlacedLoad { load, at, force, y }: &PlacedLoad) -> Self {
        Self { load: load.clone().into(), at: (*at, y.unwrap_or(Finite::ZERO)), force: *force }
    }
}

impl Loads {
    /// Loads, each with the place of its middle on x, in length, and its resultant > 0, force per unit length out of the plane.
    ///
    /// # Errors
    /// [`ValueError::OutOfRange`] if a number is not legal, [`ValueError::List`] if there are none or too many, or if their sum is
    /// not finite.
    pub fn new(loads: &[(Load, f64, f64)]) -> Result<Self, ValueError> {
        let placed = |(load, at, force): &(Load, f64, f64)| {
            let (at, force) = (ValueError::checked("at", *at)?, ValueError::checked("force", *force)?);
            Ok(PlacedLoad { load: load.clone(), at, force, y: None })
        };
        Ok(loads.iter().map(placed).collect::<Result<Vec<_>, ValueError>>()?.try_into()?)
    }

    /// Loads about axes of their own on a stack without receding interfaces, each with the place (x, y) of its axis, in length, and its force > 0. What each of them
    /// does alone is added up.
    ///
    /// ```
    /// use recede::{HalfPlane, Geometry, Load, Loads, Model, SpacePoint, Stack};
    /// let stack = Stack::builder(Geometry::Axisymmetric).layer(HalfPlane::new(1.0, 0.25)?).build()?;
    /// let wheel = |y: f64| Ok::<_, recede::ValueError>((Load::uniform(0.5)?, [0.0, y], 1.0));
    /// let loads = Loads::about_axes(&[wheel(-1.0)?, wheel(1.0)?])?;
    /// let model = Model::new(stack)?;
    /// let field = model.field(&model.press(&loads, loads.force())?)?;
    /// let [under_one, other] = [-1.0, 1.0].map(|y| SpacePoint { x: 0.0, y, depth: 0.3, layer: None });
    /// let found = field.points_in_space(&[under_one, other])?;
    /// assert!((found[0].sigma_yy / found[1].sigma_yy - 1.0).abs() < 1e-12);
    /// # Ok::<(), recede::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn about_axes(loads: &[(Load, [f64; 2], f64)]) -> Result<Self, ValueError> {
        let all: Vec<(Load, f64, f64)> = loads.iter().map(|(load, [x, _], force)| (load.clone(), *x, *force)).collect();
        let mut placed = Self::new(&all)?;
        for (one, (_, [_, y], _)) in placed.0.iter_mut().zip(loads) {
            one.y = Some(ValueError::checked("at", *y)?);
        }
        Ok(placed)
    }

    /// The places (x, y) of the axes, in length, if the loads are about axes of their own.
    pub fn axes(&self) -> Option<Vec<[f64; 2]>> {
        self.0.iter().map(|placed| Some([placed.at.get(), placed.y?.get()])).collect()
    }

    /// The sum of all forces, per unit length out of the plane.
    pub fn force(&self) -> f64 {
        self.0.iter().map(|placed| placed.force.get()).sum()
    }

    /// The loads with the places of their middles, in length, and their parts of the force, which are 1 together.
    pub(crate) fn parts(&self) -> impl Iterator<Item = (&Load, f64, f64)> {
        let force = self.force();
        self.0.iter().map(move |placed| (&placed.load, placed.at.get(), placed.force.get() / force))
    }

    /// The load, if it is one about x = 0.
    pub fn alone(&self) -> Option<&Load> {
        match &self.0[..] {
            [PlacedLoad { load, at, y: None, .. }] if at.get() == 0.0 => Some(load),
            _ => None,
        }
    }

    /// As far as a load presses on either side of x = 0, in length.
    pub fn reach(&self) -> f64 {
        self.parts().fold(0.0, |reach, (load, at, _)| reach.max(at.abs() + load.half_width()))
    }

    /// Whether the loads are their own mirror image about x = 0, in whatever order they are.
    pub fn is_even(&self) -> bool {
        self.centre() == Some(0.0)
    }

    /// The place about which the loads are their own mirror image, in length; `None` if there is none.
    pub(crate) fn centre(&self) -> Option<f64> {
        let places = || self.0.iter().map(|placed| placed.at.get());
        let [left, right] = [f64::min, f64::max].map(|pick| places().reduce(pick).unwrap_or(0.0));
        // + 0: a load at −0 is at 0
        let centre = 0.5 * (left + right) + 0.0;
        let from_centre = |placed: &PlacedLoad| placed.at.get() - centre;
        let mut images: Vec<&PlacedLoad> = self.0.iter().collect();
        let is_even = self.0.iter().all(|one| {
            let is_image = |other: &&PlacedLoad| {
                (from_centre(other), other.force, &other.load) == (-from_centre(one), one.force, &one.load)
            };
            images.iter().position(is_image).map(|place| images.swap_remove(place)).is_some()
        });
        is_even.then_some(centre)
    }

    /// Whether the pressures are known in a geometry: about an axis every load is in the middle or has an axis of its own, and no ring is too narrow; in the plane
    /// there are neither rings nor axes.
    pub(crate) fn are_known_in(&self, geometry: Geometry) -> bool {
        let is_round = geometry.is_axisymmetric();
        self.0.iter().all(|PlacedLoad { load, at, y, .. }| match load {
            _ if is_round && y.is_none() && at.get() != 0.0 || !is_round && y.is_some() => false,
            Load::Ring { radius, half_width } => is_round && half_width.get() >= NARROWEST * radius.get(),
            _ => true,
        })
    }
}

impl fmt::Display for Loads {
    /// As they are written in a scene: one about x = 0 as a load.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.alone() {
            Some(load) => load.fmt(f),
            None if self.axes().is_some() => {
                f.write_str(&written(&self.0.iter().map(PlacedRoundLoad::from).collect::<Vec<_>>()))
            }
            None => f.write_str(&written(&self.0)),
        }
    }
}

impl From<Load> for Loads {
    /// One load about x = 0.
    fn from(load: Load) -> Self {
        Self(vec![PlacedLoad { load, at: Finite::ZERO, force: Positive::ONE, y: None }])
    }
}

impl TryFrom<Vec<PlacedLoad>> for Loads {
    type Error = ListError;

    fn try_from(loads: Vec<PlacedLoad>) -> Result<Self, ListError> {
        let loads = Self(loads);
        check_list("loads", loads.0.len(), loads.force()).map(|()| loads)
    }
}

described!(Loads in "[(load: ..., at: x, force: P), ...], one or more loads with their places x, or (x, y) in axisymmetric scenes, and forces P > 0");
