//! The page on adding a law, followed to the letter: in a copy of the sources, which is compiled and run.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use tests::committed_file;

/// Number of files of code that a law may touch.
const MOST_FILES: usize = 8;

/// Crates that the program's own model of studies depends on, and none above it.
const CRATES: [&str; 17] = [
    "asperity",
    "contact-law",
    "gaussian-surfaces",
    "interface",
    "measurements",
    "numerics",
    "parallel",
    "persson",
    "scans",
    "spectrum",
    "stacked-contact",
    "stat-contact",
    "features",
    "study",
    "tables",
    "topography",
    "units",
];

/// A scene under the new model: as long as spheres are pressed to less than half their radius, their area is the load
/// over the hardness.
const FOLLOWED: &str = r#"//! A scene under the model that the page adds.

use study::NoFiles;
use scene::{Overrides, Scene};

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

/// Files by their paths in the checkout.
type Sources = BTreeMap<PathBuf, Vec<u8>>;

#[test]
fn the_page_touches_few_files_and_what_it_leads_to_compiles_and_runs() {
    let page = fs::read_to_string(committed_file("docs/adding-a-law.md")).unwrap();
    let mut sources = sources();
    let touched = follow(&page, &mut sources);
    assert!((5..=MOST_FILES).contains(&touched.len()), "{touched:?}");
    sources.insert("crates/study/study/tests/followed.rs".into(), FOLLOWED.into());
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("adding-a-law");
    write(&sources, &folder.join("sources"));
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let ran = Command::new(cargo)
        .args(["test", "--offline", "--lib", "--test", "states", "--test", "followed"])
        .args(["-p", "truearea-asperity", "-p", "truearea-stat-contact", "-p", "truearea-study"])
        .env("CARGO_TARGET_DIR", folder.join("target"))
        .current_dir(folder.join("sources"))
        .output()
        .unwrap();
    let [said, told] = [&ran.stdout, &ran.stderr].map(|bytes| String::from_utf8_lossy(bytes));
    assert!(ran.status.success(), "{said}\n{told}");
    let of_the_page = [
        "the_area_is_twice_that_of_hertz_up_to_the_cap",
        "fully_plastic_spheres_carry_their_hardness",
        "a_scene_is_carried_out_under_the_new_model",
    ];
    for test in of_the_page {
        assert!(said.lines().any(|line| line.contains(test) && line.ends_with(" ... ok")), "{test}\n{said}");
    }
}

/// The crates, a workspace of them alone, and the data that they hold.
fn sources() -> Sources {
    let mut sources = Sources::new();
    for name in CRATES {
        collect(Path::new("crates").join(name), &mut sources);
    }
    for path in ["data", "rust-toolchain.toml", "Cargo.lock", ".cargo"] {
        collect(path.into(), &mut sources);
    }
    let workspace = fs::read_to_string(committed_file("Cargo.toml")).unwrap();
    let members = CRATES.map(|name| format!("\"crates/{name}\"")).join(", ");
    let all = "members = [\"crates/*\", \"xtask\", \"tests\"]";
    assert!(workspace.contains(all));
    let workspace = workspace.replace(all, &format!("members = [{members}]"));
    sources.insert("Cargo.toml".into(), workspace.into());
    sources
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

/// Carries out every block of code of the page; the heading above it names its file. Yields the files.
fn follow(page: &str, sources: &mut Sources) -> BTreeSet<PathBuf> {
    let mut touched = BTreeSet::new();
    for section in page.split("\n### `").skip(1) {
        let section = section.split("\n## ").next().unwrap();
        let file = PathBuf::from(section.split('`').next().unwrap());
        for block in section.split("\n```").skip(1).step_by(2) {
            let (language, code) = block.split_once('\n').unwrap();
            match language {
                "rust" => {
                    let before = sources.insert(file.clone(), format!("{code}\n").into());
                    assert!(before.is_none(), "{} is there already", file.display());
                }
                "diff" => {
                    let text = sources.get_mut(&file).unwrap_or_else(|| panic!("no {}", file.display()));
                    *text = changed(std::str::from_utf8(text).unwrap(), code, &file).into();
                }
                other => panic!("a block of {other:?} under {}", file.display()),
            }
            touched.insert(file.clone());
        }
    }
    touched
}

/// A text with the lines of a block of differences changed.
fn changed(text: &str, block: &str, file: &Path) -> String {
    let [before, after] = ['+', '-'].map(|left_out| {
        let lines = block.lines().filter(|line| !line.starts_with(left_out));
        lines.map(|line| format!("{}\n", line.get(1..).unwrap_or(""))).collect::<String>()
    });
    let found = text.matches(&before).count();
    assert_eq!(found, 1, "{} has the lines before this change {found} times:\n{block}", file.display());
    text.replace(&before, &after)
}

/// Writes what differs, so that what was compiled before is compiled no more, and removes what does not belong there.
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

fn files_below(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let below = |path: PathBuf| if path.is_dir() { files_below(&path) } else { vec![path] };
    entries.flat_map(|entry| below(entry.unwrap().path())).collect()
}
