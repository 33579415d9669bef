//! Sines and cosines of several arguments at once, without branches, so that loops of them compile to vector instructions.
//!
//! Source: Cody and Waite 1980, chapter 8 (reduction); polynomials of
//! the kernels of fdlibm (Sun Microsystems, 1993).

use super::vector::{LANES, vectorised};

/// Arguments beyond this are left to the system's functions: multiples of π/2 are no longer exact.
const FARTHEST: f64 = 1e6;
/// π/2 in three parts of 33 bits.
const HALF_PI: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_795_950_6e-21];
/// Adding it rounds to whole numbers, which are the last bits of the sum.
const ROUND: f64 = 6_755_399_441_055_744.0;

const SIN: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_007e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];
const COS: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// Sine and cosine of each argument, to a few units of 1e-16.
#[inline(always)]
pub(crate) fn sin_cos<const N: usize>(arguments: &[f64; N]) -> ([f64; N], [f64; N]) {
    let (mut sines, mut cosines) = ([0.0; N], [0.0; N]);
    let mut farthest = 0.0f64;
    for x in arguments {
        farthest = farthest.max(x.abs());
    }
    if farthest > FARTHEST || farthest.is_nan() {
        for (k, x) in arguments.iter().enumerate() {
            (sines[k], cosines[k]) = x.sin_cos();
        }
        return (sines, cosines);
    }
    for k in 0..N {
        let x = arguments[k];
        let shifted = x * std::f64::consts::FRAC_2_PI + ROUND;
        let (quarters, turn) = (shifted.to_bits(), shifted - ROUND);
        let r = ((x - turn * HALF_PI[0]) - turn * HALF_PI[1]) - turn * HALF_PI[2];
        let z = r * r;
        let mut sine = SIN[5];
        let mut cosine = COS[5];
        for j in (0..5).rev() {
            sine = sine * z + SIN[j];
            cosine = cosine * z + COS[j];
        }
        let sine = (r + r * z * sine).to_bits();
        let cosine = (1.0 - (0.5 * z - z * z * cosine)).to_bits();
        // odd quarters change places, and two of four change the sign
        let odd = (quarters & 1).wrapping_neg();
        let (first, second) = ((sine & !odd) | (cosine & odd), (cosine & !odd) | (sine & odd));
        sines[k] = f64::from_bits(first ^ ((quarters & 2) << 62));
        cosines[k] = f64::from_bits(second ^ ((quarters.wrapping_add(1) & 2) << 62));
    }
    (sines, cosines)
}

/// sin z, cos z and cos z − 1 of any number of arguments, without cancellation where they are small.
pub(crate) fn waves(arguments: &[f64]) -> [Vec<f64>; 3] {
    let mut all = [(); 3].map(|()| vec![0.0; arguments.len()]);
    vectorised(
        #[inline(always)]
        || {
            let [sines, cosines, minus_one] = &mut all;
            let of = sines.chunks_mut(LANES).zip(cosines.chunks_mut(LANES)).zip(minus_one.chunks_mut(LANES));
            for (((sines, cosines), minus_one), some) in of.zip(arguments.chunks(LANES)) {
                let mut halves = [0.0; LANES];
                halves.iter_mut().zip(some).for_each(|(half, z)| *half = 0.5 * z);
                let (sin, cos) = sin_cos(&halves);
                for lane in 0..some.len() {
                    sines[lane] = 2.0 * sin[lane] * cos[lane];
                    minus_one[lane] = -2.0 * sin[lane] * sin[lane];
                    cosines[lane] = 1.0 + minus_one[lane];
                }
            }
        },
    );
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_are_those_of_the_system() {
        let mut worst = 0.0f64;
        for k in 0..200_000 {
            let x = f64::from(k - 100_000) * 1.234_567_89e-3 * (1.0 + f64::from(k % 97).powi(2));
            let (sin, cos) = sin_cos(&[x, 0.5 * x, -x, 1e-9 * x]);
            for (lane, x) in [x, 0.5 * x, -x, 1e-9 * x].into_iter().enumerate() {
                worst = worst.max((sin[lane] - x.sin()).abs()).max((cos[lane] - x.cos()).abs());
            }
        }
        assert!(worst < 4e-16, "{worst:e}");
    }

    #[test]
    fn odd_arguments_have_their_values() {
        let (sin, cos) = sin_cos(&[0.0, f64::NAN, 1e300, f64::INFINITY]);
        assert_eq!((sin[0], cos[0]), (0.0, 1.0));
        assert!(sin[1].is_nan() && cos[1].is_nan() && sin[3].is_nan());
        assert_eq!((sin[2], cos[2]), 1e300f64.sin_cos());
    }
}
