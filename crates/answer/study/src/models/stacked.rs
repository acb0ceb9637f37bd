//! Archard's stack of scales.

use asperity::{MaterialPair, NixGao};
use stacked_contact::StackedModel;

use super::{Choice, Framework, FrameworkFacts, ModelEntry, MomentUse, Theory, TheoryLaw};

/// Properties of every stack.
pub(super) static FACTS: FrameworkFacts = FrameworkFacts {
    name: "stacked",
    noun: "stacked model",
    moments: MomentUse::None,
    takes_amplitude: true,
    has_states: false,
    has_gaps: false,
    takes_hardness: false,
};

/// The stacks.
pub(super) const MODELS: &[ModelEntry] = &[
    ModelEntry {
        name: "elastic",
        short_name: "Stack, elastic",
        full_name: "Archard stack, elastic (Jackson-Streator)",
        citation: "Archard (1957), Proc. R. Soc. A 243:190; Jackson & Streator (2006), Wear 261:1337",
        framework: Framework::Stacked,
        choices: &[],
        takes_moments: false,
        build: |material, _| Ok(Theory::Stacked(StackedModel::Elastic { pair: material.pair })),
    },
    ModelEntry {
        name: "elastic-plastic",
        short_name: "Stack, elastic-plastic",
        full_name: "Archard stack, elastic-plastic (Jackson-Streator)",
        citation: "Archard (1957), Proc. R. Soc. A 243:190; Krithivasan & Jackson (2007), Tribol. Lett. 27:31",
        framework: Framework::Stacked,
        choices: &[Choice::Strength, Choice::StrainGradient],
        takes_moments: false,
        build: |material, options| {
            let strength = material.strength(options.strain_gradient)?;
            Ok(Theory::Stacked(StackedModel::ElasticPlastic { pair: material.pair, strength }))
        },
    },
];

impl TheoryLaw for StackedModel {
    fn pair(&self) -> MaterialPair {
        *StackedModel::pair(self)
    }

    fn with_pair(&self, pair: MaterialPair) -> Theory {
        Theory::Stacked(match *self {
            StackedModel::Elastic { .. } => StackedModel::Elastic { pair },
            StackedModel::ElasticPlastic { strength, .. } => StackedModel::ElasticPlastic { pair, strength },
        })
    }

    fn strength(&self) -> Option<NixGao> {
        StackedModel::strength(*self)
    }

    fn with_strength(&self, strength: NixGao) -> Option<Theory> {
        StackedModel::with_strength(*self, strength).map(Theory::Stacked)
    }

    fn needs_amplitudes(&self) -> bool {
        true
    }
}
