//! Power spectra from CSV and plain text.

mod error;
mod header;
mod layout;
mod options;
mod table;
mod unit;

pub use error::{Field, ReadError};
pub use header::Abscissa;
pub use options::ReadOptions;

use std::f64::consts::TAU;
use std::io::Read;

use csv::StringRecord;
use serde::Serialize;

use crate::psd::Psd;
use layout::{AbscissaColumn, Layout};
use table::Table;
use unit::parse_scaled;

/// How far the wavelengths of two columns may differ.
const AGREEMENT: f64 = 1e-3;

/// A power spectrum with what its file says about it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PsdFile {
    /// The spectrum.
    pub psd: Psd,
    /// The comment lines before the first row, without `#` and surrounding blanks.
    pub comments: Vec<String>,
    /// Assumptions made where the file is silent, a sentence each.
    pub notes: Vec<String>,
}

/// Reads a power spectrum from CSV (`,`, `;` or tab) or text with blanks between its columns, in UTF-8.
///
/// The columns go by their names, in any order and case: `wavelength` or `lambda`, `wavevector` or `q`,
/// `frequency` or `f`, and `c1d`, `psd` or `ciso`, each with its unit (`lambda_nm`, `q_rad_per_m`,
/// `PSD (µm³)`) or without in SI. Others are ignored. Wavelength counts before wavevector before frequency, and the others must agree with
/// it to 0.001; C1D counts before other spectra. A line `# Columns: ...` names the columns of a file without
/// a header. Lines that begin with `#` are comments.
///
/// # Errors
/// [`ReadError`], with line, column, value and bound, for the first thing that is wrong with the file.
pub fn read_psd(mut input: impl Read, options: &ReadOptions) -> Result<PsdFile, ReadError> {
    let mut bytes = Vec::new();
    input.read_to_end(&mut bytes)?;
    let table = Table::open(&bytes)?;
    let mut notes = Vec::new();
    let layout = Layout::of(&table, options, &mut notes)?;
    let (mut rows, series) = read_rows(&table, &layout)?;
    refuse_repeated_wavelengths(&mut rows)?;
    notes.extend(area_series_note(table.comments.iter().chain(&series)));
    let wavelengths_m = rows.iter().map(|row| row.wavelength_m).collect();
    let values = rows.iter().map(|row| row.value).collect();
    let psd = Psd::from_samples(wavelengths_m, values, layout.density.convention);
    Ok(PsdFile { psd, comments: table.comments, notes })
}

struct Row {
    line: usize,
    wavelength_m: f64,
    value: f64,
}

/// The rows and what they say about the series they belong to.
fn read_rows(table: &Table, layout: &Layout) -> Result<(Vec<Row>, Vec<String>), ReadError> {
    let mut lines = table.rows();
    let mut record = StringRecord::new();
    let mut last_line = table.first_line;
    if layout.has_header_row {
        lines.read(&mut record)?;
    }
    let mut first_series: Option<(usize, Vec<String>)> = None;
    let mut rows = Vec::new();
    while let Some(line) = lines.read(&mut record)? {
        let fields = Fields { line, record: &record, layout };
        fields.refuse_other_length()?;
        fields.refuse_other_series(&mut first_series)?;
        rows.push(fields.row()?);
        last_line = line;
    }
    if rows.len() < 2 {
        return Err(ReadError::TooFewRows { line: last_line, rows: rows.len() });
    }
    Ok((rows, first_series.map(|(_, labels)| labels).unwrap_or_default()))
}

/// Sorts the rows from long to short wavelengths.
fn refuse_repeated_wavelengths(rows: &mut [Row]) -> Result<(), ReadError> {
    // A stable sort: repetitions keep the order of their lines.
    rows.sort_by(|a, b| b.wavelength_m.total_cmp(&a.wavelength_m));
    let repeated = rows.windows(2).filter(|pair| pair[0].wavelength_m == pair[1].wavelength_m);
    match repeated.min_by_key(|pair| pair[1].line) {
        None => Ok(()),
        Some(pair) => Err(ReadError::RepeatedWavelength {
            line: pair[1].line,
            first_line: pair[0].line,
            wavelength_m: pair[1].wavelength_m,
        }),
    }
}

/// contact.engineering's series 'q/π × 2D PSD' comes in the unit of C1D but is another quantity.
fn area_series_note<'n>(mut names: impl Iterator<Item = &'n String>) -> Option<String> {
    let series = names.find(|name| name.contains("q/π × 2D PSD"))?;
    Some(format!(
        "the series '{series}' is q/pi times a two-dimensional spectrum, which is C1D only for a Hurst exponent \
         of 1/2"
    ))
}

/// One row of a file.
struct Fields<'f> {
    line: usize,
    record: &'f StringRecord,
    layout: &'f Layout,
}

impl Fields<'_> {
    fn refuse_other_length(&self) -> Result<(), ReadError> {
        let &Layout { ref names, names_line: first_line, .. } = self.layout;
        let (found, expected) = (self.record.len(), names.len());
        if found == expected {
            Ok(())
        } else {
            Err(ReadError::Ragged { line: self.line, found, first_line, expected })
        }
    }

    fn refuse_other_series(&self, first: &mut Option<(usize, Vec<String>)>) -> Result<(), ReadError> {
        let series = &self.layout.series;
        let (first_line, labels) = first.get_or_insert_with(|| {
            (self.line, series.iter().map(|&index| self.text(index).to_owned()).collect())
        });
        match series.iter().zip(labels).find(|(index, label)| self.text(**index) != label.as_str()) {
            None => Ok(()),
            Some((&index, label)) => Err(ReadError::SeveralSeries {
                line: self.line,
                first_line: *first_line,
                first: format!("'{label}'"),
                second: format!("{} '{}'", self.layout.names[index], self.text(index)),
            }),
        }
    }

    fn row(&self) -> Result<Row, ReadError> {
        let abscissa = &self.layout.abscissa;
        let wavelength_m = self.wavelength_m(abscissa)?;
        for check in &self.layout.checks {
            let ratio = wavelength_m / self.wavelength_m(check)?;
            if (ratio - 1.0).abs() > AGREEMENT {
                return Err(self.inconsistent(abscissa, check, ratio));
            }
        }
        let density = &self.layout.density;
        let value = self.positive(density.index, density.decimal_exponent)?;
        Ok(Row { line: self.line, wavelength_m, value })
    }

    fn wavelength_m(&self, column: &AbscissaColumn) -> Result<f64, ReadError> {
        let value = self.positive(column.index, column.decimal_exponent)?;
        self.in_range(column.index, column.quantity.wavelength_m(value))
    }

    /// The number in a column, in SI units.
    fn positive(&self, index: usize, decimal_exponent: i32) -> Result<f64, ReadError> {
        let text = self.text(index);
        match parse_scaled(text, decimal_exponent) {
            Some(value) => self.in_range(index, value),
            None if text.is_empty() => {
                Err(ReadError::EmptyField { line: self.line, column: self.name(index) })
            }
            None => Err(ReadError::NotANumber {
                line: self.line,
                column: self.name(index),
                text: text.to_owned(),
            }),
        }
    }

    fn in_range(&self, index: usize, value: f64) -> Result<f64, ReadError> {
        if value.is_finite() && value > 0.0 {
            return Ok(value);
        }
        Err(ReadError::OutOfRange {
            line: self.line,
            column: self.name(index),
            text: self.text(index).to_owned(),
        })
    }

    fn inconsistent(&self, first: &AbscissaColumn, second: &AbscissaColumn, ratio: f64) -> ReadError {
        let field = |index| Box::new(Field { column: self.name(index), text: self.text(index).to_owned() });
        ReadError::Inconsistent {
            line: self.line,
            first: field(first.index),
            second: field(second.index),
            ratio: six_digits(ratio),
            hint: two_pi_hint(second.quantity, ratio),
        }
    }

    fn text(&self, index: usize) -> &str {
        self.record.get(index).unwrap_or_default().trim()
    }

    fn name(&self, index: usize) -> String {
        self.layout.names[index].clone()
    }
}

/// A factor of 2 pi tells which quantity a mislabelled second column really holds.
fn two_pi_hint(second: Abscissa, ratio: f64) -> &'static str {
    let is_one = |factor: f64| (factor - 1.0).abs() <= AGREEMENT;
    match second {
        Abscissa::Wavevector if is_one(ratio * TAU) => {
            ": a factor of 2 pi, so the second holds the frequency 1/lambda, not the wavevector 2 pi/lambda"
        }
        Abscissa::Frequency if is_one(ratio / TAU) => {
            ": a factor of 2 pi, so the second holds the wavevector 2 pi/lambda, not the frequency 1/lambda"
        }
        _ if is_one(ratio * TAU) || is_one(ratio / TAU) => {
            ": a factor of 2 pi, as between wavevector and frequency"
        }
        _ => "",
    }
}

fn six_digits(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}
