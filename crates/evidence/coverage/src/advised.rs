//! Shrinkage of intervals when scans are added, predicted and found.

use uncertainty::{Settings, StepKind};

use crate::coverage::median;
use crate::error::StudyError;
use crate::instrument::INSTRUMENTS;
use crate::synthetic::Laboratory;
use crate::trial::{IntervalOutcome, Trial};

/// Shrinkage of the intervals of one curve and load when scans of one instrument are added.
#[derive(Debug, Clone, PartialEq)]
pub struct Shrinkage {
    /// Name of the curve.
    pub curve: String,
    /// Name of the load.
    pub load: String,
    /// Name of the instrument.
    pub instrument: &'static str,
    /// Number of scans added.
    pub added: u32,
    /// Median of the predicted ratio of widths, after over before.
    pub predicted: f64,
    /// Median of the ratio of widths found.
    pub real: f64,
    /// Median of found over predicted, study by study.
    pub ratio: f64,
}

/// Runs studies with `scans` by each instrument, adds scans of one of them, and runs them again.
///
/// # Errors
/// The error of the first study that fails.
pub fn shrinkages(
    laboratory: &Laboratory,
    studies: u32,
    scans: u32,
    added: &[u32],
    settings: &Settings,
) -> Result<Vec<Shrinkage>, StudyError> {
    let both = [scans; 2];
    let of_study = |number: usize| {
        let before = laboratory.advised_trial(number as u64, &both, settings)?;
        let mut ratios = Vec::new();
        for instrument in 0..INSTRUMENTS.len() {
            for &added in added {
                let mut more = both;
                more[instrument] += added;
                let after = laboratory.trial(number as u64, &more, settings)?;
                ratios.push(ratios_of(&before, &after, instrument, added as usize));
            }
        }
        Ok((before, ratios))
    };
    let found = numerics::parallel::map_indices(studies as usize, of_study);
    let found: Vec<(Trial, Vec<Ratios>)> = found.into_iter().collect::<Result<_, StudyError>>()?;
    let Some((first, _)) = found.first() else { return Ok(Vec::new()) };
    let steps =
        (0..INSTRUMENTS.len()).flat_map(|instrument| added.iter().map(move |&added| (instrument, added)));
    let mut rows = Vec::new();
    for (step, (instrument, added)) in steps.enumerate() {
        for (place, held) in first.intervals.iter().enumerate() {
            let here = found.iter().filter_map(|(_, steps)| steps[step].get(place).copied().flatten());
            let (predicted, real): (Vec<f64>, Vec<f64>) = here.unzip();
            if predicted.is_empty() {
                continue;
            }
            rows.push(Shrinkage {
                curve: first.curves[held.curve].clone(),
                load: first.loads[held.load].clone(),
                instrument: INSTRUMENTS[instrument].name,
                added,
                ratio: median(
                    real.iter().zip(&predicted).map(|(real, predicted)| real / predicted).collect(),
                ),
                predicted: median(predicted),
                real: median(real),
            });
        }
    }
    Ok(rows)
}

/// Predicted and found ratios, for every interval that has both.
type Ratios = Vec<Option<(f64, f64)>>;

fn ratios_of(before: &Trial, after: &Trial, instrument: usize, added: usize) -> Ratios {
    let of_interval = |(held, after): (&IntervalOutcome, &IntervalOutcome)| {
        let advice =
            before.advice.iter().find(|advice| (advice.curve, advice.load) == (held.curve, held.load))?;
        let kind = StepKind::MoreScans { instrument, added };
        let step = advice.steps.iter().find(|step| step.kind == kind)?;
        Some((step.width_ratio, after.width() / held.width()))
    };
    before.intervals.iter().zip(&after.intervals).map(of_interval).collect()
}
