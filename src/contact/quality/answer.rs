//! What a refinement level that passed the checks tells of the contacts.
use std::f64::consts::PI;

use crate::contact::answer::{Answer, Found};
use crate::contact::ends::newton::Work;
use crate::contact::problem::Problem;
use crate::contact::problem::twin::Twin;
use crate::contact::quality::admissible::{Check, Recontact};
use crate::contact::quality::estimates::{BEST, Level, UNKNOWN};
use crate::contact::quality::levels::Refined;
use crate::solution::{Interface, Interval, Stats, Strip, Warning, WarningCode};

/// The answer that a level is, and what the user should know of it.
pub(crate) fn answer(problem: &Problem, refined: Refined, check: Check, work: Work) -> Answer {
    let Refined { mut level, not_met, .. } = refined;
    let mut warnings: Vec<Warning> = precision(problem, not_met).into_iter().collect();
    level.admit(&check);
    warnings.extend(check.recontacts.iter().map(|recontact| self::recontact(problem, recontact)));
    warnings.extend(problem.unknown().filter_map(|i| unknown_end_of(problem, &level, i)));
    let contacts = problem.unknown().map(|i| found(problem.twin(), &level, i)).collect();
    Answer {
        contacts,
        min_pressure: check.min_pressure,
        min_gap: check.min_gap,
        rotations: Vec::new(),
        stats: Stats {
            modes: level.counts,
            newton_steps: work.steps,
            factorisations: work.factorisations,
            interpolated: work.interpolated,
            stopped: work.stopped,
            ..problem.kernel.stats()
        },
        warnings,
    }
}

/// Contact i of a level.
fn found(twin: Twin, level: &Level, i: usize) -> Found {
    let half_length = level.support.half_lengths[i];
    let unit = twin.unit(half_length);
    let mut coefficients: Vec<f64> = twin.coefficients(&level.modes[i]).iter().map(|c| c * unit).collect();
    let corners = twin.edge() * level.support.intensity(i).unwrap_or(0.0) * unit / PI;
    let tip = twin.tip(level.apexes[i]) * unit / PI;
    coefficients[0] -= 2.0 * twin.norm * corners;
    if tip != 0.0 {
        // arcosh(1/|cos φ|) is a closed form for all modes together
        coefficients.truncate(level.counts[i]);
        let terms = coefficients.iter_mut().enumerate();
        terms.for_each(|(m, c)| *c -= twin.tip_mode(m, tip));
    }
    let (error, peak, size) = (level.errors[i], level.peaks[i] * unit, level.sizes[i] * unit);
    let to_error = error.length * half_length;
    let peak_error = if peak.is_finite() { error.pressure * size } else { f64::INFINITY };
    let strip =
        Strip { corners: [corners; 2], tip, is_round: twin == Twin::Round, ..Strip::series(half_length, coefficients) };
    Found::even(&[Interval::new([0.0; 2], [half_length, to_error])], [peak, peak_error], &[strip])
}

/// What is to be said of a tolerance that is not met, or beyond double precision.
fn precision(problem: &Problem, not_met: Option<usize>) -> Option<Warning> {
    let tolerance = problem.tolerance;
    match not_met {
        Some(modes) => Some(Warning::new(
            WarningCode::ToleranceNotMet,
            format!(
                "the tolerance {tolerance:e} is not met with {modes} modes; the error estimates tell what was reached"
            ),
        )),
        None if tolerance < BEST => Some(Warning::new(
            WarningCode::BeyondDoublePrecision,
            format!(
                "a tolerance of {tolerance:e} is beyond double precision; the error estimates tell what was reached"
            ),
        )),
        None => None,
    }
}

/// What is to be said of a half-length that is not known.
fn unknown_end_of(problem: &Problem, level: &Level, i: usize) -> Option<Warning> {
    let (error, interface) = (level.errors[i].length, problem.interfaces[i]);
    if error <= UNKNOWN {
        return None;
    }
    Some(match level.support.decay(i) {
        Some(_) => {
            let message = format!(
                "no end of the contact {interface} was found: the pressure there decays, and nothing depends on what is beyond \
                 {:.3e} from the middle",
                level.support.half_lengths[i] * problem.kernel.length()
            );
            Warning::new(WarningCode::EndNotKnown, message)
        }
        None => unknown_end(interface, error),
    })
}

/// What is to be said of an end that is known as badly as that, relative.
pub(crate) fn unknown_end(interface: Interface, error: f64) -> Warning {
    let message = format!(
        "the end of the contact {interface} is known to {:.0} % only, and next to nothing depends on it",
        100.0 * error
    );
    Warning::new(WarningCode::EndNotKnown, message)
}

/// What is to be said of an interval that is left out.
pub(crate) fn recontact(problem: &Problem, recontact: &Recontact) -> Warning {
    let message = format!(
        "the bodies at the contact {} are in contact again about {:.3e} from the middle; the force there, with {:.0e} of the moment \
         of the total force, is left out",
        problem.interfaces[recontact.contact],
        recontact.x * problem.kernel.length(),
        recontact.moment
    );
    Warning::new(WarningCode::RecontactLeftOut, message)
}
