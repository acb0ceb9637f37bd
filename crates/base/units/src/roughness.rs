//! A wavelength of the roughness with its amplitude: output of spectra, input of stacked models.

/// A sinusoid that represents one wavelength of the roughness.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Scale {
    /// Wavelength lambda > 0 \[m\].
    pub wavelength_m: f64,
    /// Amplitude Delta >= 0 \[m\], from the mean line to a crest.
    pub amplitude_m: f64,
}

impl Scale {
    /// Aspect ratio B = Delta/lambda (Jackson & Jacobs, section 1.6 of `docs/models.md`).
    #[must_use]
    #[inline]
    pub fn aspect_ratio(&self) -> f64 {
        self.amplitude_m / self.wavelength_m
    }
}
