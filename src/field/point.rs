//! Stresses, strains and displacements at a point, and what follows from them.
use nalgebra::Matrix3;
use recede_layers::Material;

use super::Field;
use super::body::DepthRow;
use super::surface::Components;
use crate::geometry::{Coordinates, Geometry};

/// Stresses (positive in tension), strains and displacements at a point, in the units of the scene.
///
/// Strains are the ones that the loads make, positive where the material is stretched: without eigenstrains, and counted from the stack under its own weight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldPoint {
    /// Along the layers, from the centre of the contact.
    pub x: f64,
    /// Out of the plane, z: the coordinate y of a scene with loads at several places (x, y), and 0 in all others.
    pub z: f64,
    /// Below the top face of the stack.
    pub depth: f64,
    /// Number of the layer, from the top as written in the scene, starting at 1.
    pub layer: usize,
    /// Displacement along x, 0 at x = 0.
    pub u: f64,
    /// Displacement upwards, counted from the rigid base or from the top face of the half-plane at x = 0.
    pub v: f64,
    /// Displacement along z; 0 but under loads at several places (x, y).
    pub w: f64,
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
    /// Shear stress in planes along the layers; 0 but under loads at several places (x, y).
    pub sigma_xz: f64,
    /// Shear stress with y upwards and z; 0 but under loads at several places (x, y).
    pub sigma_yz: f64,
    /// Strain along the layers, ε_xx, dimensionless; about an axis ε_rr.
    pub eps_xx: f64,
    /// Strain across the layers, ε_yy, dimensionless; about an axis ε_zz.
    pub eps_yy: f64,
    /// Strain out of the plane, dimensionless: 0 in plane strain; in plane stress −ν(σ_xx + σ_yy)/E of an isotropic material, and NaN of others; about an axis ε_θθ.
    pub eps_zz: f64,
    /// Angle of shear γ_xy = 2 ε_xy, dimensionless, with y upwards.
    pub gamma_xy: f64,
    /// Angle of shear γ_xz, dimensionless; 0 but under loads at several places (x, y).
    pub gamma_xz: f64,
    /// Angle of shear γ_yz, dimensionless, with y upwards; 0 but under loads at several places (x, y).
    pub gamma_yz: f64,
    /// What z is: the direction about an axis, or out of a plane that need not be a principal one.
    pub(super) coordinates: Coordinates,
    /// The modulus by which strains are compared with stresses, the same in a whole layer.
    pub(super) stiffness: f64,
}

impl FieldPoint {
    /// The stresses, displacements and strains, which are added up where loads are.
    pub(super) fn additive(&mut self) -> [&mut f64; 16] {
        let Self { u, v, w, slope, sigma_xx, sigma_yy, sigma_xy, sigma_zz, sigma_xz, sigma_yz, .. } = self;
        let Self { eps_xx, eps_yy, eps_zz, gamma_xy, gamma_xz, gamma_yz, .. } = self;
        [
            u, v, w, slope, sigma_xx, sigma_yy, sigma_xy, sigma_zz, sigma_xz, sigma_yz, eps_xx, eps_yy, eps_zz,
            gamma_xy, gamma_xz, gamma_yz,
        ]
    }

    /// The principal stresses in the plane, the larger one first; under loads at several places (x, y) the largest and the smallest one of all three.
    pub fn principal(&self) -> [f64; 2] {
        let shears = [self.sigma_xy, self.sigma_xz, self.sigma_yz];
        self.principal_of([self.sigma_xx, self.sigma_yy, self.sigma_zz], shears)
    }

    /// The largest tension: the larger principal stress in the plane or, in axisymmetric problems, that about the axis if it is larger.
    pub fn tension(&self) -> f64 {
        self.with_hoop(self.principal()[0], self.sigma_zz)
    }

    /// The principal strains in the plane, the larger one first; under loads at several places (x, y) the largest and the smallest one of all three.
    pub fn principal_strains(&self) -> [f64; 2] {
        let shears = [self.gamma_xy, self.gamma_xz, self.gamma_yz].map(|angle| 0.5 * angle);
        self.principal_of([self.eps_xx, self.eps_yy, self.eps_zz], shears)
    }

    /// The largest strain: the larger principal one in the plane or, in axisymmetric problems, the one about the axis if it is larger.
    pub fn tensile_strain(&self) -> f64 {
        self.with_hoop(self.principal_strains()[0], self.eps_zz)
    }

    /// The largest shear stress in the plane, (σ₁ − σ₂)/2; under loads at several places (x, y) in any plane, (σ₁ − σ₃)/2.
    pub fn max_shear(&self) -> f64 {
        match self.coordinates {
            Coordinates::Cartesian => {
                let [first, last] = self.principal();
                0.5 * (first - last)
            }
            _ => (0.5 * (self.sigma_xx - self.sigma_yy)).hypot(self.sigma_xy),
        }
    }

    /// Von Mises' equivalent stress, with the stress out of the plane; NaN where that is not known.
    pub fn von_mises(&self) -> f64 {
        let (other, [first, second]) = match self.coordinates {
            Coordinates::Cartesian => {
                (self.sigma_xy.hypot(self.sigma_xz).hypot(self.sigma_yz), [self.sigma_xx, self.sigma_yy])
            }
            _ => (0.0, self.principal()),
        };
        let third = self.sigma_zz;
        let normal = 0.5 * ((first - second).powi(2) + (second - third).powi(2) + (third - first).powi(2));
        (normal + 3.0 * other.powi(2)).sqrt()
    }

    /// The larger and the smaller principal value in the plane of x and y, or the largest and the smallest one of all, of components xx, yy, zz and xy, xz, yz.
    fn principal_of(&self, [xx, yy, zz]: [f64; 3], [xy, xz, yz]: [f64; 3]) -> [f64; 2] {
        if self.coordinates == Coordinates::Cartesian {
            let all = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
            if all.iter().any(|component| !component.is_finite()) {
                return [f64::NAN; 2];
            }
            let values = all.symmetric_eigenvalues();
            return [values.max(), values.min()];
        }
        let (mean, radius) = (0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy));
        [mean + radius, mean - radius]
    }

    /// The larger one of a principal value in the plane and, about an axis, the value about it.
    fn with_hoop(&self, first: f64, hoop: f64) -> f64 {
        if self.coordinates == Coordinates::Cylindrical { first.max(hoop) } else { first }
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
        let mut point = FieldPoint {
            x: self.middle + x,
            z: 0.0,
            depth: placed.top + row.depth,
            layer: placed.number,
            u,
            v,
            w: 0.0,
            slope,
            sigma_xx,
            sigma_yy,
            sigma_xy,
            sigma_zz,
            sigma_xz: 0.0,
            sigma_yz: 0.0,
            eps_xx,
            eps_yy,
            eps_zz,
            gamma_xy: material.shear_compliance * sigma_xy,
            gamma_xz: 0.0,
            gamma_yz: 0.0,
            coordinates: self.geometry.into(),
            stiffness: placed.stiffness,
        };
        self.add_residual(row, &mut point);
        point
    }

    /// Adds the stresses that are there before anything presses but weights.
    pub(super) fn add_residual(&self, row: &DepthRow, point: &mut FieldPoint) {
        let [along, across, out] = self.layers[row.layer].residual(row.depth, self.geometry);
        point.sigma_xx += along;
        point.sigma_yy += across;
        point.sigma_zz += out;
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
