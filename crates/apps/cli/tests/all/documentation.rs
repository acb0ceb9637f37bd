//! Every call of the program that the README and the pages of `docs/` show, and the output that they show of it.
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::support::Bench;

/// A row that every kind of table finds its columns in.
const ROWS: &str = "\
model,youngs_modulus_pa,poisson_ratio,yield_strength_pa,strain_gradient_length_m,radius_m,density_per_m2,sigma_s_m,\
separation_m,pressure_pa,wavelength_m,aspect_ratio,interference_m
ep-sphere,2.1e11,0.3,1e9,,5e-6,2e11,5e-8,,1e6,1e-6,0.01,1e-9
";

/// Lines of console blocks that begin with one of these are run.
const PROGRAMS: [&str; 2] = ["truearea ", "grep "];

/// Lines of console blocks that begin with one of these are commands for people, and end the output above them.
const NOT_RUN: [&str; 2] = ["cargo ", "pip "];

/// Stands for any lines in a shown output, and inside a line for any text.
const ELISION: &str = "...";

/// A call that a page shows, with the lines of output that it shows below the call.
struct Call {
    command: String,
    shown: Vec<String>,
}

fn top() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..")
}

/// The README and the pages of the folders of `docs/`. Those on Python are run by the tests of the package.
fn pages() -> Vec<PathBuf> {
    let folders =
        ["docs", "docs/tutorials", "docs/guide", "docs/theory", "docs/develop"].map(|name| top().join(name));
    let files = folders.iter().flat_map(|folder| std::fs::read_dir(folder).unwrap());
    let pages = files.map(|entry| entry.unwrap().path());
    let pages = pages.filter(|path| path.extension().is_some_and(|extension| extension == "md"));
    pages.chain([top().join("README.md")]).collect()
}

/// The calls in the console blocks of a page, continued lines joined.
fn calls(page: &str) -> Vec<Call> {
    let mut calls: Vec<Call> = Vec::new();
    for block in page.split("```console\n").skip(1).filter_map(|rest| rest.split("```").next()) {
        let first = calls.len();
        for line in block.replace("\\\n", " ").lines() {
            let begins_with_one_of = |programs: [&str; 2]| programs.iter().any(|name| line.starts_with(name));
            if begins_with_one_of(PROGRAMS) || begins_with_one_of(NOT_RUN) {
                calls.push(Call { command: line.to_owned(), shown: Vec::new() });
            } else if calls.len() > first {
                calls.last_mut().unwrap().shown.push(line.trim_end().to_owned());
            }
        }
    }
    for call in &mut calls {
        let blank = call.shown.iter().rev().take_while(|line| line.is_empty()).count();
        call.shown.truncate(call.shown.len() - blank);
    }
    calls.retain(|call| PROGRAMS.iter().any(|name| call.command.starts_with(name)));
    calls
}

/// True if the printed lines are the shown ones, but for what the elisions stand for.
fn agree<S: AsRef<str>, P: AsRef<str>>(shown: &[S], printed: &[P]) -> bool {
    match shown.split_first() {
        None => printed.is_empty(),
        Some((line, rest)) if line.as_ref() == ELISION => {
            (0..=printed.len()).any(|from| agree(rest, &printed[from..]))
        }
        Some((line, rest)) => printed.split_first().is_some_and(|(first, others)| {
            lines_agree(line.as_ref(), first.as_ref().trim_end()) && agree(rest, others)
        }),
    }
}

fn lines_agree(shown: &str, printed: &str) -> bool {
    let mut parts = shown.split(ELISION);
    let Some(mut left) = printed.strip_prefix(parts.next().unwrap()) else { return false };
    let mut parts: Vec<&str> = parts.collect();
    let Some(end) = parts.pop() else { return left.is_empty() };
    for part in parts {
        let Some((_, after)) = left.split_once(part) else { return false };
        left = after;
    }
    left.ends_with(end)
}

/// The scenes that pages tell step by step, by the name of their page.
fn scenes() -> [(&'static str, String); 4] {
    ["gasket", "electrical-contact", "bolted-joint", "contact-challenge"]
        .map(|name| (name, std::fs::read_to_string(top().join(format!("data/scenes/{name}.toml"))).unwrap()))
}

/// A folder with the files that the calls of pages read.
fn bench_with_inputs() -> Bench {
    let bench = Bench::new();
    let spectrum = std::fs::read(top().join("data/uncd_psd_measured.csv")).unwrap();
    bench.write("psd.csv", spectrum).write("my_psd.csv", "wavelength_m,C1D_m3\n1e-5,1e-20\n1e-6,1e-23\n");
    for table in ["spheres.csv", "sinusoids.csv", "rows.csv"] {
        bench.write(table, ROWS);
    }
    bench.write(
        "pressures.csv",
        "pressure_pa,rms_pressure_pa,hardness_pa,hardness_growth\n54e6,5.4e9,5.4e9,0.5\n",
    );
    let rows = (0..4000).map(|i| format!("{i} {}\n", 0.01 * f64::from(i * i % 97)));
    let face = (0..4000).map(|i| format!("{i} {}\n", 0.002 * f64::from(i * i % 89)));
    bench.write("trace.txt", rows.collect::<String>()).write("face.txt", face.collect::<String>());
    std::fs::create_dir_all(bench.path("data/scenes")).unwrap();
    for (name, scene) in scenes() {
        bench.write(&format!("data/scenes/{name}.toml"), scene);
    }
    bench
}

/// Runs the calls of a page one after the other in a folder of their own. Returns the number of outputs compared, or
/// the calls that went wrong.
fn run_page(page: &Path) -> Result<[usize; 2], String> {
    let bench = bench_with_inputs();
    let folder = Path::new(env!("CARGO_BIN_EXE_truearea")).parent().unwrap();
    let others = std::env::var_os("PATH").unwrap();
    let path = std::env::join_paths(std::iter::once(folder.to_owned()).chain(std::env::split_paths(&others)));
    let path = path.unwrap();
    let calls = calls(&std::fs::read_to_string(page).unwrap());
    let compared = calls.iter().filter(|call| !call.shown.is_empty()).count();
    let mut wrong = String::new();
    for Call { command, shown } in &calls {
        // In one stream, in the order in which a terminal has them.
        let script = format!("{{ {command}\n}} 2>&1");
        let mut shell = Command::new("bash");
        let output =
            shell.args(["-c", &script]).env("PATH", &path).current_dir(bench.path("")).output().unwrap();
        let printed = String::from_utf8_lossy(&output.stdout);
        let lines: Vec<&str> = printed.lines().collect();
        if !output.status.success() || !(shown.is_empty() || agree(shown, &lines)) {
            let shown = shown.join("\n");
            wrong += &format!("{}: {command}\n--- shown\n{shown}\n--- printed\n{printed}\n", page.display());
        }
    }
    if wrong.is_empty() { Ok([calls.len(), compared]) } else { Err(wrong) }
}

#[test]
fn pages_show_the_scenes_that_they_run() {
    for (name, scene) in scenes() {
        let page = format!("docs/guide/{name}.md");
        let text = std::fs::read_to_string(top().join(&page)).unwrap();
        assert!(text.contains(&format!("```toml\n{scene}```")), "{page} and data/scenes/{name}.toml");
    }
}

#[test]
fn every_call_shown_succeeds_and_prints_what_the_page_shows() {
    let pages = pages();
    let results: Vec<_> = std::thread::scope(|scope| {
        let running: Vec<_> = pages.iter().map(|page| scope.spawn(|| run_page(page))).collect();
        running.into_iter().map(|page| page.join().unwrap()).collect()
    });
    let wrong: Vec<&String> = results.iter().filter_map(|result| result.as_ref().err()).collect();
    assert!(wrong.is_empty(), "{}", wrong.into_iter().cloned().collect::<String>());
    let [calls, compared] =
        [0, 1].map(|i| results.iter().map(|result| result.as_ref().unwrap()[i]).sum::<usize>());
    assert!(calls > 30 && compared > 12, "{calls} calls found, {compared} of them with output");
}

#[test]
fn an_elision_stands_for_any_lines_or_any_text_and_nothing_else_is_passed_over() {
    let printed = ["a,b", "1,2", "3,4", "5,6"];
    for shown in [
        &["a,b", "1,2", "3,4", "5,6"][..],
        &["a,b", "..."],
        &["...", "3,...", "5,6"],
        &["a...", "...", "...,6"],
    ] {
        assert!(agree(shown, &printed), "{shown:?}");
    }
    for shown in
        [&["a,b", "1,2", "3,4"][..], &["a,b", "...", "5,7"], &["a,b", "3,4", "..."], &["...", "1,...", "5,6"]]
    {
        assert!(!agree(shown, &printed), "{shown:?}");
    }
}
