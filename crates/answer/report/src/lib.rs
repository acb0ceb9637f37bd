#![doc = include_str!("../README.md")]

pub mod chart;
mod figures;
pub mod page;
pub mod products;
pub mod run_stamp;
mod words;

pub use figures::elements_figure;
use figures::{interface_figure, intervals, judged};
#[cfg(feature = "scene-errors")]
pub use words::scene_errors;
pub use words::{
    advice_words, conclusion_words, curve_names, details, dry_run, elements_words, provenance,
    question_words, scan_words, scans_table, spectrum_words, uncertainty_words,
};
use words::{cause_words, interface_words, listing, verdict_words, yardstick_words};
