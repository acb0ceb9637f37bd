//! Synthetic studies of surfaces whose spectrum is known: do intervals of the area hold the truth as often as they
//! claim, and are they no wider than necessary?
//!
//! The steps, one module each:
//! * [`KnownSurface`]: a surface of a given or random spectrum;
//! * [`Laboratory`]: scans of Gaussian surfaces with that spectrum, cut out of longer ones, by [`Instrument`]s
//!   whose height scales are off within the stated uncertainty; a [`SyntheticStudy`] is their files;
//! * [`known_composite`]: the expectation of their composite;
//! * [`StudyOutcome`]: the study as a scene, with the program's intervals beside the areas of the known spectrum;
//!   [`CELLS`] of random spectra have many, and [`tails`] counts their misses.

mod cells;
mod instrument;
mod lines;
mod maps;
mod npy;
mod outcome;
mod page;
mod random;
mod scene;
mod surface;
mod synthetic;
mod truth;

pub use cells::{CELLS, COVERAGE, Cell, TAIL, Tails, is_compatible, tails};
pub use instrument::{AFM, AFM_LINES, GAIN_SD, INSTRUMENTS, Instrument, STYLUS, Shape};
pub use outcome::{IntervalOutcome, StudyOutcome};
pub use page::{TAILS_HEADER, tails_rows};
pub use surface::{Form, KnownSurface, LONGEST_M, RMS_GRADIENT, ROLLOFF_M};
pub use synthetic::{Laboratory, SyntheticStudy};
pub use truth::known_composite;
