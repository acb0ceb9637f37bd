//! The files of a scene: a table per curve, a table and an SVG per figure, the report and its tables.

use std::io::{self, Write};

use crate::page::{Report, SceneReport};
use crate::plot;
use study::Unobserved;
use study::answer::Answer;
use study::figure::{Figure, FigureData, Shows};
use study::plan::{PlanError, Results, Work};
use study::provenance::provenance;
use study::result_tables;
use study::scene::Scene;
use study::scene::file_names::REPORT_TABLES;
use study::sensitivity::{self, Sensitivity, counted_sensitivities};
use tables::{Format, Table};

/// The figures of a scene with their data.
pub fn figures(scene: &Scene, results: &Results) -> Vec<FigureData> {
    scene.figures.iter().map(|figure| data(scene, results, figure)).collect()
}

/// One figure of a scene as an SVG document; `None` where it has no figure of that name.
pub fn figure_svg(scene: &Scene, results: &Results, name: &str) -> Option<String> {
    let figure = scene.figures.iter().find(|figure| figure.name == name)?;
    Some(drawn(scene, &data(scene, results, figure)))
}

fn data(scene: &Scene, results: &Results, figure: &Figure) -> FigureData {
    let data = figure.data(results, &scene.needs, scene.hardness_pa());
    match (&scene.surface.made_from, figure.shows) {
        (Some(scans), Shows::Psd) => scans.beneath(data),
        _ => data,
    }
}

fn drawn(scene: &Scene, figure: &FigureData) -> String {
    plot::svg(figure, &scene.title, &origin(scene, &format!("figure {}", figure.name)))
}

fn origin(scene: &Scene, what: &str) -> Vec<String> {
    let mut lines = provenance(&format!("scene \"{}\", {what}", scene.title), &scene.surface, scene.sampling);
    lines.extend(scene.choices());
    lines
}

/// What a report says besides the curves and figures of a scene.
pub struct Findings {
    /// The answer.
    pub answer: Answer,
    /// What rests on which choice.
    pub sensitivities: Vec<Sensitivity>,
    /// How much was computed for that.
    pub work: Work,
}

impl Findings {
    /// The findings in the results of a scene; the sensitivities are computed.
    ///
    /// # Errors
    /// [`PlanError`], as of the scene itself.
    pub fn of(scene: &Scene, results: &Results) -> Result<Self, PlanError> {
        let answer = Answer::of(scene, results);
        let (sensitivities, work) = counted_sensitivities(scene, results, &Unobserved)?;
        Ok(Findings { answer, sensitivities, work })
    }

    /// The part of a report that they make.
    pub fn report<'a>(&'a self, label: &'a str, scene: &'a Scene, results: &'a Results) -> SceneReport<'a> {
        SceneReport {
            label,
            scene,
            results,
            answer: &self.answer,
            sensitivities: &self.sensitivities,
            figures: figures(scene, results),
        }
    }

    fn tables(&self, scene: &Scene) -> [(&'static str, Table); 3] {
        [
            (REPORT_TABLES[0], self.answer.scales_table(&scene.needs)),
            (REPORT_TABLES[1], self.answer.decades_table(&scene.needs)),
            (REPORT_TABLES[2], sensitivity::table(&self.sensitivities, &scene.needs)),
        ]
    }
}

/// What puts the bytes of one file anywhere.
pub type Content<'c> = &'c dyn Fn(&mut dyn Write) -> io::Result<()>;

/// Hands every file of a scene to `file`, by name, and yields their names. The report and its tables are left out where there
/// are no findings. A table is made when its turn comes, so that only one of them is held.
///
/// # Errors
/// Those of `file`.
pub fn each_file<E>(
    scene: &Scene,
    results: &Results,
    findings: Option<&Findings>,
    format: Format,
    mut file: impl FnMut(&str, Content<'_>) -> Result<(), E>,
) -> Result<Vec<String>, E> {
    let mut names = Vec::new();
    let mut table_file = |name: &str, what: &str, table: &Table| {
        names.push(format!("{name}.{}", format.extension()));
        let comments = origin(scene, &format!("{what} {name}"));
        file(&names[names.len() - 1], &|out| table.write(format, &comments, out))
    };
    for (curve, result) in scene.needs.curves.iter().zip(&results.curves) {
        table_file(&curve.name, "curve", &result_tables::curve(result, &scene.needs.loads, true))?;
    }
    let reported = findings.map(|findings| findings.tables(scene));
    for (name, table) in reported.iter().flatten().filter(|(_, table)| table.rows() > 0) {
        table_file(name, "table", table)?;
    }
    let figures = figures(scene, results);
    for figure in &figures {
        table_file(&figure.name, "figure", &figure.table())?;
    }
    for figure in &figures {
        names.push(format!("{}.svg", figure.name));
        let svg = drawn(scene, figure);
        file(&names[names.len() - 1], &|out| out.write_all(svg.as_bytes()))?;
    }
    if let Some(findings) = findings {
        let report = Report {
            title: &scene.title,
            scenes: vec![findings.report(&scene.title, scene, results)],
            ledger: None,
            repeat: "truearea run with the scene; the tables beside this page hold every number of its figures.",
        };
        names.push("report.html".to_owned());
        let html = report.html();
        file("report.html", &|out| out.write_all(html.as_bytes()))?;
    }
    Ok(names)
}
