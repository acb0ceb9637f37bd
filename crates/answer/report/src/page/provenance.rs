//! The provenance of the data, and the way to make the report again.

use maud::{Markup, html};

use super::{Report, SceneReport, Section, gists, per_scene, sentence};
use crate::run_stamp::RunStamp;
use crate::scan_words::sampling;
use units::SceneKeys;
use units::printable::shown_path;

pub(super) fn section(report: &Report<'_>) -> Section {
    let RunStamp { date, command } = report.run_stamp;
    let body = html! {
        p {
            "Made by truearea " (env!("CARGO_PKG_VERSION"))
            @if let Some(date) = date { " on " (date) }
            @if let Some(command) = command { " by " code { "truearea " (command) } }
            ". To make it again: " (report.repeat)
        }
        (per_scene(&report.scenes, |report| Some(of(report))).unwrap_or_default())
    };
    let gist = gists(&report.scenes, |scene| Some(scene.scene.surface.name.clone()));
    Section { id: "provenance", title: "Data and provenance", gist, body }
}

fn of(report: &SceneReport<'_>) -> Markup {
    let surface = &report.scene.surface;
    html! {
        p { "Spectrum: " code { (shown_path(&surface.name)) } ", " (sampling(report.results)) "." }
        @for source in &surface.sources {
            p { "SHA-256 of " code { (shown_path(&source.name)) } ": " code.hash { (source.sha256) } }
        }
        @if surface.roughness.is_some() { p { "It was made from roughness parameters." } }
        @else if surface.remarks.is_empty() { p { "Its file says nothing about where it comes from." } }
        @else {
            p { "Its file says:" }
            blockquote { @for remark in &surface.remarks { p { (with_links(remark)) } } }
        }
        @for note in &surface.notes { p { (sentence(&note.words(&SceneKeys))) } }
        p { "The scene, its files without folders:" }
        pre tabindex="0" { code { (surface.without_folders(report.scene.text.trim_end())) } }
    }
}

/// Text in which addresses and DOIs are links.
fn with_links(text: &str) -> Markup {
    html! {
        @for (place, word) in text.split(' ').enumerate() {
            @if place > 0 { " " }
            (linked(word))
        }
    }
}

fn linked(word: &str) -> Markup {
    let begin =
        ["https://", "http://", "doi:", "DOI:", "10."].iter().filter_map(|start| word.find(start)).min();
    let (before, rest) = word.split_at(begin.unwrap_or(word.len()));
    let kept = rest.trim_end_matches(['.', ',', ';', ':', ')', ']', '>', '"', '\'']);
    let (name, after) = rest.split_at(kept.len());
    match address(name) {
        Some(address) => html! { (before) a href=(address) { (name) } (after) },
        None => html! { (word) },
    }
}

fn address(name: &str) -> Option<String> {
    if name.starts_with("https://") || name.starts_with("http://") {
        return Some(name.to_owned());
    }
    let doi = name.trim_start_matches("doi:").trim_start_matches("DOI:");
    // A DOI has a registrant of four digits or more and something after the slash; 10.5/2 has not.
    let (registrant, item) = doi.strip_prefix("10.")?.split_once('/')?;
    let digits = registrant.chars().take_while(char::is_ascii_digit).count();
    (digits >= 4 && !item.is_empty()).then(|| format!("https://doi.org/{doi}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_and_dois_become_links() {
        let linked = with_links("(DOI 10.57703/ce-5cz7a). See https://example.org/a?b=1, and 10.5/2 <b>")
            .into_string();
        assert_eq!(
            linked,
            "(DOI <a href=\"https://doi.org/10.57703/ce-5cz7a\">10.57703/ce-5cz7a</a>). See \
             <a href=\"https://example.org/a?b=1\">https://example.org/a?b=1</a>, and 10.5/2 &lt;b&gt;"
        );
        assert!(with_links("doi:10.1000/x").into_string().contains("https://doi.org/10.1000/x"));
    }
}
