//! What the cross-crate tests share: reference tables, golden curves, and how far results lie from them.
#![deny(missing_docs)]

pub mod golden;
pub mod pictures;
mod reference;

pub use reference::{Deviations, ReferenceTable, committed_file, shared_file};
