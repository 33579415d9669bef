//! One level of refinement: half-lengths, pressures, and how far they may be from the truth.
use std::f64::consts::PI;

use crate::kernel::Kernel;
use crate::numeric;

use crate::contact::ends::converged::Converged;
use crate::contact::equations::assemble::Rows;
use crate::contact::integrals::layout::Layout;
use crate::contact::problem::modes::{Modes, SAFETY, beyond, order, weight};
use crate::contact::problem::profile::{Indentation, Local, continued};

/// What rounding leaves of a half-length, relative: kernels are resolved to 1e-13 of themselves.
const ROUNDING: f64 = 1e-13;
/// No level is judged better than this.
pub(crate) const BEST: f64 = 5.0 * ROUNDING;
/// Pressures under punches that are not smooth are continued with so many modes.
const CONTINUED: usize = 2048;

/// A pressure is taken to be wrong by so many times what half-lengths are.
const PEAKS: f64 = 3.0;

/// Half-lengths with larger relative errors are not known.
pub(crate) const UNKNOWN: f64 = 0.03;

/// The relative error of the half-length of a contact that fades before an end is found.
pub(crate) const ENDLESS: f64 = 1.0;

/// An iteration that leaves more than this was not done.
pub(crate) const LOST: f64 = 1e-6;

/// Half-lengths feel at least this part of what is missing of pressures, whatever the last modes say.
const FELT: f64 = 1e-3;

/// The last modes that tell where a sum of alternating terms ends.
const LAST: usize = 4;

/// Half-lengths and pressures at one level of refinement.
pub(crate) struct Level {
    /// Half-lengths in units of L.
    pub(crate) half_lengths: Vec<f64>,
    /// y_im of contact i, y_i0 = 1, see [`super::galerkin`]; under a punch that is not smooth continued by what it does to
    /// a half-plane.
    pub(crate) modes: Modes,
    /// q, the amplitude of the pressure next to the corners of the punch; 0 if there are none.
    pub(crate) corners: f64,
    /// The mode y_m, the same for all m, of a half-plane under a sharp tip; 0 if there is none.
    pub(crate) tip: f64,
    /// How many of them were found.
    pub(crate) counts: Vec<usize>,
    /// Σ y_m/(πj), p(0) a/(2 μ₀P'), per contact; infinite under a sharp tip.
    pub(crate) peaks: Vec<f64>,
    /// Whether the iteration was done with the modes.
    pub(crate) settled: Vec<bool>,
    /// Relative errors of half-lengths and of pressures at x = 0, estimated.
    pub(crate) errors: Vec<[f64; 2]>,
    /// The larger of both as far as more modes of the contact itself would make it smaller.
    pub(crate) own_errors: Vec<f64>,
    /// What may depend on the end of each contact that fades, see [`super::fading`], relative.
    pub(crate) faded: Vec<Option<f64>>,
    /// Part of the highest modes in the pressure of a contact.
    pub(crate) tails: Vec<f64>,
    /// A layout, and the slope transforms of all contacts there.
    pub(crate) waves: Option<(Layout, Vec<Rows>)>,
    /// Under a punch that is not smooth, or has corners, the higher half of what its modes have besides those of a half-plane, the lower
    /// half being 0.
    pub(crate) rest: Option<Vec<f64>>,
}

impl Level {
    /// Errors are judged by what the iterated modes have changed, and by how fast the highest of them fall, less those
    /// that a half-plane would have under a punch that is not smooth: these are known, however slowly they fall.
    /// Parts of the kernels below `negligible` were left out.
    pub(crate) fn new(found: Converged, kernel: &Kernel, punch: &Indentation, negligible: f64) -> Self {
        let Converged { half_lengths, mut modes, corners, solved, shift, whole, unsettled, faded, waves, .. } = found;
        let counts: Vec<usize> = modes.iter().map(Vec::len).collect();
        let local = if punch.given().is_some() {
            None
        } else {
            punch.local(half_lengths[0], kernel.far(0).limit, CONTINUED.max(counts[0]))
        };
        let (mut errors, mut tails, mut settled, mut peaks) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let mut rest = None;
        // by how much more than the last ones the modes that are missing may change, and by how much at most
        let mut further = vec![[0.0; 2]; modes.len()];
        let mut arithmetic = vec![0.0; modes.len()];
        // what is missing of a pressure, as its neighbours feel it: not averaged
        let mut unheard = vec![0.0; modes.len()];
        for (i, y) in modes.iter().enumerate() {
            let local = local.as_ref().filter(|_| i == 0);
            let own = without(y, local);
            // where modes fall like a power, the terms of the pressure at x = 0 are averaged
            let averaged = !kernel.far(i).is_constant();
            let iterated = weight(&own, solved[i]..own.len());
            let (beyond, fall) = beyond(&own);
            let peak = peak(&own, averaged) + local.map_or(0.0, |local| local.peak)
                - corners.filter(|_| i == 0).map_or(0.0, |corners| 0.5 * corners / PI);
            // an infinite pressure is known, and others are judged by that of a mean pressure
            let size = if peak.is_finite() { peak.abs() } else { PI.recip() };
            // half-lengths feel what is missing squared, and no more than pressures do; but where a known load falls
            // slowly, only what it meets of the kernels falls fast, and contacts that are tied together feel no less
            let power = if local.is_some() || whole[i] { 1 } else { 2 };
            further[i] = [(beyond / iterated.max(f64::MIN_POSITIVE)).powi(power), beyond / (PI * size)];
            let beyond_length = (shift[i].abs() * further[i][0]).min(further[i][1]);
            let missing = if averaged {
                // an averaged sum is as good as the next one differs from it
                let change = (self::peak(&own[..own.len() * 3 / 4], true) - self::peak(&own, true)).abs();
                (change * SAFETY * fall).min(beyond / PI)
            } else {
                beyond / PI
            };
            // a pressure that is infinite cannot be missed
            let pressure = if peak.is_finite() { (missing + unsettled[i][1] / PI) / size } else { 0.0 };
            unheard[i] = if averaged { largest(&own, own.len().saturating_sub(LAST)) / PI } else { beyond / PI };
            arithmetic[i] = negligible + ROUNDING;
            // the modes of a punch that is not smooth fall slowly, but it is known how
            let felt = if local.is_some() { 0.0 } else { FELT * pressure };
            // and of an end that was left where it is, only what depends on it matters
            let length = faded[i].map_or(beyond_length + unsettled[i][0] + felt, |faded| faded.felt) + arithmetic[i];
            errors.push([length, pressure + 3.0 * arithmetic[i]]);
            let still = !peak.is_finite() || unsettled[i][1] < 0.1 * pressure * size * PI;
            settled.push(unsettled[i][0] < 0.1 * length && still);
            // compared with that of a mean pressure where there is hardly any in the middle
            tails.push(weight(&own, own.len() / 2..own.len()) / (PI * size).max(1.0));
            peaks.push(peak);
            if local.is_some() || corners.is_some() && i == 0 {
                let half = own.len() / 2;
                rest = Some([vec![0.0; half], own[half..].to_vec()].concat());
            }
        }
        // contacts that are tied together feel what each of them misses as they felt what it missed before
        for run in (0..errors.len()).collect::<Vec<_>>().chunk_by(|i, k| whole[*i] && whole[*k]) {
            let most = |k: usize| numeric::largest(run.iter().map(|i| further[*i][k]));
            for i in run.iter().filter(|_| run.len() > 1) {
                errors[*i][0] = errors[*i][0].max((shift[*i].abs() * most(0)).min(most(1)));
            }
        }
        let given = usize::from(punch.given().is_some());
        if given > 0 {
            // nothing of it is unknown
            (errors[0], tails[0], settled[0]) = ([0.0; 2], 0.0, true);
        }
        let lengths: Vec<f64> = errors.iter().map(|[length, _]| *length).collect();
        // an end that was left where it is may be anywhere; as the pressure fades, so does what depends on it
        let first: Vec<f64> =
            lengths.iter().zip(&faded).map(|(length, faded)| faded.map_or(*length, |faded| faded.decay)).collect();
        // how far half-lengths feel others, and how far pressures do: no less, unless a half-length is not known at all
        let by_length = |i: usize, k: usize| if i == k { 1.0 } else { found.influences.lengths[i][k].min(1.0) };
        let by_peak = |i: usize, k: usize| {
            let felt = found.influences.peaks[i][k].min(1.0);
            let unknown = if i == k { lengths[k] > UNKNOWN } else { first[k] > UNKNOWN || faded[k].is_some() };
            if unknown { felt } else { felt.max(by_length(i, k)) }
        };
        // what contact k misses of its pressure is a load on the other side of the laminate between them
        let passed_on = |i: usize, k: usize| {
            let last = 2.0 * modes[k].len() as f64 / half_lengths[k];
            let heard = (kernel.coupling(i.min(k), last).abs() / kernel.far(i).limit).min(1.0);
            let size = if peaks[i].is_finite() { peaks[i].abs() } else { PI.recip() };
            heard * unheard[k] * half_lengths[i] / (half_lengths[k] * size)
        };
        // what rounding does to pressures comes by way of the half-lengths
        let rounding = &found.influences.rounding;
        let by_rounding = |i: usize| {
            let felt = found.influences.peaks[i].iter().zip(rounding).map(|(felt, rounding)| felt.min(1.0) * rounding);
            PEAKS * felt.fold(rounding[i].min(ROUNDING), f64::max)
        };
        let others = |i: usize, feels: &dyn Fn(usize, usize) -> f64, lengths: &[f64]| {
            numeric::largest((0..lengths.len()).filter(|k| *k != i).map(|k| feels(i, k) * lengths[k]))
        };
        let passed: Vec<f64> = (0..lengths.len()).map(|i| first[i].max(others(i, &by_length, &first))).collect();
        let mut own_errors = Vec::with_capacity(errors.len());
        for (i, error) in errors.iter_mut().enumerate() {
            error[1] += PEAKS * by_peak(i, i) * lengths[i];
            // no modes help against rounding
            let arithmetic = arithmetic[i];
            own_errors.push((error[0] - arithmetic).max(error[1] - (3.0 + PEAKS) * arithmetic));
        }
        for (i, error) in errors.iter_mut().enumerate() {
            error[0] += rounding[i];
            error[1] += by_rounding(i);
            for k in [i.wrapping_sub(1), i + 1].into_iter().filter(|k| i.min(*k) >= given && *k < modes.len()) {
                let passed_on = passed_on(i, k);
                error[1] += passed_on;
                own_errors[k] = own_errors[k].max(passed_on);
            }
            if i >= given {
                error[1] += PEAKS * others(i, &by_peak, &passed);
                if faded[i].is_none() {
                    error[1] += PEAKS * by_peak(i, i) * (passed[i] - first[i]);
                }
                error[0] += others(i, &by_length, &passed);
            }
        }
        for (error, _) in errors.iter_mut().zip(&faded).filter(|(_, faded)| faded.is_some()) {
            error[0] = ENDLESS;
        }
        if corners.is_some() {
            // the half-length is that of the punch
            errors[0][0] = 0.0;
        }
        let tip = local.as_ref().filter(|_| punch.is_sharp()).map_or(0.0, |local| local.modes[0]);
        if let (Some(local), Some(under_punch)) = (&local, modes.first_mut()) {
            continued(under_punch, &local.modes);
        }
        let corners = corners.unwrap_or(0.0);
        Self {
            half_lengths,
            modes,
            corners,
            tip,
            counts,
            peaks,
            settled,
            errors,
            own_errors,
            faded: faded.iter().map(|faded| faded.map(|faded| faded.felt)).collect(),
            tails,
            waves,
            rest,
        }
    }

    /// Where the iteration was not done, nothing is known better than by how much half-lengths differ from those of fewer
    /// modes.
    pub(crate) fn doubt(&mut self, rough: &[f64]) {
        let doubtful = |i: usize| !self.settled[i] && self.faded[i].is_none();
        for (i, errors) in self.errors.iter_mut().enumerate().filter(|(i, _)| doubtful(*i)) {
            let change = (self.half_lengths[i] / rough[i]).ln().abs();
            if errors[0] > LOST {
                errors[0] = errors[0].max(change);
                errors[1] = errors[1].max(change);
                self.own_errors[i] = self.own_errors[i].max(change);
            }
        }
    }

    /// The largest of the error estimates, those of half-lengths that are not known aside.
    pub(crate) fn worst_error(&self) -> f64 {
        let of_contact = |[length, pressure]: &[f64; 2]| {
            if *length > UNKNOWN { *pressure } else { numeric::largest([*length, *pressure]) }
        };
        numeric::largest(self.errors.iter().map(of_contact))
    }
}

/// Modes less those of a half-plane.
fn without(modes: &[f64], local: Option<&Local>) -> Vec<f64> {
    let Some(local) = local else { return modes.to_vec() };
    modes.iter().zip(&local.modes).map(|(y, local)| y - local).collect()
}

/// The largest |y_m|/order from a mode on.
fn largest(modes: &[f64], from: usize) -> f64 {
    numeric::largest((from..modes.len()).map(|m| weight(modes, m..m + 1)))
}

/// p(0) a/(2 μ₀P'), Σ y_m/(πj). Next to a graded face the terms fall like ± j⁻⁴, alternating, since the pressure
/// has a logarithm at its ends: the last partial sums are averaged, which leaves little of what is missing.
fn peak(modes: &[f64], averaged: bool) -> f64 {
    const AVERAGED: [f64; 6] = [63.0 / 64.0, 57.0 / 64.0, 42.0 / 64.0, 22.0 / 64.0, 7.0 / 64.0, 1.0 / 64.0];
    let last = if averaged { modes.len().saturating_sub(AVERAGED.len()) } else { modes.len() };
    let terms = modes.iter().enumerate().map(|(m, y)| {
        let weight = m.checked_sub(last).map_or(1.0, |k| AVERAGED[k]);
        weight * y / order(m)
    });
    terms.sum::<f64>() / PI
}
