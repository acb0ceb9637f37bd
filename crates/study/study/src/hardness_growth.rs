//! The hardness of a material as Persson's theory takes it: constant, or growing towards short wavelengths.

use persson::hardness_laws::{Hardness, HardnessError, HardnessGrowth, HardnessTable};
use serde::{Deserialize, Serialize};
use units::Bound;

use crate::hardness_and_strength::HARDNESS_OVER_STRENGTH;
use crate::material::{Material, MaterialError, NeededFor};

/// The law by which a hardness grows towards short wavelengths. In files it is `nix-gao`, `power:N`, or a list of pairs
/// of contact size \[m\] and hardness \[Pa\].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "NameOrRows", into = "NameOrRows")]
pub enum GrowthLaw {
    /// A power of the wavevector, with its exponent.
    Power(f64),
    /// Growth with the amplitudes of scales and the strain-gradient length of the material (Nix & Gao 1998).
    NixGao,
    /// A measured table.
    Table(HardnessTable),
}

#[derive(Serialize, Deserialize)]
#[serde(untagged)]
enum NameOrRows {
    Name(String),
    Rows(Vec<(f64, f64)>),
}

impl TryFrom<NameOrRows> for GrowthLaw {
    type Error = String;

    fn try_from(given: NameOrRows) -> Result<Self, String> {
        match given {
            NameOrRows::Name(name) => {
                GrowthLaw::named(&name)?.ok_or_else(|| format!("'{name}' is none of power:N, nix-gao"))
            }
            NameOrRows::Rows(rows) => {
                HardnessTable::new(rows).map(GrowthLaw::Table).map_err(|error| error.to_string())
            }
        }
    }
}

impl From<GrowthLaw> for NameOrRows {
    fn from(law: GrowthLaw) -> Self {
        match law {
            GrowthLaw::Power(exponent) => NameOrRows::Name(format!("power:{exponent}")),
            GrowthLaw::NixGao => NameOrRows::Name("nix-gao".to_owned()),
            GrowthLaw::Table(table) => NameOrRows::Rows(table.rows().to_vec()),
        }
    }
}

impl GrowthLaw {
    /// The law that a text names, `nix-gao` or `power:N`; `None` where it names neither.
    ///
    /// # Errors
    /// What is wrong with the exponent.
    pub fn named(text: &str) -> Result<Option<Self>, String> {
        let exponent = match text.split_once(':') {
            None if text == "nix-gao" => return Ok(Some(GrowthLaw::NixGao)),
            Some(("power", exponent)) => exponent,
            _ => return Ok(None),
        };
        let exponent = exponent.parse().map_err(|_| format!("'{exponent}' is not a number"))?;
        let checked = Bound::AtLeast(0.0).check("the exponent of the hardness", exponent);
        checked.map(|exponent| Some(GrowthLaw::Power(exponent))).map_err(|error| error.to_string())
    }
}

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

/// The hardness of a material that grows by a law, up to the material's cap; constant, and without a cap, where no law is
/// given.
///
/// # Errors
/// [`GrowthError`] where the material lacks what the law takes, or has it out of bounds.
pub fn hardness_of(material: &Material, law: Option<&GrowthLaw>) -> Result<Hardness, GrowthError> {
    let hardness_pa = || material.hardness_pa().ok_or(MaterialError::Missing(NeededFor::Yielding));
    let growth = match law {
        None => {
            return Ok(Hardness::new(HardnessGrowth::Constant { hardness_pa: hardness_pa()? }, None)?);
        }
        Some(GrowthLaw::NixGao) => {
            let length_m = material.strain_gradient_length_m();
            let length_m = length_m.ok_or(MaterialError::Missing(NeededFor::StrainGradient))?;
            HardnessGrowth::NixGao { hardness_pa: hardness_pa()?, length_m }
        }
        Some(GrowthLaw::Power(exponent)) => {
            HardnessGrowth::Power { hardness_pa: hardness_pa()?, exponent: *exponent }
        }
        Some(GrowthLaw::Table(table)) => HardnessGrowth::Table(table.clone()),
    };
    // The cap is one of the yield strength, a third of the hardness.
    let over_strength = match (material.hardness_pa(), material.yield_strength_pa()) {
        (Some(hardness_pa), Some(strength_pa)) => hardness_pa / strength_pa,
        _ => HARDNESS_OVER_STRENGTH,
    };
    let cap_pa = material.strength_cap_pa().map(|cap_pa| over_strength * cap_pa);
    Ok(Hardness::new(growth, cap_pa)?)
}

#[cfg(test)]
mod tests {
    use asperity::ElasticBody;

    use super::*;
    use crate::hardness_and_strength::HardnessAndStrength;
    use crate::material::GivenMaterial;

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
    fn laws_go_by_their_names() {
        assert_eq!(GrowthLaw::named("nix-gao"), Ok(Some(GrowthLaw::NixGao)));
        assert_eq!(GrowthLaw::named("power:0.5"), Ok(Some(GrowthLaw::Power(0.5))));
        assert_eq!(GrowthLaw::named("table:file.csv"), Ok(None));
        assert_eq!(GrowthLaw::named("power:x"), Err("'x' is not a number".to_owned()));
        let negative = GrowthLaw::named("power:-1").unwrap_err();
        assert_eq!(negative, "the exponent of the hardness is -1; it must be finite and at least 0");
    }

    #[test]
    fn laws_come_back_from_files_as_they_were() {
        let table = HardnessTable::new([(1e-6, 3e9), (1e-8, 9e9)]).unwrap();
        for law in [GrowthLaw::NixGao, GrowthLaw::Power(0.25), GrowthLaw::Table(table)] {
            let text = serde_json::to_string(&law).unwrap();
            assert_eq!(serde_json::from_str::<GrowthLaw>(&text).unwrap(), law, "{text}");
        }
        assert!(serde_json::from_str::<GrowthLaw>("\"power:-1\"").is_err());
        assert!(serde_json::from_str::<GrowthLaw>("[]").is_err());
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
