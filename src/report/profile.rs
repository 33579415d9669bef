//! Profiles along x as comma-separated values.
use std::io;

use super::csv::write_columns;
use super::sweep::owner;
use crate::field::{FaceSide, FieldPoint, FieldQuantity};
use crate::profile::{ContactProfile, FaceProfile, FaceProfiles};

/// The displacements of a face, in the order of the columns.
const DISPLACEMENTS: [FieldQuantity; 2] = [FieldQuantity::U, FieldQuantity::V];

/// The columns of a profile by name: x, then pressure and gap of each contact, displacements and slope of each face.
pub fn profile_columns(profile: &FaceProfiles) -> Vec<(String, Vec<f64>)> {
    let mut columns = vec![("x".to_owned(), profile.x.clone())];
    for ContactProfile { interface, pressure, gap } in &profile.contacts {
        let owner = owner(interface);
        columns.push((format!("{owner}_pressure"), pressure.clone()));
        columns.extend(gap.clone().map(|gap| (format!("{owner}_gap"), gap)));
    }
    for FaceProfile { layer, side, points } in &profile.faces {
        let side = match side {
            FaceSide::Top => "top",
            FaceSide::Bottom => "bottom",
        };
        let mut add = |what: &str, of: &dyn Fn(&FieldPoint) -> f64| {
            columns.push((format!("layer_{layer}_{side}_{what}"), points.iter().map(of).collect()));
        };
        for quantity in DISPLACEMENTS {
            add(quantity.name_in(profile.geometry), &|point| quantity.of_in(point, profile.geometry));
        }
        add("slope", &|point| point.slope);
    }
    columns
}

/// Writes a profile: a header, then one line for each place, with all digits. What is infinite, or is not there, is empty.
///
/// ```
/// use recede::{Model, Scene, profile_places, report::write_profile};
/// let scene = Scene::read("examples/scenes/two_strips.ron")?;
/// let model = Model::new(scene.stack()?)?;
/// let solution = model.press(&scene.top, scene.force)?;
/// let profile = model.profile(&scene.top, &solution, &profile_places(&solution, None, 100))?;
/// let mut text = Vec::new();
/// write_profile(&profile, &mut text)?;
/// assert!(text.starts_with(b"x,punch_pressure,punch_gap,contact_1_2_pressure,contact_1_2_gap,"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Errors of the writer.
pub fn write_profile(profile: &FaceProfiles, out: &mut dyn io::Write) -> io::Result<()> {
    write_columns(&profile_columns(profile), out)
}
