//! The laws by which a hardness grows towards short wavelengths, by name.

use persson::hardness_laws::HardnessTable;
use serde::{Deserialize, Serialize};
use tables::InputTable;
use units::Bound;

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
                GrowthLaw::named(&name)?.ok_or_else(|| format!("'{name}' is not one of power:N, nix-gao"))
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
    /// Reads the law of a table with the columns `contact_size_m` and `hardness_pa`.
    ///
    /// # Errors
    /// A message that says what is wrong with the table.
    pub fn from_table(table: &InputTable) -> Result<Self, String> {
        let columns = [("contact_size_m", Bound::Magnitude), ("hardness_pa", Bound::Magnitude)];
        let rows = table.numbers(columns).map_err(|error| error.to_string())?;
        let rows = rows.into_iter().map(|[size_m, hardness_pa]| (size_m, hardness_pa));
        HardnessTable::new(rows).map(GrowthLaw::Table).map_err(|error| error.to_string())
    }

    /// Parses `nix-gao` or `power:N`; returns `None` if the text names neither law.
    ///
    /// # Errors
    /// A message that says what is wrong with the exponent.
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

#[cfg(test)]
mod tests {
    use super::*;

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
}
