//! The material at the Gauss points of a slice: whether they resolve it, and the transfer matrix they give.
use nalgebra::{Matrix4, SMatrix, SVector};

use super::Profile;
use super::rule::{ENDS, NODES, RULE};
use super::surface::Coefficients;
use crate::Wave;

/// A slice's largest λδ, in units of the material's own decay length.
const LENGTH: f64 = 1.0;
/// A material counts as resolved when the last Legendre coefficients on a slice are this small: their squares, which
/// is what Gauss points leave, are below rounding.
const RESOLVED: f64 = 1e-9;
/// The polynomial through the Gauss points must also meet the material at the ends of a slice, as closely as this: a
/// The polynomial through the Gauss points must also meet the material at the ends of a slice, as closely as this: a
/// thin skin or a jump might hide there.
const MET: f64 = 1e-8;
/// A slice that is too long all the same is not iterated forever.
const MOST_SWEEPS: f64 = 100.0;

/// The material at the Gauss points of a slice, from the bottom up, in units of μ₀.
pub(super) struct Points {
    pub shear: SVector<f64, NODES>,
    coupling: SVector<f64, NODES>,
    normal: SVector<f64, NODES>,
    axial: SVector<f64, NODES>,
    /// At the ends of the slice.
    ends: [Coefficients; 2],
}

impl Points {
    pub fn new(profile: &Profile, wave: &Wave, depth: f64, thickness: f64) -> Self {
        let at = |t: f64| Coefficients::new(&(profile.material)(depth + (1.0 - t) * thickness), wave.modulus);
        let points = RULE.nodes.map(at);
        let values = |pick: fn(&Coefficients) -> f64| SVector::from_iterator(points.iter().map(pick));
        Self {
            shear: values(|point| point.m),
            coupling: values(|point| point.c),
            normal: values(|point| point.d),
            axial: values(|point| point.e),
            ends: ENDS.map(at),
        }
    }

    /// Whether the slice is short enough for the wave and for the variation of the material.
    pub fn resolved(&self, zeta: f64) -> bool {
        let smooth = |f: &SVector<f64, NODES>, ends: fn(&Coefficients) -> f64, floor: f64| {
            let size = f.amax().max(floor);
            let missed = RULE.ends * f - SVector::from(self.ends.each_ref().map(ends));
            (RULE.highest * f).amax() <= RESOLVED * size && missed.amax() <= MET * size
        };
        zeta * self.fastest() <= LENGTH
            && smooth(&self.shear, |end| end.m, 0.0)
            && smooth(&self.axial, |end| end.e, 0.0)
            && smooth(&self.coupling, |end| end.c, 1.0)
            && smooth(&self.normal, |end| end.d, self.shear.amax())
    }

    /// How fast the fastest field varies with ζ = λy.
    pub fn fastest(&self) -> f64 {
        let rate = |i: usize| {
            let (m, c, d, e) = (self.shear[i], self.coupling[i], self.normal[i], self.axial[i]);
            (e * m).max(c.abs()).max((e * d).sqrt()).sqrt()
        };
        (0..NODES).map(rate).fold(1.0, f64::max)
    }

    /// How fast the slowest field decays with ζ: the real part of the smaller root s, see [`super::surface_flexibility`].
    pub fn slowest(&self) -> f64 {
        let rate = |i: usize| {
            let (m, c, d, e) = (self.shear[i], self.coupling[i], self.normal[i], self.axial[i]);
            let (half, product) = (0.5 * (e * m - 2.0 * c), c * c + e * d);
            let root = half * half - product;
            if root > 0.0 { (product / (half + root.sqrt())).sqrt() } else { (0.5 * (half + product.sqrt())).sqrt() }
        };
        (0..NODES).map(rate).fold(f64::INFINITY, f64::min)
    }

    /// The transfer matrix through the slice of length ζ, less identity: Picard iteration of X − 1 = ∫ A X dζ, where
    /// each component takes at once what the others have just become.
    pub fn transfer(&self, zeta: f64) -> Matrix4<f64> {
        type Columns = SMatrix<f64, NODES, 4>;
        let along = |f: &SVector<f64, NODES>, x: &Columns| Columns::from_fn(|i, j| f[i] * x[(i, j)]);
        let unit = |k: usize| Columns::from_fn(|_, j| if j == k { 1.0 } else { 0.0 });
        let integral = RULE.integral * zeta;
        let [unit_u, unit_v, unit_s, unit_t] = [0, 1, 2, 3].map(unit);
        let (mut u, mut v, mut s, mut t) = (unit_u, unit_v, unit_s, unit_t);
        let rates = |u: &Columns, v: &Columns, s: &Columns, t: &Columns| {
            [
                v + along(&self.shear, t),
                along(&self.normal, s) - along(&self.coupling, u),
                -t,
                along(&self.axial, u) + along(&self.coupling, s),
            ]
        };
        for _ in 0..sweeps(zeta * self.fastest()) {
            u = unit_u + integral * (v + along(&self.shear, &t));
            t = unit_t + integral * (along(&self.axial, &u) + along(&self.coupling, &s));
            s = unit_s - integral * t;
            v = unit_v + integral * (along(&self.normal, &s) - along(&self.coupling, &u));
        }
        let ends = rates(&u, &v, &s, &t).map(|rate| RULE.weights * rate * zeta);
        Matrix4::from_rows(&ends)
    }
}

/// Sweeps of Picard iteration through a slice of the given length: each adds two orders of the power series.
fn sweeps(length: f64) -> usize {
    let (mut count, mut term) = (1.0, 1.0);
    while term > 0.1 * f64::EPSILON && count < MOST_SWEEPS {
        term *= length * length / (2.0 * count * (2.0 * count + 1.0));
        count += 1.0;
    }
    count as usize + 2
}
