//! Source of the site: the pages of the repository in the order of their index, as mdBook reads them.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

use super::gallery::ListedPage;
use super::{copy_folder, formulas, gallery, normal, notebooks, python_reference};

/// Pages of the repository beside `docs`.
const PAGES_OF_THE_ROOT: [&str; 4] = ["ARCHITECTURE.md", "CHANGELOG.md", "CONTRIBUTING.md", "data/README.md"];

/// Chapters: heading, folder below `docs`, and the pages that come first; the others of the folder follow by name.
const CHAPTERS: [(&str, &str, &[&str]); 4] = [
    (
        "Guide",
        "guide",
        &[
            "report.md",
            "browser.md",
            "which-model.md",
            "gasket.md",
            "electrical-contact.md",
            "bolted-joint.md",
            "bearing-race.md",
            "contact-challenge.md",
            "nature.md",
            "flow.md",
            "lubrication.md",
            "instruments.md",
            "spectrum.md",
        ],
    ),
    ("Theory", "theory", &["README.md", "models.md"]),
    ("Python", "python", &["README.md", "material.md", "scans.md", "spectrum.md"]),
    ("Development", "develop", &["status.md", "performance.md", "stress.md", "decisions.md"]),
];

/// Tutorials: walks with data of the repository, which the tests run.
const TUTORIALS: [&str; 3] = ["tutorials/diamond.md", "tutorials/flange.md", "notebooks/1-my-scans.md"];

/// Appearance of formulas and pictures.
const STYLE: &str = "\
.formula { overflow-x: auto; margin: 1em 0; }
math { font-size: 1.1em; }
.content img { background: white; max-width: 100%; }
.content table { display: block; overflow-x: auto; max-width: 100%; }
";

/// Writes the source of the book into a folder.
pub(super) fn write(root: &Path, folder: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let source = folder.join("src");
    copy_folder(&root.join("docs"), &source)?;
    for page in PAGES_OF_THE_ROOT {
        let target = source.join(page);
        std::fs::create_dir_all(target.parent().ok_or("a page lies in a folder")?)?;
        std::fs::copy(root.join(page), target)?;
    }
    // The first page is the README, beside which `docs` lies in the repository.
    let readme =
        std::fs::read_to_string(root.join("README.md"))?.replace("](docs/README.md)", "](index-of-pages.md)");
    std::fs::rename(source.join("README.md"), source.join("index-of-pages.md"))?;
    std::fs::write(source.join("README.md"), readme.replace("](docs/", "]("))?;

    let reference = source.join("reference");
    std::fs::create_dir_all(&reference)?;
    std::fs::write(reference.join("commands.md"), command_reference(root)?)?;
    std::fs::write(reference.join("python.md"), python_reference::page(root)?)?;

    let names = notebooks::write(&root.join("python/notebooks"), &source.join("notebooks"))?;
    let repository = repository(root)?;
    for page in pages(&source)? {
        let text = std::fs::read_to_string(&page)?;
        let text = formulas::as_mathml(&text).map_err(|error| format!("{}: {error}", page.display()))?;
        std::fs::write(&page, with_links(&text, &page, &source, root, &repository))?;
    }
    let (summary, listed) = summary(&source, &names)?;
    std::fs::write(source.join("SUMMARY.md"), summary)?;
    std::fs::write(source.join("gallery.md"), gallery::page(&source, &listed)?)?;
    std::fs::write(folder.join("site.css"), STYLE)?;
    let book = format!(
        "[book]\ntitle = \"truearea\"\ndescription = \"How much of two rough surfaces really touches\"\nlanguage = \"en\"\n\n\
         [output.html]\nadditional-css = [\"site.css\"]\ngit-repository-url = \"{repository}\"\n\
         default-theme = \"light\"\npreferred-dark-theme = \"navy\"\nno-section-label = true\n\n\
         [output.html.search]\nlimit-results = 20\n\n[output.html.fold]\nenable = true\nlevel = 1\n"
    );
    std::fs::write(folder.join("book.toml"), book)?;
    Ok(())
}

/// Address of the repository, as the manifests state it.
fn repository(root: &Path) -> Result<String, Box<dyn std::error::Error>> {
    let output = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .args(["metadata", "--format-version", "1", "--no-deps"])
        .current_dir(root)
        .output()?;
    let metadata: Value = serde_json::from_slice(&output.stdout)?;
    let packages = metadata["packages"].as_array().ok_or("cargo metadata names no packages")?;
    let addresses: BTreeSet<&str> =
        packages.iter().filter_map(|package| package["repository"].as_str()).collect();
    addresses
        .first()
        .map(|address| (*address).to_owned())
        .ok_or_else(|| "no manifest names the repository".into())
}

/// The pages of Markdown in a folder and below it.
fn pages(folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in std::fs::read_dir(next)? {
            let path = entry?.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "md") {
                found.push(path);
            }
        }
    }
    Ok(found)
}

/// Sends links to files that are not pages of the site to the repository.
fn with_links(text: &str, page: &Path, source: &Path, root: &Path, repository: &str) -> String {
    let folder = page.strip_prefix(source).ok().and_then(Path::parent).unwrap_or(Path::new(""));
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find("](") {
        let (before, from) = rest.split_at(at + 2);
        out.push_str(before);
        let Some(end) = from.find(')') else {
            rest = from;
            break;
        };
        let link = &from[..end];
        rest = &from[end..];
        let (file, place) = link.split_once('#').map_or((link, None), |(file, place)| (file, Some(place)));
        let hash = place.map_or_else(String::new, |place| format!("#{place}"));
        if file.is_empty() || file.contains("://") {
            out.push_str(link);
            continue;
        }
        if source.join(folder).join(file).is_file() {
            // mdBook turns the README of a folder into its index.
            out.push_str(&link.replace("/README.md", "/index.html"));
            continue;
        }
        // Pages of `docs` are one folder deeper in the repository than on the site, on which notebooks are pages.
        let below_docs = normal(&Path::new("docs").join(folder).join(file));
        let on_site = match below_docs.strip_prefix("python/notebooks") {
            Ok(notebook) => Path::new("notebooks").join(notebook).with_extension("md"),
            Err(_) => below_docs.clone(),
        };
        let in_root = if root.join(&below_docs).exists() { below_docs } else { normal(&folder.join(file)) };
        let target = source.join(&on_site);
        if target.is_file() {
            let up = "../".repeat(folder.components().count());
            let _ = write!(out, "{up}{}{hash}", on_site.display());
        } else if root.join(&in_root).exists() {
            let _ = write!(out, "{repository}/tree/main/{}{hash}", in_root.display());
        } else {
            out.push_str(link);
        }
    }
    out.push_str(rest);
    out
}

/// The table of contents, and the pages that it lists with their titles.
fn summary(
    source: &Path,
    notebooks: &[String],
) -> Result<(String, Vec<ListedPage>), Box<dyn std::error::Error>> {
    let mut text = String::from(
        "# Summary\n\n[truearea](README.md)\n[All pages](index-of-pages.md)\n[Gallery](gallery.md)\n",
    );
    let mut listed: Vec<ListedPage> = Vec::new();
    let mut list = |text: &mut String, page: &str| -> Result<(), Box<dyn std::error::Error>> {
        let page = source.join(page);
        // mdBook takes a page once.
        if listed.iter().all(|known| known.path != page) {
            let title = title(&page)?;
            writeln!(text, "- [{title}]({})", page.strip_prefix(source)?.display())?;
            listed.push(ListedPage { path: page, title });
        }
        Ok(())
    };
    text.push_str("\n# Tutorials\n\n");
    for page in TUTORIALS {
        list(&mut text, page)?;
    }
    for (heading, folder, first) in CHAPTERS {
        writeln!(text, "\n# {heading}\n")?;
        let mut names: Vec<String> = std::fs::read_dir(source.join(folder))?
            .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
            .filter(|name| name.ends_with(".md"))
            .collect();
        names.sort_by_key(|name| {
            (first.iter().position(|page| page == name).unwrap_or(usize::MAX), name.clone())
        });
        for name in names {
            list(&mut text, &format!("{folder}/{name}"))?;
        }
    }
    text.push_str("\n# Notebooks\n\n");
    for name in notebooks {
        list(&mut text, &format!("notebooks/{name}.md"))?;
    }
    text.push_str("\n# Reference\n\n- [Commands](reference/commands.md)\n- [Python](reference/python.md)\n");
    text.push_str("- [Data](data/README.md)\n- [Architecture](ARCHITECTURE.md)\n- [Contributing](CONTRIBUTING.md)\n- [Changes](CHANGELOG.md)\n");
    Ok((text, listed))
}

/// The first heading of a page.
fn title(page: &Path) -> Result<String, Box<dyn std::error::Error>> {
    let text = std::fs::read_to_string(page)?;
    let heading = text.lines().find_map(|line| line.strip_prefix("# "));
    Ok(heading.ok_or_else(|| format!("{}: no heading", page.display()))?.to_owned())
}

/// The help of every command, as the program prints it.
fn command_reference(root: &Path) -> Result<String, Box<dyn std::error::Error>> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let status =
        Command::new(cargo).args(["build", "--quiet", "--bin", "truearea"]).current_dir(root).status()?;
    if !status.success() {
        return Err("building the command line has failed".into());
    }
    let program = root.join("target/debug/truearea").with_extension(std::env::consts::EXE_EXTENSION);
    let help = |arguments: &[&str]| -> Result<String, Box<dyn std::error::Error>> {
        let output = Command::new(&program).args(arguments).arg("--help").env("NO_COLOR", "1").output()?;
        Ok(String::from_utf8(output.stdout)?)
    };
    let overview = help(&[])?;
    let mut page = format!(
        "# Commands\n\nThis page is what `truearea --help` and `truearea COMMAND --help` print.\n\n```text\n{overview}```\n"
    );
    for command in commands(&overview) {
        write!(page, "\n## truearea {command}\n\n```text\n{}```\n", help(&[command])?)?;
    }
    Ok(page)
}

/// The names of commands in the overview: first words of lines that are indented by two spaces.
fn commands(overview: &str) -> impl Iterator<Item = &str> {
    overview
        .lines()
        .filter(|line| {
            line.starts_with("  ") && !line.starts_with("   ") && !line.trim_start().starts_with('-')
        })
        .filter_map(|line| line.split_whitespace().next())
        .filter(|word| {
            word.chars().all(|letter| letter.is_ascii_lowercase() || letter == '-') && *word != "help"
        })
}
