//! What the contact equations of a solution find, and from what.
use crate::contact::integrals::layout::{Layout, Lengths, negligible};
use crate::contact::intervals::columns::Other;
use crate::contact::intervals::equations::{Equations, Load};
use crate::contact::intervals::sinking::intervals_of;
use crate::contact::problem::Problem;
use crate::solution::{Ledger, LedgerEntry, Solution};

/// The contact equations on the intervals of a solution, with as many terms as it has; `None` where it is of low accuracy, and no solution of these equations.
pub(crate) fn ledger(problem: &Problem, solution: &Solution) -> Option<Ledger> {
    let (support, counts) = intervals_of(problem, solution)?;
    let negligible = negligible(problem.tolerance);
    let layout = Layout::new(problem.kernel, &Lengths::of(problem, &support, &counts, negligible), negligible, 0.0)?;
    Some(Equations::new(problem, &layout, &support, &counts).ledger())
}

impl Equations<'_> {
    /// What is unknown on each contact, and the rows that tell it. The first terms, which resultants and moments tell, count among the unknowns, and resultants and
    /// moments among the rows.
    pub(super) fn ledger(&self) -> Ledger {
        let (mut unknowns, mut rows) = (Vec::new(), Vec::new());
        for (contact, places) in self.places.iter().enumerate().filter(|(i, _)| !self.problem.is_known(*i)) {
            let (columns, interface) = (&self.columns[contact], self.problem.interfaces[contact]);
            let told = places.told.len();
            let corners = columns.intervals.iter().flat_map(|own| own.sides().iter().map(|side| own.is_corner(*side)));
            let free_ends = corners.filter(|is_corner| !is_corner).count();
            let means = columns.others.iter().filter(|other| matches!(other, Other::Mean(_))).count();
            let turning = self.turning.iter().filter(|(own, _)| *own == contact).count();
            let is_moment = |load: &&Load| matches!(load, Load::Moment { contact: own, .. } if *own == contact);
            let moments = self.loads.iter().filter(is_moment).count();
            let forces = self.loads.iter().filter(|load| contact == 0 && matches!(load, Load::Force(_))).count();
            let entry = |(kind, count)| LedgerEntry { interface, kind, count };
            let is_opened = self.problem.is_opened(contact);
            let [terms, tested, alone, between] = match is_opened {
                true => [
                    "terms of slopes of gaps",
                    "pressures in openings, tested with cos kφ, k > 0",
                    "pressures in openings, tested with k = 0",
                    "gaps that close again",
                ],
                false => [
                    "terms of pressures",
                    "slopes of gaps that are closed, tested with cos kφ, k > 0",
                    "slopes of gaps that are closed, tested with k = 0",
                    "resultants and moments of pressures",
                ],
            };
            let all = [
                (terms, places.terms.0.len() + told),
                ("intensities of singular pressures at ends", columns.ends()),
                ("places of ends that move", free_ends),
                ("angles by which bodies turn", turning),
                ("force of the punch", forces),
            ];
            unknowns.extend(all.map(entry).into_iter().filter(|entry| entry.count > 0));
            let all = [
                (tested, columns.terms()),
                (alone, means),
                ("gaps between intervals, closed at both ends", places.left.0.len() - told - means),
                (between, told - moments),
                ("intensities that vanish at ends that move", free_ends),
                ("half-length of the contact of the punch, or its depth", forces),
            ];
            rows.extend(all.map(entry).into_iter().filter(|entry| entry.count > 0));
        }
        Ledger { unknowns, rows }
    }
}
