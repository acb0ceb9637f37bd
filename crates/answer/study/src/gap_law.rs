//! A surface under any load: mean gap, stiffness and area by one model with the whole spectrum.
//!
//! The gap is measured from the mean plane of the rough surface to the flat: of the deformed surface in Persson's theory, of
//! the undeformed one where asperities are pressed one by one, as none of them moves the others.

use interface::finite_elements::{ContactLaw, ExponentialLaw, LawPoint, SamplingError};
use numerics::parallel::Progress;
use persson::Band;
use persson::Roughness;
use persson::separation::{LightLoads, SeparationLaw};
use spectrum::Normalisation;

use crate::models::persson::PerssonSurface;
use crate::models::{self, CurveModel, LoadedSurface};
pub use crate::plan::gap::{GapChoices, GapError, GapState};
use crate::plan::{Plan, PreparedSpectrum, Results};

/// A surface under any load.
#[derive(Debug)]
pub struct GapLaw {
    surface: LoadedSurface,
    /// Rms height of the surface \[m\].
    pub rms_height_m: f64,
    /// The band that a cutoff lets through in Persson's theory.
    band: Band,
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
        let prepared = PreparedSpectrum::from_results(results);
        let surface = model.surface(&prepared, || plan.roughness(&prepared, choices.band), choices)?;
        let surface = surface.ok_or(GapError::NoDistances(model.entry.name))?;
        Ok(GapLaw { surface, rms_height_m, band: choices.band })
    }

    /// The surface under a nominal pressure > 0 \[Pa\].
    ///
    /// # Errors
    /// [`GapError::Hardness`] and [`GapError::Value`] for a pressure that cannot be carried.
    pub fn at(&self, pressure_pa: f64) -> Result<GapState, GapError> {
        self.surface.at(pressure_pa)
    }

    /// Returns the band that a cutoff lets through; `None` if the model is not Persson's theory.
    #[must_use]
    pub fn band(&self) -> Option<Band> {
        self.roughness().map(|_| self.band)
    }

    /// Returns true if peaks flow at a constant hardness, so that the law of light loads holds at none.
    #[must_use]
    pub fn yields(&self) -> bool {
        self.surface.persson().is_some_and(PerssonSurface::yields)
    }

    /// Share of the contact that flows under a nominal pressure > 0 \[Pa\] by Persson's theory, which overstates it; `None` unless the
    /// model is one where peaks flow at a constant hardness.
    #[must_use]
    pub fn flowed_share(&self, pressure_pa: f64) -> Option<f64> {
        let PerssonSurface { model, roughness, .. } =
            self.surface.persson().filter(|surface| surface.yields())?;
        Some(model.areas_at_last(roughness, pressure_pa).ok()??.plastic_share())
    }

    /// The law of light loads of elastic peaks, where the model is Persson's theory.
    #[must_use]
    pub fn light_loads(&self) -> Option<LightLoads> {
        self.separation().and_then(SeparationLaw::light_loads)
    }

    /// The pressure \[Pa\] up to which that law gives pressures within a share of those of the theory; `None` where peaks flow.
    #[must_use]
    pub fn light_load_limit_pa(&self, share: f64) -> Option<f64> {
        self.separation().filter(|_| !self.yields()).and_then(|law| law.light_load_limit_pa(share))
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
            let GapState { area_fraction, mean_plane_distance_m, .. } = self.at(pressure_pa)?;
            Ok(mean_plane_distance_m.map(|mean_gap_m| LawPoint { pressure_pa, mean_gap_m, area_fraction }))
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
        self.surface.persson().map(|surface| &surface.roughness)
    }

    fn separation(&self) -> Option<&SeparationLaw> {
        self.surface.persson().map(|surface| &surface.separation)
    }
}

/// Builds the roughness that Persson's theory takes from results and the normalisation of their moments.
#[must_use]
pub fn roughness(results: &Results, normalisation: Normalisation, band: Band) -> Roughness {
    models::persson::roughness(&PreparedSpectrum::from_results(results), normalisation, band)
}

#[cfg(test)]
mod tests {
    use asperity::ElasticBody;
    use persson::EnergyFactor;
    use spectrum::{AsperityParameters, ProfilePsd};

    use super::*;
    use crate::hardness_and_strength::HardnessAndStrength;
    use crate::material::{GivenMaterial, Material};
    use crate::models::{MODELS, ModelOptions};
    use crate::plan::{Needs, Sampling, Tolerance};

    fn choices() -> GapChoices {
        GapChoices {
            energy_factor: EnergyFactor::default(),
            band: Band::Profile,
            tolerance: Tolerance::default(),
        }
    }

    fn material() -> Material {
        Material::new(GivenMaterial {
            hardness_and_strength: HardnessAndStrength::new(None, Some("10 GPa".parse().unwrap())).unwrap(),
            ..GivenMaterial::new(ElasticBody::new(463e9, 0.2).unwrap())
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
        // Where peaks flow the stiffness is that of unloading, and the slope that of loading.
        let has_gaps = |name: &str| name != "persson-plastic";
        let entries = MODELS.iter().filter(|entry| entry.framework.has_gaps());
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
        assert!((law.rms_height_m / law_of("bgt", &psd).unwrap().rms_height_m - 1.0).abs() < 1e-15);
    }

    #[test]
    fn a_law_is_sampled_as_close_as_it_needs() {
        for name in ["persson", "hertz", "bgt"] {
            let law = law_of(name, &spectrum()).unwrap();
            let sampled = law.sampled([1e4, 1e7], 0.01, &numerics::parallel::Unobserved).unwrap();
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
        // Where everything touches and flows, no gap is left.
        let law = law_of("persson-plastic", &spectrum()).unwrap();
        let flows = law.at(30e9).unwrap();
        assert_eq!((flows.mean_gap_m, flows.stiffness_pa_per_m, flows.area_fraction), (None, None, 1.0));
        assert_eq!((law.yields(), law.exponential(0.01)), (true, None));
    }

    #[test]
    fn peaks_that_flow_are_nearer_and_stiffer_on_unloading_and_pass_each_other() {
        let [elastic, plastic] =
            ["persson", "persson-plastic"].map(|name| law_of(name, &spectrum()).unwrap().at(3e9).unwrap());
        let gap_m = |state: GapState| state.mean_gap_m.unwrap();
        assert!(gap_m(plastic) < gap_m(elastic) && plastic.stiffness_pa_per_m > elastic.stiffness_pa_per_m);
        assert!(plastic.mean_plane_distance_m < plastic.mean_gap_m);
        assert_eq!(elastic.mean_plane_distance_m, elastic.mean_gap_m);
    }
}
