//! A punch anywhere on the top face, one of those whose contacts are not even.
use crate::contact::error::ContactError;
use crate::contact::problem::Group;
use crate::contact::problem::face::Face;
use crate::contact::problem::profile::{PunchProfile, Span};
use crate::contact::problem::twin::Twin;
use crate::numeric::means::MeanWindow;
use crate::numeric::search::begins;
use crate::scene::{Gap, Pressed, Punches, Tilt};

/// A punch at a place, in units of L, which counts from where x = 0 is in the problem.
pub(crate) struct Placed<'a> {
    profile: PunchProfile<'a>,
    at: f64,
    /// Its part of P'.
    share: f64,
    tilt: Tilt,
    length: f64,
    force: f64,
}

impl<'a> Placed<'a> {
    /// All punches, with x = 0 at this place in units of L, pressed with P' together.
    pub(crate) fn all(punches: &'a Punches, face: Face<'a>, origin: f64, length: f64, force: f64) -> Vec<Self> {
        let of = |(pressed, share): (&'a Pressed, f64)| Self {
            profile: PunchProfile::new(pressed.shape(), length, force, Twin::Plane)
                .over(Face { from: pressed.at(), ..face }),
            at: pressed.at() / length - origin,
            share,
            tilt: pressed.tilt(),
            length,
            force,
        };
        punches.parts().map(of).collect()
    }

    /// A gap between layers about x = 0 in the scene.
    pub(crate) fn gap(gap: &'a Gap, face: Face<'a>, origin: f64, length: f64, force: f64) -> Self {
        let profile = PunchProfile::gap(gap, length, force, Twin::Plane).over(face);
        Self { profile, at: -origin, share: 1.0, tilt: Tilt::None, length, force }
    }

    /// What the intervals under it carry.
    pub(crate) fn group(&self) -> Group {
        let moment = self.line_of_action().map(|line| self.share * line);
        Group { share: self.share, moment, turns: moment.is_some() }
    }

    /// Where its force acts on x, if it may turn.
    pub(crate) fn line_of_action(&self) -> Option<f64> {
        match self.tilt {
            Tilt::Free { eccentricity } => Some(self.at + eccentricity / self.length),
            Tilt::None | Tilt::Fixed(_) => None,
        }
    }

    /// The angle by which it is turned, per unit of P', if that is prescribed.
    pub(crate) fn angle(&self) -> Option<f64> {
        self.tilt.angle().map(|angle| angle / self.force)
    }

    /// Height above the tip at x, per unit of P'.
    pub(crate) fn height(&self, x: f64) -> f64 {
        // rounding does not lead beyond its edge
        let [left, right] = self.profile.ends();
        let from_tip = (x - self.at).clamp(left, right);
        self.profile.height(from_tip) + self.angle().unwrap_or(0.0) * from_tip
    }

    /// How much higher than at its lowest point, before it was turned, the punch is on average over a window, per unit of P'.
    pub(crate) fn mean_height(&self, window: &MeanWindow) -> f64 {
        self.profile.mean_height(window, self.at, self.angle().unwrap_or(0.0))
    }

    /// ∫ f' cos kφ dφ of its slope f' over x = m + w cos φ, for k from 0 on.
    pub(crate) fn rows(&self, middle: f64, half: f64, count: usize) -> Vec<f64> {
        let mut rows = self.profile.rows(Span::anywhere(middle - self.at, half), count);
        if let Some(first) = rows.first_mut() {
            *first += std::f64::consts::PI * self.angle().unwrap_or(0.0);
        }
        rows
    }

    /// Where the punch ends; infinite where it does not.
    pub(crate) fn ends(&self) -> [f64; 2] {
        self.profile.ends().map(|end| self.at + end)
    }

    /// Where the corner on a side is, 1 for the right one and −1 for the left one, if the punch is flat.
    pub(crate) fn corner(&self, side: f64) -> Option<f64> {
        self.profile.flat().map(|half| self.at + side * half)
    }

    /// Whether the profile is less smooth than with a sharp tip alone.
    pub(crate) fn is_kinked(&self) -> bool {
        self.profile.is_kinked()
    }

    /// Where it has a sharp tip, and by how much its slope jumps there, per unit of P'.
    pub(crate) fn tip(&self) -> Option<(f64, f64)> {
        self.profile.jump().map(|jump| (self.at, jump))
    }

    /// Where it is lowest, turned by its angle: the slope of the profile is minus that there.
    pub(crate) fn lowest(&self) -> f64 {
        let angle = self.angle().unwrap_or(0.0);
        if angle == 0.0 || self.profile.flat().is_some() {
            return self.at;
        }
        let side = -angle.signum();
        let rises = |x: f64| side * (self.profile.slope(side * x) + angle) >= 0.0;
        let edge = self.profile.ends()[usize::from(side > 0.0)].abs();
        // the last place before it rises, if it does so within a million times L
        let (mut low, mut high) = (0.0, edge.min(1.0));
        while high < edge && high < 1e6 && !rises(high) {
            (low, high) = (high, (2.0 * high).min(edge));
        }
        self.at + side * begins([low, high], rises)
    }

    /// Where its tip is.
    pub(crate) fn at(&self) -> f64 {
        self.at
    }

    /// The profile by itself, pressed with its own part of the force.
    pub(crate) fn alone(&self) -> PunchProfile<'a> {
        self.profile.with_force(self.share * self.force)
    }

    /// The error that the punch is too small for a contact that ends at x.
    pub(crate) fn too_small(&self, x: f64) -> Option<ContactError> {
        self.profile.too_small(x - self.at)
    }

    /// The place at which a step of an end from one place to another ends: next to the edge of the punch.
    pub(crate) fn within(&self, before: f64, after: f64) -> f64 {
        let [left, right] = self.ends();
        if after >= right {
            0.5 * (right + before)
        } else if after <= left {
            0.5 * (left + before)
        } else {
            after
        }
    }
}
