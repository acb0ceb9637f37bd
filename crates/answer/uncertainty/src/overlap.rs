//! Overlaps of instruments.

use study::student::{half_width, normal_half_width};
use topography::CompositeBin;

use crate::gains::{Observation, Prior};
use crate::instrument_bins::{InstrumentBin, InstrumentBins, standard_error_root};
use crate::results::OverlapMisfit;

/// The probability by which Student's distribution is matched by a normal one.
const MATCHED: f64 = 0.95;

/// The overlaps of instruments.
pub(crate) struct Overlaps {
    /// The observations for the gains.
    pub observations: Vec<Observation>,
    /// The misfits for the report.
    pub misfits: Vec<OverlapMisfit>,
}

/// The overlaps of every pair that shares a bin.
pub(crate) fn overlaps(instruments: &[InstrumentBins], priors: &[Prior], bins: &[CompositeBin]) -> Overlaps {
    let mut found = Overlaps { observations: Vec::new(), misfits: Vec::new() };
    for second in 0..instruments.len() {
        for first in 0..second {
            let shared: Vec<(usize, [&InstrumentBin; 2])> = (0..bins.len())
                .filter_map(|at| {
                    Some((
                        at,
                        [instruments[first].bins[at].as_ref()?, instruments[second].bins[at].as_ref()?],
                    ))
                })
                .collect();
            if shared.is_empty() {
                continue;
            }
            let mean = |of: &dyn Fn(&[&InstrumentBin; 2]) -> f64| {
                shared.iter().map(|(_, pair)| of(pair)).sum::<f64>() / shared.len() as f64
            };
            let side = |side: usize| shared.iter().map(|(_, pair)| pair[side]).collect::<Vec<_>>();
            let variance = variance_of_mean(&instruments[first], &side(0))
                + variance_of_mean(&instruments[second], &side(1));
            let observation = Observation {
                instruments: [first, second],
                ln_q: [mean(&|pair| pair[0].ln_q), mean(&|pair| pair[1].ln_q)],
                difference: mean(&|pair| pair[0].ln_mean - pair[1].ln_mean),
                variance,
            };
            let of_gain = |side: usize| {
                let prior = priors[observation.instruments[side]];
                prior.gain_sd.powi(2) + (prior.slope_sd * observation.ln_q[side]).powi(2)
            };
            found.misfits.push(OverlapMisfit {
                instruments: [first, second],
                misfit: observation.difference,
                scatter: variance.sqrt(),
                expected: (variance + of_gain(0) + of_gain(1)).sqrt(),
                bins: shared.len(),
                longest_m: bins[shared[0].0].wavelength_m,
                shortest_m: bins[shared[shared.len() - 1].0].wavelength_m,
            });
            found.observations.push(observation);
        }
    }
    found
}

/// The variance of the mean of ln C over some bins of an instrument. It is taken from the scatter of the means of
/// places, so that correlations along the wavevector count, and widened by Student's distribution.
fn variance_of_mean(instrument: &InstrumentBins, bins: &[&InstrumentBin]) -> f64 {
    let count = bins.len() as f64;
    let mut means = vec![0.0; instrument.units];
    let mut places = vec![false; instrument.units];
    for bin in bins {
        for (unit, deviation) in &bin.deviations {
            means[*unit] += deviation / count;
            places[*unit] = true;
        }
    }
    let values = places.iter().filter(|is_there| **is_there).count();
    let of_place = if values < 2 || instrument.is_one_place { instrument.place_sd.powi(2) } else { 0.0 };
    let beside: f64 = bins.iter().map(|bin| bin.beside.variance()).sum::<f64>() / (count * count) + of_place;
    if values < 2 {
        return beside;
    }
    let squares: f64 = means.iter().map(|mean| mean * mean).sum();
    let widened = half_width(MATCHED, values) / normal_half_width(MATCHED);
    beside + squares * (widened / standard_error_root(values)).powi(2)
}
