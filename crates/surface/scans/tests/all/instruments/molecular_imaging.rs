//! Files of Molecular Imaging and Agilent.

use scans::{Measure, Probe, ScanAxis, ScanOptions, read_scans};

use super::{Sample, assert_holds, channels};

/// Two channels of 3 x 2 points, heights and a signal.
fn header(data: &str) -> String {
    let lines = [
        ("fileType", "Image"),
        ("version", "PicoView 0x10c04"),
        ("comment", "tip 10 nm"),
        ("xNonlinearity2", "1.0"),
        ("xPixels", "3"),
        ("yPixels", "2"),
        ("xLength", "3.0e-006"),
        ("yLength", "1.0e-006"),
        ("  more", "bufferLabel"),
        ("bufferLabel", "Topography"),
        ("bufferRange", "3.2768e+000"),
        ("bufferUnit", "um"),
        ("trace", "Trace"),
        ("bufferLabel", "Deflection"),
        ("bufferRange", "3.2768e+000"),
        ("bufferUnit", "V"),
        ("data", data),
    ];
    lines.iter().map(|(key, value)| format!("{key:14}{value}\n")).collect()
}

const COUNTS: [i16; 12] = [1, 2, 3, 4, 5, -6, 7, 8, 9, 10, 11, 12];

fn binary() -> Vec<u8> {
    let numbers = COUNTS.iter().flat_map(|count| count.to_le_bytes());
    header("BINARY").bytes().chain(numbers).collect()
}

/// Counts 65536 times as large.
fn binary_32() -> Vec<u8> {
    let numbers = COUNTS.iter().flat_map(|count| (i32::from(*count) << 16).to_le_bytes());
    header("BINARY_32").bytes().chain(numbers).collect()
}

fn ascii() -> Vec<u8> {
    let numbers: Vec<String> = COUNTS.iter().map(i16::to_string).collect();
    (header("ASCII") + &numbers.join(" \n")).into_bytes()
}

pub fn samples() -> Vec<Sample> {
    vec![
        Sample { name: "16 bits", bytes: binary() },
        Sample { name: "32 bits", bytes: binary_32() },
        Sample { name: "text", bytes: ascii() },
    ]
}

#[test]
fn every_way_to_write_numbers_is_read() {
    let nm = |counts: [i16; 6]| counts.map(|count| Some(f64::from(count) * 1e-10));
    let from_bottom = nm([4, 5, -6, 1, 2, 3]);
    let old = [header("").into_bytes(), binary()[header("BINARY").len()..].to_vec()].concat();
    for (bytes, expected) in [
        (binary(), from_bottom),
        (old, from_bottom),
        (binary_32(), from_bottom),
        (ascii(), nm([1, 2, 3, 4, 5, -6])),
    ] {
        let all: Vec<_> = channels(&bytes, true).into_iter().map(Result::unwrap).collect();
        assert_holds(&all[0].scan, (3e-6, Some(1e-6)), &expected, 1e-24);
        assert_eq!(
            (all[0].channel.as_deref(), &all[0].measure),
            (Some("Topography (Trace)"), &Measure::Height)
        );
        assert_eq!(
            (all[1].channel.as_deref(), &all[1].measure),
            (Some("Deflection"), &Measure::Other("V".to_owned()))
        );
        assert_eq!((all[0].probe, all[0].fast_axis), (Some(Probe::Tip), Some(ScanAxis::X)));
        assert_eq!(all[0].free_text, "tip 10 nm");
    }
}

#[test]
fn what_is_damaged_is_refused() {
    let message = |text: &str, data: &[u8]| {
        let bytes = [text.as_bytes(), data].concat();
        read_scans(&bytes, "scan", &ScanOptions::default()).unwrap_err()
    };
    refused!(
        message(&header("ASCII"), b"1 2 3 x 5 6"),
        BadField { field: "'number 4 of channel 1'", value: "'x'" }
    );
    refused!(message(&header("ASCII"), b"1 2 3"), BadField { field: "'channel 1'", value: "'3 numbers'" });
    refused!(message(&header("BINARY"), b"1 2 3"), Truncated { needed: 12, available: 5 });
    refused!(message(&header("PACKED"), b""), BadField { field: "'data'", value: "'PACKED'" });
    refused!(
        message(&header("BINARY").replace("xPixels       3", "xPixels       0"), b""),
        BadField { field: "'xPixels'", value: "'0'" }
    );
    refused!(
        message(&header("BINARY").replace("Image", "Spectroscopy"), b""),
        Unsupported { found: "a file of type 'Spectroscopy'" }
    );
    refused!(
        message(&header("BINARY").replace("bufferRange", "bufferLimit"), &[0; 24]),
        MissingField { field: "'bufferRange' in the header" }
    );
    refused!(message("fileType      Image\n", b""), MissingField { field: "line 'data' before it" });
    let flat = header("BINARY").replace("3.0e-006", "0.0e+000");
    refused!(message(&flat, &[0; 24]), NoSize { what: "how large the map is" });
}
