//! No two modules of a crate import each other: what both need stands in a third.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use syn::visit::Visit;
use tests::committed_file;

/// The modules of a crate, each with those that it names.
type Imports = BTreeMap<String, BTreeSet<String>>;

#[test]
fn no_two_modules_import_each_other() {
    let mut circles = Vec::new();
    for entry in std::fs::read_dir(committed_file("crates")).unwrap() {
        let folder = entry.unwrap().path();
        let imports = imports(&folder.join("src"));
        assert!(!imports.is_empty(), "{} has no modules", folder.display());
        for (module, named) in &imports {
            let back = |other: &&String| *other > module && imports[*other].contains(module);
            let crate_name = folder.file_name().unwrap().to_string_lossy();
            circles
                .extend(named.iter().filter(back).map(|other| format!("{crate_name}: {module} and {other}")));
        }
    }
    assert!(circles.is_empty(), "these modules import each other:\n{}", circles.join("\n"));
}

/// Imports of the modules below a folder from each other. A module and one inside it are no pair: the outer one shows what the
/// inner one makes.
fn imports(src: &Path) -> Imports {
    let files = rust_files(src);
    let modules: BTreeSet<String> = files.iter().map(|file| module_of(file, src)).collect();
    let mut imports = Imports::new();
    for file in &files {
        let module = module_of(file, src);
        let text = std::fs::read_to_string(file).unwrap();
        let mut found = Paths { module: &module, found: Vec::new() };
        found.visit_file(
            &syn::parse_file(&text).unwrap_or_else(|error| panic!("{}: {error}", file.display())),
        );
        let inside = |outer: &str, inner: &str| outer.is_empty() || inner.starts_with(&format!("{outer}::"));
        let named = found
            .found
            .iter()
            .filter_map(|path| longest_module(path, &modules))
            .filter(|named| *named != module && !inside(named, &module) && !inside(&module, named));
        imports.insert(module.clone(), named.collect());
    }
    imports
}

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files
}

/// `plan::states` of `src/plan/states.rs`; nothing of the crate's root.
fn module_of(file: &Path, src: &Path) -> String {
    let path = file.strip_prefix(src).unwrap().with_extension("");
    let mut parts: Vec<&str> = path.iter().map(|part| part.to_str().unwrap()).collect();
    if matches!(parts.last(), Some(&"mod" | &"lib" | &"main")) {
        parts.pop();
    }
    parts.join("::")
}

fn longest_module(path: &[String], modules: &BTreeSet<String>) -> Option<String> {
    (1..=path.len()).rev().map(|length| path[..length].join("::")).find(|name| modules.contains(name))
}

/// The paths in a file that begin at the crate or a module above, from the crate's root; those of its tests are left out.
struct Paths<'m> {
    module: &'m str,
    found: Vec<Vec<String>>,
}

impl Paths<'_> {
    fn note(&mut self, path: &[String]) {
        let mut base: Vec<String> = match path.first().map(String::as_str) {
            Some("crate") => Vec::new(),
            Some("super") => {
                self.module.split("::").filter(|part| !part.is_empty()).map(str::to_owned).collect()
            }
            _ => return,
        };
        let ups = path.iter().take_while(|part| *part == "super").count();
        base.truncate(base.len().saturating_sub(ups));
        base.extend(path.iter().skip(ups.max(1)).cloned());
        self.found.push(base);
    }

    fn note_tree(&mut self, before: &[String], tree: &syn::UseTree) {
        let with = |name: &syn::Ident| [before, &[name.to_string()]].concat();
        match tree {
            syn::UseTree::Path(path) => self.note_tree(&with(&path.ident), &path.tree),
            syn::UseTree::Name(name) => self.note(&with(&name.ident)),
            syn::UseTree::Rename(renamed) => self.note(&with(&renamed.ident)),
            syn::UseTree::Glob(_) => self.note(before),
            syn::UseTree::Group(group) => group.items.iter().for_each(|tree| self.note_tree(before, tree)),
        }
    }
}

impl<'ast> Visit<'ast> for Paths<'_> {
    fn visit_item_mod(&mut self, module: &'ast syn::ItemMod) {
        let of_tests = module.attrs.iter().any(|attribute| attribute.path().is_ident("cfg"));
        if !of_tests {
            syn::visit::visit_item_mod(self, module);
        }
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        self.note_tree(&[], &item.tree);
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        let parts: Vec<String> = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        self.note(&parts);
        syn::visit::visit_path(self, path);
    }
}
