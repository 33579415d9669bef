//! The work of the commands on a solved scene: reports in every format, fields and pictures, and checks of these.
use std::fmt::Display;

use crate::approach::ApproachError;
use crate::field::{Extreme, Extremes, Field, FieldError, FieldPoint, FieldQuantity, Grid};
use crate::geometry::Coordinates;
use crate::model::Model;
use crate::profile::profile_places;
use crate::report::{Format, Report, write_field, write_profile};
use crate::scene::Scene;
use crate::solution::{Opening, Solution};

/// Places along x, in half-lengths of the longest contact, and depths, in units of the deepest one, of a coarse grid. None is at
/// the end of a contact, where stresses may be infinite.
const ALONG: [f64; 7] = [-1.7, -0.6, 0.0, 0.13, 0.45, 0.93, 2.1];
const DOWN: [f64; 6] = [0.0, 0.07, 0.2, 0.45, 0.8, 1.0];
/// The grid is as deep as this many half-lengths of the longest contact, or as the stack.
const DEPTH: f64 = 1.6;
/// No stress of the grid is larger than the largest by more than this part: the search for it ends with four digits.
const LARGER: f64 = 1e-3;
/// No gap is negative by more than this part of the largest.
const PENETRATION: f64 = 1e-2;
/// The stress on the loaded face is the pressure to this part of the mean pressure.
const PRESSED: f64 = 1e-5;

/// Does what `solve`, `field` and `plot` do with a solution, pictures too if requested; the error is what is wrong.
pub(super) fn run(scene: &Scene, model: &Model, solution: &Solution, pictures: bool) -> Result<(), String> {
    // under loads at several places (x, y) the vertical plane through the first axis
    let field = step("field", model.field(solution))?;
    let field = step("field", field.at_y(solution.axes().first().map_or(0.0, |[_, y]| *y)))?;
    openings(scene, model, solution)?;
    reports(scene, model, solution, &field)?;
    fields(scene, solution, &field)?;
    profile(scene, model, solution)?;
    if pictures { self::pictures(scene, model, solution, &field) } else { Ok(()) }
}

/// Layers that weights press together come apart above a critical force, and gaps are open.
fn openings(scene: &Scene, model: &Model, solution: &Solution) -> Result<(), String> {
    let separation = step("separation", model.separation(&scene.top, solution))?;
    let is_open = solution.closed().iter().any(|own| !own.openings.is_empty());
    if is_open && separation.is_some_and(|own| own.critical_force > solution.force() * (1.0 + PRESSED)) {
        return Err(format!("layers come apart below the critical force: {separation:?}"));
    }
    for own in solution.closed() {
        let is_wrong = |one: &Opening| {
            let is_ordered = one.left < one.largest_gap_at && one.largest_gap_at < one.right;
            !(is_ordered && one.largest_gap > 0.0 && one.left_error.is_finite() && one.right_error.is_finite())
        };
        if let Some(one) = own.openings.iter().find(|one| is_wrong(one)) {
            return Err(format!("the opening at {} is {one:?}", own.interface));
        }
        if !(own.smallest_pressure >= -LARGER * own.weight && own.central_pressure.is_finite()) {
            return Err(format!("tension where {} is closed: {own:?}", own.interface));
        }
    }
    Ok(())
}

/// The result of a step, whose name stands before its error.
fn step<T>(name: &str, result: Result<T, impl Display>) -> Result<T, String> {
    result.map_err(|error| format!("{name}: {error}"))
}

/// Writes the solution in every format; numbers are numbers there.
fn reports(scene: &Scene, model: &Model, solution: &Solution, field: &Field) -> Result<(), String> {
    let approaches = model.approaches(&scene.top, solution);
    for approach in &approaches {
        match approach {
            Err(ApproachError::Field(error)) => return Err(format!("approach: {error}")),
            // the tip of a turned punch may rise
            Ok(found)
                if !found.value.is_finite() || scene.top.punch().is_some() && found.value + found.error <= 0.0 =>
            {
                return Err(format!("the approach is {} ± {}", found.value, found.error));
            }
            _ => {}
        }
    }
    let searched = match field.coordinates() {
        // nowhere searched for
        Coordinates::Cartesian => None,
        _ => Some((step("largest shear stress", field.max_shear())?, step("extremes", field.extremes())?)),
    };
    let report = Report {
        scene,
        solution,
        separation: model.separation(&scene.top, solution).map_err(|error| error.to_string())?,
        approaches: &approaches,
        // it is infinite under a line load, at corners, and under some tips
        max_shear: searched.as_ref().map(|(max_shear, _)| *max_shear).filter(|found| found.value.is_finite()),
        extremes: searched.as_ref().map(|(_, extremes)| extremes),
        collocated: None,
        digits: None,
        seconds: 0.0,
    };
    for format in [Format::Table, Format::Json, Format::Csv] {
        let mut text = Vec::new();
        step("report", report.write(format, &mut text))?;
        let text = step("report", String::from_utf8(text))?;
        if text.contains("NaN") {
            return Err(format!("{format:?} report: not a number"));
        }
        if format == Format::Json {
            step("JSON report", serde_json::from_str::<serde_json::Value>(&text))?;
        }
    }
    let Some((max_shear, extremes)) = searched else { return Ok(()) };
    if max_shear.value.is_nan() || max_shear.value < 0.0 {
        return Err(format!("the largest shear stress is {}", max_shear.value));
    }
    nowhere_larger(solution, field, max_shear.value, &extremes)
}

/// The profile along x: gaps are open.
fn profile(scene: &Scene, model: &Model, solution: &Solution) -> Result<(), String> {
    let places = profile_places(solution, None, 40);
    let profile = match model.profile(&scene.top, solution, &places) {
        // next to a contact that is much shorter than another there are too many short waves
        Err(FieldError::TooFar(_)) => return Ok(()),
        profile => step("profile", profile)?,
    };
    // what is left out of an answer, and a warning tells of, may penetrate
    let is_whole = solution.warnings().iter().all(|warning| warning.code.is_about_theory());
    for contact in profile.contacts.iter().filter(|_| is_whole) {
        let gaps = contact.gap.iter().flatten().copied();
        let largest = gaps.clone().filter(|gap| gap.is_finite()).fold(0.0, f64::max);
        if let Some(gap) = gaps.filter(|gap| gap.is_nan() || *gap < -PENETRATION * largest).reduce(f64::min) {
            return Err(format!("profile: the gap at {} is {gap}, the largest {largest}", contact.interface));
        }
    }
    step("profile", write_profile(&profile, &mut Vec::new()))
}

/// The grid: places about the middle of what touches, and depths.
fn grid(solution: &Solution, field: &Field) -> [Vec<f64>; 2] {
    let bottom = field.layers().last().map_or(0.0, |(_, [_, to])| to);
    // a line load by itself has no length, nor has a half-plane: any will do
    let [left, right] = solution.ends();
    let half = Some(0.5 * (right - left)).filter(|half| *half > 0.0);
    let length = half.unwrap_or(if bottom.is_finite() { bottom } else { 1.0 });
    let deepest = bottom.min(DEPTH * length);
    [ALONG.map(|part| 0.5 * (left + right) + part * length).to_vec(), DOWN.map(|part| part * deepest).to_vec()]
}

/// No stress on a grid is larger than the largest.
fn nowhere_larger(solution: &Solution, field: &Field, max_shear: f64, extremes: &Extremes) -> Result<(), String> {
    let [xs, depths] = grid(solution, field);
    let value = |found: Extreme| found.value;
    let grids = step("field", field.by_layer(&xs, &depths))?;
    // a layer may be stretched next to nowhere: strains are as right as compressions are large
    let compressed = |layer: usize| {
        let own = grids.iter().flat_map(Grid::points).filter(|point| point.layer == layer);
        own.map(|point| point.principal_strains()[1].abs()).fold(0.0, f64::max)
    };
    let tension = extremes.tension.map_or(0.0, value);
    for point in grids.iter().flat_map(Grid::points) {
        let FieldPoint { x, depth, layer, .. } = *point;
        let own = extremes.layers.iter().find(|of| of.layer == layer);
        let strain = own.and_then(|of| of.tensile_strain).map_or(0.0, value);
        let all = [
            ("shear stress", point.max_shear(), Some(max_shear), max_shear),
            ("tension", point.principal()[0], Some(tension), max_shear),
            ("von Mises stress", point.von_mises(), own.and_then(|of| of.von_mises).map(value), max_shear),
            ("tensile strain", point.tensile_strain(), Some(strain), compressed(layer)),
        ];
        for (what, here, largest, size) in all {
            // tensions are small next to pressures, which tell how large errors are
            let is_larger = |largest: &f64| here > largest * (1.0 + LARGER) + 1e-3 * LARGER * size;
            if let Some(largest) = largest.filter(is_larger) {
                let place = format!("x = {x:e}, depth {depth:e} in layer {layer}");
                return Err(format!("{what} {here:e} at {place}, largest {largest:e}"));
            }
        }
    }
    Ok(())
}

/// Fields on a grid and their files; on the loaded face they carry the pressure.
fn fields(scene: &Scene, solution: &Solution, field: &Field) -> Result<(), String> {
    let [xs, depths] = grid(solution, field);
    let grid = step("field", field.grid(&xs, &depths))?;
    let (top, axes) = (&solution.contacts()[0], solution.axes());
    let pressure = |point: &FieldPoint| match axes {
        [] => top.pressure(point.x),
        _ => solution.load_at([point.x, point.z]),
    };
    for point in grid.points() {
        for quantity in FieldQuantity::ALL {
            let value = quantity.of(point);
            // stresses out of the plane may be unknown
            let unknown = value.is_nan() && quantity.is_out_of_plane();
            // under a line load and a tip pressures are infinite, and a half-plane sinks without end under a line load
            let infinite = pressure(point).is_infinite() && point.depth == 0.0;
            let sinks = quantity == FieldQuantity::V && top.pressure(0.0).is_infinite();
            if !(value.is_finite() || unknown || infinite || sinks) {
                let FieldPoint { x, depth, .. } = point;
                return Err(format!("field: {} is {value} at x = {x:e}, depth {depth:e}", quantity.name()));
            }
        }
    }
    for format in [Format::Csv, Format::Json] {
        step("field file", write_field(grid.points(), scene, format, &mut Vec::new()))?;
    }
    let [left, right] = top.ends();
    let mean = top.resultant / scene.geometry.size(left, right);
    for point in grid.rows().next().unwrap_or_default() {
        let FieldPoint { x, sigma_xy, sigma_yy, .. } = *point;
        let pressure = pressure(point);
        let missing = sigma_yy + pressure + scene.pressure_on_top;
        // under a tip both are infinite
        if pressure.is_finite() && !(missing.abs() <= PRESSED * mean && sigma_xy.abs() <= PRESSED * mean) {
            let what = format!("stress and pressure differ by {missing:e}, shear {sigma_xy:e}, mean pressure {mean:e}");
            return Err(format!("on the loaded face at x = {x:e}: {what}"));
        }
    }
    Ok(())
}

/// The pictures of `plot` and `field`.
#[cfg(feature = "plot")]
fn pictures(scene: &Scene, model: &Model, solution: &Solution, field: &Field) -> Result<(), String> {
    let [xs, depths] = grid(solution, field);
    let stack = crate::plot::stack(scene, model.stack(), solution);
    let grids = step("field", field.by_layer(&xs, &depths))?;
    let map = step("map", crate::plot::map(scene, solution, field, &grids, FieldQuantity::MaxShear))?;
    let profile = step("profile", model.profile(&scene.top, solution, &xs))?;
    // displacements under a line load on a half-plane are infinite
    let deformed = crate::plot::deformed(scene, model.stack(), solution, &profile, None).ok();
    let deformed = deformed.map(|picture| ("deformed stack", picture));
    for (name, picture) in [("stack", stack), ("map", map)].into_iter().chain(deformed) {
        if let Some(fault) = picture.faults().first() {
            return Err(format!("the picture of the {name}: {fault}"));
        }
        step("PNG", picture.png())?;
    }
    Ok(())
}

#[cfg(not(feature = "plot"))]
fn pictures(_: &Scene, _: &Model, _: &Solution, _: &Field) -> Result<(), String> {
    Ok(())
}
