//! The ends of all intervals at which no pressure is singular.
use crate::contact::ends::broyden::Secants;
use crate::contact::integrals::layout::{Layout, negligible};
use crate::contact::intervals::equations::Equations;
use crate::contact::intervals::pressure::Pressure;
use crate::contact::intervals::support::{Interval, Support};
use crate::contact::intervals::{Lengths, Work};
use crate::contact::problem::Problem;
use crate::contact::problem::iteration::Progress;

/// Most of the way to the next interval that an end goes in one step.
const MOST_OUT: f64 = 0.4;
/// Steps at most.
const MOST_STEPS: usize = 40;
/// Steps that are shorter, in half-lengths, are Newton's.
const SHORT: f64 = 0.1;
/// An end with a weaker singularity, in units of the mean pressure, need not be known.
const WEAK: f64 = 1e-9;

/// Ends and pressures for one number of terms.
#[derive(Clone)]
pub(super) struct Level {
    pub(super) support: Support,
    /// Terms of each interval.
    pub(super) counts: Vec<usize>,
    /// Of each interval.
    pub(super) pressures: Vec<Pressure>,
    /// The last step of each end, in half-lengths.
    pub(super) steps: Vec<f64>,
    /// For each contact, what is left of its kernel where integrals end, relative, over the wavenumber there.
    pub(super) left_out: Vec<f64>,
}

/// What the pressure says of one end.
struct Look {
    /// The intensity of the singular pressure there.
    q: f64,
    /// The step outwards, in half-lengths.
    step: f64,
}

impl Look {
    /// Whether next to nothing depends on the end, however long this step of it.
    fn is_weak(&self, step: f64) -> bool {
        self.q.abs() < WEAK && step.abs() > SHORT
    }
}

/// Moves ends until no pressure is singular; `None` if that does not converge.
pub(super) fn converge(
    problem: &Problem,
    mut support: Support,
    counts: &[usize],
    enough: f64,
    work: &mut Work,
) -> Option<Level> {
    let negligible = negligible(problem.tolerance);
    let mut kept: Option<(Layout, Vec<f64>)> = None;
    let mut progress = Progress::default();
    let mut secants = Secants::default();
    let mut limits = Limits::default();
    work.steps.push(0);
    loop {
        let lengths = Lengths::of(problem, &support);
        let (layout, about) = match kept.take().filter(|(_, about)| lengths.are_near(about)) {
            Some(kept) => kept,
            None => {
                let Lengths { ends, shortest } = &lengths;
                (Layout::without_tails(problem.kernel, ends, shortest, negligible, 0.0)?, ends.clone())
            }
        };
        let terms: usize = counts.iter().sum();
        work.spend(terms, layout.zeta.len())?;
        *work.steps.last_mut()? += 1;
        let pressures = Equations::new(problem, &layout, &support, counts).solve()?;
        let looks = looks(problem, &support, &pressures);
        let mut steps: Vec<f64> = looks.iter().map(|look| look.step).collect();
        let longest =
            looks.iter().map(|look| if look.is_weak(look.step) { 0.0 } else { look.step.abs() }).fold(0.0, f64::max);
        if longest < enough || progress.is_rounding(longest, 1e-7) {
            let left_out = |i: usize| super::left_out(problem.kernel, &layout, i, lengths.shortest[i], negligible);
            let left_out = (0..problem.contacts()).map(left_out).collect();
            return Some(Level { support, counts: counts.to_vec(), pressures, steps, left_out });
        }
        if !progress.goes_on(longest) || work.steps.last() > Some(&MOST_STEPS) {
            return None;
        }
        if longest < SHORT {
            secants.improve(&Vec::new(), &mut Vec::new(), &mut steps);
        } else {
            secants = Secants::default();
        }
        for (look, step) in looks.iter().zip(&mut steps) {
            if look.is_weak(*step) {
                *step = 0.0;
            }
        }
        limits.limit(&mut steps);
        support = moved(problem, &support, &steps)?;
        kept = Some((layout, about));
    }
}

/// How far each end may move, in half-lengths: steps back and forth grow shorter.
#[derive(Default)]
struct Limits {
    before: Vec<f64>,
    limits: Vec<f64>,
}

impl Limits {
    fn limit(&mut self, steps: &mut [f64]) {
        self.limits.resize(steps.len(), 1.0);
        self.before.resize(steps.len(), 0.0);
        for ((step, limit), before) in steps.iter_mut().zip(&mut self.limits).zip(&mut self.before) {
            *limit = if *step * *before < 0.0 { 0.5 * before.abs() } else { (2.0 * *limit).min(1.0) };
            *step = step.clamp(-*limit, *limit);
            *before = *step;
        }
    }
}

/// Takes steps, none longer than allowed; `None` if intervals vanish.
fn moved(problem: &Problem, support: &Support, steps: &[f64]) -> Option<Support> {
    let limited = support.ends().into_iter().zip(steps).map(|(end, step)| {
        let interval = &support.0[end.interval];
        let outwards = (step * interval.half).min(MOST_OUT * support.gap(end));
        let place = support.place(end);
        let side = &problem.sides[interval.contact];
        if end.side > 0.0 { side.within(place, place + outwards) - place } else { outwards }
    });
    let moved = support.moved(&limited.collect::<Vec<_>>());
    moved.0.iter().all(|interval| interval.half > 0.0 && interval.half.is_finite()).then_some(moved)
}

/// What pressures say of all ends; the corners of a flat punch are where they are.
fn looks(problem: &Problem, support: &Support, pressures: &[Pressure]) -> Vec<Look> {
    let of = |(interval, pressure): (&Interval, &Pressure)| -> Vec<Look> {
        let corner = problem.sides[interval.contact].is_flat();
        let of = |(side, q): (&f64, &f64)| match corner {
            true => Look { q: 0.0, step: 0.0 },
            false => Look { q: *q, step: pressure.step(interval, *side, *q) },
        };
        interval.sides().iter().zip(&pressure.singular).map(of).collect()
    };
    support.0.iter().zip(pressures).flat_map(of).collect()
}
