//! Outcome of one study: intervals of its areas, and the true areas.

use scene::Scene;
use study::Unobserved;
use study::plan::{Plan, Results};
use uncertainty::{UncertaintyPlan, UncertaintySettings};

use super::synthetic::Laboratory;
use super::truth::known_composite;
use crate::TrialError;

/// Interval and the true value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IntervalOutcome {
    /// Index of the curve.
    pub curve: usize,
    /// Index of the load.
    pub load: usize,
    /// Area fraction of the known spectrum in the same bins.
    pub truth: f64,
    /// Median of the draws.
    pub median: f64,
    /// Lower and upper end.
    pub ends: [f64; 2],
}

/// Outcome of a study.
#[derive(Debug, Clone)]
pub struct StudyOutcome {
    /// Names of the curves.
    pub curves: Vec<String>,
    /// Names of the loads.
    pub loads: Vec<String>,
    /// All intervals.
    pub intervals: Vec<IntervalOutcome>,
}

/// Relative difference below which areas are equal.
const ROUNDING: f64 = 1e-9;

impl IntervalOutcome {
    /// True if the interval holds the truth.
    #[must_use]
    pub fn holds(&self) -> bool {
        let [low, high] = self.ends;
        low * (1.0 - ROUNDING) <= self.truth && self.truth <= high * (1.0 + ROUNDING)
    }

    /// Width ln(high/low).
    #[must_use]
    pub fn width(&self) -> f64 {
        (self.ends[1] / self.ends[0]).ln()
    }

    /// Deviation ln(median/truth).
    #[must_use]
    pub fn deviation(&self) -> f64 {
        (self.median / self.truth).ln()
    }
}

impl Laboratory {
    /// Runs the study of a number with `scans` by each instrument.
    ///
    /// # Errors
    /// [`TrialError`] if any part fails, and [`TrialError::Certain`] if the scene has no uncertain input.
    pub fn trial(
        &self,
        number: u64,
        scans: &[u32],
        settings: &UncertaintySettings,
    ) -> Result<StudyOutcome, TrialError> {
        let scene = self.study(number, scans)?.scene()?;
        let results = scene.plan().compute()?;
        let settings = UncertaintySettings { seed: number, ..*settings };
        let plan = UncertaintyPlan::new(&scene, &results, &settings).ok_or(TrialError::Certain)?;
        let areas = plan.intervals(&Unobserved)?;
        let known = self.known(&scene)?;
        let intervals = areas.iter().filter_map(|area| {
            let (_, truth) = *known.curves[area.curve].area_fractions(area.load).last()?;
            let ends = [area.low, area.high];
            Some(IntervalOutcome { curve: area.curve, load: area.load, truth, median: area.median, ends })
        });
        Ok(StudyOutcome {
            curves: scene.needs.curves.iter().map(|curve| curve.name.clone()).collect(),
            loads: scene.needs.loads.iter().map(|load| load.label.clone()).collect(),
            intervals: intervals.collect(),
        })
    }

    /// Results of the same scene with the known spectrum.
    fn known(&self, scene: &Scene) -> Result<Results, TrialError> {
        let scans = scene.surface.made_from.as_ref().ok_or(TrialError::Certain)?;
        let psd = known_composite(&self.surface, &scans.spectrum)?;
        let plan = Plan { psd: &psd, sampling: scene.sampling, needs: scene.needs.clone() };
        Ok(plan.compute()?)
    }
}
