//! Where quantities are largest: meshes in every layer, then parabolas through ever closer points around their peaks. All quantities
//! are searched for at once, since the sums over wavenumbers are shared.
use super::error::FieldError;
use super::measure::{Peak, Search, Seen};
use super::parabola::{Level, Stencil};
use super::pressure::Pressure;
use super::sum::Row;
use super::waves::{self, Precision};
use super::{Field, FieldPoint, PlacedLayer};

/// Points of the mesh next to the loads: x in half-lengths of each contact next to the layer, depths in half-lengths from a loaded
/// face, and in thicknesses.
const BESIDE: [f64; 15] = [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.96, 1.0, 1.05, 1.15, 1.4];
const BELOW: [f64; 6] = [0.03, 0.1, 0.25, 0.5, 0.8, 1.3];
const THROUGH: [f64; 3] = [0.0, 0.5, 1.0];
/// Most strips of one pressure that have points of their own.
const APART: usize = 16;
/// Depth to which a half-plane is searched, in half-lengths of the longest contact, or thicknesses of what lies on it.
const FAR: f64 = 3.0;
/// The mesh away from the loads reaches this number of bending lengths beyond the longest contact, and each of its places is this factor
/// times the one before, from this part of the shortest contact on.
const BEYOND: f64 = 4.0;
const SPREAD: f64 = 1.3;
const NEAREST: f64 = 0.5;
/// Its depths, in parts of the thickness of a layer, or of the depth to which a half-plane is searched.
const LAYER: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];
const HALF_PLANE: [f64; 7] = [0.0, 0.05, 0.1, 0.2, 0.35, 0.6, 1.0];
/// The distance of points, in parts of that of the places of this mesh.
const SCALE: f64 = 2.0;
/// Peaks of a mesh are followed if they are above this part of the highest one, at most this number in each layer and this number
/// in all: a plateau in one layer may have any number of them.
const PROMISING: f64 = 0.8;
const OF_LAYER: usize = 4;
const FOLLOWED: usize = 12;
/// The distance of the points of the parabolas, in parts of the shortest length.
const STEPS: [f64; 3] = [0.2, 0.05, 0.012];
/// The same with all terms of the pressures, and the steps where the peak has moved far by these.
const LAST: f64 = 0.004;
const AGAIN_FROM: [f64; 2] = [0.05, 0.012];
/// Most parabolas one after the other, where the highest point of one is on its edge.
const AGAIN: usize = 4;
/// A parabola that rises by less than this part, and this number of errors of its values, need not be followed.
const RISE: f64 = 1e-7;
const RISE_OVER_ERROR: f64 = 3.0;
/// Values that differ by less are the same: at a bond that joins equal materials both layers have the stress.
const SAME: f64 = 1.0 - 1e-4;
/// Values of low accuracy are wrong by this part at most, unless it is in thin layers.
const UNSURE: f64 = 1e-3;
/// In the coarse search, terms of the pressures below this part of the largest one are left out.
const TRUNCATED: f64 = 1e-4;
/// Values of a mesh that differ by less than this part of the mean pressure are not told from each other.
const NOISE: f64 = 3e-5;

/// Whether only the surroundings of the loads are searched, where shear stresses are largest, or also what is far from them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Extent {
    Near,
    Everywhere,
}

/// The highest peak of each search; `None` where the quantity is nowhere positive, or not known.
pub(super) fn highest(field: &Field, searches: &[Search], extent: Extent) -> Result<Vec<Option<Peak>>, FieldError> {
    // far from the loads stresses may be smaller than what would be left out
    let (truncated, meshes) = match extent {
        Extent::Near => {
            let truncated = field.with_pressures(|pressure| pressure.truncated(TRUNCATED));
            let near = Mesh::near(&truncated, &waves::COARSE)?;
            (Some(truncated), vec![near])
        }
        Extent::Everywhere => (None, vec![Mesh::near(field, &waves::LOW)?, Mesh::far(field)?]),
    };
    let truncated = truncated.as_ref().unwrap_or(field);
    // the peaks of all searches one after the other, with the number of the search
    let (mut peaks, mut of): (Vec<Peak>, Vec<usize>) = (Vec::new(), Vec::new());
    for (i, search) in searches.iter().enumerate() {
        let all = meshes.iter().flat_map(|mesh| mesh.peaks(field, search)).collect();
        peaks.extend(promising(field, all));
        of.resize(peaks.len(), i);
    }
    let steps = if extent == Extent::Near { &STEPS[..2] } else { &STEPS };
    for step in steps.iter().copied() {
        climb(truncated, &mut peaks, step, &waves::LOW)?;
    }
    let mut candidates: Vec<Vec<Peak>> = vec![Vec::new(); searches.len()];
    for (peak, i) in peaks.into_iter().zip(of) {
        candidates[i].push(peak);
    }
    for peaks in &mut candidates {
        peaks.retain(|peak| !peak.value.is_nan());
        peaks.sort_by(|a, b| b.value.total_cmp(&a.value));
        // the highest one is the last: it is taken first
        peaks.reverse();
    }
    // low-accuracy values may be wrong in thin layers next to long contacts: the next peak is computed too as long as it may be higher
    let noise = NOISE * field.mean_pressure();
    let mut found: Vec<Vec<Peak>> = vec![Vec::new(); searches.len()];
    loop {
        let (mut next, mut of) = (Vec::new(), Vec::new());
        for (i, (candidates, found)) in candidates.iter_mut().zip(&found).enumerate() {
            let highest = found.iter().fold(f64::NEG_INFINITY, |highest, known: &Peak| highest.max(known.value));
            let enough = |peak: &Peak| peak.seen.value >= highest - UNSURE * highest.abs() - noise;
            if let Some(peak) = candidates.pop().filter(enough) {
                next.push(peak);
                of.push(i);
            } else {
                candidates.clear();
            }
        }
        if next.is_empty() {
            break;
        }
        exactly(field, &mut next, extent)?;
        next.into_iter().zip(of).for_each(|(peak, i)| found[i].push(peak));
    }
    Ok(found.into_iter().map(uppermost).collect())
}

/// The highest of some peaks, and the uppermost of equal ones.
fn uppermost(peaks: Vec<Peak>) -> Option<Peak> {
    let highest = peaks.iter().fold(0.0, |highest: f64, peak| highest.max(peak.value));
    let same = peaks.into_iter().filter(|peak| peak.value > 0.0 && peak.value >= SAME * highest);
    same.min_by_key(|peak| peak.layer)
}

/// The highest peaks of the meshes, those that are followed.
fn promising(field: &Field, mut peaks: Vec<Peak>) -> Vec<Peak> {
    // a stable sort: the upper one of equal peaks comes first
    peaks.sort_by(|a, b| b.value.total_cmp(&a.value));
    let highest = peaks.first().map_or(0.0, |peak| peak.value);
    let noise = NOISE * field.mean_pressure();
    let enough = match peaks.first() {
        // one that may be negative
        Some(peak) if !peak.measure.is_norm() => {
            if highest < -noise {
                return Vec::new();
            }
            PROMISING * highest.max(0.0) - noise
        }
        _ => PROMISING * highest,
    };
    peaks.retain(|peak| peak.value >= enough);
    // a peak on a bonded interface is one of both layers
    let place = |peak: &Peak| (peak.x, field.layers[peak.layer].top + peak.depth, peak.scale == 0.0);
    peaks.dedup_by(|next, peak| place(next) == place(peak) && next.value >= SAME * peak.value);
    let mut followed: Vec<Peak> = Vec::with_capacity(FOLLOWED);
    for peak in peaks {
        let of_layer = followed.iter().filter(|other| other.layer == peak.layer).count();
        if of_layer < OF_LAYER && followed.len() < FOLLOWED {
            followed.push(peak);
        }
    }
    followed
}

/// The peaks next to those of low accuracy, with all terms of the pressures: values are those of the field, since a parabola next to
/// the end of a contact may be too high.
fn exactly(field: &Field, peaks: &mut [Peak], extent: Extent) -> Result<(), FieldError> {
    // values that were computed to fewer digits are not compared
    peaks.iter_mut().for_each(|peak| peak.seen.value = f64::NEG_INFINITY);
    let unfinished = climb(field, peaks, LAST, &waves::STRESSES)?;
    let mut moved: Vec<Peak> = unfinished.iter().map(|k| peaks[*k]).collect();
    for step in AGAIN_FROM.into_iter().chain([LAST]) {
        climb(field, &mut moved, step, &waves::STRESSES)?;
    }
    unfinished.into_iter().zip(moved).for_each(|(k, peak)| peaks[k] = peak);
    if extent == Extent::Near {
        // a parabola of the last steps is as good next to the largest shear stress, which is inside; but not in a layer thinner than its steps
        peaks.iter_mut().for_each(Peak::take_seen);
        return Ok(());
    }
    let sets: Vec<Vec<f64>> = peaks.iter().map(|peak| vec![peak.x]).collect();
    let row = |(set, peak): (usize, &Peak)| Row { layer: peak.layer, depth: peak.depth, set };
    let rows: Vec<Row> = peaks.iter().enumerate().map(row).collect();
    let there = points(field, &rows, &sets, &waves::STRESSES)?;
    for (peak, point) in peaks.iter_mut().zip(there.iter().flatten()) {
        peak.value = peak.measure.of(point);
        peak.take_seen();
    }
    Ok(())
}

/// Stresses in rows of points, layer by layer.
struct Mesh {
    rows: Vec<Row>,
    sets: Vec<Vec<f64>>,
    points: Vec<Vec<FieldPoint>>,
    scale: Scale,
    /// The ends of contacts: row, and place in it.
    ends: Vec<(usize, usize)>,
}

/// The length that steps from a place of a mesh are parts of.
enum Scale {
    /// The shortest half-length next to each layer, or the distance of the next place where that is larger.
    Shortest(Vec<f64>),
    /// The distance from the loads: that from x = 0, or from the nearest loaded face, and no less than this.
    Distance(f64),
}

impl Scale {
    /// For the place number `k` of a row in a layer.
    fn at(&self, field: &Field, row: &Row, places: &[f64], k: usize) -> f64 {
        let x = places[k];
        match self {
            Self::Shortest(of) => places.get(k + 1).map_or(0.0, |next| next - x).max(of[row.layer]),
            Self::Distance(least) => {
                let placed = &field.layers[row.layer];
                let (body, depth) = (&field.bodies[placed.body], placed.top + row.depth);
                let face = (depth - body.top).min(body.bottom.map_or(f64::INFINITY, |bottom| bottom - depth));
                SCALE * (SPREAD - 1.0) * x.max(face).max(*least)
            }
        }
    }
}

impl Mesh {
    /// Next to the loads.
    fn near(field: &Field, precision: &Precision) -> Result<Self, FieldError> {
        let (mut rows, mut sets) = (Vec::new(), Vec::new());
        for (layer, placed) in field.layers.iter().enumerate() {
            let body = &field.bodies[placed.body];
            let contacts = field.contacts_of(layer);
            let deepest = field.deepest(layer);
            let xs = contacts.iter().flat_map(beside);
            let mut depths: Vec<f64> = THROUGH.iter().map(|part| part * deepest).collect();
            for (side, contact) in contacts.iter().enumerate() {
                // counted from the loaded face, be it that of this layer or of one above or below it
                let face = if side == 0 { body.top } else { body.bottom.unwrap_or(body.top) } - placed.top;
                let lengths = [contact.half_length, contact.narrowest()];
                let distances = lengths.iter().flat_map(|length| BELOW.map(|part| part * length));
                let inside = distances.map(|distance| if side == 0 { face + distance } else { face - distance });
                depths.extend(inside.filter(|depth| *depth > 0.0 && *depth < deepest));
            }
            rows.extend(ascending(depths).into_iter().map(|depth| Row { layer, depth, set: sets.len() }));
            sets.push(ascending(xs.collect()));
        }
        let points = points(field, &rows, &sets, precision)?;
        let scale = Scale::Shortest((0..field.layers.len()).map(|layer| field.shortest(layer)).collect());
        let ends = ends(field, &rows, &sets);
        Ok(Self { rows, sets, points, scale, ends })
    }

    /// Away from the loads: as far as a stiff layer on soft ones distributes them by bending.
    fn far(field: &Field) -> Result<Self, FieldError> {
        let finite = field.layers.iter().filter_map(|placed| placed.thickness);
        let bending = finite.fold(0.0, |sum, h| sum + h) * field.contrast.max(field.over_support).cbrt();
        let longest = field.pressures.iter().fold(0.0, |a: f64, pressure| a.max(pressure.half_length));
        let from = (0..field.layers.len()).map(|layer| field.shortest(layer)).fold(f64::INFINITY, f64::min);
        let to = longest + BEYOND * bending;
        let from = if from > 0.0 && from.is_finite() { NEAREST * from } else { 1e-3 * to };
        let mut places = vec![0.0];
        let mut x = from;
        while x < to {
            places.push(x);
            x *= SPREAD;
        }
        let depths = |(layer, placed): (usize, &PlacedLayer)| {
            let parts: &[f64] = if placed.thickness.is_some() { &LAYER } else { &HALF_PLANE };
            let deepest = field.deepest(layer);
            parts.iter().map(move |part| Row { layer, depth: part * deepest, set: 0 })
        };
        let rows: Vec<Row> = field.layers.iter().enumerate().flat_map(depths).collect();
        let sets = vec![places];
        let points = points(field, &rows, &sets, &waves::LOW)?;
        Ok(Self { rows, sets, points, scale: Scale::Distance(from), ends: Vec::new() })
    }

    /// The places at which a quantity is no smaller than at those around them, and the ends of contacts.
    fn peaks(&self, field: &Field, search: &Search) -> Vec<Peak> {
        let Search { measure, layer } = *search;
        let searched = |row: &Row| layer.is_none_or(|layer| row.layer == layer);
        let last = |i: usize| self.rows.get(i + 1).is_none_or(|next| next.layer != self.rows[i].layer);
        let chosen: Vec<usize> =
            (0..self.rows.len()).filter(|i| searched(&self.rows[*i]) && (!measure.is_on_face() || last(*i))).collect();
        let values: Vec<Vec<f64>> =
            chosen.iter().map(|i| self.points[*i].iter().map(|point| measure.of(point)).collect()).collect();
        let at_end = |&(i, k): &(usize, usize)| {
            let row = self.rows[i];
            let (x, value) = (self.sets[row.set][k], measure.of(&self.points[i][k]));
            Peak::new(measure, row.layer, Seen { x, depth: row.depth, value }, 0.0)
        };
        let ends = self.ends.iter().filter(|(i, _)| chosen.contains(i));
        let mut peaks: Vec<Peak> = ends.map(at_end).collect();
        for (i, in_row) in values.iter().enumerate() {
            let row = self.rows[chosen[i]];
            let beside = |other: Option<usize>| {
                other.filter(|k| chosen.get(*k).is_some_and(|k| self.rows[*k].layer == row.layer))
            };
            let around: Vec<&Vec<f64>> =
                [i.checked_sub(1), Some(i), Some(i + 1)].into_iter().filter_map(beside).map(|k| &values[k]).collect();
            for (k, value) in in_row.iter().copied().enumerate() {
                let near = k.saturating_sub(1)..(k + 2).min(in_row.len());
                if around.iter().all(|list| list[near.clone()].iter().all(|other| *other <= value)) {
                    let places = &self.sets[row.set];
                    let (x, scale) = (places[k], self.scale.at(field, &row, places, k));
                    peaks.push(Peak::new(measure, row.layer, Seen { x, depth: row.depth, value }, scale));
                }
            }
        }
        peaks
    }
}

/// Moves points to the peaks next to them in their layers, by parabolas through points at a distance `step`, and returns which of
/// them have not come to a parabola with its peak inside, or one that is level. A place that is lower than one seen before is left
/// for that: next to a thin layer a peak may be much narrower than the step.
fn climb(field: &Field, peaks: &mut [Peak], step: f64, precision: &Precision) -> Result<Vec<usize>, FieldError> {
    let mut climbing: Vec<usize> = (0..peaks.len()).collect();
    let level = Level { relative: RISE, absolute: RISE_OVER_ERROR * precision.inside * field.mean_pressure() };
    for _ in 0..AGAIN {
        if climbing.is_empty() {
            break;
        }
        let stencils: Vec<Stencil> =
            climbing.iter().map(|k| Stencil::new(&peaks[*k], step, field.deepest(peaks[*k].layer))).collect();
        let mut rows = Vec::new();
        for (set, stencil) in stencils.iter().enumerate() {
            rows.extend(stencil.depths().map(|depth| Row { layer: stencil.layer(), depth, set }));
        }
        let sets: Vec<Vec<f64>> = stencils.iter().map(Stencil::places).collect();
        let found = points(field, &rows, &sets, precision)?;
        let mut remaining = &found[..];
        let mut next = Vec::new();
        for (k, stencil) in climbing.iter().zip(&stencils) {
            let (own, others) = remaining.split_at(stencil.depths().count());
            remaining = others;
            let inside;
            (peaks[*k], inside) = stencil.highest(own, level);
            next.extend((!inside).then_some(*k));
        }
        climbing = next;
    }
    Ok(climbing)
}

impl Field {
    /// The depth to which a layer is searched.
    fn deepest(&self, layer: usize) -> f64 {
        let longest = self.pressures.iter().fold(0.0, |a: f64, pressure| a.max(pressure.half_length));
        let placed = &self.layers[layer];
        placed.thickness.unwrap_or(FAR * longest.max(placed.top))
    }

    /// The pressures on the body of a layer.
    fn contacts_of(&self, layer: usize) -> &[Pressure] {
        let body = &self.bodies[self.layers[layer].body];
        &self.pressures[body.contact..][..1 + usize::from(body.bottom.is_some())]
    }

    /// The shortest half-length of a pressure on the body of a layer.
    fn shortest(&self, layer: usize) -> f64 {
        self.contacts_of(layer).iter().fold(f64::INFINITY, |a, contact| a.min(contact.narrowest()))
    }

    /// The largest of the mean pressures of the contacts.
    pub(super) fn mean_pressure(&self) -> f64 {
        let mean = |contact: usize| self.pressures[contact].mean(self.length(contact));
        (0..self.pressures.len()).map(mean).filter(|mean| mean.is_finite()).fold(0.0, f64::max)
    }
}

/// The ends of the contacts on the loaded faces of the bodies.
fn ends(field: &Field, rows: &[Row], sets: &[Vec<f64>]) -> Vec<(usize, usize)> {
    let of = |(i, row): (usize, &Row)| {
        let placed = &field.layers[row.layer];
        let body = &field.bodies[placed.body];
        let top = (placed.place == 0 && row.depth == 0.0).then_some(body.contact);
        let is_bottom = body.bottom.is_some() && placed.place + 1 == body.layers && placed.thickness == Some(row.depth);
        let contact = &field.pressures[top.or(is_bottom.then_some(body.contact + 1))?];
        let middles = contact.strips().chain([(0.0, contact.half_length)]);
        let ends: Vec<f64> = middles.flat_map(|(at, a)| [at - a, at + a]).filter(|end| *end >= 0.0).collect();
        let places = sets[row.set].iter().enumerate();
        Some(places.filter(move |(_, x)| ends.contains(x)).map(move |(k, _)| (i, k)))
    };
    rows.iter().enumerate().filter_map(of).flatten().collect()
}

/// Places of the mesh for one contact.
fn beside(contact: &Pressure) -> Vec<f64> {
    let about =
        |(at, a): (f64, f64)| [-1.0, 1.0].into_iter().flat_map(move |side| BESIDE.map(|part| at + side * part * a));
    // many strips are taken as one
    let strips: Vec<(f64, f64)> = contact.strips().filter(|_| contact.strips().count() <= APART).collect();
    let all = strips.into_iter().chain([(0.0, contact.half_length)]).flat_map(about);
    all.filter(|x| *x >= 0.0).collect()
}

fn ascending(mut list: Vec<f64>) -> Vec<f64> {
    list.sort_by(f64::total_cmp);
    list.dedup();
    list
}

/// Stresses in rows of points.
fn points(
    field: &Field,
    rows: &[Row],
    sets: &[Vec<f64>],
    precision: &Precision,
) -> Result<Vec<Vec<FieldPoint>>, FieldError> {
    let found = field.sum(rows, sets, precision)?;
    let of = |(row, components): (&Row, Vec<_>)| {
        sets[row.set].iter().zip(components).map(|(x, components)| field.point(*x, row, components)).collect()
    };
    Ok(rows.iter().zip(found).map(of).collect())
}
