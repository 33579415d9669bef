//! The largest shear stress.
use super::sum::Row;
use super::{Field, FieldPoint};
use crate::error::Error;

/// Places along x and depths of a layer at which the search begins.
const PLACES: usize = 24;
const DEPTHS: usize = 17;
/// The mesh shrinks by this factor around the largest value, so many times.
const SHRINKS: f64 = 0.25;
const TIMES: i32 = 8;
/// Points to either side in the finer meshes.
const BESIDE: i32 = 3;
/// A value has to be larger by this part to be preferred: at a bond that joins equal materials both layers have it.
const LARGER: f64 = 1.0 + 1e-9;
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
    let mut best: Option<(FieldPoint, usize, [f64; 2])> = None;
    for (i, stratum) in field.strata.iter().enumerate() {
        // the contacts next to the layer decide how fine the mesh has to be
        let body = &field.bodies[stratum.body];
        let own = field.pressures[body.contact..].iter().take(2).map(|pressure| pressure.half_length);
        let shortest = own.fold(longest, f64::min);
        let deepest = stratum.thickness.unwrap_or(FAR * longest);
        let mut xs: Vec<f64> = steps(FAR * shortest).chain(steps(1.5 * longest)).collect();
        xs.sort_by(f64::total_cmp);
        // dense next to both faces
        let depths: Vec<f64> = (0..=DEPTHS)
            .map(|k| k as f64 / DEPTHS as f64)
            .map(|t| if stratum.thickness.is_some() { t * t * (3.0 - 2.0 * t) } else { t * t })
            .chain([1.0 / 64.0, 1.0 / 256.0].into_iter().filter(|part| part * deepest > 0.0))
            .map(|part| part * deepest)
            .chain((1..8).map(|k| 0.2 * f64::from(k) * shortest).filter(|depth| *depth < deepest))
            .collect();
        let rows: Vec<Row> = depths.iter().map(|depth| Row { stratum: i, depth: *depth, set: 0 }).collect();
        let spacing = [shortest / 8.0, (shortest / 8.0).min(deepest / DEPTHS as f64)];
        keep(field, &rows, &[xs], spacing, &mut best)?;
    }
    let Some((mut found, stratum, mut spacing)) = best else {
        return Err(Error::Unresolved { wavenumber: 0.0 });
    };
    let (top, deepest) = (field.strata[stratum].top, field.strata[stratum].thickness.unwrap_or(f64::INFINITY));
    for _ in 0..TIMES {
        let around = |centre: f64, step: f64| (-BESIDE..=BESIDE).map(move |k| centre + f64::from(k) * step);
        let mut xs: Vec<f64> = around(found.x, spacing[0]).map(f64::abs).collect();
        xs.sort_by(f64::total_cmp);
        let depths = around(found.depth - top, spacing[1]).map(|depth| depth.clamp(0.0, deepest));
        let rows: Vec<Row> = depths.map(|depth| Row { stratum, depth, set: 0 }).collect();
        let mut best = Some((found, stratum, spacing));
        keep(field, &rows, &[xs], spacing, &mut best)?;
        if let Some((better, ..)) = best {
            found = better;
        }
        spacing = spacing.map(|step| SHRINKS * step);
    }
    Ok(MaxShear { value: found.max_shear(), x: found.x, depth: found.depth, layer: found.layer })
}

/// From 0 on to an end.
fn steps(end: f64) -> impl Iterator<Item = f64> {
    (0..PLACES).map(move |k| end * k as f64 / (PLACES - 1) as f64)
}

/// Keeps the point of the largest shear stress among rows of one stratum.
fn keep(
    field: &Field,
    rows: &[Row],
    sets: &[Vec<f64>],
    spacing: [f64; 2],
    best: &mut Option<(FieldPoint, usize, [f64; 2])>,
) -> Result<(), Error> {
    for (row, values) in rows.iter().zip(field.sum(rows, sets)?) {
        for (x, value) in sets[row.set].iter().zip(values) {
            let point = field.point(*x, row, value);
            let better = best.as_ref().is_none_or(|(best, stratum, _)| {
                let margin = if *stratum == row.stratum { 1.0 } else { LARGER };
                point.max_shear() > margin * best.max_shear()
            });
            if better {
                *best = Some((point, row.stratum, spacing));
            }
        }
    }
    Ok(())
}
