//! Recipe of spectra from scans.

use std::num::NonZeroU32;

use scans::ScanFile;
use serde::{Deserialize, Serialize};

use crate::tip::may_have_a_tip;
use crate::tip_words::proposed_tip;
use crate::{BandLimits, BinMean, Detrend, Direction, GapTreatment, Preparation, Window};

/// Default number of bins per decade of a composite.
pub const DEFAULT_BINS_PER_DECADE: NonZeroU32 = NonZeroU32::new(10).expect("ten is not zero");

/// Options for making spectra from scans.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Recipe {
    /// Detrending; defaults to the mean for periodic data, else to a plane (a straight line for a line scan).
    pub detrend: Option<Detrend>,
    /// Window; defaults to none for periodic data, else to Hann.
    pub window: Option<Window>,
    /// Average over measurements in a bin.
    pub average: Average,
    /// Average over the lines of a map.
    pub line_average: LineAverage,
    /// True if spikes are removed first.
    pub remove_spikes: bool,
    /// Logarithmic bins per decade of wavevectors.
    pub bins_per_decade: NonZeroU32,
    /// Tip radius \[m\] of scans without their own.
    pub tip_radius_m: Option<f64>,
    /// Treatment of missing points.
    pub gaps: GapTreatment,
    /// Axis along which the lines of maps run.
    pub direction: Direction,
}

impl Default for Recipe {
    fn default() -> Self {
        Recipe {
            detrend: None,
            window: None,
            average: Average::default(),
            line_average: LineAverage::default(),
            remove_spikes: false,
            bins_per_decade: DEFAULT_BINS_PER_DECADE,
            tip_radius_m: None,
            gaps: GapTreatment::default(),
            direction: Direction::default(),
        }
    }
}

impl Recipe {
    /// Returns the preparation of the heights of a scan, periodic or not.
    #[must_use]
    pub fn preparation(&self, is_periodic: bool) -> Preparation {
        let fitting = if is_periodic { Preparation::PERIODIC } else { Preparation::default() };
        Preparation {
            detrend: self.detrend.unwrap_or(fitting.detrend),
            window: self.window.unwrap_or(fitting.window),
        }
    }

    /// Returns the limits of the band of a scan.
    ///
    /// The tip radius is the `given` one, else that of the file, else the largest of its free text, else that of the recipe. The shortest wavelength is the longer of the given one and the resolution of the file.
    #[must_use]
    pub fn limits<S>(&self, given: BandLimits, file: &ScanFile<S>) -> BandLimits {
        let in_words = || {
            let words = may_have_a_tip(file).then(|| proposed_tip(&file.free_text)).flatten();
            words.map(|words| words.radius_m)
        };
        BandLimits {
            tip_radius_m: given.tip_radius_m.or(file.tip_radius_m).or_else(in_words).or(self.tip_radius_m),
            shortest_m: [given.shortest_m, file.resolution_m].into_iter().flatten().reduce(f64::max),
        }
    }

    /// Describes the recipe in one line for the provenance.
    #[must_use]
    pub fn describe(&self) -> String {
        let mut line = format!(
            "detrend: {}, window: {}, average: {}, {} bins per decade",
            self.detrend.map_or("as fits the scan".to_owned(), |detrend| detrend.to_string()),
            self.window.map_or("as fits the scan".to_owned(), |window| window.to_string()),
            self.average.name(),
            self.bins_per_decade
        );
        if self.line_average != LineAverage::default() {
            line += &format!(", average over lines: {}", self.line_average);
        }
        if self.remove_spikes {
            line += ", spikes removed";
        }
        if self.gaps != GapTreatment::default() {
            line += &format!(", gaps: {}", self.gaps);
        }
        if self.direction != Direction::default() {
            line += &format!(", direction: {}", self.direction);
        }
        line
    }
}

/// Average of the spectra of the lines of a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LineAverage {
    /// The mean.
    #[default]
    Mean,
    /// The median, divided by that of chi-squared numbers of mean 1: a few outlying lines do not move it.
    Median,
}

units::named!(LineAverage, "average over lines", { Mean => "mean", Median => "median" });

/// Average of the spectra of several measurements in a bin.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Average {
    /// Mean of the logarithms, each freed from the bias psi(n/2) - ln(n/2) of a spectrum with n degrees of freedom.
    #[default]
    LogUnbiased,
    /// Mean of the logarithms, which Jackson & Jacobs call the log-space average.
    Log,
    /// Arithmetic mean, as contact.engineering takes it.
    Arithmetic,
}

units::named!(Average, "average across scans", {
    LogUnbiased => "log-unbiased",
    Log => "log",
    Arithmetic => "arithmetic",
});

impl Average {
    /// Returns the mean over the measurements that reach a bin.
    pub(crate) const fn across(self) -> BinMean {
        match self {
            Average::LogUnbiased | Average::Log => BinMean::Geometric,
            Average::Arithmetic => BinMean::Arithmetic,
        }
    }
}
