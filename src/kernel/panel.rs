//! A panel of the wavenumber axis, on which all kernels are polynomials to rounding.
use std::borrow::Cow;
use std::sync::LazyLock;

use crate::numeric::vector::vectorised;
use crate::numeric::{chebyshev, dot, quadrature};
use crate::solution::Stats;
use crate::system::Unresolved;

use super::components::{Components, Sample};
use super::{Asymptote, Chains};

/// Gauss points per panel.
pub(crate) const POINTS: usize = chebyshev::PANEL;
/// A panel is resolved if the last Legendre coefficients are below this, relative to the kernel's size on the panel.
const RESOLVED: f64 = 1e-13;
/// Kernels vary on the scale of the wavenumber: a component that is not resolved on a panel as narrow as this part of it, or
/// below this wavenumber, varies by rounding errors only.
const NARROWEST: f64 = 1.0 / 16.0;
const LOWEST: f64 = 1e-9;
/// A coupling below this part of the diagonals and of the equal-pressure responses of both contacts counts as zero.
const NEGLIGIBLE: f64 = 1e-17;

/// Kernel values at the Gauss points of one panel.
#[derive(Clone, Debug)]
pub(crate) struct Panel {
    /// Lower end.
    pub(crate) from: f64,
    /// Upper end.
    pub(crate) to: f64,
    /// Component by component, `POINTS` values each, multiplied by the power of ζ that makes them smooth at ζ = 0.
    values: Vec<[f64; POINTS]>,
    /// The laminates that equal pressures bend, and what that takes from the digits of the compliance on top, see [`Sample`].
    bent: Vec<bool>,
    cancelled: f64,
    /// The couplings that do not vanish on this panel.
    pub(crate) coupled: Vec<bool>,
    /// Bounds on the equal-pressure response of each contact minus its short-wave limit, or, where the asymptote holds, minus
    /// the asymptote.
    pub(crate) remainders: Vec<f64>,
    /// Bounds on the couplings.
    pub(crate) couplings: Vec<f64>,
    order: Components,
}

/// ζ to one of the powers of components.
fn power(zeta: f64, power: i32) -> f64 {
    match power {
        0 => 1.0,
        1 => zeta,
        _ => zeta * zeta * zeta,
    }
}

/// Adds panels for [from, to], halved until every component is resolved, and returns whether that took more than one. If this
/// is `expected`, both halves are sampled at once, since samples of a panel that is not resolved are wasted; from the samples of
/// the halves it follows whether one panel would have sufficed.
pub(super) fn resolve(
    chains: &Chains,
    [from, to]: [f64; 2],
    expected: bool,
    wanted: &[bool],
    panels: &mut Vec<Panel>,
    stats: &mut Stats,
) -> Result<bool, Unresolved> {
    if !expected {
        let panel = Panel::new(chains, from, to, wanted, stats)?;
        if panel.is_resolved() || to < LOWEST || to - from < NARROWEST * to {
            panels.push(panel);
            return Ok(false);
        }
    }
    let (first, middle) = (panels.len(), 0.5 * (from + to));
    resolve(chains, [from, middle], false, wanted, panels, stats)?;
    resolve(chains, [middle, to], false, wanted, panels, stats)?;
    if let ([left, right], true) = (&panels[first..], expected)
        && left.is_one_with(right)
    {
        // interpolated values are less accurate than samples
        let whole = Panel::new(chains, from, to, wanted, stats)?;
        if whole.is_resolved() {
            panels.truncate(first);
            panels.push(whole);
            return Ok(false);
        }
    }
    Ok(true)
}

/// Whether components of given sizes, with given values on a panel [from, to], are resolved; laminates may be `bent`.
fn resolved(
    order: Components,
    (bent, on_top): (&[bool], f64),
    [from, to]: [f64; 2],
    size: impl Fn(usize) -> f64,
    values: impl Fn(usize) -> [f64; POINTS],
) -> bool {
    let n = order.contacts;
    // the equal-pressure response has the rounding error of the bending of the laminates above and below, over 1 + ζ²
    let cancelled = |i: usize| {
        let laminates = order.shared(i).filter(|laminate| bent[*laminate]);
        laminates.map(|laminate| size(order.coupling(laminate))).fold(0.0, f64::max) / (1.0 + to * to)
    };
    // a coupling need be as accurate as the diagonals and equal-pressure responses of its contacts only
    let coupled = |i: usize| size(i).min(from * from * size(order.equal(i)));
    // only laminates below the lowest contact leave anything there
    let closed = |i: usize| if i == order.lowest { on_top } else { 0.0 };
    (0..order.squeezed()).all(|c| {
        let size = size(c);
        let scale = match c / n {
            0 => size.max(closed(c)),
            1 => size.max(cancelled(c - n)).max(closed(c - n)),
            _ => order.pair(c - 2 * n).into_iter().fold(size, |most, i| most.max(coupled(i))),
        };
        size == 0.0 || chebyshev::legendre_tail(&values(c)) * size <= RESOLVED * scale
    })
}

impl Panel {
    fn new(chains: &Chains, from: f64, to: f64, wanted: &[bool], stats: &mut Stats) -> Result<Self, Unresolved> {
        let order = chains.order();
        let mut sample = Sample::new(order);
        let (mut values, mut most_cancelled) = (vec![[0.0; POINTS]; sample.components.len()], 0.0);
        for (k, x) in quadrature::rule(POINTS).nodes.iter().enumerate() {
            let zeta = 0.5 * (from + to) + 0.5 * (to - from) * x;
            chains.sample(zeta, wanted, &mut sample, stats)?;
            most_cancelled = sample.cancelled.max(most_cancelled);
            for (c, value) in sample.components.iter().enumerate() {
                values[c][k] = value * power(zeta, order.power(c));
            }
        }
        let (coupled, remainders, couplings) = Default::default();
        let bent = sample.bent;
        let mut panel =
            Self { from, to, values, bent, cancelled: most_cancelled, coupled, remainders, couplings, order };
        panel.coupled = (0..order.pairs())
            .map(|pair| {
                // negligible next to bending by one pressure, and next to bending by equal pressures, ζ² times smaller
                let least = |i: usize| panel.size(i).min(from * from * panel.size(order.equal(i)));
                panel.size(order.coupling(pair))
                    > NEGLIGIBLE * order.pair(pair).map(least).into_iter().fold(f64::INFINITY, f64::min)
            })
            .collect();
        Ok(panel)
    }

    /// Whether one panel would resolve what this one and the next, of the same width, do.
    fn is_one_with(&self, next: &Self) -> bool {
        /// Weights that interpolate from the Gauss points of a half to those points of the whole that lie in it.
        static HALVES: LazyLock<Vec<[f64; POINTS]>> = LazyLock::new(|| {
            let nodes = quadrature::rule(POINTS).nodes.iter();
            nodes.map(|x| chebyshev::panel_row(2.0 * x - x.signum())).collect()
        });
        let both = |c: usize| {
            std::array::from_fn(|k| {
                let half = if 2 * k < POINTS { self } else { next };
                dot(&HALVES[k], &half.values[c])
            })
        };
        let bent: Vec<bool> = self.bent.iter().zip(&next.bent).map(|(one, other)| *one || *other).collect();
        resolved(
            self.order,
            (&bent, self.cancelled.max(next.cancelled)),
            [self.from, next.to],
            |c| self.size(c).max(next.size(c)),
            both,
        )
    }

    /// Adds a constant flexibility to contact 0.
    pub(super) fn add_to_first(&mut self, flexibility: f64) {
        for component in [0, self.order.equal(0), self.order.squeezed()] {
            let exponent = self.order.power(component);
            for ((zeta, _), value) in quadrature::rule(POINTS).on(self.from, self.to).zip(&mut self.values[component]) {
                *value += flexibility * power(zeta, exponent);
            }
        }
    }

    fn size(&self, c: usize) -> f64 {
        self.values[c].iter().fold(0.0, |size, value| size.max(value.abs()))
    }

    fn is_resolved(&self) -> bool {
        resolved(self.order, (&self.bent, self.cancelled), [self.from, self.to], |c| self.size(c), |c| self.values[c])
    }

    /// The Gauss points, and a component there.
    fn samples(&self, component: usize) -> impl Iterator<Item = (f64, f64)> {
        let exponent = self.order.power(component);
        let nodes = quadrature::rule(POINTS).on(self.from, self.to);
        nodes.zip(&self.values[component]).map(move |((zeta, _), value)| (zeta, value / power(zeta, exponent)))
    }

    /// The largest absolute value of a component minus `limit`, on the Gauss points.
    fn largest(&self, component: usize, limit: f64) -> f64 {
        self.samples(component).fold(0.0, |largest: f64, (_, value)| largest.max((value - limit).abs()))
    }

    /// The largest Gauss point at which the diagonal of contact `i` differs from `limit` by more than `little`.
    pub(super) fn last_above(&self, i: usize, limit: f64, little: f64) -> Option<f64> {
        self.samples(i).filter(|(_, value)| (value - limit).abs() > little).map(|(zeta, _)| zeta).last()
    }

    /// The largest Gauss point at which a coupling is larger than `little`.
    pub(super) fn last_coupled_above(&self, pair: usize, little: f64) -> Option<f64> {
        let samples = self.samples(self.order.coupling(pair));
        samples.filter(|(_, value)| value.abs() > little).map(|(zeta, _)| zeta).last()
    }

    /// Bounds the remainders and the couplings, once the asymptotes are known.
    pub(super) fn measure(&mut self, asymptotes: &[Asymptote]) {
        let order = self.order;
        let coupling = |pair: usize| if self.coupled[pair] { self.largest(order.coupling(pair), 0.0) } else { 0.0 };
        self.couplings = (0..order.pairs()).map(coupling).collect();
        let remainder = |(i, asymptote): (usize, &Asymptote)| {
            if self.from < asymptote.from {
                self.largest(order.equal(i), asymptote.limit)
            } else {
                order.shared(i).map(|pair| self.couplings[pair]).sum()
            }
        };
        self.remainders = asymptotes.iter().enumerate().map(remainder).collect();
    }

    /// A part of the panel, with the same polynomials.
    pub(super) fn part(&self, from: f64, to: f64) -> Self {
        let nodes = quadrature::rule(POINTS).on(from, to);
        let rows: Vec<[f64; POINTS]> = nodes.map(|(zeta, _)| chebyshev::panel_row(self.place(zeta))).collect();
        let values = self.values.iter().map(|values| std::array::from_fn(|k| dot(&rows[k], values))).collect();
        Self { from, to, values, ..self.clone() }
    }

    /// Where a wavenumber is on the panel, from −1 to 1.
    fn place(&self, zeta: f64) -> f64 {
        (zeta - 0.5 * (self.from + self.to)) / (0.5 * (self.to - self.from))
    }

    /// The components at one wavenumber.
    pub(super) fn at(&self, zeta: f64) -> At<'_> {
        At { panel: self, zeta, row: chebyshev::panel_row(self.place(zeta)) }
    }

    /// Equal-pressure responses, couplings and the sum of the former at the wavenumbers `zeta`, the points of a Gauss rule on [from, to], which is
    /// the panel or a part of it, to be written over others.
    pub(crate) fn values(&self, zeta: &[f64], [from, to]: [f64; 2], all: &mut Values) {
        let (order, count) = (self.order, zeta.len());
        let columns = if from == self.from && to == self.to {
            Cow::Borrowed(chebyshev::panel_matrix(count))
        } else {
            let places: Vec<f64> = zeta.iter().map(|zeta| self.place(*zeta)).collect();
            Cow::Owned(chebyshev::panel_columns(&places))
        };
        all.clear(order, count);
        for (component, values) in (order.contacts..order.count()).zip(all.values.chunks_exact_mut(count)) {
            let pair = component.checked_sub(order.coupling(0)).filter(|pair| *pair < order.pairs());
            if pair.is_some_and(|pair| !self.coupled[pair]) {
                continue;
            }
            let exponent = order.power(component);
            vectorised(
                #[inline(always)]
                || {
                    for (four, sampled) in
                        columns.chunks_exact(4 * count).zip(self.values[component].as_chunks::<4>().0)
                    {
                        let (two, more) = four.split_at(2 * count);
                        let ((a, b), (c, d)) = (two.split_at(count), more.split_at(count));
                        for ((((value, a), b), c), d) in values.iter_mut().zip(a).zip(b).zip(c).zip(d) {
                            *value += (a * sampled[0] + b * sampled[1]) + (c * sampled[2] + d * sampled[3]);
                        }
                    }
                    if exponent > 0 {
                        values.iter_mut().zip(zeta).for_each(|(value, zeta)| *value /= power(*zeta, exponent));
                    }
                },
            );
        }
    }
}

/// Equal-pressure responses, couplings, and the sum of the former, at several wavenumbers.
#[derive(Default)]
pub(crate) struct Values {
    count: usize,
    contacts: usize,
    pairs: usize,
    values: Vec<f64>,
}

impl Values {
    /// No couplings, and nothing else yet.
    pub(super) fn clear(&mut self, order: Components, count: usize) {
        (self.count, self.contacts, self.pairs) = (count, order.contacts, order.pairs());
        self.values.clear();
        self.values.resize(count * (order.contacts + order.pairs() + 1), 0.0);
    }

    /// Puts the short-wave asymptote, and the couplings that are parts of it, in place of the equal-pressure response of contact `i`.
    pub(super) fn set_far(&mut self, order: Components, i: usize, asymptotic: impl Iterator<Item = f64>) {
        let (count, contacts) = (self.count, self.contacts);
        let (equal, rest) = self.values.split_at_mut(contacts * count);
        for (k, asymptotic) in asymptotic.enumerate() {
            let value = asymptotic + order.shared(i).map(|pair| rest[pair * count + k]).sum::<f64>();
            let before = std::mem::replace(&mut equal[i * count + k], value);
            if !order.is_opening(i) {
                rest[self.pairs * count + k] += value - before;
            }
        }
    }

    /// The sum of all equal-pressure responses.
    pub(crate) fn squeezed(&self) -> &[f64] {
        self.coupling(self.pairs)
    }

    /// The equal-pressure response of contact `i`.
    pub(crate) fn equal_pressure(&self, i: usize) -> &[f64] {
        &self.values[i * self.count..(i + 1) * self.count]
    }

    /// The coupling of the contacts `i` and `i + 1`.
    pub(crate) fn coupling(&self, i: usize) -> &[f64] {
        self.equal_pressure(self.contacts + i)
    }
}

/// The components of a panel at one wavenumber, each evaluated on demand.
pub(super) struct At<'a> {
    pub(super) panel: &'a Panel,
    zeta: f64,
    row: [f64; POINTS],
}

impl At<'_> {
    fn component(&self, component: usize) -> f64 {
        dot(&self.row, &self.panel.values[component]) / power(self.zeta, self.panel.order.power(component))
    }

    /// The equal-pressure response of contact `i`.
    pub(super) fn equal_pressure(&self, i: usize) -> f64 {
        self.component(self.panel.order.equal(i))
    }

    /// The coupling of the contacts `i` and `i + 1`, 0 where it vanishes.
    pub(super) fn coupling(&self, i: usize) -> f64 {
        if self.panel.coupled[i] { self.component(self.panel.order.coupling(i)) } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use recede_layers::{HalfPlane, Homogeneous, Plane};

    use crate::kernel::{Kernel, Sample};
    use crate::solution::Stats;
    use crate::stack::Stack;

    /// Next to a loose thin layer that bends very easily equal-pressure responses keep their accuracy.
    #[test]
    fn kernels_next_to_thin_layers_are_resolved() {
        let layer = |thickness: f64, modulus: f64| Homogeneous::new(thickness, modulus, 0.3).unwrap();
        let ground = HalfPlane::new(10.0, 0.25).unwrap();
        for thickness in [1e-1, 1e-2, 1e-3] {
            let thin = Stack::builder(Plane::Strain).layer(layer(thickness, 1.0)).receding();
            let soft = thin.layer(layer(0.3, 0.05)).bonded().layer(layer(0.1, 50.0)).bonded();
            let stack = soft.layer(layer(0.4, 0.1)).bonded().layer(ground).build().unwrap();
            let kernel = Kernel::new(&stack).unwrap();
            let mut exact = Sample::new(kernel.chains.order());
            for k in 1..400 {
                let zeta = 0.01 * 1.02f64.powi(k);
                kernel.chains.sample(zeta, &[true; 2], &mut exact, &mut Stats::default()).unwrap();
                for i in 0..2 {
                    let found = kernel.remainder(i, zeta) + kernel.asymptote(i).limit;
                    // the longer the waves, the less accurate they need be
                    let off = (found / exact.components[2 + i] - 1.0).abs() * zeta.min(1.0);
                    assert!(off < 1e-11, "thickness {thickness}, contact {i}, zeta {zeta:e}: {off:e}");
                }
            }
        }
    }
}
