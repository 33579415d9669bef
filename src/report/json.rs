//! One JSON object; its keys are stable, more may be added. What is infinite is `null`, as JSON has no such numbers.
use std::io;

use serde_json::{Map, Value, json};

use super::{Report, extremes};
use crate::approach::{Approach, ApproachError, Stiffness};
use crate::scene::{Dimension, visible_json};
use crate::solution::{Carried, ClosedInterface, Contact, Warning};

pub(super) fn write(report: &Report, out: &mut dyn io::Write) -> io::Result<()> {
    let Report { scene, solution, .. } = report;
    let units = scene.units.as_ref().map(|units| {
        let [length, force, stress] =
            [Dimension::LENGTH, scene.force_dimension(), Dimension::STRESS].map(|dimension| units.symbol(dimension));
        json!({"length": length, "force": force, "stress": stress})
    });
    let contacts = report.contacts();
    let axis = |k: usize| solution.axes().get(k).map(|axis| json!({"at": axis}));
    let contact =
        |(k, (name, own)): (usize, &(String, Contact))| joined([contact(name, own)].into_iter().chain(axis(k)));
    let contacts = contacts.iter().enumerate().map(contact).chain(solution.closed().iter().map(closed));
    let contacts: Vec<Value> = contacts.collect();
    let of_each = |k: usize| report.approaches.get(k).and_then(|found| found.as_ref().ok());
    let punch = |(k, carried): (usize, &Carried)| {
        let approach = json!({
            "approach": of_each(k).map(|found| found.value),
            "approach_error": of_each(k).map(|found| found.error),
            "stiffness": of_each(k).and_then(|found| found.stiffness.value()),
            "stiffness_error": of_each(k).and_then(|found| found.stiffness.error()),
        });
        joined([approach, json!(carried)])
    };
    let punches: Vec<Value> = solution.punches().iter().enumerate().map(punch).collect();
    let warning = |warning: &Warning| json!({"code": warning.code.as_str(), "message": warning.message});
    let parts = [
        Some(json!({"scene": scene.title(), "units": units, "contacts": contacts})),
        (!punches.is_empty()).then(|| json!({"punches": punches})),
        (!solution.is_even()).then(|| json!({"rotations": solution.rotations()})),
        Some(json!({"force": solution.force(), "force_error": solution.force_error()})),
        report.separation.map(|own| {
            json!({
                "critical_force": own.critical_force,
                "critical_force_error": own.critical_force_error,
                "first_separation": {"x": own.x, "interface": own.interface},
            })
        }),
        match report.approaches {
            [] => None,
            [one] => Some(approach(one)),
            _ => Some(approach(&Err(ApproachError::Punches))),
        },
        Some(json!({"min_pressure": solution.min_pressure(), "min_gap": solution.min_gap()})),
        report.collocated.map(|checked| json!({"collocation": checked})),
        report.max_shear.map(|max| json!({"max_shear": max})),
        report.extremes.map(|found| json!({"extremes": extremes::json(scene, found)})),
        Some(json!({
            "modes": solution.modes(),
            "wavenumbers": solution.wavenumbers(),
            "newton_steps": solution.newton_steps(),
            "seconds": report.seconds,
            "stats": solution.stats(),
            "warnings": solution.warnings().iter().map(warning).collect::<Vec<_>>(),
        })),
    ];
    writeln!(out, "{}", visible_json(&serde_json::to_string_pretty(&joined(parts.into_iter().flatten()))?))
}

/// One object with the keys of several, in this order.
fn joined(objects: impl IntoIterator<Item = Value>) -> Value {
    let fields = |object| if let Value::Object(fields) = object { fields } else { Map::new() };
    Value::Object(objects.into_iter().flat_map(fields).collect())
}

/// `half_length` is `null` unless the contact is one interval about x = 0.
fn contact(name: &str, contact: &Contact) -> Value {
    let peak = contact.peak();
    let error = |of: f64, error: f64| of.is_finite().then_some(error);
    json!({
        "interface": name,
        "half_length": contact.half_length(),
        "half_length_error": contact.half_length_error(),
        "central_pressure": contact.central_pressure,
        "central_pressure_error": error(contact.central_pressure, contact.central_pressure_error),
        "peak_pressure": peak.pressure,
        "peak_pressure_error": error(peak.pressure, peak.error),
        "peak_at": peak.x,
        "peak_at_error": peak.x_error,
        "resultant": contact.resultant,
        "intervals": contact.intervals(),
    })
}

/// An interface that weights keep closed has openings in place of intervals.
fn closed(own: &ClosedInterface) -> Value {
    joined([
        json!({"half_length": null, "half_length_error": null, "intervals": null, "closed": own.openings.is_empty()}),
        json!(own),
    ])
}

/// `null` where there is none, for a reason.
fn approach(found: &Result<Approach, ApproachError>) -> Value {
    let note = match found {
        Ok(Approach { stiffness: Stiffness::NotComputed, .. }) => {
            Some("the equations for the stiffness could not be solved".to_owned())
        }
        Ok(_) => None,
        Err(reason) => Some(reason.to_string()),
    };
    let found = found.as_ref().ok();
    json!({
        "approach": found.map(|found| found.value),
        "approach_error": found.map(|found| found.error),
        "stiffness": found.and_then(|found| found.stiffness.value()),
        "stiffness_error": found.and_then(|found| found.stiffness.error()),
        "approach_note": note,
    })
}
