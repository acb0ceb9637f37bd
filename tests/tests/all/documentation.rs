//! The pages of `docs/` and their pictures. `cargo xtask docs` draws those anew.

use std::path::PathBuf;

use tests::committed_file;
use tests::pictures::{MOST_BYTES, path, pictures, stale};

#[test]
fn the_committed_pictures_are_as_drawn_now() {
    let stale = stale();
    assert!(stale.is_empty(), "docs/pictures: {stale:?} differ; run cargo xtask docs");
}

#[test]
fn the_committed_status_is_that_of_the_program() {
    let committed = std::fs::read_to_string(tests::status::path()).unwrap();
    assert_eq!(tests::status::page().unwrap(), committed, "run cargo xtask docs");
}

#[test]
fn pictures_stay_small_and_every_one_is_shown_with_words() {
    let pages: Vec<String> = pages().map(|page| std::fs::read_to_string(page).unwrap()).collect();
    for picture in pictures() {
        assert!(picture.svg.len() <= MOST_BYTES, "{} has {} bytes", picture.name, picture.svg.len());
        let file = format!("pictures/{}.svg", picture.name);
        let page = pages.iter().find(|page| page.contains(&format!("{file})")));
        let page = page.unwrap_or_else(|| panic!("{} is shown nowhere", path(picture.name).display()));
        let mut wordless = page.split("![](").skip(1).filter_map(|rest| rest.split(')').next());
        assert!(
            !wordless.any(|link| link.ends_with(&file)),
            "{} has no text for those who cannot see it",
            picture.name
        );
    }
}

#[test]
fn every_link_between_the_pages_leads_somewhere() {
    let top = ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "data/README.md"].map(committed_file);
    let floors = std::fs::read_dir(committed_file("crates")).unwrap();
    let floors = floors.map(|floor| floor.unwrap().path().join("README.md"));
    for page in top.into_iter().chain(floors).chain(pages()) {
        let text = std::fs::read_to_string(&page).unwrap();
        for link in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            let (file, section) = link.split_once('#').unwrap_or((link, ""));
            if link.contains("://") {
                continue;
            }
            let file = if file.is_empty() { page.clone() } else { page.parent().unwrap().join(file) };
            assert!(file.exists(), "{}: {link}", page.display());
            if !section.is_empty() {
                let sections = sections(&std::fs::read_to_string(&file).unwrap());
                assert!(sections.iter().any(|other| other == section), "{}: {link}", page.display());
            }
        }
    }
}

/// Returns every page below `docs`.
fn pages() -> impl Iterator<Item = PathBuf> {
    fn below(folder: PathBuf) -> Vec<PathBuf> {
        let paths = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        paths.flat_map(|path| if path.is_dir() { below(path) } else { vec![path] }).collect()
    }
    let is_page = |path: &PathBuf| path.extension().is_some_and(|extension| extension == "md");
    below(committed_file("docs")).into_iter().filter(is_page)
}

/// The names under which GitHub links to the headings of a page.
fn sections(page: &str) -> Vec<String> {
    let headings = page.lines().filter_map(|line| line.strip_prefix('#'));
    let name = |heading: &str| {
        let heading = heading.trim_start_matches('#').trim().to_lowercase();
        let kept = heading.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
        kept.map(|c| if c == ' ' { '-' } else { c }).collect()
    };
    headings.map(name).collect()
}
