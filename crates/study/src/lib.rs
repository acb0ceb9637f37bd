#![doc = include_str!("../README.md")]

pub mod choices_in_words;
pub mod figure;
mod files;
pub mod hardness_and_strength;
pub mod linear_laws;
pub mod material;
pub mod measured;
pub mod models;
mod note;
pub mod persson_law;
pub mod plan;
pub mod result_tables;
pub mod scene;
pub mod surface;
pub mod topography;

pub use features;
pub use files::{Files, NoFiles};
pub use note::Note;
pub use parallel::{Progress, Unobserved};
