//! Faces on which pressures act: the response to short waves is a series in 1/λ only if the material has a slope there.
use recede_layers::conformance::rough_face;

use super::{Placed, Stack, StackError, StackProblem};

impl Stack {
    /// Checks the material next to all loaded faces: without a slope there, kernels have no short-wave asymptote.
    /// Layers with closed forms are not checked, since their response does not come from the material as a function of the depth.
    pub(crate) fn check_faces(&self) -> Result<(), StackError> {
        let tops = self.groups().filter_map(|group| group.layers().next()).map(|layer| (layer, false));
        let bottoms = self.laminates.iter().filter_map(|laminate| laminate.layers.last()).map(|layer| (layer, true));
        // the length with which depths in a half-plane are compared
        let total = self.total_thickness();
        let length = if total > 0.0 { total } else { 1.0 };
        let mut general = tops.chain(bottoms).filter(|(placed, _)| placed.layer.closed_form().is_none());
        let rough = |(placed, bottom): (&Placed, bool)| {
            let rough = rough_face(&*placed.layer, self.plane(), bottom, length)?;
            let problem = StackProblem::RoughFace { layer: placed.name(), face: rough.face, exponent: rough.exponent };
            Some(StackError::of_layer(placed.number, problem))
        };
        general.find_map(rough).map_or(Ok(()), Err)
    }
}
