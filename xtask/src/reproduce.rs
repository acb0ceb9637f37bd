//! The paper's figures, for every scene that comes with the program, and what becomes of its statements.

use std::path::Path;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use cli::failure::Failure;
use cli::output::Place;
use cli::products::{self, Findings};
use cli::report::{self, Report};
use cli::scene::Template;
use cli::table::Format;
use paper::{Evidence, Verdict};
use tests::committed_file;

/// The spectrum that goes further comes first.
const SCENES: [Template; 2] = [Template::UncdReconstructed, Template::UncdMeasured];

pub(crate) fn run() -> ExitCode {
    reproduce(&committed_file("target/reproduce")).map_or_else(Failure::report, |()| ExitCode::SUCCESS)
}

/// Writes figures, tables and claims, and says where they are.
fn reproduce(folder: &Path) -> Result<(), Failure> {
    let start = Instant::now();
    let evidence = SCENES.into_iter().map(Evidence::compute).collect::<Result<Vec<_>, _>>()?;
    let findings = evidence.iter().map(found).collect::<Result<Vec<_>, _>>()?;
    let ledger = paper::ledger(&evidence);
    let computing = start.elapsed();
    for (evidence, findings) in evidence.iter().zip(&findings) {
        let folder = folder.join(evidence.template.name());
        let (scene, results) = (&evidence.scene, &evidence.results);
        let files = products::write(scene, results, Some(findings), Format::Csv, &folder)?;
        println!("{}: {} files in {}", scene.title, files.len(), folder.display());
    }
    let checked = checked(&ledger);
    let scenes = evidence.iter().zip(&findings);
    let report = Report {
        title: "Real contact area of ultrananocrystalline diamond",
        scenes: scenes
            .map(|(evidence, findings)| {
                findings.report(label(evidence.template.name()), &evidence.scene, &evidence.results)
            })
            .collect(),
        ledger: Some(&checked),
        repeat: "cargo xtask reproduce, which also writes every number of every figure as a table.",
    };
    let page = folder.join("report.html");
    let html = report.html();
    Place::File(page.clone()).write(|out| out.write_all(html.as_bytes()))?;
    let claims = folder.join("claims.csv");
    Place::File(claims.clone()).write(|out| paper::table(&ledger).write(Format::Csv, &[], out))?;
    println!("{}: {}", claims.display(), verdicts(&ledger));
    println!("the report: {}", page.display());
    say_time("computed in", computing);
    say_time("done in", start.elapsed());
    Ok(())
}

/// What a spectrum is called in the report.
fn label(spectrum: &str) -> &str {
    match spectrum {
        "uncd-reconstructed" => "reconstruction",
        "uncd-measured" => "measured",
        other => other,
    }
}

/// The ledger as the report shows it.
fn checked(ledger: &[paper::Row]) -> report::Ledger {
    let finding = |(spectrum, finding): &(&'static str, paper::Finding)| report::Finding {
        label: label(spectrum).to_owned(),
        found: finding.found.clone(),
        verdict: finding.verdict,
        remark: finding.remark.clone(),
    };
    let row = |row: &paper::Row| report::LedgerRow {
        number: row.statement.number,
        statement: row.statement.statement.to_owned(),
        how: row.statement.how.to_owned(),
        findings: row.findings.iter().map(finding).collect(),
    };
    report::Ledger { rows: ledger.iter().map(row).collect() }
}

fn found(evidence: &Evidence) -> Result<Findings, Failure> {
    Findings::of(&evidence.scene, &evidence.results).map_err(Failure::input)
}

/// How many statements each spectrum reproduces.
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
