//! Values of a figure at each abscissa, for a page that shows them under the pointer.

use serde::Serialize;

/// Values of the lines of a figure. Places are in units of the drawing.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Reading {
    /// Left, top, right and bottom of the frame.
    pub frame: [f64; 4],
    /// Places along the abscissa, from left to right, with the abscissa in print.
    pub places: Vec<(f64, String)>,
    /// The lines.
    pub lines: Vec<ReadingLine>,
}

/// A line of a figure with its values in print.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ReadingLine {
    /// The class of the line's elements in the drawing.
    pub class: String,
    /// The name of the line.
    pub name: String,
    /// Place along both axes, and the value in print, from left to right.
    pub points: Vec<(f64, f64, String)>,
}
