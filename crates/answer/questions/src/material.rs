//! The material of a question.

use asperity::ElasticBody;
use serde::{Deserialize, Serialize};
use study::bodies::{Body, Softer};
use study::body_properties::BodyProperty;
use study::hardness_and_strength::HardnessAndStrength;
use study::material::{GivenMaterial, Material, MaterialError};
use study::materials::TabledMaterial;
use study::models::ModelOptions;
use units::{IndentationHardness, Modulus, Pressure, Remark, RemarkCode};

use crate::{LayerInput, QuestionError};

/// All properties of the rough body and its counterface. A model uses some of them.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct MaterialInput {
    /// Young's modulus \[Pa\]; every model needs it.
    pub youngs_modulus_pa: Option<f64>,
    /// Poisson's ratio, in (-1, 0.5\]; every model needs it.
    pub poisson_ratio: Option<f64>,
    /// Yield strength S0.
    pub yield_strength: Option<Pressure>,
    /// Indentation hardness H \[Pa\].
    pub indentation_hardness_pa: Option<f64>,
    /// Strain-gradient length h* \[m\].
    pub strain_gradient_length_m: Option<f64>,
    /// Upper limit of the depth-dependent yield strength.
    pub strength_cap: Option<Pressure>,
    /// The counterface; rigid if absent.
    pub counterface: Option<BodyInput>,
    /// Yield strength of the counterface, which is taken not to yield if it has neither strength nor hardness.
    pub counterface_yield_strength: Option<Pressure>,
    /// Indentation hardness of the counterface \[Pa\].
    pub counterface_indentation_hardness_pa: Option<f64>,
    /// A layer on the rough body; none if absent.
    pub layer: Option<LayerInput>,
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
    /// [`QuestionError::Value`] if a constant is out of bounds.
    pub fn body(self, option: &'static str) -> Result<ElasticBody, QuestionError> {
        ElasticBody::new(self.youngs_modulus_pa, self.poisson_ratio)
            .map_err(|error| QuestionError::Value { option, error })
    }
}

impl MaterialInput {
    /// Fills the properties that are not given from the table of materials. A strength that is given replaces the
    /// hardness of the table, and the reverse. Under a layer the rough body keeps neither: those would be the layer's.
    #[must_use]
    pub fn filled_from(self, rough: Option<&TabledMaterial>, counterface: Option<&TabledMaterial>) -> Self {
        let mut filled = self;
        let modulus_pa = |body: &TabledMaterial| -> Option<f64> {
            body.quantity(BodyProperty::YoungsModulus).map(|modulus: Modulus| modulus.pa)
        };
        let strength = |body: &TabledMaterial| {
            let hardness: Option<IndentationHardness> = body.quantity(BodyProperty::IndentationHardness);
            (body.quantity(BodyProperty::YieldStrength), hardness.map(|hardness| hardness.pa))
        };
        if let Some(rough) = rough {
            filled.youngs_modulus_pa = self.youngs_modulus_pa.or_else(|| modulus_pa(rough));
            filled.poisson_ratio = self.poisson_ratio.or_else(|| rough.poisson_ratio());
            let has_strength = self.yield_strength.is_some() || self.indentation_hardness_pa.is_some();
            if !has_strength && self.layer.is_none() {
                (filled.yield_strength, filled.indentation_hardness_pa) = strength(rough);
            }
        }
        if let Some(counterface) = counterface {
            let elastic = modulus_pa(counterface).zip(counterface.poisson_ratio());
            let elastic = elastic
                .map(|(youngs_modulus_pa, poisson_ratio)| BodyInput { youngs_modulus_pa, poisson_ratio });
            filled.counterface = self.counterface.or(elastic);
            if self.counterface_yield_strength.is_none() && self.counterface_indentation_hardness_pa.is_none()
            {
                (filled.counterface_yield_strength, filled.counterface_indentation_hardness_pa) =
                    strength(counterface);
            }
        }
        filled
    }

    /// The material of a question whose material is a value of its own, so that it has properties that models ignore: without
    /// those of a growing strength if nothing grows.
    #[must_use]
    pub fn used_with(self, options: &ModelOptions) -> Self {
        match options.strain_gradient || options.hardness_law.is_some() {
            true => self,
            false => MaterialInput { strain_gradient_length_m: None, strength_cap: None, ..self },
        }
    }

    /// The elastic constants of the rough body, if both are given.
    #[must_use]
    pub fn body(&self) -> Option<BodyInput> {
        Some(BodyInput { youngs_modulus_pa: self.youngs_modulus_pa?, poisson_ratio: self.poisson_ratio? })
    }

    /// The elastic counterface, if there is one.
    ///
    /// # Errors
    /// [`QuestionError::Value`] if a constant is out of bounds.
    pub fn counterface(&self) -> Result<Option<ElasticBody>, QuestionError> {
        self.counterface.map(|body| body.body("counterface_poisson_ratio")).transpose()
    }

    /// Hardness and strength of the rough body, which must agree if both are given.
    ///
    /// # Errors
    /// [`QuestionError::Material`] if H is not 3 S0 within 1 %.
    pub fn hardness_and_strength(&self) -> Result<HardnessAndStrength, QuestionError> {
        hardness_and_strength(self.indentation_hardness_pa, self.yield_strength)
    }

    /// Returns true if the counterface is the body that yields, as far as the properties say.
    ///
    /// # Errors
    /// [`QuestionError`] if a property is out of bounds.
    pub fn counterface_yields(&self) -> Result<bool, QuestionError> {
        let body = match &self.layer {
            Some(layer) => Some(layer.body()?),
            None => self.body().map(|body| body.body("poisson_ratio")).transpose()?,
        };
        let softer = body.map(|body| self.yielding(body)).transpose()?.and_then(|(softer, _)| softer);
        Ok(softer.is_some_and(|softer| softer.flows == Body::Counterface))
    }

    /// The body that yields, if the counterface has a strength, and the hardness and strength that count.
    fn yielding(&self, rough: ElasticBody) -> Result<(Option<Softer>, HardnessAndStrength), QuestionError> {
        let own = self.hardness_and_strength()?;
        let Some(counterface) = self.counterface()? else { return Ok((None, own)) };
        let other =
            hardness_and_strength(self.counterface_indentation_hardness_pa, self.counterface_yield_strength)?;
        let softer = Softer::between((&own, rough), (&other, counterface));
        let is_other = softer.is_some_and(|softer| softer.flows == Body::Counterface);
        Ok((softer, if is_other { other } else { own }))
    }

    /// The material of a contact that is computed for half-spaces alone.
    ///
    /// # Errors
    /// The errors of [`material`](Self::material), and [`QuestionError::Unused`] for a layer.
    pub(crate) fn of_half_spaces(&self, contact: &'static str) -> Result<Material, QuestionError> {
        match self.layer {
            None => self.material(),
            Some(_) => {
                let remark = Remark::new(RemarkCode::OfHalfSpaces).with("contact", contact);
                Err(Box::new(remark.on("layer_thickness")).into())
            }
        }
    }

    /// The material as models take it.
    ///
    /// # Errors
    /// [`QuestionError`] if an elastic constant is missing or a property is out of bounds.
    pub fn material(&self) -> Result<Material, QuestionError> {
        let layer =
            self.layer.map(|layer| layer.on(self.youngs_modulus_pa, self.poisson_ratio)).transpose()?;
        let body = layer.map_or_else(|| self.half_space(), |layer| Ok(layer.body()))?;
        let (softer, hardness_and_strength) = self.yielding(body)?;
        Ok(Material::new(GivenMaterial {
            layer,
            counterface: self.counterface()?,
            softer,
            hardness_and_strength,
            strength_cap: self.strength_cap,
            strain_gradient_length_m: self.strain_gradient_length_m,
            ..GivenMaterial::new(body)
        }))
    }

    /// The rough body as a half-space.
    fn half_space(&self) -> Result<ElasticBody, QuestionError> {
        let youngs_modulus_pa =
            self.youngs_modulus_pa.ok_or(QuestionError::ElasticConstant("youngs_modulus"))?;
        let poisson_ratio = self.poisson_ratio.ok_or(QuestionError::ElasticConstant("poisson_ratio"))?;
        BodyInput { youngs_modulus_pa, poisson_ratio }.body("poisson_ratio")
    }
}

fn hardness_and_strength(
    hardness_pa: Option<f64>,
    yield_strength: Option<Pressure>,
) -> Result<HardnessAndStrength, QuestionError> {
    let hardness = hardness_pa.map(|pa| IndentationHardness { pa });
    Ok(HardnessAndStrength::new(hardness, yield_strength).map_err(MaterialError::from)?)
}
