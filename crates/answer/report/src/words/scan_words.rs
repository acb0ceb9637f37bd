//! Remarks on a spectrum and remedies for errors of scans, in words.

use questions::remark_on_sampling;
use scans::{Mend, ScanOption};
use study::plan::Results;
use study::surface::Surface;
use units::{Remark, RemarkLevel, SceneKeys};

fn words(remark: &Remark) -> String {
    remark.words(&SceneKeys)
}

/// The notes to read before the answer: warnings, and assumptions on the spectrum itself. Notes on single scans belong to the
/// provenance.
pub(crate) fn foremost(surface: &Surface) -> Vec<String> {
    let is_foremost = |it: &&Remark| !it.code.is_about_scans() || it.level == RemarkLevel::Caution;
    surface.notes.iter().filter(is_foremost).map(words).collect()
}

/// The remedy for an error of a scan, in words that follow the error. `name_of` returns the name of an option in the front end,
/// if it has that option.
#[must_use]
pub fn mend(mend: Mend, name_of: impl Fn(ScanOption) -> Option<&'static str>) -> String {
    let (Mend::Give(option) | Mend::LeaveOut(option)) = mend;
    match (mend, name_of(option)) {
        (_, None) => String::new(),
        (Mend::Give(_), Some(name)) => format!("; set it with {name}"),
        (Mend::LeaveOut(_), Some(name)) => format!("; leave out {name}"),
    }
}

/// Words number and range of the scales of results, on which the stacked area depends.
pub(crate) fn sampling(results: &Results) -> String {
    remark_on_sampling(&results.psd).in_short()
}
