//! The series of a file, before it is known what their columns hold.

use csv::StringRecord;

/// What a file calls one of its spectra.
///
/// Files of a single spectrum mostly call it nothing.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct SeriesName {
    /// What the subject is, such as `measurement`, or `surface` for the average over a dataset.
    pub subject_type: Option<String>,
    /// What was measured, such as the name of a measurement.
    pub subject: Option<String>,
    /// Which of its spectra this is, such as `1D PSD along x (incl. unreliable data)`.
    pub series: Option<String>,
}

/// What contact.engineering appends to the name of a series that goes beyond the resolution of the instrument.
const UNRELIABLE: &str = "(incl. unreliable data)";

impl SeriesName {
    /// Whether the file does not say that the series includes unreliable data.
    pub fn is_reliable(&self) -> bool {
        !self.series.as_ref().is_some_and(|series| series.contains(UNRELIABLE))
    }
}

impl std::fmt::Display for SeriesName {
    /// `subject - series`, as contact.engineering writes it, or the one of them that there is.
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
    /// Whether an empty or `nan` spectrum is a value left out on purpose, as in exports of contact.engineering,
    /// rather than a mistake.
    pub(crate) may_miss_values: bool,
    /// What is said about this series alone.
    pub(crate) comments: Vec<String>,
    /// What was left out on the way.
    pub(crate) notes: Vec<String>,
    /// The sheet of a workbook in which it stands; lines are rows of the sheet then.
    pub(crate) sheet: Option<String>,
}

impl Series {
    pub(crate) fn new(name: SeriesName, columns: Columns, rows: Vec<Row>) -> Self {
        let (comments, notes) = (Vec::new(), Vec::new());
        Self { name, columns, rows, may_miss_values: false, comments, notes, sheet: None }
    }

    /// The last line, or that of the names where there is no row.
    pub(crate) fn last_line(&self) -> usize {
        self.rows.last().map_or(self.columns.line, |row| row.line)
    }
}

/// The columns of a series.
#[derive(Debug)]
pub(crate) struct Columns {
    /// Their names, or their numbers where they have no names.
    pub(crate) names: Vec<String>,
    /// The line in which they stand, or the first row.
    pub(crate) line: usize,
    pub(crate) kind: ColumnKind,
}

/// Where the columns come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ColumnKind {
    /// The names are the file's.
    Named,
    /// The file has no names.
    Numbered,
    /// The arrays x, y and perhaps std_err_y of a JSON series.
    Arrays {
        /// Whether the names of the columns tell quantities and units.
        named: bool,
    },
}

/// A row with its line, counted from 1.
#[derive(Debug)]
pub(crate) struct Row {
    pub(crate) line: usize,
    pub(crate) fields: StringRecord,
}
