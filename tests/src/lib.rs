//! What the cross-crate tests share: reference tables, golden curves, and how far results lie from them.
#![deny(missing_docs)]

mod differences;
pub mod golden;
mod reference;

pub use differences::write_differences;
pub use reference::{Deviations, ReferenceTable, committed_file, shared_file};
