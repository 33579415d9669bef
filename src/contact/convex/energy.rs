//! The elastic energy of pressures that are constant on elements, ½ Σ p_iᵀ U_i p_i + ½ Σ (p_i − p_(i+1))ᵀ C_i (p_i −
//! p_(i+1)) + Σ b_iᵀ p_i, per unit of P'.
//!
//! A pressure 1 on [x_e, x_(e+1)] and its mirror image has the transform (2/ζ) (sin ζx_(e+1) − sin ζx_e). The energy is
//! that of [`super::super::galerkin`]. What a kernel has in common with a half-plane, its least value, is integrated in
//! closed form: −g/π ln |x| responds to a line load. What is left is a sum of squares over wavenumbers, positive even
//! where those are too few for the elements far out. Resultants are given, so only what is beyond them matters to long waves: every
//! transform is taken less that of a fixed pressure of the same resultant.
use std::f64::consts::PI;

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par};

use crate::kernel::Kernel;
use crate::numeric::quadrature::rule;

use super::super::punch::Indentation;
use super::grid::Grid;

/// Nodes per octave of wavenumbers, and some more the shorter elements are against their distance from the middle.
const PER_OCTAVE: f64 = 24.0;
const PER_FINENESS: f64 = 3.0;
const MOST_PER_OCTAVE: usize = 256;
/// Wavenumbers begin here, times the length of the grid.
const LONGEST_WAVE: f64 = 0.05;
/// And end here, divided by the length of the shortest element.
const SHORTEST_WAVE: f64 = 12.0;
/// How much longer than the grid the unit of lengths in logarithms is.
const BEYOND: f64 = 4.0;
/// Sines of smaller arguments are taken from their series.
const SMALL: f64 = 0.05;

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
    /// Elements that the punch does not reach.
    pub(super) barred: Vec<bool>,
}

impl Energy {
    pub(super) fn new(kernel: &Compliances, punch: &Indentation, grid: &Grid) -> Self {
        let (contacts, elements) = (kernel.contacts(), grid.elements());
        let widths: Vec<f64> = grid.edges().windows(2).map(|pair| pair[1] - pair[0]).collect();
        let mut energy = Self {
            unit: vec![Mat::zeros(elements, elements); contacts],
            coupling: vec![Mat::zeros(elements, elements); contacts - 1],
            linear: vec![vec![0.0; elements]; contacts],
            resultants: widths.iter().map(|width| 2.0 * width).collect(),
            barred: vec![false; elements],
        };
        let waves = Waves::new(grid, &widths);
        let least: Vec<f64> = (0..contacts).map(|i| waves.least(kernel, i)).collect();
        energy.add_half_planes(&least, grid);
        energy.add_waves(kernel, &least, grid, &waves);
        if waves.any_negative(kernel) {
            energy.add_resultants();
        }
        energy.add_punch(punch, grid);
        energy
    }

    pub(super) fn contacts(&self) -> usize {
        self.unit.len()
    }

    pub(super) fn elements(&self) -> usize {
        self.resultants.len()
    }

    fn add_half_planes(&mut self, least: &[f64], grid: &Grid) {
        let (edges, elements) = (grid.edges(), self.elements());
        // ∬ of ln|x|/unit: any unit will do, and one longer than the grid makes the form definite
        let unit = BEYOND * edges[elements];
        let twice = |x: f64| if x == 0.0 { 0.0 } else { x * x * (0.5 * (x.abs() / unit).ln() - 0.75) };
        for e in 0..elements {
            for f in 0..=e {
                let at = |k: usize, l: usize| twice(edges[e + k] + edges[f + l]) - twice(edges[e + k] - edges[f + l]);
                let both = 2.0 * (at(1, 1) - at(0, 1) - at(1, 0) + at(0, 0));
                for (unit, least) in self.unit.iter_mut().zip(least) {
                    unit[(e, f)] = -least / PI * both;
                    unit[(f, e)] = unit[(e, f)];
                }
            }
        }
    }

    fn add_waves(&mut self, kernel: &Compliances, least: &[f64], grid: &Grid, waves: &Waves) {
        let elements = self.elements();
        let end = grid.edges()[elements];
        for (from, to) in waves.octaves() {
            let zeta: Vec<(f64, f64)> = rule(waves.nodes).on(from, to).collect();
            let mut transforms = Mat::<f64>::zeros(zeta.len(), elements);
            let reference: Vec<f64> = zeta.iter().map(|(zeta, _)| (-0.5 * (zeta * end).powi(2)).exp()).collect();
            let beyond: Vec<f64> = zeta.iter().map(|(zeta, _)| -(-0.5 * (zeta * end).powi(2)).exp_m1()).collect();
            let mut edge = vec![0.0; zeta.len()];
            for e in 0..elements {
                let x = grid.edges()[e + 1];
                let column = transforms.col_as_slice_mut(e);
                for (k, (zeta, _)) in zeta.iter().enumerate() {
                    let next = deficit(*zeta, x);
                    column[k] = 2.0 * (next - edge[k]) + self.resultants[e] * beyond[k];
                    edge[k] = next;
                }
            }
            for (i, (unit, linear)) in self.unit.iter_mut().zip(&mut self.linear).enumerate() {
                let weights: Vec<f64> =
                    zeta.iter().map(|(zeta, w)| w / (PI * zeta) * (kernel.unit(i, *zeta) - least[i])).collect();
                add_gram(&transforms, &weights, unit);
                for (e, linear) in linear.iter_mut().enumerate() {
                    let terms = transforms.col_as_slice(e).iter().zip(&weights).zip(&reference);
                    *linear += terms.map(|((d, w), r)| d * w * r).sum::<f64>();
                }
            }
            for (i, coupling) in self.coupling.iter_mut().enumerate() {
                let weights: Vec<f64> =
                    zeta.iter().map(|(zeta, w)| -w / (PI * zeta) * kernel.coupling(i, *zeta)).collect();
                if weights.iter().any(|weight| *weight != 0.0) {
                    add_gram(&transforms, &weights, coupling);
                }
            }
        }
    }

    /// Adds multiples of the squares of the resultants, which are given: where a laminate bends when it is squeezed, the form
    /// is definite among pressures of no resultant only.
    fn add_resultants(&mut self) {
        let stiffness = |unit: &Mat<f64>| {
            let diagonal =
                self.resultants.iter().enumerate().map(|(e, resultant)| unit[(e, e)].abs() / resultant.powi(2));
            diagonal.fold(0.0, f64::max)
        };
        let most = self.unit.iter().map(stiffness).fold(0.0, f64::max);
        for unit in &mut self.unit {
            for e in 0..self.resultants.len() {
                for f in 0..self.resultants.len() {
                    unit[(e, f)] += most * self.resultants[e] * self.resultants[f];
                }
            }
        }
    }

    fn add_punch(&mut self, punch: &Indentation, grid: &Grid) {
        let last = punch.max_half_length().unwrap_or(f64::INFINITY);
        for e in 0..self.elements() {
            let [from, to] = grid.element(e);
            self.barred[e] = to >= last;
            if !self.barred[e] {
                self.linear[0][e] +=
                    rule(8).on(from, to).map(|(x, weight)| 2.0 * weight * punch.profile(x)).sum::<f64>();
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
    fn new(grid: &Grid, widths: &[f64]) -> Self {
        let shortest = widths.iter().fold(f64::INFINITY, |shortest: f64, width| shortest.min(*width));
        let fineness = grid.edges()[1..].iter().zip(widths).map(|(x, width)| x / width).fold(0.0, f64::max);
        Self {
            first: LONGEST_WAVE / grid.edges()[widths.len()],
            last: SHORTEST_WAVE / shortest,
            nodes: ((PER_OCTAVE + PER_FINENESS * fineness) as usize).min(MOST_PER_OCTAVE),
        }
    }

    fn octaves(&self) -> impl Iterator<Item = (f64, f64)> {
        let edges = std::iter::successors(Some(self.first), |edge| Some(2.0 * edge));
        let last = self.last;
        std::iter::once((0.0, self.first))
            .chain(edges.take_while(move |edge| *edge < last).map(|from| (from, 2.0 * from)))
    }

    /// Whether a kernel is negative anywhere.
    fn any_negative(&self, kernel: &Compliances) -> bool {
        (0..kernel.contacts()).any(|i| self.octaves().any(|(_, to)| kernel.unit(i, to) < 0.0))
    }

    /// The least value of the kernel of contact i, if that is positive.
    fn least(&self, kernel: &Compliances, i: usize) -> f64 {
        let values = self.octaves().map(|(_, to)| kernel.unit(i, to));
        values.fold(kernel.limit(i), f64::min).max(0.0)
    }
}

/// The kernels of all contacts, or that of the contact under the punch if no other opens.
pub(super) struct Compliances<'a> {
    pub(super) kernel: &'a Kernel,
    pub(super) alone: bool,
}

impl Compliances<'_> {
    fn contacts(&self) -> usize {
        if self.alone { 1 } else { self.kernel.contacts() }
    }

    fn limit(&self, i: usize) -> f64 {
        self.kernel.far(i).limit
    }

    /// The kernel of contact i under equal neighbouring pressures, or of contact 0 alone.
    fn unit(&self, i: usize, zeta: f64) -> f64 {
        match self.alone {
            true => self.kernel.compliances(zeta)[0],
            false => self.limit(i) + self.kernel.unit_excess(i, zeta),
        }
    }

    fn coupling(&self, i: usize, zeta: f64) -> f64 {
        self.kernel.coupling(i, zeta)
    }
}

/// x (sin ζx/(ζx) − 1).
fn deficit(zeta: f64, x: f64) -> f64 {
    let z = zeta * x;
    if z < SMALL {
        let z = z * z;
        -x * z / 6.0 * (1.0 - z / 20.0 * (1.0 - z / 42.0 * (1.0 - z / 72.0)))
    } else {
        z.sin() / zeta - x
    }
}

/// Adds transformsᵀ diag(weights) transforms.
fn add_gram(transforms: &Mat<f64>, weights: &[f64], sum: &mut Mat<f64>) {
    let mut weighted = transforms.clone();
    for e in 0..weighted.ncols() {
        weighted.col_as_slice_mut(e).iter_mut().zip(weights).for_each(|(value, weight)| *value *= weight);
    }
    matmul(sum.as_mut(), Accum::Add, transforms.transpose(), weighted.as_ref(), 1.0, Par::Seq);
}
