//! Which column of a file holds what, and in which unit and convention.

use crate::convention::Convention;
use crate::read::error::ReadError;
use crate::read::header::{Abscissa, DensityName, Heading, Quantity, trailing_unit};
use crate::read::options::ReadOptions;
use crate::read::table::Table;
use crate::read::unit::Unit;

/// Columns that tell one series of an export from another.
const SERIES_COLUMNS: [&str; 4] = ["series", "data series", "subject", "subject name"];

/// How the rows of a file are to be read.
#[derive(Debug)]
pub(crate) struct Layout {
    /// Names of all columns, or their numbers.
    pub(crate) names: Vec<String>,
    /// The line in which they stand, or the first row.
    pub(crate) names_line: usize,
    /// The column the wavelengths come from.
    pub(crate) abscissa: AbscissaColumn,
    /// Columns that must agree with it.
    pub(crate) checks: Vec<AbscissaColumn>,
    pub(crate) density: DensityColumn,
    /// Columns in which every row must say the same.
    pub(crate) series: Vec<usize>,
    /// Whether the first row of the file holds names.
    pub(crate) has_header_row: bool,
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

impl Layout {
    /// Finds the columns of a file, and notes what had to be assumed.
    pub(crate) fn of(
        table: &Table,
        options: &ReadOptions,
        notes: &mut Vec<String>,
    ) -> Result<Self, ReadError> {
        if !table.is_headerless() {
            let header = Header { line: table.first_line, names: &table.first_row, options };
            return header.layout(true, notes);
        }
        match table.column_comments()[..] {
            [] => headerless(table, options),
            [(line, text)] => {
                let names: Vec<String> = text.split(',').map(|name| name.trim().to_owned()).collect();
                Header { line, names: &names, options }.layout(false, notes)
            }
            [(first_line, first), (line, second), ..] => Err(ReadError::SeveralSeries {
                line,
                first_line,
                first: format!("Columns: {first}"),
                second: format!("Columns: {second}"),
            }),
        }
    }
}

fn headerless(table: &Table, options: &ReadOptions) -> Result<Layout, ReadError> {
    let line = table.first_line;
    let columns = table.first_row.len();
    if let Some(column) = &options.column {
        return Err(ReadError::UnknownColumn { line, column: column.clone(), found: numbers(columns) });
    }
    let (Some(quantity), Some(convention)) = (options.x, options.convention) else {
        return Err(ReadError::NoHeader { line });
    };
    if columns != 2 {
        return Err(ReadError::HeaderlessColumns { line, columns });
    }
    Ok(Layout {
        names: numbers(2),
        names_line: line,
        abscissa: AbscissaColumn { index: 0, quantity, decimal_exponent: 0 },
        checks: Vec::new(),
        density: DensityColumn { index: 1, decimal_exponent: 0, convention },
        series: Vec::new(),
        has_header_row: false,
    })
}

fn numbers(columns: usize) -> Vec<String> {
    (1..=columns).map(|number| number.to_string()).collect()
}

/// The names of a file's columns and what the caller says about them.
struct Header<'h> {
    line: usize,
    names: &'h [String],
    options: &'h ReadOptions,
}

/// A column that could be the spectrum.
struct Candidate {
    name: Option<DensityName>,
    column: DensityColumn,
}

impl Header<'_> {
    fn layout(&self, has_header_row: bool, notes: &mut Vec<String>) -> Result<Layout, ReadError> {
        let mut abscissae = self.abscissae(notes)?;
        let chosen = match self.options.x {
            Some(x) => {
                abscissae.iter().position(|column| column.quantity == x).ok_or_else(|| self.missing(x))?
            }
            None => 0,
        };
        let abscissa = abscissae.remove(chosen);
        let Candidate { name, column: density } = self.density(abscissa.quantity)?;
        self.note_missing_units(&[abscissa.index, density.index], notes);
        if name == Some(DensityName::Psd) && self.options.convention.is_none() {
            notes.push(self.psd_note(density, abscissa.quantity));
        }
        let is_series = |name: &String| SERIES_COLUMNS.iter().any(|series| name.eq_ignore_ascii_case(series));
        Ok(Layout {
            names: self.names.to_vec(),
            names_line: self.line,
            abscissa,
            checks: abscissae,
            density,
            series: (0..self.names.len()).filter(|&index| is_series(&self.names[index])).collect(),
            has_header_row,
        })
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
        let Some(text) = unit else { return Ok(quantity.si()) };
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
        let asked_for = if self.options.convention == Some(Convention::Ciso) {
            DensityName::Ciso
        } else {
            DensityName::C1d
        };
        if fitting.iter().any(|candidate| candidate.name == Some(asked_for)) {
            fitting.retain(|candidate| candidate.name == Some(asked_for));
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
        let parsed = unit.and_then(Unit::parse);
        let convention = match (self.options.convention, name) {
            (Some(convention), _) => convention,
            (None, DensityName::C1d) => Convention::C1D,
            (None, DensityName::Ciso) => Convention::Ciso,
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
        let unit = trailing_unit(column).unwrap_or(Unit::si(convention.metre_power()));
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

    fn note_missing_units(&self, columns: &[usize], notes: &mut Vec<String>) {
        let names = columns.iter().map(|&index| &self.names[index]);
        let is_bare = |name: &&String| match Heading::parse(name) {
            Some(heading) => heading.unit.is_none(),
            None => trailing_unit(name).is_none(),
        };
        notes.extend(
            names
                .filter(is_bare)
                .map(|name| format!("column '{name}' states no unit and is read in SI units")),
        );
    }

    fn psd_note(&self, density: DensityColumn, abscissa: Abscissa) -> String {
        let column = &self.names[density.index];
        match density.convention {
            Convention::Frequency => format!(
                "column '{column}' stands against {abscissa} and is read as the one-sided spectrum S of frequency, \
                 sigma^2 = Int S df"
            ),
            _ => format!(
                "column '{column}' states no convention and is read as C1D, sigma^2 = (1/pi) Int C dq"
            ),
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
