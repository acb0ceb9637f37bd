//! Persson's theory.

use ::persson::variance::Band;
use asperity::{MaterialPair, NixGao};

use super::{Choice, Framework, FrameworkFacts, ModelEntry, ModelOptions, MomentUse, Theory, TheoryLaw};
use crate::persson_law::{PerssonDeformation, PerssonLaw, PlasticLaw};

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
            gamma: (energy_factor != PerssonLaw::ENERGY_FACTOR).then_some(energy_factor),
            hardness_law: self.law.plastic().and_then(PlasticLaw::growth).cloned(),
            ..ModelOptions::default()
        }
    }
}
