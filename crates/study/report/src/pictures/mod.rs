//! Pictures of maps and lines, point by point.

pub mod field_picture;
pub mod heights_picture;
