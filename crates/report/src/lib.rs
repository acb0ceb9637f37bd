#![doc = include_str!("../README.md")]

mod answer_words;
pub mod doubt_words;
pub mod explain;
pub mod page;
pub mod plot;
pub mod products;
pub mod scene_note_words;
pub mod summary;
