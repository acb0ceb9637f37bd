//! Follows the page on adding a law to the letter, in a copy of the sources, which is compiled and run.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use tests::committed_file;

use crate::followed_page::{Sources, files_below, follow};

/// Files that adding a law touches: four of code, and the tests that all laws share.
const FILES: usize = 5;

/// Crates whose tests run in the copy. It holds them and every crate that they use.
const TESTED: [&str; 4] = ["asperity", "stat-contact", "study", "scene"];

/// Profile of the copy, which is compiled from nothing: what runs is short, so optimisation would cost more than it saves.
const PROFILE: &str = "[profile.dev]\ndebug = false\nincremental = false\n";

/// A scene under the new model: as long as spheres are pressed to less than half their radius, their area is the load
/// over the hardness.
const FOLLOWED: &str = r#"//! A scene under the model that the page adds.

use scene::{Overrides, Scene};
use study::NoFiles;

const SCENE: &str = "
[surface]
psd = 'builtin:uncd-measured'
[material]
youngs_modulus = '463 GPa'
poisson_ratio = 0.2
yield_strength = '1.8 GPa'
[loads]
pressures = ['1e-3 H']
[[curve]]
model = 'plastic-sphere'
";

#[test]
fn a_scene_is_carried_out_under_the_new_model() {
    let scene = Scene::parse(SCENE, &NoFiles, &Overrides::default()).unwrap();
    assert_eq!(scene.needs.curves[0].name, "plastic-sphere");
    let results = scene.plan().compute().unwrap();
    let (_, area_fraction) = results.curves[0].area_fractions(0)[0];
    assert!((area_fraction / 1e-3 - 1.0).abs() < 1e-6, "{area_fraction}");
}
"#;

#[test]
fn the_page_touches_few_files_and_its_law_compiles_and_runs() {
    let pages = files_below(&committed_file("docs"));
    let page = pages.iter().find(|path| path.ends_with("adding-a-law.md")).expect("a page on adding a law");
    let page = fs::read_to_string(page).unwrap();
    let mut sources = sources();
    let touched = follow(&page, &mut sources);
    assert_eq!(touched.len(), FILES, "{touched:?}");
    sources.insert("crates/answer/scene/tests/followed.rs".into(), FOLLOWED.into());
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("adding-a-law");
    write(&sources, &folder.join("sources"));
    let tests_of_the_page = [
        "the_area_is_twice_that_of_hertz_up_to_the_cap",
        "fully_plastic_spheres_carry_their_hardness",
        "a_scene_is_carried_out_under_the_new_model",
    ];
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let ran = Command::new(cargo)
        .args(["test", "--offline", "--lib", "--test", "all", "--test", "followed"])
        .args(TESTED.map(|name| format!("--package=truearea-{name}")))
        .arg("--")
        .args(tests_of_the_page)
        .env("CARGO_TARGET_DIR", folder.join("target"))
        .current_dir(folder.join("sources"))
        .output()
        .unwrap();
    let [out, err] = [&ran.stdout, &ran.stderr].map(|bytes| String::from_utf8_lossy(bytes));
    assert!(ran.status.success(), "{out}\n{err}");
    for test in tests_of_the_page {
        assert!(out.lines().any(|line| line.contains(test) && line.ends_with(" ... ok")), "{test}\n{out}");
    }
}

/// The tested crates with all that they use, a workspace of them alone, and the data that they hold.
fn sources() -> Sources {
    let workspace = fs::read_to_string(committed_file("Cargo.toml")).unwrap();
    let mut sources = Sources::new();
    let members = members(&workspace);
    for path in
        members.iter().map(String::as_str).chain(["data", "rust-toolchain.toml", "Cargo.lock", ".cargo"])
    {
        collect(path.into(), &mut sources);
    }
    let all = workspace.lines().find(|line| line.starts_with("members = ")).unwrap();
    let (manifest, _profiles) = workspace.split_once("[profile.").unwrap();
    let members = Vec::from_iter(members);
    let manifest = manifest.replace(all, &format!("members = {members:?}"));
    sources.insert("Cargo.toml".into(), format!("{manifest}\n{PROFILE}").into());
    sources
}

/// The folders of the tested crates and of every crate of the workspace below them.
fn members(workspace: &str) -> BTreeSet<String> {
    let folders: BTreeMap<&str, &str> = workspace
        .lines()
        .filter_map(|line| line.split_once(" = { path = \""))
        .map(|(name, rest)| (name, rest.split('"').next().unwrap()))
        .collect();
    let mut members = BTreeSet::new();
    let mut open = TESTED.to_vec();
    while let Some(name) = open.pop() {
        if !members.insert(folders[name].to_owned()) {
            continue;
        }
        let manifest = fs::read_to_string(committed_file(folders[name]).join("Cargo.toml")).unwrap();
        let used = |line: &&str| line.contains("workspace = true");
        let names = manifest.lines().filter(used).filter_map(|line| line.split(['.', ' ']).next());
        open.extend(names.filter_map(|name| folders.get_key_value(name).map(|(name, _)| *name)));
    }
    members
}

/// A file, or every file of a folder.
fn collect(path: PathBuf, sources: &mut Sources) {
    let committed = committed_file(path.to_str().unwrap());
    if committed.is_dir() {
        for entry in fs::read_dir(committed).unwrap() {
            collect(path.join(entry.unwrap().file_name()), sources);
        }
    } else if committed.is_file() {
        sources.insert(path, fs::read(committed).unwrap());
    }
}

/// Writes the files that differ, so that the others are not compiled again, and removes those that do not belong there.
fn write(sources: &Sources, folder: &Path) {
    for old in files_below(folder) {
        if !sources.contains_key(old.strip_prefix(folder).unwrap()) {
            fs::remove_file(old).unwrap();
        }
    }
    for (path, bytes) in sources {
        let path = folder.join(path);
        if fs::read(&path).is_ok_and(|written| &written == bytes) {
            continue;
        }
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, bytes).unwrap();
    }
}
