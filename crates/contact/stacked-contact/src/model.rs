//! Deformation law of the scales of a stack.

use asperity::{MaterialPair, NixGao};
use units::named;

/// Law that every scale follows (`docs/theory/models.md`, section 4).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StackedModel {
    /// Elastic sinusoids (Johnson, Greenwood & Higginson 1985; Jackson & Streator 2006; section 2.3).
    Elastic {
        /// The bodies in contact.
        pair: MaterialPair,
    },
    /// Elastic-plastic sinusoids (Krithivasan & Jackson 2007; section 2.4). With a strain-gradient length the
    /// strength of a scale follows from the depth to which the scale above it was pressed.
    ElasticPlastic {
        /// The bodies in contact; the first one yields.
        pair: MaterialPair,
        /// Strength of that body.
        strength: NixGao,
        /// Area of a scale that yields.
        area: YieldingAreaLaw,
    },
}

/// Area fraction of a scale that yields, over its pressure; the published sources leave it open
/// (`docs/theory/models.md`, section 2.4).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum YieldingAreaLaw {
    /// The plastic power law blended into the limit of complete contact, and limited to 1.
    #[default]
    Blended,
    /// The elastic area at p/p*_ep, which reaches 1 at p*_ep and not before.
    ElasticShape,
}

named!(YieldingAreaLaw, "area law", {
    Blended => "blended",
    ElasticShape => "elastic-shape",
});

impl StackedModel {
    /// The bodies in contact.
    #[must_use]
    pub fn pair(&self) -> &MaterialPair {
        match self {
            StackedModel::Elastic { pair } | StackedModel::ElasticPlastic { pair, .. } => pair,
        }
    }

    /// Strength of the rough body, if it yields.
    #[must_use]
    pub fn strength(mut self) -> Option<NixGao> {
        self.strength_mut().copied()
    }

    /// Returns this model with another strength; `None` if it never yields.
    #[must_use]
    pub fn with_strength(mut self, strength: NixGao) -> Option<Self> {
        *self.strength_mut()? = strength;
        Some(self)
    }

    fn strength_mut(&mut self) -> Option<&mut NixGao> {
        match self {
            StackedModel::Elastic { .. } => None,
            StackedModel::ElasticPlastic { strength, .. } => Some(strength),
        }
    }
}
