//! The ends of all intervals at which no pressure is singular.
use std::rc::Rc;

use crate::contact::integrals::layout::{Layout, Lengths, negligible};
use crate::contact::intervals::changes::changed;
use crate::contact::intervals::derivatives::{Derivatives, Matrix, steps};
use crate::contact::intervals::equations::{Equations, Solved, fewer};
use crate::contact::intervals::kept::{Kept, operations};
use crate::contact::intervals::left_out::left_out;
use crate::contact::intervals::local::{Local, locals};
use crate::contact::intervals::pressure::{FARTHEST, Pressure};
use crate::contact::intervals::steps::{Look, looks, moved};
use crate::contact::intervals::support::{ContactInterval, Intervals};
use crate::contact::problem::Problem;
use crate::contact::problem::accuracy::{BEST, MINOR, ROUNDING, SAFETY, SLOW};
use crate::contact::problem::iteration::{Progress, Work};
use crate::numeric::{largest, longest};

/// How often a step is halved after which an opening would close.
const MOST_HALVINGS: usize = 6;

/// Ends and pressures for one number of terms.
#[derive(Clone)]
pub(super) struct Approximation {
    pub(super) support: Intervals,
    /// Terms of each interval.
    pub(super) counts: Vec<usize>,
    /// Pressures and rotations.
    pub(super) solved: Solved,
    /// The same pressures without what steps have left at ends that are found, with all resultants and moments.
    pub(super) regular: Vec<Pressure>,
    /// The same with two thirds of the terms between the same ends, and with four ninths.
    pub(super) coarser: [Solved; 2],
    /// Factorised equations of nearly the same list, if they have the same unknowns.
    kept: Option<Rc<Kept>>,
    /// Derivatives of the intensities at ends of nearly the same list, if there are any.
    derivatives: Option<Rc<Matrix>>,
    /// Whether next to nothing depends on each end.
    pub(super) weak: Vec<bool>,
    /// What steps have left, in half-lengths, and how much of that another one would leave.
    pub(super) left: f64,
    rate: f64,
    /// Whether that is rounding.
    pub(super) is_rounding: bool,
    /// By how much pressures miss a prescribed depth, relative, without what is singular at ends on which next to nothing depends.
    pub(super) missed: f64,
    /// By how much what steps have left changes the pressure in the middle of each interval.
    pub(super) unmoved: Vec<f64>,
    /// What kernels are resolved to, relative.
    pub(super) negligible: f64,
    /// For each contact, what is left of its kernel where integrals end, relative, over the wavenumber there.
    pub(super) left_out: Vec<f64>,
    /// Whether each contact is next to a graded face.
    pub(super) graded: Vec<bool>,
    /// What half-planes of the material at the face do on each interval.
    pub(super) local: Vec<Local>,
}

impl Approximation {
    /// With ends that have taken their last steps, and pressures to first order in these; `None` if intervals vanish.
    fn moved(mut self, problem: &Problem, layout: &Layout, looks: &[Look]) -> Option<Self> {
        let steps = steps(looks, self.derivatives.as_deref());
        let steps: Vec<f64> = steps.into_iter().map(Option::unwrap_or_default).collect();
        if self.derivatives.as_ref().is_some_and(|derivatives| !derivatives.serves(looks)) {
            (self.derivatives, self.rate) = (None, 1.0);
        }
        let support = moved(problem, &self.support, &steps)?;
        // where an end has moved no pressure is singular but for what fewer terms make
        let mut all = steps.iter().zip(looks).map(|(step, look)| if *step == 0.0 { 0.0 } else { look.q });
        let taken: Vec<Vec<f64>> = support
            .0
            .iter()
            .map(|own| own.sides().iter().zip(all.by_ref()).map(|(side, q)| own.sign(*side) * q).collect())
            .collect();
        let on = |solved: Solved| {
            let places = self.support.0.iter().zip(&support.0).zip(&taken);
            let of = |(pressure, ((before, after), taken)): (
                Pressure,
                ((&ContactInterval, &ContactInterval), &Vec<f64>),
            )| {
                let mut own = pressure.on(before, after);
                own.singular.iter_mut().zip(taken).for_each(|(own, taken)| *own -= taken);
                own
            };
            Solved { pressures: solved.pressures.into_iter().zip(places).map(of).collect(), ..solved }
        };
        let before = self.middle_pressures(&self.solved.pressures);
        let (solved, coarser) = (on(self.solved), self.coarser.map(on));
        let regular = regular(&Equations::new(problem, layout, &support, &self.counts), &support, &solved);
        let mut moved = Self { solved, regular, coarser, support, ..self };
        // what is left of steps changes pressures by as large a part of what these steps change
        let left = if steps.iter().any(|step| *step != 0.0) { (moved.left / longest(steps)).min(1.0) } else { 0.0 };
        let changes = moved.middle_pressures(&moved.solved.pressures).into_iter().zip(before);
        moved.unmoved = changes.map(|(after, before)| left * (after - before).abs()).collect();
        Some(moved)
    }

    /// How far ends may still move, in half-lengths, with more terms.
    fn still_moves(&self) -> f64 {
        SAFETY * (self.left + largest(self.moves().into_iter().map(|[last, _]| last.abs())))
    }

    /// With two thirds of the terms between the same ends.
    pub(super) fn coarse(&self) -> Self {
        Self { counts: fewer(&self.counts), solved: self.coarser[0].clone(), ..self.clone() }
    }
}

/// Why ends do not converge.
#[derive(Debug)]
pub(super) enum Failure {
    /// The list changes to this one: nothing presses on an interval, or two grow together.
    Changed(Intervals),
    /// Steps lead nowhere from this list, or take too long.
    Stuck(Intervals),
}

/// Moves ends until no pressure is singular and what steps leave is `enough`, or less than missing terms do, from the ends and pressures of a solution with
/// fewer terms if there is one.
pub(super) fn converge(
    problem: &Problem,
    mut support: Intervals,
    before: Option<&Approximation>,
    counts: &[usize],
    enough: f64,
    work: &mut Work,
) -> Result<Approximation, Failure> {
    // kernels need no more digits than ends and pressures are to have
    let least = negligible(problem.tolerance);
    let negligible = least.max(1e-3 * enough);
    let mut laid_out: Option<(Layout, Vec<f64>)> = None;
    // a pressure that is not smooth is not known on other intervals
    let is_smooth = support.0.iter().all(|interval| problem.is_smooth(interval.contact, interval.punch));
    // so it does not follow the last steps, and changes more than these
    let enough = if is_smooth { enough } else { ROUNDING.max(0.1 * enough) };
    let mut newton = Newton::new(before, counts, enough);
    work.steps.push(0);
    loop {
        let stuck = || Failure::Stuck(support.clone());
        let lengths = Lengths::of(problem, &support, counts, negligible);
        let (layout, about) = match laid_out.take().filter(|(_, about)| lengths.are_near(about)) {
            Some(laid_out) => laid_out,
            None => {
                let layout = Layout::new(problem.kernel, &lengths, negligible, 0.0).ok_or_else(stuck)?;
                work.interpolated += layout.zeta.len();
                (layout, lengths.ends.clone())
            }
        };
        work.step();
        let equations = Equations::new(problem, &layout, &support, counts);
        let costs = operations(&layout, &support, counts);
        let (solved, looks) = newton.solve(&equations, &support, costs, work).ok_or_else(stuck)?;
        if let Some(back) = newton.back(&support, &solved.pressures) {
            (support, laid_out) = (back, Some((layout, about)));
            continue;
        }
        changed(&support, &solved.pressures).map_or(Ok(()), |list| Err(Failure::Changed(list)))?;
        newton.rate = match newton.taken {
            _ if !is_smooth => 1.0,
            Some(taken) => newton.left / taken,
            None if newton.before.as_ref().is_some_and(|before| !before.serves(&looks)) => 1.0,
            None => newton.rate,
        };
        if newton.is_converged(&support, &solved.pressures, &looks) {
            let mut level = newton.approximation(&equations, &support, solved.clone(), &looks).ok_or_else(stuck)?;
            if newton.is_enough(&level) {
                let solution = (&level.support, &level.solved.pressures[..]);
                level.negligible = negligible;
                level.left_out = left_out(problem, &layout, &lengths.shortest, least, solution);
                let level = if is_smooth { level.moved(problem, &layout, &looks) } else { Some(level) };
                return level.ok_or_else(stuck);
            }
        }
        if !newton.goes_on(&support) {
            return Err(Failure::Stuck(support));
        }
        let perturbed = |kept: &Kept, moved: &Intervals| {
            work.spend(costs[1])?;
            let equations = Equations::new(problem, &layout, moved, counts);
            let (solved, _) = kept.corrected(&equations, &solved.on(&support, moved), counts)?;
            Some(self::looks(moved, &solved.pressures).iter().map(|look| look.q).collect())
        };
        let steps = newton.steps(&equations, &support, &looks, perturbed).ok_or_else(stuck)?;
        let next = moved(problem, &support, &steps).ok_or_else(stuck)?;
        newton.take((support, solved), &steps);
        (support, laid_out) = (next, Some((layout, about)));
    }
}

/// Newton's method on ends, for one number of terms.
struct Newton<'a> {
    counts: &'a [usize],
    /// What steps may leave, in half-lengths.
    enough: f64,
    /// The same as long as missing terms matter more.
    aim: Option<f64>,
    kept: Option<Rc<Kept>>,
    /// Whether the factorised equations are the ones of the list itself, and whether the ones at the last list were.
    is_own: bool,
    was_own: bool,
    /// Whether the last pressures are as exact as a step leaves them.
    is_exact: bool,
    /// The list before, with its solution.
    last: Option<(Intervals, Solved)>,
    /// The longest of the steps of ends that are to be taken, and what these and changes of terms leave.
    farthest: f64,
    left: f64,
    /// The longest of the steps that were to be taken from the list before, or that were taken, if these were shorter; or what terms had left there.
    taken: Option<f64>,
    /// How much a step leaves of what it takes, from the last two lists, or from the solution with fewer terms.
    rate: f64,
    progress: Progress,
    /// How often a step was halved.
    halvings: usize,
    /// The longest first step that is expected, in half-lengths.
    expected: f64,
    derivatives: Derivatives,
    /// The derivatives that were known of the solution with fewer terms.
    before: Option<Rc<Matrix>>,
}

impl<'a> Newton<'a> {
    fn new(before: Option<&Approximation>, counts: &'a [usize], enough: f64) -> Self {
        Self {
            counts,
            enough,
            aim: None,
            kept: before.and_then(|before| before.kept.clone()).filter(|kept| kept.serves(counts)),
            is_own: false,
            was_own: false,
            is_exact: false,
            last: before.map(|before| (before.support.clone(), before.solved.clone())),
            farthest: 0.0,
            left: f64::INFINITY,
            taken: None,
            rate: before.map_or(1.0, |before| before.rate),
            expected: before.map_or(f64::INFINITY, Approximation::still_moves),
            progress: Progress::default(),
            halvings: 0,
            derivatives: Derivatives::default(),
            before: before.and_then(|before| before.derivatives.clone()),
        }
    }

    /// Pressures on a list, and what they say of its ends: corrected by kept equations if that leads on, or from equations that are factorised anew.
    fn solve(
        &mut self,
        equations: &Equations,
        support: &Intervals,
        [anew, kept]: [f64; 2],
        work: &mut Work,
    ) -> Option<(Solved, Vec<Look>)> {
        self.was_own = std::mem::take(&mut self.is_own);
        if let (Some(equations_kept), Some((before, solved))) =
            (self.kept.clone().filter(|kept| kept.is_near(support)), &self.last)
        {
            let mut expected = solved.on(before, support).regular(support);
            let mut changed = f64::INFINITY;
            loop {
                work.spend(kept)?;
                let Some((solved, changed_by)) = equations_kept.corrected(equations, &expected, self.counts) else {
                    break;
                };
                let looks = self.look(support, &solved, changed_by);
                // corrections between the same ends cost little, and steps leave no less than their square
                let leads_on = changed_by <= SLOW * changed;
                let is_exact = MINOR * changed_by <= self.farthest.powi(2).max(self.enough);
                let is_no_worse = self.left <= self.farthest.max(self.enough)
                    && self.left <= self.expected.min(SLOW * self.progress.last);
                // to rounding the solution is the same with any factors
                let is_solved = leads_on && changed_by <= BEST;
                if is_solved || is_no_worse && (is_exact || !leads_on) {
                    self.is_exact = is_exact;
                    return Some((solved, looks));
                }
                if !leads_on || is_exact {
                    break;
                }
                (expected, changed) = (solved, changed_by);
            }
        }
        work.spend(anew)?;
        work.factorisations += 1;
        let (kept, solved) = Kept::new(equations, support, self.counts)?;
        (self.kept, self.is_own, self.is_exact) = (Some(Rc::new(kept)), true, true);
        let looks = self.look(support, &solved, 0.0);
        Some((solved, looks))
    }

    /// What pressures say of all ends, and what steps leave.
    fn look(&mut self, support: &Intervals, solved: &Solved, changed_by: f64) -> Vec<Look> {
        let looks = looks(support, &solved.pressures);
        self.farthest = longest(steps(&looks, self.derivatives.matrix.as_deref()).into_iter().flatten());
        // next to nothing of what ends and the pressure at the middle are depends on high terms, which change most
        self.left = self.farthest.max(MINOR * changed_by);
        looks
    }

    /// The list in the middle of the last step, if an opening closes after it: that may be there all the same.
    fn back(&mut self, support: &Intervals, pressures: &[Pressure]) -> Option<Intervals> {
        let closes = self.halvings < MOST_HALVINGS && support.closing(pressures).contains(&true);
        let (last, _) = self.last.as_ref().filter(|_| closes)?;
        self.halvings += 1;
        Some(support.halfway(last))
    }

    /// Counts a step; whether there may be another. Openings may begin much shorter than they are, and grow as far as they may in each step.
    fn goes_on(&mut self, support: &Intervals) -> bool {
        let grows = self.left >= FARTHEST && support.0.iter().any(|interval| interval.opens);
        grows || self.progress.goes_on(self.left)
    }

    /// Whether steps leave rounding: hardly less than at the last list, and not for want of equations of its own there.
    fn is_rounding(&self) -> bool {
        self.was_own >= self.is_own && self.progress.is_rounding(self.left, 1e-7)
    }

    /// Whether steps leave as little as that.
    fn is_converged(&mut self, support: &Intervals, pressures: &[Pressure], looks: &[Look]) -> bool {
        let aim = *self.aim.get_or_insert_with(|| {
            MINOR * MINOR * largest(support.0.iter().zip(pressures).map(|(interval, own)| own.missing(interval)))
        });
        // intervals that overlap, as they may to begin with, are moved apart; an end that would grow into the next interval is not found
        let are_apart = support
            .ends()
            .into_iter()
            .zip(looks)
            .all(|(end, look)| support.gap(end) > (look.step * support.0[end.interval].half).max(0.0));
        are_apart && (self.leaves() < aim.max(self.enough) || self.is_rounding())
    }

    /// Whether steps leave less than missing terms do.
    fn is_enough(&mut self, level: &Approximation) -> bool {
        let aim = MINOR * largest(level.moves().into_iter().map(|[last, _]| last.abs()));
        self.aim = Some(aim);
        self.leaves() < aim.max(self.enough) || self.is_rounding()
    }

    /// What is left once the ends have taken their steps.
    fn leaves(&self) -> f64 {
        if self.is_exact { self.left * self.rate.min(1.0) } else { self.left }
    }

    fn approximation(
        &self,
        equations: &Equations,
        support: &Intervals,
        solved: Solved,
        looks: &[Look],
    ) -> Option<Approximation> {
        let kept = self.kept.as_ref()?;
        let coarser = kept.with_fewer(equations, &solved, self.counts)?;
        let kernel = equations.problem.kernel;
        let weak: Vec<bool> = steps(looks, self.derivatives.matrix.as_deref()).iter().map(Option::is_none).collect();
        Some(Approximation {
            missed: equations.missed(&solved, &weak),
            regular: regular(equations, support, &solved),
            support: support.clone(),
            counts: self.counts.to_vec(),
            // what the face alone does is known with many more terms than are unknown
            local: locals(equations.problem, support, &solved, |number| 16 * self.counts[number]),
            solved,
            coarser,
            kept: self.kept.clone(),
            weak,
            derivatives: self.derivatives.matrix.clone().or(self.before.clone().filter(|before| before.serves(looks))),
            left: self.leaves(),
            rate: self.rate,
            is_rounding: self.is_rounding(),
            unmoved: vec![0.0; self.counts.len()],
            negligible: 0.0,
            left_out: Vec::new(),
            graded: (0..equations.columns.len()).map(|i| !kernel.asymptote(i).is_constant()).collect(),
        })
    }

    /// Steps of all ends outwards, in half-lengths.
    fn steps(
        &mut self,
        equations: &Equations,
        support: &Intervals,
        looks: &[Look],
        mut perturbed: impl FnMut(&Kept, &Intervals) -> Option<Vec<f64>>,
    ) -> Option<Vec<f64>> {
        let mut steps: Vec<f64> = looks.iter().map(|look| look.step).collect();
        // derivatives do nothing about terms
        if self.left <= self.farthest {
            let (is_own, kept, counts) = (&mut self.is_own, &mut self.kept, self.counts);
            self.derivatives.improve(support, looks, &mut steps, |[outwards, inwards]| {
                if !*is_own {
                    (*kept, *is_own) = (Some(Rc::new(Kept::new(equations, support, counts)?.0)), true);
                }
                let kept = kept.as_ref()?;
                Some([perturbed(kept, outwards)?, perturbed(kept, inwards)?])
            })?;
        }
        looks.iter().zip(&mut steps).filter(|(look, step)| look.is_weak(**step)).for_each(|(_, step)| *step = 0.0);
        Some(steps)
    }

    /// Takes note of a list, and of the steps from there to the next.
    fn take(&mut self, last: (Intervals, Solved), steps: &[f64]) {
        self.taken =
            Some(if self.left > self.farthest { self.left } else { self.left.min(longest(steps.iter().copied())) });
        self.last = Some(last);
    }
}

/// Pressures without what is singular at ends that are found, with all resultants and moments.
fn regular(equations: &Equations, support: &Intervals, solved: &Solved) -> Vec<Pressure> {
    let unknowns = equations.unknowns(&solved.regular(support));
    let counts: Vec<usize> = solved.pressures.iter().map(|pressure| pressure.terms.len()).collect();
    equations.solved(&unknowns, &counts).pressures
}
