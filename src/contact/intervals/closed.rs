//! Interfaces that lie on each other but for openings: the pressure outside these, which may be no tension, and the gaps in them.
use std::f64::consts::PI;

use crate::contact::integrals::layout::{FIELDS, Layout, Lengths, negligible};
use crate::contact::intervals::errors::Errors;
use crate::contact::intervals::gaps::{self, Fault, Gaps, Least, Signs};
use crate::contact::intervals::newton::Approximation;
use crate::contact::intervals::of_contacts;
use crate::contact::intervals::pressure::Pressure;
use crate::contact::intervals::support::{ContactInterval, Intervals};
use crate::contact::problem::accuracy::{COARSE, SAFETY};
use crate::contact::problem::closed::ClosedPressure;
use crate::contact::problem::{Problem, Side};
use crate::numeric::largest;
use crate::solution::{ClosedInterface, Contact, Opening, Strip};

/// Places for each half-length of an opening and for each wave of the shortest ones that feel more than the face, and the growth of steps beyond all ends.
const PLACES: usize = 16;
const WAVES: f64 = 4.0;
const FARTHER: f64 = 0.1;
/// Small pressures are resolved where they differ by less than this part of the weight from the next ones, which are brought closer together so often.
const RESOLVED: f64 = 0.25;
const CLOSER: usize = 6;
/// Pressures are looked at by distances that differ by this factor.
const NEARER: f64 = 8.0;

/// The contacts of a solution while all is closed, in units of L, with openings at some places.
pub(crate) fn of_openings(
    problem: &Problem,
    contacts: &[Contact],
    openings: &[(usize, [f64; 2])],
) -> Option<Intervals> {
    let mut all = match problem.unknown().all(|contact| problem.is_opened(contact)) {
        true => Vec::new(),
        false => of_contacts(problem, contacts)?.0,
    };
    // what is even is solved for on x ≥ 0
    let right = openings.iter().filter(|(_, ends)| !problem.is_even() || ends[1] > 0.0);
    all.extend(right.map(|(contact, ends)| ContactInterval::opening(problem, *contact, *ends)));
    Some(Intervals(all))
}

/// Checks the signs of a solution: of gaps and pressures in contacts, see [`gaps::check`], and of pressures outside openings.
pub(super) fn check(problem: &Problem, level: &Approximation, error: f64, leaves_out: bool) -> Result<Signs, Fault> {
    let signs = gaps::check(problem, level, error, leaves_out)?;
    Ok(Signs { closed: smallest(problem, level, error)?, ..signs })
}

/// Where the smallest pressure on each interface that lies on another one is.
///
/// # Errors
/// [`Fault::Penetration`] where the layers would pull: there is another opening there.
fn smallest(problem: &Problem, level: &Approximation, error: f64) -> Result<Vec<Least>, Fault> {
    let opened: Vec<usize> = (0..problem.contacts()).filter(|contact| problem.is_opened(*contact)).collect();
    if opened.is_empty() {
        return Ok(Vec::new());
    }
    let mut lengths = Lengths::of(problem, &level.support, &level.counts, negligible(FIELDS));
    lengths.exponentials.iter_mut().for_each(Vec::clear);
    let (reach, farthest) = (largest(lengths.ends.iter().copied()), 0.5 * problem.kernel.farthest());
    let layouts = layouts(problem, &lengths, negligible(FIELDS), reach + farthest).ok_or(Fault::Unknown)?;
    let own = Pressures::new(problem, &layouts, level);
    let of = |contact: usize| {
        let Side::Openings(pressed) = &problem.sides[contact] else { return None };
        let intervals = level.support.of(contact);
        let is_closed = |x: &f64| intervals.iter().all(|own| *x < own.from() || *x > own.to());
        // waves as short as the layers at the faces feel
        let step = PI / (WAVES * problem.kernel.governed_by_faces(contact).max(farthest.recip()));
        // what is even is looked at on the right
        let from = if problem.is_even() { 0.0 } else { -reach - farthest };
        let mut places: Vec<f64> = places(intervals, reach, [from, reach + farthest], step);
        places.retain(is_closed);
        let pressures = |places: &[f64]| own.at(contact, pressed, places);
        let pressures = resolved(&mut places, pressures, pressed.weight, is_closed);
        Some(Outside { contact, weight: pressed.weight, places, pressures })
    };
    let all: Vec<Outside> = opened.into_iter().filter_map(of).collect();
    // where layers pull most they come apart first: others need not then
    let tension = |own: &Outside| -own.pressures[own.least()];
    let mut pulling: Vec<&Outside> = all.iter().filter(|own| tension(own) > COARSE.max(error) * own.weight).collect();
    pulling.sort_by(|a, b| tension(b).total_cmp(&tension(a)));
    if !pulling.is_empty() {
        // fewer terms tell how well it is known
        let coarse = level.coarse();
        let before = Pressures::new(problem, &layouts, &coarse);
        let is_known = |own: &&&Outside| {
            let Side::Openings(pressed) = &problem.sides[own.contact] else { return false };
            let before = before.at(own.contact, pressed, &[own.places[own.least()]])[0];
            tension(own) > SAFETY * (tension(own) + before).abs()
        };
        pulling.iter().find(is_known).map_or(Ok(()), |own| Err(own.tension()))?;
    }
    Ok(all.iter().map(Outside::smallest).collect())
}

/// Pressures on an interface at places outside its openings, in ascending order.
struct Outside {
    contact: usize,
    weight: f64,
    places: Vec<f64>,
    pressures: Vec<f64>,
}

impl Outside {
    /// The number of the place where the pressure is smallest.
    fn least(&self) -> usize {
        let order = |a: &usize, b: &usize| self.pressures[*a].total_cmp(&self.pressures[*b]);
        (0..self.places.len()).min_by(order).unwrap_or(0)
    }

    /// The place where the pressure is smallest, with its neighbours.
    fn smallest(&self) -> Least {
        let (least, at) = (self.least(), |k: usize| self.places[k.min(self.places.len() - 1)]);
        // what is even goes on on the left
        let left = if least > 0 { at(least - 1) } else { -at(usize::from(at(0) == 0.0)) };
        Least([left, at(least), at(least + 1)])
    }

    /// The tension about the place where it is largest.
    fn tension(&self) -> Fault {
        let Self { contact, weight, places, pressures } = self;
        let least = self.least();
        let is_tensile = |k: &usize| pressures[*k] < 0.0;
        let first = (0..=least).rev().take_while(is_tensile).last().unwrap_or(least);
        let last = (least..places.len()).take_while(is_tensile).last().unwrap_or(least);
        // a line to the next place ends before the tension does
        let end = |k: usize, next: usize| {
            let part = pressures[k] / (pressures[k] - pressures[next]);
            if (0.0..1.0).contains(&part) { places[k] + part * (places[next] - places[k]) } else { places[k] }
        };
        let over = [end(first, first.saturating_sub(1)), end(last, (last + 1).min(places.len() - 1))];
        Fault::Penetration { contact: *contact, punch: 0, at: places[least], depth: -pressures[least] / weight, over }
    }
}

/// Layouts that resolve pressures out to some distances, the farthest first: near what presses shorter waves matter than far from there.
fn layouts(problem: &Problem, lengths: &Lengths, negligible: f64, farthest: f64) -> Option<Vec<(f64, Layout)>> {
    let reach = largest(lengths.ends.iter().copied());
    let mut all = Vec::new();
    let mut span = farthest;
    loop {
        let layout = Layout::new(problem.kernel, lengths, negligible, span)?.faded();
        let is_last = layout.left_out_from.is_infinite() || span <= reach;
        all.push((span, layout));
        if is_last {
            return Some(all);
        }
        span /= NEARER;
    }
}

/// The pressures on interfaces that a solution leaves, by the distances that layouts resolve.
struct Pressures<'a>(Vec<(f64, Gaps<'a>)>);

impl<'a> Pressures<'a> {
    fn new(problem: &'a Problem<'a>, layouts: &'a [(f64, Layout)], level: &'a Approximation) -> Self {
        Self(layouts.iter().map(|(span, layout)| (*span, Gaps::new(problem, layout, level))).collect())
    }

    /// At places outside openings, from the pressure of the interface while nothing else presses.
    fn at(&self, contact: usize, pressed: &ClosedPressure, places: &[f64]) -> Vec<f64> {
        let mut all = vec![0.0; places.len()];
        for (k, (span, gaps)) in self.0.iter().enumerate() {
            let next = self.0.get(k + 1).map_or(f64::NEG_INFINITY, |(span, _)| *span);
            let is_own = |x: &f64| (k == 0 || x.abs() <= *span) && x.abs() > next;
            let numbers: Vec<usize> = (0..places.len()).filter(|number| is_own(&places[*number])).collect();
            let own: Vec<f64> = numbers.iter().map(|number| places[*number]).collect();
            let pressures = gaps.pressures(contact, pressed, &own);
            numbers.iter().zip(pressures).for_each(|(number, pressure)| all[*number] = pressure);
        }
        all
    }
}

/// The pressures at some places, and at others between these until the ones about each small pressure differ by little of the weight.
fn resolved(
    places: &mut Vec<f64>,
    pressures: impl Fn(&[f64]) -> Vec<f64>,
    weight: f64,
    is_closed: impl Fn(&f64) -> bool,
) -> Vec<f64> {
    let mut found = pressures(places);
    for _ in 0..CLOSER {
        let last = places.len().saturating_sub(1);
        let is_least = |k: usize| found[k] <= found[k.saturating_sub(1)] && found[k] <= found[(k + 1).min(last)];
        let is_small = |k: usize| found[k] < weight && is_least(k);
        let is_coarse =
            |k: &usize| (found[*k] - found[k + 1]).abs() > RESOLVED * weight && (is_small(*k) || is_small(k + 1));
        let between = (0..last).filter(is_coarse).map(|k| 0.5 * (places[k] + places[k + 1]));
        let more: Vec<f64> = between.filter(&is_closed).collect();
        if more.is_empty() {
            break;
        }
        let of_more = pressures(&more);
        let before = places.drain(..).zip(found);
        let mut all: Vec<(f64, f64)> = before.chain(more.into_iter().zip(of_more)).collect();
        all.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        (*places, found) = all.into_iter().unzip();
    }
    found
}

/// Places on an interface, dense as far as contacts and openings reach.
fn places(intervals: &[ContactInterval], reach: f64, [from, to]: [f64; 2], step: f64) -> Vec<f64> {
    let shortest = intervals.iter().map(|own| 4.0 * own.half / PLACES as f64).fold(step, f64::min);
    let step = shortest.max(reach / (8 * PLACES) as f64);
    let mut places = vec![from];
    while let Some(last) = places.last().copied().filter(|last| *last < to) {
        let beyond = (last.abs() - reach).max(0.0);
        places.push(last + step.max(FARTHER * beyond));
    }
    places
}

/// What is said of each interface that lies on another one, in units of L and per unit of P', with x = 0 of the scene.
pub(super) fn found(
    problem: &Problem,
    level: &Approximation,
    errors: &Errors,
    least: &[Least],
) -> Option<Vec<ClosedInterface>> {
    let opened: Vec<usize> = (0..problem.contacts()).filter(|contact| problem.is_opened(*contact)).collect();
    if opened.is_empty() {
        return Some(Vec::new());
    }
    let negligible = negligible(problem.tolerance);
    let mut lengths = Lengths::of(problem, &level.support, &level.counts, negligible);
    for contact in opened.iter().copied() {
        // the tail next to a graded face in closed form: at a place there is no other one
        let asymptote = problem.kernel.asymptote(contact);
        let enough = asymptote.exponentials_suffice(lengths.shortest[contact], negligible);
        lengths.turned[contact] = lengths.turned[contact].max(enough);
        lengths.exponentials[contact] = asymptote.exponentials();
    }
    let farthest = least.iter().flat_map(|own| own.0).fold(problem.origin.abs(), |most, x| most.max(x.abs()));
    let layouts = layouts(problem, &lengths, negligible, farthest)?;
    let own = Pressures::new(problem, &layouts, level);
    let of = |(contact, least): (usize, &Least)| {
        let Side::Openings(pressed) = &problem.sides[contact] else { return None };
        let weight = pressed.weight;
        let numbers = || (0..level.support.0.len()).filter(|number| level.support.0[*number].contact == contact);
        let right: Vec<(Opening, Strip)> = numbers()
            .map(|number| opening(&level.support.0[number], &level.regular[number], errors.ends[number]))
            .collect();
        let left = right.iter().rev().filter(|_| problem.is_even()).filter(|(own, _)| own.left > 0.0);
        let (openings, slopes): (Vec<Opening>, Vec<Strip>) = left
            .map(|(own, slope)| (own.mirrored(), slope.mirrored(0.0).scaled(1.0, -1.0)))
            .chain(right.clone())
            .unzip();
        let x = -problem.origin;
        // it is zero where an opening ends
        let end = openings.last().map(|last| (0.0, last.right));
        let pressures = |places: &[f64]| own.at(contact, pressed, places);
        let (smallest_pressure, smallest_at) = end.unwrap_or_else(|| least.refined(pressures));
        let is_open = openings.iter().any(|own| own.left <= x && x <= own.right);
        let central = if is_open { 0.0 } else { pressures(&[x])[0] };
        Some(ClosedInterface {
            interface: problem.interfaces[contact],
            weight,
            central_pressure: central,
            central_pressure_error: if is_open { 0.0 } else { errors.worst() * (central - weight).abs() },
            smallest_pressure,
            smallest_at,
            openings,
            slopes,
        })
    };
    opened.into_iter().zip(least).map(of).collect()
}

/// One opening with its slope, from the relative errors of its ends.
fn opening(interval: &ContactInterval, pressure: &Pressure, errors: [f64; 2]) -> (Opening, Strip) {
    let (slope, phi, sizes) = (pressure.strip(interval), widest(pressure, interval), interval.sizes());
    let [left_error, right_error] = [0, 1].map(|k| errors[k] * sizes[k]);
    let own = Opening {
        left: interval.middle - interval.half,
        right: interval.to(),
        left_error: if interval.is_even() { right_error } else { left_error },
        right_error,
        largest_gap: interval.half * slope.integral_to(phi),
        largest_gap_at: if phi == 0.5 * PI { interval.middle } else { interval.place(phi) },
    };
    (own, slope)
}

/// The angle at which the gap of an opening is largest: its slope changes its sign there.
fn widest(pressure: &Pressure, interval: &ContactInterval) -> f64 {
    let places = pressure.places(interval);
    let gaps = pressure.inside(interval, places);
    let largest = (0..gaps.len()).max_by(|a, b| gaps[*a].total_cmp(&gaps[*b])).unwrap_or(0);
    let angle = |k: usize| PI * k as f64 / places as f64;
    if interval.is_even() && largest + 1 == gaps.len() {
        return 0.5 * PI;
    }
    let (mut from, mut to) = (angle(largest), angle(largest + 2));
    let strip = pressure.strip(interval);
    // halved down to rounding
    for _ in 0..50 {
        let middle = 0.5 * (from + to);
        // the gap grows from the left end on, where angles are large
        if strip.pressure(interval.place(middle)) > 0.0 { to = middle } else { from = middle }
    }
    0.5 * (from + to)
}

impl Opening {
    /// Its mirror image about x = 0.
    fn mirrored(&self) -> Self {
        Self {
            left: -self.right,
            right: -self.left,
            left_error: self.right_error,
            right_error: self.left_error,
            largest_gap_at: -self.largest_gap_at,
            ..*self
        }
    }
}

impl ClosedInterface {
    /// In other units of length and pressure, moved along x; the gap grows with the pressure and the length.
    pub(crate) fn scaled(mut self, length: f64, by: f64, [pressure, slope]: [f64; 2]) -> Self {
        for own in [&mut self.weight, &mut self.central_pressure, &mut self.central_pressure_error] {
            *own *= pressure;
        }
        self.smallest_pressure *= pressure;
        self.smallest_at = self.smallest_at * length + by;
        let moved = |strip: Strip| Strip { at: strip.at * length + by, ..strip.scaled(length, slope) };
        self.slopes = self.slopes.into_iter().map(moved).collect();
        for own in &mut self.openings {
            [own.left, own.right, own.largest_gap_at] =
                [own.left, own.right, own.largest_gap_at].map(|x| x * length + by);
            own.left_error *= length;
            own.right_error *= length;
            own.largest_gap *= length * slope;
        }
        self
    }
}
