//! No pressure may be tension, and no gap penetrated, between the intervals of a contact and beyond them.
use std::f64::consts::PI;

use crate::contact::integrals::layout::{FIELDS, Layout, Lengths, negligible};
use crate::contact::intervals::equations::Equations;
use crate::contact::intervals::newton::Approximation;
use crate::contact::intervals::recontact::{Recontact, recontact};
use crate::contact::intervals::support::{ContactInterval, Parity};
use crate::contact::problem::Problem;
use crate::contact::problem::abel;
use crate::contact::problem::accuracy::{COARSE, ENDLESS, PLACES, SAFETY};
use crate::contact::problem::closed::ClosedPressure;
use crate::contact::problem::twin::Twin;
use crate::numeric::search::Low;
use crate::numeric::trigonometry::{self, sin_cos};
use crate::numeric::vector::{LANES, Lanes, vectorised};

/// Gaps are found from waves up to this multiple of the wavenumber where pressures begin to have tails: shorter ones do next to nothing to them, since what is
/// left falls like ζ^(−5/2). Twice as many: gaps differ in the seventh digit.
const FARTHER: f64 = 2.0;
/// What the check found, per unit of P'.
pub(super) struct Signs {
    /// Smallest pressure in the contacts, and smallest gap outside.
    pub(super) min_pressure: f64,
    pub(super) min_gap: f64,
    /// The tension of each contact about x = 0 for want of terms, as a part of its largest pressure there.
    pub(super) tensions: Vec<f64>,
    /// How far from the ends of each interval pressures are hardly larger than the tension elsewhere, in half-lengths.
    pub(super) ends: Vec<[f64; 2]>,
    /// Intervals with next to no force that are left out.
    pub(super) recontacts: Vec<Recontact>,
    /// Where the smallest pressure on each interface that lies on another one is.
    pub(super) closed: Vec<Low>,
}

/// Where a pressure or a gap is negative.
#[derive(Debug)]
pub(super) enum Fault {
    /// Inside an interval.
    Tension,
    /// Deepest at a place, by how much, and over this interval.
    Penetration { contact: usize, punch: usize, at: f64, depth: f64, over: [f64; 2] },
    /// Too many wavenumbers are needed to tell.
    Unknown,
}

/// Checks the Signorini conditions on a solution with an error, relative; one with fewer terms tells how far gaps are known. Where all is even, penetration that next to
/// no force would remove may be left.
pub(super) fn check(problem: &Problem, level: &Approximation, error: f64, leaves_out: bool) -> Result<Signs, Fault> {
    let mut signs = pressures(problem, level)?;
    // less than an answer is wrong by counts as zero
    let zero = COARSE.max(error);
    let most = if leaves_out { COARSE } else { error };
    // beyond a pressure that decays the gap is as small as the pressure
    let unknown = level.unknown();
    let decays = |contact: usize| {
        let mut own = level.support.0.iter().zip(&unknown).filter(|(interval, _)| interval.contact == contact);
        own.any(|(_, ends)| ends.contains(&ENDLESS))
    };
    let opens = |contact: &usize| !problem.is_opened(*contact) && !decays(*contact);
    let open: Vec<usize> = problem.unknown().filter(opens).collect();
    if open.is_empty() {
        return Ok(signs);
    }
    let mut lengths = Lengths::of(problem, &level.support, &level.counts, negligible(FIELDS));
    lengths.turned.iter_mut().for_each(|turned| *turned *= FARTHER);
    lengths.exponentials.iter_mut().for_each(Vec::clear);
    let span = problem.span(&lengths.ends);
    let layout = Layout::new(problem.kernel, &lengths, negligible(FIELDS), span);
    let layout = layout.ok_or(Fault::Unknown)?;
    let own = Gaps::new(problem, &layout, level);
    for contact in open {
        for beside in beside(problem, level.support.of(contact), contact, span) {
            let gaps = own.beside(contact, &beside);
            let widest = gaps.iter().fold(0.0, |widest: f64, (_, gap)| widest.max(gap.abs()));
            let least = gaps.iter().copied().min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or_default();
            signs.min_gap = signs.min_gap.min(least.1);
            if least.1 >= -zero * widest {
                continue;
            }
            let coarse = level.coarse();
            let before = Gaps::new(problem, &layout, &coarse).beside(contact, &beside);
            let known = gaps.iter().zip(before).fold(0.0, |most: f64, ((_, a), (_, b))| most.max((a - b).abs()));
            let allowed = zero * widest + SAFETY * known;
            let penetrates = |gap: f64| gap < -allowed;
            if penetrates(least.1) {
                let recontact = recontact(problem.kernel, contact, &lengths.ends, &gaps, allowed);
                if let Some(recontact) = recontact.filter(|own| problem.is_even() && own.moment <= most) {
                    signs.recontacts.push(recontact);
                    continue;
                }
                let mut all: Vec<f64> = gaps.iter().filter(|(_, gap)| penetrates(*gap)).map(|(x, _)| *x).collect();
                all.sort_by(f64::total_cmp);
                let over = [all[0], all[all.len() - 1]];
                return Err(Fault::Penetration { contact, punch: beside.0, at: least.0, depth: -least.1, over });
            }
        }
    }
    Ok(signs)
}

/// Looks for tension in all intervals; what is said of gaps is to be found.
fn pressures(problem: &Problem, level: &Approximation) -> Result<Signs, Fault> {
    let count = problem.contacts();
    let mut smallest = vec![0.0f64; count];
    // about the middle, where pressures are said to be right to a part of what they are there
    let (mut tensions, mut ends) = (vec![0.0f64; count], Vec::new());
    for (number, (interval, pressure)) in level.support.0.iter().zip(&level.solved.pressures).enumerate() {
        let inside = level.inside(problem, number, pressure);
        let extremes = |(least, most): (f64, f64), p: &f64| (least.min(*p), most.max(*p));
        let (least, most) = inside.iter().fold((0.0, 0.0), extremes);
        let contact = interval.contact;
        if interval.opens {
            ends.push([0.0; 2]);
            if least < -COARSE * most {
                return Err(Fault::Tension);
            }
            continue;
        }
        smallest[contact] = smallest[contact].min(least);
        if interval.is_even() {
            tensions[contact] = -least / most;
        }
        ends.push(unseen(interval, &inside, -SAFETY * least));
    }
    // more tension than that belongs to another root, however badly its ends are known: where intervals that ought to be apart meet, the
    // ends of the gap between them are no better known than that it is short
    if smallest.iter().enumerate().any(|(contact, least)| *least < -COARSE * level.mean_pressure(contact)) {
        return Err(Fault::Tension);
    }
    let min_pressure = smallest.into_iter().fold(0.0, f64::min);
    Ok(Signs { min_pressure, min_gap: 0.0, tensions, ends, recontacts: Vec::new(), closed: Vec::new() })
}

/// How far from the left and the right end pressures, from the right end inwards, are no larger than so much, in half-lengths; nothing at corners, or where
/// bodies do not pull.
fn unseen(interval: &ContactInterval, inside: &[f64], least: f64) -> [f64; 2] {
    let places = if interval.is_even() { 2 * inside.len() } else { inside.len() + 1 };
    let of = |first: Option<usize>| match first {
        Some(0) => 0.0,
        Some(first) => 1.0 - (PI * (first + 1) as f64 / places as f64).cos(),
        None => 1.0,
    };
    let [left, right] = interval.corners;
    let from_left = || of(inside.iter().rev().position(|p| *p > least));
    let from_right = || of(inside.iter().position(|p| *p > least));
    let is_known = |corner: bool| corner || least <= 0.0;
    [
        if is_known(left || interval.is_even()) { 0.0 } else { from_left() },
        if is_known(right) { 0.0 } else { from_right() },
    ]
}

/// From the ends of intervals to the next ones, and to the middle of what is even, or as far as gaps are looked at, with the number of the punch.
fn beside(problem: &Problem, intervals: &[ContactInterval], contact: usize, span: f64) -> Vec<(usize, [f64; 2])> {
    let groups: Vec<&[ContactInterval]> = intervals.chunk_by(|a, b| a.punch == b.punch).collect();
    let mut all = Vec::new();
    for (k, group) in groups.iter().enumerate() {
        let ([first, ..], [.., last]) = (group, group) else { continue };
        let [left, right] = problem.sides[contact].ends_of(first.punch);
        // half of the way to the next punch
        let half = |a: &[ContactInterval], b: &[ContactInterval]| {
            a.last().zip(b.first()).map(|(a, b)| 0.5 * (a.to() + b.from()))
        };
        let before = k.checked_sub(1).and_then(|before| half(groups[before], group)).unwrap_or(-span);
        let after = groups.get(k + 1).and_then(|next| half(group, next)).unwrap_or(span);
        let inwards = if first.parity == Parity::None { before.max(left) } else { 0.0 };
        // between two intervals from both ends to the middle
        let between = group.windows(2).flat_map(|pair| {
            let ends = [pair[0].to(), pair[1].from()];
            ends.map(|end| [end, 0.5 * (ends[0] + ends[1])])
        });
        let outside = [[first.from(), inwards], [last.to(), after.min(right)]];
        // there is no punch beyond a corner
        let corners = [first.corners[0], last.corners[1]];
        let outside = outside.into_iter().zip(corners).filter(|([from, to], is_corner)| from != to && !is_corner);
        let outside = outside.map(|(ends, _)| ends);
        all.extend(between.chain(outside).map(|ends| (first.punch, ends)));
    }
    all
}

/// The gaps that a solution leaves.
pub(super) struct Gaps<'a> {
    equations: Equations<'a>,
    level: &'a Approximation,
    /// The slopes of waves outside each contact, both parts of exp(iζx).
    waves: Vec<[Vec<f64>; 2]>,
}

impl<'a> Gaps<'a> {
    pub(super) fn new(problem: &'a Problem<'a>, layout: &'a Layout, level: &'a Approximation) -> Self {
        let mut equations = Equations::new(problem, layout, &level.support, &level.counts);
        equations.keeps = 0;
        let none = |contact: usize| [0, 1].map(|_| vec![0.0; layout.own[contact].reach]);
        let mut waves: Vec<_> = (0..problem.contacts()).map(none).collect();
        let amplitudes = equations.told_amplitudes(&level.solved.pressures);
        equations.responses(&[amplitudes], |[_, contact], nodes, _, response| {
            // where all is even an interface that opens, or may do so, has the odd part
            let first = usize::from(!equations.moves && problem.is_opened(contact));
            for (part, values) in (first..).zip(response.chunks(nodes.len().max(1))) {
                waves[contact][part][nodes.clone()].copy_from_slice(values);
            }
        });
        Self { equations, level, waves }
    }

    /// The pressure on an interface under weight at places outside openings, from its pressure while nothing else presses.
    pub(super) fn pressures(&self, contact: usize, pressed: &ClosedPressure, places: &[f64]) -> Vec<f64> {
        let (Equations { layout, columns, .. }, [even, odd]) = (&self.equations, &self.waves[contact]);
        let amplitudes = self.equations.amplitudes(contact, &self.level.solved.pressures);
        let exponentials = layout.own[contact].exponentials_over_limit();
        let beside = columns[contact].slopes_at(places, None, &exponentials, Some(&amplitudes));
        let of = |(k, x): (usize, &f64)| {
            let phases: Vec<f64> = layout.zeta[..even.len()].iter().map(|zeta| zeta * x).collect();
            let [sines, cosines, _] = trigonometry::waves(&phases);
            let waves = even.iter().zip(&sines).map(|(even, sine)| even * sine).sum::<f64>()
                - odd.iter().zip(&cosines).map(|(odd, cosine)| odd * cosine).sum::<f64>();
            pressed.at(*x) + waves + layout.own[contact].limit * beside[(k, 0)]
        };
        places.iter().enumerate().map(of).collect()
    }

    /// Places from one end of a gap on, dense next to it, x = from + (to − from) (k/n)², and the gap there.
    fn beside(&self, contact: usize, (punch, [from, to]): &(usize, [f64; 2])) -> Vec<(f64, f64)> {
        let (Equations { problem, layout, columns, .. }, level) = (&self.equations, self.level);
        let (limit, side) = (layout.own[contact].limit, &problem.sides[contact]);
        let pressures = self.equations.pressures_of(contact, &level.solved.pressures);
        let rotation = level.solved.rotations[contact].get(*punch).unwrap_or(&0.0);
        let height = |x: f64| side.height_under(*punch, x);
        let mut waves = Waves::new(&self.waves[contact], &layout.zeta, *from, (to - from) / (PLACES * PLACES) as f64);
        let is_round = problem.twin() == Twin::Round;
        // what pressures do on a half-plane is nothing to the transform of a gap about an axis
        let closed = |x: f64| if is_round { 0.0 } else { limit * columns[contact].closed(x, pressures) };
        let (at_end, unit) = (closed(*from), if is_round { PI } else { 1.0 });
        let at = |k: usize| {
            let t = k as f64 / PLACES as f64;
            let x = from + (to - from) * t * t;
            (x, height(x) - height(*from) - (closed(x) - at_end) - unit * waves.next() + rotation * (x - from))
        };
        let gaps: Vec<(f64, f64)> = (1..=PLACES).map(at).collect();
        if is_round { gaps.iter().map(|(x, _)| *x).zip(abel::gaps(*from, &gaps)).collect() } else { gaps }
    }
}

/// What waves add to a gap between its end and places at the distances d, 4d, 9d ... from there: phases of waves grow by odd multiples of ζd from place to place, and
/// follow by multiplication.
struct Waves(Vec<SomeWaves>);

/// Some waves, in real and imaginary parts.
#[derive(Clone, Copy)]
struct SomeWaves {
    /// Amplitudes over ζ, with their phases at the end.
    amplitude: [Lanes; 2],
    /// 1 − exp(iφ) for the phase φ at the last place from the end on, its next step, and what that grows by.
    phase: [Lanes; 2],
    step: [Lanes; 2],
    growth: [Lanes; 2],
}

impl Waves {
    fn new([even, odd]: &[Vec<f64>; 2], zeta: &[f64], from: f64, d: f64) -> Self {
        let some = |((even, odd), zeta): ((&[f64], &[f64]), &[f64])| {
            let lanes =
                |values: &[f64]| -> Lanes { std::array::from_fn(|lane| values.get(lane).copied().unwrap_or(0.0)) };
            let ([even, odd], zeta) = ([even, odd].map(lanes), lanes(zeta));
            let (sines, cosines) = sin_cos(&zeta.map(|zeta| zeta * from));
            let (half_sines, half_cosines) = sin_cos(&zeta.map(|zeta| 0.5 * zeta * d));
            // there are no waves behind the last one
            let over = |value: f64, lane: usize| if zeta[lane] > 0.0 { value / zeta[lane] } else { 0.0 };
            let amplitude = [
                std::array::from_fn(|lane| over(even[lane] * cosines[lane] + odd[lane] * sines[lane], lane)),
                std::array::from_fn(|lane| over(even[lane] * sines[lane] - odd[lane] * cosines[lane], lane)),
            ];
            let step = [
                std::array::from_fn(|lane| 2.0 * half_sines[lane] * half_sines[lane]),
                std::array::from_fn(|lane| -2.0 * half_sines[lane] * half_cosines[lane]),
            ];
            // 1 − (1 − s)²
            let mut growth = step;
            approach_one(&mut growth, &step);
            SomeWaves { amplitude, phase: [[0.0; LANES]; 2], step, growth }
        };
        let all = even.chunks(LANES).zip(odd.chunks(LANES)).zip(zeta[..even.len()].chunks(LANES));
        Self(all.map(some).collect())
    }

    /// At the next place.
    fn next(&mut self) -> f64 {
        vectorised(
            #[inline(always)]
            || {
                let mut sums = [0.0; LANES];
                for SomeWaves { amplitude: [re, im], phase, step, growth } in &mut self.0 {
                    approach_one(phase, step);
                    approach_one(step, growth);
                    (0..LANES).for_each(|lane| sums[lane] += re[lane] * phase[0][lane] - im[lane] * phase[1][lane]);
                }
                sums.iter().sum()
            },
        )
    }
}

/// 1 − (1 − a)(1 − b) in place of a.
#[inline(always)]
fn approach_one([re, im]: &mut [Lanes; 2], [by_re, by_im]: &[Lanes; 2]) {
    for lane in 0..LANES {
        let [left, minus_im] = [1.0 - re[lane], -im[lane]];
        re[lane] += left * by_re[lane] - minus_im * by_im[lane];
        im[lane] += left * by_im[lane] + minus_im * by_re[lane];
    }
}
