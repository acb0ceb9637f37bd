//! What a curve's body does under pressure, and so which elements it is held against.

use serde::Serialize;
use study::persson_law::PerssonLaw;
use study::plan::CurveModel;

/// Hardness over yield strength (Tabor 1951), where no indentation gave the hardness itself.
pub(crate) const HARDNESS_OVER_STRENGTH: f64 = 3.0;

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
        match model.strength() {
            None => Body::Elastic,
            Some(_) if model.strength_grows() => Body::Growing,
            Some(strength) => {
                Body::Hard { hardness_pa: hardness_over_strength(model) * strength.macroscopic_strength_pa() }
            }
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

/// The laws of asperities flow at three times their strength, Persson's theory at the hardness that it was given.
fn hardness_over_strength(model: &CurveModel) -> f64 {
    match model {
        CurveModel::Persson { law: PerssonLaw::ElasticPlastic { hardness_over_strength, .. }, .. } => {
            *hardness_over_strength
        }
        _ => HARDNESS_OVER_STRENGTH,
    }
}
