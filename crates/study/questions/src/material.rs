//! The material of a question.

use asperity::ElasticBody;
use serde::{Deserialize, Serialize};
use study::hardness_and_strength::HardnessAndStrength;
use study::material::{GivenMaterial, Material, MaterialError};
use study::models::{Choice, ModelEntry, ModelOptions};
use units::{IndentationHardness, Pressure};

use crate::text::optional_pressure;
use crate::{OptionName, QuestionError};

/// All properties of the rough body and its counterface. A model uses some of them.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct MaterialInput {
    /// Young's modulus \[Pa\]; every model needs it.
    pub youngs_modulus_pa: Option<f64>,
    /// Poisson's ratio, in (-1, 0.5\]; every model needs it.
    pub poisson_ratio: Option<f64>,
    /// Yield strength S0.
    #[serde(with = "optional_pressure")]
    pub yield_strength: Option<Pressure>,
    /// Indentation hardness H \[Pa\].
    pub indentation_hardness_pa: Option<f64>,
    /// Strain-gradient length h* \[m\].
    pub strain_gradient_length_m: Option<f64>,
    /// Upper limit of the depth-dependent yield strength.
    #[serde(with = "optional_pressure")]
    pub strength_cap: Option<Pressure>,
    /// The counterface; rigid if absent.
    pub counterface: Option<BodyInput>,
}

/// Elastic constants of a body.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BodyInput {
    /// Young's modulus \[Pa\].
    pub youngs_modulus_pa: f64,
    /// Poisson's ratio.
    pub poisson_ratio: f64,
}

impl BodyInput {
    /// The elastic body; `option` is the one that gives its Poisson's ratio.
    ///
    /// # Errors
    /// [`QuestionError::Body`] if a constant is out of bounds.
    pub fn body(self, option: OptionName) -> Result<ElasticBody, QuestionError> {
        ElasticBody::new(self.youngs_modulus_pa, self.poisson_ratio)
            .map_err(|error| QuestionError::Body { option, error })
    }
}

impl MaterialInput {
    /// The material of a question whose material is a value of its own, so that it has properties that models ignore: without
    /// those of a growing strength if nothing grows.
    #[must_use]
    pub fn used_with(self, options: &ModelOptions) -> Self {
        match options.strain_gradient || options.hardness_law.is_some() {
            true => self,
            false => MaterialInput { strain_gradient_length_m: None, strength_cap: None, ..self },
        }
    }

    /// True if the strength of a model grows as soon as the material has the length for it.
    #[must_use]
    pub fn strain_gradient_in(&self, entry: &ModelEntry) -> bool {
        self.strain_gradient_length_m.is_some() && entry.has(Choice::StrainGradient)
    }

    /// The elastic constants of the rough body, if both are given.
    #[must_use]
    pub fn body(&self) -> Option<BodyInput> {
        Some(BodyInput { youngs_modulus_pa: self.youngs_modulus_pa?, poisson_ratio: self.poisson_ratio? })
    }

    /// The elastic counterface, if there is one.
    ///
    /// # Errors
    /// [`QuestionError::Body`] if a constant is out of bounds.
    pub fn counterface(&self) -> Result<Option<ElasticBody>, QuestionError> {
        self.counterface.map(|body| body.body(OptionName::CounterfacePoissonRatio)).transpose()
    }

    /// Hardness and strength, which must agree if both are given.
    ///
    /// # Errors
    /// [`QuestionError::Material`] if H is not 3 S0 within 1 %.
    pub fn hardness_and_strength(&self) -> Result<HardnessAndStrength, QuestionError> {
        let hardness = self.indentation_hardness_pa.map(|pa| IndentationHardness { pa });
        Ok(HardnessAndStrength::new(hardness, self.yield_strength).map_err(MaterialError::from)?)
    }

    /// The material as models take it.
    ///
    /// # Errors
    /// [`QuestionError`] if an elastic constant is missing or a property is out of bounds.
    pub fn material(&self) -> Result<Material, QuestionError> {
        let youngs_modulus_pa =
            self.youngs_modulus_pa.ok_or(QuestionError::ElasticConstant(OptionName::YoungsModulus))?;
        let poisson_ratio =
            self.poisson_ratio.ok_or(QuestionError::ElasticConstant(OptionName::PoissonRatio))?;
        let body = BodyInput { youngs_modulus_pa, poisson_ratio }.body(OptionName::PoissonRatio)?;
        Ok(Material::new(GivenMaterial {
            counterface: self.counterface()?,
            hardness_and_strength: self.hardness_and_strength()?,
            strength_cap: self.strength_cap,
            strain_gradient_length_m: self.strain_gradient_length_m,
            ..GivenMaterial::new(body)
        }))
    }
}
