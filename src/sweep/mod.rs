//! Sweeps: one scene solved for all combinations of values of some of its quantities.
mod contacts;
mod kept;
#[cfg(feature = "parallel")]
mod parallel;
mod part;
mod probe;
#[cfg(feature = "files")]
mod read;

use std::error::Error as _;
use std::hash::Hasher;
#[cfg(feature = "parallel")]
use std::num::NonZeroUsize;
use std::ops::Range;
#[cfg(feature = "parallel")]
use std::sync::Arc;

use recede_layers::tree::ReadError;

#[cfg(feature = "parallel")]
pub use parallel::ParallelRows;
pub use part::{Part, PartError};
pub use probe::Probe;

use kept::Kept;

use crate::approach::{Approach, ApproachError};
use crate::axis::{Axis, AxisError};
use crate::errors::Error;
use crate::field::{Extremes, FieldError};
use crate::model::Model;
use crate::options::Options;
use crate::scene::{Item, Loads, Owner, Scene, Slot};
use crate::solution::{Interface, Solution};

/// Most rows of a sweep.
const MOST_ROWS: usize = 1_000_000_000;

/// A scene and the axes of a grid: every combination of values is solved, the value of the last axis changing first. Or a scene and [rows of values](Sweep::of_rows), each of which is
/// solved.
///
/// A stack is evaluated once, when the first row needs it, however many loads and punches press on it. The numbers of a row
/// depend on the grid alone, not on who computes them, how many at a time, or where one begins; and of the grid
/// nothing is stored but its axes, a range of values as its ends.
///
/// ```
/// use recede::{Scene, Sweep};
/// let scene = Scene::read("examples/scenes/table1_strip_half_plane.ron")?;
/// let sweep = Sweep::new(scene, vec!["force=[0.001, 0.002]".parse()?, "layer[3].shear_modulus=[1, 10]".parse()?])?;
/// assert_eq!(sweep.len(), 4);
/// let mut receding = Vec::new();
/// for row in sweep.rows() {
///     let solution = row.result?;
///     receding.push((row.values[0], row.values[1], solution.contacts()[1].reach()));
/// }
/// assert_eq!((receding[1].0, receding[1].1), (0.001, 10.0));
/// assert!(receding[1].2 < receding[0].2, "a stiffer half-plane is touched less far");
/// # Ok::<(), recede::Error>(())
/// ```
#[derive(Debug)]
pub struct Sweep {
    scene: Scene,
    axes: Vec<Axis>,
    /// Whether all axes change together from row to row, rather than make a grid.
    in_step: bool,
    slots: Vec<Slot>,
    options: Options,
    approach: bool,
    extremes: bool,
    probes: Vec<Probe>,
    rows: usize,
    interfaces: Vec<Interface>,
    models: Kept<Model>,
}

/// One row of a sweep.
#[derive(Clone, Debug)]
pub struct Row {
    /// Number of the row in the grid, from 0.
    pub index: usize,
    /// The value on each axis.
    pub values: Vec<f64>,
    /// The solution, or why there is none.
    pub result: Result<Solution, Error>,
    /// The approach of the punch and the stiffness, where they were [asked for](Sweep::with_approach), and the row has a solution.
    pub approach: Option<Result<Approach, ApproachError>>,
    /// The stresses by which layers and bonds break, where they were [asked for](Sweep::with_extremes), and the row has a solution.
    pub extremes: Option<Result<Extremes, FieldError>>,
    /// The quantities at points that were [asked for](Sweep::with_probes), if any were, and the row has a solution.
    pub probes: Option<Result<Vec<f64>, FieldError>>,
}

/// One row of a sweep as numbers, for a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepPoint {
    /// The columns of the table that are numbers; NaN for what a row does not have.
    pub numbers: Vec<f64>,
    /// Whether there is a solution.
    pub solved: bool,
    /// Whether there is a warning on the solution.
    pub warned: bool,
}

impl Scene {
    /// An axis as on a command line, `PATH=START:STOP:COUNT`, `PATH=START:STOP:COUNT:log` or `PATH=[v, v, ...]`, with numbers that may have units.
    ///
    /// ```
    /// let scene = recede::Scene::read("examples/gallery/slab_on_soil.ron")?;
    /// assert_eq!(scene.axis("layer[1].young=[20 GPa, 30 GPa]")?, "layer[1].young=[20e6, 30e6]".parse()?);
    /// # Ok::<(), recede::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`AxisError`](crate::AxisError) if the text is none, or a number has another unit.
    pub fn axis(&self, text: &str) -> Result<Axis, Error> {
        let number = |path: &str, number: &str| self.written_number(path, number).map_err(|error| error.to_string());
        Ok(Axis::read(text, number)?)
    }
}

impl Sweep {
    /// A sweep of a scene read from a text, to ten digits.
    ///
    /// # Errors
    /// [`Error::Scene`] if there is no quantity at the path of an axis; [`Error::Axis`] if a value is not legal for its
    /// quantity, a quantity has two axes, or the grid has too many points; [`Error::Stack`] if no combination of values is
    /// a stack. A combination that is illegal where each value is legal is a row without solution. What is looked at of an
    /// axis are its smallest and its largest value, and the one nearest to zero: where a user-defined layer type
    /// refuses others only, it does so in rows without solution.
    pub fn new(scene: Scene, axes: Vec<Axis>) -> Result<Self, Error> {
        Self::of(scene, axes, false)
    }

    /// A sweep of a scene read from a text, one row for the first value of all axes, one for the second of all, and so on: for samples, and for designs of
    /// experiments.
    ///
    /// ```
    /// use recede::{Scene, Sweep};
    /// let scene = Scene::read("examples/scenes/hertz.ron")?;
    /// let sweep = Sweep::of_rows(scene, vec!["force=[0.001, 0.003]".parse()?, "punch.radius=[250, 400]".parse()?])?;
    /// assert_eq!((sweep.len(), sweep.values(1)), (2, vec![0.003, 400.0]));
    /// # Ok::<(), recede::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Sweep::new`], and [`Error::Axis`] if an axis has more or fewer values than the first one.
    pub fn of_rows(scene: Scene, axes: Vec<Axis>) -> Result<Self, Error> {
        Self::of(scene, axes, true)
    }

    fn of(scene: Scene, axes: Vec<Axis>, in_step: bool) -> Result<Self, Error> {
        let mut slots = Vec::with_capacity(axes.len());
        for (i, axis) in axes.iter().enumerate() {
            if axes[..i].iter().any(|earlier| earlier.path() == axis.path()) {
                return Err(AxisError::new(axis.path(), "this quantity varies already").into());
            }
            let slot = scene.slot(axis.path())?;
            axis.extremes().into_iter().try_for_each(|value| legal(&scene, axis, &slot, value))?;
            if in_step && axis.count() != axes[0].count() {
                let reason = format!("found {} values, {} has {}", axis.count(), axes[0].path(), axes[0].count());
                return Err(AxisError::new(axis.path(), reason).into());
            }
            slots.push(slot);
        }
        let axes_of_grid = if in_step { &axes[..axes.len().min(1)] } else { &axes[..] };
        let product = axes_of_grid.iter().try_fold(1usize, |rows, axis| rows.checked_mul(axis.count()));
        let Some(rows) = product.filter(|rows| *rows <= MOST_ROWS) else {
            let reason = format!("the grid has more than {MOST_ROWS} points with this axis");
            return Err(AxisError::new(axes.last().map_or("", Axis::path), reason).into());
        };
        let (options, models) = (Options::default(), Kept::new(Model::stored_numbers));
        let (approach, extremes, interfaces) = (false, false, Vec::new());
        let probes = Vec::new();
        let mut sweep =
            Self { scene, axes, in_step, slots, options, approach, extremes, probes, rows, interfaces, models };
        sweep.interfaces = sweep.all_interfaces()?;
        Ok(sweep)
    }

    /// The same sweep with other options for the solutions.
    ///
    /// # Errors
    /// [`Error::Options`] if the tolerance is not legal.
    pub fn with_options(self, options: Options) -> Result<Self, Error> {
        options.check()?;
        Ok(Self { options, ..self })
    }

    /// The options with which rows are solved.
    pub fn options(&self) -> &Options {
        &self.options
    }

    /// The same sweep with the approach of the punch and the stiffness in each row, as [`Model::approach`] has them.
    ///
    /// ```
    /// use recede::{Scene, Sweep};
    /// let scene = Scene::read("examples/scenes/bonded_to_rigid.ron")?;
    /// let sweep = Sweep::new(scene, vec!["force=[0.001, 0.002]".parse()?])?.with_approach();
    /// let depths: Vec<f64> = sweep.rows().map(|row| row.approach.unwrap().unwrap().value).collect();
    /// assert!(depths[0] < depths[1]);
    /// # Ok::<(), recede::Error>(())
    /// ```
    #[must_use]
    pub fn with_approach(self) -> Self {
        Self { approach: true, ..self }
    }

    /// Whether each row has the approach.
    pub fn has_approach(&self) -> bool {
        self.approach
    }

    /// The same sweep with the stresses by which layers and bonds break in each row, as [`Field::extremes`](crate::Field::extremes) has them.
    ///
    /// ```
    /// use recede::{Scene, Sweep};
    /// let scene = Scene::read("examples/scenes/bonded_coating.ron")?;
    /// let sweep = Sweep::new(scene, vec!["force=[0.001, 0.002]".parse()?])?.with_extremes();
    /// let shear: Vec<f64> =
    ///     sweep.rows().map(|row| row.extremes.unwrap().unwrap().bonds[0].shear.unwrap().value).collect();
    /// assert!(shear[0] < shear[1]);
    /// # Ok::<(), recede::Error>(())
    /// ```
    #[must_use]
    pub fn with_extremes(self) -> Self {
        Self { extremes: true, ..self }
    }

    /// Whether each row has the stresses by which layers and bonds break.
    pub fn has_extremes(&self) -> bool {
        self.extremes
    }

    /// The same sweep with stresses, strains or displacements at points in each row.
    ///
    /// ```
    /// use recede::{Probe, Scene, Sweep};
    /// let scene = Scene::read("examples/scenes/bonded_coating.ron")?;
    /// let probe = Probe::parse("0,0=sigma_yy", scene.geometry)?;
    /// let sweep = Sweep::new(scene, vec!["force=[0.001, 0.002]".parse()?])?.with_probes(vec![probe]);
    /// for row in sweep.rows() {
    ///     let pressure = row.result?.contacts()[0].central_pressure;
    ///     assert!((row.probes.unwrap()?[0] / pressure + 1.0).abs() < 1e-9);
    /// }
    /// # Ok::<(), recede::Error>(())
    /// ```
    #[must_use]
    pub fn with_probes(self, probes: Vec<Probe>) -> Self {
        Self { probes, ..self }
    }

    /// What each row has at points.
    pub fn probes(&self) -> &[Probe] {
        &self.probes
    }

    /// Whether weights, or a pressure on top, press layers together in some row.
    pub(crate) fn has_weights(&self) -> bool {
        let is_varied = |axis: &Axis| axis.path().contains("specific_weight") || axis.path() == "pressure_on_top";
        self.scene.is_weighed() || self.axes.iter().any(is_varied)
    }

    /// The same sweep with more axes, which change before those that it has.
    ///
    /// # Errors
    /// As [`Sweep::new`].
    pub fn and_vary(self, axes: Vec<Axis>) -> Result<Self, Error> {
        let Self { scene, axes: mut all, in_step, options, approach, extremes, probes, .. } = self;
        all.extend(axes);
        let sweep = Self::of(scene, all, in_step)?.with_options(options)?;
        Ok(Self { approach, extremes, probes, ..sweep })
    }

    /// The scene that is varied.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The axes; the last one changes first.
    pub fn axes(&self) -> &[Axis] {
        &self.axes
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.rows
    }

    /// Whether there are no rows; there always are some.
    pub fn is_empty(&self) -> bool {
        self.rows == 0
    }

    /// All contacts that occur in some row, from the top down. Where layers have thickness 0 in some rows only, not
    /// every row has all of them.
    pub fn interfaces(&self) -> &[Interface] {
        &self.interfaces
    }

    /// The contacts of which tables have columns: as [`Self::interfaces`], but each of several punches, from the left, and of loads about axes of their own by itself, with its
    /// number from 0.
    pub(crate) fn contacts(&self) -> impl Iterator<Item = (Interface, Option<usize>)> {
        let axes = self.scene.top.loads().and_then(Loads::axes).map_or(1, |axes| axes.len());
        let punches = self.scene.top.punches().map_or(axes, |punches| punches.parts().count());
        self.interfaces.iter().flat_map(move |interface| {
            let count = if *interface == Interface::Punch { punches } else { 1 };
            (0..count).map(move |k| (*interface, (count > 1).then_some(k)))
        })
    }

    /// The values of row `index` on each axis.
    pub fn values(&self, index: usize) -> Vec<f64> {
        if self.in_step {
            return self.axes.iter().map(|axis| axis.at(index)).collect();
        }
        let mut rest = index;
        let digit = |axis: &Axis| {
            let value = axis.at(rest % axis.count());
            rest /= axis.count();
            value
        };
        let mut values: Vec<f64> = self.axes.iter().rev().map(digit).collect();
        values.reverse();
        values
    }

    /// The number of the row with these values, the same bit by bit; `None` if there is no such row, or several.
    ///
    /// ```
    /// use recede::{Scene, Sweep};
    /// let scene = Scene::read("examples/scenes/hertz.ron")?;
    /// let sweep = Sweep::new(scene, vec!["punch.radius=[250, 500, 250]".parse()?, "force=0.001:0.01:10".parse()?])?;
    /// assert_eq!(sweep.index_of(&sweep.values(13)), Some(13));
    /// assert_eq!((sweep.index_of(&[500.0, 0.5]), sweep.index_of(&[250.0, 0.001])), (None, None));
    /// # Ok::<(), recede::Error>(())
    /// ```
    pub fn index_of(&self, values: &[f64]) -> Option<usize> {
        if values.len() != self.axes.len() {
            return None;
        }
        if self.in_step {
            let is_same = |(axis, value): (&Axis, &f64), row: usize| axis.at(row).to_bits() == value.to_bits();
            let has_all = |row: &usize| self.axes.iter().zip(values).all(|pair| is_same(pair, *row));
            let mut rows = (0..self.rows).filter(has_all);
            return rows.next().filter(|_| rows.next().is_none());
        }
        let mut axes = self.axes.iter().zip(values);
        axes.try_fold(0, |index, (axis, value)| Some(index * axis.count() + axis.index_of(*value)?))
    }

    /// The scene of row `index`.
    ///
    /// # Errors
    /// [`Error::Scene`] if the values are illegal in combination.
    pub fn scene_at(&self, index: usize) -> Result<Scene, Error> {
        let values = self.values(index);
        let changes: Vec<_> = self.slots.iter().zip(values).collect();
        Ok(self.scene.with_changes(&changes)?)
    }

    /// The rows in the order of the grid, each solved on demand.
    pub fn rows(&self) -> impl Iterator<Item = Row> {
        self.rows_in(0..self.rows)
    }

    /// The rows with these numbers, from 0, such as the rows of a [`Part`]. They are the same, bit by bit, as among all rows.
    pub fn rows_in(&self, rows: Range<usize>) -> impl Iterator<Item = Row> {
        (rows.start..rows.end.min(self.rows)).map(|index| self.row(index))
    }

    /// The rows with these numbers in the order of the grid, solved by this many threads ahead of the caller.
    /// Rows are the same, bit by bit, for any number of threads, and as among all rows.
    ///
    /// ```
    /// use std::{num::NonZeroUsize, sync::Arc};
    /// use recede::{Part, Scene, Sweep};
    /// let scene = Scene::read("examples/scenes/hertz.ron")?;
    /// let sweep = Arc::new(Sweep::new(scene, vec!["force=0.001:0.01:10".parse()?])?);
    /// let rows = Part::new(2, 3)?.rows(sweep.len());
    /// let forces: Vec<f64> = sweep.parallel_rows(rows, NonZeroUsize::MIN).map(|row| row.values[0]).collect();
    /// assert_eq!(forces, [0.004, 0.005, 0.006]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[cfg(feature = "parallel")]
    pub fn parallel_rows(self: &Arc<Self>, rows: Range<usize>, threads: NonZeroUsize) -> ParallelRows {
        ParallelRows::new(Arc::clone(self), rows, threads)
    }

    /// A number that identifies this sweep: of another scene, other values, or another tolerance.
    pub fn fingerprint(&self) -> u64 {
        let mut hasher = fnv::FnvHasher::default();
        // numbers are written with all their digits
        let mut scene = self.scene.clone();
        (scene.name, scene.description, scene.units) = (None, None, None);
        hasher.write(scene.to_ron().as_bytes());
        // functions have no text: they are told by their values
        for layer in scene.stack.iter().filter_map(Item::elastic) {
            let thickness = layer.thickness().unwrap_or(1.0);
            for part in [0.0, 0.5, 1.0] {
                let material = layer.material(part * thickness, scene.geometry.plane());
                let numbers = [material.shear_compliance, material.normal_compliance, material.coupling];
                numbers.iter().for_each(|number| hasher.write(&number.to_bits().to_le_bytes()));
            }
        }
        hasher.write(&self.options.tolerance.to_bits().to_le_bytes());
        hasher.write(&[u8::from(self.approach), u8::from(self.extremes), u8::from(self.in_step)]);
        self.probes.iter().for_each(|probe| hasher.write(probe.to_string().as_bytes()));
        hasher.write(env!("CARGO_PKG_VERSION").as_bytes());
        self.axes.iter().for_each(|axis| axis.write_to(&mut hasher));
        hasher.finish()
    }

    /// How many combinations of values some parts of a scene have, at most, with each combination of the others.
    fn values_of(&self, wanted: impl Fn(Owner) -> bool) -> usize {
        if self.in_step {
            return if self.slots.iter().all(|slot| wanted(slot.owner)) { self.rows } else { 1 };
        }
        let axes = self.axes.iter().zip(&self.slots).filter(|(_, slot)| wanted(slot.owner));
        axes.map(|(axis, _)| axis.count()).product()
    }
}

/// Whether a value is legal for its quantity, whatever the others are.
fn legal(scene: &Scene, axis: &Axis, slot: &Slot, value: f64) -> Result<(), Error> {
    let changes = [(slot, value)];
    let Err(error) = scene.with_changes(&changes) else { return Ok(()) };
    // a mistake of one field, rather than of a layer as a whole
    let of_field =
        error.source().and_then(|cause| cause.downcast_ref::<ReadError>()).is_some_and(|e| e.field.is_some());
    if of_field { Err(AxisError::new(axis.path(), error.message()).into()) } else { Ok(()) }
}
