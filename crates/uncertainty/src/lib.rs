#![doc = include_str!("../README.md")]

mod found;
mod group;
mod material_draws;
mod settings;

pub use found::{
    Advice, AreaBand, AreaInterval, BandPoint, DecadeOfVariance, Guess, InstrumentInput, InstrumentName,
    OverlapMisfit, Resampled, Settling, SpectrumErrors, Step, StepKind, Uncertainty,
};
pub use group::{Group, Index, Indices};
pub use material_draws::{DrawnMaterial, MaterialDraws};
pub use settings::{DEFAULT_DRAWS, DEFAULT_LEVEL, DEFAULT_SEED, Settings};
