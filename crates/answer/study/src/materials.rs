//! A short table of materials, which comes with the program.

use std::collections::BTreeMap;
use std::iter::once;
use std::str::FromStr;

use serde::Deserialize;

use crate::body_properties::BodyProperty;

/// A material of the table.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct TabledMaterial {
    /// Its name.
    pub name: String,
    /// Other names that it answers to.
    #[serde(default)]
    pub aliases: Vec<String>,
    /// Its condition, and where each value comes from.
    pub sources: String,
    /// The relative standard uncertainty of its hardness or strength, as a scene types it after `+-`.
    pub strength_uncertainty: Option<String>,
    /// Values as a scene types them, with their units, by the keys of [`BodyProperty`].
    #[serde(flatten)]
    values: BTreeMap<String, toml::Value>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    material: Vec<TabledMaterial>,
}

/// The materials in the order of the table; none where the program was built with a broken one.
#[must_use]
pub fn materials() -> Vec<TabledMaterial> {
    toml::from_str::<Table>(data::MATERIALS).map_or_else(|_| Vec::new(), |table| table.material)
}

/// Least similarity of names that are spelt alike, from 0 to 1.
const ALIKE: f64 = 0.88;

/// Words for materials that come in several grades, in lower case, and the part of their names in the table.
const GRADES: [(&str, &str); 14] = [
    ("steel", "steel"),
    ("stahl", "steel"),
    ("acier", "steel"),
    ("acciaio", "steel"),
    ("acero", "steel"),
    ("aluminium", "aluminium"),
    ("aluminum", "aluminium"),
    ("alu", "aluminium"),
    ("al", "aluminium"),
    ("copper", "copper"),
    ("kupfer", "copper"),
    ("cu", "copper"),
    ("cuivre", "copper"),
    ("gummi", "nbr"),
];

/// A name that no material of the table has.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("no material is called '{name}'; {}did you mean {}?", rigid(.name), .known.join(", "))]
pub struct UnknownMaterial {
    /// The name.
    pub name: String,
    /// The names that it may mean: the grades of a material, the names most alike, or else all.
    pub known: Vec<String>,
}

/// Says what to do in place of the name of a rigid body; empty for other names.
fn rigid(name: &str) -> &'static str {
    if name.eq_ignore_ascii_case("rigid") { "a rigid counterface is one left out; " } else { "" }
}

/// Finds the material that answers to a name.
///
/// # Errors
/// [`UnknownMaterial`] for other names, and for those of materials in several grades, whose strengths differ.
pub fn named(name: &str) -> Result<TabledMaterial, UnknownMaterial> {
    let table = materials();
    if let Some(found) = table.iter().find(|material| material.answers_to(name)) {
        return Ok(found.clone());
    }
    let word = name.trim().to_lowercase();
    let grade = GRADES.into_iter().find(|(known, _)| *known == word);
    let likeness = |material: &TabledMaterial| {
        let names = once(&material.name).chain(&material.aliases);
        let words = names.flat_map(|name| once(name.as_str()).chain(name.split(' ')));
        words.map(|known| strsim::jaro_winkler(&word, &known.to_lowercase())).fold(0.0, f64::max)
    };
    let closest = table.iter().map(likeness).fold(ALIKE, f64::max);
    let (meant, others): (Vec<_>, Vec<_>) = table.into_iter().partition(|material| match grade {
        Some((_, part)) => material.name.to_lowercase().contains(part),
        None => likeness(material) >= closest,
    });
    let known = if meant.is_empty() { others } else { meant };
    let known = known.into_iter().map(|material| material.name).collect();
    Err(UnknownMaterial { name: name.to_owned(), known })
}

impl TabledMaterial {
    /// Returns the value of a property as a scene types it, or nothing if the table lacks it.
    #[must_use]
    pub fn value(&self, property: BodyProperty) -> Option<&toml::Value> {
        self.values.get(property.key())
    }

    /// Returns a property with a unit, or nothing if the table lacks it.
    #[must_use]
    pub fn quantity<T: FromStr>(&self, property: BodyProperty) -> Option<T> {
        self.value(property)?.as_str()?.parse().ok()
    }

    /// Returns Poisson's ratio.
    #[must_use]
    pub fn poisson_ratio(&self) -> Option<f64> {
        self.value(BodyProperty::PoissonRatio)?.as_float()
    }

    /// Returns true if the material has this name or alias; case does not count.
    #[must_use]
    pub fn answers_to(&self, name: &str) -> bool {
        let wanted = name.trim().to_lowercase();
        once(&self.name).chain(&self.aliases).any(|known| known.to_lowercase() == wanted)
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use asperity::ElasticBody;
    use units::{IndentationHardness, Modulus, Pressure, Resistivity, ThermalConductivity};

    use super::*;

    #[test]
    fn every_row_has_values_within_bounds_a_source_and_names_of_its_own() {
        let table: Table = toml::from_str(data::MATERIALS).unwrap();
        assert!(table.material.len() >= 12);
        let mut names = HashSet::new();
        for row in &table.material {
            let keys = row.values.keys();
            assert!(keys.clone().all(|key| BodyProperty::of_key(key).is_some()), "{}", row.name);
            let modulus: Modulus = row.quantity(BodyProperty::YoungsModulus).unwrap();
            ElasticBody::new(modulus.pa, row.poisson_ratio().unwrap()).unwrap();
            let parsed = [
                row.quantity::<IndentationHardness>(BodyProperty::IndentationHardness).is_some(),
                row.quantity::<Pressure>(BodyProperty::YieldStrength).is_some(),
                row.quantity::<ThermalConductivity>(BodyProperty::ThermalConductivity).is_some(),
                row.quantity::<Resistivity>(BodyProperty::Resistivity).is_some(),
            ];
            // Besides the elastic constants.
            assert_eq!(
                parsed.iter().filter(|is_parsed| **is_parsed).count() + 2,
                keys.count(),
                "{}",
                row.name
            );
            // H is three times S0 in the models, which no two measured values are.
            assert!(!(parsed[0] && parsed[1]), "{}", row.name);
            assert!(row.sources.len() > 10, "{}", row.name);
            for name in once(&row.name).chain(&row.aliases) {
                assert!(names.insert(name.to_lowercase()), "{name} stands twice");
            }
        }
    }

    #[test]
    fn names_of_materials_in_several_grades_offer_their_grades() {
        let known = |name: &str| named(name).unwrap_err().known;
        for name in ["steel", "Stahl", " STEEL "] {
            assert_eq!(known(name), ["steel 100Cr6", "steel C45", "stainless steel 304"], "{name}");
        }
        assert_eq!(known("aluminum"), ["aluminium 6061-T6"]);
        assert_eq!(known("steeel"), known("steel"));
        assert_eq!(
            (known("diamnod"), known("steel C54")),
            (vec!["diamond".to_owned()], vec!["steel C45".to_owned()])
        );
        assert_eq!(known("unobtainium").len(), materials().len());
        assert_eq!(named("Messing").unwrap().name, "hard brass CuZn30");
    }

    /// Checks the table by the Lorenz number, which ties both conductivities of pure metals: a slip of a digit
    /// or a unit shows.
    #[test]
    fn the_conductivities_of_metals_obey_wiedemann_and_franz() {
        const LORENZ_W_OHM_PER_K2: f64 = 2.44e-8;
        for row in materials() {
            let conductivity = row.quantity::<ThermalConductivity>(BodyProperty::ThermalConductivity);
            let resistivity = row.quantity::<Resistivity>(BodyProperty::Resistivity);
            let (Some(conductivity), Some(resistivity)) = (conductivity, resistivity) else { continue };
            let over_lorenz = conductivity.w_per_m_k * resistivity.ohm_m / 293.0 / LORENZ_W_OHM_PER_K2;
            assert!((0.8..1.6).contains(&over_lorenz), "{}: {over_lorenz}", row.name);
        }
    }
}
