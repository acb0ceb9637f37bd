//! Zeta: counts behind a header and a comment.

use crate::instruments::refusal;
use scans::Probe;

use crate::instruments::bytes::Bytes;
use crate::instruments::{Sample, assert_holds, heights};

fn map(step: f32) -> Vec<u8> {
    let mut file = Bytes::default();
    file.put("Zeta-Instruments").pad_to(85).put(3u32.to_le_bytes()).put(2u32.to_le_bytes()).zeros(4);
    for number in [0.5, 0.25, step] {
        file.put(number.to_le_bytes());
    }
    file.zeros(8).put(4u32.to_le_bytes()).zeros(10).text("recipe", 68).zeros(6).put("etch");
    for count in [0u16, 1, 2, 3, 4, 65535] {
        file.put(count.to_le_bytes());
    }
    file.0
}

pub fn samples() -> Vec<Sample> {
    vec![Sample { name: "map", bytes: map(0.125) }]
}

#[test]
fn counts_are_heights() {
    let [scan] = heights(&map(0.125)).try_into().unwrap();
    let heights_m = [0.0, 1.0, 2.0, 3.0, 4.0, 65535.0].map(|count| Some(count * 0.125e-6));
    assert_holds(&scan.scan, (1.5e-6, Some(0.5e-6)), &heights_m, 1e-17);
    assert_eq!((scan.probe, scan.free_text.as_str()), (Some(Probe::Microscope), "etch"));
}

#[test]
fn damage_is_told() {
    refused!(
        refusal(&map(0.0)),
        BadField { field: "the height of a count", value: "0", place: scans::FilePlace::Byte(105) }
    );
    refused!(refusal(&map(1.0)[..220]), Truncated { needed: 12, available: 11 });
    refused!(refusal(&map(1.0)[..40]), Truncated { needed: 4, available: 0 });
}
