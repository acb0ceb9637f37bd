#![doc = include_str!("../README.md")]
//!
//! Main types:
//! * [`Surfaces`]: surfaces to press, [`Relief`]s as measured or [`RandomSurfaces`] of a band of a spectrum, by
//!   [`RandomChoices`];
//! * [`Pressing`]: material, [`ImposedLoad`]s and tolerance;
//! * [`PressedLoad`]: one load on every surface, each with its [`PressedState`], and their [`Mean`];
//! * [`Indenter`]: a smooth ball or cylinder pressed onto a rough flat;
//! * [`AdhesivePressing`]: surfaces that attract each other, under loads and pulled apart;
//! * [`Outline`]: the points of a map that belong to the specimen, and its own compliance;
//! * [`PressedPatches`]: connected regions of the contact;
//! * [`ContactField`]: pressures and gaps of one surface under one load, which can be written as NetCDF.

mod adhesive;
mod boundary;
mod error;
mod field;
pub mod half_space;
mod in_turn;
mod indenter;
mod mean;
mod netcdf_classic;
mod outline;
mod patches;
mod placed;
mod press;
mod pressing;
mod random_choices;
mod relief;
mod specimen;
mod state;
mod surfaces;
mod table;

pub use adhesive::{AdhesiveError, AdhesivePressing, AdhesiveState, Branch, adhesive_means, adhesive_table};
pub use boundary::Boundary;
pub use error::ElementsError;
pub use field::{ContactField, PointState, with_nan};
pub use half_space::Approach;
pub use in_turn::press_in_turn;
pub use indenter::{Indenter, IndenterError, IndenterPressing, IndenterShape, IndenterState, indenter_table};
pub use mean::{Mean, PressedLoad};
pub use outline::Outline;
pub use patches::{PressedPatches, patches_table};
pub use placed::LARGEST_EXTENT;
pub use press::{press, progress_steps};
pub use pressing::{ImposedLoad, Pressing};
pub use random_choices::RandomChoices;
pub use relief::Relief;
pub use specimen::{SpecimenCompliance, stiffness_without};
pub use state::PressedState;
pub use surfaces::{RandomSurfaces, Surfaces};
pub use table::{means_table, states_table};
