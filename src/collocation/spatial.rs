//! The kernels as functions of the distance.
//!
//! With pressures that all have the resultant 1, the slope in contact i is, over π,
//!
//! ∫ [g∞/(x − t) + M_i(x − t)] p_i(t) dt + Σ_l [∫ N_il(x, t) p_l(t) dt − ∫ N_il(x, t) p_i(t) dt],   l = i ± 1,
//!
//! M(u) = ∫ (e_i − g∞) sin ζu dζ,   N(x, t) = ½ [W(x + t) + W(x − t)] − W(x),   W(u) = ∫ k_il (sin ζu − ζu) dζ,
//!
//! e_i being the equal-pressure response and k_il the coupling. No integral diverges, and none is cut off. Next to a
//! graded face M has a jump and a logarithm at u = 0, which are split off: M = sign(u) E(u) + ln|u| O(u) + R(u).
use std::f64::consts::FRAC_PI_2;

use crate::contact::ContactError;
use crate::kernel::Kernel;
use crate::numeric::chebyshev::Series;

use crate::collocation::spectrum::{Asymptote, Spectrum};

/// Points of a piece of a table.
const POINTS: usize = 20;
/// A piece is resolved if its last coefficients are below this part of its largest.
const RESOLVED: f64 = 2e-14;
/// Length of the first piece, and of the shortest, in units of L.
const FIRST: f64 = 1.0 / 16.0;
const SHORTEST: f64 = 1e-9;
/// Pieces are not cut shorter than this part of their end.
const NARROWEST: f64 = 1.0 / 8.0;

/// Kernels of all contacts in x.
pub(super) struct Spatial {
    /// Per contact.
    pub(super) diagonals: Vec<Diagonal>,
    /// Per pair of neighbours.
    coupling: Vec<(Spectrum, Samples)>,
}

/// The kernel of one contact with itself.
pub(super) struct Diagonal {
    /// g∞.
    pub(super) limit: f64,
    /// The part that is singular at u = 0, next to a graded face.
    pub(super) jump: Option<Jump>,
    spectrum: Spectrum,
    asymptote: Asymptote,
    /// R(u).
    regular: Samples,
}

/// sign(u) E(u) + ln|u| O(u), E and O bounded, with the singular terms up to u³ of the kernel.
#[derive(Clone, Copy)]
pub(super) struct Jump {
    rate: f64,
    even: [f64; 2],
    odd: [f64; 2],
}

impl Jump {
    /// From a remainder Σ c_k/ζ^k: 1/ζ makes a jump π/2 sign u, 1/ζ² makes −u ln|u|, and so on.
    fn new(c: [f64; 4]) -> Option<Self> {
        if c.iter().all(|c| *c == 0.0) {
            return None;
        }
        let rates = [c[1] / c[0], (c[2] / c[0]).abs().sqrt(), (c[3] / c[1]).abs().sqrt()];
        let rate = rates.into_iter().map(f64::abs).filter(|rate| rate.is_finite()).fold(1.0, f64::max);
        let cosine = FRAC_PI_2 * c[2] / rate.powi(2);
        let double = (c[1] / rate - c[3] / rate.powi(3)) / 6.0;
        let even = [FRAC_PI_2 * c[0] - cosine, cosine];
        Some(Self { rate, even, odd: [-c[1] / rate - 2.0 * double, double] })
    }

    /// E(u).
    pub(super) fn even(&self, u: f64) -> f64 {
        self.even[0] + self.even[1] * (self.rate * u).cos()
    }

    /// O(u).
    pub(super) fn odd(&self, u: f64) -> f64 {
        self.odd[0] * (self.rate * u).sin() + self.odd[1] * (2.0 * self.rate * u).sin()
    }
}

impl Spatial {
    /// Samples the kernels.
    pub(super) fn new(kernel: &Kernel) -> Result<Self, ContactError> {
        let n = kernel.contacts();
        let diagonal = |i: usize| -> Result<Diagonal, ContactError> {
            let (spectrum, asymptote) = Spectrum::equal_pressure(kernel, i)?;
            Ok(Diagonal {
                limit: asymptote.limit,
                jump: Jump::new(asymptote.powers()),
                spectrum,
                asymptote,
                regular: Samples::default(),
            })
        };
        let coupling = |i: usize| Ok((Spectrum::coupling(kernel, i)?, Samples::default()));
        Ok(Self {
            diagonals: (0..n).map(diagonal).collect::<Result<_, ContactError>>()?,
            coupling: (0..n - 1).map(coupling).collect::<Result<_, ContactError>>()?,
        })
    }

    /// Makes the tables long enough for distances up to `u`.
    pub(super) fn cover(&mut self, u: f64) {
        for Diagonal { limit, jump, spectrum, asymptote, regular } in &mut self.diagonals {
            let (limit, jump, asymptote) = (*limit, *jump, &*asymptote);
            regular.extend(u, limit, |frequency| {
                let nodes: Vec<(f64, f64)> = spectrum
                    .nodes(frequency)
                    .into_iter()
                    .map(|(zeta, weight, value)| (zeta, weight * (value / zeta - limit)))
                    .collect();
                move |u: f64| {
                    if u == 0.0 {
                        return 0.0;
                    }
                    let total = nodes.iter().map(|(zeta, w)| w * (zeta * u).sin()).sum::<f64>() + asymptote.integral(u);
                    total - jump.map_or(0.0, |jump| jump.even(u) + u.ln() * jump.odd(u))
                }
            });
        }
        for (i, (spectrum, table)) in self.coupling.iter_mut().enumerate() {
            let limit = self.diagonals[i].limit.max(self.diagonals[i + 1].limit);
            table.extend(u, limit, |frequency| {
                let nodes = spectrum.nodes(frequency);
                move |u: f64| {
                    u.powi(3) * nodes.iter().map(|(zeta, w, v)| w * v * sine_minus_argument(zeta * u)).sum::<f64>()
                }
            });
        }
    }

    /// Contacts next to contact i.
    pub(super) fn neighbours(&self, i: usize) -> impl Iterator<Item = usize> {
        let last = self.diagonals.len() - 1;
        i.checked_sub(1).into_iter().chain((i < last).then_some(i + 1))
    }

    /// N_il(x, t).
    pub(super) fn difference(&self, i: usize, l: usize, x: f64, t: f64) -> f64 {
        let table = &self.coupling[i.min(l)].1;
        0.5 * (table.odd(x + t) + table.odd(x - t)) - table.odd(x)
    }
}

impl Diagonal {
    /// R(u), odd.
    pub(super) fn regular(&self, u: f64) -> f64 {
        self.regular.odd(u)
    }
}

/// (sin z − z)/z³.
fn sine_minus_argument(z: f64) -> f64 {
    if z.abs() > 1.0 {
        return (z.sin() - z) / z.powi(3);
    }
    let (mut term, mut sum) = (-1.0 / 6.0, 0.0);
    for k in 2..12 {
        sum += term;
        term *= -z * z / f64::from(2 * k * (2 * k + 1));
    }
    sum
}

/// A function of u ≥ 0 in pieces that double in length.
#[derive(Default)]
struct Samples {
    pieces: Vec<Series>,
    end: f64,
}

impl Samples {
    /// Adds pieces up to `u`. `sampler` makes the function for distances up to its argument. The function is added to
    /// `scale`/u, and need not be more accurate than that.
    fn extend<F: Fn(f64) -> f64>(&mut self, u: f64, scale: f64, sampler: impl Fn(f64) -> F) {
        while self.end < u {
            let next = if self.end == 0.0 { FIRST } else { 2.0 * self.end };
            self.resolve(self.end, next, scale, &sampler(next));
            self.end = next;
        }
    }

    fn resolve(&mut self, from: f64, to: f64, scale: f64, function: &dyn Fn(f64) -> f64) {
        let piece = Series::of(from, to, POINTS, function);
        let size = piece.coefficients().iter().fold(0.0, |size: f64, c| size.max(c.abs()));
        if piece.tail() * size <= RESOLVED * (size + scale / to) || to < SHORTEST || to - from < NARROWEST * to {
            self.pieces.push(piece);
            return;
        }
        let middle = 0.5 * (from + to);
        self.resolve(from, middle, scale, function);
        self.resolve(middle, to, scale, function);
    }

    /// The function, continued to u < 0 as an odd one.
    fn odd(&self, u: f64) -> f64 {
        let at = self.pieces.partition_point(|piece| piece.interval().1 < u.abs());
        let value = self.pieces.get(at).map_or(f64::NAN, |piece| piece.eval(u.abs()));
        if u < 0.0 { -value } else { value }
    }
}
