//! The punches above a stack, and the forces on them; or the loads in their place.
use super::chart::APART;
use super::depths::last_below;
use super::names::{after, of_top};
use super::picture::{Anchor, Picture, Stroke, italic};
use super::pressure::{highest, lines, pressure};
use super::scale::{label, short};
use super::section::{ASIDE, Section, WIDTH, height_at};
use super::style::{INK, PUNCH, SMALL, TEXT};
use crate::scene::{Pressed, Punches, Tilt, Top};

/// Greatest height of the punch, in points.
const HIGHEST: f64 = 34.0;
/// A profile that rises less than this within what is drawn, in points, is drawn higher.
const SEEN: f64 = 10.0;
/// Points of its outline on each side.
const POINTS: usize = 100;
/// Room between two punches, in points.
const BETWEEN: f64 = 4.0;
/// Distance of the arrows of a load, in points.
const ARROWS: f64 = 13.0;

impl Section<'_> {
    /// Punches or loads with their forces.
    pub(super) fn presses(&self, picture: &mut Picture) {
        if self.force == 0.0 {
            return;
        }
        let mut names = of_top(self.scene);
        let unit = after(self.scene, self.scene.force_dimension());
        let force = format!("{} = {}{unit}", italic("P"), short(self.scene.force.given().unwrap_or(self.force)));
        let (places, times): (Vec<f64>, _) = match &self.scene.top {
            Top::Loads(loads) => {
                self.loads(picture);
                (loads.parts().map(|(_, at, _)| at).collect(), None)
            }
            Top::Punches(punches) => {
                let aside = |pressed: &Pressed| pressed.at() + aside(pressed);
                let times = match &self.punches {
                    Some(lower) => self.displaced(punches, lower, picture),
                    None => self.bodies(punches, picture),
                };
                (punches.parts().map(|(pressed, _)| aside(pressed)).collect(), times)
            }
        };
        // beside its arrow, or with the names, where no arrow is, if it has several
        match places[..] {
            [at] if self.sees(self.x(at)) => {
                let place = (self.x(at) + ASIDE, self.ceiling() - 15.0);
                picture.text(place, &force, TEXT, INK, Anchor::Left);
            }
            [_] => {}
            _ => names.push(force + " in all"),
        }
        names.extend(times.map(|times| format!("heights drawn × {}", label(times))));
        // the last line just above the top face
        let lowest = -APART - 2.0;
        for (i, name) in names.iter().rev().enumerate() {
            picture.text((WIDTH + ASIDE, lowest - APART * i as f64), name, SMALL, INK, Anchor::Left);
        }
    }

    /// Up to which height punches are drawn.
    fn ceiling(&self) -> f64 {
        self.top.iter().map(|(_, y)| *y).fold(0.0, f64::min) - HIGHEST
    }

    /// All punches above their lower sides, with their forces.
    fn displaced(&self, punches: &Punches, lower: &[(f64, f64)], picture: &mut Picture) -> Option<f64> {
        let ceiling = self.ceiling();
        // flanks end where they cross the ceiling
        let crossing = |pair: &[(f64, f64)]| {
            let share = (ceiling - pair[0].1) / (pair[1].1 - pair[0].1);
            let is_crossed = (pair[0].1 > ceiling) != (pair[1].1 > ceiling) && share.abs() > 0.0 && share.is_finite();
            is_crossed.then(|| (pair[0].0 + share * (pair[1].0 - pair[0].0), ceiling))
        };
        let crossings = lower.windows(2).map(crossing).chain([None]);
        let points = lower.iter().zip(crossings).flat_map(|(point, crossing)| [*point].into_iter().chain(crossing));
        let points: Vec<(f64, f64)> = points.collect();
        for side in points.split(|(_, y)| *y < ceiling).filter(|side| side.len() > 1) {
            let corner = |end: usize| (side[end].0, ceiling);
            let ends = [corner(0), corner(side.len() - 1)];
            let body = ends[..1].iter().chain(side).chain(&ends[1..]).copied();
            picture.area(&body.clone().collect::<Vec<_>>(), PUNCH);
            // its own sides are drawn, not the sides of the drawing
            let own = body.filter(|(x, y)| *y > ceiling || (*x > 0.0 && *x < WIDTH));
            picture.line(&own.collect::<Vec<_>>(), Stroke { colour: INK, width: 1.0, dash: None });
        }
        let forces = punches.parts().map(|(pressed, _)| self.x(pressed.at() + aside(pressed)));
        forces.filter(|x| self.sees(*x)).for_each(|x| arrow(picture, x, ceiling - 4.0, 18.0));
        None
    }

    /// All punches, each as far as half the way to its neighbours. Returns how much higher than to scale the highest is, if it is.
    fn bodies(&self, punches: &Punches, picture: &mut Picture) -> Option<f64> {
        let all: Vec<&Pressed> = punches.parts().map(|(pressed, _)| pressed).collect();
        let between = |one: &Pressed, other: &Pressed| self.x(0.5 * (one.face()[1] + other.face()[0]));
        let mut highest: Option<f64> = None;
        for (i, pressed) in all.iter().enumerate() {
            let before = i.checked_sub(1).and_then(|i| all.get(i));
            let from = before.map_or(0.0, |before| between(before, pressed) + 0.5 * BETWEEN);
            let to = all.get(i + 1).map_or(WIDTH, |after| between(pressed, after) - 0.5 * BETWEEN);
            let times = self.body(pressed, [from.max(0.0), to.min(WIDTH)], picture);
            highest = times.into_iter().chain(highest).reduce(f64::max);
        }
        highest
    }

    /// A punch between two places, as far as it reaches or the drawing is high, turned if its angle is prescribed. Returns the factor by which its
    /// heights are drawn larger than to scale, if it is not 1.
    fn body(&self, pressed: &Pressed, window: [f64; 2], picture: &mut Picture) -> Option<f64> {
        let (scale, middle, punch) = (self.scale, self.x(pressed.at()), pressed.shape());
        let [left, right] = window.map(|end| (end - middle) / scale);
        let angle = pressed.tilt().angle().unwrap_or(0.0);
        let ends = punch.shape().ends();
        let [first, last] = [ends[0].max(left.min(-right)), ends[1].min(right.max(-left))];
        // at its very edge the height may be infinite
        let profile = |x: f64| punch.profile(x.clamp(first * (1.0 - 1e-12), last * (1.0 - 1e-12))) + angle * x;
        let step = |from: f64, to: f64, i: usize| from + (to - from) * i as f64 / (2 * POINTS) as f64;
        let alone =
            self.contacts.first().filter(|_| self.scene.top.punches().is_some_and(|all| all.parts().count() == 1));
        let lowest = match alone {
            // no flank touches the face beyond the ends of the contact
            Some(contact) => contact.ends().map(|end| profile(end - pressed.at())).into_iter().fold(f64::MIN, f64::max),
            None => (0..=2 * POINTS).map(|i| profile(step(first, last, i))).fold(profile(0.0), f64::min),
        };
        let rise = |x: f64| (profile(x) - lowest).max(0.0);
        let times = times(scale * rise(first).max(rise(last)));
        let height = |x: f64| scale * times * rise(x);
        let seen = [-end_below(&|x: f64| height(-x), -first), end_below(&height, last)];
        let (from, to) = (left.max(seen[0]), right.min(seen[1]));
        if from >= to {
            return None;
        }
        let place = |x: f64| (middle + scale * x, -height(x).min(HIGHEST));
        let mut outline: Vec<(f64, f64)> = (0..=2 * POINTS).map(|i| place(step(from, to, i))).collect();
        let corners = [to, from].map(|x| (middle + scale * x, -HIGHEST));
        picture.area(&outline.iter().copied().chain(corners).collect::<Vec<_>>(), PUNCH);
        // its own sides are drawn, not the sides of the drawing
        if to == ends[1] {
            outline.push(corners[0]);
        }
        if from == ends[0] {
            outline.insert(0, corners[1]);
        }
        picture.line(&outline, Stroke { colour: INK, width: 1.0, dash: None });
        let force = middle + scale * aside(pressed);
        if self.sees(force) {
            arrow(picture, force, -HIGHEST - 4.0, 18.0);
        }
        (times > 1.0).then_some(times)
    }

    /// Pressures as curves with arrows, lines as arrows.
    fn loads(&self, picture: &mut Picture) {
        let curves = self.contacts.first().map_or(Vec::new(), |contact| pressure(self.scene, contact));
        let most = highest(&curves);
        for curve in &curves {
            let at = |(x, p): &(f64, f64)| {
                let x = self.x(*x).clamp(0.0, WIDTH);
                (x, height_at(&self.top, x) - HIGHEST * p.min(most) / most)
            };
            let outline: Vec<(f64, f64)> = curve.iter().map(at).collect();
            picture.area(&outline, PUNCH);
            picture.line(&outline, Stroke { colour: INK, width: 1.0, dash: None });
            let (Some((from, _)), Some((to, _))) = (outline.first(), outline.last()) else { continue };
            // one in the middle of a narrow load, none where it is out of sight
            let count = (((to - from) / ARROWS) as usize).max(usize::from(to > from));
            for x in (1..=count).map(|i| from + (to - from) * (i as f64 - 0.5) / count as f64) {
                let next = outline.partition_point(|(at, _)| *at < x).min(outline.len() - 1);
                let tip = height_at(&self.top, x) - 3.0;
                if tip - outline[next].1 > 10.0 {
                    arrow(picture, x, tip, tip - outline[next].1);
                }
            }
        }
        for x in lines(self.scene).into_iter().map(|x| self.x(x)).filter(|x| self.sees(*x)) {
            arrow(picture, x, height_at(&self.top, x) - 3.0, HIGHEST + 8.0);
        }
    }
}

/// How far from the place of a punch its force acts.
fn aside(pressed: &Pressed) -> f64 {
    if let Tilt::Free { eccentricity } = pressed.tilt() { eccentricity } else { 0.0 }
}

/// How much higher than to scale a profile is drawn that rises by so many points: 1, or a round number.
fn times(rise: f64) -> f64 {
    if !(rise > 0.0 && rise < SEEN) {
        return 1.0;
    }
    // what rises by less is as good as flat
    Some(rounded_down(2.0 * SEEN / rise)).filter(|times| *times <= 1e6).unwrap_or(1.0)
}

/// The largest of the numbers 1, 2, 5, 10, 20, 50 and so on, and of their inverses, that is no larger than a number.
pub(super) fn rounded_down(number: f64) -> f64 {
    let power = 10f64.powf(number.log10().floor());
    [5.0, 2.0, 1.0].into_iter().map(|multiple| multiple * power).find(|round| *round <= number).unwrap_or(power)
}

/// Where a height first exceeds the height of the drawing, or `end`.
fn end_below(height: &impl Fn(f64) -> f64, end: f64) -> f64 {
    let step = |i: usize| end * i as f64 / POINTS as f64;
    let Some(beyond) = (1..=POINTS).find(|i| height(step(*i)) > HIGHEST) else { return end };
    last_below(HIGHEST, height, [step(beyond - 1), step(beyond)])
}

/// An arrow that points down to a tip.
fn arrow(picture: &mut Picture, x: f64, tip: f64, length: f64) {
    picture.line(&[(x, tip - length), (x, tip)], Stroke { colour: INK, width: 1.0, dash: None });
    picture.area(&[(x, tip + 3.0), (x - 2.8, tip - 4.5), (x + 2.8, tip - 4.5)], INK);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::picture::{Colour, DrawnShape};
    use crate::plot::section::level;
    use crate::scene::Scene;

    /// The outlines of the bodies that are drawn above a face at height 0, x = 0 at 170 and 20 points per length, and the tips of their arrows.
    fn drawn(punches: &str) -> (Vec<Vec<(f64, f64)>>, Vec<f64>) {
        let scene = format!("Scene(geometry: PlaneStrain, punches: [{punches}], stack: [Rigid])");
        let scene = Scene::from_ron(&scene).unwrap();
        let mut picture = Picture::new(340.0, 100.0);
        let (contacts, symbols, top) = (Default::default(), Vec::new(), level(0.0));
        Section { scene: &scene, force: 1.0, contacts, symbols, scale: 20.0, middle: 170.0, top, punches: None }
            .presses(&mut picture);
        assert!(picture.is_finite());
        let areas = |wanted: Colour| {
            let area = move |shape: &DrawnShape| match shape {
                DrawnShape::Area { rings, colour } if *colour == wanted => Some(rings.concat()),
                _ => None,
            };
            picture.shapes.iter().filter_map(area).collect::<Vec<_>>()
        };
        (areas(PUNCH), areas(INK).iter().map(|arrow| arrow[0].0).collect())
    }

    fn extent(points: &[(f64, f64)]) -> [f64; 2] {
        let places = || points.iter().map(|(x, _)| *x);
        [places().fold(f64::INFINITY, f64::min), places().fold(f64::NEG_INFINITY, f64::max)]
    }

    #[test]
    fn each_punch_is_drawn_at_its_place() {
        let block = "(shape: Flat(half_width: 0.5), at: 3, force: 2, tilt: Free(eccentricity: 0.25))";
        let (bodies, arrows) = drawn(&format!("{block}, (shape: Parabola(radius: 2), at: -4, force: 1)"));
        let [parabola, flat] = &bodies[..] else { panic!("two bodies") };
        // the parabola rises by 34 points at a distance of √6.8, the neighbour begins later
        let [left, right] = extent(parabola);
        assert!((left - (90.0 - 20.0 * 6.8f64.sqrt())).abs() < 1e-6 && (left + right - 180.0).abs() < 1e-6);
        assert_eq!((extent(flat), &arrows[..]), ([220.0, 240.0], &[90.0, 235.0][..]));
        // wide ones share the room between them
        let (bodies, _) = drawn(&format!("(shape: Cylinder(radius: 1000), at: 0, force: 1), {block}"));
        assert_eq!([extent(&bodies[0]), extent(&bodies[1])], [[0.0, 193.0], [220.0, 240.0]]);
        // those out of sight are left out
        let (bodies, arrows) = drawn(&format!("(shape: Parabola(radius: 2), at: -90, force: 1), {block}"));
        assert_eq!((bodies.len(), &arrows[..]), (1, &[235.0][..]));
    }

    #[test]
    fn a_punch_that_is_turned_is_drawn_on_its_lower_corner() {
        for (angle, low) in [(0.75, 220.0), (-0.75, 240.0)] {
            let (bodies, _) = drawn(&format!("(shape: Flat(half_width: 0.5), at: 3, force: 2, tilt: Fixed({angle}))"));
            let at = |corner: f64| bodies[0].iter().filter(|(x, _)| *x == corner).map(|(_, y)| *y).fold(-1e9, f64::max);
            let high = 460.0 - low;
            assert!(at(low).abs() < 1e-6 && (at(high) + 15.0).abs() < 1e-6, "{} {}", at(low), at(high));
        }
    }
}
