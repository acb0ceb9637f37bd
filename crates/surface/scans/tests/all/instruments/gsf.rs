//! Gwyddion Simple Field.

use super::{Sample, assert_holds, channels, refusal};
use scans::{Measure, ScanOptions, ScanSize, read_scans};

/// A field of 3 x 2 points behind these lines.
fn gsf(lines: &str) -> Vec<u8> {
    let mut bytes = format!("Gwyddion Simple Field 1.0\n{lines}").into_bytes();
    bytes.push(0);
    bytes.resize(bytes.len().next_multiple_of(4), 0);
    bytes.extend([1f32, 2.0, 3.0, 4.0, f32::NAN, 6.0].map(f32::to_le_bytes).concat());
    bytes
}

const WHOLE: &str =
    "XRes = 3\nYRes=2\nXReal = 6\nYReal = 4e0\nXYUnits = um\nZUnits = nm\nTitle = Topo\nComment = a tip\n";

pub fn samples() -> Vec<Sample> {
    vec![Sample { name: "map", bytes: gsf(WHOLE) }]
}

#[test]
fn fields_have_their_units_and_begin_at_the_top() {
    // Lines of any length, so that one to four zero bytes stand before the numbers.
    for padding in ["", "A=1\n", "A=12\n", "A=123\n"] {
        let file = channels(&gsf(&format!("{WHOLE}{padding}")), true).remove(0).unwrap();
        let expected = [Some(1e-9), Some(2e-9), Some(3e-9), Some(4e-9), None, Some(6e-9)];
        assert_holds(&file.scan, (6e-6, Some(4e-6)), &expected, 1e-22);
        assert_eq!((file.channel.as_deref(), file.free_text.as_str()), (Some("Topo"), "a tip"));
    }
    // Ampere, not angstrom.
    let current = channels(&gsf(&WHOLE.replace("= nm", "= A")), true).remove(0).unwrap();
    assert_eq!(current.measure, Measure::Other("A".to_owned()));
}

#[test]
fn what_a_field_lacks_is_asked_for() {
    let bare = gsf("XRes = 3\nYRes = 2\n");
    refused!(refusal(&bare), NoUnit { what: scans::Unitless::Heights });
    let options = |size| ScanOptions { unit: "nm".parse().ok(), size, ..ScanOptions::default() };
    refused!(read_scans(&bare, "scan", &options(None)).unwrap_err(), NoSize { what: "how large the map is" });
    let size = Some(ScanSize { x_m: 3e-6, y_m: Some(2e-6) });
    assert_eq!(read_scans(&bare, "scan", &options(size)).unwrap()[0].scan.size_m(), (3e-6, Some(2e-6)));
}

#[test]
fn damage_is_told() {
    refused!(refusal(&gsf("YRes = 2\n")), MissingField { field: "XRes" });
    refused!(refusal(&gsf("XRes = 3\nYRes = 0\n")), BadField { value: "'0'" });
    refused!(refusal(&gsf(&WHOLE.replace("= 6", "= -6"))), BadField { value: "'-6'" });
    let whole = gsf(WHOLE);
    refused!(refusal(&whole[..whole.len() - 1]), Truncated { needed: 24, available: 23 });
    refused!(
        refusal(b"Gwyddion Simple Field 1.0\nXRes = 3"),
        MissingField { field: "zero byte behind the header" }
    );
}
