//! Curves in a frame with axes.
use super::picture::{Anchor, Picture, Stroke};
use super::scale::{Scale, ten_to};
use super::style::{FAINT, INK, SMALL, TEXT, hair};

/// Length of the mark of a tick, in points.
const TICK: f64 = 4.0;
/// Distance of two labels beside curves, in points.
const APART: f64 = 12.0;

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
    /// Its points; the curve is interrupted where one is not finite.
    pub points: Vec<(f64, f64)>,
    /// How it is drawn.
    pub stroke: Stroke,
    /// What it is called; empty for nothing.
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
    /// What is written below the bottom; a power of ten and `x_unit` are added.
    pub x_label: String,
    /// Unit along the bottom, or nothing.
    pub x_unit: Option<String>,
    /// What is written along the left side.
    pub y_label: String,
    /// Unit along the left side, or nothing.
    pub y_unit: Option<String>,
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
        self.axes(picture);
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

    fn axes(&self, picture: &mut Picture) {
        let Frame { left, top, right, bottom } = self.frame;
        for tick in self.x.ticks() {
            let (x, _) = self.place((tick.value, self.y.ends().0));
            let length = if tick.label.is_empty() { 0.6 * TICK } else { TICK };
            picture.line(&[(x, bottom), (x, bottom + length)], hair(INK));
            picture.text((x, bottom + TICK + 0.8 * SMALL), &tick.label, SMALL, INK, Anchor::Centre);
        }
        for tick in self.y.ticks() {
            let (_, y) = self.place((self.x.ends().0, tick.value));
            picture.line(&[(left - TICK, y), (left, y)], hair(INK));
            picture.text((left - TICK - 3.0, y), &tick.label, SMALL, INK, Anchor::Right);
        }
        let (low, high) = self.y.ends();
        if low < 0.0 && high > 0.0 {
            let (_, y) = self.place((self.x.ends().0, 0.0));
            picture.line(&[(left, y), (right, y)], hair(FAINT));
        }
        picture.line(&[(left, top), (left, bottom), (right, bottom)], hair(INK));
        let widest = self.y.ticks().iter().map(|tick| tick.label.chars().count()).max().unwrap_or(0);
        let beside = left - TICK - 9.0 - 0.62 * SMALL * widest as f64 - 0.5 * TEXT;
        let below = bottom + TICK + 2.4 * TEXT;
        let x_label = with_unit(&self.x_label, self.x_unit.as_deref(), self.x.power());
        let y_label = with_unit(&self.y_label, self.y_unit.as_deref(), self.y.power());
        picture.text((0.5 * (left + right), below), &x_label, TEXT, INK, Anchor::Centre);
        picture.text((beside, 0.5 * (top + bottom)), &y_label, TEXT, INK, Anchor::Upwards);
    }

    fn list_of_labels(&self, picture: &mut Picture) {
        let (left, mut y) = (self.frame.right + 8.0, self.frame.top + 0.5 * TEXT);
        for curve in self.curves.iter().filter(|curve| !curve.label.is_empty()) {
            picture.line(&[(left, y), (left + SAMPLE, y)], curve.stroke);
            picture.text((left + SAMPLE + 5.0, y), &curve.label, TEXT, INK, Anchor::Left);
            y += 1.5 * TEXT;
        }
    }

    /// What the curves are called, beside their right ends, apart from each other.
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

/// A label with a power of ten and a unit behind it, e.g. `pressure, 10⁻³ N/mm²`.
pub fn with_unit(label: &str, unit: Option<&str>, power: i32) -> String {
    let factor = (power != 0).then(|| ten_to(power));
    let parts: Vec<&str> = factor.as_deref().into_iter().chain(unit).collect();
    if parts.is_empty() { label.to_owned() } else { format!("{label}, {}", parts.join(" ")) }
}

/// Heights near those wanted, which ascend, so far from each other that labels do not overlap.
pub(super) fn apart(wanted: &[f64], top: f64, bottom: f64) -> Vec<f64> {
    let mut heights = wanted.to_vec();
    // push apart a little, again and again
    for _ in 0..200 {
        for i in 1..heights.len() {
            let missing = APART - (heights[i] - heights[i - 1]);
            if missing > 0.0 {
                heights[i - 1] -= 0.5 * missing;
                heights[i] += 0.5 * missing;
            }
        }
        let first = heights.first().map_or(0.0, |first| (top - first).max(0.0));
        let last = heights.last().map_or(0.0, |last| (last - bottom).max(0.0));
        heights.iter_mut().for_each(|height| *height += if first > 0.0 { first } else { -last });
    }
    heights
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
    }

    #[test]
    fn units_follow_labels() {
        assert_eq!(with_unit("p", Some("N/mm²"), -3), "p, 10⁻³ N/mm²");
        assert_eq!(with_unit("p", None, 0), "p");
    }
}
