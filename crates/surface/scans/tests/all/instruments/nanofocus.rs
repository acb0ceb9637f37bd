//! NanoFocus files, which have no name of their own.

use crate::instruments::bytes::Bytes;
use crate::instruments::{Sample, assert_holds, heights};
use scans::{Probe, ScanFormat, ScanOptions, read_scans};

fn nanofocus(range_um: (f64, f64), spacing_nm: f64, parts: &[u16]) -> Vec<u8> {
    let mut file = Bytes::default();
    file.zeros(16).put(range_um.0.to_le_bytes()).put(range_um.1.to_le_bytes()).pad_to(1368);
    file.put(2u32.to_le_bytes())
        .put(2u32.to_le_bytes())
        .put(spacing_nm.to_le_bytes())
        .put(2000f64.to_le_bytes());
    file.pad_to(3468);
    parts.iter().for_each(|part| {
        file.put(part.to_le_bytes());
    });
    file.0
}

const PARTS: [u16; 4] = [0, 13107, 65535, 52428];

pub fn samples() -> Vec<Sample> {
    vec![Sample { name: "map", bytes: nanofocus((-1.0, 1.0), 1000.0, &PARTS) }]
}

#[test]
fn heights_are_parts_of_a_range() {
    let file = &heights(&samples()[0].bytes)[0];
    assert_holds(&file.scan, (2e-6, Some(4e-6)), &[-1e-6, -0.6e-6, 1e-6, 0.6e-6].map(Some), 1e-20);
    assert_eq!(file.probe, Some(Probe::Microscope));
}

#[test]
fn what_makes_no_sense_is_another_file() {
    for bytes in [
        nanofocus((1.0, -1.0), 1000.0, &PARTS),
        nanofocus((-1.0, f64::NAN), 1000.0, &PARTS),
        nanofocus((-1.0, 1.0), 0.0, &PARTS),
        nanofocus((-1.0, 1.0), 1000.0, &PARTS[1..]),
    ] {
        assert_eq!(ScanFormat::recognise(&bytes), None);
        refused!(
            read_scans(&bytes, "scan", &ScanOptions::default()).unwrap_err(),
            UnknownFormat {
                start: "'\\x00\\x00\\x00\\x00\\x00\\x00\\x00\\x00\\x00\\x00\\x00\\x00\\x00\\x00\\x00\\x00'"
            }
        );
    }
}
