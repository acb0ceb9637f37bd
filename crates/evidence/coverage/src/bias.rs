//! Bias of averages of scans against the known spectrum, over many studies.

use topography::{Average, CompositeSpectrum, Recipe};

use crate::error::StudyError;
use crate::instrument::{INSTRUMENTS, Instrument};
use crate::synthetic::Laboratory;
use crate::truth::known_composite;

/// Mean deviation of a composite in a decade.
#[derive(Debug, Clone, PartialEq)]
pub struct DecadeBias {
    /// Instrument of the scans.
    pub instrument: Instrument,
    /// Method of averaging.
    pub average: Average,
    /// Exponent of the longest wavelength of the decade: 10^n m.
    pub decade: i32,
    /// Number of bins of a composite in the decade.
    pub bins: usize,
    /// Mean of ln(C/C_known) over the bins and all studies.
    pub of_known: f64,
    /// Mean of ln(C/C_expected), where C_expected is the expectation of a scan's spectrum: the known one seen through
    /// window and detrending.
    pub of_expected: f64,
    /// Standard error of `of_expected`.
    pub standard_error: f64,
}

/// ln(C/C_known) of every study and bin.
type Deviations = Vec<Vec<f64>>;

/// Computes the bias of each average, decade by decade, of the composites of one instrument, given by its index in
/// [`INSTRUMENTS`].
///
/// # Errors
/// The errors of the studies.
pub fn biases(
    laboratory: &Laboratory,
    studies: u32,
    instrument: usize,
    scans: u32,
    averages: &[Average],
) -> Result<Vec<DecadeBias>, StudyError> {
    let mut of_each = [0; 2];
    of_each[instrument] = scans;
    let one_study = |number| one_study(laboratory, number as u64, of_each, averages);
    let of_studies: Result<Vec<_>, _> =
        numerics::parallel::map_indices(studies as usize, one_study).into_iter().collect();
    let of_studies = of_studies?;
    let Some((wavelengths_m, _)) = of_studies.first() else { return Ok(Vec::new()) };
    let of_average = |average: usize| -> Deviations {
        of_studies.iter().map(|(_, deviations)| deviations[average].clone()).collect()
    };
    let expected = ln_expectation(&of_average(0));
    let rows = averages.iter().enumerate().map(|(place, &average)| {
        by_decade(wavelengths_m, &of_average(place + 1), &expected, INSTRUMENTS[instrument], average)
    });
    Ok(rows.flatten().collect())
}

/// Wavelengths \[m\] of the bins, and their deviations: first of arithmetic means, then of each average.
fn one_study(
    laboratory: &Laboratory,
    number: u64,
    scans: [u32; 2],
    averages: &[Average],
) -> Result<(Vec<f64>, Vec<Vec<f64>>), StudyError> {
    let measured = laboratory.study(number, &scans)?.composite()?;
    let known = known_composite(&laboratory.surface, &measured)?;
    let deviations = |&average: &Average| {
        let recipe = Recipe { average, ..measured.recipe };
        let composite = CompositeSpectrum::new(measured.scans.clone(), &recipe)?.composite;
        let bins = composite.bins().iter().zip(known.c1d_m3());
        Ok(bins.map(|(bin, known_m3)| (bin.c1d_m3 / known_m3).ln()).collect())
    };
    let all = std::iter::once(&Average::Arithmetic).chain(averages);
    let deviations = all.map(deviations).collect::<Result<Vec<_>, StudyError>>()?;
    Ok((known.wavelengths_m().to_vec(), deviations))
}

/// Logarithm of the mean of C/C_known in every bin.
fn ln_expectation(deviations: &Deviations) -> Vec<f64> {
    let bins = deviations.first().map_or(0, Vec::len);
    let of_bin = |bin: usize| {
        deviations.iter().map(|of_study| of_study[bin].exp()).sum::<f64>() / deviations.len() as f64
    };
    (0..bins).map(|bin| of_bin(bin).ln()).collect()
}

fn by_decade(
    wavelengths_m: &[f64],
    deviations: &Deviations,
    expected: &[f64],
    instrument: Instrument,
    average: Average,
) -> Vec<DecadeBias> {
    // A bin at the very end of a decade belongs to it.
    let decades: Vec<i32> = wavelengths_m.iter().map(|m| m.log10().ceil() as i32).collect();
    let mut rows = Vec::new();
    let mut first = 0;
    for decade in decades.chunk_by(|a, b| a == b) {
        let bins = first..first + decade.len();
        first = bins.end;
        let mean_in = |values: &[f64]| values[bins.clone()].iter().sum::<f64>() / bins.len() as f64;
        let of_studies: Vec<f64> = deviations.iter().map(|values| mean_in(values)).collect();
        let count = of_studies.len() as f64;
        let of_known = of_studies.iter().sum::<f64>() / count;
        let variance =
            of_studies.iter().map(|value| (value - of_known).powi(2)).sum::<f64>() / (count - 1.0).max(1.0);
        rows.push(DecadeBias {
            instrument,
            average,
            decade: decade[0],
            bins: bins.len(),
            of_known,
            of_expected: of_known - mean_in(expected),
            standard_error: (variance / count).sqrt(),
        });
    }
    rows
}
