//! The curves of a sweep: half-lengths above, pressures below, one column for each contact.
use super::chart::{Chart, Curve, Frame, Labels};
use super::file::PlotError;
use super::names::{Dimension, of_path, symbols, unit};
use super::picture::{Anchor, Picture};
use super::scale::{Scale, label};
use super::style::{INK, TEXT, curve};
use crate::solution::{Contact, Interface};
use crate::sweep::{Axis, Sweep};

/// Size of one plane of curves, in points.
const PLANE: (f64, f64) = (215.0, 145.0);
/// What is left of, above and below a plane, in points.
const AROUND: (f64, f64, f64) = (66.0, 22.0, 40.0);
/// Most curves that are told apart by labels.
const LABELLED: usize = 10;
/// Values of equal ratio over at least such a range are drawn so.
const WIDE: f64 = 8.0;

/// The rows of a sweep that differ on one axis only, and what they have in common.
struct Family {
    label: String,
    rows: Vec<usize>,
}

/// Most points of a curve, four to a point of the picture's width.
const POINTS: usize = 1000;
/// Most curves: those of more can hardly be told apart.
const CURVES: usize = 200;

/// Whether a picture of a sweep needs the row with this number: of a large grid equally spaced ones are drawn, at most a
/// thousand along a curve and two hundred curves.
pub fn is_drawn(sweep: &Sweep, row: usize) -> bool {
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

/// The least step with which so many are at most so few.
fn step(count: usize, most: usize) -> usize {
    count.div_ceil(most).max(1)
}

/// The axis along which curves are drawn: that with most values, if it has two.
fn along(sweep: &Sweep) -> Option<usize> {
    let counts = sweep.axes().iter().map(Axis::count).enumerate();
    counts.filter(|(_, count)| *count > 1).max_by_key(|(_, count)| *count).map(|(i, _)| i)
}

/// Curves of a sweep over the axis with most values, one for each combination of the others.
///
/// `rows` are those of the sweep in order, as [`SweepCsv::numbers`](crate::report::SweepCsv::numbers) has them; those that
/// [are not drawn](is_drawn) may be left out.
///
/// # Errors
/// [`PlotError::Empty`] if no axis has two values.
pub fn sweep(sweep: &Sweep, rows: &[Vec<f64>]) -> Result<Picture, PlotError> {
    let axes = sweep.axes();
    let Some(along) = along(sweep) else {
        return Err(PlotError::Empty("a curve needs a quantity that takes two values".into()));
    };
    let others: Vec<usize> = (0..axes.len()).filter(|i| *i != along && axes[*i].count() > 1).collect();
    let families = families(axes, along, &others, rows);
    let title = others.iter().map(|i| of_path(axes[*i].path()).0).collect::<Vec<_>>().join(", ");
    let longest = families.iter().map(|family| family.label.chars().count()).max().unwrap_or(0);
    // an index is a small letter, and a symbol has two marks around it
    let longest = longest.max(title.chars().count().saturating_sub(2 * others.len()));
    let beside = if others.is_empty() { 18.0 } else { 24.0 + 0.6 * TEXT * longest as f64 };

    let interfaces = sweep.interfaces();
    let symbols = symbols(interfaces);
    let (left, above, below) = AROUND;
    let (width, height) = (interfaces.len() as f64 * (left + PLANE.0) + beside, 2.0 * (above + PLANE.1 + below));
    let mut picture = Picture::new(width, height);
    let scene = sweep.scene();
    if !others.is_empty() {
        let right = width - beside + 11.0;
        picture.text((right, 0.5 * above), &title, TEXT, INK, Anchor::Left);
    }
    for (column, (interface, (length, pressure))) in interfaces.iter().zip(&symbols).enumerate() {
        let what = match interface {
            Interface::Punch => "under the punch".to_owned(),
            between => format!("contact {between}"),
        };
        let quantities =
            [(0, format!("half-length {length}"), Dimension::Length), (2, format!("{pressure}(0)"), Dimension::Stress)];
        for (line, (offset, y_label, dimension)) in quantities.into_iter().enumerate() {
            let at = axes.len() + Contact::COLUMNS.len() * column + offset;
            let named = column + 1 == interfaces.len() && !others.is_empty();
            let curves = families.iter().enumerate().map(|(i, family)| Curve {
                points: family.rows.iter().map(|row| (number(&rows[*row], along), number(&rows[*row], at))).collect(),
                stroke: curve(i, families.len()),
                label: if named && labelled(i, families.len()) { family.label.clone() } else { String::new() },
            });
            let frame = frame(column, line);
            let (x_label, x_dimension) = of_path(axes[along].path());
            let chart = Chart {
                frame,
                x: along_x(&axes[along]),
                y: Scale::around(rows.iter().map(|row| number(row, at))).rounded(),
                x_label,
                x_unit: unit(scene, x_dimension),
                y_label,
                y_unit: unit(scene, dimension),
                curves: curves.collect(),
                labels: Labels::AtEnds,
            };
            if line == 0 {
                let middle = 0.5 * (frame.left + frame.right);
                picture.text((middle, frame.top - 0.5 * above), &what, TEXT, INK, Anchor::Centre);
            }
            chart.draw(&mut picture);
        }
    }
    Ok(picture)
}

/// The plane of curves in a column and a line of the picture.
fn frame(column: usize, line: usize) -> Frame {
    let (beside, above, below) = AROUND;
    let left = beside + column as f64 * (beside + PLANE.0);
    let top = above + line as f64 * (above + PLANE.1 + below);
    Frame { left, top, right: left + PLANE.0, bottom: top + PLANE.1 }
}

/// Rows that differ in the value on axis `along` only, in the order of the grid.
fn families(axes: &[Axis], along: usize, others: &[usize], rows: &[Vec<f64>]) -> Vec<Family> {
    let mut families: Vec<(Vec<f64>, Family)> = Vec::new();
    for (i, row) in rows.iter().enumerate() {
        let key: Vec<f64> = (0..axes.len()).filter(|axis| *axis != along).map(|axis| number(row, axis)).collect();
        match families.iter_mut().find(|(found, _)| *found == key) {
            Some((_, family)) => family.rows.push(i),
            None => {
                let label = others.iter().map(|axis| label(number(row, *axis))).collect::<Vec<_>>().join(", ");
                families.push((key, Family { label, rows: vec![i] }));
            }
        }
    }
    families.into_iter().map(|(_, family)| family).collect()
}

/// All curves have a label, or the first and the last if there are too many.
fn labelled(index: usize, count: usize) -> bool {
    count <= LABELLED || index == 0 || index + 1 == count
}

fn number(row: &[f64], column: usize) -> f64 {
    row.get(column).copied().unwrap_or(f64::NAN)
}

/// The scale of values: logarithmic if their ratios are equal and span much.
fn along_x(axis: &Axis) -> Scale {
    let values: Vec<f64> = axis.values().step_by(step(axis.count(), POINTS)).collect();
    let scale = Scale::around(values.iter().copied());
    let (low, high) = scale.ends();
    let ratios = || values.windows(2).map(|pair| pair[1] / pair[0]);
    let same = ratios().next().is_some_and(|first| ratios().all(|ratio| (ratio / first - 1.0).abs() < 1e-6));
    if low > 0.0 && high / low >= WIDE && values.len() > 2 && same { scale.logarithmic() } else { scale }
}
