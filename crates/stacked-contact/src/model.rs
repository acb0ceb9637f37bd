//! How one scale of the stack deforms.

use asperity::{MaterialPair, NixGao};

/// The law every scale follows (`docs/models.md`, section 4).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StackedModel {
    /// Elastic sinusoids (Johnson, Greenwood & Higginson 1985; Jackson & Streator 2006; section 2.3).
    Elastic {
        /// The bodies in contact.
        pair: MaterialPair,
    },
    /// Elastic-plastic sinusoids (Krithivasan & Jackson 2007; section 2.4). With a strain-gradient length the strength
    /// of a scale follows from how deep the scale above it was pressed.
    ElasticPlastic {
        /// The bodies in contact; the first one yields.
        pair: MaterialPair,
        /// The strength of that body.
        strength: NixGao,
    },
}
