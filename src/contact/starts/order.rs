//! Which starts are tried, one after the other, until an answer is found that can be believed.
use std::cell::Cell;

use crate::contact::error::{ContactError, NoSolution};
use crate::contact::problem::profile::Indentation;
use crate::contact::quality::estimate::ENDLESS;
use crate::contact::starts::formulas;
use crate::contact::{parts, programme};
use crate::kernel::Kernel;
use crate::numeric::largest;
use crate::options::Options;
use crate::solution::{Interface, Solution};

/// Pressures are resolved so many times better from the outset, one after the other, as next to thin, stiff coatings.
const FINER: [usize; 3] = [1, 8, 32];

/// Half-lengths with larger relative errors are taken only if there are no better ones.
const DOUBTFUL: f64 = 1e-4;
/// An interval off the middle counts as a contact that is open there if it ends so many times farther out than it begins.
const OPEN: f64 = 2.0;
/// How often a contact that would have to pull is tried again with an end where it would, and before.
const SHORTER: usize = 3;
/// Each time by so many thicknesses of the thinner body.
const BENT: f64 = 2.5;

/// An answer, and in which contacts bodies touch again with a force that is left out.
pub(crate) struct Answer {
    pub(crate) solution: Solution,
    pub(crate) again: Vec<Interface>,
}

impl From<Solution> for Answer {
    fn from(solution: Solution) -> Self {
        Self { solution, again: Vec::new() }
    }
}

/// Solves from half-lengths that formulas expect, and where that fails from those of the convex programme. `solve` is
/// told, too, how much finer to begin; `last_resort`, what is expected, and how far out bodies would overlap otherwise.
pub(crate) fn from_any_start(
    kernel: &Kernel,
    interfaces: &[Interface],
    indentation: &Indentation,
    options: &Options,
    mut solve: impl FnMut(Vec<f64>, usize) -> Result<Answer, ContactError>,
    last_resort: impl FnOnce(&[f64], f64) -> Option<Solution>,
) -> Result<Solution, ContactError> {
    let expected = formulas::half_lengths(kernel, indentation)?;
    // an answer of few digits may be that of a false root: another one is looked for
    let mut doubtful: Option<(f64, Answer)> = None;
    let (in_parts, far) = (Cell::new(None), Cell::new(0.0));
    let decided =
        decide(kernel, interfaces, indentation, options, &expected, &in_parts, &far, |half_lengths, finer| {
            let answer = solve(half_lengths, finer)?;
            let contacts = &answer.solution.contacts;
            let errors = contacts.iter().map(|contact| contact.half_length_error / contact.half_length);
            let worst = largest(errors.filter(|error| error.is_nan() || *error < ENDLESS));
            // where bodies touch again, an answer has to know of it
            let all_known = in_parts.get().is_none_or(|interface| answer.again.contains(&interface));
            if all_known && (answer.solution.warnings.is_empty() || worst <= DOUBTFUL) {
                return Ok(answer.solution);
            }
            let half_lengths = contacts.iter().map(|contact| contact.half_length).collect();
            if all_known && doubtful.as_ref().is_none_or(|(least, _)| worst < *least) {
                doubtful = Some((worst, answer));
            }
            Err(NoSolution::NotConverged { half_lengths }.into())
        });
    let solution = match (decided, doubtful) {
        (Err(ContactError::NoSolution(_)), Some((_, Answer { solution, again })))
            if in_parts.get().is_none_or(|interface| again.contains(&interface)) =>
        {
            Ok(solution)
        }
        (Err(ContactError::NoSolution(failure)), _) if !matches!(failure, NoSolution::PunchTooSmall { .. }) => {
            last_resort(&expected, far.get()).ok_or(failure.into())
        }
        (decided, _) => decided,
    }?;
    indentation.too_small(solution.contacts[0].reach() / kernel.length()).map_or(Ok(solution), Err)
}

/// Goes through all starts; `in_parts` tells which contact has several parts for certain, `far` how far out bodies would overlap.
#[expect(clippy::too_many_arguments, reason = "all that makes a scene, and what is learnt on the way")]
fn decide(
    kernel: &Kernel,
    interfaces: &[Interface],
    indentation: &Indentation,
    options: &Options,
    expected: &[f64],
    in_parts: &Cell<Option<Interface>>,
    far: &Cell<f64>,
    mut solve: impl FnMut(Vec<f64>, usize) -> Result<Solution, ContactError>,
) -> Result<Solution, ContactError> {
    let mut failure = match solve(expected.to_vec(), 1) {
        Err(ContactError::NoSolution(failure)) if !matches!(failure, NoSolution::PunchTooSmall { .. }) => failure,
        decided => return decided,
    };
    let (mut zones, mut for_certain) = (None, None);
    // once more if bodies would overlap farther out than was looked at
    for _ in 0..2 {
        let overlap = if let NoSolution::Overlap { x, .. } = failure { x / kernel.length() } else { 0.0 };
        if zones.is_some() && overlap <= far.get() {
            break;
        }
        far.set(overlap);
        zones = programme::zones(kernel, indentation, expected, overlap);
        if let Some((interface, error)) = several(kernel, interfaces, zones.as_deref(), true)
            && for_certain.is_none()
        {
            let zones = zones.as_deref().unwrap_or_default();
            if let Some(solution) = parts::solve(kernel, interfaces, indentation, zones, options) {
                return Ok(solution);
            }
            // one part may be next to nothing
            in_parts.set(Some(interface));
            for_certain = Some(error);
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
            for so_far in 0..SHORTER {
                match solve(half_lengths.clone(), finer) {
                    Err(ContactError::NoSolution(found)) => failure = found,
                    decided => return decided,
                }
                // there are roots whose contacts reach past where they should end
                let NoSolution::Tension { interface, x } = failure else { break };
                let fixed = usize::from(indentation.flat().is_some());
                let pulling = interfaces.iter().position(|contact| *contact == interface);
                let Some(pulling) = pulling.filter(|pulling| *pulling >= fixed) else { break };
                half_lengths[pulling] = shorter(kernel, pulling, x / kernel.length(), so_far);
            }
        }
    }
    if let Some(error) = for_certain {
        return Err(error);
    }
    let error = several(kernel, interfaces, zones.as_deref(), false).map(|(_, error)| error);
    let zones = zones.unwrap_or_default();
    let apart = zones.iter().any(|zones| zones.intervals().first().is_some_and(|first| first[0] > 0.0));
    let solution =
        if error.is_some() || apart { parts::solve(kernel, interfaces, indentation, &zones, options) } else { None };
    solution.ok_or_else(|| error.unwrap_or_else(|| failure.into()))
}

/// Where contact i may end if it pulls at x: there, and later where the thinner of its bodies is bent no more.
fn shorter(kernel: &Kernel, i: usize, x: f64, so_far: usize) -> f64 {
    let laminates = kernel.laminates();
    let neighbours = i.checked_sub(1).into_iter().chain([i]).filter_map(|l| laminates.get(l));
    let thickness = neighbours.map(|(thickness, _)| *thickness).fold(f64::INFINITY, f64::min);
    (x - BENT * so_far as f64 * thickness).max(0.5 * x)
}

/// The contact in which bodies touch in several intervals, or in none about the middle, and the error that says so.
fn several(
    kernel: &Kernel,
    interfaces: &[Interface],
    zones: Option<&[programme::Zones]>,
    certain: bool,
) -> Option<(Interface, ContactError)> {
    let finite = |zones: &programme::Zones| zones.sure.iter().filter(|part| part[1].is_finite()).count();
    // layers that lie flat on each other far away touch without a force: they do not say that there is no answer
    let count = |zones: &programme::Zones| if certain { finite(zones) } else { zones.apart.len() };
    // bodies that do not touch about the middle touch in two intervals, one on either side
    let open = |zones: &programme::Zones| match zones.sure[..] {
        [[from, to]] => !certain && from > 0.0 && to.is_finite() && to > OPEN * from,
        _ => false,
    };
    // a zone under the punch too short for the grid says nothing
    let plausible =
        |i: usize, zones: &programme::Zones| i > 0 || zones.apart.first().is_some_and(|part| part[0] == 0.0);
    let mut all = zones?.iter().enumerate();
    let (i, zones) = all.find(|(i, zones)| open(zones) || count(zones) > 1 && plausible(*i, zones))?;
    let parts = zones.intervals().iter().map(|part| part.map(|x| x * kernel.length())).collect();
    Some((interfaces[i], NoSolution::Parts { interface: interfaces[i], parts }.into()))
}
