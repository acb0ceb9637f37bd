//! The tests of this crate from outside, in one program: linking takes longer than running them.

#[macro_use]
mod support;

mod field_files;
mod instruments;
mod scan_binary_errors;
#[cfg(feature = "container")]
mod scan_container;
mod scan_corpus;
mod scan_corruption;
mod scan_round_trip;
mod scan_samples;
mod scan_tables;
mod scan_text;
mod scan_writers;
