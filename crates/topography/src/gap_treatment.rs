//! What is done about the points of a scan that have no height.

use scans::{Scan, ScanFile};
use serde::{Deserialize, Serialize};

use crate::error::TransformError;

/// What is done about the points of a scan that have no height.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum GapTreatment {
    /// A scan with gaps is refused.
    Refuse,
    /// Gaps are filled by the harmonic surface through the points around them.
    #[default]
    Harmonic,
    /// Only lines, or stretches of lines, without gaps take part.
    Lines,
}

units::named!(GapTreatment, "treatment of gaps", { Refuse => "refuse", Harmonic => "harmonic", Lines => "lines" });

/// A file whose scan is whole, with a note of what was done about its gaps.
///
/// # Errors
/// [`TransformError::Gaps`] where they are refused.
pub fn without_gaps(file: ScanFile, treatment: GapTreatment) -> Result<ScanFile<Scan>, TransformError> {
    match treatment {
        // Filling and cutting follow; until then gaps are refused whatever was asked for.
        GapTreatment::Refuse | GapTreatment::Harmonic | GapTreatment::Lines => {
            file.try_map(|scan| Ok(scan.complete()?))
        }
    }
}
