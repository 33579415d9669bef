//! What integrals leave out where they would take too many wavenumbers.
use crate::contact::integrals::layout::Layout;
use crate::contact::intervals::pressure::Pressure;
use crate::contact::intervals::support::Intervals;
use crate::contact::problem::Problem;
use crate::contact::problem::accuracy::SAFETY;

/// What integrals of each contact leave out: the rest of its kernel where they end, relative to its limit, over the wavenumber there; and of a coupling as much, times the part
/// in which the pressures of both contacts differ.
pub(super) fn left_out(
    problem: &Problem,
    layout: &Layout,
    shortest: &[f64],
    negligible: f64,
    solution: (&Intervals, &[Pressure]),
) -> Vec<f64> {
    let kernel = problem.kernel;
    let last = |count: usize| layout.zeta[..count].last().copied().unwrap_or(0.0);
    let mut all = vec![0.0; problem.contacts()];
    for (i, left) in all.iter_mut().enumerate() {
        let end = last(layout.own[i].reach);
        if layout.tails_from[i].is_infinite() && kernel.vanishes(i, shortest[i], negligible) > end {
            *left = (kernel.remainder(i, end) / kernel.asymptote(i).limit).abs() / end;
        }
    }
    for laminate in 0..layout.coupling.len() {
        let end = last(layout.coupling[laminate].len());
        // the last wavenumber lies before the end of the integral
        let [above, below] = kernel.pair(laminate);
        if kernel.uncoupled(laminate, shortest[above].min(shortest[below]), negligible) > 1.25 * end {
            let left = (kernel.coupling(laminate, end) / kernel.least(laminate)).abs() / end;
            let differ = if below > kernel.lowest() { 1.0 } else { differ(solution, laminate) };
            [above, below].into_iter().for_each(|own| all[own] += SAFETY * differ * left);
        }
    }
    all
}

/// How much the pressures of two neighbours differ, term by term, as a part of all: all of it where their lists are not alike.
fn differ((support, pressures): (&Intervals, &[Pressure]), laminate: usize) -> f64 {
    let of = |contact: usize| {
        let own = support.0.iter().zip(pressures);
        own.filter(move |(interval, _)| interval.contact == contact)
    };
    let size = |values: &[f64]| values.iter().enumerate().map(|(m, y)| y.abs() / (m + 1) as f64).sum::<f64>();
    let (mut differences, mut all) = (0.0, 0.0);
    for ((_, above), (_, below)) in of(laminate).zip(of(laminate + 1)) {
        let pairs = above.terms.iter().zip(&below.terms);
        differences += size(&pairs.map(|(above, below)| above - below).collect::<Vec<_>>());
        all += size(&above.terms);
    }
    let are_alike = of(laminate).count() == of(laminate + 1).count() && all > 0.0;
    if are_alike { differences / all } else { 1.0 }
}
