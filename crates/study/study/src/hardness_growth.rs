//! The hardness of a material as Persson's theory takes it: constant, or growing towards short wavelengths.

use persson::hardness_laws::{Hardness, HardnessError};

pub use crate::growth_law::GrowthLaw;
use crate::material::{Material, MaterialError};
use crate::model_options::ModelOptions;
use crate::persson_law::PlasticLaw;

/// Why a material has no such hardness.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum GrowthError {
    /// The material lacks something.
    #[error(transparent)]
    Material(#[from] MaterialError),
    /// The numbers make no hardness.
    #[error(transparent)]
    Hardness(#[from] HardnessError),
}

/// Returns the hardness of a material that grows by a law, up to the material's cap. Without a law it is constant and
/// has no cap.
///
/// # Errors
/// [`GrowthError`] if the material lacks a property that the law needs, or has it out of bounds.
pub fn hardness_of(material: &Material, law: Option<&GrowthLaw>) -> Result<Hardness, GrowthError> {
    let options = ModelOptions { hardness_law: law.cloned(), ..ModelOptions::default() };
    Ok(PlasticLaw::new(material, &options)?.hardness()?)
}

#[cfg(test)]
mod tests {
    use asperity::ElasticBody;

    use persson::hardness_laws::HardnessGrowth;

    use super::*;
    use crate::hardness_and_strength::HardnessAndStrength;
    use crate::material::{GivenMaterial, NeededFor};

    fn material(strain_gradient_length_m: Option<f64>) -> Material {
        Material::new(GivenMaterial {
            body: ElasticBody::new(463e9, 0.2).unwrap(),
            counterface: None,
            flows: crate::bodies::Body::Rough,
            hardness_and_strength: HardnessAndStrength::new(None, Some("1 GPa".parse().unwrap())).unwrap(),
            strength_cap: Some("2 GPa".parse().unwrap()),
            strain_gradient_length_m,
        })
    }

    #[test]
    fn a_hardness_that_grows_has_the_cap_of_the_strength_and_a_constant_one_has_none() {
        let constant = Hardness::new(HardnessGrowth::Constant { hardness_pa: 3e9 }, None).unwrap();
        assert_eq!(hardness_of(&material(None), None), Ok(constant));
        let growth = HardnessGrowth::NixGao { hardness_pa: 3e9, length_m: 1e-6 };
        let growing = Hardness::new(growth, Some(6e9)).unwrap();
        assert_eq!(hardness_of(&material(Some(1e-6)), Some(&GrowthLaw::NixGao)), Ok(growing));
        let missing = MaterialError::Missing(NeededFor::StrainGradient);
        assert_eq!(hardness_of(&material(None), Some(&GrowthLaw::NixGao)), Err(missing.into()));
    }
}
