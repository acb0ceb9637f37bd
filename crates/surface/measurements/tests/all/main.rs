//! The tests of this crate from outside, in one program: linking takes longer than running them.

mod channels;
mod facing;
mod in_memory;
mod mutated_texts;
#[path = "../../../scans/tests/all/support/nanoscope.rs"]
#[allow(dead_code, reason = "written for the tests of the reader")]
mod nanoscope;
mod one_map;
mod scan_lists;
mod scan_requests;
