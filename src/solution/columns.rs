//! The numbers of a contact that tables list.
use super::Contact;

impl Contact {
    /// What tables list of each contact, by name.
    pub(crate) const COLUMNS: [&str; 12] = [
        "half_length",
        "half_length_error",
        "central_pressure",
        "central_pressure_error",
        "peak_pressure",
        "peak_pressure_error",
        "peak_at",
        "intervals",
        "left",
        "left_error",
        "right",
        "right_error",
    ];

    /// The numbers of these columns, NaN where there is none: of several intervals, how many there are, and where the first one
    /// begins and the last one ends.
    pub(crate) fn numbers(&self) -> [f64; Self::COLUMNS.len()] {
        let (peak, intervals) = (self.peak(), &self.intervals);
        [
            self.half_length().unwrap_or(f64::NAN),
            self.half_length_error().unwrap_or(f64::NAN),
            self.central_pressure,
            self.central_pressure_error,
            peak.pressure,
            peak.error,
            peak.x,
            intervals.len() as f64,
            intervals.first().map_or(0.0, |first| first.left),
            intervals.first().map_or(0.0, |first| first.left_error),
            intervals.last().map_or(0.0, |last| last.right),
            intervals.last().map_or(0.0, |last| last.right_error),
        ]
    }
}
