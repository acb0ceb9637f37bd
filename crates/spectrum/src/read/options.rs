//! What a caller may say about a file.

use crate::convention::Convention;
use crate::read::header::Abscissa;

/// What the caller knows about a file that the file does not say.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ReadOptions {
    /// Name of the column that holds the spectrum, exact or in another case.
    pub column: Option<String>,
    /// Convention of the spectrum, whatever the name of its column says.
    pub convention: Option<Convention>,
    /// What the first column of a file without a header holds; with a header, which of several columns
    /// counts.
    pub x: Option<Abscissa>,
}
