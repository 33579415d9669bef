//! The largest pressure of a contact.
use super::{Contact, Form, Strip};

/// A strip is looked at in this many places for each term of its series: the highest term is seen at three places of each of its
/// arches. Between them the largest pressure is found by golden sections.
const PER_TERM: usize = 3;
/// In no fewer places, and in no more: the last terms of long series belong to corners, and fall.
const PLACES: [usize; 2] = [24, 192];
/// Golden sections: the place is found to a millionth of the distance of two places, the pressure to the square of that.
const SECTIONS: usize = 28;
const GOLDEN: f64 = 0.618_033_988_749_894_8;

/// The largest pressure of a contact, in the units of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// The pressure (compression positive); infinite under the tip of a wedge, at sharp corners, and under a line load.
    pub pressure: f64,
    /// The solver's estimate of its absolute error; 0 if it is infinite.
    pub error: f64,
    /// Where it is; of a contact that is its own mirror image in the middle or on the right of it, since the pressure is the same on the left.
    pub x: f64,
    /// How far off that may be: a pressure that hardly varies about its largest value says little of the place.
    pub x_error: f64,
}

/// The place between two others where a function is largest, and its value there; `seen` is what is known already.
fn highest(function: &dyn Fn(f64) -> f64, mut from: f64, mut to: f64, seen: (f64, f64)) -> (f64, f64) {
    let mut inner = [to - GOLDEN * (to - from), from + GOLDEN * (to - from)];
    let mut values = inner.map(function);
    for _ in 0..SECTIONS {
        if values[0] > values[1] {
            to = inner[1];
            inner = [to - GOLDEN * (to - from), inner[0]];
            values = [function(inner[0]), values[0]];
        } else {
            from = inner[0];
            inner = [inner[1], from + GOLDEN * (to - from)];
            values = [values[1], function(inner[1])];
        }
    }
    let found = if values[0] > values[1] { (inner[0], values[0]) } else { (inner[1], values[1]) };
    if found.1 > seen.1 { found } else { seen }
}

/// How far from x a function is still as large as there but for an error; as far as `most`.
fn flat(function: &dyn Fn(f64) -> f64, x: f64, largest: f64, error: f64, most: f64) -> f64 {
    let enough = largest - error.max(f64::EPSILON * largest);
    let mut step = 1e-8 * most;
    while step < most && (function(x - step) > enough || function(x + step) > enough) {
        step *= 2.0;
    }
    step.min(most)
}

impl Strip {
    /// Places inside a strip, dense next to its ends.
    fn places(&self) -> impl Iterator<Item = f64> {
        let terms = self.coefficients.len().max(self.skew.len());
        let count = if self.form == Form::Uniform { 2 } else { (PER_TERM * terms).clamp(PLACES[0], PLACES[1]) };
        let place = move |k: usize| self.at - self.extent * (std::f64::consts::PI * k as f64 / count as f64).cos();
        (1..count).map(place)
    }
}

impl Contact {
    /// The largest pressure anywhere in the contact, and where it is.
    ///
    /// ```
    /// use recede::{HalfPlane, Model, Plane, Punch, Stack};
    /// let stack = Stack::builder(Plane::Strain).layer(HalfPlane::new(1.0, 0.25)?).build()?;
    /// let solution = Model::new(stack)?.press(&Punch::rounded_flat(0.5, 20.0)?, 0.05)?;
    /// let (contact, peak) = (&solution.contacts()[0], solution.contacts()[0].peak());
    /// // beyond where the flat part ends
    /// assert!(peak.pressure > 1.2 * contact.central_pressure && peak.x > 0.5);
    /// # Ok::<(), recede::Error>(())
    /// ```
    pub fn peak(&self) -> Peak {
        // of what is even the right half is looked at
        let first = self.about.unwrap_or(f64::NEG_INFINITY);
        // a tip comes before corners, and a right corner before a left one
        let infinite = self.strips.iter().filter_map(|strip| strip.singular_points().last());
        if let Some(x) = infinite.map(|(x, _)| x).filter(|x| *x >= first).reduce(f64::min) {
            // a corner is where the contact ends, but for rounding
            let mut ends = self.intervals.iter().flat_map(|interval| [interval.left, interval.right]);
            let x = ends.find(|end| (end - x).abs() <= 4.0 * f64::EPSILON * self.reach()).unwrap_or(x);
            return Peak { pressure: f64::INFINITY, error: 0.0, x, x_error: 0.0 };
        }
        let pressure = |x: f64| self.pressure(x);
        let [known, middle_error] = self.middle_pressure;
        let middle = self.about.map_or(f64::NEG_INFINITY, pressure);
        let mut best = (first, middle);
        let by_rounding = 1.0 + 4.0 * f64::EPSILON;
        let mut around = None;
        // where strips overlap, or one lies within another as in a ring, the sum may be largest away from the middles of both
        let all = self.strips.iter().flat_map(Strip::places).chain(self.between_ends());
        let mut places: Vec<f64> = all.filter(|x| *x > first).collect();
        places.sort_by(f64::total_cmp);
        places.dedup_by(|next, before| *next - *before <= self.rounding());
        for (k, x) in places.iter().enumerate() {
            let here = pressure(*x);
            if here > best.1.max(0.0) * by_rounding {
                best = (*x, here);
                around = Some([places[k.saturating_sub(1)], *places.get(k + 1).unwrap_or(x)]);
            }
        }
        if let Some([left, right]) = around {
            best = highest(&pressure, left, right, best);
        }
        let (x, largest) = best;
        if x == first {
            return Peak { pressure: known, error: middle_error, x, x_error: 0.0 };
        }
        // the series is wrong elsewhere as it is seen to be in the middle
        let seen = if self.about.is_some() { (middle - known).abs() } else { 0.0 };
        let error = middle_error + self.truncation().max(seen) + largest * self.end_error();
        let x_error = flat(&pressure, x, largest, error, self.half_span());
        Peak { pressure: largest, error, x, x_error }
    }

    /// Places that are as near to each other as this are one but for rounding.
    fn rounding(&self) -> f64 {
        1e-9 * self.half_span()
    }

    /// The middles between the ends of strips next to each other. Where one strip ends and the next begins they may overlap by rounding, and the sum of both is no pressure.
    fn between_ends(&self) -> impl Iterator<Item = f64> {
        let mut ends: Vec<f64> = self.strips.iter().flat_map(Strip::ends).collect();
        ends.sort_by(f64::total_cmp);
        ends.dedup_by(|next, before| *next - *before <= self.rounding());
        (1..ends.len()).map(move |k| 0.5 * (ends[k - 1] + ends[k]))
    }

    /// What is missing of the series of the pressure, by how its last terms fall.
    fn truncation(&self) -> f64 {
        let of = |strip: &Strip| {
            let terms = &strip.coefficients;
            let size = |from: usize, to: usize| terms[from..to].iter().map(|c| c.abs()).sum::<f64>();
            let (half, rest) = (terms.len() / 2, 3 * terms.len() / 4);
            let (third, fourth) = (size(half, rest), size(rest, terms.len()));
            let fall = (fourth / third).min(0.9);
            if strip.form != Form::Series || fourth == 0.0 || third == 0.0 { 0.0 } else { fourth * fall / (1.0 - fall) }
        };
        self.strips.iter().map(of).fold(0.0, f64::max)
    }

    /// The largest of the last terms of the series of the pressure: next to graded faces they hardly fall from one to the next.
    pub(crate) fn last_term(&self) -> f64 {
        let last = |strip: &Strip| {
            let terms = &strip.coefficients;
            terms[terms.len().saturating_sub(6)..].iter().fold(0.0, |most: f64, c| most.max(c.abs()))
        };
        // of a pressure that is given none is missing
        let is_found = self.middle_pressure[1] > 0.0;
        self.strips.iter().filter(|strip| is_found && strip.form == Form::Series).map(last).fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solution::{Interface, Interval};

    /// Elements, each with a constant pressure, that overlap by some rounding errors.
    #[test]
    fn the_pressures_of_elements_next_to_each_other_do_not_add_up() {
        for count in 2..60 {
            let end = |k: usize| 0.1 * (k as f64).powf(1.3);
            let element = |k: usize| {
                let [from, to] = [end(k), end(k + 1)];
                let pressure = 1.0 / (1 + k) as f64;
                let extent = 0.5 * (to - from) + 8.0 * f64::EPSILON * to;
                let strip = Strip::series(extent, vec![4.0 / std::f64::consts::PI * pressure]);
                Strip { at: 0.5 * (from + to), form: Form::Uniform, ..strip }
            };
            let strips: Vec<Strip> = (0..count).map(element).collect();
            let first = strips[0].pressure(strips[0].at);
            let whole = vec![Interval::new([0.0; 2], [end(count), 0.0])];
            let peak = Contact::new(Interface::Punch, whole, strips, None, [first, 0.0], Vec::new()).peak();
            assert!((peak.pressure / first - 1.0).abs() < 1e-12, "{count}: {peak:?} {first}");
        }
    }
}
