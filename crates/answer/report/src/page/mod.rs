//! The report: one page that opens with the answer, holds everything behind it, and needs no network.
//!
//! It describes one scene, or several that differ in their spectra, side by side. A section has a file, and each makes
//! its part from a [`SceneReport`] alone.

mod all_numbers;
mod area_curve;
mod cards;
mod choices;
mod contact_picture;
#[cfg(test)]
mod contrast;
mod decades;
mod disagreements;
mod figures;
mod first_screen;
mod how_sure;
mod key_numbers;
mod live;
mod meaning;
mod measure_next;
mod pressed_map;
mod provenance;
mod range_bar;
mod reading;
mod sensitivities;
mod spectrum_curve;
mod surfaces;
mod validity;
mod verdict;

pub use live::{LiveModel, LiveScreen};
pub use pressed_map::PressedMap;
pub use reading::{Reading, ReadingLine};
pub use spectrum_curve::SpectrumCurve;

use maud::{DOCTYPE, Markup, PreEscaped, html};

use crate::curve_names::{in_full, short_name};
use crate::listing::capital;
use crate::run_stamp::RunStamp;
use conclusions::{AnswerUnderLoad, Conclusions, Evidence};
use findings::answer::{LoadAnswer, SceneAnswer};
use findings::sensitivity::Sensitivity;
use scene::Scene;
use study::figure::FigureData;
use study::plan::Results;
use units::display::{load_in_full, pressure, typeset, typeset_digits};
use units::printable::printable;

/// The part of a report on one scene.
pub struct SceneReport<'a> {
    /// The label that distinguishes the scene, e.g. `measured`; not shown for a single scene.
    pub label: &'a str,
    /// The scene.
    pub scene: &'a Scene,
    /// Its results.
    pub results: &'a Results,
    /// Its answer.
    pub answer: &'a SceneAnswer,
    /// Everything found about it.
    pub evidence: Evidence<'a>,
    /// The conclusions.
    pub conclusions: &'a Conclusions,
    /// The sensitivities of its areas to modelling choices.
    pub sensitivities: &'a [Sensitivity],
    /// Its figures. The first one shows the answer, if it is one of area against cutoff.
    pub figures: Vec<FigureData>,
}

/// A report.
pub struct Report<'a> {
    /// The title.
    pub title: &'a str,
    /// The scenes, at least one.
    pub scenes: Vec<SceneReport<'a>>,
    /// A part of the caller's own, before the scenes.
    pub opening: Option<Markup>,
    /// The way to make the report again, e.g. a command.
    pub repeat: &'a str,
    /// Date and command of the run.
    pub run_stamp: &'a RunStamp,
}

/// A section of the page, folded below its heading.
struct Section {
    /// The id of its element, unique in the page.
    id: &'static str,
    /// The title.
    title: &'static str,
    /// The section in a few words, beside the title.
    gist: String,
    /// The content below the title.
    body: Markup,
}

impl Section {
    /// The section under a heading of the page, or of another section.
    fn folded(&self, is_inner: bool) -> Markup {
        html! {
            details.folded id=(self.id) {
                summary {
                    @if is_inner { h3 { (self.title) } } @else { h2 { (self.title) } }
                    @if !self.gist.is_empty() { " " span { (typeset(&self.gist)) } }
                }
                (self.body)
            }
        }
    }
}

impl Report<'_> {
    /// The page.
    pub fn html(&self) -> String {
        let scenes = &self.scenes;
        let sections: Vec<Section> = [
            how_sure::section(scenes),
            decades::section(scenes),
            surfaces::section(scenes),
            measure_next::section(scenes),
            Some(all_numbers::section(self)),
        ]
        .into_iter()
        .flatten()
        .collect();
        let page = html! {
            (DOCTYPE)
            html lang="en" {
                head {
                    // Closed, as in the rest of the page, so that it reads as XML as well.
                    (PreEscaped("<meta charset=\"utf-8\" />"))
                    (PreEscaped("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\" />"))
                    title { (self.title) }
                    style { (PreEscaped(include_str!("style.css"))) }
                }
                body {
                    header {
                        h1 { (self.title) }
                    }
                    main {
                        @if let Some(opening) = &self.opening { (opening) }
                        @for (at, scene) in scenes.iter().enumerate() { (first_screen::first_screen(scene, at, scenes.len() > 1)) }
                        @for section in &sections { (section.folded(false)) }
                    }
                }
            }
        };
        // Titles, file names and notes may hold control characters, which no page may.
        printable(&page.into_string()).into_owned()
    }
}

/// Returns the class of what belongs to a load.
fn load_class(load: &AnswerUnderLoad) -> String {
    format!("l{}", load.load)
}

/// The parts of all scenes that have one, each under its label if there are several.
fn per_scene(
    scenes: &[SceneReport<'_>],
    part: impl Fn(&SceneReport<'_>) -> Option<Markup>,
) -> Option<Markup> {
    let parts: Vec<(&str, Markup)> =
        scenes.iter().filter_map(|scene| Some((scene.label, part(scene)?))).collect();
    let several = scenes.len() > 1;
    (!parts.is_empty()).then(|| {
        html! {
            @for (label, part) in &parts {
                @if several { p.scene { strong { (label) } } }
                (part)
            }
        }
    })
}

/// The gists of all scenes that have one, each after its label if there are several.
fn gists(scenes: &[SceneReport<'_>], gist: impl Fn(&SceneReport<'_>) -> Option<String>) -> String {
    let labelled = |scene: &SceneReport<'_>| {
        let gist = gist(scene)?;
        Some(if scenes.len() > 1 { format!("{}: {gist}", scene.label) } else { gist })
    };
    scenes.iter().filter_map(labelled).collect::<Vec<_>>().join(" · ")
}

/// A note as a sentence; a name at its beginning keeps its spelling.
fn sentence(note: &str) -> String {
    let end = if note.ends_with('.') { "" } else { "." };
    let first_word = note.split(' ').next().unwrap_or_default();
    let names_something = note.contains(": ") || !first_word.chars().all(char::is_alphabetic);
    if names_something { format!("{note}{end}") } else { format!("{}{end}", capital(note)) }
}

/// A table that scrolls separately on a narrow page.
#[must_use]
pub fn table(caption: &str, columns: &[impl AsRef<str>], body: &Markup) -> Markup {
    html! {
        // Reached by keyboard, since it may have to be scrolled.
        div.wide role="region" aria-label=(caption) tabindex="0" {
            table {
                caption { (caption) }
                thead { tr { @for column in columns { th scope="col" { (column.as_ref()) } } } }
                (body)
            }
        }
    }
}

/// Rows of a table under one name, from the cells of each.
fn row_group<T>(name: &str, rows: &[T], cells: impl Fn(&T) -> Markup) -> Markup {
    html! {
        tbody {
            @for (place, row) in rows.iter().enumerate() {
                tr {
                    @if place == 0 { th scope="rowgroup" rowspan=(rows.len()) { (name) } }
                    (cells(row))
                }
            }
        }
    }
}

/// A cell as dark as its share is large; a negative share is outlined.
fn share_cell(percent: Option<i32>) -> Markup {
    match percent {
        None => html! { td.share {} },
        Some(percent) if percent < 0 => html! { td.share.against { "−" (-percent) } },
        Some(percent) => {
            let depth = f64::from(percent.min(100)) / 100.0;
            html! { td.share style={ "--share:" (format!("{depth:.2}")) } { (percent) } }
        }
    }
}

impl SceneReport<'_> {
    /// A load as typed, and in units of the hardness.
    fn load(&self, load: usize) -> String {
        load_in_full(
            &self.scene.needs.loads[load].label,
            self.scene.needs.loads[load].nominal_pressure_pa(),
            self.scene.hardness_pa(),
        )
    }

    /// Neighbouring loads.
    fn loads(&self, loads: &[usize]) -> String {
        match loads {
            [one] => self.load(*one),
            _ if loads.len() == self.scene.needs.loads.len() => "every load".to_owned(),
            [first, .., last] => format!("{} to {}", self.load(*first), self.load(*last)),
            [] => String::new(),
        }
    }

    /// A curve's short name.
    fn short_curve(&self, curve: usize) -> String {
        short_name(&self.scene.needs.curves[curve])
    }

    /// A curve's name in full.
    fn curve(&self, curve: usize) -> String {
        in_full(&self.scene.needs.curves[curve])
    }

    /// A pressure in units of the hardness, if there is one.
    fn pressure(&self, pressure_pa: f64) -> String {
        match self.scene.hardness_pa() {
            Some(hardness_pa) => format!("{} H", typeset_digits(pressure_pa / hardness_pa)),
            None => pressure(pressure_pa),
        }
    }

    /// For every curve its index and, with their indices, the answers under the loads that have one.
    fn answers(&self) -> impl Iterator<Item = (usize, Vec<(usize, &LoadAnswer)>)> {
        self.answer.curves.iter().enumerate().map(|(curve, loads)| {
            let found = loads.iter().enumerate().filter_map(|(load, answer)| Some((load, answer.as_ref()?)));
            (curve, found.collect())
        })
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
