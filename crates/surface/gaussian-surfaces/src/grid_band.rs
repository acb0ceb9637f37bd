//! Which band of a spectrum a square grid holds.

use crate::area_spectrum::AreaSpectrum;
use crate::error::SurfaceError;

/// A band of wavelengths laid out on a square grid.
///
/// Areas of contact counted in points need at least 4 points for the shortest wavelength, so that a grid of every second
/// point still tells its waves apart and areas can be extrapolated; and at least 2 lengths of the longest, or single
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
    /// Points that the shortest wavelength needs.
    pub const POINTS_PER_SHORTEST: f64 = 4.0;
    /// Lengths of the longest wavelength that a side needs.
    pub const LENGTHS: f64 = 2.0;

    /// The widest band that ends at a shortest wavelength \[m\].
    #[must_use]
    pub fn widest_to(shortest_m: f64, points: usize) -> Self {
        let length_m = points as f64 * shortest_m / Self::POINTS_PER_SHORTEST;
        Self { points, length_m, longest_m: length_m / Self::LENGTHS, shortest_m }
    }

    /// A given band \[m\], with points for its shortest and lengths of its longest wavelength more than are needed by the
    /// same factor.
    ///
    /// # Errors
    /// [`SurfaceError::GridTooSmall`] where the points do not hold the band.
    pub fn of(longest_m: f64, shortest_m: f64, points: usize) -> Result<Self, SurfaceError> {
        let (points_per_shortest, lengths) = (Self::POINTS_PER_SHORTEST, Self::LENGTHS);
        let widest = points as f64 / (points_per_shortest * lengths);
        let room = widest / (longest_m / shortest_m);
        if room.is_nan() || room < 1.0 - 1e-9 {
            return Err(SurfaceError::GridTooSmall {
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

    /// The band of a spectrum on a grid, both ends and the side \[m\] as asked for. Left open, the shortest wavelength is
    /// that of the spectrum, and the longest as long as the grid holds and the spectrum goes; with a side that is given the
    /// band ends at the fewest points and lengths that it has room for.
    ///
    /// # Errors
    /// [`SurfaceError::GridTooSmall`] where the points do not hold the band; with a side that is given, the surfaces
    /// themselves are refused where not even two points and one length are left.
    pub fn in_spectrum(
        spectrum: &AreaSpectrum,
        points: usize,
        longest_m: Option<f64>,
        shortest_m: Option<f64>,
        side_m: Option<f64>,
    ) -> Result<Self, SurfaceError> {
        let Some(length_m) = side_m else {
            let shortest_m = shortest_m.unwrap_or(spectrum.shortest_m());
            let widest_m = Self::widest_to(shortest_m, points).longest_m;
            return Self::of(longest_m.unwrap_or(widest_m.min(spectrum.longest_m())), shortest_m, points);
        };
        let finest_m = Self::POINTS_PER_SHORTEST * length_m / points as f64;
        let longest_m = longest_m.unwrap_or((length_m / Self::LENGTHS).min(spectrum.longest_m()));
        let shortest_m = shortest_m.unwrap_or(finest_m.max(spectrum.shortest_m()));
        Ok(Self { points, length_m, longest_m, shortest_m })
    }

    /// Points for the shortest wavelength.
    #[must_use]
    pub fn points_per_shortest(&self) -> f64 {
        self.shortest_m / (self.length_m / self.points as f64)
    }

    /// Lengths of the longest wavelength along a side.
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
        let again = GridBand::of(band.longest_m, 1e-6, 512).unwrap();
        assert_relative_eq!(again.length_m, band.length_m, max_relative = 1e-15);
    }

    #[test]
    fn room_is_shared_between_points_and_lengths() {
        let band = GridBand::of(16e-6, 1e-6, 512).unwrap();
        assert_relative_eq!(band.points_per_shortest(), 8.0, max_relative = 1e-15);
        assert_relative_eq!(band.lengths(), 4.0, max_relative = 1e-15);
    }

    #[test]
    fn a_band_too_wide_is_refused_with_the_one_that_fits() {
        let message = GridBand::of(100e-6, 1e-6, 512).unwrap_err().to_string();
        assert_eq!(
            message,
            "laying out a grid: the band from 100 µm to 1 µm is wider than 512 points can hold with 4 points for the \
             shortest wavelength and 2 lengths of the longest a side; give a longest wavelength of at most 64 µm, a \
             shortest of at least 1.56 µm, or at least 800 points"
        );
        assert!(GridBand::of(f64::NAN, 1e-6, 512).is_err());
    }
}
