//! A sweep as curves over one axis or as maps over two, one column for each contact: as far as it reaches above, its largest pressure below; or one for each of some columns of its table.
use super::bands::{Bands, MapStyle};
use super::chart::{Chart, Curve, Frame, Labels, hidden};
use super::file::PlotError;
use super::names::{Dimension, of_column, of_contact, of_path, symbols, unit};
use super::picture::{Anchor, Picture, Stroke};
use super::scale::{Scale, distinct, short};
use super::style::{FAINT, INK, SMALL, TEXT, curve, hair};
use crate::axis::Axis;
use crate::solution::Contact;
use crate::sweep::{Sweep, SweepPoint};

/// Distance of the middle of a heading from the plane below, in points.
const HEADING: f64 = 11.0;
/// Between a map and its scale of colours, in points.
const BEFORE_BAR: f64 = 12.0;
/// Most curves that are told apart by labels.
const LABELLED: usize = 10;
/// A curve jumps where it changes by more than the first part of its range, and that many times as much as before and after.
const JUMP: [f64; 2] = [0.1, 6.0];
/// Most points of a curve, four to a point of the picture's width.
const POINTS: usize = 1000;
/// Most curves: more can hardly be told apart.
const CURVES: usize = 200;
/// Fewest values of an axis for a map: fewer are curves.
const FEWEST: usize = 6;
/// Most places along each axis of a map.
const MOST: usize = 100;
/// Most contacts that have a column.
const CONTACTS: usize = 6;
/// Most points of a curve that are marked: more are dense.
const MARKED: usize = 25;
/// Values of equal ratio over at least such a range are drawn so.
const WIDE: f64 = 8.0;

/// Which columns of the table of a sweep are drawn, by their numbers and names; by default how far contacts reach and their largest pressures, over an axis.
#[derive(Clone, Debug, Default)]
pub struct DrawnColumns {
    /// The column over which others are drawn, as curves.
    pub along: Option<(usize, String)>,
    /// The columns that are drawn, each in a plane of its own.
    pub up: Vec<(usize, String)>,
    /// Whether equal ratios, not equal differences, are equally far apart along x, and along y.
    pub logarithmic: [bool; 2],
    /// How maps are coloured, all of them.
    pub style: MapStyle,
}

/// The axes of the planes of a picture, and the size of a plane.
struct Layout<'a> {
    sweep: &'a Sweep,
    points: &'a [SweepPoint],
    /// The axis along x: with curves that with most values.
    along: usize,
    /// The axis along y; `None` for curves.
    up: Option<usize>,
    /// Most values along x, and most of all others together.
    most: [usize; 2],
    columns: &'a DrawnColumns,
    /// Size of one plane, and the distance from one to the next, in points.
    size: [f64; 2],
    apart: [f64; 2],
}

/// Whether a picture of a sweep needs the row with this number: of a large grid equally spaced ones are drawn, at most a
/// thousand along a curve and two hundred curves.
pub fn is_drawn(sweep: &Sweep, row: usize) -> bool {
    let Some(Layout { along, most, .. }) = Layout::of(sweep, &[], &DrawnColumns::default()) else { return true };
    let counts: Vec<usize> = sweep.axes().iter().map(Axis::count).collect();
    // the last axis changes fastest
    let (count, within) = (counts[along], counts[along + 1..].iter().product::<usize>());
    let others = counts[..along].iter().product::<usize>() * within;
    let (point, other) = (row / within % count, row / (within * count) * within + row % within);
    point.is_multiple_of(step(count, most[0])) && other.is_multiple_of(step(others, most[1]))
}

/// Whether a sweep is drawn as maps, not as curves.
pub fn is_map(sweep: &Sweep, columns: &DrawnColumns) -> bool {
    Layout::of(sweep, &[], columns).is_some_and(|layout| layout.up.is_some())
}

/// A sweep over two axes of six values or more each as maps over both; any other as curves over the axis with most values, one for
/// each combination of the others. Points with a warning have a circle, those without a solution a cross, and where a curve
/// jumps it is dotted.
///
/// `points` are the points of the sweep in order, as [`SweepCsv::point`](crate::report::SweepCsv::point) has them; points that
/// [are not drawn](is_drawn) may be left out.
///
/// # Errors
/// [`PlotError::Empty`] if no axis has two values; [`PlotError::Drawing`] if a value is not positive where ratios are to be equally far apart or to have
/// equally many colours.
pub fn sweep(sweep: &Sweep, points: &[SweepPoint], columns: &DrawnColumns) -> Result<Picture, PlotError> {
    let empty = || PlotError::Empty("a curve needs a quantity that takes two values".into());
    let layout = Layout::of(sweep, points, columns).ok_or_else(empty)?;
    let (families, planes) = (layout.families(), layout.planes());
    layout.check_ratios(&planes)?;
    let mut picture = Picture::new(layout.size[0], layout.size[1]);
    let mut jumping = false;
    for plane in &planes {
        let frame = layout.frame(plane.place);
        let middle = 0.5 * (frame.left + frame.right);
        picture.text((middle, frame.top - HEADING), &plane.what, TEXT, INK, Anchor::Centre);
        if layout.up.is_some() {
            layout.map(&mut picture, plane)?;
        } else {
            jumping |= layout.curves(&mut picture, plane, &families);
        }
    }
    let right = layout.frame([layout.last(), 0]).right;
    for (i, axis) in layout.others().into_iter().rev().enumerate() {
        let (name, unit) = layout.name(axis);
        let title = [name].into_iter().chain(unit).collect::<Vec<_>>().join(", ");
        let place = (right + HEADING, -1.8 * HEADING - i as f64 * 1.3 * TEXT);
        picture.text(place, &title, TEXT, INK, Anchor::Left);
    }
    layout.notes(&mut picture, jumping);
    Ok(picture.fitted())
}

impl<'a> Layout<'a> {
    /// `None` if no axis has two values.
    fn of(sweep: &'a Sweep, points: &'a [SweepPoint], columns: &'a DrawnColumns) -> Option<Self> {
        let count = |i: &usize| sweep.axes()[*i].count();
        let varied: Vec<usize> = (0..sweep.axes().len()).filter(|i| count(i) > 1).collect();
        Some(match varied[..] {
            [y, x] if count(&x).min(count(&y)) >= FEWEST && columns.along.is_none() => {
                let (along, up, most) = (x, Some(y), [MOST; 2]);
                Self { sweep, points, along, up, most, columns, size: [200.0, 150.0], apart: [330.0, 222.0] }
            }
            _ => {
                let (along, up, most) = (varied.iter().copied().max_by_key(count)?, None, [POINTS, CURVES]);
                Self { sweep, points, along, up, most, columns, size: [215.0, 145.0], apart: [285.0, 209.0] }
            }
        })
    }

    /// The plane in a column and a line of the picture.
    fn frame(&self, place: [usize; 2]) -> Frame {
        let [left, top] = [0, 1].map(|k| place[k] as f64 * self.apart[k]);
        Frame { left, top, right: left + self.size[0], bottom: top + self.size[1] }
    }

    /// The last column of the picture.
    fn last(&self) -> usize {
        match self.columns.up.len() {
            0 => self.sweep.contacts().take(CONTACTS).count().saturating_sub(1),
            count => count - 1,
        }
    }

    /// Two planes for each contact: how far it reaches, and its largest pressure, or the pressure at x = 0 where the largest is infinite.
    fn planes(&self) -> Vec<SweepPlane> {
        if !self.columns.up.is_empty() {
            let of = |(i, (column, name)): (usize, &(usize, String))| {
                let (what, label, unit) = (String::new(), name.clone(), of_column(self.sweep.scene(), name));
                SweepPlane { what, place: [i, 0], column: *column, label, unit }
            };
            return self.columns.up.iter().enumerate().map(of).collect();
        }
        let (sweep, scene) = (self.sweep, self.sweep.scene());
        let contacts: Vec<_> = sweep.contacts().collect();
        let symbols = symbols(contacts.iter().map(|(interface, _)| *interface));
        let mut planes = Vec::new();
        for (i, ((interface, punch), (length, pressure))) in contacts.iter().zip(&symbols).enumerate().take(CONTACTS) {
            let column = |name: &str| {
                let of_contact = Contact::COLUMNS.iter().position(|column| *column == name).unwrap_or(0);
                sweep.axes().len() + Contact::COLUMNS.len() * i + of_contact
            };
            let known = |column: usize| self.points.iter().filter(move |point| number(point, column).is_finite());
            let (half, right) = (column("half_length"), column("right"));
            let whole = known(right).all(|point| number(point, half).is_finite());
            let half_length = scene.geometry.words().half_length;
            let (end, reach) = match (whole, scene.top.is_even()) {
                (true, _) => (half, format!("{half_length} {length}")),
                (false, true) => (right, "outer end of the contact".to_owned()),
                (false, false) => (right, "right end of the contact".to_owned()),
            };
            let (peak, centre) = (column("peak_pressure"), column("central_pressure"));
            let finite = known(peak).next().is_some();
            let (at, name) =
                if finite { (peak, format!("largest {pressure}")) } else { (centre, format!("{pressure}(0)")) };
            let quantities = [(end, reach, Dimension::LENGTH), (at, name, Dimension::STRESS)];
            let what =
                punch.map_or_else(|| of_contact(scene, *interface), |punch| format!("under punch {}", punch + 1));
            planes.extend(quantities.into_iter().enumerate().map(|(line, (column, label, dimension))| SweepPlane {
                what: if line == 0 { what.clone() } else { String::new() },
                place: [i, line],
                column,
                label,
                unit: unit(scene, dimension),
            }));
        }
        planes
    }

    /// The axes with two values that are neither along x nor along y.
    fn others(&self) -> Vec<usize> {
        let is_other = |i: &usize| self.sweep.axes()[*i].count() > 1 && *i != self.along && Some(*i) != self.up;
        (0..self.sweep.axes().len()).filter(is_other).collect()
    }

    /// The label of an axis, and its unit.
    fn name(&self, axis: usize) -> (String, Option<String>) {
        let (name, dimension) = of_path(self.sweep.scene(), self.sweep.axes()[axis].path());
        (name, unit(self.sweep.scene(), dimension))
    }

    /// The number of the column along x.
    fn column(&self) -> usize {
        self.columns.along.as_ref().map_or(self.along, |(column, _)| *column)
    }

    /// Refuses values that are not positive where ratios are to be equally far apart.
    fn check_ratios(&self, planes: &[SweepPlane]) -> Result<(), PlotError> {
        let [along, up] = self.columns.logarithmic;
        // of maps an axis, of curves what they show
        let columns = planes.iter().filter(|_| up).map(|plane| self.up.unwrap_or(plane.column));
        for column in columns.chain(along.then(|| self.column())) {
            if let Some(value) = self.points.iter().map(|point| number(point, column)).find(|value| *value <= 0.0) {
                let message =
                    format!("logarithmic axes need values > 0, found {}: leave out --log there", short(value));
                return Err(PlotError::Drawing(message));
            }
        }
        Ok(())
    }

    /// The scale of a column along x, 0, or along y, 1.
    fn values(&self, column: usize, direction: usize) -> Scale {
        let scale = Scale::around(self.points.iter().map(|point| number(point, column)));
        if self.columns.logarithmic[direction] { scale.logarithmic() } else { scale.rounded() }
    }

    fn chart(&self, plane: &SweepPlane, y: Scale, curves: Vec<Curve>) -> Chart {
        let x = match &self.columns.along {
            Some((column, name)) => self.values(*column, 0).of(name, of_column(self.sweep.scene(), name)),
            None if self.columns.logarithmic[0] => self.scale(self.along, self.most[0]).logarithmic(),
            None => self.scale(self.along, self.most[0]),
        };
        Chart { frame: self.frame(plane.place), x, y, curves, labels: Labels::AtEnds }
    }

    /// The values of an axis: logarithmic if their ratios are equal and span much.
    fn scale(&self, axis: usize, most: usize) -> Scale {
        let (name, unit) = self.name(axis);
        let axis = &self.sweep.axes()[axis];
        let values: Vec<f64> = axis.values().step_by(step(axis.count(), most)).collect();
        let scale = Scale::around(values.iter().copied()).of(&name, unit);
        let (low, high) = scale.ends();
        let ratios = || values.windows(2).map(|pair| pair[1] / pair[0]);
        let same = ratios().next().is_some_and(|first| ratios().all(|ratio| (ratio / first - 1.0).abs() < 1e-6));
        if low > 0.0 && high / low >= WIDE && values.len() > 2 && same { scale.logarithmic() } else { scale }
    }

    fn map(&self, picture: &mut Picture, plane: &SweepPlane) -> Result<(), PlotError> {
        let axes = [self.along, self.up.unwrap_or(self.along)];
        let [xs, ys] = [0, 1].map(|k| {
            let axis = &self.sweep.axes()[axes[k]];
            let mut places: Vec<f64> = axis.values().step_by(step(axis.count(), self.most[k])).collect();
            places.sort_by(f64::total_cmp);
            places
        });
        let mut values = vec![f64::NAN; xs.len() * ys.len()];
        for point in self.points {
            let at = |list: &[f64], axis: usize| list.binary_search_by(|at| at.total_cmp(&number(point, axis))).ok();
            if let (Some(column), Some(line)) = (at(&xs, axes[0]), at(&ys, axes[1])) {
                values[line * xs.len() + column] = number(point, plane.column);
            }
        }
        let y = self.scale(axes[1], self.most[1]);
        let y = if self.columns.logarithmic[1] { y.logarithmic() } else { y };
        let chart = self.chart(plane, y, Vec::new());
        // a plane without numbers is white in any style
        let has_numbers = values.iter().any(|value| value.is_finite());
        let style = if has_numbers { self.columns.style } else { MapStyle::default() };
        let (low, high) = Scale::around(values.iter().copied()).ends();
        let bands = Bands::new(style.scale([low, high])?.of(&plane.label, plane.unit.clone()), None, &style);
        bands.draw(picture, [&xs, &ys], &values, |place| chart.place(place));
        chart.draw(picture);
        let Frame { right, top, bottom, .. } = chart.frame;
        bands.bar(picture, (right + BEFORE_BAR, top), bottom);
        Ok(())
    }

    /// Curves with marks; whether one of them jumps.
    fn curves(&self, picture: &mut Picture, plane: &SweepPlane, families: &[(String, Vec<usize>)]) -> bool {
        let is_labelled = plane.place[0] == self.last() && families.len() > 1;
        let along = self.column();
        let place = |point: &SweepPoint| (number(point, along), number(point, plane.column));
        let gap = (f64::NAN, f64::NAN);
        let (mut curves, mut jumping) = (Vec::new(), false);
        for (i, (label, rows)) in families.iter().enumerate() {
            let mut points: Vec<(f64, f64)> = rows.iter().map(|row| place(&self.points[*row])).collect();
            let jumps = jumps(&points);
            jumping |= !jumps.is_empty();
            let dotted = Stroke { dash: Some((1.0, 2.5)), ..hair(FAINT) };
            let over = jumps.iter().flat_map(|k| [points[*k], points[k + 1], gap]).collect();
            jumps.iter().rev().for_each(|k| points.insert(k + 1, gap));
            let is_named = is_labelled && !hidden(i, families.len(), LABELLED);
            let label = if is_named { label.clone() } else { String::new() };
            curves.push(Curve { points, stroke: curve(i, families.len()), label });
            curves.push(Curve { points: over, stroke: dotted, label: String::new() });
        }
        let y = self.values(plane.column, 1);
        let chart = self.chart(plane, y.of(&plane.label, plane.unit.clone()), curves);
        chart.draw(picture);
        for (i, (_, rows)) in families.iter().enumerate().filter(|(_, (_, rows))| rows.len() <= MARKED) {
            let places = rows.iter().map(|row| chart.place(place(&self.points[*row])));
            let stroke = Stroke { dash: None, ..curve(i, families.len()) };
            places.filter(|(x, y)| x.is_finite() && y.is_finite()).for_each(|place| picture.circle(place, 1.2, stroke));
        }
        for point in self.points {
            let (x, y) = chart.place(place(point));
            if point.warned && y.is_finite() {
                picture.circle((x, y), 2.6, hair(INK));
            } else if !point.solved {
                let y = chart.frame.bottom - 5.0;
                picture.line(&[(x - 2.5, y - 2.5), (x + 2.5, y + 2.5)], hair(INK));
                picture.line(&[(x - 2.5, y + 2.5), (x + 2.5, y - 2.5)], hair(INK));
            }
        }
        jumping
    }

    /// The rows that differ on the axis along x only, in the order of the grid, and what they have in common.
    fn families(&self) -> Vec<(String, Vec<usize>)> {
        let texts = self.others().into_iter().map(|axis| {
            let values: Vec<f64> = self.points.iter().map(|point| number(point, axis)).collect();
            distinct(&values)
        });
        let texts: Vec<Vec<String>> = texts.collect();
        let mut families: Vec<(String, Vec<usize>)> = Vec::new();
        for row in 0..self.points.len() {
            let label = texts.iter().map(|of_axis| &of_axis[row][..]).collect::<Vec<_>>().join(", ");
            match families.iter_mut().find(|(found, _)| *found == label) {
                Some((_, rows)) => rows.push(row),
                None => families.push((label, vec![row])),
            }
        }
        families
    }

    /// Lines of text below the planes that explain the marks, and name contacts that are not drawn.
    fn notes(&self, picture: &mut Picture, jumping: bool) {
        let contacts = if self.columns.up.is_empty() { self.sweep.contacts().count() } else { 0 };
        let left_out = contacts.saturating_sub(CONTACTS);
        let mark = if self.up.is_some() { "white" } else { "cross" };
        let marked = self.up.is_none() && self.points.iter().any(|point| point.warned);
        let notes = [
            (marked, "circle: a warning, see the column `message`".to_owned()),
            (self.points.iter().any(|point| !point.solved), format!("{mark}: no solution, see the column `message`")),
            (jumping, "dotted: the curve jumps".to_owned()),
            (left_out > 0, format!("not drawn: {left_out} more contacts")),
        ];
        let lines = if self.columns.up.is_empty() { 2 } else { 1 };
        let top = self.frame([0, lines]).top;
        for (i, (_, note)) in notes.into_iter().filter(|(is_so, _)| *is_so).enumerate() {
            picture.text((0.0, top + 1.3 * SMALL * i as f64), &note, SMALL, INK, Anchor::Left);
        }
    }
}

/// One plane of the picture: a column of numbers of one contact.
struct SweepPlane {
    /// Which contact, and how far right and down the plane is.
    what: String,
    place: [usize; 2],
    /// The column of the numbers.
    column: usize,
    label: String,
    unit: Option<String>,
}

/// A number of a row; NaN where it has none.
fn number(point: &SweepPoint, column: usize) -> f64 {
    point.numbers.get(column).copied().unwrap_or(f64::NAN)
}

/// The smallest step with which no more than a given number of values are left.
fn step(count: usize, most: usize) -> usize {
    count.div_ceil(most).max(1)
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
