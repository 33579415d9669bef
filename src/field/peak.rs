//! The largest shear stress.
use super::sum::Row;
use super::waves::{self, Precision};
use super::{Field, FieldPoint};
use crate::error::Error;

/// Places along x and depths of a layer at which the search begins.
const PLACES: usize = 24;
const DEPTHS: usize = 12;
/// The mesh shrinks by this factor around the largest value, so many times, of which the last are closer.
const SHRINKS: f64 = 0.2;
const TIMES: i32 = 7;
const CLOSELY: i32 = 2;
/// Points to either side in the finer meshes.
const BESIDE: i32 = 3;
/// A value has to be larger by this part to be preferred: at a bond that joins equal materials both layers have it.
const LARGER: f64 = 1.0 + 1e-4;
/// Below a half-plane's face, and beside the contacts, the search goes so many half-lengths far.
const FAR: f64 = 3.0;

/// The largest shear stress in the plane, (σ₁ − σ₂)/2, and where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaxShear {
    /// The stress.
    pub value: f64,
    /// Along the layers, x ≥ 0; by symmetry it is found at −x, too.
    pub x: f64,
    /// Below the top face of the stack.
    pub depth: f64,
    /// Number of the layer.
    pub layer: usize,
}

pub(super) fn max_shear(field: &Field) -> Result<MaxShear, Error> {
    let longest = field.pressures.iter().fold(0.0, |a: f64, pressure| a.max(pressure.half_length));
    let (mut rows, mut sets, mut spacings) = (Vec::new(), Vec::new(), Vec::new());
    for (stratum, own) in field.strata.iter().enumerate() {
        // the contacts next to the layer decide how fine the mesh has to be
        let body = &field.bodies[own.body];
        let contacts = field.pressures[body.contact..].iter().take(1 + usize::from(body.bottom.is_some()));
        let shortest = contacts.map(|pressure| pressure.half_length).fold(longest, f64::min);
        let deepest = own.thickness.unwrap_or(FAR * longest);
        let mut xs: Vec<f64> = steps(FAR * shortest).chain(steps(1.5 * longest)).collect();
        xs.sort_by(f64::total_cmp);
        let even = (0..=DEPTHS).map(|k| k as f64 / DEPTHS as f64 * deepest);
        let next_to_contact = (1..8).map(|k| 0.2 * f64::from(k) * shortest).filter(|depth| *depth < deepest);
        rows.extend(even.chain(next_to_contact).map(|depth| Row { stratum, depth, set: sets.len() }));
        sets.push(xs);
        spacings.push([FAR * shortest / PLACES as f64, (0.2 * shortest).min(deepest / DEPTHS as f64)]);
    }
    let nothing = || Error::Unresolved { wavenumber: 0.0 };
    let (mut found, stratum) = largest(field, &rows, &sets, &waves::ROUGH)?.ok_or_else(nothing)?;
    let (top, deepest) = (field.strata[stratum].top, field.strata[stratum].thickness.unwrap_or(f64::INFINITY));
    let mut spacing = spacings[stratum];
    for time in 0..TIMES {
        let around = |centre: f64, step: f64| (-BESIDE..=BESIDE).map(move |k| centre + f64::from(k) * step);
        let mut xs: Vec<f64> = around(found.x, spacing[0]).map(f64::abs).collect();
        xs.sort_by(f64::total_cmp);
        let depths = around(found.depth - top, spacing[1]).map(|depth| depth.clamp(0.0, deepest));
        let rows: Vec<Row> = depths.map(|depth| Row { stratum, depth, set: 0 }).collect();
        let precision = if time + CLOSELY < TIMES { waves::ROUGH } else { waves::STRESSES };
        found = largest(field, &rows, &[xs], &precision)?.ok_or_else(nothing)?.0;
        spacing = spacing.map(|step| SHRINKS * step);
    }
    Ok(MaxShear { value: found.max_shear(), x: found.x, depth: found.depth, layer: found.layer })
}

/// From 0 on to an end.
fn steps(end: f64) -> impl Iterator<Item = f64> {
    (0..PLACES).map(move |k| end * k as f64 / (PLACES - 1) as f64)
}

/// The point of the largest shear stress, and its stratum.
fn largest(
    field: &Field,
    rows: &[Row],
    sets: &[Vec<f64>],
    precision: &Precision,
) -> Result<Option<(FieldPoint, usize)>, Error> {
    let mut best: Option<(FieldPoint, usize)> = None;
    for (row, values) in rows.iter().zip(field.sum(rows, sets, precision)?) {
        for (x, value) in sets[row.set].iter().zip(values) {
            let point = field.point(*x, row, value);
            let better = best.as_ref().is_none_or(|(best, stratum)| {
                let margin = if *stratum == row.stratum { 1.0 } else { LARGER };
                point.max_shear() > margin * best.max_shear()
            });
            if better {
                best = Some((point, row.stratum));
            }
        }
    }
    Ok(best)
}
