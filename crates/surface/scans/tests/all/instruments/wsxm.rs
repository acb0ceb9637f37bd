//! Images of WSxM.

use scans::{Measure, Probe, ScanAxis, ScanOptions, read_scans};

use super::{Sample, assert_holds, channels, heights};

fn header(data_type: &str) -> String {
    format!(
        "WSxM file copyright UAM\r\nSxM Image file\r\nImage header size: 10\r\n\r\n[Control]\r\n\r\n    X Amplitude: 300 nm\r\n    \
         Y Amplitude: 0.5 \u{b5}m\r\n    Z Gain: 3\r\n\r\n[General Info]\r\n\r\n    Acquisition channel: Topography\r\n\
         \x20   Image Data Type: {data_type}\r\n    Number of columns: 3\r\n    Number of rows: 2\r\n    Z Amplitude: 8 \u{c5}\r\n\r\n\
         [Miscellaneous]\r\n\r\n    Comments: tip: new\r\n\r\n[Header end]\r\n"
    )
}

fn file(header: &str, numbers: &[u8]) -> Vec<u8> {
    let mut bytes: Vec<u8> = header.chars().map(|letter| u8::try_from(u32::from(letter)).unwrap()).collect();
    bytes.extend(numbers);
    bytes
}

const COUNTS: [i16; 6] = [-2, 0, 2, 4, 6, 14];

fn short() -> Vec<u8> {
    file(&header("short"), &COUNTS.map(i16::to_le_bytes).concat())
}

fn double(values: [f64; 6]) -> Vec<u8> {
    file(&header("double"), &values.map(f64::to_le_bytes).concat())
}

fn float() -> Vec<u8> {
    file(&header("float"), &[1.0f32, 2.0, 3.0, 4.0, 5.0, 6.0].map(f32::to_le_bytes).concat())
}

pub fn samples() -> Vec<Sample> {
    vec![
        Sample { name: "short", bytes: short() },
        Sample { name: "float", bytes: float() },
        Sample { name: "double", bytes: double([1.0, 2.0, f64::NAN, 4.0, 5.0, 6.0]) },
    ]
}

const SIZE: (f64, Option<f64>) = (300e-9, Some(0.5e-6));

#[test]
fn counts_spread_over_the_amplitude() {
    let found = &heights(&short())[0];
    // 16 counts are 8 Å; the last point comes first.
    assert_holds(&found.scan, SIZE, &[7e-10, 3e-10, 2e-10, 1e-10, 0.0, -1e-10].map(Some), 1e-22);
    assert_eq!((found.channel.as_deref(), found.free_text.as_str()), (Some("Topography"), "tip: new"));
    assert_eq!((found.probe, found.fast_axis), (Some(Probe::Tip), Some(ScanAxis::X)));
    let flat = file(&header("short"), &[7, 0].repeat(6));
    assert_holds(&heights(&flat)[0].scan, SIZE, &[Some(0.0); 6], 0.0);
}

#[test]
fn other_numbers_have_the_unit_of_the_amplitude() {
    let expected = [6e-10, 5e-10, 4e-10, 3e-10, 2e-10, 1e-10].map(Some);
    assert_holds(&heights(&float())[0].scan, SIZE, &expected, 1e-22);
    let found = heights(&double([1.0, 2.0, f64::NAN, 4.0, 5.0, 6.0]));
    let expected = [Some(6e-10), Some(5e-10), Some(4e-10), None, Some(2e-10), Some(1e-10)];
    assert_holds(&found[0].scan, SIZE, &expected, 1e-22);
}

#[test]
fn other_channels_are_told_and_a_size_alone_makes_a_square() {
    let volts = file(&header("short").replace("8 \u{c5}", "2 V"), &[0; 12]);
    assert_eq!(channels(&volts, true)[0].as_ref().unwrap().measure, Measure::Other("V".to_owned()));
    let square = file(&header("short").replace("Y Amplitude", "Why"), &[0; 12]);
    let found = &heights(&square)[0];
    assert_eq!(found.scan.size_m(), (300e-9, Some(300e-9)));
    assert_eq!(found.notes, ["the file does not give the size along y: the scan is taken to be square"]);
}

#[test]
fn what_is_damaged_is_refused() {
    let message =
        |text: &str| read_scans(&file(text, &[0; 12]), "scan", &ScanOptions::default()).unwrap_err();
    let changed = |from: &str, to: &str| message(&header("short").replace(from, to));
    refused!(
        changed("SxM Image file", "FZ curve file"),
        Unsupported { found: "a file of kind 'FZ curve file'", place: scans::FilePlace::Line(2) }
    );
    refused!(changed("8 \u{c5}", "eight"), BadField { field: "'Z Amplitude'", value: "'eight'" });
    refused!(changed("short", "long"), BadField { field: "'Image Data Type'", value: "'long'" });
    refused!(changed("rows: 2", "rows: 3"), Truncated { needed: 18, available: 12 });
    refused!(
        changed("[Header end]", ""),
        MissingField { field: "'[Header end]' before it, which ends the header" }
    );
    refused!(changed("X Amplitude", "Ex"), NoSize { what: "how large the map is" });
}
