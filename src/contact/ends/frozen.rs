//! Decaying contacts: their ends are frozen once nothing depends on them.
//!
//! On a smooth rigid base, say, the pressure under a layer may fall like e^(−x) without ever changing its sign: each of
//! Newton's steps moves the end of such a contact outwards as far as the one before, and less and less depends on it. Once
//! that is nothing, the end stays where it is, and all other unknowns are found without it.
use crate::contact::equations::condensed::{Linearised, Pressures};
use crate::contact::problem::accuracy::{COARSE, ROUNDING};
use crate::contact::problem::support::{Decay, End, Support};
use crate::contact::problem::{Problem, Side};

/// Steps that are longer than this part of the one before do not lead to an end: where a pressure falls exponentially, all are
/// of one length ...
const CONTRACTS: f64 = 0.95;
/// ... unless they are as short as this, relative.
const SHORT: f64 = 1e-3;
/// The number of steps outwards, none much shorter than the one before, after which a contact is said to decay.
const STEPS: usize = 2;
/// The sensitivity to an end goes through a minimum where modes resolve it no longer: there it rises by this factor.
const RISES: f64 = 4.0;

/// What is seen of the end of one contact during Newton's method.
#[derive(Clone, Debug)]
struct Watch {
    /// Length of the last step.
    last: f64,
    /// Steps outwards, one after the other.
    outwards: usize,
    /// The least sensitivity to the end so far, relative, and the half-length then.
    least: (f64, f64),
}

impl Default for Watch {
    fn default() -> Self {
        Self { last: f64::INFINITY, outwards: 0, least: (f64::INFINITY, 0.0) }
    }
}

/// Which contacts decay.
#[derive(Clone, Debug, Default)]
pub(crate) struct Decaying {
    watches: Vec<Watch>,
    /// Which were seen to decay on any level.
    seen: Vec<bool>,
}

impl Decaying {
    /// Begins a new solution of Newton's method.
    pub(crate) fn begin(&mut self, contacts: usize) {
        self.seen.resize(contacts, false);
        self.watches = vec![Watch::default(); contacts];
    }

    /// Looks at a step before it is taken, with the support where it begins, and freezes the ends on which no more than
    /// `negligible`, relative, depends; whether there were any.
    pub(crate) fn freeze(
        &mut self,
        problem: &Problem,
        support: &mut Support,
        pressures: &Pressures,
        linearised: &Linearised,
        negligible: f64,
    ) -> bool {
        let mut any = false;
        for (i, watch) in self.watches.iter_mut().enumerate() {
            // the contact under a punch ends where the punch leaves it
            if !matches!(problem.sides[i], Side::Closed) || support.ends[i] != End::Free {
                continue;
            }
            let (step, a) = (pressures.step[i], &mut support.half_lengths[i]);
            let length = step.abs() * *a;
            let before = std::mem::replace(&mut watch.last, length);
            if step.abs() < SHORT {
                watch.outwards = 0;
                continue;
            }
            let leads_on = length > CONTRACTS * before;
            let outwards = step > 0.0 && leads_on;
            watch.outwards = if outwards { watch.outwards + 1 } else { 0 };
            let known = self.seen[i] || watch.outwards >= STEPS;
            let sensitivity = linearised.sensitivity(i, pressures);
            let frozen = if known && leads_on && watch.least.0 <= COARSE && sensitivity > RISES * watch.least.0 {
                // the sensitivity is never less than it was there
                *a = watch.least.1;
                true
            } else {
                if sensitivity < watch.least.0 {
                    watch.least = (sensitivity, *a);
                }
                known && outwards && sensitivity <= negligible.max(ROUNDING)
            };
            if frozen {
                let length = (watch.last / *a).min(1.0);
                support.ends[i] = End::Frozen(Decay { sensitivity: watch.least.0.max(ROUNDING), length });
                (self.seen[i], any) = (true, true);
            }
        }
        any
    }
}
