//! The laws that every layer obeys, for any implementor of [`Layer`] to run on a layer of his own.
//!
//! One function per law; [`examine`] runs all of them, [`layer_laws!`](crate::layer_laws) makes a test of each:
//!
//! ```no_run
//! # use recede_layers::*;
//! recede_layers::layer_laws!(strip, Homogeneous::new(1.0, 1.0, 0.25).expect("legal numbers"));
//! ```
//!
//! Four properties make a layer, and each law looks at one of them from one side: the fields obey the state
//! equations of its [`Layer::material`] ([`general_body`], [`inside`], [`split_in_two`], [`continues`], [`mirror`],
//! [`long_wave`], [`short_wave`]), the material is elastic and smooth at its faces ([`reciprocity`],
//! [`positive_energy`], [`smooth_faces`]), numbers keep their digits
//! ([`free_body`], [`uniform_pressure`], [`finite`]), and its key tells it from others ([`identity`]).
//!
//! # Tolerances
//!
//! Closed forms and the general body keep eleven digits of a flexibility. Nine are asked for here, [`DIGITS`]; two are
//! left to the conditioning of the laws themselves. What arises as a difference of larger numbers is granted
//! [`ROUNDING`] of the larger ones: the coupling of two faces that hardly feel each other, and the response to equal
//! loads, of which only (λh)² of that to one load is left. Equal loads are judged by [`EQUAL_LOADS`]. Limits are
//! approached to first or second order in the wavenumber; they are evaluated where the known next term is below
//! [`DIGITS`] or is granted.
mod beam;
mod bonded;
mod cut;
mod faces;
mod identity;
mod inside;
mod laws;
mod limits;
mod supports;
mod trial;

pub use self::cut::{continues, one_body};
pub use self::faces::{RoughFace, rough_face, smooth_faces};
pub use self::identity::{identity, same_key};
pub use self::inside::inside;
pub use self::laws::{finite, general_body, mirror, positive_energy, reciprocity, split_in_two, uniform_pressure};
pub use self::limits::{free_body, long_wave, short_wave};
pub use self::supports::support;
#[cfg(test)]
pub(crate) use self::trial::{size_over, work};
use crate::{Layer, Plane};

/// Relative tolerance of numbers that do not arise by cancellation.
pub const DIGITS: f64 = 1e-9;
/// Relative tolerance of the response to equal loads on both faces, relative to the face that moves more: on a layer
/// whose modulus varies by e^30 the soft face moves by itself, and what is left to the stiff one is three digits worse.
pub const EQUAL_LOADS: f64 = 1e-8;
/// Tolerance, relative to the numbers of which another one is a difference.
pub const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A law that a layer breaks: where, and by how much.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "{law}: {quantity} at wavenumber {wavenumber:e}, plane {plane:?}, is {found:e}, not {expected:e} ± {tolerance:e}"
)]
pub struct Violation {
    /// The law's name, which is the name of its function.
    pub law: &'static str,
    /// What was compared.
    pub quantity: &'static str,
    /// Plane strain or stress.
    pub plane: Plane,
    /// The wavenumber λ, in 1/length.
    pub wavenumber: f64,
    /// The layer's value.
    pub found: f64,
    /// The value that the law demands.
    pub expected: f64,
    /// How far they may differ, absolute.
    pub tolerance: f64,
}

/// A law: its name and the function that examines a layer.
pub type Law = (&'static str, fn(&dyn Layer, Plane) -> Result<(), Violation>);

/// All laws, in the order in which to read their violations: the first one broken is the likely cause of the others.
pub const LAWS: &[Law] = &[
    ("finite", finite),
    ("reciprocity", reciprocity),
    ("positive_energy", positive_energy),
    ("smooth_faces", smooth_faces),
    ("general_body", general_body),
    ("uniform_pressure", uniform_pressure),
    ("free_body", free_body),
    ("long_wave", long_wave),
    ("short_wave", short_wave),
    ("mirror", mirror),
    ("split_in_two", split_in_two),
    ("inside", inside),
    ("continues", continues),
    ("identity", identity),
];

/// Examines a layer by all laws.
///
/// # Errors
/// The first violation of each law that is broken.
pub fn examine(layer: &dyn Layer, plane: Plane) -> Result<(), Vec<Violation>> {
    let violations: Vec<Violation> = LAWS.iter().filter_map(|(_, law)| law(layer, plane).err()).collect();
    if violations.is_empty() { Ok(()) } else { Err(violations) }
}

/// Makes a module of tests, one for each law of [`conformance`](crate::conformance), in plane strain and plane stress.
///
/// ```no_run
/// # use recede_layers::*;
/// recede_layers::layer_laws!(steep, Exponential::new(1.0, 1.0, 0.25, 8.0).expect("legal numbers"));
/// ```
#[macro_export]
macro_rules! layer_laws {
    ($name:ident, $layer:expr) => {
        $crate::layer_laws!($name, $layer => finite, reciprocity, positive_energy, smooth_faces, general_body, uniform_pressure,
            free_body, long_wave, short_wave, mirror, split_in_two, inside, continues, identity);
    };
    ($name:ident, $layer:expr => $($law:ident),*) => {
        mod $name {
            #[allow(unused_imports)]
            use super::*;
            const _: () = assert!($crate::conformance::LAWS.len() == [$(stringify!($law)),*].len());
            $(
                #[test]
                fn $law() {
                    for plane in [$crate::Plane::Strain, $crate::Plane::Stress] {
                        if let Err(violation) = $crate::conformance::$law(&$layer, plane) {
                            panic!("{violation}");
                        }
                    }
                }
            )*
        }
    };
}
