//! Comma-separated values: one line for each contact, or for each place of columns of numbers.
use std::io;

use super::Report;
use crate::solution::Contact;

pub(super) fn write(report: &Report, out: &mut dyn io::Write) -> io::Result<()> {
    writeln!(out, "interface,{},resultant", Contact::COLUMNS.join(","))?;
    for (name, contact) in report.contacts() {
        // neither names nor numbers need quotes
        let numbers = contact.numbers().map(number).join(",");
        writeln!(out, "{name},{numbers},{:?}", contact.resultant)?;
    }
    for own in report.solution.closed() {
        writeln!(out, "{},{},", own.interface, own.as_contact().map(number).join(","))?;
    }
    Ok(())
}

/// The column of numbers of layers, which are whole.
pub(super) const LAYER: &str = "layer";

/// Columns of numbers by name, all of the same length: a header, then one line for each place.
pub(super) fn write_columns(columns: &[(String, Vec<f64>)], out: &mut dyn io::Write) -> io::Result<()> {
    let names: Vec<&str> = columns.iter().map(|(name, _)| &name[..]).collect();
    writeln!(out, "{}", names.join(","))?;
    for k in 0..columns.first().map_or(0, |(_, values)| values.len()) {
        let cell = |(name, values): &(String, Vec<f64>)| match name == LAYER {
            true => values[k].to_string(),
            false => number(values[k]),
        };
        writeln!(out, "{}", columns.iter().map(cell).collect::<Vec<_>>().join(","))?;
    }
    Ok(())
}

/// A number with as many digits as identify it; empty for NaN and if it is infinite.
pub(super) fn number(value: f64) -> String {
    if value.is_finite() { format!("{value:?}") } else { String::new() }
}
