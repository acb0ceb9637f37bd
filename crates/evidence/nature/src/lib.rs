//! Measured contacts beside what the program predicts of them, behind `docs/guide/nature.md`:
//!
//! * [`resistance`]: measured thermal resistances as rows with types;
//! * [`prediction`]: the rules by which a resistance is predicted;
//! * [`joint`]: rock joints, from the map of their aperture and the measured closure;
//! * [`table`] and [`page`]: the committed tables, and what the page makes of them.
//!
//! The measurements are those of others and are not part of the repository: `cargo xtask nature --data FOLDER`.
#![deny(missing_docs)]

mod error;
pub mod joint;
pub mod page;
pub mod prediction;
pub mod resistance;
pub mod table;

pub use error::NatureError;
