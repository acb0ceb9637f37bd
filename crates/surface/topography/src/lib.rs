//! From measured heights to spectra: transforms, reliable bands, and composites of several measurements.
//!
//! The nouns:
//! * [`Preparation`]: detrending and window for the heights of a [`Scan`](scans::Scan);
//! * [`LineSpectrum`] and [`ArealSpectrum`]: the spectrum of a scan on the bins of its own length, with its
//!   [`ReliableBand`];
//! * [`ScanSpectrum`]: the spectrum of a file of heights by a [`Recipe`], with [`Checks`];
//! * [`Composite`] and [`CompositeSpectrum`]: one spectrum from many measurements, with every [`Remark`](units::Remark) on it.
//!
//! The crate opens no paths, prints nothing, and runs on one thread unless the feature `parallel` is on. No digit
//! depends on the number of threads.

mod areal;
mod band;
mod band_end;
mod bins;
mod checks;
mod composite;
mod composite_spectrum;
mod cut_lines;
mod degrees_of_freedom;
mod derivatives;
mod detrend;
mod direction;
mod error;
mod gap_treatment;
mod harmonic;
mod height_rows;
mod holes;
mod kept_moments;
mod line;
mod lines;
mod map_spectrum;
mod median_lines;
mod models_get;
mod multigrid;
mod narrow_lines;
mod noise_floor;
mod overlap;
mod piecewise;
mod plausibility;
mod preparation;
mod radial;
mod recipe;
mod remark;
mod removed_spikes;
mod rows;
mod scan_bins;
mod scan_spectrum;
mod scattered_sums;
mod segment;
mod skewness;
mod spike;
mod sums;
mod tip;
mod tip_indication;
mod tip_words;
mod window_excess;

pub use areal::{ArealRows, ArealSums, ArealTransform, areal_spectrum};
pub use band::{BandLimits, ReliableBand};
pub use bins::{BinMean, log_binned};
pub use checks::{Checks, fundamental_kept};
pub use composite::{Composite, CompositeBin, CompositeOptions, composite};
pub use composite_spectrum::{CompositeSpectrum, InstrumentsDisagree};
pub use derivatives::{ScanBoundary, real_space_derivatives, real_space_derivatives_across};
pub use detrend::{Detrend, Form, detrended_m, without_form_m, without_trend_m};
pub use direction::Direction;
pub use error::TransformError;
pub use gap_treatment::{GapTreatment, MOST_FILLED, without_gaps};
pub use line::{DerivativeOf, LineSpectrum, RmsDerivatives};
pub use lines::{LineSums, MapLines, map_line_spectrum, uniform_line_spectrum};
pub use map_spectrum::{MapSpectrum, map_of};
pub use models_get::ModelsGet;
pub use narrow_lines::NarrowLine;
pub use noise_floor::NoiseFloor;
pub use overlap::{DirectionRatio, Overlap, overlaps};
pub use piecewise::{nonuniform_line_spectrum, nonuniform_line_spectrum_to};
pub use plausibility::doubt_of_scan;
pub use preparation::{Preparation, Window};
pub use radial::{ArealSpectrum, RadialBin};
pub use recipe::{Average, DEFAULT_BINS_PER_DECADE, LineAverage, Recipe};
pub use remark::{BandEnd, FundamentalMode};
pub use removed_spikes::without_spikes;
pub use scan_bins::ScanBin;
pub use scan_spectrum::{ScanSpectrum, line_spectrum, readings};
pub use skewness::clear_skewness;
pub use spike::Spike;
pub use tip::tip_cutoff_m;
pub use tip_indication::{TipIndication, TrustedDownTo, sharpest_peak_radius_m, usual_tip_radii_m};
pub use tip_words::{TipWords, proposed_tip, tip_words};

/// Runs the example of the README as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
