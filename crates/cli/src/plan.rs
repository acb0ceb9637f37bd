//! What is needed, computed once: every table, figure and reported number comes from one plan.

use std::num::NonZeroU32;

use asperity::{AsperityError, Bound, MaterialPair};
use rayon::prelude::*;
use serde::Serialize;
use spectrum::{
    AmplitudeDefinition, AsperityParameters, FitError, Moments, Normalisation, ProfilePsd, SelfAffineFit,
    amplitudes, cumulative_moments, cumulative_moments_to, fit_self_affine,
};
use stacked_contact::{Level, Scale, StackedModel, levels};
use stat_contact::{AsperityLaw, ContactState, Population, StatisticalContact};

/// More scales than any spectrum resolves, and what still fits into memory under a handful of loads.
const MOST_SCALES: usize = 2_000_000;

/// Which scales of the spectrum take part.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Sampling {
    /// Resample to this many scales per decade; as sampled where absent.
    pub scales_per_decade: Option<NonZeroU32>,
    /// Keep the scales at or above this wavelength \[m\].
    pub cutoff_m: Option<f64>,
}

/// A model under a name.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// The name of its table and of its entry in a legend.
    pub name: String,
    /// The model.
    pub model: CurveModel,
    /// Where its area is wanted.
    pub cutoffs: Cutoffs,
}

/// At which cutoffs a curve is wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Cutoffs {
    /// At every wavelength.
    #[default]
    Every,
    /// At the shortest one: a statistical model skips the others, a stack passes through them anyway.
    Shortest,
}

/// One of the two frameworks, with its law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CurveModel {
    /// Scale upon scale.
    Stacked(StackedModel),
    /// Asperities of one curvature and Gaussian heights.
    Statistical {
        /// The bodies in contact.
        pair: MaterialPair,
        /// The law of one asperity.
        law: AsperityLaw,
    },
}

/// A nominal pressure and how it was given.
#[derive(Debug, Clone, PartialEq)]
pub struct Load {
    /// Nominal pressure > 0 \[Pa\].
    pub nominal_pressure_pa: f64,
    /// As typed, e.g. `1e-3 H`.
    pub label: String,
}

/// A statistical curve against load, at some cutoffs.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadSweep {
    /// Which of the curves, by index.
    pub curve: usize,
    /// The cutoff, in multiples (at least 1) of the shortest wavelength that takes part.
    pub cutoff_multiple: f64,
    /// The nominal pressures > 0 \[Pa\].
    pub pressures_pa: Vec<f64>,
}

/// What is to be computed of a spectrum. Nothing is by default.
#[derive(Debug, Clone, Default)]
pub struct Needs {
    /// Spectral moments for every cutoff; statistical curves always need them.
    pub moments: Option<Normalisation>,
    /// McCool's asperity parameters from the moments; statistical curves always need them.
    pub asperities: bool,
    /// Amplitudes; stacked curves always need them.
    pub amplitudes: Option<AmplitudeDefinition>,
    /// The self-affine fit, to the wavelengths \[m\] between these, the shorter first; 0 and infinity leave an end open.
    pub fit_band_m: Option<(f64, f64)>,
    /// Curves against cutoff, each under every load.
    pub curves: Vec<Curve>,
    /// The loads.
    pub loads: Vec<Load>,
    /// Separations \[m\], of either sign, at which statistical curves are wanted besides the loads.
    pub separations_m: Vec<f64>,
    /// Statistical curves against load.
    pub sweeps: Vec<LoadSweep>,
    /// Relative tolerance of statistical states.
    pub tolerance: Tolerance,
}

/// The relative error allowed of a statistical state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance(f64);

impl Tolerance {
    const BOUND: Bound = Bound::LeftOpen { above: 0.0, at_most: 0.01 };

    /// A tolerance in (0, 0.01].
    ///
    /// # Errors
    /// [`AsperityError`] outside it.
    pub fn new(tolerance: f64) -> Result<Self, AsperityError> {
        Self::BOUND.check("tolerance", tolerance).map(Tolerance)
    }

    /// As a number, in (0, 0.01\].
    pub fn value(self) -> f64 {
        self.0
    }
}

impl Default for Tolerance {
    fn default() -> Self {
        Tolerance(1e-12)
    }
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
    /// Cutoffs for which asperity parameters were computed.
    pub asperity_cutoffs: usize,
    /// Scales whose amplitude was computed.
    pub amplitude_scales: usize,
    /// Levels of stacked curves.
    pub stacked_levels: usize,
    /// States of statistical curves.
    pub statistical_states: usize,
    /// Evaluations of the law of one asperity that these states took.
    pub law_evaluations: usize,
    /// Samples that took part in a fit.
    pub fitted_samples: usize,
}

/// What a plan yields; what was not needed is empty.
#[derive(Debug, Clone)]
pub struct Results {
    /// The spectrum as sampled for the plan.
    pub psd: ProfilePsd,
    /// Moments, and asperity parameters where needed, from the second wavelength on.
    pub moments: Vec<(Moments, Option<AsperityParameters>)>,
    /// Amplitudes, from long to short wavelengths.
    pub scales: Vec<Scale>,
    /// The fit.
    pub fit: Option<SelfAffineFit>,
    /// The curves against cutoff.
    pub curves: Vec<CurveResult>,
    /// For every sweep, a state per pressure; none where the cutoff leaves no asperities.
    pub sweeps: Vec<Vec<ContactState>>,
    /// How much was computed.
    pub work: Work,
}

/// A curve against cutoff: for every load its rows, from long to short wavelengths.
#[derive(Debug, Clone)]
pub enum CurveResult {
    /// Levels of the stack.
    Stacked(Vec<Vec<Level>>),
    /// States of the population that each cutoff leaves; the separations follow the loads.
    Statistical(Vec<Vec<CutoffState>>),
}

/// The contact of the asperities that a spectrum has up to a cutoff.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CutoffState {
    /// The cutoff \[m\].
    pub wavelength_m: f64,
    /// The asperities and their contact; none at the longest wavelength, where there are no moments yet.
    pub contact: Option<(AsperityParameters, ContactState)>,
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
    /// The resampled spectrum would be too large.
    #[error(
        "{scales_per_decade} scales per decade make {scales:e} scales; at most {MOST_SCALES} are computed, choose fewer"
    )]
    TooManyScales {
        /// The density asked for.
        scales_per_decade: NonZeroU32,
        /// The scales it makes.
        scales: f64,
    },
    /// The fit has too little to go by.
    #[error(transparent)]
    Fit(#[from] FitError),
    /// A value that no model takes.
    #[error(transparent)]
    Value(#[from] AsperityError),
}

impl Plan<'_> {
    /// Carries the plan out. Curves and loads run in parallel; the digits do not depend on the number of threads.
    ///
    /// # Errors
    /// [`PlanError`] where the cutoff leaves no scale, the resampled spectrum would be too large, a fit has too few
    /// samples, or a value lies outside its bounds.
    pub fn compute(&self) -> Result<Results, PlanError> {
        self.compute_observed(&|| ())
    }

    /// The same, with a call of `observe` after each statistical state, from any thread.
    ///
    /// # Errors
    /// Those of [`compute`](Self::compute).
    pub fn compute_observed(&self, observe: &(dyn Fn() + Sync)) -> Result<Results, PlanError> {
        let sampled = self.sampled()?;
        let psd = match self.sampling.cutoff_m {
            Some(cutoff_m) => sampled
                .truncated_at(cutoff_m)
                .ok_or(PlanError::NothingLeft { cutoff_m, longest_m: sampled.longest_wavelength_m() })?,
            None => sampled.clone(),
        };
        let moments = self.needs.moments.map_or_else(Vec::new, |norm| self.moments(&sampled, norm));
        let scales =
            self.needs.amplitudes.map_or_else(Vec::new, |definition| kept_scales(&sampled, &psd, definition));
        let fit =
            self.needs.fit_band_m.map(|(from_m, to_m)| fit_self_affine(&psd, from_m..=to_m)).transpose()?;
        let curve = |curve: &Curve| match curve.model {
            CurveModel::Stacked(model) => Ok(CurveResult::Stacked(self.stacked(&model, &scales))),
            CurveModel::Statistical { pair, law } => self
                .statistical(&pair, &law, psd.longest_wavelength_m(), curve.cutoffs, &moments, observe)
                .map(CurveResult::Statistical),
        };
        let curves = self.needs.curves.par_iter().map(curve).collect::<Result<Vec<_>, _>>()?;
        let sweeps = self
            .needs
            .sweeps
            .par_iter()
            .map(|sweep| self.sweep(sweep, &sampled, observe))
            .collect::<Result<Vec<_>, _>>()?;
        let states = || curves.iter().flat_map(CurveResult::states).chain(sweeps.iter().flatten());
        let work = Work {
            moment_cutoffs: moments.len(),
            asperity_cutoffs: moments.iter().filter(|(_, asperities)| asperities.is_some()).count(),
            amplitude_scales: scales.len(),
            stacked_levels: curves.iter().map(CurveResult::levels).sum(),
            statistical_states: states().count(),
            law_evaluations: states().map(|state| state.evaluations).sum(),
            fitted_samples: fit.as_ref().map_or(0, |fit| fit.points),
        };
        Ok(Results { psd, moments, scales, fit, curves, sweeps, work })
    }

    /// How many statistical states the plan takes, at most.
    pub fn statistical_states(&self) -> usize {
        let statistical = |curve: &&Curve| matches!(curve.model, CurveModel::Statistical { .. });
        let blocks = self.needs.loads.len() + self.needs.separations_m.len();
        let cutoffs = |curve: &Curve| match curve.cutoffs {
            Cutoffs::Every => self.psd.len(),
            Cutoffs::Shortest => 1,
        };
        let sweeps: usize = self.needs.sweeps.iter().map(|sweep| sweep.pressures_pa.len()).sum();
        self.needs.curves.iter().filter(statistical).map(cutoffs).sum::<usize>() * blocks + sweeps
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

    fn moments(
        &self,
        sampled: &ProfilePsd,
        norm: Normalisation,
    ) -> Vec<(Moments, Option<AsperityParameters>)> {
        let moments = match self.sampling.cutoff_m {
            Some(cutoff_m) => cumulative_moments_to(sampled, norm, cutoff_m),
            None => cumulative_moments(sampled, norm),
        };
        let asperities = |moments: &Moments| {
            if self.needs.asperities { AsperityParameters::from_moments(moments) } else { None }
        };
        moments.into_iter().map(|moments| (moments, asperities(&moments))).collect()
    }

    fn stacked(&self, model: &StackedModel, scales: &[Scale]) -> Vec<Vec<Level>> {
        let one = |load: &Load| levels(model, load.nominal_pressure_pa, scales.iter().copied()).collect();
        self.needs.loads.par_iter().map(one).collect()
    }

    fn statistical(
        &self,
        pair: &MaterialPair,
        law: &AsperityLaw,
        longest_m: f64,
        cutoffs: Cutoffs,
        moments: &[(Moments, Option<AsperityParameters>)],
        observe: &(dyn Fn() + Sync),
    ) -> Result<Vec<Vec<CutoffState>>, PlanError> {
        let pressures = self.needs.loads.iter().map(|load| Given::Pressure(load.nominal_pressure_pa));
        let separations =
            self.needs.separations_m.iter().map(|&separation_m| Given::Separation(separation_m));
        let (mut first_row, mut moments) =
            (Some(CutoffState { wavelength_m: longest_m, contact: None }), moments);
        if let (Cutoffs::Shortest, [.., shortest]) = (cutoffs, moments) {
            (first_row, moments) = (None, std::slice::from_ref(shortest));
        }
        let block = |given: Given| {
            let mut rows = Vec::from_iter(first_row);
            let mut neighbour = None;
            for (moments, parameters) in moments {
                let contact = match parameters {
                    Some(parameters) => {
                        let state = self.state(pair, law, parameters, given, neighbour.as_ref())?;
                        observe();
                        neighbour = Some(state);
                        Some((*parameters, state))
                    }
                    None => None,
                };
                rows.push(CutoffState { wavelength_m: moments.wavelength_m, contact });
            }
            Ok(rows)
        };
        pressures.chain(separations).collect::<Vec<_>>().into_par_iter().map(block).collect()
    }

    fn sweep(
        &self,
        sweep: &LoadSweep,
        sampled: &ProfilePsd,
        observe: &(dyn Fn() + Sync),
    ) -> Result<Vec<ContactState>, PlanError> {
        let CurveModel::Statistical { pair, law } = self.needs.curves[sweep.curve].model else {
            return Ok(Vec::new());
        };
        let shortest_m = self.sampling.cutoff_m.unwrap_or(0.0).max(sampled.shortest_wavelength_m());
        let norm = self.needs.moments.unwrap_or_default();
        let moments = cumulative_moments_to(sampled, norm, sweep.cutoff_multiple * shortest_m);
        let Some(parameters) = moments.last().and_then(AsperityParameters::from_moments) else {
            return Ok(Vec::new());
        };
        let mut states: Vec<ContactState> = Vec::with_capacity(sweep.pressures_pa.len());
        for &pressure_pa in &sweep.pressures_pa {
            states.push(self.state(&pair, &law, &parameters, Given::Pressure(pressure_pa), states.last())?);
            observe();
        }
        Ok(states)
    }

    /// A state of the asperities that moments describe; `neighbour` saves work and changes no digit.
    fn state(
        &self,
        pair: &MaterialPair,
        law: &AsperityLaw,
        parameters: &AsperityParameters,
        given: Given,
        neighbour: Option<&ContactState>,
    ) -> Result<ContactState, PlanError> {
        let population =
            Population::new(parameters.radius_m, parameters.density_per_m2, parameters.sigma_s_m)?;
        let contact = StatisticalContact::new(pair, &population, law);
        let tolerance = self.needs.tolerance.value();
        Ok(match given {
            Given::Pressure(pressure_pa) => contact.at_pressure(pressure_pa, tolerance, neighbour)?,
            Given::Separation(separation_m) => contact.at_separation(separation_m, tolerance)?,
        })
    }
}

/// The amplitudes of the scales kept. An amplitude does not depend on the cutoff, so that a curve cut short is the
/// beginning of the whole one: the band of the last scale reaches to its neighbour below the cutoff.
fn kept_scales(sampled: &ProfilePsd, kept: &ProfilePsd, definition: AmplitudeDefinition) -> Vec<Scale> {
    let neighbour_m = sampled.wavelengths_m().get(kept.len()).copied();
    let reached = neighbour_m.and_then(|neighbour_m| sampled.truncated_at(neighbour_m));
    let scales = amplitudes(reached.as_ref().unwrap_or(kept), definition).into_iter().take(kept.len());
    scales.map(|scale| Scale { wavelength_m: scale.wavelength_m, amplitude_m: scale.amplitude_m }).collect()
}

/// What a statistical state is asked at.
#[derive(Clone, Copy)]
enum Given {
    Pressure(f64),
    Separation(f64),
}

impl CurveResult {
    /// Number of blocks: one per load, and per separation.
    pub fn blocks(&self) -> usize {
        match self {
            CurveResult::Stacked(blocks) => blocks.len(),
            CurveResult::Statistical(blocks) => blocks.len(),
        }
    }

    /// A block as points of wavelength \[m\] and area fraction; cutoffs without asperities have none.
    ///
    /// # Panics
    /// Unless `block` is below [`blocks`](Self::blocks).
    pub fn area_fractions(&self, block: usize) -> Vec<(f64, f64)> {
        match self {
            CurveResult::Stacked(blocks) => {
                blocks[block].iter().map(|level| (level.wavelength_m, level.area_fraction)).collect()
            }
            CurveResult::Statistical(blocks) => blocks[block]
                .iter()
                .filter_map(|row| row.contact.map(|(_, state)| (row.wavelength_m, state.area_fraction)))
                .collect(),
        }
    }

    /// Levels of a stacked curve.
    fn levels(&self) -> usize {
        match self {
            CurveResult::Stacked(blocks) => blocks.iter().map(Vec::len).sum(),
            CurveResult::Statistical(_) => 0,
        }
    }

    /// States of a statistical curve.
    fn states(&self) -> impl Iterator<Item = &ContactState> {
        let blocks = match self {
            CurveResult::Stacked(_) => &[][..],
            CurveResult::Statistical(blocks) => blocks,
        };
        blocks.iter().flatten().filter_map(|row| row.contact.as_ref().map(|(_, state)| state))
    }
}

/// Scales per decade of a spectrum, on average; absent for a single scale.
pub fn scales_per_decade(psd: &ProfilePsd) -> Option<f64> {
    let decades = (psd.longest_wavelength_m() / psd.shortest_wavelength_m()).log10();
    (decades > 0.0).then(|| (psd.len() - 1) as f64 / decades)
}
