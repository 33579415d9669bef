//! Where and with which weights the wavenumber integrals are evaluated, for given modes and about given half-lengths.
//!
//! Every matrix entry is an integral of a kernel times two Bessel functions, ∫ g(ζ) J_k(ζa) J_j(ζa') dζ/ζ. What is
//! left of g when its limit g∞ is taken out either vanishes at some ζ, and so do the integrals, or has a tail like
//! 1/ζ. Beyond a wavenumber R past the turning points, Ra > order, the products of one contact's own functions split,
//! J_k J_j = ½ Re(H_k H̄_j) + ½ Re(H_k H_j): the first part does not oscillate, the second decays in the upper half of
//! the complex plane, where its path is turned.
use num_complex::Complex64;

use crate::kernel::{Kernel, Panel};
use crate::numeric::chebyshev::Series;
use crate::numeric::quadrature::{laguerre_rule, rule};

/// Longest stretch, in Gauss points, before it is cut in two.
const LONGEST: usize = 512;
/// No admissible scene was seen to need more wavenumbers.
const MOST_WAVENUMBERS: usize = 16_000;
/// Stretches with more such parts are left out of fields.
const MOST_PARTS: usize = 8;
/// Points on the path into the complex plane.
const TURNED_POINTS: usize = 32;

/// Real wavenumbers that a tail must save.
const TAIL_PAYS: f64 = 100.0;

/// What a layout is made for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Accuracy {
    /// Parts of a kernel that are smaller than this, relative to its limit, are left out.
    pub(super) negligible: f64,
    /// Gauss points besides those that the oscillation takes.
    pub(super) spare: f64,
}

impl Accuracy {
    /// What answers with a relative error of `tolerance` need.
    pub(super) fn of(tolerance: f64) -> Self {
        Self { negligible: (1e-4 * tolerance).min(1e-10), spare: 10.0 }
    }
}

/// For the first steps.
pub(super) const COARSE: Accuracy = Accuracy { negligible: 1e-5, spare: 6.0 };

/// Nodes and weights; `weights` of a contact or coupling cover the first nodes of `zeta`.
pub(super) struct Layout {
    /// Real wavenumbers, ascending, shared by all contacts.
    pub(super) zeta: Vec<f64>,
    /// Per contact.
    pub(super) own: Vec<Own>,
    /// Per pair of neighbours: weights −dζ/ζ times the coupling.
    pub(super) coupling: Vec<Vec<f64>>,
}

/// What belongs to one contact alone.
pub(super) struct Own {
    /// Weights dζ/ζ times the kernel under equal neighbouring pressures less its limit.
    pub(super) unit: Vec<f64>,
    /// How many real wavenumbers anything of this contact needs.
    pub(super) reach: usize,
    /// g∞.
    pub(super) limit: f64,
    /// What lies beyond, where J J is split.
    pub(super) tail: Tail,
}

/// The integrals beyond the wavenumber R.
#[derive(Default)]
pub(super) struct Tail {
    /// Nodes of ½ Re(H_k H̄_j) = ½ (J J + Y Y).
    pub(super) smooth: Vec<f64>,
    /// Their weights, ½ included.
    pub(super) smooth_weights: Vec<f64>,
    /// Nodes of ½ Re(H_k H_j) on the path R + is/(2a).
    pub(super) turned: Vec<Complex64>,
    /// s/2 there: H e^(s/2) is of size one.
    pub(super) lift: Vec<f64>,
    /// Square roots of their weights, ½ included.
    pub(super) turned_roots: Vec<Complex64>,
}

/// Points per stretch of the part of a tail that does not oscillate: the phases of H_k and H_j, equal far out, still
/// turn against each other by 0.4 (k − j) near the turning point.
fn smooth_points(orders: usize) -> usize {
    24 + orders / 6
}

/// Past the turning point of the highest order, and where Hankel's expansion holds for half-lengths nearby.
fn turning(orders: usize) -> f64 {
    1.3 * orders as f64 + 22.0
}

/// What a layout is built from.
struct Plan<'a> {
    kernel: &'a Kernel,
    half_lengths: &'a [f64],
    /// Where the real wavenumbers of each contact's own kernel end.
    reaches: Vec<f64>,
    /// Where those of each coupling end.
    coupled: Vec<f64>,
    accuracy: Accuracy,
    /// Fields are resolved as far out as this.
    span: f64,
}

impl Layout {
    /// For half-lengths (in units of L) near `half_lengths` and Bessel functions up to the given orders, 0 where the
    /// pressure is given, able to resolve the fields out to |x| = `span` besides; `None` if that takes too many wavenumbers.
    pub(super) fn new(
        kernel: &Kernel,
        half_lengths: &[f64],
        orders: &[usize],
        accuracy: Accuracy,
        span: f64,
    ) -> Option<Self> {
        let n = kernel.contacts();
        let mut layout = Self { zeta: Vec::new(), own: Vec::new(), coupling: vec![Vec::new(); n - 1] };
        let mut reaches = Vec::with_capacity(n);
        for i in 0..n {
            let mut ends = kernel.vanishes(i, accuracy.negligible);
            if orders[i] == 0 {
                // a given pressure is felt by others only
                ends = 0.0;
            }
            let turned = turning(orders[i]) / half_lengths[i];
            // a tail takes nodes, too
            let tail = 0.5 * half_lengths[i] * (ends - turned) > TAIL_PAYS;
            reaches.push(if tail { turned } else { ends });
            layout.own.push(Own {
                unit: Vec::new(),
                reach: 0,
                limit: kernel.far(i).limit,
                tail: if tail { Tail::new(kernel, i, turned, half_lengths[i], orders[i]) } else { Tail::default() },
            });
        }
        let coupled: Vec<f64> = (0..n - 1).map(|i| kernel.uncoupled(i, accuracy.negligible)).collect();
        let last = coupled.iter().chain(&reaches).copied().fold(0.0, f64::max);
        let plan = Plan { kernel, half_lengths, reaches, coupled, accuracy, span };
        // fields far away take more
        let most = if span > 0.0 { 2 * MOST_WAVENUMBERS } else { MOST_WAVENUMBERS };
        let mut edge = 0.0;
        for panel in 0.. {
            if edge >= last {
                break;
            }
            if layout.zeta.len() > most {
                return None;
            }
            let panel = kernel.panels().get(panel);
            let next = panel.map_or(2.0 * edge, |panel| panel.to);
            let mut cuts = vec![edge];
            cuts.extend(plan.reaches.iter().copied().filter(|&r| edge < r && r < next));
            cuts.push(next);
            cuts.sort_by(f64::total_cmp);
            for pair in cuts.windows(2) {
                layout.stretch(&plan, panel, pair[0], pair[1]);
            }
            edge = next;
        }
        for i in 0..n {
            let couplings = layout.coupling[i.saturating_sub(1)..(i + 1).min(n - 1)].iter().map(Vec::len);
            layout.own[i].reach = couplings.fold(layout.own[i].unit.len(), usize::max);
        }
        Some(layout)
    }

    /// Adds the nodes of one stretch within a panel, unless nobody needs it.
    fn stretch(&mut self, plan: &Plan, panel: Option<&Panel>, from: f64, to: f64) {
        let Plan { kernel, half_lengths, span, .. } = *plan;
        let n = kernel.contacts();
        let mut frequency: f64 = 0.0;
        for (a, reach) in half_lengths.iter().zip(&plan.reaches) {
            if to <= *reach {
                frequency = frequency.max(a + a.max(span));
            }
        }
        for (pair, reach) in half_lengths.windows(2).zip(&plan.coupled) {
            if to <= *reach {
                frequency = frequency.max(2.0 * pair[0].max(pair[1])).max(span);
            }
        }
        if frequency == 0.0 {
            return;
        }
        // a Gauss rule resolves a wave once it has two points per wavelength and some to spare
        let phase = frequency * (to - from);
        let needed = (plan.accuracy.spare + 0.25 * phase + 3.0 * (0.5 * phase).cbrt()).ceil() as usize;
        let parts = needed.div_ceil(LONGEST).min(MOST_WAVENUMBERS / LONGEST + 1);
        if span > 0.0 && parts > MOST_PARTS {
            // far from a contact, waves so much shorter than the distance do not matter
            return;
        }
        let points = rule(needed.div_ceil(parts).clamp(8, LONGEST));
        for part in 0..parts {
            let at = |k: usize| from + (to - from) * k as f64 / parts as f64;
            let first = self.zeta.len();
            let mut weights = Vec::with_capacity(points.nodes.len());
            for (zeta, weight) in points.on(at(part), at(part + 1)) {
                self.zeta.push(zeta);
                weights.push(weight / zeta);
            }
            let zeta = &self.zeta[first..];
            let values = panel.map(|panel| panel.values(zeta, at(part), at(part + 1)));
            let coupling = |i: usize, k: usize| match &values {
                Some(values) => values.coupling(i, k),
                None => 0.0,
            };
            for (i, own) in self.own.iter_mut().enumerate().filter(|(i, _)| to <= plan.reaches[*i]) {
                let far = kernel.far(i);
                own.unit.extend(weights.iter().enumerate().map(|(k, weight)| {
                    let unit = match &values {
                        Some(values) if from < far.from => values.unit(i, k) - far.limit,
                        _ => {
                            let above = i.checked_sub(1).map_or(0.0, |above| coupling(above, k));
                            far.excess(zeta[k]) + above + if i + 1 < n { coupling(i, k) } else { 0.0 }
                        }
                    };
                    weight * unit
                }));
            }
            for (i, pair) in self.coupling.iter_mut().enumerate().filter(|(i, _)| to <= plan.coupled[*i]) {
                pair.extend(weights.iter().enumerate().map(|(k, weight)| -weight * coupling(i, k)));
            }
        }
    }
}

impl Tail {
    fn new(kernel: &Kernel, contact: usize, from: f64, half_length: f64, orders: usize) -> Self {
        let far = kernel.far(contact);
        let excess = |zeta: f64| kernel.unit_excess(contact, zeta);
        let mut tail = Self::default();
        for panel in kernel.panels().iter().filter(|panel| panel.to > from && panel.to <= far.from) {
            for (zeta, weight) in rule(smooth_points(orders)).on(from.max(panel.from), panel.to) {
                tail.smooth.push(zeta);
                tail.smooth_weights.push(0.5 * weight / zeta * excess(zeta));
            }
        }
        if !far.is_constant() {
            // ζ = start/u
            let start = from.max(far.from);
            for (u, weight) in rule(smooth_points(orders)).on(0.0, 1.0) {
                tail.smooth.push(start / u);
                tail.smooth_weights.push(0.5 * weight / u * far.excess(start / u));
            }
        }
        let local = if from >= far.from { None } else { Some(Series::of(0.55 * from, 2.2 * from, 28, excess)) };
        let laguerre = laguerre_rule(TURNED_POINTS);
        for (s, weight) in laguerre.nodes.iter().zip(&laguerre.weights) {
            let zeta = Complex64::new(from, 0.5 * s / half_length);
            let g = local.as_ref().map_or_else(|| far.excess_complex(zeta), |local| local.eval_complex(zeta));
            tail.turned.push(zeta);
            tail.lift.push(0.5 * s);
            tail.turned_roots.push((Complex64::new(0.0, 0.25 * weight / half_length) * g / zeta).sqrt());
        }
        tail
    }
}
