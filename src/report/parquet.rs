//! Rows of a sweep as a Parquet file.
use std::io::{self, Write};
use std::sync::Arc;

use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;

use super::SweepCsv;
use super::sweep::{TEXTS, fields};

/// Rows of a group: so many are held in memory, and a file may have 2¹⁵ groups.
const ROWS: usize = 1 << 17;

/// The columns of a sweep, from the lines of its comma-separated values.
///
/// Numbers are doubles, and NaN where a line has none; the last four columns are texts. The metadata of the file hold the `scene` in RON,
/// the `version` of recede, and the `tolerance`.
///
/// ```
/// use recede::{Scene, Sweep, report::{SweepCsv, SweepParquet}};
/// let scene = Scene::read("examples/scenes/hertz.ron")?;
/// let sweep = Sweep::new(scene, vec!["force=[0.001, 0.002]".parse()?])?;
/// let csv = SweepCsv::new(&sweep);
/// let mut file = SweepParquet::new(&csv, Vec::new())?;
/// for row in sweep.rows() {
///     file.write(&csv.line(&row)?)?;
/// }
/// assert!(file.finish()?.starts_with(b"PAR1"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct SweepParquet<W: Write + Send> {
    writer: SerializedFileWriter<W>,
    numbers: Vec<Vec<f64>>,
    texts: Vec<Vec<ByteArray>>,
}

impl<W: Write + Send> SweepParquet<W> {
    /// A file for lines of a sweep, in the order in which they come.
    ///
    /// # Errors
    /// Errors of the writer.
    pub fn new(csv: &SweepCsv, out: W) -> io::Result<Self> {
        let header = csv.header()?;
        let names: Vec<&str> = header.trim_end().split(',').collect();
        let numbers = names.len() - TEXTS.len();
        let column = |(place, name): (usize, &&str)| {
            let (physical, logical) = if place < numbers {
                (Physical::DOUBLE, None)
            } else {
                (Physical::BYTE_ARRAY, Some(LogicalType::String))
            };
            let column = Type::primitive_type_builder(name, physical);
            column.with_repetition(Repetition::REQUIRED).with_logical_type(logical).build().map(Arc::new)
        };
        let columns = names.iter().enumerate().map(column).collect::<Result<_, _>>().map_err(failed)?;
        let schema = Type::group_type_builder("sweep").with_fields(columns).build().map_err(failed)?;
        let sweep = csv.sweep();
        let metadata = [
            ("scene", sweep.scene().to_ron()),
            ("version", env!("CARGO_PKG_VERSION").to_owned()),
            ("tolerance", format!("{:?}", sweep.options().tolerance)),
        ];
        let metadata = metadata.map(|(key, value)| KeyValue::new(key.to_owned(), value)).to_vec();
        let properties = WriterProperties::builder()
            .set_key_value_metadata(Some(metadata))
            .set_compression(Compression::SNAPPY)
            .set_created_by(format!("recede {}", env!("CARGO_PKG_VERSION")));
        let writer = SerializedFileWriter::new(out, Arc::new(schema), Arc::new(properties.build())).map_err(failed)?;
        Ok(Self { writer, numbers: vec![Vec::new(); numbers], texts: vec![Vec::new(); TEXTS.len()] })
    }

    /// Adds the row of a line.
    ///
    /// # Errors
    /// Errors of the writer, and [`io::ErrorKind::InvalidData`] if the line has other columns.
    pub fn write(&mut self, line: &str) -> io::Result<()> {
        let record = fields(line).unwrap_or_default();
        let (found, expected) = (record.len(), self.numbers.len() + self.texts.len());
        if found != expected {
            return Err(io::Error::new(
                io::ErrorKind::InvalidData,
                format!("a line has {found} columns, its sweep has {expected}"),
            ));
        }
        let mut fields = record.iter();
        for (column, field) in self.numbers.iter_mut().zip(fields.by_ref()) {
            column.push(field.parse().unwrap_or(f64::NAN));
        }
        for (column, field) in self.texts.iter_mut().zip(fields) {
            column.push(field.into());
        }
        if self.texts[0].len() == ROWS { self.write_group() } else { Ok(()) }
    }

    /// Completes the file.
    ///
    /// # Errors
    /// Errors of the writer.
    pub fn finish(mut self) -> io::Result<W> {
        self.write_group()?;
        self.writer.into_inner().map_err(failed)
    }

    /// Writes the rows in memory, if there are any.
    fn write_group(&mut self) -> io::Result<()> {
        if self.texts[0].is_empty() {
            return Ok(());
        }
        let mut group = self.writer.next_row_group().map_err(failed)?;
        let (mut numbers, mut texts) = (self.numbers.iter_mut(), self.texts.iter_mut());
        while let Some(mut column) = group.next_column().map_err(failed)? {
            match column.untyped() {
                ColumnWriter::DoubleColumnWriter(writer) => {
                    let values = numbers.next().map(std::mem::take).unwrap_or_default();
                    writer.write_batch(&values, None, None).map_err(failed)?;
                }
                ColumnWriter::ByteArrayColumnWriter(writer) => {
                    let values = texts.next().map(std::mem::take).unwrap_or_default();
                    writer.write_batch(&values, None, None).map_err(failed)?;
                }
                _ => {}
            }
            column.close().map_err(failed)?;
        }
        group.close().map(drop).map_err(failed)
    }
}

/// The error of the file below, if it is one.
fn failed(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(cause) => cause.downcast().map_or_else(io::Error::other, |cause| *cause),
        other => io::Error::other(other),
    }
}
