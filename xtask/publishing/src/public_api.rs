//! Public items of the published crates, compared with the committed lists.

use std::error::Error;
use std::process::Command;

use crate::package;
use xtask::checkout;

/// Folder of the lists, one for each crate.
const LISTS: &str = "tests/contract/public-api";

/// Compares the public items of every published crate with its list; with `accept` writes the lists anew.
pub(crate) fn run(accept: bool) -> Result<(), Box<dyn Error>> {
    let published = package::published(&checkout(""))?;
    describe()?;
    let mut moved = 0;
    for package in published.iter().filter(|package| !package.library.is_empty()) {
        let items = items(&package.library)?;
        let list = checkout(LISTS).join(format!("{}.txt", package.name));
        let committed = std::fs::read_to_string(&list).unwrap_or_default();
        if committed == items {
            continue;
        }
        moved += 1;
        for line in difference(&committed, &items) {
            println!("{}: {line}", package.name);
        }
        if accept {
            std::fs::create_dir_all(checkout(LISTS))?;
            std::fs::write(&list, items)?;
        }
    }
    match (moved, accept) {
        (0, _) => println!("the public items are those of {LISTS}"),
        (_, true) => println!("{moved} lists are new"),
        (_, false) => {
            return Err(format!("{moved} crates have other public items than {LISTS} lists; cargo xtask api --accept takes them").into());
        }
    }
    Ok(())
}

/// Lets rustdoc describe all libraries as JSON, with the features of the whole workspace. The pinned compiler does so behind a flag that is not stable; the version of
/// `public-api` is the one that reads its format.
fn describe() -> Result<(), Box<dyn Error>> {
    let mut cargo = Command::new(package::cargo_program());
    cargo
        .args(["doc", "--quiet", "--locked", "--no-deps", "--workspace", "--lib"])
        // Apart, as the flag would compile everything anew.
        .args(["--target-dir".as_ref(), checkout("target/public-api").as_os_str()])
        .env("RUSTC_BOOTSTRAP", "1")
        .env("RUSTDOCFLAGS", "-Z unstable-options --output-format json")
        .current_dir(checkout(""));
    if cargo.status()?.success() { Ok(()) } else { Err("rustdoc has failed".into()) }
}

/// Public items of a library, a line each, without what compilers and derives add.
fn items(library: &str) -> Result<String, Box<dyn Error>> {
    let json = checkout("target/public-api/doc").join(format!("{}.json", library.replace('-', "_")));
    let api = public_api::Builder::from_rustdoc_json(json)
        .omit_blanket_impls(true)
        .omit_auto_trait_impls(true)
        .omit_auto_derived_impls(true)
        .build()?;
    Ok(api.items().map(|item| format!("{item}\n")).collect())
}

/// Lines that only one of two lists has, marked as in a patch.
fn difference<'l>(before: &'l str, after: &'l str) -> impl Iterator<Item = String> {
    let lacks = |text: &str, line: &str| !text.lines().any(|other| other == line);
    let gone = before.lines().filter(move |line| lacks(after, line)).map(|line| format!("- {line}"));
    let new = after.lines().filter(move |line| lacks(before, line)).map(|line| format!("+ {line}"));
    gone.chain(new)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_that_only_one_list_has_are_marked() {
        let marked: Vec<String> = difference("a\nb\n", "b\nc\n").collect();
        assert_eq!(marked, ["- a", "+ c"]);
    }
}
