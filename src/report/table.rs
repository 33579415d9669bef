//! Tables to be read, and counts of what was computed, one line for each.
use std::{fmt, io};

use comfy_table::Table;

use super::digits::{Digits, to_digits};
use super::ruled::ruled;
use super::{Report, extremes};
use crate::approach::{Approach, Stiffness};
use crate::collocation::Collocated;
use crate::field::MaxShear;
use crate::geometry::Words;
use crate::scene::{Dimension, visible};
use crate::solution::{Carried, Interval, Opening, Separation, Stats};

pub(super) fn write(report: &Report, out: &mut dyn io::Write) -> io::Result<()> {
    let Report { scene, solution, approaches, max_shear, digits, seconds, .. } = report;
    let units = [Dimension::LENGTH, Dimension::STRESS, scene.force_dimension()].map(|of| report.unit(of));
    let [length, stress, line_load] = units.each_ref().map(|unit| &unit[..]);

    writeln!(out, "{}", visible(scene.title()))?;
    if let Some(description) = &scene.description {
        writeln!(out, "{}", visible(description))?;
    }
    let digits = Digits(*digits);
    let force = digits.with_error(solution.force(), solution.force_error());
    if solution.force() > 0.0 {
        writeln!(out, "{}, force {force}{line_load}", scene.top.label(scene.geometry))?;
        writeln!(out, "{}", contacts(report, [length, stress, line_load]))?;
    } else {
        writeln!(out, "no load")?;
    }
    notes(report, [length, stress, line_load], out)?;
    closed(report, [length, stress, line_load], out)?;
    for Collocated { interface, residual, pressure_difference, nodes } in report.collocated.unwrap_or_default() {
        let [residual, off] = [residual.abs(), *pressure_difference].map(|number| format!("{number:.0e}"));
        writeln!(out, "{interface} by collocation with {nodes} nodes: residual {residual}, pressures differ by {off}")?;
    }
    let of_stiffness = if scene.geometry.is_axisymmetric() { Dimension::FORCE_PER_LENGTH } else { Dimension::STRESS };
    let Words { along, distance, .. } = scene.geometry.words();
    let approach = |k: usize| approaches.get(k).and_then(|found| found.as_ref().ok());
    let sunk = |found: &Approach| {
        let stiffness = match found.stiffness {
            Stiffness::Known { value, error } => {
                format!("stiffness {}{}", digits.with_error(value, error), report.unit(of_stiffness))
            }
            Stiffness::NotComputed => "stiffness not found".to_owned(),
        };
        format!("approach {}{length}, {stiffness}", digits.with_error(found.value, found.error))
    };
    match (solution.punches(), approach(0)) {
        ([], Some(approach)) => writeln!(out, "{}", sunk(approach))?,
        (punches, _) => {
            let force_unit = report.unit(Dimension::FORCE);
            for (k, Carried { tilt, moment, .. }) in punches.iter().enumerate() {
                let name = if punches.len() == 1 { "punch".to_owned() } else { format!("punch {}", k + 1) };
                let sunk = approach(k).map_or_else(String::new, |found| format!("{}, ", sunk(found)));
                let [tilt, moment] = [tilt, moment].map(|number| to_digits(*number, 6));
                writeln!(out, "{name}: {sunk}tilt {tilt}, moment about the tip {moment}{force_unit}")?;
            }
        }
    }
    if let Some(MaxShear { value, x, depth, layer }) = max_shear {
        let (value, x, depth) = (to_digits(*value, 5), to_digits(*x, 4), to_digits(*depth, 4));
        let place = format!("{along} = {x}{length}, depth {depth}{length} in {}", scene.layer_label(*layer));
        writeln!(out, "largest shear stress {value}{stress} at {place}")?;
    }
    if let Some(extremes) = report.extremes {
        let place = if solution.is_even() { distance } else { along };
        writeln!(out, "{}", extremes::table(scene, extremes, place, digits, [length, stress]))?;
    }
    let [modes, wavenumbers, steps] = [solution.modes(), solution.wavenumbers(), solution.newton_steps()];
    writeln!(out, "{modes} modes, {wavenumbers} wavenumbers, {steps} Newton steps, {}", duration(*seconds))
}

/// A line for each contact.
fn contacts(report: &Report, [length, stress, line_load]: [&str; 3]) -> Table {
    let (digits, words) = (Digits(report.digits), report.scene.geometry.words());
    let pressure = format!("pressure at {} = 0", words.along);
    let mut table =
        ruled([("contact", ""), (words.half_length, length), (&pressure, stress), ("resultant", line_load)]);
    for (name, contact) in report.contacts() {
        table.add_row([
            name,
            match (contact.half_length(), contact.half_length_error()) {
                (Some(half_length), Some(error)) => digits.with_error(half_length, error),
                _ => "see below".to_owned(),
            },
            digits.or_infinite(contact.central_pressure, contact.central_pressure_error),
            digits.rounded(contact.resultant),
        ]);
    }
    table
}

/// Below the table: contacts of several intervals, largest pressures away from x = 0, and what an infinite pressure means.
fn notes(report: &Report, [length, stress, line_load]: [&str; 3], out: &mut dyn io::Write) -> io::Result<()> {
    let (solution, digits) = (report.solution, Digits(report.digits));
    for ((name, _), [x, y]) in report.contacts().iter().zip(solution.axes()) {
        writeln!(
            out,
            "{name}: about the axis at x = {}{length}, y = {}{length}",
            digits.rounded(*x),
            digits.rounded(*y)
        )?;
    }
    let Words { along, distance, line_load: concentrated, .. } = report.scene.geometry.words();
    for (name, contact) in report.contacts() {
        let is_even = contact.is_even();
        if contact.half_length().is_none() || !is_even {
            // of an even contact x ≥ 0 only: the rest is the mirror image, or the other half of a ring
            for &Interval { left, left_error, right, right_error, force, .. } in contact.intervals() {
                let share = digits.rounded(force) + line_load;
                let (from, to) = (place(digits, left, left_error), place(digits, right, right_error) + length);
                let carried = match left + right {
                    0.0 if right > 0.0 => format!("{distance} < {to} carries {share}"),
                    0.0 => format!("{along} = 0 carries {share}"),
                    _ if !is_even && left == right => format!("{along} = {to} carries {share}"),
                    _ if !is_even => format!("{along} from {from} to {to} carries {share}"),
                    middle if middle < 0.0 => continue,
                    _ if report.scene.geometry.is_axisymmetric() => {
                        format!("{along} from {from} to {to} carries {}", digits.rounded(2.0 * force) + line_load)
                    }
                    _ if left == right => format!("{along} = {to} and {along} = -{to} carry {share} each"),
                    _ => format!("{along} from {from} to {to}, and its mirror image, carry {share} each"),
                };
                writeln!(out, "{name}: {carried}")?;
            }
        }
        let peak = contact.peak();
        if peak.x.abs() > peak.x_error {
            let place = if contact.is_even() { distance } else { along };
            let x = digits.with_error(peak.x, peak.x_error) + length;
            let unit = if peak.pressure.is_finite() { stress } else { "" };
            let pressure = digits.or_infinite(peak.pressure, peak.error) + unit;
            writeln!(out, "{name}: largest pressure {pressure} at {place} = {x}")?;
        }
    }
    if solution.contacts().iter().any(|contact| contact.central_pressure.is_infinite()) {
        writeln!(
            out,
            "infinite: under a {concentrated}, and next to a sharp tip, where it grows like the logarithm of 1/{distance}"
        )?;
    }
    Ok(())
}

/// Interfaces that weights keep closed, but for openings, and when the first of them opens.
fn closed(report: &Report, [length, stress, line_load]: [&str; 3], out: &mut dyn io::Write) -> io::Result<()> {
    let (digits, words) = (Digits(report.digits), report.scene.geometry.words());
    let is_even = report.solution.is_even();
    let along = if is_even { words.distance } else { words.along };
    for own in report.solution.closed() {
        let central = digits.with_error(own.central_pressure, own.central_pressure_error) + stress;
        writeln!(out, "{}: pressure {central} at {} = 0", own.interface, words.along)?;
        for Opening { left, right, left_error, right_error, largest_gap, largest_gap_at } in &own.openings {
            let (from, to) = (digits.with_error(*left, *left_error), digits.with_error(*right, *right_error) + length);
            let [gap, at] = [largest_gap, largest_gap_at].map(|number| to_digits(*number, 6) + length);
            writeln!(out, "{}: open from {} = {from} to {to}, largest gap {gap} at {at}", own.interface, words.along)?;
        }
        if own.openings.is_empty() {
            let [least, at] = [own.smallest_pressure, own.smallest_at].map(|number| to_digits(number, 6));
            let name = own.interface;
            writeln!(out, "{name}: closed everywhere, smallest pressure {least}{stress} at {along} = {at}{length}")?;
        }
    }
    if let Some(Separation { critical_force, critical_force_error, interface, x }) = &report.separation {
        let force = digits.with_error(*critical_force, *critical_force_error) + line_load;
        writeln!(out, "{interface} begins to open at {along} = {}{length} under the force {force}", to_digits(*x, 6))?;
    }
    Ok(())
}

/// A place that is given, or one that was found.
fn place(digits: Digits, x: f64, error: f64) -> String {
    if error == 0.0 { digits.rounded(x) } else { digits.with_error(x, error) }
}

fn duration(seconds: f64) -> String {
    if seconds < 1.0 { format!("{:.1} ms", 1e3 * seconds) } else { format!("{seconds:.1} s") }
}

/// Lines with a count and what it counts.
impl fmt::Display for Stats {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{:>8} layers dropped, of no thickness", self.dropped)?;
        writeln!(f, "{:>8} layers merged with an equal neighbour", self.merged)?;
        writeln!(f, "{:>8} wavenumbers evaluated", self.wavenumbers)?;
        writeln!(f, "{:>8} layers evaluated, all wavenumbers together", self.layers)?;
        writeln!(f, "{:>8} layers skipped, in sequences that repeat others", self.repeated)?;
        writeln!(f, "{:>8} layers skipped below their decay depth", self.below_decay_depth)?;
        writeln!(f, "{:>8} values of couplings that vanish", self.uncoupled)?;
        writeln!(f, "{:>8} wavenumbers interpolated, all integrals together", self.interpolated)?;
        writeln!(f, "{:>8} modes of each contact", list(&self.modes))?;
        writeln!(f, "{:>8} Newton steps on each refinement level", list(&self.newton_steps))?;
        writeln!(f, "{:>8} factorisations", self.factorisations)
    }
}

/// Counts separated by spaces.
fn list(counts: &[impl fmt::Display]) -> String {
    counts.iter().map(|count| count.to_string()).collect::<Vec<_>>().join(" ")
}
