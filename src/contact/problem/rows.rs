//! The rows of a profile: its slope against the tests of an interval.
//!
//! On x = m + w s, s = cos θ, the tests are polynomials C_k of one family with C_k(1) = 1: in the plane T_k(s) dθ, about an axis P_k(s) sin θ dθ.
//! What is tested is the slope f', and about an axis A'(t), A(t) = t ∫ f'(r)/√(t² − r²) dr from 0 to t: with r = t sin φ it is ∫ (r f')' dφ from
//! 0 to π/2. Powers of |x| about x = 0 have closed forms, and so have polynomials, piece by piece (`pieces.rs`). All else is
//! integrated by Gauss rules from one place to the next where the profile is not smooth; towards the ends of a circle in the plane from one place to another twice as far from there.
use std::array::from_fn;
use std::f64::consts::{FRAC_PI_2, PI};

use crate::contact::problem::accuracy::ROUNDING;
use crate::contact::problem::modes::{alternating, order};
use crate::contact::problem::pieces;
use crate::contact::problem::profile::{PunchProfile, Span};
use crate::contact::problem::twin::Twin;
use crate::numeric::quadrature::rule;
use crate::numeric::vector::{LANES, vectorised};
use crate::scene::{Piece, Shape};

/// Most oscillations of a test function, as a phase, that one Gauss rule is asked to integrate.
const PHASE: f64 = 150.0;
/// Gauss points besides those that the oscillation takes.
const SPARE: f64 = 14.0;

/// The slope of a profile, per unit of P', against the tests of an interval: ∫ f'(m + w s) C_k ...
struct Slopes {
    rows: Vec<f64>,
    twin: Twin,
}

/// θ, and what is there to be added to the rows, times their tests.
type Node = (f64, f64);

impl Slopes {
    /// Adds amplitude · |s|^power sign(s) to odd rows: ∫ cos^ν θ C_k dθ is a product of gamma functions.
    fn add_power(&mut self, power: f64, amplitude: f64) {
        let mut value = 2.0 * amplitude * self.twin.moment(power + 1.0);
        for (m, row) in self.rows.iter_mut().enumerate() {
            *row += value;
            let k = order(m);
            value *= (k - power) / (k + power + (2.0 + 2.0 * self.twin.shift));
        }
    }

    /// Adds pieces between which the profile is not smooth to the rows of an interval whose middle and half-length are in the unit of the scene. At
    /// the start of each, x = b, begins J_0 + J_1 y + J_2 y² more of the slope, y = x − b.
    fn add_pieces(&mut self, pieces: &[Piece], Span { middle, half, step }: Span, force: f64) {
        let first = if step == 2 { 0.0 } else { middle - half };
        let mut before: Option<&Piece> = None;
        let after = pieces.iter().skip(1).map(|piece| piece.start).chain([f64::INFINITY]);
        let all = pieces.iter().zip(after).filter(|(_, end)| *end > first).map(|(piece, _)| piece);
        for piece in all.take_while(|piece| piece.start < middle + half) {
            let start = piece.start.max(first);
            let old = before.replace(piece).map_or([0.0; 3], |before| before.slopes(start));
            let new = piece.slopes(start);
            let [j0, j1, j2]: [f64; 3] = from_fn(|n| (new[n] - old[n]) * half.powi(n as i32) / force);
            let begins = step == 1 && start == first;
            let s = if begins { -1.0 } else { (start - middle) / half };
            let rows = match self.twin {
                Twin::Plane => pieces::plane(s, step, self.rows.len()),
                Twin::Round => pieces::round(s, self.rows.len()),
            };
            for (row, [own, linear, square]) in self.rows.iter_mut().zip(rows) {
                *row += j0 * own + j1 * linear + j2 * square;
            }
        }
    }

    /// Adds places to the first `count` rows, by the recurrence of the tests.
    fn add(&mut self, step: usize, count: usize, places: &[Node]) {
        let steps: Vec<[f64; 3]> = (0..count).map(|m| self.twin.steps(m, step)).collect();
        let mut sums = vec![[0.0; LANES]; count.min(self.rows.len())];
        vectorised(
            #[inline(always)]
            || {
                for some in places.chunks(LANES) {
                    let [mut turn, mut test, mut before, mut own] = [[0.0; LANES]; 4];
                    for (lane, (theta, part)) in some.iter().enumerate() {
                        let s = theta.cos();
                        let start = if step == 2 { [(2.0 * theta).cos(), s, -s] } else { [s, 1.0, s] };
                        [turn[lane], test[lane], before[lane]] = start;
                        own[lane] = *part;
                    }
                    for (sum, [up, stay, down]) in sums.iter_mut().zip(&steps) {
                        (0..LANES).for_each(|lane| sum[lane] += own[lane] * test[lane]);
                        for lane in 0..LANES {
                            let next = (up * turn[lane] + stay) * test[lane] - down * before[lane];
                            (before[lane], test[lane]) = (test[lane], next);
                        }
                    }
                }
            },
        );
        self.rows.iter_mut().zip(&sums).for_each(|(row, sum)| *row += sum.iter().sum::<f64>());
    }
}

impl PunchProfile<'_> {
    /// The first `count` rows on an interval.
    pub(crate) fn rows(&self, span: Span, count: usize) -> Vec<f64> {
        debug_assert!(span.step == 1 || self.shape.is_even(), "an uneven profile has rows of even k as well");
        let mut slopes = Slopes { rows: vec![0.0; count], twin: self.twin };
        match &self.shape {
            Shape::Flat(_) => {}
            Shape::Powers { .. } if span.step == 2 => {
                self.powers(span.half).for_each(|(power, slope)| slopes.add_power(power, slope));
            }
            Shape::Pieces { pieces, .. } => {
                let [middle, half] = [span.middle, span.half].map(|x| x * self.length);
                slopes.add_pieces(pieces, Span { middle, half, ..span }, self.force);
            }
            shape => {
                let phase = (span.step * count) as f64 + shape.degree();
                slopes.add(span.step, count, &self.between(span, &self.not_smooth(span), phase));
            }
        }
        if !self.face.is_flat() {
            self.add_face(&mut slopes, span);
        }
        slopes.rows
    }

    /// Adds the face below.
    fn add_face(&self, slopes: &mut Slopes, span: Span) {
        let [middle, half] = [span.middle, span.half].map(|x| x * self.length);
        if self.twin == Twin::Round {
            return slopes.add_power(1.0, self.face.curvature * half / self.force * self.twin.of_power(2.0));
        }
        let first = span.step - 1;
        let tests = self.face.tests(middle, half, first + span.step * slopes.rows.len());
        for (m, row) in slopes.rows.iter_mut().enumerate() {
            let sign = if span.step == 2 { alternating(m) } else { 1.0 };
            *row += sign * tests[first + span.step * m] / self.force;
        }
    }

    /// ∫ f'(a cos θ)/cos θ ... from 0 to π/2, over P': the sum of all odd rows.
    pub(crate) fn apex(&self, half_length: f64, most: usize) -> f64 {
        let of_face = self.face.apex(half_length * self.length, most) / self.force;
        if matches!(self.shape, Shape::Powers { .. }) {
            let sum = |(power, slope): (f64, f64)| {
                let moment = slope * self.twin.moment(power + 1.0) * (power + 1.0 + 2.0 * self.twin.shift) / power;
                if slope == 0.0 { 0.0 } else { moment }
            };
            return of_face + self.powers(half_length).map(sum).sum::<f64>();
        }
        // cell by cell to where the profile begins to be smooth: slopes farther in are nothing
        let (span, own) = (Span::even(half_length), half_length * self.length);
        let mut limits = self.not_smooth(span);
        let octaves = limits.first().map_or(0.0, |first| (own / first).log2()).min(-2.0 * ROUNDING.log2());
        limits.extend(halves(own).take(1 + octaves as usize));
        limits.sort_by(f64::total_cmp);
        of_face + self.between(span, &limits, 0.0).iter().map(|(theta, value)| 0.5 * value / theta.cos()).sum::<f64>()
    }

    /// Where the profile is not smooth inside an interval, from left to right, in the unit of the scene; powers go to the tip cell by cell.
    fn not_smooth(&self, span: Span) -> Vec<f64> {
        let [middle, half] = [span.middle, span.half].map(|x| x * self.length);
        let right: Vec<f64> = match &self.shape {
            Shape::Powers { .. } if !self.shape.is_smooth() => {
                // nearer to a tip the slope counts as a step and its mean: what else it does there is odd, so that the square of 2^(−27) counts, which is below rounding
                halves(middle.abs() + half).take(28).collect()
            }
            // where a circle ends its slope is infinite: from there twice as far each time
            Shape::Circle(radius) if self.twin == Twin::Plane => {
                let nearest = (radius - middle.abs() - half).max(f64::EPSILON * radius);
                let distances = std::iter::successors(Some(2.0 * nearest), |distance| Some(2.0 * distance));
                distances.take_while(|distance| distance < radius).map(|distance| radius - distance).collect()
            }
            // cells in which its slope is a polynomial to rounding; beyond them it is flat
            Shape::Dent { half_width, .. } => (1..=7_u8).map(|k| f64::from(k) * half_width).collect(),
            Shape::Powers { .. } | Shape::Circle(_) | Shape::Flat(_) | Shape::Pieces { .. } => Vec::new(),
        };
        let mut all: Vec<f64> =
            right.iter().map(|x| -x).chain(right.iter().copied()).chain(self.shape.starts()).collect();
        let first = if span.step == 2 { 0.0 } else { middle - half };
        all.retain(|x| *x > first && *x < middle + half);
        all.sort_by(f64::total_cmp);
        all
    }

    /// Places from one to the next of some `limits` inside the interval, for what oscillates like cos(phase · θ).
    fn between(&self, span: Span, limits: &[f64], phase: f64) -> Vec<Node> {
        let angle = |x: &f64| ((x - span.middle * self.length) / (span.half * self.length)).acos();
        let last = if span.step == 2 { FRAC_PI_2 } else { PI };
        let ends: Vec<f64> = std::iter::once(last).chain(limits.iter().map(angle)).chain([0.0]).collect();
        let mut places = Vec::new();
        for (index, pair) in ends.windows(2).enumerate() {
            let (to, from) = (pair[0], pair[1]);
            let is_about_tip = |x: &&f64| !self.shape.is_smooth() && index > 0 && **x == -limits[index - 1];
            if let Some(x) = limits.get(index).filter(is_about_tip) {
                let [right, left] = [*x, -x].map(|x| self.shape.slope(x) / self.force);
                let theta = (-span.middle / span.half).acos();
                places.push((theta, 0.5 * (right + left) * (to - from)));
                continue;
            }
            let parts = (phase * (to - from) / PHASE).ceil().max(1.0);
            let step = (to - from) / parts;
            for part in 0..parts as usize {
                let low = from + step * part as f64;
                if self.twin == Twin::Plane {
                    let nodes = rule((0.5 * phase * step + SPARE) as usize).on(low, low + step);
                    places.extend(nodes.map(|(theta, weight)| self.place(span, theta, weight)));
                } else {
                    // beyond a place where the profile is not smooth there is a square root: θ = to − u²
                    let [first, last] = [low + step, low].map(|theta| (to - theta).max(0.0).sqrt());
                    let nodes = rule((phase * last * (last - first) + SPARE) as usize).on(first, last);
                    places.extend(nodes.map(|(u, weight)| self.place(span, to - u * u, 2.0 * u * weight)));
                }
            }
        }
        places
    }

    /// What a place with a weight adds to the rows; to odd ones its mirror image adds the same.
    fn place(&self, span: Span, theta: f64, weight: f64) -> Node {
        let (s, weight) = (theta.cos(), span.step as f64 * weight);
        if self.twin == Twin::Round {
            return (theta, theta.sin() * weight * self.abel(span.half * s)[1]);
        }
        let (arm, weight) = (span.half * s * self.length, weight / self.force);
        let x = span.middle * self.length + arm;
        (theta, weight * self.shape.slope(x))
    }

    /// Height above the apex at x (both in units of L), per unit of P', and about an axis A(x).
    pub(crate) fn tested_height(&self, x: f64) -> f64 {
        if self.twin == Twin::Plane {
            return self.height(x);
        }
        let of_face = 0.5 * self.face.curvature * x * self.length / self.force * self.twin.of_power(2.0);
        x * (self.abel(x)[0] + of_face)
    }

    /// The powers of |x| that the slope consists of, and what is tested of each at x = a, over P'; none of other profiles.
    fn powers(&self, a: f64) -> impl Iterator<Item = (f64, f64)> {
        let (length, terms) =
            if let Shape::Powers { length, terms, .. } = &self.shape { (*length, &terms[..]) } else { (1.0, &[][..]) };
        terms.iter().map(move |(exponent, coefficient)| {
            let slope = coefficient * exponent / length * (a * self.length / length).powf(exponent - 1.0) / self.force;
            (exponent - 1.0, slope * self.twin.of_power(*exponent))
        })
    }

    /// A(t)/t and A'(t) at t in units of L, over P'.
    fn abel(&self, t: f64) -> [f64; 2] {
        let own = t * self.length;
        let values = match &self.shape {
            Shape::Circle(radius) => {
                // where a circle ends its slope is infinite
                let u = (own / radius).min(1.0 - 1e-12);
                let over = ((1.0 - u) * (1.0 + u)).recip();
                [u.atanh(), u.atanh() + u * over]
            }
            Shape::Pieces { pieces, .. } => pieces_abel(pieces, own),
            Shape::Flat(_) => [0.0; 2],
            Shape::Dent { depth, half_width } => {
                let z = own / half_width;
                let (factor, dawson) = (-2.0 * depth / half_width, dawson(z));
                [factor * dawson, factor * (dawson + z * (1.0 - 2.0 * z * dawson))]
            }
            Shape::Powers { .. } => {
                let add = |sum: [f64; 2], (power, slope): (f64, f64)| [sum[0] + slope / (power + 1.0), sum[1] + slope];
                return self.powers(t).fold([0.0; 2], add);
            }
        };
        values.map(|value| value / self.force)
    }
}

/// The same for polynomials: ∫ f'(t sin φ) dφ, and ∫ g(t sin φ) dφ with g = (r f')' = e_0 + e_1 r + e_2 r² in each piece.
fn pieces_abel(pieces: &[Piece], t: f64) -> [f64; 2] {
    let [mut whole, mut value] = [0.0; 2];
    // the left half is the mirror image of the right one
    let right = &pieces[pieces.partition_point(|piece| piece.start < 0.0)..];
    for (i, Piece { start, coefficients: [_, c1, c2, c3], .. }) in right.iter().enumerate() {
        if *start >= t {
            break;
        }
        // f' in powers of r, and g
        let d = [c1 - 2.0 * c2 * start + 3.0 * c3 * start * start, 2.0 * c2 - 6.0 * c3 * start, 3.0 * c3];
        let e = [d[0], 2.0 * d[1], 3.0 * d[2]];
        let end = right.get(i + 1).map_or(t, |next| next.start.min(t));
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
    }
    [whole, value]
}

/// exp(−z²) ∫ exp(s²) ds from 0 to z, Dawson's integral, by the trapezoidal rule of Rybicki (1989): right to rounding with these steps.
fn dawson(z: f64) -> f64 {
    const STEP: f64 = 0.2;
    let [from, to] = [z - 6.5, z + 6.5].map(|end| (0.5 * end / STEP).floor() as i64);
    let term = |k: i64| {
        let n = (2 * k + 1) as f64;
        (-(z - n * STEP).powi(2)).exp() / n
    };
    (from..=to).map(term).sum::<f64>() / PI.sqrt()
}

/// A length, and then each half as long as the one before.
fn halves(length: f64) -> impl Iterator<Item = f64> {
    std::iter::successors(Some(length), |length| Some(0.5 * length))
}

#[cfg(test)]
mod tests;
