//! Pressures on strips, whose sum is the pressure of a contact.
use std::f64::consts::PI;
use std::sync::LazyLock;

use num_complex::Complex64;

/// Sines of so many multiples follow from one by rotation, each with a rounding more.
const ROTATED: usize = 64;
/// Factors of so many Jacobi polynomials are tabulated.
const USUAL: usize = 4096;

/// A pressure on |x − at| < extent, in stress.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Strip {
    /// Where its middle is, in length.
    pub(crate) at: f64,
    /// Half-length a of the strip, 0 of a line load.
    pub(crate) extent: f64,
    /// Of a line load its resultant alone; else p = Σ_m coefficients[m] sin((2m + 1) φ) + [left (1 − cos φ) + right (1 + cos φ)]/(2 sin φ)
    /// + tip arcosh((1 − s t)/|s − t|) with x − at = a cos φ, s = cos φ, left and right being the corners, and t where the tip is.
    pub(crate) coefficients: Vec<f64>,
    /// Coefficients of sin((2m + 2) φ), of what is odd about the middle.
    pub(crate) skew: Vec<f64>,
    /// How strong it is next to the sharp corners of a punch, at its left and its right end; 0 where there is none.
    pub(crate) corners: [f64; 2],
    /// How strong its logarithm is under a sharp tip; 0 if there is none.
    pub(crate) tip: f64,
    /// Where that tip is, in half-lengths from the middle.
    pub(crate) tip_at: f64,
    /// What else is known of it.
    pub(crate) form: Form,
    /// Whether it is a disc about the axis x = 0: then its series is summed by [`jacobi_sums`], with the same singular parts, s = |x|/a.
    pub(crate) is_round: bool,
}

/// Pressures that are known in closed form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    /// What the series says.
    Series,
    /// All on a line.
    Line,
    /// The same everywhere.
    Uniform,
    /// Like 1 − s², s = (x − at)/a.
    Parabolic,
}

impl Strip {
    /// A pressure about x = 0 of which nothing is known but its series.
    pub(crate) fn series(extent: f64, coefficients: Vec<f64>) -> Self {
        Self {
            at: 0.0,
            extent,
            coefficients,
            skew: Vec::new(),
            corners: [0.0; 2],
            tip: 0.0,
            tip_at: 0.0,
            form: Form::Series,
            is_round: false,
        }
    }

    /// The same in other units of length and pressure.
    pub(crate) fn scaled(mut self, length: f64, pressure: f64) -> Self {
        // on a line the only coefficient is a force
        let unit = match self.form {
            Form::Line if self.is_round => length * length * pressure,
            Form::Line => length * pressure,
            _ => pressure,
        };
        self.coefficients.iter_mut().chain(&mut self.skew).for_each(|c| *c *= unit);
        (self.at, self.extent) = (self.at * length, self.extent * length);
        (self.corners, self.tip) = (self.corners.map(|corner| corner * pressure), self.tip * pressure);
        self
    }

    /// The integral of the series and of what is singular at its ends from the left end to x = at + extent cos φ, over the extent.
    pub(crate) fn integral_to(&self, phi: f64) -> f64 {
        let [of_odd, of_even] = self.integrated();
        let [left, right] = self.corners;
        let series = sine_sum(of_odd.into_iter(), 1, phi) + sine_sum(of_even.into_iter(), 2, phi);
        series + 0.5 * ((self.first() + left + right) * (PI - phi) + (left - right) * phi.sin())
    }

    /// The integral of its series from the left end on, which is 0 at the right end, too, but for the first coefficient.
    pub(crate) fn antiderivative(&self) -> Self {
        let [coefficients, skew] = self.integrated().map(|all| all.into_iter().map(|c| self.extent * c).collect());
        Self { at: self.at, skew, ..Self::series(self.extent, coefficients) }
    }

    /// The coefficients of the integral of the series over the extent, but for the first one: of what is even about the middle, and of what is odd.
    fn integrated(&self) -> [Vec<f64>; 2] {
        // 2 sin jφ sin φ is cos (j − 1)φ − cos (j + 1)φ
        let (even, odd) = (&self.coefficients, &self.skew);
        let after = |all: &[f64], m: usize| all.get(m).copied().unwrap_or(0.0);
        let of_even = (0..even.len()).map(|m| 0.5 * (even[m] - after(even, m + 1)) / (2 * m + 2) as f64);
        let before = std::iter::once(0.0).chain(odd.iter().copied());
        let of_odd = before.enumerate().map(|(m, before)| 0.5 * (before - after(odd, m)) / (2 * m + 1) as f64);
        [of_odd.collect(), of_even.collect()]
    }

    /// The first coefficient of the series.
    pub(crate) fn first(&self) -> f64 {
        self.coefficients.first().copied().unwrap_or(0.0)
    }

    /// The strength of 1/sin φ and of cos φ/sin φ, which corners make together.
    pub(crate) fn even_and_odd_corners(&self) -> [f64; 2] {
        let [left, right] = self.corners;
        [0.5 * (right + left), 0.5 * (right - left)]
    }

    /// Where it begins and ends.
    pub(crate) fn ends(&self) -> [f64; 2] {
        [self.at - self.extent, self.at + self.extent]
    }

    /// Its resultant.
    pub(crate) fn resultant(&self) -> f64 {
        if self.form == Form::Line {
            return self.coefficients.iter().sum();
        }
        let [corners, _] = self.even_and_odd_corners();
        if self.is_round {
            return 2.0 * PI / 3.0 * self.extent.powi(2) * (self.first() + 3.0 * corners + 1.5 * self.tip);
        }
        0.5 * PI * self.extent * (self.first() + 2.0 * corners + self.tip_coefficient(1))
    }

    /// p̂(0): the resultant; of a disc ∫ p r dr.
    pub(crate) fn long_waves(&self) -> f64 {
        if self.is_round { self.resultant() / (2.0 * PI) } else { self.resultant() }
    }

    /// The pressure at a place.
    pub(crate) fn pressure(&self, x: f64) -> f64 {
        let x = x - self.at;
        if self.form == Form::Line {
            return if x == 0.0 { f64::INFINITY } else { 0.0 };
        }
        let s = x / self.extent;
        // NaN is outside, too
        if s.is_nan() || s.abs() > 1.0 {
            return 0.0;
        }
        let mean = match self.is_round {
            true => self.resultant() / (PI * self.extent.powi(2)),
            false => 0.5 * self.resultant() / self.extent,
        };
        let of_middle = if self.is_round { 2.0 } else { 1.5 };
        match self.form {
            // where it ends, the mean of both sides
            Form::Uniform if s.abs() == 1.0 => 0.5 * mean,
            Form::Uniform => mean,
            Form::Parabolic => of_middle * mean * (1.0 - s * s),
            Form::Series | Form::Line => {
                let phi = s.acos();
                let half = 0.5 * phi;
                let corner = |strength: f64, (falls, rises): (f64, f64)| match strength {
                    0.0 => 0.0,
                    _ if rises == 0.0 => strength * f64::INFINITY,
                    // (1 ± cos φ)/(2 sin φ)
                    _ => 0.5 * strength * falls / rises,
                };
                let (sin, cos) = if s == -1.0 { (1.0, 0.0) } else { half.sin_cos() };
                let [left, right] = self.corners;
                let corners = corner(left, (sin, cos)) + corner(right, (cos, sin));
                let tip = match self.tip {
                    0.0 => 0.0,
                    tip if (x + self.at - self.tip_place()).abs() <= self.rounding() => tip * f64::INFINITY,
                    tip => tip * ((1.0 - s * self.tip_at) / (s - self.tip_at).abs()).max(1.0).acosh(),
                };
                if self.is_round {
                    let [series] = jacobi_sums(&self.coefficients, [s.abs()]);
                    return series + corners + tip;
                }
                sine_sum(self.coefficients.iter().copied(), 1, phi)
                    + sine_sum(self.skew.iter().copied(), 2, phi)
                    + corners
                    + tip
            }
        }
    }

    /// Its moment about the middle, ∫ (x − at) p dx.
    pub(crate) fn moment(&self) -> f64 {
        // ∫ x sin 2φ dx and ∫ x cos φ/sin φ dx with x = a cos φ
        let [_, corners] = self.even_and_odd_corners();
        let skew = self.skew.first().copied().unwrap_or(0.0) + self.tip_coefficient(2);
        0.25 * PI * self.extent.powi(2) * (skew + 2.0 * corners)
    }

    /// What rounding does to places on it.
    fn rounding(&self) -> f64 {
        4.0 * f64::EPSILON * (self.at.abs() + self.extent)
    }

    /// Where its tip is: at x = 0 but for rounding counts as there.
    pub(crate) fn tip_place(&self) -> f64 {
        let place = self.at + self.tip_at * self.extent;
        if place.abs() <= self.rounding() { 0.0 } else { place }
    }

    /// The coefficient of sin kφ in the part of the pressure that a sharp tip makes: 2 sin kθ/k where the tip is at cos θ.
    pub(crate) fn tip_coefficient(&self, k: usize) -> f64 {
        if self.tip == 0.0 { 0.0 } else { self.tip * tip_coefficient(self.tip_at, k) }
    }

    /// Its mirror image about a place.
    pub(crate) fn mirrored(&self, about: f64) -> Self {
        let [left, right] = self.corners;
        let skew = self.skew.iter().map(|c| -c).collect();
        Self { at: 2.0 * about - self.at, skew, corners: [right, left], tip_at: -self.tip_at, ..self.clone() }
    }

    /// The places at which the pressure is infinite, under a line load, at the corners of a flat punch and under a sharp tip, and whether the
    /// displacement of the face is so, too.
    pub(crate) fn singular_points(&self) -> impl Iterator<Item = (f64, bool)> {
        let line = (self.form == Form::Line).then_some((self.at, true));
        let corners = self.ends().into_iter().zip(self.corners).filter(|(_, corner)| *corner != 0.0);
        let tip = (self.tip != 0.0).then(|| self.tip_place());
        line.into_iter().chain(corners.map(|(end, _)| end).chain(tip).map(|place| (place, false)))
    }
}

/// 2 sin kθ/k with cos θ = t, the coefficient of sin kφ in arcosh((1 − t cos φ)/|cos φ − t|).
pub(crate) fn tip_coefficient(t: f64, k: usize) -> f64 {
    // exact about the middle
    let sine = match (t == 0.0, k % 4) {
        (true, 1) => 1.0,
        (true, 3) => -1.0,
        (true, _) => 0.0,
        (false, _) => (k as f64 * t.acos()).sin(),
    };
    2.0 * sine / k as f64
}

/// w_m = (−1)^m ∫ P_(2m+1)(t)/t dt from 0 to 1: the transform of the term of order m is a² j_(2m+1)(λa)/(λa w_m).
pub(crate) fn jacobi_weights() -> impl Iterator<Item = f64> {
    let ratio = |m: i32| f64::from(2 * m + 2) / f64::from(2 * m + 3);
    (0..).scan(1.0, move |next, m| Some(std::mem::replace(next, *next * ratio(m))))
}

/// √(1 − s²) Σ c_m P_m(1 − 2s²) with Jacobi polynomials P_m^(0, 1/2), which are 1 at s = 0, at several places.
#[inline(always)]
pub(crate) fn jacobi_sums<const N: usize>(coefficients: &[f64], places: [f64; N]) -> [f64; N] {
    let x = places.map(|s| 1.0 - 2.0 * s * s);
    let [mut before, mut here, mut sum] = [[0.0; N], [1.0; N], [0.0; N]];
    let more: Vec<[f64; 3]>;
    let steps = if coefficients.len() <= USUAL {
        &STEPS[..]
    } else {
        more = (0..coefficients.len()).map(step).collect();
        &more
    };
    for (c, [along, shift, across]) in coefficients.iter().zip(steps) {
        let mut next = [0.0; N];
        for i in 0..N {
            sum[i] += c * here[i];
            next[i] = (along * x[i] + shift) * here[i] - across * before[i];
        }
        (before, here) = (here, next);
    }
    std::array::from_fn(|i| ((1.0 - places[i]) * (1.0 + places[i])).max(0.0).sqrt() * sum[i])
}

/// [`step`] for as many polynomials as most series have.
static STEPS: LazyLock<Vec<[f64; 3]>> = LazyLock::new(|| (0..USUAL).map(step).collect());

/// The factors of P_(m+1) = (along x + shift) P_m − across P_(m−1).
fn step(m: usize) -> [f64; 3] {
    const BETA: f64 = 0.5;
    if m == 0 {
        // P_1 = (α + 1) + (α + β + 2) (x − 1)/2
        return [0.5 * (BETA + 2.0), -0.5 * BETA, 0.0];
    }
    let (n, double) = (m as f64, 2.0 * m as f64 + BETA);
    let over = (2.0 * (n + 1.0) * (n + 1.0 + BETA) * double).recip();
    let along = over * (double + 1.0) * (double + 2.0) * double;
    [along, -over * (double + 1.0) * BETA * BETA, over * 2.0 * n * (n + BETA) * (double + 2.0)]
}

/// Σ c_m sin((2m + first) φ).
fn sine_sum(coefficients: impl Iterator<Item = f64>, first: usize, phi: f64) -> f64 {
    let (turn, mut wave) = (Complex64::cis(2.0 * phi), Complex64::ONE);
    let mut sum = 0.0;
    for (m, c) in coefficients.enumerate() {
        if m.is_multiple_of(ROTATED) {
            wave = Complex64::cis((2 * m + first) as f64 * phi);
        }
        sum += c * wave.im;
        wave *= turn;
    }
    sum
}
