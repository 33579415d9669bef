//! Comma-separated values: one line for each contact.
use std::io;

use super::Report;
use super::sweep::number;
use crate::solution::Contact;

pub(super) fn write(report: &Report, out: &mut dyn io::Write) -> io::Result<()> {
    writeln!(out, "interface,{},resultant", Contact::COLUMNS.join(","))?;
    for (name, contact) in report.contacts() {
        // neither names nor numbers need quotes; `{:?}` prints as many digits as identify the number
        let numbers = contact.numbers().map(number).join(",");
        writeln!(out, "{name},{numbers},{:?}", contact.resultant)?;
    }
    Ok(())
}
