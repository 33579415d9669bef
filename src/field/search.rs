//! Where quantities are largest: meshes in every layer, then parabolas through ever closer points around their peaks. All quantities
//! are searched for at once, since the sums over wavenumbers are shared.
use super::Field;
use super::error::FieldError;
use super::measure::{Peak, Search};
use super::mesh::{Mesh, points};
use super::parabola::{Level, Stencil};
use super::sum::Row;
use super::waves::{self, Precision};

/// Depth to which a half-plane is searched, in half-lengths of the longest contact, or thicknesses of what lies on it.
const FAR: f64 = 3.0;
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
    if field.length(0) == 0.0 {
        // no length occurs: stresses fall with the distance from a force
        return Ok(vec![None; searches.len()]);
    }
    // far from the loads stresses may be smaller than what would be left out
    let (truncated, mut meshes) = match extent {
        Extent::Near => {
            let truncated = field.with_pressures(|pressure| pressure.truncated(TRUNCATED));
            let near = Mesh::near(&truncated, &waves::COARSE)?;
            (Some(truncated), vec![near])
        }
        Extent::Everywhere => (None, vec![Mesh::near(field, &waves::LOW)?, Mesh::far(field)?]),
    };
    meshes.extend(Mesh::jumps(field)?);
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

/// The highest of some peaks, and of equal ones in several layers that in the uppermost layer.
fn uppermost(peaks: Vec<Peak>) -> Option<Peak> {
    let highest = peaks.iter().fold(0.0, |highest: f64, peak| highest.max(peak.value));
    let same = peaks.into_iter().filter(|peak| peak.value > 0.0 && peak.value >= SAME * highest);
    same.min_by(|a, b| a.layer.cmp(&b.layer).then(b.value.total_cmp(&a.value)))
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
        let stencils: Vec<Stencil> = climbing.iter().map(|k| Stencil::new(field, &peaks[*k], step)).collect();
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
    pub(super) fn deepest(&self, layer: usize) -> f64 {
        let longest = self.pressures.iter().fold(0.0, |a: f64, pressure| a.max(pressure.half_length));
        let placed = &self.layers[layer];
        placed.thickness.unwrap_or(FAR * longest.max(placed.top))
    }

    /// The contacts on the body of a layer.
    pub(super) fn contacts_of(&self, layer: usize) -> std::ops::Range<usize> {
        let body = &self.bodies[self.layers[layer].body];
        body.contact..body.contact + 1 + usize::from(body.bottom.is_some())
    }

    /// The shortest half-length of a pressure on the body of a layer.
    pub(super) fn shortest(&self, layer: usize) -> f64 {
        self.contacts_of(layer).map(|contact| self.narrowest(contact)).fold(f64::INFINITY, f64::min)
    }

    /// The largest of the mean pressures of the contacts.
    pub(super) fn mean_pressure(&self) -> f64 {
        let mean = |contact: usize| self.pressures[contact].mean(self.length(contact));
        (0..self.pressures.len()).map(mean).filter(|mean| mean.is_finite()).fold(0.0, f64::max)
    }
}
