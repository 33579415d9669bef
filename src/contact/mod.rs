//! The contact problem: half-lengths and pressures of all contacts, for one punch and force on prepared kernels.
mod ends;
mod equations;
mod error;
mod integrals;
mod parts;
mod prescribed;
pub(crate) mod problem;
mod programme;
mod quality;
pub(crate) mod starts;
mod thin;

use std::borrow::Cow;
use std::f64::consts::PI;

use crate::kernel::{self, Kernel};
use crate::numeric;
use crate::options::Options;
use crate::scene::Punch;
use crate::solution::{Contact, Interface, Solution, Stats, Strip};

pub(crate) use ends::newton::not_converged;
pub use error::{ContactError, NoSolution};
pub(crate) use prescribed::press_to;
pub(crate) use starts::table::Lattice;

use ends::converged::Converged;
use ends::newton;
use problem::load as given;
use problem::modes::{alternating, coefficients, order};
use problem::profile::Indentation;
use quality::admissible;
use quality::estimate::{BEST, Level, UNKNOWN};
use quality::levels::{Start, refine};
use starts::formulas;
use starts::order::{Answer, from_any_start};
use thin::Thin;

/// Tolerances so many times larger are tried where errors are larger still, but not beyond what is worth it.
const LOOSER: [f64; 2] = [10.0, 100.0];
const WORTH_IT: f64 = 1e-3;

/// Without thin layers contacts are solved for to this part of what these change.
const THIN: f64 = 0.1;

/// Presses a punch with a force on a stack: the answer in the units of the scene. It may start from what a lattice of answers
/// for this kernel tells.
pub(crate) fn press(
    kernel: &Kernel,
    lattice: Option<&Lattice>,
    interfaces: &[Interface],
    punch: &Punch,
    force: f64,
    options: &Options,
) -> Result<Solution, ContactError> {
    let lattice = lattice.filter(|_| punch.material().is_none());
    let kernel = &*kernel_under(kernel, punch, force)?;
    let solution =
        solve_with_thin_layers(kernel, lattice, interfaces, &Indentation::new(punch, kernel, force), options)?;
    Ok(Solution { force, ..solution })
}

/// The kernel with what an elastic punch adds to it, in a unit of length that suits contacts on a stack without one.
pub(crate) fn kernel_under<'a>(kernel: &'a Kernel, punch: &Punch, force: f64) -> Result<Cow<'a, Kernel>, ContactError> {
    let kernel = match punch.material() {
        Some(material) => Cow::Owned(kernel.under_half_plane(&material)),
        None => Cow::Borrowed(kernel),
    };
    let length = formulas::length(&kernel, punch, force)?;
    Ok(match length {
        Some(length) => Cow::Owned(kernel.measured_in(length)),
        None => kernel,
    })
}

/// Solves, without what only layers much thinner than a contact change in the kernels if that makes the smaller error.
fn solve_with_thin_layers(
    kernel: &Kernel,
    lattice: Option<&Lattice>,
    interfaces: &[Interface],
    indentation: &Indentation,
    options: &Options,
) -> Result<Solution, ContactError> {
    let all = || solve(kernel, lattice, interfaces, indentation, options);
    let Some(thin) = Thin::new(kernel, indentation)? else { return all() };
    let without = || {
        // no more digits are of use than are left
        let options = Options { tolerance: options.tolerance.max(THIN * thin.error), ..*options };
        let solution = solve(&thin.kernel, None, &thin.interfaces(interfaces), indentation, &options)?;
        Ok(thin.admit(solution, interfaces))
    };
    if thin.error <= options.tolerance || thin.is_unresolved() {
        return without().or_else(|_: ContactError| all());
    }
    let found = all();
    if found.as_ref().is_ok_and(|all| worst(all) <= thin.error) {
        return found;
    }
    match (&found, without()) {
        (Ok(all), Ok(without)) if worst(all) <= worst(&without) => found,
        (_, Ok(without)) => Ok(without),
        (_, Err(_)) => found,
    }
}

/// The largest relative error of an answer.
fn worst(solution: &Solution) -> f64 {
    let errors = solution.contacts.iter().flat_map(|contact| {
        let pressure = contact.peak_pressure_error / contact.peak_pressure;
        // a pressure of 0 is known, and an infinite one cannot be missed
        let known = contact.peak_pressure == 0.0 || contact.peak_pressure.is_infinite();
        [contact.half_length_error / contact.half_length, if known { 0.0 } else { pressure }]
    });
    numeric::largest(errors)
}

/// Starts nearby or from formulas, and refines until the answer is admissible and good enough.
fn solve(
    kernel: &Kernel,
    lattice: Option<&Lattice>,
    interfaces: &[Interface],
    indentation: &Indentation,
    options: &Options,
) -> Result<Solution, ContactError> {
    let mut work = newton::Work::default();
    if indentation.given().is_some() && kernel.contacts() == 1 {
        // nothing is unknown
        let starts = formulas::half_lengths(kernel, indentation)?;
        let level = Level::new(Converged::known(starts), kernel, indentation, 0.0);
        let check = admissible::Check { min_pressure: 0.0, pulls: Vec::new(), min_gap: 0.0, overlaps: Vec::new() };
        return Ok(solution(kernel, interfaces, indentation, level, check, work, Vec::new()));
    }
    let mut from = |start: Start| {
        let (mut level, mut warnings) = refine(kernel, interfaces, indentation, start, options, &mut work)?;
        // what is too strict for the arithmetic, or for memory, may end with fewer digits than what is less strict
        for looser in LOOSER.map(|factor| factor * options.tolerance.max(BEST)) {
            if level.worst_error() <= looser || level.worst_error() > WORTH_IT {
                break;
            }
            let start = Start::Formulas { half_lengths: level.half_lengths.clone(), finer: 1 };
            let options = Options { tolerance: looser, ..*options };
            match refine(kernel, interfaces, indentation, start, &options, &mut work) {
                Ok((other, _)) if other.worst_error() < level.worst_error() => level = other,
                _ => {}
            }
        }
        if level.worst_error() <= options.tolerance {
            warnings.clear();
        }
        // nobody needs a half-length that nothing depends on
        let is_unknown = |[length, pressure]: &[f64; 2]| {
            length.is_nan() || pressure.is_nan() || *length > UNKNOWN && *pressure > UNKNOWN
        };
        if level.errors.iter().any(is_unknown) {
            return Err(newton::not_converged(kernel, indentation, &level.half_lengths));
        }
        let check = admissible::check(kernel, interfaces, indentation, &level)?;
        level.admit(&check);
        warnings.extend(check.overlaps.iter().map(|overlap| touching_again(kernel, interfaces, overlap)));
        warnings.extend(uncertain(kernel, interfaces, &level));
        let again = check.overlaps.iter().map(|overlap| interfaces[overlap.contact]).collect();
        let solution = solution(kernel, interfaces, indentation, level, check, work.clone(), warnings);
        Ok(Answer { solution, again })
    };
    if let Some(start) = lattice.and_then(|lattice| lattice.start(kernel, interfaces, indentation))
        && let Ok(answer) = from(start)
        && answer.solution.warnings.is_empty()
    {
        return Ok(answer.solution);
    }
    from_any_start(
        kernel,
        interfaces,
        indentation,
        options,
        |half_lengths, finer| from(Start::Formulas { half_lengths, finer }),
        |expected, far| programme::answer(kernel, interfaces, indentation, expected, far),
    )
}

/// What is to be said of half-lengths that are not known.
fn uncertain(kernel: &Kernel, interfaces: &[Interface], level: &Level) -> Vec<String> {
    let unknown = (0..interfaces.len()).filter(|i| level.errors[*i][0] > UNKNOWN);
    let about = |i: usize| match level.faded[i] {
        Some(_) => format!(
            "no end of the contact {} was found: the pressure there fades, and nothing depends on what is beyond x = {:.3e}",
            interfaces[i],
            level.half_lengths[i] * kernel.length()
        ),
        None => format!(
            "the half-length of the contact {} is known to {:.0} % only, and next to nothing depends on it",
            interfaces[i],
            100.0 * level.errors[i][0]
        ),
    };
    unknown.map(about).collect()
}

/// What is to be said of contacts in several parts.
fn in_parts(contacts: &[Contact]) -> impl Iterator<Item = String> {
    contacts.iter().flat_map(|Contact { interface, opening, parts, .. }| {
        let several = "is in several parts: its half-length is that of the innermost";
        let apart = "is open about x = 0: its half-length is where the innermost part of it ends";
        let both = [(!parts.is_empty(), several), (*opening > 0.0, apart)];
        both.into_iter().filter(|(said, _)| *said).map(move |(_, what)| format!("contact {interface} {what}"))
    })
}

fn touching_again(kernel: &Kernel, interfaces: &[Interface], overlap: &admissible::Overlap) -> String {
    format!(
        "the bodies at the contact {} touch again about x = {:.3e}; the force there, with {:.0e} of the moment of the \
         whole force, is left out",
        interfaces[overlap.contact],
        overlap.x * kernel.length(),
        overlap.moment
    )
}

/// What it took to evaluate the stack.
pub(crate) fn stats(kernel: &Kernel) -> Stats {
    let kernel::Work { wavenumbers, layers, repeated, unfelt } = kernel.work();
    let (dropped, merged) = (kernel.dropped(), kernel.merged());
    Stats {
        dropped,
        merged,
        wavenumbers,
        layers,
        repeated,
        unfelt,
        uncoupled: kernel.uncoupled_values(),
        ..Stats::default()
    }
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
                let strips = given::strips(load, force);
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
                terms.for_each(|(m, c)| *c -= 2.0 * alternating(m) * tip / order(m));
            }
            let [length_error, pressure_error] = level.errors[i];
            Contact {
                interface: *interface,
                half_length,
                half_length_error: length_error * half_length,
                peak_pressure,
                peak_pressure_error: if peak_pressure.is_finite() { pressure_error * peak_pressure } else { 0.0 },
                resultant,
                strips: vec![Strip { corners, tip, ..Strip::series(half_length, coefficients) }],
                opening: 0.0,
                opening_error: 0.0,
                parts: Vec::new(),
            }
        })
        .collect();
    Solution {
        contacts,
        stack: None,
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

    use super::*;
    use crate::contact::problem::load::Given;
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
