//! Notes on the rows of a curve, made from their counts.

use questions::CurveCounts;
use stacked_contact::Level;
use state_tables::{NarrowSpectra, StateCounts};
use study::plan::CurveResult;
use units::display::counted;
use units::number;

use crate::question_words::of_counts;

/// The notes on the states of a statistical curve, or on the cuts of Persson's theory.
pub fn statistical_notes(result: &CurveResult) -> Vec<String> {
    let mut counts = CurveCounts::default();
    counts.add(result);
    of_counts(&counts)
}

/// The notes on one block of a curve.
pub(crate) fn notes_of_block(result: &CurveResult, block: usize) -> Vec<String> {
    let mut counts = CurveCounts::default();
    counts.add_block(result, block);
    of_counts(&counts)
}

/// The note on levels beyond the range of the elastic-plastic sinusoid, if there are any.
pub fn beyond_fitted_range(curve: &[Vec<Level>]) -> Option<String> {
    let mut counts = CurveCounts::default();
    curve.iter().for_each(|levels| counts.levels.add(levels));
    of_counts(&counts).pop()
}

/// The note on spectra without summits, if there are any.
pub(crate) fn narrow_spectra(narrow: &NarrowSpectra, of: &str) -> Option<String> {
    // Rounded down, so that none reads 1.5.
    let [lowest, highest] = narrow.alphas?.map(|alpha| number((1e3 * alpha).floor() / 1e3));
    let alphas = if lowest == highest { lowest } else { format!("{lowest} to {highest}") };
    Some(format!(
        "{} of {of}: alpha = m0 m4/m2^2 is {alphas}, below the 1.5 that every surface reaches: no summits, no result",
        narrow.count
    ))
}

/// The notes on states, with those beyond complete contact.
pub fn notes_of_states(counts: &StateCounts) -> Vec<String> {
    let what = "beyond complete contact of every asperity, area fraction 1, no separation";
    of_states(counts.incomplete, counts, what).into_iter().chain(state_notes(counts)).collect()
}

/// The notes on states but those beyond complete contact.
pub(crate) fn state_notes(counts: &StateCounts) -> Vec<String> {
    let clamped = of_states(
        counts.clamped,
        counts,
        "more contact area than there is nominal area, held at an area fraction of 1",
    );
    let out_of_range = of_states(
        counts.out_of_range,
        counts,
        "most of the load on asperities outside the fitted range of their law",
    );
    clamped.into_iter().chain(out_of_range).collect()
}

fn of_states(found: usize, counts: &StateCounts, what: &str) -> Option<String> {
    (found > 0).then(|| format!("{found} of {}: {what}", counted(counts.all, "state")))
}
