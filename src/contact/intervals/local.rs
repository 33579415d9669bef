//! What half-planes do under punches that are not smooth, where terms fall slowly: short waves see no more of a stack than its face.
use crate::contact::intervals::equations::Solved;
use crate::contact::intervals::pressure::{Pressure, Tip};
use crate::contact::intervals::space::tests;
use crate::contact::intervals::support::{ContactInterval, Intervals};
use crate::contact::problem::Problem;
use crate::contact::problem::profile::continued;

/// The pressure that a half-plane has under a punch that is not smooth, besides the one of a sharp tip.
#[derive(Clone, Debug, Default)]
pub(super) struct Local {
    /// Many terms; none under a smooth punch.
    pub(super) terms: Vec<f64>,
    /// The pressure in the middle of the interval, of all terms, and how well that is known.
    pub(super) middle: f64,
    pub(super) error: f64,
}

impl Local {
    /// With this number of terms; what a sharp tip makes is known.
    pub(super) fn new(problem: &Problem, interval: &ContactInterval, tip: Tip, count: usize) -> Self {
        let (side, limit) = (&problem.sides[interval.contact], problem.kernel.asymptote(interval.contact).limit);
        if !side.is_kinked(interval.punch) {
            return Self::default();
        }
        let term = |(m, test): (usize, f64)| {
            interval.test(m) * test / (limit * interval.on_half_plane(m)) - tip.term(interval, m)
        };
        // no term has the test with k = 0
        let first = usize::from(!interval.is_even());
        let terms: Vec<f64> = tests(side, interval, count).into_iter().skip(first).enumerate().map(term).collect();
        let middle = |terms: Vec<f64>| Pressure { terms, ..Pressure::default() }.middle(interval);
        let summed = |terms: &[f64]| {
            let mut all = Vec::new();
            continued(&mut all, terms);
            middle(all)
        };
        let apex = side.profile().filter(|profile| interval.is_even() && !profile.is_sharp());
        let (middle, error) = match apex {
            Some(profile) => {
                let apex = profile.apex(interval.half, count);
                (middle(vec![interval.twin.alone(interval.half) / limit * apex]), 0.0)
            }
            None => (summed(&terms), (summed(&terms) - summed(&terms[..count / 2])).abs()),
        };
        Self { terms, middle, error }
    }
}

/// What half-planes do on all intervals, with these numbers of terms.
pub(super) fn locals(
    problem: &Problem,
    support: &Intervals,
    solved: &Solved,
    count: impl Fn(usize) -> usize,
) -> Vec<Local> {
    let all = support.0.iter().zip(&solved.pressures).enumerate();
    all.map(|(k, (interval, pressure))| Local::new(problem, interval, pressure.tip, count(k))).collect()
}
