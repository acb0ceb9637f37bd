//! What a study found, in words, SVG and one HTML page.

mod answer_words;
pub mod explain;
pub mod page;
pub mod plot;
pub mod products;
pub mod row_notes;
pub mod summary;
