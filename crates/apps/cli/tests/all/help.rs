//! Help that reads like documentation.

use crate::support::Bench;

#[test]
fn every_command_shows_an_example() {
    let bench = Bench::new();
    for command in [
        &["moments"][..],
        &["amplitude"],
        &["stacked"],
        &["fit"],
        &["run"],
        &["scene"],
        &["statistical"],
        &["bem"],
        &["persson"],
        &["gap"],
        &["law"],
        &["completions"],
        &["man"],
        &["asperity"],
        &["asperity", "sphere"],
        &["asperity", "sinusoid"],
        &["asperity", "sinusoid-interference"],
        &[],
    ] {
        let help = bench.run(&[command, &["--help"]].concat()).ok();
        assert!(help.contains("Example") && help.contains("  truearea "), "{command:?}\n{help}");
    }
    assert_eq!(bench.run(&["--version"]).ok(), "truearea 0.1.0\n");
}

#[test]
fn a_call_without_a_command_is_told_what_to_type() {
    let bench = Bench::new();
    bench.run(&[]).refused_naming(&["truearea report ", "truearea scan ", "truearea --help"]);
    for name in ["map.txt", "my map.txt", "scene.TOML"] {
        bench.write(name, "1 2\n");
    }
    std::fs::create_dir(bench.path("scans")).unwrap();
    for (call, typed) in [
        (&["map.txt"][..], "`truearea report map.txt --material \"steel 100Cr6\" --pressure 10MPa`"),
        (
            &["my map.txt", "--material=gold"],
            "`truearea report \"my map.txt\" --material=gold --pressure 10MPa`",
        ),
        (
            &["scans", "--pressure", "1MPa", "--title", "a b"],
            "`truearea report scans --pressure 1MPa --title \"a b\" --material \"steel 100Cr6\"`",
        ),
        (&["scene.TOML"], "`truearea run scene.TOML`"),
    ] {
        bench.run(call).refused_naming(&[typed]);
    }
    assert!(!bench.run(&["absent.txt"]).refused().contains("report"));
}

#[cfg(unix)]
#[test]
fn a_closed_pipe_ends_quietly() {
    // Far more than a pipe and a buffer hold.
    for format in ["csv", "json"] {
        let script = format!(
            "{} amplitude builtin:uncd-measured --scales-per-decade 5000 --format {format} 2>err | true; \
             test \"${{PIPESTATUS[0]}}\" = 0 && ! test -s err",
            env!("CARGO_BIN_EXE_truearea")
        );
        let folder = tempfile::tempdir().unwrap();
        let status = std::process::Command::new("bash")
            .args(["-c", &script])
            .current_dir(folder.path())
            .status()
            .unwrap();
        assert!(status.success(), "{format}");
    }
}

/// The commands that `--help` lists.
const COMMANDS: [&str; 14] = [
    "asperity",
    "moments",
    "amplitude",
    "stacked",
    "persson",
    "statistical",
    "bem",
    "gap",
    "law",
    "fit",
    "run",
    "scene",
    "completions",
    "man",
];

#[test]
fn every_shell_completes_every_command() {
    let bench = Bench::new();
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = bench.run(&["completions", shell]).ok();
        for word in COMMANDS.iter().chain(&["sinusoid-interference", "youngs-modulus", "elastic-plastic"]) {
            assert!(script.contains(word), "{shell}: {word}");
        }
        bench.run(&["completions", shell, "--output", "script"]).ok();
        assert_eq!(bench.read("script"), script);
    }
}

#[cfg(unix)]
#[test]
fn bash_takes_the_completions_and_completes_a_model() {
    let script = format!(
        "source <({} completions bash) && COMP_WORDS=(truearea stacked --model elastic-) COMP_CWORD=3 \
         && _truearea truearea elastic- --model && echo \"${{COMPREPLY[@]}}\"",
        env!("CARGO_BIN_EXE_truearea")
    );
    let output = std::process::Command::new("bash").args(["-c", &script]).output().unwrap();
    assert_eq!(String::from_utf8(output.stdout).unwrap(), "elastic-plastic\n", "{:?}", output.stderr);
}

#[test]
fn every_command_has_a_manual_page_with_its_example() {
    let bench = Bench::new();
    let said = bench.run(&["man", "--out", "pages"]).ok();
    assert!(said.contains(" pages in pages: truearea.1, "), "{said}");
    let below = COMMANDS.map(|command| format!("-{command}"));
    let laws = ["sphere", "sinusoid", "sinusoid-interference"].map(|law| format!("-asperity-{law}"));
    for page in below.iter().chain(&laws).map(String::as_str).chain([""]) {
        let text = bench.read(&format!("pages/truearea{page}.1"));
        // roff takes a plain hyphen for one that may break a line.
        let (head, examples) = text.split_once(".SH EXAMPLES\n").unwrap_or_else(|| panic!("{page}: {text}"));
        assert!(head.contains(".SH NAME") && head.contains(".SH SYNOPSIS"), "{page}");
        assert!(examples.contains("\n  truearea ") || examples.contains("\n  man "), "{page}: {examples}");
    }
    let stacked = bench.read("pages/truearea-stacked.1");
    assert!(stacked.contains("\\-\\-pressure 5.4MPa \\-\\-pressure 1e\\-2H"), "{stacked}");
    // Written again over the first ones; a folder that cannot be made is the system's fault.
    bench.run(&["man", "--out", "pages"]).ok();
    bench.write("file", "");
    assert_eq!(bench.run(&["man", "--out", "file/pages"]).status, 1);
}
