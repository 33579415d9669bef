//! The punch as the contact equations see it, per unit of P': its slope and height, and the pressure that is as singular as it is.

use crate::contact::error::{ContactError, NoSolution};
use crate::contact::problem::face::Face;
use crate::contact::problem::twin::Twin;
use crate::numeric::means::MeanWindow;
use crate::numeric::waves::smooth_step;
use crate::scene::{Gap, Punch, Shape};

/// The places x = m + w cos θ, 0 < θ < π, on which a profile is tested, in units of L.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Span {
    pub(super) middle: f64,
    pub(super) half: f64,
    /// From the order k of a row to the next.
    pub(super) step: usize,
}

impl Span {
    /// About x = 0 under an even profile: only the rows of odd k, the row of k = 2m + 1 times (−1)^m.
    pub(crate) fn even(half: f64) -> Self {
        Self { middle: 0.0, half, step: 2 }
    }

    /// Anywhere under any profile: rows of all k from 0 on.
    pub(crate) fn anywhere(middle: f64, half: f64) -> Self {
        Self { middle, half, step: 1 }
    }
}

/// The profile of a punch pressed with a force, in the units of the kernel.
#[derive(Clone)]
pub(crate) struct PunchProfile<'a> {
    /// None of a gap that layers make by bending alone.
    punch: Option<&'a Punch>,
    pub(super) shape: Shape<'a>,
    /// Length L in the units of the scene.
    pub(super) length: f64,
    /// P'.
    pub(super) force: f64,
    pub(super) twin: Twin,
    /// What the face below adds.
    pub(super) face: Face<'a>,
}

impl<'a> PunchProfile<'a> {
    /// A punch in units of L, pressed with P'.
    pub(crate) fn new(punch: &'a Punch, length: f64, force: f64, twin: Twin) -> Self {
        Self { punch: Some(punch), shape: punch.shape(), length, force, twin, face: Face::default() }
    }

    /// A gap between layers in units of L, per unit of P'.
    pub(crate) fn gap(gap: &'a Gap, length: f64, force: f64, twin: Twin) -> Self {
        Self { punch: gap.punch.as_ref(), shape: gap.shape(), length, force, twin, face: Face::default() }
    }

    /// The same over a face that is not flat.
    pub(crate) fn over(self, face: Face<'a>) -> Self {
        Self { face, ..self }
    }

    /// The same punch, pressed with another force.
    pub(crate) fn with_force(&self, force: f64) -> Self {
        Self { force, ..self.clone() }
    }

    /// The punch as it is written.
    pub(super) fn label(&self) -> String {
        self.punch.map_or_else(String::new, |punch| punch.label(self.twin.geometry()))
    }

    /// Where it ends on both sides of its tip, in units of L; infinite where it does not.
    pub(super) fn ends(&self) -> [f64; 2] {
        self.shape.ends().map(|end| end / self.length)
    }

    /// Half-length of the contact, in units of L, if the punch has sharp corners.
    pub(crate) fn flat(&self) -> Option<f64> {
        if let Shape::Flat(edge) = self.shape { Some(edge / self.length) } else { None }
    }

    /// Whether the profile is less smooth than with a sharp tip alone.
    pub(crate) fn is_kinked(&self) -> bool {
        match &self.shape {
            Shape::Powers { terms, .. } => terms.iter().any(|(exponent, _)| *exponent != 1.0 && exponent % 2.0 != 0.0),
            Shape::Pieces { .. } => true,
            Shape::Circle(_) | Shape::Flat(_) | Shape::Dent { .. } => false,
        }
    }

    /// Whether the pressure is infinite at the apex.
    pub(crate) fn is_sharp(&self) -> bool {
        self.punch.is_some_and(Punch::is_sharp)
    }

    /// By how much the slope jumps at a sharp tip, per unit of P'.
    pub(crate) fn jump(&self) -> Option<f64> {
        // so near to a tip that the slope is the limit from one side
        self.is_sharp().then(|| self.slope(1e-200) - self.slope(-1e-200))
    }

    /// Half-length at which the punch ends, in units of L.
    pub(crate) fn edge(&self) -> Option<f64> {
        self.shape.edge().map(|limit| limit / self.length)
    }

    /// The last place at which the profile falls, in units of L; 0 if it does so nowhere.
    pub(crate) fn last_fall(&self) -> f64 {
        self.shape.last_fall() / self.length
    }

    /// The error to report if a contact has grown to an end at x from the tip, and that is next to the edge of the punch, where the slope of a circle is infinite.
    pub(crate) fn too_small(&self, x: f64) -> Option<ContactError> {
        let [left, right] = self.shape.ends();
        let (from_tip, edge) = if x < 0.0 { (-x, -left) } else { (x, right) };
        (self.flat().is_none() && from_tip * self.length > 0.999 * edge)
            .then(|| NoSolution::PunchTooSmall { punch: self.label(), edge }.into())
    }

    /// The half-length at which a step from `before` to `after` ends: a contact covers more than the flat part of the
    /// punch, and less than all of it.
    pub(crate) fn within(&self, before: f64, after: f64) -> f64 {
        let flat = self.shape.flat() / self.length;
        match self.edge() {
            Some(edge) if after >= edge => 0.5 * (edge + before),
            _ if after <= flat => 0.5 * (flat + before),
            _ => after,
        }
    }

    /// Height above the apex at x (both in units of L), per unit of P'.
    pub(crate) fn height(&self, x: f64) -> f64 {
        let x = x * self.length;
        (self.shape.height(x) + self.face.at(x)[0]) / (self.length * self.force)
    }

    /// Height above the lowest point at x (in units of L), per unit of P'.
    pub(crate) fn height_above_lowest(&self, x: f64) -> f64 {
        self.height(x) - self.shape.lowest() / (self.length * self.force)
    }

    /// How much higher than the lowest point the profile, turned by an angle about its tip, is on average about the middle of its contact, per unit of P'.
    pub(crate) fn mean_height(&self, window: &MeanWindow, tip: f64, angle: f64) -> f64 {
        let mut starts: Vec<f64> = self.shape.starts().iter().map(|start| tip + start / self.length).collect();
        // powers are not smooth at the tip
        starts.push(tip);
        let height = |x: f64| self.height_above_lowest(x - tip) + angle * (x - tip);
        window.of_profile(self.twin == Twin::Round, height, &starts)
    }

    /// Slope at x (in units of L), per unit of P'.
    pub(crate) fn slope(&self, x: f64) -> f64 {
        let x = x * self.length;
        (self.shape.slope(x) + self.face.at(x)[1]) / self.force
    }

    /// ∫ f'(as) s/√(1 − s²) ds / P'.
    pub(crate) fn first_row(&self, half_length: f64) -> f64 {
        // of an uneven profile the even part counts
        match self.shape.is_even() && self.face.from == 0.0 {
            true => self.rows(Span::even(half_length), 1)[0],
            false => self.rows(Span::anywhere(0.0, half_length), 2)[1],
        }
    }
}

/// Continues modes by the modes of the local pressure, tapered to nothing at their end, so that the sum of all converges fast
/// wherever the pressure is smooth.
pub(crate) fn continued(modes: &mut Vec<f64>, local: &[f64]) {
    let from = modes.len();
    for (m, y) in local.iter().enumerate().skip(from) {
        modes.push(smooth_step((m - from) as f64 / (local.len() - from) as f64) * y);
    }
}
