//! Rows of a sweep as comma-separated values.
use std::io;

use super::extremes;
use crate::approach::Approach;
use crate::errors::Error;
use crate::scene::{Force, visible};
use crate::solution::{Contact, Interface};
use crate::sweep::{Row, Sweep, SweepPoint};

/// Additional columns where the force is an unknown.
const FOUND: [&str; 2] = ["force", "force_error"];
/// Additional columns with the approach.
const APPROACH: [&str; 4] = ["approach", "approach_error", "stiffness", "stiffness_error"];

/// The columns of texts, which are the last ones.
pub(super) const TEXTS: [&str; 4] = ["status", "warnings", "message", "sweep"];

/// Status of a row with a solution.
const SOLVED: &str = "solved";
/// Status of a row without, because of what was asked, or because there is none.
const UNSOLVED: [&str; 2] = ["bad_input", "no_solution"];

/// Lines of comma-separated values for the rows of a sweep, the same columns for all.
///
/// ```
/// use recede::{Scene, Sweep, report::SweepCsv};
/// let scene = Scene::read("examples/scenes/hertz.ron")?;
/// let sweep = Sweep::new(scene, vec!["force=[0.001, 0.002]".parse()?])?;
/// let csv = SweepCsv::new(&sweep);
/// let mut text = csv.header()?;
/// for row in sweep.rows() {
///     text += &csv.line(&row)?;
/// }
/// assert!(text.starts_with("force,punch_half_length,punch_half_length_error,punch_central_pressure,"));
/// assert_eq!(text.lines().count(), 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct SweepCsv<'a> {
    sweep: &'a Sweep,
    fingerprint: String,
}

impl<'a> SweepCsv<'a> {
    /// For the rows of `sweep`.
    pub fn new(sweep: &'a Sweep) -> Self {
        Self { sweep, fingerprint: format!("{:016x}", sweep.fingerprint()) }
    }

    /// The sweep.
    pub fn sweep(&self) -> &'a Sweep {
        self.sweep
    }

    /// The fingerprint of the sweep as it stands at the end of each line.
    pub fn fingerprint(&self) -> &str {
        &self.fingerprint
    }

    /// The names of the columns, with the end of the line.
    ///
    /// # Errors
    /// None in practice.
    pub fn header(&self) -> io::Result<String> {
        let axes = self.sweep.axes().iter().map(|axis| column(axis.path()));
        let of = |interface: &Interface| Contact::COLUMNS.map(|quantity| format!("{}_{quantity}", owner(interface)));
        let contacts = self.sweep.interfaces().iter().flat_map(of);
        line(axes.chain(contacts).chain(self.of_all()).chain(TEXTS.map(str::to_owned)))
    }

    /// One row, with the end of the line. A contact that the row does not have is left empty.
    ///
    /// # Errors
    /// None in practice.
    pub fn line(&self, row: &Row) -> io::Result<String> {
        let numbers = self.numbers(row).into_iter().map(number);
        line(numbers.chain(self.texts(row)).chain([self.fingerprint.clone()]))
    }

    /// What a row has besides numbers: its status, codes of its warnings, and what there is to say, each in one line.
    pub fn texts(&self, row: &Row) -> [String; 3] {
        let (status, warnings, message) = match &row.result {
            Ok(solution) => {
                let warnings = solution.warnings();
                let not_found = row.extremes.as_ref().and_then(|found| found.as_ref().err());
                let not_found = not_found.map(|error| format!("extremes were not found: {error}"));
                let messages = warnings.iter().map(|warning| &warning.message[..]).chain(not_found.as_deref());
                (SOLVED, joined(warnings.iter().map(|warning| warning.code.as_str()), " "), joined(messages, "; "))
            }
            Err(error) => (status(error), String::new(), error.to_string()),
        };
        [status.to_owned(), warnings, visible(&message).into_owned()]
    }

    /// Whether this is a whole line of the row with this number: its values, a number or nothing in all other columns of numbers,
    /// as many texts as there are, and the fingerprint, all as [`Self::line`] writes them. A row has numbers if it is solved.
    ///
    /// ```
    /// use recede::{Scene, Sweep, report::SweepCsv};
    /// let scene = Scene::read("examples/scenes/hertz.ron")?;
    /// let sweep = Sweep::new(scene, vec!["force=[0.001, 0.002]".parse()?])?;
    /// let csv = SweepCsv::new(&sweep);
    /// let lines = sweep.rows().map(|row| csv.line(&row)).collect::<Result<Vec<_>, _>>()?;
    /// assert!(csv.is_line_of(&lines[1], 1) && !csv.is_line_of(&lines[0], 1) && !csv.is_line_of(lines[1].trim_end(), 1));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn is_line_of(&self, line: &str, row: usize) -> bool {
        let Some(rest) = line.strip_prefix(&self.start(row)) else { return false };
        let Some(rest) = rest.strip_suffix('\n').and_then(|rest| rest.strip_suffix(self.fingerprint())) else {
            return false;
        };
        let found = self.columns() - self.sweep.axes().len();
        let mut fields = rest.splitn(found + TEXTS.len() - 1, ',');
        let mut has_numbers = false;
        for field in fields.by_ref().take(found) {
            has_numbers |= !field.is_empty();
            if !field.is_empty() && field.parse().map(number).as_deref() != Ok(field) {
                return false;
            }
        }
        let [Some(status), Some(warnings), Some(message)] = [fields.next(), fields.next(), fields.next()] else {
            return false;
        };
        let is_status = if has_numbers { status == SOLVED } else { UNSOLVED.contains(&status) };
        is_status && !warnings.contains('"') && message.strip_suffix(',').is_some_and(is_field)
    }

    /// Whether a text is the beginning of a line of the row with this number, as far as its values tell.
    pub fn is_begun(&self, text: &str, row: usize) -> bool {
        let start = self.start(row);
        start.starts_with(text) || text.starts_with(&start)
    }

    /// How the line of a row begins: its values.
    fn start(&self, row: usize) -> String {
        self.sweep.values(row).into_iter().map(|value| number(value) + ",").collect()
    }

    /// How many columns are numbers.
    fn columns(&self) -> usize {
        let of_contacts = Contact::COLUMNS.len() * self.sweep.interfaces().len();
        self.sweep.axes().len() + of_contacts + self.of_all().count()
    }

    /// The number of the row of which this is a line, by its values; `None` if no row of the sweep has these.
    ///
    /// ```
    /// use recede::{Scene, Sweep, report::SweepCsv};
    /// let scene = Scene::read("examples/scenes/hertz.ron")?;
    /// let sweep = Sweep::new(scene, vec!["force=[0.001, 0.002]".parse()?])?;
    /// let csv = SweepCsv::new(&sweep);
    /// for row in sweep.rows() {
    ///     assert_eq!(csv.row_of(&csv.line(&row)?), Some(row.index));
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn row_of(&self, line: &str) -> Option<usize> {
        let values = line.split(',').take(self.sweep.axes().len()).map(|field| field.parse().ok());
        self.sweep.index_of(&values.collect::<Option<Vec<f64>>>()?)
    }

    /// The numbers of a row: its values, then the numbers of each contact, NaN for a contact that it does not have; the force with its error,
    /// if it is found; the approach and the stiffness with theirs, and the stresses by which layers and bonds break, if they were asked for.
    pub fn numbers(&self, row: &Row) -> Vec<f64> {
        let contacts = row.result.as_ref().map_or(&[][..], |solution| solution.contacts());
        let of = |interface: &Interface| {
            let contact = contacts.iter().find(|contact| contact.interface == *interface);
            contact.map_or([f64::NAN; Contact::COLUMNS.len()], Contact::numbers)
        };
        let force = match &row.result {
            Ok(solution) => [solution.force(), solution.force_error()],
            Err(_) => [f64::NAN; FOUND.len()],
        };
        let approach = match &row.approach {
            Some(Ok(Approach { value, error, stiffness })) => {
                let known = |number: Option<f64>| number.unwrap_or(f64::NAN);
                [*value, *error, known(stiffness.value()), known(stiffness.error())]
            }
            _ => [f64::NAN; APPROACH.len()],
        };
        let force = force.into_iter().take(self.found().len());
        let approach = approach.into_iter().take(self.approach().len());
        let contacts = self.sweep.interfaces().iter().flat_map(of);
        let found = row.extremes.as_ref().and_then(|found| found.as_ref().ok());
        let extremes = self.sweep.has_extremes().then(|| extremes::numbers(self.sweep.scene(), found));
        let of_all = force.chain(approach).chain(extremes.into_iter().flatten());
        row.values.iter().copied().chain(contacts).chain(of_all).collect()
    }

    /// The columns that are of no contact in particular.
    fn of_all(&self) -> impl Iterator<Item = String> {
        let extremes = self.sweep.has_extremes().then(|| extremes::columns(self.sweep.scene()));
        let found = self.found().iter().chain(self.approach()).map(|column| (*column).to_owned());
        found.chain(extremes.into_iter().flatten())
    }

    /// A row for a picture.
    pub fn point(&self, row: &Row) -> SweepPoint {
        let warned = row.result.as_ref().is_ok_and(|solution| !solution.warnings().is_empty());
        SweepPoint { numbers: self.numbers(row), solved: row.result.is_ok(), warned }
    }

    /// The columns of a force that is found.
    fn found(&self) -> &'static [&'static str] {
        if !matches!(self.sweep.scene().force, Force::Given(_)) { &FOUND } else { &[] }
    }

    /// The columns of the approach, if it was asked for.
    fn approach(&self) -> &'static [&'static str] {
        if self.sweep.has_approach() { &APPROACH } else { &[] }
    }

    /// A row for a picture, from its line.
    pub fn point_of(&self, line: &str) -> SweepPoint {
        let mut fields = line.split(',');
        let numbers = fields.by_ref().take(self.columns()).map(|field| field.parse().unwrap_or(f64::NAN)).collect();
        let solved = fields.next() == Some(SOLVED);
        SweepPoint { numbers, solved, warned: solved && fields.next().is_some_and(|warnings| !warnings.is_empty()) }
    }
}

/// The name of a column, which needs no quotes in other programs: `layer[2].beta` becomes `layer_2_beta`.
fn column(path: &str) -> String {
    path.replace(['[', '.'], "_").replace(']', "")
}

/// How the columns of a contact begin.
pub(super) fn owner(interface: &Interface) -> String {
    match interface {
        Interface::Punch => "punch".to_owned(),
        Interface::Between { above, below } => format!("contact_{above}_{below}"),
    }
}

fn joined<'a>(texts: impl Iterator<Item = &'a str>, between: &str) -> String {
    texts.collect::<Vec<_>>().join(between)
}

fn status(error: &Error) -> &'static str {
    UNSOLVED[usize::from(!error.is_input())]
}

/// Whether a text is one field as it is written: within quotes they are doubled, without them there is nothing to quote.
fn is_field(text: &str) -> bool {
    match text.strip_prefix('"') {
        Some(quoted) => quoted.strip_suffix('"').is_some_and(|inner| !inner.replace("\"\"", "").contains('"')),
        None => !text.contains([',', '"']),
    }
}

/// With as many digits as identify the number; empty if there is none, or if it is infinite.
pub(super) fn number(value: f64) -> String {
    if !value.is_finite() { String::new() } else { format!("{value:?}") }
}

fn line(fields: impl Iterator<Item = String>) -> io::Result<String> {
    let mut writer = csv::WriterBuilder::new().buffer_capacity(1 << 10).from_writer(Vec::new());
    writer.write_record(fields.map(String::into_bytes))?;
    let bytes = writer.into_inner().map_err(|error| error.into_error())?;
    String::from_utf8(bytes).map_err(io::Error::other)
}
