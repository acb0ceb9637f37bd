//! Power spectra of rough surfaces: reads their files, converts their conventions, and computes the inputs of contact
//! models.
//!
//! ```
//! use spectrum::{AsperityParameters, Normalisation, Psd, ReadOptions, cumulative_moments, read_psd};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let file = "wavelength_nm,C1D_nm3\n1000,4000\n100,30\n10,0.1\n";
//! let psd: Psd = read_psd(file.as_bytes(), &ReadOptions::default())?.psd;
//! let moments = cumulative_moments(&psd.profile()?, Normalisation::Parseval);
//! let asperities = AsperityParameters::from_moments(&moments[1]).ok_or("a flat surface")?;
//! assert!((moments[1].rms_height_m() - 2.640e-9).abs() < 0.001e-9);
//! assert!((asperities.radius_m - 18.91e-9).abs() < 0.01e-9);
//! # Ok(())
//! # }
//! ```
//!
//! The nouns:
//! * [`Psd`]: a sampled power spectrum with its [`Convention`], validated and sorted from long wavelengths on;
//! * [`ProfilePsd`]: the working type, the spectrum C1D in m^3, a power law between neighbouring samples;
//! * [`Moments`]: the spectral moments m0, m2, m4 down to a cutoff, and [`AsperityParameters`] from them;
//! * [`Scale`]: one wavelength with its amplitude, for models that stack sinusoids;
//! * [`SelfAffineFit`]: Hurst exponent and roll-off;
//! * [`SelfAffineProfile`]: the spectrum that has given [`RoughnessParameters`];
//! * [`Superposition`]: the composite spectrum of two rough surfaces;
//! * [`PowerLaw`] and [`AbelIntegral`]: pieces of a function of the wavevector, and the integral that joins line and
//!   area spectra;
//! * [`random_surfaces`]: the spectrum of an area and, behind a feature, random surfaces that have it;
//! * [`PsdFile`]: a [`Psd`] as read from text, JSON or a workbook, with the comments and the assumptions made.
//!
//! Not here: paths, printing, threads. The crate `scans` reads heights and `topography` computes their spectra.
//! [`Psd::profile`] takes the profiles of a surface from its spectrum, [`random_surfaces::AreaSpectrum`] the surface from its profiles.

mod abel;
mod amplitude;
mod approximate;
mod convention;
mod hole;
mod interval;
#[cfg(feature = "fit")]
mod least_squares;
mod mccool;
mod moments;
mod power_law;
mod profile;
mod psd;
pub mod random_surfaces;
mod read;
mod roughness_parameters;
mod samples;
mod self_affine;
mod self_affine_fit;
mod superpose;
mod surface_waves;

pub use abel::AbelIntegral;
pub use amplitude::{AmplitudeDefinition, amplitudes};
pub use convention::{Convention, ConversionError};
pub use hole::{HOLE_FACTOR, Hole};
pub use mccool::AsperityParameters;
pub use moments::{Moments, Normalisation, cumulative_moments, cumulative_moments_to, interval_integrals};
pub use power_law::PowerLaw;
pub use profile::ProfilePsd;
pub use psd::Psd;
pub use read::{
    Abscissa, Encoding, Field, FieldProblem, JsonError, LineProblem, PsdFile, ReadError, ReadMend,
    ReadOption, ReadOptions, SeriesError, SeriesName, UnitError, Wanted, WorkbookError, is_psd, read_psd,
    series_names,
};
pub use roughness_parameters::{
    HURST_UNCERTAINTY, LONGEST_OVER_ROLLOFF, ROLLOFF_UNCERTAINTY_FACTOR, RoughnessError, RoughnessParameters,
    SelfAffineProfile,
};
pub use samples::PsdError;
pub use self_affine::{FitError, RollOff, SelfAffineFit};
pub use self_affine_fit::fit_self_affine;
pub use superpose::{Superposition, superpose};
pub use units::{Scale, UnknownName};

/// Runs the example of the README as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
