//! How far the faces of a stack are displaced, and how much larger that is drawn.
use super::file::PlotError;
use super::punch::rounded_down;
use super::scale::label;
use crate::field::FaceSide;
use crate::profile::FaceProfiles;
use crate::scene::Scene;
use crate::solution::Interface;

/// The largest displacement that is drawn, in points, unless the factor is given.
const LARGEST: f64 = 40.0;
/// The largest one with any factor, in points.
const HIGHEST: f64 = 400.0;
/// No layer is drawn thinner by more than this part of its height then.
const THINNER: f64 = 0.5;

/// By how much the faces of layers are displaced, upwards in length, at the places of a profile.
pub(super) struct Displaced {
    /// The upper and the lower face of each layer; what is drawn of a half-plane ends where nothing moves.
    pub(super) faces: Vec<[Vec<f64>; 2]>,
    /// The lower side of all punches, infinite beyond their edges; `None` where it is not known, as under loads.
    pub(super) punches: Option<Vec<f64>>,
    /// The number of the half-plane from whose top face displacements are counted.
    ground: Option<usize>,
}

impl Displaced {
    /// For layers with these numbers, from the top down. Each face above a contact is as high as the gap above the face below.
    pub(super) fn new(profile: &FaceProfiles, numbers: &[usize]) -> Result<Self, PlotError> {
        let v = |number: usize, side: FaceSide| {
            let face = profile.faces.iter().find(|face| face.layer == number && face.side == side)?;
            Some(face.points.iter().map(|point| point.v).collect::<Vec<f64>>())
        };
        let ground = numbers.last().copied().filter(|number| v(*number, FaceSide::Bottom).is_none());
        let at_ends = |heights: Vec<f64>| Some(0.5 * (heights.first()? + heights.last()?));
        let lift = ground.and_then(|number| at_ends(v(number, FaceSide::Top)?)).unwrap_or(0.0);
        let gap = |is_own: &dyn Fn(Interface) -> bool| {
            profile.contacts.iter().find(|contact| is_own(contact.interface)).and_then(|contact| contact.gap.as_ref())
        };
        let over = |below: &[f64], gap: &Vec<f64>| below.iter().zip(gap).map(|(v, gap)| v + gap).collect::<Vec<_>>();
        let at_rest = vec![0.0; profile.x.len()];
        let face = |number: usize, side: FaceSide| {
            v(number, side).map_or(Ok(at_rest.clone()), |face| known(face.iter().map(|v| v - lift).collect()))
        };
        let (mut faces, mut below) = (Vec::new(), at_rest.clone());
        for number in numbers.iter().rev() {
            let upper = face(*number, FaceSide::Top)?;
            let lower = match gap(&|own| matches!(own, Interface::Between { above, .. } if above == *number)) {
                Some(gap) => known(over(&below, gap))?,
                None => face(*number, FaceSide::Bottom)?,
            };
            below.clone_from(&upper);
            faces.push([upper, lower]);
        }
        faces.reverse();
        let punches = gap(&|own| own == Interface::Punch).map(|gap| over(&below, gap));
        Ok(Self { faces, punches, ground })
    }

    fn largest(&self) -> f64 {
        self.faces.iter().flatten().flatten().map(|v| v.abs()).fold(0.0, f64::max)
    }

    /// A factor with which displacements fit on a page, from the scale in points per length.
    pub(super) fn seen(&self, times: f64, scale: f64) -> Result<f64, PlotError> {
        let most = HIGHEST / (scale * self.largest());
        let allowed = label(rounded_down(most));
        let refused = || PlotError::Drawing(format!("displacements × {} do not fit, × {allowed} do", label(times)));
        if times <= most { Ok(times) } else { Err(refused()) }
    }

    /// A round factor with which displacements are seen, and layers of these heights in points remain, from the scale in points per length.
    pub(super) fn times(&self, scale: f64, heights: &[f64]) -> f64 {
        let thinner = |[upper, lower]: &[Vec<f64>; 2]| {
            upper.iter().zip(lower).map(|(upper, lower)| lower - upper).fold(0.0, f64::max)
        };
        let allowed = self.faces.iter().zip(heights).map(|(faces, height)| THINNER * height / thinner(faces));
        let times = allowed.fold(LARGEST / self.largest(), f64::min) / scale;
        if times.is_finite() { rounded_down(times) } else { 1.0 }
    }

    /// A sentence on what is drawn.
    pub(super) fn note(&self, scene: &Scene, times: f64) -> String {
        let from = match self.ground {
            Some(number) => format!("counted from both ends of the top face of {}", scene.layer_label(number)),
            None => "counted from the rigid base".to_owned(),
        };
        format!("displacements drawn × {}, {from}", label(times))
    }
}

/// Heights of a face; in place of an infinite height, under a line load or beyond a gap, the next finite one.
fn known(mut heights: Vec<f64>) -> Result<Vec<f64>, PlotError> {
    let first = heights.iter().copied().find(|v| v.is_finite()).ok_or_else(|| {
        let from = "a line load presses on the place from which they are counted";
        PlotError::Empty(format!("displacements are infinite or not known: {from}"))
    })?;
    heights.iter_mut().fold(first, |before, v| {
        *v = if v.is_finite() { *v } else { before };
        *v
    });
    Ok(heights)
}
