//! Synthetic studies of surfaces whose spectrum is known: do intervals of the area hold the truth as often as they say, and
//! are they no wider than they must be?
//!
//! The steps, one module each:
//! * [`KnownSurface`]: a self-affine spectrum with a roll-off;
//! * [`Laboratory`]: scans of Gaussian surfaces with that spectrum, cut out of longer ones, by two [`Instrument`]s whose height
//!   scales are off by as much as is stated; a [`SyntheticStudy`] is their files;
//! * [`known_composite`]: what their composite estimates;
//! * [`biases`]: how far averages of scans lie from it;
//! * [`Trial`]: the study as a scene, with all that the program says of it, beside the areas of the known spectrum; [`coverages`]
//!   gathers many, and [`shrinkages`] holds what was said of further scans against what they bring.

mod advised;
mod bias;
mod coverage;
mod error;
mod instrument;
mod lines;
mod maps;
mod npy;
mod page;
mod random;
mod scene;
mod surface;
mod synthetic;
mod trial;
mod truth;

pub use advised::{Shrinkage, shrinkages};
pub use bias::{DecadeBias, biases};
pub use coverage::{Coverage, coverages, trials};
pub use error::StudyError;
pub use instrument::{AFM, GAIN_SD, INSTRUMENTS, Instrument, STYLUS, Shape};
pub use page::{bias_table, coverage_table, shrinkage_table};
pub use surface::{KnownSurface, LONGEST_M, RMS_GRADIENT, ROLLOFF_M};
pub use synthetic::{Laboratory, SyntheticStudy};
pub use trial::{Held, Trial};
pub use truth::known_composite;
