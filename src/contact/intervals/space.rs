//! What columns do on a half-plane, and what punches do to their tests.
use std::f64::consts::{FRAC_PI_2, PI};

use faer::Mat;
use num_complex::Complex64;

use crate::contact::intervals::columns::{Columns, Other, Subtracted};
use crate::contact::intervals::pressure::{Pressure, Tip};
use crate::contact::intervals::support::{ContactInterval, Parity};
use crate::contact::problem::Side;
use crate::contact::problem::modes::alternating;
use crate::contact::problem::profile::Span;
use crate::numeric::quadrature::rule;
use crate::numeric::vector::{LANES, Lanes, vectorised};

/// Quadrature points in a gap, besides one for each term.
const POINTS: usize = 48;
/// The number of points grows no more for gaps between intervals that are shorter than this, in half-lengths.
const NEAREST: f64 = 1e-3;

/// What columns do to tests, in space.
pub(super) struct InSpace<'a> {
    /// Rows: tests as the terms are ordered, then the others; columns: terms, then ends, or one for what all of them do with some amplitudes.
    pub(super) matrix: Mat<f64>,
    pub(super) amplitudes: Option<&'a [f64]>,
}

impl InSpace<'_> {
    /// Adds what a column does to a test.
    pub(super) fn add(&mut self, row: usize, column: usize, value: f64) {
        match self.amplitudes {
            Some(amplitudes) => self.matrix[(row, 0)] += value * amplitudes[column],
            None => self.matrix[(row, column)] += value,
        }
    }
}

impl Columns<'_> {
    /// What the columns as they are do on a half-plane with λμ₀C = 1 besides sums of c exp(−ζb), the latter but for each interval to its own tests.
    pub(super) fn in_space<'a>(&self, exponentials: &[[f64; 2]], amplitudes: Option<&'a [f64]>) -> InSpace<'a> {
        let columns = if amplitudes.is_some() { 1 } else { self.terms() + self.ends() };
        let slopes = |places: &[f64], within: Option<usize>| self.slopes_at(places, within, exponentials, amplitudes);
        let mut space = InSpace { matrix: self.tested(columns, slopes), amplitudes };
        (0..self.intervals.len()).for_each(|number| self.add_on_half_plane(&mut space, number));
        space
    }

    /// What slopes do to tests: of each of some columns at some places, but for the ones that pressures on one interval make right there.
    fn tested(&self, columns: usize, slopes: impl Fn(&[f64], Option<usize>) -> Mat<f64>) -> Mat<f64> {
        let mut all = Mat::zeros(self.rows(), columns);
        for number in 0..self.intervals.len() {
            self.test_on_interval(&mut all, number, &slopes);
        }
        for (row, other) in (self.terms() + self.ends()..).zip(&self.others) {
            let Other::Closing(number) = *other else { continue };
            let [from, to] = self.gap(number);
            let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
            let factor = 2.0 / (PI * half);
            let nodes: Vec<(f64, f64)> = rule(POINTS + self.counts.iter().max().unwrap_or(&0)).on(0.0, PI).collect();
            let places: Vec<f64> = nodes.iter().map(|(theta, _)| middle + half * theta.cos()).collect();
            let tests = Mat::from_fn(1, nodes.len(), |_, q| factor * nodes[q].1 * nodes[q].0.sin());
            let tested = &tests * slopes(&places, None);
            (0..columns).for_each(|column| all[(row, column)] = tested[(0, column)]);
        }
        all
    }

    /// What tests see of the slope of the punch, if one presses, less what only the first ones of a group keep; and, on half-planes with this limit of the kernel besides exponentials,
    /// less what the terms of sharp tips do to other intervals and to gaps that are no unknowns, and do not fall.
    pub(super) fn load(&self, side: &Side, tips: &[Tip], limit: f64, exponentials: &[[f64; 2]]) -> Vec<f64> {
        let mut load = vec![0.0; self.rows()];
        if self.intervals.len() > 1 && tips.iter().any(|tip| tip.strength != 0.0) {
            let tested = self.tested(1, |places, within| {
                let mut slopes = Mat::zeros(places.len(), 1);
                for (number, tip) in tips.iter().enumerate().filter(|(number, _)| within != Some(*number)) {
                    let beyond = self.slopes_beyond(number, *tip, exponentials, places);
                    slopes.col_as_slice_mut(0).iter_mut().zip(beyond).for_each(|(sum, slope)| *sum -= limit * slope);
                }
                slopes
            });
            load.copy_from_slice(tested.col_as_slice(0));
        }
        for (number, interval) in self.intervals.iter().enumerate() {
            let (row, count) = (self.first(number), self.counts[number]);
            let mut tests = self::tests(side, interval, count).into_iter();
            if let Some(mean) = self.place(Other::Mean(number)) {
                load[mean] += interval.test(0) * tests.next().unwrap_or(0.0);
            }
            for (m, test) in tests.enumerate().take(count) {
                load[row + m] += interval.test(m) * test;
            }
            if let Some(row) = self.place(Other::Closing(number)) {
                let [from, to] = self.gap(number);
                let height = |x: f64| side.height_under(interval.punch, x);
                load[row] += 8.0 / (PI * (to - from).powi(2)) * (height(to) - height(from));
            }
        }
        for Subtracted { into, from, part } in self.subtracted_tests() {
            load[*into] -= part * load[*from];
        }
        load
    }

    /// The slopes at some places, over the limit of the kernel, that the terms of a sharp tip make which are no unknowns of its interval.
    fn slopes_beyond(&self, number: usize, tip: Tip, exponentials: &[[f64; 2]], places: &[f64]) -> Vec<f64> {
        let (interval, count) = (&self.intervals[number], self.counts[number]);
        let term = |m: usize| (tip.term(interval, m) / interval.order(m) as f64, interval.order(m) as u32);
        let known: Vec<(f64, u32)> = (0..count).map(term).collect();
        let at_depth = |x: f64, [b, c]: &[f64; 2]| {
            let inside = inside(Complex64::new(x - interval.middle, *b) / interval.half);
            let series: Complex64 = known.iter().map(|(part, order)| *part * inside.powu(*order)).sum();
            c * interval.unit() * (tip.slope(inside) - series).re
        };
        let slope = |x: &f64| std::iter::once(&[0.0, 1.0]).chain(exponentials).map(|depth| at_depth(*x, depth)).sum();
        places.iter().map(slope).collect()
    }

    /// Tests, on one interval, the slopes that others make there.
    fn test_on_interval(&self, into: &mut Mat<f64>, number: usize, slopes: impl Fn(&[f64], Option<usize>) -> Mat<f64>) {
        let (interval, row, count) = (&self.intervals[number], self.first(number), self.counts[number]);
        if self.intervals.len() == 1 && interval.parity != Parity::Pair {
            return;
        }
        // the test with k = 0 last
        let mean = self.place(Other::Mean(number));
        let all: Vec<(usize, usize)> =
            (0..count).map(|m| (row + m, interval.order(m))).chain(mean.map(|row| (row, 0))).collect();
        let points = self.points(number);
        // cos nπ/2 points
        let cosines: Vec<f64> = (0..4 * points).map(|n| (FRAC_PI_2 * n as f64 / points as f64).cos()).collect();
        let at = |q: usize, k: usize| cosines[k * (2 * q + 1) % cosines.len()];
        let places: Vec<f64> = (0..points).map(|q| interval.middle + interval.half * at(q, 1)).collect();
        let factor = 2.0 / (interval.half * points as f64);
        let tests = Mat::from_fn(all.len(), points, |m, q| factor * at(q, all[m].1));
        let tested = &tests * slopes(&places, Some(number));
        for (m, (row, _)) in all.iter().enumerate() {
            (0..tested.ncols()).for_each(|column| into[(*row, column)] = tested[(m, column)]);
        }
    }

    /// Adds what half-planes do to the tests of an interval by its own pressures.
    fn add_on_half_plane(&self, space: &mut InSpace, number: usize) {
        let (interval, row, count) = (&self.intervals[number], self.first(number), self.counts[number]);
        for m in 0..count {
            space.add(row + m, row + m, interval.on_half_plane(m));
        }
        if let Some(mean) = self.place(Other::Mean(number)) {
            let (end, images) = (self.terms() + self.end(number), if interval.is_even() { 2.0 } else { 1.0 });
            for (place, side) in interval.sides().iter().enumerate() {
                space.add(mean, end + place, -side * images * interval.unit() / interval.half);
            }
        }
    }

    /// Subtracts from the columns and tests as they are what only the first ones of a group keep.
    pub(super) fn subtract(&self, InSpace { matrix, amplitudes }: &mut InSpace) {
        let last = self.terms() + self.ends();
        let columns = |one: &&Subtracted| amplitudes.is_none() && one.into < last;
        for Subtracted { into, from, part } in self.subtracted.iter().filter(columns) {
            (0..matrix.nrows()).for_each(|row| matrix[(row, *into)] -= part * matrix[(row, *from)]);
        }
        for Subtracted { into, from, part } in self.subtracted_tests() {
            (0..matrix.ncols()).for_each(|column| matrix[(*into, column)] -= part * matrix[(*from, column)]);
        }
    }

    /// What is subtracted from tests: singular pressures are none.
    fn subtracted_tests(&self) -> impl Iterator<Item = &Subtracted> {
        let ends = self.terms()..self.terms() + self.ends();
        self.subtracted.iter().filter(move |one| !ends.contains(&one.into))
    }

    /// Quadrature points on an interval for the slopes that the others make there: these are singular at the ends of the others only, so that their Chebyshev
    /// coefficients fall like powers of the sum of the half-axes of the ellipse about the interval through the nearest end. Products with a test are summed
    /// right up to degree 2 n − 1.
    fn points(&self, number: usize) -> usize {
        let own = &self.intervals[number];
        let distance = |(k, other): (usize, &ContactInterval)| {
            let beside = (other.from() - own.to()).max(own.from() - other.to());
            let to_image = if own.parity == Parity::Pair { own.from() + other.from() } else { f64::INFINITY };
            if k == number { to_image } else { beside.min(to_image) }
        };
        let nearest = self.intervals.iter().enumerate().map(distance).fold(f64::INFINITY, f64::min);
        let gap = (nearest / own.half).max(NEAREST);
        let degree = -f64::EPSILON.ln() / (1.0 + gap + (gap * (gap + 2.0)).sqrt()).ln();
        let highest = own.order(self.counts[number] - 1);
        (0.5 * (degree + highest as f64)).ceil() as usize + 1
    }

    /// [`Self::for_slopes`] at some places, one row for each: on a half-plane besides some exponentials.
    pub(super) fn slopes_at(
        &self,
        places: &[f64],
        within: Option<usize>,
        exponentials: &[[f64; 2]],
        amplitudes: Option<&[f64]>,
    ) -> Mat<f64> {
        let columns = if amplitudes.is_some() { 1 } else { self.terms() + self.ends() };
        let mut all = Mat::zeros(places.len(), columns);
        vectorised(
            #[inline(always)]
            || {
                for (some, first) in places.chunks(LANES).zip((0..).step_by(LANES)) {
                    // the last place again in place of those that there are not
                    let x = std::array::from_fn(|lane| some[lane.min(some.len() - 1)]);
                    let rows = first..first + some.len();
                    for depth in std::iter::once(&[0.0, 1.0]).chain(exponentials) {
                        match amplitudes {
                            Some(amplitudes) => {
                                let mut sums = [0.0; LANES];
                                self.for_slopes(&x, *depth, within, |column, slopes| {
                                    (0..LANES).for_each(|lane| sums[lane] += slopes[lane] * amplitudes[column]);
                                });
                                let all = all.col_as_slice_mut(0)[rows.clone()].iter_mut();
                                all.zip(sums).for_each(|(all, sum)| *all += sum);
                            }
                            None => self.for_slopes(&x, *depth, within, |column, slopes| {
                                let all = all.col_as_slice_mut(column)[rows.clone()].iter_mut();
                                all.zip(slopes).for_each(|(all, slope)| *all += slope);
                            }),
                        }
                    }
                }
            },
        );
        all
    }

    /// Hands out the slopes that terms and singular pressures make at some places on a half-plane with λμ₀C = 1, or c times the slopes at a depth b if that is c exp(−ζb), but
    /// for the pressures right there on interval `within`; a column and its mirror image one after the other.
    #[inline(always)]
    fn for_slopes(&self, x: &Lanes, [b, c]: [f64; 2], within: Option<usize>, mut each: impl FnMut(usize, &Lanes)) {
        let mut end = self.terms();
        for (number, interval) in self.intervals.iter().enumerate() {
            let (first, count) = (self.first(number), self.counts[number]);
            let mut add = |x: &Lanes, factor: f64| {
                let column = |k: usize| if k < count { first + k } else { end + k - count };
                interval.slopes_of(count, (x, b), factor, |k, slopes| each(column(k), slopes));
            };
            if within != Some(number) {
                add(x, c);
            }
            if interval.parity == Parity::Pair {
                // the mirror image of the place, at the same depth
                add(&x.map(|x| -x), if interval.opens { c } else { -c });
            }
            end += interval.sides().len();
        }
    }

    /// By how much less pressures on a half-plane with λμ₀C = 1 open a gap at x outside the contact than farther inwards: the integral of the slope, but for a
    /// constant, with ds = ½ (1 − z⁻²) dz for s = ½ (z + 1/z).
    pub(super) fn closed(&self, x: f64, pressures: &[Pressure]) -> f64 {
        let of = |(interval, pressure): (&ContactInterval, &Pressure)| {
            let at = |x: f64| interval.closed_by(x, pressure);
            // what the mirror image of an interval does at x, the interval does at −x
            if interval.parity == Parity::Pair { at(x) + at(-x) } else { at(x) }
        };
        self.intervals.iter().zip(pressures).map(of).sum()
    }
}

impl ContactInterval {
    /// Hands out a factor times the slopes at x, at a depth, that its terms make, by their numbers, and then its singular pressures.
    #[inline(always)]
    fn slopes_of(&self, count: usize, (x, depth): (&Lanes, f64), factor: f64, mut each: impl FnMut(usize, &Lanes)) {
        let unit = factor * self.unit();
        let s = x.map(|x| Complex64::new(x - self.middle, depth) / self.half);
        let (roots, inside) = (s.map(root), s.map(inside));
        let square = || inside.map(|inside| inside * inside);
        let (from, by) = match self.has_orders() {
            [true, true] => (inside, inside),
            [true, false] => (inside, square()),
            [false, _] => (square(), square()),
        };
        let [mut re, mut im, by_re, by_im]: [Lanes; 4] =
            [from.map(|z| z.re), from.map(|z| z.im), by.map(|z| z.re), by.map(|z| z.im)];
        for m in 0..count {
            let part = unit / self.order(m) as f64;
            each(m, &re.map(|re| part * re));
            let mut most = 0.0f64;
            for lane in 0..LANES {
                let real = re[lane] * by_re[lane] - im[lane] * by_im[lane];
                im[lane] = re[lane] * by_im[lane] + im[lane] * by_re[lane];
                re[lane] = real;
                most = most.max(re[lane] * re[lane] + im[lane] * im[lane]);
            }
            // far from an interval its higher terms, here their squares, are below rounding
            if most < 1e-36 {
                break;
            }
        }
        for (place, side) in self.sides().iter().enumerate() {
            let slope = |lane: usize| {
                let at_end = match self.has_orders() {
                    [true, true] => 0.5 * (1.0 + side * inside[lane]),
                    [true, false] => Complex64::ONE,
                    [false, _] => inside[lane],
                };
                unit * (at_end / roots[lane]).re
            };
            each(count + place, &std::array::from_fn(slope));
        }
    }

    /// By how much its pressure closes a gap at x.
    fn closed_by(&self, x: f64, Pressure { terms, singular, tip }: &Pressure) -> f64 {
        let s = (x - self.middle) / self.half;
        // s less √(s² − 1)
        let inside = (s.abs() + ((s - 1.0) * (s + 1.0)).max(0.0).sqrt()).recip().copysign(s);
        let logarithm = -inside.abs().ln();
        let mut power = 1.0;
        let mut sum = tip.closed(s, inside);
        for (m, y) in terms.iter().enumerate() {
            let j = self.order(m) as f64;
            let near = if m > 0 { -power / (j - 1.0) } else { logarithm };
            let next = power * inside * inside;
            sum += 0.5 * y / j * (near + next / (j + 1.0));
            power = if self.is_even() { next } else { power * inside };
        }
        for (side, q) in self.sides().iter().zip(singular) {
            let at_end = if self.is_even() { logarithm } else { 0.5 * (logarithm - side * inside) };
            sum += q * at_end;
        }
        self.unit() * self.half * sum
    }
}

/// s less √(s² − 1).
#[inline(always)]
fn inside(s: Complex64) -> Complex64 {
    (s + root(s)).inv()
}

/// √(s² − 1) on the side of s, not quite 0 at s = ±1.
fn root(s: Complex64) -> Complex64 {
    let square = (s - 1.0) * (s + 1.0);
    let larger = (0.5 * (square.norm_sqr().sqrt() + square.re.abs())).max(f64::MIN_POSITIVE).sqrt();
    let smaller = 0.5 * square.im / larger;
    let root = if square.re < 0.0 {
        Complex64::new(smaller.abs(), larger.copysign(square.im))
    } else {
        Complex64::new(larger, smaller)
    };
    if root.re * s.re + root.im * s.im < 0.0 { -root } else { root }
}

/// ∫ f' cos kφ dφ of the slope f' of a punch over an interval, for the k of its terms, and first for k = 0 beside x = 0; none between layers.
pub(super) fn tests(side: &Side, interval: &ContactInterval, count: usize) -> Vec<f64> {
    match side {
        Side::Punches(all) => all
            .get(interval.punch)
            .map(|punch| punch.rows(interval.middle, interval.half, count + 1))
            .unwrap_or_default(),
        Side::Profile(profile) if interval.is_even() => {
            let rows = profile.rows(Span::even(interval.half), count).into_iter();
            rows.enumerate().map(|(m, value)| alternating(m) * value).collect()
        }
        Side::Profile(profile) => profile.rows(Span::anywhere(interval.middle, interval.half), count + 1),
        // what is wanted of the change of the pressure, which is to be zero
        Side::Openings(own) => {
            let orders: Vec<usize> = std::iter::once(0).chain((0..count).map(|m| interval.order(m))).collect();
            own.tests(interval.middle, interval.half, &orders)
        }
        _ => Vec::new(),
    }
}
