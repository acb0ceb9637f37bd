//! Gallery: every figure of the pages, with its caption and the page that explains it.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use super::normal;

/// Page of the table of contents.
pub(super) struct ListedPage {
    /// Its file.
    pub(super) path: PathBuf,
    /// Its first heading.
    pub(super) title: String,
}

/// Returns the page; `pages` are files below `source`.
pub(super) fn page(source: &Path, pages: &[ListedPage]) -> Result<String, Box<dyn std::error::Error>> {
    let mut text = String::from(
        "# Gallery\n\nEvery figure of these pages. The heading leads to the page that explains it.\n",
    );
    let mut shown = BTreeSet::new();
    for ListedPage { path, title } in pages {
        let folder = path.parent().unwrap_or(source);
        let markdown = std::fs::read_to_string(path)?;
        let figures: Vec<(&str, String)> = figures(&markdown)
            .filter_map(|(caption, file)| {
                let file = normal(&folder.strip_prefix(source).ok()?.join(file));
                shown.insert(file.clone()).then(|| (caption, file.display().to_string()))
            })
            .collect();
        if figures.is_empty() {
            continue;
        }
        write!(text, "\n## [{title}]({})\n", path.strip_prefix(source)?.display())?;
        for (caption, file) in figures {
            write!(text, "\n![{caption}]({file})\n\n*{caption}*\n")?;
        }
    }
    Ok(text)
}

/// Captions and files of the pictures of a page.
fn figures(markdown: &str) -> impl Iterator<Item = (&str, &str)> {
    markdown.match_indices("![").filter_map(|(at, _)| {
        let (caption, rest) = markdown[at + 2..].split_once("](")?;
        let (file, _) = rest.split_once(')')?;
        (!file.contains("://")).then_some((caption, file))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_of_a_page_are_found_and_those_of_other_sites_left_out() {
        let page = "Text ![A curve](a.svg) and ![b](x://y/b.png).\n![Two\nlines](p/c.svg)\n";
        assert_eq!(figures(page).collect::<Vec<_>>(), [("A curve", "a.svg"), ("Two\nlines", "p/c.svg")]);
    }
}
