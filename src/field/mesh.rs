//! Pieces of the layers, and the stresses at the Chebyshev points of each.
use super::body::Rows;
use super::error::FieldError;
use super::pressure::ContactPressure;
use super::waves::Precision;
use super::{Field, FieldPoint};
use crate::numeric::chebyshev;

/// Points of a piece along x and in depth; an odd number has one in the middle.
pub(super) const POINTS: usize = 5;
/// Longest piece: these parts of half the distance from the end of a load to the next along x, or of the shortest one in depth, and this many
/// times the distance from the ends, or from the loaded face. Half as long, searches take twice as long and find the same.
const LONGEST: [f64; 2] = [0.5, 1.0];
const GROWTH: f64 = 3.0;
/// Pieces that are shorter than this part of their distance from 0 are left out: their ends are the same but for rounding, or the ends of a
/// load that ends abruptly, of which stresses have limits from either side.
const ROUNDED: f64 = 1e-9;
/// Layers are searched to this number of half-lengths beyond the ends of their loads or, where stresses far from loads are wanted, to this
/// number of bending lengths, as far as a stiff layer on soft ones distributes loads; half-planes down to this number of half-lengths of the
/// longest contact, or thicknesses of what lies on them. A stress that grows there is followed.
const BESIDE: f64 = 0.5;
const BEYOND: f64 = 4.0;
const DEEP: f64 = 3.0;
/// Where a pressure jumps stresses depend on the direction: they are searched to this part of the narrowest load from there.
const CLOSE: f64 = 1e-8;

/// Two values: one for x, and one for the depth below the top face of a layer.
pub(super) type Pair<T> = [T; 2];

/// A rectangle of a layer, or a part of its lower face.
#[derive(Clone, Copy, Debug)]
pub(super) struct LayerPiece {
    pub(super) layer: usize,
    pub(super) ends: Pair<[f64; 2]>,
    /// The ends of the part of the layer in which stresses are as smooth as here.
    pub(super) smooth: Pair<[f64; 2]>,
}

impl LayerPiece {
    pub(super) fn holds(&self, place: Pair<f64>) -> bool {
        self.ends.iter().zip(place).all(|([from, to], at)| *from <= at && at <= *to)
    }

    /// Whether stresses on both sides of a place are known, along x and in depth: it is not on an edge beyond which they are as smooth as here.
    pub(super) fn has_inside(&self, place: Pair<f64>) -> Pair<bool> {
        let goes_on = |axis: usize, side: usize| {
            place[axis] == self.ends[axis][side] && self.ends[axis][side] != self.smooth[axis][side]
        };
        [0, 1].map(|axis| !goes_on(axis, 0) && !goes_on(axis, 1))
    }

    /// A piece alone, to be sampled, whose points are no farther from a place than this.
    pub(super) fn about(&self, place: Pair<f64>, reach: Pair<f64>) -> Pieces {
        let intervals = [0, 1].map(|axis| {
            let [first, last] = self.smooth[axis];
            vec![[[(place[axis] - reach[axis]).max(first), (place[axis] + reach[axis]).min(last)], [first, last]]]
        });
        Pieces { layer: self.layer, intervals }
    }
}

/// Neighbouring pieces of a layer: along x and in depth the ends of intervals, and of those in which stresses are smooth.
pub(super) struct Pieces {
    layer: usize,
    intervals: Pair<Vec<[[f64; 2]; 2]>>,
}

/// The stresses at the points of a piece, row by row from the top down.
pub(super) struct PieceSample {
    pub(super) piece: LayerPiece,
    pub(super) points: Vec<Vec<FieldPoint>>,
}

type Ranges = Vec<std::ops::Range<usize>>;

/// The points of neighbouring intervals, and the range of each interval among them.
fn points(intervals: &[[[f64; 2]; 2]]) -> (Vec<f64>, Ranges) {
    let (mut points, mut ranges) = (Vec::new(), Vec::new());
    for [[from, to], _] in intervals {
        let shared = usize::from(points.last() == Some(from));
        let count = if from < to { POINTS } else { 1 };
        ranges.push(points.len() - shared..points.len() - shared + count);
        points.extend(chebyshev::points(*from, *to, count).into_iter().skip(shared));
    }
    (points, ranges)
}

impl PieceSample {
    /// The stresses in all of these pieces, from one sum over wavenumbers; for each of the arguments a list.
    pub(super) fn all(field: &Field, all: &[Pieces], precision: &Precision) -> Result<Vec<Vec<Self>>, FieldError> {
        let (mut rows, mut ranges) = (Rows::default(), Vec::new());
        for Pieces { layer, intervals } in all {
            let [(xs, along), (depths, down)] = [0, 1].map(|axis| points(&intervals[axis]));
            ranges.push((rows.add(*layer, &depths, xs), along, down));
        }
        let rows = field.at_places(&rows, precision)?;
        let samples = |(Pieces { layer, intervals }, (first, along, down)): (&Pieces, (usize, Ranges, Ranges))| {
            let mut samples = Vec::with_capacity(along.len() * down.len());
            for ([down_ends, down_smooth], in_rows) in intervals[1].iter().zip(down) {
                let rows = &rows[first..][in_rows];
                for ([ends, smooth], range) in intervals[0].iter().zip(&along) {
                    let piece =
                        LayerPiece { layer: *layer, ends: [*ends, *down_ends], smooth: [*smooth, *down_smooth] };
                    samples.push(Self { piece, points: rows.iter().map(|row| row[range.clone()].to_vec()).collect() });
                }
            }
            samples
        };
        Ok(all.iter().zip(ranges).map(samples).collect())
    }
}

impl Pieces {
    /// All that is searched, the surroundings of the loads only if `is_near`.
    pub(super) fn all(field: &Field, is_near: bool) -> Vec<Self> {
        let mut all: Vec<Self> = (0..field.layers.len()).map(|layer| Self::of_layer(field, layer, is_near)).collect();
        // about the places of the top face at which a pressure jumps
        let near = CLOSE * field.narrowest();
        let about = |at: f64| {
            let along = [[at - near, at], [at, at + near]].map(|ends| [ends; 2]).to_vec();
            Self { layer: 0, intervals: [along, vec![[[0.0, near]; 2]]] }
        };
        all.extend(field.pressures.first().into_iter().flat_map(ContactPressure::jumps).map(about));
        all
    }

    fn of_layer(field: &Field, layer: usize, is_near: bool) -> Self {
        let placed = &field.layers[layer];
        let body = &field.bodies[placed.body];
        let (longest, bottom) = (field.longest(), placed.thickness.unwrap_or(f64::INFINITY));
        // cuts; and the ends of loads, and the loaded faces, with a length
        let (mut cuts, mut features, mut faces) = (Vec::new(), Vec::new(), Vec::new());
        for (side, face) in [Some(body.top), body.bottom].into_iter().flatten().enumerate() {
            let pressure = &field.pressures[body.contact + side];
            // next to the end of a load that is longer than a layer is far from it stresses there change over that distance
            let far = if side == 0 { placed.bottom() - face } else { face - placed.top };
            cuts.extend(pressure.sides());
            // a line load by itself has no length; the mirror images of the ends of an even pressure are ends, too
            let (mut shortest, images) =
                (field.length(body.contact + side), |end: f64| if field.is_even { -end } else { end });
            for end in &pressure.ends {
                let others = pressure.ends.iter().flat_map(|other| [*other, images(*other)]);
                let distances = others.map(|other| 0.5 * (end - other).abs()).filter(|distance| *distance > 0.0);
                let length = distances.fold(field.length(body.contact + side), f64::min);
                shortest = shortest.min(length);
                features.push((*end, length.min(far)));
            }
            faces.push((face - placed.top, shortest));
        }
        let bending = field.thickness() * field.contrast.max(field.over_support).cbrt();
        let mut reach = features.iter().fold(0.0, |reach: f64, (x, length)| reach.max(x.abs() + BESIDE * length));
        if !is_near {
            reach = reach.max(longest + BEYOND * bending);
        }
        let [from, first] = if field.is_even { [0.0; 2] } else { [-reach, f64::NEG_INFINITY] };
        let along = cut([from, reach], [first, f64::INFINITY], cuts, &features, [LONGEST[0], bending]);
        let deepest = placed.thickness.unwrap_or(DEEP * longest.max(placed.top));
        Self { layer, intervals: [along, cut([0.0, deepest], [0.0, bottom], Vec::new(), &faces, [LONGEST[1], 0.0])] }
    }
}

/// The intervals between two ends, cut at some places and at features with their lengths, and so that they grow with the distance from
/// features, up to the length of bending as far as that matters, with the ends of the intervals in which stresses are smooth: the outermost ones end `beyond`.
fn cut(
    [from, to]: [f64; 2],
    beyond: [f64; 2],
    cuts: Vec<f64>,
    features: &[(f64, f64)],
    [longest, bending]: [f64; 2],
) -> Vec<[[f64; 2]; 2]> {
    let all = cuts.into_iter().chain(features.iter().map(|(at, _)| *at));
    let mut edges: Vec<f64> = all.filter(|at| *at > from && *at < to).chain([from, to]).collect();
    edges.sort_by(f64::total_cmp);
    let mut smooth = edges.clone();
    if let [first, .., last] = &mut smooth[..] {
        [*first, *last] = beyond;
    }
    let allowed = |x: f64| {
        let of = |(at, length): &(f64, f64)| {
            let distance = (x - at).abs();
            let grown = longest * length + GROWTH * distance;
            if distance < BEYOND * bending { grown.min(bending) } else { grown }
        };
        // what is shorter is left out
        features.iter().map(of).fold(f64::INFINITY, f64::min).max(2.0 * ROUNDED * x.abs())
    };
    let mut first = 0;
    while let [left, right, ..] = edges[first..] {
        let [after, before] = [left, right].map(allowed);
        let (length, shorter) = (right - left, after.min(before));
        if length <= (1.0 + ROUNDED) * shorter {
            first += 1;
        } else if length <= 2.0 * shorter {
            edges.insert(first + 1, 0.5 * (left + right));
        } else {
            edges.insert(first + 1, if after <= before { left + after } else { right - before });
        }
    }
    let pairs = edges.windows(2).map(|pair| [pair[0], pair[1]]);
    let of = |[from, to]: [f64; 2]| {
        let next = smooth.partition_point(|edge| *edge <= from);
        [[from, to], [smooth[next - 1], smooth[next]]]
    };
    let is_long = |[from, to]: &[f64; 2]| to - from > ROUNDED * from.abs().max(to.abs());
    pairs.filter(is_long).map(of).collect()
}
