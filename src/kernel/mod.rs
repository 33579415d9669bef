//! Kernels: the stack in the contact equations, as functions of the wavenumber.
//!
//! Everything here is dimensionless: wavenumbers ζ = λL with L the total thickness of the layers, or the length over which
//! a half-plane without layers is graded, flexibilities λμ₀C with μ₀ the shear modulus at the top face. Nothing depends on
//! punch, load or contact lengths: a homogeneous half-plane, which has no length, may be measured in the length of its contact.
mod asymptote;
mod closed;
mod components;
mod cut_off;
mod depth;
mod length;
mod openings;
mod panel;

use std::sync::Arc;

use recede_layers::{Isotropic, Layer, Wave};

use crate::geometry::Geometry;
use crate::numeric::workspace::Workspace;
use crate::solution::Stats;
use crate::stack::Stack;
use crate::system::{BaseChain, BlockSystem, ClosedContacts, FreeChain, Unresolved};

pub(crate) use asymptote::{Asymptote, sum_of};
use components::{Components, Sample};
pub(crate) use depth::DepthWaves;
use panel::At;
pub(crate) use panel::{Panel, Values};

/// Beyond this λh the two faces of a layer do not interact: e^(−2·18.5) is below rounding.
pub(crate) const DECAYED: f64 = 18.5;
/// Panels double in width; more than 2^60 times the first is no stack that doubles can describe.
const DOUBLINGS: u32 = 60;
/// Most wavenumbers for each contact, so that the time is bounded for any layer: the hardest scenes known take less than half of
/// them in all. With twice as many, an unresolved stack takes twice as long to be rejected.
const MOST_WAVENUMBERS: usize = 5000;

/// The kernels of one stack.
///
/// With contacts 0 (punch), 1, ... from the top down, contact i presses on laminate i below it and, for i > 0, on
/// laminate i − 1 above it. Components, all λμ₀C:
///
/// * diagonal i: response of the gap of contact i to the pressure of the same contact, C_tt below minus C_bb above;
/// * equal-pressure response i: the same if the neighbouring contacts carry the same pressure, (C_tt + C_tb) − (C_bt + C_bb);
/// * coupling i: response of contact i to the pressure of contact i + 1, C_tb of laminate i;
/// * squeezed: the sum of all equal-pressure responses, in which what bends laminates under equal pressures, the more the longer the waves, drops out.
#[derive(Clone, Debug)]
pub(crate) struct Kernel {
    chains: Chains,
    /// Panels of the wavenumber axis, in order, without gaps from 0.
    pub(crate) panels: Vec<Panel>,
    /// The diagonals for large wavenumbers, one for each contact.
    asymptotes: Vec<Asymptote>,
    /// Counts of what was evaluated for the stack.
    stats: Stats,
    /// Compliance λμ₀C of an elastic punch, which deforms like a half-plane, 0 of a rigid one; part of contact 0.
    pub(crate) punch: f64,
    /// Storage of the tables of integrals over these kernels, shared by all kernels made of this one.
    pub(crate) workspace: Arc<Workspace>,
}

/// The chains of the block system, and the units in which they are evaluated.
#[derive(Clone, Debug)]
struct Chains {
    /// The lowest contact: what is below it lies on each other but for openings.
    lowest: usize,
    laminates: Vec<FreeChain>,
    base: BaseChain,
    /// The body that presses on top, if that is elastic and not the same for all wavenumbers.
    second: Option<BaseChain>,
    geometry: Geometry,
    length: f64,
    modulus: f64,
}

impl Chains {
    fn new(stack: &Stack, lowest: usize) -> Self {
        let (geometry, plane) = (stack.geometry(), stack.plane());
        let system = BlockSystem::new(stack);
        let (laminates, base) = (FreeChain::all(&system), BaseChain::of(&system));
        let top = laminates.first().map_or(base.top_layer(), |laminate| laminate.layers().first());
        let modulus = top.map_or(1.0, |layer| layer.material(0.0, plane).shear_compliance.recip());
        let length = [Some(stack), stack.second()].into_iter().flatten().find_map(length::intrinsic_length);
        let (length, second) = (length.unwrap_or(1.0), stack.second().map(|own| BaseChain::of(&BlockSystem::new(own))));
        Self { lowest, laminates, base, second, geometry, length, modulus }
    }

    fn order(&self) -> Components {
        Components { lowest: self.lowest, contacts: self.contacts() }
    }

    fn contacts(&self) -> usize {
        self.laminates.len() + 1
    }

    fn wave(&self, zeta: f64) -> Wave {
        Wave { wavenumber: zeta / self.length, modulus: self.modulus, plane: self.geometry.plane() }
    }

    /// All components at one wavenumber for the contacts that are `wanted`.
    fn sample(&self, zeta: f64, wanted: &[bool], sample: &mut Sample, stats: &mut Stats) -> Result<(), Unresolved> {
        let Sample { components, bent, cancelled, closed: [equal, bending] } = sample;
        let wave = self.wave(zeta);
        let (n, order) = (self.contacts(), self.order());
        let failed = || Unresolved { wavenumber: wave.wavenumber };
        components.fill(0.0);
        equal.clear();
        equal.resize(n - self.lowest, 0.0);
        bending.clear();
        stats.wavenumbers += 1;
        if stats.wavenumbers > n * MOST_WAVENUMBERS {
            return Err(failed());
        }
        // all openings are coupled with all
        let is_wanted = |i: usize| self.lowest + 1 < n || wanted[i];
        for (i, laminate) in self.laminates.iter().enumerate() {
            if !(is_wanted(i) || is_wanted(i + 1)) {
                continue;
            }
            let c = laminate.counted_flexibility(&wave, stats).ok_or_else(failed)?;
            // bending moves both faces alike; several layers are eliminated with the rounding error of bending
            bent[i] |= laminate.layers().len() > 1 || c.equal_top + c.equal_bottom != 0.0;
            if let Some(below) = i.checked_sub(self.lowest) {
                equal[below] += c.equal_top;
                equal[below + 1] -= c.equal_bottom;
                bending.push(-c.coupling);
                continue;
            }
            components[i] += c.top;
            components[n + i] += c.equal_top;
            components[i + 1] -= c.bottom;
            components[n + i + 1] -= c.equal_bottom;
            components[order.coupling(i)] = c.coupling;
            components[order.squeezed()] += c.equal_top - c.equal_bottom;
        }
        if is_wanted(n - 1) {
            equal[n - 1 - self.lowest] += self.base.counted_flexibility(&wave, stats).ok_or_else(failed)?;
            let noisy = bending.iter().zip(&bent[self.lowest..]).filter(|(_, bent)| **bent);
            *cancelled = noisy.map(|(bending, _)| bending.abs()).fold(0.0, f64::max) / (1.0 + zeta * zeta);
            let closed = (!bending.is_empty()).then(|| ClosedContacts::new(equal, bending));
            let compliance = closed.as_ref().map_or(equal[0], ClosedContacts::compliance);
            for component in [self.lowest, order.equal(self.lowest), order.squeezed()] {
                components[component] += compliance;
            }
            if let Some(closed) = closed {
                openings::set_openings(order, &closed, components);
            }
        }
        if let (Some(second), true) = (&self.second, is_wanted(0)) {
            let c = second.counted_flexibility(&wave, stats).ok_or_else(failed)?;
            [0, n, order.squeezed()].into_iter().for_each(|component| components[component] += c);
        }
        if components.iter().all(|c| c.is_finite()) { Ok(()) } else { Err(failed()) }
    }

    /// Thickness of the thinnest layer next to contact i, in units of L; infinite next to a half-plane only.
    fn thinnest_face(&self, contact: usize) -> f64 {
        let above = match contact.checked_sub(1) {
            Some(above) => self.laminates[above].layers().last(),
            None => self.second.as_ref().and_then(|second| second.layers().first()),
        };
        let below = match self.laminates.get(contact) {
            Some(laminate) => laminate.layers().first(),
            None => self.base.layers().first(),
        };
        let thickness = |layer: &Arc<dyn Layer>| layer.thickness().unwrap_or(f64::INFINITY) / self.length;
        above.into_iter().chain(below).map(thickness).fold(f64::INFINITY, f64::min)
    }
}

/// Factor by which kernels may be less accurate at a wavenumber: a contact pressure contains little of short waves,
/// ∫ J² dζ/ζ ~ 1/(ζa).
fn short_wave_allowance(half_length: f64, zeta: f64) -> f64 {
    1.0 + zeta * half_length
}

impl Kernel {
    /// Samples the flexibilities of `stack` until every component is resolved to rounding.
    pub(crate) fn new(stack: &Stack) -> Result<Self, Unresolved> {
        Self::of_stack(stack, stack.laminates().len())
    }

    /// The kernels of openings between the laminates of `stack` that weights press on each other, and of the contacts above.
    pub(crate) fn of_openings(stack: &Stack) -> Result<Self, Unresolved> {
        Self::of_stack(stack, stack.loose())
    }

    fn of_stack(stack: &Stack, lowest: usize) -> Result<Self, Unresolved> {
        let (stack, merged) = stack.merged();
        let mut kernel = Self::sampled(Chains::new(&stack, lowest))?;
        (kernel.stats.dropped, kernel.stats.merged) = (stack.dropped().len(), merged);
        Ok(kernel)
    }

    /// The kernel of the stack without one of its laminates.
    pub(crate) fn without(&self, laminate: usize) -> Result<Self, Unresolved> {
        let mut chains = self.chains.clone();
        chains.laminates.remove(laminate);
        chains.lowest -= 1;
        let mut kernel = Self::sampled(chains)?;
        let own = std::mem::replace(&mut kernel.stats, self.stats.clone());
        kernel.stats.wavenumbers += own.wavenumbers;
        kernel.stats.layers += own.layers;
        kernel.stats.repeated += own.repeated;
        kernel.stats.below_decay_depth += own.below_decay_depth;
        Ok(if self.punch == 0.0 { kernel } else { kernel.under_punch(self.punch) })
    }

    /// Samples chains until every component is resolved to rounding.
    fn sampled(chains: Chains) -> Result<Self, Unresolved> {
        let (n, order) = (chains.contacts(), chains.order());
        let (panels, asymptotes, stats) = (Vec::new(), Vec::new(), Stats::default());
        let mut kernel = Self { panels, asymptotes, stats, punch: 0.0, chains, workspace: Arc::default() };
        let mut asymptotes: Vec<Option<Asymptote>> = vec![None; n];
        let mut edge = 0.0;
        // long waves need two panels in most stacks, and an interval after one that was halved is as a rule halved too
        let mut halved = true;
        for doubling in 0..DOUBLINGS {
            for (i, asymptote) in asymptotes.iter_mut().enumerate() {
                let thickness = kernel.chains.thinnest_face(i);
                // next to a half-plane the kernel may be constant from the start
                let from = if thickness.is_finite() { edge } else { f64::max(edge, 1e-9) };
                if asymptote.is_none() && from * thickness >= DECAYED {
                    *asymptote = Asymptote::fit(&kernel.chains, i, from, &mut kernel.stats)?
                        .filter(|asymptote| edge > 0.0 || asymptote.is_constant());
                    if let (Some(asymptote), true) = (asymptote, edge == 0.0) {
                        asymptote.from = 0.0;
                    }
                }
            }
            // a coupling, one wave through the laminate, vanishes at twice the wavenumber of a reflection from its far side
            let is_coupled = |i: usize| kernel.panels.last().is_none_or(|panel| panel.coupled[i]);
            let is_wanted = |i: usize| asymptotes[i].is_none() || order.neighbours(i).any(|(_, pair)| is_coupled(pair));
            let wanted: Vec<bool> = (0..n).map(is_wanted).collect();
            if !wanted.contains(&true) {
                kernel.asymptotes = asymptotes.into_iter().flatten().collect();
                kernel.panels.iter_mut().for_each(|panel| panel.measure(&kernel.asymptotes));
                return Ok(kernel);
            }
            let next = 2.0 * f64::from(2u32).powi(doubling as i32);
            let (panels, stats) = (&mut kernel.panels, &mut kernel.stats);
            halved = panel::resolve(&kernel.chains, [edge, next], halved, &wanted, panels, stats)?;
            edge = next;
        }
        Err(Unresolved { wavenumber: edge / kernel.chains.length })
    }

    /// The same with a half-plane of another material on contact 0: its compliance is the same for all wavenumbers.
    pub(crate) fn under_half_plane(&self, material: &Isotropic) -> Self {
        let kappa = material.kappa(self.chains.geometry.plane());
        self.clone().under_punch(0.25 * (kappa + 1.0) * self.chains.modulus / material.shear_modulus)
    }

    /// The modulus E* of the two faces at a contact, in the unit of the scene, 1/E* = Σ (1 − ν²)/E in plane strain.
    pub(crate) fn contact_modulus(&self, contact: usize) -> f64 {
        2.0 * self.chains.modulus / self.asymptotes[contact].limit
    }

    /// The same with the compliance of a punch added to contact 0 at all wavenumbers.
    fn under_punch(self, punch: f64) -> Self {
        let mut kernel = Self { punch, ..self };
        kernel.panels.iter_mut().for_each(|panel| panel.add_to_first(punch));
        kernel.asymptotes.iter_mut().take(1).for_each(|asymptote| asymptote.limit += punch);
        kernel
    }

    /// Whether the kernel is constant, as for a homogeneous half-plane, in which no length occurs.
    pub(crate) fn has_no_length(&self) -> bool {
        self.panels.is_empty()
            && self.asymptotes.iter().all(|asymptote| asymptote.is_constant() && asymptote.from == 0.0)
    }

    /// The kernel of a homogeneous half-plane in another unit of length: only the unit changes.
    pub(crate) fn measured_in(&self, length: f64) -> Self {
        let chains = Chains { length, ..self.chains.clone() };
        Self { chains, ..self.clone() }
    }

    /// Plane, and in which way, or axisymmetric.
    pub(crate) fn geometry(&self) -> Geometry {
        self.chains.geometry
    }

    /// Number of contacts: the punch and the receding interfaces.
    pub(crate) fn contacts(&self) -> usize {
        self.chains.contacts()
    }

    /// Length L that makes wavenumbers dimensionless.
    pub(crate) fn length(&self) -> f64 {
        self.chains.length
    }

    /// Modulus μ₀ that makes stresses dimensionless.
    pub(crate) fn modulus(&self) -> f64 {
        self.chains.modulus
    }

    /// Number of values stored.
    pub(crate) fn stored_numbers(&self) -> usize {
        self.panels.len() * panel::POINTS * self.chains.order().squeezed()
    }

    /// Counts of what was evaluated for the stack, and of the coupling values that vanish and are left out of all integrals.
    pub(crate) fn stats(&self) -> Stats {
        let vanishing = self.panels.iter().flat_map(|panel| &panel.coupled).filter(|coupled| !**coupled);
        Stats { uncoupled: panel::POINTS * vanishing.count(), ..self.stats.clone() }
    }

    /// The same with all couplings, also those that vanish.
    #[cfg(test)]
    pub(crate) fn with_all_couplings(&self) -> Self {
        let mut kernel = self.clone();
        kernel.panels.iter_mut().for_each(|panel| {
            panel.coupled.fill(true);
            panel.measure(&kernel.asymptotes);
        });
        kernel
    }

    /// The short-wave asymptote of the diagonal of contact i.
    pub(crate) fn asymptote(&self, contact: usize) -> &Asymptote {
        &self.asymptotes[contact]
    }

    /// The wavenumber beyond which the equal-pressure response of contact i equals its short-wave limit up to `negligible` of it,
    /// weighted as for a contact of this half-length.
    pub(crate) fn vanishes(&self, contact: usize, half_length: f64, negligible: f64) -> f64 {
        let asymptote = &self.asymptotes[contact];
        let allowed = |panel: &Panel| negligible * asymptote.limit * short_wave_allowance(half_length, panel.from);
        self.last_panel(|panel| panel.remainders[contact] > allowed(panel))
            .max(asymptote.vanishes(half_length, negligible))
    }

    /// The wavenumber beyond which the coupling of the contacts i and i + 1 is below `negligible` of the lesser of their short-wave
    /// limits, weighted as for contacts of this half-length and longer ones.
    pub(crate) fn uncoupled(&self, i: usize, half_length: f64, negligible: f64) -> f64 {
        let allowed = |panel: &Panel| negligible * self.least(i) * short_wave_allowance(half_length, panel.from);
        self.last_panel(|panel| panel.couplings[i] > allowed(panel))
    }

    /// The lesser of the short-wave limits of the two that coupling i couples.
    pub(crate) fn least(&self, i: usize) -> f64 {
        let [above, below] = self.pair(i);
        self.asymptotes[above].limit.min(self.asymptotes[below].limit)
    }

    /// The wavenumber beyond which contact i depends on little else than the layers at its faces: its kernel is within a third of its
    /// short-wave limit.
    pub(crate) fn governed_by_faces(&self, contact: usize) -> f64 {
        const LITTLE: f64 = 0.33;
        let Asymptote { from, limit, .. } = self.asymptotes[contact];
        let mut panels = self.panels.iter().rev().filter(|panel| panel.from < from);
        panels.find_map(|panel| panel.last_above(contact, limit, LITTLE * limit)).unwrap_or(0.0)
    }

    /// The wavenumber beyond which the equal-pressure response of contact i is a polynomial in 1/ζ, to rounding.
    pub(crate) fn is_smooth_from(&self, contact: usize) -> f64 {
        let couplings: Vec<usize> = self.shared(contact).collect();
        self.last_panel(|panel| couplings.iter().any(|pair| panel.coupled[*pair])).max(self.asymptotes[contact].from)
    }

    /// The upper end of the last panel with a property.
    fn last_panel(&self, property: impl Fn(&Panel) -> bool) -> f64 {
        self.panels.iter().rev().find(|panel| property(panel)).map_or(0.0, |panel| panel.to)
    }

    /// The panel that holds one wavenumber, and its values there.
    fn at(&self, zeta: f64) -> Option<At<'_>> {
        Some(self.panels.get(self.panels.partition_point(|panel| panel.to < zeta))?.at(zeta))
    }

    /// How many couplings there are, and which two each of them couples, the upper one first.
    pub(crate) fn pairs(&self) -> usize {
        self.chains.order().pairs()
    }

    pub(crate) fn pair(&self, pair: usize) -> [usize; 2] {
        self.chains.order().pair(pair)
    }

    /// What a contact is coupled with, with the numbers of the couplings: the contacts above and below by the laminates between, and openings with all others and the lowest contact.
    pub(crate) fn neighbours(&self, contact: usize) -> impl Iterator<Item = (usize, usize)> + use<> {
        self.chains.order().neighbours(contact)
    }

    /// The couplings that are parts of the response of a contact under equal pressures.
    pub(crate) fn shared(&self, contact: usize) -> impl Iterator<Item = usize> + use<> {
        self.chains.order().shared(contact)
    }

    /// The lowest contact; what is below it lies on each other but for openings.
    pub(crate) fn lowest(&self) -> usize {
        self.chains.lowest
    }

    /// Whether there is anything below the lowest contact.
    pub(crate) fn has_openings(&self) -> bool {
        self.lowest() + 1 < self.contacts()
    }

    /// Coupling i, at one wavenumber.
    pub(crate) fn coupling(&self, i: usize, zeta: f64) -> f64 {
        self.at(zeta).map_or(0.0, |at| at.coupling(i))
    }

    /// The remainder of contact i at one wavenumber: the equal-pressure response minus its short-wave limit.
    pub(crate) fn remainder(&self, contact: usize, zeta: f64) -> f64 {
        self.remainder_at(contact, zeta, self.at(zeta).as_ref())
    }

    /// All kernels at the wavenumbers `zeta`, the points of a Gauss rule on [from, to], which is a panel or a part of it or lies beyond all panels, to be written over others.
    pub(crate) fn values(&self, zeta: &[f64], [from, to]: [f64; 2], values: &mut Values) {
        let number = self.panels.partition_point(|panel| panel.to <= from);
        match self.panels.get(number) {
            Some(panel) => panel.values(zeta, [from, to], values),
            None => values.clear(self.chains.order(), zeta.len()),
        }
        let far = |i: &usize| number == self.panels.len() || from >= self.asymptotes[*i].from;
        for i in (0..self.contacts()).filter(far) {
            let asymptotic = zeta.iter().map(|zeta| self.asymptotes[i].limit + self.asymptotes[i].remainder(*zeta));
            values.set_far(self.chains.order(), i, asymptotic);
        }
    }

    fn remainder_at(&self, contact: usize, zeta: f64, at: Option<&At>) -> f64 {
        let asymptote = &self.asymptotes[contact];
        match at {
            Some(at) if at.panel.from < asymptote.from => at.equal_pressure(contact) - asymptote.limit,
            Some(at) => {
                let couplings: f64 = self.shared(contact).map(|pair| at.coupling(pair)).sum();
                asymptote.remainder(zeta) + couplings
            }
            None => asymptote.remainder(zeta),
        }
    }
}
