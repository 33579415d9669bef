//! Stresses and displacements inside the stack.
//!
//! Given the contact pressures, each body of the stack is loaded on shear-free faces, and its fields are integrals over
//! the wavenumber of the states that [`crate::system`] finds inside. Next to a loaded face these integrals converge slowly; there
//! the fields of a half-plane of the face's material are subtracted, and added in closed form.
mod body;
mod closed;
mod decay;
mod disc;
mod error;
mod extremes;
mod faces;
mod joints;
mod measure;
mod mesh;
mod place;
mod point;
mod polynomial;
mod pressure;
mod quantity;
mod search;
mod spheroid;
mod strip;
mod sum;
mod superposed;
mod surface;
mod transform;
mod waves;
mod window;

use std::sync::Arc;

use recede_layers::Wave;

pub use extremes::{BondExtremes, Extreme, Extremes, LayerExtremes, MaxShear};
pub use faces::{FaceProfile, FaceSide};
pub use place::{Point, SpacePoint};
pub use point::{FieldPoint, Grid};
pub(crate) use pressure::ContactPressure;
pub use quantity::FieldQuantity;
pub(crate) use waves::{DISPLACEMENTS, FULL, LOW, Precision, ROUGH};

use crate::geometry::Geometry;
use crate::solution::{ClosedInterface, Contact, Solution};
use crate::stack::{Gaps, Stack};
use crate::system::FaceLoad;
pub use error::FieldError;

use body::{DepthRow, LoadedBody, PlacedLayer, Rows};
use closed::{Closed, ClosedBodies};
use superposed::Superposed;
use surface::Components;

/// Rounding of stresses, in parts of the mean pressure.
const ROUNDING: f64 = 1e-12;
/// A depth is on an interface if it is as close to it as this, in parts of the depth.
const ON_INTERFACE: f64 = 1e-12;
/// Long waves are negligible below this part of 1/(thickness · ratio of the stiffnesses).
const LONG: f64 = 0.25;
/// At a depth d in a half-plane, waves of λd up to this are smooth to rounding on one panel.
const DEEP: f64 = 8.0;

/// For wavelengths this much longer than any length, the response of a graded half-plane is a power of λ and three terms more of a
/// series.
const POWER: f64 = 1e-3;

/// Stresses and displacements inside a stack pressed by a punch.
///
/// Stresses are positive in tension; x runs along the layers from the centre of the contact, y upwards, so that σ_xy > 0
/// drags the upper side of a cut towards −x. `depth` is measured downwards from the top face of the stack. Displacements
/// of a plane body are defined up to a rigid motion: u is 0 at x = 0, and v is counted from the rigid base or, on a
/// half-plane, from the point of its top face at x = 0.
///
/// On an interface σ_xx jumps, and if it is a receding one, so do the displacements outside the contact. There a point
/// belongs to the layer below, unless a layer is named.
///
/// ```
/// use recede::{Field, HalfPlane, Homogeneous, Model, Plane, Punch, Stack};
/// let strip = Homogeneous::new(1.0, 1.0, 0.25)?;
/// let stack = Stack::builder(Plane::Strain).layer(strip).receding().layer(HalfPlane::new(1.0, 0.25)?).build()?;
/// let model = Model::new(stack)?;
/// let solution = model.press(&Punch::cylinder(500.0)?, 0.002)?;
/// let field = model.field(&solution)?;
/// let under_the_punch = field.at(0.0, 0.0)?;
/// assert!((under_the_punch.sigma_yy + solution.contacts()[0].central_pressure).abs() < 1e-12);
/// // the strip bends: its lower face is stretched
/// assert!(field.at_layer(0.0, 1.0, 1)?.sigma_xx > 0.0);
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Field {
    geometry: Geometry,
    layers: Vec<PlacedLayer>,
    bodies: Vec<LoadedBody>,
    pressures: Vec<ContactPressure>,
    /// Whether the field is its own mirror image about the middle: it is computed on the right of it then.
    is_even: bool,
    /// Where the middle is, from which places of pressures and sums are counted: 0 of what is not even.
    middle: f64,
    /// For each contact two places at which the bodies touch; of an even one the same twice, 0 unless they are apart there.
    joints: Vec<[f64; 2]>,
    /// Gaps between layers before they were loaded.
    pub(crate) gaps: Gaps,
    /// The gap at these places of each contact.
    apart: Vec<[f64; 2]>,
    /// μ₀, by which displacements are multiplied.
    modulus: f64,
    /// Ratio of the largest to the smallest stiffness in the stack.
    contrast: f64,
    /// Ratio of the largest stiffness in the stack to the stiffness of a support over the thickness of the stack; 0 without one.
    over_support: f64,
    /// Number of the rigid base or support to which the last layer is joined, if there is one.
    base: Option<usize>,
    /// Error estimate of the pressures, in stress.
    pressure_error: f64,
    /// Fields about several axes, of which this one is the sum.
    superposed: Option<Superposed>,
    /// The field in the body that presses on top.
    second: Option<Box<Field>>,
}

impl Field {
    /// The field of a solution of this stack; to be had from [`crate::Model::field`].
    pub(crate) fn new(stack: &Stack, solution: &Solution) -> Self {
        let layers = body::layers(stack);
        let modulus = layers.first().map_or(1.0, |s| s.layer.material(0.0, stack.plane()).shear_compliance.recip());
        let gaps = stack.gaps().dents();
        // dents are about x = 0
        let is_at_middle = |middle: &f64| *middle == 0.0 || solution.closed().is_empty() || gaps.0.is_empty();
        let about = solution.about().filter(is_at_middle).filter(|_| solution.axes().is_empty());
        let (is_even, middle) = (about.is_some(), about.unwrap_or(0.0));
        let contacts = solution.contacts();
        // interfaces that come apart, counted from the middle
        let apart = stack.laminates().len() + 1 > contacts.len();
        let moved = |own: &ClosedInterface| own.clone().scaled(1.0, -middle, [1.0; 2]);
        let closed: Vec<ClosedInterface> = solution.closed().iter().filter(|_| apart).map(moved).collect();
        let pressure = |contact| ContactPressure::new(contact, is_even, middle);
        let mut pressures: Vec<ContactPressure> = contacts.iter().map(pressure).collect();
        if let (false, Some(above)) = (closed.is_empty(), contacts.last()) {
            let bodies = Arc::new(ClosedBodies::new(stack, modulus, &above.clone().moved(-middle), &closed, &gaps));
            let of = |(k, own): (usize, &ClosedInterface)| {
                ContactPressure::of_closed(own, is_even, Closed::new(&bodies, k + 1, body::thinnest(&layers)))
            };
            pressures.extend(closed.iter().enumerate().map(of));
        }
        let stiffnesses = |placed: &PlacedLayer| {
            let depths = [0.0, 0.5, 1.0].map(|part| part * placed.thickness.unwrap_or(0.0));
            depths.map(|depth| placed.layer.material(depth, stack.plane()).axial_stiffness)
        };
        let stiffness: Vec<f64> = layers.iter().flat_map(stiffnesses).collect();
        let [largest, smallest] =
            [f64::max, f64::min].map(|pick| stiffness.iter().copied().reduce(pick).unwrap_or(1.0));
        let below = stack.base();
        let is_joined = !below.layers().is_empty() && below.foundation().half_plane().is_none();
        let touching = contacts.iter().map(|contact| contact.clone().moved(-middle).touching());
        let beside = closed.iter().map(|own| joints::beside_openings(own, is_even, stack.total_thickness()));
        let joints: Vec<[f64; 2]> = touching.chain(beside).collect();
        let mut field = Self {
            geometry: stack.geometry(),
            bodies: LoadedBody::all(stack, &layers, &pressures, modulus),
            layers,
            pressures,
            is_even,
            middle,
            joints,
            // what weights press flat is no gap
            gaps: if closed.is_empty() { stack.gaps() } else { gaps },
            apart: Vec::new(),
            modulus,
            contrast: largest / smallest,
            over_support: largest / support_stiffness(stack, modulus),
            base: is_joined.then(|| below.foundation().number()),
            pressure_error: 0.0,
            superposed: Superposed::new(stack, solution),
            second: Self::of_second(stack, solution),
        };
        let interfaces = contacts.iter().map(|own| own.interface).chain(closed.iter().map(|own| own.interface));
        let apart = interfaces.zip(&field.joints);
        field.apart = apart.map(|(own, joint)| joint.map(|x| field.gaps.height(own, x + middle))).collect();
        let error = |(i, contact): (usize, &Contact)| pressure_error(contact, field.pressures[i].mean(field.length(i)));
        field.pressure_error = contacts.iter().enumerate().map(error).sum();
        field
    }

    /// Stresses and displacements at a point; on an interface, of the layer below.
    ///
    /// # Errors
    /// [`FieldError::Outside`] if there is no layer at this depth.
    pub fn at(&self, x: f64, depth: f64) -> Result<FieldPoint, FieldError> {
        Ok(self.points(&[Point { x, depth, layer: None }])?[0])
    }

    /// Stresses and displacements at a point of a layer, numbered from the top as written in the scene, starting at 1.
    ///
    /// # Errors
    /// [`FieldError::Outside`] if the layer is not there, or not at this depth.
    pub fn at_layer(&self, x: f64, depth: f64, layer: usize) -> Result<FieldPoint, FieldError> {
        Ok(self.points(&[Point { x, depth, layer: Some(layer) }])?[0])
    }

    /// The estimated error of the stresses at a point, in stress: the error of the pressures, and the truncation error of the sums over
    /// wavenumbers. Infinite where stresses are.
    ///
    /// Next to the ends of contacts the pressure itself is less accurate, by the square root of the error of the half-length. Next to a contact
    /// thousands of times longer than a layer not all short waves are summed, and the estimate is larger by what is left out.
    ///
    /// ```
    /// # use recede::{HalfPlane, Model, Plane, Punch, Point, Stack};
    /// # let model = Model::new(Stack::builder(Plane::Strain).layer(HalfPlane::new(1.0, 0.25)?).build()?)?;
    /// let solution = model.press(&Punch::parabola(500.0)?, 0.002)?;
    /// let error = model.field(&solution)?.stress_error(&Point { x: 0.1, depth: 0.2, layer: None })?;
    /// assert!(error > 0.0 && error < 1e-9 * solution.contacts()[0].central_pressure);
    /// # Ok::<(), recede::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`FieldError::Outside`] if the layer is not there, or not at this depth.
    pub fn stress_error(&self, point: &Point) -> Result<f64, FieldError> {
        let row = self.row(point, 0)?;
        if let Some(error) = self.superposed_error(point) {
            return error;
        }
        let face = (row.depth == 0.0).then(|| self.bodies[self.layers[row.layer].body].contact);
        let place = self.place(point.x);
        let singular = face.is_some_and(|contact| self.pressures[contact].singularity(place).is_some());
        Ok(if singular { f64::INFINITY } else { self.pressure_error + self.truncation(&row, place, &waves::FULL) })
    }

    /// Stresses and displacements at any points; cheaper than one by one.
    ///
    /// # Errors
    /// As [`Self::at`] and [`Self::at_layer`].
    pub fn points(&self, requested: &[Point]) -> Result<Vec<FieldPoint>, FieldError> {
        let row = |(set, point): (usize, &Point)| self.row(point, set);
        let rows: Vec<DepthRow> = requested.iter().enumerate().map(row).collect::<Result<_, _>>()?;
        let sets = requested.iter().map(|point| vec![point.x - self.middle]).collect();
        let found = self.at_places(&Rows { rows, sets }, &waves::FULL)?.concat();
        Ok(found.into_iter().zip(requested).map(|(found, Point { x, .. })| FieldPoint { x: *x, ..found }).collect())
    }

    /// Stresses and displacements on a grid, row by row from the first depth on.
    ///
    /// ```
    /// # use recede::{HalfPlane, Model, Plane, Punch, Stack};
    /// # let model = Model::new(Stack::builder(Plane::Strain).layer(HalfPlane::new(1.0, 0.25)?).build()?)?;
    /// # let solution = model.press(&Punch::parabola(500.0)?, 0.002)?;
    /// let grid = model.field(&solution)?.grid(&[-1.0, 0.0, 1.0], &[0.0, 0.5])?;
    /// assert_eq!(grid.points().len(), 6);
    /// assert_eq!(grid.at(1, 0).sigma_xy, -grid.at(1, 2).sigma_xy); // row 1, places 0 and 2
    /// # Ok::<(), recede::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Self::at`].
    pub fn grid(&self, xs: &[f64], depths: &[f64]) -> Result<Grid, FieldError> {
        self.grid_in(None, xs, depths)
    }

    /// The same in a layer, numbered from the top as written in the scene, starting at 1, on both of its faces, too.
    ///
    /// # Errors
    /// As [`Self::at_layer`].
    pub fn grid_of_layer(&self, layer: usize, xs: &[f64], depths: &[f64]) -> Result<Grid, FieldError> {
        self.grid_in(Some(layer), xs, depths)
    }

    fn grid_in(&self, layer: Option<usize>, xs: &[f64], depths: &[f64]) -> Result<Grid, FieldError> {
        let x = xs.first().copied().unwrap_or(0.0);
        let point = |depth: &f64| self.row(&Point { x, depth: *depth, layer }, 0);
        let rows: Vec<DepthRow> = depths.iter().map(point).collect::<Result<_, _>>()?;
        Ok(Grid { xs: xs.to_vec(), points: self.lines(xs, &rows, &FULL)?.concat() })
    }

    /// Stresses and displacements layer by layer, on grids that reach the layers' faces, since stresses along the layers
    /// jump there: in each of them between the smallest and the largest of these depths, which are to ascend.
    ///
    /// ```
    /// # use recede::{HalfPlane, Homogeneous, Model, Plane, Punch, Stack};
    /// # let strip = Homogeneous::new(1.0, 1.0, 0.25)?;
    /// # let stack = Stack::builder(Plane::Strain).layer(strip).receding().layer(HalfPlane::new(1.0, 0.25)?).build()?;
    /// # let model = Model::new(stack)?;
    /// # let solution = model.press(&Punch::parabola(500.0)?, 0.002)?;
    /// let grids = model.field(&solution)?.by_layer(&[0.0, 0.5], &[0.0, 0.6, 1.2, 1.8])?;
    /// let depths = |k: usize| grids[k].rows().map(|row| row[0].depth).collect::<Vec<_>>();
    /// assert_eq!((depths(0), depths(1)), (vec![0.0, 0.6, 1.0], vec![1.0, 1.2, 1.8]));
    /// # Ok::<(), recede::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Self::at`].
    pub fn by_layer(&self, xs: &[f64], depths: &[f64]) -> Result<Vec<Grid>, FieldError> {
        let (Some(first), Some(last)) = (depths.first(), depths.last()) else { return Ok(Vec::new()) };
        for depth in [first, last] {
            self.row(&Point { x: 0.0, depth: *depth, layer: None }, 0)?;
        }
        let (mut rows, mut counts) = (Vec::new(), Vec::new());
        for (layer, placed) in self.layers.iter().enumerate() {
            let (from, to) = (placed.top.max(*first), placed.bottom().min(*last));
            if from < to {
                let between = depths.iter().copied().filter(|depth| *depth > from && *depth < to);
                let within = |depth: f64| placed.thickness.map_or(depth, |h| h.min(depth)).max(0.0);
                let all = [from].into_iter().chain(between).chain([to]);
                let before = rows.len();
                rows.extend(all.map(|depth| DepthRow { layer, depth: within(depth - placed.top), set: 0 }));
                counts.push(rows.len() - before);
            }
        }
        let mut points = self.lines(xs, &rows, &FULL)?.into_iter();
        let grid = |count| Grid { xs: xs.to_vec(), points: points.by_ref().take(count).flatten().collect() };
        Ok(counts.into_iter().map(grid).collect())
    }

    /// Points in rows at the same places along x.
    fn lines(&self, xs: &[f64], rows: &[DepthRow], precision: &Precision) -> Result<Vec<Vec<FieldPoint>>, FieldError> {
        if let Some(x) = xs.iter().find(|x| !x.is_finite()) {
            return Err(self.outside(&Point { x: *x, depth: 0.0, layer: None }));
        }
        let sets = vec![xs.iter().map(|x| x - self.middle).collect()];
        let mut found = self.at_places(&Rows { rows: rows.to_vec(), sets }, precision)?;
        found.iter_mut().for_each(|row| row.iter_mut().zip(xs).for_each(|(point, x)| point.x = *x));
        Ok(found)
    }

    /// Points in rows, each at a set of places that are counted from the middle.
    fn at_places(&self, of: &Rows, precision: &Precision) -> Result<Vec<Vec<FieldPoint>>, FieldError> {
        if let Some(found) = self.superposed(of, precision) {
            return found;
        }
        let Rows { rows, sets } = of;
        // in an even field places on both sides of the middle share their tables
        let distinct = |xs: &Vec<f64>| {
            let mut places: Vec<f64> = xs.iter().map(|x| self.folded(*x)).collect();
            places.sort_by(f64::total_cmp);
            places.dedup();
            let of: Vec<usize> = xs.iter().map(|x| places.partition_point(|place| *place < self.folded(*x))).collect();
            (places, of)
        };
        let (places, of): (Vec<_>, Vec<_>) = sets.iter().map(distinct).unzip();
        let values = self.sum(&Rows { rows: rows.clone(), sets: places }, precision)?;
        let origins = if precision.displacements { self.at_origin(precision)? } else { Vec::new() };
        // v of all bodies is counted from a half-plane
        let is_half_plane = self.bodies.last().is_some_and(|body| body.bottom.is_none());
        let lift = origins.last().filter(|_| is_half_plane).map_or(0.0, |[_, v]| *v);
        let points = rows.iter().zip(&values).map(|(row, values)| {
            let u = origins.get(self.layers[row.layer].body).map_or(0.0, |[u, _]| *u);
            let places = sets[row.set].iter().zip(&of[row.set]);
            let from_origin = |point: FieldPoint| FieldPoint { u: point.u - u, v: point.v - lift, ..point };
            places.map(|(x, k)| from_origin(self.point(*x, row, values[*k]))).collect()
        });
        Ok(points.collect())
    }

    /// u and v of each body at x = 0 of the depth from which they are counted, where the middle is another place; 0 of bodies that stay.
    fn at_origin(&self, precision: &Precision) -> Result<Vec<[f64; 2]>, FieldError> {
        if self.middle == 0.0 {
            return Ok(Vec::new());
        }
        let rows: Vec<DepthRow> = self.bodies.iter().filter_map(|body| body.reference).collect();
        let known = Rows { rows, sets: vec![vec![self.place(0.0)]] };
        let mut values = self.sum(&known, precision)?.into_iter().zip(&known.rows);
        let displacements = |(values, row): (Vec<Components>, &DepthRow)| {
            let point = self.point(-self.middle, row, values[0]);
            [point.u, point.v]
        };
        let of = |body: &LoadedBody| body.reference.and_then(|_| values.next()).map_or([0.0; 2], displacements);
        Ok(self.bodies.iter().map(of).collect())
    }

    /// Depths at which layers begin and end, with the layers' numbers, from the top down; a half-plane ends at infinity.
    pub fn layers(&self) -> impl Iterator<Item = (usize, [f64; 2])> {
        self.layers.iter().map(|placed| (placed.number, [placed.top, placed.bottom()]))
    }

    /// The place at which the components of a field at x are computed, see [`Self::point`].
    fn place(&self, x: f64) -> f64 {
        self.folded(x - self.middle)
    }

    /// The same of a place that is counted from the middle.
    fn folded(&self, x: f64) -> f64 {
        if self.is_even { x.abs() } else { x }
    }

    /// The layer of a point, and its depth in it.
    fn row(&self, point: &Point, set: usize) -> Result<DepthRow, FieldError> {
        let Point { x, depth, layer: named } = *point;
        let near = |face: f64| face.is_finite() && (depth - face).abs() <= ON_INTERFACE * face;
        let here = |placed: &PlacedLayer| {
            let inside = depth >= placed.top && depth <= placed.bottom();
            let is_named = named.is_none_or(|number| placed.number == number);
            is_named && (inside || near(placed.top) || near(placed.bottom()))
        };
        let found = self.layers.iter().rposition(here).filter(|_| x.is_finite() && depth.is_finite());
        let layer = found.ok_or_else(|| self.outside(point))?;
        let placed = &self.layers[layer];
        let within = (depth - placed.top).max(0.0);
        let within = if near(placed.bottom()) { placed.thickness.unwrap_or(within) } else { within };
        Ok(DepthRow { layer, depth: if near(placed.top) { 0.0 } else { within }, set })
    }

    fn outside(&self, point: &Point) -> FieldError {
        let layers = self.layers.iter().map(|placed| match placed.thickness {
            Some(_) => format!("{} from {:?} to {:?}", placed.label(), placed.top, placed.bottom()),
            None => format!("{} from {:?} down", placed.label(), placed.top),
        });
        let allowed = layers.collect::<Vec<_>>().join(", ");
        FieldError::Outside { place: point.written_in(self.geometry), allowed }
    }

    /// The wavenumber below which transformed fields are smooth but for a power of λ, infinite if there is none, and whether there may be such a power.
    /// They are smooth for waves long compared with the layers; fields of a graded half-plane may have a power of λ there. In a homogeneous
    /// half-plane alone no length occurs but the depth down to which it is asked for.
    fn origin(&self, deepest: f64) -> (f64, bool) {
        let [longest, thickness] = [self.longest(), self.thickness()];
        let smooth = (LONG / (self.contrast * thickness)).min(DEEP / deepest);
        let power = self.layers.last().is_some_and(|base| {
            let at = |depth: f64| base.layer.material(depth, self.geometry.plane());
            base.thickness.is_none() && at(0.0) != at(longest + thickness)
        });
        (if power { POWER * smooth.min(longest.recip()) } else { smooth }, power)
    }
}

/// The pressure that lifts a support by the thickness of the stack; infinite if there is none.
fn support_stiffness(stack: &Stack, modulus: f64) -> f64 {
    let Some((_, support)) = stack.base().foundation().support() else { return f64::INFINITY };
    let wave = Wave { wavenumber: stack.total_thickness().recip(), modulus, plane: stack.plane() };
    let states = support.face_states(&wave);
    let stiffness = states.column_iter().filter(|state| state[1] != 0.0).map(|state| (state[2] / state[1]).abs());
    modulus * stiffness.fold(0.0, f64::max)
}

/// The error estimate of the pressure of a contact inside it, in stress; rounding of the mean pressure at least.
fn pressure_error(contact: &Contact, mean: f64) -> f64 {
    // elsewhere the series is no better than its last terms say
    let [pressure, error] = contact.middle_pressure;
    let peak = if pressure.is_finite() { error + contact.last_term() } else { 0.0 };
    let rounding = mean * (ROUNDING + contact.end_error());
    peak + if rounding.is_finite() { rounding } else { 0.0 }
}
