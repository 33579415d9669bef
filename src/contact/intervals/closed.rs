//! Interfaces that lie on each other but for openings: the pressure outside these, which may be no tension, and the gaps in them.
use std::f64::consts::PI;

use crate::contact::integrals::layout::{FIELDS, Layout, Lengths, negligible};
use crate::contact::intervals::errors::Errors;
use crate::contact::intervals::gaps::{self, Fault, Gaps, Signs};
use crate::contact::intervals::newton::Approximation;
use crate::contact::intervals::pressure::Pressure;
use crate::contact::intervals::support::ContactInterval;
use crate::contact::problem::accuracy::{COARSE, SAFETY};
use crate::contact::problem::closed::ClosedPressure;
use crate::contact::problem::{Problem, Side};
use crate::numeric::largest;
use crate::numeric::search::{ByDistance, Low, Samples, begins, places};
use crate::solution::{ClosedInterface, Opening, Strip};

/// Places for each half-length of an opening and for each wave of the shortest ones that feel more than the face.
const PLACES: usize = 16;
const WAVES: f64 = 4.0;

/// Checks the signs of a solution: of gaps and pressures in contacts, see [`gaps::check`], and of pressures outside openings.
pub(super) fn check(problem: &Problem, level: &Approximation, error: f64, leaves_out: bool) -> Result<Signs, Fault> {
    let signs = gaps::check(problem, level, error, leaves_out)?;
    Ok(Signs { closed: smallest(problem, level, error)?, ..signs })
}

/// Where the smallest pressure on each interface that lies on another one is.
///
/// # Errors
/// [`Fault::Penetration`] where the layers would pull: there is another opening there.
fn smallest(problem: &Problem, level: &Approximation, error: f64) -> Result<Vec<Low>, Fault> {
    let opened: Vec<usize> = (0..problem.contacts()).filter(|contact| problem.is_opened(*contact)).collect();
    if opened.is_empty() {
        return Ok(Vec::new());
    }
    let mut lengths = Lengths::of(problem, &level.support, &level.counts, negligible(FIELDS));
    lengths.exponentials.iter_mut().for_each(Vec::clear);
    let (reach, farthest) = (largest(lengths.ends.iter().copied()), 0.5 * problem.kernel.farthest());
    let layouts = layouts(problem, &lengths, negligible(FIELDS), reach + farthest)?;
    let own = pressures(problem, &layouts, level);
    let of = |contact: usize| {
        let Side::Openings(pressed) = &problem.sides[contact] else { return None };
        let intervals = level.support.of(contact);
        let is_closed = |[from, to]: [f64; 2]| intervals.iter().all(|own| to < own.from() || from > own.to());
        // waves as short as the layers at the faces feel
        let step = PI / (WAVES * problem.kernel.governed_by_faces(contact).max(farthest.recip()));
        let shortest = intervals.iter().map(|own| 4.0 * own.half / PLACES as f64).fold(step, f64::min);
        let shortest = shortest.max(reach / (8 * PLACES) as f64);
        // what is even is looked at on the right
        let from = if problem.is_even() { 0.0 } else { -reach - farthest };
        let of = |places: &[f64]| deviations(&own, contact, pressed, places);
        let mut samples = Samples::new(places([from, reach + farthest], &lengths.ends, shortest), of, is_closed);
        let low = samples.lowest(of, is_closed);
        Some(Outside { contact, pressed, samples, low })
    };
    let all: Vec<Outside> = opened.into_iter().filter_map(of).collect();
    // where layers pull most they come apart first: others need not then
    let pulls = |own: &&Outside| own.tension() > COARSE.max(error * own.samples.largest());
    let mut pulling: Vec<&Outside> = all.iter().filter(pulls).collect();
    pulling.sort_by(|a, b| b.tension().total_cmp(&a.tension()));
    if !pulling.is_empty() {
        // fewer terms tell how well it is known
        let coarse = level.coarse();
        let before = pressures(problem, &layouts, &coarse);
        let is_known = |own: &&&Outside| {
            let before = deviations(&before, own.contact, own.pressed, &[own.low.place])[0];
            own.tension() > SAFETY * (own.low.value - before).abs()
        };
        // more terms are to tell of what is not known
        Err(pulling.iter().find(is_known).map_or(Fault::Tension, |own| own.fault()))?;
    }
    Ok(all.iter().map(|own| own.low).collect())
}

/// Pressures on an interface outside its openings.
struct Outside<'a> {
    contact: usize,
    pressed: &'a ClosedPressure<'a>,
    samples: Samples,
    low: Low,
}

impl Outside<'_> {
    /// The largest tension, in parts of the weight.
    fn tension(&self) -> f64 {
        -1.0 - self.low.value
    }

    /// The tension about the place where it is largest.
    fn fault(&self) -> Fault {
        let over = self.samples.below(-1.0, &self.low);
        Fault::Penetration { contact: self.contact, punch: 0, at: self.low.place, depth: self.tension(), over }
    }
}

/// Layouts that resolve pressures out to some distances.
fn layouts(problem: &Problem, lengths: &Lengths, negligible: f64, farthest: f64) -> Result<ByDistance<Layout>, Fault> {
    let reach = largest(lengths.ends.iter().copied());
    ByDistance::new(farthest, reach, |span| {
        let layout = Layout::new(problem.kernel, lengths, negligible, span).ok_or(Fault::Unknown)?.faded();
        let is_whole = layout.left_out_from.is_infinite();
        Ok((layout, is_whole))
    })
}

/// The pressures on interfaces that a solution leaves, by the distances that layouts resolve.
fn pressures<'a>(
    problem: &'a Problem<'a>,
    layouts: &'a ByDistance<Layout>,
    level: &'a Approximation,
) -> ByDistance<Gaps<'a>> {
    layouts.map(|layout| Gaps::new(problem, layout, level))
}

/// By how much pressures outside openings differ from the weight, in parts of the weight.
fn deviations(own: &ByDistance<Gaps>, contact: usize, pressed: &ClosedPressure, places: &[f64]) -> Vec<f64> {
    let pressures = own.values(places, |gaps, places| gaps.pressures(contact, pressed, places));
    pressures.into_iter().map(|pressure| pressure / pressed.weight - 1.0).collect()
}

/// What is said of each interface that lies on another one, in units of L and per unit of P', with x = 0 of the scene.
pub(super) fn found(
    problem: &Problem,
    level: &Approximation,
    errors: &Errors,
    least: &[Low],
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
    let farthest = least.iter().flat_map(|own| own.ends).fold(problem.origin.abs(), |most, x| most.max(x.abs()));
    let layouts = layouts(problem, &lengths, negligible, farthest).ok()?;
    let own = pressures(problem, &layouts, level);
    let of = |(contact, least): (usize, &Low)| {
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
        let deviations = |places: &[f64]| deviations(&own, contact, pressed, places);
        let (smallest_pressure, smallest_at) = end.unwrap_or_else(|| {
            let low = Low::between(least.ends, deviations);
            (weight + weight * low.value, low.place)
        });
        let is_open = openings.iter().any(|own| own.left <= x && x <= own.right);
        let central = if is_open { 0.0 } else { weight + weight * deviations(&[x])[0] };
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
    let strip = pressure.strip(interval);
    // the gap grows from the left end on, where angles are large
    begins([angle(largest), angle(largest + 2)], |phi| strip.pressure(interval.place(phi)) > 0.0)
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
