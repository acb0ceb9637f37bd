//! Preparation of a spectrum: its scales that take part, their moments and asperities, their amplitudes.

use std::sync::Arc;

use spectrum::{
    AmplitudeDefinition, AsperityParameters, Moments, ProfilePsd, amplitudes, cumulative_moments,
    cumulative_moments_to, fit_self_affine,
};
use stacked_contact::Scale;

use super::error::MOST_SCALES;
use super::prepared_spectrum::{Cutoff, Roughness};
use super::run::Run;
use super::{Cutoffs, LoadSweep, Plan, PlanError, PreparedSpectrum, Work};

impl Plan<'_> {
    /// Computes the values that the curves need.
    pub(super) fn prepare(&self, run: Run<'_>) -> Result<PreparedSpectrum, PlanError> {
        let sampled = self.sampled()?;
        run.go_on()?;
        let nothing_left =
            |cutoff_m| PlanError::NothingLeft { cutoff_m, longest_m: sampled.longest_wavelength_m() };
        let kept = |cutoff_m| sampled.truncated_at(cutoff_m).ok_or_else(|| nothing_left(cutoff_m));
        let kept = self.sampling.cutoff_m.map(kept).transpose()?;
        let psd = kept.as_ref().unwrap_or(&sampled);
        let moments = self.moments(&sampled);
        run.go_on()?;
        let scales =
            self.needs.amplitudes.map_or_else(Vec::new, |definition| kept_scales(&sampled, psd, definition));
        run.go_on()?;
        let fit =
            self.needs.fit_band_m.map(|(from_m, to_m)| fit_self_affine(psd, from_m..=to_m)).transpose()?;
        let mut work = Work {
            moment_cutoffs: moments.len(),
            asperity_cutoffs: moments.iter().filter(|(_, asperities)| asperities.is_some()).count(),
            amplitude_scales: scales.len(),
            fitted_samples: fit.as_ref().map_or(0, |fit| fit.points),
            ..Work::default()
        };
        let sweep_cutoffs = self.sweep_cutoffs(&sampled, &moments, &mut work);
        let (psd, gradients) = (kept.unwrap_or(sampled), Arc::default());
        Ok(PreparedSpectrum { psd, moments, scales, fit, sweep_cutoffs, work, gradients })
    }

    /// Returns an upper bound of the number of scales that take part.
    pub(super) fn most_scales(&self) -> usize {
        let (longest_m, shortest_m) = (self.psd.longest_wavelength_m(), self.psd.shortest_wavelength_m());
        let cutoff_m = self.sampling.cutoff_m.unwrap_or(0.0);
        match self.sampling.scales_per_decade {
            // Both ends may be scales beside the evenly spaced ones.
            Some(scales_per_decade) => {
                let decades = (longest_m / shortest_m.max(cutoff_m)).log10().max(0.0);
                (f64::from(scales_per_decade.get()) * decades) as usize + 2
            }
            None => {
                let kept = self.psd.wavelengths_m().partition_point(|wavelength_m| *wavelength_m >= cutoff_m);
                (kept + 1).min(self.psd.len())
            }
        }
    }

    fn sampled(&self) -> Result<ProfilePsd, PlanError> {
        let Some(scales_per_decade) = self.sampling.scales_per_decade else { return Ok(self.psd.clone()) };
        let decades = (self.psd.longest_wavelength_m() / self.psd.shortest_wavelength_m()).log10();
        let scales = f64::from(scales_per_decade.get()) * decades;
        if scales > MOST_SCALES as f64 {
            return Err(PlanError::TooManyScales { scales_per_decade, scales });
        }
        Ok(self.psd.resampled(scales_per_decade))
    }

    /// The moments, and the asperities at the cutoffs where something needs them.
    fn moments(&self, sampled: &ProfilePsd) -> Vec<(Moments, Option<AsperityParameters>)> {
        let Some(norm) = self.needs.moments else { return Vec::new() };
        let moments = match self.sampling.cutoff_m {
            Some(cutoff_m) => cumulative_moments_to(sampled, norm, cutoff_m),
            None => cumulative_moments(sampled, norm),
        };
        let first_needed = match self.asperity_cutoffs_wanted() {
            None => moments.len(),
            Some(Cutoffs::Shortest) => moments.len().saturating_sub(1),
            Some(Cutoffs::Every) => 0,
        };
        let asperities =
            |at: usize, moments| (at >= first_needed).then(|| AsperityParameters::from_moments(moments));
        let rows = moments.iter().enumerate();
        rows.map(|(at, moments)| (*moments, asperities(at, moments).flatten())).collect()
    }

    /// Returns the cutoffs at which asperities are needed, if any.
    pub fn asperity_cutoffs_wanted(&self) -> Option<Cutoffs> {
        let statistical = self.needs.curves.iter().filter(|curve| curve.model.statistical().is_some());
        let mut wanted = statistical.map(|curve| curve.cutoffs).peekable();
        if wanted.peek().is_none() && !self.needs.asperities {
            return None;
        }
        let every = self.needs.asperities || wanted.any(|cutoffs| cutoffs == Cutoffs::Every);
        Some(if every { Cutoffs::Every } else { Cutoffs::Shortest })
    }

    /// The cutoffs of the sweeps. Those at one cutoff share their asperities, and those at the shortest wavelength that takes
    /// part share the curves'.
    fn sweep_cutoffs(
        &self,
        sampled: &ProfilePsd,
        of_curves: &[(Moments, Option<AsperityParameters>)],
        work: &mut Work,
    ) -> Vec<Cutoff> {
        let shortest_m = self.sampling.cutoff_m.unwrap_or(0.0).max(sampled.shortest_wavelength_m());
        let norm = self.needs.moments.unwrap_or_default();
        let mut at = |cutoff_multiple: f64| {
            let wavelength_m = cutoff_multiple * shortest_m;
            let roughness = match of_curves.last() {
                Some(row @ (_, Some(_))) if cutoff_multiple == 1.0 => Roughness::of(row),
                _ => {
                    let moments = cumulative_moments_to(sampled, norm, wavelength_m);
                    let row = moments.last().map(|last| (*last, AsperityParameters::from_moments(last)));
                    let roughness = row.as_ref().and_then(Roughness::of);
                    work.moment_cutoffs += moments.len();
                    work.asperity_cutoffs += usize::from(roughness.is_some());
                    roughness
                }
            };
            Cutoff { wavelength_m, roughness }
        };
        let mut known: Vec<(f64, Cutoff)> = Vec::new();
        let cutoff = |sweep: &LoadSweep| {
            let multiple = sweep.cutoff_multiple;
            if let Some((_, cutoff)) = known.iter().find(|(other, _)| *other == multiple) {
                return *cutoff;
            }
            let cutoff = at(multiple);
            known.push((multiple, cutoff));
            cutoff
        };
        self.needs.sweeps.iter().map(cutoff).collect()
    }
}

/// The amplitudes of the scales kept. An amplitude does not depend on the cutoff, so that a curve cut short is the
/// beginning of the whole one: the band of the last scale reaches to its neighbour below the cutoff.
fn kept_scales(sampled: &ProfilePsd, kept: &ProfilePsd, definition: AmplitudeDefinition) -> Vec<Scale> {
    let neighbour_m = sampled.wavelengths_m().get(kept.len()).copied();
    let reached = neighbour_m.and_then(|neighbour_m| sampled.truncated_at(neighbour_m));
    let mut scales = amplitudes(reached.as_ref().unwrap_or(kept), definition);
    scales.truncate(kept.len());
    scales
}
