//! The curves of a sweep, one column for each contact: as far as it reaches above, its largest pressure below.
use super::chart::{Chart, Curve, Frame, Labels, hidden, with_unit};
use super::file::PlotError;
use super::heat;
use super::names::{of_path, unit};
use super::picture::{Anchor, Picture, Stroke};
use super::planes::{CONTACTS, Plane, number, planes, scale_of, step};
use super::scale::{Scale, distinct};
use super::style::{FAINT, INK, SMALL, TEXT, curve, hair};
use crate::axis::Axis;
use crate::scene::Scene;
use crate::sweep::{Sweep, SweepPoint};

/// Size of one plane of curves, in points.
const PLANE: (f64, f64) = (215.0, 145.0);
/// What is left of, above and below a plane, in points.
const AROUND: (f64, f64, f64) = (70.0, 22.0, 42.0);
/// Most curves that are told apart by labels.
const LABELLED: usize = 10;
/// A curve jumps where it changes by more than the first part of its range, and that many times as much as before and after.
const JUMP: [f64; 2] = [0.1, 6.0];

/// The rows of a sweep that differ on one axis only, and what they have in common.
struct Family {
    label: String,
    rows: Vec<usize>,
}

/// Most points of a curve, four to a point of the picture's width.
const POINTS: usize = 1000;
/// Most curves: more can hardly be told apart.
const CURVES: usize = 200;

/// Whether a picture of a sweep needs the row with this number: of a large grid equally spaced ones are drawn, at most a
/// thousand along a curve and two hundred curves.
pub fn is_drawn(sweep: &Sweep, row: usize) -> bool {
    if let Some(axes) = heat::axes(sweep) {
        return heat::is_drawn(sweep, axes, row);
    }
    let (axes, along) = (sweep.axes(), along(sweep));
    let (mut rest, mut curve, mut place) = (row, 0, 1);
    let mut point = 0;
    for (i, axis) in axes.iter().enumerate().rev() {
        let value = rest % axis.count();
        rest /= axis.count();
        if Some(i) == along {
            point = value;
        } else {
            curve += value * place;
            place *= axis.count();
        }
    }
    let points = along.map_or(1, |along| axes[along].count());
    point % step(points, POINTS) == 0 && curve % step(place, CURVES) == 0
}

/// The axis along which curves are drawn: that with most values, if it has two.
fn along(sweep: &Sweep) -> Option<usize> {
    let counts = sweep.axes().iter().map(Axis::count).enumerate();
    counts.filter(|(_, count)| *count > 1).max_by_key(|(_, count)| *count).map(|(i, _)| i)
}

/// A sweep over two axes of six values or more each as maps over both; any other as curves over the axis with most values, one for
/// each combination of the others. Points with a warning have a circle, those without a solution a cross, and where a curve
/// jumps it is dotted.
///
/// `points` are the points of the sweep in order, as [`SweepCsv::point`](crate::report::SweepCsv::point) has them; points that
/// [are not drawn](is_drawn) may be left out.
///
/// # Errors
/// [`PlotError::Empty`] if no axis has two values.
pub fn sweep(sweep: &Sweep, points: &[SweepPoint]) -> Result<Picture, PlotError> {
    let axes = sweep.axes();
    let Some(along) = along(sweep) else {
        return Err(PlotError::Empty("a curve needs a quantity that takes two values".into()));
    };
    if let Some(both) = heat::axes(sweep) {
        return Ok(heat::maps(sweep, both, &planes(sweep, points), points));
    }
    let others: Vec<usize> = (0..axes.len()).filter(|i| *i != along && axes[*i].count() > 1).collect();
    let curves = Curves {
        scene: sweep.scene(),
        axis: &axes[along],
        along,
        families: families(axes, along, &others, points),
        points,
    };
    let planes = planes(sweep, points);
    let mut picture = Picture::new(PLANE.0, PLANE.1);
    for plane in &planes {
        let last = planes.iter().all(|other| other.place[0] <= plane.place[0]);
        curves.draw(&mut picture, plane, last && !others.is_empty());
    }
    let name = |i: &usize| {
        let (name, dimension) = of_path(sweep.scene(), axes[*i].path());
        with_unit(&name, unit(sweep.scene(), dimension).as_deref(), 0)
    };
    let right = frame([planes.iter().map(|plane| plane.place[0]).max().unwrap_or(0), 0]).right;
    for (i, title) in others.iter().map(name).enumerate() {
        let below = (others.len() - 1 - i) as f64 * 1.3 * TEXT;
        picture.text((right + 11.0, -0.9 * AROUND.1 - below), &title, TEXT, INK, Anchor::Left);
    }
    let left_out = sweep.interfaces().len().saturating_sub(CONTACTS);
    notes(&mut picture, points, &curves.jumps(&planes), left_out);
    Ok(picture.fitted())
}

/// What is to be said of marks and of what is not drawn.
fn notes(picture: &mut Picture, points: &[SweepPoint], jumps: &[usize], left_out: usize) {
    let mut notes = Vec::new();
    if points.iter().any(|point| point.warned) {
        notes.push("circle: a warning, see the column `message`".to_owned());
    }
    if points.iter().any(|point| !point.solved) {
        notes.push("cross: no solution, see the column `message`".to_owned());
    }
    if !jumps.is_empty() {
        notes.push("dotted: the curve jumps".to_owned());
    }
    if left_out > 0 {
        notes.push(format!("not drawn: {left_out} more contacts"));
    }
    let top = frame([0, 2]).top;
    for (i, note) in notes.iter().enumerate() {
        picture.text((0.0, top + 1.3 * SMALL * i as f64), note, SMALL, INK, Anchor::Left);
    }
}

/// All curves over one axis.
struct Curves<'a> {
    scene: &'a Scene,
    axis: &'a Axis,
    along: usize,
    families: Vec<Family>,
    points: &'a [SweepPoint],
}

impl Curves<'_> {
    fn curve(&self, family: &Family, column: usize) -> Vec<(f64, f64)> {
        let point = |row: &usize| (number(&self.points[*row], self.along), number(&self.points[*row], column));
        family.rows.iter().map(point).collect()
    }

    fn draw(&self, picture: &mut Picture, plane: &Plane, named: bool) {
        let frame = frame(plane.place);
        let (x_label, x_dimension) = of_path(self.scene, self.axis.path());
        let count = self.families.len();
        let mut drawn = Vec::new();
        for (i, family) in self.families.iter().enumerate() {
            let (mut points, mut last) = (Vec::new(), Vec::new());
            let all = self.curve(family, plane.column);
            let jumps = jumps(&all);
            for (k, point) in all.iter().enumerate() {
                points.push(*point);
                if jumps.contains(&k) {
                    points.push((f64::NAN, f64::NAN));
                    last.extend([*point, all[k + 1], (f64::NAN, f64::NAN)]);
                }
            }
            let label = if named && !hidden(i, count, LABELLED) { family.label.clone() } else { String::new() };
            drawn.push(Curve { points, stroke: curve(i, count), label });
            let dotted = Stroke { dash: Some((1.0, 2.5)), ..hair(FAINT) };
            drawn.push(Curve { points: last, stroke: dotted, label: String::new() });
        }
        let chart = Chart {
            frame,
            x: scale_of(self.axis, POINTS),
            y: Scale::around(self.points.iter().map(|point| number(point, plane.column))).rounded(),
            x_label,
            x_unit: unit(self.scene, x_dimension),
            y_label: plane.label.clone(),
            y_unit: plane.unit.clone(),
            curves: drawn,
            labels: Labels::AtEnds,
        };
        let middle = 0.5 * (frame.left + frame.right);
        picture.text((middle, frame.top - 0.5 * AROUND.1), &plane.what, TEXT, INK, Anchor::Centre);
        chart.draw(picture);
        for point in self.points {
            let (x, y) = (number(point, self.along), number(point, plane.column));
            if point.warned && y.is_finite() {
                picture.circle(chart.place((x, y)), 2.6, hair(INK));
            } else if !point.solved {
                let (x, y) = (chart.place((x, 0.0)).0, frame.bottom - 5.0);
                picture.line(&[(x - 2.5, y - 2.5), (x + 2.5, y + 2.5)], hair(INK));
                picture.line(&[(x - 2.5, y + 2.5), (x + 2.5, y - 2.5)], hair(INK));
            }
        }
    }

    /// All jumps of all curves.
    fn jumps(&self, planes: &[Plane]) -> Vec<usize> {
        let of = |plane: &Plane| {
            self.families.iter().flat_map(|family| jumps(&self.curve(family, plane.column))).collect::<Vec<_>>()
        };
        planes.iter().flat_map(of).collect()
    }
}

/// After which points a curve jumps.
fn jumps(curve: &[(f64, f64)]) -> Vec<usize> {
    let (low, high) = Scale::around(curve.iter().map(|(_, y)| *y)).ends();
    let changes: Vec<f64> = curve.windows(2).map(|pair| (pair[1].1 - pair[0].1).abs()).collect();
    let jumps = |k: &usize| {
        let beside = changes[*k - 1].max(changes[*k + 1]);
        changes[*k] > JUMP[0] * (high - low) && changes[*k] > JUMP[1] * beside
    };
    (1..changes.len().saturating_sub(1)).filter(jumps).collect()
}

/// The plane of curves in a column and a line of the picture.
fn frame([column, line]: [usize; 2]) -> Frame {
    let (beside, above, below) = AROUND;
    let left = column as f64 * (beside + PLANE.0);
    let top = line as f64 * (above + PLANE.1 + below);
    Frame { left, top, right: left + PLANE.0, bottom: top + PLANE.1 }
}

/// Rows that differ in the value on axis `along` only, in the order of the grid.
fn families(axes: &[Axis], along: usize, others: &[usize], points: &[SweepPoint]) -> Vec<Family> {
    let mut families: Vec<(Vec<f64>, Family)> = Vec::new();
    let texts = others.iter().map(|axis| {
        let values: Vec<f64> = points.iter().map(|row| number(row, *axis)).collect();
        distinct(&values)
    });
    let texts: Vec<Vec<String>> = texts.collect();
    for (i, row) in points.iter().enumerate() {
        let key: Vec<f64> = (0..axes.len()).filter(|axis| *axis != along).map(|axis| number(row, axis)).collect();
        match families.iter_mut().find(|(found, _)| *found == key) {
            Some((_, family)) => family.rows.push(i),
            None => {
                let label = texts.iter().map(|of_axis| &of_axis[i][..]).collect::<Vec<_>>().join(", ");
                families.push((key, Family { label, rows: vec![i] }));
            }
        }
    }
    families.into_iter().map(|(_, family)| family).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn jumps_are_found_and_steep_curves_are_none() {
        let curve = |f: fn(f64) -> f64| (0..20).map(f64::from).map(|x| (x, f(x))).collect::<Vec<_>>();
        assert_eq!(jumps(&curve(|x| if x < 9.5 { x } else { x + 30.0 })), [9]);
        assert_eq!(jumps(&curve(|x| x * x)), [0; 0]);
        assert_eq!(jumps(&curve(|x| (0.4 * x).sin())), [0; 0]);
        assert_eq!(jumps(&curve(|_| 1.0)), [0; 0]);
        assert_eq!(jumps(&[]), [0; 0]);
    }
}
