//! What presses the layers together before anything else does: their weights, and a pressure on top.
use super::{Base, Joint, Laminate, Placed, Stack};

impl Stack {
    /// The pressure on each receding interface while all are closed and nothing else presses, from the top down: the pressure on top and the weights of all layers above.
    pub fn weights(&self) -> Vec<f64> {
        let mut pressure = self.pressure_on_top;
        let below = |laminate: &Laminate| {
            pressure += laminate.layers.iter().map(weight).sum::<f64>();
            pressure
        };
        self.laminates.iter().map(below).collect()
    }

    /// How many receding interfaces nothing presses together: the uppermost ones.
    pub(crate) fn loose(&self) -> usize {
        self.weights().partition_point(|weight| *weight == 0.0)
    }

    /// The stack with interfaces that slide in place of the receding ones that are pressed together; `None` if there are none.
    pub(crate) fn closed(&self) -> Option<Self> {
        let (loose, pressed) = self.laminates.split_at(self.loose());
        if pressed.is_empty() {
            return None;
        }
        let Base { joined, foundation } = &self.base;
        let mut all = Laminate::default();
        for laminate in pressed {
            all.layers.extend(laminate.layers.iter().cloned());
            all.joints.extend(laminate.joints.iter().copied().chain([Joint::SLIDING]));
        }
        all.layers.extend(joined.layers.iter().cloned());
        all.joints.extend(&joined.joints);
        let base = Base { joined: all, foundation: foundation.clone() };
        Some(Self {
            laminates: loose.to_vec(),
            base,
            dropped: self.dropped.clone(),
            second: self.second.clone(),
            ..*self
        })
    }

    /// Curves the laminates above parabolic gaps that weights press flat: all of them lie on a base that stays flat.
    pub(super) fn press_flat(&mut self) {
        let (loose, mut curvature) = (self.loose(), 0.0);
        for laminate in self.laminates[loose..].iter_mut().rev() {
            curvature -= laminate.gap.as_ref().and_then(|gap| gap.shape().even_curvature()).unwrap_or(0.0);
            laminate.layers.iter_mut().for_each(|placed| placed.pressed_to = curvature);
        }
    }
}

/// The weight of a layer, force per area.
pub(super) fn weight(placed: &Placed) -> f64 {
    placed.layer.specific_weight() * placed.thickness()
}
