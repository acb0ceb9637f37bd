//! X3P files whose points have positions of their own, and whose data stand in the XML.

use crate::instruments::refusal;
use crate::instruments::{Sample, assert_holds, heights};
use crate::support::x3p::X3p;
use crate::support::zip_file::{stored, zipped};
use crate::support::{read_one, self_affine_map};
use scans::{Probe, Scan, ScanOptions};

fn axis(name: &str, axis_type: &str, data_type: &str, increment: f64) -> String {
    format!(
        "<{name}><AxisType>{axis_type}</AxisType><DataType>{data_type}</DataType><Increment>{increment}</Increment>\
         <Offset>0</Offset></{name}>"
    )
}

/// `x` and `y` are `I` for even axes of 0.5 and 2 µm, or `A`.
fn described(feature: &str, (x, y): (&str, &str), dimension: &str, data: &str) -> String {
    format!(
        "<p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\"><Record1><FeatureType>{feature}</FeatureType>\
         <Axes>{}{}{}</Axes></Record1><Record2><ProbingSystem><Type>Contacting</Type></ProbingSystem><Comment>tip 2 \
         µm</Comment></Record2><Record3>{dimension}{data}</Record3></p:ISO5436_2>",
        axis("CX", x, "D", if x == "I" { 0.5e-6 } else { 1.0 }),
        axis("CY", y, "F", if y == "I" { 2e-6 } else { 1.0 }),
        axis("CZ", "A", "L", 1e-9),
    )
}

fn matrix(columns: usize, rows: usize) -> String {
    format!(
        "<MatrixDimension><SizeX>{columns}</SizeX><SizeY>{rows}</SizeY><SizeZ>1</SizeZ></MatrixDimension>"
    )
}

fn list(points: &[&str]) -> String {
    let points: String = points.iter().map(|point| format!("<Datum>{point}</Datum>")).collect();
    format!("<DataList>{points}</DataList>")
}

const LINK: &str = "<DataLink><PointDataLink>bindata/data.bin</PointDataLink></DataLink>";

/// Points (x, y, height) of a 2 x 3 grid, in m and nm.
const POINTS: [(f64, f64, i32); 5] =
    [(1e-6, 2e-6, 4), (0.0, 0.0, 1), (1e-6, 0.0, 2), (0.0, 4e-6, 5), (1e-6, 4e-6, 6)];
const ON_GRID: [Option<f64>; 6] = [Some(1e-9), Some(2e-9), None, Some(4e-9), Some(5e-9), Some(6e-9)];

fn cloud(points: &[(f64, f64, i32)]) -> Vec<u8> {
    let dimension = format!("<ListDimension>{}</ListDimension>", points.len());
    let bytes = points.iter().flat_map(|&(x, y, z)| {
        [x.to_le_bytes().to_vec(), (y as f32).to_le_bytes().to_vec(), z.to_le_bytes().to_vec()].concat()
    });
    let index = described("PCL", ("A", "A"), &dimension, LINK);
    zipped(&[("main.xml", index.as_bytes()), ("bindata/data.bin", &bytes.collect::<Vec<_>>())])
}

fn listed(feature: &str, axes: (&str, &str), dimension: &str, points: &[&str]) -> Vec<u8> {
    zipped(&[("main.xml", described(feature, axes, dimension, &list(points)).as_bytes())])
}

pub fn samples() -> Vec<Sample> {
    let sample = |name, bytes| Sample { name, bytes };
    vec![
        sample("points", cloud(&POINTS)),
        sample("listed", listed("SUR", ("I", "I"), &matrix(2, 2), &["1", "2", "", "4"])),
        sample("listed-profile", listed("PRF", ("A", "I"), &matrix(3, 1), &["0;1", "1e-6;2", "3e-6;3"])),
    ]
}

#[test]
fn points_on_a_grid_are_a_map() {
    let file = &heights(&cloud(&POINTS))[0];
    assert_eq!(file.scan.points(), (2, Some(3)));
    let heights_m: Vec<_> = file.scan.heights_m().collect();
    assert_eq!(heights_m.len(), ON_GRID.len());
    for (found, expected) in heights_m.iter().zip(ON_GRID) {
        assert!(
            found.is_none() == expected.is_none()
                && (found.unwrap_or(0.0) - expected.unwrap_or(0.0)).abs() < 1e-22
        );
    }
    let (x_m, y_m) = file.scan.spacing_m();
    assert!((x_m / 1e-6 - 1.0).abs() < 1e-9 && (y_m.unwrap() / 2e-6 - 1.0).abs() < 1e-6);
    assert_eq!((file.probe, file.free_text.as_str()), (Some(Probe::Tip), "tip 2 µm"));
}

#[test]
fn data_may_stand_in_the_description() {
    let even = &heights(&samples()[1].bytes)[0];
    assert_holds(&even.scan, (1e-6, Some(4e-6)), &[Some(1e-9), Some(2e-9), None, Some(4e-9)], 1e-22);
    let line = &heights(&samples()[2].bytes)[0];
    assert_eq!(line.scan.positions_m().unwrap(), [0.0, 1e-6, 3e-6]);
    // A point that does not count is left out of an unevenly spaced line.
    let missing = &heights(&listed("PRF", ("A", "A"), &matrix(3, 1), &["0;0;1", " ", "3e-6; 0; 3"]))[0];
    assert_eq!((missing.scan.positions_m().unwrap(), missing.notes.len()), ([0.0, 3e-6].as_slice(), 1));
    // A surface may give positions along one of its axes.
    let given = &heights(&listed("SUR", ("A", "I"), &matrix(2, 2), &["0;1", "1e-6;2", "0;3", "1e-6;4"]))[0];
    assert_holds(&given.scan, (2e-6, Some(4e-6)), &[Some(1e-9), Some(2e-9), Some(3e-9), Some(4e-9)], 1e-22);
}

#[test]
fn points_off_a_grid_and_damage_are_told() {
    let mut points = POINTS;
    points[0].0 = 0.7e-6;
    refused!(
        refusal(&cloud(&points)),
        Unsupported { found: "points that lie on no even grid, one at each of its points" }
    );
    points = POINTS;
    points[0] = points[1];
    refused!(
        refusal(&cloud(&points)),
        Unsupported { found: "points that lie on no even grid, one at each of its points" }
    );
    let list = |points: &[&str]| refusal(&listed("SUR", ("I", "I"), &matrix(2, 2), points));
    refused!(list(&["1", "2", "3"]), BadField { field: "the number of points", value: "3" });
    refused!(
        list(&["1", "2", "3", "4;5"]),
        BadField { field: "the number of values of a point", value: "2" }
    );
    refused!(list(&["1", "2", "3", "x"]), BadField { field: "the text", value: "'x'" });
    let even = listed("PCL", ("I", "A"), "<ListDimension>1</ListDimension>", &["1;2"]);
    refused!(refusal(&even), BadField { field: "the text", value: "'I'" });
}

#[test]
fn archives_of_other_programs_are_read() {
    let map = self_affine_map(4, 3);
    let read = |data_type: char, folder: &str, change: &dyn Fn(String) -> String| {
        let file = X3p { increment_m: 1.0, offset_m: 0.0, ..X3p::surface(data_type, 4, &map) };
        let index = change(file.main_xml());
        let [main, data] = ["main.xml", "bindata/data.bin"].map(|path| format!("{folder}{path}"));
        read_one(&stored(&[(&main, index.as_bytes()), (&data, &file.data())]), &ScanOptions::default())
    };
    let heights_m = |folder: &str, change: &dyn Fn(String) -> String| {
        let file = read('D', folder, change).unwrap();
        let Scan::Map(map) = file.scan else { panic!("a map") };
        (map.heights_m().to_vec(), file.notes.len())
    };
    assert_eq!(heights_m("scan 1/", &|index| index), (map.clone(), 0));
    // Empty offsets are none.
    assert_eq!(heights_m("", &|index| index.replace("<Offset>0</Offset>", "<Offset/>")), (map.clone(), 0));
    // Floating-point heights take no increment; a note says so.
    let scaled = |index: String| index.replace("<Increment>1</Increment>", "<Increment>1e-6</Increment>");
    assert_eq!(heights_m("a/b/", &scaled), (map.clone(), 1));
    let file = X3p::surface('D', 4, &map);
    let (index, data) = (file.main_xml(), file.data());
    let two =
        stored(&[("a/main.xml", index.as_bytes()), ("b/main.xml", index.as_bytes()), ("a/data.bin", &data)]);
    refused!(refusal(&two), Unsupported { found: "an archive with 2 files named 'main.xml'" });
}
