//! The answer in words, and its limits.

use maud::{Markup, html};

use super::{SceneReport, Section};
use crate::answer_words;
use crate::scan_words;
use crate::summary::sampling;
use crate::verdict_words;
use units::display::typeset;

pub(super) fn section(scenes: &[SceneReport<'_>], figures: &Markup) -> Section {
    let body = html! {
        div.answers { @for scene in scenes { div { (of(scene, scenes.len() > 1)) } } }
        (figures)
    };
    Section { id: "answer", title: "The answer in words", body }
}

fn of(report: &SceneReport<'_>, several: bool) -> Markup {
    let (scene, answer) = (report.scene, report.answer);
    let sentences = answer_words::sentences(answer, scene, report.results);
    let shortcomings = answer_words::shortcomings(answer, scene, report.results);
    html! {
        @if several { h3 { (report.label) } }
        @for text in verdict_words::opening(report.conclusions, &report.evidence) { p.first { strong { (typeset(&text)) } } }
        p.spectrum { (sampling(report.results)) "." @for note in scan_words::foremost(&scene.surface) { " " strong { (sentence(&note)) } } }
        @if scene.needs.curves.is_empty() { p { "No contact was computed: the scene has no curves." } }
        @for text in &sentences { p { (with_name_in_bold(text)) } }
        @for text in &shortcomings { p.shortcoming { strong { (text.heading) ". " } (typeset(&text.reason)) } }
        @for text in answer_words::disagreements(answer, scene) { p.disagreement { (typeset(&text)) } }
    }
}

/// `name: text` with the name in bold.
fn with_name_in_bold(text: &str) -> Markup {
    match text.split_once(": ") {
        Some((name, found)) => html! { strong.curve { (name) } ": " (typeset(found)) },
        None => html! { (typeset(text)) },
    }
}

/// A note as a sentence; a name at its beginning keeps its spelling.
pub(super) fn sentence(note: &str) -> String {
    let end = if note.ends_with('.') { "" } else { "." };
    let first_word = note.split(' ').next().unwrap_or_default();
    let names_something = note.contains(": ") || !first_word.chars().all(char::is_alphabetic);
    let mut letters = note.chars();
    match letters.next().filter(|_| !names_something) {
        Some(first) => format!("{}{}{end}", first.to_uppercase(), letters.as_str()),
        None => format!("{note}{end}"),
    }
}

#[cfg(test)]
mod tests {
    use super::sentence;

    #[test]
    fn a_sentence_begins_with_a_capital_but_a_name_stays_as_it_is() {
        assert_eq!(sentence("this spectrum is a reconstruction"), "This spectrum is a reconstruction.");
        for named in
            ["map.001 has no unit", "trace: 3 rows left out", "my scan: 3 rows left out", "a/b.txt is short"]
        {
            assert_eq!(sentence(named), format!("{named}."));
        }
    }
}
