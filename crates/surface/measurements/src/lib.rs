#![doc = include_str!("../README.md")]

mod agreement;
mod areal;
mod calibration;
mod channels;
mod composite;
mod error;
mod evaluated;
mod files;
mod folders;
mod instrument;
mod list;
mod load;
mod map;
mod map_patch;
mod only_map;
mod request;
mod roughness_of_files;
mod scales_of_files;
mod sketch;

pub use areal::{ArealTable, areal_spectrum};
pub use calibration::{Instrument, SlopeUncertainty, ZCalibration};
pub use channels::{Channels, read_channels};
pub use composite::{CompositeOfFiles, STEPS_PER_FILE, ScanInput, ScanSource};
pub use error::{ScanProblem, TopographyError};
pub use files::{Files, NoFiles};
pub use folders::ScansInFolders;
pub use instrument::InstrumentOfScan;
pub use list::{ListError, requests_of_list};
pub use load::{Loaded, METADATA_FILES, heights_in, holds_a_spectrum, holds_heights};
pub use map::MapOfFile;
pub use map_patch::MapPatch;
pub use request::{RequestError, ScanRequest, TipRadius};
pub use roughness_of_files::{Conventions, RoughnessOfFiles, RoughnessSettings};
pub use scales_of_files::ScalesOfFiles;
pub use sketch::ScanSketch;
