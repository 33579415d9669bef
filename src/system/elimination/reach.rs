//! How many layers of a chain the fields of a face reach.
use std::sync::Arc;

use recede_layers::{Layer, Plane, Wave};

/// Fields decay like e^(−λd): they end beyond this λd, where even their square is below rounding.
const END: f64 = 40.0;

/// How many layers a flexibility has taken.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Taken {
    /// Those that the wave reaches.
    pub(crate) reached: usize,
    /// Those that were evaluated, others being equal to them.
    pub(crate) evaluated: usize,
}

impl std::ops::AddAssign for Taken {
    fn add_assign(&mut self, other: Self) {
        self.reached += other.reached;
        self.evaluated += other.evaluated;
    }
}

/// How many of the layers, counted from a face, the fields of a load on that face reach.
pub(super) fn reached<'a>(layers: impl Iterator<Item = &'a Arc<dyn Layer>>, wave: &Wave) -> usize {
    let mut length = 0.0;
    let mut count = 0;
    for layer in layers {
        if length > END {
            break;
        }
        let thickness = layer.thickness().unwrap_or(f64::INFINITY);
        let own = wave.wavenumber * thickness;
        // unless what stiffens a layer along its faces carries the fields farther
        length += if length + own > END { own * slowest_decay(&**layer, thickness, wave.plane) } else { own };
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
