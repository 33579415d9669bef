//! What the state equations need to know of a material at one depth.
use num_complex::Complex64;
#[cfg(feature = "read")]
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{LayerError, Notation, Poisson, Positive};

/// Whether the plane problem is one of plane strain or of plane stress.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(feature = "read", derive(JsonSchema))]
pub enum Plane {
    /// Plane strain, ε_zz = 0: κ = 3 − 4ν.
    #[default]
    Strain,
    /// Plane stress, σ_zz = 0: κ = (3 − ν)/(1 + ν).
    Stress,
}

/// Roots this close to 1 are the roots of an isotropic material: rounding of the coefficients moves a double
/// root by its square root.
const DOUBLE: f64 = 1e-6;

/// The four coefficients of the state equations at one depth, and what they do not tell of the stress out of the plane.
///
/// For an orthotropic material with axes along x and y and stiffnesses c11, c12, c22, c66 (σ_xx = c11 ε_xx +
/// c12 ε_yy, ...). None of them is singular for an incompressible material (ν = 1/2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// 1/c66 = 1/μ, in 1/stress.
    pub shear_compliance: f64,
    /// 1/c22 = (κ − 1)/((κ + 1) μ), in 1/stress; zero if incompressible in plane strain.
    pub normal_compliance: f64,
    /// c12/c22 = (3 − κ)/(κ + 1), dimensionless.
    pub coupling: f64,
    /// c11 − c12²/c22 = 8 μ/(κ + 1), the modulus of a plate stretched along x, in stress.
    pub axial_stiffness: f64,
    /// The stress out of the plane, σ_zz = s_x σ_xx + s_y σ_yy, as [s_x, s_y], dimensionless: [ν, ν] of an isotropic
    /// material in plane strain. The other four coefficients do not tell it; `None` where it is not known. In plane stress
    /// nobody asks.
    pub out_of_plane: Option<[f64; 2]>,
}

/// Coefficients that differ by less, in parts of their size, are the same.
const SAME: f64 = 1e-9;

impl Material {
    /// Whether these are the coefficients of an isotropic material in plane strain: the four coefficients follow from two of them.
    pub fn is_isotropic(&self) -> bool {
        let [stiffness, compliance] = [2.0 * (1.0 + self.coupling), 0.5 * (1.0 - self.coupling)];
        (self.axial_stiffness * self.shear_compliance - stiffness).abs() <= SAME * stiffness
            && (self.normal_compliance / self.shear_compliance - compliance).abs() <= SAME
    }

    /// How fast the slowest field decays with λ·depth, dimensionless: the smaller real part of the roots of
    /// s⁴ − (em − 2c) s² + c² + ed = 0, in which m, d, c, e are the coefficients of this material, in their order. 1 for
    /// any isotropic material, less for one that is stiff along the layers.
    ///
    /// ```
    /// use recede_layers::{EngineeringConstants, Isotropic, Plane};
    /// assert_eq!(Isotropic::new(3.0, 0.3)?.material(Plane::Strain).slowest_decay(), 1.0);
    /// let ply = EngineeringConstants::new([140.0, 10.0, 10.0], [0.3, 0.3, 0.4], 5.0)?;
    /// assert!(ply.material(Plane::Strain).slowest_decay() < 0.7);
    /// # Ok::<(), recede_layers::LayerError>(())
    /// ```
    pub fn slowest_decay(&self) -> f64 {
        let [first, second] = self.squared_roots();
        // of an isotropic material both are 1, up to the root of rounding
        let slowest = if first.im != 0.0 { first.sqrt().re } else { first.re.min(second.re).max(0.0).sqrt() };
        if (slowest - 1.0).abs() < DOUBLE { 1.0 } else { slowest }
    }

    /// The squares of the roots s of the characteristic equation, both real or conjugate.
    pub fn squared_roots(&self) -> [Complex64; 2] {
        let (e, m) = (self.axial_stiffness, self.shear_compliance);
        let half = 0.5 * (e * m - 2.0 * self.coupling);
        let product = self.coupling * self.coupling + e * self.normal_compliance;
        let square = half * half - product;
        if square < 0.0 {
            let root = Complex64::new(half, (-square).sqrt());
            return [root, root.conj()];
        }
        // the larger one without cancellation, the other one from the product
        let large = if half < 0.0 { half - square.sqrt() } else { half + square.sqrt() };
        [large, if large == 0.0 { 0.0 } else { product / large }].map(Complex64::from)
    }
}

/// An isotropic elastic material: shear modulus μ and Poisson's ratio ν.
///
/// ```
/// use recede_layers::{Isotropic, Plane};
/// let steel = Isotropic::new(80e9, 0.25)?;
/// assert_eq!(steel.kappa(Plane::Strain), 2.0);
/// # Ok::<(), recede_layers::LayerError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isotropic {
    /// Shear modulus μ, in stress.
    pub shear_modulus: f64,
    /// Poisson's ratio ν, dimensionless, −1 < ν ≤ 1/2.
    pub poisson: f64,
}

impl Isotropic {
    /// A material of shear modulus μ > 0 and Poisson's ratio −1 < ν ≤ 1/2.
    ///
    /// # Errors
    /// [`LayerError`] if a number is outside its range or not finite.
    pub fn new(shear_modulus: f64, poisson: f64) -> Result<Self, LayerError> {
        Ok(Self {
            shear_modulus: LayerError::checked::<Positive>("shear_modulus", shear_modulus)?.get(),
            poisson: LayerError::checked::<Poisson>("poisson", poisson)?.get(),
        })
    }

    /// A material of Young's modulus E > 0 and Poisson's ratio −1 < ν ≤ 1/2: μ = E/(2(1 + ν)).
    ///
    /// ```
    /// use recede_layers::{HalfPlane, Isotropic};
    /// let steel = Isotropic::from_young(210e3, 0.3)?;
    /// let ground = HalfPlane::new(steel.shear_modulus, steel.poisson)?;
    /// assert!((steel.shear_modulus - 80769.2307).abs() < 1e-3);
    /// # Ok::<(), recede_layers::LayerError>(())
    /// ```
    ///
    /// # Errors
    /// [`LayerError`] if a number is outside its range or not finite.
    pub fn from_young(young: f64, poisson: f64) -> Result<Self, LayerError> {
        ElasticConstants::read(
            None,
            Some(LayerError::checked("young", young)?),
            LayerError::checked("poisson", poisson)?,
        )
        .map(|constants| constants.isotropic())
    }

    /// Kolosov's constant κ, dimensionless: 3 − 4ν in plane strain, (3 − ν)/(1 + ν) in plane stress.
    pub fn kappa(&self, plane: Plane) -> f64 {
        match plane {
            Plane::Strain => 3.0 - 4.0 * self.poisson,
            Plane::Stress => (3.0 - self.poisson) / (1.0 + self.poisson),
        }
    }

    /// The coefficients of the state equations.
    pub fn material(&self, plane: Plane) -> Material {
        let (mu, nu) = (self.shear_modulus, self.poisson);
        // Written in ν rather than κ, so that κ − 1 and 3 − κ lose no digit near ν = 1/2 and ν = 0.
        match plane {
            Plane::Strain => Material {
                shear_compliance: 1.0 / mu,
                normal_compliance: (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu) * mu),
                coupling: nu / (1.0 - nu),
                axial_stiffness: 2.0 * mu / (1.0 - nu),
                out_of_plane: Some([nu, nu]),
            },
            Plane::Stress => Material {
                shear_compliance: 1.0 / mu,
                normal_compliance: (1.0 - nu) / (2.0 * mu),
                coupling: nu,
                axial_stiffness: 2.0 * mu * (1.0 + nu),
                out_of_plane: Some([0.0; 2]),
            },
        }
    }
}

/// The constants of an isotropic material as written in a scene: Poisson's ratio, and either the shear modulus or Young's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElasticConstants {
    modulus: Modulus<Positive>,
    poisson: Poisson,
}

/// A modulus as written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Modulus<Q> {
    /// `shear_modulus`
    Shear(Q),
    /// `young`
    Young(Q),
}

impl<Q> Modulus<Q> {
    /// Exactly one of the two fields.
    pub(crate) fn one_of(shear_modulus: Option<Q>, young: Option<Q>) -> Result<Self, LayerError> {
        let fields = ["shear_modulus", "young"];
        match (shear_modulus, young) {
            (Some(shear_modulus), None) => Ok(Self::Shear(shear_modulus)),
            (None, Some(young)) => Ok(Self::Young(young)),
            (None, None) => Err(LayerError::EitherOr { found: "none", fields }),
            (Some(_), Some(_)) => Err(LayerError::EitherOr { found: "both", fields }),
        }
    }

    /// The name of the field, and its value.
    pub(crate) fn field(&self) -> (&'static str, &Q) {
        match self {
            Self::Shear(value) => ("shear_modulus", value),
            Self::Young(value) => ("young", value),
        }
    }

    /// The material with the value that the modulus has somewhere.
    pub(crate) fn isotropic(&self, value: f64, poisson: f64) -> Isotropic {
        let shear_modulus = match self {
            Self::Shear(_) => value,
            Self::Young(_) => 0.5 * value / (1.0 + poisson),
        };
        Isotropic { shear_modulus, poisson }
    }
}

impl ElasticConstants {
    /// Shear modulus μ > 0 (stress) and Poisson's ratio −1 < ν ≤ 1/2.
    ///
    /// # Errors
    /// [`LayerError`] if a number is outside its range or not finite.
    pub fn new(shear_modulus: f64, poisson: f64) -> Result<Self, LayerError> {
        let shear_modulus = LayerError::checked("shear_modulus", shear_modulus)?;
        Ok(Self { modulus: Modulus::Shear(shear_modulus), poisson: LayerError::checked("poisson", poisson)? })
    }

    /// What the fields `shear_modulus` or `young`, and `poisson` say.
    ///
    /// # Errors
    /// [`LayerError::EitherOr`] unless exactly one modulus is given, [`LayerError::Field`] if Young's modulus makes the shear
    /// modulus too small or too large a number.
    pub fn read(
        shear_modulus: Option<Positive>,
        young: Option<Positive>,
        poisson: Poisson,
    ) -> Result<Self, LayerError> {
        let constants = Self { modulus: Modulus::one_of(shear_modulus, young)?, poisson };
        LayerError::checked::<Positive>("shear modulus from `young`", constants.isotropic().shear_modulus)?;
        Ok(constants)
    }

    /// The material.
    pub fn isotropic(&self) -> Isotropic {
        self.modulus.isotropic(self.modulus.field().1.get(), self.poisson.get())
    }

    /// Adds the fields to a notation, as they were given.
    pub fn noted(&self, notation: Notation) -> Notation {
        let (name, value) = self.modulus.field();
        notation.with(name, value).with("poisson", &self.poisson)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coefficients_are_those_of_kappa() {
        for poisson in [-0.9, -0.5, 0.0, 0.25, 0.5] {
            for plane in [Plane::Strain, Plane::Stress] {
                let isotropic = Isotropic { shear_modulus: 2.0, poisson };
                let (kappa, material) = (isotropic.kappa(plane), isotropic.material(plane));
                for (found, expected) in [
                    (material.shear_compliance, 0.5),
                    (material.normal_compliance, (kappa - 1.0) / (kappa + 1.0) / 2.0),
                    (material.coupling, (3.0 - kappa) / (kappa + 1.0)),
                    (material.axial_stiffness, 16.0 / (kappa + 1.0)),
                ] {
                    assert!((found - expected).abs() < 1e-14, "ν = {poisson}, {plane:?}: {found} ≠ {expected}");
                }
            }
        }
    }

    #[test]
    fn plane_stress_is_plane_strain_of_another_material() {
        let (strain, stress) = (0.3, 0.3 / 0.7);
        let [a, b] = [(strain, Plane::Strain), (stress, Plane::Stress)]
            .map(|(poisson, plane)| Isotropic { shear_modulus: 1.0, poisson }.material(plane));
        assert!((a.axial_stiffness - b.axial_stiffness).abs() < 1e-15 && (a.coupling - b.coupling).abs() < 1e-15);
    }

    #[test]
    fn one_modulus_is_to_be_given() {
        let positive = |value: f64| Positive::try_from(value).ok();
        let quarter = Poisson::try_from(0.25).expect("legal");
        let steel = ElasticConstants::read(None, positive(200.0), quarter).expect("legal");
        assert_eq!(steel.isotropic(), Isotropic { shear_modulus: 80.0, poisson: 0.25 });
        for (shear_modulus, young, message) in [
            (None, None, "found none of `shear_modulus` and `young`; allowed is one of them"),
            (positive(1.0), positive(1.0), "found both of `shear_modulus` and `young`; allowed is one of them"),
            (None, positive(5e-324), "shear modulus from `young`: found 0.0, allowed is a finite number > 0"),
        ] {
            let error = ElasticConstants::read(shear_modulus, young, quarter).expect_err(message);
            assert_eq!(error.to_string(), message);
        }
    }

    #[test]
    fn impossible_materials_are_rejected() {
        for (shear_modulus, poisson) in [(0.0, 0.3), (-1.0, 0.3), (f64::NAN, 0.3), (1.0, -1.0), (1.0, 0.51)] {
            assert!(Isotropic::new(shear_modulus, poisson).is_err(), "{shear_modulus}, {poisson}");
        }
    }
}
