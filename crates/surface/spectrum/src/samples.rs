//! Validation of the samples of a spectrum.

use thiserror::Error;
use units::display::{counted, length};

/// Errors of samples that are not a power spectrum. Rows are counted from 1 in the order given.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum PsdError {
    /// The two columns differ in length.
    #[error(
        "building a spectrum: {} and {}; give one value for each wavelength",
        counted(*.wavelengths, "wavelength"), counted(*.values, "value")
    )]
    LengthMismatch {
        /// Number of wavelengths.
        wavelengths: usize,
        /// Number of values.
        values: usize,
    },
    /// Too few rows.
    #[error("building a spectrum: {}; give at least {least}", counted(*.rows, "row"))]
    TooFewRows {
        /// Number of rows.
        rows: usize,
        /// Smallest number of rows.
        least: usize,
    },
    /// A wavelength not below the one before it.
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
    /// A wavelength that is not finite and above 0.
    #[error("building a spectrum: the wavelength in row {row} is {}, it must be finite and above 0", length(*.value))]
    BadWavelength {
        /// Row.
        row: usize,
        /// Wavelength in m.
        value: f64,
    },
    /// A value that is not finite and above 0.
    #[error("building a spectrum: the density in row {row} is {value}, it must be finite and above 0")]
    BadDensity {
        /// Row.
        row: usize,
        /// Value in the unit of the convention.
        value: f64,
    },
    /// A repeated wavelength.
    #[error(
        "building a spectrum: the wavelength {} appears twice; keep one value for it",
        length(*.wavelength_m)
    )]
    RepeatedWavelength {
        /// The wavelength in m.
        wavelength_m: f64,
    },
    /// Another number of standard errors than of values.
    #[error(
        "building a spectrum: {} for {}; give one, or none, for each value",
        counted(*.errors, "standard error"), counted(*.values, "value")
    )]
    StandardErrorCount {
        /// Number of standard errors.
        errors: usize,
        /// Number of values.
        values: usize,
    },
    /// A standard error that is not finite and at least 0.
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

/// Refuses columns of different lengths, fewer than `least` rows, and numbers that are not finite and above 0.
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

/// Returns true if a number is finite and above 0.
pub(crate) fn is_positive(value: f64) -> bool {
    value.is_finite() && value > 0.0
}
