//! Options of random surfaces of a spectrum.

use std::ops::RangeInclusive;

use spectrum::random_surfaces::{AreaSpectrum, GridBand, Phases, RandomSurfaceError, Synthesis};

use crate::surfaces::RandomSurfaces;

/// Options of random surfaces of a spectrum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RandomChoices {
    /// Number of points along each side.
    pub points: usize,
    /// Number of surfaces.
    pub realisations: usize,
    /// Seed of the random numbers.
    pub seed: u64,
    /// Longest wavelength \[m\]; by default the longest that grid and spectrum hold.
    pub longest_m: Option<f64>,
    /// Shortest wavelength \[m\]; by default that of the spectrum.
    pub shortest_m: Option<f64>,
    /// Length of a side \[m\]; by default the rest of the grid is divided between points and lengths.
    pub side_m: Option<f64>,
    /// Random part of the waves.
    pub phases: Phases,
}

impl Default for RandomChoices {
    fn default() -> Self {
        RandomChoices {
            points: 512,
            realisations: 8,
            seed: 1,
            longest_m: None,
            shortest_m: None,
            side_m: None,
            phases: Phases::default(),
        }
    }
}

impl RandomChoices {
    /// Range of the points along a side.
    pub const POINTS: RangeInclusive<u32> = 16..=16384;

    /// Range of the number of surfaces.
    pub const REALISATIONS: RangeInclusive<u32> = 1..=10_000;

    /// Returns surfaces with the spectrum in the band that the grid holds, and that band.
    ///
    /// # Errors
    /// [`RandomSurfaceError`] if the grid or the spectrum does not hold the band.
    pub fn surfaces(&self, area: &AreaSpectrum) -> Result<(RandomSurfaces, GridBand), RandomSurfaceError> {
        let grid = GridBand::in_spectrum(area, self.points, self.longest_m, self.shortest_m, self.side_m)?;
        let band = area.cut(grid.longest_m, grid.shortest_m)?;
        let synthesis = Synthesis::square(self.points, grid.length_m, self.seed, self.phases);
        Ok((RandomSurfaces { band, synthesis, realisations: self.realisations }, grid))
    }
}
