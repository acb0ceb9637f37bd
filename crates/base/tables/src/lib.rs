#![doc = include_str!("../README.md")]

mod csv_text;
mod error;
mod input;
mod json_text;
pub mod markdown;
mod source;
#[cfg(feature = "staging")]
pub mod staging;
mod table;
mod writer;

pub use error::{Refusal, TableError};
pub use input::{InputTable, Row};
pub use source::TableSource;
pub use table::{Cell, Cells, Table};
pub use writer::{Format, TableWriter};

/// Prefix of comment lines that this program writes.
pub const OWN_COMMENT: &str = "truearea ";
