//! Examples and materials that the page offers before the core has loaded.

use serde::Serialize;
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
        let values = [
            Some(format!("E {}", material.youngs_modulus)),
            Some(format!("ν {}", material.poisson_ratio)),
            material.yield_strength.map(|value| format!("yield strength {value}")),
            material.indentation_hardness.map(|value| format!("hardness {value}")),
        ];
        Material {
            name: material.name,
            sources: material.sources,
            values: values.into_iter().flatten().collect::<Vec<_>>().join(" · "),
        }
    });
    let choices = Choices {
        program: concat!("truearea ", env!("CARGO_PKG_VERSION")),
        examples: EXAMPLES,
        materials: materials.collect(),
    };
    // All keys are text, so that it can be written.
    serde_json::to_string(&choices).unwrap_or_default()
}
