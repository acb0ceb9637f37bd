//! Notes on the rows of a curve, made from their counts.

use questions::CurveCounts;
use stacked_contact::Level;
use study::plan::CurveResult;

use crate::question_words::of_counts;

/// The notes on the states of a statistical curve, or on the cuts of Persson's theory.
pub fn statistical_notes(result: &CurveResult) -> Vec<String> {
    let mut counts = CurveCounts::default();
    counts.add(result);
    of_counts(&counts)
}

/// The note on levels beyond the range of the elastic-plastic sinusoid, if there are any.
pub fn beyond_fitted_range(curve: &[Vec<Level>]) -> Option<String> {
    let mut counts = CurveCounts::default();
    curve.iter().for_each(|levels| counts.levels.add(levels));
    of_counts(&counts).pop()
}
