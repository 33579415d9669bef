//! The contact equations of a solution in words.
use std::fmt;

use super::Interface;

/// The unknowns and the rows of the contact equations of a solution, contact by contact from the top down; as many of each. Intervals of a solution that is
/// symmetric about x = 0 count without their mirror images.
///
/// ```
/// use recede::{Model, Scene};
/// let scene = Scene::read("examples/scenes/two_strips.ron")?;
/// let model = Model::new(scene.stack()?)?;
/// let ledger = model.ledger(&scene.top, &model.press(&scene.top, scene.force)?)?;
/// let count = |entries: &[recede::LedgerEntry]| entries.iter().map(|entry| entry.count).sum::<usize>();
/// assert_eq!(count(&ledger.unknowns), count(&ledger.rows));
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ledger {
    /// What is found.
    pub unknowns: Vec<LedgerEntry>,
    /// What it is found from.
    pub rows: Vec<LedgerEntry>,
}

/// Unknowns or rows of one kind on one contact.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LedgerEntry {
    /// The contact.
    pub interface: Interface,
    /// The kind in words.
    pub kind: &'static str,
    /// How many of them there are, one at least.
    pub count: usize,
}

impl fmt::Display for Ledger {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = |entries: &[LedgerEntry]| entries.iter().map(|entry| entry.count).sum::<usize>();
        writeln!(f, "{} unknowns for {} rows", count(&self.unknowns), count(&self.rows))?;
        for (title, entries) in [("unknowns", &self.unknowns), ("rows", &self.rows)] {
            writeln!(f, "\n{title}")?;
            for LedgerEntry { interface, kind, count } in entries {
                writeln!(f, "{count:>7}  {:<6}  {kind}", interface.to_string())?;
            }
        }
        Ok(())
    }
}
