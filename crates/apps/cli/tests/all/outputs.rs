//! Output files: they appear together or not at all, and never replace an input.

use crate::support::{Bench, DIAMOND};

const PSD: &str = "wavelength_m,C1D_m3\n1e-5,1e-20\n1e-6,1e-23\n1e-7,1e-26\n";
const SCENE: &str = "[surface]\npsd = \"s.csv\"\n[material]\nyoungs_modulus = \"1 GPa\"\npoisson_ratio = 0.3\n\
                     [loads]\npressures = [\"1 MPa\"]\n[[curve]]\nname = \"c\"\nmodel = \"elastic\"\n";

fn profile() -> String {
    let height = |i: usize| ((i * 7919) % 1009) as f64 / 100.0;
    (0..512).map(|i| format!("{i} {}\n", height(i))).collect()
}

#[test]
fn no_output_replaces_an_input() {
    let bench = Bench::new();
    bench.write("raw.txt", profile()).write("s.csv", PSD).write("s.toml", SCENE);
    bench.write("c.csv", PSD).write("c.toml", SCENE.replace("s.csv", "c.csv"));
    let before: Vec<(String, String)> =
        bench.files().into_iter().map(|name| (name.clone(), bench.read(&name))).collect();
    let stacked = ["stacked", "s.csv", "--model", "elastic", "--pressure", "1MPa"];
    let stacked = [&stacked[..], &DIAMOND].concat();
    let psd = ["psd", "raw.txt", "--unit", "nm"];
    let calls = [
        [&psd[..], &["--out", "raw.txt"]].concat(),
        [&psd[..], &["--output", "raw.txt"]].concat(),
        [&psd[..], &["--areal", "--out", "./raw.txt"]].concat(),
        [&stacked[..], &["--output", "s.csv"]].concat(),
        ["moments", "s.csv", "--output", "s.csv"].to_vec(),
        ["run", "s.toml", "--output", "s.toml"].to_vec(),
        ["run", "s.toml", "--output", "s.csv"].to_vec(),
        // The table of the curve `c` would be written over its spectrum.
        ["run", "c.toml", "--out", "."].to_vec(),
    ];
    for call in calls {
        let message = bench.run(&call).refused();
        assert!(message.contains(" would replace "), "{call:?}: {message}");
        for (name, content) in &before {
            assert_eq!(bench.read(name), *content, "{call:?}");
        }
        assert_eq!(bench.files().len(), before.len(), "{call:?}");
    }
}

#[test]
fn a_picture_replaces_no_input_either() {
    let bench = Bench::new();
    bench.write("raw.svg", profile()).write("s.png", PSD);
    for call in [["psd", "raw.svg", "--figure", "raw.svg"], ["moments", "s.png", "--figure", "s.png"]] {
        assert!(bench.run(&call).refused().contains("--figure"), "{call:?}");
    }
    assert_eq!((bench.read("raw.svg"), bench.read("s.png")), (profile(), PSD.to_owned()));
}

#[cfg(unix)]
#[test]
fn an_input_is_known_under_other_names_and_through_a_redirection() {
    let bench = Bench::new();
    bench.write("s.csv", PSD);
    std::fs::hard_link(bench.path("s.csv"), bench.path("hard.csv")).unwrap();
    std::os::unix::fs::symlink("s.csv", bench.path("soft.csv")).unwrap();
    for (input, output) in [("s.csv", "soft.csv"), ("soft.csv", "s.csv"), ("s.csv", "hard.csv")] {
        bench.run(&["moments", input, "--output", output]).refused();
    }
    let script = format!("{} moments - --output s.csv < s.csv", env!("CARGO_BIN_EXE_truearea"));
    let mut shell = std::process::Command::new("bash");
    let output = shell.args(["-c", &script]).current_dir(bench.path("")).output().unwrap();
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert_eq!(bench.read("s.csv"), PSD);
}

#[test]
fn a_table_that_is_extended_row_by_row_may_be_replaced() {
    let bench = Bench::new();
    bench.write(
        "t.csv",
        "model,youngs_modulus_pa,poisson_ratio,radius_m,density_per_m2,sigma_s_m,separation_m,pressure_pa\n\
         hertz,2.1e11,0.3,5e-6,2e11,5e-8,,1e6\n",
    );
    bench.run(&["statistical", "--input", "t.csv", "--output", "t.csv"]).ok();
    assert!(bench.read("t.csv").lines().next().unwrap().ends_with("pressure_pa,area_fraction"));
}

#[test]
fn where_one_of_several_files_cannot_be_written_none_is() {
    let bench = Bench::new();
    bench.write("raw.txt", profile()).write("t.csv", "old");
    let ran = bench.run(&["psd", "raw.txt", "--unit", "nm", "--out", "t.csv", "--figure", "no/folder/x.svg"]);
    assert_eq!(ran.status, 1, "{}", ran.stderr);
    assert!(ran.stderr.starts_with("error: writing no/folder/x.svg: "), "{}", ran.stderr);
    assert_eq!(
        (bench.files(), bench.read("t.csv")),
        (vec!["raw.txt".to_owned(), "t.csv".to_owned()], "old".to_owned())
    );
}

#[test]
fn a_picture_is_what_its_name_says() {
    let bench = Bench::new();
    bench.write("raw.txt", profile());
    let psd = ["psd", "raw.txt", "--unit", "nm"].to_vec();
    let spectrum = |command| vec![command, "builtin:uncd-measured"];
    let contact = |command, model| {
        let args = [command, "builtin:uncd-measured", "--model", model, "--pressure", "1MPa"];
        [&args[..], &DIAMOND].concat()
    };
    let both = [contact("statistical", "hertz"), vec!["--separation", "50nm"]].concat();
    for call in [psd, spectrum("moments"), spectrum("amplitude"), contact("stacked", "elastic"), both] {
        let table = bench.run(&call).ok();
        let drawn = |name: &str| {
            let ran = bench.run(&[&call[..], &["--figure", name]].concat()).ok();
            // The first lines of a composite tell the call.
            let rows = |table: &str| table.lines().filter(|line| !line.starts_with('#')).count();
            assert_eq!(rows(&ran), rows(&table), "{call:?}");
            std::fs::read(bench.path(name)).unwrap()
        };
        let (svg, png) = (drawn("figure.svg"), drawn("figure.png"));
        let svg = String::from_utf8(svg).unwrap();
        let svg = roxmltree::Document::parse(&svg).unwrap();
        assert!(svg.descendants().any(|node| node.has_tag_name("path")), "{call:?}");
        let says =
            |words: &str| svg.descendants().any(|node| node.text().is_some_and(|text| text.contains(words)));
        assert_eq!(says("separation 50 nm"), call.contains(&"--separation"), "{call:?}");
        assert!(png.starts_with(b"\x89PNG\r\n\x1a\n"), "{call:?}");
        // 480 pixels of 1/96 inch, at 600 dots per inch.
        let number = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
        assert_eq!(number(16), 3000);
        // 600 dots per inch, in dots per metre.
        let size = png.windows(4).position(|name| name == b"pHYs").expect("a size in print") + 4;
        assert_eq!((number(size), number(size + 4), png[size + 8]), (23622, 23622, 1));
    }
    let call = [contact("stacked", "elastic"), vec!["--figure", "x.gif", "--output", "x.csv"]].concat();
    bench.run(&call).refused_naming(&["--figure", "'x.gif'", ".svg", ".png", ".pdf"]);
    assert!(!bench.path("x.csv").exists());
}

#[cfg(target_os = "linux")]
mod signals {
    use std::io::Read;
    use std::process::{Child, Command, Stdio};
    use std::time::{Duration, Instant};

    use crate::support::{Bench, DIAMOND};

    /// A call whose signals are not those that the caller of this test happens to ignore.
    fn spawn(bench: &Bench, args: &[&str]) -> Child {
        Command::new("env")
            .args(["--default-signal=INT,TERM,HUP", env!("CARGO_BIN_EXE_truearea")])
            .args(args)
            .current_dir(bench.path(""))
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap()
    }

    fn signal(child: &Child, name: &str) {
        let sent = Command::new("kill").args([name, &child.id().to_string()]).status().unwrap();
        assert!(sent.success());
    }

    #[test]
    fn a_signal_ends_the_work_and_leaves_no_file() {
        for name in ["-INT", "-TERM"] {
            let bench = Bench::new();
            let args = [
                "stacked",
                "builtin:uncd-measured",
                "--model",
                "elastic",
                "--pressures",
                "1kPa:1GPa:1000000",
            ];
            let mut child = spawn(&bench, &[&args[..], &DIAMOND, &["--output", "big.csv"]].concat());
            let begun = Instant::now();
            while bench.files().is_empty() {
                assert!(begun.elapsed() < Duration::from_secs(60), "nothing is written");
                std::thread::sleep(Duration::from_millis(5));
            }
            signal(&child, name);
            assert_eq!(child.wait().unwrap().code(), Some(130), "{name}");
            let mut said = String::new();
            child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
            assert!(said.ends_with("error: ended before the result was there\n"), "{said}");
            assert!(bench.files().is_empty(), "{:?}", bench.files());
        }
    }

    #[test]
    fn a_program_that_waits_for_its_input_ends_too() {
        let bench = Bench::new();
        let mut child = spawn(&bench, &["moments", "-", "--output", "m.csv"]);
        // Until it listens, it ends by the signal itself.
        std::thread::sleep(Duration::from_millis(300));
        let kept_open = child.stdin.take();
        signal(&child, "-INT");
        assert_eq!(child.wait().unwrap().code(), Some(130));
        drop(kept_open);
        assert!(bench.files().is_empty());
    }
}

#[test]
fn figures_of_a_scene_are_drawn_for_print_and_touch_no_other_file() {
    let bench = Bench::new();
    let steel = "youngs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n";
    std::fs::create_dir(bench.path("report")).unwrap();
    bench.write(
        "report/scene.toml",
        format!(
            "title = \"t\"\n[surface]\npsd = \"builtin:uncd-measured\"\n[material]\n{steel}\
             [loads]\npressures = [\"1 MPa\", \"10 MPa\"]\n[[curve]]\nmodel = \"elastic\"\n\
             [[curve]]\nmodel = \"persson\"\n[[figure]]\nname = \"f\"\nshows = \"area\"\n\
             [[figure]]\nname = \"g\"\nshows = \"psd\"\n[uncertainty]\noff = true\n"
        ),
    );
    bench.write("report/f.csv", "kept");
    let chosen = ["--only", "f", "--models", "persson", "--loads", "10MPa", "--no-title", "--width", "85mm"];
    let files = ["--picture", "svg,png,pdf", "--out", "report"];
    let printed = bench.run(&[&["figure", "report"], &chosen[..], &files[..]].concat()).ok();
    assert_eq!(printed.lines().count(), 3, "{printed}");
    let svg = bench.read("report/f.svg");
    assert!(
        svg.contains(" width=\"85.00mm\"") && svg.contains("Persson") && !svg.contains("Archard"),
        "{svg}"
    );
    assert!(svg.contains("10 MPa") && !svg.contains(">1 MPa") && !svg.contains(">t</text>"), "{svg}");
    assert!(svg.contains(">boundary elements</text>") && svg.contains(">linear laws</text>"), "{svg}");
    let fast = ["figure", "report", "--only", "f", "--no-judge", "--picture", "py", "--out", "fast"];
    bench.run(&fast).ok();
    assert!(!bench.read("fast/f.csv").contains("elements"));
    let judged = ["figure", "report", "--only", "f", "--picture", "py", "--out", "judged"];
    bench.run(&judged).ok();
    assert!(bench.read("judged/f.csv").contains(",elastic elements at 10 MPa low,"));
    let script = bench.read("judged/f.py");
    assert!(script.contains("\"elastic elements at 10 MPa\"") && script.lines().count() <= 40, "{script}");
    let bytes = |name: &str| std::fs::read(bench.path(name)).unwrap();
    assert!(bytes("report/f.png").starts_with(b"\x89PNG"));
    let pdf = bytes("report/f.pdf");
    let holds = |text: &[u8]| pdf.windows(text.len()).any(|window| window == text);
    assert!(pdf.starts_with(b"%PDF-") && holds(b"DejaVuSans") && holds(b"/MediaBox [0 0 240.9"));
    assert!(!bench.path("report/g.svg").exists() && bench.read("report/f.csv") == "kept");
    let scene = bench.read("report/scene.toml") + "[figures]\nformat = [\"pdf\"]\n";
    bench.write("own.toml", scene);
    bench.run(&["run", "own.toml", "--no-judge", "--out", "run"]).ok();
    for name in ["f.pdf", "f.svg", "g.pdf"] {
        assert!(bench.path("run").join(name).exists(), "{name}");
    }
    bench.write("own.toml", bench.read("own.toml").replace("\"f\"", "\"e\""));
    bench.run(&["run", "own.toml", "--no-judge", "--out", "run"]).ok();
    assert!(bench.path("run/e.pdf").exists() && !bench.path("run/f.pdf").exists());
    // A spectrum by the name of the picture.
    let spectrum = "wavelength_m,C1D_m3\n1e-6,4e-24\n5e-7,1e-24\n";
    bench.write("e.svg", spectrum);
    bench.write("own.toml", bench.read("own.toml").replace("builtin:uncd-measured", "e.svg"));
    bench.run(&["figure", "own.toml", "--only", "e"]).refused_naming(&["e.svg"]);
    assert_eq!(bench.read("e.svg"), spectrum);
    for wrong in [["--only", "h"], ["--models", "hertz"], ["--loads", "2MPa"]] {
        let call = [&["figure", "report"], &wrong[..]].concat();
        bench.run(&call).refused_naming(&[wrong[1]]);
    }
}
