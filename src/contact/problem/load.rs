//! Given pressures on top, in place of what a punch would do: their transform is known for any wavenumber.
use std::borrow::Cow;
use std::f64::consts::PI;

use crate::numeric::bessel;
use crate::scene::{Load, Loads};
use crate::solution::{Contact, Form, Interface, Interval, Strip};

use crate::contact::problem::accuracy::ROUNDING;
#[cfg(test)]
use crate::contact::problem::modes::alternating;
use crate::contact::problem::modes::order;
use crate::contact::problem::twin::Twin;

/// Given pressures, even about x = 0, in place of a punch.
pub(crate) struct Given<'a> {
    /// What presses.
    pub(crate) loads: Cow<'a, Loads>,
    /// As far as they reach, or what rounding leaves of L, in units of L: the contacts see loads through their transform, which is exact for
    /// any half-width, and no wave in it is as short as this.
    pub(crate) half_length: f64,
    /// Their moment about x = 0 over their resultant, in units of L.
    pub(crate) moment: f64,
    /// x = 0 is here in the scene, in units of L, which is so long there.
    origin: f64,
    length: f64,
    transform_minus_one: Box<dyn Fn(f64) -> f64 + 'a>,
    odd_transform_less_moment: Box<dyn Fn(f64) -> f64 + 'a>,
}

impl<'a> Given<'a> {
    /// Loads, with places x from an origin in units of L, and the length L in the units of the scene.
    pub(crate) fn new(loads: &'a Loads, origin: f64, length: f64, twin: Twin) -> Self {
        let from = origin * length;
        let even = move |zeta: f64| transform_minus_one(loads, from, zeta / length, twin);
        let odd = move |zeta: f64| odd_transform_less_moment(loads, from, zeta / length, twin);
        let reach =
            loads.parts().fold(0.0, |reach: f64, (load, at, _)| reach.max((at - from).abs() + load.half_width()));
        Self {
            loads: Cow::Borrowed(loads),
            half_length: (reach / length).max(ROUNDING),
            moment: loads.parts().map(|(_, at, share)| share * (at - from) / length).sum(),
            origin,
            length,
            transform_minus_one: Box::new(even),
            odd_transform_less_moment: Box::new(odd),
        }
    }

    /// ∫ p sin ζx dx/P − ζ times the moment at a wavenumber ζ.
    pub(crate) fn odd_transform_less_moment(&self, zeta: f64) -> f64 {
        (self.odd_transform_less_moment)(zeta)
    }

    /// Where each load presses, in units of L, from left to right.
    pub(crate) fn places(&self) -> Vec<[f64; 2]> {
        let from_origin = |x: &f64| x / self.length - self.origin;
        intervals(&self.loads).iter().map(|Interval { left, right, .. }| [left, right].map(from_origin)).collect()
    }

    /// ∫ p cos ζx dx/P − 1 at a wavenumber ζ.
    pub(crate) fn transform_minus_one(&self, zeta: f64) -> f64 {
        (self.transform_minus_one)(zeta)
    }
}

/// ∫ p cos ζx dx/P − 1 of loads, with all its digits also for long waves.
fn transform_minus_one(loads: &Loads, origin: f64, wavenumber: f64, twin: Twin) -> f64 {
    let part = |(load, at, share): (&Load, f64, f64)| {
        let (sin, cos) = (0.5 * wavenumber * (at - origin)).sin_cos();
        // cos λx (1 + transform_minus_one) − 1
        share * (transform_of_one(load, wavenumber, twin) * (cos * cos - sin * sin) - 2.0 * sin * sin)
    };
    loads.parts().map(part).sum()
}

/// ∫ p sin ζx dx/P of loads less λ times their moment, with all its digits also for long waves.
fn odd_transform_less_moment(loads: &Loads, origin: f64, wavenumber: f64, twin: Twin) -> f64 {
    let part = |(load, at, share): (&Load, f64, f64)| {
        let phase = wavenumber * (at - origin);
        share * (phase * bessel::sinc_minus_one(phase) + transform_of_one(load, wavenumber, twin) * phase.sin())
    };
    loads.parts().map(part).sum()
}

/// The even transform less 1 of a load about its middle.
fn transform_of_one(load: &Load, wavenumber: f64, twin: Twin) -> f64 {
    // of (1 − s²)^(n/2)
    let of = |n| bessel::of_order_minus_one(n + twin.lengths, wavenumber * load.half_width());
    match load {
        Load::Line => 0.0,
        Load::Uniform { .. } => of(0),
        Load::Elliptic { .. } => of(1),
        Load::Parabolic { .. } => of(2),
        Load::Ring { radius, half_width } => {
            let disc = |(radius, part): (f64, f64)| part * bessel::jinc_minus_one(wavenumber * radius);
            ring(radius.get(), half_width.get()).into_iter().map(disc).sum::<f64>()
        }
    }
}

/// The discs whose uniform pressures are together one on a ring |r − at| < half_width: radii, and parts of the force.
fn ring(at: f64, half_width: f64) -> [(f64, f64); 2] {
    let [outer, inner] = [at + half_width, (at - half_width).max(0.0)];
    // without cancellation in narrow rings
    let area = if inner > 0.0 { 4.0 * at * half_width } else { outer * outer };
    [(outer, outer * outer / area), (inner, -inner * inner / area)]
}

/// The strips on which loads press with a force, in the units of the scene.
fn strips(loads: &Loads, force: f64, twin: Twin) -> Vec<Strip> {
    let strips = |(load, at, share): (&Load, f64, f64)| -> Vec<Strip> {
        let form = match load {
            Load::Line => Form::Line,
            Load::Uniform { .. } => Form::Uniform,
            Load::Parabolic { .. } => Form::Parabolic,
            Load::Elliptic { .. } => Form::Series,
            Load::Ring { radius, half_width } => {
                let disc = |(radius, part)| round(strip(Form::Uniform, 0.0, radius, 1.0), share * part * force);
                let discs = ring(radius.get(), half_width.get());
                return discs.into_iter().filter(|(radius, _)| *radius > 0.0).map(disc).collect();
            }
        };
        let strip = strip(form, at, load.half_width(), share * force);
        vec![if twin == Twin::Round { round(strip, share * force) } else { strip }]
    };
    loads.parts().flat_map(strips).collect()
}

/// A pressure of a form on a strip, with a resultant.
pub(crate) fn strip(form: Form, at: f64, extent: f64, resultant: f64) -> Strip {
    if form == Form::Line {
        return Strip { at, form, ..Strip::series(extent, vec![resultant]) };
    }
    let unit = 2.0 * resultant / (PI * extent);
    // c_j of 1 and of 1 − s² over the c_1 of the ellipse with the same resultant
    let coefficient = |m: usize| match form {
        Form::Line | Form::Series => unit,
        Form::Uniform => unit / order(m),
        Form::Parabolic => -3.0 * unit / (order(m) * (order(m).powi(2) - 4.0)),
    };
    // 64 are enough wherever a pressure that does not vanish smoothly at its ends has no closed form
    let terms = if matches!(form, Form::Line | Form::Series) { 1 } else { 64 };
    Strip { at, form, ..Strip::series(extent, (0..terms).map(coefficient).collect()) }
}

/// A pressure on a disc.
pub(crate) fn disc(radius: f64, pressure: f64) -> Strip {
    round(strip(Form::Uniform, 0.0, radius, 1.0), PI * radius * radius * pressure)
}

/// The same about the axis: a series of one term, an ellipse, has the resultant; forms are known by it.
fn round(strip: Strip, force: f64) -> Strip {
    let first = if strip.form == Form::Line { force } else { 1.5 * force / (PI * strip.extent.powi(2)) };
    Strip { coefficients: vec![first], is_round: true, ..strip }
}

/// What is said of loads in place of a contact: nothing of it is unknown.
pub(crate) fn contact(loads: &Loads, interface: Interface, force: f64, twin: Twin, about: Option<f64>) -> Contact {
    let (mut strips, intervals) = (strips(loads, force, twin), intervals(loads));
    strips.sort_by(|a, b| a.at.total_cmp(&b.at));
    // in the hole of a ring nothing presses but the rounding of two discs
    let is_loaded = |x: f64| intervals.iter().any(|interval| interval.left <= x && interval.right >= x);
    let middle = about.filter(|x| is_loaded(*x)).map_or(0.0, |x| strips.iter().map(|strip| strip.pressure(x)).sum());
    Contact { resultant: force, ..Contact::new(interface, intervals, strips, about, [middle, 0.0], Vec::new()) }
}

/// Where loads press, from left to right, what overlaps as one.
fn intervals(loads: &Loads) -> Vec<Interval> {
    let ends = |(load, at, _): (&Load, f64, f64)| {
        let [inner, outer] = [load.hole(), load.half_width()];
        let both = [[-outer, -inner], [inner, outer]].map(|[left, right]| [at + left, at + right]);
        if inner > 0.0 { both.to_vec() } else { vec![[at - outer, at + outer]] }
    };
    let mut ends: Vec<[f64; 2]> = loads.parts().flat_map(ends).collect();
    ends.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut intervals: Vec<Interval> = Vec::new();
    for [left, right] in ends {
        match intervals.last_mut().filter(|last| left <= last.right) {
            Some(last) => last.right = last.right.max(right),
            None => intervals.push(Interval::new([left, 0.0], [right, 0.0])),
        }
    }
    intervals
}

#[cfg(test)]
impl Given<'_> {
    /// The pressure Σ c_j sin jφ.
    pub(crate) fn of(half_length: f64, coefficients: &[f64]) -> Self {
        let modes: Vec<f64> =
            coefficients.iter().enumerate().map(|(m, c)| alternating(m) * order(m) * c / coefficients[0]).collect();
        let transform_minus_one = move |zeta: f64| {
            let z = zeta * half_length;
            let orders = 2 * modes.len();
            let mut table = vec![0.0; orders];
            bessel::table(orders, &[z], &mut table);
            let higher = modes.iter().enumerate().skip(1).map(|(m, y)| 2.0 * y * table[2 * m + 1] / z);
            bessel::jinc_minus_one_from(z, table[1]) + higher.sum::<f64>()
        };
        Self {
            loads: Cow::Owned(Load::Line.into()),
            half_length,
            moment: 0.0,
            origin: 0.0,
            length: 1.0,
            transform_minus_one: Box::new(transform_minus_one),
            odd_transform_less_moment: Box::new(|_| 0.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The transform of the strips, which are even together, by their series.
    fn by_series(strips: &[Strip], wavenumber: f64) -> f64 {
        let strip = |strip: &Strip| {
            let transform_minus_one = match strip.form {
                Form::Line => 0.0,
                _ => Given::of(strip.extent, &strip.coefficients).transform_minus_one(wavenumber),
            };
            (wavenumber * strip.at).cos() * strip.resultant() * (1.0 + transform_minus_one)
        };
        strips.iter().map(strip).sum()
    }

    /// Loads with their mirror images, between which the force is shared.
    fn even(loads: &[(Load, f64, f64)]) -> Loads {
        let images = |(load, at, force): &(Load, f64, f64)| [-at, *at].map(|at| (load.clone(), at, 0.5 * force));
        Loads::new(&loads.iter().flat_map(images).collect::<Vec<_>>()).unwrap()
    }

    #[test]
    fn loads_have_the_transforms_of_their_series() {
        let several = [
            (Load::uniform(0.3).unwrap(), 0.0, 1.0),
            (Load::parabolic(0.4).unwrap(), 0.7, 0.5),
            (Load::elliptic(0.1).unwrap(), 0.2, 3.0),
            (Load::Line, 1.1, 0.1),
        ];
        for loads in several.iter().map(|(load, ..)| load.clone().into()).chain([even(&several)]) {
            let strips = strips(&loads, 3.0, Twin::Plane);
            for wavenumber in [1e-6, 0.3, 1.0, 7.0, 30.0] {
                let (found, expected) = (
                    3.0 * (1.0 + transform_minus_one(&loads, 0.0, wavenumber, Twin::Plane)),
                    by_series(&strips, wavenumber),
                );
                assert!((found - expected).abs() < 1e-13, "{loads} at {wavenumber}: {found} {expected}");
            }
        }
    }

    #[test]
    fn long_waves_feel_the_second_moment() {
        let loads = even(&[(Load::uniform(0.1).unwrap(), 0.5, 1.0), (Load::Line, 0.0, 1.0)]);
        let moment = 0.5 * (0.25 + 0.01 / 3.0);
        for wavenumber in [1e-3, 1e-6, 1e-9] {
            let expected = -0.5 * moment * wavenumber * wavenumber;
            assert!(
                (transform_minus_one(&loads, 0.0, wavenumber, Twin::Plane) / expected - 1.0).abs() < 1e-6,
                "{wavenumber}"
            );
        }
    }
}
