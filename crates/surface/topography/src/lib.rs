//! From measured heights to spectra: the transforms, the band in which they hold, and what joins several of them.
//!
//! The nouns:
//! * [`Preparation`]: what is done to the heights of a [`Scan`](scans::Scan) before they are transformed;
//! * [`LineSpectrum`] and [`ArealSpectrum`]: the spectrum of a scan, on the bins of its own length, with the
//!   [`ReliableBand`] it holds in;
//! * [`ScanSpectrum`]: a file of heights on its way through all of these by a [`Recipe`], with [`Checks`];
//! * [`Composite`] and [`CompositeSpectrum`]: one spectrum from many measurements, with every [`Remark`] there is to make.
//!
//! What it does not do: it opens no paths, prints nothing, and runs on one thread unless the feature `parallel` is on, with
//! the same digits on any number of them.

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
mod direction_ratio;
mod error;
mod fundamental;
mod gap_treatment;
mod harmonic;
mod holes;
mod independent_lines;
mod line;
mod lines;
mod map_spectrum;
mod multigrid;
mod noise_floor;
mod of_any_scan;
mod overlap;
mod piecewise;
mod preparation;
mod radial;
mod recipe;
mod remark;
mod rms;
mod rows;
mod scan_bins;
mod scan_spectrum;
mod segment;
mod sums;
mod tip;
mod tip_indication;
mod tip_words;
mod window;

pub use areal::{ArealRows, ArealSums, ArealTransform, areal_spectrum};
pub use band::{BandLimits, ReliableBand};
pub use bins::{BinMean, log_binned};
pub use checks::Checks;
pub use composite::{Composite, CompositeBin, CompositeOptions, composite};
pub use composite_spectrum::{CompositeSpectrum, InstrumentsDisagree};
pub use derivatives::{Boundary, real_space_derivatives, real_space_derivatives_across};
pub use detrend::{Detrend, detrended_m};
pub use direction::Direction;
pub use direction_ratio::{DIRECTIONS_DIFFER, DirectionRatio};
pub use error::TransformError;
pub use fundamental::fundamental_kept;
pub use gap_treatment::{GapTreatment, MOST_FILLED, without_gaps};
pub use line::{DerivativeOf, LineSpectrum};
pub use lines::{LineSums, MapLines, map_line_spectrum, uniform_line_spectrum};
pub use map_spectrum::{MapSpectrum, map_of};
pub use noise_floor::NoiseFloor;
pub use of_any_scan::line_spectrum;
pub use overlap::{Overlap, overlaps};
pub use piecewise::{nonuniform_line_spectrum, nonuniform_line_spectrum_to};
pub use preparation::Preparation;
pub use radial::{ArealSpectrum, RadialBin};
pub use recipe::{Average, DEFAULT_BINS_PER_DECADE, Recipe};
pub use remark::{
    BandEnd, Derivative, FundamentalMode, Remark, SLOPES_DIFFER, SPECTRA_DIFFER, ScanRemark, Severity,
};
pub use rms::RmsDerivatives;
pub use scan_bins::ScanBin;
pub use scan_spectrum::ScanSpectrum;
pub use tip::tip_cutoff_m;
pub use tip_indication::{TipIndication, TrustedDownTo, sharpest_peak_radius_m};
pub use tip_words::{TipWords, proposed_tip, tip_words};
pub use window::Window;

/// The example of the page runs.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
