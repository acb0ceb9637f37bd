//! From the files of instruments to one spectrum: which scans, how each is read and transformed, and their composite.
//!
//! | step | file |
//! |---|---|
//! | what was asked for | `request.rs`: files with their own options, and how spectra are made |
//! | a file becomes heights | `load.rs`: format, unit and size from the file, else from metadata beside it, else as given |
//! | heights become a spectrum | `measure.rs`: transformed in parallel, limited to the band that shows the surface |
//! | is it right? | `checks.rs`: Parseval, slopes in real space, the fundamental mode, overlaps of instruments |
//! | several become one | `composite.rs`, drawn by `figure.rs` |
//! | maps in two dimensions | `areal.rs` |

mod areal;
mod checks;
mod composite;
mod error;
mod figure;
mod load;
mod measure;
mod request;

pub use areal::{AreaSpectrum, areal_spectrum};
pub use checks::Checks;
pub use composite::{CompositeSpectrum, InstrumentsDisagree};
pub use error::{ScanProblem, TopographyError};
pub use measure::ScanSpectrum;
pub use request::{Average, DEFAULT_BINS_PER_DECADE, Recipe, RequestError, ScanRequest};
