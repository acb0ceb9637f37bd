//! TrueMap files, whose writers end their comment in several ways.

use crate::instruments::bytes::Bytes;
use crate::instruments::refusal;
use crate::instruments::{Sample, assert_holds, heights};
use scans::Probe;

fn truemap(title: &str, comment: &[u8]) -> Vec<u8> {
    let mut file = Bytes::default();
    file.text(title, 32).put(comment).put(3u32.to_le_bytes()).put(2u32.to_le_bytes());
    for length in [1.5f32, 0.5, 7.0, 8.0] {
        file.put(length.to_le_bytes());
    }
    for height in [0.25f32, 0.5, 0.75, 1.0, f32::NAN, 1.5] {
        file.put(height.to_le_bytes());
    }
    file.0
}

const TITLE: &str = "Binary TrueMap Data File v2.0\r\n";

pub fn samples() -> Vec<Sample> {
    let sample = |name, bytes| Sample { name, bytes };
    vec![
        sample("commented", truemap(TITLE, b"Created by TrueMap v6\r\n\0")),
        sample("first-version", truemap("TrueMap Data File v1.0", b"")),
    ]
}

#[test]
fn maps_are_read_behind_any_comment() {
    let expected = [Some(0.25e-3), Some(0.5e-3), Some(0.75e-3), Some(1e-3), None, Some(1.5e-3)];
    let padded = [b"padded\0".as_slice(), &[0; 17]].concat();
    let longer = [b"padded to thirty-two\0".as_slice(), &[0; 11]].concat();
    for (comment, text) in [
        (b"Created by TrueMap v6\r\n\0".as_slice(), "Created by TrueMap v6"),
        (b"\0", ""),
        (
            b"a comment of any length at all, as GelSight writes it\0",
            "a comment of any length at all, as GelSight writes it",
        ),
        (&padded, "padded"),
        (&longer, "padded to thirty-two"),
        (b"", ""),
    ] {
        for title in [TITLE, "Binary TrueMap Data File v1.0\r\n", "TrueMap Data File v1.0"] {
            let file = &heights(&truemap(title, comment))[0];
            assert_holds(&file.scan, (1.5e-3, Some(0.5e-3)), &expected, 1e-18);
            assert_eq!((file.free_text.as_str(), file.probe), (text, Some(Probe::Microscope)));
        }
    }
}

#[test]
fn damage_is_told() {
    let bytes = truemap(TITLE, b"comment\0");
    refused!(refusal(&bytes[..bytes.len() - 1]), Truncated { needed: 24, available: 23, offset: 64 });
    refused!(refusal(&bytes[..42]), Truncated { needed: 4, available: 2 });
}
