//! A sampled power spectrum in any convention.

use serde::Serialize;
use thiserror::Error;

use crate::convention::{Convention, ConversionError};
use crate::profile::ProfilePsd;

/// A sampled power spectrum: at least two wavelengths, finite and above 0, from long to short without
/// repeats, and as many finite values above 0 in the stated convention.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Psd {
    wavelengths_m: Vec<f64>,
    values: Vec<f64>,
    convention: Convention,
}

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
    /// Fewer than two rows.
    #[error("building a spectrum: the number of rows is {rows}, it must be at least 2")]
    TooFewRows {
        /// Number of rows.
        rows: usize,
    },
    /// A wavelength that is no finite number above 0.
    #[error("building a spectrum: the wavelength in row {row} is {value} m, it must be finite and above 0")]
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
        "building a spectrum: the wavelength {wavelength_m} m stands in it twice; keep one value for each"
    )]
    RepeatedWavelength {
        /// The wavelength in m.
        wavelength_m: f64,
    },
}

impl Psd {
    /// A spectrum from its samples, in any order.
    ///
    /// `wavelengths_m` in m; `values` in m^3 or m^4, whichever `convention` says.
    ///
    /// # Errors
    /// [`PsdError`] for columns of different lengths, fewer than two rows, a wavelength or value that is not
    /// finite and above 0, or a repeated wavelength.
    pub fn new(wavelengths_m: Vec<f64>, values: Vec<f64>, convention: Convention) -> Result<Self, PsdError> {
        if wavelengths_m.len() != values.len() {
            return Err(PsdError::LengthMismatch { wavelengths: wavelengths_m.len(), values: values.len() });
        }
        if values.len() < 2 {
            return Err(PsdError::TooFewRows { rows: values.len() });
        }
        if let Some(row) = wavelengths_m.iter().position(|&wavelength| !is_positive(wavelength)) {
            return Err(PsdError::BadWavelength { row: row + 1, value: wavelengths_m[row] });
        }
        if let Some(row) = values.iter().position(|&value| !is_positive(value)) {
            return Err(PsdError::BadDensity { row: row + 1, value: values[row] });
        }
        let mut rows: Vec<(f64, f64)> = wavelengths_m.into_iter().zip(values).collect();
        rows.sort_by(|a, b| b.0.total_cmp(&a.0));
        if let Some(pair) = rows.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            return Err(PsdError::RepeatedWavelength { wavelength_m: pair[0].0 });
        }
        let (wavelengths_m, values) = rows.into_iter().unzip();
        Ok(Self { wavelengths_m, values, convention })
    }

    /// Samples that already are what the type promises.
    pub(crate) fn from_samples(wavelengths_m: Vec<f64>, values: Vec<f64>, convention: Convention) -> Self {
        Self { wavelengths_m, values, convention }
    }

    /// The same spectrum in another convention.
    ///
    /// # Errors
    /// [`ConversionError`] between a profile and an area convention: the Abel integral between them needs the
    /// spectrum beyond the last sample.
    pub fn to(&self, convention: Convention) -> Result<Self, ConversionError> {
        let factor = self.convention.factor_to(convention)?;
        let values = self.values.iter().map(|value| value * factor).collect();
        Ok(Self { wavelengths_m: self.wavelengths_m.clone(), values, convention })
    }

    /// The spectrum as C1D, on which everything else is computed.
    ///
    /// # Errors
    /// [`ConversionError`] for an area convention, as in [`Psd::to`].
    pub fn profile(&self) -> Result<ProfilePsd, ConversionError> {
        let c1d = self.to(Convention::C1D)?;
        Ok(ProfilePsd::from_samples(c1d.wavelengths_m, c1d.values))
    }

    /// Wavelengths in m, from long to short.
    pub fn wavelengths_m(&self) -> &[f64] {
        &self.wavelengths_m
    }

    /// Values in m^3 or m^4, whichever the convention says, one for each wavelength.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// What the values mean.
    pub fn convention(&self) -> Convention {
        self.convention
    }

    /// Number of samples, at least 2.
    #[expect(clippy::len_without_is_empty, reason = "a spectrum is never empty")]
    pub fn len(&self) -> usize {
        self.values.len()
    }
}

impl TryFrom<&Psd> for ProfilePsd {
    type Error = ConversionError;

    fn try_from(psd: &Psd) -> Result<Self, ConversionError> {
        psd.profile()
    }
}

fn is_positive(value: f64) -> bool {
    value.is_finite() && value > 0.0
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    fn error(wavelengths_m: &[f64], values: &[f64]) -> String {
        Psd::new(wavelengths_m.to_vec(), values.to_vec(), Convention::C1D).unwrap_err().to_string()
    }

    #[test]
    fn samples_in_any_order_are_sorted_from_long_to_short() {
        let psd = Psd::new(vec![1e-6, 1e-3, 1e-5], vec![3.0, 1.0, 2.0], Convention::C1D).unwrap();
        assert_eq!(psd.wavelengths_m(), [1e-3, 1e-5, 1e-6]);
        assert_eq!(psd.values(), [1.0, 2.0, 3.0]);
        assert_eq!(psd.len(), 3);
    }

    #[test]
    fn samples_that_make_no_spectrum_are_refused() {
        assert_eq!(
            error(&[1.0, 0.5], &[1.0]),
            "building a spectrum: the number of wavelengths is 2, that of values 1; give one value for each wavelength"
        );
        assert_eq!(
            error(&[1.0], &[1.0]),
            "building a spectrum: the number of rows is 1, it must be at least 2"
        );
        assert_eq!(
            error(&[1.0, -0.5], &[1.0, 1.0]),
            "building a spectrum: the wavelength in row 2 is -0.5 m, it must be finite and above 0"
        );
        assert_eq!(
            error(&[1.0, 0.5], &[f64::NAN, 1.0]),
            "building a spectrum: the density in row 1 is NaN, it must be finite and above 0"
        );
        assert_eq!(
            error(&[1.0, 0.5, 1.0], &[1.0, 1.0, 2.0]),
            "building a spectrum: the wavelength 1 m stands in it twice; keep one value for each"
        );
    }

    #[test]
    fn every_profile_convention_yields_the_same_c1d() {
        for (convention, factor) in
            [(Convention::C1D, 1.0), (Convention::W1, PI), (Convention::Frequency, 0.5)]
        {
            let psd = Psd::new(vec![2.0, 1.0], vec![3.0, 4.0], convention).unwrap();
            assert_eq!(psd.profile().unwrap().c1d_m3(), [3.0 * factor, 4.0 * factor]);
        }
        let area = Psd::new(vec![2.0, 1.0], vec![3.0, 4.0], Convention::Persson).unwrap();
        assert_eq!(area.to(Convention::Ciso).unwrap().values(), [12.0 * PI * PI, 16.0 * PI * PI]);
        assert!(ProfilePsd::try_from(&area).is_err());
    }
}
