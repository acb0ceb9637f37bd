#![doc = include_str!("../README.md")]

mod found;
mod group;
mod settings;
mod tables;

pub use found::{
    Advice, AreaBand, AreaInterval, BandPoint, DecadeOfVariance, Guess, InstrumentInput, InstrumentName,
    OverlapMisfit, Resampled, Settling, SpectrumErrors, Step, StepKind, Uncertainty,
};
pub use group::{Group, Index, Indices};
pub use settings::{DEFAULT_DRAWS, DEFAULT_LEVEL, DEFAULT_SEED, Settings};
pub use tables::LARGEST_ERROR_OF_A_SHARE;
