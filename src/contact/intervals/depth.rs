//! The row that tells the force of a punch where its depth is prescribed.
use faer::Mat;

use crate::contact::intervals::columns::Columns;
use crate::contact::intervals::equations::{Equations, Sunk};
use crate::contact::intervals::support::ContactInterval;
use crate::numeric::largest;
use crate::numeric::means::MeanWindow;

impl Equations<'_> {
    /// What the depth of the punch follows from.
    pub(super) fn sunk(&self) -> &Sunk {
        self.sunk.get_or_init(|| self.sum_sunk())
    }

    fn sum_sunk(&self) -> Sunk {
        let window =
            |columns: &Columns| MeanWindow { middle: columns.intervals[0].middle, half: columns.intervals[0].half };
        let mut windows: Vec<MeanWindow> = self.columns.iter().map(window).collect();
        MeanWindow::equalise(&mut windows);
        let end = |columns: &Columns| largest(columns.intervals.iter().map(ContactInterval::to));
        let ends: Vec<f64> = self.columns.iter().map(end).collect();
        let (kernel, mut sums) = (self.problem.kernel, Vec::new());
        sums.extend(self.columns.iter().map(|columns| Mat::zeros(1, columns.rows())));
        kernel.depth(&windows, &ends, (self.layout.negligible, 1), |own| {
            let columns = &self.columns[own.contact];
            let waves = columns.waves(own.zeta, &kernel.workspace);
            let long = columns.long_waves(own.zeta, &kernel.workspace);
            let told = long.places.iter().copied().zip(long.values.all().test(&own.resultant[0]));
            let tested = waves.all().test(&own.all[0]).into_iter().enumerate();
            tested.chain(told).for_each(|(column, wave)| sums[own.contact][(0, column)] += wave);
        });
        let profile = self.problem.sides[0].profile();
        let height = profile.map_or(0.0, |profile| profile.mean_height(&windows[0]));
        Sunk { by_columns: sums, height }
    }
}
