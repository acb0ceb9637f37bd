//! The spectrum of line profiles, the input of moments, amplitudes and fits.

use std::f64::consts::TAU;
use std::num::NonZeroU32;
use std::sync::Arc;

use serde::Serialize;

use crate::interval::{Interval, Sample, ln_ratio};
use crate::samples::{PsdError, check_samples, falls};
use crate::surface_waves::SurfaceWaves;

/// A sampled one-dimensional power spectrum C1D in m^3, sigma^2 = (1/pi) Int_0^inf C1D dq, which is a power
/// law of the wavevector between neighbouring samples (a straight line in log-log axes).
///
/// Holds at least one sample, wavelengths \[m\] strictly from long to short and within thirty decades of 1, and densities
/// \[m^3\] above 0.
/// Standard errors of the values are kept if the source has them.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ProfilePsd {
    wavelengths_m: Vec<f64>,
    c1d_m3: Vec<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    standard_errors_m3: Option<Vec<Option<f64>>>,
    /// The waves of the surface, if they are known: those of a table of areas.
    #[serde(skip)]
    pub(crate) surface: Option<Arc<SurfaceWaves>>,
    /// Samples below the cutoff (\[m\], \[m^3\]), from long to short wavelengths: they hold waves of the surface above it no
    /// less.
    #[serde(skip)]
    pub(crate) beyond: Vec<(f64, f64)>,
}

impl ProfilePsd {
    /// Makes a spectrum from wavelengths \[m\], strictly from long to short, and values of C1D \[m^3\].
    ///
    /// # Errors
    /// [`PsdError`] for columns of different lengths or without rows, a wavelength or value out of its range, or wavelengths
    /// out of order.
    pub fn new(wavelengths_m: Vec<f64>, c1d_m3: Vec<f64>) -> Result<Self, PsdError> {
        check_samples(&wavelengths_m, &c1d_m3, 1)?;
        match wavelengths_m.windows(2).position(|pair| !falls(pair[0], pair[1])) {
            Some(row) => Err(PsdError::OutOfOrder { row: row + 2, wavelength_m: wavelengths_m[row + 1] }),
            None => Ok(Self::from_samples(wavelengths_m, c1d_m3)),
        }
    }

    /// Makes a spectrum from samples that are valid already.
    pub(crate) fn from_samples(wavelengths_m: Vec<f64>, c1d_m3: Vec<f64>) -> Self {
        Self { wavelengths_m, c1d_m3, standard_errors_m3: None, surface: None, beyond: Vec::new() }
    }

    /// States the waves of the surface whose profiles these are, so that they are not computed from them.
    pub(crate) fn with_surface(self, surface: SurfaceWaves) -> Self {
        Self { surface: Some(Arc::new(surface)), ..self }
    }

    /// Takes over what is known of the surface from a spectrum of the same surface over a wider band.
    #[must_use]
    pub fn with_surface_of(self, wider: &Self) -> Self {
        Self { surface: wider.surface.clone(), ..self }
    }

    /// Replaces the values of C1D \[m^3\]. If the surface is known, its spectrum changes by the same factors.
    ///
    /// # Errors
    /// [`PsdError`] for another number of values, or one out of its range.
    pub fn with_values(&self, c1d_m3: Vec<f64>) -> Result<Self, PsdError> {
        let changed = Self::new(self.wavelengths_m.clone(), c1d_m3)?;
        let factor = |q_rad_per_m: f64| {
            let within = self.shortest_wavelength_m()..=self.longest_wavelength_m();
            let wavelength_m = (TAU / q_rad_per_m).clamp(*within.start(), *within.end());
            changed
                .value_at(wavelength_m)
                .zip(self.value_at(wavelength_m))
                .map_or(1.0, |(new, old)| new / old)
        };
        let surface = self.surface.as_ref().map(|surface| Arc::new(surface.weighted(factor)));
        Ok(Self { surface, beyond: self.beyond.clone(), ..changed })
    }

    /// Replaces the standard errors, one per value.
    pub(crate) fn with_standard_errors(self, standard_errors_m3: Option<Vec<Option<f64>>>) -> Self {
        Self { standard_errors_m3, ..self }
    }

    /// Wavelengths in m, from long to short.
    pub fn wavelengths_m(&self) -> &[f64] {
        &self.wavelengths_m
    }

    /// Spectrum C1D in m^3, one value for each wavelength.
    pub fn c1d_m3(&self) -> &[f64] {
        &self.c1d_m3
    }

    /// Standard errors of C1D in m^3, one per value, with `None` for unknown ones; `None` if no value has one.
    pub fn standard_errors_m3(&self) -> Option<&[Option<f64>]> {
        self.standard_errors_m3.as_deref()
    }

    /// Number of samples, at least 1.
    #[expect(clippy::len_without_is_empty, reason = "a spectrum is never empty")]
    pub fn len(&self) -> usize {
        self.c1d_m3.len()
    }

    /// The longest wavelength in m.
    pub fn longest_wavelength_m(&self) -> f64 {
        self.wavelengths_m[0]
    }

    /// The shortest wavelength in m.
    pub fn shortest_wavelength_m(&self) -> f64 {
        self.wavelengths_m[self.len() - 1]
    }

    /// C1D in m^3 at a wavelength in m; `None` outside the sampled range.
    pub fn value_at(&self, wavelength_m: f64) -> Option<f64> {
        if !(self.shortest_wavelength_m()..=self.longest_wavelength_m()).contains(&wavelength_m) {
            return None;
        }
        match self.wavelengths_m.partition_point(|&sampled| sampled > wavelength_m) {
            0 => Some(self.c1d_m3[0]),
            end => Some(self.interval_ending_at(end).value_at(wavelength_m)),
        }
    }

    /// Samples the piecewise power law at round(`scales_per_decade` x decades) + 1 geometric points, at least 2.
    ///
    /// Both ends are kept exactly. Kinks between the new points are lost, so the moments differ from those of the
    /// original. Standard errors belong to the samples and are dropped. A spectrum of one sample is returned unchanged.
    pub fn resampled(&self, scales_per_decade: NonZeroU32) -> Self {
        let (longest_m, shortest_m) = (self.longest_wavelength_m(), self.shortest_wavelength_m());
        if self.len() == 1 {
            return self.clone();
        }
        let ln_range = ln_ratio(longest_m, shortest_m);
        let steps = (f64::from(scales_per_decade.get()) * ln_range / 10f64.ln()).round().max(1.0);
        let mut wavelengths_m = vec![longest_m];
        let mut c1d_m3 = vec![self.c1d_m3[0]];
        let mut end = 1;
        for step in 1..steps as usize {
            let wavelength_m = longest_m * (-ln_range * (step as f64 / steps)).exp();
            while self.wavelengths_m[end] > wavelength_m {
                end += 1;
            }
            wavelengths_m.push(wavelength_m);
            c1d_m3.push(self.interval_ending_at(end).value_at(wavelength_m));
        }
        wavelengths_m.push(shortest_m);
        c1d_m3.push(self.c1d_m3[self.len() - 1]);
        Self { surface: self.surface.clone(), ..Self::from_samples(wavelengths_m, c1d_m3) }
    }

    /// Keeps the samples at wavelengths from the cutoff \[m\] up; `None` if none are left or the cutoff is NaN.
    ///
    /// The cutoff is one of the surface: the others still count in the conversion to its spectrum.
    pub fn truncated_at(&self, cutoff_wavelength_m: f64) -> Option<Self> {
        let kept = self.wavelengths_m.partition_point(|&sampled| sampled >= cutoff_wavelength_m);
        (kept > 0).then(|| Self {
            wavelengths_m: self.wavelengths_m[..kept].to_vec(),
            c1d_m3: self.c1d_m3[..kept].to_vec(),
            standard_errors_m3: self.standard_errors_m3.as_ref().map(|errors| errors[..kept].to_vec()),
            surface: self.surface.clone(),
            beyond: self.samples().skip(kept).chain(self.beyond.iter().copied()).collect(),
        })
    }

    /// Yields wavelengths \[m\] and C1D \[m^3\].
    pub(crate) fn samples(&self) -> impl Iterator<Item = (f64, f64)> {
        self.wavelengths_m.iter().copied().zip(self.c1d_m3.iter().copied())
    }

    /// The intervals between neighbouring samples, from long to short wavelengths.
    pub(crate) fn intervals(&self) -> impl Iterator<Item = Interval> {
        (1..self.len()).map(|end| self.interval_ending_at(end))
    }

    fn interval_ending_at(&self, end: usize) -> Interval {
        let sample = |i: usize| Sample { wavelength_m: self.wavelengths_m[i], c1d_m3: self.c1d_m3[i] };
        Interval::new(sample(end - 1), sample(end))
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn kinked() -> ProfilePsd {
        ProfilePsd::from_samples(vec![1e-3, 1e-5, 1e-6], vec![1e-20, 1e-20, 1e-23])
    }

    fn per_decade(scales: u32) -> NonZeroU32 {
        NonZeroU32::new(scales).unwrap()
    }

    #[test]
    fn values_follow_the_power_law_between_samples_and_end_with_them() {
        let psd = kinked();
        assert_eq!(psd.value_at(1e-3), Some(1e-20));
        assert_eq!(psd.value_at(1e-5), Some(1e-20));
        assert_eq!(psd.value_at(1e-6), Some(1e-23));
        assert_relative_eq!(psd.value_at(1e-4).unwrap(), 1e-20, max_relative = 1e-15, epsilon = 0.0);
        assert_relative_eq!(
            psd.value_at(10f64.powf(-5.5)).unwrap(),
            10f64.powf(-21.5),
            max_relative = 1e-14,
            epsilon = 0.0
        );
        assert_eq!(psd.value_at(1.0001e-3), None);
        assert_eq!(psd.value_at(0.9999e-6), None);
        assert_eq!(psd.value_at(f64::NAN), None);
    }

    #[test]
    fn samples_that_make_no_profile_are_refused() {
        let error = |wavelengths_m: &[f64], c1d_m3: &[f64]| {
            ProfilePsd::new(wavelengths_m.to_vec(), c1d_m3.to_vec()).unwrap_err()
        };
        assert!(matches!(error(&[], &[]), PsdError::TooFewRows { rows: 0, least: 1 }));
        assert!(matches!(error(&[2.0], &[1.0, 1.0]), PsdError::LengthMismatch { wavelengths: 1, values: 2 }));
        let infinite = error(&[2.0, 1.0], &[1.0, f64::INFINITY]);
        assert!(matches!(infinite, PsdError::BadDensity { row: 2, value: f64::INFINITY }));
        let level = error(&[2.0, 2.0], &[1.0, 1.0]);
        assert!(matches!(level, PsdError::OutOfOrder { row: 2, wavelength_m: 2.0 }));
        assert_eq!(ProfilePsd::new(vec![2.0], vec![1.0]).unwrap().len(), 1);
    }

    #[test]
    fn resampling_counts_points_by_decades_and_keeps_both_ends() {
        let psd = kinked();
        let resampled = psd.resampled(per_decade(10));
        assert_eq!(resampled.len(), 31);
        assert_eq!(resampled.longest_wavelength_m(), 1e-3);
        assert_eq!(resampled.shortest_wavelength_m(), 1e-6);
        assert_eq!(resampled.c1d_m3()[30], 1e-23);
        for (&wavelength_m, &value) in resampled.wavelengths_m().iter().zip(resampled.c1d_m3()) {
            assert_eq!(psd.value_at(wavelength_m), Some(value));
        }
        assert_relative_eq!(resampled.wavelengths_m()[10], 1e-4, max_relative = 1e-15, epsilon = 0.0);
    }

    #[test]
    fn resampling_a_narrow_spectrum_leaves_its_two_ends() {
        let narrow = ProfilePsd::from_samples(vec![1.0e-6, 0.99e-6, 0.98e-6], vec![1.0, 2.0, 3.0]);
        let resampled = narrow.resampled(per_decade(1));
        assert_eq!(resampled.wavelengths_m(), [1.0e-6, 0.98e-6]);
        assert_eq!(resampled.c1d_m3(), [1.0, 3.0]);
    }

    #[test]
    fn truncation_keeps_the_scales_at_and_above_the_cutoff() {
        let psd = kinked();
        assert_eq!(psd.truncated_at(1e-5).unwrap().wavelengths_m(), [1e-3, 1e-5]);
        assert_eq!(psd.truncated_at(2e-5).unwrap().wavelengths_m(), [1e-3]);
        assert_eq!(psd.truncated_at(1e-9).unwrap(), psd);
        assert_eq!(psd.truncated_at(2e-3), None);
        assert_eq!(psd.truncated_at(f64::NAN), None);
        assert_eq!(psd.truncated_at(2e-5).unwrap().resampled(per_decade(10)).len(), 1);
    }
}
