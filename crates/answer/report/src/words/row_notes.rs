//! Notes on rows in words.

use questions::rows::RowsNote;
use units::display::counted;
use units::number;

use super::state_words::{narrow_spectra, state_notes};

/// A note in words; empty if there is nothing to say.
pub fn lines(note: &RowsNote) -> Vec<String> {
    match note {
        RowsNote::BeyondCompleteContact { row, pressure_pa, highest_pressure_pa } => vec![format!(
            "{row}: {} Pa is beyond complete contact of every asperity: area fraction 1, no separation; pressures below {} Pa \
             have one",
            number(*pressure_pa),
            number(*highest_pressure_pa)
        )],
        RowsNote::WithoutAsperities { rows, all } => {
            vec![format!("{rows} of {all} rows have no asperities: their results are empty")]
        }
        RowsNote::Bad { rows, all, .. } => {
            vec![format!(
                "{rows} of {all} rows have input that is missing or out of bounds: their results are NaN"
            )]
        }
        RowsNote::AssumedStrengths { rows, all } => {
            vec![format!("{rows} of {all} rows have a hardness and no yield strength: S0 = H/3 is used")]
        }
        RowsNote::NarrowSpectra { narrow, all } => {
            narrow_spectra(narrow, &counted(*all, "row")).into_iter().collect()
        }
        RowsNote::States(counts) => state_notes(counts),
        RowsNote::FlowingEverywhere { rows, all } => vec![format!(
            "{rows} of {all} rows: the pressure is not below the hardness; everything touches and flows"
        )],
        RowsNote::BeyondRange { rows, all, range } => {
            vec![format!("{rows} of {all} rows lie beyond {range}")]
        }
        _ => Vec::new(),
    }
}
