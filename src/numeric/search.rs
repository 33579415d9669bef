//! Searches along x: where a condition begins to hold, and where a function is least that is known at places.
use super::chebyshev::{Series, points};
use super::longest;

/// Halvings down to rounding.
const HALVINGS: usize = 60;
/// Functions are looked at by distances that differ by this factor.
const NEARER: f64 = 8.0;
/// The growth of steps between places with the distance to the next end.
const FARTHER: f64 = 0.1;
/// Values about a low are resolved where they differ by less than this from the next ones, which are brought closer together so often.
const RESOLVED: f64 = 0.25;
const CLOSER: usize = 6;
/// Lows that are less than this part of the lowest value are not looked at from nearby.
const NEARLY: f64 = 0.5;
/// The number of places in a low through whose values a polynomial goes: it is right to rounding there.
const POINTS: usize = 16;

/// The place between two others from which on a condition holds.
pub(crate) fn begins([mut from, mut to]: [f64; 2], holds: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (from + to);
        if holds(middle) { to = middle } else { from = middle }
    }
    0.5 * (from + to)
}

/// What finds values of a function, by the distances from x = 0 at which it does so, the farthest first: near what presses shorter waves matter than far from there.
pub(crate) struct ByDistance<T>(Vec<(f64, T)>);

impl<T> ByDistance<T> {
    /// For distances up to the farthest one, by smaller ones until one of them leaves out nothing that matters nearer to x = 0, or is as small as the smallest asked for.
    pub(crate) fn new<E>(farthest: f64, smallest: f64, of: impl Fn(f64) -> Result<(T, bool), E>) -> Result<Self, E> {
        let (mut all, mut distance) = (Vec::new(), farthest);
        loop {
            let (own, is_whole) = of(distance)?;
            all.push((distance, own));
            if is_whole || distance <= smallest {
                return Ok(Self(all));
            }
            distance /= NEARER;
        }
    }

    /// The same at all distances.
    pub(crate) fn of(own: T) -> Self {
        Self(vec![(f64::INFINITY, own)])
    }

    /// What is found from each.
    pub(crate) fn map<'a, U>(&'a self, of: impl Fn(&'a T) -> U) -> ByDistance<U> {
        ByDistance(self.0.iter().map(|(distance, own)| (*distance, of(own))).collect())
    }

    fn number(&self, x: f64) -> usize {
        self.0.iter().rposition(|(distance, _)| x.abs() <= *distance).unwrap_or(0)
    }

    /// What finds values at x.
    pub(crate) fn near(&self, x: f64) -> &T {
        &self.0[self.number(x)].1
    }

    /// The values at places.
    pub(crate) fn values(&self, places: &[f64], of: impl Fn(&T, &[f64]) -> Vec<f64>) -> Vec<f64> {
        let some = places.chunk_by(|a, b| self.number(*a) == self.number(*b));
        some.flat_map(|some| of(self.near(some[0]), some)).collect()
    }
}

/// Places from one to another, dense next to some ends.
pub(crate) fn places([from, to]: [f64; 2], ends: &[f64], shortest: f64) -> Vec<f64> {
    let mut places = vec![from];
    while let Some(last) = places.last().copied().filter(|last| *last < to) {
        let nearest = ends.iter().map(|end| (last - end).abs()).fold(f64::INFINITY, f64::min);
        places.push((last + shortest.max(FARTHER * nearest)).min(to));
    }
    places
}

/// Values of a function that is next to zero far away, in a unit in which small parts of 1 mean nothing, at places in ascending order.
pub(crate) struct Samples {
    places: Vec<f64>,
    values: Vec<f64>,
}

/// A least value, its place, and the neighbours between which it was found: the place itself where it is known exactly.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Low {
    pub(crate) value: f64,
    pub(crate) place: f64,
    pub(crate) ends: [f64; 2],
}

impl Low {
    /// The least value of a function between two places next to each other, from the polynomial through its values.
    pub(crate) fn between([from, to]: [f64; 2], of: impl Fn(&[f64]) -> Vec<f64>) -> Self {
        let place = || {
            let slope = Series::from_values_at_points(from, to, &of(&points(from, to, POINTS))).derivative();
            begins([from, to], |x| slope.eval(x) > 0.0)
        };
        let place = if from < to { place() } else { from };
        Self { value: of(&[place])[0], place, ends: [from, to] }
    }
}

impl Samples {
    /// The values at some places, and at others between these until values about each low differ by little; where nothing is known is left out.
    pub(crate) fn new(places: Vec<f64>, of: impl Fn(&[f64]) -> Vec<f64>, is_known: impl Fn([f64; 2]) -> bool) -> Self {
        let places: Vec<f64> = places.into_iter().filter(|x| is_known([*x, *x])).collect();
        let mut own = Self { values: of(&places), places };
        for _ in 0..CLOSER {
            let Self { places, values } = &own;
            let is_coarse =
                |k: &usize| (values[*k] - values[k + 1]).abs() > RESOLVED && (own.is_low(*k) || own.is_low(k + 1));
            let between = (1..places.len()).map(|k| k - 1).filter(is_coarse).map(|k| 0.5 * (places[k] + places[k + 1]));
            let more: Vec<f64> = between.filter(|x| is_known([*x, *x])).collect();
            if more.is_empty() {
                break;
            }
            let values = of(&more);
            own.add(more.into_iter().zip(values));
        }
        own
    }

    fn add(&mut self, more: impl Iterator<Item = (f64, f64)>) {
        let before = self.places.drain(..).zip(self.values.drain(..));
        let mut all: Vec<(f64, f64)> = before.chain(more).collect();
        all.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        (self.places, self.values) = all.into_iter().unzip();
    }

    /// Whether a value is negative and no neighbour is less.
    fn is_low(&self, k: usize) -> bool {
        let beside = [k.saturating_sub(1), (k + 1).min(self.places.len() - 1)];
        self.values[k] < 0.0 && beside.iter().all(|beside| self.values[k] <= self.values[*beside])
    }

    /// The least value, from nearby. What is even is flat at x = 0, its first place.
    pub(crate) fn lowest(&mut self, of: impl Fn(&[f64]) -> Vec<f64>, is_known: impl Fn([f64; 2]) -> bool) -> Low {
        let Self { places, values } = &*self;
        let least = (0..places.len()).min_by(|a, b| values[*a].total_cmp(&values[*b])).unwrap_or(0);
        let mut lowest = Low { value: values[least], place: places[least], ends: [places[least]; 2] };
        let last = places.len() - 1;
        for k in (1..last).filter(|k| self.is_low(*k) && values[*k] <= NEARLY * values[least]) {
            let ends = [places[k - 1], places[k + 1]];
            let low = if is_known(ends) { Low::between(ends, &of) } else { lowest };
            // the place itself is not as well known
            if low.value < lowest.value || (low.value <= lowest.value && k == least) {
                lowest = low;
            }
        }
        if lowest.ends[0] < lowest.ends[1] {
            self.add([(lowest.place, lowest.value)].into_iter());
        }
        lowest
    }

    /// The largest absolute value.
    pub(crate) fn largest(&self) -> f64 {
        longest(self.values.iter().copied())
    }

    /// From where to where values about a low one are below a level: next to the low they are like a parabola, and like a line between other places.
    pub(crate) fn below(&self, level: f64, low: &Low) -> [f64; 2] {
        let after = self.places.partition_point(|place| *place <= low.place);
        let ends = |outwards: &mut dyn Iterator<Item = usize>| {
            let mut inner = (low.place, low.value);
            for k in outwards {
                let value = self.values[k];
                if value >= level {
                    let part = (level - inner.1) / (value - inner.1);
                    let part = if inner.0 == low.place { part.sqrt() } else { part };
                    return inner.0 + part * (self.places[k] - inner.0);
                }
                inner = (self.places[k], value);
            }
            inner.0
        };
        [ends(&mut (0..after).rev()), ends(&mut (after..self.places.len()))]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lower_one_of_two_lows_is_found_to_rounding() {
        // two lows of which the higher one is seen as the lower one by the places
        let f = |x: f64| -0.9 * (-2.0 * (x - 1.03) * (x - 1.03)).exp() - (-(x - 4.3) * (x - 4.3)).exp();
        let of = |places: &[f64]| places.iter().map(|x| f(*x)).collect::<Vec<f64>>();
        let mut samples = Samples::new(places([-10.0, 10.0], &[1.0], 0.5), of, |_| true);
        let low = samples.lowest(of, |_| true);
        // the other term's slope there is e^(−2·3.27²)
        assert!((low.place - 4.3).abs() < 1e-8 && (low.value + 1.0).abs() < 1e-8, "{low:?}");
        let fine = Low::between([low.place - 0.1, low.place + 0.1], of);
        assert!((fine.place - low.place).abs() < 1e-12, "{fine:?} {low:?}");
        // e^(−s²) = 1/2
        let [from, to] = samples.below(-0.5, &low);
        assert!((4.3 - from - 0.8326).abs() < 0.05 && (to - 4.3 - 0.8326).abs() < 0.05, "{from} {to}");
    }

    #[test]
    fn a_condition_begins_where_it_does() {
        assert!((begins([0.0, 2.0], |x| x * x > 2.0) - 2f64.sqrt()).abs() < 1e-15);
    }
}
