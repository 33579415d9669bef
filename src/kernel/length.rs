//! The unit of length of a stack, which makes wavenumbers dimensionless.
use recede_layers::{Layer, Plane};

use crate::stack::Stack;

/// Relative changes of the moduli with the depth, the first of which that occurs at any depth defines the length of a graded half-plane.
/// The length only scales the wavenumber axis, on which panels double in width, so that other values give the same
/// kernels. A half-plane whose moduli change by less than the last value is homogeneous to rounding.
const CHANGES: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];
/// Natural logarithm of the largest depth searched, in the unit of the scene: from 1e-300 to 1e300.
const DEEPEST: f64 = 690.0;
/// Bisections of that interval: the depth is then known to rounding.
const BISECTIONS: usize = 64;

/// The length over which kernels vary: the total thickness of the layers or, without layers, the depth over which the moduli of the
/// half-plane vary. `None` for a homogeneous half-plane, in which no length occurs.
pub(super) fn intrinsic_length(stack: &Stack) -> Option<f64> {
    let total = stack.total_thickness();
    if total > 0.0 {
        return Some(total);
    }
    variation(&*stack.base().foundation().half_plane()?.layer, stack.plane())
}

/// The depth over which the moduli of a half-plane would change by 100 %, at their rate of change next to the face.
fn variation(layer: &dyn Layer, plane: Plane) -> Option<f64> {
    let face = layer.material(0.0, plane);
    let change = |depth: f64| {
        let below = layer.material(depth, plane);
        let relative = [
            below.shear_compliance / face.shear_compliance - 1.0,
            (below.normal_compliance - face.normal_compliance) / face.shear_compliance,
            below.coupling - face.coupling,
            below.axial_stiffness / face.axial_stiffness - 1.0,
        ];
        relative.iter().fold(0.0, |most: f64, change| most.max(change.abs()))
    };
    let least = CHANGES.into_iter().find(|least| change(DEEPEST.exp()) > *least)?;
    let (mut low, mut high) = (-DEEPEST, DEEPEST);
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (low + high);
        if change(middle.exp()) > least { high = middle } else { low = middle }
    }
    Some(high.exp() / least)
}

#[cfg(test)]
mod tests {
    use recede_layers::{GradedHalfPlane, HalfPlane, PowerHalfPlane};

    use super::*;

    #[test]
    fn the_length_of_a_half_plane_scales_with_it() {
        let length = |layer: &dyn Layer| variation(layer, Plane::Strain);
        assert_eq!(length(&HalfPlane::new(2.0, 0.3).unwrap()), None);
        assert_eq!(length(&GradedHalfPlane::new(2.0, 0.3, 0.0).unwrap()), None);
        for unit in [1e-60, 1e-3, 1.0, 1e60] {
            let exponential = length(&GradedHalfPlane::new(2.0, 0.3, 0.5 / unit).unwrap()).unwrap();
            assert!((exponential / (2.0 * unit) - 1.0).abs() < 2e-3, "{exponential} {unit}");
            let power = length(&PowerHalfPlane::new(2.0, 0.3, 3.0 * unit, 0.5).unwrap()).unwrap();
            assert!((power / (6.0 * unit) - 1.0).abs() < 2e-3, "{power} {unit}");
        }
    }
}
