//! Coverage of the truth by intervals, and their width.

use uncertainty::Settings;

use crate::error::StudyError;
use crate::synthetic::Laboratory;
use crate::trial::{IntervalOutcome, Trial};

/// Coverage over many studies for one curve and load.
#[derive(Debug, Clone, PartialEq)]
pub struct Coverage {
    /// Name of the curve.
    pub curve: String,
    /// Name of the load.
    pub load: String,
    /// Number of studies with an area there.
    pub studies: usize,
    /// Number of intervals that hold the truth.
    pub held: usize,
    /// Median of ln(high/low).
    pub width: f64,
    /// Root mean square of ln(median/truth).
    pub deviation: f64,
    /// Mean of ln(median/truth).
    pub bias: f64,
}

impl Coverage {
    /// Share of intervals that hold the truth.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.held as f64 / self.studies as f64
    }

    /// Width of an interval over that of 95 % of a normal distribution as wide as the deviations.
    #[must_use]
    pub fn relative_width(&self) -> f64 {
        self.width / (3.92 * self.deviation)
    }
}

/// Runs the studies 0, 1, ... with `scans` by each instrument.
///
/// # Errors
/// The error of the first study that fails.
pub fn trials(
    laboratory: &Laboratory,
    studies: u32,
    scans: &[u32],
    settings: &Settings,
) -> Result<Vec<Trial>, StudyError> {
    let trial = |number: usize| laboratory.trial(number as u64, scans, settings);
    numerics::parallel::map_indices(studies as usize, trial).into_iter().collect()
}

/// Coverage of every curve and load.
#[must_use]
pub fn coverages(trials: &[Trial]) -> Vec<Coverage> {
    let Some(first) = trials.first() else { return Vec::new() };
    let (curves, loads) = (first.curves.iter().enumerate(), first.loads.len());
    let places = curves.flat_map(|(curve, name)| (0..loads).map(move |load| (curve, name, load)));
    let of_place = |(curve, name, load): (usize, &String, usize)| {
        let here = |held: &&IntervalOutcome| held.curve == curve && held.load == load;
        let found: Vec<IntervalOutcome> =
            trials.iter().flat_map(|trial| trial.intervals.iter().filter(here)).copied().collect();
        let count = found.len() as f64;
        let mean = |of: fn(&IntervalOutcome) -> f64| found.iter().map(of).sum::<f64>() / count;
        (!found.is_empty()).then(|| Coverage {
            curve: name.clone(),
            load: first.loads[load].clone(),
            studies: found.len(),
            held: found.iter().filter(|held| held.holds()).count(),
            width: median(found.iter().map(IntervalOutcome::width).collect()),
            deviation: mean(|held| held.deviation().powi(2)).sqrt(),
            bias: mean(IntervalOutcome::deviation),
        })
    };
    places.filter_map(of_place).collect()
}

/// Median of at least one value.
pub(crate) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    0.5 * (values[(values.len() - 1) / 2] + values[values.len() / 2])
}
