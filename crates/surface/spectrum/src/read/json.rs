//! Spectra as JSON: series `{name, x, y, std_err_y}` of contact.engineering, one or an array of them; a whole analysis
//! with its units; or a table, an array with an object for each row.

use csv::StringRecord;
use indexmap::{IndexMap, IndexSet};
use serde::Deserialize;
use serde_json::value::RawValue;
use thiserror::Error;

use crate::read::series::{ColumnKind, Columns, Row, Series, SeriesName};

/// Errors of reading a series from JSON.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum JsonError {
    /// The text is not JSON, or has values of other types than a series.
    #[error("line {line}, column {column}: reading a series from JSON: {message}")]
    Syntax {
        /// Line.
        line: usize,
        /// Character in the line.
        column: usize,
        /// The JSON reader's message.
        message: String,
    },
    /// The array x or y is missing.
    #[error(
        "reading a series from JSON: {place} has no array '{missing}'; a series is {{\"name\": ..., \"x\": [...], \
         \"y\": [...], \"std_err_y\": [...]}}, the last of which may be missing"
    )]
    NoArray {
        /// The object at fault.
        place: String,
        /// The array it lacks.
        missing: &'static str,
    },
    /// Arrays of different lengths.
    #[error(
        "reading a series from JSON: {place} has {x} numbers in 'x' and {other} in '{array}'; give one for each"
    )]
    UnequalLengths {
        /// The object at fault.
        place: String,
        /// Length of x.
        x: usize,
        /// The other array.
        array: &'static str,
        /// Length of the other array.
        other: usize,
    },
    /// The file holds no series.
    #[error("reading a series from JSON: the array of series is empty; give at least 1")]
    Empty,
}

impl JsonError {
    /// The line at fault, if there is one.
    pub(crate) fn line(&self) -> Option<usize> {
        match *self {
            Self::Syntax { line, .. } => Some(line),
            _ => None,
        }
    }
}

impl From<serde_json::Error> for JsonError {
    fn from(error: serde_json::Error) -> Self {
        let (line, column) = (error.line(), error.column());
        // serde_json ends its messages with the place; here it comes first.
        let mut message = error.to_string().replace(&format!(" at line {line} column {column}"), "");
        if message == "expected value" {
            message.push_str("; a missing number is null, not NaN");
        }
        Self::Syntax { line, column, message }
    }
}

/// Numbers as text: the unit moves the decimal point before they are rounded.
type Numbers<'d> = Vec<Option<&'d RawValue>>;

#[derive(Deserialize)]
struct JsonSeries<'d> {
    name: Option<String>,
    #[serde(borrow)]
    x: Option<Numbers<'d>>,
    #[serde(borrow)]
    y: Option<Numbers<'d>>,
    #[serde(borrow)]
    std_err_y: Option<Numbers<'d>>,
}

/// An analysis: its series with labels and units of the axes.
#[derive(Deserialize)]
struct Analysis<'d> {
    #[serde(borrow)]
    series: Vec<JsonSeries<'d>>,
    xlabel: Option<String>,
    ylabel: Option<String>,
    xunit: Option<String>,
    yunit: Option<String>,
}

/// The key that marks a JSON object as an analysis.
#[derive(Deserialize)]
struct Probe<'d> {
    #[serde(borrow)]
    series: Option<&'d RawValue>,
}

/// Returns true if a text is a JSON object or array.
pub(crate) fn is_json(text: &str) -> bool {
    let text = text.trim_start();
    text.strip_prefix('{').is_some_and(|rest| rest.trim_start().starts_with(['"', '}']))
        || text.strip_prefix('[').is_some_and(|rest| rest.trim_start().starts_with(['{', ']']))
}

/// A row of a table: names with values.
type JsonRow<'d> = IndexMap<String, &'d RawValue>;

/// Reads the series of a JSON text.
pub(crate) fn series(text: &str) -> Result<Vec<Series>, JsonError> {
    if let Some(table) = table(text) {
        return Ok(vec![table]);
    }
    let (analysis, is_single) = if text.trim_start().starts_with('[') {
        (bare(serde_json::from_str(text)?), false)
    } else if serde_json::from_str::<Probe<'_>>(text)?.series.is_some() {
        (serde_json::from_str(text)?, false)
    } else {
        (bare(vec![serde_json::from_str(text)?]), true)
    };
    if analysis.series.is_empty() {
        return Err(JsonError::Empty);
    }
    let names = analysis.names();
    let one = |(i, series): (usize, &JsonSeries<'_>)| {
        let place = match &series.name {
            Some(name) => format!("the series '{name}'"),
            None if is_single => "the object".to_owned(),
            None => format!("series {}", i + 1),
        };
        series.rows(text, &names, place)
    };
    analysis.series.iter().enumerate().map(one).collect()
}

/// Reads a table, an array of objects; `None` if the first object holds an array, which makes it a series.
fn table(text: &str) -> Option<Series> {
    let rows: Vec<JsonRow<'_>> = serde_json::from_str(text).ok()?;
    if rows.first()?.values().any(|value| value.get().starts_with('[')) {
        return None;
    }
    let names: IndexSet<&String> = rows.iter().flat_map(IndexMap::keys).collect();
    let mut place = Place { text, byte: 0, line: 1 };
    let row = |row: &JsonRow<'_>| {
        if let Some(first) = row.values().next() {
            place.advance_to(first.get());
        }
        let field = |name: &&String| match row.get(*name).map(|value| number_text(value)) {
            Some("null") | None => "",
            Some(text) => text,
        };
        Row { line: place.line, fields: names.iter().map(field).collect() }
    };
    let rows: Vec<Row> = rows.iter().map(row).collect();
    let line = rows.first().map_or(1, |row| row.line);
    let names = names.into_iter().cloned().collect();
    Some(Series::new(SeriesName::default(), Columns { names, line, kind: ColumnKind::Named }, rows))
}

fn bare(series: Vec<JsonSeries<'_>>) -> Analysis<'_> {
    Analysis { series, xlabel: None, ylabel: None, xunit: None, yunit: None }
}

/// Names of the arrays in messages; `named` is true if they state quantity and unit.
struct Names {
    x: String,
    y: String,
    std_err_y: String,
    named: bool,
}

impl Analysis<'_> {
    fn names(&self) -> Names {
        let label = |label: &Option<String>, usual: &str| label.clone().unwrap_or_else(|| usual.to_owned());
        match (&self.xunit, &self.yunit) {
            (Some(x), Some(y)) => Names {
                x: format!("{} ({x})", label(&self.xlabel, "Wavevector")),
                y: format!("{} ({y})", label(&self.ylabel, "PSD")),
                std_err_y: format!("standard error of {} ({y})", label(&self.ylabel, "PSD")),
                named: true,
            },
            _ => Names { x: "x".into(), y: "y".into(), std_err_y: "std_err_y".into(), named: false },
        }
    }
}

impl JsonSeries<'_> {
    fn rows(&self, text: &str, names: &Names, place: String) -> Result<Series, JsonError> {
        let missing = |missing| JsonError::NoArray { place: place.clone(), missing };
        let x = self.x.as_ref().ok_or_else(|| missing("x"))?;
        let y = self.y.as_ref().ok_or_else(|| missing("y"))?;
        let mut columns = vec![names.x.clone(), names.y.clone()];
        let mut arrays = vec![x, y];
        if let Some(errors) = &self.std_err_y {
            columns.push(names.std_err_y.clone());
            arrays.push(errors);
        }
        for (array, of) in arrays.iter().zip(["x", "y", "std_err_y"]) {
            if array.len() != x.len() {
                let (x, other) = (x.len(), array.len());
                return Err(JsonError::UnequalLengths { place, x, array: of, other });
            }
        }
        let mut place = Place { text, byte: 0, line: 1 };
        let mut rows = Vec::with_capacity(x.len());
        for i in 0..x.len() {
            let fields: Vec<&str> = arrays.iter().map(|array| array[i].map_or("", number_text)).collect();
            if let Some(raw) = y[i].or(x[i]) {
                place.advance_to(raw.get());
            }
            rows.push(Row { line: place.line, fields: StringRecord::from(fields) });
        }
        let line = rows.first().map_or(1, |row| row.line);
        let columns = Columns { names: columns, line, kind: ColumnKind::Arrays { named: names.named } };
        let name = SeriesName { series: self.name.clone(), ..SeriesName::default() };
        let mut series = Series::new(name, columns, rows);
        series.may_miss_values = true;
        Ok(series)
    }
}

/// Returns a number as text, or the text of a string.
fn number_text(raw: &RawValue) -> &str {
    let text = raw.get();
    text.strip_prefix('"').and_then(|text| text.strip_suffix('"')).unwrap_or(text)
}

/// Line counter that moves forward through the text.
struct Place<'t> {
    text: &'t str,
    byte: usize,
    line: usize,
}

impl Place<'_> {
    /// Moves to `part`, a slice of the text at or after the last one.
    fn advance_to(&mut self, part: &str) {
        let byte = (part.as_ptr() as usize).saturating_sub(self.text.as_ptr() as usize);
        if (self.byte..self.text.len()).contains(&byte) {
            let between = &self.text.as_bytes()[self.byte..byte];
            self.line += between.iter().filter(|&&byte| byte == b'\n').count();
            self.byte = byte;
        }
    }
}
