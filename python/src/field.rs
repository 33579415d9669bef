//! Stresses and displacements.
use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat, PyList};
use recede::{BondExtremes, Extreme, FieldPoint, Grid, LayerExtremes, Point, SpacePoint};

use crate::arrays::{self, read};
use crate::errors::raised;
use crate::solver::Solver;

/// The units of length and of stress, as they stand on axes; empty where the scene names none.
pub fn units(scene: &recede::Scene) -> (String, String) {
    scene.units.as_ref().map_or_else(Default::default, |units| (units.length.clone(), units.stress()))
}

/// Stresses and displacements inside a stack, stresses positive in tension.
#[pyclass(frozen, module = "recede", weakref)]
pub struct Field {
    inner: recede::Field,
    solver: Arc<Solver>,
}

impl Field {
    pub fn new(inner: recede::Field, solver: &Arc<Solver>) -> Self {
        Self { inner, solver: Arc::clone(solver) }
    }

    /// The fields on a grid, in arrays with a row for each depth, of which the number is given.
    fn arrays<'py>(&self, py: Python<'py>, grid: &Grid, depths: usize) -> PyResult<Bound<'py, PyAny>> {
        let shape = (depths, grid.xs().len());
        let columns = self.columns(py, grid.points())?;
        py.import("recede._arrays")?.call_method1("fields", (columns, shape))
    }

    /// A column for each quantity, by its name in the geometry.
    fn columns<'py>(&self, py: Python<'py>, points: &[FieldPoint]) -> PyResult<Bound<'py, PyDict>> {
        arrays::columns(py, recede::report::field_columns(points, self.inner.coordinates()))
    }
}

#[pymethods]
impl Field {
    /// Stresses and displacements at points.
    ///
    /// Args:
    ///     x: places along the layers (distances from the axis), in length.
    ///     depth: depths below the top face, in length; in the shape of `x`, or one that fits to it.
    ///     layer: number of the layer from the top, from 1, on an interface; the layer below if not given.
    ///     y: the other coordinate along the layers, in length, under loads at several places (x, y).
    #[pyo3(signature = (x, depth, layer=None, *, y=None))]
    fn at<'py>(
        &self,
        py: Python<'py>,
        x: &Bound<'py, PyAny>,
        depth: &Bound<'py, PyAny>,
        layer: Option<usize>,
        y: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let arrays = py.import("recede._arrays")?;
        let y = y.cloned().unwrap_or_else(|| PyFloat::new(py, 0.0).into_any());
        let places: [Bound<'_, PyAny>; 3] = arrays.call_method1("places", (x, depth, y))?.extract()?;
        let [xs, depths, ys] = [read(&places[0])?, read(&places[1])?, read(&places[2])?];
        let point = |((x, depth), y): ((f64, f64), f64)| SpacePoint { x, y, depth, layer };
        let points: Vec<SpacePoint> = xs.into_iter().zip(depths).zip(ys).map(point).collect();
        let found = py.detach(|| self.inner.points_in_space(&points));
        let found = found.map_err(|error| self.solver.failed(py, &error.into()))?;
        arrays.call_method1("fields", (self.columns(py, &found)?, places[0].getattr("shape")?))
    }

    /// The same field in the vertical plane at this y, in which points without a y are then, grids and maps, under loads at several
    /// places (x, y).
    fn at_y(&self, py: Python<'_>, y: f64) -> PyResult<Self> {
        let inner = self.inner.clone().at_y(y).map_err(|error| self.solver.failed(py, &error.into()))?;
        Ok(Self { inner, solver: Arc::clone(&self.solver) })
    }

    /// The same on a grid: arrays with a row for each depth, faster than one by one; on interfaces of this layer, if it is given.
    #[pyo3(signature = (x, depth, layer=None))]
    fn grid<'py>(
        &self,
        py: Python<'py>,
        x: &Bound<'py, PyAny>,
        depth: &Bound<'py, PyAny>,
        layer: Option<usize>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (xs, depths) = (list(x, "x")?, list(depth, "depth")?);
        let of = || match layer {
            Some(layer) => self.inner.grid_of_layer(layer, &xs, &depths),
            None => self.inner.grid(&xs, &depths),
        };
        let grid = py.detach(of).map_err(|error| self.solver.failed(py, &error.into()))?;
        self.arrays(py, &grid, depths.len())
    }

    /// The same layer by layer, on grids that reach the faces of layers, since stresses along the layers jump there: a list.
    fn by_layer<'py>(
        &self,
        py: Python<'py>,
        x: &Bound<'py, PyAny>,
        depth: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyList>> {
        let (xs, depths) = (list(x, "x")?, list(depth, "depth")?);
        let grids =
            py.detach(|| self.inner.by_layer(&xs, &depths)).map_err(|error| self.solver.failed(py, &error.into()))?;
        let all = PyList::empty(py);
        grids.iter().try_for_each(|grid| all.append(self.arrays(py, grid, grid.rows().count())?))?;
        Ok(all)
    }

    /// The layers, from the top: number, and the depths of top and bottom, infinite at the bottom of a half-plane.
    #[getter]
    fn layers(&self) -> Vec<(usize, f64, f64)> {
        self.inner.layers().map(|(number, [top, bottom])| (number, top, bottom)).collect()
    }

    /// Where stresses are, from and to along x, and in depth.
    fn window(&self) -> [(f64, f64); 2] {
        self.inner.window().map(|[from, to]| (from, to))
    }

    /// Draws a quantity in all layers in colours with `matplotlib`, and returns the axes.
    ///
    /// Args:
    ///     quantity: a stress, strain or displacement, by the name that it has in `at`.
    ///     ax: axes to draw on; new ones if not given.
    ///     x: places along x; `window` if not given.
    ///     depth: depths, ascending; `window` if not given.
    #[pyo3(signature = (quantity="max_shear", ax=None, *, x=None, depth=None))]
    fn map<'py>(
        slf: &Bound<'py, Self>,
        quantity: &str,
        ax: Option<Bound<'py, PyAny>>,
        x: Option<Bound<'py, PyAny>>,
        depth: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let scene = &slf.get().solver.scene;
        let is_strain = quantity.starts_with("eps") || quantity.starts_with("gamma");
        let (length, stress) = units(scene);
        let unit = match quantity {
            "u" | "v" | "u_r" | "u_x" | "u_y" | "u_z" => length.clone(),
            _ if is_strain => String::new(),
            _ => stress,
        };
        let along = scene.coordinates().along();
        let all = (slf, quantity, ax, x, depth, along, (length, unit));
        slf.py().import("recede._plots")?.call_method1("field_map", all)
    }

    /// Estimate of the error of the stresses at a point, in stress.
    #[pyo3(signature = (x, depth, layer=None))]
    fn stress_error(&self, py: Python<'_>, x: f64, depth: f64, layer: Option<usize>) -> PyResult<f64> {
        self.inner.stress_error(&Point { x, depth, layer }).map_err(|error| raised(py, error))
    }

    /// The largest shear stress in the plane anywhere, `value`, with `x`, `depth` and `layer`.
    fn max_shear<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let found = py.detach(|| self.inner.max_shear()).map_err(|error| self.solver.failed(py, &error.into()))?;
        let all = dictionary(py, &[("value", found.value), ("x", found.x), ("depth", found.depth)])?;
        all.set_item("layer", found.layer)?;
        Ok(all)
    }

    /// The stresses by which layers and bonds break, as `recede solve --extremes --format json` has them: the largest `tension`; of each
    /// of the `layers` the largest von Mises stress and tensile strain; of each of the `interfaces` that do not open the shear stress and the tension across
    /// it. None for what is not there, or not known.
    fn extremes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let found = py.detach(|| self.inner.extremes()).map_err(|error| self.solver.failed(py, &error.into()))?;
        let of = |extreme: Option<Extreme>| -> PyResult<Option<Bound<'py, PyDict>>> {
            let Some(Extreme { value, error, x, depth, layer }) = extreme else { return Ok(None) };
            let all = dictionary(py, &[("value", value), ("error", error), ("x", x), ("depth", depth)])?;
            all.set_item("layer", layer)?;
            Ok(Some(all))
        };
        let (all, layers, interfaces) = (PyDict::new(py), PyList::empty(py), PyList::empty(py));
        for LayerExtremes { layer, von_mises, tensile_strain } in &found.layers {
            let all = PyDict::new(py);
            all.set_item("layer", layer)?;
            all.set_item("von_mises", of(*von_mises)?)?;
            all.set_item("tensile_strain", of(*tensile_strain)?)?;
            layers.append(all)?;
        }
        for BondExtremes { above, below, shear, tension, .. } in &found.bonds {
            let all = PyDict::new(py);
            all.set_item("interface", format!("{above}|{below}"))?;
            all.set_item("shear", of(*shear)?)?;
            all.set_item("tension", of(*tension)?)?;
            interfaces.append(all)?;
        }
        all.set_item("tension", of(found.tension)?)?;
        all.set_item("layers", layers)?;
        all.set_item("interfaces", interfaces)?;
        Ok(all)
    }

    fn __repr__(&self) -> String {
        let layers =
            self.inner.layers().map(|(number, [top, bottom])| format!("layer {number} from {top} to {bottom}"));
        format!("<Field: {}>", layers.collect::<Vec<_>>().join(", "))
    }
}

/// A dictionary of numbers.
fn dictionary<'py>(py: Python<'py>, fields: &[(&str, f64)]) -> PyResult<Bound<'py, PyDict>> {
    let all = PyDict::new(py);
    fields.iter().try_for_each(|(name, value)| all.set_item(name, value))?;
    Ok(all)
}

/// Places along one direction.
fn list(values: &Bound<'_, PyAny>, name: &str) -> PyResult<Vec<f64>> {
    read(&values.py().import("recede._arrays")?.call_method1("line", (values, name))?)
}
