#![doc = include_str!("../README.md")]

pub mod bodies;
pub mod body_properties;
pub mod choices_in_words;
pub mod figure;
pub mod gap_law;
pub mod given_roughness;
pub mod growth_law;
pub mod hardness_and_strength;
pub mod interface;
pub mod layer_base;
pub mod linear_laws;
mod load;
pub mod material;
pub mod material_spreads;
pub mod materials;
pub mod measured;
pub mod model_options;
pub mod models;
pub mod plan;
pub mod result_tables;
pub mod spread;
pub mod student;
pub mod surface;
pub mod validity;
mod way_out;

pub use measurements::{self, Files, NoFiles};
pub use models::persson as persson_law;
pub use numerics::parallel::{Progress, Unobserved};
pub use way_out::way_out;
