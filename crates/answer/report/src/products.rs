//! The files of a scene: a table per curve, a table and pictures per figure, the report and its tables.

use std::io::{self, Write};

use crate::chart;
use crate::curve_names::with_printed_names;
use crate::intervals::with_intervals;
use crate::judged::with_marks;
use crate::page::{Report, SceneReport};
use crate::provenance::provenance;
use crate::run_stamp::RunStamp;
use conclusions::{AnswerUnderLoad, Conclusions, Evidence};
use findings::answer::SceneAnswer;
use findings::sensitivity::Sensitivity;
use judge::Judgement;
use questions::RunOptions;
use scene::Scene;
use scene::file_names::{INTERFACE_TABLE, JUDGE_TABLES, REPORT_TABLES, UNCERTAINTY_TABLES};
use serde::Serialize;
use study::figure::{Figure, FigureData, PictureFormat, Shows, over_scans};
use study::interface::Slot;
use study::interface::{FlatnessRange, InterfaceStates, slots_table};
use study::plan::{Cutoffs, Results};
use study::result_tables;
use tables::{Format, Table};
use uncertainty::{QuantityInterval, Uncertainty};
use units::printable::printable;

/// The name of the report page.
pub const REPORT: &str = "report.html";

/// The name of the conclusions for scripts.
pub const ANSWER: &str = "answer.json";

/// The figures of a scene with their data.
pub fn figures(scene: &Scene, results: &Results) -> Vec<FigureData> {
    scene.figures.iter().map(|figure| data(scene, results, figure, None)).collect()
}

/// The figure of the spectrum that a report makes where the scene asks for none.
fn spectrum_figure() -> Figure {
    Figure { name: SPECTRUM_NAME.to_owned(), shows: Shows::Psd, ..Figure::area_of_all(Vec::new()) }
}

/// The conclusions on a scene, and what they rest on.
pub type Found<'a> = (Evidence<'a>, &'a Conclusions);

/// Computes the data of the figures of a scene, in their order, with the elements and intervals that were found.
pub fn figure_documents<'a>(
    scene: &'a Scene,
    results: &'a Results,
    found: Option<Found<'a>>,
) -> impl Iterator<Item = FigureDocuments<'a>> {
    let documents =
        move |figure| FigureDocuments { scene, figure, data: data(scene, results, figure, found) };
    scene.figures.iter().map(documents)
}

/// A figure of a scene with its data, to be written in its formats.
pub struct FigureDocuments<'a> {
    scene: &'a Scene,
    figure: &'a Figure,
    data: FigureData,
}

impl FigureDocuments<'_> {
    /// Draws the figure as an SVG document.
    #[must_use]
    pub fn svg(&self) -> String {
        chart::styled_svg(&self.named(), &self.figure.style, &self.scene.title, &self.origin())
    }

    /// Writes the Python script that draws the figure from its table in a format.
    #[must_use]
    pub fn script(&self, format: Format) -> String {
        chart::script(&self.named(), &self.figure.style, &self.origin(), format)
    }

    /// Writes the table of the figure, from which its script draws it.
    ///
    /// # Errors
    /// Any error that `out` returns.
    pub fn write_table(&self, format: Format, out: &mut dyn Write) -> io::Result<()> {
        self.data.table().write(format, &self.origin(), out)
    }

    fn named(&self) -> FigureData {
        with_printed_names(self.data.clone(), &self.scene.needs.curves)
    }

    fn origin(&self) -> Vec<String> {
        origin(self.scene, &format!("figure {}", self.figure.name))
    }
}

/// The data of a figure, with the elements and the intervals of its areas.
fn data(scene: &Scene, results: &Results, figure: &Figure, found: Option<Found<'_>>) -> FigureData {
    let mut figure = figure.clone();
    let judged = found.and_then(|(evidence, conclusions)| Some((evidence.judgement?, conclusions)));
    if let Some((_, conclusions)) = judged.filter(|_| figure.draws_nearest) {
        let nearest: Vec<usize> =
            conclusions.loads.iter().filter_map(AnswerUnderLoad::nearest_curve).collect();
        if figure.curves.iter().any(|curve| nearest.contains(curve)) {
            figure.keep_curves(&nearest, &scene.needs);
        }
    }
    let data = figure.data(results, &scene.needs, scene.hardness_pa());
    let data = match judged {
        Some((judgement, _)) => with_marks(data, scene, judgement, results.psd.shortest_wavelength_m()),
        None => data,
    };
    let data = match found.and_then(|(evidence, _)| evidence.uncertainty) {
        Some(uncertainty) => with_intervals(data, &figure, scene, uncertainty),
        None => data,
    };
    let data = data.with_holes(&scene.surface.holes);
    match &scene.surface.made_from {
        Some(scans) if data.shows == Shows::Psd => over_scans(scans, data),
        _ => data,
    }
}

/// The figures of a report: first the area of all curves against the cutoff, unless it has too many lines to be read, then the spectrum, both made where the scene
/// does not ask for them, then the others.
fn reported_figures(found: Found<'_>) -> Vec<FigureData> {
    let Evidence { scene, results, .. } = found.0;
    let mut own = scene.figures.clone();
    let data = |figure: &Figure| data(scene, results, figure, Some(found));
    let finished = |data: FigureData| with_printed_names(data, &scene.needs.curves);
    let mut figures = Vec::new();
    let followed: Vec<usize> = (0..scene.needs.curves.len())
        .filter(|&at| scene.needs.curves[at].cutoffs == Cutoffs::Every)
        .collect();
    let shows_all = |figure: &Figure| {
        figure.shows == Shows::Area
            && figure.loads.is_none()
            && followed.iter().all(|curve| figure.curves.contains(curve))
    };
    if !followed.is_empty() {
        let all = match own.iter().position(shows_all) {
            Some(at) => own.remove(at),
            None => Figure { name: ANSWER_NAME.to_owned(), ..Figure::area_of_all(followed.clone()) },
        };
        // The first screen has the same lines, load by load.
        figures.extend(Some(data(&all)).filter(|data| data.series.len() <= MAX_LINES).map(finished));
    }
    let spectrum = match own.iter().position(|figure| figure.shows == Shows::Psd) {
        Some(at) => own.remove(at),
        None => spectrum_figure(),
    };
    figures.push(finished(data(&spectrum)));
    figures.extend(own.iter().map(|figure| finished(data(figure))));
    figures
}

/// The names of figures that only the report has. No figure of a scene has such a name, which begins with a letter.
const ANSWER_NAME: &str = "_answer";
const SPECTRUM_NAME: &str = "_spectrum";

/// The largest number of lines that a reader can distinguish.
const MAX_LINES: usize = 12;

fn origin(scene: &Scene, what: &str) -> Vec<String> {
    let mut lines = provenance(&format!("scene \"{}\", {what}", scene.title), &scene.surface, scene.sampling);
    lines.extend(scene.choices());
    lines
}

/// The tables of the answer and of the sensitivities.
fn report_tables(
    answer: &SceneAnswer,
    sensitivities: &[Sensitivity],
    scene: &Scene,
) -> [(&'static str, Table); 3] {
    let [scales, decades, sensitivity] = REPORT_TABLES;
    [
        (scales, answer.scales_table(&scene.needs)),
        (decades, answer.decades_table(&scene.needs)),
        (sensitivity, findings::sensitivity::table(sensitivities, &scene.needs)),
    ]
}

/// The verdict on every curve, and on every window.
fn judge_tables(judgement: &Judgement, scene: &Scene) -> [(&'static str, Table); 2] {
    let [models, windows] = JUDGE_TABLES;
    [(models, judgement.models_table(&scene.needs)), (windows, judgement.windows_table(&scene.needs))]
}

/// The interval of every area, the indices of its inputs, and what to measure next.
fn uncertainty_tables(uncertainty: &Uncertainty, scene: &Scene) -> [(&'static str, Table); 3] {
    let [intervals, indices, advice] = UNCERTAINTY_TABLES;
    [
        (intervals, uncertainty.intervals_table(&scene.needs)),
        (indices, uncertainty.indices_table(&scene.needs)),
        (advice, uncertainty.advice_table(&scene.needs)),
    ]
}

/// The names of the files that a scene may have, for checks before anything is computed. Tables of the judge or of
/// draws without rows are not written.
#[must_use]
pub fn file_names(scene: &Scene, options: RunOptions, format: Format) -> Vec<String> {
    let table = |name: &str| format!("{name}.{}", format.extension());
    let mut names: Vec<String> = scene.needs.curves.iter().map(|curve| table(&curve.name)).collect();
    if options.is_judged(scene) {
        names.extend(JUDGE_TABLES.map(table));
    }
    if options.is_drawn(scene) {
        names.extend(UNCERTAINTY_TABLES.map(table));
    }
    names.extend(scene.interface.as_ref().map(|_| table(INTERFACE_TABLE)));
    if options.report {
        names.extend(REPORT_TABLES.map(table));
        names.push(REPORT.to_owned());
    }
    names.push(ANSWER.to_owned());
    for figure in &scene.figures {
        names.push(table(&figure.name));
        names.extend(figure.file_names());
    }
    names
}

/// The writer of one file's content.
pub type Content<'c> = &'c dyn Fn(&mut dyn Write) -> io::Result<()>;

/// A product of a scene.
#[derive(Debug, Clone, Copy)]
pub enum Product<'p> {
    /// A table with the lines of its provenance.
    Table {
        /// The table.
        table: &'p Table,
        /// The lines.
        origin: &'p [String],
    },
    /// The text of a file: a figure as an SVG document or as a Python script, the report, or the conclusions as JSON.
    Text(&'p str),
}

impl Product<'_> {
    /// Returns the name of its file: that of a table is without ending.
    #[must_use]
    pub fn file_name(&self, name: &str, format: Format) -> String {
        match self {
            Product::Table { .. } => format!("{name}.{}", format.extension()),
            Product::Text(_) => name.to_owned(),
        }
    }

    /// Writes the content of its file.
    ///
    /// # Errors
    /// Any error that `out` returns.
    pub fn write(&self, format: Format, out: &mut dyn Write) -> io::Result<()> {
        match self {
            Product::Table { table, origin } => table.write(format, origin, out),
            Product::Text(text) => out.write_all(printable(text).as_bytes()),
        }
    }
}

/// A scene with what was found about it, and the products made of that.
#[derive(Clone, Copy)]
pub struct SceneProducts<'a> {
    /// The scene and what was found about it.
    pub evidence: Evidence<'a>,
    /// The conclusions.
    pub conclusions: &'a Conclusions,
    /// The sensitivities to modelling choices; without them there is no report.
    pub sensitivities: Option<&'a [Sensitivity]>,
    /// Date and command of the run.
    pub run_stamp: &'a RunStamp,
}

impl<'a> SceneProducts<'a> {
    /// Passes the name and content of every file to `file`, and returns the names.
    ///
    /// # Errors
    /// Any error that `file` returns.
    pub fn each_file<E>(
        &self,
        format: Format,
        mut file: impl FnMut(&str, Content<'_>) -> Result<(), E>,
    ) -> Result<Vec<String>, E> {
        let mut names = Vec::new();
        self.each(format, |name, product| {
            let name = product.file_name(name, format);
            let written = file(&name, &|out| product.write(format, out));
            names.push(name);
            written
        })?;
        Ok(names)
    }

    /// Passes every table to `take` by its name, and every text by that of its file; scripts read tables in a format. The report and its tables need sensitivities; the tables of the
    /// judge and of draws need those. A table is made when its turn comes, so that only one is held.
    ///
    /// # Errors
    /// Any error that `take` returns.
    pub fn each<E>(
        &self,
        format: Format,
        mut take: impl FnMut(&str, Product<'_>) -> Result<(), E>,
    ) -> Result<(), E> {
        let SceneProducts { evidence, sensitivities, run_stamp, .. } = *self;
        let Evidence { scene, results, answer, .. } = evidence;
        let mut take_table = |name: &str, what: &str, table: &Table| {
            let origin = origin(scene, &format!("{what} {name}"));
            take(name, Product::Table { table, origin: &origin })
        };
        for (curve, result) in scene.needs.curves.iter().zip(&results.curves) {
            take_table(&curve.name, "curve", &result_tables::curve(result, &scene.needs.loads, true))?;
        }
        let reported = sensitivities.map(|sensitivities| report_tables(answer, sensitivities, scene));
        for (name, table) in reported.iter().flatten().filter(|(_, table)| table.rows() > 0) {
            take_table(name, "table", table)?;
        }
        let judged = evidence.judgement.into_iter().flat_map(|judgement| judge_tables(judgement, scene));
        let drawn_from = evidence.uncertainty.into_iter();
        let of_draws = drawn_from.flat_map(|uncertainty| uncertainty_tables(uncertainty, scene));
        for (name, table) in judged.chain(of_draws) {
            if table.rows() > 0 {
                take_table(name, "table", &table)?;
            }
        }
        if let Some(states) = scene.interface_states(results) {
            take_table(INTERFACE_TABLE, "table", &interface_table(&states, scene, evidence.uncertainty))?;
        }
        let figures: Vec<FigureDocuments<'_>> =
            figure_documents(scene, results, Some((evidence, self.conclusions))).collect();
        for documents in &figures {
            take_table(&documents.figure.name, "figure", &documents.data.table())?;
        }
        for documents in &figures {
            let name = &documents.figure.name;
            take(&format!("{name}.svg"), Product::Text(&documents.svg()))?;
            if documents.figure.formats.contains(&PictureFormat::Script) {
                take(&format!("{name}.py"), Product::Text(&documents.script(format)))?;
            }
        }
        take(ANSWER, Product::Text(&answer_json(self.conclusions, scene)))?;
        if let Some(part) = self.report(&scene.title) {
            let report = Report {
                title: &scene.title,
                scenes: vec![part],
                opening: None,
                repeat: "truearea run with the scene below; the tables beside this page hold its numbers.",
                run_stamp,
            };
            take(REPORT, Product::Text(&report.html()))?;
        }
        Ok(())
    }

    /// Returns the part of a report on this scene; `None` without sensitivities.
    #[must_use]
    pub fn report(&self, label: &'a str) -> Option<SceneReport<'a>> {
        let SceneProducts { evidence, conclusions, sensitivities, .. } = *self;
        let Evidence { scene, results, answer, .. } = evidence;
        Some(SceneReport {
            label,
            scene,
            results,
            answer,
            evidence,
            conclusions,
            sensitivities: sensitivities?,
            figures: reported_figures((evidence, conclusions)),
        })
    }
}

/// The conclusions as JSON, with the names of the curves that they number.
fn answer_json(conclusions: &Conclusions, scene: &Scene) -> String {
    let answer = AnswerFile {
        program: concat!("truearea ", env!("CARGO_PKG_VERSION")),
        curves: scene.needs.curves.iter().map(|curve| curve.name.as_str()).collect(),
        conclusions,
    };
    // Conclusions have text keys only, so that they can be written.
    serde_json::to_string_pretty(&answer).unwrap_or_default() + "\n"
}

/// The content of `answer.json`.
#[derive(Serialize)]
struct AnswerFile<'a> {
    /// The program and its version.
    program: &'static str,
    /// The names of the curves, in the order of their indices.
    curves: Vec<&'a str>,
    #[serde(flatten)]
    conclusions: &'a Conclusions,
}

/// A row per quantity, load and curve with a value: `quantity, nominal_pressure_pa, curve, value, median, low, high,
/// level`. The quantity includes its unit; pressures are empty for all loads together, intervals without draws.
fn interface_table(states: &InterfaceStates<'_>, scene: &Scene, uncertainty: Option<&Uncertainty>) -> Table {
    let found: Vec<(Slot, f64)> = states
        .slots()
        .into_iter()
        .filter_map(|slot| Some((slot, states.value(slot).ok().flatten()?)))
        .collect();
    let slots: Vec<Slot> = found.iter().map(|(slot, _)| *slot).collect();
    let interval = |of: fn(&QuantityInterval) -> f64| {
        slots.iter().map(move |slot| uncertainty.and_then(|found| found.quantity(*slot)).map(of))
    };
    let level = |slot: &Slot| uncertainty.filter(|found| found.quantity(*slot).is_some());
    let limits = |of: fn(FlatnessRange) -> f64| {
        found
            .iter()
            .map(move |(slot, flat)| states.with_flatness(slot.quantity, slot.load?, *flat).ok()?.map(of))
    };
    let table = slots_table(&scene.needs, &slots)
        .with_numbers("value", found.iter().map(|(_, value)| *value))
        .with_numbers("median", interval(|interval| interval.median))
        .with_numbers("low", interval(|interval| interval.low))
        .with_numbers("high", interval(|interval| interval.high))
        .with_numbers("level", slots.iter().map(|slot| level(slot).map(|found| found.settings.level)));
    if states.request.flatness.is_none() {
        return table;
    }
    table
        .with_numbers("with_wave", limits(|range| range.by_wave))
        .with_numbers("with_cap", limits(|range| range.by_cap))
}
