//! Reports on a solved scene: the same numbers in several formats. Nothing is computed here.
mod csv;
mod digits;
mod extremes;
mod field;
mod json;
#[cfg(feature = "parquet")]
mod parquet;
mod ruled;
mod sweep;
mod table;

use std::io;

pub use field::{field_columns, profile_columns, write_field, write_profile};

use crate::approach::{Approach, ApproachError};
use crate::collocation::Collocated;
use crate::field::{Extremes, MaxShear};
use crate::scene::{Dimension, Scene, Units};
use crate::solution::{Contact, Separation, Solution};

#[cfg(feature = "parquet")]
pub use parquet::SweepParquet;
#[doc(hidden)]
pub use ruled::ruled;
pub use sweep::SweepCsv;

/// How a report, or a field, is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum Format {
    /// A table to be read
    ///
    /// It has the digits that the error estimates justify; of a field five digits, and no stresses that follow from others.
    #[default]
    Table,
    /// One JSON object, all digits
    Json,
    /// One line for each contact or point, all digits
    ///
    /// Comma-separated values, with a header.
    Csv,
}

/// A solved scene, and the results that are reported with it.
///
/// ```no_run
/// use recede::{Scene, report::{Format, Report}};
/// let scene = Scene::read("examples/scenes/hertz.ron")?;
/// let solution = recede::solve(&scene)?;
/// let report = Report { scene: &scene, solution: &solution, separation: None, approaches: &[], max_shear: None, extremes: None,
///     collocated: None, digits: None, seconds: 0.0 };
/// report.write(Format::Csv, &mut std::io::stdout())?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Report<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// Its solution.
    pub solution: &'a Solution,
    /// When layers that weights press together come apart, if there are any: see [`crate::Model::separation`].
    pub separation: Option<Separation>,
    /// The approach of each punch and the stiffness, none if they were not requested: see [`crate::Model::approaches`].
    pub approaches: &'a [Result<Approach, ApproachError>],
    /// The largest shear stress, if it was requested: see [`crate::Field::max_shear`].
    pub max_shear: Option<MaxShear>,
    /// Stresses by which layers and bonds break, if they were requested: see [`crate::Field::extremes`].
    pub extremes: Option<&'a Extremes>,
    /// The check of each contact by collocation, if it was requested: see [`crate::Model::collocate`].
    pub collocated: Option<&'a [Collocated]>,
    /// Significant digits of the numbers in a table, at most; `None` shows as many as their errors justify.
    pub digits: Option<usize>,
    /// Time it took, in seconds.
    pub seconds: f64,
}

impl Report<'_> {
    /// The names and contacts from the top down; the contact under each of several punches stands by itself.
    fn contacts(&self) -> Vec<(String, Contact)> {
        let of = |contact: &Contact| {
            let each = contact.of_each_punch();
            let (name, is_one) = (self.scene.top.contact_name(contact.interface), each.len() == 1);
            let name = |k: usize| if is_one { name.clone() } else { format!("{name} {}", k + 1) };
            each.into_iter().enumerate().map(|(k, own)| (name(k), own)).collect::<Vec<_>>()
        };
        // without a load there is none
        let pressed = self.solution.contacts().iter().filter(|contact| contact.resultant != 0.0);
        let mut all: Vec<(String, Contact)> = pressed.flat_map(of).collect();
        if self.solution.axes().len() > 1 {
            all.iter_mut().enumerate().for_each(|(k, (name, _))| *name = format!("{name} {}", k + 1));
        }
        all
    }

    /// The unit behind a number, with a space; empty if the scene does not name its units.
    fn unit(&self, dimension: Dimension) -> String {
        Units::after(self.scene.units.as_ref(), dimension)
    }

    /// Writes the report.
    ///
    /// # Errors
    /// Errors of the writer.
    pub fn write(&self, format: Format, out: &mut dyn io::Write) -> io::Result<()> {
        match format {
            Format::Table => table::write(self, out),
            Format::Json => json::write(self, out),
            Format::Csv => csv::write(self, out),
        }
    }
}
