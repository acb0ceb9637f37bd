//! Surfaces that come with the page.

use questions::{BodyText, ReportQuestion, ReportSurface};
use scene::Template;
use serde::Serialize;

/// An example by its key, its title and the text of its scene.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Example {
    /// The key in a link.
    pub key: &'static str,
    /// The title in the list.
    pub title: &'static str,
}

/// The examples in the order of the list.
pub const EXAMPLES: [Example; 4] = [
    Example { key: "uncd-measured", title: "Diamond film, measured" },
    Example { key: "uncd-reconstructed", title: "Diamond film, reconstructed" },
    Example { key: "steel-on-steel", title: "Ground steel on ground steel" },
    Example { key: "gasket", title: "Rubber gasket on a steel flange" },
];

/// Two ground surfaces of bearing steel, known by their roughness parameters only.
const STEEL_ON_STEEL: &str = include_str!("../examples/steel-on-steel.toml");

/// Returns the scene of an example; `None` for an unknown key.
pub(crate) fn scene_text(key: &str) -> Option<String> {
    match key {
        "uncd-measured" => Some(diamond("Diamond film, measured", "builtin:uncd-measured")),
        "uncd-reconstructed" => Some(diamond("Diamond film, reconstructed", "builtin:uncd-reconstructed")),
        "steel-on-steel" => Some(STEEL_ON_STEEL.to_owned()),
        "gasket" => Some(Template::Gasket.text().to_owned()),
        _ => None,
    }
}

/// The report on a diamond film of the paper, pressed at 5.4 MPa.
fn diamond(title: &str, psd: &str) -> String {
    let question = ReportQuestion {
        title: Some(title.to_owned()),
        surface: ReportSurface::Psd(psd.to_owned()),
        material: BodyText {
            name: Some("diamond".to_owned()),
            yield_strength: Some("1.8 GPa".to_owned()),
            strain_gradient_length: Some("5 um".to_owned()),
            ..BodyText::default()
        },
        pressures: vec!["5.4 MPa".to_owned()],
        ..ReportQuestion::default()
    };
    question.scene_text()
}
