//! Curves in a frame with axes.
use super::letters::width;
use super::picture::{Anchor, Picture, Stroke};
use super::scale::{Scale, Tick};
use super::style::{FAINT, INK, SMALL, TEXT, hair};

/// Length of the mark of a tick, in points.
const TICK: f64 = 4.0;
/// Distance of two labels below each other, in points.
pub(super) const APART: f64 = 11.5;
/// Distance of two numbers beside each other, in points.
const BESIDE: f64 = 4.0;

/// Length of a piece of line in a list, in points.
const SAMPLE: f64 = 24.0;

/// A rectangle of the picture in points, y downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Left side.
    pub left: f64,
    /// Upper side.
    pub top: f64,
    /// Right side.
    pub right: f64,
    /// Lower side.
    pub bottom: f64,
}

/// One curve.
#[derive(Clone, Debug)]
pub struct Curve {
    /// The points; the curve is interrupted where one is not finite.
    pub points: Vec<(f64, f64)>,
    /// The line of the curve.
    pub stroke: Stroke,
    /// The name of the curve; empty for none. In a list it may have several lines.
    pub label: String,
}

/// Where curves are labelled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Labels {
    /// Beside their right ends.
    #[default]
    AtEnds,
    /// In a list at the upper right, with a piece of each line: for curves that all end in one place.
    Listed,
}

/// Curves, and axes on the left and below.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The plane of the curves without axes and labels.
    pub frame: Frame,
    /// Along the bottom.
    pub x: Scale,
    /// Along the left side.
    pub y: Scale,
    /// The curves.
    pub curves: Vec<Curve>,
    /// Where their labels stand, right of the frame.
    pub labels: Labels,
}

impl Chart {
    /// Where a point of the curves lies in the picture.
    pub fn place(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let Frame { left, top, right, bottom } = self.frame;
        (left + self.x.share(x) * (right - left), bottom - self.y.share(y) * (bottom - top))
    }

    /// Draws all of it.
    pub fn draw(&self, picture: &mut Picture) {
        self.draw_with(picture, 0.0);
    }

    /// Draws all of it, the axis below so much lower than the frame.
    pub(super) fn draw_with(&self, picture: &mut Picture, lower: f64) {
        self.axes(picture, lower);
        for curve in &self.curves {
            for part in curve.points.split(|(x, y)| !x.is_finite() || !y.is_finite()) {
                let points: Vec<(f64, f64)> = part.iter().map(|point| self.place(*point)).collect();
                if let [(x, y)] = points[..] {
                    picture.line(&[(x - 1.0, y), (x + 1.0, y)], Stroke { dash: None, ..curve.stroke });
                } else if !points.is_empty() {
                    picture.line(&points, curve.stroke);
                }
            }
        }
        match self.labels {
            Labels::AtEnds => self.labels_at_ends(picture),
            Labels::Listed => self.list_of_labels(picture),
        }
    }

    fn axes(&self, picture: &mut Picture, lower: f64) {
        let Frame { left, top, right, bottom } = self.frame;
        let floor = bottom + lower;
        let at = |tick: &Tick| self.place((tick.value, self.y.ends().0)).0;
        let half = |tick: &Tick| 0.5 * width(&tick.label, SMALL);
        let labelled = labelled(&self.x, |one, next| at(next) - at(one) > half(one) + half(next) + BESIDE);
        for tick in self.x.ticks() {
            let x = at(&tick);
            let shown = labelled.contains(&tick);
            picture.line(&[(x, floor), (x, floor + if shown { TICK } else { 0.6 * TICK })], hair(INK));
            if shown {
                picture.text((x, floor + TICK + 0.8 * SMALL), &tick.label, SMALL, INK, Anchor::Centre);
            }
        }
        let (low, high) = self.y.ends();
        if low < 0.0 && high > 0.0 {
            let (_, y) = self.place((self.x.ends().0, 0.0));
            picture.line(&[(left, y), (right, y)], hair(FAINT));
        }
        picture.line(&[(left, top), (left, floor), (right, floor)], hair(INK));
        let below = floor + TICK + 2.4 * TEXT;
        picture.text((0.5 * (left + right), below), &self.x.title(), TEXT, INK, Anchor::Centre);
        upright_axis(picture, &self.y, [left, top, bottom], Anchor::Right);
    }

    fn list_of_labels(&self, picture: &mut Picture) {
        let (left, mut y) = (self.frame.right + 8.0, self.frame.top + 0.5 * TEXT);
        for curve in self.curves.iter().filter(|curve| !curve.label.is_empty()) {
            picture.line(&[(left, y), (left + SAMPLE, y)], curve.stroke);
            for (i, line) in curve.label.lines().enumerate() {
                y += if i > 0 { 1.2 * TEXT } else { 0.0 };
                picture.text((left + SAMPLE + 5.0, y), line, if i > 0 { SMALL } else { TEXT }, INK, Anchor::Left);
            }
            y += 1.5 * TEXT;
        }
    }

    /// Labels beside the right ends of the curves, apart from each other.
    fn labels_at_ends(&self, picture: &mut Picture) {
        let end = |curve: &Curve| curve.points.iter().rev().find(|(x, y)| x.is_finite() && y.is_finite()).copied();
        let named = self.curves.iter().filter(|curve| !curve.label.is_empty());
        let mut ends: Vec<_> = named.filter_map(|curve| Some((self.place(end(curve)?), curve))).collect();
        ends.sort_by(|((_, a), _), ((_, b), _)| a.total_cmp(b));
        let wanted: Vec<f64> = ends.iter().map(|((_, y), _)| *y).collect();
        let (top, bottom) = (self.frame.top, self.frame.bottom);
        for (y, ((x, from), curve)) in apart(&wanted, top, bottom).into_iter().zip(&ends) {
            let right = self.frame.right.max(*x);
            if (y - from).abs() > 1.0 || right - x > 1.0 {
                picture.line(&[(x + 2.0, *from), (right + 8.0, y)], hair(FAINT));
            }
            picture.text((right + 11.0, y), &curve.label, TEXT, INK, Anchor::Left);
        }
    }
}

/// The marks of an axis that have a number: all, or each second one, and so on, so that they stay apart.
fn labelled(scale: &Scale, are_apart: impl Fn(&Tick, &Tick) -> bool) -> Vec<Tick> {
    let ticks: Vec<Tick> = scale.ticks().into_iter().filter(|tick| !tick.label.is_empty()).collect();
    let zero = ticks.iter().position(|tick| tick.value == 0.0).unwrap_or(0);
    let every = |step: usize| ticks.iter().skip(zero % step).step_by(step);
    let fits = |step: &usize| every(*step).zip(every(*step).skip(1)).all(|(one, next)| are_apart(one, next));
    let step = (1..=ticks.len()).find(fits).unwrap_or(1);
    every(step).cloned().collect()
}

/// The marks, numbers and title of an axis that runs upwards: on its left if they are anchored at their right ends, else on its right.
pub(super) fn upright_axis(picture: &mut Picture, scale: &Scale, [x, top, bottom]: [f64; 3], anchor: Anchor) {
    let out = if anchor == Anchor::Right { -1.0 } else { 1.0 };
    let at = |tick: &Tick| bottom - scale.share(tick.value) * (bottom - top);
    let labelled = labelled(scale, |one, next| (at(next) - at(one)).abs() > SMALL + 1.0);
    for tick in scale.ticks() {
        let y = at(&tick);
        picture.line(&[(x + out * TICK, y), (x, y)], hair(INK));
        if labelled.contains(&tick) {
            picture.text((x + out * (TICK + 3.0), y), &tick.label, SMALL, INK, anchor);
        }
    }
    let widest = labelled.iter().map(|tick| width(&tick.label, SMALL)).fold(0.0, f64::max);
    let beside = x + out * (TICK + 9.0 + widest + 0.5 * TEXT);
    picture.text((beside, 0.5 * (top + bottom)), &scale.title(), TEXT, INK, Anchor::Upwards);
}

/// Heights as near as possible to those wanted, which ascend, so far from each other that labels do not overlap: not above
/// `top`, and not below `bottom` if there is room for all.
pub(super) fn apart(wanted: &[f64], top: f64, bottom: f64) -> Vec<f64> {
    // without the distances between them: groups that would overlap stand at the mean of what is wanted
    let mut groups: Vec<(f64, usize)> = Vec::new();
    for (i, height) in wanted.iter().enumerate() {
        let mut group = (height - i as f64 * APART, 1);
        while let Some((mean, count)) = groups.pop_if(|(mean, _)| *mean >= group.0) {
            let all = count + group.1;
            group = ((mean * count as f64 + group.0 * group.1 as f64) / all as f64, all);
        }
        groups.push(group);
    }
    let lowest = (bottom - APART * wanted.len().saturating_sub(1) as f64).max(top);
    let all = groups.into_iter().flat_map(|(mean, count)| (0..count).map(move |_| mean));
    all.enumerate().map(|(i, height)| height.clamp(top, lowest) + i as f64 * APART).collect()
}

/// Whether a curve is one of too many to be told apart: all but the first and the last, then.
pub(super) fn hidden(index: usize, count: usize, most: usize) -> bool {
    count > most && index > 0 && index + 1 < count
}

/// Labels between two heights, below each other: of more than there is room for the first and the last ones, and between them how
/// many more there are of what `more` calls them. Each with the height of what it names and the height at which it stands.
pub(super) fn beside(mut labels: Vec<(f64, String)>, top: f64, bottom: f64, more: &str) -> Vec<(f64, f64, String)> {
    labels.sort_by(|a, b| a.0.total_cmp(&b.0));
    let room = (((bottom - top) / APART) as usize + 1).max(3);
    if labels.len() > room {
        let kept = room - 1;
        let left_out: Vec<_> = labels.drain(kept.div_ceil(2)..labels.len() - kept / 2).collect();
        let middle = left_out[left_out.len() / 2].0;
        labels.insert(kept.div_ceil(2), (middle, format!("{} more {more}", left_out.len())));
    }
    let wanted: Vec<f64> = labels.iter().map(|(at, _)| *at).collect();
    let heights = apart(&wanted, top, bottom);
    labels.into_iter().zip(heights).map(|((at, text), y)| (at, y, text)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_stay_apart_and_in_order() {
        let heights = apart(&[50.0, 50.5, 51.0, 99.0], 0.0, 100.0);
        assert!(heights.windows(2).all(|pair| pair[1] - pair[0] > APART - 0.1), "{heights:?}");
        assert!(heights[3] <= 100.0 && heights[0] > 30.0, "{heights:?}");
        assert!(apart(&[], 0.0, 1.0).is_empty());
        let full = apart(&[0.0; 9], 0.0, 8.0 * APART);
        assert!(full.windows(2).all(|pair| pair[1] - pair[0] > APART - 1e-9) && full[8] <= 8.0 * APART, "{full:?}");
    }

    #[test]
    fn labels_without_room_are_counted() {
        let labels = (0..60).map(|i| (f64::from(i), format!("layer {i}"))).collect();
        let shown = beside(labels, 0.0, 100.0, "layers");
        assert!(shown.len() < 12 && shown[0].2 == "layer 0" && shown[shown.len() - 1].2 == "layer 59", "{shown:?}");
        assert!(shown.iter().any(|(_, _, text)| text == &format!("{} more layers", 61 - shown.len())), "{shown:?}");
        assert!(shown.iter().all(|(_, y, _)| (0.0..=100.0).contains(y)), "{shown:?}");
    }
}
