//! The site: the documentation with search, references of commands, of Python and of the crates, and the page for browsers.

mod book;
mod formulas;
mod gallery;
mod links;
mod notebooks;
mod python_reference;

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use xtask::checkout;

/// Builds `target/site` with mdBook, and checks every link in it.
pub(crate) fn run() -> ExitCode {
    match carry_out() {
        Ok(site) => {
            println!("{}: open index.html", site.display());
            ExitCode::SUCCESS
        }
        Err(problem) => {
            eprintln!("error: {problem}");
            ExitCode::FAILURE
        }
    }
}

fn carry_out() -> Result<PathBuf, Box<dyn std::error::Error>> {
    let root = &checkout("");
    let source = root.join("target/site-source");
    let site = root.join("target/site");
    for folder in [&source, &site] {
        if folder.exists() {
            std::fs::remove_dir_all(folder)?;
        }
    }
    book::write(root, &source)?;
    let status = Command::new("mdbook")
        .args(["build", "--dest-dir"])
        .arg(&site)
        .arg(&source)
        .status()
        .map_err(|error| format!("running mdbook: {error}; install it: cargo install mdbook --locked"))?;
    if !status.success() {
        return Err(format!("mdbook has failed ({status})").into());
    }
    let page = root.join("target/web");
    if page.is_dir() {
        copy_folder(&page, &site.join("app"))?;
    } else {
        println!("the page for browsers is not part of this site: run cargo xtask web before");
    }
    let broken = links::broken(&site)?;
    for link in &broken {
        println!("{link}");
    }
    if broken.is_empty() { Ok(site) } else { Err(format!("{} broken links", broken.len()).into()) }
}

fn copy_folder(from: &Path, to: &Path) -> std::io::Result<()> {
    std::fs::create_dir_all(to)?;
    for entry in std::fs::read_dir(from)? {
        let entry = entry?;
        let target = to.join(entry.file_name());
        if entry.file_type()?.is_dir() {
            copy_folder(&entry.path(), &target)?;
        } else {
            std::fs::copy(entry.path(), target)?;
        }
    }
    Ok(())
}

/// The path without `..`.
fn normal(path: &Path) -> PathBuf {
    path.components().fold(PathBuf::new(), |mut plain, part| {
        match part {
            std::path::Component::ParentDir => {
                plain.pop();
            }
            part => plain.push(part),
        }
        plain
    })
}
