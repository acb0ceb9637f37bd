//! Notes on the rows of a curve, made from their counts.

use questions::CurveCounts;
use stacked_contact::Level;
use study::plan::CurveResult;

use units::SceneKeys;

/// The notes on the states of a statistical curve, or on the cuts of Persson's theory.
pub fn statistical_notes(result: &CurveResult) -> Vec<String> {
    let mut counts = CurveCounts::default();
    counts.add(result);
    words(&counts)
}

/// The note on levels beyond the range of the elastic-plastic sinusoid, if there are any.
pub fn beyond_fitted_range(curve: &[Vec<Level>]) -> Option<String> {
    let mut counts = CurveCounts::default();
    curve.iter().for_each(|levels| counts.levels.add(levels));
    words(&counts).pop()
}

fn words(counts: &CurveCounts) -> Vec<String> {
    counts.remarks().iter().map(|remark| remark.words(&SceneKeys)).collect()
}
