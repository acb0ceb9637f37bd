//! The numbers of a text file, and how finely they are printed.

use crate::error::ScanReadError;
use crate::raster::Decoded;
use super::style::{Separator, is_gap, rows, shortened};

/// Rows of numbers of one length.
pub(crate) struct Columns {
    /// Number of columns, at least 1.
    pub(crate) count: usize,
    /// Row after row.
    pub(crate) values: Decoded,
    /// The first line of numbers.
    pub(crate) first_line: usize,
    pub(crate) separator: Separator,
    /// How the first two columns are printed; empty for matrices, where nobody asks.
    printed: [Precision; 2],
}

impl Columns {
    pub(crate) fn read(text: &str) -> Result<Self, ScanReadError> {
        let separator = Separator::of(text)?;
        let mut columns = Self {
            count: 0,
            values: Decoded::default(),
            first_line: 0,
            separator,
            printed: [Precision::default(); 2],
        };
        let mut decimals = Decimals::default();
        let mut scratch = String::new();
        for (line, row) in rows(text) {
            let start = columns.values.values.len();
            for (index, field) in separator.split(row).enumerate() {
                let field = decimals.with_point(field, line, &mut scratch)?;
                columns.values.push(number(field, line, index + 1)?);
                if let (true, Some(printed)) = (columns.count <= 3, columns.printed.get_mut(index)) {
                    printed.take(field);
                }
            }
            let found = columns.values.values.len() - start;
            if start == 0 {
                (columns.count, columns.first_line) = (found, line);
            } else if found != columns.count {
                let Self { first_line, count: expected, .. } = columns;
                return Err(ScanReadError::Ragged { line, found, first_line, expected });
            }
        }
        Ok(columns)
    }

    /// Number of rows.
    pub(crate) fn rows(&self) -> usize {
        self.values.values.len() / self.count
    }

    /// A column, from 0; 0 where a field marks a gap.
    pub(crate) fn column(&self, index: usize) -> impl Iterator<Item = f64> {
        self.values.values.iter().skip(index).step_by(self.count).copied()
    }

    /// A column that may have gaps, from 0.
    pub(crate) fn measured(&self, index: usize) -> impl Iterator<Item = Option<f64>> {
        let at = move |(row, value)| (!self.values.gaps.contains(row * self.count + index)).then_some(value);
        self.column(index).enumerate().map(at)
    }

    /// Refuses a column of positions that has gaps.
    pub(crate) fn refuse_gaps(&self, text: &str, column: usize) -> Result<(), ScanReadError> {
        match self.measured(column).position(|value| value.is_none()) {
            None => Ok(()),
            Some(row) => Err(ScanReadError::NotANumber {
                line: line_of_row(text, row),
                column: column + 1,
                text: "no position".to_owned(),
            }),
        }
    }

    /// How far two printed positions of a column may lie from evenly spaced ones: a unit of the last digit, since
    /// instruments round or cut off, and the rounding of the numbers themselves.
    pub(crate) fn rounding(&self, column: usize) -> f64 {
        let largest = self.column(column).fold(0.0, |largest: f64, value| largest.max(value.abs()));
        self.printed[column].last_digit(largest) * (1.0 + 1e-6) + 4.0 * f64::EPSILON * largest
    }
}

/// The line of a row, from 0.
pub(crate) fn line_of_row(text: &str, row: usize) -> usize {
    rows(text).nth(row).map_or(0, |(line, _)| line)
}

/// Which decimal mark a file uses, and since which line.
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

/// A number; nothing where the field marks a gap.
fn number(field: &str, line: usize, column: usize) -> Result<Option<f64>, ScanReadError> {
    match field.parse::<f64>() {
        Err(_) if !is_gap(field) && !field.is_empty() => {
            Err(ScanReadError::NotANumber { line, column, text: shortened(field) })
        }
        parsed => Ok(parsed.ok().filter(|value| value.is_finite())),
    }
}

/// Most decimals and most significant digits of printed numbers. The most, since trailing zeros may be left out.
#[derive(Clone, Copy, Default)]
struct Precision {
    /// 3 for `0.250`, 5 for `1.3381669e+02`, -2 for `1e2`.
    decimals: Option<i32>,
    digits: i32,
}

impl Precision {
    fn take(&mut self, field: &str) {
        let (mantissa, exponent) = match field.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, exponent.parse().unwrap_or(0)),
            None => (field, 0i32),
        };
        let length = |text: &str| i32::try_from(text.len()).unwrap_or(i32::MAX);
        let decimals =
            mantissa.split_once('.').map_or(0, |(_, decimals)| length(decimals)).saturating_sub(exponent);
        let significant = mantissa.trim_start_matches(['+', '-', '0', '.']);
        let digits = length(significant) - i32::from(significant.contains('.'));
        self.decimals = self.decimals.max(Some(decimals));
        self.digits = self.digits.max(digits);
    }

    /// The value of one in the last digit of numbers up to `largest`.
    fn last_digit(self, largest: f64) -> f64 {
        let Some(decimals) = self.decimals else { return 0.0 };
        let of_decimals = 10f64.powi(decimals.saturating_neg());
        if largest == 0.0 {
            return of_decimals;
        }
        of_decimals.max(10f64.powi(largest.log10().floor() as i32 + 1 - self.digits))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_digit_is_the_finest_printed() {
        for (fields, largest, digit) in [
            (&["0.000", "0.250", "12.500"][..], 12.5, 1e-3),
            (&["0", "0.5", "1.25"], 1.25, 1e-2),
            (&["1.3381669e+01", "2.0057210e+02"], 200.6, 1e-5),
            (&["0.123456", "123.456"], 123.5, 1e-3),
            (&["0", "5", "10"], 10.0, 1.0),
            (&["-5E-9", "1e-8"], 1e-8, 1e-8),
            (&["0", "1e99999999999"], 0.0, 1.0),
        ] {
            let mut printed = Precision::default();
            fields.iter().for_each(|field| printed.take(field));
            let found = printed.last_digit(largest);
            assert!((found / digit - 1.0).abs() < 1e-12, "{fields:?}: {found}");
        }
    }

    #[test]
    fn decimals_have_one_mark() {
        assert_eq!(Columns::read("0,5;1\n1,5;2").unwrap().values.values, [0.5, 1.0, 1.5, 2.0]);
        let mixed = Columns::read("0,5;1\n1.5;2").map(|columns| columns.count).unwrap_err();
        assert_eq!(
            mixed.to_string(),
            "line 2: '1.5' has a decimal point, line 1 a decimal comma; write all decimals with points"
        );
        assert!(matches!(
            Columns::read("1.234,5;1\n").map(|columns| columns.count),
            Err(ScanReadError::NotANumber { line: 1, column: 1, .. })
        ));
    }
}
