//! Where and with which weights the wavenumber integrals are evaluated, for given modes and about given half-lengths.
//!
//! Every matrix entry is an integral of a kernel times two Bessel functions, ∫ g(ζ) J_k(ζa) J_j(ζa') dζ/ζ. What is
//! left of g when its limit g∞ is taken out either vanishes at some ζ, and so do the integrals, or has a tail like
//! 1/ζ. Where that takes many wavenumbers, the integrals beyond the turning points are found otherwise: see [`super::tail`].
use std::cell::RefCell;
use std::rc::Rc;

use crate::contact::integrals::tail::MOST_WAVENUMBERS;
use crate::contact::problem::twin::Twin;
use crate::kernel::{DepthWaves, Kernel, Panel, Values, sum_of};
use crate::numeric::means::MeanWindow;
use crate::numeric::quadrature::{LARGEST, points, rule};
use crate::numeric::waves::fades;

/// Stretches with more such parts are left out of fields.
const MOST_PARTS: usize = 8;
/// Without tails, integrals end after about this many wavenumbers.
const CUT_AFTER: f64 = 24_000.0;

/// Parts of a kernel that are smaller than this, relative to its limit, are left out of a layout: what answers with a
/// relative error of `tolerance` need.
pub(crate) fn negligible(tolerance: f64) -> f64 {
    (1e-3 * tolerance).min(1e-10)
}

/// Fields away from the contacts are wanted to this, relative.
pub(crate) const FIELDS: f64 = 1e-6;
/// Nodes and weights; the weights of a contact or coupling cover the first nodes of `zeta`.
pub(crate) struct Layout {
    /// Plane or axisymmetric.
    pub(crate) twin: Twin,
    /// See [`negligible`].
    pub(crate) negligible: f64,
    /// Real wavenumbers, ascending, shared by all contacts.
    pub(crate) zeta: Vec<f64>,
    /// Per contact.
    pub(crate) own: Vec<Own>,
    /// Per pair of neighbours: weights −dζ/ζ times the coupling.
    pub(crate) coupling: Vec<Vec<f64>>,
    /// Where the depths of punches are told from, and how.
    pub(crate) depths: RefCell<Vec<Rc<Depth>>>,
    /// Of intervals: beyond its wavenumbers each contact has tails of its intervals, from here on; infinite where it has none.
    pub(crate) tails_from: Vec<f64>,
    /// The wavenumber from which on waves are left out that matter to fields near what presses alone; infinite if there are none.
    pub(crate) left_out_from: f64,
}

/// What a layout of intervals is laid for, of each contact.
pub(crate) struct Lengths {
    /// As far as it reaches from x = 0.
    pub(crate) ends: Vec<f64>,
    /// Half of its shortest interval.
    pub(crate) shortest: Vec<f64>,
    /// The wavenumber beyond which intervals have tails of their own; infinite without tails.
    pub(crate) turned: Vec<f64>,
    /// What is taken out of its kernel, as a sum of c exp(−ζb), in pairs of b and c.
    pub(crate) exponentials: Vec<Vec<[f64; 2]>>,
}

/// What tells the depth of a punch, as long as bodies touch in its windows.
pub(crate) struct Depth {
    /// The number of the punch.
    pub(crate) punch: usize,
    /// Where displacements are averaged, of each contact.
    pub(crate) windows: Vec<MeanWindow>,
    /// What waves of the pressure of each contact add.
    pub(crate) waves: Vec<DepthWaves>,
    /// How much higher than their lowest points the punch and all gaps are there, per unit of P'.
    pub(crate) height: f64,
}

/// What belongs to one contact alone.
pub(crate) struct Own {
    /// Weights dζ/ζ times the kernel under equal neighbouring pressures less its limit.
    pub(crate) unit: Vec<f64>,
    /// How many real wavenumbers anything of this contact needs.
    pub(crate) reach: usize,
    /// g∞.
    pub(crate) limit: f64,
    /// What was taken out of `unit`: a sum of c exp(−ζb), in pairs of b and c, and weights dζ/ζ times it.
    pub(crate) exponentials: (Vec<[f64; 2]>, Vec<f64>),
}

impl Own {
    /// What was taken out of the kernel over its limit.
    pub(crate) fn exponentials_over_limit(&self) -> Vec<[f64; 2]> {
        self.exponentials.0.iter().map(|[b, c]| [*b, c / self.limit]).collect()
    }
}

/// Vectors begin with room for this number of real wavenumbers, enough for most layouts: else they grow five times each. No number depends on it.
const USUAL: usize = 512;

/// What a layout is built from.
struct Plan<'a> {
    kernel: &'a Kernel,
    half_lengths: &'a [f64],
    /// Where the real wavenumbers of each contact's own kernel end.
    reaches: Vec<f64>,
    /// Where the wavenumbers of each coupling end.
    coupled: Vec<f64>,
    /// See [`negligible`].
    negligible: f64,
    /// Fields are resolved as far out as this.
    span: f64,
}

/// Some neighbouring wavenumbers, with what integrals take there.
#[derive(Default)]
struct Nodes {
    /// The number of the first of them.
    first: usize,
    /// The weights of a sum that is the integral over dζ/ζ.
    weights: Vec<f64>,
    /// Kernels there, in the storage of the nodes before.
    values: Values,
}

impl Layout {
    /// Real wavenumbers for intervals, and where tails of their own begin, able to resolve fields out to `span` besides. Kernels that never vanish are
    /// cut off where they would take too many wavenumbers; `None` if there are too many all the same.
    pub(crate) fn new(kernel: &Kernel, lengths: &Lengths, negligible: f64, span: f64) -> Option<Self> {
        let Lengths { ends, shortest, turned, exponentials } = lengths;
        let n = kernel.contacts();
        // two wavenumbers per wavelength
        let cut = |end: f64| 2.0 * CUT_AFTER / end.max(0.5 * span);
        let mut layout = Self::empty(kernel, negligible);
        let coupled = |pair: usize| {
            let [above, below] = kernel.pair(pair);
            let shortest = shortest[above].min(shortest[below]);
            kernel.uncoupled(pair, shortest, negligible).min(cut(ends[above].max(ends[below])))
        };
        let vanishes = |i: usize| kernel.vanishes(i, shortest[i], negligible);
        let reach = |i: usize| vanishes(i).min(cut(ends[i]));
        // shorter waves that are left out for fields far away alone
        let is_short = |i: &usize| cut(ends[*i]) < vanishes(*i).min(turned[*i]) && 0.5 * span > ends[*i];
        let left_out = (0..n).filter(is_short).map(|i| cut(ends[i]));
        layout.left_out_from = left_out.fold(f64::INFINITY, f64::min);
        layout.own.iter_mut().zip(exponentials).for_each(|(own, taken)| own.exponentials.0.clone_from(taken));
        layout.tails_from = (0..n).map(|i| if turned[i] < reach(i) { turned[i] } else { f64::INFINITY }).collect();
        let plan = Plan {
            kernel,
            half_lengths: ends,
            reaches: (0..n).map(|i| reach(i).min(turned[i])).collect(),
            coupled: (0..kernel.pairs()).map(coupled).collect(),
            negligible,
            span,
        };
        layout.real(&plan)?;
        for i in 0..n {
            let couplings = kernel.neighbours(i).map(|(_, pair)| layout.coupling[pair].len());
            layout.own[i].reach = couplings.fold(layout.own[i].unit.len(), usize::max);
        }
        Some(layout)
    }

    /// Lets waves fade before the first ones that are left out: an abrupt end would be seen far away.
    pub(crate) fn faded(mut self) -> Self {
        if self.left_out_from.is_infinite() {
            return self;
        }
        let factors: Vec<f64> = self.zeta.iter().map(|zeta| fades(*zeta, self.left_out_from)).collect();
        for weights in self.own.iter_mut().map(|own| &mut own.unit).chain(&mut self.coupling) {
            weights.iter_mut().zip(&factors).for_each(|(weight, factor)| *weight *= factor);
        }
        self
    }

    /// Without wavenumbers.
    fn empty(kernel: &Kernel, negligible: f64) -> Self {
        let n = kernel.contacts();
        let own = |i: usize| Own {
            unit: Vec::with_capacity(USUAL),
            reach: 0,
            limit: kernel.asymptote(i).limit,
            exponentials: Default::default(),
        };
        Self {
            twin: Twin::of(kernel.geometry()),
            negligible,
            zeta: Vec::with_capacity(USUAL),
            own: (0..n).map(own).collect(),
            coupling: (0..kernel.pairs()).map(|_| Vec::with_capacity(USUAL)).collect(),
            depths: RefCell::default(),
            tails_from: Vec::new(),
            left_out_from: f64::INFINITY,
        }
    }

    /// All real wavenumbers; `None` if they are too many.
    fn real(&mut self, plan: &Plan) -> Option<()> {
        let last = plan.coupled.iter().chain(&plan.reaches).copied().fold(0.0, f64::max);
        let mut nodes = Nodes::default();
        let mut edge = 0.0;
        for panel in 0.. {
            if edge >= last {
                break;
            }
            if self.zeta.len() > 4 * MOST_WAVENUMBERS {
                return None;
            }
            let panel = plan.kernel.panels.get(panel);
            let next = panel.map_or(2.0 * edge, |panel| panel.to);
            // ends within the panel, in order
            let mut from = edge;
            while from < next {
                let ends = plan.reaches.iter().chain(&plan.coupled).copied();
                let to = ends.filter(|&end| from < end && end < next).fold(next, f64::min);
                self.stretch(plan, panel, [from, to], &mut nodes);
                from = to;
            }
            edge = next;
        }
        Some(())
    }

    /// Adds the nodes of one stretch within a panel, unless nobody needs it.
    fn stretch(&mut self, plan: &Plan, panel: Option<&Panel>, [from, to]: [f64; 2], nodes: &mut Nodes) {
        let Some((frequency, size)) = plan.wanted(panel, from, to) else { return };
        let digits = (size / plan.negligible).log10().clamp(1.0, f64::from(f64::DIGITS));
        let needed = points(frequency * (to - from), digits);
        let parts = needed.div_ceil(LARGEST).min(MOST_WAVENUMBERS / LARGEST + 1);
        if plan.span > 0.0 && parts > MOST_PARTS {
            // far from a contact, waves so much shorter than the distance do not matter
            self.left_out_from = self.left_out_from.min(from);
            return;
        }
        let points = rule(needed.div_ceil(parts).clamp(8, LARGEST));
        for number in 0..parts {
            let at = |k: usize| from + (to - from) * k as f64 / parts as f64;
            let [start, end] = [at(number), at(number + 1)];
            nodes.first = self.zeta.len();
            self.zeta.extend(points.on(start, end).map(|(zeta, _)| zeta));
            nodes.weights.clear();
            nodes.weights.extend(points.on(start, end).map(|(zeta, weight)| weight / zeta * self.twin.measure(zeta)));
            if let Some(panel) = panel {
                panel.values(&self.zeta[nodes.first..], [start, end], &mut nodes.values);
            }
            self.weigh(plan, panel.map(|_| &nodes.values), nodes, [from, to]);
        }
    }

    /// Adds the weights of all kernels, the values of which are known within a panel, at some real wavenumbers within a stretch.
    fn weigh(&mut self, plan: &Plan, values: Option<&Values>, nodes: &Nodes, [from, to]: [f64; 2]) {
        let (kernel, zeta, weights) = (plan.kernel, &self.zeta[nodes.first..], &nodes.weights);
        for (i, own) in self.own.iter_mut().enumerate().filter(|(i, _)| to <= plan.reaches[*i]) {
            let (far, start) = (kernel.asymptote(i), own.unit.len());
            match values {
                Some(values) if from < far.from => {
                    let excess =
                        weights.iter().zip(values.equal_pressure(i)).map(|(weight, unit)| weight * (unit - far.limit));
                    own.unit.extend(excess);
                }
                _ => {
                    let excess = weights.iter().zip(zeta).map(|(weight, zeta)| weight * far.remainder(*zeta));
                    own.unit.extend(excess);
                    for coupling in kernel.shared(i).filter_map(|pair| values.map(|values| values.coupling(pair))) {
                        let excess = own.unit[start..].iter_mut().zip(weights.iter()).zip(coupling);
                        excess.for_each(|((excess, weight), coupling)| *excess += weight * coupling);
                    }
                }
            }
            let (taken, taken_weights) = &mut own.exponentials;
            if !taken.is_empty() {
                taken_weights.extend(weights.iter().zip(zeta).map(|(weight, zeta)| weight * sum_of(taken, *zeta)));
                let excess = own.unit[start..].iter_mut().zip(&taken_weights[start..]);
                excess.for_each(|(excess, taken)| *excess -= taken);
            }
        }
        for (i, pair) in self.coupling.iter_mut().enumerate().filter(|(i, _)| to <= plan.coupled[*i]) {
            match values {
                Some(values) => {
                    let both = weights.iter().zip(values.coupling(i));
                    pair.extend(both.map(|(weight, coupling)| -weight * coupling));
                }
                None => pair.resize(pair.len() + weights.len(), 0.0),
            }
        }
    }
}

impl Plan<'_> {
    /// The highest frequency of integrands within a stretch, and the largest part of a kernel there; `None` if nobody needs it.
    fn wanted(&self, panel: Option<&Panel>, from: f64, to: f64) -> Option<(f64, f64)> {
        let (mut frequency, mut size): (f64, f64) = (0.0, 0.0);
        for (i, (a, reach)) in self.half_lengths.iter().zip(&self.reaches).enumerate() {
            if to <= *reach {
                frequency = frequency.max(a + a.max(self.span));
                let far = self.kernel.asymptote(i);
                let beyond = if from < far.from { 0.0 } else { far.remainder(from).abs() };
                size = size.max((beyond + panel.map_or(0.0, |panel| panel.remainders[i])) / far.limit);
            }
        }
        for (pair, reach) in self.coupled.iter().enumerate() {
            if to <= *reach {
                let longest = self.kernel.pair(pair).map(|i| self.half_lengths[i]).into_iter().fold(0.0, f64::max);
                frequency = frequency.max(2.0 * longest).max(self.span);
                size = size.max(panel.map_or(0.0, |panel| panel.couplings[pair]) / self.kernel.least(pair));
            }
        }
        (frequency > 0.0).then_some((frequency, size))
    }
}
