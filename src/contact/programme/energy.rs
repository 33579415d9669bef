//! The elastic energy of pressures that are constant on elements, ½ Σ p_iᵀ U_i p_i + ½ Σ (p_i − p_(i+1))ᵀ C_i (p_i −
//! p_(i+1)) + Σ b_iᵀ p_i, per unit of P'.
//!
//! A pressure 1 on [x_e, x_(e+1)] and its mirror image has the transform (2/ζ) (sin ζx_(e+1) − sin ζx_e), on a ring about an axis
//! (x_(e+1) J₁(ζx_(e+1)) − x_e J₁(ζx_e))/ζ. The energy is the quadratic form of the Galerkin equations. Resultants are given, so every pressure is taken less a uniform one of the same resultant
//! over the shortest contact: what is left bends laminates no more than it has to, and no digits are lost to what all pressures have
//! in common. What a kernel has in common with a half-plane, its least value, is integrated in closed form. The rest is a sum over wavenumbers, none of which has a negative energy: the sum is positive even
//! where they are too few for the elements far out.
use faer::Mat;

use crate::contact::programme::compliances::Compliances;
use crate::contact::programme::constraints::{Constraint, Turning};
use crate::contact::programme::grid::Grid;
use crate::contact::programme::patch::Patch;
use crate::contact::programme::waves::{Octave, Waves, add_products};
use crate::numeric::quadrature::rule;

/// The quadratic form of the programme.
pub(super) struct Energy {
    /// U of each contact.
    pub(super) unit: Vec<Mat<f64>>,
    /// C of each laminate between contacts.
    pub(super) coupling: Vec<Mat<f64>>,
    /// b of each contact, and without punches and gaps.
    pub(super) linear: Vec<Vec<f64>>,
    of_pressures: Vec<Vec<f64>>,
    /// Resultant of each element's unit pressure.
    pub(super) resultants: Vec<f64>,
    /// The pressures on elements that do not touch: less than the pressure of weights where these press, which is none then.
    pub(super) apart: Vec<Vec<f64>>,
    /// Elements that the punch at a contact does not reach.
    pub(super) inadmissible: Vec<Vec<bool>>,
    /// What pressures have to carry.
    pub(super) constraints: Vec<Constraint>,
    /// None where all is even.
    pub(super) turning: Option<Turning>,
}

impl Energy {
    /// `None` if the matrices of all contacts would have too many entries.
    pub(super) fn new(kernel: &Compliances, grid: &Grid) -> Option<Self> {
        let (contacts, elements) = (kernel.contacts(), grid.elements());
        // there are two such sets of matrices, and the elimination makes as many again: they stay below 500 MB together
        if contacts.saturating_mul(elements).saturating_mul(elements) > 16_000_000 {
            return None;
        }
        let mut energy = Self {
            unit: vec![Mat::zeros(elements, elements); contacts],
            coupling: vec![Mat::zeros(elements, elements); contacts - 1],
            linear: vec![vec![0.0; elements]; contacts],
            of_pressures: Vec::new(),
            resultants: (0..elements).map(|e| grid.carried(e)[0]).collect(),
            apart: (0..contacts).map(|i| kernel.apart(i, grid)).collect(),
            inadmissible: Vec::new(),
            constraints: Vec::new(),
            turning: (grid.patch() == Patch::Strip).then(|| Turning {
                moment: kernel.moment(),
                linear: vec![vec![0.0; elements]; contacts],
                square: vec![0.0; contacts],
                coupling: vec![vec![0.0; elements]; contacts - 1],
                beside: vec![vec![0.0; elements]; contacts],
                given: vec![0.0; contacts],
            }),
        };
        let waves = Waves::new(kernel, grid);
        let least = waves.least(kernel);
        energy.add_half_planes(&least, grid);
        energy.add_waves(kernel, &least, grid, &waves);
        energy.add_carried(kernel, grid);
        energy.of_pressures.clone_from(&energy.linear);
        energy.press(kernel, grid);
        Some(energy)
    }

    pub(super) fn contacts(&self) -> usize {
        self.unit.len()
    }

    pub(super) fn elements(&self) -> usize {
        self.resultants.len()
    }

    fn add_half_planes(&mut self, least: &[f64], grid: &Grid) {
        let (elements, reference, patch) = (self.elements(), grid.shortest(), grid.patch());
        let edges = grid.edges();
        let of_edges = Mat::from_fn(elements + 1, elements + 1, |e, f| {
            if f <= e { patch.both(edges[e], edges[f], reference) } else { 0.0 }
        });
        // the elements before a pair of edges
        let both = |e: usize, f: usize| {
            let at = |e: usize, f: usize| of_edges[(e.max(f), e.min(f))];
            at(e + 1, f + 1) - at(e, f + 1) - at(e + 1, f) + at(e, f)
        };
        // per unit of the resultant
        let whole = patch.middle(reference);
        let to_edge: Vec<f64> = edges.iter().map(|edge| patch.with_middle(*edge, reference)).collect();
        let with_it: Vec<f64> = to_edge.windows(2).map(|pair| (pair[1] - pair[0]) / whole).collect();
        let itself = [reference, -reference].map(|x| patch.with_middle(x, reference));
        let itself = if patch == Patch::Strip { itself[0] - itself[1] } else { itself[0] } / whole.powi(2);
        for e in 0..elements {
            let own = self.resultants[e];
            for f in 0..=e {
                let other = self.resultants[f];
                let both = both(e, f) - own * with_it[f] - other * with_it[e] + own * other * itself;
                for (unit, least) in self.unit.iter_mut().zip(least) {
                    unit[(e, f)] = patch.half_space(*least) * both;
                    unit[(f, e)] = unit[(e, f)];
                }
            }
            for (linear, least) in self.linear.iter_mut().zip(least) {
                linear[e] = patch.half_space(*least) * (with_it[e] - own * itself);
            }
        }
    }

    fn add_waves(&mut self, kernel: &Compliances, least: &[f64], grid: &Grid, waves: &Waves) {
        for (from, to) in waves.octaves() {
            let octave = waves.octave(grid, [from, to]);
            self.add_even(kernel, least, grid, &octave);
            if grid.patch() == Patch::Pair && !octave.is_one() {
                self.add_mirrored(kernel, least, grid, &octave);
            }
            if let Some(mut turning) = self.turning.take() {
                self.add_odd(kernel, least, grid, &octave, &mut turning);
                self.turning = Some(turning);
            }
        }
    }

    /// Adds the even parts of some waves.
    fn add_even(&mut self, kernel: &Compliances, least: &[f64], grid: &Grid, octave: &Octave) {
        let reference = grid.shortest();
        let whole = grid.patch().resultant(reference);
        let beyond = grid.patch().transform(&octave.zeta, reference).into_iter();
        let beyond: Vec<f64> = beyond.map(|own| if octave.is_one() { own / whole } else { -1.0 }).collect();
        let of = |x: f64| grid.patch().transform(&octave.zeta, x);
        let transforms = octave.transforms(grid, of, |e, k| -grid.carried(e)[0] * beyond[k]);
        let mirrored = f64::from(u8::from(grid.patch() == Patch::Pair));
        for (i, (unit, linear)) in self.unit.iter_mut().zip(&mut self.linear).enumerate() {
            let (mut weights, mut forces) = (Vec::new(), Vec::new());
            for ((zeta, w), beyond) in octave.zeta.iter().zip(&octave.widths).zip(&beyond) {
                let (own, coupled) = (kernel.own(i, *zeta) - least[i], kernel.coupled(i, *zeta));
                weights.push(w * (own + coupled));
                // a given neighbour counts by what it differs from the pressure that all are compared with
                forces.push(w * (own * (1.0 + beyond) + coupled * beyond - kernel.given(i, *zeta)));
            }
            octave.add_gram(&transforms, &weights, mirrored, unit);
            add_products(&transforms, &forces, linear);
        }
        self.add_couplings(kernel, &transforms, mirrored, octave);
    }

    /// Adds the odd parts of some waves. As for resultants, pressures are compared with one of the same moment: long waves, by which laminates bend, lose no digits.
    fn add_odd(&mut self, kernel: &Compliances, least: &[f64], grid: &Grid, octave: &Octave, turning: &mut Turning) {
        let Octave { zeta, widths, .. } = octave;
        let reference = grid.shortest();
        // per unit of the moment of a pressure 1 on one half of it and −1 on the other
        let beyond = Patch::odd_transform(zeta, reference).into_iter().zip(zeta);
        let beyond: Vec<f64> = beyond
            .map(|(own, zeta)| if octave.is_one() { 2.0 * own / (reference * reference) } else { -zeta })
            .collect();
        let of = |x: f64| Patch::odd_transform(zeta, x);
        let transforms = octave.transforms(grid, of, |e, k| -grid.carried(e)[1] * beyond[k]);
        let unit: Vec<f64> = beyond.iter().zip(zeta).map(|(beyond, zeta)| beyond + zeta).collect();
        for (i, least) in least.iter().enumerate() {
            let [mut weights, mut forces, mut turned, mut beside] = [(); 4].map(|()| Vec::new());
            for (((zeta, w), beyond), unit) in zeta.iter().zip(widths).zip(&beyond).zip(&unit) {
                let (own, coupled) = (w * (kernel.own(i, *zeta) - least), w * kernel.coupled(i, *zeta));
                let given = w * kernel.given_odd(i, *zeta, *beyond);
                weights.push(own + coupled);
                forces.push(given);
                turned.push(own * unit);
                beside.push(coupled * unit);
                turning.square[i] += own * unit * unit;
                turning.given[i] += given * unit;
            }
            octave.add_gram(&transforms, &weights, 0.0, &mut self.unit[i]);
            add_products(&transforms, &forces, &mut self.linear[i]);
            add_products(&transforms, &turned, &mut turning.linear[i]);
            add_products(&transforms, &beside, &mut turning.beside[i]);
        }
        for (i, sum) in turning.coupling.iter_mut().enumerate() {
            let all = zeta.iter().zip(widths).zip(&unit);
            let weights: Vec<f64> = all.map(|((zeta, w), unit)| w * kernel.coupling(i, *zeta) * unit).collect();
            add_products(&transforms, &weights, sum);
        }
        self.add_couplings(kernel, &transforms, 0.0, octave);
    }

    /// Adds the odd parts of waves by which what is even is not felt by its mirror image far away: without them, that would be told by phases that are not told from each other.
    fn add_mirrored(&mut self, kernel: &Compliances, least: &[f64], grid: &Grid, octave: &Octave) {
        let of = |x: f64| octave.zeta.iter().map(|zeta| 4.0 * (0.5 * zeta * x).sin().powi(2) / zeta).collect();
        let transforms = octave.transforms(grid, of, |_, _| 0.0);
        for (i, (unit, least)) in self.unit.iter_mut().zip(least).enumerate() {
            let of = |(zeta, w): (&f64, &f64)| w * (kernel.own(i, *zeta) - least + kernel.coupled(i, *zeta));
            let weights: Vec<f64> = octave.zeta.iter().zip(&octave.widths).map(of).collect();
            octave.add_gram(&transforms, &weights, -1.0, unit);
        }
        self.add_couplings(kernel, &transforms, -1.0, octave);
    }

    fn add_couplings(&mut self, kernel: &Compliances, transforms: &Mat<f64>, mirrored: f64, octave: &Octave) {
        for (i, coupling) in self.coupling.iter_mut().enumerate() {
            let all = octave.zeta.iter().zip(&octave.widths);
            let weights: Vec<f64> = all.map(|(zeta, w)| w * kernel.coupling(i, *zeta)).collect();
            octave.add_gram(transforms, &weights, mirrored, coupling);
        }
    }

    /// Adds multiples of the squares of resultants and moments, which are given or the same in all contacts: a pressure like those which all are compared with has no
    /// energy otherwise.
    fn add_carried(&mut self, kernel: &Compliances, grid: &Grid) {
        let unit_length = grid.patch().twin().measure(grid.shortest().recip());
        let carried: Vec<[f64; 2]> = (0..self.elements()).map(|e| grid.carried(e)).collect();
        for (i, unit) in self.unit.iter_mut().enumerate() {
            let own = unit_length * kernel.limit(i);
            let of_moment = own / (grid.shortest() * grid.shortest());
            for (e, [resultant, moment]) in carried.iter().enumerate() {
                for (f, other) in carried.iter().enumerate() {
                    unit[(e, f)] += own * resultant * other[0] + of_moment * moment * other[1];
                }
            }
            if let Some(turning) = &mut self.turning {
                turning.square[i] -= of_moment;
            }
        }
    }

    /// Puts punches and gaps in place of the ones before.
    pub(super) fn press(&mut self, kernel: &Compliances, grid: &Grid) {
        self.constraints = (0..self.contacts()).flat_map(|i| kernel.constraints(i, grid)).collect();
        self.inadmissible = vec![vec![false; self.elements()]; self.contacts()];
        self.linear.clone_from(&self.of_pressures);
        for i in 0..self.contacts() {
            for e in 0..self.elements() {
                let [from, to] = grid.element(e);
                let Some(height) = kernel.height(i, [from, to]) else {
                    self.inadmissible[i][e] = true;
                    continue;
                };
                let heights = rule(8).on(from, to).map(|(x, weight)| grid.patch().measure(x) * weight * height(x));
                self.linear[i][e] += heights.sum::<f64>();
            }
        }
    }
}
