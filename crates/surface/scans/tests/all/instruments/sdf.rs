//! Surface data files in text and binary, with every type of number.

use scans::ScanReadError;

use crate::instruments::bytes::Bytes;
use crate::instruments::refusal;
use crate::instruments::{Sample, assert_holds, heights};

/// A binary file of 3 x 2 points with spacings of 1 and 2 µm.
fn binary(version: &str, data_type: u8, check_type: u8, extra: &[u8], data: &[u8]) -> Vec<u8> {
    let mut file = Bytes::default();
    file.put(version).text("maker", 10).put("010120240000").put("010120240000");
    match version {
        "bISO-2.0" => file.put(3u32.to_le_bytes()).put(2u32.to_le_bytes()),
        _ => file.put(3u16.to_le_bytes()).put(2u16.to_le_bytes()),
    };
    for scale in [1e-6f64, 2e-6, 1e-9, -1.0] {
        file.put(scale.to_le_bytes());
    }
    file.put([0, data_type, check_type]).put(extra).put(data);
    file.0
}

fn numbers<const N: usize>(to_bytes: impl Fn(f64) -> [u8; N], missing: [u8; N]) -> Vec<u8> {
    let mut bytes: Vec<[u8; N]> = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0].map(to_bytes).to_vec();
    bytes[4] = missing;
    bytes.concat()
}

const TEXT: &str = "aISO-1.0\r\nManufacID = maker\r\n; a remark\r\nCreateDate = 040120100853\r\nModDate = 040120100853\r\nNumPoints = \
                    3\r\nNumProfiles = 2\r\nXscale = 1.0E-6\r\nYscale = 2.0E-6\r\nZscale = 1.0E-9\r\nZresolution = \
                    -1\r\nCompression = 0\r\nDataType = 7\r\nCheckType = 0\r\n*\r\n1.0 2 3\r\n4 BAD 6\r\n*\r\n< Comment > on \
                    glass < /Comment >\r\n*\r\n";

pub fn samples() -> Vec<Sample> {
    let sample = |name, bytes| Sample { name, bytes };
    let doubles = numbers(f64::to_le_bytes, f64::NAN.to_le_bytes());
    vec![
        sample("text", TEXT.into()),
        sample("binary", binary("bISO-1.0", 7, 0, &[], &doubles)),
        sample(
            "wide",
            binary("bISO-2.0", 5, 0, &[], &numbers(|v| (v as i16).to_le_bytes(), i16::MIN.to_le_bytes())),
        ),
    ]
}

const HEIGHTS: [Option<f64>; 6] = [Some(1e-9), Some(2e-9), Some(3e-9), Some(4e-9), None, Some(6e-9)];

#[test]
fn text_is_read() {
    let file = &heights(TEXT.as_bytes())[0];
    assert_holds(&file.scan, (3e-6, Some(4e-6)), &HEIGHTS, 1e-22);
    assert_eq!((file.free_text.as_str(), file.notes.len()), ("< Comment > on glass < /Comment >", 0));
    let older = TEXT
        .replace("aISO-1.0", "aBCR-1.0")
        .replace("\r\n*\r\n< Comment > on glass < /Comment >\r\n*\r\n", "\n");
    assert_holds(&heights(older.as_bytes())[0].scan, (3e-6, Some(4e-6)), &HEIGHTS, 1e-22);
}

#[test]
fn a_text_cut_off_within_its_last_number_is_refused() {
    let cut = TEXT.find(" BAD 6").unwrap() + " BAD 6".len();
    let error = refusal(&TEXT.as_bytes()[..cut]);
    assert!(matches!(error, ScanReadError::BadField { field, .. } if field == "the last height"));
}

#[test]
fn binary_numbers_of_every_type_are_read() {
    for (version, data_type, data) in [
        ("bBCR-1.0", 1, numbers(|v| (v as u16).to_le_bytes(), u16::MAX.to_le_bytes())),
        ("bBCR-1.0", 2, numbers(|v| (v as u32).to_le_bytes(), u32::MAX.to_le_bytes())),
        ("bISO-1.0", 3, numbers(|v| (v as f32).to_le_bytes(), f32::NAN.to_le_bytes())),
        ("bISO-2.0", 3, numbers(|v| (v as f32).to_le_bytes(), f32::MIN.to_le_bytes())),
        ("bISO-2.0", 4, numbers(|v| (v as i8).to_le_bytes(), i8::MIN.to_le_bytes())),
        ("bISO-1.0", 5, numbers(|v| (v as i16).to_le_bytes(), i16::MIN.to_le_bytes())),
        ("bISO-1.0", 6, numbers(|v| (v as i32).to_le_bytes(), i32::MIN.to_le_bytes())),
        ("bISO-1.0", 7, numbers(f64::to_le_bytes, f64::MIN.to_le_bytes())),
    ] {
        for trailer in [&b""[..], b"a trailer"] {
            let file = &heights(&binary(version, data_type, 0, &[], &[&data, trailer].concat()))[0];
            assert_holds(&file.scan, (3e-6, Some(4e-6)), &HEIGHTS, 1e-22);
            assert_eq!(file.free_text.as_bytes(), trailer);
        }
    }
    // Bytes have no mark for missing points.
    let bytes = binary("bISO-1.0", 0, 0, &[], &[1, 2, 3, 4, 255, 0]);
    assert_eq!(heights(&bytes)[0].scan.heights_m().nth(4), Some(Some(255e-9)));
    // Some exports have eight bytes more in their header.
    let data = numbers(|v| (v as i16).to_le_bytes(), i16::MIN.to_le_bytes());
    let longer = binary("bISO-1.0", 5, 0, &[5, 0, 0, 0, 1, 0, 0, 0], &data);
    assert_holds(&heights(&longer)[0].scan, (3e-6, Some(4e-6)), &HEIGHTS, 1e-22);
}

#[test]
fn a_line_and_a_check_sum() {
    let line = TEXT.replace("NumProfiles = 2", "NumProfiles = 1").replace("NumPoints = 3", "NumPoints = 6");
    let line = line.replace("Yscale = 2.0E-6", "Yscale = 0").replace("CheckType = 0", "CheckType = 1");
    let file = &heights(line.as_bytes())[0];
    assert_holds(&file.scan, (6e-6, None), &HEIGHTS, 1e-22);
    assert_eq!(file.notes, ["the check sum of the file, of type 1, is not verified"]);
}

#[test]
fn damage_is_told() {
    let text = |from: &str, to: &str| refusal(TEXT.replace(from, to).as_bytes());
    refused!(
        text("4 BAD 6", "4 BAD"),
        BadField { field: "the number of heights", value: "5", place: scans::FilePlace::Line(15) }
    );
    refused!(
        text("4 BAD 6", "4 BAD x"),
        BadField { field: "a height", value: "x", place: scans::FilePlace::Line(17) }
    );
    refused!(text("NumPoints", "Points"), MissingField { field: "line 'NumPoints' in the header" });
    refused!(text("DataType = 7", "DataType = 9"), BadField { field: "DataType", value: "9" });
    refused!(text("Compression = 0", "Compression = 1"), Unsupported { found: "compression 1" });
    refused!(text("Xscale = 1.0E-6", "Xscale = 0"), Scan(BadSpacing { what: "spacing along x", value: 0.0 }));
    let short = binary("bISO-1.0", 7, 0, &[], &[0; 47]);
    refused!(refusal(&short), Truncated { needed: 48, available: 47 });
}
