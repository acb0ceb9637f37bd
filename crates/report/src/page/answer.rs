//! The answer in plain words, and what cannot be answered.

use maud::{Markup, html};

use super::SceneReport;
use crate::answer_words;
use crate::summary::sampling;
use units::display::typeset;

pub(super) fn lead(scenes: &[SceneReport<'_>]) -> Markup {
    html! {
        section id="answer" {
            h2 { "The answer" }
            div.answers { @for scene in scenes { div { (of(scene, scenes.len() > 1)) } } }
        }
    }
}

fn of(report: &SceneReport<'_>, several: bool) -> Markup {
    let (scene, answer) = (report.scene, report.answer);
    let sentences = answer_words::sentences(answer, scene, report.results);
    let shortcomings = answer_words::shortcomings(answer, scene, report.results);
    html! {
        @if several { h3 { (report.label) } }
        p.spectrum { (sampling(report.results)) "." @for note in &scene.surface.notes { " " strong { (sentence(note)) } } }
        @if scene.needs.curves.is_empty() { p { "No contact was asked for: the scene has no curves." } }
        @for text in &sentences { p { (with_name_in_bold(text)) } }
        @for text in &shortcomings { p.shortcoming { strong { "Not answered. " } (typeset(text)) } }
        @for text in answer_words::disagreements(answer, scene) { p.disagreement { (typeset(&text)) } }
    }
}

/// `name: what it found`, the name in bold.
fn with_name_in_bold(text: &str) -> Markup {
    match text.split_once(": ") {
        Some((name, found)) => html! { strong.curve { (name) } ": " (typeset(found)) },
        None => html! { (typeset(text)) },
    }
}

/// A note as a sentence of its own.
pub(super) fn sentence(note: &str) -> String {
    let mut letters = note.chars();
    let first = letters.next().map(|first| first.to_uppercase().to_string()).unwrap_or_default();
    let end = if note.ends_with('.') { "" } else { "." };
    format!("{first}{}{end}", letters.as_str())
}
