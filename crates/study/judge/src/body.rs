//! What a curve's body does under pressure, and so which elements it is held against.

use serde::Serialize;
use study::plan::CurveModel;

/// How a body yields.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Body {
    /// It never does.
    Elastic,
    /// It flows where the pressure reaches a hardness \[Pa\] that is the same at every scale.
    Hard {
        /// The hardness \[Pa\].
        hardness_pa: f64,
    },
    /// Its strength grows at small scales, of which a bound on the pressure knows nothing.
    Growing,
}

impl Body {
    /// That of a model.
    #[must_use]
    pub fn of(model: &CurveModel) -> Self {
        match model.hardness_pa() {
            None => Body::Elastic,
            Some(_) if model.strength_grows() => Body::Growing,
            Some(hardness_pa) => Body::Hard { hardness_pa },
        }
    }

    /// The pressure \[Pa\] that no point of elements exceeds; `None` where there is no such bound. A growing strength is
    /// held against elements only while it never matters.
    pub(crate) fn saturation_pa(self) -> Option<f64> {
        match self {
            Body::Hard { hardness_pa } => Some(hardness_pa),
            Body::Elastic | Body::Growing => None,
        }
    }
}
