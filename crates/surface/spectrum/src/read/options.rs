//! What a caller may say about a file.

use thiserror::Error;

use crate::convention::Convention;
use crate::read::header::Abscissa;
use crate::read::mend::{ReadMend, ReadOption};
use crate::read::unit::Unit;

/// What the caller knows about a file that the file does not say, and which of its spectra is meant.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ReadOptions {
    /// Name of the column that holds the spectrum, exact or in another case.
    pub column: Option<String>,
    /// Convention of the spectrum, whatever the name of its column says.
    pub convention: Option<Convention>,
    /// What the first column of a file without a header holds; with a header, which of several columns
    /// counts.
    pub x: Option<Abscissa>,
    /// Name of the series to read from a file of several, such as `1D PSD along y`, in any case; `q/pi x 2D PSD` stands
    /// for `q/π × 2D PSD`. `subject - series` names both.
    pub series: Option<String>,
    /// Name of the subject whose series is read from a file of several, such as a measurement's, in any case.
    pub subject: Option<String>,
    /// Unit of the abscissa where the file states none: `m`, `nm`, `1/um`, `rad/m` and the like.
    pub x_unit: Option<String>,
    /// Unit of the spectrum where the file states none: `um^3`, `m^4` and the like.
    pub psd_unit: Option<String>,
}

/// A unit given by the caller that does not do.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum UnitError {
    /// No unit of the quantity.
    #[error("reading the unit of the {quantity}: '{given}' is none; give one like {accepted}")]
    NotAUnit {
        /// The option that gives it.
        option: ReadOption,
        /// The text given.
        given: String,
        /// The quantity.
        quantity: String,
        /// Units that would do.
        accepted: &'static str,
    },
    /// Another unit than the file's.
    #[error(
        "line {line}: column '{column}' is in '{stated}', and '{given}' is given for it; mend the file where it is wrong"
    )]
    Contradiction {
        /// Line of the header.
        line: usize,
        /// Column.
        column: String,
        /// The unit in the header.
        stated: String,
        /// The option that gives it.
        option: ReadOption,
        /// The unit given.
        given: String,
    },
    /// A series of JSON, which never tells its units.
    #[error("line {line}: the series of a JSON file states no units, and both of them are needed")]
    Missing {
        /// Line in which the numbers begin.
        line: usize,
    },
}

impl UnitError {
    pub(crate) fn line(&self) -> Option<usize> {
        match *self {
            Self::NotAUnit { .. } => None,
            Self::Contradiction { line, .. } | Self::Missing { line } => Some(line),
        }
    }

    /// What the caller can do about it with an option.
    pub(crate) fn mend(&self) -> ReadMend {
        match *self {
            Self::NotAUnit { option, .. } => ReadMend::Correct(option),
            Self::Contradiction { option, .. } => ReadMend::LeaveOut(option),
            Self::Missing { .. } => ReadMend::Give(vec![
                ReadOption::XUnit.one_of(["m", "nm", "1/m", "1/um"]),
                ReadOption::PsdUnit.one_of(["m^3", "um^3", "nm^3"]),
            ]),
        }
    }
}

/// A unit that the caller gives.
#[derive(Clone, Copy, Debug)]
pub(crate) struct GivenUnit<'o> {
    option: ReadOption,
    pub(crate) text: &'o str,
    pub(crate) unit: Unit,
}

/// The units that the caller gives.
#[derive(Clone, Copy, Debug)]
pub(crate) struct GivenUnits<'o> {
    pub(crate) x: Option<GivenUnit<'o>>,
    pub(crate) psd: Option<GivenUnit<'o>>,
}

impl ReadOptions {
    /// The units given, each of which must measure an abscissa or a spectrum, and that of the quantity given with it.
    pub(crate) fn units(&self) -> Result<GivenUnits<'_>, UnitError> {
        let x = self.x_unit.as_deref().map(|text| {
            let fits = |unit: &Unit| match self.x {
                Some(abscissa) => abscissa.fits(*unit),
                None => matches!(unit.metre_power, 1 | -1),
            };
            let given = |unit| GivenUnit { option: ReadOption::XUnit, text, unit };
            Unit::parse(text).filter(fits).map(given).ok_or_else(|| UnitError::NotAUnit {
                option: ReadOption::XUnit,
                given: text.to_owned(),
                quantity: self.x.map_or("abscissa", Abscissa::name).to_owned(),
                accepted: match self.x {
                    Some(Abscissa::Wavelength) => "m, um or nm",
                    Some(Abscissa::Wavevector) => "1/m, 1/um, 1/nm or rad/m",
                    Some(Abscissa::Frequency) => "1/m, 1/mm, 1/um or 1/nm",
                    None => "m, um or nm of a wavelength, 1/m, 1/um or 1/nm of a wavevector",
                },
            })
        });
        let psd = self.psd_unit.as_deref().map(|text| {
            let fits = |unit: &Unit| match self.convention {
                Some(convention) => unit.metre_power == convention.metre_power(),
                None => matches!(unit.metre_power, 3 | 4),
            };
            let given = |unit| GivenUnit { option: ReadOption::PsdUnit, text, unit };
            let of = self.convention.map(|convention| (convention, convention.metre_power()));
            Unit::parse(text).filter(fits).map(given).ok_or_else(|| UnitError::NotAUnit {
                option: ReadOption::PsdUnit,
                given: text.to_owned(),
                quantity: of
                    .map_or("spectrum".to_owned(), |(convention, _)| format!("spectrum ({convention})")),
                accepted: match of {
                    Some((_, 3)) => "m^3, um^3 or nm^3",
                    Some(_) => "m^4, um^4 or nm^4",
                    None => "m^3, um^3 or nm^3 of a profile, m^4, um^4 or nm^4 of an area",
                },
            })
        });
        Ok(GivenUnits { x: x.transpose()?, psd: psd.transpose()? })
    }
}

impl GivenUnit<'_> {
    /// Refuses another unit than the one a column states.
    pub(crate) fn refuse_other(
        self,
        stated: Option<Unit>,
        line: usize,
        column: &str,
    ) -> Result<(), UnitError> {
        let Some(stated) = stated.filter(|&stated| !self.unit.is_same_size(stated)) else { return Ok(()) };
        Err(UnitError::Contradiction {
            line,
            column: column.to_owned(),
            stated: stated.to_string(),
            option: self.option,
            given: self.text.to_owned(),
        })
    }
}
