//! Stresses and displacements at a point, and what follows from them.
use std::fmt;

use recede_layers::Plane;

use super::Field;
use super::potentials::Components;
use super::sum::Row;

/// A point at which a field is requested.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Along the layers, from the centre of the contact, in length.
    pub x: f64,
    /// Below the top face of the stack, in length.
    pub depth: f64,
    /// The layer, numbered from the top as written in the scene, starting at 1. On an interface `None` is the layer below.
    pub layer: Option<usize>,
}

impl fmt::Display for Point {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "x = {:?}, depth = {:?}", self.x, self.depth)?;
        self.layer.map_or(Ok(()), |layer| write!(f, " in layer {layer}"))
    }
}

/// Stresses (positive in tension) and displacements at a point, in the units of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldPoint {
    /// Along the layers, from the centre of the contact.
    pub x: f64,
    /// Below the top face of the stack.
    pub depth: f64,
    /// Number of the layer, from the top as written in the scene, starting at 1.
    pub layer: usize,
    /// Displacement along x, 0 at x = 0.
    pub u: f64,
    /// Displacement upwards, counted from the rigid base or from the top face of the half-plane at x = 0.
    pub v: f64,
    /// Slope dv/dx.
    pub slope: f64,
    /// Normal stress along the layers.
    pub sigma_xx: f64,
    /// Normal stress across the layers.
    pub sigma_yy: f64,
    /// Shear stress, with y upwards.
    pub sigma_xy: f64,
    /// Normal stress out of the plane: that for which ε_zz = 0 in plane strain, ν(σ_xx + σ_yy) of an isotropic material; 0 in
    /// plane stress. NaN in a layer whose material does not give it, see
    /// [`Material::out_of_plane`](recede_layers::Material::out_of_plane).
    pub sigma_zz: f64,
}

impl FieldPoint {
    /// The principal stresses in the plane, the larger one first.
    pub fn principal(&self) -> [f64; 2] {
        let (mean, radius) = (0.5 * (self.sigma_xx + self.sigma_yy), self.max_shear());
        [mean + radius, mean - radius]
    }

    /// The largest shear stress in the plane, (σ₁ − σ₂)/2.
    pub fn max_shear(&self) -> f64 {
        (0.5 * (self.sigma_xx - self.sigma_yy)).hypot(self.sigma_xy)
    }

    /// Von Mises' equivalent stress, with the stress out of the plane; NaN where that is not known.
    pub fn von_mises(&self) -> f64 {
        let [first, second] = self.principal();
        let third = self.sigma_zz;
        (0.5 * ((first - second).powi(2) + (second - third).powi(2) + (third - first).powi(2))).sqrt()
    }
}

/// The quantities at a point of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FieldQuantity {
    /// Normal stress along the layers.
    SigmaXx,
    /// Normal stress across the layers.
    SigmaYy,
    /// Shear stress, with y upwards.
    SigmaXy,
    /// Normal stress out of the plane.
    SigmaZz,
    /// The larger principal stress in the plane.
    Sigma1,
    /// The smaller principal stress in the plane.
    Sigma2,
    /// The largest shear stress in the plane.
    MaxShear,
    /// Von Mises' equivalent stress.
    VonMises,
    /// Displacement along x.
    U,
    /// Displacement upwards.
    V,
}

impl FieldQuantity {
    /// All of them.
    pub const ALL: [Self; 10] = [
        Self::SigmaXx,
        Self::SigmaYy,
        Self::SigmaXy,
        Self::SigmaZz,
        Self::Sigma1,
        Self::Sigma2,
        Self::MaxShear,
        Self::VonMises,
        Self::U,
        Self::V,
    ];

    /// Its name, as in the columns of a CSV file.
    pub fn name(self) -> &'static str {
        match self {
            Self::SigmaXx => "sigma_xx",
            Self::SigmaYy => "sigma_yy",
            Self::SigmaXy => "sigma_xy",
            Self::SigmaZz => "sigma_zz",
            Self::Sigma1 => "sigma_1",
            Self::Sigma2 => "sigma_2",
            Self::MaxShear => "max_shear",
            Self::VonMises => "von_mises",
            Self::U => "u",
            Self::V => "v",
        }
    }

    /// Its value at a point.
    ///
    /// ```
    /// # use recede::{HalfPlane, Model, Plane, Punch, FieldQuantity, Stack};
    /// # let model = Model::new(Stack::builder(Plane::Strain).layer(HalfPlane::new(1.0, 0.25)?).build()?)?;
    /// # let solution = model.press(&Punch::parabola(500.0)?, 0.002)?;
    /// let point = model.field(&solution)?.at(0.0, 0.5)?;
    /// assert_eq!(FieldQuantity::SigmaYy.of(&point), point.sigma_yy);
    /// # Ok::<(), recede::Error>(())
    /// ```
    pub fn of(self, point: &FieldPoint) -> f64 {
        match self {
            Self::SigmaXx => point.sigma_xx,
            Self::SigmaYy => point.sigma_yy,
            Self::SigmaXy => point.sigma_xy,
            Self::SigmaZz => point.sigma_zz,
            Self::Sigma1 => point.principal()[0],
            Self::Sigma2 => point.principal()[1],
            Self::MaxShear => point.max_shear(),
            Self::VonMises => point.von_mises(),
            Self::U => point.u,
            Self::V => point.v,
        }
    }
}

/// Stresses and displacements on a grid: rows at one depth each, from the first to the last.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    xs: Vec<f64>,
    points: Vec<FieldPoint>,
}

impl Grid {
    pub(super) fn new(xs: Vec<f64>, points: Vec<FieldPoint>) -> Self {
        Self { xs, points }
    }

    /// The places along x.
    pub fn xs(&self) -> &[f64] {
        &self.xs
    }

    /// All points, row by row.
    pub fn points(&self) -> &[FieldPoint] {
        &self.points
    }

    /// The rows, from the first depth to the last.
    pub fn rows(&self) -> impl Iterator<Item = &[FieldPoint]> {
        self.points.chunks(self.xs.len().max(1))
    }

    /// The point of a row at a place.
    ///
    /// # Panics
    /// If the grid has no such row or place.
    pub fn at(&self, row: usize, place: usize) -> &FieldPoint {
        &self.points[row * self.xs.len() + place]
    }
}

impl Field {
    /// A point from the components at |x|.
    pub(super) fn point(&self, x: f64, row: &Row, components: Components) -> FieldPoint {
        let placed = &self.layers[row.layer];
        let [sigma_xx, sigma_yy, mut sigma_xy, mut u, v, mut slope] = components;
        if x < 0.0 {
            (sigma_xy, u, slope) = (-sigma_xy, -u, -slope);
        }
        let sigma_zz = match self.plane {
            Plane::Strain => {
                let shares = placed.layer.material(row.depth, self.plane).out_of_plane;
                shares.map_or(f64::NAN, |[along, across]| along * sigma_xx + across * sigma_yy)
            }
            Plane::Stress => 0.0,
        };
        FieldPoint {
            x,
            depth: placed.top + row.depth,
            layer: placed.number,
            u,
            v,
            slope,
            sigma_xx,
            sigma_yy,
            sigma_xy,
            sigma_zz,
        }
    }
}
