//! The yielding of a curve's body, which decides the elements that it is held against.

use serde::Serialize;
use study::plan::CurveModel;

/// The yielding of a body.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum BodyKind {
    /// The body never yields.
    Elastic,
    /// The body yields at a hardness that is the same at every scale.
    Hard {
        /// The hardness \[Pa\].
        hardness_pa: f64,
    },
    /// The strength grows at small scales, as that of the material.
    Growing,
    /// The hardness grows at small scales by a law of the model's own.
    GrowingByOwnLaw,
}

impl BodyKind {
    /// The body of a model.
    #[must_use]
    pub fn from_model(model: &CurveModel) -> Self {
        match model.hardness_pa() {
            None => BodyKind::Elastic,
            Some(_) if model.options().hardness_law.is_some() => BodyKind::GrowingByOwnLaw,
            Some(_) if model.strength_grows() => BodyKind::Growing,
            Some(hardness_pa) => BodyKind::Hard { hardness_pa },
        }
    }

    /// The elements that match the body where it yields. A hardness law of a model's own has none, so that the body is held
    /// against elastic elements, and only if it never yields.
    pub(crate) fn reference(self) -> Reference {
        match self {
            BodyKind::Elastic | BodyKind::GrowingByOwnLaw => Reference::Elastic,
            BodyKind::Hard { hardness_pa } => Reference::Yielding { hardness_pa },
            BodyKind::Growing => Reference::Growing,
        }
    }
}

/// The bodies that boundary elements press, for curves to be compared with.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "bodies")]
pub enum Reference {
    /// Bodies that never yield.
    Elastic,
    /// Bodies that flow at the hardness.
    Yielding {
        /// The hardness \[Pa\].
        hardness_pa: f64,
    },
    /// Bodies that flow at a hardness that grows at small scales: nothing is pressed for them, and their area has a range alone.
    Growing,
}

impl Reference {
    /// The name in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Reference::Elastic => "elastic",
            Reference::Yielding { .. } => "yielding",
            Reference::Growing => "growing",
        }
    }
}
