//! Interfaces that weights, or a pressure on top, press together: the pressure on them, and the force under which they begin to open.
//!
//! While all is closed a unit pressure on top of long or short waves makes the pressure t_i on interface i, so that the pressure of a punch or a load adds to the weight w_i
//! the sum of all waves of its own transform times t_i.
use std::borrow::Cow;
use std::convert::Infallible;
use std::f64::consts::{PI, SQRT_2};

use crate::field::ContactPressure;
use crate::kernel::Kernel;
use crate::numeric::longest;
use crate::numeric::quadrature::{LARGEST, points, rule};
use crate::numeric::search::{ByDistance, Low, Samples, places};
use crate::numeric::waves::{Waves, fades};
use crate::solution::{ClosedInterface, Interface, Separation, Solution};
use crate::stack::{Dent, Stack};
use crate::system::Unresolved;

/// Steps between places at which pressures are found, over the mean wavelength, or in parts of how far from what presses they are looked at.
const STEP: f64 = 0.125;
const PARTS: f64 = 64.0;
/// Forces are scaled at most so often until the first interface opens.
const SCALINGS: usize = 20;
/// Forces are scaled once more where tension differs from the weight by so much, relative.
const ENOUGH: f64 = 1e-9;
/// Forces grow by no more than this from one scaling to the next.
const FASTEST: f64 = 10.0;
/// Tension is taken to grow no more slowly than like this power of the forces, so that these do not grow beyond all bounds.
const SLOWEST: f64 = 0.2;
/// Tension counts as none below this part of the weight.
const COARSEST: f64 = 1e-9;
/// Parts of a pressure on top that are less than this are none, and waves with a larger product of wavenumber and distance are left out, which do next to nothing where that is large.
const NEGLIGIBLE: f64 = 1e-14;
const MOST_PHASE: f64 = 3e4;
/// Digits of the sums.
const DIGITS: f64 = 15.0;
/// The part of the pressures that rounding and sums leave.
const ROUNDING: f64 = 1e-13;

/// The interfaces of a stack that are pressed together.
#[derive(Clone, Debug)]
pub(crate) struct Weights {
    /// The kernels of openings and of the contacts above them.
    pub(crate) kernel: Kernel,
    /// The interfaces, and the pressure on each.
    pub(crate) interfaces: Vec<(Interface, f64)>,
    /// The interfaces with a dent, by their numbers from 1, and what dents that are pressed flat do to the pressure on each interface; none if there are no dents.
    dents: Vec<(usize, Dent)>,
    pub(crate) by_dents: Vec<Waves>,
    /// How far dents that are pressed flat lower the face below the contact above.
    pub(crate) hollow: Option<Waves>,
}

impl Weights {
    /// Of a stack; `None` if nothing presses its layers together.
    pub(crate) fn of(stack: &Stack) -> Result<Option<Self>, Unresolved> {
        let (above, weights) = (stack.loose(), stack.weights());
        if above == weights.len() {
            return Ok(None);
        }
        let interfaces: Vec<(Interface, f64)> = stack.contacts().into_iter().skip(1).zip(weights).skip(above).collect();
        let dent =
            |(number, (interface, _)): (usize, &(Interface, f64))| Some((number + 1, stack.gaps().dent(*interface)?));
        let dents: Vec<(usize, Dent)> = interfaces.iter().enumerate().filter_map(dent).collect();
        let kernel = Kernel::of_openings(stack)?;
        let own = Self { kernel, interfaces, dents, by_dents: Vec::new(), hollow: None };
        if own.dents.is_empty() {
            return Ok(Some(own));
        }
        let of = |i: usize| own.with_dents(i, Waves::default(), 0.0, 2.0 * own.farthest()).0;
        let (hollow, by_dents) = (Some(of(0)), (1..=own.interfaces.len()).map(of).collect());
        Ok(Some(Self { by_dents, hollow, ..own }))
    }

    /// Whether there is a dent.
    pub(crate) fn has_dents(&self) -> bool {
        !self.dents.is_empty()
    }

    /// The interfaces under what presses on the contact above them, all closed, and where layers would pull most for their weight, of what is even on the right, with the number of that interface, from 1.
    pub(crate) fn under(&self, solution: &Solution) -> (Vec<ClosedInterface>, Option<(usize, [f64; 2])>) {
        let middle = solution.about().unwrap_or(0.0);
        let contact = &solution.contacts()[self.kernel.lowest()];
        let error = self.above_error(solution);
        let is_even = solution.about().is_some() && (middle == 0.0 || !self.has_dents());
        let pressure = ContactPressure::new(contact, is_even, middle);
        let ends: Vec<f64> =
            contact.intervals.iter().flat_map(|own| [own.left, own.right]).map(|end| end - middle).collect();
        let mut tensile = None;
        let mut deepest = 0.0;
        let of = |(i, (interface, weight)): (usize, &(Interface, f64))| {
            let waves = self.by_distance(i + 1, (&pressure, is_even), &ends, middle);
            let [central, _] = waves.near(-middle).at(-middle);
            let (low, tension) = self.least(&waves, *weight, &ends);
            // where one interface opens, others need not
            if let Some(ends) = tension.filter(|_| -low.value > deepest) {
                deepest = -low.value;
                tensile = Some((i + 1, ends.map(|end| end + middle)));
            }
            ClosedInterface {
                interface: *interface,
                weight: *weight,
                central_pressure: weight + central,
                central_pressure_error: error * central.abs() + ROUNDING * weight,
                smallest_pressure: weight + weight * low.value,
                smallest_at: low.place + middle,
                openings: Vec::new(),
                slopes: Vec::new(),
            }
        };
        let closed = self.interfaces.iter().enumerate().map(of).collect();
        (closed, tensile)
    }

    /// When the first interface opens, from a solution, and unless pressures are proportional to forces from others under all forces scaled by a factor, nothing if a punch cannot carry them; `None` if this is not found,
    /// or not before a contact above is so long that layers pull hardly more under more force.
    pub(crate) fn separation<E>(
        &self,
        solution: &Solution,
        is_linear: bool,
        scaled: impl Fn(f64) -> Result<Option<Solution>, E>,
    ) -> Option<Separation> {
        if self.is_open_at_rest() {
            return None;
        }
        // the largest tension over the weight, which has to be 1
        let opens = |solution: &Solution| {
            let all = self.under(solution).0.into_iter();
            let tension = |own: &ClosedInterface| 1.0 - own.smallest_pressure / own.weight;
            all.map(|own| (tension(&own), own)).max_by(|(a, _), (b, _)| a.total_cmp(b))
        };
        let (mut factor, mut power, (mut tension, mut own)) = (1.0, 1.0, opens(solution)?);
        let (mut below, mut above) = (0.0, f64::INFINITY);
        let reach = |solution: &Solution| solution.contacts()[self.kernel.lowest()].reach();
        let (mut last, longest) = (Cow::Borrowed(solution), self.farthest().max(reach(solution)));
        for _ in 0..SCALINGS {
            let (missed, error) = ((tension - 1.0).abs(), self.above_error(&last));
            if tension > 0.0 && (is_linear || missed < error.max(ENOUGH)) {
                let critical_force = factor * tension.powf(-1.0 / power) * solution.force();
                // more than a secant leaves of what is missed
                let relative = if is_linear { error } else { error + missed };
                let critical_force_error = relative * critical_force;
                return Some(Separation {
                    critical_force,
                    critical_force_error,
                    interface: own.interface,
                    x: own.smallest_at,
                });
            }
            if tension <= 0.0 || tension < 1.0 && reach(&last) > longest {
                return None;
            }
            if tension < 1.0 {
                below = factor
            } else {
                above = factor
            }
            // tension grows like a power of the forces, which the last two of them tell
            let expected = (factor * tension.powf(-1.0 / power)).min(FASTEST * factor);
            let next = if below < expected && expected < above { expected } else { (below * above).sqrt() };
            // a punch may not carry as much
            let Some(solution) = scaled(next).ok()? else {
                above = next;
                continue;
            };
            last = Cow::Owned(solution);
            let before = (factor, tension);
            factor = next;
            (tension, own) = opens(&last)?;
            let grows = (tension / before.1).ln() / (factor / before.0).ln();
            power = grows.max(SLOWEST);
        }
        None
    }

    /// Whether a dent is too deep for the weights to press it flat while nothing else presses.
    fn is_open_at_rest(&self) -> bool {
        let pulls = |(waves, (_, weight)): (&Waves, &(Interface, f64))| {
            let all = ByDistance::of(waves.clone());
            self.least(&all, *weight, &[0.0]).1.is_some()
        };
        self.by_dents.iter().zip(&self.interfaces).any(pulls)
    }

    /// The relative error of what presses on the contact above.
    fn above_error(&self, solution: &Solution) -> f64 {
        let error = solution.contacts()[self.kernel.lowest()].end_error();
        ROUNDING + if error.is_finite() { error } else { 0.0 }
    }

    /// How far from what presses pressures are looked at, in the unit of the scene.
    fn farthest(&self) -> f64 {
        self.kernel.length() * self.kernel.farthest()
    }

    /// The number of the coupling of two interfaces, or of one with the contact above them, which counts as 0.
    fn coupling(&self, i: usize, j: usize) -> Option<usize> {
        let [own, other] = [i, j].map(|number| self.kernel.lowest() + number);
        self.kernel.neighbours(own).find(|(there, _)| *there == other).map(|(_, pair)| pair)
    }

    /// The waves of the pressure on interface i about a middle, under what presses above, which has these ends.
    fn by_distance(
        &self,
        i: usize,
        pressure: (&ContactPressure, bool),
        ends: &[f64],
        middle: f64,
    ) -> ByDistance<Waves> {
        let pressed = longest(ends.iter().copied());
        let Ok(all) = ByDistance::new(self.farthest(), pressed, |distance| {
            let (waves, is_whole) = self.waves(i, pressure, distance + 2.0 * pressed);
            let (waves, is_all) = self.with_dents(i, waves, middle, distance + pressed);
            Ok::<_, Infallible>((waves, is_whole && is_all))
        });
        all
    }

    /// The waves of the pressure on interface i that what presses above makes, at places as far as this from its ends, and whether none are left out that matter nearer to it.
    fn waves(&self, i: usize, (pressure, is_even): (&ContactPressure, bool), reach: f64) -> (Waves, bool) {
        let (kernel, is_round) = (&self.kernel, self.kernel.geometry().is_axisymmetric());
        let length = kernel.length();
        let pair = self.coupling(0, i).unwrap_or_default();
        // a wave at the farthest place looked at, times the transform of a pressure at the farthest end
        let reach = reach / length;
        let last = MOST_PHASE / reach;
        let (mut zeta, mut weights, mut is_whole) = (Vec::new(), Vec::new(), true);
        for panel in kernel.panels.iter().filter(|panel| panel.couplings[pair] > NEGLIGIBLE) {
            is_whole &= panel.to <= last;
            if panel.from >= last {
                break;
            }
            let to = panel.to.min(last);
            let needed = points(reach * (to - panel.from), DIGITS);
            let parts = needed.div_ceil(LARGEST);
            let at = |k: usize| panel.from + (to - panel.from) * k as f64 / parts as f64;
            for part in 0..parts {
                let nodes = rule(needed.div_ceil(parts)).on(at(part), at(part + 1));
                let passed = nodes.map(|(zeta, weight)| (zeta, weight * kernel.coupling(pair, zeta)));
                passed.for_each(|(wave, weight)| {
                    zeta.push(wave / length);
                    weights.push(weight / length);
                });
            }
        }
        // an abrupt end would be seen far away
        if !is_whole {
            zeta.iter().zip(&mut weights).for_each(|(wave, weight)| *weight *= fades(*wave, last / length));
        }
        let transforms = pressure.transforms(&zeta);
        let measure = |wave: f64| if is_round { wave } else { PI.recip() };
        let factors: Vec<f64> = zeta.iter().zip(&weights).map(|(wave, weight)| weight * measure(*wave)).collect();
        let even = factors.iter().zip(&transforms).map(|(factor, transform)| factor * transform.value.re).collect();
        // of what is even the imaginary parts mean nothing
        let odd = factors.iter().zip(&transforms).map(|(factor, transform)| factor * transform.value.im);
        let odd = if is_even { vec![0.0; factors.len()] } else { odd.collect() };
        (Waves { wavenumbers: zeta, amplitudes: [even, odd], is_even, is_round }, is_whole)
    }

    /// Waves about a middle on interface i with what dents that are pressed flat add: to take away the slope of a gap g makes the pressure μ₀M ĝ', with ĝ' = −λĝ, and lowers the face
    /// of contact 0 by t ĝ. Whether none are left out that matter nearer to the middle.
    fn with_dents(&self, i: usize, mut waves: Waves, middle: f64, reach: f64) -> (Waves, bool) {
        let (kernel, length, mut is_whole) = (&self.kernel, self.kernel.length(), true);
        for (number, dent) in &self.dents {
            let (pair, own) = (self.coupling(i, *number), kernel.lowest() + i);
            let response = |zeta: f64| match pair {
                Some(pair) => kernel.coupling(pair, zeta),
                None => kernel.asymptote(own).limit + kernel.remainder(own, zeta),
            };
            let shortest = length * dent.shortest();
            let last = shortest.min(MOST_PHASE * length / (reach + 2.0 * dent.half_width));
            // an abrupt end would be seen far away
            let fades = |zeta: f64| if last < shortest { fades(zeta, last) } else { 1.0 };
            is_whole &= last == shortest;
            let panels = kernel.panels.iter().map(|panel| [panel.from, panel.to]).filter(|[from, _]| *from < last);
            let panels: Vec<[f64; 2]> = panels.map(|[from, to]| [from, to.min(last)]).collect();
            let beyond = panels.iter().map(|[_, to]| *to).fold(0.0, f64::max);
            let count = ((last - beyond) / (length / dent.half_width)).ceil() as usize;
            let part = |k: usize| beyond + (last - beyond) * k as f64 / count as f64;
            for [from, to] in panels.into_iter().chain((0..count).map(|k| [part(k), part(k + 1)])) {
                let needed = points((reach + 2.0 * dent.half_width) / length * (to - from), DIGITS);
                let parts = needed.div_ceil(LARGEST);
                let at = |k: usize| from + (to - from) * k as f64 / parts as f64;
                for (zeta, weight) in (0..parts).flat_map(|k| rule(needed.div_ceil(parts)).on(at(k), at(k + 1))) {
                    let wave = zeta / length;
                    let of_gap = if i == 0 { 1.0 } else { -kernel.modulus() * wave };
                    let amplitude = of_gap / PI * response(zeta) * dent.transform(wave) * fades(zeta) * weight / length;
                    let (sin, cos) = (wave * middle).sin_cos();
                    waves.wavenumbers.push(wave);
                    waves.amplitudes[0].push(amplitude * cos);
                    waves.amplitudes[1].push(-amplitude * sin);
                }
            }
        }
        (waves, is_whole)
    }

    /// Where the pressure that waves add is least, in parts of a weight, and from where to where layers come apart about that if this is more tension than the weight is pressure.
    fn least(&self, all: &ByDistance<Waves>, weight: f64, ends: &[f64]) -> (Low, Option<[f64; 2]>) {
        let (farthest, nearest) = (self.farthest(), all.near(0.0));
        let from = if nearest.is_even { 0.0 } else { ends[0] - farthest };
        let shortest = (STEP * 2.0 * PI / nearest.mean_wavenumber()).min(farthest / PARTS);
        let of = |waves: &Waves, places: &[f64]| places.iter().map(|x| waves.at(*x)[0] / weight).collect();
        let of = |places: &[f64]| all.values(places, of);
        let places = places([from, ends[ends.len() - 1] + farthest], ends, shortest);
        let mut samples = Samples::new(places, of, |_| true);
        let low = samples.lowest(of, |_| true);
        // a short opening is √2 as long as the pressure over it would be tension; where layers pull elsewhere is seen once they are apart here
        let opens = low.value < -(1.0 + COARSEST);
        let wider = |end: f64| low.place + SQRT_2 * (end - low.place);
        (low, opens.then(|| samples.below(-1.0, &low).map(wider)))
    }
}
