//! The faces of the layers, and of an elastic punch, along x.
use recede_layers::Isotropic;

use super::body::DepthRow;
use super::error::FieldError;
use super::point::FieldPoint;
use super::surface::Surface;
use super::{Field, PlacedLayer, Precision};
use crate::solution::Solution;
use crate::stack::Stack;
pub use crate::system::Face as FaceSide;

/// One face of a layer along x.
#[derive(Clone, Debug)]
pub struct FaceProfile {
    /// Number of the layer, from the top as written in the scene, starting at 1.
    pub layer: usize,
    /// Which of its faces.
    pub side: FaceSide,
    /// Stresses, displacements and the slope there.
    pub points: Vec<FieldPoint>,
}

impl Field {
    /// The field in the body that presses on the top face in place of a rigid punch, if there is one: depths count from its own face inwards,
    /// and its y-axis points out of that face.
    ///
    /// ```
    /// use recede::Scene;
    /// let scene = Scene::from_ron("Scene(geometry: PlaneStrain, force: 0.01, stack: [HalfPlane(shear_modulus: 1, poisson: 0.3)],
    ///     punch: Covered(radius: 100, layers: [Homogeneous(thickness: 1, shear_modulus: 2, poisson: 0.4)], core: Rigid))")?;
    /// let model = recede::Model::new(scene.stack()?)?;
    /// let field = model.field(&model.press(&scene.top, scene.force)?)?;
    /// let [below, above] = [&field, field.second().unwrap()].map(|field| field.at(0.0, 0.0).unwrap());
    /// assert_eq!(below.sigma_yy, above.sigma_yy);
    /// # Ok::<(), recede::Error>(())
    /// ```
    pub fn second(&self) -> Option<&Self> {
        self.second.as_deref()
    }

    /// The field in the body that presses on the top face of a stack, under the pressure there.
    pub(super) fn of_second(stack: &Stack, solution: &Solution) -> Option<Box<Self>> {
        let contacts = solution.contacts().iter().take(1).cloned().collect();
        let top = || Solution { contacts, closed: Vec::new(), ..solution.clone() };
        stack.second().map(|second| Box::new(Self::new(second, &top())))
    }

    /// The faces of all layers from the top down at these places.
    pub(crate) fn faces(&self, xs: &[f64], precision: &Precision) -> Result<Vec<FaceProfile>, FieldError> {
        let sides = |(layer, placed): (usize, &PlacedLayer)| {
            let (number, bottom) = (placed.number, placed.thickness.map(|depth| (FaceSide::Bottom, depth)));
            let sides = [(FaceSide::Top, 0.0)].into_iter().chain(bottom);
            sides.map(move |(side, depth)| ((number, side), DepthRow { layer, depth, set: 0 }))
        };
        let (sides, rows): (Vec<_>, Vec<DepthRow>) = self.layers.iter().enumerate().flat_map(sides).unzip();
        let faces = sides.into_iter().zip(self.lines(xs, &rows, precision)?);
        Ok(faces.map(|((layer, side), points)| FaceProfile { layer, side, points }).collect())
    }

    /// How much higher the face of a punch of this material is, but for a constant, than it would be without the pressure on it: it is
    /// flattened like a half-plane.
    pub(crate) fn flattening(&self, material: &Isotropic, xs: &[f64]) -> Vec<f64> {
        let material = material.material(self.geometry.plane());
        let Some(mut surface) = Surface::new(&|_| material, 1.0, self.modulus) else { return vec![0.0; xs.len()] };
        surface.shift = f64::INFINITY;
        xs.iter().map(|x| -surface.closed(&self.pressures[0], self.place(*x), 0.0, true)[4]).collect()
    }
}
