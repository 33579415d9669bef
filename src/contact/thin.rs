//! Contacts next to layers that are much thinner than the contact is long.
//!
//! A loose layer of that kind has no bending stiffness but in a boundary layer at the ends of its contacts, about as long as a
//! line load on it would touch below: elsewhere both of its faces carry the same pressure, and it is compressed like a Winkler
//! foundation. So it is left out: its two contacts are one.
//!
//! Waves that tell such a layer from what lies behind it are shorter than the modes of the pressure resolve; they change the
//! pressure in a boundary layer at the ends of the contact only, and all else by about the ratio of thickness to
//! half-length, which first-order perturbation tells: the change of the diagonal of the equations. So the contact is
//! solved without these waves, and that change is part of the error.
use crate::contact::problem::accuracy::{COARSE, ROUNDING, SAFETY, SLOW, UNKNOWN};
use std::borrow::Cow;
use std::f64::consts::PI;

use crate::contact::answer::Answer;
use crate::contact::error::ContactError;
use crate::contact::intervals::{self, Refused, Sinking};
use crate::contact::problem::{Problem, Side};
use crate::contact::starts::formulas;
use crate::contact::starts::order::solve_in_order;
use crate::kernel::{DECAYED, Kernel};
use crate::numeric::largest;
use crate::solution::{Contact, Interface, Solution, Warning, WarningCode};

/// A kernel without the waves that only thin layers at the faces of contacts tell apart.
struct Thin<'a> {
    kernel: Cow<'a, Kernel>,
    /// By how much what is left out changes an answer at most, relative.
    error: f64,
    /// Thickness of the thinnest of the layers over the half-length next to it.
    thinnest: f64,
    /// Next to which contacts of that kernel, and by how much a layer there changes the answer.
    contacts: Vec<(usize, f64)>,
    /// Contacts of the stack that are one with the contact above them, from the bottom up, and the relative error of that.
    joined: Vec<(usize, f64)>,
}

/// Terms of a pressure that count as the first and as the last ones where layers are judged. Twice as many: layers are left out only half as thick as now.
const COARSEST: usize = 8;
const FINEST: usize = 512;

/// Solves without what only layers much thinner than a contact change in the kernels if that makes the smaller error.
///
/// Which layers these are is judged by contacts that were found to a few digits, without the layers that are thin next to contacts that formulas expect: the
/// latter may be wrong by any factor. All contacts are near these, unless what is thin changes them: from there each step of an end would be as short as a layer is thick.
pub(super) fn solve(problem: &Problem, refused: &mut Refused) -> Result<Answer, ContactError> {
    let mut half_lengths = formulas::half_lengths(problem);
    let Some(expected) = Thin::new(problem, half_lengths.clone())? else {
        return solve_in_order(problem, None, refused);
    };
    // contacts by which layers are judged are not looked for any longer
    let (tolerance, operations) = (problem.tolerance.max(COARSE), 0.02 * problem.operations);
    let rough = expected.without(problem, tolerance, operations, None, &mut Refused::default());
    let near = rough.as_ref().ok().map(|rough| &rough.contacts[..]);
    for (found, contact) in near.into_iter().flatten().zip(problem.unknown()) {
        half_lengths[contact] = found.innermost().right;
    }
    match Thin::new(problem, half_lengths)? {
        Some(thin) if thin.error <= UNKNOWN => thin.solve(problem, near, refused),
        Some(_) => solve_in_order(problem, None, refused),
        None => solve_in_order(problem, near, refused),
    }
}

/// How far each punch of a solution has sunk; without what only layers much thinner than a contact change, if it was found so.
pub(super) fn sinking(problem: Problem, solution: &Solution) -> Option<Vec<Sinking>> {
    let is_left_out = |warning: &Warning| warning.code == WarningCode::ThinLayerLeftOut;
    if !solution.warnings.iter().any(is_left_out) {
        return intervals::sinking(problem, solution);
    }
    let half_length = |contact: &Contact| contact.innermost().right / problem.kernel.length();
    let thin = Thin::new(&problem, solution.contacts.iter().map(half_length).collect()).ok()??;
    let mut simpler = solution.clone();
    for (lower, _) in &thin.joined {
        simpler.contacts.remove(*lower);
        simpler.stats.terms.remove(*lower);
    }
    let interfaces = thin.interfaces(problem.interfaces);
    intervals::sinking(problem.on(&thin.kernel, &interfaces, problem.tolerance), &simpler)
}

/// The largest relative error of an answer.
fn worst(answer: &Answer) -> f64 {
    let errors = answer.contacts.iter().flat_map(|contact| {
        // a pressure of 0 is known, and an infinite one cannot be missed
        let [middle, error] = contact.middle_pressure;
        let is_known = middle == 0.0 || middle.is_infinite();
        [contact.end_error(), if is_known { 0.0 } else { error / middle }]
    });
    largest(errors)
}

impl<'a> Thin<'a> {
    /// What is thin next to contacts of these half-lengths; `None` if modes resolve all that matters.
    fn new(problem: &Problem<'a>, mut half_lengths: Vec<f64>) -> Result<Option<Self>, ContactError> {
        let (contacts, joined) = (Vec::new(), Vec::new());
        let mut thin = Self { kernel: Cow::Borrowed(problem.kernel), error: 0.0, thinnest: 1.0, contacts, joined };
        if !problem.sides.iter().any(Side::is_sharp) {
            for upper in problem.unknown().collect::<Vec<_>>().into_iter().rev().skip(1) {
                // bodies that were apart may touch elsewhere than those above them
                if !matches!(problem.sides[upper + 1], Side::Closed) {
                    continue;
                }
                thin.join_below(upper, &mut half_lengths)?;
            }
        }
        for (contact, half_length) in half_lengths.iter().enumerate().filter(|(i, _)| !problem.is_known(*i)) {
            let Some((from, error)) = beyond_modes(&thin.kernel, contact, *half_length, &half_lengths) else {
                continue;
            };
            thin.thinnest = thin.thinnest.min(DECAYED / (thin.kernel.asymptote(contact).from * half_length));
            thin.kernel = Cow::Owned(thin.kernel.cut_off(contact, from));
            thin.error = thin.error.max(error);
            thin.contacts.push((contact, error));
        }
        Ok((!thin.contacts.is_empty() || !thin.joined.is_empty()).then_some(thin))
    }

    /// Solves without what is thin, or the whole problem where that makes the smaller error.
    fn solve(
        &self,
        problem: &Problem,
        near: Option<&[Contact]>,
        refused: &mut Refused,
    ) -> Result<Answer, ContactError> {
        // with and without together take half as long again as one of them at most
        let operations = 0.5 * problem.operations;
        let without = |refused: &mut Refused| self.without(problem, problem.tolerance, operations, near, refused);
        // the boundary layer at the ends of a contact is as long as a layer there is thick, up to φ = √(2 h/a) of x = a cos φ: shorter than a wave of the highest modes
        let is_unresolved = (2.0 * self.thinnest).sqrt() * (2 * FINEST) as f64 <= 2.0 * PI;
        if self.error <= problem.tolerance || is_unresolved {
            return without(refused).or_else(|_| solve_in_order(problem, None, refused));
        }
        let whole = solve_in_order(problem, None, refused);
        if whole.as_ref().is_ok_and(|whole| worst(whole) <= self.error) {
            return whole;
        }
        match without(refused) {
            Ok(less) if !whole.as_ref().is_ok_and(|whole| worst(whole) <= worst(&less)) => Ok(less),
            _ => whole,
        }
    }

    /// Solves without what is thin.
    fn without(
        &self,
        problem: &Problem,
        tolerance: f64,
        operations: f64,
        near: Option<&[Contact]>,
        refused: &mut Refused,
    ) -> Result<Answer, ContactError> {
        let interfaces = self.interfaces(problem.interfaces);
        // no more digits are of use than are left
        let tolerance = tolerance.max(0.1 * self.error);
        let simpler = Problem { operations, ..problem.on(&self.kernel, &interfaces, tolerance) };
        let near = near.map(|contacts| {
            let all = contacts.iter().zip(problem.unknown());
            all.filter(|(_, contact)| !self.is_joined(*contact)).map(|(found, _)| found.clone()).collect::<Vec<_>>()
        });
        solve_in_order(&simpler, near.as_deref(), refused).map(|answer| self.admit(answer, problem))
    }

    /// Leaves out the laminate below a contact, which is one with the next contact then, if modes do not resolve how far the
    /// laminate carries a line load.
    fn join_below(&mut self, upper: usize, half_lengths: &mut Vec<f64>) -> Result<(), ContactError> {
        let (a, carried) = (half_lengths[upper], formulas::carried(&self.kernel, upper));
        if carried.is_nan() || carried * (2 * FINEST) as f64 > a {
            return Ok(());
        }
        // a layer gives way to longer waves by the same displacement as to those as short as it is thick
        let [longest, shortest] = [a, carried].map(|length| formulas::TYPICAL / length);
        let squeezed = self.kernel.compression(upper, shortest) / shortest;
        self.kernel = Cow::Owned(self.kernel.without(upper)?);
        // a part of the pressure that is as long as a wave: where bodies are so stiff that it is concentrated at the ends, a short one counts
        let changed = |zeta: f64| {
            let squeezed = squeezed * zeta;
            squeezed / (squeezed + self.kernel.compliances(zeta)[upper].max(0.0)) * longest / zeta
        };
        let waves = std::iter::successors(Some(longest), |zeta| Some(2.0 * zeta)).take_while(|zeta| *zeta < shortest);
        let error = SAFETY * carried / a + SAFETY * largest(waves.map(changed));
        half_lengths.remove(upper + 1);
        self.thinnest = self.thinnest.min(carried / a);
        self.error = self.error.max(error);
        self.joined.push((upper + 1, error));
        Ok(())
    }

    /// The stack's contacts that the kernel has, too.
    fn interfaces(&self, all: &[Interface]) -> Vec<Interface> {
        all.iter()
            .enumerate()
            .filter(|(contact, _)| !self.is_joined(*contact))
            .map(|(_, interface)| *interface)
            .collect()
    }

    /// Whether a contact of the stack is one with the contact above.
    fn is_joined(&self, contact: usize) -> bool {
        self.joined.iter().any(|(lower, _)| *lower == contact)
    }

    /// The answer for all contacts of the problem, with what is left out in its errors, and a warning that says so.
    fn admit(&self, mut answer: Answer, problem: &Problem) -> Answer {
        let solved = self.interfaces(problem.interfaces);
        for contact in &mut answer.contacts {
            for interval in &mut contact.intervals {
                let [left, right] = [interval.left, interval.right].map(f64::abs);
                // of an end that is not found no more than all
                interval.left_error = (interval.left_error + self.error * left).min(left);
                interval.right_error = (interval.right_error + self.error * right).min(right);
            }
            let [middle, error] = &mut contact.middle_pressure;
            *error += self.error * middle.abs();
        }
        if !problem.prescribed.is_empty() {
            answer.force[1] += self.error * answer.force[0];
        }
        answer.warnings.extend(self.contacts.iter().map(|(contact, error)| {
            left_out(format!(
                "a layer next to the contact {} is so thin that it is left out: it changes the ends of contacts and pressures by \
                 about {error:.0e}, and the pressure near the ends of the contact over about as long as it is thick",
                solved[*contact]
            ))
        }));
        let known = (0..problem.contacts()).filter(|i| problem.is_known(*i)).count();
        for (lower, error) in self.joined.iter().rev() {
            let above = answer.contacts[lower - known - 1].clone();
            answer.contacts.insert(lower - known, Contact { interface: problem.interfaces[*lower], ..above });
            answer.stats.modes.insert(*lower, answer.stats.modes[*lower - 1]);
            if let Some(above) = answer.stats.terms.get(*lower - 1).cloned() {
                answer.stats.terms.insert(*lower, above);
            }
            answer.warnings.push(left_out(format!(
                "the layer above the contact {} is so thin that it is left out, and both of its faces carry the same \
                 pressure: that changes the ends of the contact by about {error:.0e}, and the pressure near the ends of the contact",
                problem.interfaces[*lower]
            )));
        }
        answer
    }
}

fn left_out(message: String) -> Warning {
    Warning::new(WarningCode::ThinLayerLeftOut, message)
}

/// The wavenumber beyond which the kernel of a contact may be held constant, and what that may change in the answer; `None` if
/// the modes resolve the layers at its faces, or waves that short still couple it to its neighbours.
fn beyond_modes(kernel: &Kernel, contact: usize, half_length: f64, half_lengths: &[f64]) -> Option<(f64, f64)> {
    let highest = (2 * FINEST) as f64 / half_length;
    if kernel.asymptote(contact).from <= highest {
        return None;
    }
    let coupled = |i: usize| kernel.uncoupled(i, half_lengths[i].min(half_lengths[i + 1]), ROUNDING);
    let couplings = contact.saturating_sub(1)..(contact + 1).min(half_lengths.len() - 1);
    let lowest = couplings.map(coupled).fold((2 * COARSEST) as f64 / half_length, f64::max);
    let error = |from: f64| SAFETY * 2.0 / (PI * half_length) * kernel.left_out(contact, from);
    let least = error(highest);
    let octaves = std::iter::successors(Some(lowest), |from| Some(2.0 * from)).take_while(|from| *from <= highest);
    // waves that hardly make the change smaller cost time
    octaves.map(|from| (from, error(from))).find(|(_, error)| least >= SLOW * *error)
}
