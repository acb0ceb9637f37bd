//! The numbers of a text file, and how finely they are printed.

use std::ops::Range;

use super::body::Body;
use super::precision::Precision;
use super::separator::Separator;
use super::style::{is_missing, shortened};
use super::thousands::Thousands;
use crate::error::ScanReadError;
use crate::raster::Decoded;
use units::LengthUnit;

/// Most columns of a table, all of which may hold positions.
const NARROW: usize = 16;

/// Rows of numbers of one length.
pub(crate) struct Columns {
    /// Number of columns, at least 1.
    pub(crate) count: usize,
    /// Row after row.
    pub(crate) values: Decoded,
    /// The first line of numbers.
    pub(crate) first_line: usize,
    pub(crate) separator: Separator,
    /// Note on commas before three digits.
    pub(super) comma_note: Option<String>,
    /// Most fields of a line.
    fields: usize,
    /// Most decimals of the last numbers of all rows but the last, and those of the last.
    last_decimals: (usize, usize),
    /// The fields of a line that are columns; those outside are empty in every row.
    used: Range<usize>,
    /// Precision of the columns; of a wide matrix that of the first alone.
    printed: Vec<Precision>,
}

impl Columns {
    pub(super) fn read(body: &Body<'_>) -> Result<Self, ScanReadError> {
        let separator = Separator::recognise(body)?;
        let (first_line, used, fields) = used_fields(body, separator)?;
        let mut columns = Self {
            count: used.len(),
            values: Decoded::default(),
            first_line,
            separator,
            used: used.clone(),
            comma_note: None,
            fields,
            last_decimals: (0, 0),
            printed: vec![Precision::default(); if used.len() <= NARROW { used.len() } else { 1 }],
        };
        let mut decimals = Decimals::default();
        let mut thousands = vec![Thousands::default(); columns.printed.len()];
        let mut scratch = String::new();
        for (line, row) in lines(body, separator, used.end) {
            let mut last = 0;
            for (index, field) in separator.split(row).skip(used.start).take(used.len()).enumerate() {
                // Of a wide matrix all columns are written alike.
                let written = index.min(thousands.len() - 1);
                thousands[written].take(field, line);
                let field = decimals.with_point(field, line, &mut scratch)?;
                last = field.split_once('.').map_or(0, |(_, decimals)| decimals.len());
                columns.values.push(number(field, line, used.start + index + 1)?);
                if let Some(printed) = columns.printed.get_mut(index) {
                    printed.take(field);
                }
            }
            columns.last_decimals = (columns.last_decimals.0.max(columns.last_decimals.1), last);
        }
        thousands.iter().try_for_each(Thousands::refuse)?;
        columns.comma_note = thousands.iter().find_map(Thousands::note);
        Ok(columns)
    }

    /// The fields of a line of the header, as many as there are columns; none where it has more or fewer.
    pub(crate) fn fields_of<'l>(&self, line: &'l str) -> Option<Vec<&'l str>> {
        let mut fields: Vec<&str> = self.separator.split(line).skip(self.used.start).collect();
        while fields.len() > self.count && fields.last().is_some_and(|field| field.is_empty()) {
            fields.pop();
        }
        (fields.len() == self.count).then_some(fields)
    }

    /// The numbers of a single column as they are written, with their lines.
    pub(super) fn as_written<'t>(&self, body: &Body<'t>) -> Vec<(usize, &'t str)> {
        let field = |row: &'t str| self.separator.split(row).nth(self.used.start).unwrap_or_default();
        let fields = lines(body, self.separator, self.used.end).map(|(line, row)| (line, field(row)));
        fields.filter(|(_, field)| !is_missing(field) && !field.is_empty()).collect()
    }

    /// Refuses words in the line right above the numbers where all else in it is written as in a row.
    pub(super) fn refuse_words(&self, body: &Body<'_>) -> Result<(), ScanReadError> {
        let Some((line, text)) = body.line_above() else { return Ok(()) };
        let fields: Vec<&str> = self.separator.split(text).skip(self.used.start).take(self.count).collect();
        let is_number = |field: &&str| field.parse::<f64>().is_ok();
        let numbers = fields.iter().filter(|field| is_number(field)).count();
        let is_row = fields.len() == self.count
            && 2 * numbers >= self.count
            && (fields.first().is_some_and(is_number) || self.count > 3);
        let word = fields.iter().position(|field| {
            !is_number(field)
                && !field.is_empty()
                && !is_missing(field)
                && LengthUnit::parse_instrument(field).is_none()
        });
        match word.filter(|_| is_row && self.count > 1) {
            None => Ok(()),
            Some(column) => Err(ScanReadError::NotANumber {
                line,
                column: self.used.start + column + 1,
                text: shortened(fields[column]),
            }),
        }
    }

    /// Notes empty columns at the edges of a map, which may be gaps.
    pub(super) fn edge_note(&self) -> Option<String> {
        let dropped = self.used.start + self.fields.saturating_sub(self.used.end + 1);
        (self.count > 3 && dropped > 0).then(|| {
            format!("{dropped} empty columns at the edges are left out: if they are gaps, write nan in them")
        })
    }

    /// Returns true if the last number has fewer decimals than those above it, as one that is cut off has.
    pub(super) fn ends_shorter(&self) -> bool {
        self.last_decimals.1 < self.last_decimals.0
    }

    /// The number in a row and a column, where there is one.
    pub(super) fn at(&self, row: usize, column: usize) -> Option<f64> {
        let index = row * self.count + column;
        self.values.values.get(index).copied().filter(|_| !self.values.missing.contains(index))
    }

    /// Drops the first row, the first column, or both.
    pub(super) fn drop_edges(&mut self, row: bool, column: bool) {
        let (from_row, from_column) = (usize::from(row), usize::from(column));
        let kept = (from_row..self.rows())
            .flat_map(|row| (from_column..self.count).map(move |column| (row, column)));
        let values: Decoded = kept.map(|(row, column)| self.at(row, column)).collect();
        self.values = values;
        self.count -= from_column;
        self.used.start += from_column;
    }

    /// Number of rows.
    pub(crate) fn rows(&self) -> usize {
        self.values.values.len() / self.count
    }

    /// A column, from 0; 0 where a field marks a missing point.
    pub(crate) fn column(&self, index: usize) -> impl Iterator<Item = f64> + Clone {
        self.values.values.iter().skip(index).step_by(self.count).copied()
    }

    /// A column that may have missing points, from 0.
    pub(crate) fn measured(&self, index: usize) -> impl Iterator<Item = Option<f64>> + Clone {
        let at =
            move |(row, value)| (!self.values.missing.contains(row * self.count + index)).then_some(value);
        self.column(index).enumerate().map(at)
    }

    /// Takes away the points of the value that marks missing ones.
    pub(super) fn mark_missing(&mut self, no_data: f64) {
        for index in 0..self.values.values.len() {
            if self.values.values[index] == no_data {
                self.values.set_missing(index);
            }
        }
    }

    /// Refuses rows that have a height but no position in this column.
    pub(super) fn refuse_missing_points(
        &self,
        body: &Body<'_>,
        column: usize,
        height: usize,
    ) -> Result<(), ScanReadError> {
        let mut points = self.measured(column).zip(self.measured(height));
        match points.position(|(position, height)| position.is_none() && height.is_some()) {
            None => Ok(()),
            Some(row) => Err(ScanReadError::NotANumber {
                line: self.line_of_row(body, row),
                column: self.used.start + column + 1,
                text: "no position".to_owned(),
            }),
        }
    }

    /// The line of a row, from 0.
    pub(super) fn line_of_row(&self, body: &Body<'_>, row: usize) -> usize {
        lines(body, self.separator, self.used.end).nth(row).map_or(0, |(line, _)| line)
    }

    /// Largest distance of two printed positions of a column from evenly spaced ones: a unit of the last digit, since
    /// instruments round or cut off, and the rounding of the numbers themselves.
    pub(crate) fn rounding(&self, column: usize) -> f64 {
        let largest = self.column(column).fold(0.0, |largest: f64, value| largest.max(value.abs()));
        self.printed.get(column).map_or(0.0, |printed| printed.last_digit(largest)) * (1.0 + 1e-6)
            + 4.0 * f64::EPSILON * largest
    }
}

/// The first line of numbers, which fields of the lines are columns, and how many it has: columns go from the first to the last that is not empty
/// in every line, since instruments open and close lines with separators.
///
/// Every line must have all of them, but for lines of separators alone, which may have fewer.
fn used_fields(body: &Body<'_>, separator: Separator) -> Result<(usize, Range<usize>, usize), ScanReadError> {
    let rows = || {
        body.whole_rows(separator == Separator::Tab)
            .map(|(line, row)| (line, Extent::measure(separator, row)))
    };
    let (first_line, first) = rows().next().ok_or(ScanReadError::NoRows)?;
    let mut used = first.filled.clone();
    let mut fewest = first.fields;
    for (line, row) in rows().filter(|(_, row)| !row.filled.is_empty()) {
        if used.is_empty() {
            used = row.filled.clone();
        }
        used = used.start.min(row.filled.start)..used.end.max(row.filled.end);
        fewest = fewest.min(row.fields);
        if row.filled.end > first.fields {
            let expected = first.filled.end;
            return Err(ScanReadError::Ragged { line, found: row.filled.end, first_line, expected });
        }
    }
    let is_short = |(_, row): &(usize, Extent)| row.fields < used.end && !row.filled.is_empty();
    // Lines are gone through again only where one of them is known to be too short.
    let short = (fewest < used.end).then(|| rows().find(is_short)).flatten();
    match short {
        None => Ok((first_line, used, first.fields)),
        Some((line, row)) => {
            let expected = used.len();
            let found = row.fields.saturating_sub(used.start);
            Err(ScanReadError::Ragged { line, found, first_line, expected })
        }
    }
}

/// The fields of a line.
struct Extent {
    fields: usize,
    /// From the first to the last that is not empty.
    filled: Range<usize>,
}

impl Extent {
    fn measure(separator: Separator, line: &str) -> Self {
        let (mut fields, mut filled) = (0, 0..0);
        for field in separator.split(line) {
            if !field.is_empty() {
                let start = if filled.is_empty() { fields } else { filled.start };
                filled = start..fields + 1;
            }
            fields += 1;
        }
        Self { fields, filled }
    }
}

/// The lines of the rows; those of separators alone that are too short for one separate nothing.
fn lines<'t>(body: &Body<'t>, separator: Separator, fields: usize) -> impl Iterator<Item = (usize, &'t str)> {
    // A line of numbers has them all, which was looked at: only one that begins with a separator may have too few.
    let is_whole = move |row: &str| {
        let begins_with_number =
            row.starts_with(|first: char| first.is_ascii_digit() || "+-.".contains(first));
        begins_with_number || separator.split(row).count() >= fields
    };
    body.whole_rows(separator == Separator::Tab).filter(move |(_, row)| is_whole(row))
}

/// Decimal mark of a file, and the line that shows it.
#[derive(Default)]
struct Decimals {
    mark: Option<(bool, usize)>,
}

impl Decimals {
    /// The field with a decimal point; commas left in a field are decimal ones.
    fn with_point<'f>(
        &mut self,
        field: &'f str,
        line: usize,
        scratch: &'f mut String,
    ) -> Result<&'f str, ScanReadError> {
        let is_comma = field.contains(',');
        if !is_comma && !field.contains('.') {
            return Ok(field);
        }
        match self.mark {
            Some((first, first_line)) if first != is_comma => {
                return Err(ScanReadError::MixedDecimals {
                    line,
                    text: shortened(field),
                    is_comma,
                    first_line,
                });
            }
            _ => self.mark = self.mark.or(Some((is_comma, line))),
        }
        if !is_comma {
            return Ok(field);
        }
        scratch.clear();
        scratch.extend(field.chars().map(|character| if character == ',' { '.' } else { character }));
        Ok(scratch)
    }
}

/// A number; nothing where the field marks a missing point.
fn number(field: &str, line: usize, column: usize) -> Result<Option<f64>, ScanReadError> {
    match field.parse::<f64>() {
        Err(_) if !is_missing(field) && !field.is_empty() => {
            Err(ScanReadError::NotANumber { line, column, text: shortened(field) })
        }
        parsed => Ok(parsed.ok().filter(|value| value.is_finite())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_have_one_mark() {
        let read = |text| Columns::read(&Body::find(text).unwrap());
        assert_eq!(read("0,5;1\n1,5;2").unwrap().values.values, [0.5, 1.0, 1.5, 2.0]);
        let mixed = read("0,5;1\n1.5;2").map(|columns| columns.count).unwrap_err();
        let is_found =
            matches!(mixed, ScanReadError::MixedDecimals { line: 2, is_comma: false, first_line: 1, .. });
        assert!(is_found, "{mixed}");
        assert!(matches!(
            read("1.234,5;1\n").map(|columns| columns.count),
            Err(ScanReadError::NotANumber { line: 1, column: 1, .. })
        ));
    }
}
