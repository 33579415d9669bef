//! The punch above a stack, and the force on it; or the loads in its place.
use super::chart::APART;
use super::names::{after, of_top};
use super::picture::{Anchor, Picture, Stroke, italic};
use super::pressure::{highest, lines, pressure};
use super::scale::{label, short};
use super::style::{INK, PUNCH, SMALL, TEXT};
use crate::scene::{Loads, Punch, Scene, Top};
use crate::solution::Contact;

/// Greatest height of the punch, in points.
const HIGHEST: f64 = 34.0;
/// A profile that rises less than this within what is drawn, in points, is drawn higher.
const SEEN: f64 = 10.0;
/// Points of its outline on each side.
const POINTS: usize = 100;
/// Halvings of the place where the outline leaves the drawing.
const HALVINGS: usize = 50;
/// Distance of the arrows of a load, in points.
const ARROWS: f64 = 13.0;

/// What presses, in a drawing.
pub(super) struct Presses<'a> {
    pub(super) scene: &'a Scene,
    pub(super) force: f64,
    /// What is under it: it is pressed in as far as it touches.
    pub(super) contact: Option<&'a Contact>,
    /// Points per length.
    pub(super) scale: f64,
    /// Where x = 0 is.
    pub(super) middle: f64,
    /// Height of the top face of the stack.
    pub(super) top: f64,
    /// What is seen of it.
    pub(super) ends: (f64, f64),
}

impl Presses<'_> {
    pub(super) fn draw(&self, picture: &mut Picture) {
        let mut names = of_top(self.scene);
        match &self.scene.top {
            Top::Loads(loads) => self.loads(loads, picture),
            Top::Punch(punch) => {
                names.extend(self.body(punch, picture).map(|times| format!("heights drawn × {}", label(times))));
            }
        }
        // the last line just above the top face
        let lowest = self.top - APART - 2.0;
        for (i, name) in names.iter().rev().enumerate() {
            picture.text((self.ends.1 + 9.0, lowest - APART * i as f64), name, SMALL, INK, Anchor::Left);
        }
    }

    /// What is drawn of the punch: to where it ends, or leaves the drawing at the sides or above. Returns how much higher than to
    /// scale, if it is.
    fn body(&self, punch: &Punch, picture: &mut Picture) -> Option<f64> {
        let scale = self.scale;
        let [left, right] = [self.ends.0, self.ends.1].map(|end| (end - self.middle) / scale);
        let ends = punch.ends();
        let [first, last] = [ends[0].max(left.min(-right)), ends[1].min(right.max(-left))];
        // at its very edge the height may be infinite
        let profile = |x: f64| punch.profile(x.clamp(first * (1.0 - 1e-12), last * (1.0 - 1e-12)));
        let rise = |x: f64| (profile(x) - profile(self.contact.map_or(0.0, Contact::reach))).max(0.0);
        let times = times(scale * rise(first).max(rise(last)));
        let height = |x: f64| scale * times * rise(x);
        let seen = [-end_below(&|x: f64| height(-x), -first), end_below(&height, last)];
        let (from, to) = (left.max(seen[0]), right.min(seen[1]));
        if from >= to {
            return None;
        }
        let roof = self.top - HIGHEST;
        let x = |i: usize| from + (to - from) * i as f64 / (2 * POINTS) as f64;
        let place = |x: f64| (self.middle + scale * x, self.top - height(x).min(HIGHEST));
        let mut outline: Vec<(f64, f64)> = (0..=2 * POINTS).map(x).map(place).collect();
        let corners = [to, from].map(|x| (self.middle + scale * x, roof));
        picture.area(&outline.iter().copied().chain(corners).collect::<Vec<_>>(), PUNCH);
        // its own sides are drawn, not the sides of the drawing
        if seen[1] == ends[1] && to == ends[1] {
            outline.push(corners[0]);
        }
        if seen[0] == ends[0] && from == ends[0] {
            outline.insert(0, corners[1]);
        }
        picture.line(&outline, Stroke { colour: INK, width: 1.0, dash: None });
        if (self.ends.0..=self.ends.1).contains(&self.middle) {
            arrow(picture, self.middle, roof - 4.0, 18.0);
            self.force(picture, "");
        }
        (times > 1.0).then_some(times)
    }

    /// Pressures as curves with arrows, lines as arrows.
    fn loads(&self, loads: &Loads, picture: &mut Picture) {
        let curves = self.contact.map_or(Vec::new(), |contact| pressure(self.scene, contact));
        let most = highest(&curves);
        let (left, right) = self.ends;
        let place = |x: f64| self.middle + self.scale * x;
        for curve in &curves {
            let at = |(x, p): &(f64, f64)| (place(*x).clamp(left, right), self.top - HIGHEST * p.min(most) / most);
            let outline: Vec<(f64, f64)> = curve.iter().map(at).collect();
            picture.area(&outline, PUNCH);
            picture.line(&outline, Stroke { colour: INK, width: 1.0, dash: None });
            let (Some((from, _)), Some((to, _))) = (outline.first(), outline.last()) else { continue };
            // one in the middle of a narrow load, none where it is out of sight
            let count = (((to - from) / ARROWS) as usize).max(usize::from(to > from));
            for x in (1..=count).map(|i| from + (to - from) * (i as f64 - 0.5) / count as f64) {
                let next = outline.partition_point(|(at, _)| *at < x).min(outline.len() - 1);
                let length = self.top - 3.0 - outline[next].1;
                if length > 10.0 {
                    arrow(picture, x, self.top - 3.0, length);
                }
            }
        }
        for x in lines(self.scene).into_iter().map(place).filter(|x| (left..=right).contains(x)) {
            arrow(picture, x, self.top - 3.0, HIGHEST + 8.0);
        }
        self.force(picture, if loads.parts().count() > 1 { " in all" } else { "" });
    }

    fn force(&self, picture: &mut Picture, all: &str) {
        let unit = after(self.scene, self.scene.force_dimension());
        let given = self.scene.force.given();
        let number = short(given.unwrap_or(self.force));
        let text = format!("{} = {number}{unit}{all}", italic("P"));
        let y = self.top - HIGHEST - 4.0 - 11.0;
        picture.text((self.middle + 9.0, y), &text, TEXT, INK, Anchor::Left);
    }
}

/// How much higher than to scale a profile is drawn that rises by so many points: 1, or a round number.
fn times(rise: f64) -> f64 {
    if !(rise > 0.0 && rise < SEEN) {
        return 1.0;
    }
    let wanted = 2.0 * SEEN / rise;
    let power = 10f64.powf(wanted.log10().floor());
    let round = [5.0, 2.0, 1.0].into_iter().map(|multiple| multiple * power).find(|times| *times <= wanted);
    // what rises by less is as good as flat
    round.filter(|times| *times <= 1e6).unwrap_or(1.0)
}

/// Where a height first exceeds the height of the drawing, or `end`.
fn end_below(height: &impl Fn(f64) -> f64, end: f64) -> f64 {
    let step = |i: usize| end * i as f64 / POINTS as f64;
    let Some(beyond) = (1..=POINTS).find(|i| height(step(*i)) > HIGHEST) else { return end };
    let [mut inside, mut outside] = [step(beyond - 1), step(beyond)];
    for _ in 0..HALVINGS {
        let middle = 0.5 * (inside + outside);
        *(if height(middle) > HIGHEST { &mut outside } else { &mut inside }) = middle;
    }
    inside
}

/// An arrow that points down to a tip.
fn arrow(picture: &mut Picture, x: f64, tip: f64, length: f64) {
    picture.line(&[(x, tip - length), (x, tip)], Stroke { colour: INK, width: 1.0, dash: None });
    picture.area(&[(x, tip + 3.0), (x - 2.8, tip - 4.5), (x + 2.8, tip - 4.5)], INK);
}
