//! The series of a file as text, before their columns are assigned.

use csv::StringRecord;

/// Name of a spectrum in a file; empty in most files of a single spectrum.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct SeriesName {
    /// Type of the subject, such as `measurement`, or `surface` for the average over a dataset.
    pub subject_type: Option<String>,
    /// Subject, such as the name of a measurement.
    pub subject: Option<String>,
    /// Spectrum of the subject, such as `1D PSD along x (incl. unreliable data)`.
    pub series: Option<String>,
}

/// Suffix of contact.engineering for series beyond the resolution of the instrument.
const UNRELIABLE: &str = "(incl. unreliable data)";

impl SeriesName {
    /// Returns true unless the name says that the series includes unreliable data.
    pub fn is_reliable(&self) -> bool {
        !self.series.as_ref().is_some_and(|series| series.contains(UNRELIABLE))
    }
}

impl std::fmt::Display for SeriesName {
    /// Writes `subject - series`, as contact.engineering does, or the one that is known.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match (&self.subject, &self.series) {
            (Some(subject), Some(series)) => write!(f, "{subject} - {series}"),
            (Some(name), None) | (None, Some(name)) => f.write_str(name),
            (None, None) => f.write_str("unnamed"),
        }
    }
}

/// One spectrum of a file: its columns and rows, as text.
#[derive(Debug)]
pub(crate) struct Series {
    pub(crate) name: SeriesName,
    pub(crate) columns: Columns,
    pub(crate) rows: Vec<Row>,
    /// True if an empty or `nan` value is left out on purpose, as in exports of contact.engineering, and not an error.
    pub(crate) may_miss_values: bool,
    /// Comments on this series alone.
    pub(crate) comments: Vec<String>,
    /// Notes on omissions.
    pub(crate) notes: Vec<String>,
    /// Sheet of a workbook; lines are then rows of the sheet.
    pub(crate) sheet: Option<String>,
}

impl Series {
    pub(crate) fn new(name: SeriesName, columns: Columns, rows: Vec<Row>) -> Self {
        let (comments, notes) = (Vec::new(), Vec::new());
        Self { name, columns, rows, may_miss_values: false, comments, notes, sheet: None }
    }

    /// The last line, or that of the names if there are no rows.
    pub(crate) fn last_line(&self) -> usize {
        self.rows.last().map_or(self.columns.line, |row| row.line)
    }
}

/// The columns of a series.
#[derive(Debug)]
pub(crate) struct Columns {
    /// Names, or numbers if there are no names.
    pub(crate) names: Vec<String>,
    /// Line of the names, or of the first row.
    pub(crate) line: usize,
    pub(crate) kind: ColumnKind,
}

/// Origin of the columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ColumnKind {
    /// Named by the file.
    Named,
    /// Numbered, because the file has no names.
    Numbered,
    /// The arrays x, y and perhaps std_err_y of a JSON series.
    Arrays {
        /// True if the names of the columns state quantities and units.
        named: bool,
    },
}

/// A row with its line, counted from 1.
#[derive(Debug)]
pub(crate) struct Row {
    pub(crate) line: usize,
    pub(crate) fields: StringRecord,
}
