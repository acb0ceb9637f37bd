//! Errors of reading the file of a spectrum.

use thiserror::Error;
use units::LengthUnit;
use units::display::{counted, length};
use units::printable::listed;

use crate::convention::Convention;
use crate::read::header::{Abscissa, Heading};
use crate::read::json::JsonError;
use crate::read::mend::{ReadMend, ReadOption, Wanted};
use crate::read::options::UnitError;
use crate::read::select::SeriesError;
use crate::read::workbook::WorkbookError;

/// Name of the quantity for which the caller may name the column.
pub(crate) const SPECTRUM: &str = "spectrum";

/// Probable encoding of bytes that are not UTF-8 text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Encoding {
    /// UTF-16, by its first bytes.
    Utf16,
    /// Binary, such as files of instruments: control characters among the first bytes.
    Binary,
    /// Text in another encoding.
    Unknown,
}

impl Encoding {
    pub(crate) fn guess(bytes: &[u8]) -> Self {
        if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
            return Self::Utf16;
        }
        let is_control = |byte: &u8| *byte < b' ' && !b"\t\n\r\x0c".contains(byte);
        if bytes.iter().take(512).any(is_control) { Self::Binary } else { Self::Unknown }
    }
}

impl std::fmt::Display for Encoding {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Utf16 => "the start of UTF-16, not UTF-8",
            Self::Binary => "binary data, perhaps a scan",
            Self::Unknown => "not UTF-8 text",
        })
    }
}

/// Errors of reading a power spectrum.
///
/// Lines are counted from 1, comments and empty lines included. Columns are given by name, or by number if the file has
/// no header.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The input cannot be read.
    #[error("reading the spectrum: {0}")]
    Io(#[from] std::io::Error),
    /// The file has only comments and empty lines.
    #[error("reading the spectrum: the file holds no rows; give at least 2")]
    Empty,
    /// The choice of the series fails or is missing.
    #[error(transparent)]
    Series(#[from] SeriesError),
    /// A unit given by the caller is invalid.
    #[error(transparent)]
    Unit(#[from] UnitError),
    /// The JSON holds no series.
    #[error(transparent)]
    Json(#[from] JsonError),
    /// The workbook cannot be read.
    #[error(transparent)]
    Workbook(#[from] WorkbookError),
    /// Another error in a sheet of a workbook, with rows of the sheet as lines.
    #[error("sheet '{sheet}', {error}")]
    InSheet {
        /// Name of the sheet.
        sheet: String,
        /// The error in the sheet.
        error: Box<ReadError>,
    },
    /// An error in a line.
    #[error("line {line}: {problem}")]
    AtLine {
        /// Line; the last line read if rows are missing.
        line: usize,
        /// The problem.
        problem: LineProblem,
    },
}

/// Problem of a line.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum LineProblem {
    /// The file is not UTF-8 text.
    #[error(
        "byte {offset} of the file is 0x{byte:02x}, which is {encoding}; save the spectrum as CSV or text in UTF-8"
    )]
    NotText {
        /// Position of the byte in the file, from 1.
        offset: usize,
        /// The byte.
        byte: u8,
        /// The probable encoding.
        encoding: Encoding,
    },
    /// Numbers without a header.
    #[error("the file has no header that names its two columns")]
    NoHeader,
    /// Numbers without a header, but not in two columns.
    #[error("a file without a header needs 2 columns but has {columns}; name them in a first row")]
    HeaderlessColumns {
        /// Number of columns.
        columns: usize,
    },
    /// No column for a quantity.
    #[error("no column holds the {quantity} ({accepted}); the columns are {}{}", list(.found), logarithms(.found))]
    MissingColumn {
        /// The missing quantity.
        quantity: &'static str,
        /// Accepted names.
        accepted: &'static str,
        /// The columns there are.
        found: Vec<String>,
    },
    /// No column of the requested name.
    #[error("there is no column '{column}'; the columns are {}", list(.found))]
    UnknownColumn {
        /// The requested name.
        column: String,
        /// The columns there are.
        found: Vec<String>,
    },
    /// Two columns for the same quantity.
    #[error("duplicate column: '{first}' and '{second}' both hold the {quantity}; keep one")]
    DuplicateColumn {
        /// The quantity.
        quantity: &'static str,
        /// One column.
        first: String,
        /// The other.
        second: String,
    },
    /// Several spectra, none with precedence.
    #[error("several columns hold a spectrum: {}", list(.found))]
    SeveralDensities {
        /// The columns.
        found: Vec<String>,
    },
    /// A unit that is unknown or of the wrong dimension.
    #[error("column '{column}' is in '{unit}', but the {quantity} is read in {accepted}; rename the column")]
    BadUnit {
        /// Column.
        column: String,
        /// The text in the place of the unit.
        unit: String,
        /// The quantity.
        quantity: String,
        /// Accepted units.
        accepted: String,
    },
    /// A spectrum in m^4, which two conventions share.
    #[error("column '{0}' is a spectrum in m^4, which two conventions share")]
    AmbiguousDensity(String),
    /// A wavenumber, which some count in radians and others in cycles per length.
    #[error("wavenumber in radians or cycles")]
    AmbiguousWavenumber(String),
    /// A column called two-dimensional with the unit of profiles.
    #[error("'{0}' is 2D by name, 1D by unit")]
    TwoDimensionalInCubicMetres(String),
    /// A column whose name does not state a convention.
    #[error("column '{0}' does not state its convention")]
    NoConvention(String),
    /// A row of another length than the header or the first row.
    #[error(
        "{}, but {expected} in line {first_line}; give every row the same columns",
        counted(*.found, "field")
    )]
    Ragged {
        /// Number of fields.
        found: usize,
        /// Line of the header or the first row.
        first_line: usize,
        /// Number of fields there.
        expected: usize,
    },
    /// An empty field.
    #[error("column '{0}' is empty; enter a number above 0 or remove the row")]
    EmptyField(String),
    /// A field whose text is no number for its column.
    #[error("column '{column}' is '{text}'{problem}")]
    BadField {
        /// Column.
        column: String,
        /// The field.
        text: String,
        /// The problem.
        problem: FieldProblem,
    },
    /// Two abscissae that contradict each other.
    #[error(
        "{first} and {second}, wavelengths in the ratio {ratio}, which must be 1 within 0.001{hint}; \
         correct the row or remove a column"
    )]
    Inconsistent {
        /// The field with precedence.
        first: Box<Field>,
        /// The field that contradicts it.
        second: Box<Field>,
        /// The wavelength of the first over that of the second, to six digits.
        ratio: f64,
        /// Explanation of a factor of 2 pi, or empty.
        hint: &'static str,
    },
    /// A repeated wavelength.
    #[error(
        "the wavelength {} is already in line {first_line}; keep one row for each wavelength, and one series (such as '1D PSD along x') in a file",
        length(*.wavelength_m)
    )]
    RepeatedWavelength {
        /// Line of the first occurrence.
        first_line: usize,
        /// The wavelength in m.
        wavelength_m: f64,
    },
    /// Fewer than two rows.
    #[error("the file holds {}; give at least 2", counted(*.rows, "row"))]
    TooFewRows {
        /// Number of rows.
        rows: usize,
    },
}

/// Problem of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum FieldProblem {
    /// A field that is not a number.
    #[error(", not a number; write it like 1.5e-9, with a point, or remove the row")]
    NotANumber,
    /// A number that is NaN, infinite, zero or negative.
    #[error("; it must be finite and above 0: correct it or remove the row")]
    OutOfRange,
    /// A positive number that no surface has: a wavelength beyond thirty decades from 1 m, a density beyond ninety from 1 m^3
    /// or m^4.
    #[error(", which no surface has; check its unit, correct it or remove the row")]
    Absurd,
    /// A standard error that is infinite or negative.
    #[error("; it must be finite and at least 0: correct it, or leave it empty")]
    BadStandardError,
}

/// A field of a row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field {
    /// Column.
    pub column: String,
    /// Text of the field.
    pub text: String,
}

impl std::fmt::Display for Field {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "column '{}' is '{}'", self.column, self.text)
    }
}

impl ReadError {
    /// The line at fault, counted from 1; `None` if the whole file is.
    pub fn line(&self) -> Option<usize> {
        match *self {
            Self::Io(_) | Self::Empty | Self::Series(_) | Self::Workbook(_) => None,
            Self::Unit(ref error) => error.line(),
            Self::Json(ref error) => error.line(),
            Self::InSheet { ref error, .. } => error.line(),
            Self::AtLine { line, .. } => Some(line),
        }
    }

    /// Returns true if nothing in the file names a spectrum, so that it may hold heights.
    #[must_use]
    pub fn names_no_spectrum(&self) -> bool {
        match self {
            Self::AtLine { problem, .. } => match problem {
                LineProblem::MissingColumn { found, .. } => {
                    found.iter().all(|name| Heading::parse(name).is_none())
                }
                LineProblem::NoHeader | LineProblem::HeaderlessColumns { .. } => true,
                _ => false,
            },
            Self::Workbook(error) => {
                matches!(error, WorkbookError::NoTable { .. } | WorkbookError::NotBuiltIn)
            }
            _ => false,
        }
    }

    /// Returns true if the names of the columns are those of a spectrum, whose values or units are at fault.
    #[must_use]
    pub fn is_of_a_spectrum(&self) -> bool {
        match self {
            Self::AtLine { problem, .. } => match problem {
                LineProblem::MissingColumn { found, .. } => !logarithms(found).is_empty(),
                LineProblem::NotText { .. }
                | LineProblem::NoHeader
                | LineProblem::HeaderlessColumns { .. }
                | LineProblem::UnknownColumn { .. } => false,
                _ => true,
            },
            Self::InSheet { error, .. } => error.is_of_a_spectrum(),
            _ => false,
        }
    }

    /// The option that fixes the error, if one does.
    #[must_use]
    pub fn mend(&self) -> Option<ReadMend> {
        match self {
            Self::AtLine { problem, .. } => problem.mend().map(ReadMend::Give),
            Self::Series(error) => error.mend(),
            Self::Unit(error) => Some(error.mend()),
            Self::InSheet { error, .. } => error.mend(),
            _ => None,
        }
    }
}

impl LineProblem {
    /// Puts the problem into a line.
    pub(crate) fn at(self, line: usize) -> ReadError {
        ReadError::AtLine { line, problem: self }
    }

    /// The options that fix it.
    fn mend(&self) -> Option<Vec<Wanted>> {
        let convention = || ReadOption::Convention.one_of(Convention::ALL);
        Some(match self {
            Self::NoHeader => vec![ReadOption::X.one_of(Abscissa::ALL), convention()],
            Self::SeveralDensities { .. } | Self::MissingColumn { quantity: SPECTRUM, .. } => {
                vec![ReadOption::Column.name_in_file()]
            }
            Self::AmbiguousDensity(_) => {
                vec![ReadOption::Convention.one_of([Convention::Ciso, Convention::Persson])]
            }
            Self::TwoDimensionalInCubicMetres(_) => {
                vec![ReadOption::Convention.one_of([Convention::C1D, Convention::W1])]
            }
            Self::AmbiguousWavenumber(_) => {
                vec![ReadOption::X.one_of([Abscissa::Wavevector, Abscissa::Frequency])]
            }
            Self::NoConvention(_) => vec![convention()],
            _ => return None,
        })
    }

    /// Makes the error of a unit that does not fit the spectrum of a convention.
    pub(crate) fn bad_density_unit(column: &str, unit: &str, convention: Convention) -> Self {
        let power = convention.metre_power();
        Self::BadUnit {
            column: column.to_owned(),
            unit: unit.to_owned(),
            quantity: format!("spectrum ({convention})"),
            accepted: format!(
                "{}, or a product such as nm^2 {}",
                LengthUnit::ALL.map(|unit| format!("{}^{power}", unit.ascii())).join(", "),
                if power == 3 { "mm" } else { "mm^2" }
            ),
        }
    }
}

/// The remedy for columns of logarithms; empty if there are none.
fn logarithms(names: &[String]) -> &'static str {
    let are_some = names.iter().any(|name| name.trim().to_lowercase().starts_with("log"));
    if are_some { ": logarithms are not read; write the numbers themselves" } else { "" }
}

fn list(names: &[String]) -> String {
    listed(names, "'")
}
