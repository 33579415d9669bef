//! Profiles along the faces of a stack: pressures and gaps of all contacts, displacements and slopes of all faces.
use std::f64::consts::PI;

use crate::field::{DISPLACEMENTS, FULL, FaceProfile, FaceSide, Field, FieldError, LOW};
use crate::geometry::Coordinates;
use crate::scene::Top;
use crate::solution::{ClosedInterface, Contact, Interface, Interval, Solution};
use crate::stack::Stack;

/// A profile that is not told how far to go goes to this many times the end of the farthest contact.
const BEYOND: f64 = 2.0;

/// Pressures, gaps, displacements and slopes at places along x; made by [`Model::profile`](crate::Model::profile).
#[derive(Clone, Debug)]
pub struct FaceProfiles {
    /// The coordinates by which displacements are named; under loads at several places (x, y) the profile lies in the plane y = 0.
    pub coordinates: Coordinates,
    /// The places x, in length.
    pub x: Vec<f64>,
    /// Each contact from the top down, the punch first.
    pub contacts: Vec<ContactProfile>,
    /// The faces of the layers from the top down; where layers are bonded, the lower face of one lies on the upper face of the next.
    pub faces: Vec<FaceProfile>,
}

/// Pressure and gap of one contact along x.
#[derive(Clone, Debug)]
pub struct ContactProfile {
    /// Which contact.
    pub interface: Interface,
    /// The pressure (compression positive), in stress; infinite at a sharp corner, or under the tip of a wedge.
    pub pressure: Vec<f64>,
    /// How far the bodies are apart, in length: 0 where they touch; infinite beyond the edge of a punch, to the nearest of several punches. None under a given pressure.
    pub gap: Option<Vec<f64>>,
}

/// Places from −`to` to `to`, about `count` of them, dense next to the ends of all contacts, where pressures and gaps begin like roots;
/// without `to`, twice as far from the middle of what touches, and of all openings, as their ends are.
///
/// ```
/// use recede::{HalfPlane, Model, Plane, Punch, Stack, profile_places};
/// let model = Model::new(Stack::builder(Plane::Strain).layer(HalfPlane::new(1.0, 0.25)?).build()?)?;
/// let solution = model.press(&Punch::parabola(500.0)?, 0.002)?;
/// let x = profile_places(&solution, None, 100);
/// let a = solution.contacts()[0].reach();
/// assert!(x.contains(&a) && x.contains(&-a) && *x.last().unwrap() == 2.0 * a);
/// # Ok::<(), recede::Error>(())
/// ```
pub fn profile_places(solution: &Solution, to: Option<f64>, count: usize) -> Vec<f64> {
    let [left, right] = solution.ends_with_openings();
    let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
    // a line load by itself has no length
    let beyond = BEYOND * if half > 0.0 { half } else { 1.0 };
    let [first, last] = to.map_or([middle - beyond, middle + beyond], |to| [-to, to]);
    let ends = solution.contacts().iter().flat_map(Contact::intervals).flat_map(|one| [one.left, one.right]);
    let openings = solution.closed().iter().flat_map(|own| &own.openings).flat_map(|one| [one.left, one.right]);
    let inside = ends.chain(openings).chain([middle]).filter(|x| *x > first && *x < last);
    let mut breaks: Vec<f64> = inside.chain([first, last]).collect();
    breaks.sort_by(f64::total_cmp);
    // what differs by rounding is one place
    breaks.dedup_by(|next, before| *next - *before <= 8.0 * f64::EPSILON * first.abs().max(last.abs()));
    let steps = (count / (breaks.len() - 1)).max(4);
    let between = |pair: &[f64]| {
        let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
        let place = move |k: usize| middle - half * (PI * k as f64 / steps as f64).cos();
        (1..steps).map(place).chain([pair[1]]).collect::<Vec<_>>()
    };
    [first].into_iter().chain(breaks.windows(2).flat_map(between)).collect()
}

/// The profile of a solution at places along x.
pub(crate) fn profile(top: &Top, stack: &Stack, solution: &Solution, x: &[f64]) -> Result<FaceProfiles, FieldError> {
    let field = Field::new(stack, solution);
    let coordinates = field.coordinates();
    if !solution.axes().is_empty() {
        let pressure = x.iter().map(|x| solution.load_at([*x, 0.0])).collect();
        let contacts = vec![ContactProfile { interface: Interface::Punch, pressure, gap: None }];
        return Ok(FaceProfiles { coordinates, x: x.to_vec(), contacts, faces: field.faces(x, &FULL)? });
    }
    // two places more in each contact, under each punch, between which its gap is none: bodies may have turned against each other
    let each: Vec<Vec<Contact>> = solution.contacts().iter().map(Contact::of_each_punch).collect();
    let mut places = x.to_vec();
    places.extend(each.iter().flatten().flat_map(Contact::touching));
    let mut faces = field.faces(&places, &FULL)?;
    let mut touching = x.len();
    let mut contacts = Vec::new();
    for (contact, each) in solution.contacts().iter().zip(&each) {
        let known =
            contact.interface != Interface::Punch || top.punches().is_some_and(|all| all.parts().count() == each.len());
        let of = |(k, body): (usize, &Contact)| {
            let apart = heights(top, &field, &faces, contact.interface, k, &places)?;
            Ok(apart.map(|apart| {
                let [begin, end] = [0, 1].map(|side| touching + 2 * k + side).map(|q| (places[q], apart[q]));
                gap(x, &apart, body.intervals(), [begin, end])
            }))
        };
        // each of several punches is looked at half of the way to the next one
        let half = |pair: &[Contact]| 0.5 * (pair[0].ends()[1] + pair[1].ends()[0]);
        let halves: Vec<f64> = each.windows(2).map(half).collect();
        let own = |x: &f64| halves.partition_point(|half| half <= x);
        let all = || each.iter().enumerate().map(of).collect::<Result<Option<Vec<_>>, FieldError>>();
        let gaps = if known { all()? } else { None };
        let pressure = x.iter().map(|x| contact.pressure(*x)).collect();
        let gap = gaps.map(|gaps| x.iter().enumerate().map(|(k, x)| gaps[own(x)][k]).collect());
        contacts.push(ContactProfile { interface: contact.interface, pressure, gap });
        touching += 2 * each.len();
    }
    faces.iter_mut().for_each(|face| face.points.truncate(x.len()));
    contacts.extend(closed(solution, &faces, x));
    Ok(FaceProfiles { coordinates, x: x.to_vec(), contacts, faces })
}

/// The profiles of the interfaces that weights press together, from the faces of layers at places along x.
fn closed(solution: &Solution, faces: &[FaceProfile], x: &[f64]) -> Vec<ContactProfile> {
    let of = |own: &ClosedInterface| {
        let Interface::Between { above, .. } = own.interface else { return None };
        let face = faces.iter().find(|face| face.layer == above && face.side == FaceSide::Bottom)?;
        let pressure = face.points.iter().map(|point| -point.sigma_yy).collect();
        let gap = Some(x.iter().map(|x| own.gap(*x)).collect());
        Some(ContactProfile { interface: own.interface, pressure, gap })
    };
    solution.closed().iter().filter_map(of).collect()
}

/// Pressures, to be drawn, and gaps of the interfaces that weights press together at places along x.
pub(crate) fn under_weight(stack: &Stack, solution: &Solution, x: &[f64]) -> Result<Vec<ContactProfile>, FieldError> {
    if solution.closed().is_empty() {
        return Ok(Vec::new());
    }
    Ok(closed(solution, &Field::new(stack, solution).faces(x, &LOW)?, x))
}

/// A gap at places along x by how much higher one body is there, counted from the straight line through two places where they touch.
fn gap(x: &[f64], apart: &[f64], intervals: &[Interval], [(from, begin), (to, end)]: [(f64, f64); 2]) -> Vec<f64> {
    let turn = if from < to { (end - begin) / (to - from) } else { 0.0 };
    let touches = |x: f64| intervals.iter().any(|one| one.left <= x && x <= one.right);
    let gap = |(x, apart): (&f64, &f64)| if touches(*x) { 0.0 } else { apart - (begin + turn * (x - from)) };
    x.iter().zip(apart).map(gap).collect()
}

/// How much higher the upper body of a contact, under it a punch of this number from the left, is than the lower one at places along x; `None` under a
/// given pressure.
pub(crate) fn heights(
    top: &Top,
    field: &Field,
    faces: &[FaceProfile],
    interface: Interface,
    number: usize,
    x: &[f64],
) -> Result<Option<Vec<f64>>, FieldError> {
    let face = |layer: usize, side: FaceSide| faces.iter().find(|face| face.layer == layer && face.side == side);
    let v = |face: Option<&FaceProfile>, k: usize| face.map_or(0.0, |face| face.points[k].v);
    Ok(Some(match interface {
        Interface::Punch => {
            let Some((pressed, _)) = top.punches().and_then(|all| all.parts().nth(number)) else { return Ok(None) };
            let punch = pressed.shape();
            let flattened = match (punch.material(), field.second()) {
                (Some(material), _) => Some(field.flattening(&material, x)),
                (None, Some(second)) => {
                    Some(second.faces(x, &DISPLACEMENTS)?[0].points.iter().map(|own| -own.v).collect())
                }
                (None, None) => None,
            };
            // nothing is above the stack beyond the edge of a punch, but for rounding where a contact ends at a corner
            let [left, right] = punch.shape().ends();
            let profile = |x: f64| {
                let inside = x.clamp(left, right);
                let is_there = (x - inside).abs() <= 4.0 * f64::EPSILON * (pressed.at().abs() + inside.abs());
                if is_there { punch.profile(inside) } else { f64::INFINITY }
            };
            let height = |k: usize| profile(x[k] - pressed.at()) + flattened.as_ref().map_or(0.0, |all| all[k]);
            let height = |k: usize| height(k) + field.gaps.height(interface, x[k]);
            (0..x.len()).map(|k| height(k) - v(faces.first(), k)).collect()
        }
        Interface::Between { above, below } => {
            // a rigid base without layers has no face, and stays where it is
            let (above, below) = (face(above, FaceSide::Bottom), face(below, FaceSide::Top));
            (0..x.len()).map(|k| v(above, k) - v(below, k) + field.gaps.height(interface, x[k])).collect()
        }
    }))
}

#[cfg(test)]
mod tests;
