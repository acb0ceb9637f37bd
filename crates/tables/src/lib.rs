//! Tables as columns: what came in, as typed, and what was computed beside it; CSV or JSON, in blocks of rows.
//!
//! ```
//! use std::io::Cursor;
//! use tables::{Format, TableSource};
//! use units::Bound;
//!
//! let file = "radius_m,note\n1e-6,small\n2e-6,larger\n";
//! let rows = TableSource::new("spheres.csv", Cursor::new(file))?.whole()?;
//! let radii_m = rows.numbers([("radius_m", Bound::Positive)])?;
//! let table = rows.table.with_numbers("diameter_m", radii_m.iter().map(|[radius_m]| 2.0 * radius_m));
//! let mut written = Vec::new();
//! table.write(Format::Csv, &[], &mut written)?;
//! assert_eq!(written, b"radius_m,note,diameter_m\n1e-6,small,2e-6\n2e-6,larger,4e-6\n");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod csv_text;
mod error;
mod input;
mod json_text;
mod source;
mod table;
mod writer;

pub use error::{Refusal, TableError};
pub use input::{InputTable, Row};
pub use source::TableSource;
pub use table::{Cell, Cells, Table};
pub use writer::{Format, TableWriter};

/// What begins the comment lines that this program writes itself.
pub const OWN_COMMENT: &str = "truearea ";
