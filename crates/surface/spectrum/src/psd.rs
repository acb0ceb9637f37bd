//! A sampled power spectrum in any convention.

use std::f64::consts::TAU;

use serde::Serialize;

use crate::abel::profile_of_area;
use crate::convention::{Convention, ConversionError};
use crate::power_law::PowerLaw;
use crate::profile::ProfilePsd;
use crate::samples::{PsdError, check_samples, falls, is_density};
use crate::surface_waves::SurfaceWaves;

/// A sampled power spectrum in a stated convention: at least two wavelengths from long to short without repeats, and as
/// many values, all finite and above 0. Standard errors of the values are optional.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Psd {
    wavelengths_m: Vec<f64>,
    values: Vec<f64>,
    convention: Convention,
    /// Options rather than NaN, so that equal spectra compare equal.
    #[serde(skip_serializing_if = "Option::is_none")]
    standard_errors: Option<Vec<Option<f64>>>,
}

impl Psd {
    /// Makes a spectrum from samples in any order, `wavelengths_m` in m and `values` in the unit of `convention` (m^3
    /// or m^4).
    ///
    /// # Errors
    /// [`PsdError`] for columns of different lengths, fewer than two rows, a wavelength or value out of its range, or a
    /// repeated wavelength.
    pub fn new(wavelengths_m: Vec<f64>, values: Vec<f64>, convention: Convention) -> Result<Self, PsdError> {
        check_samples(&wavelengths_m, &values, 2)?;
        let mut rows: Vec<(f64, f64)> = wavelengths_m.into_iter().zip(values).collect();
        rows.sort_by(|a, b| b.0.total_cmp(&a.0));
        if let Some(pair) = rows.windows(2).find(|pair| !falls(pair[0].0, pair[1].0)) {
            return Err(PsdError::RepeatedWavelength { wavelength_m: pair[0].0 });
        }
        let (wavelengths_m, values) = rows.into_iter().unzip();
        Ok(Self::from_samples(wavelengths_m, values, convention))
    }

    /// Makes a spectrum from samples that are valid already.
    pub(crate) fn from_samples(wavelengths_m: Vec<f64>, values: Vec<f64>, convention: Convention) -> Self {
        Self { wavelengths_m, values, convention, standard_errors: None }
    }

    /// Sets the standard errors of the values in their unit, one per sample in the order of [`Psd::wavelengths_m`];
    /// `None` is an unknown one.
    ///
    /// # Errors
    /// [`PsdError::StandardErrorCount`], and [`PsdError::BadStandardError`] for one that is not finite or below 0.
    pub fn with_standard_errors(self, errors: Vec<Option<f64>>) -> Result<Self, PsdError> {
        if errors.len() != self.len() {
            return Err(PsdError::StandardErrorCount { errors: errors.len(), values: self.len() });
        }
        let is_bad = |error: &Option<f64>| error.is_some_and(|error| !(error.is_finite() && error >= 0.0));
        if let Some(row) = errors.iter().position(is_bad) {
            return Err(PsdError::BadStandardError { row: row + 1, value: errors[row].unwrap_or(f64::NAN) });
        }
        Ok(self.with_checked_standard_errors(errors))
    }

    /// Sets standard errors that are valid already: one per value, finite and not below 0.
    pub(crate) fn with_checked_standard_errors(self, errors: Vec<Option<f64>>) -> Self {
        Self { standard_errors: errors.iter().any(Option::is_some).then_some(errors), ..self }
    }

    /// Converts the spectrum to another convention of profiles, or of areas, by a factor.
    ///
    /// # Errors
    /// [`ConversionError::NoFactor`] between profiles and areas: see [`Psd::profile`], and
    /// [`AreaSpectrum::from_psd`](crate::random_surfaces::AreaSpectrum::from_psd).
    pub fn to(&self, convention: Convention) -> Result<Self, ConversionError> {
        let factor = self.convention.factor_to(convention)?;
        let values = self.values.iter().map(|value| value * factor).collect();
        let scaled = |error: &Option<f64>| error.map(|error| error * factor);
        let standard_errors = self.standard_errors.as_ref().map(|errors| errors.iter().map(scaled).collect());
        Ok(Self { wavelengths_m: self.wavelengths_m.clone(), values, convention, standard_errors })
    }

    /// Converts the spectrum to C1D, the input of moments, amplitudes and fits. An area spectrum stays the spectrum of the surface
    /// for all that takes the waves of a surface; its C1D ends with a sample that keeps the gradient, and has no standard errors,
    /// because files do not state how those of neighbouring samples are correlated.
    ///
    /// # Errors
    /// [`ConversionError::TooFewSamples`] for 2 samples of an area convention, [`ConversionError::OutOfRange`] for densities beyond doubles.
    pub fn profile(&self) -> Result<ProfilePsd, ConversionError> {
        let (from, samples) = (self.convention, self.len());
        let Some(surface) = self.surface() else {
            let Self { wavelengths_m, values, standard_errors, .. } = self.to(Convention::C1D)?;
            return Ok(ProfilePsd::from_samples(wavelengths_m, values).with_standard_errors(standard_errors));
        };
        if samples < 3 {
            return Err(ConversionError::TooFewSamples { from, samples });
        }
        let Self { wavelengths_m, values, .. } = self.to(Convention::Ciso)?;
        let c1d_m3 = profile_of_area(&wavelengths_m, &values);
        if let Some(row) = c1d_m3.iter().position(|&value| !is_density(value)) {
            let (wavelength_m, c1d_m3) = (wavelengths_m[row], c1d_m3[row]);
            return Err(ConversionError::OutOfRange { from, wavelength_m, c1d_m3 });
        }
        Ok(ProfilePsd::from_samples(wavelengths_m, c1d_m3).with_surface(surface))
    }

    /// The waves of the surface, if the spectrum is that of an area: power laws between its samples.
    pub(crate) fn surface(&self) -> Option<SurfaceWaves> {
        // A factor exists only among conventions of areas, or among those of profiles.
        let factor = self.convention.factor_to(Convention::Ciso).ok()?;
        let sample = |at: usize| (TAU / self.wavelengths_m[at], factor * self.values[at]);
        Some(SurfaceWaves {
            pieces: (1..self.len()).map(|end| PowerLaw::through(sample(end - 1), sample(end))).collect(),
            longest_m: self.wavelengths_m[0],
            shortest_m: self.wavelengths_m[self.len() - 1],
        })
    }

    /// Wavelengths in m, from long to short.
    pub fn wavelengths_m(&self) -> &[f64] {
        &self.wavelengths_m
    }

    /// Values in the unit of the convention (m^3 or m^4), one per wavelength.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Standard errors of the values in their unit, one per value, with `None` for unknown ones; `None` if no value has
    /// one.
    pub fn standard_errors(&self) -> Option<&[Option<f64>]> {
        self.standard_errors.as_deref()
    }

    /// Convention of the values.
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
            "building a spectrum: 2 wavelengths and 1 value; give one value for each wavelength"
        );
        assert_eq!(error(&[1.0], &[1.0]), "building a spectrum: 1 row; give at least 2");
        assert_eq!(
            error(&[1.0, -0.5], &[1.0, 1.0]),
            "building a spectrum: the wavelength in row 2 is -500 mm, it must be finite and above 0"
        );
        assert_eq!(
            error(&[1.0, 0.5], &[f64::NAN, 1.0]),
            "building a spectrum: the density in row 1 is NaN, it must be finite and above 0"
        );
        assert_eq!(
            error(&[1.0, 0.5, 1.0], &[1.0, 1.0, 2.0]),
            "building a spectrum: the wavelength 1 m appears twice; keep one value for it"
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
        assert_eq!(
            ProfilePsd::try_from(&area).unwrap_err().to_string(),
            "converting a spectrum from persson (m^4) to c1d (m^3): 2 samples; give at least 3"
        );
    }

    #[test]
    fn standard_errors_follow_their_values() {
        let psd = Psd::new(vec![2.0, 1.0], vec![3.0, 4.0], Convention::Frequency).unwrap();
        let with = |errors: &[Option<f64>]| psd.clone().with_standard_errors(errors.to_vec());
        let psd_with_errors = with(&[Some(0.2), None]).unwrap();
        assert_eq!(psd_with_errors.standard_errors(), Some(&[Some(0.2), None][..]));
        let profile = psd_with_errors.profile().unwrap();
        assert_eq!(profile.standard_errors_m3(), Some(&[Some(0.1), None][..]));
        assert_eq!(profile.truncated_at(1.5).unwrap().standard_errors_m3(), Some(&[Some(0.1)][..]));
        assert_eq!(profile.resampled(std::num::NonZeroU32::MIN).standard_errors_m3(), None);
        assert_eq!(with(&[None, None]).unwrap().standard_errors(), None);
        assert_eq!(
            with(&[None]).unwrap_err().to_string(),
            "building a spectrum: 1 standard error for 2 values; give one, or none, for each value"
        );
        assert_eq!(
            with(&[None, Some(-1.0)]).unwrap_err().to_string(),
            "building a spectrum: the standard error in row 2 is -1, it must be finite and at least 0"
        );
    }
}
