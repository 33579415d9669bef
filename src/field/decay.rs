//! The cut-off of sums over wavenumbers: how fields decay with the wavenumber at a depth, and the truncation error.
use std::f64::consts::PI;

use super::Field;
use super::body::{self, DepthRow, PlacedLayer};
use super::pressure::ContactPressure;
use super::surface::Remainder;
use super::waves::{self, Precision};

/// Bisections of the logarithm of a cut-off: 14 take the whole range of doubles to five per cent, more gain nothing.
const HALVINGS: usize = 20;

/// How the fields due to a loaded face decay with the wavenumber, at a distance d from it.
pub(super) struct FieldDecay<'a> {
    /// All fields fall like e^(−λ·distance) at least.
    distance: f64,
    /// Fields that do not come from the face directly fall faster, like e^(−λ·reflected).
    reflected: f64,
    /// The remainder that the closed form leaves of the face; `None` if there is no closed form.
    remainder: Option<Remainder>,
    /// The pressure on the face.
    pressure: &'a ContactPressure,
    /// The length over which the resultant is spread for the mean pressure, with which the truncation error is compared.
    length: f64,
}

impl FieldDecay<'_> {
    /// A bound on the contribution of all waves beyond a wavenumber, in parts of the mean pressure.
    fn truncation(&self, from: f64) -> f64 {
        let reflected = if self.remainder.is_some() { self.reflected } else { self.distance };
        let t = from * reflected;
        // states of layers are like (1 + t)² e^(−t)
        let reflections = (2.0 + t) * (2.0 + t) * (-t).exp() / reflected.max(from.recip());
        self.direct(from) + if reflections > 0.0 { reflections * self.amplitudes(from)[0] } else { 0.0 }
    }

    /// The part of it that comes from the face directly: the remainder that its closed form leaves, and what of the pressure has no closed form.
    fn direct(&self, from: f64) -> f64 {
        let left = self.remainder.filter(|remainder| remainder.size > 0.0);
        if left.is_none() && !self.pressure.has_waves() {
            return 0.0;
        }
        let left = left.map_or(0.0, |Remainder { size, power }| size * from.powf(-power));
        let [all, not_local] = self.amplitudes(from);
        let t = from * self.distance;
        // the integral of an integrand that falls at least like 1/λ
        from * (left * all + not_local) * (1.0 + t) * (1.0 + t) * (-t).exp()
    }

    /// Amplitudes of p̂ at a wavenumber, and of what is not local in it, in parts of the mean pressure, times what an integral over the wavenumber takes.
    fn amplitudes(&self, from: f64) -> [f64; 2] {
        // about an axis J₀(λr) falls like a root or, next to r = 0, the transform oscillates
        let measure = if self.pressure.is_round() { from / (1.0 + from * self.length).sqrt() } else { PI.recip() };
        self.pressure.envelopes(from).map(|one| one * measure / self.pressure.mean(self.length))
    }
}

impl Field {
    /// The decay of fields with the wavenumber at a depth, for the contacts above and below its body; none where closed forms have no
    /// remainder.
    pub(super) fn decays(&self, row: &DepthRow) -> impl Iterator<Item = (usize, FieldDecay<'_>)> {
        let placed = &self.layers[row.layer];
        let (body, depth) = (&self.bodies[placed.body], row.depth);
        let is_outermost = [placed.place == 0, placed.place + 1 == body.layers.len()];
        let of = move |(side, contact): (usize, usize)| {
            let face = body.faces[side].as_ref().filter(|_| is_outermost[side]);
            let pressure = &self.pressures[contact];
            // of a pressure that has waves of its own these are left where closed forms leave nothing
            let shift = face.map_or(0.0, |face| face.shift);
            let shift = if pressure.has_waves() { shift.min(body::thinnest(&self.layers)) } else { shift };
            let shift = Some(shift).filter(|shift| !shift.is_infinite())?;
            let distance = self.distance(placed, depth, side == 0);
            let thickness = placed.slowest * placed.thickness.unwrap_or(f64::INFINITY);
            let decay = FieldDecay {
                distance,
                reflected: (distance + shift).min(2.0 * thickness - distance),
                remainder: face.map(|face| face.remainder),
                pressure,
                length: Some(pressure.half_length.max(shift)).filter(|a| *a > 0.0).unwrap_or(self.length(contact)),
            };
            Some((contact, decay))
        };
        body.contacts().enumerate().filter_map(of)
    }

    /// The wavenumber beyond which fields are negligible, and no sum with places as far out as `farthest` goes; a force that has no length is
    /// cut off at the places.
    pub(super) fn end(&self, contact: usize, decay: &FieldDecay, precision: &Precision, farthest: f64) -> f64 {
        let length = Some(self.length(contact)).filter(|length| *length > 0.0).unwrap_or(farthest);
        let most = waves::MOST.min(precision.evaluations / (waves::PER_PHASE * self.layers.len() as f64)) / length;
        let mut hi = (precision.exponent / decay.distance).min(most);
        if decay.remainder.is_none() {
            return hi;
        }
        let tolerance = if decay.distance > 0.0 { precision.inside } else { precision.on_face };
        let mut lo = (precision.exponent / decay.reflected).min(hi);
        if decay.direct(lo) <= tolerance {
            return lo;
        }
        if decay.direct(hi) > tolerance {
            return hi;
        }
        for _ in 0..HALVINGS {
            if hi <= 1.05 * lo {
                break;
            }
            let middle = (lo * hi).sqrt();
            if decay.direct(middle) > tolerance { lo = middle } else { hi = middle }
        }
        hi
    }

    /// A bound on the truncation error of the sums over wavenumbers in the stresses at a point of a row.
    pub(super) fn truncation(&self, row: &DepthRow, x: f64, precision: &Precision) -> f64 {
        let of = |(contact, decay): (usize, FieldDecay)| {
            let end = self.end(contact, &decay, precision, x.abs());
            // waves shorter than the distance from where the pressure is not smooth cancel
            let cancelled = (end * self.pressures[contact].distance(x)).recip().min(1.0);
            decay.truncation(end) * decay.pressure.mean(decay.length) * cancelled
        };
        self.decays(row).map(of).sum()
    }

    /// The distance of the loaded face above or below a depth, in lengths over which fields decay by e at λ = 1.
    fn distance(&self, placed: &PlacedLayer, depth: f64, above: bool) -> f64 {
        let within = if above { depth } else { (placed.thickness.unwrap_or(f64::INFINITY) - depth).max(0.0) };
        let layers = &self.layers[self.bodies[placed.body].layers.clone()];
        let between = if above { &layers[..placed.place] } else { &layers[placed.place + 1..] };
        let between = between.iter().map(|other| other.slowest * other.thickness.unwrap_or(f64::INFINITY));
        between.sum::<f64>() + placed.slowest * within
    }

    /// Half-length of a contact. A line load has none: in its place the half-length of the longest contact or, under line loads alone, the thickness of
    /// what lies on the base; 0 on a half-plane, where no length occurs.
    pub(super) fn length(&self, contact: usize) -> f64 {
        let lengths = [self.pressures[contact].half_length, self.longest(), self.thickness()];
        lengths.into_iter().find(|length| *length > 0.0).unwrap_or(0.0)
    }

    /// Half-length of the longest contact; 0 under line loads alone.
    pub(super) fn longest(&self) -> f64 {
        self.pressures.iter().fold(0.0, |a, pressure| a.max(pressure.half_length))
    }

    /// Thickness of all layers together, without a half-plane.
    pub(super) fn thickness(&self) -> f64 {
        // an empty sum would be -0
        self.layers.iter().filter_map(|placed| placed.thickness).fold(0.0, |sum, h| sum + h)
    }

    /// Half-length of the narrowest strip on the top face that is one.
    pub(super) fn narrowest(&self) -> f64 {
        let strips = self.pressures[0].strips().map(|strip| strip.extent);
        strips.filter(|a| *a > 0.0).fold(self.length(0), f64::min)
    }
}
