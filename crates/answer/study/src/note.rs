//! Notes on a spectrum, as data; `report` has the words.

use spectrum::Hole;
use topography::{Remark, Severity};

use crate::given_roughness::GivenRoughness;

/// A note on the spectrum of a surface. Deliberately not `#[non_exhaustive]`: every front end must word every variant.
#[derive(Debug, Clone, PartialEq)]
pub enum Note {
    /// An assumption that was made in reading the file, in the reader's words.
    Reading(String),
    /// The built-in spectrum is a reconstruction, not the published one.
    Reconstruction,
    /// Wavelengths that were not measured, from long to short, at least one.
    Holes(Vec<Hole>),
    /// It was not measured but made from roughness parameters.
    OfParameters(GivenRoughness),
    /// A remark on the scans that the spectrum is made from.
    Scans(Remark),
    /// The spectrum is the sum of the spectra of two surfaces.
    Superposition {
        /// Longest and shortest wavelength \[m\] that both have; absent if they share none.
        shared_m: Option<[f64; 2]>,
    },
    /// About one of the two surfaces of a contact.
    OfSurface {
        /// Its name.
        name: String,
        /// The note itself.
        note: Box<Note>,
    },
}

impl Note {
    /// Returns the severity of the note.
    #[must_use]
    pub fn severity(&self) -> Severity {
        match self {
            Note::Reading(_) | Note::Reconstruction | Note::Superposition { .. } => Severity::Note,
            Note::Holes(_) | Note::OfParameters(_) => Severity::Warning,
            Note::Scans(remark) => remark.severity(),
            Note::OfSurface { note, .. } => note.severity(),
        }
    }
}
