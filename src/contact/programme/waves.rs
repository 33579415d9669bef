//! Sums over wavenumbers: which waves, and which elements they tell from each other.
use std::ops::Range;

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par};

use crate::contact::programme::compliances::Compliances;
use crate::contact::programme::grid::Grid;
use crate::contact::programme::patch::Patch;
use crate::numeric::quadrature::rule;

/// Nodes per octave of wavenumbers, and three more for each element that the distance from the middle is long at most, up to this number.
const LEAST: f64 = 24.0;
const MOST: f64 = 240.0;
/// So many times as many where layers lie on each other far away.
const CLOSED: f64 = 4.0;

/// Phases up to this many times the number of nodes are told from each other.
const TOLD: f64 = 2.0;

/// Octaves of wavenumbers.
pub(super) struct Waves {
    first: f64,
    last: f64,
    /// Nodes in each at least, and at most.
    least: f64,
    most: usize,
    /// How far apart elements are, or an element and the mirror image of another.
    span: f64,
    /// Whether elements do nothing to each other that are too far apart for the nodes. Where layers lie on each other far away, elements there are too far from their mirror images.
    is_windowed: bool,
}

impl Waves {
    pub(super) fn new(kernel: &Compliances, grid: &Grid) -> Self {
        let widths: Vec<f64> = grid.edges().windows(2).map(|pair| pair[1] - pair[0]).collect();
        let shortest = widths.iter().fold(f64::INFINITY, |shortest: f64, width| shortest.min(*width));
        let reach = |pair: &[f64]| grid.distance(pair[1]).max(grid.distance(pair[0]));
        let fineness = grid.edges().windows(2).map(|pair| reach(pair) / (pair[1] - pair[0])).fold(0.0, f64::max);
        let is_windowed = grid.patch() == Patch::Strip || grid.patch() == Patch::Pair && kernel.has_openings();
        let [least, most] = match is_windowed {
            true if kernel.has_openings() => [LEAST, LEAST + CLOSED * MOST],
            true => [LEAST, LEAST + MOST],
            false => [LEAST + (3.0 * fineness).min(MOST); 2],
        };
        let longest = grid.edges()[0].abs().max(grid.edges()[widths.len()]);
        Self {
            // waves twenty times as long as the grid, and twelfths of the shortest element
            first: 0.05 / longest,
            last: 12.0 / shortest,
            least,
            most: most as usize,
            span: grid.edges()[widths.len()] + longest,
            is_windowed,
        }
    }

    /// The waves from one wavenumber to another.
    pub(super) fn octave(&self, grid: &Grid, [from, to]: [f64; 2]) -> Octave {
        let (zeta, widths): (Vec<f64>, Vec<f64>) = rule(self.nodes(to)).on(from, to).unzip();
        let widths = widths.iter().zip(&zeta).map(|(w, zeta)| w / grid.patch().over_waves(*zeta)).collect();
        let reach = if self.is_windowed { TOLD * self.most as f64 / to } else { f64::INFINITY };
        // a mirror image is twice as far away
        let within = if grid.patch() == Patch::Pair { 0.5 * reach } else { reach };
        let mut windows: Vec<Range<usize>> = Vec::new();
        for e in 0..grid.elements() {
            match windows.last_mut() {
                Some(last) if grid.edges()[e + 1] - grid.edges()[last.start] <= within => last.end = e + 1,
                _ => windows.push(e..e + 1),
            }
        }
        let middles = grid.edges().windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
        Octave { zeta, widths, windows, reach, middles }
    }

    /// As many nodes up to a wavenumber as phases take.
    pub(super) fn nodes(&self, wavenumber: f64) -> usize {
        self.most.min((self.least + wavenumber * self.span) as usize)
    }

    pub(super) fn octaves(&self) -> impl Iterator<Item = (f64, f64)> {
        let edges = std::iter::successors(Some(self.first), |edge| Some(2.0 * edge));
        let last = self.last;
        std::iter::once((0.0, self.first))
            .chain(edges.take_while(move |edge| *edge < last).map(|from| (from, 2.0 * from)))
    }

    /// The least value of the kernel of each contact; less of it where the energy of some wave would not be positive
    /// without it, since some other kernel is negative.
    pub(super) fn least(&self, kernel: &Compliances) -> Vec<f64> {
        let n = kernel.contacts();
        let waves: Vec<(Vec<f64>, Vec<f64>)> = self
            .octaves()
            .map(|(_, zeta)| {
                let coupling = (1..n).map(|i| kernel.coupling(i - 1, zeta)).collect();
                ((0..n).map(|i| kernel.own(i, zeta) + kernel.coupled(i, zeta)).collect(), coupling)
            })
            .collect();
        let mut least = vec![0.0; n];
        for i in 0..n {
            let values = waves.iter().map(|(units, _)| units[i]);
            let most = values.fold(kernel.limit(i), f64::min).max(0.0);
            for part in [1.0, 0.5, 0.25, 0.0] {
                least[i] = part * most;
                if waves.iter().all(|(units, coupling)| is_positive(units, coupling, &least)) {
                    break;
                }
            }
        }
        least
    }
}

/// Whether the energy of a wave is positive without the least kernels, for any pressures on the contacts.
fn is_positive(units: &[f64], coupling: &[f64], least: &[f64]) -> bool {
    // what is left of contact i with all above it as they like best
    let mut above = 0.0;
    (0..units.len()).all(|i| {
        let own = units[i] - least[i] + above;
        let Some(coupled) = coupling.get(i) else { return own >= 0.0 };
        above = if own + coupled > 0.0 { own * coupled / (own + coupled) } else { 0.0 };
        own + coupled >= 0.0
    })
}

/// Some waves.
pub(super) struct Octave {
    pub(super) zeta: Vec<f64>,
    /// By which products of transforms are weighed besides kernels.
    pub(super) widths: Vec<f64>,
    /// Elements from left to right, none of which are farther apart than `reach`.
    pub(super) windows: Vec<Range<usize>>,
    /// Up to this distance the sum over these waves tells what elements do to each other; farther apart they do next to nothing to each other by waves so short.
    pub(super) reach: f64,
    /// Where the middles of the elements are.
    pub(super) middles: Vec<f64>,
}

impl Octave {
    /// Whether all elements feel each other: so long are the waves that pressures are compared with one of the same resultant and moment.
    pub(super) fn is_one(&self) -> bool {
        self.windows.len() == 1
    }

    /// Transforms of all elements, one column for each: what the transform of a patch grows by, and what is added at a wave.
    pub(super) fn transforms(
        &self,
        grid: &Grid,
        of: impl Fn(f64) -> Vec<f64>,
        add: impl Fn(usize, usize) -> f64,
    ) -> Mat<f64> {
        let mut transforms = Mat::<f64>::zeros(self.zeta.len(), grid.elements());
        let mut edge = of(grid.edges()[0]);
        for e in 0..grid.elements() {
            let next = of(grid.edges()[e + 1]);
            let column = transforms.col_as_slice_mut(e);
            for (k, (next, edge)) in next.iter().zip(&edge).enumerate() {
                column[k] = next - edge + add(e, k);
            }
            edge = next;
        }
        transforms
    }

    /// Adds transformsᵀ diag(weights) transforms; if not all elements feel each other, times a window of their distance and, where an element has a mirror image, of the distance to this, by its
    /// part `mirrored`: 0 without mirror images, 1 of what is even and −1 of what is odd. The window is positive definite, so that the sum remains so.
    pub(super) fn add_gram(&self, transforms: &Mat<f64>, weights: &[f64], mirrored: f64, sum: &mut Mat<f64>) {
        if weights.iter().all(|weight| *weight == 0.0) {
            return;
        }
        let mut weighted = transforms.clone();
        for e in 0..weighted.ncols() {
            weighted.col_as_slice_mut(e).iter_mut().zip(weights).for_each(|(value, weight)| *value *= weight);
        }
        if self.is_one() {
            return matmul(sum.as_mut(), Accum::Add, transforms.transpose(), weighted.as_ref(), 1.0, Par::Seq);
        }
        for (number, own) in self.windows.iter().enumerate() {
            let is_near = |other: &&Range<usize>| self.middles[other.start] - self.middles[own.end - 1] < self.reach;
            for other in self.windows[number..].iter().take_while(is_near) {
                let is_same = own == other;
                let left = transforms.subcols(own.start, own.len());
                let both = left.transpose() * weighted.subcols(other.start, other.len());
                for (l, f) in other.clone().enumerate() {
                    for (k, e) in own.clone().enumerate() {
                        let [own, other] = [self.middles[e], self.middles[f]];
                        let window = |distance: f64| parzen(distance / self.reach);
                        let window = match mirrored {
                            0.0 => window(other - own),
                            part => 0.5 * (window(other - own) + part * window(other + own)),
                        };
                        let value = window * both[(k, l)];
                        sum[(e, f)] += value;
                        if !is_same {
                            sum[(f, e)] += value;
                        }
                    }
                }
            }
        }
    }
}

/// The window of Parzen, which is positive definite: 1 at 0, and 0 from ±1 on.
fn parzen(x: f64) -> f64 {
    let x = x.abs().min(1.0);
    if x < 0.5 { 1.0 - 6.0 * x * x * (1.0 - x) } else { 2.0 * (1.0 - x).powi(3) }
}

/// Adds transformsᵀ forces.
pub(super) fn add_products(transforms: &Mat<f64>, forces: &[f64], sum: &mut [f64]) {
    for (e, sum) in sum.iter_mut().enumerate() {
        *sum += transforms.col_as_slice(e).iter().zip(forces).map(|(d, force)| d * force).sum::<f64>();
    }
}
