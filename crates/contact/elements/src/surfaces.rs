//! Surfaces to press: maps, or random surfaces.

use std::borrow::Cow;

use spectrum::random_surfaces::{AreaSpectrum, RandomSurfaceError, Synthesis};

use crate::boundary::Boundary;
use crate::relief::Relief;

/// Points per wave below which a grid no longer resolves the shortest wave.
const FEWEST_POINTS: f64 = 2.0;

/// Surfaces to press.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Surfaces {
    /// Surfaces as measured.
    Maps(Vec<Relief>),
    /// Surfaces with the same spectrum.
    Random(RandomSurfaces),
}

/// Random surfaces of a band of a spectrum, numbered from 0.
///
/// The heights of each are scaled such that its rms gradient, by the sum over its waves, is that of the band: areas
/// depend on the pressure over E* h', and most of the scatter of small boxes comes from their gradients.
#[derive(Clone, Debug, PartialEq)]
pub struct RandomSurfaces {
    /// Spectrum, zero outside its band.
    pub band: AreaSpectrum,
    /// Grid, seed, and random part of the waves.
    pub synthesis: Synthesis,
    /// Number of surfaces.
    pub realisations: usize,
}

impl Surfaces {
    /// Number of surfaces.
    #[must_use]
    pub fn count(&self) -> usize {
        match self {
            Surfaces::Maps(maps) => maps.len(),
            Surfaces::Random(random) => random.realisations,
        }
    }

    /// Returns the surface of a number.
    ///
    /// # Errors
    /// [`RandomSurfaceError`] for a band that the grid does not hold.
    pub fn relief(&self, number: usize) -> Result<Cow<'_, Relief>, RandomSurfaceError> {
        match self {
            Surfaces::Maps(maps) => Ok(Cow::Borrowed(&maps[number])),
            Surfaces::Random(random) => random.relief(number).map(Cow::Owned),
        }
    }

    /// Rms gradient of one of the surfaces: that of the band, which all random surfaces have, or that of a map from
    /// neighbouring points.
    #[must_use]
    pub fn rms_gradient(&self, relief: &Relief) -> f64 {
        match self {
            Surfaces::Maps(_) => relief.rms_gradient(),
            Surfaces::Random(random) => random.band.mean_square_gradient().sqrt(),
        }
    }

    /// Points along y and along x of each surface; none of no surface.
    #[must_use]
    pub fn points(&self) -> Option<[usize; 2]> {
        match self {
            Surfaces::Maps(maps) => maps.first().map(|relief| [relief.rows, relief.columns]),
            Surfaces::Random(random) => Some([random.synthesis.points_y, random.synthesis.points_x]),
        }
    }

    /// Lengths of each surface along y and along x \[m\]; none of no surface.
    #[must_use]
    pub fn size_m(&self) -> Option<[f64; 2]> {
        match self {
            Surfaces::Maps(maps) => maps.first().map(|relief| [relief.length_y_m, relief.length_x_m]),
            Surfaces::Random(random) => Some([random.synthesis.length_y_m, random.synthesis.length_x_m]),
        }
    }

    /// Rms gradients: one for each map, from neighbouring points, or that of the band of all random surfaces.
    #[must_use]
    pub fn rms_gradients(&self) -> Vec<f64> {
        match self {
            Surfaces::Maps(maps) => maps.iter().map(Relief::rms_gradient).collect(),
            Surfaces::Random(random) => vec![random.band.mean_square_gradient().sqrt()],
        }
    }

    /// Surface on every second point, if that still resolves its waves: always for a map, because its shortest wave
    /// is unknown.
    pub(crate) fn coarser(&self, relief: &Relief) -> Option<Relief> {
        match self {
            Surfaces::Maps(_) => {
                let is_map = |coarse: &Relief| coarse.rows > 1 && coarse.columns > 1;
                let has_heights =
                    |coarse: &Relief| coarse.is_missing.is_empty() || coarse.is_missing.contains(&false);
                relief.every_second_of_map().filter(|coarse| is_map(coarse) && has_heights(coarse))
            }
            Surfaces::Random(random) => {
                let [spacing_x_m, spacing_y_m] = relief.spacings_m();
                let points = random.band.shortest_m() / (2.0 * spacing_x_m.max(spacing_y_m));
                let shows = points >= FEWEST_POINTS * (1.0 - 1e-9);
                if shows { relief.every_second_point() } else { None }
            }
        }
    }
}

impl RandomSurfaces {
    fn relief(&self, number: usize) -> Result<Relief, RandomSurfaceError> {
        let surface = self.band.surface(&self.synthesis, number as u64)?;
        let factor = (self.band.mean_square_gradient() / surface.mean_square_gradient()).sqrt();
        let surface = surface.scaled(factor);
        Ok(Relief {
            rows: surface.points_y,
            columns: surface.points_x,
            length_x_m: surface.length_x_m,
            length_y_m: surface.length_y_m,
            heights_m: surface.heights_m,
            boundary: Boundary::Periodic,
            is_missing: Vec::new(),
        })
    }
}
