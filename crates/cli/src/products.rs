//! The files of a scene: a table per curve, a table and an SVG per figure, the report and its tables.

use std::path::Path;

use crate::answer::Answer;
use crate::failure::Failure;
use crate::figure::{Figure, FigureData, Shows};
use crate::output::StagedFiles;
use crate::plan::{PlanError, Results, Work};
use crate::plot;
use crate::provenance::provenance;
use crate::report::{Report, SceneReport};
use crate::scene::Scene;
use crate::sensitivity::{self, Sensitivity, counted_sensitivities};
use crate::table::{Format, Table};
use crate::tables;

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
        let (sensitivities, work) = counted_sensitivities(scene, results)?;
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
            ("report-scales", self.answer.scales_table(&scene.needs)),
            ("report-decades", self.answer.decades_table(&scene.needs)),
            ("report-sensitivity", sensitivity::table(&self.sensitivities, &scene.needs)),
        ]
    }
}

/// Writes every file of a scene into a folder, all of them or none; yields their names. The report and its tables are
/// left out where there are no findings.
///
/// # Errors
/// [`Failure::System`] that names the path.
pub fn write(
    scene: &Scene,
    results: &Results,
    findings: Option<&Findings>,
    format: Format,
    folder: &Path,
) -> Result<Vec<String>, Failure> {
    std::fs::create_dir_all(folder)
        .map_err(|error| Failure::writing(&folder.display().to_string(), &error))?;
    let mut files = StagedFiles::default();
    let mut names = Vec::new();
    let mut stage_table = |files: &mut StagedFiles, name: &str, what: &str, table: &Table| {
        names.push(format!("{name}.{}", format.extension()));
        let comments = origin(scene, &format!("{what} {name}"));
        files.stage(&folder.join(&names[names.len() - 1]), |out| table.write(format, &comments, out))
    };
    for (curve, result) in scene.needs.curves.iter().zip(&results.curves) {
        let table = tables::curve(result, &scene.needs.loads, true);
        stage_table(&mut files, &curve.name, "curve", &table)?;
    }
    let reported = findings.map(|findings| findings.tables(scene));
    for (name, table) in reported.iter().flatten().filter(|(_, table)| table.rows() > 0) {
        stage_table(&mut files, name, "table", table)?;
    }
    let figures = figures(scene, results);
    for figure in &figures {
        stage_table(&mut files, &figure.name, "figure", &figure.table())?;
    }
    for figure in &figures {
        names.push(format!("{}.svg", figure.name));
        let svg = drawn(scene, figure);
        files.stage(&folder.join(&names[names.len() - 1]), |out| out.write_all(svg.as_bytes()))?;
    }
    if let Some(findings) = findings {
        let report = Report {
            title: &scene.title,
            scenes: vec![findings.report(&scene.title, scene, results)],
            ledger: None,
            repeat: "truearea run with the scene; the tables beside this page hold every number of its figures.",
        };
        names.push("report.html".to_owned());
        files.stage(&folder.join("report.html"), |out| out.write_all(report.html().as_bytes()))?;
    }
    files.publish()?;
    Ok(names)
}
