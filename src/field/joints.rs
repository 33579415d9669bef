//! Where the bodies of a stack touch, so that their displacements are counted from one base.
use super::Field;
use super::potentials::Components;

/// A place at which two bodies touch.
pub(super) struct Joint {
    pub(super) contact: usize,
    pub(super) x: f64,
    /// Whether this is the face of the body above.
    is_above: bool,
    pub(super) layer: usize,
    pub(super) depth: f64,
}

impl Field {
    /// Where the bodies are joined, from the top down: the lower face of each contact below the uppermost one, and where bodies are apart
    /// at x = 0, from where v of the body above is counted, also its upper face.
    pub(super) fn joints(&self) -> Vec<Joint> {
        let mut joints = Vec::new();
        for (contact, x) in self.joints.iter().copied().enumerate().skip(1) {
            let last = self.layers.iter().rposition(|placed| placed.body + 1 == contact);
            if let Some(layer) = last.filter(|_| x > 0.0) {
                let depth = self.layers[layer].thickness.unwrap_or(0.0);
                joints.push(Joint { contact, x, is_above: true, layer, depth });
            }
            if let Some(layer) = self.layers.iter().position(|placed| placed.body == contact) {
                joints.push(Joint { contact, x, is_above: false, layer, depth: 0.0 });
            }
        }
        joints
    }

    /// By how much v of each body, counted from its own reference point, is to be lifted; `values` are those at the joints.
    pub(super) fn lifts(&self, joints: &[Joint], values: &[Vec<Components>]) -> Vec<f64> {
        let mut lifts = vec![0.0; self.bodies.len() + 1];
        for (joint, values) in joints.iter().zip(values).rev() {
            let v = values[0][4];
            if joint.is_above {
                lifts[joint.contact - 1] -= v
            } else {
                lifts[joint.contact - 1] = lifts[joint.contact] + v
            }
        }
        lifts
    }
}
