//! The punch above a stack, and the force on it; or the load in its place.
use super::names::{Dimension, unit};
use super::picture::{Anchor, Picture, Stroke, italic};
use super::pressure::{highest, pressure};
use super::scale::label;
use super::style::{FAINT, INK, SMALL, TEXT};
use crate::scene::{Force, Load, Scene};
use crate::solution::Contact;

/// Room for the punch and its force, in points.
pub(super) const ABOVE: f64 = 72.0;
/// Greatest height of the punch, in points.
const HIGHEST: f64 = 34.0;
/// Points of its outline.
const POINTS: usize = 200;

/// A punch in a drawing.
pub(super) struct Punch<'a> {
    pub(super) scene: &'a Scene,
    /// What is under it: it is pressed in as far as it touches.
    pub(super) contact: Option<&'a Contact>,
    /// Points per length along the layers and across them.
    pub(super) scale: [f64; 2],
    /// Where x = 0 is.
    pub(super) middle: f64,
    /// Height of the top face of the stack.
    pub(super) top: f64,
    /// What is seen of it.
    pub(super) ends: (f64, f64),
}

impl Punch<'_> {
    pub(super) fn draw(&self, picture: &mut Picture) {
        let (left, right) = self.ends;
        let punch = &self.scene.punch;
        let [along, across] = self.scale;
        let edge = punch.max_half_length().map_or(f64::INFINITY, |edge| along * edge);
        let (from, to) = (left.max(self.middle - edge), right.min(self.middle + edge));
        if let Some(load) = punch.load() {
            return self.load(load, picture);
        }
        let touching = self.contact.map_or(0.0, |contact| contact.innermost().to);
        let rise = |x: f64| {
            let x = (x - self.middle) / along;
            (across * (punch.profile(x) - punch.profile(touching))).clamp(0.0, HIGHEST)
        };
        if from < to {
            let at = |i: usize| from + (to - from) * i as f64 / POINTS as f64;
            let outline: Vec<(f64, f64)> = (0..=POINTS).map(at).map(|x| (x, self.top - rise(x))).collect();
            let upper = [(to, self.top - HIGHEST), (from, self.top - HIGHEST)];
            let body: Vec<_> = outline.iter().copied().chain(upper).collect();
            picture.area(&body, FAINT, 0.8);
            picture.line(&outline, Stroke { colour: INK, width: 1.0, dash: None });
        }
        if (left..=right).contains(&self.middle) {
            self.force(picture);
        }
        picture.text((right + 9.0, self.top - 0.5 * HIGHEST), &punch.label(), SMALL, INK, Anchor::Left);
    }

    /// Pressures as curves, lines as arrows.
    fn load(&self, load: &Load, picture: &mut Picture) {
        let (left, right) = self.ends;
        let curve = self.contact.map_or(Vec::new(), |contact| pressure(self.scene, contact));
        let most = highest(&curve);
        let place = |x: f64| (self.middle + self.scale[0] * x).clamp(left, right);
        if most > 0.0 {
            let inside = curve.iter().filter(|(_, p)| p.is_finite());
            let outline = inside.map(|(x, p)| (place(*x), self.top - HIGHEST * p / most));
            let mut outline: Vec<(f64, f64)> = outline.collect();
            if let (Some((first, _)), Some((last, _))) = (outline.first().copied(), outline.last().copied()) {
                outline.insert(0, (first, self.top));
                outline.push((last, self.top));
            }
            picture.area(&outline, FAINT, 0.8);
            picture.line(&outline, Stroke { colour: INK, width: 1.0, dash: None });
        }
        for (at, _, _) in load.parts().into_iter().filter(|(_, _, part)| part.half_width() == 0.0) {
            for x in [at, -at] {
                arrow(picture, place(x), self.top - 3.0, HIGHEST - 3.0);
            }
        }
        self.number(picture);
        picture.text((right + 9.0, self.top - 0.5 * HIGHEST), &self.scene.punch.label(), SMALL, INK, Anchor::Left);
    }

    fn force(&self, picture: &mut Picture) {
        arrow(picture, self.middle, self.top - HIGHEST - 4.0, 18.0);
        self.number(picture);
    }

    fn number(&self, picture: &mut Picture) {
        let line_load = unit(self.scene, Dimension::LineLoad).map_or(String::new(), |unit| format!(" {unit}"));
        let tip = self.top - HIGHEST - 4.0;
        let number = match (self.scene.force, self.contact) {
            (Force::ForHalfLength(_) | Force::ForDepth(_), Some(contact)) => label(contact.resultant),
            (force, _) => label(force.number()),
        };
        let force = format!("{} = {number}{line_load}", italic("P"));
        picture.text((self.middle + 9.0, tip - 11.0), &force, TEXT, INK, Anchor::Left);
    }
}

/// An arrow that points down to a tip.
fn arrow(picture: &mut Picture, x: f64, tip: f64, length: f64) {
    picture.line(&[(x, tip - length), (x, tip)], Stroke { colour: INK, width: 1.2, dash: None });
    picture.area(&[(x, tip + 3.0), (x - 3.2, tip - 5.0), (x + 3.2, tip - 5.0)], INK, 1.0);
}
