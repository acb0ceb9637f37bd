//! Options for reading a file.

use thiserror::Error;

use crate::convention::Convention;
use crate::read::header::Abscissa;
use crate::read::mend::{ReadMend, ReadOption};
use crate::read::unit::Unit;

/// Options for reading a file: facts that it does not state, and the choice of the spectrum.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ReadOptions {
    /// Name of the column of the spectrum, exact or in another case.
    pub column: Option<String>,
    /// Convention of the spectrum; overrides the name of its column.
    pub convention: Option<Convention>,
    /// Quantity of the first column of a file without a header; with a header, the abscissa with precedence.
    pub x: Option<Abscissa>,
    /// Name of the series to read from a file of several, such as `1D PSD along y`, in any case. `q/pi x 2D PSD`
    /// matches `q/π × 2D PSD`; `subject - series` names both.
    pub series: Option<String>,
    /// Name of the subject whose series is read from a file of several, such as a measurement's, in any case.
    pub subject: Option<String>,
    /// Unit of the abscissa if the file states none: `m`, `nm`, `1/um`, `rad/m` and the like.
    pub x_unit: Option<String>,
    /// Unit of the spectrum if the file states none: `um^3`, `m^4` and the like.
    pub psd_unit: Option<String>,
}

/// Errors of a unit given by the caller.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum UnitError {
    /// The text is not a unit of the quantity.
    #[error("'{given}' is not a unit of the {quantity}; give one such as {accepted}")]
    NotAUnit {
        /// The option.
        option: ReadOption,
        /// The given text.
        given: String,
        /// The quantity.
        quantity: String,
        /// Suitable units.
        accepted: &'static str,
    },
    /// The unit differs from that of the file.
    #[error(
        "line {line}: column '{column}' is in '{stated}', but '{given}' is given for it; correct the file"
    )]
    Contradiction {
        /// Line of the header.
        line: usize,
        /// Column.
        column: String,
        /// The unit in the header.
        stated: String,
        /// The option.
        option: ReadOption,
        /// The given unit.
        given: String,
    },
    /// A JSON series, which never states its units.
    #[error("line {line}: the JSON series states no units, and both are needed")]
    Missing {
        /// First line of the numbers.
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

    /// The option that fixes the error.
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

/// A unit given by the caller.
#[derive(Clone, Copy, Debug)]
pub(crate) struct GivenUnit<'o> {
    option: ReadOption,
    pub(crate) text: &'o str,
    pub(crate) unit: Unit,
}

/// The units given by the caller.
#[derive(Clone, Copy, Debug)]
pub(crate) struct GivenUnits<'o> {
    pub(crate) x: Option<GivenUnit<'o>>,
    pub(crate) psd: Option<GivenUnit<'o>>,
}

impl ReadOptions {
    /// Parses the given units; each must fit its axis, and the quantity or convention if that is given too.
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
                    None => "m, um or nm for a wavelength, 1/m, 1/um or 1/nm for a wavevector",
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
                    None => "m^3, um^3 or nm^3 for a profile, m^4, um^4 or nm^4 for an area",
                },
            })
        });
        Ok(GivenUnits { x: x.transpose()?, psd: psd.transpose()? })
    }
}

impl GivenUnit<'_> {
    /// Refuses a unit that differs from the one a column states.
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
