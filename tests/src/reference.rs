//! Reference tables of high-precision values, and quantiles of the deviation from them.

use std::path::{Path, PathBuf};

/// A table of reference values read by column name.
pub struct ReferenceTable {
    columns: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl ReferenceTable {
    /// A table committed with these tests, in `tests/reference`.
    pub fn committed(name: &str) -> Self {
        Self::read(&committed_file(&format!("tests/reference/{name}")))
    }

    /// The table in a file.
    pub fn read(path: &Path) -> Self {
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .from_path(path)
            .unwrap_or_else(|error| panic!("reading {}: {error}", path.display()));
        let columns = reader.headers().expect("a header").iter().map(str::to_owned).collect();
        let rows =
            reader.records().map(|row| row.expect("a row").iter().map(str::to_owned).collect()).collect();
        ReferenceTable { columns, rows }
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// True if the table has no rows.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// True if there is such a column.
    pub fn has(&self, column: &str) -> bool {
        self.columns.iter().any(|name| name == column)
    }

    /// The column as typed.
    pub fn text(&self, column: &str) -> Vec<&str> {
        let at = self
            .columns
            .iter()
            .position(|name| name == column)
            .unwrap_or_else(|| panic!("no column {column}"));
        self.rows.iter().map(|row| row[at].as_str()).collect()
    }

    /// The column as numbers.
    pub fn numbers(&self, column: &str) -> Vec<f64> {
        self.text(column)
            .iter()
            .map(|cell| cell.parse().unwrap_or_else(|_| panic!("{column}: {cell:?}")))
            .collect()
    }
}

/// A file of the shared folder beside the checkout, which tests that are ignored without it read.
pub fn shared_file(name: &str) -> PathBuf {
    committed_file("..").join("shared").join(name)
}

/// A file of this repository, from its top. The checkout is the one that cargo was called in, which need not be the one that
/// compiled this: two of them may share a folder for what is built.
pub fn committed_file(path: &str) -> PathBuf {
    let package = std::env::var_os("CARGO_MANIFEST_DIR")
        .map_or(PathBuf::from(env!("CARGO_MANIFEST_DIR")), PathBuf::from);
    let top = package.ancestors().find(|folder| folder.join("Cargo.lock").is_file());
    top.expect("a package of the workspace").join(path)
}

/// Relative deviations of computed values from their references.
#[derive(Default)]
pub struct Deviations(Vec<f64>);

impl Deviations {
    /// Notes the deviation of one value. An exact match, of zeros too, deviates by nothing.
    pub fn note(&mut self, computed: f64, reference: f64) {
        self.note_beyond(0.0, computed, reference);
    }

    /// Notes by how much the deviation of one value exceeds what no double-precision result could avoid.
    pub fn note_beyond(&mut self, unavoidable: f64, computed: f64, reference: f64) {
        let deviation = if computed == reference { 0.0 } else { (computed / reference - 1.0).abs() };
        // A comparison with NaN is false, and would pass any bound.
        self.0.push(if deviation.is_nan() { f64::INFINITY } else { (deviation - unavoidable).max(0.0) });
    }

    /// Asserts the largest deviation and the median, and that there was something to compare.
    pub fn assert_within(mut self, what: &str, median: f64, max: f64) {
        assert!(!self.0.is_empty(), "{what}: nothing was compared");
        self.0.sort_by(f64::total_cmp);
        let (middle, worst) = (self.0[self.0.len() / 2], self.0[self.0.len() - 1]);
        eprintln!("{what}: median {middle:.1e}, worst {worst:.1e} of {} values", self.0.len());
        assert!(worst <= max, "{what}: worst deviation {worst:e} above {max:e}");
        assert!(middle <= median, "{what}: median deviation {middle:e} above {median:e}");
    }
}
