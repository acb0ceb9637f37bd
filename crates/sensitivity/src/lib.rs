#![doc = include_str!("../README.md")]

mod other_choices;
mod variation;

pub use other_choices::{Moved, Sensitivity, counted_sensitivities, sensitivities, table, wanted_areas};
