//! Factorised equations, which are kept while ends move little and terms are added.
//!
//! Pressures on a list of intervals are corrected by what they miss there, with the factors of the equations of an earlier list: a correction costs a product of
//! columns with one vector, twice, in place of products of all columns with each other. It leaves as much of an error as ends have moved. Terms that the
//! equations do not have are so short that half-planes dominate in their rows.
use crate::contact::integrals::layout::Layout;
use crate::contact::intervals::equations::{Equations, Solved, fewer};
use crate::contact::intervals::support::Intervals;
use crate::contact::intervals::system::{Factors, System, Unknowns};
use crate::numeric::longest;

/// How far the ends of a list may be from where they were, in half-lengths, for equations to be kept. Half or twice as far: solutions take as long.
const NEAR: f64 = 0.02;

/// The equations of a list of intervals, with their factors.
pub(super) struct Kept {
    system: System,
    factors: Factors,
    /// The list, and terms of each interval.
    support: Intervals,
    counts: Vec<usize>,
}

impl Kept {
    /// The equations of a list, and their solution; `None` if there is none in double precision.
    pub(super) fn new(equations: &Equations, support: &Intervals, counts: &[usize]) -> Option<(Self, Solved)> {
        let system = equations.system()?;
        let factors = system.factorised()?;
        let solved = equations.solved(&factors.solve(&system.right)?, counts);
        Some((Self { system, factors, support: support.clone(), counts: counts.to_vec() }, solved))
    }

    /// Whether they correct pressures on another list of the same kind.
    pub(super) fn is_near(&self, support: &Intervals) -> bool {
        longest(self.support.steps_to(support)) < NEAR
    }

    /// Whether the equations of another list have the same kinds of unknowns, with as many terms at least.
    pub(super) fn serves(&self, counts: &[usize]) -> bool {
        self.counts.len() == counts.len() && self.counts.iter().zip(counts).all(|(own, count)| own <= count)
    }

    /// Pressures less what they miss, with these numbers of terms, and the largest change of a term.
    pub(super) fn corrected(&self, equations: &Equations, solved: &Solved, counts: &[usize]) -> Option<(Solved, f64)> {
        self.all_corrected(equations, &[(solved, counts)])?.pop()
    }

    /// The same of several ones at once.
    pub(super) fn all_corrected(
        &self,
        equations: &Equations,
        all: &[(&Solved, &[usize])],
    ) -> Option<Vec<(Solved, f64)>> {
        let wanted = |counts: &[usize]| {
            let mut wanted = vec![false; equations.unknown_terms()];
            equations.kept(counts).into_iter().for_each(|place| wanted[place] = true);
            wanted
        };
        let wanted: Vec<Vec<bool>> = all.iter().map(|(_, counts)| wanted(counts)).collect();
        let unknowns: Vec<Unknowns> =
            all.iter().map(|(solved, counts)| equations.unknowns(&solved.first_terms(counts))).collect();
        let missed = equations.residuals(&unknowns)?;
        let sets = unknowns.into_iter().zip(missed).zip(&wanted).zip(all);
        let corrected = sets.map(|(((mut unknowns, missed), wanted), (_, counts))| {
            let correction = self.correction(equations, wanted, &missed)?;
            unknowns.x.iter_mut().zip(&correction.x).for_each(|(x, change)| *x += change);
            unknowns.q.iter_mut().zip(&correction.q).for_each(|(q, change)| *q += change);
            Some((equations.solved(&unknowns, counts), longest(correction.x.iter().copied())))
        });
        corrected.collect()
    }

    /// The solution with two thirds of the terms, and with four ninths, to first order in what these change.
    pub(super) fn with_fewer(&self, equations: &Equations, solved: &Solved, counts: &[usize]) -> Option<[Solved; 2]> {
        let few = fewer(counts);
        let mut all = self.all_corrected(equations, &[(solved, &few), (solved, &fewer(&few))])?.into_iter();
        let mut next = || all.next().map(|(solved, _)| solved);
        Some([next()?, next()?])
    }

    /// The unknowns that make up for what tests miss.
    fn correction(&self, equations: &Equations, is_wanted: &[bool], missed: &[Vec<f64>]) -> Option<Unknowns> {
        let own = equations.kept(&self.counts);
        let common: Vec<usize> = (0..own.len()).filter(|k| is_wanted[own[*k]]).collect();
        let among: Vec<usize> = common.iter().map(|k| own[*k]).collect();
        let rows = equations.rows_of(missed).part(&among);
        let Unknowns { x: of_common, q } = if common.len() == own.len() {
            self.factors.solve(&rows)?
        } else {
            self.system.part(&common).factorised()?.solve(&rows)?
        };
        let mut x = equations.on_half_planes(missed);
        x.iter_mut().zip(is_wanted).filter(|(_, wanted)| !**wanted).for_each(|(x, _)| *x = 0.0);
        among.iter().zip(of_common).for_each(|(place, value)| x[*place] = value);
        Some(Unknowns { x, q })
    }
}

impl Solved {
    /// Nearly the same pressures on the intervals of another list.
    pub(super) fn on(&self, before: &Intervals, after: &Intervals) -> Self {
        let all = self.pressures.iter().zip(before.0.iter().zip(&after.0));
        let pressures = all.map(|(pressure, (before, after))| pressure.on(before, after)).collect();
        Self { pressures, ..self.clone() }
    }

    /// The same with no more than these numbers of terms besides what tips make.
    fn first_terms(&self, counts: &[usize]) -> Self {
        let mut all = self.clone();
        all.pressures.iter_mut().zip(counts).for_each(|(pressure, count)| pressure.terms.truncate(*count));
        all
    }

    /// The same with singular pressures at corners only.
    pub(super) fn regular(&self, support: &Intervals) -> Self {
        let pressures = self.pressures.iter().zip(&support.0).map(|(pressure, interval)| pressure.regular(interval));
        Self { pressures: pressures.collect(), ..self.clone() }
    }
}

/// Multiplications, about, that it takes to solve the equations of a list, and to correct pressures with kept ones.
pub(super) fn operations(layout: &Layout, support: &Intervals, counts: &[usize]) -> [f64; 2] {
    let contacts = support.0.iter().map(|interval| interval.contact + 1).max().unwrap_or(0);
    let of = |contact: usize| {
        let own = support.0.iter().zip(counts).filter(|(interval, _)| interval.contact == contact);
        own.map(|(_, count)| *count).sum::<usize>() as f64
    };
    let terms: Vec<f64> = (0..contacts).map(of).collect();
    let (nodes, all) = (layout.zeta.len() as f64, terms.iter().sum::<f64>());
    // a Bessel function takes as long as some 64 multiplications, and products are symmetric
    let columns = 64.0 * nodes * all;
    let own: f64 = terms.iter().map(|terms| 0.5 * nodes * terms * terms).sum();
    let between: f64 = terms.windows(2).map(|pair| 0.5 * nodes * (pair[0] + pair[1]).powi(2)).sum();
    [columns + own + between + all.powi(3) / 3.0, columns + all.powi(2)]
}
