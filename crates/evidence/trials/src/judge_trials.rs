//! Trials of the judge of scenes: spectra of every kind, whose whole band is solved at once, against the judge that must cut
//! them into windows: tables of `docs/develop/trials.md`.

use judge::{CurveVerdict, JudgePlan, JudgeSettings, Verdict};
use numerics::parallel::Unobserved;
use scene::Scene;
use serde::{Deserialize, Serialize};
use tables::markdown::{table, with_section};
use units::display::three_digits;

use crate::TrialError;
use crate::elements::digits;
use crate::judge_spectra::{JudgeTrial, Kind, LayerKind, Set};
use crate::judge_truth::{TRUTH_ERROR, TruthRow};

/// Budget of the judge: three windows under three loads on grids of 96 points a side, about one decade each.
const BUDGET: f64 = 1.2e7;

impl JudgeTrial {
    /// Judges the spectrum in windows, and compares the judge and every curve with the truth.
    ///
    /// # Errors
    /// The error of making or pressing a surface, and of running a model.
    pub fn judged(&self, truth: &[TruthRow]) -> Result<Vec<JudgedRow>, TrialError> {
        let JudgeTrial { set, kind, number } = *self;
        judged(&self.scene(true)?, |load| {
            let known = truth.iter().filter(|row| row.number == number).nth(load)?;
            let (load, truth, truth_error) =
                (known.pressure_over_gradient, known.area_fraction, known.relative_error);
            Some(JudgedRow {
                set,
                kind,
                number,
                stiffening: 1.0,
                load,
                truth,
                truth_error,
                ..JudgedRow::default()
            })
        })
    }
}

/// Judges a scene in windows, and compares the judge and every curve with the truth of each load by its index; loads without one
/// are left out.
pub(crate) fn judged(
    scene: &Scene,
    truth: impl Fn(usize) -> Option<JudgedRow>,
) -> Result<Vec<JudgedRow>, TrialError> {
    let settings = JudgeSettings { budget: BUDGET, ..JudgeSettings::default() };
    let results = scene.plan().compute()?;
    let judgement = JudgePlan::new(scene, &results, &settings).run(&Unobserved)?;
    let row = |curve: &CurveVerdict| {
        let (known, elements) = (truth(curve.load)?, curve.elements?);
        Some(JudgedRow {
            judge: digits(elements.area_fraction / known.truth),
            stated_error: digits(elements.relative_error()),
            bracket: digits(elements.high() / elements.low()),
            curve: scene.needs.curves[curve.curve].name.clone(),
            curve_over_truth: digits(curve.area_fraction? / known.truth),
            agrees: curve.verdict == Verdict::Agrees,
            holds: curve.holds(),
            ..known
        })
    };
    Ok(judgement.curves.iter().filter_map(row).collect())
}

/// A curve under a load, beside the judge and the truth.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct JudgedRow {
    /// Set of the trial.
    pub set: Set,
    /// Layer; none on a half-space.
    pub layer: Option<LayerKind>,
    /// Form of the spectrum.
    pub kind: Kind,
    /// Number of the spectrum among those of the judge's trials.
    pub number: u32,
    /// Rms pressure of full contact over that without a layer.
    pub stiffening: f64,
    /// Load p/(2s), with the rms pressure s of full contact.
    pub load: f64,
    /// Area fraction of the whole band solved at once.
    pub truth: f64,
    /// Its relative standard error.
    pub truth_error: f64,
    /// Judge's area over the truth.
    pub judge: f64,
    /// Relative standard error that the judge states.
    pub stated_error: f64,
    /// Upper over lower end of the judge's bracket.
    pub bracket: f64,
    /// Name of the curve.
    pub curve: String,
    /// Curve's area over the truth.
    pub curve_over_truth: f64,
    /// True if its verdict on the whole band is `agrees`.
    pub agrees: bool,
    /// True if it agrees on most windows too.
    pub holds: bool,
}

/// Returns the page with new tables; its text is written by hand.
///
/// # Errors
/// [`TrialError::Page`] if the page lacks a section.
pub fn written(page: &str, rows: &[JudgedRow]) -> Result<String, TrialError> {
    let sections = [("judge", errors(rows)), ("agrees", promises(rows))];
    sections.into_iter().try_fold(page.to_owned(), |page, (name, contents)| {
        with_section(&page, name, &contents).map_err(TrialError::Page)
    })
}

/// Errors of the judge, for each set and each kind of the reported one.
fn errors(rows: &[JudgedRow]) -> String {
    let of_judge: Vec<&JudgedRow> = rows.iter().filter(|row| row.curve == "persson").collect();
    let line = |name: &str, wanted: &dyn Fn(&JudgedRow) -> bool| {
        let of_line: Vec<&JudgedRow> = of_judge.iter().copied().filter(|row| wanted(row)).collect();
        let worst = of_line.iter().map(|row| (row.judge.ln().abs(), row.judge));
        let worst = worst.max_by(|a, b| a.0.total_cmp(&b.0)).map_or(1.0, |(_, ratio)| ratio);
        let [rms, within, bracket] = errors_of_judge(&of_line);
        vec![name.to_owned(), rms, three_digits(worst), within, bracket]
    };
    let mut lines = vec![
        line("calibration", &|row| row.set == Set::Calibration),
        line("reported", &|row| row.set == Set::Report),
        line("reported, truth known to 2 %", &|row| row.set == Set::Report && row.truth_error <= TRUTH_ERROR),
    ];
    lines.extend(Kind::IN_BOTH_SETS.iter().chain(&Kind::FURTHER).map(|&kind| {
        line(&format!("reported, {}", kind.name()), &|row| row.set == Set::Report && row.kind == kind)
    }));
    table(&["trials", "rms", "worst ratio", "within two standard errors", "median bracket"], &lines)
}

/// Rms error of the judge, how often it is within two standard errors, and its median bracket.
pub(crate) fn errors_of_judge(rows: &[&JudgedRow]) -> [String; 3] {
    let count = rows.len();
    let squares: f64 = rows.iter().map(|row| row.judge.ln().powi(2)).sum();
    let within = rows.iter().filter(|row| row.is_within_two_errors()).count();
    let mut brackets: Vec<f64> = rows.iter().map(|row| row.bracket).collect();
    brackets.sort_by(f64::total_cmp);
    [
        format!("{:.1} %", 100.0 * (squares / count.max(1) as f64).sqrt()),
        format!("{within} of {count}"),
        three_digits(brackets.get(count / 2).copied().unwrap_or(f64::NAN)),
    ]
}

/// Share of the curves that get `agrees` and are within 4/3 of the truth.
fn promises(rows: &[JudgedRow]) -> String {
    let line = |name: &str, set: Set, has: fn(&JudgedRow) -> bool| {
        let promised = || rows.iter().filter(|row| row.set == set && has(row));
        let kept = promised().filter(|row| row.is_curve_right()).count();
        let count = promised().count();
        vec![
            name.to_owned(),
            format!("{kept} of {count}"),
            format!("{:.1} %", 100.0 * kept as f64 / count.max(1) as f64),
        ]
    };
    let lines = [
        line("calibration, whole band", Set::Calibration, |row| row.agrees),
        line("calibration, whole band and most windows", Set::Calibration, |row| row.holds),
        line("reported, whole band", Set::Report, |row| row.agrees),
        line("reported, whole band and most windows", Set::Report, |row| row.holds),
    ];
    table(&["`agrees`", "within 4/3 of the truth", "share"], &lines)
}

impl JudgedRow {
    /// True if the curve is within 4/3 of the truth.
    pub(crate) fn is_curve_right(&self) -> bool {
        (0.75..=4.0 / 3.0).contains(&self.curve_over_truth)
    }

    /// True if judge and truth differ by at most two of their standard errors. The errors of the judge and of the truth are
    /// independent.
    fn is_within_two_errors(&self) -> bool {
        (self.judge - 1.0).abs() <= 2.0 * (self.stated_error * self.judge).hypot(self.truth_error)
    }
}
