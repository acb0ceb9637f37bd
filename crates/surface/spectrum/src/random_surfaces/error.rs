//! Errors of spectra of areas and of surfaces.

use crate::PsdError;
use thiserror::Error;
use units::OutOfBounds;
use units::display::length;

/// Errors of making a spectrum of an area, a band of it, or a surface.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum RandomSurfaceError {
    /// A number outside its bound.
    #[error("describing a surface: {0}")]
    Bounds(#[from] OutOfBounds),
    /// A single sample has no slope with which to continue the spectrum.
    #[error("converting a spectrum of profiles to that of a surface: {samples} samples; give at least 2")]
    TooFewSamples {
        /// Number of samples.
        samples: usize,
    },
    /// A band without roughness.
    #[error(
        "no roughness between {} and {}; give a longest wavelength above the shortest, both within the spectrum",
        length(*.longest_m), length(*.shortest_m)
    )]
    EmptyBand {
        /// The longest wavelength in m.
        longest_m: f64,
        /// The shortest wavelength in m.
        shortest_m: f64,
    },
    /// A band that extends beyond the spectrum.
    #[error(
        "the band from {} to {} extends beyond the spectrum, which covers {} to {}",
        length(*.longest_m), length(*.shortest_m), length(*.spectrum_longest_m), length(*.spectrum_shortest_m)
    )]
    BeyondSpectrum {
        /// The longest wavelength asked for, in m.
        longest_m: f64,
        /// The shortest wavelength asked for, in m.
        shortest_m: f64,
        /// The longest wavelength of the spectrum in m.
        spectrum_longest_m: f64,
        /// The shortest wavelength of the spectrum in m.
        spectrum_shortest_m: f64,
    },
    /// A wavelength below the shortest of the surface, where its profiles have no waves.
    #[error(
        "the profile of the surface has no waves at {}: the shortest wave of the surface is {}; give longer wavelengths",
        length(*.wavelength_m), length(*.shortest_m)
    )]
    NoWaves {
        /// The wavelength asked for, in m.
        wavelength_m: f64,
        /// The shortest wavelength of the surface in m.
        shortest_m: f64,
    },
    /// Wavelengths that are not those of a profile.
    #[error(transparent)]
    Samples(#[from] PsdError),
    /// A band wider than the grid can hold.
    #[error(
        "the band from {} to {} is wider than the grid holds: {points} points over {} hold {} (one wave per side) to {} \
         (two points per wave)",
        length(*.longest_m), length(*.shortest_m), length(*.length_m), length(*.length_m),
        length(2.0 * .length_m / *.points as f64)
    )]
    BandTooWide {
        /// The longest wavelength of the band in m.
        longest_m: f64,
        /// The shortest wavelength of the band in m.
        shortest_m: f64,
        /// Points along the side that is too coarse or too short.
        points: usize,
        /// Length of that side in m.
        length_m: f64,
    },
    /// A band wider than a grid holds with the points and lengths that contact areas need.
    #[error(
        "the band from {} to {} is too wide for {points} points a side ({points_per_shortest} per shortest wavelength, \
         {lengths} longest wavelengths per side); give a longest wavelength of at most {}, a shortest of at least {}, or \
         at least {} points",
        length(*.longest_m), length(*.shortest_m), length(.shortest_m * .widest), length(.longest_m / .widest),
        (.longest_m / .shortest_m * .points_per_shortest * .lengths * (1.0 - 1e-9)).ceil()
    )]
    GridTooSmall {
        /// The longest wavelength of the band in m.
        longest_m: f64,
        /// The shortest wavelength of the band in m.
        shortest_m: f64,
        /// Points along a side.
        points: usize,
        /// Largest ratio of longest to shortest wavelength that fits.
        widest: f64,
        /// Points needed per shortest wavelength.
        points_per_shortest: f64,
        /// Longest wavelengths needed per side.
        lengths: f64,
    },
    /// A band so narrow that it contains no wave of the box.
    #[error(
        "no wave of a box of {} by {} lies in the band from {} to {}; widen the band or enlarge the box",
        length(*.length_x_m), length(*.length_y_m), length(*.longest_m), length(*.shortest_m)
    )]
    NoModes {
        /// The longest wavelength of the band in m.
        longest_m: f64,
        /// The shortest wavelength of the band in m.
        shortest_m: f64,
        /// Length of the box along x in m.
        length_x_m: f64,
        /// Length of the box along y in m.
        length_y_m: f64,
    },
    /// No points, or too many to index.
    #[error("a grid of {points_x} by {points_y} points; give at least 1 and at most {} points", u32::MAX)]
    Points {
        /// Points along x.
        points_x: usize,
        /// Points along y.
        points_y: usize,
    },
}
