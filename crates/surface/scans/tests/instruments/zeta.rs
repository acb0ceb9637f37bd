//! Zeta: counts behind a header and a comment.

use scans::{Probe, ScanOptions, read_scans};

use crate::bytes::Bytes;
use crate::{Sample, assert_holds, heights};

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
    assert_eq!(
        refusal(&map(0.0)),
        "reading Zeta, byte 105: the height of a count is 0, it must be a number above 0; the file is damaged or of a \
         variant that is not known: export it again"
    );
    assert!(refusal(&map(1.0)[..220]).contains("takes 12 bytes, but the file ends 11 bytes on"));
    assert!(refusal(&map(1.0)[..40]).contains("the number of columns takes 4 bytes"));
}

fn refusal(bytes: &[u8]) -> String {
    read_scans(bytes, "scan", &ScanOptions::default()).unwrap_err().to_string()
}
