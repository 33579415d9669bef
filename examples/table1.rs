//! Table 1 of the source paper (`docs/references.md`), a strip on a half-plane: its values, those computed here, and the differences.
//!
//! `cargo run --release --example table1`
mod paper;

/// Prints the table and checks it.
pub fn main() -> Result<(), recede::Error> {
    let table = paper::table("table1")?;
    println!("{table}");
    assert!(table.wrong().is_empty(), "further off than the paper's method explains: {:#?}", table.wrong());
    Ok(())
}
