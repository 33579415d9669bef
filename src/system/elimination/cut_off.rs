//! The cut-off of a chain: the layers below it are so far from a loaded face that its fields have decayed there.
use std::sync::Arc;

use recede_layers::{Layer, Plane, Wave};

use super::junction::Junction;

/// Fields decay like e^(−λd): they end beyond this λd, where even their square is below rounding.
const END: f64 = 40.0;

/// Plates of thickness d that slide on each other decay the more slowly the thinner they are, by (λd)²/√12 each if λd is small,
/// since nothing but their bending resists: by no less than λd·λd/(λd + LOOSE). Among plates of different stiffness fields decay faster.
const LOOSE: f64 = 4.0;

/// The number of layers, in the order `outwards` from a loaded face, after which the fields of the load have decayed; `junctions` are
/// those between each layer and the next.
pub(super) fn cut_off(
    layers: &[Arc<dyn Layer>],
    junctions: &[Junction],
    outwards: impl Iterator<Item = usize>,
    wave: &Wave,
) -> usize {
    let is_loose = |interface: usize| junctions.get(interface).is_some_and(|junction| !junction.is_bonded());
    let mut length = 0.0;
    let mut count = 0;
    for i in outwards {
        if length > END {
            break;
        }
        let layer = &*layers[i];
        let thickness = layer.thickness().unwrap_or(f64::INFINITY);
        let mut phase = wave.wavenumber * thickness;
        if phase.is_finite() && (is_loose(i) || i.checked_sub(1).is_some_and(is_loose)) {
            phase *= phase / (phase + LOOSE);
        }
        // fields decay more slowly in layers that are stiff along their faces
        length += if length + phase > END { phase * slowest_decay(layer, thickness, wave.plane) } else { phase };
        count += 1;
    }
    count
}

/// The slowest decay of fields in a layer, see [`Material::slowest_decay`].
///
/// [`Material::slowest_decay`]: recede_layers::Material::slowest_decay
pub(crate) fn slowest_decay(layer: &dyn Layer, thickness: f64, plane: Plane) -> f64 {
    let at = |depth: f64| layer.material(depth, plane).slowest_decay();
    [0.0, 0.5, 1.0].map(|part| at(part * thickness)).into_iter().fold(1.0, f64::min)
}
