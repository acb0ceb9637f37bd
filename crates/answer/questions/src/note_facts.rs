//! Level, kind and place of notes, which every front end shows alike.

use std::fmt::Debug;

use crate::rows::RowsNote;
use scene::SceneNote;
use study::models::Choice;
use topography::{Remark, Severity};

use crate::{Note, OptionName};

/// Weight of a note for whoever relies on the answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum NoteLevel {
    /// An assumption, an omission or a finding.
    Note,
    /// A doubt that changes what to conclude from the answer.
    Caution,
    /// Part of the answer is missing because its input is bad.
    Error,
}

units::named!(NoteLevel, "level", { Note => "note", Caution => "caution", Error => "error" });

/// Place that a note is about, as far as it is known.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct NotePlace {
    /// Names of the files or scans.
    pub files: Vec<String>,
    /// Row of an array or a table, counted from 0.
    pub row: Option<usize>,
    /// Line of a text, counted from 1.
    pub line: Option<usize>,
    /// Option of the question.
    pub option: Option<OptionName>,
    /// Key of a scene with its section, e.g. `curve.strain_gradient`.
    pub key: Option<String>,
}

impl Note {
    /// Returns the level of the note; none for a check that was passed.
    #[must_use]
    pub fn level(&self) -> Option<NoteLevel> {
        match self {
            Note::Surface(note) => match note.severity() {
                Severity::Passed => None,
                Severity::Note => Some(NoteLevel::Note),
                Severity::Warning => Some(NoteLevel::Caution),
            },
            Note::Doubt(_) => Some(NoteLevel::Caution),
            Note::Rows(RowsNote::Bad { .. }) => Some(NoteLevel::Error),
            _ => Some(NoteLevel::Note),
        }
    }

    /// Returns the place that the note is about; empty if it is about the whole answer.
    #[must_use]
    pub fn place(&self) -> NotePlace {
        let about = |option| NotePlace { option: Some(option), ..NotePlace::default() };
        match self {
            Note::Surface(note) => NotePlace { files: files_of(note), ..NotePlace::default() },
            Note::Rows(RowsNote::Bad { first, .. }) => {
                NotePlace { row: Some(*first), ..NotePlace::default() }
            }
            Note::AssumedStrength { .. } => about(OptionName::ModelOption(Choice::Strength)),
            Note::ToleranceTooFine { .. } => about(OptionName::Tolerance),
            Note::Sampling(_) => about(OptionName::ScalesPerDecade),
            Note::WavesOfProfiles => about(OptionName::ModelOption(Choice::Band)),
            _ => NotePlace::default(),
        }
    }
}

impl From<&SceneNote> for NotePlace {
    fn from(note: &SceneNote) -> Self {
        NotePlace { line: Some(note.line), key: Some(note.key.clone()), ..NotePlace::default() }
    }
}

/// Names of the scans or surfaces that a note on a surface is about.
fn files_of(note: &study::Note) -> Vec<String> {
    match note {
        study::Note::OfSurface { name, note } => match files_of(note) {
            files if files.is_empty() => vec![name.clone()],
            files => files,
        },
        study::Note::Scans(Remark::Scan { names, .. } | Remark::SameData { names }) => names.clone(),
        study::Note::Scans(Remark::Overlap { names, .. } | Remark::Directions { names, .. }) => {
            names.to_vec()
        }
        _ => Vec::new(),
    }
}

/// Kind of a note by the names of its types: `doubt.steep-surface` for `Doubt(SteepSurface { .. })`. It is the same for every
/// wording and value.
#[must_use]
pub fn note_code(note: &impl Debug) -> String {
    let text = format!("{note:?}");
    let names = text.split('(').map_while(|part| {
        let name: String = part.chars().take_while(|letter| letter.is_ascii_alphanumeric()).collect();
        name.starts_with(|first: char| first.is_ascii_uppercase()).then_some(name)
    });
    let kebab = names.map(|name| {
        let letters = name.char_indices().flat_map(|(at, letter)| {
            let dash = (at > 0 && letter.is_ascii_uppercase()).then_some('-');
            dash.into_iter().chain([letter.to_ascii_lowercase()])
        });
        letters.collect::<String>()
    });
    kebab.collect::<Vec<_>>().join(".")
}

#[cfg(test)]
mod tests {
    use findings::doubts::Doubt;

    use super::*;

    #[test]
    fn rows_without_results_are_errors_at_the_first_of_them() {
        let bad = Note::Rows(RowsNote::Bad { rows: 2, first: 7, all: 9 });
        assert_eq!(bad.level(), Some(NoteLevel::Error));
        assert_eq!(bad.place().row, Some(7));
        assert_eq!(note_code(&bad), "rows.bad");
    }

    #[test]
    fn doubts_are_cautions_and_passed_checks_have_no_level() {
        let steep = Note::Doubt(Doubt::of_slope(2.0).expect("a slope of 2 is steep"));
        assert_eq!(steep.level(), Some(NoteLevel::Caution));
        assert_eq!(steep.place(), NotePlace::default());
        let names = ["along x".to_owned(), "along y".to_owned()];
        let overlap = Remark::Overlap { names, ratio: 9.0, bins: 3, longest_m: 2e-6, shortest_m: 1e-6 };
        let overlap = Note::Surface(study::Note::Scans(overlap));
        assert_eq!(overlap.level(), Some(NoteLevel::Caution));
        assert_eq!(overlap.place().files, ["along x", "along y"]);
    }
}
