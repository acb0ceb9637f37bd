//! Sensitivities: each choice that the models leave open, made another way, and how far it moves the final areas.
//!
//! Only final areas are computed, by plans of their own, and none that the results hold.

mod other_choices;
mod variation;

pub use other_choices::{Moved, Sensitivity, counted_sensitivities, sensitivities, table, wanted_areas};
