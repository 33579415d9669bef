//! One JSON object; its keys are stable, more may be added.
use std::io;

use serde::Serialize;

use super::Report;
use crate::solution;

#[derive(Serialize)]
struct Document<'a> {
    scene: &'a str,
    contacts: Vec<Contact>,
    force: f64,
    force_error: f64,
    min_pressure: f64,
    min_gap: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    max_shear: Option<MaxShear>,
    modes: usize,
    wavenumbers: usize,
    newton_steps: usize,
    seconds: f64,
    stats: Stats<'a>,
    warnings: &'a [String],
}

#[derive(Serialize)]
struct MaxShear {
    value: f64,
    x: f64,
    depth: f64,
    layer: usize,
}

#[derive(Serialize)]
struct Stats<'a> {
    layers_dropped: usize,
    layers_merged: usize,
    wavenumbers: usize,
    layers_evaluated: usize,
    layers_repeated: usize,
    layers_below_decay_depth: usize,
    couplings_vanished: usize,
    wavenumbers_interpolated: usize,
    modes: &'a [usize],
    newton_steps: &'a [usize],
    factorisations: usize,
}

impl<'a> Stats<'a> {
    fn of(stats: &'a crate::solution::Stats) -> Self {
        Self {
            layers_dropped: stats.dropped,
            layers_merged: stats.merged,
            wavenumbers: stats.wavenumbers,
            layers_evaluated: stats.layers,
            layers_repeated: stats.repeated,
            layers_below_decay_depth: stats.below_decay_depth,
            couplings_vanished: stats.uncoupled,
            wavenumbers_interpolated: stats.interpolated,
            modes: &stats.modes,
            newton_steps: &stats.newton_steps,
            factorisations: stats.factorisations,
        }
    }
}

#[derive(Serialize)]
struct Contact {
    interface: String,
    half_length: f64,
    half_length_error: f64,
    /// `null` if it is infinite.
    central_pressure: Option<f64>,
    central_pressure_error: Option<f64>,
    resultant: f64,
    /// Not written unless the bodies are apart about x = 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    opening: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    opening_error: Option<f64>,
    /// Not written if the contact is one interval.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    parts: Vec<Part>,
}

#[derive(Serialize)]
struct Part {
    from: f64,
    from_error: f64,
    to: f64,
    to_error: f64,
}

impl Part {
    fn of(part: &solution::Part) -> Self {
        let solution::Part { from, from_error, to, to_error } = *part;
        Self { from, from_error, to, to_error }
    }
}

pub(super) fn write(report: &Report, out: &mut dyn io::Write) -> io::Result<()> {
    let solution = report.solution;
    let contacts = solution.contacts().iter().map(|contact| Contact {
        interface: report.name(contact),
        half_length: contact.half_length,
        half_length_error: contact.half_length_error,
        central_pressure: finite(contact.central_pressure),
        central_pressure_error: finite(contact.central_pressure).map(|_| contact.central_pressure_error),
        resultant: contact.resultant,
        opening: (contact.opening > 0.0).then_some(contact.opening),
        opening_error: (contact.opening > 0.0).then_some(contact.opening_error),
        parts: contact.parts.iter().map(Part::of).collect(),
    });
    let document = Document {
        scene: report.scene.title(),
        contacts: contacts.collect(),
        force: solution.force(),
        force_error: solution.force_error(),
        min_pressure: solution.min_pressure(),
        min_gap: solution.min_gap(),
        max_shear: report.max_shear.map(|max| MaxShear {
            value: max.value,
            x: max.x,
            depth: max.depth,
            layer: max.layer,
        }),
        modes: solution.modes(),
        wavenumbers: solution.wavenumbers(),
        newton_steps: solution.newton_steps(),
        seconds: report.seconds,
        stats: Stats::of(solution.stats()),
        warnings: solution.warnings(),
    };
    serde_json::to_writer_pretty(&mut *out, &document)?;
    writeln!(out)
}

/// JSON has no infinite numbers.
fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}
