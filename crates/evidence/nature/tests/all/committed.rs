//! The committed page is what its generator makes of the committed tables.

use std::fs::{File, read_to_string};
use std::path::{Path, PathBuf};

use nature::joint::JointRow;
use nature::page::{sections, written};
use nature::table::{ResistanceRow, exponents, percentile, read, write};

fn docs(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../docs").join(path)
}

fn committed() -> (Vec<ResistanceRow>, Vec<JointRow>) {
    let table = |name: &str| File::open(docs(&format!("develop/nature/{name}.csv"))).unwrap();
    (read(table("resistances")).unwrap(), read(table("joints")).unwrap())
}

#[test]
fn the_tables_of_the_page_are_those_of_the_committed_tables() {
    let page = read_to_string(docs("guide/nature.md")).unwrap();
    let (rows, joints) = committed();
    let written = written(&page, &rows, &joints).unwrap();
    if std::env::var_os("TRUEAREA_ACCEPT").is_some() {
        std::fs::write(docs("guide/nature.md"), &written).unwrap();
    }
    assert_eq!(written, page);
    assert!(page.split_whitespace().count() <= 1200);
}

#[test]
fn most_of_the_visible_rows_lie_inside_ranges_that_say_something() {
    let (rows, _) = committed();
    assert!(rows.iter().filter(|row| row.is_inside()).count() as f64 >= 0.8 * rows.len() as f64);
    assert!(percentile(rows.iter().map(ResistanceRow::width), 0.9).unwrap() <= 6.0);
    let heavy = rows.iter().filter(|row| row.pressure_mpa >= 1.0);
    assert!(heavy.clone().count() > 10 && heavy.map(ResistanceRow::stated_width).all(|width| width < 3.0));
}

#[test]
fn an_exponent_is_the_slope_within_groups() {
    let (rows, _) = committed();
    let row = |pressure_mpa: f64, measured: f64, temperature_c: f64| ResistanceRow {
        pressure_mpa,
        measured,
        predicted: pressure_mpa,
        temperature_c,
        ..rows[0].clone()
    };
    // p^0.5 in two groups of other heights, and a row that has no neighbour.
    let made = [
        row(1.0, 3.0, 20.0),
        row(4.0, 6.0, 20.0),
        row(2.0, 8.0, 25.0),
        row(8.0, 16.0, 25.0),
        row(1.0, 9.0, 30.0),
    ];
    let found = exponents(made.iter()).unwrap();
    assert!((found[0] - 0.5).abs() < 1e-12 && (found[1] - 1.0).abs() < 1e-12);
    assert!(exponents(made[4..].iter()).is_none());
}

#[test]
fn tables_survive_writing() {
    let (rows, joints) = committed();
    let mut text = Vec::new();
    write(&joints, &mut text).unwrap();
    assert_eq!(read::<JointRow>(&text[..]).unwrap(), joints);
    let names = |rows: &[ResistanceRow], joints: &[JointRow]| -> Vec<&str> {
        sections(rows, joints).into_iter().map(|(name, _)| name).collect()
    };
    assert_eq!(names(&rows, &joints), ["resistances", "exponents", "joints"]);
    assert_eq!(names(&[], &joints), ["joints"]);
    assert_eq!(percentile([3.0, 1.0, 2.0].into_iter(), 0.5), Some(2.0));
    assert_eq!(percentile(std::iter::empty(), 0.5), None);
}
