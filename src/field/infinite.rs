//! Where stresses are infinite.
use std::f64::consts::PI;

use super::Field;
use super::measure::Measure;
use super::sum::Row;

/// Distances from a singular point, in parts of the narrowest load, at which stresses are compared.
const CLOSE: [f64; 2] = [1e-7, 1e-8];
/// Directions from the face on one side to the face on the other; twice as many change nothing.
const DIRECTIONS: u8 = 16;
/// A stress is infinite if it grows by more than this part between the two: a logarithm grows by a tenth, what is finite by a
/// millionth; and if it is above this part of the largest component, since the others leave rounding.
const GROWS: f64 = 1e-3;

/// Where on the top face a stress is infinite: at a singular point next to which it grows in some direction. The closed forms tell: the rest of
/// the field is finite.
pub(super) fn infinite(field: &Field, measure: Measure) -> Option<f64> {
    let scale = [field.narrowest(0), 1.0].into_iter().find(|length| *length > 0.0)?;
    let grows = |x: f64| {
        let [far, near] = CLOSE.map(|part| next_to(field, measure, x, part * scale));
        near.0 > far.0 * (1.0 + GROWS) && near.0 > GROWS * near.1
    };
    field.pressures.first()?.singular_points().map(|(x, _)| x).filter(|x| grows(*x)).min_by(f64::total_cmp)
}

/// The largest value of a stress at a distance from a place on the top face, and the largest component there.
fn next_to(field: &Field, measure: Measure, x: f64, distance: f64) -> (f64, f64) {
    let of = |k: u8| {
        let (sin, cos) = (PI * f64::from(k) / f64::from(DIRECTIONS)).sin_cos();
        let row = Row { layer: 0, depth: distance * sin, set: 0 };
        let x = field.place(x + distance * cos);
        let point = field.point(x, &row, *field.closed(&row, &[x], false).first()?);
        let size = [point.sigma_xx, point.sigma_yy, point.sigma_xy].into_iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        Some((measure.of(&point), size))
    };
    let all = (0..=DIRECTIONS).filter_map(of);
    all.fold((0.0, 0.0), |(value, size): (f64, f64), found| (value.max(found.0), size.max(found.1)))
}
