#![doc = include_str!("../README.md")]

mod advice;
mod areas;
mod bands;
mod draws;
mod gains;
mod group;
mod hole_scatter;
mod influence;
mod inputs;
mod instrument_bins;
mod instruments;
mod light_draws;
mod material_draws;
mod overlap;
mod plan;
pub mod quantiles;
mod quantities;
mod random;
mod results;
mod scan_scatter;
mod shares;
mod smooth_spectrum;
pub mod sobol;
mod spectrum_ends;
mod spectrum_errors;
mod student;
mod surface_scatter;
mod tables;

pub use advice::MIN_SCANS;
pub use group::{Group, Index, Indices};
pub use inputs::scattering_groups;
pub use instruments::ASSUMED_Z_CALIBRATION;
pub use material_draws::{DrawnMaterial, MaterialDraws};
pub use plan::UncertaintyPlan;
pub use results::{
    Advice, AreaBand, AreaInterval, BandPoint, DecadeOfVariance, InstrumentInput, InstrumentName,
    OpenChannel, OverlapMisfit, QuantityInterval, Resampled, Settling, SpectrumErrors, Step, StepKind,
    Uncertainty,
};
pub use scene::UncertaintySettings;
pub use spectrum_errors::CORRELATION_DECADES;
pub use tables::LARGEST_ERROR_OF_A_SHARE;
