//! The rows of a punch in axisymmetric problems.
//!
//! What is tested is A'(t), A(t) = t ∫ f'(r)/√(t² − r²) dr from 0 to t, with Legendre polynomials P_k(t/a), k odd. With r = t sin φ it is
//! ∫ (r f')' dφ from 0 to π/2: powers of r keep their exponents, a circle is analytic, and pieces of polynomials have closed forms.
use crate::contact::problem::modes::order;
use crate::contact::problem::profile::{Profile, Slopes, covered, wallis};
use crate::numeric::quadrature::rule;
use crate::numeric::vector::{LANES, vectorised};
use crate::scene::{Piece, Shape};

/// Largest phase of a test function, in radians, over the interval of one Gauss rule, and the Gauss points added to those that resolve this
/// phase.
const PHASE: f64 = 100.0;
const SPARE: f64 = 18.0;
/// Where a circle ends its slope is infinite: it is as steep as here.
const STEEPEST: f64 = 1.0 - 1e-12;

/// The factors of s and of the last but one by which −P_2, P_4, ... and then −P_3, P_5, ... follow from each other, with k = 2m + 1.
pub(crate) fn steps(m: usize) -> [f64; 4] {
    let k = order(m);
    [-(2.0 * k + 1.0) / (k + 1.0), k / (k + 1.0), (2.0 * k + 3.0) / (k + 2.0), (k + 1.0) / (k + 2.0)]
}

impl Profile<'_> {
    /// (−1)^m ∫ A'(as) P_k(s) ds/P' over −1 < s < 1 for k = 2m + 1, with derivatives with respect to ln a.
    pub(super) fn round_rows(&self, half_length: f64, slopes: &mut Slopes) {
        if let Shape::Powers { length, terms, .. } = &self.shape {
            for (exponent, coefficient) in terms {
                let amplitude = self.amplitude(half_length, *length, *exponent, *coefficient);
                power_rows(exponent - 1.0, amplitude * exponent * wallis(exponent - 1.0), slopes);
            }
            return;
        }
        let rows = slopes.value.len();
        let places: Vec<(f64, f64)> = self.round_places(half_length, 2.0 * rows as f64).collect();
        let values: Vec<[f64; 3]> = places.iter().map(|(s, _)| self.abel(half_length * s)).collect();
        let steps: Vec<[f64; 4]> = (0..rows).map(steps).collect();
        // lane by lane: sums over the lanes would take longer than the polynomials
        let mut sums = vec![[[0.0; LANES]; 2]; rows];
        vectorised(
            #[inline(always)]
            || {
                for (places, values) in places.chunks(LANES).zip(values.chunks(LANES)) {
                    let [mut s, mut value, mut slope] = [[0.0; LANES]; 3];
                    for (lane, ((place, weight), [_, own, derivative])) in places.iter().zip(values).enumerate() {
                        s[lane] = *place;
                        value[lane] = 2.0 * weight * own;
                        slope[lane] = 2.0 * weight * derivative;
                    }
                    let (mut even, mut odd) = ([1.0; LANES], s);
                    for ([row, derivative], [up, down, next, back]) in sums.iter_mut().zip(&steps) {
                        for lane in 0..LANES {
                            row[lane] += value[lane] * odd[lane];
                            derivative[lane] += slope[lane] * odd[lane];
                            even[lane] = up * s[lane] * odd[lane] + down * even[lane];
                            odd[lane] = next * s[lane] * even[lane] + back * odd[lane];
                        }
                    }
                }
            },
        );
        for ((value, slope), sums) in slopes.value.iter_mut().zip(&mut slopes.slope).zip(sums) {
            [*value, *slope] = sums.map(|lanes| lanes.iter().sum());
        }
    }

    /// ∫ A'(as)/s ds from 0 to 1, over P'.
    pub(super) fn round_apex(&self, half_length: f64) -> f64 {
        if let Shape::Powers { length, terms, .. } = &self.shape {
            let term = |(exponent, coefficient): &(f64, f64)| {
                let amplitude = self.amplitude(half_length, *length, *exponent, *coefficient);
                if amplitude == 0.0 { 0.0 } else { amplitude * exponent * wallis(exponent - 1.0) / (exponent - 1.0) }
            };
            return terms.iter().map(term).sum();
        }
        self.round_places(half_length, 0.0).map(|(s, weight)| weight * self.abel(half_length * s)[1] / s).sum()
    }

    /// Places s = t/a from 0 to 1 and weights: s = cos θ, with a square root where pieces begin.
    fn round_places(&self, half_length: f64, phase: f64) -> impl Iterator<Item = (f64, f64)> + use<> {
        let pieces: &[Piece] = if let Shape::Pieces { pieces, .. } = &self.shape { pieces } else { &[] };
        let own = half_length * self.length;
        let starts = covered(pieces, own).filter(|start| *start > 0.0).map(|start| (start / own).acos());
        let mut ends: Vec<f64> = [std::f64::consts::FRAC_PI_2].into_iter().chain(starts).collect();
        ends.push(0.0);
        let ends: Vec<(f64, f64)> = ends.windows(2).map(|pair| (pair[0], pair[0] - pair[1])).collect();
        ends.into_iter().flat_map(move |(from, width)| {
            // θ = from − width u², in parts of equal phase; in the first one the phase grows from nothing to twice its mean rate
            let parts = (phase * width / PHASE).ceil().max(1.0);
            let each = phase * width / parts;
            let place = move |(u, weight): (f64, f64)| {
                let theta = from - width * u * u;
                (theta.cos(), weight * 2.0 * width * u * theta.sin())
            };
            (0..parts as usize).flat_map(move |part| {
                let points = rule((if part == 0 { each } else { 0.6 * each } + SPARE) as usize);
                let [from, to] = [part, part + 1].map(|part| (part as f64 / parts).sqrt());
                points.on(from, to).map(place).collect::<Vec<_>>()
            })
        })
    }

    /// A(t) at t in units of L, over P'.
    pub(crate) fn transformed(&self, t: f64) -> f64 {
        if let Shape::Powers { length, terms, .. } = &self.shape {
            let term = |(exponent, coefficient): &(f64, f64)| {
                self.amplitude(t, *length, *exponent, *coefficient) * wallis(exponent - 1.0)
            };
            return t * terms.iter().map(term).sum::<f64>();
        }
        t * self.abel(t)[0]
    }

    /// A(t)/t, A'(t) and t A''(t) at t in units of L, over P'.
    fn abel(&self, t: f64) -> [f64; 3] {
        let t = t * self.length;
        let values = match &self.shape {
            Shape::Circle(radius) => {
                let u = (t / radius).min(STEEPEST);
                let over = ((1.0 - u) * (1.0 + u)).recip();
                [u.atanh(), u.atanh() + u * over, 2.0 * u * over * over]
            }
            Shape::Pieces { pieces, .. } => pieces_abel(pieces, t),
            Shape::Flat(_) | Shape::Powers { .. } => [0.0; 3],
        };
        values.map(|value| value / self.force)
    }
}

/// The same for polynomials: ∫ f'(t sin φ) dφ, and ∫ g(t sin φ) dφ with g = (r f')' = e_0 + e_1 r + e_2 r² in each piece.
fn pieces_abel(pieces: &[Piece], t: f64) -> [f64; 3] {
    let [mut whole, mut value, mut slope, mut before] = [0.0; 4];
    for (i, Piece { start, coefficients: [_, c1, c2, c3] }) in pieces.iter().enumerate() {
        if *start >= t {
            break;
        }
        // f' in powers of r, and g
        let d = [c1 - 2.0 * c2 * start + 3.0 * c3 * start * start, 2.0 * c2 - 6.0 * c3 * start, 3.0 * c3];
        let e = [d[0], 2.0 * d[1], 3.0 * d[2]];
        let end = pieces.get(i + 1).map_or(t, |next| next.start.min(t));
        let at = |r: f64| {
            let sin = (r / t).min(1.0);
            (sin.asin(), sin, ((1.0 - sin) * (1.0 + sin)).sqrt())
        };
        let ((phi, sin, cos), (phi_0, sin_0, cos_0)) = (at(end), at(*start));
        let angle = phi - phi_0;
        let square = 0.5 * t * t * (angle - sin * cos + sin_0 * cos_0);
        let linear = e[1] * t * (cos_0 - cos);
        whole += d[0] * angle + 0.5 * linear + d[2] * square;
        value += e[0] * angle + linear + e[2] * square;
        slope += linear + 2.0 * e[2] * square;
        // where g jumps
        let here = e[0] + start * (e[1] + start * e[2]);
        if i > 0 {
            slope += (here - before) * sin_0 / cos_0;
        }
        before = e[0] + end * (e[1] + end * e[2]);
    }
    [whole, value, slope]
}

/// The rows of amplitude · |s|^power sign(s).
fn power_rows(power: f64, amplitude: f64, slopes: &mut Slopes) {
    let mut value = 2.0 * amplitude / (power + 2.0);
    for (m, (row, slope)) in slopes.value.iter_mut().zip(&mut slopes.slope).enumerate() {
        *row += value;
        *slope += power * value;
        let k = order(m);
        value *= (k - power) / (k + power + 3.0);
    }
}

#[cfg(test)]
mod tests {
    use crate::contact::problem::profile::Profile;
    use crate::contact::problem::twin::Twin;
    use crate::scene::Punch;

    #[test]
    fn rows_of_one_shape_are_the_same_however_it_is_written() {
        let parabola = Punch::parabola(2.0).unwrap();
        let others = [
            Punch::polynomial(1.5, &[1.5 * 1.5 / 4.0]).unwrap(),
            Punch::rounded_flat(0.0, 2.0).unwrap_or(parabola.clone()),
        ];
        let rows = |punch: &Punch| Profile::new(punch, 1.0, 1.0, Twin::Round).slopes(1.2, 6).value;
        for other in others {
            for (found, expected) in rows(&other).iter().zip(rows(&parabola)) {
                assert!((found - expected).abs() < 1e-13, "{other}: {found} {expected}");
            }
        }
    }

    #[test]
    fn derivatives_are_those_of_differences() {
        for punch in [
            Punch::cylinder(2.0).unwrap(),
            Punch::wedge(0.3).unwrap(),
            Punch::power(2.7, 1.3, 0.1).unwrap(),
            Punch::rounded_flat(0.8, 3.0).unwrap(),
            Punch::table(&[(0.0, 0.1), (0.3, 0.2), (0.9, 0.5), (1.5, 1.9)]).unwrap(),
        ] {
            let profile = Profile::new(&punch, 1.0, 1.0, Twin::Round);
            let (found, step) = (profile.slopes(1.2, 9), 1e-6);
            let [more, less] = [step, -step].map(|step: f64| profile.slopes(1.2 * step.exp(), 9).value);
            for ((slope, more), less) in found.slope.iter().zip(more).zip(less) {
                let expected = (more - less) / (2.0 * step);
                assert!((slope - expected).abs() < 1e-7, "{punch}: {slope} {expected}");
            }
        }
    }
}
