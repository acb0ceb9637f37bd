#![doc = include_str!("../README.md")]
//!
//! The nouns:
//! * [`AreaSpectrum`]: Ciso of an isotropic surface, a power law between neighbouring wavevectors and zero outside its
//!   band; [`AreaSpectrum::cut`] narrows the band, [`AreaSpectrum::profile`] is the spectrum that a stylus measures;
//! * [`SelfAffine`]: a self-affine spectrum by its Hurst exponent and three wavelengths;
//! * [`GridBand`]: a band laid out on a square grid;
//! * [`MapWaves`]: a measured map made periodic, and Gaussian surfaces of its own waves;
//! * [`Synthesis`]: grid, seed and [`Phases`], from which [`AreaSpectrum::surface`] makes a [`Surface`].

mod area_spectrum;
mod conversion;
mod error;
mod fourier;
mod grading;
mod grid_band;
mod map_waves;
mod modes;
mod monotone;
mod self_affine;
mod surface;
mod synthesis;

pub use area_spectrum::AreaSpectrum;
pub use conversion::Conversion;
pub use error::SurfaceError;
pub use grid_band::GridBand;
pub use map_waves::MapWaves;
pub use self_affine::{SelfAffine, Size};
pub use surface::Surface;
pub use synthesis::{Phases, Synthesis};
