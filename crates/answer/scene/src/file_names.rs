//! Names of curves and figures. They become names of files, which must not replace one another.

use std::ops::Range;

use super::error::{SceneError, SceneProblem};
use super::raw::RawScene;
use study::figure::{AREA_OF_ALL, Figure};
use study::plan::Curve;

/// The name of the report.
pub const REPORT: &str = "report";
/// The names of the report's tables: of what curves end in, of what each decade decides, of other choices.
pub const REPORT_TABLES: [&str; 3] = ["report-scales", "report-decades", "report-sensitivity"];
/// The names of the judge's tables: the verdict on every curve, and on every window.
pub const JUDGE_TABLES: [&str; 2] = ["report-models", "report-judge"];
/// The names of the tables of draws: the interval of every area, the indices of its inputs, and what to measure next.
pub const UNCERTAINTY_TABLES: [&str; 3] = ["report-uncertainty", "report-sobol", "report-advice"];

/// The name of the table of the results on the interface.
pub const INTERFACE_TABLE: &str = "report-interface";

/// Refuses curves and figures whose files would replace those of another or of the report. Disks differ in whether case
/// counts, so here it does not.
pub(super) fn check(raw: &RawScene, curves: &[Curve], figures: &[Figure]) -> Result<(), SceneError> {
    let curve_spans =
        raw.curve.iter().map(|curve| curve.get_ref().name.as_ref().map_or(curve.span(), |name| name.span()));
    let curves = curves.iter().map(|curve| curve.name.as_str()).zip(curve_spans);
    let figure_spans = raw.figure.iter().map(|figure| figure.get_ref().name.span());
    // A scene without figures gets one of all curves, which has no place in its text.
    let drawn = figures.iter().map(|figure| figure.name.as_str()).zip(figure_spans);
    let mut taken: Vec<&str> = [&REPORT_TABLES[..], &JUDGE_TABLES[..], &UNCERTAINTY_TABLES[..]].concat();
    taken.extend([REPORT, INTERFACE_TABLE]);
    if raw.figure.is_empty() && !figures.is_empty() {
        taken.push(AREA_OF_ALL);
    }
    for (name, span) in curves.chain(drawn) {
        refuse_taken(name, span, &taken)?;
        taken.push(name);
    }
    Ok(())
}

fn refuse_taken(name: &str, span: Range<usize>, taken: &[&str]) -> Result<(), SceneError> {
    let lower = name.to_lowercase();
    match taken.iter().find(|other| other.to_lowercase() == lower) {
        Some(other) => {
            let problem = SceneProblem::FileNameTaken { name: name.to_owned(), by: (*other).to_owned() };
            Err(SceneError::at(span, problem))
        }
        None => Ok(()),
    }
}
