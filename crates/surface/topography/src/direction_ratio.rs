//! Whether a surface looks the same along both axes of a map.

use std::num::NonZeroU32;

use serde::Serialize;

use crate::bins::{BinMean, log_bins};
use crate::overlap::{SharedBin, mean_ratio, shared_bins};
use spectrum::ProfilePsd;

/// From this ratio on, the spectra along x and y are not those of an isotropic surface.
pub const DIRECTIONS_DIFFER: f64 = 1.5;

/// In fewer shared bins the scatter of the few waves of a map may look like a direction of the surface.
const TELLING_BINS: usize = 3;

/// The spectra of a map along y and x, compared in one decade of wavelengths.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct DirectionRatio {
    /// Longest wavelength in m that both reach in the decade.
    pub longest_m: f64,
    /// Shortest.
    pub shortest_m: f64,
    /// How many bins both reach, at least 1.
    pub bins: usize,
    /// Geometric mean over these bins of the spectrum along y over that along x.
    pub ratio: f64,
}

impl DirectionRatio {
    /// Whether the decade tells that the surface has a direction, or that lines are offset against each other.
    #[must_use]
    pub fn is_anisotropic(&self) -> bool {
        self.bins >= TELLING_BINS && self.ratio.ln().abs() >= DIRECTIONS_DIFFER.ln()
    }

    /// Decade by decade, from long to short wavelengths; none where the two share no bin.
    pub(crate) fn per_decade(x: &ProfilePsd, y: &ProfilePsd, bins_per_decade: NonZeroU32) -> Vec<Self> {
        let binned = |psd| log_bins(psd, bins_per_decade, BinMean::Arithmetic);
        let decade = |wavelength_m: f64| wavelength_m.log10().floor();
        let shared = shared_bins(&binned(y), &binned(x));
        let decades = shared.chunk_by(|a, b| decade(a.wavelength_m) == decade(b.wavelength_m));
        let of_decade = |bins: &[SharedBin]| Self {
            longest_m: bins[0].wavelength_m,
            shortest_m: bins[bins.len() - 1].wavelength_m,
            bins: bins.len(),
            ratio: mean_ratio(bins),
        };
        decades.map(of_decade).collect()
    }
}
