//! What there is to say of rows, in words.

use state_tables::RowsNote;
use units::display::counted;
use units::number;

use super::curve_counts::{narrow_spectra, state_notes};

/// A note as people read it; none where there is nothing to say.
pub fn told(note: &RowsNote) -> Vec<String> {
    match note {
        RowsNote::BeyondCompleteContact { row, pressure_pa, highest_pressure_pa } => vec![format!(
            "{row}: {} Pa is beyond complete contact of every asperity: area fraction 1, no separation; every pressure \
             below {} Pa has one",
            number(*pressure_pa),
            number(*highest_pressure_pa)
        )],
        RowsNote::WithoutAsperities { rows, all } => {
            vec![format!("{rows} of {all} rows have no asperities: their results are empty")]
        }
        RowsNote::AssumedStrengths { rows, all } => vec![format!(
            "{rows} of {all} rows have a hardness and no yield strength: a third of the hardness is taken, S0 = H/3"
        )],
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
