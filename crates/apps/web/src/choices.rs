//! Examples and materials that the page offers before the core has loaded.

use serde::Serialize;
use study::body_properties::BodyProperty;
use study::materials::materials;

use crate::example::{EXAMPLES, Example};

/// Returns examples, and materials with their sources, as JSON. The build writes it beside the page.
#[must_use]
pub fn choices() -> String {
    #[derive(Serialize)]
    struct Material {
        name: String,
        sources: String,
        values: String,
    }
    #[derive(Serialize)]
    struct Choices {
        program: &'static str,
        examples: [Example; 4],
        materials: Vec<Material>,
    }
    let materials = materials().into_iter().map(|material| {
        let words = [
            ("E", BodyProperty::YoungsModulus),
            ("ν", BodyProperty::PoissonRatio),
            ("yield strength", BodyProperty::YieldStrength),
            ("hardness", BodyProperty::IndentationHardness),
        ];
        let values = words.into_iter().filter_map(|(words, property)| {
            let value = material.value(property)?;
            Some(value.as_str().map_or_else(|| format!("{words} {value}"), |text| format!("{words} {text}")))
        });
        let values = values.collect::<Vec<_>>().join(" · ");
        Material { name: material.name, sources: material.sources, values }
    });
    let choices = Choices {
        program: concat!("truearea ", env!("CARGO_PKG_VERSION")),
        examples: EXAMPLES,
        materials: materials.collect(),
    };
    // All keys are text, so that it can be written.
    serde_json::to_string(&choices).unwrap_or_default()
}
