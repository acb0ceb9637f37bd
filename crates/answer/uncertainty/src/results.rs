//! The results of an uncertainty analysis.

use scene::UncertaintySettings;
use serde::Serialize;
use study::interface::Slot;
use study::plan::Work;
use units::Remark;

use crate::group::{Group, Indices};

/// The uncertainty of the areas of a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Uncertainty {
    /// The settings of the draws.
    pub settings: UncertaintySettings,
    /// The number of draws behind the intervals: the requested number, unless the draws were stopped early.
    pub draws: usize,
    /// True if the draws were stopped early.
    pub ended_early: bool,
    /// The groups of inputs that scatter.
    pub groups: Vec<Group>,
    /// The instruments of the scans; none for a spectrum from a file.
    pub instruments: Vec<InstrumentInput>,
    /// The overlaps of instruments.
    pub overlaps: Vec<OverlapMisfit>,
    /// The standard errors of spectra from files that have some.
    pub spectrum_errors: Vec<SpectrumErrors>,
    /// The reasons to treat intervals as guesses.
    pub guesses: Vec<Remark>,
    /// An interval for every curve and load that has an area.
    pub areas: Vec<AreaInterval>,
    /// An interval for every quantity of the interface that the scene requests and that has a value.
    pub quantities: Vec<QuantityInterval>,
    /// For every load, the share of draws in which a seal leaks.
    pub open_channels: Vec<OpenChannel>,
    /// Intervals along the cutoff, for every followed curve and load.
    pub bands: Vec<AreaBand>,
    /// Advice on what to measure next; empty if the spectrum is certain or the draws were stopped early.
    pub advice: Vec<Advice>,
    /// The work of draws, bands, shares and advice together.
    pub work: Work,
    /// The number of plans computed for them.
    pub plans: usize,
}

/// An area with its interval.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AreaInterval {
    /// The curve, by index.
    pub curve: usize,
    /// The load, by index.
    pub load: usize,
    /// The area fraction of the plain run, at the shortest wavelength.
    pub area_fraction: f64,
    /// The median of the draws, corrected for bias where the surface scatters.
    pub median: f64,
    /// The lower end of the interval, with as much probability below it as above the upper end; corrected for bias
    /// ([`area_interval_about`](crate::quantiles::area_interval_about)) if the surface is uncertain.
    pub low: f64,
    /// The upper end.
    pub high: f64,
    /// The interval of 68 %.
    pub within_68: [f64; 2],
    /// The standard error of ln(high/low) and of the ends from the number of draws, as a share of ln(high/low); 0 if
    /// nothing is uncertain.
    pub monte_carlo_error: f64,
    /// Standard deviation of ln A.
    pub ln_area_sd: f64,
    /// The indices of each group that scatters, in the order of [`Uncertainty::groups`].
    pub indices: Vec<Indices>,
}

/// A quantity of the interface with its interval, defined as that of an area.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct QuantityInterval {
    /// The quantity, its load and its curve.
    pub slot: Slot,
    /// The value of the plain run, in the unit of the quantity.
    pub value: f64,
    /// The median.
    pub median: f64,
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
    /// The standard error of ln(high/low), as a share of it.
    pub monte_carlo_error: f64,
}

/// The share of draws in which a seal is not tight.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct OpenChannel {
    /// The load, by index.
    pub load: usize,
    /// The share of draws in which a channel is open.
    pub share: f64,
}

/// The name of an instrument and its source.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "from", content = "name")]
pub enum InstrumentName {
    /// Named by the scene.
    Given(String),
    /// Guessed from the format and the maker in the file.
    Guessed(String),
    /// Assumed of texts of one length and spacing, or of all instruments beyond the first ones.
    Shared(String),
}

impl InstrumentName {
    /// The name.
    #[must_use]
    pub fn text(&self) -> &str {
        match self {
            InstrumentName::Given(name) | InstrumentName::Guessed(name) | InstrumentName::Shared(name) => {
                name
            }
        }
    }
}

/// The data that represent the scatter between places.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Resampled {
    /// This number of scans at different places.
    Scans(usize),
    /// This number of blocks of lines of the one map.
    BlocksOfLines(usize),
    /// One scan of few lines: only the scatter of its own Fourier bins is known.
    SingleLine,
}

/// An instrument as an input of the draws.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct InstrumentInput {
    /// Its name.
    pub name: InstrumentName,
    /// The number of places scanned.
    pub scans: usize,
    /// The data that represent the scatter between these places.
    pub resampled: Resampled,
    /// The standard uncertainty of its height scale, as a share.
    pub z_calibration: f64,
    /// True if this uncertainty was assumed.
    pub z_calibration_is_assumed: bool,
    /// The standard uncertainty of the exponent of its spectrum; 0 if none was given.
    pub slope_uncertainty: f64,
    /// Mean and standard uncertainty of the gain of its spectrum, ln C, after all overlaps.
    pub gain: [f64; 2],
    /// The wavelengths \[m\] that its scans show, the longest first.
    pub band_m: [f64; 2],
}

/// The overlap of two instruments.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OverlapMisfit {
    /// Both instruments, by index.
    pub instruments: [usize; 2],
    /// Mean of ln(C_first/C_second) over the shared bins.
    pub misfit: f64,
    /// The standard uncertainty of the misfit from the scatter of the scans.
    pub scatter: f64,
    /// The standard uncertainty of the misfit, including that of the height scales: the scale on which to judge the
    /// misfit.
    pub expected: f64,
    /// The number of shared bins.
    pub bins: usize,
    /// The longest wavelength shared \[m\].
    pub longest_m: f64,
    /// The shortest \[m\].
    pub shortest_m: f64,
}

/// The standard errors of a spectrum from a file.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SpectrumErrors {
    /// The file.
    pub name: String,
    /// The number of samples with a standard error.
    pub samples: usize,
    /// The number of all samples.
    pub of: usize,
    /// Decades of wavelength over which errors are correlated.
    pub correlation_decades: f64,
    /// True if the errors come from assumptions on roughness parameters, not from statistics.
    pub are_assumed: bool,
}

/// The interval of a curve along the cutoff.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AreaBand {
    /// The curve, by index.
    pub curve: usize,
    /// The load, by index.
    pub load: usize,
    /// The points, from long to short cutoffs.
    pub points: Vec<BandPoint>,
}

/// An interval at a cutoff.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct BandPoint {
    /// The cutoff \[m\].
    pub wavelength_m: f64,
    /// The area fraction without uncertainty.
    pub area_fraction: f64,
    /// The median of the draws, as the ends an area fraction.
    pub median: f64,
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
}

/// Advice on what to measure next for one curve and load.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Advice {
    /// The curve, by index.
    pub curve: usize,
    /// The load, by index.
    pub load: usize,
    /// The share of each decade of wavelengths in the variance of ln A from the spectrum.
    pub decades: Vec<DecadeOfVariance>,
    /// For every instrument, the shares of its scans and of its height scale in the variance of ln A.
    pub instruments: Vec<[f64; 2]>,
    /// The possible steps, the one that shrinks the interval most first.
    pub steps: Vec<Step>,
    /// The outlook for settling the area with more of the spectrum.
    pub settling: Settling,
}

/// A decade of wavelengths and its share.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct DecadeOfVariance {
    /// Its longest wavelength \[m\].
    pub longest_m: f64,
    /// Its shortest \[m\].
    pub shortest_m: f64,
    /// Its share of the variance of ln A.
    pub share: f64,
}

/// A possible measurement.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Step {
    /// The kind of measurement.
    pub kind: StepKind,
    /// ln(high/low) after the step over that before.
    pub width_ratio: f64,
    /// The area after the step over that before; 1 if no change is expected.
    pub area_ratio: f64,
}

/// The kind of a possible measurement.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum StepKind {
    /// Further scans of an instrument, at other places.
    MoreScans {
        /// The instrument, by index.
        instrument: usize,
        /// The number of further scans.
        added: usize,
    },
    /// A height scale known exactly.
    Calibration {
        /// The instrument, by index.
        instrument: usize,
    },
    /// Inputs of the material known exactly.
    KnownExactly {
        /// The group of inputs.
        group: Group,
    },
    /// Wavelengths longer by half a decade.
    LongerWavelengths {
        /// The new longest wavelength \[m\].
        to_m: f64,
    },
    /// Wavelengths shorter by half a decade; they belong to the surface, so that the area changes.
    ShorterWavelengths {
        /// The new shortest wavelength \[m\].
        to_m: f64,
    },
}

impl StepKind {
    /// Its name in tables.
    #[must_use]
    pub fn key(&self) -> &'static str {
        match self {
            StepKind::MoreScans { .. } => "more-scans",
            StepKind::Calibration { .. } => "calibration",
            StepKind::KnownExactly { group: Group::Scans } => "known-scans",
            StepKind::KnownExactly { group: Group::Instruments } => "known-instruments",
            StepKind::KnownExactly { group: Group::Material } => "known-material",
            StepKind::KnownExactly { group: Group::Strength } => "known-strength",
            StepKind::KnownExactly { group: Group::Holes } => "closed-holes",
            StepKind::LongerWavelengths { .. } => "longer-wavelengths",
            StepKind::ShorterWavelengths { .. } => "shorter-wavelengths",
        }
    }

    /// The instrument of the step, by index.
    #[must_use]
    pub fn instrument(&self) -> Option<usize> {
        match self {
            StepKind::MoreScans { instrument, .. } | StepKind::Calibration { instrument } => {
                Some(*instrument)
            }
            _ => None,
        }
    }

    /// The number of scans that the step adds.
    #[must_use]
    pub fn added_scans(&self) -> Option<usize> {
        match self {
            StepKind::MoreScans { added, .. } => Some(*added),
            _ => None,
        }
    }

    /// The new end of the spectrum \[m\].
    #[must_use]
    pub fn wavelength_m(&self) -> Option<f64> {
        match self {
            StepKind::LongerWavelengths { to_m } | StepKind::ShorterWavelengths { to_m } => Some(*to_m),
            _ => None,
        }
    }
}

/// The outlook for settling the area with shorter wavelengths.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Settling {
    /// The area has settled.
    HasSettled,
    /// The spectrum falls fast enough at its short end for the area to tend to a limit.
    WillSettle {
        /// d ln C/d ln q at the short end.
        slope: f64,
        /// Its standard error.
        standard_error: f64,
    },
    /// The spectrum falls too slowly for a limit: the area changes with every shorter wavelength.
    CannotSettle {
        /// d ln C/d ln q at the short end.
        slope: f64,
        /// Its standard error.
        standard_error: f64,
    },
    /// Unknown: the spectrum has too few samples.
    Unknown,
}
