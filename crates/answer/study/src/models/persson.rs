//! Persson's theory: its models, its cuts of curves, and surfaces under any load.

use asperity::{MaterialPair, NixGao};
use persson::corrections::Correction;
use persson::hardness_laws::{CappedHardness, HardnessError, HardnessGrowth};
use persson::separation::SeparationLaw;
use persson::yielding::{SpotFactor, YieldingLaw};
use persson::{Band, Cut, EnergyFactor, PerssonModel, Roughness, RoughnessSample};
use serde::Serialize;
use spectrum::Normalisation;
use tables::Table;

use super::{Choice, CurveResult, Framework, Job, ModelEntry, Theory};
use crate::growth_law::GrowthLaw;
use crate::hardness_and_strength::HARDNESS_OVER_STRENGTH;
use crate::material::{Material, MaterialError, NeededFor};
use crate::model_options::{ModelOptions, unless_default};
use crate::plan::error::PlanError;
use crate::plan::gap::{GapError, GapState};
use crate::plan::prepared_spectrum::{Cutoffs, PreparedSpectrum};
use crate::plan::work::Work;

/// The forms of the theory.
pub(super) const MODELS: &[ModelEntry] = &[
    ModelEntry {
        name: "persson",
        short_name: "Persson, elastic",
        full_name: "Persson's theory, elastic",
        citation: "Persson (2001), J. Chem. Phys. 115:3840; Manners & Greenwood (2006), Wear 261:600",
        aliases: &["perssonstheory", "perssontheory"],
        framework: Framework::Persson,
        choices: &[Choice::Correction, Choice::Band, Choice::Gamma],
        takes_moments: false,
        build: |material, options| {
            let persson = Persson::new(material.pair, options);
            Ok(Theory::Persson(Persson { correction: options.correction, ..persson }))
        },
    },
    ModelEntry {
        name: "persson-plastic",
        short_name: "Persson, elastic-plastic",
        full_name: "Persson's theory, elastic-plastic",
        citation: "Persson (2001), Phys. Rev. Lett. 87:116101; Persson (2006), Surf. Sci. Rep. 61:201",
        aliases: &["perssonep"],
        framework: Framework::Persson,
        choices: &[
            Choice::Strength,
            Choice::StrainGradient,
            Choice::Band,
            Choice::Gamma,
            Choice::HardnessLaw,
        ],
        takes_moments: false,
        build: |material, options| {
            let plastic = Some(PlasticLaw::new(material, options)?);
            Ok(Theory::Persson(Persson { plastic, ..Persson::new(material.pair, options) }))
        },
    },
];

/// Persson's theory of bodies in contact, with its choices.
#[derive(Debug, Clone, PartialEq)]
pub struct Persson {
    /// The bodies in contact.
    pub pair: MaterialPair,
    /// The corrected form of the elastic theory, if any; absent for a surface that yields.
    pub correction: Option<Correction>,
    /// The hardness; absent for an elastic surface.
    pub plastic: Option<PlasticLaw>,
    /// The spectrum that a cutoff ends.
    pub band: Band,
    /// The elastic energy factor of separations.
    pub energy_factor: EnergyFactor,
}

impl Persson {
    /// Returns the elastic theory, with band and energy factor as given or by default.
    fn new(pair: MaterialPair, options: &ModelOptions) -> Self {
        let (band, energy_factor) = (options.band.unwrap_or_default(), options.gamma.unwrap_or_default());
        Persson { pair, correction: None, plastic: None, band, energy_factor }
    }

    /// Returns the law of a hardness that grows without a strain gradient.
    pub(super) fn growth(&self) -> Option<&GrowthLaw> {
        self.plastic.as_ref()?.growth.as_ref()
    }

    /// Returns the theory with another strength, or nothing for an elastic surface. A measured hardness is kept.
    pub(super) fn with_strength(&self, strength: NixGao) -> Option<Theory> {
        let plastic = Some(self.plastic.as_ref()?.with_strength(strength));
        Some(Theory::Persson(Persson { plastic, ..self.clone() }))
    }

    /// Returns the options that differ from their defaults, but for the strain gradient.
    pub(super) fn options(&self) -> ModelOptions {
        let Persson { band, energy_factor, .. } = *self;
        ModelOptions {
            correction: self.correction,
            band: unless_default(band),
            gamma: unless_default(energy_factor),
            hardness_law: self.growth().cloned(),
            ..ModelOptions::default()
        }
    }

    /// Returns the theory of the bodies in contact, and a roughness between them.
    ///
    /// # Errors
    /// [`HardnessError`] for a hardness beyond the range of magnitudes.
    fn between_bodies(&self, roughness: Roughness) -> Result<(PerssonModel, Roughness), HardnessError> {
        let contact_modulus_pa = self.pair.composite_modulus_pa();
        let model = match &self.plastic {
            None => PerssonModel::Elastic { contact_modulus_pa, correction: self.correction },
            Some(plastic) => {
                PerssonModel::ElasticPlastic { contact_modulus_pa, hardness: plastic.hardness()? }
            }
        };
        let roughness = match self.pair.layer_compliance() {
            Some(layer) => roughness.on_layer(layer),
            None => roughness,
        };
        Ok((model, roughness))
    }

    /// Computes a block of cuts for every nominal pressure \[Pa\].
    ///
    /// # Errors
    /// [`PlanError`] for a hardness that cannot carry a load, and if the work was cancelled.
    pub(super) fn blocks(
        &self,
        job: &Job<'_>,
        pressures_pa: &[f64],
    ) -> Result<(CurveResult, Work), PlanError> {
        let (model, roughness) = self.between_bodies((job.roughness)(self.band))?;
        let separation = (!job.run.areas_alone).then(|| model.separation(&roughness, self.energy_factor));
        let blocks = numerics::parallel::try_map(pressures_pa, |&pressure_pa| {
            job.run.go_on()?;
            Ok::<_, PlanError>(cuts(&model, &roughness, separation.as_ref(), job.cutoffs, pressure_pa)?)
        })?;
        Ok((CurveResult::Persson(PerssonCuts { blocks, band: self.band }), Work::default()))
    }

    /// Returns the surface with its whole roughness.
    ///
    /// # Errors
    /// [`HardnessError`] for a hardness beyond the range of magnitudes.
    pub fn surface(
        &self,
        roughness: Roughness,
        energy_factor: EnergyFactor,
    ) -> Result<PerssonSurface, HardnessError> {
        let (model, roughness) = self.between_bodies(roughness)?;
        let separation = model.separation(&roughness, energy_factor);
        let yielding =
            model.constant_hardness_pa().zip(roughness.places().last()).map(|(hardness_pa, last)| {
                let spread_pa = last.variance_pa2(model.contact_modulus_pa()).sqrt();
                (YieldingLaw::new(&separation, spread_pa), hardness_pa)
            });
        Ok(PerssonSurface { model, roughness, separation, yielding })
    }
}

/// The deformation of the surface, as requested: elastic, or elastic-plastic at a hardness.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Deformation {
    /// It does not.
    Elastic,
    /// It does at a hardness.
    ElasticPlastic,
}

units::named!(Deformation, "model", { Elastic => "elastic", ElasticPlastic => "elastic-plastic" });

impl Deformation {
    /// Returns the name of its model, as scenes have it.
    #[must_use]
    pub fn model_name(self) -> &'static str {
        match self {
            Deformation::Elastic => "persson",
            Deformation::ElasticPlastic => "persson-plastic",
        }
    }
}

/// A hardness with its growth towards short wavelengths, and the strength of the same body.
#[derive(Debug, Clone, PartialEq)]
pub struct PlasticLaw {
    /// The strength of the body that yields, with the strain-gradient length where the hardness grows as Nix & Gao have it.
    pub strength: NixGao,
    /// The hardness \[Pa\] at long wavelengths.
    pub hardness_pa: f64,
    /// H/S0: 3, except for the deviation that a given pair may have.
    hardness_over_strength: f64,
    /// The law of a hardness that grows without a strain gradient.
    pub growth: Option<GrowthLaw>,
}

impl PlasticLaw {
    /// Returns the hardness of a material under the options of its model.
    ///
    /// # Errors
    /// [`MaterialError`] if the material lacks a property that the law needs, or has it out of bounds.
    pub fn new(material: &Material, options: &ModelOptions) -> Result<Self, MaterialError> {
        let law = options.hardness_law.as_ref();
        let has_gradient = law.map_or(options.strain_gradient, |law| *law == GrowthLaw::NixGao);
        let growth = law.filter(|law| **law != GrowthLaw::NixGao).cloned();
        let given_pa = match (material.hardness_pa(), &growth) {
            // A table brings its own hardness.
            (None, Some(GrowthLaw::Table(table))) => table.rows().last().map(|(_, hardness_pa)| *hardness_pa),
            (given_pa, _) => given_pa,
        };
        let (strength, hardness_pa) = match (material.hardness_pa(), given_pa) {
            (None, Some(hardness_pa)) => {
                let strength = NixGao::constant(hardness_pa / HARDNESS_OVER_STRENGTH)?;
                let cap_pa = material.strength_cap_pa();
                (cap_pa.map_or(Ok(strength), |cap_pa| strength.with_cap(cap_pa))?, hardness_pa)
            }
            (_, hardness_pa) => {
                let strength = material.strength(has_gradient)?;
                (strength, hardness_pa.ok_or(MaterialError::Missing(NeededFor::Yielding))?)
            }
        };
        let hardness_over_strength = match material.hardness_pa() {
            Some(hardness_pa) => hardness_pa / strength.macroscopic_strength_pa(),
            None => HARDNESS_OVER_STRENGTH,
        };
        Ok(PlasticLaw { strength, hardness_pa, hardness_over_strength, growth })
    }

    fn with_strength(&self, strength: NixGao) -> Self {
        let is_other = strength.macroscopic_strength_pa() != self.strength.macroscopic_strength_pa();
        let hardness_pa = match is_other {
            true => self.hardness_over_strength * strength.macroscopic_strength_pa(),
            false => self.hardness_pa,
        };
        PlasticLaw { strength, hardness_pa, ..self.clone() }
    }

    /// Returns the hardness along a spectrum. One that does not grow has no cap.
    ///
    /// # Errors
    /// [`HardnessError`] for numbers beyond the range of magnitudes, and for a cap below the hardness.
    pub fn hardness(&self) -> Result<CappedHardness, HardnessError> {
        let hardness_pa = self.hardness_pa;
        let growth = match (&self.growth, self.strength.strain_gradient_length_m()) {
            (Some(GrowthLaw::Power(exponent)), _) => {
                HardnessGrowth::Power { hardness_pa, exponent: *exponent }
            }
            (Some(GrowthLaw::Table(table)), _) => HardnessGrowth::Table(table.clone()),
            (_, Some(length_m)) => HardnessGrowth::NixGao { hardness_pa, length_m },
            (_, None) => return CappedHardness::new(HardnessGrowth::Constant { hardness_pa }, None),
        };
        // The cap is one of the yield strength.
        let cap_pa = self.strength.cap_pa().map(|cap_pa| self.hardness_over_strength * cap_pa);
        CappedHardness::new(growth, cap_pa)
    }
}

/// A surface by Persson's theory.
#[derive(Debug)]
pub struct PerssonSurface {
    /// The theory of the bodies in contact.
    pub model: PerssonModel,
    /// The roughness.
    pub roughness: Roughness,
    /// The law of its separations.
    pub separation: SeparationLaw,
    /// The law of separations where peaks flow at a constant hardness \[Pa\], if they do.
    yielding: Option<(YieldingLaw, f64)>,
}

impl PerssonSurface {
    /// Returns true if peaks flow at a constant hardness.
    pub(crate) fn yields(&self) -> bool {
        self.yielding.is_some()
    }

    pub(super) fn at(&self, pressure_pa: f64) -> Result<GapState, GapError> {
        let last = self.model.at_last(&self.roughness, &self.separation, pressure_pa)?;
        let last = last.ok_or(GapError::NoRoughness)?;
        let elastic = GapState {
            nominal_pressure_pa: pressure_pa,
            area_fraction: last.areas.contact(),
            mean_gap_m: last.mean_gap_m,
            mean_plane_distance_m: last.mean_gap_m,
            stiffness_pa_per_m: last.stiffness_pa_per_m,
        };
        let Some((law, hardness_pa)) = &self.yielding else { return Ok(elastic) };
        let yielded = law.at(pressure_pa, *hardness_pa, &SpotFactor::new());
        Ok(GapState {
            mean_gap_m: yielded.map(|yielded| yielded.gap.mean_gap_m),
            mean_plane_distance_m: yielded.map(|yielded| yielded.gap.mean_plane_distance_m),
            stiffness_pa_per_m: yielded.map(|yielded| yielded.unloading_stiffness_pa_per_m),
            ..elastic
        })
    }
}

/// Returns the contact under a pressure at the cutoffs, with mean gap and stiffness if a law of separations is given.
fn cuts(
    model: &PerssonModel,
    roughness: &Roughness,
    separation: Option<&SeparationLaw>,
    cutoffs: Cutoffs,
    pressure_pa: f64,
) -> Result<Vec<Cut>, HardnessError> {
    let by_area = |(place, areas)| Cut::without_separation(place, areas, pressure_pa);
    let places = roughness.places();
    Ok(match (cutoffs, separation) {
        (Cutoffs::Every, Some(separation)) => model.along(roughness, separation, pressure_pa)?,
        (Cutoffs::Every, None) => {
            places.iter().zip(model.areas(roughness, pressure_pa)?).map(by_area).collect()
        }
        (Cutoffs::Shortest, Some(separation)) => {
            model.at_last(roughness, separation, pressure_pa)?.into_iter().collect()
        }
        (Cutoffs::Shortest, None) => {
            let last = places.last().zip(model.areas_at_last(roughness, pressure_pa)?);
            last.into_iter().map(by_area).collect()
        }
    })
}

/// Cuts of Persson's theory under loads.
#[derive(Debug, Clone, Serialize)]
#[serde(transparent)]
pub struct PerssonCuts {
    /// For every load its cuts, from long to short wavelengths.
    pub blocks: Vec<Vec<Cut>>,
    /// Band that a cutoff lets through.
    #[serde(skip)]
    pub band: Band,
}

impl PerssonCuts {
    /// Appends the columns of the cuts to a table of their loads.
    pub(super) fn table(&self, loads: Table) -> Table {
        let column = |of: fn(&Cut) -> f64| self.blocks.iter().flatten().map(of);
        let optional = |of: fn(&Cut) -> Option<f64>| self.blocks.iter().flatten().map(of);
        loads
            .with_numbers("wavelength_m", column(|cut| cut.wavelength_m))
            .with_numbers("area_fraction", column(|cut| cut.areas.contact()))
            .with_numbers("elastic_area_fraction", column(|cut| cut.areas.elastic))
            .with_numbers("plastic_area_fraction", column(|cut| cut.areas.plastic))
            .with_numbers("real_pressure_pa", column(|cut| cut.real_pressure_pa))
            .with_numbers("rms_gradient", column(|cut| cut.rms_gradient))
            .with_numbers("mean_gap_m", optional(|cut| cut.mean_gap_m))
            .with_numbers("stiffness_pa_per_m", optional(|cut| cut.stiffness_pa_per_m))
            .with_words("band", self.blocks.iter().flatten().map(|_| self.band.name()))
    }
}

/// Returns wavelength \[m\], area fraction and real pressure \[Pa\] of a cut.
pub(super) fn point(cut: &Cut) -> [f64; 3] {
    [cut.wavelength_m, cut.areas.contact(), cut.real_pressure_pa]
}

/// The roughness of a spectrum with the moments, of a normalisation, that it has from the second wavelength on, and the amplitudes of its
/// scales; without amplitudes no hardness can follow them.
#[must_use]
pub(crate) fn roughness(prepared: &PreparedSpectrum, normalisation: Normalisation, band: Band) -> Roughness {
    let PreparedSpectrum { psd, moments, scales, .. } = prepared;
    let parseval = Normalisation::Parseval.factor() / normalisation.factor();
    let moments = moments.iter().map(|(m, _)| [m.m0_m2, m.m2, m.m4_per_m2].map(|moment| parseval * moment));
    let samples: Vec<RoughnessSample> = psd
        .wavelengths_m()
        .iter()
        .zip(psd.c1d_m3())
        .zip(std::iter::once([0.0; 3]).chain(moments))
        .enumerate()
        .map(|(at, ((&wavelength_m, &c1d_m3), moments))| {
            let amplitude_m = scales.get(at).map_or(f64::INFINITY, |scale| scale.amplitude_m);
            RoughnessSample { wavelength_m, c1d_m3, moments, amplitude_m }
        })
        .collect();
    Roughness::new(&samples, (band == Band::Surface).then(|| prepared.gradients_of_surface()))
}

#[cfg(test)]
mod tests {
    use asperity::ElasticBody;

    use super::*;
    use crate::hardness_and_strength::HardnessAndStrength;
    use crate::material::GivenMaterial;

    #[test]
    fn a_hardness_that_grows_has_the_cap_of_the_strength_and_a_constant_one_has_none() {
        let hardness = |length_m, law: Option<GrowthLaw>| {
            let material = Material::new(GivenMaterial {
                hardness_and_strength: HardnessAndStrength::new(None, Some("1 GPa".parse().unwrap()))
                    .unwrap(),
                strength_cap: Some("2 GPa".parse().unwrap()),
                strain_gradient_length_m: length_m,
                ..GivenMaterial::new(ElasticBody::new(463e9, 0.2).unwrap())
            });
            let options = ModelOptions { hardness_law: law, ..ModelOptions::default() };
            PlasticLaw::new(&material, &options).map(|law| law.hardness().unwrap())
        };
        let constant = CappedHardness::new(HardnessGrowth::Constant { hardness_pa: 3e9 }, None).unwrap();
        assert_eq!(hardness(None, None), Ok(constant));
        let growth = HardnessGrowth::NixGao { hardness_pa: 3e9, length_m: 1e-6 };
        let growing = CappedHardness::new(growth, Some(6e9)).unwrap();
        assert_eq!(hardness(Some(1e-6), Some(GrowthLaw::NixGao)), Ok(growing));
        let missing = MaterialError::Missing(NeededFor::StrainGradient);
        assert_eq!(hardness(None, Some(GrowthLaw::NixGao)), Err(missing));
    }
}
