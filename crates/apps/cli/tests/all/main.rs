//! The tests of this crate from outside, in one program: linking takes longer than running them.

mod answers;
mod attack;
mod bem;
mod columns;
mod conductance;
#[cfg(unix)]
mod documentation;
mod elements_law;
mod faces;
mod flow;
mod gap;
mod help;
mod idle;
mod inputs;
mod instruments;
mod layers;
mod lubrication;
mod messages;
#[path = "../../../../surface/scans/tests/all/support/nanoscope.rs"]
#[allow(dead_code, reason = "written for the tests of the reader")]
mod nanoscope;
mod one_command;
mod outputs;
mod persson;
mod relations;
mod report;
mod roughness;
mod scan_findings;
mod scans;
mod scenes;
mod spectra;
mod statistical;
mod support;
mod tables;
mod two_maps;
mod uncertainty;
#[path = "../../../../surface/scans/tests/all/support/zip_file.rs"]
#[allow(dead_code, reason = "written for the tests of readers")]
mod zip_file;
