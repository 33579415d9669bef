//! Stresses, strains and displacements at points of the stack as columns of a sweep.
use std::fmt;

use crate::axis::AxisError;
use crate::field::{FieldQuantity, SpacePoint};
use crate::geometry::Coordinates;

/// A quantity at a point.
///
/// ```
/// use recede::{Geometry, Probe};
/// let probe = Probe::parse("0,0.2@1=eps_xx", Geometry::PlaneStrain)?;
/// assert_eq!((probe.point.depth, probe.point.layer), (0.2, Some(1)));
/// assert!(Probe::parse("0,0.2=eps_rr", Geometry::PlaneStrain).is_err());
/// # Ok::<(), recede::AxisError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Probe {
    /// Where.
    pub point: SpacePoint,
    /// What.
    pub quantity: FieldQuantity,
    coordinates: Coordinates,
}

impl Probe {
    /// Reads X,DEPTH=QUANTITY or X,DEPTH@LAYER=QUANTITY, under loads at several places (x, y) also X,Y,DEPTH, with the names that quantities have in the coordinates of a geometry, or in others.
    ///
    /// # Errors
    /// [`AxisError`] if the text is no point, or the geometry has no such quantity.
    pub fn parse(text: &str, coordinates: impl Into<Coordinates>) -> Result<Self, AxisError> {
        let coordinates = coordinates.into();
        let (point, name) = text
            .rsplit_once('=')
            .ok_or_else(|| AxisError::new(text, "X,DEPTH=QUANTITY or X,DEPTH@LAYER=QUANTITY is expected"))?;
        let point = point.parse().map_err(|reason: String| AxisError::new(text, reason))?;
        let quantity = FieldQuantity::named(name.trim(), coordinates);
        let quantity = quantity.map_err(|reason| AxisError::new(text, reason))?;
        Ok(Self { point, quantity, coordinates })
    }
}

/// The name of the column.
impl fmt::Display for Probe {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let SpacePoint { x, y, depth, layer } = self.point;
        write!(f, "{}_at_{x}", self.quantity.name_in(self.coordinates))?;
        if self.coordinates == Coordinates::Cartesian {
            write!(f, "_{y}")?;
        }
        write!(f, "_{depth}")?;
        layer.map_or(Ok(()), |layer| write!(f, "_in_{layer}"))
    }
}
