//! Contacts without an end that anything depends on.
//!
//! On a smooth rigid base, say, the pressure under a layer may fall like e^(−x) without ever changing its sign: each of
//! Newton's steps takes the end of such a contact as far as the one before, and less and less depends on it. Once that is
//! nothing, the end is left where it is, and all other numbers are found without it.
use crate::contact::equations::condensed::{Linearised, Pressures};

/// Steps that are longer than this part of the one before do not lead to an end: where a pressure falls exponentially, all are
/// of one length ...
const CONTRACTS: f64 = 0.95;
/// ... unless they are as short as this, relative.
const SHORT: f64 = 1e-3;
/// So many steps that lead outwards, none much shorter than the one before, make a contact that fades.
const STEPS: usize = 2;
/// More than this, relative, must not depend on an end that is left where it is.
const MOST_FELT: f64 = 1e-4;
/// What an end changes goes through its least where modes resolve it no longer: there it is so many times more.
const RISES: f64 = 4.0;
/// Nothing is known better than this.
const NOISE: f64 = 1e-13;

/// The end of a contact that fades.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Faded {
    /// What may depend on it, relative.
    pub(crate) felt: f64,
    /// How far on Newton's method would have it, relative: over that length the pressure falls to a third.
    pub(crate) decay: f64,
}

/// What is seen of the end of one contact during Newton's method.
#[derive(Clone, Debug)]
struct End {
    /// Length of the last step.
    last: f64,
    /// Steps outwards, one after the other.
    outwards: usize,
    /// Least that depended on it so far, relative, and the half-length then.
    least: (f64, f64),
    /// Whether it is left where it is.
    left: bool,
}

/// Which contacts fade.
#[derive(Clone, Debug, Default)]
pub(crate) struct Fading {
    ends: Vec<End>,
    /// Which were seen to fade on any level.
    seen: Vec<bool>,
}

impl Fading {
    /// Begins a level; the first contact may be `given`.
    pub(crate) fn begin(&mut self, contacts: usize, given: bool) {
        self.seen.resize(contacts, false);
        let end =
            |i: usize| End { last: f64::INFINITY, outwards: 0, least: (f64::INFINITY, 0.0), left: i == 0 && given };
        self.ends = (0..contacts).map(end).collect();
    }

    /// Which ends are not solved for.
    pub(crate) fn left(&self) -> Vec<bool> {
        self.ends.iter().map(|end| end.left).collect()
    }

    /// The ends of contacts that fade.
    pub(crate) fn faded(&self, half_lengths: &[f64]) -> Vec<Option<Faded>> {
        let faded = |((end, seen), a): ((&End, &bool), &f64)| {
            let decay = (end.last / a).min(1.0);
            (end.left && *seen).then_some(Faded { felt: end.least.0.max(NOISE), decay })
        };
        self.ends.iter().zip(&self.seen).zip(half_lengths).map(faded).collect()
    }

    /// Looks at a step before it is taken, with the half-lengths where it begins; whether an end more is to be left where it is
    /// now, since no more than `little` depends on it.
    pub(crate) fn look(
        &mut self,
        half_lengths: &mut [f64],
        pressures: &Pressures,
        linearised: &Linearised,
        little: f64,
    ) -> bool {
        let mut more = false;
        // the contact under the punch ends where the punch leaves it
        for (i, end) in self.ends.iter_mut().enumerate().skip(1).filter(|(_, end)| !end.left) {
            let step = pressures.step[i];
            let length = step.abs() * half_lengths[i];
            let before = std::mem::replace(&mut end.last, length);
            if step.abs() < SHORT {
                end.outwards = 0;
                continue;
            }
            let leads_on = length > CONTRACTS * before;
            let outwards = step > 0.0 && leads_on;
            end.outwards = if outwards { end.outwards + 1 } else { 0 };
            let known = self.seen[i] || end.outwards >= STEPS;
            let felt = linearised.felt(i, pressures);
            if known && leads_on && end.least.0 <= MOST_FELT && felt > RISES * end.least.0 {
                // no nearer than this
                half_lengths[i] = end.least.1;
                end.left = true;
            } else {
                if felt < end.least.0 {
                    end.least = (felt, half_lengths[i]);
                }
                end.left = known && outwards && felt <= little.max(NOISE);
            }
            self.seen[i] |= end.left;
            more |= end.left;
        }
        more
    }
}
