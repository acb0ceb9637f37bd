//! The rows of a series as numbers.

use std::f64::consts::TAU;

use crate::read::error::{Field, FieldProblem, LineProblem, ReadError};
use crate::read::header::Abscissa;
use crate::read::layout::{AbscissaColumn, Layout};
use crate::read::series::{ColumnKind, Row, Series};
use crate::samples::{falls, is_density, is_wavelength};
use units::UnitScale;

/// Largest relative difference of the wavelengths of two columns.
const AGREEMENT: f64 = 1e-3;

/// A sample with the line it comes from.
pub(crate) struct Sample {
    line: usize,
    pub(crate) wavelength_m: f64,
    pub(crate) value: f64,
    pub(crate) standard_error: Option<f64>,
}

/// Reads the samples of a series from long to short wavelengths, and counts rows without a value.
pub(crate) fn samples(series: &Series, layout: &Layout) -> Result<(Vec<Sample>, usize), ReadError> {
    let mut samples = Vec::new();
    let mut missing = 0;
    for (at, row) in series.rows.iter().enumerate() {
        let fields = Fields { at, row, series, layout };
        fields.refuse_other_length()?;
        if series.may_miss_values && fields.is_missing(layout.density.index) {
            missing += 1;
        } else {
            samples.push(fields.sample()?);
        }
    }
    if samples.len() < 2 {
        return Err(LineProblem::TooFewRows { rows: samples.len() }.at(series.last_line()));
    }
    refuse_repeated_wavelengths(&mut samples)?;
    Ok((samples, missing))
}

/// Sorts the rows from long to short wavelengths and refuses repeated ones.
fn refuse_repeated_wavelengths(rows: &mut [Sample]) -> Result<(), ReadError> {
    // A stable sort: repetitions keep the order of their lines.
    rows.sort_by(|a, b| b.wavelength_m.total_cmp(&a.wavelength_m));
    let repeated = rows.windows(2).filter(|pair| !falls(pair[0].wavelength_m, pair[1].wavelength_m));
    match repeated.min_by_key(|pair| pair[1].line) {
        None => Ok(()),
        Some(pair) => {
            let (first_line, wavelength_m) = (pair[0].line, pair[1].wavelength_m);
            Err(LineProblem::RepeatedWavelength { first_line, wavelength_m }.at(pair[1].line))
        }
    }
}

/// One row of a file.
struct Fields<'f> {
    /// Index in the series, from 0.
    at: usize,
    row: &'f Row,
    series: &'f Series,
    layout: &'f Layout,
}

impl Fields<'_> {
    fn refuse_other_length(&self) -> Result<(), ReadError> {
        let columns = &self.series.columns;
        let (first_line, found, expected) = (columns.line, self.row.fields.len(), columns.names.len());
        if found == expected {
            Ok(())
        } else {
            Err(LineProblem::Ragged { found, first_line, expected }.at(self.row.line))
        }
    }

    /// Returns true if a field is empty or NaN.
    fn is_missing(&self, index: usize) -> bool {
        let text = self.text(index);
        text.is_empty() || text.parse().is_ok_and(f64::is_nan)
    }

    fn sample(&self) -> Result<Sample, ReadError> {
        let abscissa = &self.layout.abscissa;
        let wavelength_m = self.wavelength_m(abscissa)?;
        for check in &self.layout.checks {
            let ratio = wavelength_m / self.wavelength_m(check)?;
            if (ratio - 1.0).abs() > AGREEMENT {
                return Err(self.inconsistent(abscissa, check, ratio));
            }
        }
        let density = &self.layout.density;
        let value = self.positive(density.index, density.scale)?;
        self.of_a_surface(density.index, is_density(value))?;
        let standard_error = self.standard_error()?;
        Ok(Sample { line: self.row.line, wavelength_m, value, standard_error })
    }

    /// Reads the standard error of the value; `None` if its field is empty or NaN.
    fn standard_error(&self) -> Result<Option<f64>, ReadError> {
        let Some(column) = self.layout.standard_error.filter(|column| !self.is_missing(column.index)) else {
            return Ok(None);
        };
        let error = self.number(column.index, column.scale)?;
        if error.is_finite() && error >= 0.0 {
            return Ok(Some(error));
        }
        Err(self.bad(column.index, FieldProblem::BadStandardError))
    }

    fn wavelength_m(&self, column: &AbscissaColumn) -> Result<f64, ReadError> {
        let value = self.positive(column.index, column.scale)?;
        let wavelength_m = self.in_range(column.index, column.quantity.wavelength_m(value))?;
        self.of_a_surface(column.index, is_wavelength(wavelength_m))?;
        Ok(wavelength_m)
    }

    fn positive(&self, index: usize, scale: UnitScale) -> Result<f64, ReadError> {
        self.in_range(index, self.number(index, scale)?)
    }

    /// Reads the number in a column, in SI units.
    fn number(&self, index: usize, scale: UnitScale) -> Result<f64, ReadError> {
        let text = self.text(index);
        match scale.read(text) {
            Some(value) => Ok(value),
            None if text.is_empty() => Err(LineProblem::EmptyField(self.name(index)).at(self.row.line)),
            None => Err(self.bad(index, FieldProblem::NotANumber)),
        }
    }

    fn in_range(&self, index: usize, value: f64) -> Result<f64, ReadError> {
        let is_admitted = value.is_finite() && value > 0.0;
        if is_admitted { Ok(value) } else { Err(self.bad(index, FieldProblem::OutOfRange)) }
    }

    /// Refuses a positive number that is too small or too large for any spectrum.
    fn of_a_surface(&self, index: usize, is_admitted: bool) -> Result<(), ReadError> {
        if is_admitted { Ok(()) } else { Err(self.bad(index, FieldProblem::Absurd)) }
    }

    /// Makes the error of a field.
    fn bad(&self, index: usize, problem: FieldProblem) -> ReadError {
        let (column, text) = (self.name(index), self.text(index).to_owned());
        LineProblem::BadField { column, text, problem }.at(self.row.line)
    }

    fn inconsistent(&self, first: &AbscissaColumn, second: &AbscissaColumn, ratio: f64) -> ReadError {
        let field = |index| Box::new(Field { column: self.name(index), text: self.text(index).to_owned() });
        let problem = LineProblem::Inconsistent {
            first: field(first.index),
            second: field(second.index),
            ratio: six_digits(ratio),
            hint: two_pi_hint(second.quantity, ratio),
        };
        problem.at(self.row.line)
    }

    fn text(&self, index: usize) -> &str {
        self.row.fields.get(index).unwrap_or_default().trim()
    }

    fn name(&self, index: usize) -> String {
        let name = &self.series.columns.names[index];
        match self.series.columns.kind {
            ColumnKind::Arrays { .. } => format!("{name}[{}]", self.at),
            _ => name.clone(),
        }
    }
}

/// Names the quantity that a mislabelled second column probably holds, by a factor of 2 pi.
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
