//! The faces of the layers, and of an elastic punch, along x.
use recede_layers::Isotropic;

use super::body::DepthRow;
use super::error::FieldError;
use super::point::FieldPoint;
use super::surface::Surface;
use super::{Field, PlacedLayer, Precision};

/// A face of a layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FaceSide {
    /// The upper one.
    Top,
    /// The lower one, which a half-plane does not have.
    Bottom,
}

impl Field {
    /// The faces of all layers from the top down, each with its layer's number, at these places.
    pub(crate) fn faces(
        &self,
        xs: &[f64],
        precision: &Precision,
    ) -> Result<Vec<(usize, FaceSide, Vec<FieldPoint>)>, FieldError> {
        let sides = |(layer, placed): (usize, &PlacedLayer)| {
            let top = (layer, placed.number, FaceSide::Top, 0.0);
            let bottom = placed.thickness.map(|depth| (layer, placed.number, FaceSide::Bottom, depth));
            [Some(top), bottom].into_iter().flatten()
        };
        let faces: Vec<(usize, usize, FaceSide, f64)> = self.layers.iter().enumerate().flat_map(sides).collect();
        let rows: Vec<DepthRow> =
            faces.iter().map(|(layer, _, _, depth)| DepthRow { layer: *layer, depth: *depth, set: 0 }).collect();
        let lines = faces.iter().zip(self.in_rows(xs, &rows, precision)?);
        Ok(lines.map(|((_, number, side, _), points)| (*number, *side, points)).collect())
    }

    /// How much higher the face of a punch of this material is, but for a constant, than it would be without the pressure of a contact: it is
    /// flattened like a half-plane.
    pub(crate) fn flattening(&self, contact: usize, material: &Isotropic, xs: &[f64]) -> Vec<f64> {
        let half_plane = Surface::of_half_plane(material.material(self.geometry.plane()), self.modulus);
        let Some(surface) = half_plane else { return vec![0.0; xs.len()] };
        let pressure = &self.pressures[contact];
        xs.iter().map(|x| -surface.closed(pressure, self.place(*x), 0.0, true)[4]).collect()
    }
}
