//! How well ends and pressures are known.
use crate::contact::intervals::gaps::Signs;
use crate::contact::intervals::newton::Approximation;
use crate::contact::intervals::steps::{SHORT, looks};
use crate::contact::intervals::support::{ContactInterval, Intervals};
use crate::contact::problem::Problem;
use crate::contact::problem::accuracy::{ENDLESS, ROUNDING, SAFETY, UNKNOWN};
use crate::numeric::largest;
use crate::solution::{Warning, WarningCode};

/// Changes from level to level are said to fall at least this fast, and at most.
const MOST_FALL: f64 = 0.75;
const LEAST_FALL: f64 = 0.01;
pub(super) const LEAST_FALL_GRADED: f64 = 0.1;
const LEAST_FALL_KINKED: f64 = 0.5;

/// How well ends and pressures are known, from what fewer terms tell of them.
pub(super) struct Errors {
    /// Of the ends of each interval, relative.
    pub(super) ends: Vec<[f64; 2]>,
    /// Of the pressure in the middle of each interval, relative to the largest of these of the contact.
    pub(super) pressures: Vec<f64>,
    /// Of the force, relative, if that is to be found.
    pub(super) force: f64,
    /// Whether terms resolve the layers at the faces of contacts.
    pub(super) resolves: bool,
    /// The most that is due to something else than the number of terms.
    pub(super) floor: f64,
    /// The most that is due to missing terms.
    pub(super) missing: f64,
    /// What is due to steps of ends, which go on with as many terms.
    pub(super) steps: f64,
    /// How much less half as many terms more change than those before.
    pub(super) fall: f64,
}

impl Errors {
    /// Estimates them from what the last third of the terms changes, and how much less that is than what the third before changes.
    pub(super) fn of(level: &Approximation, resolves: bool) -> Self {
        let all = &level.support.0;
        let moves = level.moves();
        let [own, some, few] = [&level.solved, &level.coarser[0], &level.coarser[1]]
            .map(|solved| level.middle_pressures(&solved.pressures));
        let size = |number: usize| level.largest_pressure(all[number].contact, &own);
        let differ = |number: usize| {
            [own[number] - some[number], some[number] - few[number]].map(|change| (change / size(number)).abs())
        };
        let changes: Vec<[f64; 2]> = (0..all.len()).map(differ).collect();
        let of_force = level.force_changes();
        // next to graded faces changes fall like a power
        let least = match level.graded.contains(&true) {
            // under a kink, or where terms do not resolve the layers at the faces, changes may be small by chance
            _ if !resolves || level.local.iter().any(|local| !local.terms.is_empty()) => LEAST_FALL_KINKED,
            true => LEAST_FALL_GRADED,
            false => LEAST_FALL,
        };
        let falls = [fall(&moves, least), fall(&changes, least), fall(&[of_force], least)];
        let [of_ends, of_pressures] = [falls[0], falls[1]].map(|fall| SAFETY * fall / (1.0 - fall));
        // short waves matter where an interval is short
        let rest = |interval: &ContactInterval| {
            SAFETY * level.left
                + 5.0 * ROUNDING.max(level.negligible)
                + level.left_out[interval.contact] / interval.half
        };
        let rests: Vec<f64> = all.iter().map(rest).collect();
        let steps = if level.is_rounding { 0.0 } else { SAFETY * level.left };
        let most = |changes: &[[f64; 2]]| largest(changes.iter().map(|[last, _]| last.abs()));
        let missing_force = beyond(of_force, least);
        let missing = (of_ends * most(&moves)).max(of_pressures * most(&changes)).max(missing_force);
        let mut next = moves.iter();
        let ends = |(interval, rest): (&ContactInterval, &f64)| {
            let mut errors = [*rest; 2];
            for side in interval.sides() {
                let k = usize::from(*side > 0.0);
                let moved = next.next().map_or(0.0, |[moved, _]| moved.abs() * interval.half / interval.sizes()[k]);
                errors[k] += of_ends * moved;
            }
            errors
        };
        let pressure = |(number, ([change, _], rest)): (usize, (&[f64; 2], &f64))| {
            of_pressures * change + rest + SAFETY * level.unmoved[number] / size(number)
        };
        Self {
            ends: all.iter().zip(&rests).map(ends).collect(),
            pressures: changes.iter().zip(&rests).enumerate().map(pressure).collect(),
            // a force grows no faster than the square of a depth
            force: missing_force + largest(rests.iter().copied()) + 2.0 * SAFETY * level.missed,
            floor: largest(rests.iter().copied()) - steps,
            missing,
            steps,
            resolves,
            fall: largest(falls),
        }
    }

    /// Adds what an answer is seen to be wrong by: tension, ends next to which pressures are no larger or on which nothing depends, and intervals that are left out.
    pub(super) fn admit(&mut self, level: &Approximation, signs: &Signs) {
        let unknown = level.unknown();
        for (number, interval) in level.support.0.iter().enumerate() {
            // a pressure that decays is singular at the end that is not found, and nothing depends on that
            if !unknown[number].contains(&ENDLESS) {
                self.pressures[number] = self.pressures[number].max(SAFETY * signs.tensions[interval.contact]);
            }
            for k in interval.sides().iter().map(|side| usize::from(*side > 0.0)) {
                let wrong = signs.ends[number][k].max(unknown[number][k]) * interval.half / interval.sizes()[k];
                self.ends[number][k] = self.ends[number][k].max(wrong);
            }
            for recontact in &signs.recontacts {
                let laminate = recontact.laminate..=recontact.laminate + 1;
                // a moment that is missing changes other contacts in proportion
                let moves =
                    if laminate.contains(&interval.contact) { recontact.moves() } else { SAFETY * recontact.moment };
                self.ends[number].iter_mut().for_each(|end| *end += moves);
                self.pressures[number] += recontact.moment;
            }
        }
    }

    /// What is to be said of the ends of a contact that are not known.
    pub(super) fn unknown_end(&self, problem: &Problem, support: &Intervals, contact: usize) -> Option<Warning> {
        let own = support.0.iter().zip(&self.ends).filter(|(interval, _)| interval.contact == contact);
        let free = own.flat_map(|(interval, ends)| {
            interval
                .sides()
                .iter()
                .filter(|side| !interval.is_corner(**side))
                .map(|side| ends[usize::from(*side > 0.0)])
        });
        let error = largest(free);
        let interface = problem.interfaces[contact];
        let reach = largest(support.of(contact).iter().map(ContactInterval::to)) * problem.kernel.length();
        let message = if error < ENDLESS {
            let percent = 100.0 * error;
            format!(
                "the end of the contact {interface} is known to {percent:.0} % only, and next to nothing depends on it"
            )
        } else {
            format!(
                "no end of the contact {interface} was found: the pressure there decays, and nothing depends on what is beyond \
                 {reach:.3e} from the middle"
            )
        };
        (error > UNKNOWN).then(|| Warning::new(WarningCode::EndNotKnown, message))
    }

    /// Whether the pressure of each interval is known, or its ends: nothing may depend on the latter.
    pub(super) fn are_known(&self) -> bool {
        let known =
            |(ends, pressure): (&[f64; 2], &f64)| *pressure <= UNKNOWN || ends.iter().all(|end| *end <= UNKNOWN);
        !self.worst().is_nan() && self.ends.iter().zip(&self.pressures).all(known)
    }

    pub(super) fn worst(&self) -> f64 {
        largest(self.ends.iter().flatten().chain(&self.pressures).copied().chain([self.force]))
    }
}

/// How much less half as many terms more change than those before, from what the last third of the terms changes and the third before, at least this much.
fn fall(changes: &[[f64; 2]], least: f64) -> f64 {
    let [last, before] = [0, 1].map(|k| largest(changes.iter().map(|change| change[k].abs())));
    if last > 0.0 { (last / before).clamp(least, MOST_FALL) } else { least }
}

/// What all further terms change, from what the last third of the terms changes and the third before.
pub(super) fn beyond(changes: [f64; 2], least: f64) -> f64 {
    let fall = fall(&[changes], least);
    SAFETY * fall / (1.0 - fall) * changes[0].abs()
}

impl Approximation {
    /// By how much the last third of the terms changes the forces that are to be found, and the third before, relative.
    fn force_changes(&self) -> [f64; 2] {
        let [own, some, few] = [&self.solved, &self.coarser[0], &self.coarser[1]].map(|solved| &solved.forces);
        let change = |one: &[f64], other: &[f64]| {
            largest(one.iter().zip(other).zip(own).map(|((one, other), own)| ((one - other) / own).abs()))
        };
        [change(own, some), change(some, few)]
    }

    /// By how much farther out fewer terms would put the ends of each interval, in half-lengths, and still fewer than these; nothing where next to nothing
    /// depends on an end.
    pub(super) fn moves(&self) -> Vec<[f64; 2]> {
        let [own, some, few] =
            [&self.solved, &self.coarser[0], &self.coarser[1]].map(|solved| looks(&self.support, &solved.pressures));
        let of = |k: usize| {
            if self.weak[k] { [0.0; 2] } else { [some[k].step - own[k].step, few[k].step - some[k].step] }
        };
        (0..own.len()).map(of).collect()
    }

    /// By how much farther out pressures would put the ends of each interval, in half-lengths, on which next to nothing depends; nothing for others. Where a pressure decays
    /// outwards no end is found.
    pub(super) fn unknown(&self) -> Vec<[f64; 2]> {
        let looks = looks(&self.support, &self.solved.pressures);
        let mut unknown = vec![[0.0; 2]; self.support.0.len()];
        let ends = self.support.ends().into_iter().zip(looks).zip(&self.weak).filter(|(_, weak)| **weak);
        for ((end, look), _) in ends {
            let step = if look.q > 0.0 { ENDLESS } else { look.step.abs().max(SHORT) };
            unknown[end.interval][usize::from(end.side > 0.0)] = step;
        }
        unknown
    }
}
