//! Tables of `docs/guide/uncertainty.md`.

use crate::advised::Shrinkage;
use crate::bias::DecadeBias;
use crate::cells::{Cell, Tails};
use crate::coverage::Coverage;

/// Table of the bias of averages, decade by decade.
#[must_use]
pub fn bias_table(hurst_exponent: f64, rows: &[DecadeBias]) -> String {
    let mut text = String::from(
        "| Hurst exponent | instrument | average | decade from | bins | off the spectrum seen | standard error | off the known spectrum |\n\
         | ---: | --- | --- | ---: | ---: | ---: | ---: | ---: |\n",
    );
    for row in rows {
        text += &format!(
            "| {hurst_exponent} | {} | {} | 10^{} m | {} | {} | {:.1} % | {} |\n",
            row.instrument.name,
            row.average.name(),
            row.decade,
            row.bins,
            signed_percent(row.of_expected),
            100.0 * row.standard_error,
            signed_percent(row.of_known)
        );
    }
    text
}

/// Table of the coverage of intervals.
#[must_use]
pub fn coverage_table(hurst_exponent: f64, scans: u32, rows: &[Coverage]) -> String {
    let mut text = String::from(
        "| Hurst exponent | scans each | curve | load | studies | hold the truth | median ln(high/low) | over 3.92 rms | mean ln(median/truth) |\n\
         | ---: | ---: | --- | --- | ---: | ---: | ---: | ---: | ---: |\n",
    );
    for row in rows {
        text += &format!(
            "| {hurst_exponent} | {scans} | {} | {} | {} | {:.1} % | {:.3} | {:.2} | {:+.4} |\n",
            row.curve,
            row.load,
            row.studies,
            100.0 * row.share(),
            row.width,
            row.relative_width(),
            row.bias
        );
    }
    text
}

/// Table of the shrinkage of intervals, as predicted and as found.
#[must_use]
pub fn shrinkage_table(hurst_exponent: f64, rows: &[Shrinkage]) -> String {
    let mut text = String::from(
        "| Hurst exponent | curve | load | more scans of | added | predicted | found | found over predicted |\n\
         | ---: | --- | --- | --- | ---: | ---: | ---: | ---: |\n",
    );
    for row in rows {
        text += &format!(
            "| {hurst_exponent} | {} | {} | {} | {} | {:.3} | {:.3} | {:.2} |\n",
            row.curve, row.load, row.instrument, row.added, row.predicted, row.real, row.ratio
        );
    }
    text
}

/// Formats a difference of logarithms as a share.
fn signed_percent(difference: f64) -> String {
    format!("{:+.1} %", 100.0 * difference.exp_m1())
}

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
