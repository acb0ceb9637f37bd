//! The columns of output tables, listed in `tests/columns/columns.txt`: scripts read them by name. A new column is added to the list.

use std::collections::BTreeSet;
use std::path::Path;

use crate::support::Bench;

fn listed(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../tests/columns").join(name);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn every_column_is_written() {
    let bench = Bench::new();
    for file in ["scene.toml", "rows.csv", "map.txt"] {
        bench.write(file, listed(file));
    }
    for line in listed("columns.txt").lines() {
        // The line of `run` has no columns: its tables are files, on the lines below.
        let (source, columns) = line.split_once(": ").unwrap_or((line.trim_end_matches(':'), ""));
        let table = if source.ends_with(".csv") && !source.contains(' ') {
            bench.read(source)
        } else {
            bench.run(&source.split(' ').collect::<Vec<_>>()).ok()
        };
        let header = table.lines().find(|line| !line.starts_with('#')).unwrap_or_default();
        let written: BTreeSet<&str> = header.split(',').collect();
        for column in columns.split(',').filter(|column| !column.is_empty()) {
            assert!(written.contains(column), "{source}: column {column} is missing in {header}");
        }
    }
}
