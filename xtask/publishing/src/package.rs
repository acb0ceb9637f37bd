//! Crates as they are published: packed, compiled from their archives, and used by a project outside of the workspace.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use flate2::read::GzDecoder;
use serde_json::Value;

use xtask::checkout;

/// Packs every crate of the workspace, lets cargo compile each archive, and runs the example of each README in a project
/// elsewhere that knows nothing but the archives of published crates.
pub(crate) fn run() -> ExitCode {
    match carry_out() {
        Ok(examples) => {
            println!("{examples} examples run from the packed crates");
            ExitCode::SUCCESS
        }
        Err(problem) => {
            eprintln!("error: {problem}");
            ExitCode::FAILURE
        }
    }
}

/// Folder in which archives are packed and compiled.
const FOLDER: &str = "target/published";

/// Crate that is published.
pub(crate) struct Published {
    /// Name of the package.
    pub(crate) name: String,
    /// Name and version, as its archive is called.
    archive: String,
    /// Name of its library, as its users type it.
    pub(crate) library: String,
    /// Its README, which has the example.
    readme: Option<PathBuf>,
}

fn carry_out() -> Result<usize, Box<dyn std::error::Error>> {
    let root = &checkout("");
    let published = published(root)?;
    forget(root, &published)?;
    // What is checked is what lies in the checkout, committed or not. Crates that are not published are packed too, so that the
    // plain command passes; cargo finds no crate that depends on one of them, so none may.
    cargo(root, ["package", "--quiet", "--workspace", "--allow-dirty", "--locked", "--target-dir", FOLDER])?;

    let elsewhere = std::env::temp_dir().join(format!("truearea-packages-{}", std::process::id()));
    let outcome = try_elsewhere(root, &elsewhere, &published);
    std::fs::remove_dir_all(&elsewhere)?;
    outcome
}

/// Crates that are published.
pub(crate) fn published(root: &Path) -> Result<Vec<Published>, Box<dyn std::error::Error>> {
    let output = Command::new(cargo_program())
        .args(["metadata", "--format-version", "1", "--no-deps"])
        .current_dir(root)
        .output()?;
    let metadata: Value = serde_json::from_slice(&output.stdout)?;
    let packages = metadata["packages"].as_array().ok_or("cargo metadata names no packages")?;
    let mut published = Vec::new();
    for package in packages {
        let text = |key: &str| package[key].as_str().unwrap_or_default().to_owned();
        if package["publish"].as_array().is_some_and(Vec::is_empty) {
            continue;
        }
        let targets = package["targets"].as_array().ok_or("a package without targets")?;
        let library = targets.iter().find(|target| target["kind"][0] == "lib");
        published.push(Published {
            archive: format!("{}-{}", text("name"), text("version")),
            library: library.and_then(|target| target["name"].as_str()).unwrap_or_default().to_owned(),
            readme: package["readme"].as_str().map(|readme| {
                Path::new(&text("manifest_path")).parent().unwrap_or(Path::new("")).join(readme)
            }),
            name: text("name"),
        });
    }
    Ok(published)
}

/// Removes archives of an earlier run from cargo's folders, and what was compiled from them: of two with one version, cargo takes
/// the one that it knows.
fn forget(root: &Path, published: &[Published]) -> std::io::Result<()> {
    if let Ok(compiled) = std::fs::read_dir(root.join(FOLDER).join("debug/.fingerprint")) {
        for entry in compiled {
            let entry = entry?;
            let name = entry.file_name().display().to_string();
            if published.iter().any(|package| name.starts_with(&format!("{}-", package.name))) {
                std::fs::remove_dir_all(entry.path())?;
            }
        }
    }
    let at_home = || std::env::home_dir().map(|home| home.join(".cargo"));
    let Some(cargo_home) = std::env::var_os("CARGO_HOME").map(PathBuf::from).or_else(at_home) else {
        return Ok(());
    };
    for folder in ["cache", "src"] {
        let Ok(registries) = std::fs::read_dir(cargo_home.join("registry").join(folder)) else { continue };
        for registry in registries {
            let registry = registry?.path();
            for Published { archive, .. } in published {
                let (unpacked, packed) = (registry.join(archive), registry.join(format!("{archive}.crate")));
                if unpacked.exists() {
                    std::fs::remove_dir_all(unpacked)?;
                }
                if packed.exists() {
                    std::fs::remove_file(packed)?;
                }
            }
        }
    }
    Ok(())
}

/// Makes a project of the archives in `elsewhere`, with an example per crate, and runs them all.
fn try_elsewhere(
    root: &Path,
    elsewhere: &Path,
    published: &[Published],
) -> Result<usize, Box<dyn std::error::Error>> {
    std::fs::create_dir_all(elsewhere.join("examples"))?;
    std::fs::create_dir_all(elsewhere.join("src"))?;
    std::fs::write(elsewhere.join("src/lib.rs"), "")?;
    let mut dependencies = String::new();
    let mut patches = String::new();
    let mut examples = Vec::new();
    for package in published {
        let Published { name, archive, library, readme } = package;
        let file = std::fs::File::open(root.join(format!("{FOLDER}/package/{archive}.crate")))?;
        tar::Archive::new(GzDecoder::new(file)).unpack(elsewhere)?;
        writeln!(patches, "{name} = {{ path = \"{archive}\" }}")?;
        let Some(example) = readme.as_deref().map(example).transpose()?.flatten() else { continue };
        writeln!(dependencies, "{library} = {{ package = \"{name}\", path = \"{archive}\" }}")?;
        let called = library.replace('-', "_");
        std::fs::write(elsewhere.join(format!("examples/{called}.rs")), example)?;
        examples.push(called);
    }
    let manifest = format!(
        "[package]\nname = \"elsewhere\"\nedition = \"2024\"\n\n[workspace]\n\n\
         [dependencies]\n{dependencies}\n[patch.crates-io]\n{patches}"
    );
    std::fs::write(elsewhere.join("Cargo.toml"), manifest)?;
    // The versions that the workspace has been tested with.
    std::fs::copy(root.join("Cargo.lock"), elsewhere.join("Cargo.lock"))?;
    cargo(elsewhere, ["build", "--quiet", "--examples"])?;
    for example in &examples {
        cargo(elsewhere, ["run", "--quiet", "--example", example])?;
    }
    Ok(examples.len())
}

/// The first Rust example of a README, as a program; lines that rustdoc hides are part of it.
fn example(readme: &Path) -> Result<Option<String>, Box<dyn std::error::Error>> {
    let text = std::fs::read_to_string(readme)?;
    let Some((_, from)) = text.split_once("```rust\n") else { return Ok(None) };
    let (code, _) = from.split_once("```").ok_or_else(|| format!("{}: an open example", readme.display()))?;
    let lines = code.lines().map(|line| match line {
        "#" => "",
        line => line.strip_prefix("# ").unwrap_or(line),
    });
    let code = lines.collect::<Vec<_>>().join("\n");
    if code.contains("fn main()") {
        return Ok(Some(code));
    }
    // The error of an example without a function stands in its last line, as rustdoc has it.
    let error = code.lines().last().and_then(|line| line.strip_prefix("Ok::<(), ")?.strip_suffix(">(())"));
    let returns = error.map_or_else(String::new, |error| format!("-> Result<(), {error}> "));
    Ok(Some(format!("fn main() {returns}{{\n{code}\n}}\n")))
}

pub(crate) fn cargo_program() -> std::ffi::OsString {
    std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into())
}

fn cargo<'a>(
    folder: &Path,
    arguments: impl IntoIterator<Item = &'a str>,
) -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<&str> = arguments.into_iter().collect();
    let status = Command::new(cargo_program())
        .args(&arguments)
        .current_dir(folder)
        .env_remove("CARGO_TARGET_DIR")
        .status()?;
    if status.success() { Ok(()) } else { Err(format!("cargo {} has failed", arguments.join(" ")).into()) }
}
