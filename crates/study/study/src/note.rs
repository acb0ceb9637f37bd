//! What is worth knowing about a spectrum, as data; `report` has the words.

use spectrum::Hole;
use topography::{Remark, Severity};

use crate::given_roughness::GivenRoughness;

/// Something to know about the spectrum of a surface. Whoever has words has some for all of these: a match on them is whole.
#[derive(Debug, Clone, PartialEq)]
pub enum Note {
    /// What reading its file took for granted, in the reader's words.
    Reading(String),
    /// The built-in spectrum is a reconstruction, not the published one.
    Reconstruction,
    /// Wavelengths that were not measured, from long to short, at least one.
    Holes(Vec<Hole>),
    /// It was not measured but made from roughness parameters.
    OfParameters(GivenRoughness),
    /// Of the scans that it is made from.
    Scans(Remark),
    /// It is the sum of the spectra of two surfaces.
    Superposition {
        /// Longest and shortest wavelength \[m\] that both have; absent where they share none.
        shared_m: Option<[f64; 2]>,
    },
    /// About one of the two surfaces of a contact.
    OfSurface {
        /// Its name.
        name: String,
        /// What.
        note: Box<Note>,
    },
}

impl Note {
    /// How much it matters.
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
