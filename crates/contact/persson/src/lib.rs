#![doc = include_str!("../README.md")]
//!
//! Modules by subject:
//! * [`Roughness`]: mean square gradients up to each cutoff, of the spectrum of profiles or of the surface ([`Band`]).
//! * [`elastic`]: area and stress of the elastic theory.
//! * [`constant_hardness`]: area and stress up to a hardness.
//! * [`growing_hardness`]: a hardness that grows towards short wavelengths, along a [`HardnessPath`];
//!   [`hardness_laws`]: the laws that there are.
//! * [`corrections`]: forms fitted to simulations.
//! * [`separation`]: mean gap and stiffness, by an [`EnergyFactor`].
//! * [`yielding`]: mean gap and stiffness where peaks have flowed.
//! * [`sealing`]: open channels through the contact, and their narrowest places.
//! * [`GapDistribution`]: shares of the nominal area by gap, and the flow through them by an effective medium; [`SealFlow`]: that flow under any load.
//! * [`PerssonModel`]: all of this along a spectrum, one pass per load.
#![deny(missing_docs)]

mod areas;
mod band;
pub mod constant_hardness;
mod contact_energy;
pub mod corrections;
pub mod elastic;
mod energy;
mod excursion;
mod flowed_surface;
mod gap_distribution;
pub mod growing_hardness;
pub mod hardness_laws;
mod hardness_path;
mod layered;
mod model;
mod roughness;
mod seal_flow;
pub mod sealing;
pub mod separation;
mod stress_profile;
mod stretch;
pub mod yielding;

pub use areas::ContactAreas;
pub use band::Band;
pub use energy::{EnergyFactor, EnergyFactorError};
pub use gap_distribution::GapDistribution;
pub use hardness_path::{HardnessKnot, HardnessPath};
pub use model::{Cut, PerssonModel};
pub use roughness::{Place, Roughness, RoughnessSample};
pub use seal_flow::{SealConductance, SealFlow};
