//! Sensitivities: the change of the final areas if an open modelling choice is made differently.
//!
//! Only final areas are computed, by plans of their own, and none that the results hold.

mod other_choices;
mod variation;

pub use other_choices::{
    MovedArea, Sensitivity, sensitivities, sensitivities_with_work, table, wanted_areas,
};
