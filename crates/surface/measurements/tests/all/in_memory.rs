//! Composites of scans that are in memory already.

use std::collections::BTreeMap;

use measurements::{CompositeOfFiles, Loaded, NoFiles, ScanInput, ScanProblem, ScanRequest};
use numerics::parallel::Unobserved;
use scans::{MissingPoints, ScanFile, ScanSize};
use topography::Recipe;

const COLUMNS: usize = 64;
const ROWS: usize = 48;

fn height_nm(x: usize, y: usize) -> f64 {
    ((x * 7919 + y * 104_729) % 1009) as f64 / 1024.0
}

/// A map, 1 nm from point to point; every other row has a gap.
fn is_gap(x: usize, y: usize) -> bool {
    y.is_multiple_of(2) && x == (y * 37) % COLUMNS
}

fn points() -> impl Iterator<Item = (usize, usize)> {
    (0..ROWS).flat_map(|y| (0..COLUMNS).map(move |x| (x, y)))
}

fn files() -> BTreeMap<String, Vec<u8>> {
    let height = |x, y| if is_gap(x, y) { "nan".to_owned() } else { height_nm(x, y).to_string() };
    let row = |y| (0..COLUMNS).map(|x| height(x, y)).collect::<Vec<_>>().join("\t");
    let rows: Vec<String> = (0..ROWS).map(row).collect();
    let head = "# Channel: Topo\n# Width: 64 nm\n# Height: 48 nm\n# Value units: nm";
    BTreeMap::from([("scan.txt".to_owned(), format!("{head}\n{}\n", rows.join("\n")).into_bytes())])
}

fn request() -> ScanRequest {
    "scan.txt:tip-radius=2nm,instrument=AFM,z-calibration=3 %".parse().unwrap()
}

fn in_memory(loaded: Loaded) -> CompositeOfFiles {
    let asked = vec![ScanInput::InMemory(request(), loaded)];
    CompositeOfFiles::from_scans(asked, &NoFiles, &Recipe::default(), &Unobserved).unwrap()
}

fn heights() -> ScanFile {
    let heights_m = points().map(|(x, y)| if is_gap(x, y) { 0.0 } else { height_nm(x, y) / 1e9 }).collect();
    let gaps: MissingPoints =
        points().enumerate().filter(|(_, (x, y))| is_gap(*x, *y)).map(|(at, _)| at).collect();
    let size = ScanSize { x_m: 64e-9, y_m: Some(48e-9) };
    ScanFile::of_map("scan.txt".to_owned(), size, COLUMNS, heights_m, gaps).unwrap()
}

#[test]
fn what_is_in_memory_makes_the_composite_of_its_file() {
    let of_file = CompositeOfFiles::read(&[request()], &files(), &Recipe::default()).unwrap();
    let read_before = in_memory(Loaded::read(&request(), &files()).unwrap());
    assert_eq!(read_before.spectrum.composite.bins, of_file.spectrum.composite.bins);
    assert_eq!(read_before.sources, of_file.sources);
    assert_eq!(read_before.provenance(), of_file.provenance());

    let from_heights = in_memory(Loaded::from_heights(heights()));
    assert_eq!(from_heights.spectrum.composite.bins, of_file.spectrum.composite.bins);
    assert_eq!(from_heights.sources[0].instrument, of_file.sources[0].instrument);
    assert_ne!(from_heights.sources[0].sha256, of_file.sources[0].sha256);
    assert!(from_heights.provenance()[1].starts_with("scan: scan.txt (memory), SHA-256 "));
    let again = Loaded::from_heights(heights());
    assert_eq!((again.sha256.len(), &again.sha256), (64, &from_heights.sources[0].sha256));
}

#[test]
fn the_scan_to_blame_is_told_among_files_and_heights() {
    let missing = ScanRequest { path: "none.txt".to_owned(), ..ScanRequest::default() };
    let asked =
        vec![ScanInput::InMemory(request(), Loaded::from_heights(heights())), ScanInput::File(missing)];
    let error = CompositeOfFiles::from_scans(asked, &NoFiles, &Recipe::default(), &Unobserved).unwrap_err();
    assert_eq!((error.file.as_deref(), error.request), (Some("none.txt"), Some(1)));
    assert!(matches!(error.problem, ScanProblem::Reading(_)));
}
