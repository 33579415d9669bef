//! Interfaces that weights, or a pressure on top, keep closed but for openings.
use serde::Serialize;

use super::{Contact, Interface, Strip};

/// An interface between layers that are pressed together far away. Lengths and stresses are in the units of the scene.
///
/// ```
/// use recede::Scene;
/// let scene = Scene::from_ron("Scene(geometry: PlaneStrain, load: Line, force: 20.0, stack: [
///     Homogeneous(thickness: 1.0, shear_modulus: 0.75, poisson: 0.25, specific_weight: 1.0), Receding, Rigid])")?;
/// let solution = recede::solve(&scene)?;
/// let [interface] = solution.closed() else { unreachable!() };
/// // the layer does not lift off yet
/// assert!(interface.openings.is_empty() && interface.smallest_pressure > 0.0);
/// assert!(interface.central_pressure > 20.0 / 2.0 && interface.weight == 1.0);
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ClosedInterface {
    /// Which interface.
    pub interface: Interface,
    /// The pressure of the weights above and on top alone, which it has far away.
    pub weight: f64,
    /// The pressure at x = 0 (compression positive).
    pub central_pressure: f64,
    /// The solver's estimate of the absolute error of `central_pressure`.
    pub central_pressure_error: f64,
    /// The smallest pressure outside openings: 0 if there are any, since it vanishes where they end.
    pub smallest_pressure: f64,
    /// Where it is; of what is even on the right.
    pub smallest_at: f64,
    /// Where the layers are apart, from left to right; none while all is closed.
    pub openings: Vec<Opening>,
    /// The slope of the gap in each of them, as pressures of contacts are.
    #[serde(skip)]
    pub(crate) slopes: Vec<Strip>,
}

impl ClosedInterface {
    /// What tables list of the opening with the largest gap, by name; of what is even of the one on the right.
    pub(crate) const COLUMNS: [&str; 7] = [
        "openings",
        "opening_left",
        "opening_left_error",
        "opening_right",
        "opening_right_error",
        "largest_gap",
        "smallest_pressure",
    ];

    /// The numbers of these columns, NaN where there is none.
    pub(crate) fn numbers(&self) -> [f64; Self::COLUMNS.len()] {
        let widest = self.openings.iter().max_by(|a, b| a.largest_gap.total_cmp(&b.largest_gap));
        let of = |number: fn(&Opening) -> f64| widest.map_or(f64::NAN, number);
        [
            self.openings.len() as f64,
            of(|own| own.left),
            of(|own| own.left_error),
            of(|own| own.right),
            of(|own| own.right_error),
            of(|own| own.largest_gap),
            self.smallest_pressure,
        ]
    }

    /// The numbers of [`Contact::COLUMNS`], of which it has the pressure at x = 0.
    pub(crate) fn as_contact(&self) -> [f64; Contact::COLUMNS.len()] {
        Contact::COLUMNS.map(|column| match column {
            "central_pressure" => self.central_pressure,
            "central_pressure_error" => self.central_pressure_error,
            _ => f64::NAN,
        })
    }

    /// How far the layers are apart at a place, in length; 0 where they lie on each other.
    pub fn gap(&self, x: f64) -> f64 {
        let here = self.slopes.iter().find(|strip| (x - strip.at).abs() < strip.extent);
        here.map_or(0.0, |strip| strip.extent * strip.integral_to(((x - strip.at) / strip.extent).acos()))
    }
}

/// An interval in which two layers that are pressed together far away are apart. Lengths are in the unit of the scene.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Opening {
    /// Where it begins.
    pub left: f64,
    /// Where it ends.
    pub right: f64,
    /// The solver's estimate of the absolute error of `left`.
    pub left_error: f64,
    /// The solver's estimate of the absolute error of `right`.
    pub right_error: f64,
    /// The largest gap in it.
    pub largest_gap: f64,
    /// Where that is.
    pub largest_gap_at: f64,
}

/// When layers that are pressed together begin to come apart, all forces scaled together.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Separation {
    /// The force, all punches or loads together, per unit length out of plane; about an axis the whole force.
    pub critical_force: f64,
    /// The solver's estimate of its absolute error.
    pub critical_force_error: f64,
    /// The interface that opens first.
    pub interface: Interface,
    /// Where it opens; of what is even on the right, and on the left, too.
    pub x: f64,
}
