//! Populations of asperities.

use asperity::{AsperityError, Hardness, MaterialPair, NixGao};
use stat_contact::{AsperityLaw, InterferenceLaw, NayakSummits, Population, StatisticalContact};

use super::{Choice, Framework, FrameworkFacts, ModelEntry, ModelOptions, MomentUse, Theory, TheoryLaw};
use crate::material::Material;

/// Properties of every population.
pub(super) static FACTS: FrameworkFacts = FrameworkFacts {
    name: "statistical",
    noun: "statistical model",
    moments: MomentUse::Chosen,
    takes_amplitude: false,
    has_states: true,
    has_gaps: true,
    takes_hardness: false,
};

/// The populations.
pub(super) const MODELS: &[ModelEntry] = &[
    ModelEntry {
        name: "hertz",
        short_name: "Spheres, elastic",
        full_name: "Greenwood-Williamson (Hertz)",
        citation: "Greenwood & Williamson (1966), Proc. R. Soc. A 295:300",
        framework: Framework::Statistical,
        choices: &[],
        takes_moments: false,
        build: |material, _| Ok(statistical(material, AsperityLaw::Hertz)),
    },
    ModelEntry {
        name: "ep-sphere",
        short_name: "Spheres, elastic-plastic",
        full_name: "GW, elastic-plastic spheres (Jackson-Green)",
        citation: "Jackson & Green (2005), J. Tribol. 127:343",
        framework: Framework::Statistical,
        choices: &[Choice::Strength, Choice::StrainGradient, Choice::Hardness],
        takes_moments: false,
        build: |material, options| {
            let strength = material.strength(options.strain_gradient)?;
            Ok(statistical(
                material,
                AsperityLaw::EpSphere { strength, hardness: options.hardness.unwrap_or_default() },
            ))
        },
    },
    ModelEntry {
        name: "elastic-sine",
        short_name: "Sinusoids, elastic",
        full_name: "GW, elastic sinusoids (Rostami-Jackson)",
        citation: "Johnson, Greenwood & Higginson (1985), Int. J. Mech. Sci. 27:383; Jackson & Streator (2006), Wear 261:1337",
        framework: Framework::Statistical,
        choices: &[Choice::Interference],
        takes_moments: false,
        build: |material, options| {
            let interference = options.interference_law.unwrap_or_default();
            Ok(statistical(material, AsperityLaw::ElasticSine { interference }))
        },
    },
    ModelEntry {
        name: "ep-sine",
        short_name: "Sinusoids, elastic-plastic",
        full_name: "GW, elastic-plastic sinusoids (Krithivasan-Jackson)",
        citation: "Krithivasan & Jackson (2007), Tribol. Lett. 27:31; Rostami & Jackson (2013), Proc. IMechE J 227:1376",
        framework: Framework::Statistical,
        choices: &[Choice::Strength, Choice::StrainGradient],
        takes_moments: false,
        build: |material, options| {
            let strength = material.strength(options.strain_gradient)?;
            Ok(statistical(material, AsperityLaw::EpSine { strength }))
        },
    },
    ModelEntry {
        name: "bgt",
        short_name: "Summits, elastic",
        full_name: "elastic summits of every curvature (Bush-Gibson-Thomas)",
        citation: "Bush, Gibson & Thomas (1975), Wear 35:87; Nayak (1971), J. Lubr. Technol. 93:398",
        framework: Framework::Statistical,
        choices: &[],
        takes_moments: true,
        build: |material, _| {
            Ok(Theory::Statistical(Statistical { pair: material.pair, law: StatisticalLaw::Summits }))
        },
    },
];

fn statistical(material: &Material, law: AsperityLaw) -> Theory {
    Theory::Statistical(Statistical { pair: material.pair, law: StatisticalLaw::Asperities(law) })
}

/// A statistical theory of bodies in contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Statistical {
    /// The bodies in contact.
    pub pair: MaterialPair,
    /// The law of what is pressed.
    pub law: StatisticalLaw,
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

impl Statistical {
    /// Returns the contact of a roughness: of the radius \[m\], density \[1/m^2\] and rms height \[m\] of asperities, or of
    /// the moments m0 \[m^2\], m2 and m4 \[1/m^2\] for the law of the summits.
    ///
    /// # Errors
    /// [`AsperityError`] for numbers that the law does not take.
    pub fn press(&self, [first, second, third]: [f64; 3]) -> Result<Pressable, AsperityError> {
        match &self.law {
            StatisticalLaw::Asperities(law) => {
                let population = Population::new(first, second, third)?;
                Ok(Pressable::Contact(StatisticalContact::new(&self.pair, &population, law)))
            }
            StatisticalLaw::Summits => match NayakSummits::new(first, second, third) {
                Ok(summits) => Ok(Pressable::Contact(StatisticalContact::from_summits(&self.pair, &summits))),
                Err(error) if error.bound == NayakSummits::ALPHA => {
                    Ok(Pressable::TooNarrow { alpha: error.value })
                }
                Err(error) => Err(error),
            },
        }
    }
}

/// The law by which a statistical model turns the moments of a cutoff into contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StatisticalLaw {
    /// Asperities of one curvature, McCool's, under a law.
    Asperities(AsperityLaw),
    /// The summits of the surface, of every curvature, elastic (Bush, Gibson & Thomas).
    Summits,
}

impl Statistical {
    /// Returns the law of one asperity, or nothing for the summits of a surface.
    fn asperities(&self) -> Option<AsperityLaw> {
        match self.law {
            StatisticalLaw::Asperities(law) => Some(law),
            StatisticalLaw::Summits => None,
        }
    }

    /// Returns the same bodies with another law of one asperity, or nothing for the summits of a surface.
    pub(super) fn with_law(&self, change: impl FnOnce(AsperityLaw) -> Option<AsperityLaw>) -> Option<Theory> {
        let law = StatisticalLaw::Asperities(change(self.asperities()?)?);
        Some(Theory::Statistical(Statistical { pair: self.pair, law }))
    }
}

impl TheoryLaw for Statistical {
    fn pair(&self) -> MaterialPair {
        self.pair
    }

    fn with_pair(&self, pair: MaterialPair) -> Theory {
        Theory::Statistical(Statistical { pair, law: self.law })
    }

    fn strength(&self) -> Option<NixGao> {
        self.asperities()?.strength()
    }

    fn with_strength(&self, strength: NixGao) -> Option<Theory> {
        self.with_law(|law| law.with_strength(strength))
    }

    fn options(&self) -> ModelOptions {
        let (hardness, interference_law) = match self.asperities() {
            Some(AsperityLaw::EpSphere { hardness, .. }) => (Some(hardness), None),
            Some(AsperityLaw::ElasticSine { interference }) => (None, Some(interference)),
            _ => (None, None),
        };
        ModelOptions {
            hardness: hardness.filter(|form| *form != Hardness::default()),
            interference_law: interference_law.filter(|law| *law != InterferenceLaw::default()),
            ..ModelOptions::default()
        }
    }
}
