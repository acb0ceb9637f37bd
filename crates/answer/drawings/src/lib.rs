#![doc = include_str!("../README.md")]

pub mod field_picture;
pub mod heights_picture;
pub mod model_style;
pub mod plot;
pub mod thumbnail;
