//! What the cross-crate tests share: reference tables, and how far results lie from them.
#![deny(missing_docs)]

mod reference;

pub use reference::{Deviations, ReferenceTable};
