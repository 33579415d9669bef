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

/// How a body that was counted from its own reference point has moved: v grows by `lift` and by `turn` times x.
#[derive(Clone, Copy, Default)]
pub(super) struct Motion {
    pub(super) lift: f64,
    pub(super) turn: f64,
}

impl Motion {
    /// Adds it to displacements and slope at a place, which lies so deep in its body.
    pub(super) fn add_to(self, components: &mut Components, x: f64, depth: f64) {
        let [.., u, v, slope] = components;
        *u += self.turn * depth;
        *v += self.lift + self.turn * x;
        *slope += self.turn;
    }
}

impl Field {
    /// Where the bodies are joined, from the top down: at one place of each contact below the uppermost one, or where bodies may turn at two, the
    /// upper face, but where v of the body above is counted from x = 0 there, and then the lower face.
    pub(super) fn joints(&self) -> Vec<Joint> {
        let mut joints = Vec::new();
        for (contact, places) in self.joints.iter().enumerate().skip(1) {
            let last = self.layers.iter().rposition(|placed| placed.body + 1 == contact);
            let first = self.layers.iter().position(|placed| placed.body == contact);
            let is_one = places[0] == places[1];
            for x in places.iter().copied().take(if is_one { 1 } else { 2 }) {
                if let Some(layer) = last.filter(|_| x != 0.0 || !is_one) {
                    let depth = self.layers[layer].thickness.unwrap_or(0.0);
                    joints.push(Joint { contact, x, is_above: true, layer, depth });
                }
                if let Some(layer) = first {
                    joints.push(Joint { contact, x, is_above: false, layer, depth: 0.0 });
                }
            }
        }
        joints
    }

    /// How the bodies have moved, from the top down; `values` are those at the joints.
    pub(super) fn motions(&self, joints: &[Joint], values: &[Vec<Components>]) -> Vec<Motion> {
        let mut motions = vec![Motion::default(); self.bodies.len() + 1];
        for (contact, places) in self.joints.iter().enumerate().skip(1).rev() {
            let below = motions[contact];
            let v = |x: f64, is_above: bool| {
                let own = |joint: &&(&Joint, &Vec<Components>)| {
                    (joint.0.contact, joint.0.x, joint.0.is_above) == (contact, x, is_above)
                };
                joints.iter().zip(values).collect::<Vec<_>>().iter().find(own).map_or(0.0, |(_, values)| values[0][4])
            };
            let apart = places.map(|x| v(x, false) + below.lift + below.turn * x - v(x, true));
            let [from, to] = *places;
            let turn = if from < to { (apart[1] - apart[0]) / (to - from) } else { 0.0 };
            motions[contact - 1] = Motion { lift: apart[0] - turn * from, turn };
        }
        motions
    }
}
