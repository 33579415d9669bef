//! What is tested and what presses on the intervals of one contact, as columns.
//!
//! The pressure of an interval is p = Σ y_j (unit/j) sin jφ, x = middle + half cos φ, unit sin φ having the resultant 1 on the interval and
//! its mirror image together; at its ends it may be singular, q unit (1 ± cos φ)/(2 sin φ). A column u is the transform ∫ p cos ζx dx times ζ. The
//! slope of a gap is tested with (2/πw) cos kφ on each interval, which makes 2 J_k(ζw)/w times a phase of a wave sin ζx, as sin jφ makes 2 J_j(ζw)/w: all
//! tests with k > 0 are columns, too. The others are the tests with k = 0, and of the closing of gaps between two intervals.
//!
//! Only the first column of a contact has a resultant, 1, which is known. From all others as much of the first one is subtracted as they
//! have, in such a way that long waves, which feel resultants most, lose no digits.
use std::f64::consts::PI;

use faer::Mat;

use crate::contact::intervals::pressure::Pressure;
use crate::contact::intervals::support::Interval;
use crate::contact::problem::accuracy::PER_MODE;
use crate::contact::problem::modes::alternating;
use crate::contact::problem::profile::{Profile, Span};
use crate::numeric::quadrature::rule;
use crate::numeric::{bessel, dot};

/// Quadrature points on an interval, besides the points that each term takes.
const POINTS: usize = 48;

/// The intervals of one contact, with the numbers of terms on each.
#[derive(Clone, Copy)]
pub(super) struct Columns<'a> {
    pub(super) intervals: &'a [Interval],
    pub(super) counts: &'a [usize],
}

/// What columns do on a half-plane with λμ₀C = 1, and what they do to a gap with a slope of its own.
pub(super) struct InSpace {
    /// Rows: tests as the terms are ordered, then the others; columns: terms, then ends.
    pub(super) matrix: Mat<f64>,
    pub(super) load: Vec<f64>,
}

impl Columns<'_> {
    /// Number of terms.
    pub(super) fn terms(&self) -> usize {
        self.counts.iter().sum()
    }

    /// Number of ends.
    pub(super) fn ends(&self) -> usize {
        self.intervals.iter().map(|interval| interval.sides().len()).sum()
    }

    /// Number of tests that are no columns.
    pub(super) fn others(&self) -> usize {
        self.ends().saturating_sub(1)
    }

    /// Number of the first term of an interval.
    pub(super) fn first(&self, interval: usize) -> usize {
        self.counts[..interval].iter().sum()
    }

    /// The gaps to be closed, between one interval and the next.
    fn gaps(&self) -> impl Iterator<Item = [f64; 2]> {
        self.intervals.windows(2).map(|pair| [pair[0].to(), pair[1].from()])
    }

    /// The intervals beside x = 0.
    fn pairs(&self) -> impl Iterator<Item = (usize, &Interval)> {
        self.intervals.iter().enumerate().filter(|(_, interval)| !interval.is_central())
    }

    /// The resultants of the singular pressures at the ends.
    pub(super) fn resultants(&self) -> Vec<f64> {
        let of = |interval: &Interval| vec![if interval.is_central() { 2.0 } else { 1.0 }; interval.sides().len()];
        self.intervals.iter().flat_map(of).collect()
    }

    /// The transform of the first term less its resultant at some wavenumbers.
    pub(super) fn first_minus_one(&self, zeta: &[f64]) -> Vec<f64> {
        let Interval { middle, half, .. } = self.intervals[0];
        let of = |zeta: &f64| less_one(bessel::jinc_minus_one(zeta * half), cosine_minus_one(zeta * middle));
        zeta.iter().map(of).collect()
    }

    /// All columns at some wavenumbers: terms, singular pressures at ends, other tests.
    pub(super) fn waves(&self, zeta: &[f64]) -> Mat<f64> {
        let (terms, ends) = (self.terms(), self.ends());
        let mut all = Mat::zeros(zeta.len(), terms + ends + self.others());
        let first = self.first_minus_one(zeta);
        let (mut end, mut other) = (terms, terms + ends);
        for (number, interval) in self.intervals.iter().enumerate() {
            let Interval { middle, half, .. } = *interval;
            let count = self.counts[number];
            let orders = (interval.order(count - 1) + 1).max(3);
            let arguments: Vec<f64> = zeta.iter().map(|zeta| zeta * half).collect();
            let mut table = vec![0.0; orders * zeta.len()];
            bessel::table(orders, &arguments, &mut table);
            let j = |order: usize| &table[order * zeta.len()..(order + 1) * zeta.len()];
            let phases: Vec<(f64, f64)> = zeta.iter().map(|zeta| (zeta * middle).sin_cos()).collect();
            let column = self.first(number);
            for m in 0..count {
                let order = interval.order(m);
                let factor = 2.0 * alternating(order / 2) / half;
                let values = j(order).iter().zip(&phases);
                let values = values.map(|(j, (sin, cos))| j * if order.is_multiple_of(2) { *sin } else { *cos });
                all.col_as_slice_mut(column + m).iter_mut().zip(values).for_each(|(out, value)| *out = factor * value);
            }
            for k in 0..zeta.len() {
                let (sin, wave) = (phases[k].0, zeta[k]);
                let jinc = bessel::jinc_minus_one_from(arguments[k], j(1)[k]);
                let (zeroth, cos) = (jinc - j(2)[k], cosine_minus_one(wave * middle));
                if number > 0 {
                    all[(k, column)] = wave * (less_one(jinc, cos) - first[k]);
                }
                for (place, side) in interval.sides().iter().enumerate() {
                    all[(k, end + place)] = if interval.is_central() {
                        2.0 * wave * (zeroth - first[k])
                    } else {
                        wave * (less_one(zeroth, cos) - side * j(1)[k] * sin - first[k])
                    };
                }
                if !interval.is_central() {
                    let mean = less_one(zeroth, bessel::sinc_minus_one(wave * middle));
                    all[(k, other)] = self.resultant_of_mean(interval) * wave * (mean - first[k]);
                }
            }
            end += interval.sides().len();
            other += usize::from(!interval.is_central());
        }
        for gap @ [from, to] in self.gaps() {
            for (k, wave) in zeta.iter().enumerate() {
                let [sum, difference] =
                    [to + from, to - from].map(|length| bessel::sinc_minus_one(0.5 * wave * length));
                all[(k, other)] = resultant_of_closing(gap) * wave * (less_one(sum, difference) - first[k]);
            }
            other += 1;
        }
        all
    }

    /// How much of the first column the test with k = 0 contains.
    fn resultant_of_mean(&self, interval: &Interval) -> f64 {
        2.0 * interval.middle / interval.half
    }

    /// What the columns do on a half-plane with λμ₀C = 1, and the tests of the profile of a punch, if one presses.
    pub(super) fn in_space(&self, profile: Option<&Profile>) -> InSpace {
        let (terms, ends, others) = (self.terms(), self.ends(), self.others());
        let mut matrix = Mat::zeros(terms + others, terms + ends);
        let mut load = vec![0.0; terms + others];
        let mut other = terms;
        for (number, interval) in self.intervals.iter().enumerate() {
            let (row, count) = (self.first(number), self.counts[number]);
            let points = POINTS + PER_MODE * interval.order(count - 1);
            let angles: Vec<f64> = (0..points).map(|q| PI * (q as f64 + 0.5) / points as f64).collect();
            let places: Vec<f64> = angles.iter().map(|theta| interval.middle + interval.half * theta.cos()).collect();
            let factor = 2.0 / (interval.half * points as f64);
            // the test with k = 0 last
            let count_all = count + usize::from(!interval.is_central());
            let order = |m: usize| if m < count { interval.order(m) as f64 } else { 0.0 };
            let tests = Mat::from_fn(count_all, points, |m, q| factor * (order(m) * angles[q]).cos());
            let tested = &tests * self.slopes_at(&places, Some(number));
            for m in 0..count_all {
                let row = if m < count { row + m } else { other };
                (0..terms + ends).for_each(|column| matrix[(row, column)] = tested[(m, column)]);
            }
            if let Some(profile) = profile {
                let factor = 2.0 / (PI * interval.half);
                let mut tests = self::tests(profile, interval, count).into_iter().map(|test| factor * test);
                if !interval.is_central() {
                    load[other] = tests.next().unwrap_or(0.0);
                }
                load[row..row + count].iter_mut().zip(tests).for_each(|(load, test)| *load = test);
            }
            for m in 0..count {
                matrix[(row + m, row + m)] += interval.unit() / (interval.half * interval.order(m) as f64);
            }
            if !interval.is_central() {
                let end = terms + self.end(number);
                for (place, side) in interval.sides().iter().enumerate() {
                    matrix[(other, end + place)] -= side * interval.unit() / interval.half;
                }
                other += 1;
            }
        }
        for [from, to] in self.gaps() {
            let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
            let factor = 2.0 / (PI * half);
            let nodes: Vec<(f64, f64)> = rule(POINTS + self.counts.iter().max().unwrap_or(&0)).on(0.0, PI).collect();
            let places: Vec<f64> = nodes.iter().map(|(theta, _)| middle + half * theta.cos()).collect();
            let tests = Mat::from_fn(1, nodes.len(), |_, q| factor * nodes[q].1 * nodes[q].0.sin());
            let tested = &tests * self.slopes_at(&places, None);
            (0..terms + ends).for_each(|column| matrix[(other, column)] = tested[(0, column)]);
            load[other] = factor / half * profile.map_or(0.0, |profile| profile.height(to) - profile.height(from));
            other += 1;
        }
        self.subtract_first(&mut matrix, &mut load);
        InSpace { matrix, load }
    }

    /// [`Self::slopes`] at some places, one row for each.
    fn slopes_at(&self, places: &[f64], within: Option<usize>) -> Mat<f64> {
        let columns = self.terms() + self.ends();
        let mut slopes = vec![0.0; columns];
        let mut all = Mat::zeros(places.len(), columns);
        for (row, x) in places.iter().enumerate() {
            self.slopes(*x, within, &mut slopes);
            slopes.iter().enumerate().for_each(|(column, slope)| all[(row, column)] = *slope);
        }
        all
    }

    /// Subtracts what other columns, and tests, contain of the first one.
    fn subtract_first(&self, matrix: &mut Mat<f64>, load: &mut [f64]) {
        let terms = self.terms();
        let later = (1..self.intervals.len()).map(|number| (self.first(number), 1.0));
        let singular = self.resultants().into_iter().enumerate().map(|(end, resultant)| (terms + end, resultant));
        for (column, part) in later.clone().chain(singular) {
            for row in 0..matrix.nrows() {
                let first = matrix[(row, 0)];
                matrix[(row, column)] -= part * first;
            }
        }
        let means = self.pairs().map(|(_, interval)| self.resultant_of_mean(interval));
        let others = means.chain(self.gaps().map(resultant_of_closing));
        for (row, part) in later.chain(others.enumerate().map(|(other, part)| (terms + other, part))) {
            for column in 0..matrix.ncols() {
                let first = matrix[(0, column)];
                matrix[(row, column)] -= part * first;
            }
            load[row] -= part * load[0];
        }
    }

    /// Number of the first end of an interval.
    fn end(&self, interval: usize) -> usize {
        self.intervals[..interval].iter().map(|interval| interval.sides().len()).sum()
    }

    /// The slopes that terms and singular pressures make at x on a half-plane with λμ₀C = 1, but for the pressures right there on interval
    /// `within`.
    fn slopes(&self, x: f64, within: Option<usize>, out: &mut [f64]) {
        out.fill(0.0);
        let mut end = self.terms();
        for (number, interval) in self.intervals.iter().enumerate() {
            let unit = interval.unit();
            let first = self.first(number);
            let mut add = |x: f64, sign: f64| {
                let s = (x - interval.middle) / interval.half;
                let root = (s * s - 1.0).max(f64::MIN_POSITIVE).sqrt() * s.signum();
                // s − √(s² − 1) with the sign of s
                let inside = (s + root).recip();
                let square = inside * inside;
                let (mut power, by) = if interval.is_central() { (inside, square) } else { (inside, inside) };
                for (m, out) in out[first..first + self.counts[number]].iter_mut().enumerate() {
                    *out += sign * unit * power / interval.order(m) as f64;
                    power *= by;
                }
                for (place, side) in interval.sides().iter().enumerate() {
                    let at_end = if interval.is_central() { 1.0 } else { 0.5 * (1.0 + side * inside) };
                    out[end + place] += sign * unit * at_end / root;
                }
            };
            if within != Some(number) {
                add(x, 1.0);
            }
            if !interval.is_central() {
                add(-x, -1.0);
            }
            end += interval.sides().len();
        }
    }

    /// The slope at x outside the contact that pressures make on a half-plane with λμ₀C = 1.
    pub(super) fn slope(&self, x: f64, amplitudes: &[f64]) -> f64 {
        let mut slopes = vec![0.0; self.terms() + self.ends()];
        self.slopes(x, None, &mut slopes);
        dot(&slopes, amplitudes)
    }

    /// The amplitudes of terms, then of singular pressures, of the pressures of its intervals.
    pub(super) fn amplitudes(&self, pressures: &[Pressure]) -> Vec<f64> {
        let terms = pressures.iter().flat_map(|own| &own.terms);
        terms.chain(pressures.iter().flat_map(|own| &own.singular)).copied().collect()
    }

    /// The pressures with these amplitudes.
    pub(super) fn pressures(&self, terms: &[f64], singular: &[f64]) -> Vec<Pressure> {
        let (mut terms, mut singular) = (terms.iter().copied(), singular.iter().copied());
        let of = |(interval, count): (&Interval, &usize)| Pressure {
            terms: terms.by_ref().take(*count).collect(),
            singular: singular.by_ref().take(interval.sides().len()).collect(),
        };
        self.intervals.iter().zip(self.counts).map(of).collect()
    }
}

/// ∫ f' cos kφ dφ of the slope f' of a profile over an interval, for the k of its terms, and first for k = 0 beside x = 0.
fn tests(profile: &Profile, interval: &Interval, count: usize) -> Vec<f64> {
    let value = |[value, ..]: [f64; 3]| value;
    if interval.is_central() {
        let rows = profile.rows(Span::even(interval.half), count).rows.into_iter();
        return rows.map(value).enumerate().map(|(m, value)| alternating(m) * value).collect();
    }
    profile.rows(Span::anywhere(interval.middle, interval.half), count + 1).rows.into_iter().map(value).collect()
}

/// How much of the first column the test of a closing contains.
fn resultant_of_closing([from, to]: [f64; 2]) -> f64 {
    let half = 0.5 * (to - from);
    (to * to - from * from) / (PI * half * half)
}

/// cos z − 1.
fn cosine_minus_one(z: f64) -> f64 {
    let sine = (0.5 * z).sin();
    -2.0 * sine * sine
}

/// (1 + a)(1 + b) − 1.
fn less_one(a: f64, b: f64) -> f64 {
    a + b + a * b
}
