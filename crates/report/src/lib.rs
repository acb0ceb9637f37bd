#![doc = include_str!("../README.md")]

mod answer_words;
pub mod curve_names;
mod cut_counts;
mod decade;
pub mod doubt_words;
pub mod elements_figure;
pub mod elements_words;
pub mod explain;
pub mod field_picture;
pub mod heights_picture;
mod judged;
mod listing;
pub mod occasion;
pub mod page;
pub mod persson_words;
pub mod plot;
pub mod products;
pub mod provenance;
pub mod reasons;
pub mod row_notes;
pub mod scan_words;
pub mod scans_table;
pub mod scene_note_words;
pub mod spectrum_words;
pub mod summary;
mod verdict_words;
mod yardstick_words;
