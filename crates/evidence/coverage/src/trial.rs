//! One study carried out: what is said of its areas, and what they are.

use scene::Scene;
use study::Unobserved;
use study::plan::{Plan, PlanError, Results};
use uncertainty::{Advice, AreaInterval, Settings, UncertaintyPlan};

use crate::error::StudyError;
use crate::synthetic::Laboratory;
use crate::truth::known_composite;

/// An interval and what it should hold.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Held {
    /// The curve, by index.
    pub curve: usize,
    /// The load, by index.
    pub load: usize,
    /// The area fraction of the known spectrum in the same bins.
    pub truth: f64,
    /// The median of the draws.
    pub median: f64,
    /// Both ends.
    pub ends: [f64; 2],
}

/// A study carried out.
#[derive(Debug, Clone)]
pub struct Trial {
    /// The names of its curves.
    pub curves: Vec<String>,
    /// The names of its loads.
    pub loads: Vec<String>,
    /// Every interval.
    pub held: Vec<Held>,
    /// What to measure next, where that was asked for.
    pub advice: Vec<Advice>,
}

/// Areas that differ by less are the same.
const ROUNDING: f64 = 1e-9;

impl Held {
    /// Whether the interval holds the truth.
    #[must_use]
    pub fn holds(&self) -> bool {
        let [low, high] = self.ends;
        low * (1.0 - ROUNDING) <= self.truth && self.truth <= high * (1.0 + ROUNDING)
    }

    /// ln(high/low).
    #[must_use]
    pub fn width(&self) -> f64 {
        (self.ends[1] / self.ends[0]).ln()
    }

    /// ln(median/truth).
    #[must_use]
    pub fn deviation(&self) -> f64 {
        (self.median / self.truth).ln()
    }
}

impl Laboratory {
    /// Carries out the study of a number with so many scans by each instrument, for its intervals alone.
    ///
    /// # Errors
    /// [`StudyError`] where anything of it fails, and [`StudyError::Certain`] where nothing of it is said to scatter.
    pub fn trial(&self, number: u64, scans: [u32; 2], settings: &Settings) -> Result<Trial, StudyError> {
        self.carried_out(number, scans, settings, |plan| Ok((plan.intervals(&Unobserved)?, Vec::new())))
    }

    /// The same with what to measure next.
    ///
    /// # Errors
    /// Those of [`trial`](Self::trial).
    pub fn advised_trial(
        &self,
        number: u64,
        scans: [u32; 2],
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
        scans: [u32; 2],
        settings: &Settings,
        carry_out: impl Fn(&UncertaintyPlan<'_>) -> Result<(Vec<AreaInterval>, Vec<Advice>), PlanError>,
    ) -> Result<Trial, StudyError> {
        let scene = self.study(number, scans)?.scene()?;
        let results = scene.plan().compute()?;
        let settings = Settings { seed: number, ..*settings };
        let plan = UncertaintyPlan::new(&scene, &results, &settings).ok_or(StudyError::Certain)?;
        let (areas, advice) = carry_out(&plan)?;
        let known = self.known(&scene)?;
        let held = areas.iter().filter_map(|area| {
            let (_, truth) = *known.curves[area.curve].area_fractions(area.load).last()?;
            let ends = [area.low, area.high];
            Some(Held { curve: area.curve, load: area.load, truth, median: area.median, ends })
        });
        Ok(Trial {
            curves: scene.needs.curves.iter().map(|curve| curve.name.clone()).collect(),
            loads: scene.needs.loads.iter().map(|load| load.label.clone()).collect(),
            held: held.collect(),
            advice,
        })
    }

    /// The same scene about the known spectrum.
    fn known(&self, scene: &Scene) -> Result<Results, StudyError> {
        let scans = scene.surface.made_from.as_ref().ok_or(StudyError::Certain)?;
        let psd = known_composite(&self.surface, &scans.spectrum)?;
        let plan = Plan { psd: &psd, sampling: scene.sampling, needs: scene.needs.clone() };
        Ok(plan.compute()?)
    }
}
