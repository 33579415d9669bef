//! One JSON object; its keys are stable, more may be added.
use std::io;

use serde::Serialize;

use super::{Report, extremes};
use crate::approach::{self, ApproachError, Stiffness};
use crate::collocation::Collocated;
use crate::scene::{self, Dimension, visible_json};
use crate::solution;

#[derive(Serialize)]
struct Document<'a> {
    scene: &'a str,
    units: Option<Units>,
    contacts: Vec<Contact>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    punches: Vec<Punch>,
    force: f64,
    force_error: f64,
    #[serde(flatten)]
    approach: Option<Approach>,
    min_pressure: f64,
    min_gap: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    collocation: Option<&'a [Collocated]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    max_shear: Option<MaxShear>,
    #[serde(skip_serializing_if = "Option::is_none")]
    extremes: Option<extremes::Document>,
    modes: usize,
    wavenumbers: usize,
    newton_steps: usize,
    seconds: f64,
    stats: Stats<'a>,
    warnings: Vec<Warning<'a>>,
}

/// What numbers are in, where the scene names its units.
#[derive(Serialize)]
struct Units {
    length: String,
    force: String,
    stress: String,
}

impl Units {
    fn of(units: &scene::Units, of_force: Dimension) -> Self {
        let [length, force, stress] =
            [Dimension::LENGTH, of_force, Dimension::STRESS].map(|dimension| units.symbol(dimension));
        Self { length, force, stress }
    }
}

#[derive(Serialize)]
struct Warning<'a> {
    code: &'static str,
    message: &'a str,
}

impl<'a> Warning<'a> {
    fn of(warning: &'a solution::Warning) -> Self {
        Self { code: warning.code.as_str(), message: &warning.message }
    }
}

/// `null` where there is none, for a reason.
#[derive(Serialize)]
struct Approach {
    approach: Option<f64>,
    approach_error: Option<f64>,
    stiffness: Option<f64>,
    stiffness_error: Option<f64>,
    approach_note: Option<String>,
}

impl Approach {
    fn of(found: &Result<approach::Approach, ApproachError>) -> Self {
        let stiffness = found.as_ref().ok().map(|found| found.stiffness);
        let note = match found {
            Ok(found) if found.stiffness == Stiffness::NotComputed => {
                Some("the stiffness is not computed for these contacts".to_owned())
            }
            Ok(_) => None,
            Err(reason) => Some(reason.to_string()),
        };
        Self {
            approach: found.as_ref().ok().map(|found| found.value),
            approach_error: found.as_ref().ok().map(|found| found.error),
            stiffness: stiffness.and_then(Stiffness::value),
            stiffness_error: stiffness.and_then(Stiffness::error),
            approach_note: note,
        }
    }
}

/// One of several punches.
#[derive(Serialize)]
struct Punch {
    /// `null`: it is not computed yet.
    approach: Option<f64>,
    #[serde(flatten)]
    carried: solution::Carried,
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
    stopped: Vec<String>,
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
            stopped: stats.stopped.iter().map(ToString::to_string).collect(),
            factorisations: stats.factorisations,
        }
    }
}

#[derive(Serialize)]
struct Contact {
    interface: String,
    /// `null` unless the contact is one interval about x = 0.
    half_length: Option<f64>,
    half_length_error: Option<f64>,
    /// `null` if it is infinite.
    central_pressure: Option<f64>,
    central_pressure_error: Option<f64>,
    /// `null` if it is infinite.
    peak_pressure: Option<f64>,
    peak_pressure_error: Option<f64>,
    peak_at: f64,
    peak_at_error: f64,
    resultant: f64,
    intervals: Vec<solution::Interval>,
}

impl Contact {
    fn of(name: String, contact: &solution::Contact) -> Self {
        let peak = contact.peak();
        Self {
            interface: name,
            half_length: contact.half_length(),
            half_length_error: contact.half_length_error(),
            central_pressure: finite(contact.central_pressure),
            central_pressure_error: finite(contact.central_pressure).map(|_| contact.central_pressure_error),
            peak_pressure: finite(peak.pressure),
            peak_pressure_error: finite(peak.pressure).map(|_| peak.error),
            peak_at: peak.x,
            peak_at_error: peak.x_error,
            resultant: contact.resultant,
            intervals: contact.intervals().to_vec(),
        }
    }
}

pub(super) fn write(report: &Report, out: &mut dyn io::Write) -> io::Result<()> {
    let solution = report.solution;
    let contacts = report.contacts().into_iter().map(|(name, contact)| Contact::of(name, &contact));
    let document = Document {
        scene: report.scene.title(),
        units: report.scene.units.as_ref().map(|units| Units::of(units, report.force())),
        contacts: contacts.collect(),
        punches: solution.punches().iter().map(|carried| Punch { approach: None, carried: *carried }).collect(),
        force: solution.force(),
        force_error: solution.force_error(),
        approach: report.approach.map(Approach::of),
        min_pressure: solution.min_pressure(),
        min_gap: solution.min_gap(),
        collocation: report.collocated,
        max_shear: report.max_shear.map(|max| MaxShear {
            value: max.value,
            x: max.x,
            depth: max.depth,
            layer: max.layer,
        }),
        extremes: report.extremes.map(extremes::Document::of),
        modes: solution.modes(),
        wavenumbers: solution.wavenumbers(),
        newton_steps: solution.newton_steps(),
        seconds: report.seconds,
        stats: Stats::of(solution.stats()),
        warnings: solution.warnings().iter().map(Warning::of).collect(),
    };
    writeln!(out, "{}", visible_json(&serde_json::to_string_pretty(&document)?))
}

/// JSON has no infinite numbers.
fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}
