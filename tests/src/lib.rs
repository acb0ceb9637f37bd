//! Common parts of the cross-crate tests: reference tables, golden curves, pictures, the page of the status, and
//! deviations of results from references.
//!
//! ```
//! use tests::{Deviations, ReferenceTable};
//!
//! let table = ReferenceTable::committed("sphere.csv");
//! let (radii_m, interferences_m) = (table.numbers("radius_m"), table.numbers("interference_m"));
//! let mut deviations = Deviations::default();
//! for ((radius_m, w_m), area_m2) in radii_m.iter().zip(interferences_m).zip(table.numbers("hertz_area_m2")) {
//!     deviations.note(std::f64::consts::PI * radius_m * w_m, area_m2);
//! }
//! deviations.assert_within("Hertz's area", 1e-15, 1e-15);
//! ```
#![deny(missing_docs)]

mod differences;
pub mod golden;
pub mod pictures;
mod reference;
pub mod status;

pub use differences::write_differences;
pub use reference::{Deviations, ReferenceTable, committed_file, shared_file};
