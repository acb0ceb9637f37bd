//! All texts: sentences, notes and text tables, made from results as data.

pub mod advice_words;
pub mod conclusion_words;
pub(crate) mod curve_counts;
pub mod curve_names;
pub mod details;
pub mod doubt_words;
pub mod dry_run;
pub mod elements_words;
pub(crate) mod interface_words;
pub(crate) mod listing;
pub(crate) mod persson_words;
pub mod provenance;
pub mod question_words;
pub(crate) mod row_notes;
pub mod scan_words;
pub mod scans_table;
#[cfg(feature = "scene-errors")]
pub mod scene_errors;
pub mod scene_note_words;
pub mod spectrum_words;
pub(crate) mod state_words;
pub mod uncertainty_words;
pub(crate) mod verdict_words;
pub(crate) mod yardstick_words;
