//! A sweep over two axes as maps over both, one column for each contact.
use super::bands::{Bands, Values};
use super::chart::{Chart, Frame, Labels, with_unit};
use super::names::{of_path, unit};
use super::picture::{Anchor, Picture};
use super::planes::{Plane, number, scale_of, step};
use super::scale::Scale;
use super::style::{INK, SMALL, TEXT};
use crate::axis::Axis;
use crate::sweep::{Sweep, SweepPoint};

/// Fewest values of an axis for a map: fewer are curves.
const FEWEST: usize = 6;
/// Most places along each axis.
const MOST: usize = 100;
/// Size of one map, and the distance from one to the next, in points.
const SIZE: [f64; 2] = [200.0, 150.0];
const APART: [f64; 2] = [330.0, 222.0];
/// Between a map and its scale of colours, in points.
const BEFORE_BAR: f64 = 12.0;

/// The two axes of a sweep that is drawn as maps, those along x and along y.
pub(super) fn axes(sweep: &Sweep) -> Option<[usize; 2]> {
    let varied: Vec<usize> = (0..sweep.axes().len()).filter(|i| sweep.axes()[*i].count() > 1).collect();
    match varied[..] {
        [y, x] if [x, y].iter().all(|i| sweep.axes()[*i].count() >= FEWEST) => Some([x, y]),
        _ => None,
    }
}

/// Whether a map needs the row with this number.
pub(super) fn is_drawn(sweep: &Sweep, [x, y]: [usize; 2], row: usize) -> bool {
    let count = |i: usize| sweep.axes()[i].count();
    // the axes between and beyond have one value
    let (column, line) = (row % count(x), row / count(x));
    column.is_multiple_of(step(count(x), MOST)) && line.is_multiple_of(step(count(y), MOST))
}

/// The maps of all planes.
pub(super) fn maps(sweep: &Sweep, both: [usize; 2], planes: &[Plane], points: &[SweepPoint]) -> Picture {
    let [x, y] = both.map(|i| &sweep.axes()[i]);
    let needed = |point: &&SweepPoint| both.iter().all(|i| places(&sweep.axes()[*i]).contains(&number(point, *i)));
    let points: Vec<&SweepPoint> = points.iter().filter(needed).collect();
    let mut picture = Picture::new(SIZE[0], SIZE[1]);
    for plane in planes {
        let [left, top] = [0, 1].map(|k| plane.place[k] as f64 * APART[k]);
        let name = |axis: &Axis| {
            let (name, dimension) = of_path(sweep.scene(), axis.path());
            (name, unit(sweep.scene(), dimension))
        };
        let ((x_label, x_unit), (y_label, y_unit)) = (name(x), name(y));
        let chart = Chart {
            frame: Frame { left, top, right: left + SIZE[0], bottom: top + SIZE[1] },
            x: scale_of(x, MOST),
            y: scale_of(y, MOST),
            x_label,
            x_unit,
            y_label,
            y_unit,
            curves: Vec::new(),
            labels: Labels::AtEnds,
        };
        let [xs, ys] = [x, y].map(|axis| {
            let mut places = places(axis);
            places.sort_by(f64::total_cmp);
            places
        });
        let at = |list: &[f64], value: f64| list.partition_point(|place| *place < value).min(list.len() - 1);
        let mut values = vec![f64::NAN; xs.len() * ys.len()];
        for point in &points {
            let [column, line] = [(both[0], &xs), (both[1], &ys)].map(|(i, list)| at(list, number(point, i)));
            values[line * xs.len() + column] = number(point, plane.column);
        }
        let bands = Bands::new(Scale::around(values.iter().copied()), None);
        bands.draw(&mut picture, &Values { xs: &xs, ys: &ys, values: &values }, |place| chart.place(place));
        chart.draw(&mut picture);
        let Frame { right, bottom, .. } = chart.frame;
        let title = with_unit(&plane.label, plane.unit.as_deref(), bands.scale.power());
        bands.bar(&mut picture, (right + BEFORE_BAR, top), bottom, &title);
        picture.text((0.5 * (left + right), top - 12.0), &plane.what, TEXT, INK, Anchor::Centre);
    }
    if points.iter().any(|point| !point.solved) {
        let note = "white: no solution, see the column `message`";
        picture.text((0.0, 2.0 * APART[1]), note, SMALL, INK, Anchor::Left);
    }
    picture.fitted()
}

/// The values of an axis that are drawn.
fn places(axis: &Axis) -> Vec<f64> {
    axis.values().step_by(step(axis.count(), MOST)).collect()
}
