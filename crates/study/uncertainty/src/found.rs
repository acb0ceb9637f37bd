//! What draws say of a scene.

use serde::Serialize;
use study::interface::Slot;
use study::plan::Work;

use crate::group::{Group, Indices};
use crate::settings::Settings;

/// How sure the areas of a scene are.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Uncertainty {
    /// How the draws were made.
    pub settings: Settings,
    /// How many draws the intervals rest on: as many as were asked for, unless they were ended before.
    pub draws: usize,
    /// Whether somebody ended the draws before all were made.
    pub ended_early: bool,
    /// The groups of inputs that scatter.
    pub groups: Vec<Group>,
    /// The instruments of the scans; none for a spectrum from a file.
    pub instruments: Vec<InstrumentInput>,
    /// What instruments say of the wavelengths that they share.
    pub overlaps: Vec<OverlapMisfit>,
    /// The standard errors of spectra from files, where they have some.
    pub spectrum_errors: Vec<SpectrumErrors>,
    /// Why an interval is a guess, where it is one.
    pub guesses: Vec<Guess>,
    /// An interval for every curve and load that has an area.
    pub areas: Vec<AreaInterval>,
    /// An interval for everything that the scene asks of its interface and that has a value.
    pub quantities: Vec<QuantityInterval>,
    /// In how many draws a seal lets a channel through, load by load.
    pub open_channels: Vec<OpenChannel>,
    /// Intervals along the cutoff, for every followed curve and load.
    pub bands: Vec<AreaBand>,
    /// What to measure next; absent where nothing of the spectrum scatters or draws were ended.
    pub advice: Vec<Advice>,
    /// How much was computed for the draws, bands, shares and advice together.
    pub work: Work,
    /// How often the plan was carried out for them.
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
    /// The lower end of the interval, which leaves as much probability below as the upper one above; of draws as they are where
    /// the surface is taken for exact, and else corrected for bias
    /// ([`interval_about`](crate::quantiles::interval_about)).
    pub low: f64,
    /// The upper end.
    pub high: f64,
    /// The interval of 68 %.
    pub within_68: [f64; 2],
    /// One standard error of ln(high/low) and of the ends, which more draws would shrink, as a share of ln(high/low); 0 where nothing scatters.
    pub monte_carlo_error: f64,
    /// Standard deviation of ln A.
    pub ln_area_sd: f64,
    /// The indices of each group that scatters, in the order of [`Uncertainty::groups`].
    pub indices: Vec<Indices>,
}

/// A quantity of the interface with its interval, as that of an area.
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
    /// One standard error of ln(high/low) as a share of it.
    pub monte_carlo_error: f64,
}

/// How often a seal is not tight.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct OpenChannel {
    /// The load, by index.
    pub load: usize,
    /// The share of draws in which a channel is open.
    pub share: f64,
}

/// How an instrument's scans came to their instrument.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "from", content = "name")]
pub enum InstrumentName {
    /// The scene says so.
    Given(String),
    /// Guessed from the format and what the file says of its maker.
    Guessed(String),
}

impl InstrumentName {
    /// The name itself.
    #[must_use]
    pub fn text(&self) -> &str {
        match self {
            InstrumentName::Given(name) | InstrumentName::Guessed(name) => name,
        }
    }
}

/// What stands for the scatter between places.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Resampled {
    /// The scans, of which there are so many at different places.
    Scans(usize),
    /// So many blocks of lines of the one map.
    BlocksOfLines(usize),
    /// Nothing: one scan of few lines, of which the scatter of its own Fourier bins is known.
    SingleLine,
}

/// An instrument, as the draws take it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct InstrumentInput {
    /// Its name.
    pub name: InstrumentName,
    /// At how many places it has scanned.
    pub scans: usize,
    /// What stands for their scatter.
    pub resampled: Resampled,
    /// One standard uncertainty of its height scale, as a share.
    pub z_calibration: f64,
    /// Whether that was assumed.
    pub z_calibration_is_assumed: bool,
    /// One standard uncertainty of the exponent of its spectrum; 0 where none was given.
    pub slope_uncertainty: f64,
    /// What the overlaps leave of the gain of its spectrum, ln C: mean and standard uncertainty.
    pub gain: [f64; 2],
    /// The wavelengths \[m\] that its scans show, the longest first.
    pub band_m: [f64; 2],
}

/// What two instruments say of the wavelengths that they share.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OverlapMisfit {
    /// Both, by index.
    pub instruments: [usize; 2],
    /// Mean of ln(C_first/C_second) over the shared bins.
    pub misfit: f64,
    /// Its standard uncertainty from the scatter of the scans.
    pub scatter: f64,
    /// Its standard uncertainty with that of the height scales, against which the misfit is to be held.
    pub expected: f64,
    /// How many bins they share.
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
    /// How many samples have one.
    pub samples: usize,
    /// Of how many.
    pub of: usize,
    /// Decades of wavelength over which errors are taken to go together.
    pub correlation_decades: f64,
    /// Whether they are of what was assumed to make the spectrum of roughness parameters, and no statistics.
    pub are_assumed: bool,
}

/// Why an interval is a guess.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Guess {
    /// An instrument with so few scans (1 or 2) says little of how places differ.
    FewScans {
        /// The instrument, by index.
        instrument: usize,
        /// How many it has.
        scans: usize,
    },
    /// Some draws leave the range of a model, so that its interval is that of the others.
    DrawsWithoutArea {
        /// How many have no area, of the area that has fewest.
        draws: usize,
        /// Of how many.
        of: usize,
    },
    /// The draws were ended early, or are so few that none lies beyond an end, or that an end is known to a quarter of the interval
    /// at best.
    FewDraws {
        /// How many there are.
        draws: usize,
    },
    /// Spectra from files without standard errors beside uncertain materials: nothing is known of their scatter.
    SpectrumWithoutErrors {
        /// The file.
        name: String,
    },
}

/// The interval of a curve along the cutoff.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AreaBand {
    /// The curve, by index.
    pub curve: usize,
    /// The load, by index.
    pub load: usize,
    /// From long to short cutoffs.
    pub points: Vec<BandPoint>,
}

/// An interval at a cutoff.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct BandPoint {
    /// The cutoff \[m\].
    pub wavelength_m: f64,
    /// The lower end, an area fraction.
    pub low: f64,
    /// The upper end.
    pub high: f64,
}

/// What to measure next, for one curve and load.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Advice {
    /// The curve, by index.
    pub curve: usize,
    /// The load, by index.
    pub load: usize,
    /// How much of the variance of ln A that comes from the spectrum each decade of wavelengths carries.
    pub decades: Vec<DecadeOfVariance>,
    /// How much of the variance of ln A the scatter of each instrument's scans carries, and its height scale.
    pub instruments: Vec<[f64; 2]>,
    /// What could be done, the step that shrinks the interval most first.
    pub steps: Vec<Step>,
    /// Whether more of the spectrum would settle the area.
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

/// Something that could be measured.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Step {
    /// What.
    pub kind: StepKind,
    /// ln(high/low) after it over that before.
    pub width_ratio: f64,
    /// The area after it over that before; 1 where it is not expected to move.
    pub area_ratio: f64,
}

/// What could be measured.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum StepKind {
    /// More scans of an instrument, at other places.
    MoreScans {
        /// The instrument, by index.
        instrument: usize,
        /// How many more.
        added: usize,
    },
    /// A height scale known exactly.
    Calibration {
        /// The instrument, by index.
        instrument: usize,
    },
    /// Inputs of the material known exactly.
    KnownExactly {
        /// Which.
        group: Group,
    },
    /// Longer wavelengths, by half a decade.
    LongerWavelengths {
        /// Up to this wavelength \[m\].
        to_m: f64,
    },
    /// Shorter wavelengths, by half a decade: they belong to the surface, so that the area moves.
    ShorterWavelengths {
        /// Down to this wavelength \[m\].
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
            StepKind::LongerWavelengths { .. } => "longer-wavelengths",
            StepKind::ShorterWavelengths { .. } => "shorter-wavelengths",
        }
    }

    /// The instrument that it takes, by index.
    #[must_use]
    pub fn instrument(&self) -> Option<usize> {
        match self {
            StepKind::MoreScans { instrument, .. } | StepKind::Calibration { instrument } => {
                Some(*instrument)
            }
            _ => None,
        }
    }

    /// How many scans it adds.
    #[must_use]
    pub fn added_scans(&self) -> Option<usize> {
        match self {
            StepKind::MoreScans { added, .. } => Some(*added),
            _ => None,
        }
    }

    /// The wavelength \[m\] that it prolongs the spectrum to.
    #[must_use]
    pub fn wavelength_m(&self) -> Option<f64> {
        match self {
            StepKind::LongerWavelengths { to_m } | StepKind::ShorterWavelengths { to_m } => Some(*to_m),
            _ => None,
        }
    }
}

/// Whether the area settles as the spectrum is followed to shorter wavelengths.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Settling {
    /// It has.
    HasSettled,
    /// The spectrum falls fast enough at its short end that the area tends to a limit.
    WillSettle {
        /// d ln C/d ln q at the short end.
        slope: f64,
        /// Its standard error.
        standard_error: f64,
    },
    /// The spectrum does not: at every shorter wavelength the area is another one.
    CannotSettle {
        /// d ln C/d ln q at the short end.
        slope: f64,
        /// Its standard error.
        standard_error: f64,
    },
    /// The spectrum has too few samples to tell.
    Unknown,
}
