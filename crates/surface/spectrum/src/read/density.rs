//! Choice of the columns of the spectrum and its standard errors, with unit and convention.

use crate::convention::Convention;
use crate::read::error::{LineProblem, ReadError, SPECTRUM};
use crate::read::header::{Abscissa, DensityName, Heading, Quantity, trailing_unit};
use crate::read::layout::{DensityColumn, ErrorColumn};
use crate::read::names::Header;
use crate::read::unit::Unit;

/// A column that could be the spectrum.
pub(crate) struct Candidate {
    pub(crate) name: Option<DensityName>,
    pub(crate) column: DensityColumn,
}

impl Header<'_> {
    /// Chooses the column of the spectrum: the requested one, else the only one, else C1D.
    pub(crate) fn density(&self, abscissa: Abscissa) -> Result<Candidate, ReadError> {
        if let Some(column) = &self.options.column {
            return self.density_named(column, abscissa);
        }
        let mut fitting = Vec::new();
        let mut unfit = None;
        for (index, heading) in self.headings() {
            let Quantity::Density(name) = heading.quantity else { continue };
            match self.recognised_density(index, name, heading.unit, abscissa) {
                Ok(candidate) => fitting.push(candidate),
                Err(error) => unfit = unfit.or(Some(error)),
            }
        }
        let asked_for = match self.options.convention {
            Some(Convention::Ciso) => DensityName::Ciso,
            Some(Convention::Persson) => DensityName::C,
            Some(Convention::W1) => DensityName::W1,
            _ => DensityName::C1d,
        };
        let is_present = |name: &DensityName| fitting.iter().any(|candidate| candidate.name == Some(*name));
        if let Some(preferred) = [asked_for, DensityName::C1d].into_iter().find(is_present) {
            fitting.retain(|candidate| candidate.name == Some(preferred));
        }
        match &fitting[..] {
            [] => Err(unfit.unwrap_or_else(|| self.missing_density())),
            [_] => Ok(fitting.remove(0)),
            [first, second, ..] if first.name == second.name => {
                Err(self.duplicate(SPECTRUM, first.column.index, second.column.index))
            }
            several => {
                let found = several.iter().map(|candidate| self.names[candidate.column.index].clone());
                Err(LineProblem::SeveralDensities { found: found.collect() }.at(self.line))
            }
        }
    }

    /// Finds the column of exactly this name, else of this name in any case.
    fn density_named(&self, column: &str, abscissa: Abscissa) -> Result<Candidate, ReadError> {
        let matching = |is_match: fn(&str, &str) -> bool| -> Vec<usize> {
            (0..self.names.len()).filter(|&index| is_match(&self.names[index], column)).collect()
        };
        let mut found = matching(|name, column| name == column);
        if found.is_empty() {
            found = matching(|name, column| name.to_lowercase() == column.to_lowercase());
        }
        match found[..] {
            [] => {
                let (column, found) = (column.to_owned(), self.names.to_vec());
                Err(LineProblem::UnknownColumn { column, found }.at(self.line))
            }
            [index] => match Heading::parse(&self.names[index]) {
                Some(Heading { quantity: Quantity::Density(name), unit }) => {
                    self.recognised_density(index, name, unit, abscissa)
                }
                _ => self.unrecognised_density(index),
            },
            [first, second, ..] => Err(self.duplicate(SPECTRUM, first, second)),
        }
    }

    fn recognised_density(
        &self,
        index: usize,
        name: DensityName,
        unit: Option<&str>,
        abscissa: Abscissa,
    ) -> Result<Candidate, ReadError> {
        let (line, column) = (self.line, &self.names[index]);
        let unit = unit.or(self.units.psd.map(|given| given.text));
        let parsed = unit.and_then(Unit::parse);
        let convention = match (self.options.convention, name) {
            (Some(convention), _) => convention,
            (None, DensityName::C1d) => Convention::C1D,
            (None, DensityName::W1 | DensityName::Psdf) => Convention::W1,
            (None, DensityName::Ciso) => Convention::Ciso,
            (None, DensityName::C) => Convention::Persson,
            (None, DensityName::Psd | DensityName::C2d)
                if parsed.is_some_and(|unit| unit.metre_power == 4) =>
            {
                return Err(LineProblem::AmbiguousDensity(column.clone()).at(line));
            }
            (None, DensityName::C2d) if parsed.is_some_and(|unit| unit.metre_power == 3) => {
                return Err(LineProblem::TwoDimensionalInCubicMetres(column.clone()).at(line));
            }
            (None, DensityName::C2d) => return Err(LineProblem::NoConvention(column.clone()).at(line)),
            (None, DensityName::Psd) if abscissa == Abscissa::Frequency => Convention::Frequency,
            (None, DensityName::Psd) => Convention::C1D,
        };
        let si = Unit::si(convention.metre_power());
        let unit = match unit {
            None => si,
            Some(text) => parsed
                .filter(|unit| unit.metre_power == si.metre_power)
                .ok_or_else(|| LineProblem::bad_density_unit(column, text, convention).at(line))?,
        };
        let scale = unit.scale();
        Ok(Candidate { name: Some(name), column: DensityColumn { index, scale, convention } })
    }

    fn unrecognised_density(&self, index: usize) -> Result<Candidate, ReadError> {
        let (line, column) = (self.line, &self.names[index]);
        let Some(convention) = self.options.convention else {
            return Err(LineProblem::NoConvention(column.clone()).at(line));
        };
        let given = self.units.psd.map(|given| given.unit);
        let unit = trailing_unit(column).or(given).unwrap_or(Unit::si(convention.metre_power()));
        if unit.metre_power != convention.metre_power() {
            let unit = format!("m^{}", unit.metre_power);
            return Err(LineProblem::bad_density_unit(column, &unit, convention).at(line));
        }
        let scale = unit.scale();
        Ok(Candidate { name: None, column: DensityColumn { index, scale, convention } })
    }

    /// Finds the standard errors of the spectrum; without a unit they are in that of the spectrum.
    pub(crate) fn standard_error(
        &self,
        name: DensityName,
        density: DensityColumn,
        notes: &mut Vec<String>,
    ) -> Option<ErrorColumn> {
        let is_meant =
            |(_, heading): &(usize, Heading<'_>)| heading.quantity == Quantity::StandardError(name);
        let (index, heading) = self.headings().find(is_meant)?;
        let Some(text) = heading.unit else {
            return Some(ErrorColumn { index, scale: density.scale });
        };
        let fitting = Unit::parse(text).filter(|unit| unit.metre_power == density.convention.metre_power());
        if fitting.is_none() {
            notes.push(format!(
                "column '{}' is ignored: its unit does not fit its quantity",
                self.names[index]
            ));
        }
        Some(ErrorColumn { index, scale: fitting?.scale() })
    }

    /// Describes the convention that was assumed for a name that does not state it.
    pub(crate) fn convention_note(
        &self,
        name: DensityName,
        density: DensityColumn,
        abscissa: Abscissa,
    ) -> Option<String> {
        let column = &self.names[density.index];
        match (name, density.convention) {
            (DensityName::Psd, Convention::Frequency) => Some(format!(
                "column '{column}' is given against {abscissa} and is read as the one-sided spectrum S of frequency, \
                 sigma^2 = Int S df"
            )),
            (DensityName::Psd, _) => Some(format!(
                "column '{column}' states no convention and is read as C1D, sigma^2 = (1/pi) Int C dq"
            )),
            (DensityName::Psdf, _) => {
                Some(format!("column '{column}' is named as by Gwyddion and read as W1, sigma^2 = Int W dq"))
            }
            (DensityName::C, _) => {
                Some(format!("column '{column}' is read as Persson's C, sigma^2 = 2 pi Int q C dq"))
            }
            (DensityName::C1d | DensityName::W1 | DensityName::Ciso | DensityName::C2d, _) => None,
        }
    }

    fn missing_density(&self) -> ReadError {
        self.missing_column(SPECTRUM, "c1d, psd or ciso")
    }
}
