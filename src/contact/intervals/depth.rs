//! The rows that tell the forces of punches of which the depth is prescribed.
use std::rc::Rc;

use faer::Mat;

use crate::contact::integrals::layout::Depth;
use crate::contact::intervals::LAYOUT_SERVES;
use crate::contact::intervals::columns::Columns;
use crate::contact::intervals::equations::{Equations, Sunk};
use crate::contact::intervals::pressure::Tip;
use crate::contact::intervals::support::ContactInterval;
use crate::kernel::DepthWaves;
use crate::numeric::largest;
use crate::numeric::means::{FELT, MeanWindow};

impl Equations<'_> {
    /// What the depths of punches follow from, as far as they are prescribed.
    pub(super) fn sunk(&self) -> &[Sunk] {
        let punches = self.problem.prescribed.iter().filter(|(_, prescribed)| prescribed.depth().is_some());
        self.sunk.get_or_init(|| punches.map(|(punch, _)| self.sum_sunk(*punch)).collect())
    }

    fn sum_sunk(&self, punch: usize) -> Sunk {
        let (depth, workspace) = (self.depth(punch), &self.problem.kernel.workspace);
        let mut height = depth.height;
        let mut sum = |(contact, own): (usize, &DepthWaves)| {
            let (columns, tips) = (&self.columns[contact], self.tips(contact));
            // terms of a tip do not fall: there are more of them than of unknown terms
            let more = |(tip, count): (&Tip, &usize)| if tip.strength == 0.0 { *count } else { FELT.max(*count) };
            let counts: Vec<usize> = tips.iter().zip(columns.counts).map(more).collect();
            let with_tips = Columns::new(columns.intervals, &counts, self.moves);
            let (waves, long) = (with_tips.waves(&own.zeta, workspace), with_tips.long_waves(&own.zeta, workspace));
            let mut tested = waves.test(&self.met_by_contacts(contact, [&own.all, &own.odd]));
            let told = long.values.test(&self.met_by_contacts(contact, [&own.resultant, &own.moment]));
            long.places.iter().zip(told).for_each(|(column, wave)| tested[*column] += wave);
            for (number, (interval, tip)) in columns.intervals.iter().zip(&tips).enumerate().rev() {
                let first = with_tips.first(number);
                let beyond = tested.drain(first + columns.counts[number]..first + counts[number]);
                let terms = (columns.counts[number]..).map(|m| tip.term(interval, m));
                height += beyond.zip(terms).map(|(wave, term)| wave * term).sum::<f64>();
            }
            Mat::from_fn(1, columns.rows(), |_, column| tested[column])
        };
        let by_columns = depth.waves.iter().enumerate().map(&mut sum).collect();
        Sunk { by_columns, by_angles: self.turned(punch, &depth.windows), height }
    }

    /// What tells the depth of a punch, from the windows of an earlier list if bodies touch in these here as well.
    fn depth(&self, punch: usize) -> Rc<Depth> {
        let (mut windows, mut known) = (self.windows(punch), self.layout.depths.borrow_mut());
        let serves = |own: &Depth| own.windows.iter().zip(&windows).all(|(own, window)| window.contains(own));
        if let Some(own) = known.iter().find(|own| own.punch == punch && serves(own)) {
            return own.clone();
        }
        windows.iter_mut().for_each(|window| window.half *= 1.0 - LAYOUT_SERVES);
        let end = |columns: &Columns| {
            largest(columns.intervals.iter().map(|own: &ContactInterval| own.to().max(-own.from())))
        };
        let ends: Vec<f64> = self.columns.iter().map(end).collect();
        let waves = self.problem.kernel.depth(&windows, &ends, self.layout.negligible);
        let height = (0..windows.len()).map(|contact| self.height(contact, punch, &windows[contact])).sum();
        let depth = Rc::new(Depth { punch, windows, waves, height });
        known.push(depth.clone());
        depth
    }

    /// How much higher than at its lowest point the punch is on average over its window, or the gap at another contact before it was loaded.
    fn height(&self, contact: usize, punch: usize, window: &MeanWindow) -> f64 {
        self.problem.sides[contact].mean_height(if contact > 0 { 0 } else { punch }, window)
    }

    /// Where displacements are averaged under a punch and below: where all is even, on the innermost intervals; under the punch alone where bodies lie on each other but for openings.
    fn windows(&self, punch: usize) -> Vec<MeanWindow> {
        let of = |(contact, columns): (usize, &Columns)| {
            if self.problem.is_opened(contact) {
                return Vec::new();
            }
            let own = columns.intervals.iter().filter(|own| contact > 0 || own.punch == punch);
            let ends = own.map(|own| [own.middle - own.half, own.middle + own.half]);
            if self.moves { ends.collect() } else { ends.take(1).collect() }
        };
        MeanWindow::on_contacts(&self.columns.iter().enumerate().map(of).collect::<Vec<_>>())
    }

    /// What the depth has of each angle by which bodies turn: the layers between two windows at different places turn, and so does a punch from its tip to its window.
    fn turned(&self, punch: usize, windows: &[MeanWindow]) -> Vec<f64> {
        let mut all = vec![0.0; self.turning.len()];
        let from_tip = match self.problem.placed(0, punch) {
            Some(placed) if placed.angle().is_none() => windows[0].middle - placed.at(),
            _ => 0.0,
        };
        for (angle, (contact, group)) in self.turning.iter().enumerate() {
            all[angle] = match contact {
                0 if *group == punch => from_tip,
                0 => 0.0,
                _ => from_tip - (windows[0].middle - windows[*contact].middle),
            };
        }
        all
    }
}
