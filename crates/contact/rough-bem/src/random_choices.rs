//! What there is to choose of random surfaces of a spectrum.

use std::ops::RangeInclusive;

use gaussian_surfaces::{AreaSpectrum, GridBand, Phases, SurfaceError, Synthesis};

use crate::surfaces::RandomSurfaces;

/// How random surfaces are made of a spectrum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RandomChoices {
    /// Points along each side.
    pub points: usize,
    /// How many surfaces.
    pub realisations: usize,
    /// The seed of what is random.
    pub seed: u64,
    /// The longest wavelength \[m\]; where not given, as long as the grid holds and the spectrum goes.
    pub longest_m: Option<f64>,
    /// The shortest wavelength \[m\]; where not given, that of the spectrum.
    pub shortest_m: Option<f64>,
    /// Length of a side \[m\]; where not given, what is left of the grid is shared between points and lengths.
    pub side_m: Option<f64>,
    /// What is random.
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
    /// Points along a side that may be asked for.
    pub const POINTS: RangeInclusive<u32> = 16..=16384;

    /// Surfaces that have a spectrum in the band that the grid holds, and that band.
    ///
    /// # Errors
    /// [`SurfaceError`] where the grid does not hold the band, or the spectrum does not.
    pub fn surfaces(&self, area: &AreaSpectrum) -> Result<(RandomSurfaces, GridBand), SurfaceError> {
        let grid = GridBand::in_spectrum(area, self.points, self.longest_m, self.shortest_m, self.side_m)?;
        let band = area.cut(grid.longest_m, grid.shortest_m)?;
        let synthesis = Synthesis::square(self.points, grid.length_m, self.seed, self.phases);
        Ok((RandomSurfaces { band, synthesis, realisations: self.realisations }, grid))
    }
}
