//! Outcome of one study: intervals of its areas, and the true areas.

use scene::Scene;
use study::Unobserved;
use study::plan::{Plan, PlanError, Results};
use uncertainty::{Advice, AreaInterval, Settings, UncertaintyPlan};

use crate::error::StudyError;
use crate::synthetic::Laboratory;
use crate::truth::known_composite;

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
pub struct Trial {
    /// Names of the curves.
    pub curves: Vec<String>,
    /// Names of the loads.
    pub loads: Vec<String>,
    /// All intervals.
    pub intervals: Vec<IntervalOutcome>,
    /// Advice on the next measurement, if requested.
    pub advice: Vec<Advice>,
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
    /// Runs the study of a number with `scans` by each instrument, for its intervals alone.
    ///
    /// # Errors
    /// [`StudyError`] if any part fails, and [`StudyError::Certain`] if the scene has no uncertain input.
    pub fn trial(&self, number: u64, scans: &[u32], settings: &Settings) -> Result<Trial, StudyError> {
        self.carried_out(number, scans, settings, |plan| Ok((plan.intervals(&Unobserved)?, Vec::new())))
    }

    /// Runs a study as [`trial`](Self::trial) does, with advice on the next measurement.
    ///
    /// # Errors
    /// The errors of [`trial`](Self::trial).
    pub fn advised_trial(
        &self,
        number: u64,
        scans: &[u32],
        settings: &Settings,
    ) -> Result<Trial, StudyError> {
        self.carried_out(number, scans, settings, |plan| {
            let found = plan.run(&Unobserved)?;
            Ok((found.areas, found.advice))
        })
    }

    fn carried_out(
        &self,
        number: u64,
        scans: &[u32],
        settings: &Settings,
        carry_out: impl Fn(&UncertaintyPlan<'_>) -> Result<(Vec<AreaInterval>, Vec<Advice>), PlanError>,
    ) -> Result<Trial, StudyError> {
        let scene = self.study(number, scans)?.scene()?;
        let results = scene.plan().compute()?;
        let settings = Settings { seed: number, ..*settings };
        let plan = UncertaintyPlan::new(&scene, &results, &settings).ok_or(StudyError::Certain)?;
        let (areas, advice) = carry_out(&plan)?;
        let known = self.known(&scene)?;
        let intervals = areas.iter().filter_map(|area| {
            let (_, truth) = *known.curves[area.curve].area_fractions(area.load).last()?;
            let ends = [area.low, area.high];
            Some(IntervalOutcome { curve: area.curve, load: area.load, truth, median: area.median, ends })
        });
        Ok(Trial {
            curves: scene.needs.curves.iter().map(|curve| curve.name.clone()).collect(),
            loads: scene.needs.loads.iter().map(|load| load.label.clone()).collect(),
            intervals: intervals.collect(),
            advice,
        })
    }

    /// Results of the same scene with the known spectrum.
    fn known(&self, scene: &Scene) -> Result<Results, StudyError> {
        let scans = scene.surface.made_from.as_ref().ok_or(StudyError::Certain)?;
        let psd = known_composite(&self.surface, &scans.spectrum)?;
        let plan = Plan { psd: &psd, sampling: scene.sampling, needs: scene.needs.clone() };
        Ok(plan.compute()?)
    }
}
