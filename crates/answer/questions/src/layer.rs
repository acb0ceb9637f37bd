//! The layer on the rough body of a question.

use asperity::{ElasticBody, Layer};
use serde::{Deserialize, Serialize};
use study::layer_base::LayerBase;
use units::{Remark, RemarkCode};

use crate::QuestionError;

/// An elastic layer bonded to the rough body, or to a rigid base in its place. It carries the roughness, and a hardness or a
/// strength of the rough body is then that of the layer.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct LayerInput {
    /// Thickness \[m\].
    pub thickness_m: Option<f64>,
    /// Young's modulus of the layer \[Pa\].
    pub youngs_modulus_pa: Option<f64>,
    /// Poisson's ratio of the layer, in \[0, 0.5\].
    pub poisson_ratio: Option<f64>,
    /// Base that the layer is bonded to.
    pub base: LayerBase,
}

impl LayerInput {
    /// Returns the layer if any part of it is given.
    #[must_use]
    pub fn given(self) -> Option<Self> {
        (self != LayerInput::default()).then_some(self)
    }

    /// The body that the layer consists of.
    ///
    /// # Errors
    /// [`QuestionError`] for a constant that is missing or out of bounds.
    pub(crate) fn body(&self) -> Result<ElasticBody, QuestionError> {
        let option = "layer_poisson_ratio";
        let youngs_modulus_pa =
            self.youngs_modulus_pa.ok_or_else(|| QuestionError::missing("layer_youngs_modulus"))?;
        let poisson_ratio = self.poisson_ratio.ok_or_else(|| QuestionError::missing(option))?;
        Layer::POISSON_RATIO
            .check("Poisson's ratio of the layer", poisson_ratio)
            .map_err(|error| QuestionError::Value { option, error })?;
        ElasticBody::new(youngs_modulus_pa, poisson_ratio)
            .map_err(|error| QuestionError::Value { option: "layer_youngs_modulus", error })
    }

    /// The layer on its base: the rough body with Young's modulus \[Pa\] and Poisson's ratio, as far as given, or a rigid one.
    ///
    /// # Errors
    /// [`QuestionError`] for what is missing or out of bounds, and for elastic constants of a rigid base.
    pub(crate) fn on(
        &self,
        youngs_modulus_pa: Option<f64>,
        poisson_ratio: Option<f64>,
    ) -> Result<Layer, QuestionError> {
        let option = "layer_thickness";
        let thickness_m = self.thickness_m.ok_or_else(|| QuestionError::missing(option))?;
        let body = self.body()?;
        let base = match self.base {
            LayerBase::Rigid if youngs_modulus_pa.is_some() => {
                return Err(Box::new(Remark::new(RemarkCode::RigidBase).on("youngs_modulus")).into());
            }
            LayerBase::Rigid if poisson_ratio.is_some() => {
                return Err(Box::new(Remark::new(RemarkCode::RigidBase).on("poisson_ratio")).into());
            }
            LayerBase::Rigid => None,
            LayerBase::Material => {
                let needed = QuestionError::Missing(vec!["youngs_modulus", "layer_base"]);
                let youngs_modulus_pa = youngs_modulus_pa.ok_or(needed)?;
                let poisson_ratio = poisson_ratio.ok_or(QuestionError::ElasticConstant("poisson_ratio"))?;
                let body = ElasticBody::new(youngs_modulus_pa, poisson_ratio);
                Some(body.map_err(|error| QuestionError::Value { option: "poisson_ratio", error })?)
            }
        };
        Layer::new(body, thickness_m, base).map_err(|error| QuestionError::Value { option, error })
    }
}
