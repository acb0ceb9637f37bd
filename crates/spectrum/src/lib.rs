//! Power spectra of rough surfaces: their conventions, their files, and what contact models need from them.
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
//! * [`LineSpectrum`] and [`ArealSpectrum`]: the spectrum of a [`Scan`], on the bins of its own length, with the
//!   [`ReliableBand`] it holds in;
//! * [`Composite`]: one spectrum from many measurements;
//! * [`PsdFile`]: a [`Psd`] as read from text, JSON or a workbook, with the comments and the assumptions made;
//! * [`ScanFile`]: measured heights, a [`Scan`], as read from the files of instruments and containers.
//!
//! What it does not do: it opens no paths, prints nothing, and runs on one thread; maps come in blocks of rows for callers
//! that have more. Between one- and two-dimensional spectra it converts by the Abel integral over the samples, which knows
//! nothing of the surface beyond them.

mod abel;
mod amplitude;
mod approximate;
mod convention;
mod interval;
mod mccool;
mod moments;
mod profile;
mod psd;
mod read;
mod scan;
mod self_affine_fit;
mod transform;

pub use amplitude::{AmplitudeDefinition, amplitudes};
pub use convention::{Convention, ConversionError};
pub use mccool::AsperityParameters;
pub use moments::{Moments, Normalisation, cumulative_moments, cumulative_moments_to};
pub use profile::ProfilePsd;
pub use psd::{Psd, PsdError};
pub use read::{
    Abscissa, Field, JsonError, PsdFile, ReadError, ReadOptions, SeriesError, SeriesName, UnitError,
    WorkbookError, read_psd, series_names,
};
#[cfg(feature = "container")]
pub use scan::read_metadata;
pub use scan::{
    HeightMap, LengthUnit, MeasurementMetadata, NonuniformLineScan, Place, Scan, ScanError, ScanFile,
    ScanFormat, ScanOptions, ScanReadError, ScanSize, UniformLineScan, UnknownLengthUnit, read_scans,
};
pub use self_affine_fit::{FitError, RollOff, SelfAffineFit, fit_self_affine};
pub use transform::{
    ArealRows, ArealSpectrum, ArealSums, ArealTransform, BandLimits, BinMean, Boundary, Composite,
    CompositeBin, CompositeOptions, DerivativeOf, Detrend, LineSpectrum, LineSums, MapLines, Overlap,
    Preparation, RadialBin, ReliableBand, RmsDerivatives, Superposition, TransformError, Window,
    areal_spectrum, composite, fundamental_kept, line_spectrum, log_binned, map_line_spectrum,
    nonuniform_line_spectrum, nonuniform_line_spectrum_to, overlaps, real_space_derivatives, superpose,
    tip_cutoff_m, uniform_line_spectrum,
};
pub use units::{Scale, UnknownName};
