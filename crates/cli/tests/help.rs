//! Help that reads like documentation.

mod support;

use support::Bench;

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
fn a_command_that_does_not_exist_is_bad_input() {
    assert!(Bench::new().run(&["stack"]).refused().contains("unrecognized subcommand 'stack'"));
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
