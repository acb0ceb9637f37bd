//! The influence of each part of the spectrum on ln A, and hence the contribution of every instrument and decade.

use spectrum::ProfilePsd;
use study::Progress;
use study::plan::Work;

use crate::areas::Areas;

/// The number of parts per decade.
const PARTS_PER_DECADE: f64 = 10.0;

/// The change of ln C of a part.
const STEP: f64 = 0.02;

/// d ln A/d ln C of every area, in neighbouring parts of the spectrum.
#[derive(Debug)]
pub(crate) struct Influence {
    /// The part of each sample.
    part_of: Vec<usize>,
    /// The number of samples of each part.
    samples: Vec<usize>,
    /// For every part, the derivative of every area.
    of_parts: Vec<Vec<f64>>,
    /// The work that it took.
    pub work: Work,
    /// The number of plans that it took.
    pub plans: usize,
}

impl Influence {
    /// Computes the influence on the areas of this spectrum; `None` if cancelled. `progress` advances once per part.
    pub fn new(areas: &Areas, psd: &ProfilePsd, progress: &dyn Progress) -> Option<Self> {
        let part_of = parts(psd);
        let count = part_of.last().map_or(0, |last| last + 1);
        let mut samples = vec![0; count];
        part_of.iter().for_each(|part| samples[*part] += 1);
        let centre = areas.at_the_end(Some(psd), areas.distinct_curves().to_vec());
        let moved = |part: &usize| {
            if progress.is_cancelled() {
                return None;
            }
            let factor = |of: &usize| if of == part { STEP.exp() } else { 1.0 };
            let values = psd.c1d_m3().iter().zip(&part_of).map(|(c1d_m3, of)| c1d_m3 * factor(of)).collect();
            let psd = psd.with_values(values).ok()?;
            let found = areas.at_the_end(Some(&psd), areas.distinct_curves().to_vec());
            progress.advance(1);
            Some(found)
        };
        let parts: Vec<usize> = (0..count).collect();
        let found: Option<Vec<_>> = numerics::parallel::map(&parts, moved).into_iter().collect();
        let mut work = centre.work;
        let mut of_parts = Vec::new();
        for part in found? {
            work += part.work;
            let derivative = |(moved, centre): (&Option<f64>, &Option<f64>)| match (moved, centre) {
                (Some(moved), Some(centre)) => (moved - centre) / STEP,
                _ => 0.0,
            };
            of_parts.push(part.ln_areas.iter().zip(&centre.ln_areas).map(derivative).collect());
        }
        Some(Influence { part_of, samples, of_parts, work, plans: count + 1 })
    }

    /// The number of parts of a spectrum.
    pub fn parts_of(psd: &ProfilePsd) -> usize {
        parts(psd).last().map_or(0, |last| last + 1)
    }

    /// Averages deviations of ln C, sample by sample, over each part.
    pub fn in_parts(&self, deviations: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; self.samples.len()];
        for (part, deviation) in self.part_of.iter().zip(deviations) {
            sums[*part] += deviation;
        }
        sums.iter().zip(&self.samples).map(|(sum, samples)| sum / *samples as f64).collect()
    }

    /// The change of ln A of an area by small deviations in parts, part by part.
    pub fn on(&self, area: usize, in_parts: &[f64]) -> Vec<f64> {
        self.of_parts.iter().zip(in_parts).map(|(of_part, deviation)| of_part[area] * deviation).collect()
    }

    /// The first sample of each part.
    pub fn starts(&self) -> impl Iterator<Item = usize> {
        (0..self.samples.len()).map(|part| self.part_of.partition_point(|of| *of < part))
    }
}

/// The part of each sample, from long to short wavelengths.
fn parts(psd: &ProfilePsd) -> Vec<usize> {
    let place = |wavelength_m: &f64| -(wavelength_m.log10() * PARTS_PER_DECADE).ceil();
    let mut part = 0;
    let mut last = psd.wavelengths_m().first().map_or(0.0, place);
    let mut next = |wavelength_m: &f64| {
        let here = place(wavelength_m);
        part += usize::from(here != last);
        last = here;
        part
    };
    psd.wavelengths_m().iter().map(&mut next).collect()
}
