//! Errors of damaged objects.

use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;

pub(super) const MEND: &str = "the file is damaged: save it again from Gwyddion";

/// An object under a key of the file lacks a component.
pub(super) fn missing(key: &str, name: &str) -> ScanReadError {
    let place = FilePlace::Element(key.to_owned());
    ScanFormat::Gwyddion.missing(place, format!("component '{name}'"), MEND)
}

/// Something under a key of the file is not what it must be.
pub(super) fn bad(key: &str, field: &str, value: impl ToString, bound: impl Into<String>) -> ScanReadError {
    ScanFormat::Gwyddion.bad(FilePlace::Element(key.to_owned()), field, value, bound, MEND)
}
