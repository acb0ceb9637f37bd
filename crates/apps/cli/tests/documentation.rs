//! Every call of the program that the README and the pages of `docs/` show.
#![cfg(unix)]

mod support;

use std::path::{Path, PathBuf};
use std::process::Command;

use support::Bench;

/// A row that every kind of table finds its columns in.
const ROWS: &str = "\
model,youngs_modulus_pa,poisson_ratio,yield_strength_pa,strain_gradient_length_m,radius_m,density_per_m2,sigma_s_m,\
separation_m,pressure_pa,wavelength_m,aspect_ratio,interference_m
ep-sphere,2.1e11,0.3,1e9,,5e-6,2e11,5e-8,,1e6,1e-6,0.01,1e-9
";

fn top() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..")
}

/// The lines of the console blocks of a page that call the program, continued lines joined.
fn calls(page: &str) -> Vec<String> {
    let blocks = page.split("```console\n").skip(1).filter_map(|rest| rest.split("```").next());
    let joined: Vec<String> = blocks.map(|block| block.replace("\\\n", " ")).collect();
    let lines = joined.iter().flat_map(|block| block.lines());
    lines.filter(|line| line.starts_with("truearea ")).map(str::to_owned).collect()
}

/// The scenes that pages tell step by step, by the name of their page.
fn scenes() -> [(&'static str, String); 3] {
    ["gasket", "electrical-contact", "bolted-joint"]
        .map(|name| (name, std::fs::read_to_string(top().join(format!("data/scenes/{name}.toml"))).unwrap()))
}

#[test]
fn pages_show_the_scenes_that_they_run() {
    for (name, scene) in scenes() {
        let page = std::fs::read_to_string(top().join(format!("docs/{name}.md"))).unwrap();
        assert!(page.contains(&format!("```toml\n{scene}```")), "docs/{name}.md and data/scenes/{name}.toml");
    }
}

#[test]
fn every_call_shown_succeeds() {
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
    std::fs::create_dir_all(bench.path("data/scenes")).unwrap();
    for (name, scene) in scenes() {
        bench.write(&format!("data/scenes/{name}.toml"), scene);
    }
    let folder = Path::new(env!("CARGO_BIN_EXE_truearea")).parent().unwrap();
    let path = std::env::join_paths(
        std::iter::once(folder.to_owned()).chain(std::env::split_paths(&std::env::var_os("PATH").unwrap())),
    )
    .unwrap();
    let pages = std::fs::read_dir(top().join("docs")).unwrap().map(|entry| entry.unwrap().path());
    let pages = pages.filter(|path| path.extension().is_some_and(|extension| extension == "md"));
    let mut made = 0;
    for page in pages.chain([top().join("README.md")]) {
        for call in calls(&std::fs::read_to_string(&page).unwrap()) {
            let mut shell = Command::new("bash");
            let output =
                shell.args(["-c", &call]).env("PATH", &path).current_dir(bench.path("")).output().unwrap();
            let said = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{}: {call}\n{said}", page.display());
            made += 1;
        }
    }
    assert!(made > 10, "{made} calls found");
}
