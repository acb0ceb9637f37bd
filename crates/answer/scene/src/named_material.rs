//! The keys of a body, with missing keys filled from the table of materials if the scene names a material.

use std::ops::Range;

use serde_spanned::Spanned;

use super::error::{SceneError, SceneProblem};
use super::raw::{RawBody, RawProperty};
use study::bodies::FromTable;
use study::body_properties::BodyProperty;
use study::materials::{TabledMaterial, UnknownMaterial, named};

/// The keys of a body, as given or from the table.
pub(super) struct BodyKeys {
    /// Section of the keys.
    pub section: &'static str,
    /// Bytes of the scene that the section spans.
    pub span: Range<usize>,
    properties: Vec<(BodyProperty, Spanned<RawProperty>)>,
    /// Properties that were filled from the table of materials.
    pub from_table: Option<FromTable>,
}

impl BodyKeys {
    /// Returns the keys of a section, and those that it leaves to the table.
    pub fn new<const IS_COUNTERFACE: bool>(
        raw: &Spanned<RawBody<IS_COUNTERFACE>>,
    ) -> Result<Self, SceneError> {
        let RawBody { name, properties, layer, .. } = raw.get_ref();
        let section = if IS_COUNTERFACE { "counterface" } else { "material" };
        let keys = BodyKeys { section, span: raw.span(), properties: properties.clone(), from_table: None };
        keys.filled(name.as_ref(), layer.is_some())
    }

    /// Returns a property as given or from the table.
    pub fn get(&self, property: BodyProperty) -> Option<&Spanned<RawProperty>> {
        self.properties.iter().find(|(own, _)| *own == property).map(|(_, given)| given)
    }

    /// Returns true if hardness or strength is given; they give each other.
    pub fn has_strength(&self) -> bool {
        BodyProperty::STRENGTHS.into_iter().any(|property| self.get(property).is_some())
    }

    /// Returns the key of a property with its section.
    pub fn key(&self, property: BodyProperty) -> String {
        format!("{}.{}", self.section, property.key())
    }

    /// Fills missing keys from the table, if a material is named; under a layer without its strength, since the layer touches.
    fn filled(mut self, name: Option<&Spanned<String>>, is_base: bool) -> Result<Self, SceneError> {
        let Some(name) = name else { return Ok(self) };
        let tabled = tabled(name)?;
        // Hardness and strength give each other: one of them given leaves none of them out.
        let has_strength = self.has_strength() || is_base;
        let mut properties = Vec::new();
        for property in BodyProperty::ALL {
            let is_given =
                self.get(property).is_some() || has_strength && BodyProperty::STRENGTHS.contains(&property);
            if let Some(value) = tabled.value(property).filter(|_| !is_given) {
                properties.push(property);
                let uncertainty = tabled
                    .strength_uncertainty
                    .as_ref()
                    .filter(|_| BodyProperty::STRENGTHS.contains(&property));
                let value = match (value.as_str(), uncertainty) {
                    (Some(strength), Some(uncertainty)) => format!("{strength} +- {uncertainty}").into(),
                    _ => value.clone(),
                };
                let value = RawProperty::Other(value);
                self.properties.push((property, Spanned::new(name.span(), value)));
            }
        }
        self.from_table = Some(FromTable { name: tabled.name, properties, sources: tabled.sources });
        Ok(self)
    }
}

/// The material of the table that answers to a name.
fn tabled(name: &Spanned<String>) -> Result<TabledMaterial, SceneError> {
    named(name.get_ref()).map_err(|UnknownMaterial { name: value, known }| {
        // Several names are as likely as each other.
        let meant = if let [one] = &known[..] { Some(one.clone()) } else { None };
        SceneError::at(name.span(), SceneProblem::UnknownValue { value, known, meant })
    })
}
