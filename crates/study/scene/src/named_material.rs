//! The keys of a body, with missing keys filled from the table of materials if the scene names a material.

use std::ops::Range;

use serde_spanned::Spanned;

use super::error::{SceneError, SceneProblem};
use super::raw::{RawCounterface, RawMaterial, RawProperty, RawQuantity};
use super::spelling::meant;
use study::bodies::FromTable;
use study::materials::{TabledMaterial, UnknownMaterial, materials, named};

/// The keys of a body, as given or from the table.
pub(super) struct BodyKeys {
    /// Section of the keys.
    pub section: &'static str,
    /// Bytes of the scene that the section spans.
    pub span: Range<usize>,
    pub youngs_modulus: Option<Spanned<RawProperty>>,
    pub poisson_ratio: Option<Spanned<RawProperty>>,
    pub yield_strength: Option<Spanned<RawProperty>>,
    pub indentation_hardness: Option<Spanned<RawProperty>>,
    pub strain_gradient_length: Option<Spanned<RawProperty>>,
    pub thermal_conductivity: Option<RawQuantity>,
    pub resistivity: Option<RawQuantity>,
    /// Properties that were filled from the table of materials.
    pub from_table: Option<FromTable>,
}

impl BodyKeys {
    /// Returns the keys of the rough body.
    pub fn of_material(raw: &Spanned<RawMaterial>) -> Result<Self, SceneError> {
        let keys = raw.get_ref().clone();
        BodyKeys {
            section: "material",
            span: raw.span(),
            youngs_modulus: keys.youngs_modulus,
            poisson_ratio: keys.poisson_ratio,
            yield_strength: keys.yield_strength,
            indentation_hardness: keys.indentation_hardness,
            strain_gradient_length: keys.strain_gradient_length,
            thermal_conductivity: keys.thermal_conductivity,
            resistivity: keys.resistivity,
            from_table: None,
        }
        .filled(keys.name.as_ref())
    }

    /// Returns the keys of the counterface.
    pub fn of_counterface(raw: &Spanned<RawCounterface>) -> Result<Self, SceneError> {
        let keys = raw.get_ref();
        BodyKeys {
            section: "counterface",
            span: raw.span(),
            youngs_modulus: keys.youngs_modulus.clone(),
            poisson_ratio: keys.poisson_ratio.clone(),
            yield_strength: keys.yield_strength.clone(),
            indentation_hardness: keys.indentation_hardness.clone(),
            strain_gradient_length: keys.strain_gradient_length.clone(),
            thermal_conductivity: keys.thermal_conductivity.clone(),
            resistivity: keys.resistivity.clone(),
            from_table: None,
        }
        .filled(keys.name.as_ref())
    }

    /// The key of this body under a name, with its section.
    pub fn key(&self, name: &str) -> String {
        format!("{}.{name}", self.section)
    }

    /// Fills missing keys from the table, if a material is named.
    fn filled(mut self, name: Option<&Spanned<String>>) -> Result<Self, SceneError> {
        let Some(name) = name else { return Ok(self) };
        let TabledMaterial {
            name: known_as,
            aliases: _,
            youngs_modulus,
            poisson_ratio,
            yield_strength,
            indentation_hardness,
            thermal_conductivity,
            resistivity,
            sources,
        } = tabled(name)?;
        let span = name.span();
        // Hardness and strength give each other: one of them given leaves none of them out.
        let has_strength = self.yield_strength.is_some() || self.indentation_hardness.is_some();
        let of_table = |text: Option<String>| text.filter(|_| !has_strength).map(toml::Value::String);
        let mut keys = Vec::new();
        let mut fill =
            |key: &'static str, given: &mut Option<Spanned<RawProperty>>, value: Option<toml::Value>| {
                if let (None, Some(value)) = (&given, value) {
                    keys.push(key);
                    *given = Some(Spanned::new(span.clone(), RawProperty::Value(value)));
                }
            };
        fill("youngs_modulus", &mut self.youngs_modulus, Some(toml::Value::String(youngs_modulus)));
        fill("poisson_ratio", &mut self.poisson_ratio, Some(toml::Value::Float(poisson_ratio)));
        fill("yield_strength", &mut self.yield_strength, of_table(yield_strength));
        fill("indentation_hardness", &mut self.indentation_hardness, of_table(indentation_hardness));
        let mut fill = |key: &'static str, given: &mut Option<RawQuantity>, text: Option<String>| {
            if let (None, Some(text)) = (&given, text) {
                keys.push(key);
                *given = Some(Spanned::new(span.clone(), toml::Value::String(text)));
            }
        };
        fill("thermal_conductivity", &mut self.thermal_conductivity, thermal_conductivity);
        fill("resistivity", &mut self.resistivity, resistivity);
        self.from_table = Some(FromTable { name: known_as, keys, sources });
        Ok(self)
    }
}

/// The material of the table that answers to a name.
fn tabled(name: &Spanned<String>) -> Result<TabledMaterial, SceneError> {
    named(name.get_ref()).map_err(|UnknownMaterial { name: value, known }| {
        let table = materials();
        let names =
            table.iter().flat_map(|material| std::iter::once(&material.name).chain(&material.aliases));
        // Grades of one material are as likely as each other.
        let is_open = known.len() == table.len();
        let meant = is_open.then(|| meant(&value, names.map(String::as_str))).flatten().map(str::to_owned);
        SceneError::at(name.span(), SceneProblem::UnknownValue { value, known, meant })
    })
}
