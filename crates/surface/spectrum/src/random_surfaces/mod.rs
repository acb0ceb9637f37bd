//! Rough surfaces from a power spectrum: converts the spectrum of profiles to the isotropic spectrum Ciso of an area, cuts it
//! to a band, and makes periodic random surfaces with exactly this spectrum. A seed gives the same surface on every grid that
//! holds the band.
//!
//! ```
//! use spectrum::random_surfaces::{AreaSpectrum, Phases, Synthesis};
//! use spectrum::ProfilePsd;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! // C1D falls with the wavevector to the power -2.6: a Hurst exponent of 0.8.
//! let wavelengths_m = vec![100e-6, 10e-6, 1e-6];
//! let c1d_m3 = wavelengths_m.iter().map(|lambda_m: &f64| 1e-20 * (lambda_m / 100e-6).powf(2.6)).collect();
//! let area = AreaSpectrum::from_profile(&ProfilePsd::new(wavelengths_m, c1d_m3)?)?;
//!
//! // A band of one decade on a grid with 8 points per shortest wavelength and 2 longest wavelengths per side.
//! let window = area.cut(20e-6, 2e-6)?;
//! let synthesis = Synthesis::square(160, 40e-6, 1, Phases::FixedModulus);
//! let surface = window.surface(&synthesis, 0)?;
//! assert_eq!(surface.heights_m.len(), 160 * 160);
//!
//! // The grid sums over discrete waves; the spectrum is an integral.
//! let own = surface.mean_square_gradient() / window.mean_square_gradient();
//! assert!((own - 1.0).abs() < 0.05, "{own}");
//! # Ok(())
//! # }
//! ```
//!
//! The nouns:
//! * [`AreaSpectrum`]: Ciso of an isotropic surface, a power law between neighbouring wavevectors and zero outside its
//!   band; [`AreaSpectrum::cut`] narrows the band, [`AreaSpectrum::profile`] is the spectrum that a stylus measures;
//! * [`SelfAffine`]: a self-affine spectrum by its Hurst exponent and three wavelengths;
//! * [`GridBand`]: a band laid out on a square grid;
//! * [`MapWaves`]: a measured map made periodic, and Gaussian surfaces of its own waves;
//! * [`Synthesis`]: grid, seed and [`Phases`], from which [`AreaSpectrum::surface`] makes a [`RandomSurface`].

mod area_spectrum;
mod conversion;
mod error;
#[cfg(feature = "random-surfaces")]
mod fourier;
mod grading;
mod grid_band;
#[cfg(feature = "random-surfaces")]
mod map_waves;
#[cfg(feature = "random-surfaces")]
mod modes;
mod monotone;
mod self_affine;
mod surface;
#[cfg(feature = "random-surfaces")]
mod synthesis;

pub use area_spectrum::AreaSpectrum;
pub use conversion::Conversion;
pub use error::RandomSurfaceError;
pub use grid_band::GridBand;
#[cfg(feature = "random-surfaces")]
pub use map_waves::MapWaves;
pub use self_affine::{SelfAffine, Size};
#[cfg(feature = "random-surfaces")]
pub use surface::RandomSurface;
#[cfg(feature = "random-surfaces")]
pub use synthesis::{Phases, Synthesis};
