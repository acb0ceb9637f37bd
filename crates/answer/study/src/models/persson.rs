//! Persson's theory as a model of curves, and a spectrum as that theory takes it.

use asperity::{MaterialPair, NixGao};
use persson::corrections::Correction;
use persson::hardness_laws::{Hardness, HardnessError, HardnessGrowth};
use persson::variance::Band;
use persson::{EnergyFactor, PerssonModel, Roughness, RoughnessSample};
use spectrum::{Moments, Normalisation, ProfilePsd};
use stacked_contact::Scale;

use super::{Choice, Framework, FrameworkFacts, ModelEntry, MomentUse, Theory, TheoryLaw};
use crate::growth_law::GrowthLaw;
use crate::hardness_and_strength::HARDNESS_OVER_STRENGTH;
use crate::material::{Material, MaterialError, NeededFor};
use crate::model_options::ModelOptions;

/// Properties of every form of the theory.
pub(super) static FACTS: FrameworkFacts = FrameworkFacts {
    name: "persson",
    noun: "model of Persson's theory",
    moments: MomentUse::Parseval,
    takes_amplitude: true,
    has_states: false,
    has_gaps: true,
    takes_hardness: true,
};

/// The forms of the theory.
pub(super) const MODELS: &[ModelEntry] = &[
    ModelEntry {
        name: "persson",
        short_name: "Persson, elastic",
        full_name: "Persson's theory, elastic",
        citation: "Persson (2001), J. Chem. Phys. 115:3840; Manners & Greenwood (2006), Wear 261:600",
        framework: Framework::Persson,
        choices: &[Choice::Correction, Choice::Band, Choice::Gamma],
        takes_moments: false,
        build: |material, options| {
            let deformation = PerssonDeformation::Elastic { correction: options.correction };
            Ok(Theory::Persson(Persson { pair: material.pair, law: PerssonLaw::new(deformation, options) }))
        },
    },
    ModelEntry {
        name: "persson-plastic",
        short_name: "Persson, elastic-plastic",
        full_name: "Persson's theory, elastic-plastic",
        citation: "Persson (2001), Phys. Rev. Lett. 87:116101; Persson (2006), Surf. Sci. Rep. 61:201",
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
            let plastic = PlasticLaw::new(material, options)?;
            let law = PerssonLaw::new(PerssonDeformation::ElasticPlastic(plastic), options);
            Ok(Theory::Persson(Persson { pair: material.pair, law }))
        },
    },
];

/// Persson's theory of bodies in contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Persson {
    /// The bodies in contact.
    pub pair: MaterialPair,
    /// The law with its choices.
    pub law: PerssonLaw,
}

impl Persson {
    /// Returns the theory of the same bodies with another law.
    pub(super) fn with_law(&self, law: PerssonLaw) -> Theory {
        Theory::Persson(Persson { pair: self.pair, law })
    }
}

impl TheoryLaw for Persson {
    fn pair(&self) -> MaterialPair {
        self.pair
    }

    fn with_pair(&self, pair: MaterialPair) -> Theory {
        Theory::Persson(Persson { pair, law: self.law.clone() })
    }

    fn strength(&self) -> Option<NixGao> {
        self.law.plastic().map(PlasticLaw::strength)
    }

    fn with_strength(&self, strength: NixGao) -> Option<Theory> {
        Some(self.with_law(self.law.with_strength(strength)?))
    }

    fn hardness_pa(&self) -> Option<f64> {
        self.law.plastic().map(PlasticLaw::hardness_pa)
    }

    fn strength_grows(&self) -> bool {
        self.law.plastic().is_some_and(PlasticLaw::grows)
    }

    fn needs_amplitudes(&self) -> bool {
        self.has_strain_gradient()
    }

    fn options(&self) -> ModelOptions {
        let PerssonLaw { band, energy_factor, .. } = self.law;
        ModelOptions {
            correction: self.law.correction().flatten(),
            band: (band != Band::default()).then_some(band),
            gamma: (energy_factor != EnergyFactor::default()).then_some(energy_factor),
            hardness_law: self.law.plastic().and_then(PlasticLaw::growth).cloned(),
            ..ModelOptions::default()
        }
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

/// Persson's theory with its choices.
#[derive(Debug, Clone, PartialEq)]
pub struct PerssonLaw {
    /// The deformation of the surface.
    pub deformation: PerssonDeformation,
    /// The spectrum that a cutoff ends.
    pub band: Band,
    /// The elastic energy factor of separations.
    pub energy_factor: EnergyFactor,
}

/// The deformation of the surface in Persson's theory.
#[derive(Debug, Clone, PartialEq)]
pub enum PerssonDeformation {
    /// Elastic, by the theory or by a corrected form of it.
    Elastic {
        /// The corrected form.
        correction: Option<Correction>,
    },
    /// Elastic up to a hardness.
    ElasticPlastic(PlasticLaw),
}

/// A hardness with its growth towards short wavelengths, and the strength of the same body.
#[derive(Debug, Clone, PartialEq)]
pub struct PlasticLaw {
    /// The strength, with the strain-gradient length where the hardness grows as Nix & Gao have it.
    strength: NixGao,
    /// The hardness \[Pa\] at long wavelengths.
    hardness_pa: f64,
    /// H/S0: 3, except for the deviation that a given pair may have.
    hardness_over_strength: f64,
    /// The law of a hardness that grows without a strain gradient.
    growth: Option<GrowthLaw>,
}

impl PerssonLaw {
    /// Returns the law of a deformation, with the other choices as given or by default.
    #[must_use]
    pub fn new(deformation: PerssonDeformation, options: &ModelOptions) -> Self {
        let (band, energy_factor) = (options.band.unwrap_or_default(), options.gamma.unwrap_or_default());
        PerssonLaw { deformation, band, energy_factor }
    }

    /// Returns the law of the hardness, or nothing for an elastic surface.
    #[must_use]
    pub fn plastic(&self) -> Option<&PlasticLaw> {
        match &self.deformation {
            PerssonDeformation::Elastic { .. } => None,
            PerssonDeformation::ElasticPlastic(plastic) => Some(plastic),
        }
    }

    /// Returns the corrected form of the elastic theory; the outer `None` is for a surface that yields.
    #[must_use]
    pub fn correction(&self) -> Option<Option<Correction>> {
        match self.deformation {
            PerssonDeformation::Elastic { correction } => Some(correction),
            PerssonDeformation::ElasticPlastic(_) => None,
        }
    }

    /// Returns the law with another strength, or nothing for an elastic surface. A measured hardness is kept.
    #[must_use]
    pub fn with_strength(&self, strength: NixGao) -> Option<Self> {
        let plastic = self.plastic()?.with_strength(strength);
        Some(PerssonLaw { deformation: PerssonDeformation::ElasticPlastic(plastic), ..*self })
    }

    /// Returns the law with another correction, or nothing for a surface that yields.
    #[must_use]
    pub fn with_correction(&self, correction: Option<Correction>) -> Option<Self> {
        let deformation = self.correction().map(|_| PerssonDeformation::Elastic { correction })?;
        Some(PerssonLaw { deformation, ..*self })
    }

    /// Returns the theory for bodies in contact.
    ///
    /// # Errors
    /// [`HardnessError`] for a hardness beyond the range of magnitudes.
    pub fn model(&self, pair: &MaterialPair) -> Result<PerssonModel, HardnessError> {
        let contact_modulus_pa = pair.composite_modulus_pa();
        Ok(match &self.deformation {
            PerssonDeformation::Elastic { correction } => {
                PerssonModel::Elastic { contact_modulus_pa, correction: *correction }
            }
            PerssonDeformation::ElasticPlastic(plastic) => {
                PerssonModel::ElasticPlastic { contact_modulus_pa, hardness: plastic.hardness()? }
            }
        })
    }
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

    /// Returns the strength of the body that yields.
    #[must_use]
    pub fn strength(&self) -> NixGao {
        self.strength
    }

    /// Returns the hardness \[Pa\] at long wavelengths.
    #[must_use]
    pub fn hardness_pa(&self) -> f64 {
        self.hardness_pa
    }

    /// Returns the law of a hardness that grows without a strain gradient.
    #[must_use]
    pub fn growth(&self) -> Option<&GrowthLaw> {
        self.growth.as_ref()
    }

    /// Returns true if the hardness grows towards short wavelengths.
    #[must_use]
    pub fn grows(&self) -> bool {
        self.growth.is_some() || self.strength.strain_gradient_length_m().is_some()
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
    pub fn hardness(&self) -> Result<Hardness, HardnessError> {
        let hardness_pa = self.hardness_pa;
        let growth = match (&self.growth, self.strength.strain_gradient_length_m()) {
            (Some(GrowthLaw::Power(exponent)), _) => {
                HardnessGrowth::Power { hardness_pa, exponent: *exponent }
            }
            (Some(GrowthLaw::Table(table)), _) => HardnessGrowth::Table(table.clone()),
            (_, Some(length_m)) => HardnessGrowth::NixGao { hardness_pa, length_m },
            (_, None) => return Hardness::new(HardnessGrowth::Constant { hardness_pa }, None),
        };
        // The cap is one of the yield strength.
        let cap_pa = self.strength.cap_pa().map(|cap_pa| self.hardness_over_strength * cap_pa);
        Hardness::new(growth, cap_pa)
    }
}

/// A spectrum with the moments, of a normalisation, that it has from the second wavelength on, and the amplitudes of its
/// scales; without amplitudes no hardness can follow them. `beyond` are the samples \[m\], \[m^3\] that a cutoff has left out.
#[must_use]
pub(crate) fn roughness<'m>(
    psd: &ProfilePsd,
    moments: impl Iterator<Item = &'m Moments>,
    normalisation: Normalisation,
    scales: &[Scale],
    beyond: &[(f64, f64)],
    band: Band,
) -> Roughness {
    let parseval = Normalisation::Parseval.factor() / normalisation.factor();
    let moments = moments.map(|m| [m.m0_m2, m.m2, m.m4_per_m2].map(|moment| parseval * moment));
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
    Roughness::new(&samples, beyond, band)
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
        let constant = Hardness::new(HardnessGrowth::Constant { hardness_pa: 3e9 }, None).unwrap();
        assert_eq!(hardness(None, None), Ok(constant));
        let growth = HardnessGrowth::NixGao { hardness_pa: 3e9, length_m: 1e-6 };
        let growing = Hardness::new(growth, Some(6e9)).unwrap();
        assert_eq!(hardness(Some(1e-6), Some(GrowthLaw::NixGao)), Ok(growing));
        let missing = MaterialError::Missing(NeededFor::StrainGradient);
        assert_eq!(hardness(None, Some(GrowthLaw::NixGao)), Err(missing));
    }
}
