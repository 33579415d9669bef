//! How far sums over wavenumbers go: how fields decay with the wavenumber at a depth, and what is left out.
use std::f64::consts::PI;

use super::Field;
use super::body::Stratum;
use super::pressure::Pressure;
use super::sum::Row;
use super::waves::{self, Precision};

/// The whole range of doubles takes 14 halvings of its logarithm to five per cent; with more, nothing is gained.
const HALVINGS: usize = 20;
/// Places are near for which this part of the most wavenumbers will do.
const SURELY: f64 = 0.9;

/// What decays with the wavenumber next to a loaded face, at a distance d from it.
struct Decay<'a> {
    /// Everything falls like e^(−λ·distance) at least.
    distance: f64,
    /// What does not come from the face itself falls faster, like e^(−λ·reflected).
    reflected: f64,
    /// What the closed form leaves of the face itself, size·λ^(−power); `None` if there is no closed form.
    left: Option<[f64; 2]>,
    /// The pressure on the face.
    pressure: &'a Pressure,
    /// Length over which its resultant is spread to be compared with what is left out.
    length: f64,
}

impl Decay<'_> {
    /// The mean pressure, with which what is left out is compared.
    fn mean(&self) -> f64 {
        self.pressure.resultant() / (2.0 * self.length)
    }

    /// What all waves beyond a wavenumber contribute at most, in parts of the mean pressure.
    fn left_out(&self, from: f64) -> f64 {
        let t = from * self.distance;
        let Some([size, power]) = self.left else { return (-t).exp() };
        if size == 0.0 {
            return 0.0;
        }
        // the integral of an integrand that falls at least like 1/λ, over π
        let amplitude = size * from.powf(1.0 - power) * self.pressure.envelope(from) / (PI * self.mean());
        amplitude * (1.0 + t) * (1.0 + t) * (-t).exp()
    }

    /// The wavenumber beyond which fields are negligible; `most` if there is none below.
    fn end(&self, precision: &Precision, most: f64) -> f64 {
        let exponential = precision.felt / self.distance;
        if self.left.is_none() {
            return exponential.min(most);
        }
        let tolerance = if self.distance > 0.0 { precision.inside } else { precision.on_face };
        let (mut lo, mut hi) = ((precision.felt / self.reflected).min(exponential).min(most), exponential.min(most));
        if self.left_out(lo) <= tolerance {
            return lo;
        }
        if self.left_out(hi) > tolerance {
            return hi;
        }
        for _ in 0..HALVINGS {
            if hi <= 1.05 * lo {
                break;
            }
            let middle = (lo * hi).sqrt();
            if self.left_out(middle) > tolerance { lo = middle } else { hi = middle }
        }
        hi
    }
}

impl Field {
    /// How fields decay with the wavenumber at a depth, for the contacts next to its body; `None` where closed forms have no remainder.
    fn decays(&self, row: &Row) -> impl Iterator<Item = (usize, Option<Decay<'_>>)> {
        let stratum = &self.strata[row.stratum];
        let (body, depth) = (&self.bodies[stratum.body], row.depth);
        [true, false].into_iter().enumerate().filter_map(move |(side, above)| {
            if !above && body.bottom.is_none() {
                return None;
            }
            let contact = body.contact + side;
            let own = if above { stratum.place == 0 } else { stratum.place + 1 == body.layers };
            let face = body.faces[side].as_ref().filter(|_| own);
            if face.is_some_and(|face| face.surface.shift.is_infinite()) {
                return Some((contact, None));
            }
            let distance = self.distance(stratum, depth, above);
            let thickness = stratum.slowest * stratum.thickness.unwrap_or(f64::INFINITY);
            let shift = face.map_or(0.0, |face| face.surface.shift);
            let pressure = &self.pressures[contact];
            let decay = Decay {
                distance,
                reflected: (distance + shift).min(2.0 * thickness - distance),
                left: face.map(|face| [face.size, face.power]),
                pressure,
                length: pressure.half_length.max(shift),
            };
            Some((contact, Some(decay)))
        })
    }

    /// The cut-off wavenumbers of a depth for the contacts next to its body, closed forms aside;
    /// no farther than `most` of each contact.
    pub(super) fn ends(
        &self,
        row: &Row,
        precision: &Precision,
        most: impl Fn(usize) -> f64,
    ) -> impl Iterator<Item = (usize, f64)> {
        let end = move |(contact, decay): (usize, Option<Decay>)| {
            (contact, decay.map_or(0.0, |decay| decay.end(precision, most(contact))))
        };
        self.decays(row).map(end)
    }

    /// What sums over wavenumbers leave out of the stresses at a place of a row, at most.
    pub(super) fn left_out(&self, row: &Row, x: f64) -> f64 {
        let of = |(contact, decay): (usize, Option<Decay>)| {
            let Some(decay) = decay else { return 0.0 };
            let length = self.length(contact);
            let end = decay.end(&waves::FULL, waves::most(x.abs() + length));
            // waves shorter than the distance from where the pressure is not smooth cancel
            let cancelled = (end * self.pressures[contact].distance(x)).recip().min(1.0);
            decay.left_out(end) * decay.mean() * cancelled
        };
        self.decays(row).map(of).sum()
    }

    /// How far the loaded face above or below a depth is, in lengths over which fields decay by e at λ = 1.
    fn distance(&self, stratum: &Stratum, depth: f64, above: bool) -> f64 {
        let within = if above { depth } else { (stratum.thickness.unwrap_or(f64::INFINITY) - depth).max(0.0) };
        let between = self.strata.iter().filter(|other| {
            other.body == stratum.body && if above { other.place < stratum.place } else { other.place > stratum.place }
        });
        let between = between.map(|other| other.slowest * other.thickness.unwrap_or(f64::INFINITY));
        between.sum::<f64>() + stratum.slowest * within
    }

    /// Half-length of a contact, or of the longest one in the place of a line load, which has none.
    pub(super) fn length(&self, contact: usize) -> f64 {
        let all = || self.pressures.iter().fold(0.0, |a: f64, pressure| a.max(pressure.half_length));
        Some(self.pressures[contact].half_length).filter(|own| *own > 0.0).unwrap_or_else(all)
    }

    /// The largest x up to which all wavenumbers of a contact below the cut-offs of the rows can be summed; `None` if there are too many even at x = 0.
    pub(super) fn nearest(&self, rows: &[Row], precision: &Precision, contact: usize) -> Option<f64> {
        // without a length no wave is too short
        let length = Some(self.length(contact)).filter(|length| *length > 0.0)?;
        let most = waves::most(length);
        let ends = rows.iter().flat_map(|row| self.ends(row, precision, |_| most)).filter(|(own, _)| *own == contact);
        let end = ends.map(|(_, end)| end).fold(0.0, f64::max);
        // ends are known to some per cent
        (end < most).then(|| SURELY * waves::most(end) - length).filter(|near| *near > 0.0)
    }
}
