//! From the files of instruments to one spectrum: which scans, how each is read, and their composite as tables and figures.
//!
//! | step | file |
//! |---|---|
//! | what was asked for | `request.rs`: files with their own options; `list.rs`: a table of them |
//! | a file becomes heights | `load.rs`: format, unit and size from the file, else from metadata beside it, else as given |
//! | heights become one spectrum, with checks | the crate `topography`; `composite.rs` remembers the files |
//! | what is shown | `tables.rs`, `figure.rs` |
//! | maps in two dimensions | `areal.rs`; as heights that are pressed, `map.rs` |

mod areal;
mod composite;
mod error;
mod figure;
mod list;
mod load;
mod map;
mod request;
mod tables;

pub use areal::{AreaSpectrum, areal_spectrum};
pub use composite::{CompositeOfFiles, MapPatch, Source};
pub use error::{ScanProblem, TopographyError};
pub use list::{ListError, requests_of_list};
pub use map::MapOfFile;
pub use request::{RequestError, ScanRequest};
