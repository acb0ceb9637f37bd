//! A short table of materials, which comes with the program.

use std::iter::once;

use serde::Deserialize;
use units::{IndentationHardness, Modulus, Pressure};

use crate::body_properties::BodyProperty;

/// A material of the table: properties as a scene types them, with their units.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TabledMaterial {
    /// Its name.
    pub name: String,
    /// Other names that it answers to.
    #[serde(default)]
    pub aliases: Vec<String>,
    /// Young's modulus.
    pub youngs_modulus: String,
    /// Poisson's ratio.
    pub poisson_ratio: f64,
    /// The yield strength, where that is what its source has.
    pub yield_strength: Option<String>,
    /// The indentation hardness, where that is what its source has.
    pub indentation_hardness: Option<String>,
    /// The thermal conductivity.
    pub thermal_conductivity: Option<String>,
    /// The electrical resistivity.
    pub resistivity: Option<String>,
    /// Its condition, and where each value comes from.
    pub sources: String,
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
#[error("no material is called '{name}'; did you mean {}?", .known.join(", "))]
pub struct UnknownMaterial {
    /// The name.
    pub name: String,
    /// The names that it may mean: the grades of a material, the names most alike, or else all.
    pub known: Vec<String>,
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
    pub fn value(&self, property: BodyProperty) -> Option<toml::Value> {
        let text = match property {
            BodyProperty::PoissonRatio => return Some(toml::Value::Float(self.poisson_ratio)),
            BodyProperty::YoungsModulus => Some(&self.youngs_modulus),
            BodyProperty::YieldStrength => self.yield_strength.as_ref(),
            BodyProperty::IndentationHardness => self.indentation_hardness.as_ref(),
            BodyProperty::ThermalConductivity => self.thermal_conductivity.as_ref(),
            BodyProperty::Resistivity => self.resistivity.as_ref(),
            BodyProperty::StrainGradientLength => None,
        };
        text.cloned().map(toml::Value::String)
    }

    /// Young's modulus \[Pa\].
    #[must_use]
    pub fn youngs_modulus_pa(&self) -> Option<f64> {
        self.youngs_modulus.parse().ok().map(|modulus: Modulus| modulus.pa)
    }

    /// Yield strength, where that is what the source has.
    #[must_use]
    pub fn own_yield_strength(&self) -> Option<Pressure> {
        self.yield_strength.as_ref()?.parse().ok()
    }

    /// Indentation hardness \[Pa\], where that is what the source has.
    #[must_use]
    pub fn indentation_hardness_pa(&self) -> Option<f64> {
        self.indentation_hardness.as_ref()?.parse().ok().map(|hardness: IndentationHardness| hardness.pa)
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
    use units::{Resistivity, ThermalConductivity};

    use super::*;

    #[test]
    fn every_row_has_values_within_bounds_a_source_and_names_of_its_own() {
        let table: Table = toml::from_str(data::MATERIALS).unwrap();
        assert!(table.material.len() >= 12);
        let mut names = HashSet::new();
        for row in &table.material {
            let modulus: Modulus = row.youngs_modulus.parse().unwrap();
            ElasticBody::new(modulus.pa, row.poisson_ratio).unwrap();
            let hardness =
                row.indentation_hardness.as_ref().map(|text| text.parse::<IndentationHardness>().unwrap());
            let strength = row.yield_strength.as_ref().map(|text| text.parse::<Pressure>().unwrap());
            // H is three times S0 in the models, which no two measured values are.
            assert!(hardness.is_none() || strength.is_none(), "{}", row.name);
            if let Some(conductivity) = &row.thermal_conductivity {
                conductivity.parse::<ThermalConductivity>().unwrap();
            }
            if let Some(resistivity) = &row.resistivity {
                resistivity.parse::<Resistivity>().unwrap();
            }
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
            let (Some(conductivity), Some(resistivity)) = (&row.thermal_conductivity, &row.resistivity)
            else {
                continue;
            };
            let conductivity: ThermalConductivity = conductivity.parse().unwrap();
            let resistivity: Resistivity = resistivity.parse().unwrap();
            let over_lorenz = conductivity.w_per_m_k * resistivity.ohm_m / 293.0 / LORENZ_W_OHM_PER_K2;
            assert!((0.8..1.6).contains(&over_lorenz), "{}: {over_lorenz}", row.name);
        }
    }
}
