//! The one map of a file: its areal spectrum, and its heights as they are pressed.

use std::collections::BTreeMap;

use measurements::{MapOfFile, ScanProblem, ScanRequest, TopographyError, areal_spectrum};
use topography::{Recipe, TransformError};

/// A map of 64 x 48 points, 1 nm apart; one point of every other row has no height.
fn map_with_gaps() -> String {
    let height = |x: usize, y: usize| match y.is_multiple_of(2) && x == (y * 37) % 64 {
        true => "nan".to_owned(),
        false => format!("{:.6}", ((x * 7919 + y * 104_729) % 1009) as f64 / 1009.0),
    };
    let row = |y| (0..64).map(|x| height(x, y)).collect::<Vec<_>>().join("\t");
    let rows: Vec<String> = (0..48).map(row).collect();
    format!("# Channel: Topo\n# Width: 64 nm\n# Height: 48 nm\n# Value units: nm\n{}\n", rows.join("\n"))
}

fn files(text: &str) -> BTreeMap<String, Vec<u8>> {
    BTreeMap::from([("scan.txt".to_owned(), text.as_bytes().to_vec())])
}

fn areal(text: &str, options: &str) -> Result<Vec<String>, TopographyError> {
    let request: ScanRequest = format!("scan.txt{options}").parse().unwrap();
    let found = areal_spectrum(&request, &files(text), &Recipe::default())?;
    Ok(found.remarks.iter().map(|remark| format!("{remark:?}")).collect())
}

fn pressed(text: &str, options: &str) -> Result<MapOfFile, TopographyError> {
    let request: ScanRequest = format!("scan.txt{options}").parse().unwrap();
    MapOfFile::read(&request, text.as_bytes(), &files(text), &Recipe::default(), false)
}

#[test]
fn lines_that_gaps_left_are_told_from_lines_that_were_scanned() {
    assert!(areal(&map_with_gaps(), "").is_ok() && pressed(&map_with_gaps(), "").is_ok());
    let of_area = areal(&map_with_gaps(), ":gaps=lines").unwrap_err();
    let of_surface = pressed(&map_with_gaps(), ":gaps=lines").unwrap_err();
    for error in [of_area, of_surface] {
        let ScanProblem::Transform { error: TransformError::LinesHaveNoArea, .. } = error.problem else {
            panic!("{error}")
        };
        assert!(error.to_string().contains("gaps = \"harmonic\""), "{error}");
    }
    let line = "# x (nm) h (nm)\n0 1\n1 3\n2 2\n3 2\n";
    assert!(matches!(areal(line, "").unwrap_err().problem, ScanProblem::LineHasNoArea));
    assert!(matches!(pressed(line, "").unwrap_err().problem, ScanProblem::LineIsNoSurface));
}

#[test]
fn a_direction_is_refused_of_an_areal_spectrum_and_told_of_a_map_that_is_pressed() {
    let map = map_with_gaps();
    for direction in ["x", "y", "both"] {
        let refused = areal(&map, &format!(":direction={direction}")).unwrap_err();
        let told = format!(
            "scan.txt: an areal spectrum averages over all directions of a map; leave out direction = \"{direction}\""
        );
        assert!(refused.to_string().starts_with(&told), "{refused}");
        let of_all = Recipe { direction: direction.parse().unwrap(), ..Recipe::default() };
        let request = ScanRequest { path: "scan.txt".to_owned(), ..ScanRequest::default() };
        // A recipe has a direction in any case, and x is its default.
        assert_eq!(areal_spectrum(&request, &files(&map), &of_all).is_ok(), direction == "x");
    }

    let told_of = |options: &str| {
        let found = pressed(&map, options).unwrap();
        (found.heights.map.columns(), format!("{:?}", found.remarks).contains("direction both"))
    };
    assert_eq!(told_of(":direction=both"), (64, true));
    assert_eq!(told_of(":direction=y"), (48, false));
    assert_eq!(told_of(""), (64, false));
}
