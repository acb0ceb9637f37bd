//! Zygo's text of points.

use crate::instruments::{Sample, assert_holds, heights, refusal};
use scans::Probe;

fn text(map: &str, distance_m: &str, points: &str) -> Vec<u8> {
    format!(
        "Zygo XYZ Data File - Format 1\n0 8 1 5 \"2020\"\n0 0 4 3 1 255\n{map}\n\"\"\n\"\"\n\"\"\n\
         0 0.5 6.328e-007 0 1 0 {distance_m} 1\n0 0 0\n0 1 0\n0\n1 0 20\n0\n#\n{points}"
    )
    .into()
}

const POINTS: &str = "10 20 0.5\n11 20 No Data\n10 21 1.5\n11 21\t2.5\n#\n";

pub fn samples() -> Vec<Sample> {
    vec![Sample { name: "points", bytes: text("10 20 2 2", "5.0e-006", POINTS) }]
}

#[test]
fn points_lie_where_their_lines_say() {
    let expected = [Some(0.5e-6), None, Some(1.5e-6), Some(2.5e-6)];
    let reordered = "11 21 2.5\n10 20 0.5\n10 21 1.5\n#\n";
    for points in [POINTS, reordered] {
        let file = &heights(&text("10 20 2 2", "5.0e-006", points))[0];
        assert_holds(&file.scan, (10e-6, Some(10e-6)), &expected, 1e-20);
        assert_eq!(file.probe, Some(Probe::Microscope));
    }
}

#[test]
fn damaged_texts_are_refused() {
    for (map, points) in [
        ("10 20 2 2", "10 20 0.5\n11 20 1\n"),
        ("10 20 2 2", "9 20 0.5\n#\n"),
        ("10 20 2 2", "12 20 0.5\n#\n"),
        ("10 20 2 2", "a 20 0.5\n#\n"),
        ("10 20 0 2", POINTS),
        ("10 20 90000 90000", POINTS),
        ("10 20 2", POINTS),
    ] {
        refused!(refusal(&text(map, "5.0e-006", points)), BadField {});
    }
    refused!(refusal(&text("10 20 2 2", "5.0e-006", "10 20 x\n#\n")), NotANumber { column: 3 });
    refused!(refusal(&text("10 20 2 2", "0", POINTS)), NoSize {});
    refused!(refusal(&text("", "5.0e-006", POINTS)), MissingField {});
}
