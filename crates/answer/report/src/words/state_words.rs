//! Notes on states and on spectra without summits.

use questions::rows::{NarrowSpectra, StateCounts};
use units::display::counted;
use units::number;

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
pub(crate) fn notes_of_states(counts: &StateCounts) -> Vec<String> {
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
