//! Follows the page on adding a format to the letter: its blocks make the sources that this checkout compiles and tests.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use tests::committed_file;

use crate::followed_page::{Sources, blocks, files_below, follow, take_back};

/// Files of code that adding a format touches, and files of tests that the page changes.
const FILES: [usize; 2] = [3, 1];

/// What only a reader's own files may say: code elsewhere does not know single formats.
const NAMES: [&str; 2] = ["ScanFormat::Gsf", "gsf::READER"];

#[test]
fn the_page_makes_the_reader_that_it_shows() {
    let page = fs::read_to_string(committed_file("docs/develop/adding-a-format.md")).unwrap();
    let files: BTreeSet<_> = blocks(&page).into_iter().map(|block| block.file).collect();
    let (code, tests): (Vec<_>, Vec<_>) =
        files.iter().partition(|file| file.starts_with("crates/surface/scans/src"));
    assert_eq!([code.len(), tests.len()], FILES, "{files:?}");
    let read = |file: &Path| fs::read(committed_file(file.to_str().unwrap())).unwrap();
    let committed: Sources = files.iter().map(|file| (file.clone(), read(file))).collect();
    let mut sources = committed.clone();
    take_back(&page, &mut sources);
    assert!(sources.len() < committed.len());
    let mentions = |sources: &Sources| {
        let text = |bytes: &Vec<u8>| String::from_utf8_lossy(bytes).to_lowercase();
        sources.iter().filter(|(_, bytes)| text(bytes).contains("gsf")).count()
    };
    assert_eq!(mentions(&sources), 0, "the page leaves something out");
    assert_eq!(follow(&page, &mut sources), files);
    for (file, bytes) in &committed {
        assert!(sources[file] == *bytes, "{} is not what the page makes of it", file.display());
    }
}

#[test]
fn no_other_source_knows_the_format() {
    let page = fs::read_to_string(committed_file("docs/develop/adding-a-format.md")).unwrap();
    let own: BTreeSet<_> =
        blocks(&page).iter().map(|block| committed_file(block.file.to_str().unwrap())).collect();
    let sources = files_below(&committed_file("crates"));
    let is_source = |path: &&std::path::PathBuf| path.extension().is_some_and(|ending| ending == "rs");
    for path in sources.iter().filter(is_source).filter(|path| !own.contains(*path)) {
        let text = fs::read_to_string(path).unwrap();
        assert!(!NAMES.iter().any(|name| text.contains(name)), "{}", path.display());
    }
}
