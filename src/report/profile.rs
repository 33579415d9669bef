//! Profiles along x as comma-separated values.
use std::io;

use super::sweep::{number, owner};
use crate::field::{FieldQuantity, Side};
use crate::profile::{ContactProfile, FaceProfile, Profile};

/// The displacements of a face, in the order of the columns.
const DISPLACEMENTS: [FieldQuantity; 2] = [FieldQuantity::U, FieldQuantity::V];

/// Writes a profile: a header, then one line for each place, with all digits. What is infinite, or is not there, is empty.
///
/// ```
/// use recede::{Model, Scene, profile_places, report::write_profile};
/// let scene = Scene::read("examples/scenes/two_strips.ron")?;
/// let model = Model::new(scene.stack()?)?;
/// let solution = model.press(&scene.punch, scene.force)?;
/// let profile = model.profile(&scene.punch, &solution, &profile_places(&solution, None, 100))?;
/// let mut text = Vec::new();
/// write_profile(&profile, &mut text)?;
/// assert!(text.starts_with(b"x,punch_pressure,punch_gap,contact_1_2_pressure,contact_1_2_gap,"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Those of the writer.
pub fn write_profile(profile: &Profile, out: &mut dyn io::Write) -> io::Result<()> {
    let of_contact = |contact: &ContactProfile| {
        let gap = contact.gap.as_ref().map(|_| "gap");
        ["pressure"]
            .into_iter()
            .chain(gap)
            .map(|what| format!("{}_{what}", owner(&contact.interface)))
            .collect::<Vec<_>>()
    };
    let of_face = |face: &FaceProfile| {
        let side = match face.side {
            Side::Top => "top",
            Side::Bottom => "bottom",
        };
        let [u, v] = DISPLACEMENTS.map(|quantity| quantity.name_in(profile.geometry));
        [u, v, "slope"].map(|what| format!("layer_{}_{side}_{what}", face.layer))
    };
    let contacts = profile.contacts.iter().flat_map(of_contact);
    let header: Vec<String> =
        ["x".to_owned()].into_iter().chain(contacts).chain(profile.faces.iter().flat_map(of_face)).collect();
    writeln!(out, "{}", header.join(","))?;
    for (k, x) in profile.x.iter().enumerate() {
        let contacts = profile
            .contacts
            .iter()
            .flat_map(|contact| [contact.pressure[k]].into_iter().chain(contact.gap.as_ref().map(|gap| gap[k])));
        let faces = profile.faces.iter().flat_map(|face| {
            let point = &face.points[k];
            let values = DISPLACEMENTS.map(|quantity| quantity.of_in(point, profile.geometry));
            values.into_iter().chain([point.slope])
        });
        let numbers: Vec<String> = [*x].into_iter().chain(contacts).chain(faces).map(number).collect();
        writeln!(out, "{}", numbers.join(","))?;
    }
    Ok(())
}
