//! The laws that hold at any wavenumber.
use nalgebra::{Matrix4, SMatrix};

use super::bonded::{bonded, bonded_to_half_plane};
use super::trial::{EXTREME, Trial, USUAL, stress_rows};
use super::{DIGITS, ROUNDING, Violation};
use crate::graded::{self, BodyProfile, Tree};
use crate::{FaceStates, Flexibility, Layer, Plane, State, solve_equilibrated};

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

/// [`crate::ClosedForm::face_states`] and [`crate::ClosedForm::flexibility`], if given, follow from the state equations as
/// [`graded::face_states`] integrates them from [`Layer::material`].
///
/// # Errors
/// The first number that differs.
pub fn general_body(layer: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    let Some(trial) = Trial::new("general_body", layer, plane) else { return Ok(()) };
    let tree = Tree::default();
    for wave in USUAL.map(|z| trial.wave(z)) {
        let (states, general) = (layer.face_states(&wave), graded::of_layer(layer, &wave, &tree));
        trial.members(&wave, "face states: work with the face states of the general body", &states, &general)?;
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
    let tree = Tree::default();
    for wave in USUAL.map(|z| trial.wave(z)) {
        let states = layer.face_states(&wave);
        let FaceStates::Finite { uniform, .. } = &states else { continue };
        let general = graded::of_layer(layer, &wave, &tree);
        let [top, bottom] = uniform.map(|deviation| Matrix4::from_columns(&[State::z() + deviation; 4]));
        let field = FaceStates::Finite { top, bottom, uniform: *uniform };
        trial.members(&wave, "uniform: work with the fields of the general body", &field, &general)?;
        trial.same_equal(&wave, &trial.of(&wave, &states)?, &trial.of(&wave, &general)?)?;
    }
    Ok(())
}

/// A layer turned upside down has its faces swapped: C_tt ↔ −C_bb, C_tb ↔ −C_bt.
///
/// # Errors
/// The first number that does not change its place.
pub fn mirror(layer: &dyn Layer, plane: Plane) -> Result<(), Violation> {
    let Some(trial) = Trial::new("mirror", layer, plane) else { return Ok(()) };
    let Some(thickness) = trial.thickness else { return Ok(()) };
    let material = |depth: f64| layer.material((thickness - depth).clamp(0.0, thickness), plane);
    let mirrored = BodyProfile { thickness: Some(thickness), material: &material, kinks: &[] };
    let tree = Tree::default();
    for wave in USUAL.map(|z| trial.wave(z)) {
        let c = trial.of(&wave, &mirrored.face_states(&wave, &tree))?;
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
        let above = BodyProfile { thickness: Some(cut), material: &above, kinks: &[] };
        let below = BodyProfile { thickness: trial.thickness.map(|h| h - cut), material: &below, kinks: &[] };
        let [above, below] = [above, below].map(|part| part.face_states(&wave, &Tree::default()));
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
