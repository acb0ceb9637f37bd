//! Synthetic studies of surfaces whose spectrum is known: do intervals of the area hold the truth as often as they
//! claim, and are they no wider than necessary?
//!
//! The steps, one module each:
//! * [`KnownSurface`]: a self-affine spectrum with a roll-off;
//! * [`Laboratory`]: scans of Gaussian surfaces with that spectrum, cut out of longer ones, by two [`Instrument`]s
//!   whose height scales are off within the stated uncertainty; a [`SyntheticStudy`] is their files;
//! * [`known_composite`]: the expectation of their composite;
//! * [`biases`]: the deviation of averages of scans from it;
//! * [`Moves`]: the ends of intervals with other seeds of the draws;
//! * [`Trial`]: the study as a scene, with the program's results beside the areas of the known spectrum;
//!   [`coverages`] gathers many, and [`shrinkages`] compares the advice on further scans with their effect.

mod advised;
mod bias;
mod cells;
mod coverage;
mod error;
mod instrument;
mod lines;
mod maps;
mod npy;
mod page;
mod random;
mod scene;
mod seeds;
mod surface;
mod synthetic;
mod trial;
mod truth;

pub use advised::{Shrinkage, shrinkages};
pub use bias::{DecadeBias, biases};
pub use cells::{CELLS, COVERAGE, Cell, TAIL, Tails, is_compatible, tails};
pub use coverage::{Coverage, coverages, trials};
pub use error::StudyError;
pub use instrument::{AFM, AFM_LINES, GAIN_SD, INSTRUMENTS, Instrument, STYLUS, Shape};
pub use page::{TAILS_HEADER, bias_table, coverage_table, shrinkage_table, tails_rows};
pub use seeds::{LARGEST_MOVE, Moves};
pub use surface::{Form, KnownSurface, LONGEST_M, RMS_GRADIENT, ROLLOFF_M};
pub use synthetic::{Laboratory, SyntheticStudy};
pub use trial::{IntervalOutcome, Trial};
pub use truth::known_composite;
