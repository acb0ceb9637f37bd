//! The paper's figures, for every scene that comes with the program, and what becomes of its statements.

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use judge::{JudgePlan, Judgement, Settings};
use paper::{Evidence, Verdict};
use report::occasion::Occasion;
use report::page::{self, Report};
use report::products::{self, Findings};
use report::trust::Trust;
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

/// Writes figures, tables and claims, and says where they are.
fn reproduce(folder: &Path) -> Result<(), Box<dyn Error>> {
    let start = Instant::now();
    let evidence = SCENES.into_iter().map(Evidence::compute).collect::<Result<Vec<_>, _>>()?;
    let findings = evidence.iter().map(found).collect::<Result<Vec<_>, _>>()?;
    let judgements = evidence.iter().map(judged).collect::<Result<Vec<_>, _>>()?;
    let ledger = paper::ledger(&evidence);
    let computing = start.elapsed();
    for ((evidence, findings), judgement) in evidence.iter().zip(&findings).zip(&judgements) {
        let folder = folder.join(evidence.template.name());
        let (scene, results) = (&evidence.scene, &evidence.results);
        std::fs::create_dir_all(&folder)?;
        let mut files = StagedFiles::default();
        let names = products::each_file(
            scene,
            results,
            Some(findings),
            Trust { judgement: Some(judgement), uncertainty: None },
            Format::Csv,
            |name, content| files.stage(&folder.join(name), |out| content(out)),
        )?;
        files.publish()?;
        println!("{}: {} files in {}", scene.title, names.len(), folder.display());
    }
    let checked = checked(&ledger, &paper::other_models(&evidence)?);
    let scenes = evidence.iter().zip(&findings).zip(&judgements);
    let report = Report {
        title: "Real contact area of ultrananocrystalline diamond",
        scenes: scenes
            .map(|((evidence, findings), judgement)| {
                let label = label(evidence.template.name());
                let trust = Trust { judgement: Some(judgement), uncertainty: None };
                findings.report(label, &evidence.scene, &evidence.results, trust)
            })
            .collect(),
        ledger: Some(&checked),
        occasion: &Occasion::default(),
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

/// Returns the name of a spectrum in the report.
fn label(spectrum: &str) -> &str {
    match spectrum {
        "uncd-reconstructed" => "reconstruction",
        "uncd-measured" => "measured",
        other => other,
    }
}

/// The ledger as the report shows it.
fn checked(ledger: &[paper::Row], others: &[paper::OtherModel]) -> page::Ledger {
    let finding = |(spectrum, finding): &(&'static str, paper::Finding)| page::Finding {
        label: label(spectrum).to_owned(),
        found: finding.found.clone(),
        verdict: finding.verdict,
        remark: finding.remark.clone(),
    };
    let row = |row: &paper::Row| page::LedgerRow {
        number: row.statement.number,
        statement: row.statement.statement.to_owned(),
        how: row.statement.how.to_owned(),
        findings: row.findings.iter().map(finding).collect(),
    };
    let other_finding = |(spectrum, finding): &(&'static str, paper::OtherFinding)| page::OtherFinding {
        label: label(spectrum).to_owned(),
        found: finding.found.clone(),
        remark: finding.remark.clone(),
    };
    let other = |other: &paper::OtherModel| page::OtherModel {
        model: other.model.to_owned(),
        statement: other.statement.to_owned(),
        findings: other.findings.iter().map(other_finding).collect(),
    };
    page::Ledger { rows: ledger.iter().map(row).collect(), other_models: others.iter().map(other).collect() }
}

fn found(evidence: &Evidence) -> Result<Findings, Box<dyn Error>> {
    Findings::of(&evidence.scene, &evidence.results).map_err(Into::into)
}

fn judged(evidence: &Evidence) -> Result<Judgement, Box<dyn Error>> {
    let settings = Settings::of(evidence.scene.judge.as_ref());
    let plan = JudgePlan::of(&evidence.scene, &evidence.results, &settings);
    plan.carry_out(&Unobserved).map_err(Into::into)
}

/// Counts the statements that each spectrum reproduces.
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
