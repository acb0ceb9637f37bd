//! Gaps are filled, cut out or refused.

use crate::transform_support::Random;
use crate::transform_support::files::{file_of, map_with_gaps};
use scans::{MeasuredScan, Scan, UniformLineScan};
use topography::{BandLimits, Direction, GapTreatment, Recipe, ScanSpectrum, TransformError, without_gaps};

fn filled_m(scan: MeasuredScan) -> Vec<f64> {
    match without_gaps(file_of(scan), GapTreatment::Harmonic).expect("few gaps").scan {
        Scan::Map(map) => map.heights_m().to_vec(),
        Scan::UniformLine(line) => line.heights_m().to_vec(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_plane_is_continued_to_rounding_through_holes_of_any_shape() {
    let plane = |row: usize, column: usize| 1e-3 + 3e-9 * column as f64 - 7e-10 * row as f64;
    let is_gap = |row: usize, column: usize| {
        let ring = ((row as f64 - 40.0).hypot(column as f64 - 30.0) - 15.0).abs() < 2.0;
        ring || (row * 31 + column * 17).is_multiple_of(29)
            && (1..99).contains(&row)
            && (1..79).contains(&column)
            || row == 70 && (5..70).contains(&column)
    };
    let filled = filled_m(map_with_gaps(80, 100, [1e-9, 3e-9], plane, is_gap));
    for (at, height_m) in filled.iter().enumerate() {
        let expected_m = plane(at / 80, at % 80);
        assert!(
            (height_m - expected_m).abs() < 4.0 * f64::EPSILON * 1e-3,
            "{at}: {height_m} is not {expected_m}"
        );
    }
}

#[test]
fn every_filled_point_is_the_weighted_mean_of_its_neighbours() {
    for spacings_m in [[1.0, 1.0], [1.0, 3.0], [20.0, 1.0]] {
        let (columns, rows) = (90, 70);
        let mut random = Random(3);
        let heights = random.numbers(columns * rows);
        // A large hole at an edge, a comb, a block and single points.
        let is_gap = |row: usize, column: usize| {
            (column < 12 && (10..40).contains(&row))
                || (row < 20 && column > 40 && column.is_multiple_of(2) && column < 60)
                || ((45..60).contains(&row) && (40..70).contains(&column) && (row, column) != (50, 50))
                || (row == 60 && column % 7 == 3)
        };
        let map =
            map_with_gaps(columns, rows, spacings_m, |row, column| heights[row * columns + column], is_gap);
        let filled = filled_m(map);
        let [x, y] = spacings_m.map(|spacing_m| 1.0 / (spacing_m * spacing_m));
        for row in 0..rows {
            for column in 0..columns {
                let here = filled[row * columns + column];
                if !is_gap(row, column) {
                    assert_eq!(here, heights[row * columns + column]);
                    continue;
                }
                let (mut sum, mut weights) = (0.0, 0.0);
                let mut add = |row: Option<usize>, column: Option<usize>, weight: f64| {
                    if let (Some(row), Some(column)) =
                        (row.filter(|&r| r < rows), column.filter(|&c| c < columns))
                    {
                        sum += weight * filled[row * columns + column];
                        weights += weight;
                    }
                };
                add(Some(row), column.checked_sub(1), x);
                add(Some(row), Some(column + 1), x);
                add(row.checked_sub(1), Some(column), y);
                add(Some(row + 1), Some(column), y);
                assert!((here - sum / weights).abs() < 1e-10, "{spacings_m:?}, row {row}, column {column}");
            }
        }
    }
}

#[test]
fn gaps_of_a_line_lie_on_straight_lines_and_are_level_at_its_ends() {
    let heights_m = vec![9.0, 1.0, 2.0, 9.0, 9.0, 5.0, 4.0, 3.0, 2.0, 1.0, 0.0, 0.5, 1.0, 1.5, 2.0, 9.0];
    let line = UniformLineScan::new(1.0, heights_m).unwrap();
    let scan = MeasuredScan::with_missing_points(Scan::UniformLine(line), [0, 3, 4].into_iter().collect());
    let filled = filled_m(scan);
    assert_eq!(filled[..6], [1.0, 1.0, 2.0, 3.0, 4.0, 5.0]);
}

#[test]
fn gaps_of_a_line_lie_between_their_ends_even_below_the_normal_doubles() {
    // Both halves of an odd number of smallest doubles are rounded up.
    let height_m = f64::from_bits(7);
    let line = UniformLineScan::new(1.0, vec![height_m; 16]).unwrap();
    let scan = MeasuredScan::with_missing_points(Scan::UniformLine(line), [5].into_iter().collect());
    assert_eq!(filled_m(scan)[5], height_m);
}

#[test]
fn too_many_gaps_are_refused_with_what_to_do() {
    let refusal = |treatment, is_gap: &dyn Fn(usize, usize) -> bool| {
        let map = map_with_gaps(10, 10, [1.0, 1.0], |row, column| (row * column) as f64, is_gap);
        without_gaps(file_of(map), treatment).unwrap_err()
    };
    assert_eq!(
        refusal(GapTreatment::Harmonic, &|_, column| column < 3).to_string(),
        "30.0 % of the points have no height, and at most 20 % can be filled; crop the scan, use only lines without missing \
         points (gaps = \"lines\"), press a map with them (bem, gaps = \"keep\"), or measure with an instrument that loses fewer points"
    );
    assert!(matches!(refusal(GapTreatment::Refuse, &|row, _| row == 3), TransformError::Gaps(_)));
    for treatment in [GapTreatment::Harmonic, GapTreatment::Lines] {
        assert_eq!(refusal(treatment, &|_, _| true), TransformError::NoHeights { points: 100 });
    }
    assert_eq!(
        refusal(GapTreatment::Lines, &|row, column| row == column).to_string(),
        "no line along x has 16 neighbouring points with heights; crop the scan to a part with fewer missing points, or \
         measure with an instrument that loses fewer points"
    );
}

#[test]
fn what_was_filled_is_told() {
    let is_gap =
        |row: usize, column: usize| (row, column) == (1, 1) || (row == 5 && (4..7).contains(&column));
    let map = map_with_gaps(10, 10, [1e-6, 2e-6], |row, column| (row * column) as f64, is_gap);
    let file = without_gaps(file_of(map), GapTreatment::Harmonic).unwrap();
    assert_eq!(
        file.notes,
        [
            "4.00 % of the points have no height (2 holes, the largest 3 µm x 2 µm): filled by the harmonic surface through the \
          points around them"
        ]
    );
}

fn lines_of(scan: MeasuredScan) -> (scans::ParallelLines, Vec<String>) {
    let file = without_gaps(file_of(scan), GapTreatment::Lines).expect("lines");
    let Scan::Lines(lines) = file.scan else { panic!("{:?}", file.scan) };
    (lines, file.notes)
}

#[test]
fn whole_lines_take_part_where_they_are_enough() {
    let height_m = |row: usize, column: usize| (100 * row + column) as f64;
    let (lines, notes) =
        lines_of(map_with_gaps(20, 30, [1.0, 2.0], height_m, |row, column| column == 7 && row < 10));
    assert_eq!((lines.points(), lines.lines(), lines.heights_m()[0]), (20, 20, 1000.0));
    let across = lines.across().expect("columns");
    assert_eq!(
        (across.points(), across.lines(), across.spacing_m(), across.heights_m()[1]),
        (30, 19, 2.0, 100.0)
    );
    assert_eq!(
        notes,
        [
            "1.67 % of the points have no height: 20 whole lines of 20 m (20 points each) without missing points are used, \
          66.67 % of the points"
        ]
    );
}

#[test]
fn stretches_of_the_length_that_keeps_most_points_take_part_where_they_are_not() {
    let height_m = |row: usize, column: usize| (100 * row + column) as f64;
    // Each row is broken: 20 and 59 points, one row in 16 and 63.
    let is_gap = |row: usize, column: usize| column == if row == 3 { 16 } else { 20 };
    let (lines, _) = lines_of(map_with_gaps(80, 8, [1.0, 1.0], height_m, is_gap));
    assert_eq!((lines.points(), lines.lines()), (59, 8));
    assert_eq!(lines.heights_m()[3 * 59], 317.0);
    assert!(lines.across().is_none());

    let line = UniformLineScan::new(1.0, (0..50).map(f64::from).collect()).unwrap();
    let scan = MeasuredScan::with_missing_points(Scan::UniformLine(line), [15].into_iter().collect());
    let (lines, _) = lines_of(scan);
    assert_eq!((lines.points(), lines.lines(), lines.heights_m()[0]), (34, 1, 16.0));
}

#[test]
fn lines_cut_from_a_map_have_the_spectrum_of_the_map_where_nothing_is_cut() {
    let mut random = Random(5);
    let heights = random.numbers(64 * 40);
    let rough =
        |row: usize, column: usize| heights[64 * row + column] + 0.3 * column as f64 - 0.1 * row as f64;
    let is_gap = |row: usize, column: usize| (row, column) == (39, 63);
    let recipe =
        Recipe { gaps: GapTreatment::Lines, detrend: Some(topography::Detrend::Line), ..Recipe::default() };
    let spectrum = |scan: MeasuredScan, direction| {
        let recipe = Recipe { direction, ..recipe };
        let file = without_gaps(file_of(scan), recipe.gaps).expect("lines");
        ScanSpectrum::per_direction(file, BandLimits::default(), &recipe).expect("spectra")
    };
    let cut = || map_with_gaps(64, 40, [1.0, 2.0], rough, is_gap);
    let found = spectrum(cut(), Direction::Both);
    assert_eq!(
        found.iter().map(|scan| &scan.name[scan.name.len() - 9..]).collect::<Vec<_>>(),
        [", along x", ", along y"]
    );
    let upper = spectrum(map_with_gaps(64, 39, [1.0, 2.0], rough, |_, _| false), Direction::X);
    let left = spectrum(map_with_gaps(63, 40, [1.0, 2.0], rough, |_, _| false), Direction::Y);
    for (found, expected) in found.iter().zip(upper.iter().chain(&left)) {
        assert_eq!(found.spectrum.c1d_m3, expected.spectrum.c1d_m3);
        assert_eq!(found.checks.real_slope, expected.checks.real_slope);
    }
    assert_eq!(found[0].checks.slope_across, Some(found[1].checks.real_slope));
}

#[test]
fn a_line_has_no_other_direction_and_says_so() {
    let line = UniformLineScan::new(1.0, Random(1).numbers(64)).unwrap();
    for direction in [Direction::Y, Direction::Both] {
        let recipe = Recipe { direction, ..Recipe::default() };
        let file = without_gaps(file_of(Scan::UniformLine(line.clone()).into()), recipe.gaps).unwrap();
        let found = ScanSpectrum::per_direction(file, BandLimits::default(), &recipe).unwrap();
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].notes, ["ignoring the direction y: the spectrum of a line is along it"]);
    }
}
