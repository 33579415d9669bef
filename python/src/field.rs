//! Stresses and displacements.
use std::sync::Arc;

use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use recede::{BondExtremes, Extreme, FieldPoint, FieldQuantity, Geometry, Point};

use crate::errors::raised;
use crate::model::Solver;
use crate::solution::dictionary;

/// Stresses and displacements inside a stack.
#[pyclass(frozen, module = "recede", weakref)]
pub struct Field {
    inner: recede::Field,
    solver: Arc<Solver>,
}

impl Field {
    pub fn new(inner: recede::Field, solver: &Arc<Solver>) -> Self {
        Self { inner, solver: Arc::clone(solver) }
    }

    fn geometry(&self) -> Geometry {
        self.solver.scene.geometry
    }

    /// A column for each quantity, by its name in the geometry.
    fn columns<'py>(&self, py: Python<'py>, points: &[FieldPoint]) -> PyResult<Bound<'py, PyDict>> {
        let columns = PyDict::new(py);
        let geometry = self.geometry();
        for quantity in FieldQuantity::ALL {
            let values = points.iter().map(|point| quantity.of_in(point, geometry)).collect();
            columns.set_item(quantity.name_in(geometry), PyArray1::from_vec(py, values))?;
        }
        for (k, name) in ["eps_rr", "eps_tt", "eps_zz"].into_iter().enumerate() {
            if geometry.is_axisymmetric() {
                let strain = |point: &FieldPoint| point.strains.map_or(f64::NAN, |strains| strains[k]);
                columns.set_item(name, PyArray1::from_vec(py, points.iter().map(strain).collect()))?;
            }
        }
        let layers: Vec<i64> = points.iter().map(|point| point.layer as i64).collect();
        columns.set_item("layer", PyArray1::from_vec(py, layers))?;
        Ok(columns)
    }
}

#[pymethods]
impl Field {
    #[pyo3(signature = (x, depth, layer=None))]
    fn at<'py>(
        &self,
        py: Python<'py>,
        x: &Bound<'py, PyAny>,
        depth: &Bound<'py, PyAny>,
        layer: Option<usize>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let arrays = py.import("recede._arrays")?;
        let (places, depths): (Bound<'_, PyAny>, Bound<'_, PyAny>) =
            arrays.call_method1("pair", (x, depth))?.extract()?;
        let [xs, ds] = [&places, &depths].map(|all| all.call_method0("ravel")?.extract::<PyReadonlyArray1<'_, f64>>());
        let (xs, ds) = (xs?, ds?);
        let points: Vec<Point> =
            xs.as_array().iter().zip(ds.as_array()).map(|(x, depth)| Point { x: *x, depth: *depth, layer }).collect();
        let found = py.detach(|| self.inner.points(&points)).map_err(|error| self.solver.failed(py, &error.into()))?;
        arrays.call_method1("fields", (self.columns(py, &found)?, places.getattr("shape")?))
    }

    fn grid<'py>(
        &self,
        py: Python<'py>,
        x: &Bound<'py, PyAny>,
        depth: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let arrays = py.import("recede._arrays")?;
        let list = |values: &Bound<'py, PyAny>, name: &str| -> PyResult<Vec<f64>> {
            let values = arrays.call_method1("line", (values, name))?;
            Ok(values.extract::<PyReadonlyArray1<'_, f64>>()?.as_array().to_vec())
        };
        let (xs, depths) = (list(x, "x")?, list(depth, "depth")?);
        let grid =
            py.detach(|| self.inner.grid(&xs, &depths)).map_err(|error| self.solver.failed(py, &error.into()))?;
        arrays.call_method1("fields", (self.columns(py, grid.points())?, (depths.len(), xs.len())))
    }

    #[pyo3(signature = (x, depth, layer=None))]
    fn stress_error(&self, py: Python<'_>, x: f64, depth: f64, layer: Option<usize>) -> PyResult<f64> {
        self.inner.stress_error(&Point { x, depth, layer }).map_err(|error| raised(py, error))
    }

    fn max_shear<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let found = py.detach(|| self.inner.max_shear()).map_err(|error| self.solver.failed(py, &error.into()))?;
        let all = dictionary(py, &[("value", found.value), ("x", found.x), ("depth", found.depth)])?;
        all.set_item("layer", found.layer)?;
        Ok(all)
    }

    fn extremes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let found = py.detach(|| self.inner.extremes()).map_err(|error| self.solver.failed(py, &error.into()))?;
        let of = |extreme: Option<Extreme>| -> PyResult<Option<Bound<'py, PyDict>>> {
            let Some(Extreme { value, error, x, depth, layer }) = extreme else { return Ok(None) };
            let all = dictionary(py, &[("value", value), ("error", error), ("x", x), ("depth", depth)])?;
            all.set_item("layer", layer)?;
            Ok(Some(all))
        };
        let (all, layers, bonds) = (PyDict::new(py), PyDict::new(py), PyDict::new(py));
        for layer in &found.layers {
            layers.set_item(layer.layer, of(layer.von_mises)?)?;
        }
        for BondExtremes { above, below, shear, tension, .. } in &found.bonds {
            let bond = PyDict::new(py);
            bond.set_item("shear", of(*shear)?)?;
            bond.set_item("tension", of(*tension)?)?;
            bonds.set_item(format!("{above}|{below}"), bond)?;
        }
        all.set_item("tension", of(found.tension)?)?;
        all.set_item("von_mises", layers)?;
        all.set_item("interfaces", bonds)?;
        Ok(all)
    }

    fn __repr__(&self) -> String {
        let layers =
            self.inner.layers().map(|(number, [top, bottom])| format!("layer {number} from {top} to {bottom}"));
        format!("<Field: {}>", layers.collect::<Vec<_>>().join(", "))
    }
}
