//! Rows of sweeps as columns.
use std::num::NonZeroUsize;
use std::sync::Arc;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;

use pyo3::prelude::*;
use recede::report::SweepCsv;
use recede::{Axis, Options, Probe, Sweep, SweepRow};

use crate::arrays::array;
use crate::errors::raised;
use crate::model::PATIENCE;
use crate::scene::Scene;

/// The rows of a sweep.
#[pyclass(frozen, module = "recede._recede")]
pub struct Rows {
    sweep: Arc<Sweep>,
}

/// Columns of numbers, columns of texts, and whether all rows were made.
type Columns<'py> = (Vec<Bound<'py, PyAny>>, Vec<Vec<String>>, bool);

#[pymethods]
impl Rows {
    #[new]
    fn new(
        py: Python<'_>,
        scene: &Bound<'_, Scene>,
        axes: Vec<(String, Vec<f64>)>,
        in_step: bool,
        tolerance: f64,
        wanted: (bool, bool, Vec<String>),
    ) -> PyResult<Self> {
        let (approach, extremes, at) = wanted;
        let axes: Result<Vec<Axis>, _> = axes.into_iter().map(|(path, values)| Axis::list(&path, values)).collect();
        let axes = axes.map_err(|error| raised(py, error))?;
        let options = Options { tolerance };
        let made = if in_step { Sweep::of_rows } else { Sweep::new };
        let sweep = made(scene.get().inner.clone(), axes).and_then(|sweep| sweep.with_options(options));
        let sweep = sweep.map_err(|error| raised(py, error))?;
        let probe = |text: &String| Probe::parse(&sweep.scene().numbered(text), sweep.scene().coordinates());
        let probes: Result<Vec<Probe>, _> = at.iter().map(probe).collect();
        let sweep = sweep.with_probes(probes.map_err(|error| raised(py, error))?);
        let sweep = if approach { sweep.with_approach() } else { sweep };
        Ok(Self { sweep: Arc::new(if extremes { sweep.with_extremes() } else { sweep }) })
    }

    fn __len__(&self) -> usize {
        self.sweep.len()
    }

    /// The names of the columns: numbers, then texts.
    #[getter]
    fn names(&self) -> PyResult<Vec<String>> {
        let header = SweepCsv::new(&self.sweep).header()?;
        Ok(header.trim_end().split(',').map(str::to_owned).collect())
    }

    /// What tells the sweep from others.
    #[getter]
    fn fingerprint(&self) -> String {
        SweepCsv::new(&self.sweep).fingerprint().to_owned()
    }

    /// Some rows, by this many threads. When interrupted it returns those that are complete.
    fn run<'py>(&self, py: Python<'py>, first: usize, last: usize, threads: usize) -> PyResult<Columns<'py>> {
        let threads = NonZeroUsize::new(threads).unwrap_or(NonZeroUsize::MIN);
        let csv = SweepCsv::new(&self.sweep);
        let count = self.names()?.len() - 4;
        let mut numbers = vec![Vec::new(); count];
        let mut texts = vec![Vec::new(); 3];
        let mut add = |row: &SweepRow| {
            numbers.iter_mut().zip(csv.numbers(row)).for_each(|(column, number)| column.push(number));
            texts.iter_mut().zip(csv.texts(row)).for_each(|(column, text)| column.push(text));
        };
        // rows come from another thread, so that an interruption is seen while one takes long
        let (sender, mut receiver) = channel();
        let sweep = Arc::clone(&self.sweep);
        let rows = move || {
            for row in sweep.parallel_rows(first..last, threads) {
                if sender.send(row).is_err() {
                    return;
                }
            }
        };
        thread::Builder::new().name("rows".into()).spawn(rows)?;
        let mut complete = true;
        loop {
            // all rows that are there before the next look at signals
            let (receiver, add) = (&mut receiver, &mut add);
            let ended = py.detach(move || {
                let begun = std::time::Instant::now();
                loop {
                    match receiver.recv_timeout(PATIENCE) {
                        Ok(row) => add(&row),
                        Err(RecvTimeoutError::Timeout) => return false,
                        Err(RecvTimeoutError::Disconnected) => return true,
                    }
                    if begun.elapsed() > PATIENCE {
                        return false;
                    }
                }
            });
            if ended {
                break;
            }
            if py.check_signals().is_err() {
                complete = false;
                break;
            }
        }
        let numbers: PyResult<_> = numbers.iter().map(|column| array(py, column)).collect();
        Ok((numbers?, texts, complete))
    }
}
