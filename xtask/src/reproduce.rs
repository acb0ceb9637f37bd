//! Reproduces the paper: its figures for every scene that comes with the program, and the verdicts on its statements.

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use findings::SceneFindings;
use judge::{JudgePlan, Judgement, Settings};
use paper::{Evidence, Verdict};
use report::assessment::Assessment;
use report::page::Report;
use report::products::SceneProducts;
use report::run_stamp::RunStamp;
use scene::Template;
use staging::{StagedFiles, write_file};
use study::Unobserved;
use tables::Format;
use tests::committed_file;

/// The spectrum that goes further comes first.
const SCENES: [Template; 2] = [Template::UncdReconstructed, Template::UncdMeasured];

pub(crate) fn run() -> ExitCode {
    match reproduce(&committed_file("target/reproduce")) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Writes figures, tables and claims, and prints their folder.
fn reproduce(folder: &Path) -> Result<(), Box<dyn Error>> {
    let start = Instant::now();
    let evidence = SCENES.into_iter().map(Evidence::compute).collect::<Result<Vec<_>, _>>()?;
    let findings = evidence.iter().map(found).collect::<Result<Vec<_>, _>>()?;
    let judgements = evidence.iter().map(judged).collect::<Result<Vec<_>, _>>()?;
    let ledger = paper::ledger(&evidence);
    let computing = start.elapsed();
    let run_stamp = RunStamp::default();
    let products: Vec<SceneProducts<'_>> = evidence
        .iter()
        .zip(&findings)
        .zip(&judgements)
        .map(|((evidence, findings), judgement)| SceneProducts {
            scene: &evidence.scene,
            results: &evidence.results,
            findings: Some(findings),
            assessment: Assessment { judgement: Some(judgement), uncertainty: None },
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
    let parts = evidence.iter().zip(&products);
    let report = Report {
        title: "Real contact area of ultrananocrystalline diamond",
        scenes: parts
            .filter_map(|(evidence, products)| products.report(label(evidence.template.name())))
            .collect(),
        extra: Some(paper::section(&ledger, &paper::other_models(&evidence)?, label)),
        run_stamp: &run_stamp,
        repeat: "cargo xtask reproduce, which also writes every number of every figure as a table.",
    };
    let page = folder.join("report.html");
    write_file(&page, report.html())?;
    let claims = folder.join("claims.csv");
    let mut table = Vec::new();
    paper::table(&ledger).write(Format::Csv, &[], &mut table)?;
    write_file(&claims, table)?;
    println!("{}: {}", claims.display(), verdicts(&ledger));
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

fn found(evidence: &Evidence) -> Result<SceneFindings, Box<dyn Error>> {
    SceneFindings::from_results(&evidence.scene, &evidence.results, &Unobserved).map_err(Into::into)
}

fn judged(evidence: &Evidence) -> Result<Judgement, Box<dyn Error>> {
    let settings = Settings::from_choices(evidence.scene.judge.as_ref());
    let plan = JudgePlan::new(&evidence.scene, &evidence.results, &settings);
    plan.run(&Unobserved).map_err(Into::into)
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

fn say_time(what: &str, time: Duration) {
    println!("{what} {:.1} ms", time.as_secs_f64() * 1e3);
}
