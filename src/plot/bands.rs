//! A quantity over a plane in bands of colour, and the scale that says which colour is which value.
use super::chart::upright_axis;
use super::contour::rings;
use super::file::PlotError;
use super::picture::{Anchor, Colour, Picture};
use super::scale::{Scale, short};
use super::style::{Colours, INK, NEUTRAL, hair};

/// Fewest bands of colour, and how many there are where ratios are equal.
const BANDS: usize = 10;
const RATIOS: usize = 12;
/// Width of the scale of colours, in points.
pub(super) const BAR: f64 = 12.0;
/// Values below this part of the largest are zero, however small their error is.
const ZERO: f64 = 1e-9;
/// A line of zeros is drawn where both signs occur within this number of grid places from it, on either side of the two places between which it
/// lies: the line may pass through places where the value is 0.
const BESIDE: usize = 1;

/// How a map is coloured. By default colours go from light to dark where values have one sign, and are symmetric about zero where they have two.
///
/// ```
/// use recede::plot::{Colours, MapStyle};
/// let style = MapStyle { colours: Some(Colours::Viridis), levels: Some(20), ..MapStyle::default() };
/// assert!(style.range.is_none() && !style.is_logarithmic);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MapStyle {
    /// The values at which colours begin and end, in the unit of the quantity; beyond them they do not change.
    pub range: Option<[f64; 2]>,
    /// Whether equal ratios of values, not equal differences, have equally many colours.
    pub is_logarithmic: bool,
    /// How many colours there are.
    pub levels: Option<usize>,
    /// Which.
    pub colours: Option<Colours>,
}

impl MapStyle {
    /// The scale of colours between these ends, unless the style has others; an error if it is logarithmic and they are not positive.
    pub(super) fn scale(&self, ends: [f64; 2]) -> Result<Scale, PlotError> {
        let ends = self.range.unwrap_or(ends);
        let scale = Scale::around(ends);
        if self.is_logarithmic && scale.ends().0 <= 0.0 {
            let [from, to] = ends.map(short);
            let message = format!("logarithmic colours need values > 0, found {from} to {to}: give a range > 0");
            return Err(PlotError::Drawing(message));
        }
        Ok(if self.is_logarithmic { scale.logarithmic() } else { scale })
    }
}

/// Bands of a quantity and their colours.
pub(super) struct Bands {
    scale: Scale,
    colours: Colours,
    /// Where bands meet.
    edges: Vec<f64>,
    /// The value below which no sign is known; `None` if colours do not tell the sign.
    unknown: Option<f64>,
}

impl Bands {
    /// For values between the ends of a scale, in a style without a range. Values of two signs that are right to `error` have colours on both sides of a
    /// neutral zero.
    pub(super) fn new(scale: Scale, error: Option<f64>, style: &MapStyle) -> Self {
        let (low, high) = scale.ends();
        let default = if error.is_some() { Colours::RedBlue } else { Colours::Magma };
        let colours = style.colours.unwrap_or(default);
        let scale = match style.range {
            None if colours.are_signed() => scale.with(-low).with(-high).rounded(),
            None => scale.rounded(),
            Some(_) => scale,
        };
        let (low, high) = scale.ends();
        let ticks: Vec<f64> = scale.ticks().iter().map(|tick| tick.value).collect();
        let step = ticks.windows(2).map(|pair| pair[1] - pair[0]).next().unwrap_or(high - low);
        let parts = (1..5).find(|parts| parts * (ticks.len().max(2) - 1) >= BANDS).unwrap_or(4);
        let even = if style.is_logarithmic { RATIOS } else { ((high - low) * parts as f64 / step).round() as usize };
        let count = style.levels.unwrap_or(even);
        let largest = low.abs().max(high.abs());
        let at = |i: usize| scale.value(i as f64 / count as f64);
        let edge = |i: usize| Some(at(i)).filter(|edge| edge.abs() > ZERO * largest).unwrap_or(0.0);
        // a band that is as wide as the error has no sign of its own
        let unknown = error.filter(|_| colours.are_signed()).map(|error| error.clamp(ZERO * largest, at(1) - at(0)));
        Self { edges: (1..count).map(edge).collect(), scale, colours, unknown }
    }

    /// The colour of a band; 0 is the lowest.
    fn colour(&self, index: usize) -> Colour {
        let (low, high) = self.scale.ends();
        if !self.colours.are_signed() {
            let share = index as f64 / self.edges.len().max(1) as f64;
            // dark where the magnitude is large
            return self.colours.at(if high <= 0.0 { 1.0 - share } else { share });
        }
        let from = index.checked_sub(1).map_or(low, |below| self.edges[below]);
        let to = self.edges.get(index).copied().unwrap_or(high);
        self.colours.at(0.5 * (from + to) / low.abs().max(high.abs()))
    }

    /// Values on a grid, row by row: from the lowest band up, each over all that is higher, so no seams remain. Nothing where the value is not
    /// a number. A quantity that may have both signs is neutral where it is less than its error, and has a line where it changes its sign by
    /// more than that.
    pub(super) fn draw(
        &self,
        picture: &mut Picture,
        [xs, ys]: [&[f64]; 2],
        values: &[f64],
        place: impl Fn((f64, f64)) -> (f64, f64),
    ) {
        let (low, high) = self.scale.ends();
        let clamped: Vec<f64> = values.iter().map(|value| value.clamp(low, high)).collect();
        let within = |(x, y): (f64, f64)| place((between(xs, x), between(ys, y)));
        let above = |edge: f64, colour: Colour, picture: &mut Picture| {
            let rings = rings(&clamped, xs.len(), edge).into_iter();
            let rings: Vec<Vec<_>> = rings.map(|ring| ring.into_iter().map(within).collect()).collect();
            if !rings.is_empty() {
                picture.rings(rings, colour);
            }
        };
        let edges = [f64::NEG_INFINITY].into_iter().chain(self.edges.iter().copied());
        for (index, edge) in edges.enumerate() {
            match self.unknown.filter(|_| edge == 0.0) {
                Some(unknown) => {
                    above(-unknown, NEUTRAL, picture);
                    above(unknown, self.colour(index), picture);
                }
                None => above(edge, self.colour(index), picture),
            }
        }
        if let Some(unknown) = self.unknown.filter(|_| low < 0.0 && high > 0.0) {
            let known: Vec<f64> =
                clamped.iter().map(|value| if value.abs() < unknown { 0.0 } else { *value }).collect();
            for line in rings(&known, xs.len(), 0.0).iter().flat_map(|ring| lines(ring, &known, xs.len())) {
                picture.line(&line.into_iter().map(within).collect::<Vec<_>>(), hair(INK));
            }
        }
    }

    /// The scale of colours, from the left upper corner down.
    pub(super) fn bar(&self, picture: &mut Picture, (left, top): (f64, f64), bottom: f64) {
        let right = left + BAR;
        let height = |value: f64| bottom - self.scale.share(value) * (bottom - top);
        for index in 0..=self.edges.len() {
            let from = if index == 0 { bottom } else { height(self.edges[index - 1]) };
            picture.rectangle((left, from), (right, top), self.colour(index));
        }
        let corners = [(left, top), (right, top), (right, bottom), (left, bottom), (left, top)];
        picture.line(&corners, hair(INK));
        upright_axis(picture, &self.scale, [right, top, bottom], Anchor::Left);
    }
}

/// The pieces of a ring around the values that are not negative on a grid with this number of columns: those that do not run along its
/// border, and have both signs beside them.
fn lines(ring: &[(f64, f64)], values: &[f64], columns: usize) -> Vec<Vec<(f64, f64)>> {
    let rows = values.len() / columns;
    let on_border = |a: f64, b: f64, count: usize| a == b && (a == 0.0 || a == (count - 1) as f64);
    let beside = |at: f64, count: usize| {
        (at.floor() as usize).saturating_sub(BESIDE)..(at.ceil() as usize + BESIDE + 1).min(count)
    };
    let signs = |(x, y): (f64, f64)| {
        let values =
            || beside(y, rows).flat_map(|row| beside(x, columns).map(move |column| values[row * columns + column]));
        values().any(|value| value < 0.0) && values().any(|value| value > 0.0)
    };
    let is_left_out = |(from, to): &(&(f64, f64), &(f64, f64))| {
        on_border(from.0, to.0, columns) || on_border(from.1, to.1, rows) || !signs(**from) || !signs(**to)
    };
    let pieces: Vec<_> = ring.iter().zip(ring.iter().cycle().skip(1)).collect();
    let lines = pieces.split(is_left_out).filter(|line| !line.is_empty());
    lines
        .map(|line| line[..1].iter().map(|(from, _)| **from).chain(line.iter().map(|(_, to)| **to)).collect())
        .collect()
}

/// The value at a place between the values of a list.
fn between(list: &[f64], at: f64) -> f64 {
    let last = list.len() - 1;
    let at = at.clamp(0.0, last as f64);
    let below = (at as usize).min(last.saturating_sub(1));
    let share = at - below as f64;
    list[below] + share * (list[(below + 1).min(last)] - list[below])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_is_neutral_and_signs_have_colours_of_their_own() {
        let signed = |share: f64| Colours::RedBlue.at(share);
        let bands = Bands::new(Scale::around([-1.0, 3.0]), Some(0.0), &MapStyle::default());
        assert_eq!(bands.scale.ends(), (-3.0, 3.0));
        assert!(bands.edges.contains(&0.0));
        let zero = bands.edges.iter().position(|edge| *edge == 0.0).unwrap();
        let (below, above) = (bands.colour(zero), bands.colour(zero + 1));
        assert!(below.b > below.r && above.r > above.b, "{below:?} {above:?}");
        assert_eq!(signed(0.0), NEUTRAL);
        let [violet, orange] = [-1.0, 1.0].map(|share| Colours::PurpleOrange.at(share));
        assert!(violet.b > violet.r && orange.r > orange.b, "{violet:?} {orange:?}");
        let grey = NEUTRAL.r.max(NEUTRAL.g).max(NEUTRAL.b) - NEUTRAL.r.min(NEUTRAL.g).min(NEUTRAL.b);
        assert!(grey < 8, "{NEUTRAL:?}");
        // equal values of both signs are equally dark
        let light = |c: Colour| 0.3 * f64::from(c.r) + 0.6 * f64::from(c.g) + 0.1 * f64::from(c.b);
        for share in [0.25, 0.5, 1.0] {
            assert!((light(signed(share)) - light(signed(-share))).abs() < 40.0, "{share}");
            assert!(light(signed(share)) < light(signed(0.8 * share)), "{share}");
        }
    }

    #[test]
    fn one_sign_goes_from_light_to_dark() {
        let light = |c: Colour| u32::from(c.r) + u32::from(c.g) + u32::from(c.b);
        for (ends, style) in [
            ([0.0, 5.0], MapStyle::default()),
            ([0.01, 5.0], MapStyle { is_logarithmic: true, ..MapStyle::default() }),
            ([1.0, 5.0], MapStyle { levels: Some(7), range: Some([1.0, 5.0]), ..MapStyle::default() }),
        ] {
            for (_, colours) in Colours::NAMED.into_iter().filter(|(_, colours)| !colours.are_signed()) {
                let style = MapStyle { colours: Some(colours), ..style };
                let of = |ends: [f64; 2]| {
                    let scale = Scale::around(ends);
                    Bands::new(if style.is_logarithmic { scale.logarithmic() } else { scale }, None, &style)
                };
                let bands = of(ends);
                let colours: Vec<u32> = (0..=bands.edges.len()).map(|index| light(bands.colour(index))).collect();
                assert!(colours.is_sorted_by(|a, b| a > b), "{style:?}: {colours:?}");
                assert!(bands.edges.is_sorted() && style.levels.is_none_or(|count| colours.len() == count));
                let ratios: Vec<f64> = bands.edges.windows(2).map(|pair| pair[1] / pair[0]).collect();
                assert!(!style.is_logarithmic || ratios.iter().all(|ratio| (ratio / ratios[0] - 1.0).abs() < 1e-9));
                if !style.is_logarithmic {
                    let below = of(ends.map(|end| -end));
                    assert!(light(below.colour(0)) < light(below.colour(below.edges.len())));
                }
            }
        }
    }

    /// The lines of zero of values on a grid, which are right to an error.
    fn drawn(values: &[f64], [xs, ys]: [&[f64]; 2], error: f64) -> Vec<String> {
        let mut picture = Picture::new(8.0, 4.0);
        let bands = Bands::new(Scale::around(values.iter().copied()), Some(error), &MapStyle::default());
        bands.draw(&mut picture, [xs, ys], values, |at| at);
        picture.svg().lines().filter(|line| line.contains("fill=\"none\"")).map(str::to_owned).collect()
    }

    #[test]
    fn the_line_of_zero_leaves_the_border_out() {
        let lines = drawn(&[-1.0, 1.0, 1.0, -1.0, 1.0, 1.0], [&[0.0, 1.0, 2.0], &[0.0, 1.0]], 0.0);
        assert_eq!(lines.len(), 1);
        assert!(lines[0].contains("d=\"M0.5 ") && !lines[0].contains(" 2 "), "{lines:?}");
    }

    /// Where a quantity has fallen below its error, its sign is rounding: left of the middle it changes its sign at y = 2 by much, right of
    /// it by less than the error from place to place.
    #[test]
    fn the_line_of_zero_ends_where_values_are_below_their_error() {
        let (xs, ys): (Vec<f64>, Vec<f64>) = ((0..9).map(f64::from).collect(), (0..5).map(f64::from).collect());
        let value = |i: usize, j: usize| match i {
            0..4 => j as f64 - 2.0,
            4 => 1e-3 * (j as f64 - 2.0),
            _ if (i * 7 + j * 3) % 5 < 2 => -1e-5,
            _ => 1e-5,
        };
        let values: Vec<f64> = (0..5).flat_map(|j| (0..9).map(move |i| value(i, j))).collect();
        let known = drawn(&values, [&xs, &ys], 1e-4);
        assert!(known.len() == 1 && known[0].contains("d=\"M0 2"), "{known:?}");
        assert!(!["6 ", "7 ", "8 "].iter().any(|x| known[0].contains(x)), "{known:?}");
        assert!(drawn(&values, [&xs, &ys], 0.0).len() > 1);
    }
}
