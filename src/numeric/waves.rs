//! Sums of waves.
use std::f64::consts::PI;

use super::{bessel, trigonometry};

/// Integrals of as many waves are found at once.
const AT_ONCE: usize = 256;

/// Waves with the amplitudes of cos λx and sin λx, or about an axis of J₀(λr).
#[derive(Clone, Debug, Default)]
pub(crate) struct Waves {
    pub(crate) wavenumbers: Vec<f64>,
    pub(crate) amplitudes: [Vec<f64>; 2],
    /// Whether there are no sines, and whether waves are about an axis.
    pub(crate) is_even: bool,
    pub(crate) is_round: bool,
}

/// A smooth step from 1 at a quarter of a wavenumber to 0 there.
pub(crate) fn fades(wave: f64, end: f64) -> f64 {
    smooth_step((4.0 * wave / end - 1.0) / 3.0)
}

/// A smooth step from 1 at t = 0 to 0 at t = 1.
pub(crate) fn smooth_step(t: f64) -> f64 {
    match t {
        t if t <= 0.0 => 1.0,
        t if t >= 1.0 => 0.0,
        t => 0.5 * libm::erfc(3.5 * (2.0 * t - 1.0) / (4.0 * t * (1.0 - t)).sqrt()),
    }
}

impl Waves {
    /// The value at a place, and its derivative.
    pub(crate) fn at(&self, x: f64) -> [f64; 2] {
        let phases: Vec<f64> = self.wavenumbers.iter().map(|wave| wave * x).collect();
        let [mut value, mut slope] = [0.0; 2];
        let [even, odd] = &self.amplitudes;
        if self.is_round {
            let mut table = vec![0.0; 2 * phases.len()];
            bessel::table(2, &phases, &mut table);
            let (zeroth, first) = table.split_at(phases.len());
            for (k, wave) in self.wavenumbers.iter().enumerate() {
                value += even[k] * zeroth[k];
                slope -= wave * even[k] * first[k];
            }
            return [value, slope];
        }
        let [sines, cosines, _] = trigonometry::waves(&phases);
        for (k, wave) in self.wavenumbers.iter().enumerate() {
            value += even[k] * cosines[k] + odd[k] * sines[k];
            slope += wave * (odd[k] * cosines[k] - even[k] * sines[k]);
        }
        [value, slope]
    }

    /// ∫ f' cos kφ dφ over 0 < φ < π of the slope f' at x = middle + half cos φ, for the k below a number: π i^k J_k(λ half) of a wave exp(iλx). Not about an axis.
    pub(crate) fn slope_tests(&self, middle: f64, half: f64, count: usize) -> Vec<f64> {
        let [even, odd] = &self.amplitudes;
        let mut tests = vec![0.0; count];
        // many waves at once would take much memory
        for some in (0..self.wavenumbers.len()).step_by(AT_ONCE) {
            let some = some..(some + AT_ONCE).min(self.wavenumbers.len());
            let phases: Vec<f64> = self.wavenumbers[some.clone()].iter().map(|wave| wave * middle).collect();
            let arguments: Vec<f64> = self.wavenumbers[some.clone()].iter().map(|wave| wave * half).collect();
            let [sines, cosines, _] = trigonometry::waves(&phases);
            let mut table = vec![0.0; count * phases.len()];
            bessel::table(count, &arguments, &mut table);
            for (k, (test, values)) in tests.iter_mut().zip(table.chunks(phases.len())).enumerate() {
                for ((n, value), (sin, cos)) in some.clone().zip(values).zip(sines.iter().zip(&cosines)) {
                    let (cos, sin) = (even[n] * cos + odd[n] * sin, even[n] * sin - odd[n] * cos);
                    *test += PI * self.wavenumbers[n] * value * [-sin, -cos, sin, cos][k % 4];
                }
            }
        }
        tests
    }

    /// The mean of the wavenumbers, by the sizes of waves.
    pub(crate) fn mean_wavenumber(&self) -> f64 {
        let sizes = || self.amplitudes[0].iter().zip(&self.amplitudes[1]).map(|(even, odd)| even.hypot(*odd));
        let sum: f64 = sizes().zip(&self.wavenumbers).map(|(size, wave)| size * wave).sum();
        sum / sizes().sum::<f64>()
    }
}
