//! The laws of one asperity, as `truearea asperity` fills in its tables, against high-precision tables.

use std::path::PathBuf;

use questions::rows::asperity_table::AsperityTable;
use tables::{Cells, TableSource};
use tests::{Deviations, ReferenceTable, committed_file, shared_file};

/// Recomputes the result columns of a table of references and compares each. Where the table tells how much a result
/// magnifies the rounding of its inputs, the deviation counts beyond that.
fn compare(law: AsperityTable, path: PathBuf, max: f64) {
    let references = ReferenceTable::read(&path);
    let file = std::fs::File::open(&path).unwrap();
    let mut computed = TableSource::new("references", file).and_then(TableSource::whole).unwrap();
    law.set_results(&mut computed, None).unwrap();
    let conditions = references.has("condition").then(|| references.numbers("condition"));
    for column in law.results() {
        let Some(Cells::Numbers(values)) = computed.table.column(column) else {
            panic!("{column} is not computed")
        };
        let mut deviations = Deviations::default();
        for (row, (value, reference)) in values.iter().zip(references.numbers(column)).enumerate() {
            let unavoidable =
                conditions.as_ref().map_or(0.0, |conditions| 2.0 * conditions[row] * f64::EPSILON);
            deviations.note_beyond(unavoidable, value.unwrap(), reference);
        }
        deviations.assert_within(column, max / 100.0, max);
    }
}

#[test]
#[ignore = "needs the shared folder"]
fn spheres_agree_with_the_shared_table() {
    compare(AsperityTable::Sphere, shared_file("reference/sphere.csv"), 2e-13);
}

#[test]
#[ignore = "needs the shared folder"]
fn sinusoids_agree_with_the_shared_table() {
    compare(AsperityTable::Sinusoid, shared_file("reference/sinusoid.csv"), 2e-13);
}

#[test]
#[ignore = "needs the shared folder"]
fn sinusoids_at_an_interference_agree_with_the_shared_table() {
    compare(AsperityTable::SinusoidInterference, shared_file("reference/sinusoid_interference.csv"), 2e-12);
}

#[test]
fn spheres_agree_with_the_hard_regions() {
    compare(AsperityTable::Sphere, committed_file("tests/reference/sphere.csv"), 2e-13);
}

#[test]
fn sinusoids_agree_with_the_hard_regions() {
    compare(AsperityTable::Sinusoid, committed_file("tests/reference/sinusoid.csv"), 2e-13);
}

#[test]
fn sinusoids_at_an_interference_agree_with_the_hard_regions() {
    let path = committed_file("tests/reference/sinusoid_interference.csv");
    compare(AsperityTable::SinusoidInterference, path, 2e-12);
}
