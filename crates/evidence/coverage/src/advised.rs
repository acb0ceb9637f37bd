//! Whether intervals shrink as they are said to when scans are added.

use uncertainty::{Settings, StepKind};

use crate::coverage::median;
use crate::error::StudyError;
use crate::instrument::INSTRUMENTS;
use crate::synthetic::Laboratory;
use crate::trial::{Held, Trial};

/// How the intervals of one curve and load shrink when scans of one instrument are added.
#[derive(Debug, Clone, PartialEq)]
pub struct Shrinkage {
    /// The name of the curve.
    pub curve: String,
    /// The name of the load.
    pub load: String,
    /// The instrument.
    pub instrument: &'static str,
    /// How many scans are added.
    pub added: u32,
    /// Median of the width after over that before, as predicted.
    pub predicted: f64,
    /// The same as found.
    pub real: f64,
    /// Median of real over predicted, study by study.
    pub ratio: f64,
}

/// Carries out studies with so many scans by each instrument, adds so many of one of them, and carries them out again.
///
/// # Errors
/// That of the first study that fails.
pub fn shrinkages(
    laboratory: &Laboratory,
    studies: u32,
    scans: u32,
    added: &[u32],
    settings: &Settings,
) -> Result<Vec<Shrinkage>, StudyError> {
    let both = [scans; 2];
    let of_study = |number: usize| {
        let before = laboratory.advised_trial(number as u64, both, settings)?;
        let mut ratios = Vec::new();
        for instrument in 0..INSTRUMENTS.len() {
            for &added in added {
                let mut more = both;
                more[instrument] += added;
                let after = laboratory.trial(number as u64, more, settings)?;
                ratios.push(ratios_of(&before, &after, instrument, added as usize));
            }
        }
        Ok((before, ratios))
    };
    let found = parallel::map_indices(studies as usize, of_study);
    let found: Vec<(Trial, Vec<Ratios>)> = found.into_iter().collect::<Result<_, StudyError>>()?;
    let Some((first, _)) = found.first() else { return Ok(Vec::new()) };
    let steps =
        (0..INSTRUMENTS.len()).flat_map(|instrument| added.iter().map(move |&added| (instrument, added)));
    let mut rows = Vec::new();
    for (step, (instrument, added)) in steps.enumerate() {
        for (place, held) in first.held.iter().enumerate() {
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

/// Predicted and real, for every interval that has both.
type Ratios = Vec<Option<(f64, f64)>>;

fn ratios_of(before: &Trial, after: &Trial, instrument: usize, added: usize) -> Ratios {
    let of_interval = |(held, after): (&Held, &Held)| {
        let advice =
            before.advice.iter().find(|advice| (advice.curve, advice.load) == (held.curve, held.load))?;
        let kind = StepKind::MoreScans { instrument, added };
        let step = advice.steps.iter().find(|step| step.kind == kind)?;
        Some((step.width_ratio, after.width() / held.width()))
    };
    before.held.iter().zip(&after.held).map(of_interval).collect()
}
