//! How the face below a contact is shaped before anything presses there.
use std::f64::consts::PI;

use crate::numeric::waves::Waves;

/// What a face adds to the gap of a contact: layers that eigenstrains bend, or that weights press down on a parabola, are curved, and dents that are pressed flat below lower it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Face<'a> {
    /// By how much the slope of the gap grows with x, in 1/length.
    pub(crate) curvature: f64,
    /// How far dents lower the face over x in length, plane problems only.
    pub(crate) hollow: Option<&'a Waves>,
    /// Where in the scene x = 0 is.
    pub(crate) from: f64,
}

impl Face<'_> {
    pub(crate) fn is_flat(&self) -> bool {
        self.curvature == 0.0 && self.hollow.is_none()
    }

    /// What is added to the gap at x, in length, and to its slope.
    pub(crate) fn at(&self, x: f64) -> [f64; 2] {
        let x = x + self.from;
        let [height, slope] = self.hollow.map_or([0.0; 2], |waves| waves.at(x));
        [height + 0.5 * self.curvature * x * x, slope + self.curvature * x]
    }

    /// ∫ f' cos kφ dφ over 0 < φ < π of the slope f' that is added at x = middle + half cos φ, for the k below a number.
    pub(crate) fn tests(&self, middle: f64, half: f64, count: usize) -> Vec<f64> {
        let middle = middle + self.from;
        let mut tests = self.hollow.map_or_else(|| vec![0.0; count], |waves| waves.slope_tests(middle, half, count));
        let curved = [PI * middle, 0.5 * PI * half];
        tests.iter_mut().zip(curved).for_each(|(test, part)| *test += self.curvature * part);
        tests
    }

    /// ∫ f'(half cos φ)/cos φ dφ from 0 to π/2: the sum of the tests with odd k, with alternating signs, of no more tests than a number, which do not resolve a face whose
    /// waves are much shorter.
    pub(crate) fn apex(&self, half: f64, most: usize) -> f64 {
        let shortest = self.hollow.and_then(|waves| waves.wavenumbers.last()).map_or(0.0, |wave| wave * half);
        // tests with k so far beyond the shortest wave are below rounding
        let tests = self.tests(0.0, half, (shortest as usize).saturating_add(40).min(most.max(4)));
        tests.chunks(4).map(|four| four.get(1).unwrap_or(&0.0) - four.get(3).unwrap_or(&0.0)).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The tests of a face are integrals of its slope, and their alternating sum is the one at the apex.
    #[test]
    fn tests_are_integrals_of_the_slope() {
        let waves = Waves {
            wavenumbers: vec![0.3, 1.7, 4.0],
            amplitudes: [vec![1.0, -0.4, 0.2], vec![0.0; 3]],
            is_even: true,
            is_round: false,
        };
        let odd = Waves { amplitudes: [vec![0.1, 0.2, 0.3], vec![0.5, -0.1, 0.7]], is_even: false, ..waves.clone() };
        let places = 400;
        let angle = |q: usize| PI * (q as f64 + 0.5) / places as f64;
        for (hollow, from, middle) in [(None, 0.0, 0.0), (Some(&waves), 0.0, 0.0), (Some(&odd), 0.4, -1.1)] {
            let face = Face { curvature: 0.3, hollow, from };
            let half = 1.3;
            let slope = |q: usize| face.at(middle + half * angle(q).cos())[1];
            for (k, test) in face.tests(middle, half, 9).into_iter().enumerate() {
                let sum: f64 = (0..places).map(|q| slope(q) * (k as f64 * angle(q)).cos()).sum();
                assert!((test - PI / places as f64 * sum).abs() < 1e-13, "{k}");
            }
            if from == 0.0 {
                let sum: f64 = (0..places / 2).map(|q| slope(q) / angle(q).cos()).sum();
                assert!((face.apex(half, 100) - PI / places as f64 * sum).abs() < 1e-12);
            }
            let step = 1e-5;
            let difference = (face.at(0.7 + step)[0] - face.at(0.7 - step)[0]) / (2.0 * step);
            assert!((face.at(0.7)[1] - difference).abs() < 1e-8);
        }
    }
}
