//! Table of `docs/theory/intervals.md`.

use super::cells::{Cell, Tails};

/// Head of the table of [`tails_rows`].
pub const TAILS_HEADER: &str = "| cell | spectra | scans | curve | load | studies | hold the truth | truth above | truth below | median ln(high/low) | width over need | verdict |\n\
     | ---: | --- | --- | --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | --- |";

/// Rows of a cell: coverage, tails, and the verdict.
#[must_use]
pub fn tails_rows(number: usize, cell: &Cell, rows: &[Tails]) -> String {
    let mut text = String::new();
    for row in rows {
        let percent = |hits: usize| 100.0 * hits as f64 / row.studies as f64;
        text += &format!(
            "| {number} | {} | {} | {} | {} | {} | {:.1} % | {:.1} % | {:.1} % | {:.3} | {:.2} | {} |\n",
            cell.form.name(),
            cell.scans_in_words(),
            row.curve,
            row.load,
            row.studies,
            percent(row.held()),
            percent(row.above),
            percent(row.below),
            row.width,
            row.width_over_need,
            if row.passes() { "holds" } else { "fails" }
        );
    }
    text
}
