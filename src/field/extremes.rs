//! Stresses and strains by which layers and bonds break: the largest tension, the largest von Mises stress and tensile strain of each layer, and the largest shear
//! stress and tension across each interface that does not open.
use serde::Serialize;

use super::error::FieldError;
use super::measure::Measure;
use super::search::{HighestPlace, highest};
use super::{Field, PlacedLayer, Point, waves};
use crate::system::Unresolved;

/// Stresses below this part of the mean pressure are rounding, and below [`Precision::on_face`] of it what sums over wavenumbers
/// leave out.
const NOTHING: f64 = 1e-12;

/// The largest value of a stress or of a strain, and where it is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Extreme {
    /// The stress or strain; infinite where it is at a singular point.
    pub value: f64,
    /// Estimate of its absolute error; 0 if it is infinite.
    pub error: f64,
    /// Along the layers; of symmetric contacts in the middle or on the right of it, and found on the left, too.
    pub x: f64,
    /// Below the top face of the stack.
    pub depth: f64,
    /// Number of the layer; above an interface, if it is one of that.
    pub layer: usize,
}

/// The largest shear stress in the plane, (σ₁ − σ₂)/2, and where it is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct MaxShear {
    /// The stress; infinite under a line load and at the sharp corners of a punch.
    pub value: f64,
    /// Along the layers; of symmetric contacts in the middle or on the right of it, and found on the left, too.
    pub x: f64,
    /// Below the top face of the stack.
    pub depth: f64,
    /// Number of the layer.
    pub layer: usize,
}

/// The extremes of a layer.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct LayerExtremes {
    /// Number of the layer, from the top as written in the scene, starting at 1.
    pub layer: usize,
    /// Von Mises' equivalent stress; `None` if the material does not give the stress out of the plane.
    pub von_mises: Option<Extreme>,
    /// The largest strain, dimensionless, positive where the layer is stretched; about an axis in any direction. `None` if it is stretched nowhere.
    pub tensile_strain: Option<Extreme>,
}

/// The extremes of an interface that does not open: bonded, sliding, or of springs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BondExtremes {
    /// Number of the layer above.
    pub above: usize,
    /// Number of the layer or base below.
    pub below: usize,
    /// The size of the shear stress; `None` if there is none.
    pub shear: Option<Extreme>,
    /// The tension across the interface, by which it would open; `None` if it is compressed everywhere.
    pub tension: Option<Extreme>,
}

/// Stresses and strains by which layers and bonds break; made by [`Field::extremes`].
///
/// ```
/// use recede::{HalfPlane, Homogeneous, Model, Plane, Punch, Stack};
/// let coating = Homogeneous::new(0.1, 20.0, 0.25)?;
/// let model = Model::new(Stack::builder(Plane::Strain).layer(coating).bonded().layer(HalfPlane::new(1.0, 0.25)?).build()?)?;
/// let extremes = model.field(&model.press(&Punch::cylinder(100.0)?, 0.01)?)?.extremes()?;
/// // under the end of the contact the ground is stretched where the coating is bonded to it
/// let tension = extremes.tension.unwrap();
/// assert_eq!((tension.layer, tension.depth), (2, 0.1));
/// assert!(extremes.bonds[0].shear.unwrap().value < extremes.layers[0].von_mises.unwrap().value);
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Extremes {
    /// The largest principal stress in the plane anywhere in the stack; `None` if there is no tension.
    pub tension: Option<Extreme>,
    /// The layers from the top down.
    pub layers: Vec<LayerExtremes>,
    /// The interfaces that do not open, from the top down.
    pub bonds: Vec<BondExtremes>,
}

impl Field {
    /// The largest shear stress in the plane anywhere in the stack, (σ₁ − σ₂)/2, and where it is.
    ///
    /// # Errors
    /// [`FieldError::Unresolved`] if the fields cannot be computed; [`FieldError::Superposed`] under loads at several places (x, y).
    pub fn max_shear(&self) -> Result<MaxShear, FieldError> {
        self.check_searched()?;
        let found = highest(self, &[(Measure::MaxShear, None)])?.into_iter().next().flatten();
        let HighestPlace { layer, place: [x, depth], value, .. } = found.ok_or(Unresolved { wavenumber: 0.0 })?;
        let placed = &self.layers[layer];
        Ok(MaxShear { value, x: self.middle + x, depth: placed.top + depth, layer: placed.number })
    }

    /// The largest tension, the largest von Mises stress and tensile strain of each layer, and the largest shear stress and tension across each interface
    /// that does not open.
    ///
    /// A value is the value of the field at the place named, right to the error given with it. Places are found to some 1e-4 of the shortest
    /// half-length, and a half-plane is searched to three half-lengths of the longest contact; so a value is the largest to some
    /// 1e-6 of itself. Where a pressure jumps, stresses are limits from one side, and the place is next to the end of the load. Where contacts
    /// are so long, or layers so thin, that not all short waves are summed, the error has what the search does not see of them.
    ///
    /// # Errors
    /// As [`Self::max_shear`].
    pub fn extremes(&self) -> Result<Extremes, FieldError> {
        self.check_searched()?;
        let (layers, bonds) = (0..self.layers.len(), self.bonds());
        let mut searches = vec![(Measure::Tension, None)];
        let of_layer = |layer| [Measure::VonMises, Measure::TensileStrain].map(|measure| (measure, Some(layer)));
        searches.extend(layers.clone().flat_map(of_layer));
        for (layer, _) in &bonds {
            searches.extend([Measure::FaceShear, Measure::FaceTension].map(|measure| (measure, Some(*layer))));
        }
        let mut extremes = self.exact(&highest(self, &searches)?)?.into_iter();
        let mut next = || extremes.next().flatten();
        let tension = next();
        let of_layer = |layer: usize| LayerExtremes {
            layer: self.layers[layer].number,
            von_mises: next(),
            tensile_strain: next(),
        };
        let layers = layers.map(of_layer).collect();
        let bonds = bonds.into_iter().map(|(layer, below)| BondExtremes {
            above: self.layers[layer].number,
            below,
            shear: next(),
            tension: next(),
        });
        Ok(Extremes { tension, layers, bonds: bonds.collect() })
    }

    /// The values of the field at peaks, with their errors; `None` where they are no larger than what sums over wavenumbers miss.
    fn exact(&self, peaks: &[Option<HighestPlace>]) -> Result<Vec<Option<Extreme>>, FieldError> {
        let point = |peak: &HighestPlace| {
            let placed = &self.layers[peak.layer];
            Point { x: self.middle + peak.place[0], depth: placed.top + peak.place[1], layer: Some(placed.number) }
        };
        let finite = peaks.iter().flatten().filter(|peak| peak.value.is_finite());
        let mut there = self.points(&finite.map(point).collect::<Vec<_>>())?.into_iter();
        let mut extreme = |peak: &HighestPlace| {
            let (point, layer) = (point(peak), self.layers[peak.layer].number);
            let of = |value: f64, error: f64| Extreme { value, error, x: point.x, depth: point.depth, layer };
            let Some(there) = peak.value.is_finite().then(|| there.next()).flatten() else {
                return Ok(Some(of(f64::INFINITY, 0.0)));
            };
            let (row, place, mean) = (self.row(&point, 0)?, self.place(point.x), self.mean_pressure(peak.layer));
            // what a sum leaves out that ends at its cut-off, and what one leaves out that ends before
            let allowed = waves::STRESSES.on_face * mean;
            let unseen = (self.truncation(&row, place, &waves::STRESSES) - allowed).max(0.0);
            let missed = self.truncation(&row, place, &waves::FULL).min(allowed) + NOTHING * mean;
            let (value, error) = (peak.measure.of(&there), self.stress_error(&point)? + unseen);
            // a strain follows from two stresses
            let found = match peak.measure {
                Measure::TensileStrain => of(value / there.stiffness, 2.0 * error / there.stiffness),
                _ => of(value, error),
            };
            Ok(Some(found).filter(|_| value > missed))
        };
        peaks.iter().map(|peak| peak.as_ref().map_or(Ok(None), &mut extreme)).collect()
    }

    /// The layers with an interface below them that does not open, by their index, and the number of the layer or base below.
    fn bonds(&self) -> Vec<(usize, usize)> {
        let of = |(layer, placed): (usize, &PlacedLayer)| {
            let next = self.layers.get(layer + 1).filter(|next| next.body == placed.body).map(|next| next.number);
            let is_last = layer + 1 == self.layers.len();
            let base = (is_last && placed.thickness.is_some()).then_some(self.base).flatten();
            Some((layer, next.or(base)?))
        };
        self.layers.iter().enumerate().filter_map(of).collect()
    }
}
