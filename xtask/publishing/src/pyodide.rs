//! `cargo xtask pyodide`: the Python package as a wheel for Pyodide, target/pyodide, tried under node.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::python::Place;
use crate::web::call;
use xtask::checkout;

const TARGET: &str = "wasm32-unknown-emscripten";

/// Tags of the extension, which serves every CPython from 3.10 on.
const PYTHON_TAGS: &str = "cp310-abi3";

/// Options of the linker of Rust for a module that Pyodide loads beside its own, as Emscripten's `-sSIDE_MODULE=2` links it:
/// the module imports from Pyodide all that it lacks, and exports only what Python calls.
const SIDE_MODULE: [&str; 9] = [
    "-flavor",
    "wasm",
    "-shared",
    "--experimental-pic",
    "--import-memory",
    "--unresolved-symbols=import-dynamic",
    "-Bsymbolic",
    "--no-export-dynamic",
    "--export=PyInit__native",
];

/// Builds the wheels of this machine and of Pyodide, and compares what both answer.
pub(crate) fn run() -> Result<(), Box<dyn Error>> {
    let root = &checkout("");
    let out = &root.join("target/pyodide");
    if out.exists() {
        fs::remove_dir_all(out)?;
    }
    fs::create_dir_all(out)?;
    let tests = root.join("tests/pyodide");
    call(Command::new("npm").args(["ci", "--prefix"]).arg(&tests))?;

    let place = Place::new(root, false)?;
    let native = place.wheel()?;
    place.install(&native, "")?;
    let module = link_side_module(root, out)?;
    let wheel = repack(&place, &native, &module, &read_platform(&tests)?, out)?;
    let name = wheel.file_name().unwrap_or_default().display();
    println!("{name}: {:.1} MB", fs::metadata(&wheel)?.len() as f64 / 1e6);

    call(
        Command::new("node")
            .current_dir(&tests)
            .args(["--test", "pyodide.test.mjs"])
            .env("TRUEAREA_WHEEL", &wheel)
            .env("TRUEAREA_PYTHON", place.in_environment("python")),
    )
}

/// Builds the extension without threads, and links it as a side module of WebAssembly. Emscripten is not needed: the extension
/// contains no C, and Pyodide brings the C library.
fn link_side_module(root: &Path, out: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let built = root.join("target/python");
    call(
        Command::new(env!("CARGO"))
            .args(["rustc", "--release", "--locked", "--lib", "--crate-type", "staticlib"])
            .args(["--no-default-features", "--target", TARGET, "--target-dir"])
            .arg(&built)
            .current_dir(root.join("python")),
    )?;
    let module = out.join("_native.abi3.so");
    let objects = built.join(TARGET).join("release/lib_native.a");
    call(
        Command::new(find_linker(root)?)
            .args(SIDE_MODULE)
            .arg("--strip-all")
            .arg(&objects)
            .arg("-o")
            .arg(&module),
    )?;
    Ok(module)
}

/// Finds the linker that comes with Rust.
fn find_linker(root: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let output = Command::new("rustc").current_dir(root).args(["--print", "target-libdir"]).output()?;
    let libraries = PathBuf::from(String::from_utf8(output.stdout)?.trim());
    let linker =
        libraries.with_file_name("bin").join("rust-lld").with_extension(std::env::consts::EXE_EXTENSION);
    if linker.exists() { Ok(linker) } else { Err(format!("{} is missing", linker.display()).into()) }
}

/// Reads which platform the Pyodide of the tests is, as wheels name it.
fn read_platform(tests: &Path) -> Result<String, Box<dyn Error>> {
    let lock = fs::read(tests.join("node_modules/pyodide/pyodide-lock.json"))?;
    let lock: serde_json::Value = serde_json::from_slice(&lock)?;
    let abi = lock["info"]["abi_version"].as_str().ok_or("Pyodide does not name its ABI")?;
    Ok(format!("pyemscripten_{abi}_wasm32"))
}

/// Repacks the wheel of this machine with the module for Pyodide.
fn repack(
    place: &Place,
    native: &str,
    module: &Path,
    platform: &str,
    out: &Path,
) -> Result<PathBuf, Box<dyn Error>> {
    let folder = out.display().to_string();
    place.python(&["-m", "pip", "install", "--quiet", "wheel"])?;
    place.python(&["-m", "wheel", "unpack", "--dest", &folder, native])?;
    let unpacked = only_entry(out, |path| path.is_dir())?;
    let package = unpacked.join("truearea");
    let is_native = |path: &Path| {
        path.file_stem().is_some_and(|stem| stem.to_string_lossy().starts_with("_native"))
            && path.extension().is_some_and(|ending| ending != "pyi")
    };
    fs::remove_file(only_entry(&package, is_native)?)?;
    fs::rename(module, package.join("_native.abi3.so"))?;
    let information =
        only_entry(&unpacked, |path| path.extension().is_some_and(|ending| ending == "dist-info"))?;
    let named = information.join("WHEEL");
    let lines: Vec<String> = fs::read_to_string(&named)?
        .lines()
        .map(|line| match line.starts_with("Tag:") {
            true => format!("Tag: {PYTHON_TAGS}-{platform}\n"),
            false => format!("{line}\n"),
        })
        .collect();
    fs::write(&named, lines.concat())?;
    place.python(&["-m", "wheel", "pack", "--dest-dir", &folder, &unpacked.display().to_string()])?;
    fs::remove_dir_all(unpacked)?;
    only_entry(out, |path| path.extension().is_some_and(|ending| ending == "whl"))
}

/// Returns the only entry of a folder that `is_wanted`.
fn only_entry(folder: &Path, is_wanted: impl Fn(&Path) -> bool) -> Result<PathBuf, Box<dyn Error>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder)? {
        found.extend(Some(entry?.path()).filter(|path| is_wanted(path)));
    }
    match <[PathBuf; 1]>::try_from(found) {
        Ok([path]) => Ok(path),
        Err(found) => Err(format!("{} has {} such entries, not one", folder.display(), found.len()).into()),
    }
}
