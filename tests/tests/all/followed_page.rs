//! Pages whose blocks of code a test applies to the sources.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Files by their paths in the checkout.
pub type Sources = BTreeMap<PathBuf, Vec<u8>>;

/// A block of code of a page.
pub struct Block {
    /// The file that the heading above it names.
    pub file: PathBuf,
    /// True for a whole new file, false for a change of one.
    pub is_new: bool,
    code: String,
}

/// Returns the blocks of code of a page below the headings that name files.
pub fn blocks(page: &str) -> Vec<Block> {
    let mut blocks = Vec::new();
    for section in page.split("\n### `").skip(1) {
        let section = section.split("\n## ").next().unwrap();
        let file = PathBuf::from(section.split('`').next().unwrap());
        for block in section.split("\n```").skip(1).step_by(2) {
            let (language, code) = block.split_once('\n').unwrap();
            let is_new = match language {
                "rust" => true,
                "diff" => false,
                other => panic!("a block of {other:?} under {}", file.display()),
            };
            blocks.push(Block { file: file.clone(), is_new, code: code.to_owned() });
        }
    }
    blocks
}

/// Applies every block of a page, and returns the files touched.
pub fn follow(page: &str, sources: &mut Sources) -> BTreeSet<PathBuf> {
    let blocks = blocks(page);
    for Block { file, is_new, code } in &blocks {
        if *is_new {
            let before = sources.insert(file.clone(), format!("{code}\n").into());
            assert!(before.is_none(), "{} is there already", file.display());
        } else {
            change(sources, file, code, ['+', '-']);
        }
    }
    blocks.into_iter().map(|block| block.file).collect()
}

/// Takes every block of a page back, the last first.
pub fn take_back(page: &str, sources: &mut Sources) {
    for Block { file, is_new, code } in blocks(page).iter().rev() {
        if *is_new {
            sources.remove(file).unwrap_or_else(|| panic!("no {}", file.display()));
        } else {
            change(sources, file, code, ['-', '+']);
        }
    }
}

/// Changes the lines of a block of differences: those without the first sign become those without the second.
fn change(sources: &mut Sources, file: &Path, block: &str, left_out: [char; 2]) {
    let text = sources.get_mut(file).unwrap_or_else(|| panic!("no {}", file.display()));
    let [before, after] = left_out.map(|left_out| {
        let lines = block.lines().filter(|line| !line.starts_with(left_out));
        lines.map(|line| format!("{}\n", line.get(1..).unwrap_or(""))).collect::<String>()
    });
    let old = std::str::from_utf8(text).unwrap();
    let found = old.matches(&before).count();
    assert_eq!(found, 1, "{} has the lines before this change {found} times:\n{block}", file.display());
    *text = old.replace(&before, &after).into();
}

pub fn files_below(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let below = |path: PathBuf| if path.is_dir() { files_below(&path) } else { vec![path] };
    entries.flat_map(|entry| below(entry.unwrap().path())).collect()
}
