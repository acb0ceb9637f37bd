//! The paper's figures, for every scene that comes with the program.

use std::process::ExitCode;
use std::time::{Duration, Instant};

use cli::failure::Failure;
use cli::products::{self, Findings};
use cli::scene::{Scene, Template};
use cli::table::Format;
use tests::committed_file;

pub(crate) fn run() -> ExitCode {
    let mut computing = Duration::ZERO;
    for template in Template::RUNNABLE {
        match reproduce(template) {
            Ok(time) => computing += time,
            Err(failure) => return failure.report(),
        }
    }
    println!("computed in {:.1} ms", computing.as_secs_f64() * 1e3);
    ExitCode::SUCCESS
}

/// Writes the figures of one scene, says where they are, and yields the time spent computing.
fn reproduce(template: Template) -> Result<Duration, Failure> {
    let scene = Scene::builtin(template)?;
    let start = Instant::now();
    let results = scene.plan().compute().map_err(Failure::input)?;
    let findings = Findings::of(&scene, &results).map_err(Failure::input)?;
    let computing = start.elapsed();
    let folder = committed_file("target/reproduce").join(template.name());
    let files = products::write(&scene, &results, Some(&findings), Format::Csv, &folder)?;
    let figures: Vec<&str> = scene.figures.iter().map(|figure| figure.name.as_str()).collect();
    println!("{}: {} files in {}", scene.title, files.len(), folder.display());
    println!(
        "  {}, each as .svg and .csv; every level of the curves in the other tables",
        figures.join(", ")
    );
    Ok(computing)
}
