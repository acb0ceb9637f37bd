#![doc = include_str!("../README.md")]
//!
//! Main types:
//! * [`Scale`]: one wavelength of the roughness and its amplitude, two plain numbers.
//! * [`StackedModel`]: the deformation of a scale, elastic or elastic-plastic, with a strength that may depend on
//!   depth.
//! * [`Level`]: the state once a scale has been passed; [`levels`] yields one per scale, lazily. Cutting the stack
//!   short at a wavelength is stopping there, so one pass answers every cutoff. [`levels_under_loads`] takes several
//!   loads through the same scales at half the cost.
//! * [`FinalLevels`]: the last level alone, for any number of loads, without the scales that no longer change
//!   anything.
//! * [`Convergence`]: the wavelength below which the area no longer changes; [`largest_full_contact_pressure_pa`]:
//!   the limit of the pressure as the spectrum is sampled more densely; [`setting_level`]: the scale that sets it.
#![deny(missing_docs)]

mod convergence;
mod dense_limit;
mod descent;
mod final_level;
mod level;
mod levels;
mod model;

pub use convergence::{Convergence, LEAST_WAVELENGTH_RATIO_BELOW, convergence};
pub use dense_limit::{largest_full_contact_pressure_pa, setting_level};
pub use final_level::{FinalLevel, FinalLevels};
pub use level::{Level, Regime};
pub use levels::{levels, levels_under_loads};
pub use model::{StackedModel, YieldingAreaLaw};
pub use units::Scale;
