//! The spectrum of lines on the bins of their own length, and its derivatives.

use std::f64::consts::TAU;

use serde::Serialize;

use crate::band::ReliableBand;
use crate::error::TransformError;
use crate::sums::dot;
use spectrum::ProfilePsd;

/// The spectrum C1D \[m^3\] at q = 2 pi n/L, n = 1, 2, ..., of one line or averaged over the lines of a map:
/// C1D = |h~|^2/L, h~(q) = Int h e^(-iqx) dx.
///
/// q = 0 is left out, so (1/pi) Sum C1D dq is the variance of the prepared heights about their mean. For an even number
/// of evenly spaced points the last bin, at their Nyquist wavevector, counts half.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[non_exhaustive]
pub struct LineSpectrum {
    /// Length L of the period in m; the first bin is at q = 2 pi/L.
    pub length_m: f64,
    /// Distance of neighbouring points \[m\]; `None` if it is uneven.
    pub spacing_m: Option<f64>,
    /// Values \[m^3\] from the bin n = 1 on; 0 for a wavelength that the lines do not contain.
    pub c1d_m3: Vec<f64>,
    pub(crate) ends_at_nyquist: bool,
    /// Variance of the prepared heights in real space \[m^2\]: detrended, windowed, each line about its own mean.
    pub variance_m2: f64,
    /// Number of averaged lines: one, or the rows of the map.
    pub lines: usize,
    /// Number of first bins that do not show the spectrum of the surface, see
    /// [`Preparation::flagged_bins`](crate::Preparation::flagged_bins).
    pub flagged_bins: usize,
    /// Spectra \[m^3\] of parts of a map at the same wavevectors, each part a group of neighbouring lines; empty for a
    /// single line or few.
    #[serde(skip)]
    pub parts_m3: Vec<Vec<f64>>,
    /// Independent lines of the first bins, see [`LineSpectrum::independent_lines`]; empty for a single line.
    #[serde(skip)]
    pub(crate) independent: Vec<f64>,
}

/// Kind of derivative computed from a spectrum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DerivativeOf {
    /// Derivative of the continuous surface: factors q^2 and q^4.
    Continuum,
    /// Differences of neighbouring points a apart: factors (2 sin(qa/2)/a)^2 and its square.
    Differences,
}

/// Root mean square slope and curvature along scan lines.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RmsDerivatives {
    /// Root mean square slope.
    pub slope: f64,
    /// Root mean square second derivative in 1/m; `None` for a line of two points.
    pub curvature_per_m: Option<f64>,
}

impl LineSpectrum {
    /// Wavevector of each value \[rad/m\].
    pub fn wavevectors_rad_per_m(&self) -> impl ExactSizeIterator<Item = f64> + '_ {
        (0..self.c1d_m3.len()).map(|bin| TAU * (bin + 1) as f64 / self.length_m)
    }

    /// Wavelength of each value \[m\], from long to short.
    pub fn wavelengths_m(&self) -> impl ExactSizeIterator<Item = f64> + '_ {
        (0..self.c1d_m3.len()).map(|bin| self.length_m / (bin + 1) as f64)
    }

    /// Equivalent number of independent lines in bin n >= 1, from 1 to [`lines`](Self::lines): neighbouring lines of a
    /// map are correlated at long wavelengths. Measured in the first bins and extrapolated in proportion to n.
    pub fn independent_lines(&self, n: usize) -> f64 {
        let all = self.lines as f64;
        let measured = match (self.independent.get(n.saturating_sub(1)), self.independent.last()) {
            (Some(measured), _) => *measured,
            (None, Some(last)) => last * n as f64 / self.independent.len() as f64,
            (None, None) => 1.0,
        };
        measured.clamp(1.0, all.max(1.0))
    }

    /// Variance from the spectrum, (1/pi) Sum C1D dq \[m^2\].
    pub fn spectral_variance_m2(&self) -> f64 {
        self.moment(|_| 1.0)
    }

    /// Ratio of spectral to real-space variance; 1 for a flat surface.
    ///
    /// For evenly spaced points 1 to rounding, by Parseval's theorem. For unevenly spaced points the share of the
    /// variance at the wavelengths of the spectrum; the rest lies below its shortest one.
    pub fn parseval_share(&self) -> f64 {
        let spectral_m2 = self.spectral_variance_m2();
        if spectral_m2 == self.variance_m2 { 1.0 } else { spectral_m2 / self.variance_m2 }
    }

    /// Returns true if the bin at q = 2 pi/L holds more than the rounding of the whole variance.
    pub fn holds_fundamental(&self) -> bool {
        let variance_m2 = 2.0 / self.length_m * self.c1d_m3[0];
        variance_m2 > self.variance_m2 * (64.0 * f64::EPSILON).powi(2)
    }

    /// Root mean square slope and curvature along the lines over all bins; `None` for differences of uneven points.
    pub fn rms_derivatives(&self, of: DerivativeOf) -> Option<RmsDerivatives> {
        let squared_factor = |q_rad_per_m: f64| match of {
            DerivativeOf::Continuum => Some(q_rad_per_m * q_rad_per_m),
            DerivativeOf::Differences => {
                let spacing_m = self.spacing_m?;
                Some((2.0 * (0.5 * q_rad_per_m * spacing_m).sin() / spacing_m).powi(2))
            }
        };
        squared_factor(1.0)?;
        let factor = |q_rad_per_m| squared_factor(q_rad_per_m).unwrap_or(0.0);
        Some(RmsDerivatives {
            slope: self.moment(factor).sqrt(),
            curvature_per_m: Some(self.moment(|q_rad_per_m| factor(q_rad_per_m).powi(2)).sqrt()),
        })
    }

    /// Mean square height of the wave of each value, C1D dq/pi \[m^2\]; the sum is
    /// [`spectral_variance_m2`](Self::spectral_variance_m2).
    pub fn mean_squares_m2(&self) -> impl ExactSizeIterator<Item = f64> + '_ {
        let last = self.c1d_m3.len().saturating_sub(1);
        self.c1d_m3.iter().enumerate().map(move |(bin, c1d_m3)| {
            let share = if self.ends_at_nyquist && bin == last { 0.5 } else { 1.0 };
            share * 2.0 / self.length_m * c1d_m3
        })
    }

    /// Computes (1/pi) Sum factor(q) C1D dq.
    fn moment(&self, factor: impl Fn(f64) -> f64) -> f64 {
        let mut factors: Vec<f64> = self.wavevectors_rad_per_m().map(factor).collect();
        if let (true, Some(last)) = (self.ends_at_nyquist, factors.last_mut()) {
            *last *= 0.5;
        }
        2.0 / self.length_m * dot(&factors, &self.c1d_m3)
    }

    /// Returns the bins that show the surface: inside the band, not flagged, and above 0.
    ///
    /// # Errors
    /// [`TransformError::NothingReliable`] without such bins, [`TransformError::Overflow`] for heights whose squares
    /// overflow.
    pub fn profile(&self, band: &ReliableBand) -> Result<ProfilePsd, TransformError> {
        let samples = self.wavelengths_m().zip(self.c1d_m3.iter().copied()).skip(self.flagged_bins);
        let (wavelengths_m, c1d_m3): (Vec<_>, Vec<_>) =
            samples.filter(|&(wavelength_m, c1d_m3)| band.contains(wavelength_m) && c1d_m3 > 0.0).unzip();
        if wavelengths_m.is_empty() {
            let longest_m = self.length_m / (self.flagged_bins + 1) as f64;
            return Err(TransformError::NothingReliable { shortest_m: band.shortest_m, longest_m });
        }
        Ok(ProfilePsd::new(wavelengths_m, c1d_m3)?)
    }

    /// Makes the spectrum of `lines` evenly spaced lines from Sum |F|^2 of their unnormalised transforms from n = 1 on,
    /// and from the sum of their mean squared deviations.
    pub(crate) fn from_even_lines(
        spacing_m: f64,
        points: usize,
        lines: usize,
        power_m2: Vec<f64>,
        variances_m2: f64,
        flagged_bins: usize,
    ) -> Self {
        // (L/N)^2 |F|^2/L, averaged over the lines.
        let unit_m = spacing_m / (points as f64 * lines as f64);
        Self {
            length_m: spacing_m * points as f64,
            spacing_m: Some(spacing_m),
            c1d_m3: power_m2.into_iter().map(|power_m2| unit_m * power_m2).collect(),
            ends_at_nyquist: points.is_multiple_of(2),
            variance_m2: variances_m2 / lines as f64,
            lines,
            flagged_bins,
            parts_m3: Vec::new(),
            independent: Vec::new(),
        }
    }
}
