//! What a solved scene tells.
mod closed;
mod contact;
mod controlled;
mod ledger;
mod peak;
mod strip;
mod warning;

use std::any::Any;
use std::fmt;
use std::sync::Arc;

use serde::{Serialize, Serializer};

pub use closed::{ClosedInterface, Opening, Separation};
pub use contact::{Contact, Interval};
pub use controlled::Controlled;
pub use ledger::{Ledger, LedgerEntry};
pub use peak::Peak;
pub(crate) use strip::{Form, Strip, jacobi_weights, tip_coefficient};
pub use warning::{Warning, WarningCode};

/// Which contact: the punch on top, or a receding interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Interface {
    /// Punch on the top face of the stack.
    Punch,
    /// Receding interface between two neighbours, numbered from the top as written in the scene, starting at 1;
    /// the base counts.
    Between {
        /// Number of the layer above.
        above: usize,
        /// Number of the layer (or base) below.
        below: usize,
    },
}

impl fmt::Display for Interface {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Punch => write!(f, "punch"),
            Self::Between { above, below } => write!(f, "{above}|{below}"),
        }
    }
}

impl Serialize for Interface {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// Counts of what was computed for a solution, and of what was not needed.
///
/// What is counted for the stack was done once for its [`Model`](crate::Model), however many punches and loads follow.
///
/// ```
/// use recede::{HalfPlane, Homogeneous, Model, Plane, Punch, Stack};
/// let slice = || Homogeneous::new(0.25, 1.0, 0.25);
/// let stack = Stack::builder(Plane::Strain).layer(slice()?).bonded().layer(slice()?).receding();
/// let model = Model::new(stack.layer(HalfPlane::new(1.0, 0.25)?).build()?)?;
/// let stats = model.press(&Punch::cylinder(500.0)?, 0.002)?.stats().clone();
/// assert_eq!((stats.dropped, stats.merged), (0, 1));
/// assert_eq!(stats.layers + stats.below_decay_depth, stats.wavenumbers);
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Stats {
    /// Layers of thickness zero, which are not there.
    #[serde(rename = "layers_dropped")]
    pub dropped: usize,
    /// Layers that are one body with the layer or half-plane to which they are bonded, and were solved for with it.
    #[serde(rename = "layers_merged")]
    pub merged: usize,
    /// Wavenumbers at which the stack was evaluated.
    pub wavenumbers: usize,
    /// Layers evaluated, all wavenumbers together; a half-plane does not count.
    #[serde(rename = "layers_evaluated")]
    pub layers: usize,
    /// Layers that would have been evaluated, were they not in sequences that repeat others.
    #[serde(rename = "layers_repeated")]
    pub repeated: usize,
    /// Layers that would have been evaluated, had they not been too deep for the wave to be felt.
    #[serde(rename = "layers_below_decay_depth")]
    pub below_decay_depth: usize,
    /// Values of couplings between neighbouring contacts that vanish and were left out, all wavenumbers together.
    #[serde(rename = "couplings_vanished")]
    pub uncoupled: usize,
    /// Wavenumbers of the integrals of the contact equations, at which kernels were taken from values known before rather
    /// than evaluated; all layouts of integrals together.
    #[serde(rename = "wavenumbers_interpolated")]
    pub interpolated: usize,
    /// Terms in the series of each pressure, contacts from the top down.
    pub modes: Vec<usize>,
    /// The same of each interval, if the contact equations were solved; of x ≥ 0 alone where all is even.
    #[serde(skip)]
    pub terms: Vec<Vec<usize>>,
    /// Newton steps, and rounds of iteration, on each level of refinement, the coarsest first; for each force that was tried, if
    /// it was found.
    pub newton_steps: Vec<usize>,
    /// Systems of equations that were factorised.
    pub factorisations: usize,
}

/// What a solution belongs to, known by a key of any type.
#[derive(Clone)]
pub(crate) struct OwnerKey {
    key: Arc<dyn Any + Send + Sync>,
    is_same: fn(&dyn Any, &dyn Any) -> bool,
}

impl OwnerKey {
    /// Owners with equal keys of one type are the same.
    pub(crate) fn new<T: Any + PartialEq + Send + Sync>(key: T) -> Self {
        let is_same = |one: &dyn Any, other: &dyn Any| {
            one.downcast_ref::<T>().is_some_and(|one| other.downcast_ref::<T>().is_some_and(|other| one == other))
        };
        Self { key: Arc::new(key), is_same }
    }
}

impl PartialEq for OwnerKey {
    fn eq(&self, other: &Self) -> bool {
        (self.is_same)(&*self.key, &*other.key)
    }
}

impl fmt::Debug for OwnerKey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("OwnerKey")
    }
}

/// A solved scene: contacts from the top down, and what it took to find them.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// The stack that it belongs to, which [`crate::Model`] sets and compares.
    pub(crate) stack: Option<OwnerKey>,
    pub(crate) contacts: Vec<Contact>,
    /// Where loads press about axes of their own, the place (x, y) of the axis of each; else none.
    pub(crate) axes: Vec<[f64; 2]>,
    /// Interfaces that weights keep closed.
    pub(crate) closed: Vec<ClosedInterface>,
    pub(crate) force: f64,
    pub(crate) force_error: f64,
    /// What was prescribed in place of the force.
    pub(crate) controlled: Option<Controlled>,
    /// What each punch carries, if they are not one at x = 0 that is not turned.
    pub(crate) punches: Vec<Carried>,
    /// By how much the bodies above each contact but the first are turned.
    pub(crate) rotations: Vec<f64>,
    pub(crate) min_pressure: f64,
    pub(crate) min_gap: f64,
    pub(crate) stats: Stats,
    pub(crate) warnings: Vec<Warning>,
}

/// What one of several punches, or one away from x = 0 or turned, carries.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Carried {
    /// Its force, per unit length out of plane.
    pub force: f64,
    /// The angle by which it is turned, in radians, which is added to its slope.
    pub tilt: f64,
    /// The moment of the pressures under it about its tip, per unit length out of plane: > 0 if they act on its right.
    pub moment: f64,
}

impl Solution {
    /// What each punch carries, from left to right; none for loads, and for one punch at x = 0 that is not turned.
    ///
    /// ```
    /// use recede::{HalfPlane, Homogeneous, Model, Plane, Pressed, Punch, Punches, Stack, Tilt};
    /// let strip = Homogeneous::new(1.0, 1.0, 0.25)?;
    /// let stack = Stack::builder(Plane::Strain).layer(strip).receding().layer(HalfPlane::new(1.0, 0.25)?).build()?;
    /// let roller = |at: f64, force: f64| Pressed::new(Punch::parabola(100.0)?, at, force, Tilt::None);
    /// let punches = Punches::new(&[roller(0.0, 2e-3)?, roller(1.5, 1e-3)?])?;
    /// let solution = Model::new(stack)?.press(punches, 3e-3)?;
    /// let [left, right] = solution.punches() else { unreachable!() };
    /// assert!((left.force - 2e-3).abs() < 1e-12 && (right.force - 1e-3).abs() < 1e-12);
    /// # Ok::<(), recede::Error>(())
    /// ```
    pub fn punches(&self) -> &[Carried] {
        &self.punches
    }

    /// The angles, in radians, by which the layers above each receding interface are turned against the base: the means of their slopes far to the left
    /// and far to the right of the contacts, > 0 if they rise to the right. All are 0 where all is even.
    ///
    /// ```
    /// use recede::Scene;
    /// let turned = |left: f64, right: f64| {
    ///     let scene = format!("Scene(geometry: PlaneStrain, stack: [Homogeneous(thickness: 1.0, shear_modulus: 1.0, poisson: 0.25),
    ///         Receding, HalfPlane(shear_modulus: 1.0, poisson: 0.25)],
    ///         loads: [(load: Line, at: -0.5, force: {left}), (load: Line, at: 0.5, force: {right})])");
    ///     Ok::<_, recede::Error>(recede::solve(&Scene::from_ron(&scene)?)?.rotations()[0])
    /// };
    /// assert!(turned(3e-3, 1e-3)? < 0.0 && (turned(3e-3, 1e-3)? + turned(1e-3, 3e-3)?).abs() < 1e-12);
    /// # Ok::<(), recede::Error>(())
    /// ```
    pub fn rotations(&self) -> &[f64] {
        &self.rotations
    }

    /// The pressure of loads about axes of their own at a place (x, y) of the top face.
    pub(crate) fn load_at(&self, [x, y]: [f64; 2]) -> f64 {
        let of = |(contact, axis): (&Contact, &[f64; 2])| contact.pressure((x - axis[0]).hypot(y - axis[1]));
        self.contacts.iter().zip(&self.axes).map(of).sum()
    }

    /// The places (x, y) of the axes of loads about axes of their own, each of which is a contact about its axis; none of all that else presses.
    pub fn axes(&self) -> &[[f64; 2]] {
        &self.axes
    }

    /// The contacts from the top down: the punch first.
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// The interfaces that weights, or a pressure on top, keep closed but for openings, from the top down; they are no contacts.
    pub fn closed(&self) -> &[ClosedInterface] {
        &self.closed
    }

    /// The place on x about which all contacts are their own mirror images, if there is one.
    pub(crate) fn about(&self) -> Option<f64> {
        self.contacts.first()?.about
    }

    /// Whether all contacts are their own mirror images about x = 0.
    pub(crate) fn is_even(&self) -> bool {
        self.about() == Some(0.0)
    }

    /// Where the leftmost contact or load begins, and where the rightmost one ends; `[-extent, extent]` if all are even about x = 0.
    pub fn ends(&self) -> [f64; 2] {
        let at = |k: usize| self.axes.get(k).map_or(0.0, |[x, _]| *x);
        let ends = self.contacts.iter().enumerate().map(|(k, contact)| contact.ends().map(|end| at(k) + end));
        ends.reduce(|all, one| [all[0].min(one[0]), all[1].max(one[1])]).unwrap_or_default()
    }

    /// The same with all openings of interfaces that weights keep closed elsewhere.
    pub(crate) fn ends_with_openings(&self) -> [f64; 2] {
        let openings = self.closed.iter().flat_map(|own| &own.openings);
        openings.fold(self.ends(), |[left, right], one| [left.min(one.left), right.max(one.right)])
    }

    /// As far as the bodies touch, or a load presses, on the interface where that is farthest; `None` where a line load on
    /// x = 0 is all that presses.
    pub fn extent(&self) -> Option<f64> {
        let [left, right] = self.ends();
        Some(right.max(-left)).filter(|extent| *extent > 0.0)
    }

    /// The line load P that presses, force per unit length out of plane: as given, or found for a half-length.
    pub fn force(&self) -> f64 {
        self.force
    }

    /// The solver's estimate of the absolute error of the force; 0 if it was given.
    pub fn force_error(&self) -> f64 {
        self.force_error
    }

    /// Smallest pressure found inside the contacts by the admissibility check, in stress.
    pub fn min_pressure(&self) -> f64 {
        self.min_pressure
    }

    /// Smallest gap found outside the contacts by the admissibility check, in length.
    pub fn min_gap(&self) -> f64 {
        self.min_gap
    }

    /// Largest number of modes by which a pressure was represented.
    pub fn modes(&self) -> usize {
        self.stats.modes.iter().copied().max().unwrap_or(0)
    }

    /// Number of wavenumbers at which the stack was evaluated.
    pub fn wavenumbers(&self) -> usize {
        self.stats.wavenumbers
    }

    /// Newton steps taken, all levels together.
    pub fn newton_steps(&self) -> usize {
        self.stats.newton_steps.iter().sum()
    }

    /// What was computed, and what was not needed.
    pub fn stats(&self) -> &Stats {
        &self.stats
    }

    /// What the user should know about this result; empty if there is nothing.
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }
}
