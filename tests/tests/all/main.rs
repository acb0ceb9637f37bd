//! The tests of this crate from outside, in one program: linking takes longer than running them.

mod adding_a_format;
mod adding_a_law;
mod asperity_references;
mod boundary_element_references;
mod contact_challenge;
mod documentation;
mod followed_page;
mod generated;
mod golden;
mod instrument_samples;
mod layer_references;
mod modules;
mod persson_references;
mod public_names;
mod relations;
mod spectrum_references;
mod stacked_references;
mod statistical_references;
mod tangential_references;
mod uncd_scans;
mod work_counters;
