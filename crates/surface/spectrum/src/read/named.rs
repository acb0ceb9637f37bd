//! Named columns: choice of the abscissa, its unit, and the columns that must agree with it.

use units::LengthUnit;

use crate::read::density::Candidate;
use crate::read::error::{LineProblem, ReadError};
use crate::read::header::{Abscissa, Heading, Quantity};
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
            let Quantity::Abscissa(stated) = heading.quantity else { continue };
            let quantity = self.abscissa_of(index, stated, heading.unit);
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
        if self.options.x.is_none() {
            self.settle_wavenumber(&mut columns)?;
        }
        Ok(columns)
    }

    /// Returns the quantity of a column: the option for the abscissa decides where a unit without radians leaves it open.
    fn abscissa_of(&self, index: usize, stated: Abscissa, unit: Option<&str>) -> Abscissa {
        let is_angular = unit.and_then(Unit::parse).is_some_and(|unit| unit.angular);
        let others = self.headings().filter(|(other, _)| *other != index);
        let is_taken = others
            .map(|(_, heading)| heading.quantity)
            .any(|it| it == Quantity::Abscissa(Abscissa::Frequency));
        match self.options.x {
            Some(Abscissa::Frequency) if stated == Abscissa::Wavevector && !is_angular && !is_taken => {
                Abscissa::Frequency
            }
            _ => stated,
        }
    }

    /// Refuses a wavenumber that may count radians or cycles if nothing else tells the wavelengths; beside another column
    /// it is left out.
    fn settle_wavenumber(&self, columns: &mut Vec<AbscissaColumn>) -> Result<(), ReadError> {
        let is_open = |column: &AbscissaColumn| Heading::may_count_cycles(&self.names[column.index]);
        if let [only] = &columns[..]
            && is_open(only)
        {
            let column = self.names[only.index].clone();
            return Err(LineProblem::AmbiguousWavenumber(column).at(self.line));
        }
        columns.retain(|column| !is_open(column));
        Ok(())
    }

    /// Notes a wavevector in 1/m, which may count cycles.
    pub(crate) fn bare_wavevector_note(&self, abscissa: AbscissaColumn) -> Option<String> {
        let is_bare = self.stated_unit(abscissa.index).is_some_and(|unit| !unit.angular);
        let is_open = abscissa.quantity == Abscissa::Wavevector && is_bare && self.options.x.is_none();
        let column = &self.names[abscissa.index];
        // Gwyddion's k is in rad/m.
        (is_open && !column.starts_with('k')).then(|| {
            format!("column '{column}' is read as rad/m; if it counts cycles, areas change by about 2 pi: set x to frequency")
        })
    }

    fn abscissa_unit(&self, index: usize, quantity: Abscissa, unit: Option<&str>) -> Result<Unit, ReadError> {
        let given = self.units.x.filter(|given| quantity.fits(given.unit));
        let Some(text) = unit else { return Ok(given.map_or(quantity.si(), |given| given.unit)) };
        let bad = || LineProblem::BadUnit {
            column: self.names[index].clone(),
            unit: text.to_owned(),
            quantity: quantity.name().to_owned(),
            accepted: accepted_units(quantity),
        };
        Unit::parse(text).filter(|&unit| quantity.fits(unit)).ok_or_else(|| bad().at(self.line))
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
