//! Spectra of the study: self-affine surfaces, given in waves per box.

use std::io;

use measurements::Files;
use serde::{Deserialize, Serialize};
use spectrum::random_surfaces::{AreaSpectrum, RandomSurfaceError, SelfAffine, Size};

/// Side of the periodic box \[m\]. Areas do not depend on it: only ratios of lengths matter.
pub const BOX_M: f64 = 1e-3;

/// Contact modulus E* of all surfaces \[Pa\]. Elastic areas depend on p/(E* h') alone; the laws of asperities that
/// yield need more of a material, for which this is a metal.
pub const CONTACT_MODULUS_PA: f64 = 100e9;

/// Rms gradient h' of every surface: small enough for a half-space.
pub const RMS_GRADIENT: f64 = 0.05;

/// Self-affine spectrum: Ciso is level from the first wave of the box to the roll-off, falls as q^(-2(1 + H)) from
/// there to the last one, and is zero outside.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct WaveBand {
    /// Hurst exponent H.
    pub hurst_exponent: f64,
    /// Longest wavelength, in waves per box.
    pub first_wave: f64,
    /// Roll-off, in waves per box; the first wave without a roll-off.
    pub rolloff_wave: f64,
    /// Shortest wavelength, in waves per box.
    pub last_wave: f64,
}

impl WaveBand {
    /// Spectrum of the band, at [`RMS_GRADIENT`].
    ///
    /// # Errors
    /// The errors of [`AreaSpectrum::self_affine`].
    pub fn spectrum(&self) -> Result<AreaSpectrum, RandomSurfaceError> {
        AreaSpectrum::self_affine(&SelfAffine {
            hurst_exponent: self.hurst_exponent,
            longest_m: BOX_M / self.first_wave,
            rolloff_m: BOX_M / self.rolloff_wave,
            shortest_m: BOX_M / self.last_wave,
            size: Size::RmsGradient(RMS_GRADIENT),
        })
    }

    /// Table of profiles of the spectrum of the band, with its waves this many times as short.
    ///
    /// # Errors
    /// The errors of [`AreaSpectrum::profile`].
    pub(crate) fn file(
        &self,
        spectrum: &AreaSpectrum,
        shorter: f64,
    ) -> Result<SpectrumFile, RandomSurfaceError> {
        // Profiles have no waves as short as the shortest of the surface.
        let (longest_m, shortest_m) = (BOX_M / self.first_wave, 1.05 * BOX_M / self.last_wave);
        let wavelengths_m: Vec<f64> =
            (0..=40).map(|at| longest_m * (shortest_m / longest_m).powf(f64::from(at) / 40.0)).collect();
        let profile = spectrum.profile(&wavelengths_m)?;
        let mut csv = "wavelength_m,C1D_m3\n".to_owned();
        for (wavelength_m, c1d_m3) in profile.wavelengths_m().iter().zip(profile.c1d_m3()) {
            csv += &format!("{:e},{:e}\n", wavelength_m / shorter, c1d_m3 / shorter);
        }
        Ok(SpectrumFile(csv))
    }

    /// Nayak's alpha = m0 m4/m2^2 of its profiles.
    ///
    /// # Errors
    /// The errors of [`WaveBand::spectrum`].
    pub fn alpha(&self) -> Result<f64, RandomSurfaceError> {
        let moments = self.spectrum()?.moments();
        Ok(moments.m0_m2 * moments.m4_per_m2 / (moments.m2 * moments.m2))
    }
}

/// Spectrum in memory, as the file that a scene names.
pub(crate) struct SpectrumFile(pub String);

impl Files for SpectrumFile {
    fn read(&self, _: &str) -> io::Result<Vec<u8>> {
        Ok(self.0.clone().into_bytes())
    }

    fn read_beside(&self, _: &str, _: &str) -> io::Result<Option<Vec<u8>>> {
        Ok(None)
    }
}

/// Dimensionless load on a surface.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct TrialLoad {
    /// Load p/(E* h').
    pub pressure_over_gradient: f64,
    /// Spread over hardness s/H, with s = E* h'/2 the rms pressure that would flatten the surface; `None` if it is
    /// elastic throughout.
    pub spread_over_hardness: Option<f64>,
}

impl TrialLoad {
    /// Creates an elastic load.
    #[must_use]
    pub fn elastic(pressure_over_gradient: f64) -> Self {
        Self { pressure_over_gradient, spread_over_hardness: None }
    }

    /// Nominal pressure \[Pa\].
    #[must_use]
    pub fn nominal_pressure_pa(&self) -> f64 {
        self.pressure_over_gradient * (CONTACT_MODULUS_PA * RMS_GRADIENT)
    }

    /// Hardness H \[Pa\].
    #[must_use]
    pub fn hardness_pa(&self) -> Option<f64> {
        self.spread_over_hardness.map(|ratio| spread_pa() / ratio)
    }
}

/// Spread s = E* h'/2 \[Pa\].
#[must_use]
pub fn spread_pa() -> f64 {
    0.5 * CONTACT_MODULUS_PA * RMS_GRADIENT
}
