//! Where and with which weights the wavenumber integrals are evaluated, for given modes and about given half-lengths.
//!
//! Every matrix entry is an integral of a kernel times two Bessel functions, ∫ g(ζ) J_k(ζa) J_j(ζa') dζ/ζ. What is
//! left of g when its limit g∞ is taken out either vanishes at some ζ, and so do the integrals, or has a tail like
//! 1/ζ. Beyond a wavenumber R past the turning points, Ra > order, the products of one contact's own functions split,
//! J_k J_j = ½ Re(H_k H̄_j) + ½ Re(H_k H_j): the first part does not oscillate, the second decays in the upper half of
//! the complex plane, where its path is turned.
use num_complex::Complex64;

use crate::kernel::Kernel;
use crate::numeric::chebyshev::Series;
use crate::numeric::quadrature::{laguerre_rule, rule};

/// Longest stretch, in Gauss points, before it is cut in two.
const LONGEST: usize = 512;
/// More wavenumbers than this no admissible scene was seen to need.
const MOST_WAVENUMBERS: usize = 8_000;
/// Stretches with more such parts are left out of fields.
const MOST_PARTS: usize = 8;
/// Points on the path into the complex plane.
const TURNED_POINTS: usize = 32;

/// Nodes and weights; `weights` of a contact or coupling cover the first nodes of `zeta`.
pub(super) struct Layout {
    /// Real wavenumbers, ascending, shared by all contacts.
    pub(super) zeta: Vec<f64>,
    /// Per contact.
    pub(super) own: Vec<Own>,
    /// Per pair of neighbours: weights dζ/ζ times the coupling.
    pub(super) coupling: Vec<Vec<f64>>,
}

/// What belongs to one contact alone.
pub(super) struct Own {
    /// Weights dζ/ζ times the diagonal kernel less its limit.
    pub(super) diagonal: Vec<f64>,
    /// Weights dζ/ζ times the kernel under equal neighbouring pressures less the same limit.
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

impl Layout {
    /// For half-lengths (in units of L) near `half_lengths` and Bessel functions up to the given orders, able to resolve
    /// the fields out to |x| = `span` besides; `None` if that takes too many wavenumbers.
    pub(super) fn new(kernel: &Kernel, half_lengths: &[f64], orders: &[usize], span: f64) -> Option<Self> {
        let n = kernel.contacts();
        let reaches: Vec<f64> = (0..n)
            .map(|i| {
                let (far, turned) = (kernel.far(i), turning(orders[i]) / half_lengths[i]);
                if far.is_constant() && far.from <= turned { far.from } else { turned }
            })
            .collect();
        let mut layout = Self { zeta: Vec::new(), own: Vec::new(), coupling: vec![Vec::new(); n - 1] };
        layout.own.extend((0..n).map(|i| Own {
            diagonal: Vec::new(),
            unit: Vec::new(),
            reach: 0,
            limit: kernel.far(i).limit,
            tail: if kernel.far(i).is_constant() && kernel.far(i).from <= reaches[i] {
                Tail::default()
            } else {
                Tail::new(kernel, i, reaches[i], half_lengths[i], orders[i])
            },
        }));
        let coupled = kernel.panels().iter().filter(|panel| panel.coupled.contains(&true));
        let last = coupled.map(|panel| panel.to).chain(reaches.iter().copied()).fold(0.0, f64::max);
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
            let next = kernel.panels().get(panel).map_or(2.0 * edge, |panel| panel.to);
            let mut cuts = vec![edge];
            cuts.extend(reaches.iter().copied().filter(|&r| edge < r && r < next));
            cuts.push(next);
            cuts.sort_by(f64::total_cmp);
            for pair in cuts.windows(2) {
                layout.stretch(kernel, panel, pair[0], pair[1], half_lengths, &reaches, span);
            }
            edge = next;
        }
        for i in 0..n {
            let couplings = layout.coupling[i.saturating_sub(1)..(i + 1).min(n - 1)].iter().map(Vec::len);
            layout.own[i].reach = couplings.fold(layout.own[i].diagonal.len(), usize::max);
        }
        Some(layout)
    }

    /// Adds the nodes of one stretch within a panel, unless nobody needs it.
    #[expect(clippy::too_many_arguments, reason = "one call, in the loop above")]
    fn stretch(
        &mut self,
        kernel: &Kernel,
        panel: usize,
        from: f64,
        to: f64,
        half_lengths: &[f64],
        reaches: &[f64],
        span: f64,
    ) {
        let n = kernel.contacts();
        let panel = kernel.panels().get(panel);
        let gapless = |nodes: &Vec<f64>| nodes.len() == self.zeta.len();
        let coupled: Vec<bool> =
            (0..n - 1).map(|i| panel.is_some_and(|panel| panel.coupled[i]) && gapless(&self.coupling[i])).collect();
        let own: Vec<bool> = (0..n).map(|i| to <= reaches[i] && gapless(&self.own[i].diagonal)).collect();
        let mut frequency: f64 = 0.0;
        for i in 0..n {
            if own[i] {
                frequency = frequency.max(half_lengths[i] + half_lengths[i].max(span));
            }
            if i + 1 < n && coupled[i] {
                frequency = frequency.max(half_lengths[i].max(half_lengths[i + 1]) * 2.0).max(span);
            }
        }
        if frequency == 0.0 {
            return;
        }
        // a Gauss rule resolves a wave once it has two points per wavelength and some to spare
        let phase = frequency * (to - from);
        let needed = (13.0 + 0.25 * phase + 3.0 * (0.5 * phase).cbrt()).ceil() as usize;
        let parts = needed.div_ceil(LONGEST).min(MOST_WAVENUMBERS / LONGEST + 1);
        if span > 0.0 && parts > MOST_PARTS {
            // far from a contact, waves so much shorter than the distance do not matter
            return;
        }
        let points = rule(needed.div_ceil(parts).clamp(16, LONGEST));
        let mut components = vec![0.0; 3 * n - 1];
        for part in 0..parts {
            let at = |k: usize| from + (to - from) * k as f64 / parts as f64;
            for (zeta, weight) in points.on(at(part), at(part + 1)) {
                let weight = weight / zeta;
                if let Some(panel) = panel {
                    panel.interpolate(zeta, &mut components);
                }
                for i in 0..n {
                    if own[i] {
                        let far = kernel.far(i);
                        let (diagonal, unit) = if zeta > far.from {
                            let excess = far.excess(zeta);
                            (excess, excess)
                        } else {
                            (components[i] - far.limit, components[n + i] - far.limit)
                        };
                        self.own[i].diagonal.push(weight * diagonal);
                        self.own[i].unit.push(weight * unit);
                    }
                    if i + 1 < n && coupled[i] {
                        self.coupling[i].push(weight * components[2 * n + i]);
                    }
                }
                self.zeta.push(zeta);
            }
        }
    }
}

impl Tail {
    fn new(kernel: &Kernel, contact: usize, from: f64, half_length: f64, orders: usize) -> Self {
        let far = kernel.far(contact);
        let excess = |zeta: f64| {
            if zeta >= far.from {
                return far.excess(zeta);
            }
            let mut components = vec![0.0; 3 * kernel.contacts() - 1];
            let panels = kernel.panels();
            let at = panels.partition_point(|panel| panel.to < zeta).min(panels.len() - 1);
            panels[at].interpolate(zeta, &mut components);
            components[contact] - far.limit
        };
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
        let local = Series::of(0.55 * from, 2.2 * from, 28, excess);
        let laguerre = laguerre_rule(TURNED_POINTS);
        for (s, weight) in laguerre.nodes.iter().zip(&laguerre.weights) {
            let zeta = Complex64::new(from, 0.5 * s / half_length);
            let g = if from >= far.from { far.excess_complex(zeta) } else { local.eval_complex(zeta) };
            tail.turned.push(zeta);
            tail.lift.push(0.5 * s);
            tail.turned_roots.push((Complex64::new(0.0, 0.25 * weight / half_length) * g / zeta).sqrt());
        }
        tail
    }
}
