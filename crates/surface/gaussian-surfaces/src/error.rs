//! What cannot be made into a spectrum of an area, or into a surface.

use spectrum::PsdError;
use thiserror::Error;
use units::OutOfBounds;
use units::display::length;

/// Why there is no spectrum, no band of it, or no surface.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum SurfaceError {
    /// A number outside the range in which it makes sense.
    #[error("describing a surface: {0}")]
    Bounds(#[from] OutOfBounds),
    /// One sample has no slope by which the spectrum could be continued.
    #[error(
        "converting a spectrum of profiles to that of their surface: the number of samples is {samples}, it must be at \
         least 2"
    )]
    TooFewSamples {
        /// Number of samples.
        samples: usize,
    },
    /// No roughness is left between the two ends of a band.
    #[error(
        "cutting a spectrum: between {} and {} it holds no roughness; give a longest wavelength above the shortest, both \
         where the spectrum has values",
        length(*.longest_m), length(*.shortest_m)
    )]
    EmptyBand {
        /// The longest wavelength in m.
        longest_m: f64,
        /// The shortest wavelength in m.
        shortest_m: f64,
    },
    /// A band that goes on where the spectrum has ended.
    #[error(
        "cutting a spectrum: the band from {} to {} goes beyond the spectrum, which holds {} to {}",
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
    /// Profiles of a surface have no waves shorter than the surface's shortest.
    #[error(
        "taking the profile of a surface: at the wavelength {} its spectrum is zero, as the surface's shortest waves are \
         {} long",
        length(*.wavelength_m), length(*.shortest_m)
    )]
    NoWaves {
        /// The wavelength asked for, in m.
        wavelength_m: f64,
        /// The shortest wavelength of the surface in m.
        shortest_m: f64,
    },
    /// Wavelengths that make no profile.
    #[error(transparent)]
    Samples(#[from] PsdError),
    /// A band wider than the grid can hold.
    #[error(
        "making a surface: the band from {} to {} is wider than the grid can hold: {points} points over {} hold {} \
         (one length a side) to {} (two points a wavelength)",
        length(*.longest_m), length(*.shortest_m), length(*.length_m), length(*.length_m),
        length(2.0 * .length_m / *.points as f64)
    )]
    BandTooWide {
        /// The longest wavelength of the band in m.
        longest_m: f64,
        /// The shortest wavelength of the band in m.
        shortest_m: f64,
        /// Points along the side on which it does not fit.
        points: usize,
        /// Length of that side in m.
        length_m: f64,
    },
    /// A band wider than a grid holds with as many points and lengths as areas of contact need.
    #[error(
        "laying out a grid: the band from {} to {} is wider than {points} points can hold with {points_per_shortest} points \
         for the shortest wavelength and {lengths} lengths of the longest a side; give a longest wavelength of at most {}, \
         a shortest of at least {}, or at least {} points",
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
        /// The ratio of longest to shortest wavelength that fits.
        widest: f64,
        /// Points that the shortest wavelength needs.
        points_per_shortest: f64,
        /// Lengths of the longest wavelength that a side needs.
        lengths: f64,
    },
    /// A band so narrow that no wave of the box lies in it.
    #[error(
        "making a surface: no wave of a box of {} by {} lies in the band from {} to {}; widen the band or enlarge the box",
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
    /// More points than can be numbered.
    #[error("making a surface: {points_x} by {points_y} points are none, or more than can be numbered")]
    Points {
        /// Points along x.
        points_x: usize,
        /// Points along y.
        points_y: usize,
    },
}
