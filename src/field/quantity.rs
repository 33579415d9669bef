//! The quantities at a point of a field by name.
use super::point::FieldPoint;
use crate::geometry::Coordinates;

/// Names of a quantity in plane, cylindrical and Cartesian coordinates, and its value at a point.
type QuantityEntry = ([&'static str; 3], fn(&FieldPoint) -> f64);

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
    /// Shear stress in planes along the layers, which only [`Coordinates::Cartesian`] have.
    SigmaXz,
    /// Shear stress out of the plane of x and y, which only [`Coordinates::Cartesian`] have.
    SigmaYz,
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
    /// Displacement out of the plane of x and y, which only [`Coordinates::Cartesian`] have.
    W,
    /// Strain along the layers.
    EpsXx,
    /// Strain across the layers.
    EpsYy,
    /// Angle of shear, with y upwards.
    GammaXy,
    /// Angle of shear in planes along the layers, which only [`Coordinates::Cartesian`] have.
    GammaXz,
    /// Angle of shear out of the plane of x and y, which only [`Coordinates::Cartesian`] have.
    GammaYz,
    /// Strain out of the plane.
    EpsZz,
    /// The larger principal strain in the plane.
    Eps1,
    /// The smaller principal strain in the plane.
    Eps2,
}

impl FieldQuantity {
    /// All of them.
    pub const ALL: [Self; 21] = [
        Self::SigmaXx,
        Self::SigmaYy,
        Self::SigmaXy,
        Self::SigmaZz,
        Self::SigmaXz,
        Self::SigmaYz,
        Self::Sigma1,
        Self::Sigma2,
        Self::MaxShear,
        Self::VonMises,
        Self::U,
        Self::V,
        Self::W,
        Self::EpsXx,
        Self::EpsYy,
        Self::GammaXy,
        Self::GammaXz,
        Self::GammaYz,
        Self::EpsZz,
        Self::Eps1,
        Self::Eps2,
    ];

    const TABLE: [QuantityEntry; Self::ALL.len()] = [
        (["sigma_xx", "sigma_rr", "sigma_xx"], |point| point.sigma_xx),
        (["sigma_yy", "sigma_zz", "sigma_zz"], |point| point.sigma_yy),
        (["sigma_xy", "tau_rz", "tau_xz"], |point| point.sigma_xy),
        (["sigma_zz", "sigma_tt", "sigma_yy"], |point| point.sigma_zz),
        (["sigma_xz", "tau_rt", "tau_xy"], |point| point.sigma_xz),
        (["sigma_yz", "tau_tz", "tau_yz"], |point| point.sigma_yz),
        (["sigma_1"; 3], |point| point.principal()[0]),
        (["sigma_2", "sigma_2", "sigma_3"], |point| point.principal()[1]),
        (["max_shear"; 3], FieldPoint::max_shear),
        (["von_mises"; 3], FieldPoint::von_mises),
        (["u", "u_r", "u_x"], |point| point.u),
        (["v", "u_z", "u_z"], |point| point.v),
        (["w", "u_t", "u_y"], |point| point.w),
        (["eps_xx", "eps_rr", "eps_xx"], |point| point.eps_xx),
        (["eps_yy", "eps_zz", "eps_zz"], |point| point.eps_yy),
        (["gamma_xy", "gamma_rz", "gamma_xz"], |point| point.gamma_xy),
        (["gamma_xz", "gamma_rt", "gamma_xy"], |point| point.gamma_xz),
        (["gamma_yz", "gamma_tz", "gamma_yz"], |point| point.gamma_yz),
        (["eps_zz", "eps_tt", "eps_yy"], |point| point.eps_zz),
        (["eps_1"; 3], |point| point.principal_strains()[0]),
        (["eps_2", "eps_2", "eps_3"], |point| point.principal_strains()[1]),
    ];

    /// The quantities that a field in these coordinates has: others are 0 everywhere.
    pub fn all_in(coordinates: impl Into<Coordinates>) -> impl Iterator<Item = Self> {
        let is_cartesian = coordinates.into() == Coordinates::Cartesian;
        let is_spatial =
            |own: &Self| matches!(own, Self::SigmaXz | Self::SigmaYz | Self::W | Self::GammaXz | Self::GammaYz);
        Self::ALL.into_iter().filter(move |own| is_cartesian || !is_spatial(own))
    }

    /// The quantity of this name in the coordinates of a geometry, or in others.
    ///
    /// # Errors
    /// If there is none: what was found, and all that there are.
    pub fn named(name: &str, coordinates: impl Into<Coordinates>) -> Result<Self, String> {
        let coordinates = coordinates.into();
        let names = || Self::all_in(coordinates).map(|quantity| quantity.name_in(coordinates)).collect::<Vec<_>>();
        let found = Self::all_in(coordinates).find(|quantity| quantity.name_in(coordinates) == name);
        found.ok_or_else(|| format!("there is no {name} in this geometry; there are {}", names().join(", ")))
    }

    /// Whether it is a strain, which has no unit.
    pub(crate) fn is_strain(self) -> bool {
        self as usize >= Self::EpsXx as usize
    }

    /// Whether it is a normal stress or strain, positive in tension.
    pub(crate) fn is_tensile(self) -> bool {
        matches!(
            self,
            Self::SigmaXx
                | Self::SigmaYy
                | Self::SigmaZz
                | Self::Sigma1
                | Self::EpsXx
                | Self::EpsYy
                | Self::EpsZz
                | Self::Eps1
        )
    }

    /// Whether it needs what a material may not tell of the direction out of the plane.
    pub(crate) fn is_out_of_plane(self) -> bool {
        matches!(self, Self::SigmaZz | Self::VonMises | Self::EpsZz)
    }

    /// The name of the quantity, as in the columns of a CSV file.
    pub fn name(self) -> &'static str {
        Self::TABLE[self as usize].0[0]
    }

    /// The name of the quantity in the coordinates of a geometry, or in others, as in the columns of a CSV file: in axisymmetric problems z is downwards.
    ///
    /// ```
    /// use recede::{FieldQuantity, Geometry};
    /// assert_eq!(FieldQuantity::SigmaZz.name_in(Geometry::Axisymmetric), "sigma_tt");
    /// ```
    pub fn name_in(self, coordinates: impl Into<Coordinates>) -> &'static str {
        Self::TABLE[self as usize].0[coordinates.into() as usize]
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

    /// The value of the quantity in the coordinates of a geometry, or in others, under [`Self::name_in`]: z points downwards in axisymmetric problems.
    pub fn of_in(self, point: &FieldPoint, coordinates: impl Into<Coordinates>) -> f64 {
        let turns = matches!(self, Self::SigmaXy | Self::SigmaYz | Self::V | Self::GammaXy | Self::GammaYz);
        // not −0
        if turns && coordinates.into() != Coordinates::Plane { 0.0 - self.of(point) } else { self.of(point) }
    }
}
