//! Archard's stacked multiscale model: roughness scale upon roughness scale, from long to short wavelengths.
//!
//! ```
//! use asperity::{ElasticBody, MaterialPair, NixGao};
//! use stacked_contact::{Scale, StackedModel, levels};
//!
//! let pair = MaterialPair::against_rigid(ElasticBody::new(463e9, 0.2)?);
//! let model = StackedModel::ElasticPlastic { pair, strength: NixGao::constant(1.8e9)? };
//! let scales = [(1e-6, 10e-9), (1e-7, 3e-9), (1e-8, 0.4e-9)]
//!     .map(|(wavelength_m, amplitude_m)| Scale { wavelength_m, amplitude_m });
//! let curve: Vec<_> = levels(&model, 5.4e6, scales).collect();
//! assert!(curve.is_sorted_by(|long, short| long.area_fraction >= short.area_fraction));
//! # Ok::<(), asperity::AsperityError>(())
//! ```
//!
//! The nouns:
//! * [`Scale`]: one wavelength of the roughness and its amplitude, two plain numbers.
//! * [`StackedModel`]: how a scale deforms, elastically or elastic-plastically, with a strength that may depend on depth.
//! * [`Level`]: what is known once a scale has been passed; [`levels`] yields one per scale, lazily. Cutting the stack
//!   short at a wavelength is stopping there, so one pass answers every cutoff. [`levels_under_loads`] takes several loads
//!   through the same scales at half the cost.
//! * [`FinalLevels`]: the last level alone, for any number of loads, without the scales that change nothing any more.
//! * [`Convergence`]: the wavelength below which the area no longer changes; [`largest_full_contact_pressure_pa`]: the
//!   pressure that it tends to as the spectrum is sampled more densely; [`setting_level`]: the scale that sets it.
//!
//! Not here: where the scales come from (a spectrum, resampled or not), and units. SI throughout.
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
pub use model::StackedModel;
pub use units::Scale;
