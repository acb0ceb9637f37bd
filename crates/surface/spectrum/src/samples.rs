//! What samples of a spectrum must be.

use thiserror::Error;
use units::display::length;

/// Samples that make no power spectrum. Rows are counted from 1 in the order given.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum PsdError {
    /// The two columns differ in length.
    #[error(
        "building a spectrum: the number of wavelengths is {wavelengths}, that of values {values}; give one value for each wavelength"
    )]
    LengthMismatch {
        /// Number of wavelengths.
        wavelengths: usize,
        /// Number of values.
        values: usize,
    },
    /// Fewer rows than make one.
    #[error("building a spectrum: the number of rows is {rows}, it must be at least {least}")]
    TooFewRows {
        /// Number of rows.
        rows: usize,
        /// How many there must be.
        least: usize,
    },
    /// A wavelength that does not lie below the one before it.
    #[error(
        "building a spectrum: the wavelength in row {row} is {}; they must fall from row to row",
        length(*.wavelength_m)
    )]
    OutOfOrder {
        /// Row.
        row: usize,
        /// Wavelength in m.
        wavelength_m: f64,
    },
    /// A wavelength that is no finite number above 0.
    #[error("building a spectrum: the wavelength in row {row} is {}, it must be finite and above 0", length(*.value))]
    BadWavelength {
        /// Row.
        row: usize,
        /// Wavelength in m.
        value: f64,
    },
    /// A value that is no finite number above 0.
    #[error("building a spectrum: the density in row {row} is {value}, it must be finite and above 0")]
    BadDensity {
        /// Row.
        row: usize,
        /// Value in the unit of the convention.
        value: f64,
    },
    /// The same wavelength twice.
    #[error(
        "building a spectrum: the wavelength {} stands in it twice; keep one value for each",
        length(*.wavelength_m)
    )]
    RepeatedWavelength {
        /// The wavelength in m.
        wavelength_m: f64,
    },
    /// Not one standard error for each value.
    #[error(
        "building a spectrum: the number of standard errors is {errors}, that of values {values}; give one, or none, \
         for each value"
    )]
    StandardErrorCount {
        /// Number of standard errors.
        errors: usize,
        /// Number of values.
        values: usize,
    },
    /// A standard error that is no finite number from 0 up.
    #[error(
        "building a spectrum: the standard error in row {row} is {value}, it must be finite and at least 0"
    )]
    BadStandardError {
        /// Row.
        row: usize,
        /// Standard error in the unit of the convention.
        value: f64,
    },
}

/// Refuses columns of different lengths, fewer than `least` rows, and what is not finite and above 0.
pub(crate) fn check_samples(wavelengths_m: &[f64], values: &[f64], least: usize) -> Result<(), PsdError> {
    if wavelengths_m.len() != values.len() {
        return Err(PsdError::LengthMismatch { wavelengths: wavelengths_m.len(), values: values.len() });
    }
    if values.len() < least {
        return Err(PsdError::TooFewRows { rows: values.len(), least });
    }
    if let Some(row) = wavelengths_m.iter().position(|&wavelength| !is_positive(wavelength)) {
        return Err(PsdError::BadWavelength { row: row + 1, value: wavelengths_m[row] });
    }
    if let Some(row) = values.iter().position(|&value| !is_positive(value)) {
        return Err(PsdError::BadDensity { row: row + 1, value: values[row] });
    }
    Ok(())
}

/// Whether a number is finite and above 0.
pub(crate) fn is_positive(value: f64) -> bool {
    value.is_finite() && value > 0.0
}
