//! The wavenumbers over which a field is summed: panels of Gauss points, up to the cut-offs of the pressures.
//!
//! Far from the contacts the waves oscillate much faster than all they are multiplied with. There the states are polynomials through the
//! points of a panel, and the integrals of these times the waves are exact, with ∫ P_k(t) e^(iωt) dt = 2 i^k j_k(ω) over |t| < 1:
//! Filon's quadrature. Source: Abramowitz and Stegun 1964, 10.1.47; Iserles and Nørsett 2005.
use num_complex::Complex64;

use crate::geometry::Geometry;
use crate::numeric::bessel::{self, Kind};
use crate::numeric::quadrature::{self, Rule};
use crate::numeric::trigonometry;

/// The accuracy to which a field is summed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Precision {
    /// Truncation error allowed beyond the last wavenumber, in parts of the mean pressure: inside, and on a loaded face.
    pub(super) inside: f64,
    pub(super) on_face: f64,
    /// Exponentially small terms are left out beyond this exponent.
    pub(super) exponent: f64,
    /// Points of a panel that spans a short phase.
    pub(super) points: usize,
    /// Largest ratio of the width of a panel to its distance from 0.
    pub(super) growth: f64,
    /// Whether displacements are wanted, too.
    pub(super) displacements: bool,
    /// Most evaluations of layers, all wavenumbers together: a sum that needs more ends at a smaller wavenumber.
    pub(super) evaluations: f64,
}

/// Each of the some forty sums of a search for the largest shear stress may take as many evaluations of layers, at 1 to 10 µs
/// each: all together a minute at the very worst. Three layers take some 2000; twice the limit is twice that minute.
const SEARCHED: f64 = 2e5;

/// Full accuracy.
pub(crate) const FULL: Precision = Precision {
    inside: 1e-10,
    on_face: 1e-8,
    exponent: 36.0,
    points: 16,
    growth: 2.0,
    displacements: true,
    evaluations: f64::INFINITY,
};
/// Stresses to some nine digits.
pub(super) const STRESSES: Precision = Precision {
    inside: 1e-9,
    on_face: 1e-8,
    exponent: 24.0,
    points: 12,
    growth: 3.0,
    displacements: false,
    evaluations: SEARCHED,
};
/// Stresses to some four digits.
pub(crate) const LOW: Precision = Precision { inside: 1e-5, on_face: 1e-5, exponent: 14.0, ..STRESSES };
/// Stresses to some two digits.
pub(super) const COARSE: Precision = Precision { inside: 1e-3, on_face: 1e-3, exponent: 8.0, points: 8, ..STRESSES };

/// Full accuracy of displacements also on graded faces.
pub(crate) const DISPLACEMENTS: Precision = Precision { on_face: 1e-10, ..FULL };
/// Displacements to some two digits.
pub(crate) const ROUGH: Precision = Precision { displacements: true, ..COARSE };

/// Waves with a smaller product of wavenumber and length of a contact squeeze a laminate like those with this one, since it gives way by even functions of the
/// wavenumber: to the square of this.
pub(super) const LONG: f64 = 1e-4;
/// Largest phase of a panel, and the phase up to which half as many points or fewer suffice.
const PHASE: f64 = 56.0;
const SHORT_PHASE: f64 = 16.0;
/// The first panel spans this phase.
const FIRST: f64 = 0.25;
/// Phases λx beyond this are integrated exactly: rounding of a larger one would be more than 1e-12. Twice as large, sums far away
/// take twice as long.
const FAR: f64 = 1e4;
/// Largest product of a wavenumber and a half-length: a pressure is left out beyond it, which the error estimate takes account of. Twice
/// as large, stresses next to a contact 1e4 times longer than a layer take twice as long.
pub(super) const MOST: f64 = 2e5;
/// Wavenumbers that a pressure takes per unit of that product.
pub(super) const PER_PHASE: f64 = 2.0;
/// The first panel is no shorter than this part of the whole axis: some hundred panels grow from there, and the integral
/// over less than that is below rounding.
const LEAST: f64 = 1e-40;

/// Next to λ = 0 a power λ^α is integrated in t, λ ~ t^STRETCH: any α > -0.95 leaves a positive power of t, and three
/// more powers of λ are still of the degree that [`STRETCHED`] points integrate exactly.
const STRETCH: i32 = 20;
const STRETCHED: usize = 32;

/// A panel of the wavenumber axis.
pub(super) struct WavePanel {
    pub(super) lo: f64,
    pub(super) hi: f64,
    rule: &'static Rule,
    pub(super) wavenumbers: Vec<f64>,
    pub(super) weights: Vec<f64>,
    /// Whether waves at the farthest places oscillate between its points.
    far: bool,
}

impl WavePanel {
    /// sin λx, cos λx and cos λx − 1, without cancellation, wavenumber by wavenumber; in an axisymmetric problem Bessel functions in their place.
    /// Where they oscillate between the wavenumbers of the panel, the factors of [`Self::wave`] in place of e^(iλx).
    pub(super) fn tables(&self, geometry: Geometry, places: &[f64]) -> [Vec<f64>; 3] {
        let is_round = geometry.is_axisymmetric();
        let phases = self.wavenumbers.iter().flat_map(|wavenumber| places.iter().map(move |x| wavenumber * x));
        let phases: Vec<f64> = phases.collect();
        let mut tables = if is_round { round(&phases) } else { trigonometry::waves(&phases) };
        for (k, x) in places.iter().enumerate() {
            let Some(waves) = self.wave(*x) else { continue };
            for (q, (wave, wavenumber)) in waves.into_iter().zip(&self.wavenumbers).enumerate() {
                let [zeroth, first] = if is_round { round_waves(wave, wavenumber * x) } else { [wave.re, wave.im] };
                let at = q * places.len() + k;
                [tables[0][at], tables[1][at], tables[2][at]] = [first, zeroth, zeroth - 1.0];
            }
        }
        tables
    }

    /// Factors at its points, times the weights of which the values of a polynomial at these sum to its integral times e^(iλx); `None`
    /// where e^(iλx) itself does.
    ///
    /// (2k + 1) i^k j_k(ω) e^(iλx) at the middle is written with the waves at both ends, which neighbouring panels share: rounding of large
    /// phases λx then cancels. With h_k the spherical Hankel functions, S_k = i^(k+1) ω e^(−iω) h_k obeys S_(k+1) = S_(k−1) + i (2k + 1)/ω S_k.
    fn wave(&self, x: f64) -> Option<Vec<Complex64>> {
        let half = 0.5 * (self.hi - self.lo);
        if !self.far || 2.0 * half * x.abs() <= PHASE {
            return None;
        }
        let [lo, hi] = [self.lo, self.hi].map(|end| Complex64::cis(end * x));
        let phase = half * x;
        let (mut last, mut decay) = (Complex64::ONE, Complex64::ONE);
        let mut moments = Vec::with_capacity(self.rule.nodes.len());
        for k in 0..self.rule.nodes.len() {
            let order = (2 * k + 1) as f64;
            let back = if k % 2 == 0 { decay.conj() } else { -decay.conj() };
            moments.push(Complex64::I * (lo * back - hi * decay) * (0.5 * order / phase));
            (last, decay) = (decay, last + Complex64::I * decay * (order / phase));
        }
        let at = |t: &f64| {
            let (mut before, mut legendre, mut sum) = (0.0, 1.0, Complex64::ZERO);
            for (k, moment) in moments.iter().enumerate() {
                let k = k as f64;
                sum += moment * legendre;
                (before, legendre) = (legendre, ((2.0 * k + 1.0) * t * legendre - k * before) / (k + 1.0));
            }
            sum
        };
        Some(self.rule.nodes.iter().map(at).collect())
    }
}

/// J₀(z) and J₁(z) with this in place of e^(iz): what they are multiplied with varies slowly.
fn round_waves(wave: Complex64, z: f64) -> [f64; 2] {
    let mut amplitudes = [Complex64::ZERO; 2];
    bessel::hankel_table(Kind::Integer, 2, &[z.into()], &mut amplitudes);
    amplitudes.map(|amplitude| (amplitude * wave).re)
}

/// J₁(λr), J₀(λr) and J₀(λr) − 1 in place of the sine, the cosine and the cosine minus 1.
fn round(arguments: &[f64]) -> [Vec<f64>; 3] {
    let count = arguments.len();
    let mut bessel = vec![0.0; 2 * count];
    bessel::table(2, arguments, &mut bessel);
    let first = bessel.split_off(count);
    // J₀ − 1 = −z²/4 + z⁴/64 − ... cancels where z is small
    let minus_one = |(z, zeroth): (&f64, &f64)| {
        let q = 0.25 * z * z;
        if *z > 0.5 {
            zeroth - 1.0
        } else {
            -q * (1.0 - q / 4.0 * (1.0 - q / 9.0 * (1.0 - q / 16.0 * (1.0 - q / 25.0))))
        }
    };
    let minus_one = arguments.iter().zip(&bessel).map(minus_one).collect();
    [first, bessel, minus_one]
}

/// The cut-off of a pressure.
#[derive(Clone, Copy, Debug)]
pub(super) struct CutOff {
    /// The wavenumber beyond which the pressure is left out.
    pub(super) end: f64,
    /// The length over which all but the waves oscillates: the half-length of the pressure.
    pub(super) own: f64,
}

/// Panels from 0 to the largest cut-off of all pressures. Their width grows as far as the oscillation of cos λx, x being `farthest` at most,
/// and of the transforms of pressures below their cut-off allows, and where λx is large the oscillation of the transforms alone; `None` if there would be too
/// many. Below the wavenumber `first` fields are smooth but for a power of λ, if there is one.
///
/// The number of panels is bounded whatever the arguments: the first one is at least a fixed part of the whole, the next
/// ones grow by the factor `precision.growth` until each spans the phase that is allowed.
pub(super) fn panels(
    cut_offs: &[CutOff],
    farthest: f64,
    (first, has_power): (f64, bool),
    precision: &Precision,
) -> Option<Vec<WavePanel>> {
    let product = |cut: &CutOff| cut.end * cut.own;
    if cut_offs.iter().any(|cut| cut.end.is_infinite() || product(cut).is_nan() || product(cut) > 2.0 * MOST) {
        return None;
    }
    let end = cut_offs.iter().fold(0.0, |end: f64, cut| end.max(cut.end));
    let longest = |lo: f64| cut_offs.iter().filter(|cut| cut.end > lo).fold(0.0, |own: f64, cut| own.max(cut.own));
    let shortest = first.min(FIRST / (farthest + longest(0.0))).max(LEAST * end);
    let (mut panels, mut lo) = (Vec::new(), 0.0);
    while lo < end {
        // over the extent the integrand oscillates
        let extent = farthest + longest(lo);
        let [whole, alone] = [PHASE / extent, SHORT_PHASE / longest(lo)];
        let far = lo * extent > FAR && alone > whole;
        let allowed = if far { alone } else { whole };
        let width = if lo == 0.0 { shortest } else { (precision.growth * lo).min(allowed) };
        let width = width.min(end - lo);
        let power = has_power && lo == 0.0;
        let points = if power {
            STRETCHED
        } else if width * extent <= SHORT_PHASE {
            precision.points
        } else {
            32
        };
        let (hi, rule) = (lo + width, quadrature::rule(points));
        let stretched = |(t, weight): (f64, f64)| {
            let before = hi * t.powi(STRETCH - 1);
            (before * t, f64::from(STRETCH) * before * weight)
        };
        let (wavenumbers, weights) =
            if power { rule.on(0.0, 1.0).map(stretched).unzip() } else { rule.on(lo, hi).unzip() };
        panels.push(WavePanel { lo, hi, rule, wavenumbers, weights, far });
        lo = hi;
    }
    Some(panels)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panels_integrate_waves_of_any_length_exactly() {
        let (cut, farthest) = (CutOff { end: 40.0, own: 1.0 }, 1e9);
        let all = panels(&[cut], farthest, (0.3, false), &FULL).unwrap();
        // ∫ e^(−λ) e^(iλx) dλ = 1/(1 − ix), and what was left out
        for x in [0.0, 0.3, 20.0, 3e3, 1e5, 1e7, 1e9] {
            let mut sum = Complex64::ZERO;
            for panel in &all {
                let plain = || panel.wavenumbers.iter().map(|l| Complex64::cis(l * x)).collect();
                let waves: Vec<Complex64> = panel.wave(x).unwrap_or_else(plain);
                let points = panel.wavenumbers.iter().zip(&panel.weights).zip(waves);
                sum += points.map(|((l, w), e)| e * (w * (-l).exp())).sum::<Complex64>();
            }
            let expected = Complex64::new(1.0, -x).inv();
            // waves below FAR are summed as they are: in each of their panels the phases at both ends are rounded
            let phase = FAR / farthest * x;
            let rounding = 2.0 * phase / PHASE * phase * f64::EPSILON;
            assert!((sum - expected).norm() < (1e-12 + rounding) * expected.norm(), "{x}: {sum} {expected}");
        }
    }
}
