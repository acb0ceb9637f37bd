//! All texts: sentences, notes and text tables, made from results as data.

pub mod advice_words;
pub(crate) mod cause_words;
pub mod conclusion_words;
pub(crate) mod curve_counts;
pub mod curve_names;
pub mod details;
pub mod dry_run;
pub mod elements_words;
pub(crate) mod interface_words;
pub(crate) mod listing;
pub mod provenance;
pub mod question_words;
pub mod scan_words;
pub mod scans_table;
#[cfg(feature = "scene-errors")]
pub mod scene_errors;
pub mod spectrum_words;
pub mod uncertainty_words;
pub(crate) mod verdict_words;
pub(crate) mod yardstick_words;
