//! What is needed, computed once: every table, figure and reported number comes from one plan.

use std::num::NonZeroU32;

use rayon::prelude::*;
use serde::Serialize;
use spectrum::{
    AmplitudeDefinition, AsperityParameters, FitError, Moments, Normalisation, ProfilePsd, SelfAffineFit,
    amplitudes, cumulative_moments, cumulative_moments_to, fit_self_affine,
};
use stacked_contact::{Level, Scale, StackedModel, levels};

/// Which scales of the spectrum take part.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Sampling {
    /// Resample to this many scales per decade; as sampled where absent.
    pub scales_per_decade: Option<NonZeroU32>,
    /// Keep the scales at or above this wavelength \[m\].
    pub cutoff_m: Option<f64>,
}

/// A stacked model under a name.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// The name of its table and of its entry in a legend.
    pub name: String,
    /// The model.
    pub model: StackedModel,
}

/// A nominal pressure and how it was given.
#[derive(Debug, Clone, PartialEq)]
pub struct Load {
    /// Nominal pressure > 0 \[Pa\].
    pub nominal_pressure_pa: f64,
    /// As typed, e.g. `1e-3 H`.
    pub label: String,
}

/// What is to be computed of a spectrum. Nothing is by default.
#[derive(Debug, Clone, Default)]
pub struct Needs {
    /// Spectral moments and McCool's parameters for every cutoff.
    pub moments: Option<Normalisation>,
    /// Amplitudes; stacked curves always need them.
    pub amplitudes: Option<AmplitudeDefinition>,
    /// The self-affine fit, to the wavelengths \[m\] between these.
    pub fit_band_m: Option<(f64, f64)>,
    /// Stacked curves, each under every load.
    pub curves: Vec<Curve>,
    /// The loads.
    pub loads: Vec<Load>,
}

/// A spectrum, and what is to be computed of it.
pub struct Plan<'p> {
    /// The spectrum as read.
    pub psd: &'p ProfilePsd,
    /// Which of its scales take part.
    pub sampling: Sampling,
    /// What is to be computed.
    pub needs: Needs,
}

/// How much was computed: the proof that nothing else was.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Work {
    /// Cutoffs for which moments were computed.
    pub moment_cutoffs: usize,
    /// Scales whose amplitude was computed.
    pub amplitude_scales: usize,
    /// Levels of stacked curves.
    pub stacked_levels: usize,
    /// Samples that took part in a fit.
    pub fitted_samples: usize,
}

/// What a plan yields; what was not needed is empty.
#[derive(Debug, Clone)]
pub struct Results {
    /// The spectrum as sampled for the plan.
    pub psd: ProfilePsd,
    /// Moments and asperity parameters, from the second wavelength on.
    pub moments: Vec<(Moments, Option<AsperityParameters>)>,
    /// Amplitudes, from long to short wavelengths.
    pub scales: Vec<Scale>,
    /// The fit.
    pub fit: Option<SelfAffineFit>,
    /// For every curve, for every load, its levels.
    pub curves: Vec<Vec<Vec<Level>>>,
    /// How much was computed.
    pub work: Work,
}

/// Why a plan cannot be carried out.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PlanError {
    /// The cutoff leaves nothing.
    #[error(
        "the cutoff {cutoff_m:e} m leaves no scale: the longest wavelength is {longest_m:e} m; choose a shorter one"
    )]
    NothingLeft {
        /// The cutoff.
        cutoff_m: f64,
        /// The longest wavelength.
        longest_m: f64,
    },
    /// The fit has too little to go by.
    #[error(transparent)]
    Fit(#[from] FitError),
}

impl Plan<'_> {
    /// Carries the plan out. Curves and loads run in parallel; the digits do not depend on the number of threads.
    ///
    /// # Errors
    /// [`PlanError`].
    pub fn compute(&self) -> Result<Results, PlanError> {
        let sampled = match self.sampling.scales_per_decade {
            Some(scales_per_decade) => self.psd.resampled(scales_per_decade),
            None => self.psd.clone(),
        };
        let psd = match self.sampling.cutoff_m {
            Some(cutoff_m) => sampled
                .truncated_at(cutoff_m)
                .ok_or(PlanError::NothingLeft { cutoff_m, longest_m: sampled.longest_wavelength_m() })?,
            None => sampled.clone(),
        };
        let moments = self.needs.moments.map_or_else(Vec::new, |norm| self.moments(&sampled, norm));
        // An amplitude does not depend on the cutoff: a curve cut short is the beginning of the whole one.
        let scales: Vec<Scale> = self.needs.amplitudes.map_or_else(Vec::new, |definition| {
            let scales = amplitudes(&sampled, definition).into_iter().take(psd.len());
            scales.map(|s| Scale { wavelength_m: s.wavelength_m, amplitude_m: s.amplitude_m }).collect()
        });
        let fit =
            self.needs.fit_band_m.map(|(from_m, to_m)| fit_self_affine(&psd, from_m..=to_m)).transpose()?;
        let curves = self.curves(&scales);
        let work = Work {
            moment_cutoffs: moments.len(),
            amplitude_scales: scales.len(),
            stacked_levels: curves.iter().flatten().map(Vec::len).sum(),
            fitted_samples: fit.as_ref().map_or(0, |fit| fit.points),
        };
        Ok(Results { psd, moments, scales, fit, curves, work })
    }

    fn moments(
        &self,
        sampled: &ProfilePsd,
        norm: Normalisation,
    ) -> Vec<(Moments, Option<AsperityParameters>)> {
        let moments = match self.sampling.cutoff_m {
            Some(cutoff_m) => cumulative_moments_to(sampled, norm, cutoff_m),
            None => cumulative_moments(sampled, norm),
        };
        moments.into_iter().map(|moments| (moments, AsperityParameters::from_moments(&moments))).collect()
    }

    fn curves(&self, scales: &[Scale]) -> Vec<Vec<Vec<Level>>> {
        let curve = |curve: &Curve| {
            let one = |load: &Load| {
                levels(&curve.model, load.nominal_pressure_pa, scales.iter().copied()).collect::<Vec<_>>()
            };
            self.needs.loads.par_iter().map(one).collect()
        };
        self.needs.curves.par_iter().map(curve).collect()
    }
}

/// Scales per decade of a spectrum, on average; absent for a single scale.
pub fn scales_per_decade(psd: &ProfilePsd) -> Option<f64> {
    let decades = (psd.longest_wavelength_m() / psd.shortest_wavelength_m()).log10();
    (decades > 0.0).then(|| (psd.len() - 1) as f64 / decades)
}
