//! Rows of a sweep as comma-separated values.
use std::io;

use super::csv::number;
use super::extremes;
use crate::scene::{Force, visible};
use crate::solution::{ClosedInterface, Contact, Interface, Solution};
use crate::sweep::{Row, Sweep, SweepPoint};

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
    /// The names of the columns of numbers.
    names: Vec<String>,
}

impl<'a> SweepCsv<'a> {
    /// For the rows of `sweep`.
    pub fn new(sweep: &'a Sweep) -> Self {
        let names = cells(sweep, None).into_iter().map(|(name, _)| name).collect();
        Self { sweep, fingerprint: format!("{:016x}", sweep.fingerprint()), names }
    }

    /// The sweep.
    pub fn sweep(&self) -> &'a Sweep {
        self.sweep
    }

    /// The names of the columns of numbers.
    pub fn names(&self) -> &[String] {
        &self.names
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
        line(self.names.iter().map(String::as_str).chain(TEXTS))
    }

    /// One row, with the end of the line. A contact that the row does not have is left empty.
    ///
    /// # Errors
    /// None in practice.
    pub fn line(&self, row: &Row) -> io::Result<String> {
        let numbers = self.numbers(row).into_iter().map(number);
        line(numbers.chain(self.texts(row)).chain([self.fingerprint.clone()]))
    }

    /// The texts of a row: its status, the codes of its warnings, and its messages, each in one line.
    pub fn texts(&self, row: &Row) -> [String; 3] {
        let (status, warnings, message) = match &row.result {
            Ok(solution) => {
                let warnings = solution.warnings();
                let extremes = row.extremes.as_ref().and_then(|found| found.as_ref().err());
                let probes = row.probes.as_ref().and_then(|found| found.as_ref().err());
                let not_found = [("extremes", extremes), ("quantities at points", probes)].into_iter();
                let not_found: Vec<String> =
                    not_found.filter_map(|(what, error)| Some(format!("{what} were not found: {}", error?))).collect();
                let codes: Vec<&str> = warnings.iter().map(|warning| warning.code.as_str()).collect();
                let messages =
                    warnings.iter().map(|warning| &warning.message[..]).chain(not_found.iter().map(String::as_str));
                (SOLVED, codes.join(" "), messages.collect::<Vec<_>>().join("; "))
            }
            Err(error) => (UNSOLVED[usize::from(!error.is_input())], String::new(), error.to_string()),
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
    pub fn is_line_of(&self, text: &str, row: usize) -> bool {
        let record = fields(text).unwrap_or_default();
        let fields: Vec<&str> = record.iter().collect();
        let Some((numbers, texts)) = fields.split_at_checked(self.names.len()).filter(|(_, t)| t.len() == TEXTS.len())
        else {
            return false;
        };
        let is_number = |field: &str| field.is_empty() || field.parse().map(number).as_deref() == Ok(field);
        let has_numbers = numbers[self.sweep.axes().len()..].iter().any(|field| !field.is_empty());
        let is_status = if has_numbers { texts[0] == SOLVED } else { UNSOLVED.contains(&texts[0]) };
        let is_own = text.starts_with(&self.start(row)) && texts[TEXTS.len() - 1] == self.fingerprint;
        // written again it is the same: nothing is quoted that needs no quotes
        is_own && is_status && numbers.iter().copied().all(is_number) && line(&fields).is_ok_and(|line| line == text)
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
        cells(self.sweep, Some(row)).into_iter().map(|(_, number)| number).collect()
    }

    /// A row for a picture.
    pub fn point(&self, row: &Row) -> SweepPoint {
        let warned = row.result.as_ref().is_ok_and(|solution| !solution.warnings().is_empty());
        SweepPoint { numbers: self.numbers(row), solved: row.result.is_ok(), warned }
    }

    /// A row for a picture, from its line.
    pub fn point_of(&self, line: &str) -> SweepPoint {
        let mut fields = line.split(',');
        let numbers = fields.by_ref().take(self.names.len()).map(|field| field.parse().unwrap_or(f64::NAN)).collect();
        let solved = fields.next() == Some(SOLVED);
        SweepPoint { numbers, solved, warned: solved && fields.next().is_some_and(|warnings| !warnings.is_empty()) }
    }
}

/// The columns of numbers by name, with the numbers of a row; NaN for what it does not have, and without a row.
fn cells(sweep: &Sweep, row: Option<&Row>) -> Vec<(String, f64)> {
    let value = |k: usize| row.map_or(f64::NAN, |row| row.values[k]);
    // a name that needs no quotes in other programs: `layer[2].beta` becomes `layer_2_beta`
    let column = |path: &str| path.replace(['[', '.'], "_").replace(']', "");
    let mut cells: Vec<(String, f64)> =
        sweep.axes().iter().enumerate().map(|(k, axis)| (column(axis.path()), value(k))).collect();
    let solution = row.and_then(|row| row.result.as_ref().ok());
    for (interface, punch) in sweep.contacts() {
        let own = solution.into_iter().flat_map(Solution::contacts).filter(|own| own.interface == interface);
        let found: Vec<Contact> = own.flat_map(Contact::of_each_punch).collect();
        let closed = solution.and_then(|solution| solution.closed().iter().find(|own| own.interface == interface));
        let missing = closed.map_or([f64::NAN; Contact::COLUMNS.len()], ClosedInterface::as_contact);
        let numbers = found.get(punch.unwrap_or(0)).map_or(missing, Contact::numbers);
        let owner = punch.map_or(owner(&interface), |punch| format!("{}_{}", owner(&interface), punch + 1));
        cells.extend(Contact::COLUMNS.map(|quantity| format!("{owner}_{quantity}")).into_iter().zip(numbers));
    }
    let weighed = sweep.contacts().filter(|(own, _)| *own != Interface::Punch && sweep.has_weights());
    for (interface, _) in weighed {
        let found = solution.and_then(|solution| solution.closed().iter().find(|own| own.interface == interface));
        let numbers = found.map_or([f64::NAN; ClosedInterface::COLUMNS.len()], ClosedInterface::numbers);
        let names = ClosedInterface::COLUMNS.map(|quantity| format!("{}_{quantity}", owner(&interface)));
        cells.extend(names.into_iter().zip(numbers));
    }
    // `punch.left` may be varied, and contacts have a left end
    let (varied, found) = cells.split_at_mut(sweep.axes().len());
    let doubled = varied.iter_mut().filter(|(name, _)| found.iter().any(|(other, _)| other == name));
    doubled.for_each(|(name, _)| name.insert_str(0, "varied_"));
    let mut add = |name: &str, number: Option<f64>| cells.push((name.to_owned(), number.unwrap_or(f64::NAN)));
    if !matches!(sweep.scene().force, Force::Given(_)) {
        add("force", solution.map(Solution::force));
        add("force_error", solution.map(Solution::force_error));
    }
    if sweep.has_approach() {
        let approach = row.and_then(|row| row.approach.as_ref()?.as_ref().ok());
        add("approach", approach.map(|approach| approach.value));
        add("approach_error", approach.map(|approach| approach.error));
        add("stiffness", approach.and_then(|approach| approach.stiffness.value()));
        add("stiffness_error", approach.and_then(|approach| approach.stiffness.error()));
    }
    if sweep.has_extremes() {
        let found = row.and_then(|row| row.extremes.as_ref()?.as_ref().ok());
        cells.extend(extremes::cells(sweep.scene(), found));
    }
    let probed = row.and_then(|row| row.probes.as_ref()?.as_ref().ok());
    let at = |number: usize| probed.map_or(f64::NAN, |numbers| numbers[number]);
    cells.extend(sweep.probes().iter().enumerate().map(|(number, probe)| (probe.to_string(), at(number))));
    cells
}

/// How the columns of a contact begin.
pub(super) fn owner(interface: &Interface) -> String {
    match interface {
        Interface::Punch => "punch".to_owned(),
        Interface::Between { above, below } => format!("contact_{above}_{below}"),
    }
}

/// The fields of one line with its end; `None` for anything else.
pub(super) fn fields(text: &str) -> Option<csv::StringRecord> {
    let mut reader = csv::ReaderBuilder::new().has_headers(false).buffer_capacity(1 << 10).from_reader(text.as_bytes());
    let mut record = csv::StringRecord::new();
    reader.read_record(&mut record).is_ok_and(|found| found).then_some(record)
}

/// Fields as a line with its end, each within quotes where it needs them.
fn line(fields: impl IntoIterator<Item = impl AsRef<[u8]>>) -> io::Result<String> {
    let mut writer = csv::WriterBuilder::new().buffer_capacity(1 << 10).from_writer(Vec::new());
    writer.write_record(fields)?;
    let bytes = writer.into_inner().map_err(|error| error.into_error())?;
    String::from_utf8(bytes).map_err(io::Error::other)
}
