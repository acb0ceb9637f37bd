//! Validation of the samples of a spectrum.

use thiserror::Error;
use units::Bound;
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
    /// A wavelength that is not finite and above 0, or not within thirty decades of 1 m.
    #[error(
        "building a spectrum: the wavelength in row {row} is {}, it must be {}",
        length(*.value), needed(*.value, "from 1e-30 to 1e30 m")
    )]
    BadWavelength {
        /// Row.
        row: usize,
        /// Wavelength in m.
        value: f64,
    },
    /// A value that is not finite and above 0, or not within ninety decades of 1.
    #[error(
        "building a spectrum: the density in row {row} is {value}, it must be {}",
        needed(*.value, "from 1e-90 to 1e90 m^3 (or m^4)")
    )]
    BadDensity {
        /// Row.
        row: usize,
        /// Value in the unit of the convention.
        value: f64,
    },
    /// A wavelength that is repeated, or agrees with its neighbour to rounding.
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

/// Refuses columns of different lengths, fewer than `least` rows, and numbers that no spectrum has.
pub(crate) fn check_samples(wavelengths_m: &[f64], values: &[f64], least: usize) -> Result<(), PsdError> {
    if wavelengths_m.len() != values.len() {
        return Err(PsdError::LengthMismatch { wavelengths: wavelengths_m.len(), values: values.len() });
    }
    if values.len() < least {
        return Err(PsdError::TooFewRows { rows: values.len(), least });
    }
    if let Some(row) = wavelengths_m.iter().position(|&wavelength| !is_wavelength(wavelength)) {
        return Err(PsdError::BadWavelength { row: row + 1, value: wavelengths_m[row] });
    }
    if let Some(row) = values.iter().position(|&value| !is_density(value)) {
        return Err(PsdError::BadDensity { row: row + 1, value: values[row] });
    }
    Ok(())
}

/// Returns true if a number can be a wavelength \[m\]: within thirty decades of 1.
pub(crate) fn is_wavelength(value: f64) -> bool {
    Bound::Magnitude.admits(value)
}

/// Returns true if a number can be a density \[m^3\] or \[m^4\]: within ninety decades of 1. With wavelengths in bounds, no
/// moment of such a spectrum leaves the range of doubles, nor its products with moduli in bounds.
pub(crate) fn is_density(value: f64) -> bool {
    const SMALLEST: f64 = 1e-90;
    const LARGEST: f64 = 1e90;
    (SMALLEST..=LARGEST).contains(&value)
}

/// Returns true if the second of two wavelengths is smaller by more than rounding: a spectrum has no slope between others.
pub(crate) fn falls(wavelength_m: f64, next_m: f64) -> bool {
    /// Relative rounding of wavelengths and of the wavevectors computed from them.
    const ROUNDING: f64 = 16.0 * f64::EPSILON;
    wavelength_m - next_m > ROUNDING * next_m
}

/// Words the requirement that a number violates: the plain one, or its range.
fn needed(value: f64, range: &'static str) -> &'static str {
    if value.is_finite() && value > 0.0 { range } else { "finite and above 0" }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_beyond_all_surfaces_are_refused_with_their_row() {
        let refused =
            |wavelengths_m: &[f64], values: &[f64]| check_samples(wavelengths_m, values, 1).unwrap_err();
        assert_eq!(refused(&[1.0, 1e-31], &[1.0, 1.0]), PsdError::BadWavelength { row: 2, value: 1e-31 });
        assert_eq!(refused(&[1.0, 0.5], &[1e91, 1.0]), PsdError::BadDensity { row: 1, value: 1e91 });
        assert_eq!(check_samples(&[1e30, 1e-30], &[1e90, 1e-90], 1), Ok(()));
    }

    #[test]
    fn wavelengths_that_agree_to_rounding_do_not_fall() {
        assert!(!falls(1.0, 1f64.next_down()) && falls(1.0, 1.0 - 1e-14) && !falls(1.0, 2.0));
    }
}
