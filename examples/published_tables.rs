//! Published numbers that can be computed again: printed and computed values, and their differences. Writes
//! docs/published_tables.md.
//!
//! `cargo run --release --example published_tables`
mod paper;
mod published;

use std::error::Error;
use std::fs;
use std::path::Path;

use published::Table;

/// Writes the tables.
pub fn main() -> Result<(), Box<dyn Error>> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/published_tables.md");
    Ok(fs::write(file, written()?)?)
}

/// The document; every number in it is checked.
pub fn written() -> Result<String, Box<dyn Error>> {
    let tables = published::sources::tables()?;
    tables.iter().for_each(check);
    Ok(published::markdown(&tables))
}

/// Differences are within the stated bounds, and the computed numbers are accurate enough to assess the published ones.
fn check(table: &Table) {
    for number in &table.numbers {
        let of = format!("{}, {}, {}", table.title, number.of, number.quantity);
        assert!(table.allows(number), "{of}: {} and {}", number.published, number.computed);
        assert!(number.is_certain(), "{of}: {} ± {:e}", number.computed, number.error);
    }
}
