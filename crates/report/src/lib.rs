//! What a study found, in words, SVG and one HTML page.

mod answer_words;
pub mod curve_names;
pub mod explain;
pub mod page;
pub mod plot;
pub mod products;
pub mod reasons;
pub mod summary;
