//! Inputs after every command that writes: their bytes are those before, whatever results are called.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use clap::CommandFactory;
use cli::args::Args;

use crate::support::Bench;

const BODIES: &str = " --youngs-modulus 463GPa --poisson-ratio 0.2";
const ASPERITIES: &str = "model,youngs_modulus_pa,poisson_ratio,radius_m,density_per_m2,sigma_s_m,pressure_pa,hardness_pa,rms_pressure_pa\n\
                          hertz,2.1e11,0.3,5e-6,2e11,5e-8,1e6,1e9,1e9\n";
const LAWS: &str = "youngs_modulus_pa,poisson_ratio,yield_strength_pa,radius_m,interference_m,wavelength_m,aspect_ratio,pressure_pa\n\
                    2e11,0.3,1e9,1e-6,1e-9,1e-6,0.01,1e8\n";
const SCENE: &str = "[surface]\nscans = [{ file = \"in2\", unit = \"nm\" }]\n[material]\nyoungs_modulus = \"1 GPa\"\n\
                     poisson_ratio = 0.3\n[loads]\npressures = [\"1 MPa\"]\n[[curve]]\nname = \"c\"\nmodel = \"elastic\"\n\
                     [[figure]]\nname = \"f\"\nshows = \"area\"\nformat = [\"svg\", \"py\"]\n[judge]\noff = true\n[uncertainty]\noff = true\n";

/// Options whose files are read. Every other option with a file is taken to write.
const READ: [&str; 5] = ["list", "input", "hardness-law", "counterface-scans", "counterface-psd"];

/// Words in the name of the value of an option with a file or a folder.
const FILES: [&str; 4] = ["PATH", "FILE", "DIR", "FOLDER"];

/// Commands that read no file.
const READ_NOTHING: [&str; 3] = ["completions", "man", "scene"];

/// Calls of every command, `in` and `in2` for their inputs.
fn calls() -> Vec<String> {
    let scan = " --unit nm";
    let pressed = format!(" --pressure 1MPa{BODIES}");
    let mut calls: Vec<String> = ["sphere", "sinusoid", "sinusoid-interference"]
        .map(|law| format!("asperity {law} --input in@laws"))
        .to_vec();
    calls.extend(["moments", "amplitude", "fit"].map(|command| format!("{command} in@psd")));
    calls.extend([
        format!("stacked in@psd --model elastic{pressed}"),
        format!("statistical in@psd --model hertz{pressed}"),
        "statistical --input in@rows".to_owned(),
        format!("persson in@psd --model elastic{pressed}"),
        "persson --input in@rows".to_owned(),
        format!("persson in@psd --model elastic-plastic{pressed} --hardness-law in2@hardness"),
        format!("gap in@psd --model persson{pressed}"),
        format!("gap in@psd --model persson{pressed} --counterface-scans in2@trace:unit=nm"),
        format!("tangential in@psd --model persson --friction 0.3{pressed}"),
        format!("law in@psd --model persson --dialect csv --pressure-range 1MPa:10MPa{BODIES}"),
        format!("bem in@map --unit nm --size 1um{pressed}"),
        format!("bem in@psd --shortest 1um --grid 16{pressed}"),
        "flow in@map --unit nm --size 1um".to_owned(),
        format!("scan in@trace in2@trace{scan}"),
        format!("scan in@map --size 1um{scan}"),
        format!("roughness in@trace in2@trace{scan}"),
        format!("roughness in@trace in2@trace --scales{scan}"),
        format!("psd in@trace in2@trace{scan}"),
        format!("psd in@map --size 1um{scan} --areal"),
        format!("psd in@trace{scan} --counterface-psd in2@psd"),
        "psd --list in@list in2@trace:unit=nm".to_owned(),
        format!("report in@trace in2@trace{scan} --material gold --pressure 1MPa"),
        "run in@scene in2@trace".to_owned(),
        "figure in@scene in2@trace".to_owned(),
    ]);
    calls
}

fn content(kind: &str) -> String {
    let height = |i: usize| ((i * 7919) % 1009) as f64 / 100.0;
    match kind {
        "laws" => LAWS.to_owned(),
        "rows" => ASPERITIES.to_owned(),
        "psd" => "wavelength_m,C1D_m3\n1e-5,1e-20\n1e-6,1e-23\n1e-7,1e-26\n".to_owned(),
        "hardness" => "depth_m,hardness_pa\n1e-9,2e10\n1e-6,1e10\n".to_owned(),
        "trace" => (0..64).map(|i| format!("{i} {}\n", height(i))).collect(),
        "map" => {
            let row = |row: usize| {
                (0..16).map(|at| format!("{} ", height(16 * row + at))).collect::<String>() + "\n"
            };
            (0..16).map(row).collect()
        }
        "list" => "file,unit\nin2,nm\n".to_owned(),
        "scene" => SCENE.to_owned(),
        kind => panic!("{kind}"),
    }
}

/// A call with inputs of these names in its folder.
struct Case {
    bench: Bench,
    words: Vec<String>,
    inputs: BTreeMap<PathBuf, Vec<u8>>,
}

impl Case {
    /// Puts the inputs of a call into a folder; `names` gives them others than `in` and `in2`.
    fn new(call: &str, names: [&str; 2]) -> Self {
        let bench = Bench::new();
        std::fs::create_dir_all(bench.path("a/b")).unwrap();
        let mut inputs = BTreeMap::new();
        let mut words: Vec<String> = Vec::new();
        for word in call.split(' ') {
            let Some((name, kind)) = word.split_once('@') else {
                words.push(word.to_owned());
                continue;
            };
            let (kind, options) =
                kind.split_once(':').map_or((kind, String::new()), |(kind, rest)| (kind, format!(":{rest}")));
            let name = names[usize::from(name == "in2")];
            let content = content(kind)
                .replace("\"in2\"", &format!("\"{}\"", names[1]))
                .replace("in2,", &format!("{},", names[1]));
            let path = bench.path(name);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(&path, &content).unwrap();
            inputs.insert(path, content.into_bytes());
            // The scene names the scan itself.
            if !(call.contains("@scene") && kind == "trace") {
                words.push(format!("{name}{options}"));
            }
        }
        Case { bench, words, inputs }
    }

    /// Runs with further words, and asserts that no input has changed.
    #[track_caller]
    fn run(&self, more: &[&str], stdout: Stdio) -> (Option<i32>, String) {
        let mut command = Command::new(env!("CARGO_BIN_EXE_truearea"));
        let ran = command.args(&self.words).args(more).current_dir(self.bench.path("")).stdin(Stdio::null());
        let ran = ran.stdout(stdout).stderr(Stdio::piped()).output().unwrap();
        let said = String::from_utf8_lossy(&ran.stderr).into_owned();
        for (path, content) in &self.inputs {
            let is_kept = std::fs::read(path).unwrap() == *content;
            assert!(is_kept, "{path:?} after {:?} {more:?}: {said}", self.words);
        }
        (ran.status.code(), said)
    }

    /// True for a table that may be extended in its own place.
    fn extends(&self, option: &str) -> bool {
        option == "output" && self.words.contains(&"--input".to_owned())
    }
}

/// The options of a command that take a file or a folder and do not read it, and whether they take a folder.
fn writing_options(words: &[String]) -> Vec<(String, bool)> {
    let mut program = Args::command();
    program.build();
    let mut command = program.find_subcommand(&words[0]).unwrap();
    if let Some(below) = words.get(1).and_then(|word| command.find_subcommand(word)) {
        command = below;
    }
    let takes = |argument: &&clap::Arg| {
        let names = argument.get_value_names().unwrap_or_default();
        names.iter().any(|name| FILES.iter().any(|file| name.contains(file)) && *name != "PATHS")
    };
    let options = command.get_arguments().filter(takes).filter_map(|argument| {
        let is_folder = argument.get_value_names().unwrap().iter().any(|name| *name == "DIR");
        Some((argument.get_long()?.to_owned(), is_folder))
    });
    options.filter(|(option, _)| !READ.contains(&option.as_str())).collect()
}

fn leaves(command: &clap::Command, path: &str, found: &mut Vec<String>) {
    for below in command.get_subcommands().filter(|below| below.get_name() != "help") {
        let path = format!("{path} {}", below.get_name());
        if below.has_subcommands() { leaves(below, &path, found) } else { found.push(path.trim().to_owned()) }
    }
}

#[test]
fn every_command_that_reads_files_is_called() {
    let mut found = Vec::new();
    leaves(&Args::command(), "", &mut found);
    for command in found {
        let is_called = calls().iter().any(|call| call.starts_with(&format!("{command} ")));
        assert!(is_called || READ_NOTHING.contains(&command.as_str()), "{command} has no call here");
    }
}

#[cfg(unix)]
#[test]
fn no_file_of_a_result_replaces_an_input_under_any_name() {
    for call in calls() {
        let names = ["in.svg", "in2.svg"];
        let plain = Case::new(&call, names);
        let options = writing_options(&plain.words);
        assert!(options.iter().any(|(option, _)| option == "output"), "{call}");
        for (option, _) in options.iter().filter(|(_, is_folder)| !is_folder) {
            let option = format!("--{option}");
            for input in plain.inputs.keys() {
                let name = input.file_name().unwrap().to_str().unwrap();
                std::os::unix::fs::symlink(name, plain.bench.path("soft.svg")).unwrap();
                std::fs::hard_link(input, plain.bench.path("hard.svg")).unwrap();
                std::os::unix::fs::symlink("../soft.svg", plain.bench.path("a/soft.svg")).unwrap();
                let absolute = input.display().to_string();
                for spelling in [
                    name,
                    &format!("./{name}"),
                    &format!("a/../{name}"),
                    &format!("a//b/../../{name}"),
                    "soft.svg",
                    "a/soft.svg",
                    "hard.svg",
                    &absolute,
                ] {
                    if !plain.extends(&option[2..]) {
                        assert_eq!(
                            plain.run(&[&option, spelling], Stdio::null()).0,
                            Some(2),
                            "{call} {option} {spelling}"
                        );
                    }
                }
                for link in ["soft.svg", "hard.svg", "a/soft.svg"] {
                    std::fs::remove_file(plain.bench.path(link)).unwrap();
                }
                let appended = std::fs::File::options().append(true).open(input).unwrap();
                plain.run(&[], appended.into());
            }
        }
    }
}

/// Lists the files below a folder.
fn files_below(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries.flat_map(|path| if path.is_dir() { files_below(&path) } else { vec![path] }).collect()
}

#[test]
fn no_file_in_a_folder_of_results_replaces_an_input() {
    for call in calls() {
        let plain = Case::new(&call, ["in", "in2"]);
        for (option, _) in writing_options(&plain.words).iter().filter(|(_, is_folder)| *is_folder) {
            let option = format!("--{option}");
            let (status, said) = plain.run(&[&option, "results"], Stdio::null());
            assert_eq!(status, Some(0), "{call}: {said}");
            for product in files_below(&plain.bench.path("results")) {
                let product = product.strip_prefix(plain.bench.path("results")).unwrap().to_str().unwrap();
                for names in [[product, "in2"], ["in", product]] {
                    let case = Case::new(&call, names);
                    if case.inputs.contains_key(&case.bench.path(product)) {
                        case.run(&[&option, "."], Stdio::null());
                    }
                }
            }
        }
    }
}

#[test]
fn nothing_is_published_where_no_file_was_readable() {
    for command in ["scan", "roughness", "roughness --scales", "psd"] {
        let bench = Bench::new();
        bench.write("results.csv", "earlier");
        let words: Vec<&str> = command.split(' ').chain(["absent.txt", "--output", "results.csv"]).collect();
        bench.run(&words).refused_naming(&["absent.txt"]);
        assert_eq!(bench.read("results.csv"), "earlier", "{command}");
    }
}

#[test]
fn a_table_replaced_by_its_own_extension_is_named() {
    let bench = Bench::new();
    bench.write("t.csv", LAWS);
    let ran = bench.run(&["asperity", "sphere", "--input", "t.csv", "--output", "t.csv"]);
    ran.ok_remarking(&["t.csv", "replaced"]);
    assert!(bench.read("t.csv").starts_with(LAWS.lines().next().unwrap()));
}

#[cfg(unix)]
#[test]
fn what_a_killed_run_left_is_removed_and_what_another_run_holds_is_not() {
    use tables::staging::StagedFiles;
    let bench = Bench::new();
    bench.write(".truearea-tmp-killed", "half");
    let mut held = StagedFiles::default();
    held.stage(&bench.path("later"), |out| out.write_all(b"whole")).unwrap();
    bench.run(&["moments", "builtin:uncd-measured", "--output", "m.csv"]).ok();
    assert!(!bench.path(".truearea-tmp-killed").exists());
    held.publish().unwrap();
    assert_eq!(bench.files(), ["later", "m.csv"]);
}

#[test]
fn equal_runs_give_equal_bytes() {
    let bench = Bench::new();
    bench.write("in2", content("trace"));
    bench.write("s.toml", SCENE.replace("[\"svg\", \"py\"]", "[\"svg\", \"py\", \"pdf\", \"png\"]"));
    let run = || {
        bench.run_with_env(&["run", "s.toml", "--out", "o"], "SOURCE_DATE_EPOCH", "0").ok();
        let files = files_below(&bench.path("o")).into_iter();
        files.map(|path| (path.clone(), std::fs::read(path).unwrap())).collect::<BTreeMap<_, _>>()
    };
    let first = run();
    std::thread::sleep(std::time::Duration::from_millis(1100));
    let second = run();
    assert!(first.len() > 5 && first.keys().eq(second.keys()));
    assert!(first.iter().all(|(path, bytes)| second[path] == *bytes));
}

#[test]
fn a_picture_that_is_too_large_is_refused() {
    let bench = Bench::new();
    bench.write("in2", content("trace")).write("s.toml", SCENE);
    let call = ["figure", "s.toml", "--picture", "png", "--width", "1000mm"];
    bench.run(&call).refused_naming(&["f.png", "too large", ".svg"]);
    assert!(!bench.path("f.png").exists());
}

#[test]
fn names_of_files_have_as_many_folders_as_tell_them_apart() {
    let paths = ["a/t.txt", "b/t.txt", "/x/a/u.txt", "t.txt", "c/d/v", "e/d/v", "c/d/v"];
    let short = units::printable::short_paths(paths);
    let expected = ["a/t.txt", "b/t.txt", "u.txt", "t.txt", "c/d/v", "e/d/v", "c/d/v"];
    assert_eq!(paths.map(|path| short[path].as_str()), expected);
}

/// The memory and the time of many files are linear by `cargo xtask instructions`; here they have one instrument.
#[test]
fn texts_of_one_length_and_spacing_share_an_instrument_and_the_report_says_so() {
    let bench = Bench::new();
    let names: Vec<String> = (0..12).map(|at| format!("t{at}.txt")).collect();
    for (at, name) in names.iter().enumerate() {
        let height = |i: usize| ((i * i * (7 * at + 13)) % 997) as f64 / 100.0;
        bench.write(name, (0..64).map(|i| format!("{i} {}\n", height(i))).collect::<String>());
    }
    bench.write("longer.txt", content("trace") + "64 1\n65 2\n");
    let options = ["--unit", "nm", "--material", "gold", "--pressure", "1MPa", "--out", "o"];
    let call: Vec<&str> = ["report"]
        .into_iter()
        .chain(names.iter().map(String::as_str))
        .chain(["longer.txt"])
        .chain(options)
        .collect();
    bench.run(&call).ok();
    let answer = bench.read("o/answer.json");
    assert!(
        answer.contains("\"one-instrument\"") && answer.contains("text of 64 points, 1 nm apart"),
        "{answer}"
    );
    assert!(bench.read("o/report.html").contains("longer.txt (guessed)"));
}

#[test]
fn a_header_with_another_length_than_the_points_is_noted() {
    let bench = Bench::new();
    let rows =
        |count: usize| (0..count).map(|at| format!("{:.1},0.{at},,\n", at as f64 * 0.5)).collect::<String>();
    let text = |header: &str, count| {
        format!("Scan Parameters\n{header}\nScan Data\nLateral um,Raw Micrometer,\n{}", rows(count))
    };
    for (header, is_noted) in [
        ("Length,50.0 um", false),
        ("Length,50.0 um,", false),
        ("Length,250.0 um", true),
        ("Length: 250 um", true),
        ("Length: 20 um", true),
    ] {
        bench.write("t.csv", text(header, 100));
        assert_eq!(bench.run(&["scan", "t.csv"]).ok().contains("the header says"), is_noted, "{header}");
    }
    bench
        .write("t.csv", text("Number of points,400", 100))
        .run(&["scan", "t.csv"])
        .refused_naming(&["400", "100"]);
}
