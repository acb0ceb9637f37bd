//! A run that tells how sure its areas are: what it writes, when it draws, and how draws are ended.

use crate::support::{Bench, assert_names};

const SCENE: &str = "[surface]\npsd = \"e.csv\"\n[material]\nyoungs_modulus = \"463 GPa\"\n\
                     poisson_ratio = 0.2\n[loads]\npressures = [\"1 MPa\"]\n[[curve]]\nname = \"c\"\nmodel = \"persson\"\n";

/// A spectrum of three decades that rolls off at the longest, each value with a standard error of a tenth or none.
fn spectrum(has_errors: bool) -> String {
    let error = |c1d_m3: f64| if has_errors { format!(",{:e}", 0.1 * c1d_m3) } else { String::new() };
    let sample = |at: i32| {
        let wavelength_m = 1e-5 * 10f64.powf(-f64::from(at) / 10.0);
        let c1d_m3 = 1e-20 / (1.0 + 1e-6 / wavelength_m).powf(2.6);
        format!("{wavelength_m:e},{c1d_m3:e}{}\n", error(c1d_m3))
    };
    let heads = if has_errors { "wavelength_m,C1D_m3,C1D_se_m3\n" } else { "wavelength_m,C1D_m3\n" };
    heads.to_owned() + &(0..=30).map(sample).collect::<String>()
}

const TABLES: [&str; 3] = ["report-advice.csv", "report-sobol.csv", "report-uncertainty.csv"];

fn bench(section: &str) -> Bench {
    let bench = Bench::new();
    bench.write("s.toml", format!("{SCENE}{section}")).write("e.csv", spectrum(true));
    bench
}

fn written(bench: &Bench) -> Vec<String> {
    let folder = bench.path("s-results");
    let entries = std::fs::read_dir(folder).into_iter().flatten();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

fn has_intervals(bench: &Bench) -> bool {
    written(bench).iter().any(|name| name == "report-uncertainty.csv")
}

#[test]
fn an_area_is_told_with_its_interval_in_words_table_and_page() {
    let bench = bench("[judge]\noff = true\n");
    // As it stands before lines are broken.
    let said = bench.run(&["run", "s.toml", "-v"]).ok().replace('\n', " ");
    assert_names(&said, &["95 %", "2000 draws"]);
    let table = bench.read("s-results/report-uncertainty.csv");
    let rows: Vec<&str> = table.lines().filter(|line| !line.starts_with('#')).collect();
    assert_eq!(rows.len(), 2, "{table}");
    assert!(rows[0].starts_with("curve,nominal_pressure_pa,area_fraction,median,low,high,level,"), "{table}");
    let cells: Vec<f64> = rows[1].split(',').skip(2).map_while(|cell| cell.parse().ok()).collect();
    let [area, median, low, high, level, ..] = cells[..] else { panic!("{table}") };
    assert!(low < median && median < high && (area / median - 1.0).abs() < 0.02, "{table}");
    assert_eq!(level, 0.95);
    assert!(bench.read("s-results/report.html").contains("id=\"how-sure\""));
}

#[test]
fn draws_are_made_where_a_report_or_the_scene_asks_for_them() {
    let calls: [(&str, &[&str], bool); 6] = [
        ("", &[], true),
        ("", &["--no-uncertainty"], false),
        ("", &["--no-report"], false),
        ("[uncertainty]\ndraws = 50\n", &["--no-report"], true),
        ("[uncertainty]\ndraws = 50\n", &["--no-report", "--no-uncertainty"], false),
        ("[uncertainty]\noff = true\n", &[], false),
    ];
    for (section, options, drawn) in calls {
        let bench = bench(section);
        bench.run(&[&["run", "s.toml", "--no-judge"], options].concat()).ok();
        assert_eq!(has_intervals(&bench), drawn, "{section:?} {options:?}");
    }
}

#[test]
fn a_scene_of_which_nothing_scatters_is_not_drawn() {
    let bench = Bench::new();
    bench.write("s.toml", SCENE).write("e.csv", spectrum(false));
    bench.run(&["run", "s.toml", "--no-judge"]).ok();
    assert!(!has_intervals(&bench) && !bench.read("s-results/report.html").contains("id=\"how-sure\""));
    assert!(!bench.run(&["run", "s.toml", "--dry-run"]).ok().contains("draws"));
}

#[test]
fn tables_of_draws_replace_no_input() {
    let bench = Bench::new();
    let scene = SCENE.replace("e.csv", "report-uncertainty.csv");
    bench.write("s.toml", &scene).write("report-uncertainty.csv", spectrum(true));
    bench.run(&["run", "s.toml", "--out", "."]).refused_naming(&["report-uncertainty.csv", "replace"]);
    bench.run(&["run", "s.toml", "--out", ".", "--no-uncertainty", "--no-judge"]).ok();
    assert_eq!(bench.read("report-uncertainty.csv"), spectrum(true));
}

#[cfg(target_os = "linux")]
mod signals {
    use std::io::Read;
    use std::process::{Child, Command, Stdio};
    use std::time::Duration;

    use super::{SCENE, TABLES, spectrum, written};
    use crate::support::Bench;

    /// Draws without end, each of which takes a while.
    fn bench() -> Bench {
        let loads: Vec<String> = (1..60).map(|load| format!("\"{load} MPa\"")).collect();
        let scene = SCENE.replace("\"1 MPa\"", &loads.join(", "));
        let bench = Bench::new();
        bench.write("s.toml", format!("{scene}[uncertainty]\ndraws = 1000000\n"));
        bench.write("e.csv", spectrum(true));
        bench
    }

    /// A run whose signals are not those that the caller of this test happens to ignore.
    fn spawn(bench: &Bench) -> Child {
        Command::new("env")
            .args(["--default-signal=INT", env!("CARGO_BIN_EXE_truearea"), "run", "s.toml"])
            .args(["--no-judge", "--no-report"])
            .current_dir(bench.path(""))
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap()
    }

    /// Exit status and stderr of a run that receives these signals after a while.
    fn ended(bench: &Bench, after: Duration, signals: &str) -> (Option<i32>, String) {
        let mut child = spawn(bench);
        std::thread::sleep(after);
        let script = signals.replace("PID", &child.id().to_string());
        assert!(Command::new("bash").args(["-c", &script]).status().unwrap().success());
        let status = child.wait().unwrap().code();
        let mut said = String::new();
        child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
        (status, said)
    }

    /// Long enough that draws are made, however busy the machine is: at first a little, then more.
    const PATIENCE_S: [u64; 3] = [2, 10, 40];

    #[test]
    fn the_first_signal_ends_the_draws_alone() {
        for seconds in PATIENCE_S {
            let bench = bench();
            let (status, said) = ended(&bench, Duration::from_secs(seconds), "kill -INT PID");
            let files = written(&bench);
            if files.is_empty() {
                continue;
            }
            assert_eq!(status, Some(130), "{said}");
            assert!(said.contains("the draws were stopped after "), "{said}");
            for table in ["c.csv", TABLES[2]] {
                assert!(files.iter().any(|name| name == table), "{table}: {files:?}");
            }
            return;
        }
        panic!("no draws were made");
    }

    #[test]
    fn the_second_signal_leaves_nothing() {
        let seconds = Duration::from_secs(PATIENCE_S[0]);
        let bench = bench();
        let (status, said) = ended(&bench, seconds, "kill -INT PID; sleep 0.02; kill -INT PID");
        assert!(written(&bench).is_empty(), "{:?}, {said}", written(&bench));
        assert_eq!(status, Some(130), "{said}");
    }
}
