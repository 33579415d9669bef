//! Where stresses are largest: layers are cut into pieces, and in each of them the highest place of the polynomial through the values at
//! its Chebyshev points is the middle of a smaller piece, until the values and the polynomial are the same. All quantities are searched for
//! at once, since the sums over wavenumbers are shared.
use std::f64::consts::PI;

use super::body::DepthRow;
use super::error::FieldError;
use super::measure::{ExtremeSearch, Measure};
use super::mesh::{LayerPiece, Pair, PieceSample, Pieces};
use super::polynomial::{Height, Polynomial};
use super::waves::{self, Precision};
use super::{Field, ROUNDING};

/// The size of a smaller piece, in parts of the last one.
const SMALLER: f64 = 0.25;
/// The size of the next piece along x, or in depth, in parts of the last one, where the highest place is on its edge there.
const LARGER: f64 = 2.0;
/// Most smaller pieces one after the other: steps towards a singular point would not end. The first ones, of low accuracy, are for places on
/// the edge of their piece alone.
const ROUGH: usize = 4;
const ROUNDS: usize = 12;
/// Pieces are followed if their highest place is above this part of the highest value, at most this number in each layer and this
/// number in all: a plateau in one layer may have any number of them.
const PROMISING: f64 = 0.8;
const OF_LAYER: usize = 6;
const FOLLOWED: usize = 16;
/// Values of low accuracy are wrong by this part at most, unless it is in thin layers.
const UNSURE: f64 = 1e-3;
/// A place is found if the polynomial is nowhere higher than the highest point by more than this part, and rounding.
const RISE: f64 = 1e-8;
/// Values of the sums are not told from each other if they differ by less than this number of their errors.
const ERRORS: f64 = 3.0;
/// Values that differ by less are the same: at a bond that joins equal materials both layers have the stress.
const SAME: f64 = 1.0 - 1e-4;

/// Distances from a singular point, in parts of the narrowest load, at which stresses are compared.
const CLOSE: [f64; 2] = [1e-7, 1e-8];
/// Directions from the face on one side to the face on the other; twice as many change nothing.
const DIRECTIONS: u8 = 16;
/// A stress is infinite if it grows by more than this part between the two: a logarithm grows by a tenth, what is finite by a
/// millionth; and if it is above this part of the largest component, since the others leave rounding.
const GROWS: f64 = 1e-3;

/// A place in a layer, and the largest value of a quantity, which is there.
#[derive(Clone, Copy, Debug)]
pub(super) struct HighestPlace {
    pub(super) measure: Measure,
    pub(super) layer: usize,
    pub(super) place: Pair<f64>,
    pub(super) value: f64,
}

/// A piece in which a quantity may be largest.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    measure: Measure,
    piece: LayerPiece,
    /// How far the smaller piece about the expected place reaches.
    reach: Pair<f64>,
    /// Where the highest value is expected.
    expected: Height,
    /// The highest value that was computed.
    seen: Height,
    /// The error of the highest value; infinite if values at an expected place were lower.
    error: f64,
    /// Whether the highest place is inside the piece.
    is_inside: bool,
    /// Whether values have all digits that are searched for.
    is_exact: bool,
    /// Whether the highest value is as high as expected.
    is_found: bool,
}

impl Candidate {
    fn new(polynomial: &Polynomial, measure: Measure, error: f64) -> Self {
        let (piece, seen) = (polynomial.piece, polynomial.highest_point());
        let (expected, _) = polynomial.highest(seen.0);
        let reach = piece.ends.map(|[from, to]| 0.5 * SMALLER * (to - from));
        let is_inside = piece.has_inside(expected.0) == [true; 2];
        Self { measure, piece, reach, expected, seen, error, is_inside, is_exact: false, is_found: false }
    }

    /// Whether the highest place is on the edge of another piece that is no lower, with smooth stresses in both.
    fn is_of(&self, other: &Self) -> bool {
        let is_same = other.piece.layer == self.piece.layer && other.piece.smooth == self.piece.smooth;
        is_same && other.piece.holds(self.expected.0) && other.expected.1 >= self.expected.1
    }

    /// Goes to the highest place of a smaller piece, or back to the highest value before if that piece is lower.
    fn follow(&mut self, polynomial: &Polynomial, [error, rounding]: [f64; 2], is_exact: bool) {
        let seen = polynomial.highest_point();
        let (highest, there) = polynomial.highest(self.expected.0);
        let is_lower = seen.1 < self.seen.1 - self.error;
        let inside = polynomial.piece.has_inside(highest.0);
        let is_inside = inside == [true; 2];
        for (reach, is_inside) in self.reach.iter_mut().zip(inside) {
            *reach *= if is_inside || is_lower { SMALLER } else { LARGER };
        }
        if is_lower {
            (self.expected, self.error) = (self.seen, f64::INFINITY);
            return;
        }
        let is_level = |lower: f64| highest.1 - lower <= RISE * highest.1.abs() + rounding;
        // what is no larger than its error may be 0
        self.is_found = is_exact && (highest.1 <= error || is_level(seen.1) && (is_inside || is_level(there)));
        (self.expected, self.seen, self.error) = (highest, seen, error);
        (self.is_inside, self.is_exact) = (is_inside, is_exact);
    }
}

/// The highest place of each search; `None` where the quantity is nowhere positive, or not known.
pub(super) fn highest(field: &Field, searches: &[ExtremeSearch]) -> Result<Vec<Option<HighestPlace>>, FieldError> {
    // where the top layer has infinite stresses there is nothing to search for
    let infinite: Vec<Option<HighestPlace>> = searches.iter().map(|search| infinite(field, search)).collect();
    // without a length stresses fall with the distance from a force
    if field.length(0) == 0.0 || infinite.iter().all(Option::is_some) {
        return Ok(infinite);
    }
    // shear stresses are largest in the surroundings of the loads, unless eigenstrains or weights make stresses that are there without loads; far
    // from loads other stresses may be smaller than what is left out
    let is_loaded = field.layers.iter().all(|placed| placed.residual.is_none());
    let is_near = is_loaded && searches.iter().all(|(measure, _)| *measure == Measure::MaxShear);
    let first = if is_near { &waves::COARSE } else { &waves::LOW };
    let samples: Vec<PieceSample> =
        PieceSample::all(field, &Pieces::all(field, is_near), first)?.into_iter().flatten().collect();
    let candidates = |((measure, layer), infinite): (&ExtremeSearch, &Option<HighestPlace>)| {
        if infinite.is_some() {
            return Vec::new();
        }
        let own = samples.iter().filter(|sample| layer.is_none_or(|layer| sample.piece.layer == layer));
        let of = |sample: &PieceSample| {
            let polynomial = Polynomial::new(sample, *measure, field.layers[sample.piece.layer].thickness)?;
            Some((polynomial, field.unsure(sample.piece.layer, first)))
        };
        promising(own.filter_map(of).collect(), *measure)
    };
    let mut candidates: Vec<Vec<Candidate>> = searches.iter().zip(&infinite).map(candidates).collect();
    for round in 0..ROUGH {
        // nothing is to be learnt about a place that is a point already, and the highest of its surroundings
        let is_open = |one: &Candidate| !one.is_inside || round == 0 && one.expected.1 > one.seen.1;
        let chosen = candidates.iter_mut().flat_map(|own| open(field, own, 1.0 - PROMISING)).filter(|one| is_open(one));
        if !follow(field, chosen.collect(), &waves::LOW)? {
            break;
        }
    }
    for _ in 0..ROUNDS {
        let chosen = candidates.iter_mut().flat_map(|own| open(field, own, UNSURE));
        if !follow(field, chosen.collect(), &waves::STRESSES)? {
            break;
        }
    }
    Ok(candidates.iter().zip(infinite).map(|(own, infinite)| infinite.or_else(|| uppermost(own))).collect())
}

/// Where on the top face a stress is infinite: at a singular point next to which it grows in some direction. The closed forms tell: the rest of
/// the field is finite.
fn infinite(field: &Field, &(measure, layer): &ExtremeSearch) -> Option<HighestPlace> {
    if layer.unwrap_or(0) != 0 || measure.is_on_face() {
        return None;
    }
    let scale = [field.narrowest(), 1.0].into_iter().find(|length| *length > 0.0)?;
    let grows = |x: f64| {
        let [far, near] = CLOSE.map(|part| next_to(field, measure, x, part * scale));
        near.0 > far.0 * (1.0 + GROWS) && near.0 > GROWS * near.1
    };
    let places = field.pressures.first()?.singular_points().map(|(x, _)| x).filter(|x| grows(*x));
    places.min_by(f64::total_cmp).map(|x| HighestPlace { measure, layer: 0, place: [x, 0.0], value: f64::INFINITY })
}

/// The largest value of a stress at a distance from a place on the top face, and the largest component there.
fn next_to(field: &Field, measure: Measure, x: f64, distance: f64) -> (f64, f64) {
    let of = |k: u8| {
        let (sin, cos) = (PI * f64::from(k) / f64::from(DIRECTIONS)).sin_cos();
        let row = DepthRow { layer: 0, depth: distance * sin, set: 0 };
        let x = field.folded(x + distance * cos);
        let point = field.point(x, &row, *field.closed(&row, &[x], false).first()?);
        let size = [point.sigma_xx, point.sigma_yy, point.sigma_xy].into_iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        Some((measure.of(&point), size))
    };
    let all = (0..=DIRECTIONS).filter_map(of);
    all.fold((0.0, 0.0), |(value, size): (f64, f64), found| (value.max(found.0), size.max(found.1)))
}

/// Follows some candidates; whether there are any.
fn follow(field: &Field, mut chosen: Vec<&mut Candidate>, precision: &Precision) -> Result<bool, FieldError> {
    let is_exact = precision.inside <= waves::STRESSES.inside;
    let smaller = |one: &&mut Candidate| one.piece.about(one.expected.0, one.reach);
    let samples = PieceSample::all(field, &chosen.iter().map(smaller).collect::<Vec<_>>(), precision)?;
    for (one, samples) in chosen.iter_mut().zip(samples) {
        let layer = one.piece.layer;
        let polynomial = |sample: &PieceSample| Polynomial::new(sample, one.measure, field.layers[layer].thickness);
        if let Some(polynomial) = samples.first().and_then(polynomial) {
            let rounding = ROUNDING * field.mean_pressure(layer);
            one.follow(&polynomial, [field.unsure(layer, precision), rounding], is_exact);
        }
    }
    Ok(!chosen.is_empty())
}

/// The highest of some peaks, and of equal ones in several layers that in the uppermost layer.
fn uppermost(candidates: &[Candidate]) -> Option<HighestPlace> {
    let exact = || candidates.iter().filter(|one| one.is_exact);
    let highest = exact().fold(0.0, |highest: f64, one| highest.max(one.seen.1));
    let same = exact().filter(|one| one.seen.1 > 0.0 && one.seen.1 >= SAME * highest);
    let found = same.min_by(|a, b| a.piece.layer.cmp(&b.piece.layer).then(b.seen.1.total_cmp(&a.seen.1)))?;
    let Candidate { measure, piece, seen: (place, value), .. } = *found;
    Some(HighestPlace { measure, layer: piece.layer, place, value })
}

/// The highest pieces, which are followed.
fn promising(mut all: Vec<(Polynomial, f64)>, measure: Measure) -> Vec<Candidate> {
    let highest = all.iter().fold(0.0, |highest: f64, (one, _)| highest.max(one.highest_point().1));
    all.retain(|(one, error)| one.highest_point().1 + error >= PROMISING * highest);
    let mut all: Vec<Candidate> = all.iter().map(|(one, error)| Candidate::new(one, measure, *error)).collect();
    // a stable sort: the upper one of equal ones comes first
    all.sort_by(|a, b| b.expected.1.total_cmp(&a.expected.1));
    let mut followed: Vec<Candidate> = Vec::new();
    for (i, one) in all.iter().enumerate() {
        let of_layer = followed.iter().filter(|other| other.piece.layer == one.piece.layer).count();
        if of_layer < OF_LAYER && followed.len() < FOLLOWED && !all[..i].iter().any(|other| one.is_of(other)) {
            followed.push(*one);
        }
    }
    followed
}

/// The candidates that may be higher than the highest one that was found, if their values are wrong by this part and the error of a sum
/// of low accuracy.
fn open<'a>(field: &Field, own: &'a mut [Candidate], unsure: f64) -> impl Iterator<Item = &'a mut Candidate> {
    let error = |one: &Candidate| field.unsure(one.piece.layer, &waves::LOW);
    let of = |all: &[Candidate], found: bool| {
        let values = all.iter().filter(|one| one.is_found || !found).map(|one| one.seen.1 - error(one));
        values.reduce(f64::max)
    };
    let highest = of(own, true).or(of(own, false)).unwrap_or(0.0);
    let least = highest - unsure * highest.abs();
    own.iter_mut().filter(move |one| !one.is_found && one.expected.1 >= least - error(one))
}

impl Field {
    /// The largest of the mean pressures on the body of a layer.
    pub(super) fn mean_pressure(&self, layer: usize) -> f64 {
        let body = &self.bodies[self.layers[layer].body];
        let mean = |contact: usize| self.pressures[contact].mean(self.length(contact));
        body.contacts().map(mean).filter(|mean| mean.is_finite()).fold(0.0, f64::max)
    }

    /// A difference below which values of the sums in a layer are not told from each other.
    fn unsure(&self, layer: usize, precision: &Precision) -> f64 {
        ERRORS * precision.inside * self.mean_pressure(layer)
    }
}
