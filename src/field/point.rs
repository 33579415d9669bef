//! Stresses, strains and displacements at a point, and what follows from them.
use std::fmt;
use std::str::FromStr;

use recede_layers::Material;

use super::Field;
use super::body::DepthRow;
use super::surface::Components;
use crate::geometry::Geometry;

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

/// Reads X,DEPTH or X,DEPTH@LAYER.
impl FromStr for Point {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || format!("found `{text}`, expected X,DEPTH or X,DEPTH@LAYER as in 0,0.5 or 1.2,1@2");
        let (place, layer) = match text.split_once('@') {
            Some((place, layer)) => (place, Some(layer.trim().parse().map_err(|_| wrong())?)),
            None => (text, None),
        };
        let (x, depth) = place.split_once(',').ok_or_else(wrong)?;
        let number = |text: &str| text.trim().parse().map_err(|_| wrong());
        Ok(Self { x: number(x)?, depth: number(depth)?, layer })
    }
}

impl fmt::Display for Point {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.written_in(Geometry::PlaneStrain))
    }
}

impl Point {
    /// The point in words, with the name of the coordinate in this geometry.
    pub(super) fn written_in(&self, geometry: Geometry) -> String {
        let layer = self.layer.map_or(String::new(), |layer| format!(" in layer {layer}"));
        format!("{} = {:?}, depth = {:?}{layer}", geometry.words().along, self.x, self.depth)
    }
}

/// Stresses (positive in tension), strains and displacements at a point, in the units of the scene.
///
/// Strains are the ones that the loads make, positive where the material is stretched: without eigenstrains, and counted from the stack under its own weight.
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
    /// [`Material::out_of_plane`](recede_layers::Material::out_of_plane), or that has an eigenstrain and is not isotropic. In axisymmetric problems the stress about the axis, σ_θθ.
    pub sigma_zz: f64,
    /// Strain along the layers, ε_xx, dimensionless; about an axis ε_rr.
    pub eps_xx: f64,
    /// Strain across the layers, ε_yy, dimensionless; about an axis ε_zz.
    pub eps_yy: f64,
    /// Strain out of the plane, dimensionless: 0 in plane strain; in plane stress −ν(σ_xx + σ_yy)/E of an isotropic material, and NaN of others; about an axis ε_θθ.
    pub eps_zz: f64,
    /// Angle of shear γ_xy = 2 ε_xy, dimensionless, with y upwards.
    pub gamma_xy: f64,
    /// Whether z is the direction about an axis.
    pub(super) is_axisymmetric: bool,
    /// The modulus by which strains are compared with stresses, the same in a whole layer.
    pub(super) stiffness: f64,
}

impl FieldPoint {
    /// The principal stresses in the plane, the larger one first.
    pub fn principal(&self) -> [f64; 2] {
        let (mean, radius) = (0.5 * (self.sigma_xx + self.sigma_yy), self.max_shear());
        [mean + radius, mean - radius]
    }

    /// The largest tension: the larger principal stress in the plane or, in axisymmetric problems, that about the axis if it is larger.
    pub fn tension(&self) -> f64 {
        let [first, _] = self.principal();
        if self.is_axisymmetric { first.max(self.sigma_zz) } else { first }
    }

    /// The principal strains in the plane, the larger one first.
    pub fn principal_strains(&self) -> [f64; 2] {
        let mean = 0.5 * (self.eps_xx + self.eps_yy);
        let radius = 0.5 * (self.eps_xx - self.eps_yy).hypot(self.gamma_xy);
        [mean + radius, mean - radius]
    }

    /// The largest strain: the larger principal one in the plane or, in axisymmetric problems, the one about the axis if it is larger.
    pub fn tensile_strain(&self) -> f64 {
        let [first, _] = self.principal_strains();
        if self.is_axisymmetric { first.max(self.eps_zz) } else { first }
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

/// Names of a quantity in plane problems, and in axisymmetric ones in cylindrical coordinates; and its value at a point.
type QuantityEntry = ([&'static str; 2], fn(&FieldPoint) -> f64);

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
    /// Strain along the layers.
    EpsXx,
    /// Strain across the layers.
    EpsYy,
    /// Angle of shear, with y upwards.
    GammaXy,
    /// Strain out of the plane.
    EpsZz,
    /// The larger principal strain in the plane.
    Eps1,
    /// The smaller principal strain in the plane.
    Eps2,
}

impl FieldQuantity {
    /// All of them.
    pub const ALL: [Self; 16] = [
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
        Self::EpsXx,
        Self::EpsYy,
        Self::GammaXy,
        Self::EpsZz,
        Self::Eps1,
        Self::Eps2,
    ];

    const TABLE: [QuantityEntry; Self::ALL.len()] = [
        (["sigma_xx", "sigma_rr"], |point| point.sigma_xx),
        (["sigma_yy", "sigma_zz"], |point| point.sigma_yy),
        (["sigma_xy", "tau_rz"], |point| point.sigma_xy),
        (["sigma_zz", "sigma_tt"], |point| point.sigma_zz),
        (["sigma_1"; 2], |point| point.principal()[0]),
        (["sigma_2"; 2], |point| point.principal()[1]),
        (["max_shear"; 2], FieldPoint::max_shear),
        (["von_mises"; 2], FieldPoint::von_mises),
        (["u", "u_r"], |point| point.u),
        (["v", "u_z"], |point| point.v),
        (["eps_xx", "eps_rr"], |point| point.eps_xx),
        (["eps_yy", "eps_zz"], |point| point.eps_yy),
        (["gamma_xy", "gamma_rz"], |point| point.gamma_xy),
        (["eps_zz", "eps_tt"], |point| point.eps_zz),
        (["eps_1"; 2], |point| point.principal_strains()[0]),
        (["eps_2"; 2], |point| point.principal_strains()[1]),
    ];

    /// The quantity of this name in a geometry.
    ///
    /// # Errors
    /// If there is none: what was found, and all that there are.
    pub fn named(name: &str, geometry: Geometry) -> Result<Self, String> {
        let all = || Self::ALL.map(|quantity| quantity.name_in(geometry)).join(", ");
        let found = Self::ALL.into_iter().find(|quantity| quantity.name_in(geometry) == name);
        found.ok_or_else(|| format!("there is no {name} in this geometry; there are {}", all()))
    }

    /// Whether it is a strain, which has no unit.
    pub(crate) fn is_strain(self) -> bool {
        self as usize > Self::V as usize
    }

    /// Whether it is a normal stress or strain, positive in tension.
    pub(crate) fn is_tensile(self) -> bool {
        let others =
            [Self::SigmaXy, Self::Sigma2, Self::MaxShear, Self::VonMises, Self::U, Self::V, Self::GammaXy, Self::Eps2];
        !others.contains(&self)
    }

    /// Whether it needs what a material may not tell of the direction out of the plane.
    pub(crate) fn is_out_of_plane(self) -> bool {
        matches!(self, Self::SigmaZz | Self::VonMises | Self::EpsZz)
    }

    /// The name of the quantity, as in the columns of a CSV file.
    pub fn name(self) -> &'static str {
        Self::TABLE[self as usize].0[0]
    }

    /// The name of the quantity in a geometry, as in the columns of a CSV file: in axisymmetric problems of cylindrical coordinates with z downwards.
    ///
    /// ```
    /// use recede::{FieldQuantity, Geometry};
    /// assert_eq!(FieldQuantity::SigmaZz.name_in(Geometry::Axisymmetric), "sigma_tt");
    /// ```
    pub fn name_in(self, geometry: Geometry) -> &'static str {
        Self::TABLE[self as usize].0[usize::from(geometry.is_axisymmetric())]
    }

    /// The value of the quantity at a point.
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
        (Self::TABLE[self as usize].1)(point)
    }

    /// The value of the quantity in a geometry, under [`Self::name_in`]: z points downwards in axisymmetric problems.
    pub fn of_in(self, point: &FieldPoint, geometry: Geometry) -> f64 {
        match (geometry, self) {
            // not −0
            (Geometry::Axisymmetric, Self::SigmaXy | Self::V | Self::GammaXy) => 0.0 - self.of(point),
            _ => self.of(point),
        }
    }
}

/// Stresses and displacements on a grid: rows at one depth each, from the first to the last.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    pub(super) xs: Vec<f64>,
    pub(super) points: Vec<FieldPoint>,
}

impl Grid {
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
    /// A point from the components at its place, x from the middle.
    pub(super) fn point(&self, x: f64, row: &DepthRow, components: Components) -> FieldPoint {
        let placed = &self.layers[row.layer];
        let [sigma_xx, sigma_yy, mut sigma_xy, mut u, v, mut slope] = components;
        let material = placed.layer.material(row.depth, self.geometry.plane());
        if x < 0.0 && self.is_even {
            (sigma_xy, u, slope) = (-sigma_xy, -u, -slope);
        }
        let [eps_xx, eps_zz, eps_yy] = strains(&material, self.geometry, x.abs(), &components);
        let [sigma_xx, sigma_zz] = match self.geometry {
            Geometry::Axisymmetric => around(&material, sigma_xx, [eps_xx, eps_zz]),
            Geometry::PlaneStrain => {
                let shares = material.out_of_plane;
                [sigma_xx, shares.map_or(f64::NAN, |[along, across]| along * sigma_xx + across * sigma_yy)]
            }
            Geometry::PlaneStress => [sigma_xx, 0.0],
        };
        let residual = placed.residual(row.depth, &material, self.geometry);
        FieldPoint {
            x: self.middle + x,
            depth: placed.top + row.depth,
            layer: placed.number,
            u,
            v,
            slope,
            sigma_xx: sigma_xx + residual[0],
            sigma_yy: sigma_yy + residual[1],
            sigma_xy,
            sigma_zz: sigma_zz + residual[2],
            eps_xx,
            eps_yy,
            eps_zz,
            gamma_xy: material.shear_compliance * sigma_xy,
            is_axisymmetric: self.geometry.is_axisymmetric(),
            stiffness: placed.stiffness,
        }
    }
}

/// The strains along the layers, out of the plane, and across the layers. In an axisymmetric problem the first component is the stress of plane strain with ε_rr + ε_θθ as
/// the strain along the layers.
fn strains(material: &Material, geometry: Geometry, distance: f64, [along, across, _, u, ..]: &Components) -> [f64; 3] {
    let both = (along - material.coupling * across) / material.axial_stiffness;
    let other = match geometry {
        Geometry::Axisymmetric if distance > 0.0 => u / distance,
        Geometry::Axisymmetric => 0.5 * both,
        Geometry::PlaneStrain => 0.0,
        // Poisson's ratio over Young's modulus
        Geometry::PlaneStress if material.is_isotropic() => {
            -material.coupling / material.axial_stiffness * (along + across)
        }
        Geometry::PlaneStress => f64::NAN,
    };
    let first = if geometry.is_axisymmetric() { both - other } else { both };
    [first, other, material.normal_compliance * across - material.coupling * both]
}

/// The radial stress and that about the axis: they are less than the first component by 2Gε_θθ and 2Gε_rr, G being the modulus of shear along
/// the layers; with ν along the layers 2G is the modulus of a stretched plate times 1 − ν.
fn around(material: &Material, along: f64, [radial, hoop]: [f64; 2]) -> [f64; 2] {
    if along.is_infinite() {
        return [along; 2];
    }
    let shear = match material.out_of_plane {
        Some([poisson, _]) => material.axial_stiffness * (1.0 - poisson),
        None => 2.0 / material.shear_compliance,
    };
    [along - shear * hoop, along - shear * radial]
}
