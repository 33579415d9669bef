//! The laws that every layer obeys, for any implementor of [`Layer`] to run on a layer of his own.
//!
//! One function per law; [`examine`] runs all of them, [`layer_laws!`](crate::layer_laws) makes a test of each:
//!
//! ```no_run
//! # use recede_layers::*;
//! recede_layers::layer_laws!(strip, Homogeneous::new(1.0, 1.0, 0.25).expect("legal numbers"));
//! ```
//!
//! Three properties make a layer what it is, and each law looks at one of them from one side: the fields obey the state
//! equations of its [`Layer::material`] ([`general_body`], [`split_in_two`], [`mirror`], [`long_wave`],
//! [`short_wave`]), the material is elastic ([`reciprocity`], [`positive_energy`]), and numbers keep their digits
//! ([`free_body`], [`uniform_pressure`], [`finite`]).
//!
//! # Tolerances
//!
//! Closed forms and the general body keep eleven digits of a flexibility. Nine are asked for here, [`DIGITS`]; two are
//! left to the conditioning of the laws themselves. What arises as a difference of larger numbers is granted
//! [`ROUNDING`] of the larger ones: the coupling of two faces that hardly feel each other, and the response to equal
//! loads, of which only (λh)² of that to one load is left. Equal loads are judged by [`EQUAL_LOADS`]. Limits are
//! approached to first or second order in the wavenumber; they are evaluated where the known next term is below
//! [`DIGITS`] or is granted.
use nalgebra::{Matrix2, Matrix4, Matrix4x2, SMatrix};

use crate::graded::{self, Profile, surface_flexibility};
use crate::{FaceStates, Flexibility, Layer, Material, Plane, State, Wave, solve_equilibrated};

/// Relative tolerance of numbers that do not arise by cancellation.
pub const DIGITS: f64 = 1e-9;
/// Relative tolerance of the response to equal loads on both faces, relative to the face that moves more: on a layer
/// whose modulus varies by e^30 the soft face moves by itself, and what is left to the stiff one is three digits worse.
pub const EQUAL_LOADS: f64 = 1e-8;
/// Tolerance, relative to the numbers of which another one is a difference.
pub const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// λh at which layers are examined (λ itself, for one without a thickness).
const USUAL: [f64; 16] = [1e-8, 1e-6, 1e-4, 1e-3, 1e-2, 0.05, 0.2, 0.7, 0.99, 1.6, 2.5, 6.0, 17.0, 45.0, 300.0, 1e8];
/// λh at which nothing but finite numbers is expected.
const EXTREME: [f64; 9] = [1e-150, 1e-100, 1e-50, 1e-20, 1e-12, 1e12, 1e50, 1e100, 1e150];

/// A law that a layer breaks: where, and by how much.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "{law}: {quantity} at wavenumber {wavenumber:e}, plane {plane:?}, is {found:e}, not {expected:e} ± {tolerance:e}"
)]
pub struct Violation {
    /// The law's name, which is that of its function.
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
pub const LAWS: [Law; 10] = [
    ("finite", finite),
    ("reciprocity", reciprocity),
    ("positive_energy", positive_energy),
    ("general_body", general_body),
    ("uniform_pressure", uniform_pressure),
    ("free_body", free_body),
    ("long_wave", long_wave),
    ("short_wave", short_wave),
    ("mirror", mirror),
    ("split_in_two", split_in_two),
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
        $crate::layer_laws!($name, $layer => finite, reciprocity, positive_energy, general_body, uniform_pressure,
            free_body, long_wave, short_wave, mirror, split_in_two);
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

/// Face states are finite for any wavenumber, from λh = 1e-150 to 1e150, and so is the flexibility from 1e-8 to 1e8.
///
/// # Errors
/// The first number that is not.
pub fn finite(layer: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    let Some(trial) = Trial::new("finite", layer, plane) else { return Ok(()) };
    for z in EXTREME.into_iter().chain(USUAL) {
        let wave = trial.wave(z);
        let check = |quantity, number: f64| trial.equal(quantity, &wave, number, 0.0, f64::MAX);
        match layer.face_states(&wave) {
            FaceStates::Finite { top, bottom, uniform } => {
                let numbers = top.iter().chain(&bottom).chain(&uniform[0]).chain(&uniform[1]);
                numbers.copied().try_for_each(|x| check("a face state", x))?;
            }
            FaceStates::HalfPlane { top } => top.iter().try_for_each(|x| check("a face state", *x))?,
        }
        if trial.thickness.is_some() && USUAL.contains(&z) {
            let c = trial.flexibility(&wave)?;
            let numbers = [c.top, c.coupling, c.bottom, c.equal_top, c.equal_bottom];
            numbers.into_iter().try_for_each(|x| check("a flexibility", x))?;
        } else if let Some(c) = layer.flexibility(&wave) {
            // bending overflows where λh is below 1e-100: to infinity, not to nonsense
            let numbers = [c.top, c.coupling, c.bottom, c.equal_top, c.equal_bottom];
            numbers.into_iter().filter(|x| x.is_nan()).try_for_each(|x| check("a flexibility", x))?;
        }
    }
    Ok(())
}

/// Betti: of any two fields the faces give the same U₁T₂ − T₁U₂ + V₁S₂ − S₁V₂, hence C_bt = −C_tb. On a half-plane it
/// is zero.
///
/// # Errors
/// The first pair of fields, or of loads, that is not reciprocal.
pub fn reciprocity(layer: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    let Some(trial) = Trial::new("reciprocity", layer, plane) else { return Ok(()) };
    for wave in USUAL.map(|z| trial.wave(z)) {
        let states = layer.face_states(&wave);
        trial.members(&wave, "U₁T₂ − T₁U₂ + V₁S₂ − S₁V₂ of two columns", &states, &states)?;
        if let FaceStates::Finite { top, bottom, .. } = states {
            let rows = stress_rows(&top, &bottom);
            let loads = SMatrix::<f64, 4, 2>::from_row_slice(&[1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
            let amplitudes = trial.solved(&wave, solve_equilibrated(rows, loads))?;
            let (at_top, at_bottom) = (top.row(1) * amplitudes, bottom.row(1) * amplitudes);
            let tolerance = DIGITS * (at_top[0] * at_bottom[1]).abs().sqrt();
            trial.equal("C_bt = −C_tb", &wave, at_bottom[0], -at_top[1], tolerance)?;
        }
    }
    Ok(())
}

/// Any load does positive work: C_tt > 0, C_bb < 0, C_tt |C_bb| > C_tb², equal loads included. On a half-plane, also
/// loads along the face.
///
/// # Errors
/// The first load that does not.
pub fn positive_energy(layer: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    let Some(trial) = Trial::new("positive_energy", layer, plane) else { return Ok(()) };
    for z in USUAL {
        let wave = trial.wave(z);
        if trial.thickness.is_none() {
            let f = trial.surface(&wave, &layer.face_states(&wave))?;
            trial.exceeds("V under S (more than)", &wave, f[(1, 0)], 0.0)?;
            trial.exceeds("U under T (more than)", &wave, f[(0, 1)], 0.0)?;
            // displacements conjugate to (S, T) are (V, U)
            trial.exceeds("determinant of the flexibility (more than)", &wave, -f.determinant(), 0.0)?;
            continue;
        }
        let c = trial.flexibility(&wave)?;
        trial.exceeds("C_tt (more than)", &wave, c.top, 0.0)?;
        trial.exceeds("−C_bb (more than)", &wave, -c.bottom, 0.0)?;
        let product = -c.top * c.bottom;
        let determinant = product - c.coupling * c.coupling;
        // a long wave moves both faces alike: of the determinant (λh)⁴ is left
        let least = if z > 0.1 { 0.0 } else { -DIGITS * product };
        trial.exceeds("C_tt |C_bb| − C_tb² (more than)", &wave, determinant, least)?;
        let equal = c.equal_top - c.equal_bottom;
        let least = -ROUNDING * (1.0f64).min(z * z) * c.top.max(-c.bottom);
        trial.exceeds("work of equal loads (more than)", &wave, equal, least)?;
    }
    Ok(())
}

/// [`Layer::face_states`] and [`Layer::flexibility`], if overridden, are those of the state equations as
/// [`graded::face_states`] integrates them from [`Layer::material`].
///
/// # Errors
/// The first number that differs.
pub fn general_body(layer: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    let Some(trial) = Trial::new("general_body", layer, plane) else { return Ok(()) };
    for wave in USUAL.map(|z| trial.wave(z)) {
        let (states, general) = (layer.face_states(&wave), graded::face_states(layer, &wave));
        trial.members(&wave, "face states: work with those of the general body", &states, &general)?;
        if trial.thickness.is_none() {
            let [found, expected] = [trial.surface(&wave, &states)?, trial.surface(&wave, &general)?];
            trial.same_surface(&wave, &found, &expected)?;
        } else {
            // states of fewer than four independent fields would have passed so far
            let expected = trial.of(&wave, &general)?;
            trial.same_but_coupling(&wave, &trial.of(&wave, &states)?, &expected)?;
            trial.same(&wave, &trial.flexibility(&wave)?, &expected)?;
        }
    }
    Ok(())
}

/// The field "close to uniform pressure" of [`FaceStates::Finite`] is a field of the layer, and its deviation from
/// uniform pressure is accurate in itself: equal loads are answered as by the general body.
///
/// # Errors
/// The first number that differs.
pub fn uniform_pressure(layer: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    let Some(trial) = Trial::new("uniform_pressure", layer, plane) else { return Ok(()) };
    for wave in USUAL.map(|z| trial.wave(z)) {
        let states = layer.face_states(&wave);
        let FaceStates::Finite { uniform, .. } = &states else { continue };
        let general = graded::face_states(layer, &wave);
        let [top, bottom] = uniform.map(|deviation| Matrix4::from_columns(&[State::z() + deviation; 4]));
        let field = FaceStates::Finite { top, bottom, uniform: *uniform };
        trial.members(&wave, "uniform: work with the fields of the general body", &field, &general)?;
        trial.same_equal(&wave, &trial.of(&wave, &states)?, &trial.of(&wave, &general)?)?;
    }
    Ok(())
}

/// A free body under a long wave is moved as one: C_tt, −C_tb and −C_bb become the same and grow like λ⁻⁴, while
/// the response to equal loads, which are in equilibrium, grows at most like λ⁻².
///
/// # Errors
/// The first number that is not in proportion.
pub fn free_body(layer: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    let Some(trial) = Trial::new("free_body", layer, plane) else { return Ok(()) };
    let Some(beam) = trial.beam() else { return Ok(()) };
    let [wave, longer] = [beam.wave(1.0), beam.wave(0.5)];
    let [c, long] = [trial.flexibility(&wave)?, trial.flexibility(&longer)?];
    let tolerance = DIGITS * c.top.abs();
    trial.equal("C_tb", &wave, -c.coupling, c.top, tolerance)?;
    trial.equal("C_bb", &wave, -c.bottom, c.top, tolerance)?;
    trial.equal("λμ₀C_tt against that of half the wavenumber", &wave, 8.0 * c.top, long.top, DIGITS * long.top)?;
    for (quantity, x, y) in [
        ("λμ₀(C_tt + C_tb) against that of half the wavenumber", c.equal_top, long.equal_top),
        ("λμ₀(C_bt + C_bb) against that of half the wavenumber", c.equal_bottom, long.equal_bottom),
    ] {
        // λ⁻¹, or a smaller power where it is absent; what rounding leaves of the larger response is no response
        let largest = 2.0 * x.abs() * (1.0 + DIGITS) + beam.equal_loads_resolution();
        trial.equal(quantity, &wave, y, 0.0, largest)?;
    }
    Ok(())
}

/// Beam theory: λ⁴C → 1/D with the bending stiffness D about the neutral axis; equal loads p bend a beam by the moment
/// ∫ c (y − y₀) p dy of their transverse strain.
///
/// # Errors
/// The first number that is not that of the beam.
pub fn long_wave(layer: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    let Some(trial) = Trial::new("long_wave", layer, plane) else { return Ok(()) };
    let Some(beam) = trial.beam() else { return Ok(()) };
    let wave = beam.wave(1.0);
    let c = trial.flexibility(&wave)?;
    let bending = wave.modulus / (beam.stiffness * wave.wavenumber.powi(3));
    trial.equal("C_tt", &wave, c.top, bending, DIGITS * bending)?;
    trial.equal("C_bb", &wave, c.bottom, -bending, DIGITS * bending)?;
    let equal = wave.modulus * beam.moment / (beam.stiffness * wave.wavenumber);
    let tolerance = DIGITS * equal.abs() + beam.equal_loads_resolution();
    trial.equal("C_tt + C_tb", &wave, c.equal_top, equal, tolerance)?;
    trial.equal("C_bt + C_bb", &wave, c.equal_bottom, equal, tolerance)
}

/// A short wave sees a half-plane of the material at the face: λC_tt → (κ + 1)/(4μ) for an isotropic one. Granted is
/// the variation of the material over the depth that the wave feels.
///
/// # Errors
/// The first face that differs from that half-plane.
pub fn short_wave(layer: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    let Some(trial) = Trial::new("short_wave", layer, plane) else { return Ok(()) };
    let wave = trial.wave(1e8);
    let felt = 30.0 / wave.wavenumber;
    let face = |depth: f64, inside: f64| {
        let [at, near] = [layer.material(depth, plane), layer.material(inside, plane)];
        let coefficients = |m: &Material| [m.shear_compliance, m.axial_stiffness, 1.0 + m.coupling];
        let ratio = coefficients(&at).into_iter().zip(coefficients(&near)).map(|(a, b)| (a / b).ln().abs());
        let expected = surface_flexibility(&at, wave.modulus)[(1, 0)];
        (expected, expected * (DIGITS + 4.0 * ratio.fold(0.0, f64::max)))
    };
    let (top, tolerance) = face(0.0, felt);
    let Some(thickness) = trial.thickness else {
        let found = trial.surface(&wave, &layer.face_states(&wave))?[(1, 0)];
        return trial.equal("V under S", &wave, found, top, tolerance);
    };
    let c = trial.flexibility(&wave)?;
    trial.equal("C_tt", &wave, c.top, top, tolerance)?;
    let (bottom, tolerance) = face(thickness, thickness - felt);
    trial.equal("C_bb", &wave, c.bottom, -bottom, tolerance)
}

/// A layer turned upside down has its faces swapped: C_tt ↔ −C_bb, C_tb ↔ −C_bt.
///
/// # Errors
/// The first number that does not change its place.
pub fn mirror(layer: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    let Some(trial) = Trial::new("mirror", layer, plane) else { return Ok(()) };
    let Some(thickness) = trial.thickness else { return Ok(()) };
    let material = |depth: f64| layer.material((thickness - depth).clamp(0.0, thickness), plane);
    let mirrored = Profile { thickness: Some(thickness), material: &material };
    for wave in USUAL.map(|z| trial.wave(z)) {
        let c = trial.of(&wave, &mirrored.face_states(&wave))?;
        let expected = Flexibility {
            top: -c.bottom,
            coupling: c.coupling,
            bottom: -c.top,
            equal_top: -c.equal_bottom,
            equal_bottom: -c.equal_top,
        };
        trial.same(&wave, &trial.flexibility(&wave)?, &expected)?;
    }
    Ok(())
}

/// A layer is the same as its two parts, cut anywhere and bonded again.
///
/// # Errors
/// The first number that changes.
pub fn split_in_two(layer: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    let Some(trial) = Trial::new("split_in_two", layer, plane) else { return Ok(()) };
    for wave in USUAL.map(|z| trial.wave(z)) {
        let cut = 0.4 * trial.thickness.unwrap_or(1.0 / wave.wavenumber);
        let [above, below] = [0.0, cut].map(|from| move |depth: f64| layer.material(from + depth, plane));
        let above = Profile { thickness: Some(cut), material: &above }.face_states(&wave);
        let below = Profile { thickness: trial.thickness.map(|h| h - cut), material: &below }.face_states(&wave);
        match below {
            FaceStates::Finite { .. } => {
                // one system of eight equations leaves the coupling fewer digits than the rest
                let (found, expected) = (trial.flexibility(&wave)?, trial.solved(&wave, bonded(&above, &below))?);
                let tolerance = DIGITS * (expected.top * expected.bottom).abs().sqrt();
                trial.equal("C_tb", &wave, found.coupling, expected.coupling, tolerance)?;
                trial.same_but_coupling(&wave, &found, &expected)?;
            }
            FaceStates::HalfPlane { .. } => {
                let expected = trial.solved(&wave, bonded_to_half_plane(&above, &below))?;
                trial.same_surface(&wave, &trial.surface(&wave, &layer.face_states(&wave))?, &expected)?;
            }
        }
    }
    Ok(())
}

/// One law put to one layer.
struct Trial<'a> {
    law: &'static str,
    layer: &'a dyn Layer,
    plane: Plane,
    thickness: Option<f64>,
    /// Some modulus of the layer, so that the laws do not depend on units.
    modulus: f64,
}

impl<'a> Trial<'a> {
    /// `None` if the layer has no thickness at all: then there is nothing to be examined.
    fn new(law: &'static str, layer: &'a dyn Layer, plane: Plane) -> Option<Self> {
        let thickness = layer.thickness();
        let modulus = 1.0 / layer.material(0.5 * thickness.unwrap_or(0.0), plane).shear_compliance;
        (thickness != Some(0.0)).then_some(Self { law, layer, plane, thickness, modulus })
    }

    fn wave(&self, z: f64) -> Wave {
        Wave { wavenumber: z / self.thickness.unwrap_or(1.0), modulus: self.modulus, plane: self.plane }
    }

    fn violation(&self, quantity: &'static str, wave: &Wave, [found, expected, tolerance]: [f64; 3]) -> Violation {
        Violation {
            law: self.law,
            quantity,
            plane: self.plane,
            wavenumber: wave.wavenumber,
            found,
            expected,
            tolerance,
        }
    }

    fn exceeds(&self, quantity: &'static str, wave: &Wave, found: f64, least: f64) -> Result<(), Violation> {
        if found > least { Ok(()) } else { Err(self.violation(quantity, wave, [found, least, 0.0])) }
    }

    fn equal(
        &self,
        quantity: &'static str,
        wave: &Wave,
        found: f64,
        expected: f64,
        tolerance: f64,
    ) -> Result<(), Violation> {
        // not "difference > tolerance", which a NaN would pass
        let holds = (found - expected).abs() <= tolerance;
        if holds { Ok(()) } else { Err(self.violation(quantity, wave, [found, expected, tolerance])) }
    }

    fn solved<T>(&self, wave: &Wave, solution: Option<T>) -> Result<T, Violation> {
        solution.ok_or_else(|| self.violation("a response to loads on the faces", wave, [f64::NAN; 3]))
    }

    fn flexibility(&self, wave: &Wave) -> Result<Flexibility, Violation> {
        self.solved(wave, self.layer.flexibility(wave))
    }

    fn of(&self, wave: &Wave, states: &FaceStates) -> Result<Flexibility, Violation> {
        self.solved(wave, Flexibility::of_face_states(states))
    }

    /// (U, V) from (S, T) at the face of a half-plane.
    fn surface(&self, wave: &Wave, states: &FaceStates) -> Result<Matrix2<f64>, Violation> {
        let FaceStates::HalfPlane { top } = states else { return self.solved(wave, None) };
        self.solved(wave, flexibility_of_half_plane(top))
    }

    /// Every column of `states` does, by reciprocity, no net work with any column of `others`: since these are all
    /// fields that there are, it is one of them.
    fn members(
        &self,
        wave: &Wave,
        quantity: &'static str,
        states: &FaceStates,
        others: &FaceStates,
    ) -> Result<(), Violation> {
        match (states, others) {
            (
                FaceStates::Finite { top, bottom, .. },
                FaceStates::Finite { top: other_top, bottom: other_bottom, .. },
            ) => {
                // what thick layers hand from face to face, squared, is below rounding
                let thick = wave.wavenumber * self.thickness.unwrap_or(0.0) > 1.0;
                let unfelt = if thick { f64::EPSILON * ROUNDING } else { 0.0 };
                for (upper, lower) in top.column_iter().zip(bottom.column_iter()) {
                    for (other_upper, other_lower) in other_top.column_iter().zip(other_bottom.column_iter()) {
                        let (upper, lower) = (upper.into_owned(), lower.into_owned());
                        let (other_upper, other_lower) = (other_upper.into_owned(), other_lower.into_owned());
                        let size = size(&upper, &other_upper).max(size(&lower, &other_lower));
                        let both = size_over(&[upper, lower], &[other_upper, other_lower]);
                        let [at_top, at_bottom] = [work(&upper, &other_upper), work(&lower, &other_lower)];
                        self.equal(quantity, wave, at_top, at_bottom, DIGITS * size + unfelt * both)?;
                    }
                }
                Ok(())
            }
            (FaceStates::HalfPlane { top }, FaceStates::HalfPlane { top: other_top }) => {
                for one in top.column_iter() {
                    for other in other_top.column_iter() {
                        let (one, other) = (one.into_owned(), other.into_owned());
                        self.equal(quantity, wave, work(&one, &other), 0.0, DIGITS * size(&one, &other))?;
                    }
                }
                Ok(())
            }
            _ => Err(self.violation("number of faces", wave, [f64::NAN; 3])),
        }
    }

    fn same(&self, wave: &Wave, found: &Flexibility, expected: &Flexibility) -> Result<(), Violation> {
        let mean = (expected.top * expected.bottom).abs().sqrt();
        let tolerance = DIGITS * expected.coupling.abs() + ROUNDING * mean;
        self.equal("C_tb", wave, found.coupling, expected.coupling, tolerance)?;
        self.same_but_coupling(wave, found, expected)
    }

    fn same_but_coupling(&self, wave: &Wave, found: &Flexibility, expected: &Flexibility) -> Result<(), Violation> {
        self.equal("C_tt", wave, found.top, expected.top, DIGITS * expected.top.abs())?;
        self.equal("C_bb", wave, found.bottom, expected.bottom, DIGITS * expected.bottom.abs())?;
        self.same_equal(wave, found, expected)
    }

    /// Responses to equal loads.
    fn same_equal(&self, wave: &Wave, found: &Flexibility, expected: &Flexibility) -> Result<(), Violation> {
        let z = wave.wavenumber * self.thickness.unwrap_or(0.0);
        let lost = ROUNDING * (1.0f64).min(z * z) * expected.top.abs().max(expected.bottom.abs());
        let tolerance = EQUAL_LOADS * expected.equal_top.abs().max(expected.equal_bottom.abs()) + lost;
        for (quantity, x, y) in [
            ("C_tt + C_tb", found.equal_top, expected.equal_top),
            ("C_bt + C_bb", found.equal_bottom, expected.equal_bottom),
        ] {
            self.equal(quantity, wave, x, y, tolerance)?;
        }
        Ok(())
    }

    fn same_surface(&self, wave: &Wave, found: &Matrix2<f64>, expected: &Matrix2<f64>) -> Result<(), Violation> {
        let tolerance = DIGITS * expected.amax();
        for (quantity, i, j) in [("U under S", 0, 0), ("U under T", 0, 1), ("V under S", 1, 0), ("V under T", 1, 1)] {
            self.equal(quantity, wave, found[(i, j)], expected[(i, j)], tolerance)?;
        }
        Ok(())
    }

    /// The layer as a beam; `None` for a half-plane.
    fn beam(&self) -> Option<Beam> {
        let h = self.thickness?;
        let material = |depth| self.layer.material(depth, self.plane);
        let profile = Profile { thickness: self.thickness, material: &material };
        let [stretching, first, compliance] = profile.integrate(|m, depth| {
            [m.axial_stiffness, m.axial_stiffness * depth, m.shear_compliance + m.normal_compliance]
        });
        let neutral = first / stretching;
        let [stiffness, moment] =
            profile.integrate(|m, d| [m.axial_stiffness * (d - neutral).powi(2), m.coupling * (d - neutral)]);
        // the next terms are of relative order λ² h² and, for shear and compression, λ² D ∫(1/c66 + 1/c22)/h²
        let next = h * h + stiffness * compliance / (h * h);
        let wavenumber = (0.01 * DIGITS / next).sqrt();
        Some(Beam {
            stiffness,
            moment,
            thickness: h,
            unit: Wave { wavenumber, modulus: self.modulus, plane: self.plane },
        })
    }
}

/// What beam theory needs to know of a layer.
struct Beam {
    /// D = ∫ E (y − y₀)² dy.
    stiffness: f64,
    /// −∫ c (y − y₀) dy.
    moment: f64,
    thickness: f64,
    /// A wave long enough for beam theory.
    unit: Wave,
}

impl Beam {
    fn wave(&self, factor: f64) -> Wave {
        Wave { wavenumber: factor * self.unit.wavenumber, ..self.unit }
    }

    /// To which the response to equal loads is known, the wave being of finite length and numbers rounded.
    fn equal_loads_resolution(&self) -> f64 {
        DIGITS * self.unit.modulus * self.thickness.powi(2) / (self.stiffness * self.unit.wavenumber)
    }
}

/// U₁T₂ − T₁U₂ + V₁S₂ − S₁V₂.
fn work(one: &State, two: &State) -> f64 {
    one[0] * two[3] - one[3] * two[0] + one[1] * two[2] - one[2] * two[1]
}

/// The size of [`work`] if none of its terms happened to vanish.
fn size(one: &State, two: &State) -> f64 {
    size_over(&[*one], &[*two])
}

/// The same, whichever of some states is the largest.
fn size_over(ones: &[State], twos: &[State]) -> f64 {
    let largest = |states: &[State], parts: [usize; 2]| {
        states.iter().flat_map(|state| parts.map(|i| state[i].abs())).fold(0.0, f64::max)
    };
    let (displacements, stresses) = ([0, 1], [2, 3]);
    largest(ones, displacements) * largest(twos, stresses) + largest(ones, stresses) * largest(twos, displacements)
}

/// Rows S, T of the top face and S, T of the bottom face.
fn stress_rows(top: &Matrix4<f64>, bottom: &Matrix4<f64>) -> Matrix4<f64> {
    Matrix4::from_rows(&[top.row(2), top.row(3), bottom.row(2), bottom.row(3)])
}

fn flexibility_of_half_plane(top: &Matrix4x2<f64>) -> Option<Matrix2<f64>> {
    let stress: Matrix2<f64> = top.fixed_rows::<2>(2).into_owned();
    Some(top.fixed_rows::<2>(0) * solve_equilibrated(stress, Matrix2::identity())?)
}

/// Two layers bonded to each other, by one system of eight equations.
fn bonded(above: &FaceStates, below: &FaceStates) -> Option<Flexibility> {
    let FaceStates::Finite { top, bottom, uniform } = above else { return None };
    let FaceStates::Finite { top: lower_top, bottom: lower_bottom, uniform: lower_uniform } = below else {
        return None;
    };
    let mut system = SMatrix::<f64, 8, 8>::zeros();
    system.fixed_view_mut::<2, 4>(0, 0).copy_from(&top.fixed_rows::<2>(2));
    system.fixed_view_mut::<4, 4>(2, 0).copy_from(bottom);
    system.fixed_view_mut::<4, 4>(2, 4).copy_from(&-lower_top);
    system.fixed_view_mut::<2, 4>(6, 4).copy_from(&lower_bottom.fixed_rows::<2>(2));
    let mut loads = SMatrix::<f64, 8, 3>::zeros();
    loads[(0, 0)] = 1.0;
    loads[(6, 1)] = 1.0;
    loads.fixed_view_mut::<2, 1>(0, 2).copy_from(&-uniform[0].fixed_rows::<2>(2));
    loads.fixed_view_mut::<4, 1>(2, 2).copy_from(&(lower_uniform[0] - uniform[1]));
    loads.fixed_view_mut::<2, 1>(6, 2).copy_from(&-lower_uniform[1].fixed_rows::<2>(2));
    let amplitudes = solve_equilibrated(system, loads)?;
    let at_top = top.row(1) * amplitudes.fixed_rows::<4>(0);
    let at_bottom = lower_bottom.row(1) * amplitudes.fixed_rows::<4>(4);
    Some(Flexibility {
        top: at_top[0],
        coupling: at_top[1],
        bottom: at_bottom[1],
        equal_top: at_top[2] + uniform[0][1],
        equal_bottom: at_bottom[2] + lower_uniform[1][1],
    })
}

/// A layer bonded to a half-plane.
fn bonded_to_half_plane(above: &FaceStates, below: &FaceStates) -> Option<Matrix2<f64>> {
    let (FaceStates::Finite { top, bottom, .. }, FaceStates::HalfPlane { top: lower }) = (above, below) else {
        return None;
    };
    let mut system = SMatrix::<f64, 6, 6>::zeros();
    system.fixed_view_mut::<2, 4>(0, 0).copy_from(&top.fixed_rows::<2>(2));
    system.fixed_view_mut::<4, 4>(2, 0).copy_from(bottom);
    system.fixed_view_mut::<4, 2>(2, 4).copy_from(&-lower);
    let amplitudes = solve_equilibrated(system, SMatrix::<f64, 6, 2>::identity())?;
    Some(top.fixed_rows::<2>(0) * amplitudes.fixed_rows::<4>(0))
}
