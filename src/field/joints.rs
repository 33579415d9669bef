//! Where the bodies of a stack touch, so that their displacements are counted from one base.
use super::Field;
use super::body::Rows;
use super::surface::Components;
use crate::solution::ClosedInterface;

/// The numbers of the rows of the faces that touch at a place, the face of the body above first, if there are any.
type JointRows = [Option<usize>; 2];

/// How a body that was counted from its own reference point has moved: v grows by `lift` and by `turn` times x.
#[derive(Clone, Copy, Default)]
pub(super) struct Motion {
    pub(super) lift: f64,
    pub(super) turn: f64,
}

/// Two places at which layers that weights press together touch: the outermost ends of openings, or as far from the middle as the layers are thick; of what is even the right one twice.
pub(super) fn beside_openings(own: &ClosedInterface, is_even: bool, thickness: f64) -> [f64; 2] {
    let right = own.openings.last().map_or(thickness, |last| last.right);
    let left = own.openings.first().map_or(-thickness, |first| first.left);
    [if is_even { right } else { left }, right]
}

impl Field {
    /// Adds rows where the bodies are joined, and tells for each contact below the uppermost one which they are: at one place, or where bodies may
    /// turn at two, the lower face, and the upper one but where v of the body above is counted from the middle there.
    pub(super) fn joints(&self, rows: &mut Rows) -> Vec<[JointRows; 2]> {
        let first = rows.rows.len();
        let mut add = |layer: usize, depth: f64, x: f64| rows.add(layer, &[depth], vec![x]) - first;
        let of = |(contact, [from, to]): (usize, &[f64; 2])| {
            let last = self.bodies[contact - 1].layers.end - 1;
            let next = self.bodies.get(contact).map(|body| body.layers.start);
            let mut joint = |x: f64| {
                let depth = self.layers[last].thickness.unwrap_or(0.0);
                let above = (x != 0.0 || from != to).then(|| add(last, depth, x));
                [above, next.map(|layer| add(layer, 0.0, x))]
            };
            let first = joint(*from);
            [first, if from == to { first } else { joint(*to) }]
        };
        self.joints.iter().enumerate().skip(1).map(of).collect()
    }

    /// How the bodies have moved, from the top down; `values` are the components in the rows of the joints.
    pub(super) fn motions(&self, joints: &[[JointRows; 2]], values: &[Vec<Components>]) -> Vec<Motion> {
        let mut motions = vec![Motion::default(); self.bodies.len() + 1];
        for (k, (places, joints)) in self.joints.iter().skip(1).zip(joints).enumerate().rev() {
            let contact = k + 1;
            let below = motions[contact];
            let v = |row: Option<usize>| row.map_or(0.0, |row| values[row][0][4]);
            let apart = [0, 1].map(|k| {
                let [above, own] = joints[k].map(v);
                own + below.lift + below.turn * places[k] - above - self.apart[contact][k]
            });
            let [from, to] = *places;
            let turn = if from < to { (apart[1] - apart[0]) / (to - from) } else { 0.0 };
            motions[contact - 1] = Motion { lift: apart[0] - turn * from, turn };
        }
        motions
    }
}
