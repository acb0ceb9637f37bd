//! Errors of reading the file of a scan.

use std::fmt;

use thiserror::Error;

use crate::foreign::ForeignFile;
use crate::format::ScanFormat;
use crate::heights::ScanError;
use units::LengthUnit;
use units::printable::listed;

/// Error of a file that holds no scan, or lacks unit or size.
///
/// Lines, rows, columns and points are counted from 1, bytes from 0.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ScanReadError {
    /// Content that no reader knows.
    #[error(
        "recognising '{name}': no format that is read begins with {start}; save the heights as text, or in a format of \
         docs/guide/instruments.md"
    )]
    UnknownFormat {
        /// Name of the file.
        name: String,
        /// Its first bytes, escaped.
        start: String,
    },
    /// A file of another kind, such as a picture.
    #[error("this is {kind}; {advice}", kind = .0, advice = .0.advice())]
    Foreign(ForeignFile),
    /// A field that is missing.
    #[error("reading {format}, {place}: there is no {field}; {mend}")]
    MissingField {
        /// Format of the file.
        format: ScanFormat,
        /// Place where it should be.
        place: FilePlace,
        /// Its name.
        field: String,
        /// Advice.
        mend: &'static str,
    },
    /// A field with a value that cannot be.
    #[error("reading {format}, {place}: {field} is {value}, it must be {bound}; {mend}")]
    BadField {
        /// Format of the file.
        format: ScanFormat,
        /// Place of the point or field.
        place: FilePlace,
        /// Its name.
        field: String,
        /// Value found.
        value: String,
        /// Values allowed.
        bound: String,
        /// Advice.
        mend: &'static str,
    },
    /// Bytes beyond the end of the file.
    #[error(
        "reading {format}, byte {offset}: {what} takes {needed} bytes, but the file ends {available} bytes on; the file \
         is cut off or its header damaged: export it again"
    )]
    Truncated {
        /// Format of the file.
        format: ScanFormat,
        /// Offset of the bytes.
        offset: u64,
        /// Name of their content.
        what: String,
        /// Number of bytes needed.
        needed: u64,
        /// Number found.
        available: u64,
    },
    /// A variant of the format that is not read.
    #[error("reading {format}, {place}: {found} cannot be read; {mend}")]
    Unsupported {
        /// Format of the file.
        format: ScanFormat,
        /// Place in the file.
        place: FilePlace,
        /// Variant found.
        found: String,
        /// Advice.
        mend: &'static str,
    },
    /// A file none of whose channels holds heights of the surface.
    #[error("reading {format}: no channel holds heights; there {}", list(.channels))]
    NoHeightChannel {
        /// Format of the file.
        format: ScanFormat,
        /// Names of its channels.
        channels: Vec<String>,
    },
    /// No channel or measurement of the name asked for.
    #[error("reading {format}: there is no {wanted}; there {}", list(.channels))]
    NoChannel {
        /// Format of the file.
        format: ScanFormat,
        /// Name asked for.
        wanted: String,
        /// Names of the channels of the file.
        channels: Vec<String>,
    },
    /// A measurement asked for of a file that holds one.
    #[error("choosing measurement '{0}': the file is no container of measurements")]
    OneMeasurement(String),
    /// A channel asked for whose values are not lengths.
    #[error(
        "reading {format}: channel '{channel}' has values {}, which are not heights; there {} with heights",
        in_unit(.unit), list(.channels)
    )]
    NoHeights {
        /// Format of the file.
        format: ScanFormat,
        /// The channel asked for.
        channel: String,
        /// The unit of its values as the file writes it; empty where it gives none.
        unit: String,
        /// The channels with heights.
        channels: Vec<String>,
    },
    /// Lengths or heights without a unit.
    #[error("reading {format}: the file does not say the unit of {what}")]
    NoUnit {
        /// Format of the file.
        format: ScanFormat,
        /// Kind of content.
        what: Unitless,
    },
    /// A unit given by option to a format that fixes its own.
    #[error("reading {format}: the format fixes the unit of lengths and heights, and '{unit}' is asked for")]
    UnitIsFixed {
        /// Format of the file.
        format: ScanFormat,
        /// The unit asked for.
        unit: LengthUnit,
    },
    /// Heights without a lateral size.
    #[error("reading {format}: the file does not say {what}")]
    NoSize {
        /// Format of the file.
        format: ScanFormat,
        /// Size that is unknown.
        what: &'static str,
    },
    /// A size asked for where every point has its position.
    #[error("reading {format}, {place}: a line at uneven spacing has its own size, and another is asked for")]
    SizeIsFixed {
        /// Format of the file.
        format: ScanFormat,
        /// Place in the file.
        place: FilePlace,
    },
    /// Bytes that are not text.
    #[error(
        "line {line}: byte {offset} of the file is 0x{byte:02x}, which is not text; save the scan as text in UTF-8"
    )]
    NotText {
        /// Line.
        line: usize,
        /// Position of the byte.
        offset: usize,
        /// The byte.
        byte: u8,
    },
    /// No line of numbers.
    #[error(
        "reading text: the file holds no line of numbers, it must hold at least 2; write them without units, as 0.5 1.25"
    )]
    NoRows,
    /// A field that is not a number.
    #[error(
        "line {line}: column {column} is '{text}', which is not a number; write numbers as 1000.5, and nan where the point is missing"
    )]
    NotANumber {
        /// Line.
        line: usize,
        /// Column.
        column: usize,
        /// The field.
        text: String,
    },
    /// A row of another length than the first.
    #[error(
        "line {line}: the number of columns is {found}, in line {first_line} it is {expected}; the file is cut off or \
         holds more than one scan: give every line the same columns"
    )]
    Ragged {
        /// Line.
        line: usize,
        /// Number of columns.
        found: usize,
        /// The first line of numbers.
        first_line: usize,
        /// Number of columns there.
        expected: usize,
    },
    /// Commas that may separate columns or mark decimals.
    #[error(
        "line {line}: in '{text}' the comma may separate two columns or mark the decimals of one number, and no other \
         line tells; separate columns with semicolons or tabs, or write decimals with points"
    )]
    AmbiguousComma {
        /// Line.
        line: usize,
        /// The line's text.
        text: String,
    },
    /// Decimal commas and decimal points in one file.
    #[error(
        "line {line}: '{text}' has a decimal {}, line {first_line} a decimal {}; write all decimals with points, and no separators of thousands",
        mark(*.is_comma), mark(!*.is_comma)
    )]
    MixedDecimals {
        /// Line.
        line: usize,
        /// The field.
        text: String,
        /// True if the field has a comma.
        is_comma: bool,
        /// Line of the first decimal mark.
        first_line: usize,
    },
    /// A column of a text whose unit is no length, where positions or heights are wanted.
    #[error(
        "line {line}: column {column} is {}, which is no length; export positions and heights in units of length",
        in_unit(.unit)
    )]
    NoLength {
        /// Line of the unit.
        line: usize,
        /// Column.
        column: usize,
        /// The unit as the file writes it; empty where a name alone says that the column is no length.
        unit: String,
    },
    /// Columns without names, more than one of which may hold positions, or one that is not the first.
    #[error(
        "line {line}: column{} {} throughout, as positions do; name the columns in a line above, such as 'x (mm) z (um)', or choose the \
         column of heights by its number, such as 2",
        if .columns.len() > 1 { "s" } else { "" }, rising(.columns)
    )]
    AmbiguousColumns {
        /// The first line of numbers.
        line: usize,
        /// The columns that rise or fall from row to row.
        columns: Vec<usize>,
    },
    /// Positions of a profile that neither rise nor fall throughout.
    #[error(
        "line {line}: the position is {position}, that of the point before {before}; positions must rise: cut out \
         points where the profile turns back (re-entrant points of a traced contour), or sort the lines"
    )]
    PositionsDoNotRise {
        /// Line.
        line: usize,
        /// The offending position, in the file's unit.
        position: f64,
        /// The position before, in the file's unit.
        before: f64,
    },
    /// Points that lie on no regular grid.
    #[error(
        "line {line}: {axis} = {position} lies on no grid of {count} evenly spaced values from {first} to {last}; \
         points of a map must form a regular grid: interpolate them onto one; of several traces make a file each"
    )]
    NotAGrid {
        /// Line.
        line: usize,
        /// Name of the coordinate.
        axis: char,
        /// Its value, in the file's unit.
        position: f64,
        /// Number of distinct values.
        count: usize,
        /// Smallest value, in the file's unit.
        first: f64,
        /// Largest value, in the file's unit.
        last: f64,
    },
    /// Points scattered over a grid that they hardly fill.
    #[error(
        "reading text: {points} points lie on a grid of {columns} x {rows}, most of which they leave empty; points of a map \
         must fill a regular grid but for missing points: interpolate them onto one"
    )]
    Scattered {
        /// Number of points.
        points: usize,
        /// Points of the grid along x.
        columns: usize,
        /// Points of the grid along y.
        rows: usize,
    },
    /// A grid point with two heights.
    #[error("line {line}: the point x = {x}, y = {y} is already in line {first_line}; keep one")]
    RepeatedPoint {
        /// Line of the repetition.
        line: usize,
        /// Line of the first occurrence.
        first_line: usize,
        /// Position, in the file's unit.
        x: f64,
        /// Position, in the file's unit.
        y: f64,
    },
    /// A ZIP file that cannot be unpacked.
    #[error("unpacking {what}: {problem}; pack the archive again")]
    Zip {
        /// The archive or the entry.
        what: String,
        /// Problem found.
        problem: String,
    },
    /// A ZIP file that unpacks to more than it may.
    #[error(
        "unpacking {what}: it takes more than {bound} {unit}, the most that is accepted; pack fewer or smaller files"
    )]
    ArchiveTooLarge {
        /// The archive or the entry.
        what: String,
        /// Most that is accepted.
        bound: u64,
        /// Name of the quantity counted.
        unit: &'static str,
    },
    /// An entry of a ZIP file that points out of it.
    #[error(
        "unpacking the archive: the path '{path}' leads out of it; pack the archive again with relative paths"
    )]
    PathOutside {
        /// The path.
        path: String,
    },
    /// Metadata in XML, YAML or JSON that cannot be parsed.
    #[error("reading '{file}': {problem}; correct it or export it again")]
    Syntax {
        /// Name of the file.
        file: String,
        /// Problem found, with the line.
        problem: String,
    },
    /// A measurement of a container that cannot be read.
    #[error("measurement '{measurement}' in '{file}': {source}")]
    Measurement {
        /// Name of the measurement.
        measurement: String,
        /// Its data file.
        file: String,
        /// Error of the data file.
        source: Box<ScanReadError>,
    },
    /// Heights and spacings that make no scan.
    #[error(transparent)]
    Scan(#[from] ScanError),
}

/// Quotes the beginning of a text of the file, for messages.
pub(crate) fn quoted(text: &str) -> String {
    const MOST: usize = 60;
    format!("'{}'", text.chars().take(MOST).collect::<String>())
}

/// Errors of the fields of a file.
impl ScanFormat {
    /// The error of a field that is missing.
    pub(crate) fn missing(
        self,
        place: FilePlace,
        field: impl Into<String>,
        mend: &'static str,
    ) -> ScanReadError {
        ScanReadError::MissingField { format: self, place, field: field.into(), mend }
    }

    /// The error of a field with a value that cannot be.
    pub(crate) fn bad(
        self,
        place: FilePlace,
        field: impl Into<String>,
        value: impl ToString,
        bound: impl Into<String>,
        mend: &'static str,
    ) -> ScanReadError {
        let (field, value, bound) = (field.into(), value.to_string(), bound.into());
        ScanReadError::BadField { format: self, place, field, value, bound, mend }
    }

    /// The error of a variant of the format that is not read.
    pub(crate) fn unsupported(
        self,
        place: FilePlace,
        found: impl Into<String>,
        mend: &'static str,
    ) -> ScanReadError {
        ScanReadError::Unsupported { format: self, place, found: found.into(), mend }
    }
}

impl ScanReadError {
    /// Returns the option that mends the error, if one does.
    #[must_use]
    pub fn mend(&self) -> Option<Mend> {
        match self {
            Self::NoUnit { what, .. } => Some(Mend::Give(match what {
                Unitless::Lengths | Unitless::Heights => ScanOption::Unit,
                Unitless::HeightsAlone => ScanOption::HeightUnit,
                Unitless::LengthsAndHeights => ScanOption::Units,
            })),
            Self::NoSize { .. } => Some(Mend::Give(ScanOption::Size)),
            Self::NoChannel { format, channels, .. } if !channels.is_empty() => {
                Some(Mend::Give(match format {
                    ScanFormat::Container => ScanOption::Measurement,
                    _ => ScanOption::Channel,
                }))
            }
            Self::AmbiguousColumns { .. } => Some(Mend::Give(ScanOption::Channel)),
            Self::NoHeights { channels, .. } if !channels.is_empty() => Some(Mend::Give(ScanOption::Channel)),
            Self::OneMeasurement(_) => Some(Mend::LeaveOut(ScanOption::Measurement)),
            Self::UnitIsFixed { .. } => Some(Mend::LeaveOut(ScanOption::Unit)),
            Self::SizeIsFixed { .. } => Some(Mend::LeaveOut(ScanOption::Size)),
            Self::Measurement { source, .. } => source.mend(),
            _ => None,
        }
    }
}

/// An option that mends an error; front ends spell it in their own way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mend {
    /// Give what the file lacks.
    Give(ScanOption),
    /// Leave out what the file has itself.
    LeaveOut(ScanOption),
}

/// A field of [`ScanOptions`](crate::ScanOptions).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ScanOption {
    /// The unit of lengths and heights.
    Unit,
    /// The unit of heights, where lengths have theirs.
    HeightUnit,
    /// The units of lengths and of heights, which may differ.
    Units,
    /// The lateral size.
    Size,
    /// The channel of a file.
    Channel,
    /// The measurement of a container.
    Measurement,
}

/// Numbers of a file that have no unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Unitless {
    /// Lengths along the surface.
    Lengths,
    /// Heights.
    Heights,
    /// Heights beside lengths that have a unit.
    HeightsAlone,
    /// Positions and heights, which may be in different units.
    LengthsAndHeights,
}

impl fmt::Display for Unitless {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Lengths => "lengths",
            Self::Heights | Self::HeightsAlone => "heights",
            Self::LengthsAndHeights => "lengths and heights",
        })
    }
}

/// A place in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FilePlace {
    /// The whole file.
    File,
    /// Line, from 1.
    Line(usize),
    /// Offset in bytes, from 0.
    Byte(u64),
    /// Path of an element.
    Element(String),
}

impl fmt::Display for FilePlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File => f.write_str("the file"),
            Self::Line(line) => write!(f, "line {line}"),
            Self::Byte(offset) => write!(f, "byte {offset}"),
            Self::Element(path) => f.write_str(path),
        }
    }
}

fn list(names: &[String]) -> String {
    match names {
        [] => "are none".to_owned(),
        [name] => format!("is '{name}'"),
        _ => format!("are {}", listed(names, "'")),
    }
}

fn in_unit(unit: &str) -> String {
    if unit.is_empty() { "without a unit of length".to_owned() } else { format!("in {unit}") }
}

/// `1 and 2 rise or fall`.
fn rising(columns: &[usize]) -> String {
    let numbers: Vec<String> = columns.iter().map(ToString::to_string).collect();
    match numbers.split_last() {
        Some((last, [])) => format!("{last} rises or falls"),
        Some((last, before)) => format!("{} and {last} rise or fall", before.join(", ")),
        None => String::new(),
    }
}

fn mark(is_comma: bool) -> &'static str {
    if is_comma { "comma" } else { "point" }
}
