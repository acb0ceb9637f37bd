//! Cells of the study of coverage: spectra drawn at random, and the scans by which each surface is measured.

use numerics::parallel::map_indices;
use statrs::distribution::{Beta, ContinuousCDF};
use uncertainty::UncertaintySettings;

use super::instrument::{AFM, AFM_LINES, Instrument, STYLUS};
use super::outcome::{IntervalOutcome, StudyOutcome};
use super::random::Normals;
use super::surface::{Form, KnownSurface};
use super::synthetic::{Laboratory, SyntheticStudy};
use crate::TrialError;

/// Scans of a cell and the form of its spectra.
#[derive(Debug, Clone, Copy)]
pub struct Cell {
    /// Form of the spectra.
    pub form: Form,
    /// Instruments.
    pub instruments: &'static [Instrument],
    /// Scans by each instrument.
    pub scans: u32,
}

/// Design of the study: each number of scans meets each form and each choice of instruments, but not every pair of
/// these. Nine of the 24 combinations.
pub const CELLS: [Cell; 9] = [
    Cell { form: Form::RolloffInside, instruments: &[STYLUS, AFM_LINES], scans: 3 },
    Cell { form: Form::RolloffOutside, instruments: &[STYLUS], scans: 3 },
    Cell { form: Form::Hump, instruments: &[STYLUS, AFM], scans: 3 },
    Cell { form: Form::RolloffInside, instruments: &[STYLUS], scans: 5 },
    Cell { form: Form::RolloffOutside, instruments: &[STYLUS, AFM], scans: 5 },
    Cell { form: Form::Hump, instruments: &[STYLUS, AFM_LINES], scans: 5 },
    Cell { form: Form::Hump, instruments: &[STYLUS], scans: 3 },
    Cell { form: Form::RolloffOutside, instruments: &[STYLUS, AFM_LINES], scans: 3 },
    Cell { form: Form::RolloffInside, instruments: &[AFM], scans: 3 },
];

impl Cell {
    /// Describes the scans.
    #[must_use]
    pub fn scans_in_words(&self) -> String {
        let shapes: Vec<String> =
            self.instruments.iter().map(|of| format!("{} {}s", self.scans, of.shape.name())).collect();
        shapes.join(", ")
    }

    /// Runs one study. Surface, scans and draws follow from both numbers.
    ///
    /// # Errors
    /// The error of the study.
    pub fn trial(
        &self,
        number: u64,
        seed: u64,
        settings: &UncertaintySettings,
    ) -> Result<StudyOutcome, TrialError> {
        self.laboratory(number, seed)?.trial(number, &self.scans_of_each(), settings)
    }

    /// Returns the files of one study.
    ///
    /// # Errors
    /// The error of the study.
    pub fn study(&self, number: u64, seed: u64) -> Result<SyntheticStudy, TrialError> {
        self.laboratory(number, seed)?.study(number, &self.scans_of_each())
    }

    fn laboratory(&self, number: u64, seed: u64) -> Result<Laboratory, TrialError> {
        let mut normals = Normals::new(seed ^ 0x5eed, number);
        let surface = KnownSurface::at_random(self.form, &mut normals, 2.0 * AFM.spacing_m())?;
        Laboratory::of_surface(surface, self.instruments, seed)
    }

    fn scans_of_each(&self) -> Vec<u32> {
        vec![self.scans; self.instruments.len()]
    }

    /// Runs the studies from `first` on.
    ///
    /// # Errors
    /// The error of the first study that fails.
    pub fn trials(
        &self,
        first: u32,
        studies: u32,
        seed: u64,
        settings: &UncertaintySettings,
    ) -> Result<Vec<StudyOutcome>, TrialError> {
        let trial = |study: usize| self.trial(u64::from(first) + study as u64, seed, settings);
        map_indices(studies as usize, trial).into_iter().collect()
    }
}

/// Misses of one curve under one load.
#[derive(Debug, Clone, PartialEq)]
pub struct Tails {
    /// Name of the curve.
    pub curve: String,
    /// Name of the load.
    pub load: String,
    /// Number of studies with an interval.
    pub studies: usize,
    /// Number of studies with the truth above the interval.
    pub above: usize,
    /// Number of studies with the truth below the interval.
    pub below: usize,
    /// Mean width over 3.92 root mean squares of ln(median/truth), both without the widest twentieth.
    pub width_over_need: f64,
    /// Median of ln(high/low).
    pub width: f64,
}

/// Range of coverage that the intervals promise at 95 %.
pub const COVERAGE: [f64; 2] = [0.92, 0.98];

/// Range of each tail.
pub const TAIL: [f64; 2] = [0.01, 0.04];

/// Confidence of a verdict.
const CONFIDENCE: f64 = 0.99;

impl Tails {
    /// Number of intervals that hold the truth.
    #[must_use]
    pub fn held(&self) -> usize {
        self.studies - self.above - self.below
    }

    /// True if no 99 % interval of the three shares excludes its whole range.
    #[must_use]
    pub fn passes(&self) -> bool {
        is_compatible(self.held(), self.studies, COVERAGE)
            && is_compatible(self.above, self.studies, TAIL)
            && is_compatible(self.below, self.studies, TAIL)
    }
}

/// True if the interval of Clopper and Pearson for a share (1934, Biometrika 26:404) meets a range.
#[must_use]
pub fn is_compatible(hits: usize, of: usize, range: [f64; 2]) -> bool {
    let [low, high] = clopper_pearson(hits, of);
    low <= range[1] && range[0] <= high
}

fn clopper_pearson(hits: usize, of: usize) -> [f64; 2] {
    let tail = 0.5 * (1.0 - CONFIDENCE);
    let (hits, misses) = (hits as f64, (of - hits) as f64);
    let quantile = |a: f64, b: f64, share: f64| Beta::new(a, b).map(|beta| beta.inverse_cdf(share));
    let low = if hits > 0.0 { quantile(hits, misses + 1.0, tail).unwrap_or(0.0) } else { 0.0 };
    let high = if misses > 0.0 { quantile(hits + 1.0, misses, 1.0 - tail).unwrap_or(1.0) } else { 1.0 };
    [low, high]
}

/// Counts the misses of every curve and load.
#[must_use]
pub fn tails(trials: &[StudyOutcome]) -> Vec<Tails> {
    let Some(first) = trials.first() else { return Vec::new() };
    let mut rows = Vec::new();
    for (curve, name) in first.curves.iter().enumerate() {
        for (load, label) in first.loads.iter().enumerate() {
            let here = |found: &&IntervalOutcome| (found.curve, found.load) == (curve, load);
            let found: Vec<IntervalOutcome> =
                trials.iter().flat_map(|trial| trial.intervals.iter().filter(here)).copied().collect();
            if found.is_empty() {
                continue;
            }
            let is_above = |found: &&IntervalOutcome| !found.holds() && found.truth > found.ends[1];
            let is_below = |found: &&IntervalOutcome| !found.holds() && found.truth < found.ends[0];
            let widths = sorted(found.iter().map(IntervalOutcome::width));
            let squares = sorted(found.iter().map(|found| found.deviation().powi(2)));
            let kept = (found.len() * 19).div_ceil(20);
            let mean = |of: &[f64]| of[..kept].iter().sum::<f64>() / kept as f64;
            rows.push(Tails {
                curve: name.clone(),
                load: label.clone(),
                studies: found.len(),
                above: found.iter().filter(is_above).count(),
                below: found.iter().filter(is_below).count(),
                width_over_need: mean(&widths) / (3.92 * mean(&squares).sqrt()),
                width: widths[widths.len() / 2],
            });
        }
    }
    rows
}

fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values
}

#[cfg(test)]
mod tests {
    use super::clopper_pearson;

    #[test]
    fn bounds_of_a_share_are_those_of_clopper_and_pearson() {
        // No hits: 1 - 0.005^(1/n).
        let [low, high] = clopper_pearson(0, 20);
        assert!(low == 0.0 && (high - (1.0 - 0.005f64.powf(0.05))).abs() < 1e-9, "{high}");
        let [low, high] = clopper_pearson(20, 20);
        assert!(high == 1.0 && (low - 0.005f64.powf(0.05)).abs() < 1e-9, "{low}");
    }
}
