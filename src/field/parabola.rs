//! The highest place of a parabola through values at three by three points.
use super::measure::{Peak, Seen};
use super::{Field, FieldPoint};

/// By how much the highest place of a parabola may be higher than its middle and count as that.
#[derive(Clone, Copy)]
pub(super) struct Level {
    /// As a part of the value there.
    pub(super) relative: f64,
    /// In stress.
    pub(super) absolute: f64,
}

/// From a peak that was passed over steps are shorter by this factor.
const SHORTER: f64 = 0.25;

/// On either side of a place, and there.
const SIDES: [f64; 3] = [-1.0, 0.0, 1.0];

/// Three by three points of a layer about a place, or three on a face.
pub(super) struct Stencil<'a> {
    field: &'a Field,
    /// The place in the middle; the points above and below are in the layer, too.
    peak: Peak,
    along: f64,
    across: f64,
    deepest: f64,
}

impl<'a> Stencil<'a> {
    /// About a peak, with points at the distance `step` in parts of the scale of the peak.
    pub(super) fn new(field: &'a Field, peak: &Peak, step: f64) -> Self {
        let (along, deepest) = (step * peak.scale, field.deepest(peak.layer));
        let across = if peak.measure.is_on_face() { 0.0 } else { along.min(0.25 * deepest) };
        let depth = peak.depth.clamp(across, deepest - across);
        Self { field, peak: Peak { depth, ..*peak }, along, across, deepest }
    }

    /// The index of its layer.
    pub(super) fn layer(&self) -> usize {
        self.peak.layer
    }

    /// The depths of its rows of points, of which a face has one, and the end of a contact.
    pub(super) fn depths(&self) -> impl Iterator<Item = f64> + use<> {
        let Self { peak: Peak { depth, .. }, across, .. } = *self;
        let sides: &'static [f64] = if across > 0.0 { &SIDES } else { &SIDES[1..2] };
        sides.iter().map(move |side| depth + side * across)
    }

    /// The places of the points of a row.
    pub(super) fn places(&self) -> Vec<f64> {
        let sides: &[f64] = if self.along > 0.0 { &SIDES } else { &SIDES[1..2] };
        sides.iter().map(|side| self.field.place(self.peak.x + side * self.along)).collect()
    }

    /// The highest place of the parabola through the values at the points, row by row, and whether it is inside or on a face, or hardly
    /// higher than the middle. Where all points are lower than one seen before, that one, from which steps are shorter.
    pub(super) fn highest(&self, rows: &[Vec<FieldPoint>], level: Level) -> (Peak, bool) {
        let measure = self.peak.measure;
        let all = rows.iter().flatten().map(|point| (measure.of(point), point));
        let Some((value, point)) = all.max_by(|a, b| a.0.total_cmp(&b.0)) else { return (self.peak, true) };
        let top = self.peak.depth - self.middle_depth(rows);
        let best = Seen { x: point.x, depth: point.depth + top, value };
        if best.value < self.peak.seen.value - level.absolute {
            let Seen { x, depth, value } = self.peak.seen;
            return (Peak { x, depth, value, scale: SHORTER * self.peak.scale, ..self.peak }, false);
        }
        let seen = if best.value > self.peak.seen.value { best } else { self.peak.seen };
        if rows.len() == 1 && rows[0].len() == 1 {
            return (Peak { value, seen, ..self.peak }, true);
        }
        let value = |i: usize, k: usize| {
            // of a face there is one row
            let row = if rows.len() == 1 { &rows[0] } else { &rows[i] };
            let value = measure.of(&row[k]);
            if measure.is_norm() { value * value } else { value }
        };
        let parabola = Parabola {
            value: value(1, 1),
            slope: [0.5 * (value(1, 2) - value(1, 0)), 0.5 * (value(2, 1) - value(0, 1))],
            curve: [value(1, 2) - 2.0 * value(1, 1) + value(1, 0), value(2, 1) - 2.0 * value(1, 1) + value(0, 1)],
            twist: 0.25 * (value(2, 2) - value(2, 0) - value(0, 2) + value(0, 0)),
        };
        let ([right, down], top) = parabola.highest();
        let depth = self.peak.depth + down * self.across;
        let x = self.field.place(self.peak.x + right * self.along);
        let on_face = depth <= 0.0 || depth >= self.deepest;
        let inside = right.abs() < 1.0 && (down.abs() < 1.0 || on_face);
        let root = |value: f64| if measure.is_norm() { value.max(0.0).sqrt() } else { value };
        let (value, middle) = (root(top), root(parabola.value));
        let is_level = value - middle <= level.relative * middle.abs() + level.absolute;
        (Peak { x, depth, value, seen, ..self.peak }, inside || is_level)
    }

    /// The depth of the middle row below the top face of the stack.
    fn middle_depth(&self, rows: &[Vec<FieldPoint>]) -> f64 {
        rows.get(rows.len() / 2).and_then(|row| row.first()).map_or(0.0, |point| point.depth)
    }
}

/// value + slope·s + ½ curve·s² + twist·s₀s₁ for −1 ≤ s₀, s₁ ≤ 1.
struct Parabola {
    value: f64,
    slope: [f64; 2],
    curve: [f64; 2],
    twist: f64,
}

impl Parabola {
    fn at(&self, [s, t]: [f64; 2]) -> f64 {
        let straight = self.value + self.slope[0] * s + self.slope[1] * t;
        straight + 0.5 * (self.curve[0] * s * s + self.curve[1] * t * t) + self.twist * s * t
    }

    /// Where it is highest, and how high: where it is level, or on an edge.
    fn highest(&self) -> ([f64; 2], f64) {
        let determinant = self.curve[0] * self.curve[1] - self.twist * self.twist;
        let level = [
            (self.twist * self.slope[1] - self.curve[1] * self.slope[0]) / determinant,
            (self.twist * self.slope[0] - self.curve[0] * self.slope[1]) / determinant,
        ];
        let mut places = vec![level];
        for end in [-1.0, 1.0] {
            for axis in [0, 1] {
                let other = 1 - axis;
                let along = -(self.slope[other] + self.twist * end) / self.curve[other];
                for s in [-1.0, along, 1.0] {
                    places.push(if axis == 0 { [end, s] } else { [s, end] });
                }
            }
        }
        places.retain(|place| place.iter().all(|s| (-1.0..=1.0).contains(s)));
        let heights = places.into_iter().map(|place| (place, self.at(place)));
        heights.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or(([0.0; 2], self.value))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_is_highest_where_it_is_level_or_on_an_edge() {
        let level = Parabola { value: 1.0, slope: [0.2, -0.4], curve: [-1.0, -1.0], twist: 0.0 };
        let (place, height) = level.highest();
        assert!((place[0] - 0.2).abs() < 1e-15 && (place[1] + 0.4).abs() < 1e-15 && (height - 1.1).abs() < 1e-15);
        let rising = Parabola { value: 0.0, slope: [0.5, 3.0], curve: [-1.0, 0.1], twist: 0.1 };
        let (place, height) = rising.highest();
        assert!((place[0] - 0.6).abs() < 1e-15 && place[1] == 1.0 && (height - 3.23).abs() < 1e-14);
        let plane = Parabola { value: 2.0, slope: [0.0; 2], curve: [0.0; 2], twist: 0.0 };
        assert_eq!(plane.highest().1, 2.0);
    }
}
