//! From measured heights to spectra: the transforms, the band in which they hold, and what joins several of them.
//!
//! The nouns:
//! * [`Preparation`]: what is done to the heights of a [`Scan`] before they are transformed;
//! * [`LineSpectrum`] and [`ArealSpectrum`]: the spectrum of a scan, on the bins of its own length, with the
//!   [`ReliableBand`] it holds in;
//! * [`ScanSpectrum`]: a file of heights on its way through all of these by a [`Recipe`], with [`Checks`];
//! * [`Composite`] and [`CompositeSpectrum`]: one spectrum from many measurements, with every [`Remark`] there is to make.
//!
//! What it does not do: it opens no paths, prints nothing, and runs on one thread unless the feature `parallel` is on, with
//! the same digits on any number of them.

mod areal;
mod band;
mod bins;
mod checks;
mod composite;
mod composite_spectrum;
mod derivatives;
mod detrend;
mod error;
mod fundamental;
mod line;
mod lines;
mod overlap;
mod piecewise;
mod radial;
mod recipe;
mod remark;
mod scan_spectrum;
mod segment;
mod sums;
mod tip;
mod window;

use serde::{Deserialize, Serialize};

use scans::Scan;

pub use areal::{ArealRows, ArealSums, ArealTransform, areal_spectrum};
pub use band::{BandLimits, ReliableBand};
pub use bins::{BinMean, log_binned};
pub use checks::Checks;
pub use composite::{Composite, CompositeBin, CompositeOptions, composite};
pub use composite_spectrum::{CompositeSpectrum, InstrumentsDisagree};
pub use derivatives::{Boundary, RmsDerivatives, real_space_derivatives};
pub use detrend::Detrend;
pub use error::TransformError;
pub use fundamental::fundamental_kept;
pub use line::{DerivativeOf, LineSpectrum};
pub use lines::{LineSums, MapLines, map_line_spectrum, uniform_line_spectrum};
pub use overlap::{Overlap, overlaps};
pub use piecewise::{nonuniform_line_spectrum, nonuniform_line_spectrum_to};
pub use radial::{ArealSpectrum, RadialBin};
pub use recipe::{Average, DEFAULT_BINS_PER_DECADE, Recipe};
pub use remark::{
    BandEnd, Derivative, FundamentalMode, Remark, SLOPES_DIFFER, SPECTRA_DIFFER, ScanRemark, Severity,
};
pub use scan_spectrum::ScanSpectrum;
pub use tip::tip_cutoff_m;
pub use window::Window;

/// What is done to the heights before they are transformed.
///
/// The default suits data that are not periodic: a plane (of a line: a straight line) is subtracted and the Hann window
/// applied. Periodic data, such as computed surfaces, want [`Detrend::Mean`] and [`Window::None`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Preparation {
    /// What is subtracted.
    pub detrend: Detrend,
    /// What the remainder is multiplied by.
    pub window: Window,
}

impl Preparation {
    /// For periodic data: the mean subtracted, no window.
    pub const PERIODIC: Self = Self { detrend: Detrend::Mean, window: Window::None };

    /// How many of the first bins, from q = 2 pi/L on, do not show the spectrum of the surface.
    ///
    /// The first one wherever a slope was subtracted, which takes most of its content from it, or a window applied, which
    /// mixes it with the mean that has gone; none for [`Preparation::PERIODIC`].
    pub const fn flagged_bins(self) -> usize {
        match (self.detrend, self.window) {
            (Detrend::Mean, Window::None) => 0,
            _ => 1,
        }
    }
}

/// The spectrum C1D of any scan: of a map, the mean of those of its rows.
pub fn line_spectrum(scan: &Scan, preparation: Preparation) -> LineSpectrum {
    match scan {
        Scan::UniformLine(line) => uniform_line_spectrum(line, preparation),
        Scan::NonuniformLine(line) => nonuniform_line_spectrum(line, preparation),
        Scan::Map(map) => map_line_spectrum(map, preparation),
    }
}
