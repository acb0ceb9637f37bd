#![doc = include_str!("../README.md")]

mod answer_words;
pub mod curve_names;
mod decade;
pub mod explain;
pub mod page;
pub mod plot;
pub mod products;
pub mod reasons;
pub mod row_notes;
pub mod scan_words;
pub mod scans_table;
pub mod summary;
