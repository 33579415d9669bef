//! Comma-separated values: one line for each contact.
use std::io;

use super::Report;
use super::sweep::number;

pub(super) fn write(report: &Report, out: &mut dyn io::Write) -> io::Result<()> {
    writeln!(out, "interface,half_length,half_length_error,central_pressure,central_pressure_error,resultant")?;
    for contact in report.solution.contacts() {
        // neither names nor numbers need quotes; `{:?}` prints as many digits as identify the number
        writeln!(
            out,
            "{},{:?},{:?},{},{},{:?}",
            report.name(contact),
            contact.half_length,
            contact.half_length_error,
            number(contact.central_pressure),
            number(contact.central_pressure_error),
            contact.resultant
        )?;
    }
    Ok(())
}
