//! The two-dimensional spectrum of a map, averaged over directions.

use std::f64::consts::TAU;

use serde::Serialize;

use crate::band::ReliableBand;
use crate::error::TransformError;
use crate::sums::sum_of;
use spectrum::{Convention, Psd};

/// The two-dimensional spectrum C2D = |h~|^2/(Lx Ly) \[m^4\] of a map in rings of width dq = 2 pi/max(Lx, Ly).
///
/// Ring k = 1, 2, ... holds the modes with k - 1/2 <= q/dq < k + 1/2. Every mode but q = 0 is in a ring, so Sum C2D/(Lx
/// Ly) over all modes is the variance of the prepared heights. The edge of the sampled rectangle cuts rings beyond the
/// smaller Nyquist wavevector of the two directions: they belong to the variance, not to the spectrum. Rings are wider
/// if sides or pixels differ so much that there would be more than a million.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ArealSpectrum {
    /// Sizes Lx and Ly of the period in m.
    pub sizes_m: [f64; 2],
    /// Smaller of the Nyquist wavevectors of the two directions \[rad/m\]; rings beyond it are incomplete.
    pub nyquist_rad_per_m: f64,
    /// The rings that hold a mode, from long to short wavelengths.
    pub bins: Vec<RadialBin>,
    /// Variance in m^2 of the prepared heights about their mean, in real space.
    pub variance_m2: f64,
    /// Number of first rings that do not show the spectrum of the surface.
    pub flagged_bins: usize,
}

/// The modes of a ring, those at q and at -q both counted.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RadialBin {
    /// Mean magnitude of the wavevectors of the modes \[rad/m\].
    pub wavevector_rad_per_m: f64,
    /// Number of modes, at least 1.
    pub modes: u64,
    /// Sum of C2D over the modes \[m^4\].
    pub sum_m4: f64,
    /// Sum of q^2 C2D over the modes, each with its own wavevector \[m^2\].
    #[serde(skip)]
    pub slope_sum_m2: f64,
    /// Sum of q^4 C2D over the modes, each with its own wavevector; 1.
    #[serde(skip)]
    pub curvature_sum: f64,
}

impl RadialBin {
    /// Returns the radial mean Ciso \[m^4\].
    pub fn ciso_m4(&self) -> f64 {
        self.sum_m4 / self.modes as f64
    }
}

impl ArealSpectrum {
    /// Variance from the spectrum, Sum C2D/(Lx Ly) over all modes but q = 0 \[m^2\].
    pub fn spectral_variance_m2(&self) -> f64 {
        let sums_m4: Vec<f64> = self.bins.iter().map(|bin| bin.sum_m4).collect();
        sum_of(&sums_m4, |sum_m4| sum_m4) / self.sizes_m[0] / self.sizes_m[1]
    }

    /// Ratio of spectral to real-space variance, 1 to rounding.
    pub fn parseval_share(&self) -> f64 {
        let spectral_m2 = self.spectral_variance_m2();
        if spectral_m2 == self.variance_m2 { 1.0 } else { spectral_m2 / self.variance_m2 }
    }

    /// Returns Ciso in the rings that show the surface: complete, inside the band, not flagged, and above 0.
    ///
    /// # Errors
    /// [`TransformError::NothingReliable`] for fewer than two rings, [`TransformError::Overflow`] for heights whose
    /// squares overflow.
    pub fn ciso(&self, band: &ReliableBand) -> Result<Psd, TransformError> {
        let complete = self.bins.iter().skip(self.flagged_bins).filter(|bin| {
            bin.wavevector_rad_per_m <= self.nyquist_rad_per_m * (1.0 + 1e-12) && bin.sum_m4 > 0.0
        });
        let samples = complete.map(|bin| (TAU / bin.wavevector_rad_per_m, bin.ciso_m4()));
        let (wavelengths_m, values): (Vec<_>, Vec<_>) =
            samples.filter(|&(wavelength_m, _)| band.contains(wavelength_m)).unzip();
        if values.len() < 2 {
            let longest_m = self.sizes_m[0].max(self.sizes_m[1]) / (self.flagged_bins + 1) as f64;
            return Err(TransformError::NothingReliable { shortest_m: band.shortest_m, longest_m });
        }
        Ok(Psd::new(wavelengths_m, values, Convention::Ciso)?)
    }
}
