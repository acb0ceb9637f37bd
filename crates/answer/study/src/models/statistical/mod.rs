//! Populations of asperities that cutoffs leave, under loads and at separations.

pub(crate) mod states;

use std::num::NonZeroU32;
use std::ops::Range;

use asperity::{AsperityError, MaterialPair};
use ordered_float::OrderedFloat;
use serde::Serialize;
use spectrum::AsperityParameters;
use stat_contact::{
    AsperityLaw, Condition, ContactState, Flattening, NayakSummits, Population, StatisticalContact,
    SummitHeights,
};
use tables::Table;

use self::states::States;
use super::{Choice, CurveResult, Framework, Job, ModelEntry, ModelOptions, Theory};
use crate::material::Material;
use crate::model_options::unless_default;
use crate::plan::error::PlanError;
use crate::plan::gap::{GapError, GapState};
use crate::plan::prepared_spectrum::{Cutoff, Cutoffs, PreparedSpectrum, Roughness};
use crate::plan::work::Work;

/// The populations.
pub(super) const MODELS: &[ModelEntry] = &[
    ModelEntry {
        name: "hertz",
        short_name: "Greenwood & Williamson",
        full_name: "Greenwood-Williamson (Hertz)",
        citation: "Greenwood & Williamson (1966), Proc. R. Soc. A 295:300",
        aliases: &["gw", "gwhertz", "greenwoodwilliamson"],
        framework: Framework::Statistical,
        choices: &[Choice::SummitHeights],
        takes_moments: false,
        build: |material, options| {
            let heights = options.summit_heights.unwrap_or_default();
            let law = Some(AsperityLaw::Hertz);
            Ok(Theory::Statistical(Statistical { pair: material.pair, law, heights }))
        },
    },
    ModelEntry {
        name: "ep-sphere",
        short_name: "GW spheres, elastic-plastic",
        full_name: "GW, elastic-plastic spheres (Jackson-Green)",
        citation: "Jackson & Green (2005), J. Tribol. 127:343",
        aliases: &["jacksongreen"],
        framework: Framework::Statistical,
        choices: &[Choice::Strength, Choice::StrainGradient, Choice::Hardness, Choice::Flattening],
        takes_moments: false,
        build: |material, options| {
            let strength = material.strength(options.strain_gradient)?;
            let hardness = options.hardness.unwrap_or_default();
            let held_from = options.flattening.unwrap_or_default().held_from();
            Ok(statistical(material, Some(AsperityLaw::EpSphere { strength, hardness, held_from })))
        },
    },
    ModelEntry {
        name: "elastic-sine",
        short_name: "GW sinusoids, elastic",
        full_name: "GW, elastic sinusoids (Rostami-Jackson)",
        citation: "Johnson, Greenwood & Higginson (1985), Int. J. Mech. Sci. 27:383; Jackson & Streator (2006), Wear 261:1337",
        aliases: &["rostamijackson"],
        framework: Framework::Statistical,
        choices: &[Choice::Interference],
        takes_moments: false,
        build: |material, options| {
            let interference = options.interference_law.unwrap_or_default();
            Ok(statistical(material, Some(AsperityLaw::ElasticSine { interference })))
        },
    },
    ModelEntry {
        name: "ep-sine",
        short_name: "GW sinusoids, elastic-plastic",
        full_name: "GW, elastic-plastic sinusoids (Krithivasan-Jackson)",
        citation: "Krithivasan & Jackson (2007), Tribol. Lett. 27:31; Rostami & Jackson (2013), Proc. IMechE J 227:1376",
        aliases: &["krithivasanjackson"],
        framework: Framework::Statistical,
        choices: &[Choice::Strength, Choice::StrainGradient],
        takes_moments: false,
        build: |material, options| {
            let strength = material.strength(options.strain_gradient)?;
            Ok(statistical(material, Some(AsperityLaw::EpSine { strength })))
        },
    },
    ModelEntry {
        name: "bgt",
        short_name: "Bush-Gibson-Thomas",
        full_name: "elastic summits of every curvature (Bush-Gibson-Thomas)",
        citation: "Bush, Gibson & Thomas (1975), Wear 35:87; Nayak (1971), J. Lubr. Technol. 93:398",
        aliases: &["bushgibsonthomas"],
        framework: Framework::Statistical,
        choices: &[],
        takes_moments: true,
        build: |material, _| Ok(statistical(material, None)),
    },
];

fn statistical(material: &Material, law: Option<AsperityLaw>) -> Theory {
    Theory::Statistical(Statistical { pair: material.pair, law, heights: SummitHeights::Gaussian })
}

/// A statistical theory of bodies in contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Statistical {
    /// The bodies in contact.
    pub pair: MaterialPair,
    /// The law of asperities of one curvature, McCool's; absent for the summits of the surface, which have every curvature and
    /// are elastic (Bush, Gibson & Thomas).
    pub law: Option<AsperityLaw>,
    /// The distribution of the heights; other laws than that of elastic spheres have Gaussian ones.
    pub heights: SummitHeights,
}

/// A surface as a statistical model presses it.
pub enum Pressable {
    /// Asperities, or the summits of a surface.
    Contact(StatisticalContact),
    /// A spectrum narrower than that of any surface, which has no summits.
    TooNarrow {
        /// m0 m4/m2^2 of the spectrum, below 1.5.
        alpha: f64,
    },
}

/// The contact of the asperities that a spectrum has up to a cutoff.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CutoffState {
    /// The cutoff \[m\].
    pub wavelength_m: f64,
    /// The asperities and their contact; `None` at the longest wavelength, where there are no moments yet.
    pub contact: Option<(AsperityParameters, ContactState)>,
    /// Alpha of a spectrum too narrow for any surface, for a model of summits: there is no contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub too_narrow_alpha: Option<f64>,
}

/// The asperity parameters that a state depends on: if these are equal, so are the moments, the summits and the states.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Asperities([OrderedFloat<f64>; 3]);

impl Asperities {
    pub fn of(parameters: &AsperityParameters) -> Self {
        Asperities([parameters.radius_m, parameters.density_per_m2, parameters.sigma_s_m].map(OrderedFloat))
    }
}

impl Statistical {
    /// Returns the contact of a roughness: of the radius \[m\], density \[1/m^2\] and rms height \[m\] of asperities, or of
    /// the moments m0 \[m^2\], m2 and m4 \[1/m^2\] for the law of the summits.
    ///
    /// # Errors
    /// [`AsperityError`] for numbers that the law does not take.
    pub fn press(&self, [first, second, third]: [f64; 3]) -> Result<Pressable, AsperityError> {
        let Some(law) = &self.law else {
            return match NayakSummits::new(first, second, third) {
                Ok(summits) => Ok(Pressable::Contact(StatisticalContact::from_summits(&self.pair, &summits))),
                Err(error) if error.bound == NayakSummits::ALPHA => {
                    Ok(Pressable::TooNarrow { alpha: error.value })
                }
                Err(error) => Err(error),
            };
        };
        let population = Population::new(first, second, third)?;
        Ok(Pressable::Contact(match self.heights {
            SummitHeights::Gaussian => StatisticalContact::new(&self.pair, &population, law),
            SummitHeights::Exponential => StatisticalContact::from_exponential(&self.pair, &population),
        }))
    }

    /// Returns the asperities of a roughness as the model presses them.
    ///
    /// # Errors
    /// [`AsperityError`] for numbers out of the law's bounds.
    pub(crate) fn press_roughness(&self, roughness: &Roughness) -> Result<Pressable, AsperityError> {
        let Roughness { moments, asperities } = roughness;
        self.press(match self.law {
            Some(_) => [asperities.radius_m, asperities.density_per_m2, asperities.sigma_s_m],
            None => [moments.m0_m2, moments.m2, moments.m4_per_m2],
        })
    }

    /// Returns the same bodies with another law of one asperity, or nothing for the summits of a surface.
    pub(super) fn with_law(&self, change: impl FnOnce(AsperityLaw) -> Option<AsperityLaw>) -> Option<Theory> {
        let law = Some(change(self.law?)?);
        Some(Theory::Statistical(Statistical { law, ..*self }))
    }

    /// Returns the options that differ from their defaults, but for the strain gradient.
    pub(super) fn options(&self) -> ModelOptions {
        let summit_heights = unless_default(self.heights);
        let mut options = ModelOptions { summit_heights, ..ModelOptions::default() };
        match self.law {
            Some(AsperityLaw::EpSphere { hardness, held_from, .. }) => {
                options.hardness = unless_default(hardness);
                options.flattening = held_from.is_none().then_some(Flattening::Area);
            }
            Some(AsperityLaw::ElasticSine { interference }) => {
                options.interference_law = unless_default(interference);
            }
            _ => {}
        }
        options
    }

    /// Checks that every cutoff can be pressed.
    ///
    /// # Errors
    /// [`PlanError::Value`] for numbers out of the law's bounds.
    pub(super) fn check(&self, prepared: &PreparedSpectrum, cutoffs: Cutoffs) -> Result<(), PlanError> {
        for cutoff in prepared.cutoffs(cutoffs, 0..prepared.cutoff_count(cutoffs)) {
            cutoff.roughness.map(|roughness| self.press_roughness(&roughness)).transpose()?;
        }
        Ok(())
    }

    /// Computes some rows of the block of every condition.
    ///
    /// # Errors
    /// [`PlanError`] for values out of the law's bounds, and if the work was cancelled.
    pub(super) fn blocks(
        &self,
        job: &Job<'_>,
        conditions: &[Condition],
        places: Range<usize>,
    ) -> Result<(CurveResult, Work), PlanError> {
        let cutoffs = job.prepared.cutoffs(job.cutoffs, places);
        let cutoffs = match job.run.states_per_decade {
            Some(per_decade) => thinned(cutoffs, per_decade),
            None => cutoffs,
        };
        let states = States { model: self, run: job.run };
        let (blocks, work) = states.over_cutoffs(&cutoffs, conditions)?;
        Ok((CurveResult::Statistical(blocks), work))
    }

    /// Returns all asperities of a spectrum.
    ///
    /// # Errors
    /// [`GapError`] for a spectrum without asperities.
    pub(super) fn surface(
        &self,
        prepared: &PreparedSpectrum,
        tolerance: f64,
    ) -> Result<PressedAsperities, GapError> {
        let (moments, _) = prepared.moments.last().ok_or(GapError::NoRoughness)?;
        let asperities = AsperityParameters::from_moments(moments).ok_or(GapError::NoRoughness)?;
        let contact = match self.press_roughness(&Roughness { moments: *moments, asperities })? {
            Pressable::Contact(contact) => contact,
            Pressable::TooNarrow { alpha } => return Err(GapError::TooNarrow { alpha }),
        };
        let mean_height_m = self.law.map_or(0.0, |_| asperities.offset_m);
        Ok(PressedAsperities { contact, mean_height_m, tolerance })
    }
}

/// Returns of neighbouring cutoffs, from long to short, at most so many per decade: the last of each part of a decade, so
/// that the shortest is always there.
fn thinned(cutoffs: Vec<Cutoff>, per_decade: NonZeroU32) -> Vec<Cutoff> {
    let part = |cutoff: &Cutoff| (cutoff.wavelength_m.log10() * f64::from(per_decade.get())).ceil();
    cutoffs.chunk_by(|a, b| part(a) == part(b)).filter_map(|part| part.last().copied()).collect()
}

/// All asperities of a spectrum, the mean of their heights above the mean plane of the surface.
#[derive(Debug)]
pub(crate) struct PressedAsperities {
    contact: StatisticalContact,
    mean_height_m: f64,
    tolerance: f64,
}

impl PressedAsperities {
    pub fn at(&self, pressure_pa: f64) -> Result<GapState, GapError> {
        let state = self.contact.at_pressure(pressure_pa, self.tolerance, None)?;
        let mean_gap_m = state.separation_m.map(|separation_m| separation_m + self.mean_height_m);
        Ok(GapState {
            nominal_pressure_pa: pressure_pa,
            area_fraction: state.area_fraction,
            mean_gap_m,
            mean_plane_distance_m: mean_gap_m,
            stiffness_pa_per_m: state.stiffness_pa_per_m(),
        })
    }
}

impl CutoffState {
    /// Returns wavelength \[m\], area fraction and real pressure \[Pa\], or nothing without contact.
    pub(super) fn point(&self) -> Option<[f64; 3]> {
        let (_, state) = self.contact?;
        let real_pressure_pa = (state.ln_pressure_pa - state.ln_area_fraction).exp();
        Some([self.wavelength_m, state.area_fraction, real_pressure_pa])
    }
}

/// One column of a state.
type StateColumn = (&'static str, fn(&ContactState) -> Option<f64>);

/// Columns of a statistical state on how it was found, and its logarithms.
pub const STATE_DETAILS: [StateColumn; 6] = [
    ("error_estimate", |state| Some(state.error_estimate)),
    ("evaluations", |state| Some(state.evaluations as f64)),
    ("out_of_range_load_share", |state| Some(state.out_of_range_load_share)),
    ("ln_pressure_pa", |state| Some(state.ln_pressure_pa)),
    ("ln_area_fraction", |state| Some(state.ln_area_fraction)),
    ("flattened_share", |state| state.flattened_share),
];

/// Returns states as a table, with `details` of how each was found.
pub(super) fn table(blocks: &[Vec<CutoffState>], details: bool) -> Table {
    let rows = || blocks.iter().flatten();
    let parameter =
        |of: fn(&AsperityParameters) -> f64| rows().map(move |row| row.contact.map(|(p, _)| of(&p)));
    let state =
        |of: fn(&ContactState) -> Option<f64>| rows().map(move |row| row.contact.and_then(|(_, s)| of(&s)));
    let table = Table::default()
        .with_numbers("wavelength_m", rows().map(|row| row.wavelength_m))
        .with_numbers("radius_m", parameter(|p| p.radius_m))
        .with_numbers("density_per_m2", parameter(|p| p.density_per_m2))
        .with_numbers("sigma_s_m", parameter(|p| p.sigma_s_m))
        .with_numbers("separation_m", state(|s| s.separation_m))
        .with_numbers("pressure_pa", state(|s| Some(s.pressure_pa)))
        .with_numbers("area_fraction", state(|s| Some(s.area_fraction)));
    if !details {
        return table;
    }
    STATE_DETAILS.iter().fold(table, |table, (name, of)| table.with_numbers(name, state(*of)))
}
