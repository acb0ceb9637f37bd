//! How spectra are made from scans.

use std::num::NonZeroU32;

use scans::ScanFile;
use serde::{Deserialize, Serialize};

use crate::tip::may_have_a_tip;
use crate::tip_words::proposed_tip;
use crate::{BandLimits, BinMean, Detrend, Direction, GapTreatment, Preparation, Window};

/// The density of a composite where none is asked for.
pub const DEFAULT_BINS_PER_DECADE: NonZeroU32 = NonZeroU32::new(10).expect("ten is not zero");

/// How spectra are made from scans.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Recipe {
    /// What is subtracted; for periodic data the mean, else a line or plane, where absent.
    pub detrend: Option<Detrend>,
    /// The window; none for periodic data, else Hann, where absent.
    pub window: Option<Window>,
    /// How measurements are averaged bin by bin.
    pub average: Average,
    /// Logarithmic bins per decade of wavevectors.
    pub bins_per_decade: NonZeroU32,
    /// Radius of the tip \[m\] of scans that have no other.
    pub tip_radius_m: Option<f64>,
    /// Whether the radius of a tip that a file tells in free text alone is used: the largest it speaks of.
    pub tip_radius_auto: bool,
    /// What is done about points without a height.
    pub gaps: GapTreatment,
    /// Along which axis of maps their lines run.
    pub direction: Direction,
}

impl Default for Recipe {
    fn default() -> Self {
        Recipe {
            detrend: None,
            window: None,
            average: Average::default(),
            bins_per_decade: DEFAULT_BINS_PER_DECADE,
            tip_radius_m: None,
            tip_radius_auto: false,
            gaps: GapTreatment::default(),
            direction: Direction::default(),
        }
    }
}

impl Recipe {
    /// What is done to the heights of a scan, periodic or not.
    #[must_use]
    pub fn preparation(&self, is_periodic: bool) -> Preparation {
        let fitting = if is_periodic { Preparation::PERIODIC } else { Preparation::default() };
        Preparation {
            detrend: self.detrend.unwrap_or(fitting.detrend),
            window: self.window.unwrap_or(fitting.window),
        }
    }

    /// What limits the band of a scan: the tip and the shortest wavelength. What is `given` of the tip counts before what the
    /// file says in a field of its own, that before what it says in free text, where the recipe wants that, and that before the
    /// recipe; of two shortest wavelengths the longer one counts, which all vouch for.
    #[must_use]
    pub fn limits<S>(&self, given: BandLimits, file: &ScanFile<S>) -> BandLimits {
        let in_words = || {
            let is_wanted = self.tip_radius_auto && may_have_a_tip(file);
            is_wanted.then(|| proposed_tip(&file.free_text)).flatten().map(|words| words.radius_m)
        };
        BandLimits {
            tip_radius_m: given.tip_radius_m.or(file.tip_radius_m).or_else(in_words).or(self.tip_radius_m),
            shortest_m: [given.shortest_m, file.resolution_m].into_iter().flatten().reduce(f64::max),
        }
    }

    /// The recipe in a line, for the record.
    #[must_use]
    pub fn describe(&self) -> String {
        let mut line = format!(
            "detrend: {}, window: {}, average: {}, {} bins per decade",
            self.detrend.map_or("as fits the scan".to_owned(), |detrend| detrend.to_string()),
            self.window.map_or("as fits the scan".to_owned(), |window| window.to_string()),
            self.average.name(),
            self.bins_per_decade
        );
        if self.tip_radius_auto {
            line += ", tip radius: auto";
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

/// How the spectra of several measurements are averaged in a bin.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Average {
    /// The mean of their logarithms, each without the bias that the logarithm of a spectrum of few lines and Fourier bins has:
    /// psi(n/2) - ln(n/2) for n degrees of freedom.
    #[default]
    LogUnbiased,
    /// The mean of their logarithms, which Jackson & Jacobs call the log-space average.
    Log,
    /// Their mean, as contact.engineering takes it.
    Arithmetic,
}

units::named!(Average, "average across scans", {
    LogUnbiased => "log-unbiased",
    Log => "log",
    Arithmetic => "arithmetic",
});

impl Average {
    /// The mean over the measurements that reach a bin.
    pub(crate) const fn across(self) -> BinMean {
        match self {
            Average::LogUnbiased | Average::Log => BinMean::Geometric,
            Average::Arithmetic => BinMean::Arithmetic,
        }
    }
}
