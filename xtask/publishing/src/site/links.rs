//! Links of the built site: each names a file of the site and, behind `#`, a place in it.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Component, Path, PathBuf};

/// Links without a target, a line each. Links to other sites are not followed.
pub(super) fn broken(site: &Path) -> std::io::Result<Vec<String>> {
    let mut pages = BTreeMap::new();
    collect(site, &mut pages)?;
    let places: BTreeMap<&PathBuf, BTreeSet<&str>> =
        pages.iter().map(|(path, text)| (path, attributes(text, "id").collect())).collect();
    let mut broken = Vec::new();
    for (path, text) in &pages {
        // The page for browsers has tests of its own, and mdBook's own pages link into each other from the root.
        let name = path.strip_prefix(site).unwrap_or(path);
        if name.starts_with("app")
            || ["print.html", "404.html", "toc.html"].iter().any(|own| name == Path::new(own))
        {
            continue;
        }
        let folder = path.parent().unwrap_or(site);
        for link in attributes(text, "href").chain(attributes(text, "src")) {
            let elsewhere = link.contains("://") || link.starts_with("mailto:") || link.starts_with("data:");
            if elsewhere || link.is_empty() {
                continue;
            }
            let (file, place) = link.split_once('#').unwrap_or((link, ""));
            let file = file.split('?').next().unwrap_or_default();
            let target = if file.is_empty() { path.clone() } else { plain(&folder.join(file)) };
            let target = if target.is_dir() { target.join("index.html") } else { target };
            if !target.exists() {
                broken.push(format!("{}: {link} leads nowhere", name.display()));
            } else if !place.is_empty() && places.get(&target).is_some_and(|places| !places.contains(place)) {
                broken.push(format!("{}: {link} has no such heading", name.display()));
            }
        }
    }
    broken.sort();
    broken.dedup();
    Ok(broken)
}

/// Reads the pages of a folder and of those below it.
fn collect(folder: &Path, pages: &mut BTreeMap<PathBuf, String>) -> std::io::Result<()> {
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            collect(&path, pages)?;
        } else if path.extension().is_some_and(|extension| extension == "html") {
            let text = std::fs::read_to_string(&path)?;
            pages.insert(path, text);
        }
    }
    Ok(())
}

/// Values of an attribute, as mdBook writes them: in double quotes.
fn attributes<'t>(text: &'t str, name: &str) -> impl Iterator<Item = &'t str> {
    let start = format!(" {name}=\"");
    let length = start.len();
    let positions: Vec<usize> = text.match_indices(&start).map(|(at, _)| at + length).collect();
    positions.into_iter().map(move |at| text[at..].split('"').next().unwrap_or_default())
}

/// The path without `..` and `.`.
fn plain(path: &Path) -> PathBuf {
    path.components().fold(PathBuf::new(), |mut plain, part| {
        match part {
            Component::ParentDir => {
                plain.pop();
            }
            Component::CurDir => {}
            part => plain.push(part),
        }
        plain
    })
}
