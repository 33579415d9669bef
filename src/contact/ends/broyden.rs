//! Steps with kept derivatives, improved by what the steps before have done (Broyden 1965).
//!
//! In the form that needs nothing but the steps: C. T. Kelley, Iterative Methods for Linear and Nonlinear Equations, 1995,
//! section 7.3.
use crate::contact::problem::accuracy::SLOW;
use crate::contact::problem::modes::Modes;
use crate::numeric::dot;

/// Steps in the modes of all contacts and the logarithms of the half-lengths, one after the other.
#[derive(Default)]
pub(crate) struct Secants {
    taken: Vec<Vec<f64>>,
}

impl Secants {
    /// What kept derivatives make of the equations, from modes `start` to `modes` and a `step` still to be taken, becomes
    /// what derivatives would that agree with all steps before.
    pub(crate) fn improve(&mut self, start: &Modes, modes: &mut Modes, step: &mut [f64]) {
        let changes = modes.iter().flatten().zip(start.iter().flatten()).map(|(now, before)| now - before);
        let mut all: Vec<f64> = changes.chain(step.iter().copied()).collect();
        for pair in self.taken.windows(2) {
            let part = dot(&pair[0], &all) / dot(&pair[0], &pair[0]);
            all.iter_mut().zip(&pair[1]).for_each(|(value, next)| *value += part * next);
        }
        if let Some(last) = self.taken.last() {
            let part = (dot(last, &all) / dot(last, last)).min(SLOW);
            all.iter_mut().for_each(|value| *value /= 1.0 - part);
        }
        let mut improved = all.iter();
        for (now, before) in modes.iter_mut().flatten().zip(start.iter().flatten()) {
            *now = before + improved.next().unwrap_or(&0.0);
        }
        step.iter_mut().zip(improved).for_each(|(step, improved)| *step = *improved);
        self.taken.push(all);
    }
}
