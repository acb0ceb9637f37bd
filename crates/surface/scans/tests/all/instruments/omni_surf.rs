//! OmniSurf3D: heights behind texts of any length.

use crate::instruments::refusal;

use crate::instruments::bytes::Bytes;
use crate::instruments::{Sample, assert_holds, heights};

fn map(spacing: f64, rows: u32) -> Vec<u8> {
    let mut file = Bytes::default();
    file.put("OmniSurf3D").put(1u32.to_le_bytes()).put(0u32.to_le_bytes());
    for text in ["plateau honed", "2024-01-02 03:04:05"] {
        file.put((text.len() as u32).to_le_bytes()).put(text);
    }
    file.put(3u32.to_le_bytes()).put(rows.to_le_bytes());
    for number in [spacing, 2.0, 0.0, 0.0] {
        file.put(number.to_le_bytes());
    }
    for point in [1.0, -2.0, 3.0, f32::MIN, 5.0, 6.0] {
        file.put(point.to_le_bytes());
    }
    file.0
}

pub fn samples() -> Vec<Sample> {
    vec![Sample { name: "map", bytes: map(0.5, 2) }, Sample { name: "line", bytes: map(0.5, 1) }]
}

#[test]
fn maps_and_lines_are_read() {
    let [scan] = heights(&map(0.5, 2)).try_into().unwrap();
    let heights_m = [1.0, -2.0, 3.0, 0.0, 5.0, 6.0].map(|um| Some(um * 1e-6).filter(|_| um != 0.0));
    assert_holds(&scan.scan, (1.5e-6, Some(4e-6)), &heights_m, 1e-20);
    assert_eq!(scan.free_text, "plateau honed");
    let [line] = heights(&map(0.5, 1)).try_into().unwrap();
    assert_holds(&line.scan, (1.5e-6, None), &heights_m[..3], 1e-20);
}

#[test]
fn damage_is_told() {
    refused!(
        refusal(&map(-1.0, 2)),
        BadField { field: "the distance of columns", value: "-1", place: scans::FilePlace::Byte(66) }
    );
    refused!(refusal(&map(1.0, 3)), Truncated { needed: 36, available: 24 });
    refused!(refusal(&map(1.0, 0)), BadField { field: "the number of rows", value: "0" });
    refused!(refusal(&map(1.0, 2)[..30]), Truncated { needed: 13, available: 8 });
}
