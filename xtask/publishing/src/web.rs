//! `cargo xtask web`: the page for browsers as a static folder, target/web.

use std::error::Error;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use brotli::enc::BrotliEncoderParams;
use flate2::{Compression, write::GzEncoder};
use wasm_bindgen_cli_support::Bindgen;

use xtask::checkout;

/// The largest size of everything that a first visit needs, with brotli: 1.21 MB since parts need not be flat, and
/// some room. The goal was 1.5 MB.
const MOST_BYTES: usize = 1_225_000;

/// The two cores: the page begins with the first, which reads the common formats, and loads the second when a file needs it.
const CORES: [Core; 2] = [
    Core { name: "truearea", options: &["--no-default-features"] },
    Core { name: ALL_FORMATS, options: &[] },
];

/// The name of the core with all formats.
const ALL_FORMATS: &str = "truearea_all";

/// A build of the core.
struct Core {
    name: &'static str,
    options: &'static [&'static str],
}

/// Files of these endings are compressed beside the plain ones.
const COMPRESSED: [&str; 6] = ["html", "css", "js", "json", "wasm", "svg"];

/// Builds the page, and with `tests` runs its tests in Chromium.
pub(crate) fn run(tests: bool) -> Result<(), Box<dyn Error>> {
    build()?;
    if tests { test() } else { Ok(()) }
}

fn build() -> Result<(), Box<dyn Error>> {
    let root = &checkout("");
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from);
    let out = target.join("web");
    if out.exists() {
        fs::remove_dir_all(&out)?;
    }
    fs::create_dir_all(&out)?;
    for core in CORES {
        call(
            Command::new(env!("CARGO"))
                .current_dir(root)
                .args(["rustc", "--package", "truearea-web", "--lib", "--crate-type", "cdylib"])
                .args(["--target", "wasm32-unknown-unknown", "--profile", "wasm"])
                .args(core.options),
        )?;
        Bindgen::new()
            .input_path(target.join("wasm32-unknown-unknown/wasm/web.wasm"))
            .out_name(core.name)
            .web(true)?
            .typescript(false)
            .remove_name_section(true)
            .remove_producers_section(true)
            .generate(&out)?;
    }
    fs::copy(root.join("crates/answer/report/src/page/style.css"), out.join("report.css"))?;
    fs::write(out.join("choices.json"), printed(root, "page_choices")?)?;
    let page = root.join("crates/apps/web/page");
    for entry in fs::read_dir(&page)? {
        let path = entry?.path();
        if path.is_file() && path.extension().is_some_and(|ending| ending != "json") {
            fs::copy(&path, out.join(path.file_name().unwrap_or_default()))?;
        }
    }
    name_version(&out)?;
    compress(&out)
}

/// Runs a program of the workspace, and returns what it prints.
fn printed(root: &Path, program: &str) -> Result<Vec<u8>, Box<dyn Error>> {
    let output =
        Command::new(env!("CARGO")).current_dir(root).args(["run", "--quiet", "--bin", program]).output()?;
    if output.status.success() { Ok(output.stdout) } else { Err(format!("{program} failed").into()) }
}

/// Names the files of this build in the service worker, with their version, so that a new build replaces an old one.
fn name_version(out: &Path) -> Result<(), Box<dyn Error>> {
    let mut names: Vec<String> = Vec::new();
    for entry in fs::read_dir(out)? {
        names.push(entry?.file_name().to_string_lossy().into_owned());
    }
    names.sort();
    names.retain(|name| name != "offline.js");
    let mut version = flate2::Crc::new();
    for name in &names {
        version.update(&fs::read(out.join(name))?);
    }
    let script = fs::read_to_string(out.join("offline.js"))?;
    let list = serde_json::to_string(&names)?;
    let script =
        script.replace("\"VERSION\"", &format!("\"{:08x}\"", version.sum())).replace("[\"FILES\"]", &list);
    fs::write(out.join("offline.js"), script)?;
    Ok(())
}

/// Writes compressed files beside the plain ones, and prints and checks their sizes.
fn compress(out: &Path) -> Result<(), Box<dyn Error>> {
    let mut totals = [0; 3];
    let mut paths = fs::read_dir(out)?.map(|entry| Ok(entry?.path())).collect::<std::io::Result<Vec<_>>>()?;
    paths.sort();
    for path in paths {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_owned();
        if !COMPRESSED.contains(&ending.as_str()) {
            continue;
        }
        let plain = fs::read(&path)?;
        let mut gzip = GzEncoder::new(Vec::new(), Compression::best());
        gzip.write_all(&plain)?;
        let gzip = gzip.finish()?;
        let mut packed = Vec::new();
        let parameters = BrotliEncoderParams { quality: 11, lgwin: 24, ..BrotliEncoderParams::default() };
        brotli::BrotliCompress(&mut &plain[..], &mut packed, &parameters)?;
        fs::write(path.with_extension(format!("{ending}.gz")), &gzip)?;
        fs::write(path.with_extension(format!("{ending}.br")), &packed)?;
        let sizes = [plain.len(), gzip.len(), packed.len()];
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        println!("{name:<22} {:>9} bytes, gzip {:>9}, brotli {:>9}", sizes[0], sizes[1], sizes[2]);
        if name.starts_with(ALL_FORMATS) {
            continue;
        }
        for (total, size) in totals.iter_mut().zip(sizes) {
            *total += size;
        }
    }
    println!("{:<22} {:>9} bytes, gzip {:>9}, brotli {:>9}", "first visit", totals[0], totals[1], totals[2]);
    if totals[2] > MOST_BYTES {
        return Err(format!(
            "the page has {} bytes with brotli; at most {MOST_BYTES} are allowed",
            totals[2]
        )
        .into());
    }
    Ok(())
}

/// Runs the tests of the page in Chromium.
fn test() -> Result<(), Box<dyn Error>> {
    let root = &checkout("");
    let tests = root.join("tests/browser");
    call(Command::new(env!("CARGO")).current_dir(root).args(["build", "--bin", "truearea"]))?;
    call(Command::new("npm").args(["ci", "--prefix"]).arg(&tests))?;
    call(Command::new("node").current_dir(&tests).args(["--test", "web.test.mjs"]))
}

/// Runs a command, and fails if it does.
pub(crate) fn call(command: &mut Command) -> Result<(), Box<dyn Error>> {
    match command.status()? {
        status if status.success() => Ok(()),
        status => Err(format!("{command:?} ended with {status}").into()),
    }
}
