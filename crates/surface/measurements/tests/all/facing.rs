//! Maps that face each other.

use std::collections::BTreeMap;

use measurements::{MapOfFile, PartialMap, ScanProblem, ScanRequest, TopographyError};
use scans::HeightMap;
use topography::{Detrend, GapTreatment, Recipe};
use units::RemarkCode;

/// A map with heights by place, from its middle, of which some points are missing.
fn map(
    [columns, rows]: [usize; 2],
    spacing_m: f64,
    height_m: impl Fn(f64, f64) -> f64,
    missing: &[usize],
) -> PartialMap {
    let from_middle = |at: usize, count: usize| spacing_m * (at as f64 - 0.5 * (count - 1) as f64);
    let points = 0..columns * rows;
    let heights_m = points
        .map(|point| height_m(from_middle(point % columns, columns), from_middle(point / columns, rows)))
        .collect();
    PartialMap {
        map: HeightMap::new(columns, spacing_m, spacing_m, heights_m).unwrap(),
        missing: missing.iter().copied().collect(),
    }
}

fn bumpy(x: f64, y: f64) -> f64 {
    (3.0 * x).sin() + 0.3 * x * y + (2.0 * y).cos()
}

fn wavy(x: f64, y: f64) -> f64 {
    (x + 0.5 * y).cos() - 0.2 * x
}

#[test]
fn column_i_meets_column_n_minus_1_minus_i() {
    let (own, other) = (map([5, 3], 0.1, bumpy, &[7]), map([5, 3], 0.1, wavy, &[0]));
    let sum = own.facing(&other).unwrap();
    for (point, sum_m) in sum.map.heights_m().iter().enumerate() {
        let turned = point / 5 * 5 + 4 - point % 5;
        if sum.missing.contains(point) {
            assert!(point == 7 || turned == 0);
        } else {
            assert_eq!(*sum_m, own.map.heights_m()[point] + other.map.heights_m()[turned]);
        }
    }
    assert_eq!(sum.missing.indices().collect::<Vec<_>>(), [4, 7]);
}

#[test]
fn exchanged_maps_have_the_mirror_image_of_the_sum() {
    for (points, spacing_m) in [([8, 6], 0.1), ([7, 9], 0.1), ([13, 4], 0.07), ([3, 3], 0.4)] {
        let (own, other) = (map([8, 6], 0.1, bumpy, &[11]), map(points, spacing_m, wavy, &[1]));
        let sum = own.facing(&other).unwrap();
        let exchanged = other.facing(&own).unwrap();
        let (columns, rows) = (sum.map.columns(), sum.map.rows());
        assert_eq!((columns, rows), (exchanged.map.columns(), exchanged.map.rows()));
        assert_eq!(sum.map.spacing_x_m(), exchanged.map.spacing_x_m());
        for point in 0..columns * rows {
            let turned = point / columns * columns + columns - 1 - point % columns;
            assert_eq!(sum.missing.contains(point), exchanged.missing.contains(turned));
            if !sum.missing.contains(point) {
                let (one_m, other_m) = (sum.map.heights_m()[point], exchanged.map.heights_m()[turned]);
                assert!((one_m - other_m).abs() < 1e-12, "{points:?}: {one_m} {other_m}");
            }
        }
    }
}

#[test]
fn the_finer_spacing_and_the_smaller_extent_count_and_planes_are_interpolated_exactly() {
    let plane = |x: f64, y: f64| 0.5 + 2.0 * x - y;
    let (own, other) = (map([9, 9], 0.2, plane, &[]), map([40, 12], 0.09, plane, &[]));
    let sum = own.facing(&other).unwrap();
    // Along x own ends first: 8 steps of 0.2 hold 17 of 0.09. Along y the other has 11 steps of 0.09.
    assert_eq!((sum.map.columns(), sum.map.rows()), (18, 12));
    assert_eq!([sum.map.spacing_x_m(), sum.map.spacing_y_m()], [0.09; 2]);
    for (point, sum_m) in sum.map.heights_m().iter().enumerate() {
        let y = 0.09 * ((point / 18) as f64 - 5.5);
        // Turned over, the slopes along x cancel.
        assert!((sum_m - (1.0 - 2.0 * y)).abs() < 1e-12, "{sum_m} {y}");
    }
    // Two points along either axis are left of any two maps.
    let narrow = map([2, 2], 1.0, plane, &[]).facing(&map([2, 2], 100.0, plane, &[])).unwrap();
    assert_eq!((narrow.map.columns(), narrow.map.spacing_x_m()), (2, 1.0));
}

/// A map as text.
fn text(unit: &str, side_um: f64, rows: &[Vec<Option<f64>>]) -> String {
    let cell = |height: &Option<f64>| height.map_or("nan".to_owned(), |height| format!("{height:.9}"));
    let lines: Vec<String> =
        rows.iter().map(|row| row.iter().map(cell).collect::<Vec<_>>().join("\t")).collect();
    format!(
        "# Channel: Topo\n# Width: {side_um} um\n# Height: {side_um} um\n# Value units: {unit}\n{}\n",
        lines.join("\n")
    )
}

fn rows_of(side: usize, height: impl Fn(usize, usize) -> Option<f64>) -> Vec<Vec<Option<f64>>> {
    (0..side).map(|row| (0..side).map(|column| height(row, column)).collect()).collect()
}

fn read(
    files: &BTreeMap<String, Vec<u8>>,
    own: &str,
    other: &str,
    recipe: &Recipe,
) -> Result<MapOfFile, TopographyError> {
    let [own, other]: [ScanRequest; 2] = [own, other].map(|request| request.parse().unwrap());
    MapOfFile::read_facing([&own, &other], &files[&own.path], files, recipe, false)
}

fn some_files() -> BTreeMap<String, Vec<u8>> {
    let height = |row: usize, column: usize, seed: usize| {
        ((row * 7919 + column * 104_729 + seed * 31) % 1009) as f64 / 1009.0 + 0.1 * column as f64
    };
    let own = rows_of(16, |row, column| (row + column > 2).then(|| height(row, column, 1)));
    let other = rows_of(16, |row, column| Some(height(row, column, 5)));
    let sum = rows_of(16, |row, column| Some(own[row][column]? + other[row][15 - column]?));
    let small = rows_of(12, |row, column| other[row][column]);
    let line = "# x (nm) h (nm)\n0 1\n1 3\n2 2\n3 2\n".to_owned();
    let files = [
        ("own.txt", text("um", 16.0, &own)),
        ("other.txt", text("um", 16.0, &other)),
        ("sum.txt", text("um", 16.0, &sum)),
        ("small.txt", text("um", 12.0, &small)),
        ("far.txt", text("um", 16e6, &other)),
        ("line.txt", line),
        ("psd.csv", "wavelength_m,C1D_m3\n1e-6,1e-24\n1e-7,1e-27\n1e-8,1e-30\n".to_owned()),
    ];
    BTreeMap::from(files.map(|(name, text)| (name.to_owned(), text.into_bytes())))
}

fn keeping(detrend: Detrend) -> Recipe {
    Recipe { gaps: GapTreatment::Keep, detrend: Some(detrend), ..Recipe::default() }
}

#[test]
fn two_files_are_the_file_of_their_sum() {
    let files = some_files();
    for detrend in Detrend::ALL {
        let recipe = keeping(*detrend);
        let pair = read(&files, "own.txt", "other.txt", &recipe).unwrap();
        let sum: ScanRequest = "sum.txt".parse().unwrap();
        let sum = MapOfFile::read(&sum, &files["sum.txt"], &files, &recipe, false).unwrap();
        assert_eq!(pair.heights.missing, sum.heights.missing);
        assert_eq!(pair.heights.missing.count(), 6);
        for (pair_m, sum_m) in pair.heights.map.heights_m().iter().zip(sum.heights.map.heights_m()) {
            assert!((pair_m - sum_m).abs() < 3e-15, "{detrend}: {pair_m} {sum_m}");
        }
        assert!(pair.provenance.contains("own.txt") && pair.provenance.contains("other.txt"));
        let codes: Vec<RemarkCode> = pair.remarks.iter().map(|remark| remark.code).collect();
        assert_eq!(codes, [RemarkCode::FacingMaps]);
    }
}

#[test]
fn differences_of_size_are_noted() {
    let files = some_files();
    let recipe = keeping(Detrend::Plane);
    let noted = |other: &str| {
        let found = read(&files, "own.txt", other, &recipe).unwrap();
        let noted: Vec<(RemarkCode, bool)> =
            found.remarks.iter().map(|remark| (remark.code, remark.text("differ").is_some())).collect();
        (found.heights.map.columns(), noted)
    };
    assert_eq!(noted("other.txt"), (16, vec![(RemarkCode::FacingMaps, false)]));
    assert_eq!(noted("small.txt"), (12, vec![(RemarkCode::FacingMaps, true)]));
    let apart = vec![(RemarkCode::FacingMaps, true), (RemarkCode::FacingSizesApart, false)];
    assert_eq!(noted("far.txt"), (16, apart));
}

#[test]
fn what_does_not_face_a_map_is_refused() {
    let files = some_files();
    let problem = |own: &str, other: &str| {
        let error = read(&files, own, other, &Recipe::default()).unwrap_err();
        (error.file.unwrap(), error.problem)
    };
    for (own, other) in [("own.txt", "line.txt"), ("line.txt", "own.txt")] {
        let (file, problem) = problem(own, other);
        assert_eq!(file, "line.txt");
        assert!(matches!(problem, ScanProblem::LineFacesMap { map } if map == "own.txt"));
    }
    let (file, spectrum) = problem("own.txt", "psd.csv");
    assert!(file == "psd.csv" && matches!(spectrum, ScanProblem::HoldsASpectrum));
    let (file, idle) = problem("own.txt", "other.txt:detrend=mean");
    assert!(file == "other.txt" && matches!(idle, ScanProblem::UnusedOption("detrend")));
    let (file, lines) = problem("line.txt", "line.txt");
    assert!(file == "line.txt" && matches!(lines, ScanProblem::LineIsNoSurface));
}

#[test]
fn a_trend_is_fitted_through_the_points_that_are_left() {
    // A tilted plane with a frame of missing points is flat without its trend.
    let plane = rows_of(12, |row, column| {
        let is_inside = (3..9).contains(&row) && (2..11).contains(&column);
        is_inside.then_some(3.0 + 0.7 * column as f64 - 0.4 * row as f64)
    });
    let files = BTreeMap::from([("plane.txt".to_owned(), text("um", 12.0, &plane).into_bytes())]);
    let request: ScanRequest = "plane.txt".parse().unwrap();
    let read =
        |detrend| MapOfFile::read(&request, &files["plane.txt"], &files, &keeping(detrend), false).unwrap();
    let largest_m = |detrend| {
        read(detrend).heights.map.heights_m().iter().fold(0.0f64, |most, height| most.max(height.abs()))
    };
    assert!(largest_m(Detrend::Plane) < 1e-14 && largest_m(Detrend::Line) < 1e-14);
    assert!(largest_m(Detrend::Mean) > 1e-6);
    let mean = read(Detrend::Mean);
    let measured = (0..144).filter(|&point| !mean.heights.missing.contains(point));
    assert!(
        measured.map(|point| mean.heights.map.heights_m()[point]).sum::<f64>().abs() < 1e-18 * 54.0 * 1e4
    );
    assert_eq!(mean.heights.missing.count(), 144 - 54);
}

#[test]
fn maps_of_other_spacings_meet_in_their_middle() {
    // A face against its counterpart on other grids, each over the same side.
    let height = |x: f64, y: f64| (3.0 * x).sin() + (2.0 * y).cos();
    let own = map([64, 64], 1.0 / 64.0, height, &[]);
    for points in [63, 65, 96, 100, 128] {
        let other = map([points, points], 1.0 / points as f64, |x, y| -height(-x, y), &[]);
        let sum = own.facing(&other).unwrap();
        let largest_m = sum.map.heights_m().iter().fold(0.0, |most: f64, sum_m| most.max(sum_m.abs()));
        // The error of a straight line between points; half a point would be 0.02.
        assert!(largest_m < 1e-3, "{points}: {largest_m}");
    }
}
