//! Everything behind the answer: verdicts, numbers, figures, choices, data and provenance, each folded.

use maud::html;
use units::display::counted;

use super::{
    Report, Section, choices, disagreements, figures, gists, key_numbers, meaning, provenance, sensitivities,
    validity, verdict,
};

pub(super) fn section(report: &Report<'_>) -> Section {
    let scenes = &report.scenes;
    let parts = [
        verdict::section(scenes),
        key_numbers::section(scenes),
        disagreements::section(scenes),
        meaning::section(scenes),
        figures::section(scenes),
        sensitivities::section(scenes),
        validity::section(scenes),
        choices::section(scenes),
        Some(provenance::section(report)),
    ];
    let gist = gists(scenes, |scene| {
        let needs = &scene.scene.needs;
        let models = counted(needs.curves.len(), "model");
        Some(format!("{models} × {} · scene · SHA-256", counted(needs.loads.len(), "load")))
    });
    let body = html! { @for part in parts.iter().flatten() { (part.folded(true)) } };
    Section { id: "all-numbers", title: "All numbers, choices, data and provenance", gist, body }
}
