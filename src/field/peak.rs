//! The largest shear stress: a coarse mesh in every layer, then parabolas through ever closer points around its peaks.
use super::error::FieldError;
use super::pressure::Pressure;
use super::strip::Singularity;
use super::sum::Row;
use super::waves::{self, Precision};
use super::{Field, FieldPoint};
use crate::system::Unresolved;

/// Points of the coarse mesh: x in half-lengths of each contact next to the layer, depths in half-lengths from a loaded
/// face, and in thicknesses.
const BESIDE: [f64; 15] = [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.96, 1.0, 1.05, 1.15, 1.4];
const BELOW: [f64; 6] = [0.03, 0.1, 0.25, 0.5, 0.8, 1.3];
const THROUGH: [f64; 3] = [0.0, 0.5, 1.0];
/// Most strips of one pressure that have points of their own.
const APART: usize = 16;
/// Depth to which a half-plane is searched, in half-lengths of the longest contact.
const FAR: f64 = 3.0;
/// Peaks of the coarse mesh are followed if they are above this part of the highest one, at most this number in each layer and this number
/// in all: a plateau in one layer may have any number of them.
const PROMISING: f64 = 0.8;
const OF_LAYER: usize = 4;
const FOLLOWED: usize = 12;
/// The distance of the points of the parabolas, in parts of the shortest length.
const STEPS: [f64; 2] = [0.2, 0.05];
/// The same with all terms of the pressures, and the steps where the peak has moved far by these.
const LAST: f64 = 0.004;
const AGAIN_FROM: [f64; 2] = [0.05, 0.012];
/// Most parabolas one after the other, where the highest point of one is on its edge.
const AGAIN: usize = 4;
/// Values that differ by less are the same: at a bond that joins equal materials both layers have the stress.
const SAME: f64 = 1.0 - 1e-4;
/// In the coarse search, terms of the pressures below this part of the largest one are left out.
const TRUNCATED: f64 = 1e-4;

/// The largest shear stress in the plane, (σ₁ − σ₂)/2, and where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaxShear {
    /// The stress; infinite under a line load and at the sharp corners of a punch.
    pub value: f64,
    /// Along the layers, x ≥ 0; by symmetry it is found at −x, too.
    pub x: f64,
    /// Below the top face of the stack.
    pub depth: f64,
    /// Number of the layer.
    pub layer: usize,
}

/// A place in a layer, and the stress there.
#[derive(Clone, Copy, Debug)]
struct Peak {
    layer: usize,
    x: f64,
    /// Below the top face of the layer.
    depth: f64,
    value: f64,
}

pub(super) fn max_shear(field: &Field) -> Result<MaxShear, FieldError> {
    if let Some(infinite) = infinite(field) {
        return Ok(infinite);
    }
    let truncated = field.with_pressures(|pressure| pressure.truncated(TRUNCATED));
    let mut peaks = promising(field, coarsely(&truncated)?);
    for step in STEPS {
        climb(&truncated, &mut peaks, step, &waves::LOW)?;
    }
    peaks.sort_by(|a, b| b.value.total_cmp(&a.value));
    // low-accuracy values may be wrong in thin layers next to long contacts: the next peak is computed too as long as it may be higher
    let mut found: Vec<Peak> = Vec::new();
    for peak in peaks {
        let highest = found.iter().fold(0.0, |highest: f64, known| highest.max(known.value));
        if peak.value >= SAME * highest {
            found.push(exactly(field, peak)?);
        }
    }
    let highest = found.iter().fold(0.0, |highest: f64, peak| highest.max(peak.value));
    // the uppermost of equal peaks
    let same = found.into_iter().filter(|peak| peak.value >= SAME * highest);
    let Some(Peak { layer, x, depth, value }) = same.min_by_key(|peak| peak.layer) else {
        return Err(Unresolved { wavenumber: 0.0 }.into());
    };
    if !value.is_finite() {
        return Err(Unresolved { wavenumber: 0.0 }.into());
    }
    let placed = &field.layers[layer];
    Ok(MaxShear { value, x, depth: placed.top + depth, layer: placed.number })
}

/// The highest peaks of the coarse mesh, those that are followed.
fn promising(field: &Field, mut peaks: Vec<Peak>) -> Vec<Peak> {
    // a stable sort: the upper one of equal peaks comes first
    peaks.sort_by(|a, b| b.value.total_cmp(&a.value));
    let highest = peaks.first().map_or(0.0, |peak| peak.value);
    peaks.retain(|peak| peak.value >= PROMISING * highest);
    // a peak on a bonded interface is one of both layers
    let place = |peak: &Peak| (peak.x, field.layers[peak.layer].top + peak.depth);
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

/// The peak next to one of low accuracy, with all terms of the pressures.
fn exactly(field: &Field, low_accuracy: Peak) -> Result<Peak, FieldError> {
    let mut peak = [low_accuracy];
    if !climb(field, &mut peak, LAST, &waves::STRESSES)? {
        for step in AGAIN_FROM.into_iter().chain([LAST]) {
            climb(field, &mut peak, step, &waves::STRESSES)?;
        }
    }
    let [peak] = peak;
    Ok(peak)
}

/// Where the shear stress is infinite: under a line load, at sharp corners, and under a sharp tip where the stresses on the face
/// are not the same along it and across, as they are where its material is isotropic.
fn infinite(field: &Field) -> Option<MaxShear> {
    let layer = field.layers.first()?.number;
    let isotropic = field.bodies.first()?.faces[0].as_ref().is_some_and(|face| face.surface.is_isotropic());
    let points = field.pressures.first()?.singular_points();
    let (x, _) =
        points.filter(|(_, kind)| *kind != Singularity::Tip || !isotropic).min_by(|a, b| a.0.total_cmp(&b.0))?;
    Some(MaxShear { value: f64::INFINITY, x, depth: 0.0, layer })
}

/// The peaks of a coarse mesh.
fn coarsely(field: &Field) -> Result<Vec<Peak>, FieldError> {
    let (mut rows, mut sets) = (Vec::new(), Vec::new());
    for (layer, placed) in field.layers.iter().enumerate() {
        let body = &field.bodies[placed.body];
        let contacts = &field.pressures[body.contact..][..1 + usize::from(body.bottom.is_some())];
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
    let values = values(field, &rows, &sets, &waves::COARSE)?;
    let mut peaks = Vec::new();
    for (i, (row, in_row)) in rows.iter().zip(&values).enumerate() {
        let beside = |other: Option<usize>| {
            other.and_then(|k| Some((rows.get(k)?, &values[k]))).filter(|(other, _)| other.layer == row.layer)
        };
        let around: Vec<&Vec<f64>> =
            [i.checked_sub(1), Some(i), Some(i + 1)].into_iter().filter_map(beside).map(|(_, list)| list).collect();
        for (k, value) in in_row.iter().enumerate() {
            let near = k.saturating_sub(1)..(k + 2).min(in_row.len());
            if around.iter().all(|list| list[near.clone()].iter().all(|other| other <= value)) {
                peaks.push(Peak { layer: row.layer, x: sets[row.set][k], depth: row.depth, value: *value });
            }
        }
    }
    Ok(peaks)
}

/// Moves points to the peaks next to them in their layers, by parabolas through points at a distance `step`, and returns whether each
/// of the last parabolas had its peak inside.
fn climb(field: &Field, peaks: &mut [Peak], step: f64, precision: &Precision) -> Result<bool, FieldError> {
    let mut climbing: Vec<usize> = (0..peaks.len()).collect();
    for _ in 0..AGAIN {
        let stencils: Vec<Stencil> = climbing.iter().map(|k| Stencil::new(field, &peaks[*k], step)).collect();
        let rows = stencils.iter().enumerate().flat_map(|(set, stencil)| {
            let depths = [-1.0, 0.0, 1.0].map(|side| stencil.depth + side * stencil.across);
            depths.map(|depth| Row { layer: stencil.layer, depth, set })
        });
        let places = |stencil: &Stencil| [-1.0, 0.0, 1.0].map(|side| (stencil.x + side * stencil.along).abs()).to_vec();
        let sets: Vec<Vec<f64>> = stencils.iter().map(places).collect();
        let values = values(field, &rows.collect::<Vec<_>>(), &sets, precision)?;
        let mut next = Vec::new();
        for ((k, stencil), values) in climbing.iter().zip(&stencils).zip(values.chunks(3)) {
            let inside;
            (peaks[*k], inside) = stencil.highest(values);
            next.extend((!inside).then_some(*k));
        }
        climbing = next;
        if climbing.is_empty() {
            return Ok(true);
        }
    }
    Ok(false)
}

/// Three by three points of a layer about a place.
struct Stencil {
    layer: usize,
    x: f64,
    /// Below the top face of the layer; the points above and below are in the layer, too.
    depth: f64,
    along: f64,
    across: f64,
    deepest: f64,
}

impl Stencil {
    fn new(field: &Field, peak: &Peak, step: f64) -> Self {
        let body = &field.bodies[field.layers[peak.layer].body];
        let contacts = &field.pressures[body.contact..][..1 + usize::from(body.bottom.is_some())];
        let shortest = contacts.iter().fold(f64::INFINITY, |a, contact| a.min(contact.narrowest()));
        let deepest = field.deepest(peak.layer);
        let along = step * shortest;
        let across = along.min(0.25 * deepest);
        let depth = peak.depth.clamp(across, deepest - across);
        Self { layer: peak.layer, x: peak.x, depth, along, across, deepest }
    }

    /// The highest place of the parabola through the values, row by row, and whether it is inside or on a face.
    fn highest(&self, values: &[Vec<f64>]) -> (Peak, bool) {
        // the square is smooth
        let square = |i: usize, k: usize| values[i][k] * values[i][k];
        let parabola = Parabola {
            value: square(1, 1),
            slope: [0.5 * (square(1, 2) - square(1, 0)), 0.5 * (square(2, 1) - square(0, 1))],
            curve: [square(1, 2) - 2.0 * square(1, 1) + square(1, 0), square(2, 1) - 2.0 * square(1, 1) + square(0, 1)],
            twist: 0.25 * (square(2, 2) - square(2, 0) - square(0, 2) + square(0, 0)),
        };
        let ([right, down], top) = parabola.highest();
        let depth = self.depth + down * self.across;
        let x = (self.x + right * self.along).abs();
        let on_face = depth <= 0.0 || depth >= self.deepest;
        let inside = right.abs() < 1.0 && (down.abs() < 1.0 || on_face);
        (Peak { layer: self.layer, x, depth, value: top.max(0.0).sqrt() }, inside)
    }
}

/// value + slope·s + ½ curve·s² + twist·s₀s₁ for −1 ≤ s₀, s₁ ≤ 1.
struct Parabola {
    value: f64,
    slope: [f64; 2],
    curve: [f64; 2],
    twist: f64,
}

impl Parabola {
    fn at(&self, [s, t]: [f64; 2]) -> f64 {
        let straight = self.value + self.slope[0] * s + self.slope[1] * t;
        straight + 0.5 * (self.curve[0] * s * s + self.curve[1] * t * t) + self.twist * s * t
    }

    /// Where it is highest, and how high: where it is level, or on an edge.
    fn highest(&self) -> ([f64; 2], f64) {
        let determinant = self.curve[0] * self.curve[1] - self.twist * self.twist;
        let level = [
            (self.twist * self.slope[1] - self.curve[1] * self.slope[0]) / determinant,
            (self.twist * self.slope[0] - self.curve[0] * self.slope[1]) / determinant,
        ];
        let mut places = vec![level];
        for end in [-1.0, 1.0] {
            for axis in [0, 1] {
                let other = 1 - axis;
                let along = -(self.slope[other] + self.twist * end) / self.curve[other];
                for s in [-1.0, along, 1.0] {
                    places.push(if axis == 0 { [end, s] } else { [s, end] });
                }
            }
        }
        places.retain(|place| place.iter().all(|s| (-1.0..=1.0).contains(s)));
        let heights = places.into_iter().map(|place| (place, self.at(place)));
        heights.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or(([0.0; 2], self.value))
    }
}

impl Field {
    /// The depth to which a layer is searched.
    fn deepest(&self, layer: usize) -> f64 {
        let longest = self.pressures.iter().fold(0.0, |a: f64, pressure| a.max(pressure.half_length));
        self.layers[layer].thickness.unwrap_or(FAR * longest)
    }
}

/// Places of the coarse mesh for one contact.
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

/// The largest shear stress in the plane, row by row.
fn values(field: &Field, rows: &[Row], sets: &[Vec<f64>], precision: &Precision) -> Result<Vec<Vec<f64>>, FieldError> {
    let found = field.sum(rows, sets, precision)?;
    let of = |(row, components): (&Row, Vec<_>)| {
        let xs = &sets[row.set];
        xs.iter()
            .zip(components)
            .map(|(x, components)| field.point(*x, row, components))
            // under a sharp tip it is not defined; along the face it comes to 0 there
            .map(|p: FieldPoint| if p.sigma_yy.is_infinite() { 0.0 } else { p.max_shear() })
            .collect()
    };
    Ok(rows.iter().zip(found).map(of).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_is_highest_where_it_is_level_or_on_an_edge() {
        let level = Parabola { value: 1.0, slope: [0.2, -0.4], curve: [-1.0, -1.0], twist: 0.0 };
        let (place, height) = level.highest();
        assert!((place[0] - 0.2).abs() < 1e-15 && (place[1] + 0.4).abs() < 1e-15 && (height - 1.1).abs() < 1e-15);
        let rising = Parabola { value: 0.0, slope: [0.5, 3.0], curve: [-1.0, 0.1], twist: 0.1 };
        let (place, height) = rising.highest();
        assert!((place[0] - 0.6).abs() < 1e-15 && place[1] == 1.0 && (height - 3.23).abs() < 1e-14);
        let plane = Parabola { value: 2.0, slope: [0.0; 2], curve: [0.0; 2], twist: 0.0 };
        assert_eq!(plane.highest().1, 2.0);
    }
}
