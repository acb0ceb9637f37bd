//! The material as given: what a model needs of it is drawn, and missed, only when the model asks.

use asperity::{ElasticBody, MaterialPair, NixGao};
use stacked_contact::StackedModel;

use crate::quantity::Pressure;

/// The bodies and the strength, in SI units, each checked where it is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// The rough body and its counterface.
    pub pair: MaterialPair,
    /// The strength S0 \[Pa\] and the cap of its growth; not needed by elastic models.
    pub strength: Option<NixGao>,
    /// h* \[m\]; needed by models with a strain gradient.
    pub strain_gradient_length_m: Option<f64>,
}

/// What a material is made from, as given.
#[derive(Debug, Clone, Copy)]
pub struct GivenMaterial {
    /// The rough body.
    pub body: ElasticBody,
    /// What presses on it; rigid where absent.
    pub counterface: Option<ElasticBody>,
    /// Its yield strength S0.
    pub yield_strength: Option<Pressure>,
    /// The cap of its growth.
    pub strength_cap: Option<Pressure>,
    /// h* \[m\].
    pub strain_gradient_length_m: Option<f64>,
}

/// Which of the stacked models, as typed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum StackedModelName {
    /// Sinusoids that only deform elastically.
    Elastic,
    /// Sinusoids that yield.
    ElasticPlastic,
}

/// Something a model needs and the material lacks.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MaterialError {
    /// A property outside its bounds.
    #[error(transparent)]
    Bound(#[from] asperity::AsperityError),
    /// A strength given as a multiple of itself.
    #[error(
        "the yield strength cannot be given in H, which is three times the yield strength; give it in GPa or MPa"
    )]
    StrengthInHardnesses,
    /// A pressure in units of a hardness that is not known.
    #[error("a pressure in H, three times the yield strength, needs the yield strength")]
    NoHardness,
    /// An elastic-plastic model without a strength.
    #[error(
        "the elastic-plastic model needs the yield strength: give --yield-strength, or yield_strength in [material]"
    )]
    NoStrength,
    /// A strain gradient without its length.
    #[error(
        "the strain-gradient strength needs its length: give --strain-gradient-length, or strain_gradient_length in [material]"
    )]
    NoStrainGradientLength,
}

impl Material {
    /// The material in SI units.
    ///
    /// # Errors
    /// [`MaterialError`] for what is out of bounds, and for quantities in H without a strength.
    pub fn new(given: GivenMaterial) -> Result<Self, MaterialError> {
        let pair = match given.counterface {
            Some(counterface) => MaterialPair::against(given.body, counterface),
            None => MaterialPair::against_rigid(given.body),
        };
        let strength = match given.yield_strength {
            Some(strength) => Some(capped_strength(strength, given.strength_cap)?),
            None => None,
        };
        Ok(Material { pair, strength, strain_gradient_length_m: given.strain_gradient_length_m })
    }

    /// The hardness H = 3 S0 \[Pa\], where there is a strength.
    pub fn hardness_pa(&self) -> Option<f64> {
        self.strength.as_ref().map(hardness_pa)
    }

    /// A pressure \[Pa\], in units of the hardness or not.
    ///
    /// # Errors
    /// [`MaterialError::NoHardness`].
    pub fn pascals(&self, pressure: Pressure) -> Result<f64, MaterialError> {
        pressure.pascals(self.hardness_pa()).ok_or(MaterialError::NoHardness)
    }

    /// The stacked model of this name for this material.
    ///
    /// # Errors
    /// [`MaterialError`] where the model needs what the material lacks.
    pub fn stacked(
        &self,
        name: StackedModelName,
        strain_gradient: bool,
    ) -> Result<StackedModel, MaterialError> {
        match name {
            StackedModelName::Elastic => Ok(StackedModel::Elastic { pair: self.pair }),
            StackedModelName::ElasticPlastic => {
                let constant = self.strength.ok_or(MaterialError::NoStrength)?;
                let strength = if strain_gradient {
                    let length_m =
                        self.strain_gradient_length_m.ok_or(MaterialError::NoStrainGradientLength)?;
                    constant.with_strain_gradient(length_m)?
                } else {
                    constant
                };
                Ok(StackedModel::ElasticPlastic { pair: self.pair, strength })
            }
        }
    }
}

fn capped_strength(strength: Pressure, cap: Option<Pressure>) -> Result<NixGao, MaterialError> {
    let constant = NixGao::constant(strength.pascals(None).ok_or(MaterialError::StrengthInHardnesses)?)?;
    let Some(cap) = cap else { return Ok(constant) };
    let cap_pa = cap.pascals(Some(hardness_pa(&constant))).ok_or(MaterialError::NoHardness)?;
    Ok(constant.with_cap(cap_pa)?)
}

fn hardness_pa(strength: &NixGao) -> f64 {
    3.0 * strength.macroscopic_strength_pa()
}
