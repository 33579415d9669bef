//! The planes of the picture of a sweep: for each contact its extent and its largest pressure, as curves or as maps.
use super::names::{Dimension, of_contact, symbols, unit};
use super::scale::Scale;
use crate::axis::Axis;
use crate::solution::Contact;
use crate::sweep::{Sweep, SweepPoint};

/// Most contacts that have a column.
pub(super) const CONTACTS: usize = 6;
/// Values of equal ratio over at least such a range are drawn so.
const WIDE: f64 = 8.0;

/// One plane of the picture: a column of numbers of one contact.
pub(super) struct SweepPlane {
    /// Which contact, and how far right and down the plane is.
    pub(super) what: String,
    pub(super) place: [usize; 2],
    /// The column of the numbers.
    pub(super) column: usize,
    pub(super) label: String,
    pub(super) unit: Option<String>,
}

/// Two planes for each contact: how far it reaches, and its largest pressure, or the pressure at x = 0 where the largest is infinite.
pub(super) fn planes(sweep: &Sweep, points: &[SweepPoint]) -> Vec<SweepPlane> {
    let scene = sweep.scene();
    let contacts: Vec<_> = sweep.contacts().collect();
    let symbols = symbols(contacts.iter().map(|(interface, _)| *interface));
    let mut planes = Vec::new();
    for (i, ((interface, punch), (length, pressure))) in contacts.iter().zip(&symbols).enumerate().take(CONTACTS) {
        let column = |name: &str| {
            let of_contact = Contact::COLUMNS.iter().position(|column| *column == name).unwrap_or(0);
            sweep.axes().len() + Contact::COLUMNS.len() * i + of_contact
        };
        let known = |column: usize| points.iter().filter(move |point| number(point, column).is_finite());
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
        let what = punch.map_or_else(|| of_contact(scene, *interface), |punch| format!("under punch {}", punch + 1));
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

/// A number of a row; NaN where it has none.
pub(super) fn number(point: &SweepPoint, column: usize) -> f64 {
    point.numbers.get(column).copied().unwrap_or(f64::NAN)
}

/// The least step with which so many are at most so few.
pub(super) fn step(count: usize, most: usize) -> usize {
    count.div_ceil(most).max(1)
}

/// The scale of values: logarithmic if their ratios are equal and span much.
pub(super) fn scale_of(axis: &Axis, most: usize) -> Scale {
    let values: Vec<f64> = axis.values().step_by(step(axis.count(), most)).collect();
    let scale = Scale::around(values.iter().copied());
    let (low, high) = scale.ends();
    let ratios = || values.windows(2).map(|pair| pair[1] / pair[0]);
    let same = ratios().next().is_some_and(|first| ratios().all(|ratio| (ratio / first - 1.0).abs() < 1e-6));
    if low > 0.0 && high / low >= WIDE && values.len() > 2 && same { scale.logarithmic() } else { scale }
}
