//! The contact problem: half-lengths and pressures of all contacts, for one punch and force on prepared kernels.
mod admissible;
mod basis;
mod collocation;
mod convex;
mod galerkin;
mod given;
mod lattice;
mod layout;
mod level;
mod newton;
mod parts;
mod prescribed;
mod pressures;
mod punch;
mod refine;
mod start;
mod tail;

use std::f64::consts::PI;

use crate::error::{Error, NoSolution};
use crate::kernel::{self, Kernel};
use crate::options::{Method, Options};
use crate::scene::Punch;
use crate::solution::{Contact, Interface, Solution, Stats, Strip};

pub(crate) use lattice::Lattice;
pub(crate) use prescribed::press_to;

use level::{Level, coefficients};
use newton::Converged;
use punch::Indentation;
use refine::{Start, refine};

/// Pressures are resolved so many times better from the outset, one after the other, as next to thin, stiff coatings.
const FINER: [usize; 3] = [1, 8, 32];

/// Half-lengths with larger relative errors are none.
const UNUSABLE: f64 = 0.03;
/// Half-lengths with larger relative errors are taken only if there are no better ones.
const DOUBTFUL: f64 = 1e-4;
/// An interval off the middle counts as a contact that is open there if it ends so many times farther out than it begins.
const OPEN: f64 = 2.0;
/// How often a contact that would have to pull is tried again with an end where it would.
const SHORTER: usize = 3;

/// Presses a punch with a force on a stack: the answer in the units of the scene. It may start from what a lattice of answers
/// for this kernel tells.
pub(crate) fn press(
    kernel: &Kernel,
    lattice: Option<&Lattice>,
    interfaces: &[Interface],
    punch: &Punch,
    force: f64,
    options: &Options,
) -> Result<Solution, Error> {
    let with_punch = punch.material().map(|material| kernel.under_half_plane(&material));
    let lattice = lattice.filter(|_| with_punch.is_none());
    let kernel = with_punch.as_ref().unwrap_or(kernel);
    let indentation = Indentation::new(punch, kernel, force);
    if punch.load().is_some() && options.method == Method::Collocation {
        return Err(Error::LoadByCollocation);
    }
    if indentation.flat().is_some() && options.method == Method::Collocation {
        return Err(Error::FlatByCollocation);
    }
    let solution = match options.method {
        Method::Collocation => collocation::press(kernel, interfaces, &indentation, options)?,
        Method::Galerkin => solve(kernel, lattice, interfaces, &indentation, options)?,
    };
    Ok(Solution { force, ..solution })
}

/// Starts nearby or from formulas, and refines until the answer is admissible and good enough.
fn solve(
    kernel: &Kernel,
    lattice: Option<&Lattice>,
    interfaces: &[Interface],
    indentation: &Indentation,
    options: &Options,
) -> Result<Solution, Error> {
    let mut work = newton::Work::default();
    if indentation.given().is_some() && kernel.contacts() == 1 {
        // nothing is unknown
        let starts = start::half_lengths(kernel, indentation)?;
        let level = Level::new(Converged::known(starts), kernel, indentation, 0.0);
        let check = admissible::Check { min_pressure: 0.0, min_gap: 0.0 };
        return Ok(solution(kernel, interfaces, indentation, level, check, work, Vec::new()));
    }
    let mut from = |start: Start| {
        let (level, warnings) = refine(kernel, interfaces, indentation, start, options, &mut work)?;
        if level.errors.iter().any(|[half_length, _]| *half_length > UNUSABLE) {
            return Err(newton::not_converged(kernel, indentation, &level.half_lengths));
        }
        let check = admissible::check(kernel, interfaces, indentation, &level)?;
        Ok(solution(kernel, interfaces, indentation, level, check, work.clone(), warnings))
    };
    if let Some(start) = lattice.and_then(|lattice| lattice.start(kernel, interfaces, indentation))
        && let Ok(solution) = from(start)
        && solution.warnings.is_empty()
    {
        return Ok(solution);
    }
    from_any_start(kernel, interfaces, indentation, options, |half_lengths, finer| {
        from(Start::Formulas { half_lengths, finer })
    })
}

/// Solves from half-lengths that formulas expect, and where that fails from those of the convex programme. `solve` is
/// told, too, how much finer to begin.
fn from_any_start(
    kernel: &Kernel,
    interfaces: &[Interface],
    indentation: &Indentation,
    options: &Options,
    mut solve: impl FnMut(Vec<f64>, usize) -> Result<Solution, Error>,
) -> Result<Solution, Error> {
    // an answer of few digits may be that of a false root: another one is looked for
    let mut doubtful: Option<(f64, Solution)> = None;
    let mut in_parts = false;
    let decided = decide(kernel, interfaces, indentation, options, &mut in_parts, |half_lengths, finer| {
        let solution = solve(half_lengths, finer)?;
        let errors = solution.contacts.iter().map(|contact| contact.half_length_error / contact.half_length);
        let worst = errors.fold(0.0, f64::max);
        if solution.warnings.is_empty() || worst <= DOUBTFUL {
            return Ok(solution);
        }
        let half_lengths = solution.contacts.iter().map(|contact| contact.half_length).collect();
        if doubtful.as_ref().is_none_or(|(least, _)| worst < *least) {
            doubtful = Some((worst, solution));
        }
        Err(NoSolution::NotConverged { half_lengths }.into())
    });
    match (decided, doubtful) {
        (Err(Error::NoSolution(_)), Some((_, solution))) if !in_parts => Ok(solution),
        (decided, _) => decided,
    }
}

/// Goes through all starts; `in_parts` tells whether a contact has several parts for certain.
fn decide(
    kernel: &Kernel,
    interfaces: &[Interface],
    indentation: &Indentation,
    options: &Options,
    in_parts: &mut bool,
    mut solve: impl FnMut(Vec<f64>, usize) -> Result<Solution, Error>,
) -> Result<Solution, Error> {
    let expected = start::half_lengths(kernel, indentation)?;
    let mut failure = match solve(expected.clone(), 1) {
        Err(Error::NoSolution(failure)) if !matches!(failure, NoSolution::PunchTooSmall { .. }) => failure,
        decided => return decided,
    };
    let mut zones = None;
    let mut far = 0.0;
    // once more if bodies would overlap farther out than was looked at
    for _ in 0..2 {
        let overlap = if let NoSolution::Overlap { x, .. } = failure { x / kernel.length() } else { 0.0 };
        if zones.is_some() && overlap <= far {
            break;
        }
        far = overlap;
        zones = convex::zones(kernel, indentation, &expected, far);
        if let Some(error) = several(kernel, interfaces, zones.as_deref(), true) {
            *in_parts = true;
            let zones = zones.as_deref().unwrap_or_default();
            return parts::solve(kernel, interfaces, indentation, zones, options).ok_or(error);
        }
        let ends: Vec<f64> = (0..expected.len())
            .map(|i| match zones.as_ref().map_or(0.0, |zones| zones[i].end()) {
                _ if i == 0 && indentation.flat().is_some() => expected[i],
                0.0 => expected[i],
                end => end,
            })
            .collect();
        for finer in FINER {
            let mut half_lengths = ends.clone();
            for _ in 0..SHORTER {
                match solve(half_lengths.clone(), finer) {
                    Err(Error::NoSolution(found)) => failure = found,
                    decided => return decided,
                }
                // there are roots whose contacts reach past where they should end
                let NoSolution::Tension { interface, x } = failure else { break };
                let fixed = usize::from(indentation.flat().is_some());
                let pulling = interfaces.iter().position(|contact| *contact == interface);
                let Some(pulling) = pulling.filter(|pulling| *pulling >= fixed) else { break };
                half_lengths[pulling] = x / kernel.length();
            }
        }
    }
    let zones = zones.as_deref();
    let Some(error) = several(kernel, interfaces, zones, false) else { return Err(failure.into()) };
    parts::solve(kernel, interfaces, indentation, zones.unwrap_or_default(), options).ok_or(error)
}

/// The error that says in which intervals bodies touch, if there are several, or none about the middle.
fn several(kernel: &Kernel, interfaces: &[Interface], zones: Option<&[convex::Zones]>, certain: bool) -> Option<Error> {
    let finite = |zones: &convex::Zones| zones.sure.iter().filter(|part| part[1].is_finite()).count();
    // layers that lie flat on each other far away touch without a force: they do not say that there is no answer
    let count = |zones: &convex::Zones| if certain { finite(zones) } else { zones.apart.len() };
    // bodies that do not touch about the middle touch in two intervals, one on either side
    let open = |zones: &convex::Zones| match zones.sure[..] {
        [[from, to]] => !certain && from > 0.0 && to.is_finite() && to > OPEN * from,
        _ => false,
    };
    // a zone under the punch too short for the grid says nothing
    let plausible = |i: usize, zones: &convex::Zones| i > 0 || zones.apart.first().is_some_and(|part| part[0] == 0.0);
    let mut all = zones?.iter().enumerate();
    let (i, zones) = all.find(|(i, zones)| open(zones) || count(zones) > 1 && plausible(*i, zones))?;
    let parts = zones.hull().iter().map(|part| part.map(|x| x * kernel.length())).collect();
    Some(NoSolution::Parts { interface: interfaces[i], parts }.into())
}

/// What it took to evaluate the stack.
fn stats(kernel: &Kernel) -> Stats {
    let kernel::Work { wavenumbers, layers, unfelt } = kernel.work();
    let (dropped, merged) = (kernel.dropped(), kernel.merged());
    Stats { dropped, merged, wavenumbers, layers, unfelt, uncoupled: kernel.uncoupled_values(), ..Stats::default() }
}

/// The answer in the units of the scene.
fn solution(
    kernel: &Kernel,
    interfaces: &[Interface],
    indentation: &Indentation,
    level: Level,
    check: admissible::Check,
    work: newton::Work,
    warnings: Vec<String>,
) -> Solution {
    let pressure_unit = kernel.modulus() * indentation.force;
    let force = pressure_unit * kernel.length();
    let contacts = interfaces
        .iter()
        .enumerate()
        .map(|(i, interface)| {
            if let (0, Some(load)) = (i, indentation.load()) {
                let strips = given::strips(load, force, kernel.length());
                return given::contact(load, *interface, force, strips);
            }
            let half_length = level.half_lengths[i] * kernel.length();
            let pressure_unit = pressure_unit * 2.0 / level.half_lengths[i];
            let mut coefficients = coefficients(&level.modes[i]);
            coefficients.iter_mut().for_each(|c| *c *= pressure_unit);
            let peak_pressure = level.peaks[i] * pressure_unit;
            let resultant = 0.5 * PI * half_length * coefficients[0];
            let unit = if i == 0 { 0.5 * pressure_unit / PI } else { 0.0 };
            let (corners, tip) = (level.corners * unit, level.tip * unit);
            coefficients[0] -= 2.0 * corners;
            if tip != 0.0 {
                // arcosh(1/|cos φ|) is known as a whole
                coefficients.truncate(level.counts[i]);
                let terms = coefficients.iter_mut().enumerate();
                terms.for_each(|(m, c)| *c -= 2.0 * galerkin::alternating(m) * tip / galerkin::order(m));
            }
            let [length_error, pressure_error] = level.errors[i];
            Contact {
                interface: *interface,
                half_length,
                half_length_error: length_error * half_length,
                peak_pressure,
                peak_pressure_error: if peak_pressure.is_finite() { pressure_error * peak_pressure } else { 0.0 },
                resultant,
                strips: vec![Strip { corners, tip, ..Strip::series(half_length, coefficients, level.counts[i]) }],
                parts: Vec::new(),
            }
        })
        .collect();
    Solution {
        contacts,
        force,
        force_error: 0.0,
        min_pressure: check.min_pressure * pressure_unit,
        min_gap: check.min_gap * indentation.force * kernel.length(),
        stats: Stats {
            modes: level.counts,
            newton_steps: work.steps,
            factorisations: work.factorisations,
            interpolated: work.interpolated,
            ..stats(kernel)
        },
        warnings,
    }
}

#[cfg(test)]
mod tests {
    use recede_layers::{Exponential, HalfPlane, Homogeneous, Plane};

    use super::given::Given;
    use super::*;
    use crate::stack::Stack;

    #[test]
    fn the_pressure_of_a_punch_given_as_a_load_makes_the_same_contacts() {
        let strip = || Homogeneous::new(1.0, 1.0, 0.25).unwrap();
        let graded = Exponential::new(0.7, 2.0, 0.3, 1.3).unwrap();
        let stack = || Stack::builder(Plane::Strain);
        for stack in [
            stack().layer(strip()).receding().layer(HalfPlane::new(0.5, 0.3).unwrap()),
            stack().layer(graded).receding().layer(strip()).receding().rigid(),
        ] {
            let stack = stack.build().unwrap();
            let (kernel, interfaces, options) = (Kernel::new(&stack).unwrap(), stack.contacts(), Options::default());
            let punch = Punch::parabola(100.0).unwrap();
            for force in [1e-4, 0.02] {
                let expected = press(&kernel, None, &interfaces, &punch, force, &options).unwrap();
                let top = &expected.contacts[0];
                let given = Given::of(top.half_length / kernel.length(), &top.strips[0].coefficients);
                let indentation = Indentation::new(&punch, &kernel, force).with(given);
                let found = solve(&kernel, None, &interfaces, &indentation, &options).unwrap();
                for (found, expected) in found.contacts[1..].iter().zip(&expected.contacts[1..]) {
                    assert!((found.half_length / expected.half_length - 1.0).abs() < 1e-10, "{found:?} {expected:?}");
                    assert!((found.peak_pressure / expected.peak_pressure - 1.0).abs() < 1e-9);
                }
            }
        }
    }
}
