//! A surface under any load: mean gap, stiffness and area by one model with the whole spectrum.
//!
//! The gap is measured from the mean plane of the rough surface to the flat: of the deformed surface in Persson's theory, of
//! the undeformed one where asperities are pressed one by one, as none of them moves the others.

use asperity::AsperityError;
use contact_law::{ContactLaw, ExponentialLaw, LawPoint, SamplingError};
use parallel::Progress;
use persson::hardness_laws::HardnessError;
use persson::separation::{LightLoads, SeparationLaw};
use persson::variance::Band;
use persson::{PerssonModel, Roughness};
use spectrum::{AsperityParameters, Normalisation};
use stat_contact::StatisticalContact;

use crate::models::{CurveModel, Persson, Pressable, Theory};
use crate::persson_law;
use crate::plan::{Plan, Results, Roughness as CutRoughness, Tolerance, contact_of};

/// A surface under a nominal pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GapState {
    /// Nominal pressure \[Pa\].
    pub nominal_pressure_pa: f64,
    /// Real over nominal area of contact.
    pub area_fraction: f64,
    /// Mean gap \[m\]; none where the model has none: with more than 3 % of the contact plastic in Persson's theory, and beyond
    /// complete contact.
    pub mean_gap_m: Option<f64>,
    /// K = -dp/du \[Pa/m\]; none where there is no gap.
    pub stiffness_pa_per_m: Option<f64>,
}

/// Choices beside the model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GapChoices {
    /// Elastic energy factor of Persson's theory, in (0, 1].
    pub energy_factor: f64,
    /// The band that a cutoff lets through in Persson's theory.
    pub band: Band,
    /// Relative tolerance of statistical states.
    pub tolerance: Tolerance,
}

/// Why a model has no gaps.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GapError {
    /// A model that knows no distance between the surfaces.
    #[error("the model {0} knows areas and no distances; take a statistical one, or one of Persson's theory")]
    NoDistances(&'static str),
    /// One sample, or moments that make no asperities.
    #[error(
        "the spectrum has no gap: its moments need two samples at least, and numbers within the range of doubles"
    )]
    NoRoughness,
    /// A spectrum that no isotropic surface has.
    #[error(
        "the spectrum is narrower than that of any isotropic surface (alpha = {alpha}, at least 1.5): it has no summits"
    )]
    TooNarrow {
        /// m0 m4/m2^2.
        alpha: f64,
    },
    /// A hardness that cannot be used with this spectrum, or cannot carry a load.
    #[error(transparent)]
    Hardness(#[from] HardnessError),
    /// A value that no model takes.
    #[error(transparent)]
    Value(#[from] AsperityError),
    /// The work was cancelled.
    #[error("ended before all was computed")]
    Cancelled,
}

/// A surface under any load.
#[derive(Debug)]
pub struct GapLaw {
    pressed: PressedBy,
    rms_height_m: f64,
    /// The band that a cutoff lets through in Persson's theory.
    band: Band,
}

#[derive(Debug)]
enum PressedBy {
    Persson { model: PerssonModel, roughness: Roughness, separation: SeparationLaw },
    Asperities { contact: StatisticalContact, mean_height_m: f64, tolerance: f64 },
}

impl GapLaw {
    /// The law of a model with what a plan has made of a spectrum: moments, and amplitudes where the hardness grows with
    /// them.
    ///
    /// # Errors
    /// [`GapError`] where the model or the spectrum has no gaps.
    pub fn of(
        model: &CurveModel,
        plan: &Plan<'_>,
        results: &Results,
        choices: &GapChoices,
    ) -> Result<Self, GapError> {
        let normalisation = plan.needs.moments.unwrap_or_default();
        let (moments, _) = results.moments.last().ok_or(GapError::NoRoughness)?;
        let parseval = Normalisation::Parseval.factor() / normalisation.factor();
        let rms_height_m = parseval.sqrt() * moments.rms_height_m();
        let pressed = match model.theory() {
            Theory::Stacked(_) => return Err(GapError::NoDistances(model.entry().name)),
            Theory::Persson(Persson { pair, law }) => {
                let model = law.model(pair)?;
                let roughness = roughness(plan, results, choices.band);
                let separation = model.separation(&roughness, choices.energy_factor);
                PressedBy::Persson { model, roughness, separation }
            }
            Theory::Statistical(statistical) => {
                let asperities = AsperityParameters::from_moments(moments).ok_or(GapError::NoRoughness)?;
                let cut = CutRoughness { moments: *moments, asperities };
                let contact = match contact_of(statistical, &cut)? {
                    Pressable::Contact(contact) => contact,
                    Pressable::TooNarrow { alpha } => return Err(GapError::TooNarrow { alpha }),
                };
                let mean_height_m = if model.entry().takes_moments() { 0.0 } else { asperities.offset_m };
                PressedBy::Asperities { contact, mean_height_m, tolerance: choices.tolerance.value() }
            }
        };
        Ok(GapLaw { pressed, rms_height_m, band: choices.band })
    }

    /// The surface under a nominal pressure > 0 \[Pa\].
    ///
    /// # Errors
    /// [`GapError::Hardness`] and [`GapError::Value`] for a pressure that cannot be carried.
    pub fn at(&self, pressure_pa: f64) -> Result<GapState, GapError> {
        match &self.pressed {
            PressedBy::Persson { model, roughness, separation } => {
                let last = model.at_last(roughness, separation, pressure_pa)?;
                let last = last.ok_or(GapError::NoRoughness)?;
                Ok(GapState {
                    nominal_pressure_pa: pressure_pa,
                    area_fraction: last.areas.contact(),
                    mean_gap_m: last.mean_gap_m,
                    stiffness_pa_per_m: last.stiffness_pa_per_m,
                })
            }
            PressedBy::Asperities { contact, mean_height_m, tolerance } => {
                let state = contact.at_pressure(pressure_pa, *tolerance, None)?;
                Ok(GapState {
                    nominal_pressure_pa: pressure_pa,
                    area_fraction: state.area_fraction,
                    mean_gap_m: state.separation_m.map(|separation_m| separation_m + mean_height_m),
                    stiffness_pa_per_m: state.stiffness_pa_per_m(),
                })
            }
        }
    }

    /// Returns the band that a cutoff lets through; `None` if the model is not Persson's theory.
    #[must_use]
    pub fn band(&self) -> Option<Band> {
        self.roughness().map(|_| self.band)
    }

    /// The law of light loads, where the model is Persson's theory.
    #[must_use]
    pub fn light_loads(&self) -> Option<LightLoads> {
        self.separation().and_then(SeparationLaw::light_loads)
    }

    /// The pressure \[Pa\] up to which that law gives pressures within a share of those of the theory.
    #[must_use]
    pub fn light_load_limit_pa(&self, share: f64) -> Option<f64> {
        self.separation().and_then(|separation| separation.light_load_limit_pa(share))
    }

    /// The law between two pressures \[Pa\] by points, straight within a relative `tolerance` of the pressure. `progress`
    /// advances once per state that is computed; how many are needed shows only in the end.
    ///
    /// # Errors
    /// [`SamplingError`] as [`ContactLaw::sample`] has it, and [`GapError::Cancelled`].
    pub fn sampled(
        &self,
        range_pa: [f64; 2],
        tolerance: f64,
        progress: &dyn Progress,
    ) -> Result<ContactLaw, SamplingError<GapError>> {
        ContactLaw::sample(range_pa, tolerance, |pressure_pa| {
            if progress.is_cancelled() {
                return Err(GapError::Cancelled);
            }
            progress.advance(1);
            let GapState { area_fraction, mean_gap_m, .. } = self.at(pressure_pa)?;
            Ok(mean_gap_m.map(|mean_gap_m| LawPoint { pressure_pa, mean_gap_m, area_fraction }))
        })
    }

    /// The law of light loads as finite element codes take it, with the pressure up to which it is within a share of the
    /// theory's.
    #[must_use]
    pub fn exponential(&self, share: f64) -> Option<ExponentialLaw> {
        let light = self.light_loads()?;
        Some(ExponentialLaw {
            decay_length_m: light.decay_length_m,
            reference_pressure_pa: light.reference_pressure_pa,
            holds_up_to_pa: self.light_load_limit_pa(share)?,
            share,
        })
    }

    /// The roughness as Persson's theory takes it, where that is the model.
    #[must_use]
    pub fn roughness(&self) -> Option<&Roughness> {
        match &self.pressed {
            PressedBy::Persson { roughness, .. } => Some(roughness),
            PressedBy::Asperities { .. } => None,
        }
    }

    /// Rms height of the surface \[m\].
    #[must_use]
    pub fn rms_height_m(&self) -> f64 {
        self.rms_height_m
    }

    fn separation(&self) -> Option<&SeparationLaw> {
        match &self.pressed {
            PressedBy::Persson { separation, .. } => Some(separation),
            PressedBy::Asperities { .. } => None,
        }
    }
}

/// Builds the roughness that Persson's theory takes from a computed plan, including the part that the cutoff left out.
#[must_use]
pub fn roughness(plan: &Plan<'_>, results: &Results, band: Band) -> Roughness {
    persson_law::roughness(
        &results.psd,
        results.moments.iter().map(|(moments, _)| moments),
        plan.needs.moments.unwrap_or_default(),
        &results.scales,
        &plan.beyond(&results.psd, band),
        band,
    )
}

#[cfg(test)]
mod tests {
    use asperity::ElasticBody;
    use spectrum::ProfilePsd;

    use super::*;
    use crate::hardness_and_strength::HardnessAndStrength;
    use crate::material::{GivenMaterial, Material};
    use crate::models::{Framework, MODELS, ModelOptions};
    use crate::plan::{Needs, Sampling};

    fn choices() -> GapChoices {
        GapChoices { energy_factor: 0.45, band: Band::Profile, tolerance: Tolerance::default() }
    }

    fn material() -> Material {
        Material::new(GivenMaterial {
            body: ElasticBody::new(463e9, 0.2).unwrap(),
            counterface: None,
            flows: crate::bodies::Body::Rough,
            hardness_and_strength: HardnessAndStrength::new(None, Some("10 GPa".parse().unwrap())).unwrap(),
            strength_cap: None,
            strain_gradient_length_m: None,
        })
    }

    /// Flat from 1e5 to 1e6 rad/m, and q^-2.6 to 1e8: rms height about 20 nm.
    fn spectrum() -> ProfilePsd {
        let q = |at: i32| 1e5 * 10f64.powf(f64::from(at) / 20.0);
        let c1d = |q: f64| if q < 1e6 { 6e-22 } else { 6e-22 * (q / 1e6).powf(-2.6) };
        let wavelengths_m = (0..=60).map(|at| std::f64::consts::TAU / q(at)).collect();
        ProfilePsd::new(wavelengths_m, (0..=60).map(|at| c1d(q(at))).collect()).unwrap()
    }

    fn law_of(name: &str, psd: &ProfilePsd) -> Result<GapLaw, GapError> {
        let entry = MODELS.iter().find(|entry| entry.name == name).unwrap();
        let model = entry.build(&material(), &ModelOptions::default()).unwrap();
        let needs = Needs { moments: Some(Normalisation::Parseval), ..Needs::default() };
        let plan = Plan { psd, sampling: Sampling::default(), needs };
        GapLaw::of(&model, &plan, &plan.compute().unwrap(), &choices())
    }

    #[test]
    fn the_stiffness_of_every_model_is_what_pressures_of_neighbouring_gaps_differ_by() {
        let psd = spectrum();
        // At this hardness more than a few per cent of the contact flow, and there is no gap then.
        let has_gaps = |name: &str| name != "persson-plastic";
        let entries = MODELS.iter().filter(|entry| entry.framework != Framework::Stacked);
        for entry in entries.filter(|entry| has_gaps(entry.name)) {
            let law = law_of(entry.name, &psd).unwrap();
            for pressure_pa in [1e5, 3e6, 2e8] {
                let state = law.at(pressure_pa).unwrap();
                let [less, more] = [1.0 - 1e-4, 1.0 + 1e-4].map(|factor| {
                    let state = law.at(factor * pressure_pa).unwrap();
                    state.mean_gap_m.unwrap()
                });
                let difference = 2e-4 * pressure_pa / (less - more);
                let off = state.stiffness_pa_per_m.unwrap() / difference - 1.0;
                assert!(off.abs() < 1e-6, "{entry} at {pressure_pa}: {off:e}");
                assert!(0.0 < state.area_fraction && state.area_fraction < 1.0, "{entry}: {state:?}");
            }
        }
    }

    #[test]
    fn gaps_of_asperities_are_those_of_their_summits_and_the_offset_of_these() {
        let psd = spectrum();
        let moments = spectrum::cumulative_moments(&psd, Normalisation::Parseval);
        let asperities = AsperityParameters::from_moments(moments.last().unwrap()).unwrap();
        // Both stand on the same summits, once of one curvature and once of all: from the same plane they are near to each
        // other, and farther apart than that by the offset if not.
        let [one, all] = ["hertz", "bgt"].map(|name| law_of(name, &psd).unwrap().at(1e6).unwrap());
        let apart_m = (one.mean_gap_m.unwrap() - all.mean_gap_m.unwrap()).abs();
        assert!(apart_m < 0.25 * asperities.offset_m, "{apart_m} {}", asperities.offset_m);
    }

    #[test]
    fn light_loads_are_a_law_of_perssons_theory_alone() {
        let psd = spectrum();
        let law = law_of("persson", &psd).unwrap();
        let light = law.light_loads().unwrap();
        let state = law.at(1e-6 * light.reference_pressure_pa).unwrap();
        let by_law_m = light.decay_length_m * 1e6f64.ln();
        assert!((state.mean_gap_m.unwrap() / by_law_m - 1.0).abs() < 1e-6);
        let most_pa = law.light_load_limit_pa(0.01).unwrap();
        assert!(most_pa < light.reference_pressure_pa && law.roughness().is_some());
        assert_eq!(law_of("hertz", &psd).unwrap().light_loads(), None);
        assert!((law.rms_height_m() / law_of("bgt", &psd).unwrap().rms_height_m() - 1.0).abs() < 1e-15);
    }

    #[test]
    fn a_law_is_sampled_as_close_as_it_needs() {
        for name in ["persson", "hertz", "bgt"] {
            let law = law_of(name, &spectrum()).unwrap();
            let sampled = law.sampled([1e4, 1e7], 0.01, &parallel::Unobserved).unwrap();
            for pressure_pa in [1e4, 7e4, 3.3e6, 1e7] {
                let overclosure_m = sampled.overclosure_m(law.at(pressure_pa).unwrap().mean_gap_m.unwrap());
                let off = sampled.pressure_pa(overclosure_m) / pressure_pa - 1.0;
                assert!(off.abs() < 0.01, "{name} at {pressure_pa}: {off:e}");
            }
            assert_eq!(law.exponential(0.01).is_some(), name == "persson");
        }
    }

    #[test]
    fn what_has_no_gaps_says_why() {
        let refused = |name: &str, psd: &ProfilePsd| law_of(name, psd).unwrap_err();
        assert_eq!(refused("elastic", &spectrum()), GapError::NoDistances("elastic"));
        let single = ProfilePsd::new(vec![1e-6], vec![1e-22]).unwrap();
        assert_eq!(refused("hertz", &single), GapError::NoRoughness);
        assert_eq!(refused("persson", &single), GapError::NoRoughness);
        // Where asperities flow, the elastic gap says nothing.
        let flows = law_of("persson-plastic", &spectrum()).unwrap().at(25e9).unwrap();
        assert_eq!((flows.mean_gap_m, flows.stiffness_pa_per_m), (None, None));
    }
}
