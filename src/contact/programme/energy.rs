//! The elastic energy of pressures that are constant on elements, ½ Σ p_iᵀ U_i p_i + ½ Σ (p_i − p_(i+1))ᵀ C_i (p_i −
//! p_(i+1)) + Σ b_iᵀ p_i, per unit of P'.
//!
//! A pressure 1 on [x_e, x_(e+1)] and its mirror image has the transform (2/ζ) (sin ζx_(e+1) − sin ζx_e), on a ring about an axis
//! (x_(e+1) J₁(ζx_(e+1)) − x_e J₁(ζx_e))/ζ. The energy is the quadratic form of the Galerkin equations. Resultants are given, so every pressure is taken less a uniform one of the same resultant
//! over the shortest contact: what is left bends laminates no more than it has to, and no digits are lost to what all pressures have
//! in common. What a kernel has in common with a half-plane, its least value, is integrated in closed form. The rest is a sum over wavenumbers, none of which has a negative energy: the sum is positive even
//! where they are too few for the elements far out.
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par};

use crate::contact::programme::compliances::Compliances;
use crate::contact::programme::grid::Grid;
use crate::numeric::quadrature::rule;

/// Nodes per octave of wavenumbers for each element that the distance from the middle is long at most, and for eight more. Twice as many
/// change nothing.
const PER_FINENESS: f64 = 3.0;
/// Wavenumbers begin here, times the length of the grid.
const LONGEST_WAVE: f64 = 0.05;
/// And end here, divided by the length of the shortest element.
const SHORTEST_WAVE: f64 = 12.0;

/// Entries of the matrices of all contacts at most: there are two such sets, and the elimination makes as many again, so
/// that they stay below 500 MB together. 32 contacts may have 700 elements each; grids that are refined have some 500.
const MOST_ENTRIES: usize = 16_000_000;

/// The quadratic form of the programme.
pub(super) struct Energy {
    /// U of each contact.
    pub(super) unit: Vec<Mat<f64>>,
    /// C of each laminate between contacts.
    pub(super) coupling: Vec<Mat<f64>>,
    /// b of each contact.
    pub(super) linear: Vec<Vec<f64>>,
    /// Resultant of each element's unit pressure.
    pub(super) resultants: Vec<f64>,
    /// Elements that the punch at a contact does not reach.
    pub(super) inadmissible: Vec<Vec<bool>>,
}

impl Energy {
    /// `None` if the matrices of all contacts would have too many entries.
    pub(super) fn new(kernel: &Compliances, grid: &Grid) -> Option<Self> {
        let (contacts, elements) = (kernel.contacts(), grid.elements());
        if contacts.saturating_mul(elements).saturating_mul(elements) > MOST_ENTRIES {
            return None;
        }
        let mut energy = Self {
            unit: vec![Mat::zeros(elements, elements); contacts],
            coupling: vec![Mat::zeros(elements, elements); contacts - 1],
            linear: vec![vec![0.0; elements]; contacts],
            resultants: (0..elements).map(|e| grid.resultant(e)).collect(),
            inadmissible: vec![vec![false; elements]; contacts],
        };
        let waves = Waves::new(grid);
        let least = waves.least(kernel);
        energy.add_half_planes(&least, grid);
        energy.add_waves(kernel, &least, grid, &waves);
        energy.add_resultants(kernel, grid);
        energy.add_punches(kernel, grid);
        Some(energy)
    }

    pub(super) fn contacts(&self) -> usize {
        self.unit.len()
    }

    pub(super) fn elements(&self) -> usize {
        self.resultants.len()
    }

    fn add_half_planes(&mut self, least: &[f64], grid: &Grid) {
        let (elements, reference, twin) = (self.elements(), grid.shortest(), grid.twin());
        let patches = |x: f64, y: f64| twin.patches(x, y, reference);
        let edges = grid.edges();
        let of_edges =
            Mat::from_fn(elements + 1, elements + 1, |e, f| if f <= e { patches(edges[e], edges[f]) } else { 0.0 });
        // the elements before a pair of edges
        let both = |e: usize, f: usize| {
            let at = |e: usize, f: usize| of_edges[(e.max(f), e.min(f))];
            at(e + 1, f + 1) - at(e, f + 1) - at(e + 1, f) + at(e, f)
        };
        // per unit of the resultant
        let whole = twin.patch(reference);
        let to_edge: Vec<f64> = edges.iter().map(|edge| patches(*edge, reference)).collect();
        let with_it: Vec<f64> = to_edge.windows(2).map(|pair| (pair[1] - pair[0]) / whole).collect();
        let itself = patches(reference, reference) / whole.powi(2);
        for e in 0..elements {
            let own = self.resultants[e];
            for f in 0..=e {
                let other = self.resultants[f];
                let both = both(e, f) - own * with_it[f] - other * with_it[e] + own * other * itself;
                for (unit, least) in self.unit.iter_mut().zip(least) {
                    unit[(e, f)] = twin.half_space(*least) * both;
                    unit[(f, e)] = unit[(e, f)];
                }
            }
            for (linear, least) in self.linear.iter_mut().zip(least) {
                linear[e] = twin.half_space(*least) * (with_it[e] - own * itself);
            }
        }
    }

    fn add_waves(&mut self, kernel: &Compliances, least: &[f64], grid: &Grid, waves: &Waves) {
        let (elements, twin) = (self.elements(), grid.twin());
        let whole = twin.patch(grid.shortest());
        for (from, to) in waves.octaves() {
            let (zeta, widths): (Vec<f64>, Vec<f64>) = rule(waves.nodes).on(from, to).unzip();
            let mut transforms = Mat::<f64>::zeros(zeta.len(), elements);
            let reference = twin.patch_transform(&zeta, grid.shortest());
            let beyond: Vec<f64> = reference.iter().map(|transform| transform / whole).collect();
            let mut edge = vec![0.0; zeta.len()];
            for e in 0..elements {
                let next = twin.patch_transform(&zeta, grid.edges()[e + 1]);
                let column = transforms.col_as_slice_mut(e);
                for (k, next) in next.iter().enumerate() {
                    column[k] = next - edge[k] - self.resultants[e] * beyond[k];
                }
                edge = next;
            }
            for (i, (unit, linear)) in self.unit.iter_mut().zip(&mut self.linear).enumerate() {
                let (mut weights, mut forces) = (Vec::new(), Vec::new());
                for ((zeta, w), beyond) in zeta.iter().zip(&widths).zip(&beyond) {
                    let w = w / twin.over_waves(*zeta);
                    let (own, coupled) = (kernel.own(i, *zeta) - least[i], kernel.coupled(i, *zeta));
                    weights.push(w * (own + coupled));
                    // a given neighbour counts by what it differs from the pressure that all are compared with
                    forces.push(w * (own * (1.0 + beyond) + coupled * beyond - kernel.given(i, *zeta)));
                }
                add_gram(&transforms, &weights, unit);
                for (e, linear) in linear.iter_mut().enumerate() {
                    *linear += transforms.col_as_slice(e).iter().zip(&forces).map(|(d, force)| d * force).sum::<f64>();
                }
            }
            for (i, coupling) in self.coupling.iter_mut().enumerate() {
                let weights: Vec<f64> = zeta
                    .iter()
                    .zip(&widths)
                    .map(|(zeta, w)| w / twin.over_waves(*zeta) * kernel.coupling(i, *zeta))
                    .collect();
                if weights.iter().any(|weight| *weight != 0.0) {
                    add_gram(&transforms, &weights, coupling);
                }
            }
        }
    }

    /// Adds multiples of the squares of the resultants, which are given: a pressure like that which all are compared with has no
    /// energy otherwise.
    fn add_resultants(&mut self, kernel: &Compliances, grid: &Grid) {
        let unit_length = grid.twin().measure(grid.shortest().recip());
        for (i, unit) in self.unit.iter_mut().enumerate() {
            for e in 0..self.resultants.len() {
                for f in 0..self.resultants.len() {
                    unit[(e, f)] += unit_length * kernel.limit(i) * self.resultants[e] * self.resultants[f];
                }
            }
        }
    }

    fn add_punches(&mut self, kernel: &Compliances, grid: &Grid) {
        for i in 0..self.contacts() {
            let Some(profile) = kernel.side(i).profile() else { continue };
            let last = profile.edge().unwrap_or(f64::INFINITY);
            for e in 0..self.elements() {
                let [from, to] = grid.element(e);
                self.inadmissible[i][e] = to > last;
                if !self.inadmissible[i][e] {
                    let heights = rule(8)
                        .on(from, to)
                        .map(|(x, weight)| grid.twin().patch_measure(x) * weight * profile.height(x));
                    self.linear[i][e] += heights.sum::<f64>();
                }
            }
        }
    }
}

/// Octaves of wavenumbers.
struct Waves {
    first: f64,
    last: f64,
    /// Nodes in each.
    nodes: usize,
}

impl Waves {
    fn new(grid: &Grid) -> Self {
        let widths: Vec<f64> = grid.edges().windows(2).map(|pair| pair[1] - pair[0]).collect();
        let shortest = widths.iter().fold(f64::INFINITY, |shortest: f64, width| shortest.min(*width));
        let fineness = grid.edges()[1..].iter().zip(&widths).map(|(x, width)| x / width).fold(0.0, f64::max);
        Self {
            first: LONGEST_WAVE / grid.edges()[widths.len()],
            last: SHORTEST_WAVE / shortest,
            nodes: (PER_FINENESS * (8.0 + fineness.min(80.0))) as usize,
        }
    }

    fn octaves(&self) -> impl Iterator<Item = (f64, f64)> {
        let edges = std::iter::successors(Some(self.first), |edge| Some(2.0 * edge));
        let last = self.last;
        std::iter::once((0.0, self.first))
            .chain(edges.take_while(move |edge| *edge < last).map(|from| (from, 2.0 * from)))
    }

    /// The least value of the kernel of each contact; less of it where the energy of some wave would not be positive
    /// without it, since some other kernel is negative.
    fn least(&self, kernel: &Compliances) -> Vec<f64> {
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

/// Adds transformsᵀ diag(weights) transforms.
fn add_gram(transforms: &Mat<f64>, weights: &[f64], sum: &mut Mat<f64>) {
    let mut weighted = transforms.clone();
    for e in 0..weighted.ncols() {
        weighted.col_as_slice_mut(e).iter_mut().zip(weights).for_each(|(value, weight)| *value *= weight);
    }
    matmul(sum.as_mut(), Accum::Add, transforms.transpose(), weighted.as_ref(), 1.0, Par::Seq);
}
