//! The largest shear stress.
use super::Field;
use super::error::FieldError;
use super::measure::{Measure, Peak, Search};
use super::search::{Extent, highest};
use super::strip::Singularity;
use crate::system::Unresolved;

/// The largest shear stress in the plane, (σ₁ − σ₂)/2, and where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaxShear {
    /// The stress; infinite under a line load and at the sharp corners of a punch.
    pub value: f64,
    /// Along the layers, x ≥ 0; by symmetry it is found at −x, too.
    pub x: f64,
    /// Below the top face of the stack.
    pub depth: f64,
    /// Number of the layer.
    pub layer: usize,
}

pub(super) fn max_shear(field: &Field) -> Result<MaxShear, FieldError> {
    if let Some(x) = infinite(field, Measure::MaxShear) {
        let layer = field.layers.first().map_or(1, |placed| placed.number);
        return Ok(MaxShear { value: f64::INFINITY, x, depth: 0.0, layer });
    }
    let search = Search { measure: Measure::MaxShear, layer: None };
    let found = highest(field, &[search], Extent::Near)?.into_iter().next().flatten();
    let Some(Peak { layer, x, depth, value, .. }) = found.filter(|peak| peak.value.is_finite()) else {
        return Err(Unresolved { wavenumber: 0.0 }.into());
    };
    let placed = &field.layers[layer];
    Ok(MaxShear { value, x, depth: placed.top + depth, layer: placed.number })
}

/// Where on the top face a stress is infinite: under a line load and at sharp corners, where no tension is; and under a sharp tip the
/// shear stress where stresses on the face are not the same along it and across, as they are where its material is isotropic, and
/// von Mises' stress where that out of the plane is another.
pub(super) fn infinite(field: &Field, measure: Measure) -> Option<f64> {
    let placed = field.layers.first()?;
    let face = field.bodies.first()?.faces[0].as_ref();
    let isotropic = face.is_some_and(|face| face.surface.is_isotropic());
    let hydrostatic = || {
        let shares = placed.layer.material(0.0, field.plane).out_of_plane;
        field.plane == recede_layers::Plane::Strain && shares.is_some_and(|[along, across]| along + across == 1.0)
    };
    let at_tip = match measure {
        Measure::MaxShear => !isotropic,
        Measure::VonMises => !isotropic || !hydrostatic(),
        _ => return None,
    };
    let points = field.pressures.first()?.singular_points().filter(|(_, kind)| *kind != Singularity::Tip || at_tip);
    points.map(|(x, _)| x).min_by(f64::total_cmp)
}
