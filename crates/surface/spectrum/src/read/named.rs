//! Named columns: choice of the abscissa, its unit, and the columns that must agree with it.

use units::LengthUnit;

use crate::read::density::Candidate;
use crate::read::error::ReadError;
use crate::read::header::{Abscissa, Quantity};
use crate::read::layout::{AbscissaColumn, DensityColumn, Layout};
use crate::read::names::Header;
use crate::read::unit::Unit;

impl Header<'_> {
    /// Assigns the columns and notes assumptions.
    pub(crate) fn layout(&self, notes: &mut Vec<String>) -> Result<Layout, ReadError> {
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

    /// Finds the columns of wavelength, wavevector and frequency, in this order; at least one.
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
                        let scale = unit.scale();
                        columns.push(AbscissaColumn { index, quantity, scale });
                    }
                },
            }
        }
        if columns.is_empty() {
            return Err(unfit.map_or_else(|| self.missing_abscissa(), |(_, error)| error));
        }
        if let Some((index, _)) = unfit {
            notes.push(format!(
                "column '{}' is ignored: its unit does not fit its quantity",
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
            accepted: accepted_units(quantity),
        })
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
}

fn accepted_units(quantity: Abscissa) -> String {
    let lengths = LengthUnit::ALL.map(LengthUnit::ascii);
    match quantity {
        Abscissa::Wavelength => lengths.join(", "),
        Abscissa::Wavevector => format!("rad/m or 1/m, and the same with {}", lengths[1..].join(", ")),
        Abscissa::Frequency => format!("1/{}", lengths.join(", 1/")),
    }
}
