//! The modules of a crate import each other in one direction: no cycle of any length, in any crate.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use syn::visit::Visit;
use tests::committed_file;

/// A path by its segments, from the root of its crate.
type Segments = Vec<String>;

#[test]
fn no_modules_import_each_other_in_a_cycle() {
    let folders = crate_folders();
    assert!(folders.len() > 25, "only {} crates are found", folders.len());
    let mut cycles = Vec::new();
    for folder in folders {
        let source = Source::read(&folder.join("src"));
        assert!(!source.modules.is_empty(), "{} has no modules", folder.display());
        let name = folder.file_name().unwrap().to_string_lossy().into_owned();
        cycles.extend(
            cycles_of(&source.imports()).iter().map(|cycle| format!("{name}: {}", cycle.join(" -> "))),
        );
    }
    assert!(cycles.is_empty(), "these modules import each other:\n{}", cycles.join("\n"));
}

#[test]
fn a_cycle_of_three_modules_is_found_through_a_name_that_the_root_exports() {
    let file = |text: &str| syn::parse_file(text).unwrap();
    let source = Source::new([
        (String::new(), file("mod a; mod b; mod c; pub use c::Third;")),
        ("a".to_owned(), file("use crate::b::Second; pub struct First;")),
        ("b".to_owned(), file("use crate::Third; pub struct Second;")),
        ("c".to_owned(), file("pub struct Third; #[cfg(test)] mod tests { use crate::b::Second; }")),
    ]);
    assert!(cycles_of(&source.imports()).is_empty());
    let source = Source::new(source.modules.into_iter().map(|(name, module)| {
        let closes = name == "c";
        (name, if closes { file("pub struct Third; fn f(_: &crate::a::First) {}") } else { module })
    }));
    assert_eq!(cycles_of(&source.imports()), [["a", "b", "c", "a"]]);
}

#[test]
fn programs_hold_no_tests_since_most_are_built_without() {
    for file in crate_folders().iter().flat_map(|folder| rust_files(&folder.join("src"))) {
        let is_program =
            file.ends_with("src/main.rs") || file.parent().is_some_and(|at| at.ends_with("src/bin"));
        let text = std::fs::read_to_string(&file).unwrap();
        assert!(
            !is_program || !text.contains("#[test]"),
            "{}: move its tests to the library",
            file.display()
        );
    }
}

/// The folders of all crates: those of every floor, those of chores and `tests`.
fn crate_folders() -> Vec<PathBuf> {
    let inside = |folder: PathBuf| std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let floors = inside(committed_file("crates")).filter(|path| path.is_dir());
    let crates = floors.flat_map(inside).filter(|path| path.is_dir());
    crates.chain(["xtask", "xtask/publishing", "tests"].map(committed_file)).collect()
}

/// The modules of a crate by their paths, `plan::states` for `src/plan/states.rs` and nothing for the root.
struct Source {
    modules: BTreeMap<String, syn::File>,
    /// Names that a module has by `use`, each with its full path.
    used: BTreeMap<String, BTreeMap<String, Segments>>,
}

impl Source {
    fn read(src: &Path) -> Self {
        let parse = |file: PathBuf| {
            let text = std::fs::read_to_string(&file).unwrap();
            let parsed = syn::parse_file(&text).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
            (module_of(&file, src), parsed)
        };
        Self::new(rust_files(src).into_iter().map(parse))
    }

    fn new(modules: impl IntoIterator<Item = (String, syn::File)>) -> Self {
        let mut source = Self { modules: modules.into_iter().collect(), used: BTreeMap::new() };
        let used = |(module, file): (&String, &syn::File)| {
            let named = Paths::of(file).used.into_iter();
            let full = named.filter_map(|(name, path)| Some((name, source.absolute(&path, module)?)));
            (module.clone(), full.collect())
        };
        source.used = source.modules.iter().map(used).collect();
        source
    }

    /// The modules that each module names. A module and one inside it do not count: the outer one exports the items of the
    /// inner one.
    fn imports(&self) -> BTreeMap<&str, BTreeSet<&str>> {
        let inside = |outer: &str, inner: &str| outer.is_empty() || inner.starts_with(&format!("{outer}::"));
        let named = |(module, file)| {
            let module: &String = module;
            let paths = Paths::of(file).all;
            let owners = paths.iter().filter_map(|path| self.owner(self.absolute(path, module)?));
            let others =
                owners.filter(|named| named != module && !inside(named, module) && !inside(module, named));
            (module.as_str(), others.collect())
        };
        self.modules.iter().map(named).collect()
    }

    /// The module that owns the item of a path, also where others export it.
    fn owner(&self, mut path: Segments) -> Option<&str> {
        // A name leads over a few exports at the most; a path that leads back to itself ends here.
        for _ in 0..8 {
            let length = (0..=path.len())
                .rev()
                .find(|&length| self.modules.contains_key(&path[..length].join("::")))?;
            let (module, _) = self.modules.get_key_value(&path[..length].join("::"))?;
            match path.get(length).and_then(|name| self.used[module].get(name)) {
                Some(exported) => path = exported.iter().chain(&path[length + 1..]).cloned().collect(),
                None => return Some(module),
            }
        }
        None
    }

    /// A path in a module from the root of the crate; none for paths of other crates.
    fn absolute(&self, path: &[String], module: &str) -> Option<Segments> {
        let mut base: Segments =
            module.split("::").filter(|part| !part.is_empty()).map(str::to_owned).collect();
        let first = path.first()?;
        let left_out = match first.as_str() {
            "crate" => {
                base.clear();
                1
            }
            "self" => 1,
            "super" => {
                let parents = path.iter().take_while(|part| *part == "super").count();
                base.truncate(base.len().saturating_sub(parents));
                parents
            }
            _ => {
                let is_child =
                    self.modules.contains_key(&[&base[..], std::slice::from_ref(first)].concat().join("::"));
                let is_used = self.used.get(module).is_some_and(|used| used.contains_key(first));
                (is_child || is_used).then_some(0)?
            }
        };
        base.extend_from_slice(&path[left_out..]);
        Some(base)
    }
}

/// One shortest cycle for each group of modules that reach each other.
fn cycles_of<'m>(imports: &BTreeMap<&'m str, BTreeSet<&'m str>>) -> Vec<Vec<&'m str>> {
    let mut cycles = Vec::new();
    let mut covered = BTreeSet::new();
    for &start in imports.keys() {
        if covered.contains(start) {
            continue;
        }
        // Breadth first, until an import leads back to the start.
        let mut before: BTreeMap<&str, &str> = BTreeMap::new();
        let mut reached = vec![start];
        let mut at = 0;
        while at < reached.len() && !before.contains_key(start) {
            for &next in imports.get(reached[at]).into_iter().flatten() {
                if !before.contains_key(next) {
                    before.insert(next, reached[at]);
                    reached.push(next);
                }
            }
            at += 1;
        }
        if before.contains_key(start) {
            let mut cycle = vec![start, before[start]];
            while cycle[cycle.len() - 1] != start {
                cycle.push(before[cycle[cycle.len() - 1]]);
            }
            cycle.reverse();
            covered.extend(cycle.iter().copied());
            cycles.push(cycle);
        }
    }
    cycles
}

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let paths = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let below = |path: PathBuf| if path.is_dir() { rust_files(&path) } else { vec![path] };
    paths.flat_map(below).filter(|path| path.extension().is_some_and(|extension| extension == "rs")).collect()
}

fn module_of(file: &Path, src: &Path) -> String {
    let path = file.strip_prefix(src).unwrap().with_extension("");
    let mut parts: Vec<&str> = path.iter().map(|part| part.to_str().unwrap()).collect();
    if matches!(parts.last(), Some(&"mod" | &"lib" | &"main")) {
        parts.pop();
    }
    parts.join("::")
}

/// The paths in a file as written; those of its tests are left out.
#[derive(Default)]
struct Paths {
    all: Vec<Segments>,
    /// Names that the file has by `use`.
    used: Vec<(String, Segments)>,
}

impl Paths {
    fn of(file: &syn::File) -> Self {
        let mut paths = Self::default();
        paths.visit_file(file);
        paths
    }

    fn note_tree(&mut self, before: &[String], tree: &syn::UseTree) {
        let with = |name: &syn::Ident| [before, &[name.to_string()]].concat();
        let (name, path) = match tree {
            syn::UseTree::Path(path) => return self.note_tree(&with(&path.ident), &path.tree),
            syn::UseTree::Group(group) => {
                return group.items.iter().for_each(|tree| self.note_tree(before, tree));
            }
            syn::UseTree::Glob(_) => return self.all.push(before.to_vec()),
            syn::UseTree::Name(name) if name.ident == "self" => (before.last().cloned(), before.to_vec()),
            syn::UseTree::Name(name) => (Some(name.ident.to_string()), with(&name.ident)),
            syn::UseTree::Rename(renamed) => (Some(renamed.rename.to_string()), with(&renamed.ident)),
        };
        self.used.extend(name.map(|name| (name, path.clone())));
        self.all.push(path);
    }
}

impl<'ast> Visit<'ast> for Paths {
    fn visit_item_mod(&mut self, module: &'ast syn::ItemMod) {
        let is_of_tests = module.attrs.iter().any(|attribute| attribute.path().is_ident("cfg"));
        if !(is_of_tests && module.content.is_some()) {
            syn::visit::visit_item_mod(self, module);
        }
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        self.note_tree(&[], &item.tree);
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        self.all.push(path.segments.iter().map(|segment| segment.ident.to_string()).collect());
        syn::visit::visit_path(self, path);
    }
}
