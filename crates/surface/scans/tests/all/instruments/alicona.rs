//! Alicona: a depth image behind a list of tags.

use crate::instruments::refusal;
use scans::Probe;

use crate::instruments::bytes::Bytes;
use crate::instruments::{Sample, assert_holds, heights};

const TAGS: [(&str, &str); 6] = [
    ("Cols", "3"),
    ("Rows", "2"),
    ("PixelSizeXMeter", "5e-7"),
    ("PixelSizeYMeter", "2.5e-7"),
    ("InvalidPixelValue", "1.70141e38"),
    ("DepthImageOffset", "700"),
];

/// Rows of three points and one more to fill them up.
fn file(tags: &[(&str, &str)], missing: f32) -> Vec<u8> {
    let mut file = Bytes::default();
    file.put(b"AliconaImaging\0\r\n");
    let count = tags.len().to_string();
    for (key, value) in [("Version", "1"), ("TagCount", count.as_str())].iter().chain(tags) {
        file.text(key, 20).text(value, 30).put(b"\r\n");
    }
    file.text("turned", 256).pad_to(700);
    for point in [1e-6f32, -2e-6, 3e-6, 99.0, missing, f32::NAN, 6e-6, 99.0] {
        file.put(point.to_le_bytes());
    }
    file.0
}

/// The tags with another value for one of them.
fn with<'a>(key: &str, value: &'a str) -> Vec<(&'a str, &'a str)> {
    let mut tags: Vec<(&str, &str)> = TAGS.to_vec();
    tags.iter_mut().filter(|(own, _)| *own == key).for_each(|tag| tag.1 = value);
    tags
}

const MARK: f32 = 1.701_411_8e38;

pub fn samples() -> Vec<Sample> {
    vec![
        Sample { name: "depth", bytes: file(&TAGS, MARK) },
        Sample { name: "mark within reach", bytes: file(&with("InvalidPixelValue", "-0.5"), -0.5) },
    ]
}

#[test]
fn rows_are_cut_where_they_are_filled_up_and_marks_are_missing_points() {
    let marked =
        [("1.70141e38", MARK), ("-0.5", -0.5), ("-1e10", -1e10), ("0.1", 0.1), ("NaN", f32::INFINITY)];
    for (text, mark) in marked {
        let [scan] = heights(&file(&with("InvalidPixelValue", text), mark)).try_into().unwrap();
        let heights_m = [Some(1e-6), Some(-2e-6), Some(3e-6), None, None, Some(6e-6)];
        assert_holds(&scan.scan, (1.5e-6, Some(0.5e-6)), &heights_m, 1e-12);
        assert_eq!((scan.probe, scan.free_text.as_str()), (Some(Probe::Microscope), "turned"));
    }
}

#[test]
fn damage_is_told() {
    refused!(
        refusal(&file(&with("Cols", "-3"), 0.0)),
        BadField { field: "'Cols'", value: "'-3'", place: scans::FilePlace::Byte(141) }
    );
    refused!(refusal(&file(&TAGS[..5], 0.0)), MissingField { field: "tag 'DepthImageOffset'" });
    let mut line = file(&TAGS, 0.0);
    line[67] = b' ';
    refused!(refusal(&line), BadField { field: "the end of a tag", value: "another" });
    let many = file(&with("Rows", "1000000000000"), 0.0);
    refused!(refusal(&many), Truncated { needed: 15999999999996, available: 32 });
    refused!(refusal(&file(&with("PixelSizeXMeter", "0"), 0.0)), NoSize { what: "how large the map is" });
}
