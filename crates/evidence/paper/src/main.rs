//! Reproduces the paper: its figures for every scene that comes with the program, and the verdicts on its statements, by
//! `cargo xtask reproduce`.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use conclusions::Conclusions;
use findings::answer::SceneAnswer;
use findings::sensitivity::{Sensitivity, sensitivities};
use judge::{JudgePlan, Judgement};
use paper::{Evidence, Part, Reading, Verdict};
use report::page::Report;
use report::products::SceneProducts;
use report::run_stamp::RunStamp;
use scene::Template;
use study::Unobserved;
use tables::Format;
use tables::staging::{StagedFiles, write_file};

/// The spectrum that goes further comes first.
const SCENES: [Template; 2] = [Template::UncdReconstructed, Template::UncdMeasured];

fn main() -> ExitCode {
    if let Some(argument) = std::env::args().nth(1) {
        eprintln!("error: {argument}: this program takes no arguments");
        return ExitCode::from(2);
    }
    match reproduce(&checkout().join("target/reproduce")) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Top of the checkout.
fn checkout() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .ancestors()
        .nth(3)
        .expect("this crate lies in the checkout")
        .to_owned()
}

/// Writes figures, tables and claims, and prints their folder.
fn reproduce(folder: &Path) -> Result<(), Box<dyn Error>> {
    let start = Instant::now();
    let evidence = SCENES.into_iter().map(Evidence::compute).collect::<Result<Vec<_>, _>>()?;
    let found = evidence.iter().map(Found::about).collect::<Result<Vec<_>, _>>()?;
    let ledger = paper::ledger(&evidence);
    let of_readings = Reading::ALL.into_iter().flat_map(|reading| SCENES.map(|scene| (reading, scene)));
    let of_readings = of_readings.map(|(reading, scene)| Evidence::read_as(reading, scene));
    let parts = paper::parts(&of_readings.collect::<Result<Vec<_>, _>>()?);
    let computing = start.elapsed();
    let run_stamp = RunStamp::default();
    let of_scenes: Vec<conclusions::Evidence<'_>> =
        evidence.iter().zip(&found).map(|(evidence, found)| found.beside(evidence)).collect();
    let conclusions: Vec<Conclusions> = of_scenes.iter().map(Conclusions::new).collect();
    let products: Vec<SceneProducts<'_>> = of_scenes
        .into_iter()
        .zip(&found)
        .zip(&conclusions)
        .map(|((evidence, found), conclusions)| SceneProducts {
            evidence,
            conclusions,
            sensitivities: Some(&found.sensitivities),
            run_stamp: &run_stamp,
        })
        .collect();
    for (evidence, products) in evidence.iter().zip(&products) {
        let folder = folder.join(evidence.template.name());
        std::fs::create_dir_all(&folder)?;
        let mut files = StagedFiles::default();
        let names = products
            .each_file(Format::Csv, |name, content| files.stage(&folder.join(name), |out| content(out)))?;
        files.publish()?;
        println!("{}: {} files in {}", evidence.scene.title, names.len(), folder.display());
    }
    let of_scenes = evidence.iter().zip(&products);
    let report = Report {
        title: "Real contact area of ultrananocrystalline diamond",
        scenes: of_scenes
            .filter_map(|(evidence, products)| products.report(label(evidence.template.name())))
            .collect(),
        opening: Some(paper::opening(&ledger, &parts, &paper::other_models(&evidence)?, label)),
        run_stamp: &run_stamp,
        repeat: "cargo xtask reproduce, which also writes every number of every figure as a table.",
    };
    let page = folder.join("report.html");
    write_file(&page, report.html())?;
    for (name, table, counts) in [
        ("claims.csv", paper::table(&ledger), verdicts(&ledger)),
        ("parts.csv", paper::parts_table(&parts), parts_that_hold(&parts)),
    ] {
        let (file, mut text) = (folder.join(name), Vec::new());
        table.write(Format::Csv, &[], &mut text)?;
        write_file(&file, text)?;
        println!("{}: {counts}", file.display());
    }
    println!("the report: {}", page.display());
    say_time("computed in", computing);
    say_time("done in", start.elapsed());
    Ok(())
}

/// The name of a spectrum in the report.
fn label(spectrum: &str) -> &str {
    match spectrum {
        "uncd-reconstructed" => "reconstruction",
        "uncd-measured" => "measured",
        other => other,
    }
}

/// The findings on the scene of a spectrum, besides its results.
struct Found {
    answer: SceneAnswer,
    sensitivities: Vec<Sensitivity>,
    judgement: Judgement,
}

impl Found {
    fn about(evidence: &Evidence) -> Result<Self, Box<dyn Error>> {
        let (scene, results) = (&evidence.scene, &evidence.results);
        let settings = scene.judge.unwrap_or_default();
        Ok(Found {
            answer: SceneAnswer::from_results(scene, results),
            sensitivities: sensitivities(scene, results, &Unobserved)?,
            judgement: JudgePlan::new(scene, results, &settings).run(&Unobserved)?,
        })
    }

    fn beside<'a>(&'a self, evidence: &'a Evidence) -> conclusions::Evidence<'a> {
        conclusions::Evidence {
            scene: &evidence.scene,
            results: &evidence.results,
            answer: &self.answer,
            judgement: Some(&self.judgement),
            uncertainty: None,
        }
    }
}

/// The number of statements that each spectrum reproduces.
fn verdicts(ledger: &[paper::Row]) -> String {
    let findings = || ledger.iter().flat_map(|row| row.findings.iter());
    let mut spectra: Vec<&str> = findings().map(|(spectrum, _)| *spectrum).collect();
    spectra.dedup();
    spectra.truncate(SCENES.len());
    let count = |spectrum: &&str| {
        let with = |verdict: Verdict| {
            findings().filter(|(name, finding)| name == spectrum && finding.verdict == verdict).count()
        };
        format!(
            "{spectrum} {} reproduced, {} not, {} by construction",
            with(Verdict::Reproduced),
            with(Verdict::NotReproduced),
            with(Verdict::ByConstruction)
        )
    };
    spectra.iter().map(count).collect::<Vec<_>>().join("; ")
}

/// The number of parts that hold on each spectrum in the program's reading, and in any.
fn parts_that_hold(parts: &[Part]) -> String {
    let count = |scene: &Template| {
        let held = |reading| paper::parts_that_hold(parts, scene.name(), reading);
        let (own, any) = (held(Some(Reading::PROGRAM)), held(None));
        format!("{} {own} of {} parts hold in the program's reading, {any} in any", scene.name(), parts.len())
    };
    SCENES.iter().map(count).collect::<Vec<_>>().join("; ")
}

fn say_time(what: &str, time: Duration) {
    println!("{what} {:.1} ms", time.as_secs_f64() * 1e3);
}
