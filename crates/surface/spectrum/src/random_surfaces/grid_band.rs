//! Bands of a spectrum on square grids.

use crate::random_surfaces::area_spectrum::AreaSpectrum;
use crate::random_surfaces::error::RandomSurfaceError;

/// A band of wavelengths laid out on a square grid.
///
/// Contact areas counted in points need at least 4 points per shortest wavelength: the grid of every second point then
/// still resolves all waves, and areas can be extrapolated. A side needs at least 2 longest wavelengths, or single
/// surfaces scatter by several per cent at light loads.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct GridBand {
    /// Points along a side.
    pub points: usize,
    /// Length of a side \[m\].
    pub length_m: f64,
    /// The longest wavelength \[m\].
    pub longest_m: f64,
    /// The shortest wavelength \[m\].
    pub shortest_m: f64,
}

impl GridBand {
    /// Points needed per shortest wavelength.
    pub const POINTS_PER_SHORTEST: f64 = 4.0;
    /// Longest wavelengths needed per side.
    pub const LENGTHS: f64 = 2.0;

    /// Returns the widest band with this shortest wavelength \[m\] on `points` points a side.
    #[must_use]
    pub fn widest_to(shortest_m: f64, points: usize) -> Self {
        let length_m = points as f64 * shortest_m / Self::POINTS_PER_SHORTEST;
        Self { points, length_m, longest_m: length_m / Self::LENGTHS, shortest_m }
    }

    /// Lays out a given band \[m\]. Spare points are shared: points per shortest wavelength and longest wavelengths per
    /// side exceed their minimum by the same factor.
    ///
    /// # Errors
    /// [`RandomSurfaceError::GridTooSmall`] if the points do not hold the band.
    pub fn new(longest_m: f64, shortest_m: f64, points: usize) -> Result<Self, RandomSurfaceError> {
        let (points_per_shortest, lengths) = (Self::POINTS_PER_SHORTEST, Self::LENGTHS);
        let widest = points as f64 / (points_per_shortest * lengths);
        let room = widest / (longest_m / shortest_m);
        if room.is_nan() || room < 1.0 - 1e-9 {
            return Err(RandomSurfaceError::GridTooSmall {
                longest_m,
                shortest_m,
                points,
                widest,
                points_per_shortest,
                lengths,
            });
        }
        Ok(Self { points, length_m: lengths * longest_m * room.max(1.0).sqrt(), longest_m, shortest_m })
    }

    /// Lays out a band of a spectrum; both ends and the side \[m\] may be left open.
    ///
    /// Without a side, the shortest wavelength defaults to that of the spectrum, and the longest to the longest that
    /// the grid and the spectrum hold. With a given side, the ends default to the minimum of points and lengths.
    ///
    /// # Errors
    /// [`RandomSurfaceError::GridTooSmall`] if the points do not hold the band. With a given side nothing is refused here;
    /// making the surface fails with fewer than two points per shortest wavelength or one longest wavelength per side.
    pub fn in_spectrum(
        spectrum: &AreaSpectrum,
        points: usize,
        longest_m: Option<f64>,
        shortest_m: Option<f64>,
        side_m: Option<f64>,
    ) -> Result<Self, RandomSurfaceError> {
        let Some(length_m) = side_m else {
            let shortest_m = shortest_m.unwrap_or(spectrum.shortest_m());
            let widest_m = Self::widest_to(shortest_m, points).longest_m;
            return Self::new(longest_m.unwrap_or(widest_m.min(spectrum.longest_m())), shortest_m, points);
        };
        let finest_m = Self::POINTS_PER_SHORTEST * length_m / points as f64;
        let longest_m = longest_m.unwrap_or((length_m / Self::LENGTHS).min(spectrum.longest_m()));
        let shortest_m = shortest_m.unwrap_or(finest_m.max(spectrum.shortest_m()));
        Ok(Self { points, length_m, longest_m, shortest_m })
    }

    /// Points per shortest wavelength.
    #[must_use]
    pub fn points_per_shortest(&self) -> f64 {
        self.shortest_m / (self.length_m / self.points as f64)
    }

    /// Longest wavelengths per side.
    #[must_use]
    pub fn lengths(&self) -> f64 {
        self.length_m / self.longest_m
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    #[test]
    fn the_widest_band_has_the_least_points_and_lengths() {
        let band = GridBand::widest_to(1e-6, 512);
        assert_relative_eq!(band.longest_m, 64e-6, max_relative = 1e-15);
        assert_relative_eq!(band.points_per_shortest(), 4.0, max_relative = 1e-15);
        assert_relative_eq!(band.lengths(), 2.0, max_relative = 1e-15);
        let again = GridBand::new(band.longest_m, 1e-6, 512).unwrap();
        assert_relative_eq!(again.length_m, band.length_m, max_relative = 1e-15);
    }

    #[test]
    fn room_is_shared_between_points_and_lengths() {
        let band = GridBand::new(16e-6, 1e-6, 512).unwrap();
        assert_relative_eq!(band.points_per_shortest(), 8.0, max_relative = 1e-15);
        assert_relative_eq!(band.lengths(), 4.0, max_relative = 1e-15);
    }

    #[test]
    fn a_band_too_wide_is_refused_with_the_one_that_fits() {
        let message = GridBand::new(100e-6, 1e-6, 512).unwrap_err().to_string();
        assert_eq!(
            message,
            "the band from 100 µm to 1 µm is too wide for 512 points a side (4 per shortest wavelength, 2 longest \
             wavelengths per side); give a longest wavelength of at most 64 µm, a shortest of at least 1.56 µm, or at \
             least 800 points"
        );
        assert!(GridBand::new(f64::NAN, 1e-6, 512).is_err());
    }
}
