//! Hostile files, faults and company: nothing that a file holds reaches a terminal or a page as more than text, no
//! message is longer than a screen, and whatever ends the program leaves whole files.

use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::support::{Bench, Ran, assert_names, column};

/// Texts that terminals, browsers, spreadsheets or readers of tables would take for more than text.
const HOSTILE: [&str; 6] = [
    "<script>alert(1)</script>",
    "\"><img src=x onload=alert(1)>",
    "a\u{1b}]0;owned\u{7}\u{1b}[2Jb",
    "\u{202e}cod.exe\u{2066}\u{2069}",
    "=HYPERLINK(\"http://example.com\")",
    "\u{9b}31m\u{7f}\u{1}'&amp;--> ]]>",
];

const SCENE: &str = r#"
title = "TITLE"
[surface]
psd = "PSD"
[material]
youngs_modulus = "210 GPa"
poisson_ratio = 0.3
yield_strength = "1 GPa"
[loads]
pressures = ["10 MPa", "100 MPa"]
[[curve]]
model = "elastic"
[[curve]]
model = "elastic-plastic"
[judge]
off = true
[uncertainty]
off = true
"#;

/// A file of Molecular Imaging with this name of its channel.
fn molecular_imaging(name: &str) -> String {
    format!(
        "fileType      Image\nversion       PicoView 0x10c04\ncomment       {name}\nxPixels       3\nyPixels       2\n\
         xLength       3.0e-006\nyLength       1.0e-006\n  more        bufferLabel\nbufferLabel   {name}\n\
         bufferRange   3.2768e+000\nbufferUnit    um\ntrace         Trace\ndata          ASCII\n1 \n2 \n3 \n4 \n5 \n-6 \n"
    )
}

/// A profile in um, with a hostile comment.
fn profile(comment: &str) -> String {
    let rows = (0..64).map(|at| format!("{at} {:.4}\n", f64::from((at * 7919) % 101) / 101.0));
    format!("# {comment}\n{}", rows.collect::<String>())
}

/// A TOML string of a text.
fn toml(text: &str) -> String {
    let escaped = text.chars().map(|c| match c {
        '"' | '\\' => format!("\\{c}"),
        c if c.is_control() => format!("\\u{:04x}", u32::from(c)),
        c => c.to_string(),
    });
    escaped.collect()
}

fn is_obeyed(c: char) -> bool {
    (c.is_control() && !matches!(c, '\n' | '\t'))
        || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// Asserts that a message is text alone, and of a length that people read.
#[track_caller]
fn assert_harmless(ran: &Ran) {
    assert!(!ran.stderr.contains(is_obeyed), "{:?}", ran.stderr);
    assert!(ran.stderr.len() < 20_000, "{} bytes of messages", ran.stderr.len());
    assert!([0, 1, 2].contains(&ran.status), "{}: {}", ran.status, ran.stderr);
}

/// Asserts that a drawing is well-formed and has no element that a file could have put there.
#[track_caller]
fn assert_drawing(svg: &str) {
    assert!(!svg.contains(is_obeyed), "{svg:?}");
    let document = roxmltree::Document::parse(svg).unwrap();
    let is_foreign = |node: &roxmltree::Node<'_, '_>| ["script", "img"].contains(&node.tag_name().name());
    assert!(!document.descendants().any(|node| is_foreign(&node)));
}

#[test]
fn hostile_names_in_scans_are_text_everywhere() {
    for hostile in HOSTILE {
        let bench = Bench::new();
        bench.write("a.mi", molecular_imaging(hostile)).write("b.txt", profile(hostile));
        for figure in ["x.svg", "x.png"] {
            let scanned = bench.run(&["scan", "a.mi", "--figure", figure]);
            assert_harmless(&scanned);
            let table = scanned.ok();
            assert!(
                !column(&table, "channel").iter().any(|cell| cell.starts_with(['=', '+', '@'])),
                "{table}"
            );
        }
        assert_drawing(&bench.read("x.svg"));
        assert_harmless(&bench.run(&["psd", "a.mi"]));
        let spectrum =
            bench.run(&["psd", "b.txt:unit=um", "--output", "c.csv", "--figure", "c.svg", "--provenance"]);
        assert_harmless(&spectrum);
        // A file with control characters is not text.
        if hostile.contains(char::is_control) {
            assert_eq!(spectrum.status, 2, "{}", spectrum.stderr);
            continue;
        }
        spectrum.ok();
        assert_drawing(&bench.read("c.svg"));
        let comments = bench.read("c.csv");
        assert!(comments.lines().all(|line| !line.contains('\r')), "{comments:?}");
    }
}

#[test]
fn hostile_names_in_scenes_and_spectra_are_text_everywhere() {
    for hostile in HOSTILE {
        let bench = Bench::new();
        let table =
            format!("# {hostile}\nwavelength_m,C1D_m3\n1e-5,1e-22\n1e-6,1e-25\n1e-7,1e-28\n1e-8,1e-31\n");
        bench.write("p.csv", table);
        let scene = SCENE.replace("TITLE", &toml(hostile)).replace("PSD", "p.csv");
        let ran = bench.write("s.toml", &scene).run(&["run", "s.toml", "--out", "o"]);
        assert_harmless(&ran);
        ran.ok();
        let page = bench.read("o/report.html");
        assert!(!page.contains(is_obeyed) && !page.contains("<script>alert") && !page.contains("<img src=x"));
        for entry in std::fs::read_dir(bench.path("o")).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|ending| ending == "svg") {
                assert_drawing(&std::fs::read_to_string(path).unwrap());
            }
        }
        for scene in [
            SCENE.replace("PSD", &toml(hostile)),
            SCENE
                .replace("PSD", "p.csv")
                .replace("model = \"elastic\"", &format!("model = \"{}\"", toml(hostile))),
            SCENE.replace("PSD", "p.csv").replace("[judge]", &format!("[\"{}\"]", toml(hostile))),
        ] {
            let refused = bench.write("bad.toml", scene).run(&["run", "bad.toml", "--out", "bad"]);
            assert_harmless(&refused);
            refused.refused();
        }
        let refused = bench.write("h.csv", format!("{hostile},b\n1,2\n")).run(&["moments", "h.csv"]);
        assert_harmless(&refused);
        refused.refused();
    }
}

#[test]
#[cfg(unix)]
fn hostile_names_of_files_are_text_in_messages() {
    let bench = Bench::new();
    for hostile in HOSTILE.iter().filter(|name| !name.contains('/')) {
        bench.write(&format!("{hostile}.txt"), profile("a"));
    }
    let scanned = bench.run(&["scan", ".", "--unit", "um", "--figure", "x.svg"]);
    assert_harmless(&scanned);
    assert!(column(&scanned.ok(), "file").len() >= 4);
    assert_harmless(&bench.run(&["psd", "\u{1b}[2J.txt"]));
}

#[test]
#[cfg(target_os = "linux")]
fn names_of_files_that_are_not_utf_8_are_read_in_folders_and_refused_as_words() {
    use std::os::unix::ffi::OsStrExt;
    let bench = Bench::new();
    let name = std::ffi::OsStr::from_bytes(b"\xff.txt");
    std::fs::write(bench.path("").join(name), profile("a")).unwrap();
    assert_eq!(column(&bench.run(&["scan", ".", "--unit", "um"]).ok(), "file").len(), 1);
    let program = env!("CARGO_BIN_EXE_truearea");
    let refused = Command::new(program).current_dir(bench.path("")).arg("scan").arg(name).output().unwrap();
    assert_eq!(refused.status.code(), Some(2));
}

#[test]
fn containers_with_hostile_paths_write_nothing_elsewhere() {
    use std::io::Write;
    let bench = Bench::new();
    let mut zip = zip::ZipWriter::new(std::fs::File::create(bench.path("a.zip")).unwrap());
    for path in ["../escaped.txt", "/tmp/escaped-by-truearea.txt", "<script>.txt", "a\u{1b}[2J.txt"] {
        zip.start_file(path, zip::write::SimpleFileOptions::default()).unwrap();
        zip.write_all(profile("a").as_bytes()).unwrap();
    }
    zip.finish().unwrap();
    for command in ["scan", "psd"] {
        assert_harmless(&bench.run(&[command, "a.zip", "--unit", "um"]));
    }
    assert_eq!(bench.files(), ["a.zip"]);
    assert!(!Path::new("/tmp/escaped-by-truearea.txt").exists());
    assert!(!bench.path("../escaped.txt").exists());
}

/// Gives every command lines, names and tables of this length, and returns the time that they take together.
fn time_of_absurd_lengths(length: usize) -> Duration {
    let bench = Bench::new();
    let columns: String = (0..length).map(|at| format!("c{at},")).collect();
    bench.write("header.csv", format!("{columns}z\n"));
    bench.write("name.csv", format!("{}\n1\n", "n".repeat(3 * length)));
    bench.write("twice.csv", format!("{0},{0}\n1,2\n", "n".repeat(3 * length)));
    bench.write("title.toml", SCENE.replace("TITLE", &"t".repeat(length / 3)).replace("PSD", "missing.csv"));
    bench.write("key.toml", format!("{} = 1\n", "k".repeat(3 * length)));
    bench.write("rows.txt", "1 ".repeat(2 * length));
    let begun = Instant::now();
    for args in [
        &["moments", "header.csv"][..],
        &["moments", "name.csv"],
        &["persson", "--input", "header.csv"],
        &["persson", "--input", "twice.csv"],
        &["psd", "--list", "header.csv"],
        &["psd", "--list", "name.csv"],
        &["run", "title.toml"],
        &["run", "key.toml"],
        &["scan", "header.csv"],
        &["psd", "rows.txt"],
    ] {
        assert_harmless(&bench.run(args));
    }
    begun.elapsed()
}

#[test]
fn absurd_lengths_end_in_short_messages_soon() {
    let short = time_of_absurd_lengths(30_000);
    let long = time_of_absurd_lengths(300_000);
    // Ten times the length takes at most ten times as long, beside ten programs' starts; squares would take a hundred.
    assert!(long < 40 * short, "{short:?} {long:?}");
}

#[test]
fn many_scans_are_compared_in_one_sentence() {
    let bench = Bench::new();
    for at in 0..12 {
        bench.write(&format!("{at}.txt"), profile("a").replace("0.4", &format!("0.4{at}")));
    }
    let list: String = (0..12).map(|at| format!("{at}.txt,um\n")).collect();
    let ran = bench.write("list.csv", format!("file,unit\n{list}")).run(&["psd", "--list", "list.csv"]);
    assert_eq!(ran.remarks(&["more pairs of overlapping scans"]).len(), 1, "{}", ran.stderr);
    assert_eq!(ran.remarks(&[" over "]).len(), 10, "{}", ran.stderr);
    ran.ok();
}

#[test]
#[cfg(target_os = "linux")]
fn a_device_that_never_ends_is_read_up_to_a_bound() {
    let refused = Bench::new().run(&["moments", "/dev/zero"]);
    refused.refused_naming(&["/dev/zero", "1 GiB"]);
}

#[test]
fn a_text_that_may_be_cut_off_is_noted() {
    let bench = Bench::new();
    let whole = profile("a");
    bench.write("whole.txt", &whole).write("cut.txt", &whole[..whole.len() - 3]);
    assert_names(&bench.run(&["scan", "cut.txt:unit=um"]).ok(), &["cut off"]);
    assert!(!bench.run(&["scan", "whole.txt:unit=um"]).ok().contains("cut off"));
}

#[test]
fn provenance_quotes_no_folder_of_the_machine_unless_asked() {
    let bench = Bench::new();
    bench
        .write("b.txt", profile("a"))
        .write("p.csv", "wavelength_m,C1D_m3\n1e-5,1e-22\n1e-6,1e-25\n1e-7,1e-28\n");
    let folder = bench.path("").display().to_string();
    let scan = format!("{folder}b.txt:unit=um");
    let composite = bench.run(&["psd", &scan]).ok();
    assert!(!composite.contains(&folder) && composite.contains("psd b.txt:unit=um"), "{composite}");
    let full = bench.run(&["psd", &scan, "--provenance=full"]).ok();
    assert!(full.contains(&folder), "{full}");
    let scene = SCENE.replace("PSD", &format!("{folder}p.csv").replace('\\', "/"));
    let path = bench.write("s.toml", scene).path("s.toml").display().to_string();
    bench.run(&["run", &path, "--out", &format!("{folder}o")]).ok();
    for file in std::fs::read_dir(bench.path("o")).unwrap() {
        let text = std::fs::read_to_string(file.unwrap().path()).unwrap();
        assert!(!text.contains(folder.trim_end_matches('/')), "{text}");
    }
}

#[test]
fn a_folder_that_cannot_be_written_is_refused_before_anything_is_computed() {
    let bench = Bench::new();
    bench.write("file", "").write("s.toml", SCENE.replace("PSD", "missing.csv"));
    // The missing spectrum would be noticed next.
    let refused = bench.run(&["run", "s.toml", "--out", "file/o"]);
    assert_eq!(refused.status, 1, "{}", refused.stderr);
    assert_names(&refused.stderr, &["file/o"]);
}

#[test]
fn curves_have_no_names_of_devices() {
    let bench = Bench::new();
    for name in ["nul", "CON", "aux.x", "com1", "LPT9", "a."] {
        let scene = SCENE.replace("PSD", "builtin:uncd-measured");
        let scene = scene.replace("model = \"elastic\"", &format!("model = \"elastic\"\nname = \"{name}\""));
        bench.write("s.toml", scene).run(&["run", "s.toml"]).refused_naming(&[name]);
    }
}

#[test]
fn curves_have_composed_names() {
    let bench = Bench::new();
    let scene = |name: &str| {
        let scene = SCENE.replace("PSD", "builtin:uncd-measured");
        scene.replace("model = \"elastic\"", &format!("model = \"elastic\"\nname = \"{name}\""))
    };
    for name in ["e\u{301}", "\u{1112}\u{1161}\u{11ab}"] {
        bench.write("s.toml", scene(name)).run(&["run", "s.toml"]).refused_naming(&["letter"]);
    }
    for name in ["\u{e9}", "\u{d55c}"] {
        bench.write("s.toml", scene(name)).run(&["run", "s.toml", "--no-report", "--out", "o"]).ok();
        assert!(bench.path(&format!("o/{name}.csv")).exists());
    }
}

/// Starts a run into a folder.
fn start(bench: &Bench, out: &str) -> Child {
    Command::new(env!("CARGO_BIN_EXE_truearea"))
        .args(["run", "s.toml", "--out", out])
        .current_dir(bench.path(""))
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap()
}

/// The files of a folder with their contents, without hidden ones.
fn contents(folder: &Path) -> Vec<(String, String)> {
    let mut files: Vec<(String, String)> = std::fs::read_dir(folder)
        .into_iter()
        .flatten()
        .map(|entry| entry.unwrap().path())
        .filter(|path| !path.file_name().unwrap().to_string_lossy().starts_with('.'))
        .map(|path| {
            (path.file_name().unwrap().to_string_lossy().into_owned(), std::fs::read_to_string(path).unwrap())
        })
        .collect();
    files.sort();
    files
}

/// Asserts that every file is one of a whole run; the report and the answer have dates.
#[track_caller]
fn assert_whole(found: &[(String, String)], whole: &[(String, String)]) {
    for (name, text) in found {
        let (_, expected) = whole.iter().find(|(other, _)| other == name).unwrap();
        match name.rsplit('.').next() {
            Some("html") => assert!(text.trim_end().ends_with("</html>"), "{name}"),
            Some("json") => assert!(text.trim_end().ends_with('}'), "{name}"),
            _ => assert_eq!(text, expected, "{name}"),
        }
    }
}

/// Kills runs at moments spread over their time, each into a folder of its own and all into one.
fn kill_at_many_moments(moments: u32) {
    let bench = Bench::new();
    bench.write("s.toml", SCENE.replace("PSD", "builtin:uncd-measured"));
    let begun = Instant::now();
    assert!(start(&bench, "shared").wait().unwrap().success());
    let time = begun.elapsed();
    let whole = contents(&bench.path("shared"));
    assert!(whole.len() > 4);
    for moment in 0..moments {
        let wait = time * moment / moments;
        for (out, kill) in
            [("shared", "-KILL"), (&format!("own-{moment}"), "-KILL"), (&format!("term-{moment}"), "-TERM")]
        {
            let mut child = start(&bench, out);
            std::thread::sleep(wait);
            if cfg!(unix) && kill == "-TERM" {
                // The child may have ended already.
                let _ =
                    Command::new("kill").args([kill, &child.id().to_string()]).stderr(Stdio::null()).status();
            } else {
                let _ = child.kill();
            }
            let status = child.wait().unwrap();
            let found = contents(&bench.path(out));
            assert_whole(&found, &whole);
            match status.code() {
                Some(0) => assert_eq!(found.len(), whole.len(), "{out}"),
                Some(130) => assert!(found.is_empty(), "{out}: {} files", found.len()),
                _ if out == "shared" => assert_eq!(found.len(), whole.len()),
                _ => {}
            }
        }
    }
    assert!(start(&bench, "shared").wait().unwrap().success());
    let found = contents(&bench.path("shared"));
    assert_eq!(found.len(), whole.len());
    assert_whole(&found, &whole);
}

/// Starts several runs at once into one folder.
fn run_together(rounds: u32, programs: usize) {
    let bench = Bench::new();
    bench.write("s.toml", SCENE.replace("PSD", "builtin:uncd-measured"));
    assert!(start(&bench, "alone").wait().unwrap().success());
    let whole = contents(&bench.path("alone"));
    for round in 0..rounds {
        let out = format!("o-{round}");
        let running: Vec<Child> = (0..programs).map(|_| start(&bench, &out)).collect();
        for mut child in running {
            assert!(child.wait().unwrap().success());
        }
        let found: Vec<_> = contents(&bench.path(&out));
        assert_eq!(found.len(), whole.len());
        for (name, text) in found {
            // Tables begin with the command, which names the folder.
            let rows = |text: &str| {
                text.lines().filter(|line| !line.starts_with('#')).map(str::to_owned).collect::<Vec<_>>()
            };
            if name.ends_with(".csv") {
                let (_, expected) = whole.iter().find(|(other, _)| *other == name).unwrap();
                assert_eq!(rows(&text), rows(expected), "{name}");
            }
        }
        // The record of the files.
        let hidden = std::fs::read_dir(bench.path(&out)).unwrap().count() - whole.len();
        assert_eq!(hidden, 1);
    }
}

#[test]
fn runs_killed_at_any_moment_leave_whole_files() {
    kill_at_many_moments(6);
}

#[test]
fn runs_together_into_one_folder_leave_the_files_of_one() {
    run_together(3, 2);
}

#[test]
#[ignore = "takes minutes: .ci/slow runs it"]
fn runs_killed_at_very_many_moments_leave_whole_files() {
    kill_at_many_moments(300);
    run_together(60, 4);
}
