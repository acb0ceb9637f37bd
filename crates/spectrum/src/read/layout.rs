//! Which column of a file holds what, and in which unit and convention.

use crate::convention::Convention;
use crate::read::error::ReadError;
use crate::read::header::{Abscissa, DensityName, Heading, Quantity, trailing_unit};
use crate::read::nameless::nameless;
use crate::read::options::{GivenUnits, ReadOptions};
use crate::read::series::{ColumnKind, Columns};
use crate::read::unit::Unit;

/// How the rows of a series are to be read.
#[derive(Debug)]
pub(crate) struct Layout {
    /// The column the wavelengths come from.
    pub(crate) abscissa: AbscissaColumn,
    /// Columns that must agree with it.
    pub(crate) checks: Vec<AbscissaColumn>,
    pub(crate) density: DensityColumn,
    pub(crate) standard_error: Option<ErrorColumn>,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct AbscissaColumn {
    pub(crate) index: usize,
    pub(crate) quantity: Abscissa,
    pub(crate) decimal_exponent: i32,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct DensityColumn {
    pub(crate) index: usize,
    pub(crate) decimal_exponent: i32,
    pub(crate) convention: Convention,
}

/// The standard errors of the spectrum, in its convention.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ErrorColumn {
    pub(crate) index: usize,
    pub(crate) decimal_exponent: i32,
}

impl Layout {
    /// Finds the columns of a series, and notes what had to be assumed.
    pub(crate) fn of(
        columns: &Columns,
        options: &ReadOptions,
        units: &GivenUnits<'_>,
        notes: &mut Vec<String>,
    ) -> Result<Self, ReadError> {
        match columns.kind {
            ColumnKind::Named | ColumnKind::Arrays { named: true } => {
                Header { line: columns.line, names: &columns.names, options, units }.layout(notes)
            }
            ColumnKind::Numbered | ColumnKind::Arrays { named: false } => {
                nameless(columns, options, units, notes)
            }
        }
    }
}

/// The names of a file's columns and what the caller says about them.
struct Header<'h> {
    line: usize,
    names: &'h [String],
    options: &'h ReadOptions,
    units: &'h GivenUnits<'h>,
}

/// A column that could be the spectrum.
struct Candidate {
    name: Option<DensityName>,
    column: DensityColumn,
}

impl Header<'_> {
    fn layout(&self, notes: &mut Vec<String>) -> Result<Layout, ReadError> {
        let mut abscissae = self.abscissae(notes)?;
        let chosen = match self.options.x {
            Some(x) => {
                abscissae.iter().position(|column| column.quantity == x).ok_or_else(|| self.missing(x))?
            }
            None => 0,
        };
        let abscissa = abscissae.remove(chosen);
        let Candidate { name, column: density } = self.density(abscissa.quantity)?;
        self.refuse_other_units(abscissa, density)?;
        self.note_missing_units(abscissa, density, notes);
        if let Some(name) = name
            && self.options.convention.is_none()
        {
            notes.extend(self.convention_note(name, density, abscissa.quantity));
        }
        let standard_error = name.and_then(|name| self.standard_error(name, density, notes));
        Ok(Layout { abscissa, checks: abscissae, density, standard_error })
    }

    /// The columns of wavelength, wavevector and frequency, in this order; at least one.
    fn abscissae(&self, notes: &mut Vec<String>) -> Result<Vec<AbscissaColumn>, ReadError> {
        let mut columns: Vec<AbscissaColumn> = Vec::new();
        let mut unfit = None;
        for (index, heading) in self.headings() {
            let Quantity::Abscissa(quantity) = heading.quantity else { continue };
            match self.abscissa_unit(index, quantity, heading.unit) {
                Err(error) => unfit = unfit.or(Some((index, error))),
                Ok(unit) => match columns.iter().find(|column| column.quantity == quantity) {
                    Some(first) => return Err(self.duplicate(quantity.name(), first.index, index)),
                    None => {
                        let decimal_exponent = unit.decimal_exponent;
                        columns.push(AbscissaColumn { index, quantity, decimal_exponent });
                    }
                },
            }
        }
        if columns.is_empty() {
            return Err(unfit.map_or_else(|| self.missing_abscissa(), |(_, error)| error));
        }
        if let Some((index, _)) = unfit {
            notes.push(format!(
                "column '{}' is not looked at: its unit is none of its quantity's",
                self.names[index]
            ));
        }
        columns.sort_by_key(|column| column.quantity as u8);
        Ok(columns)
    }

    fn abscissa_unit(&self, index: usize, quantity: Abscissa, unit: Option<&str>) -> Result<Unit, ReadError> {
        let given = self.units.x.filter(|given| quantity.fits(given.unit));
        let Some(text) = unit else { return Ok(given.map_or(quantity.si(), |given| given.unit)) };
        Unit::parse(text).filter(|&unit| quantity.fits(unit)).ok_or_else(|| ReadError::BadUnit {
            line: self.line,
            column: self.names[index].clone(),
            unit: text.to_owned(),
            quantity: quantity.name().to_owned(),
            accepted: match quantity {
                Abscissa::Wavelength => "m, cm, mm, um, nm, pm, angstrom",
                Abscissa::Wavevector => "rad/m or 1/m, and the same with cm, mm, um, nm, pm, angstrom",
                Abscissa::Frequency => "1/m, 1/cm, 1/mm, 1/um, 1/nm, 1/pm, 1/angstrom",
            }
            .to_owned(),
        })
    }

    /// The column of the spectrum: the one asked for, else the only one, else C1D.
    fn density(&self, abscissa: Abscissa) -> Result<Candidate, ReadError> {
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
                Err(self.duplicate("spectrum", first.column.index, second.column.index))
            }
            several => Err(ReadError::SeveralDensities {
                line: self.line,
                found: several.iter().map(|candidate| self.names[candidate.column.index].clone()).collect(),
            }),
        }
    }

    /// The column of exactly this name, or else of this name in any case.
    fn density_named(&self, column: &str, abscissa: Abscissa) -> Result<Candidate, ReadError> {
        let matching = |is_match: fn(&str, &str) -> bool| -> Vec<usize> {
            (0..self.names.len()).filter(|&index| is_match(&self.names[index], column)).collect()
        };
        let mut found = matching(|name, column| name == column);
        if found.is_empty() {
            found = matching(|name, column| name.to_lowercase() == column.to_lowercase());
        }
        match found[..] {
            [] => Err(ReadError::UnknownColumn {
                line: self.line,
                column: column.to_owned(),
                found: self.names.to_vec(),
            }),
            [index] => match Heading::parse(&self.names[index]) {
                Some(Heading { quantity: Quantity::Density(name), unit }) => {
                    self.recognised_density(index, name, unit, abscissa)
                }
                _ => self.unrecognised_density(index),
            },
            [first, second, ..] => Err(self.duplicate("spectrum", first, second)),
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
            (None, DensityName::Psd) if parsed.is_some_and(|unit| unit.metre_power == 4) => {
                return Err(ReadError::AmbiguousDensity { line, column: column.clone() });
            }
            (None, DensityName::Psd) if abscissa == Abscissa::Frequency => Convention::Frequency,
            (None, DensityName::Psd) => Convention::C1D,
        };
        let si = Unit::si(convention.metre_power());
        let unit = match unit {
            None => si,
            Some(text) => parsed
                .filter(|unit| unit.metre_power == si.metre_power)
                .ok_or_else(|| ReadError::bad_density_unit(line, column, text, convention))?,
        };
        let decimal_exponent = unit.decimal_exponent;
        Ok(Candidate { name: Some(name), column: DensityColumn { index, decimal_exponent, convention } })
    }

    fn unrecognised_density(&self, index: usize) -> Result<Candidate, ReadError> {
        let (line, column) = (self.line, &self.names[index]);
        let Some(convention) = self.options.convention else {
            return Err(ReadError::NoConvention { line, column: column.clone() });
        };
        let given = self.units.psd.map(|given| given.unit);
        let unit = trailing_unit(column).or(given).unwrap_or(Unit::si(convention.metre_power()));
        if unit.metre_power != convention.metre_power() {
            let unit = format!("m^{}", unit.metre_power);
            return Err(ReadError::bad_density_unit(line, column, &unit, convention));
        }
        let decimal_exponent = unit.decimal_exponent;
        Ok(Candidate { name: None, column: DensityColumn { index, decimal_exponent, convention } })
    }

    fn headings(&self) -> impl Iterator<Item = (usize, Heading<'_>)> {
        self.names.iter().enumerate().filter_map(|(index, name)| Some((index, Heading::parse(name)?)))
    }

    /// The standard errors of the spectrum of this name, in the unit of the same dimension.
    fn standard_error(
        &self,
        name: DensityName,
        density: DensityColumn,
        notes: &mut Vec<String>,
    ) -> Option<ErrorColumn> {
        let is_meant =
            |(_, heading): &(usize, Heading<'_>)| heading.quantity == Quantity::StandardError(name);
        let (index, heading) = self.headings().find(is_meant)?;
        let unit = match heading.unit {
            None => self
                .units
                .psd
                .map_or(Some(Unit::si(density.convention.metre_power())), |given| Some(given.unit)),
            Some(text) => Unit::parse(text),
        };
        let fitting = unit.filter(|unit| unit.metre_power == density.convention.metre_power());
        if fitting.is_none() {
            notes.push(format!(
                "column '{}' is not looked at: its unit is none of its quantity's",
                self.names[index]
            ));
        }
        Some(ErrorColumn { index, decimal_exponent: fitting?.decimal_exponent })
    }

    /// The unit in the name of a column.
    fn stated_unit(&self, index: usize) -> Option<Unit> {
        let name = &self.names[index];
        match Heading::parse(name) {
            Some(heading) => heading.unit.and_then(Unit::parse),
            None => trailing_unit(name),
        }
    }

    fn refuse_other_units(&self, abscissa: AbscissaColumn, density: DensityColumn) -> Result<(), ReadError> {
        for (index, given) in [(abscissa.index, self.units.x), (density.index, self.units.psd)] {
            if let Some(given) = given {
                given.refuse_other(self.stated_unit(index), self.line, &self.names[index])?;
            }
        }
        let bare = self.stated_unit(abscissa.index).is_none();
        match self.units.x.filter(|given| bare && !abscissa.quantity.fits(given.unit)) {
            Some(given) => {
                self.abscissa_unit(abscissa.index, abscissa.quantity, Some(given.text)).map(|_| ())
            }
            None => Ok(()),
        }
    }

    fn note_missing_units(&self, abscissa: AbscissaColumn, density: DensityColumn, notes: &mut Vec<String>) {
        for (index, given) in [(abscissa.index, self.units.x), (density.index, self.units.psd)] {
            if given.is_none() && self.stated_unit(index).is_none() {
                notes.push(format!("column '{}' states no unit and is read in SI units", self.names[index]));
            }
        }
    }

    /// What a name does not say by itself.
    fn convention_note(
        &self,
        name: DensityName,
        density: DensityColumn,
        abscissa: Abscissa,
    ) -> Option<String> {
        let column = &self.names[density.index];
        match (name, density.convention) {
            (DensityName::Psd, Convention::Frequency) => Some(format!(
                "column '{column}' stands against {abscissa} and is read as the one-sided spectrum S of frequency, \
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
            (DensityName::C1d | DensityName::W1 | DensityName::Ciso, _) => None,
        }
    }

    fn missing(&self, abscissa: Abscissa) -> ReadError {
        let accepted = match abscissa {
            Abscissa::Wavelength => "wavelength, lambda",
            Abscissa::Wavevector => "wavevector, q",
            Abscissa::Frequency => "frequency, f",
        };
        self.missing_column(abscissa.name(), accepted)
    }

    fn missing_abscissa(&self) -> ReadError {
        self.missing_column("wavelength", "wavelength or lambda, wavevector or q, frequency or f")
    }

    fn missing_density(&self) -> ReadError {
        self.missing_column("spectrum", "c1d, psd or ciso; any other name with --column NAME")
    }

    fn missing_column(&self, quantity: &'static str, accepted: &'static str) -> ReadError {
        ReadError::MissingColumn { line: self.line, quantity, accepted, found: self.names.to_vec() }
    }

    fn duplicate(&self, quantity: &'static str, first: usize, second: usize) -> ReadError {
        let (first, second) = (self.names[first].clone(), self.names[second].clone());
        ReadError::DuplicateColumn { line: self.line, quantity, first, second }
    }
}
