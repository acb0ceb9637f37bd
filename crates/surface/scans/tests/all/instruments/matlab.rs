//! Matrices of MATLAB.

use std::io::Write;

use super::{Sample, assert_holds, refusal};
use scans::{ScanFile, ScanOptions, ScanSize, read_scans};

fn element(kind: u32, content: &[u8]) -> Vec<u8> {
    let mut element = [kind.to_le_bytes(), (content.len() as u32).to_le_bytes()].concat();
    element.extend(content);
    element.resize(element.len().next_multiple_of(8), 0);
    element
}

/// A matrix of this class, with its numbers of this type.
fn matrix(name: &str, class: u32, [rows, columns]: [u32; 2], kind: u32, numbers: &[u8]) -> Vec<u8> {
    let flags = [class.to_le_bytes(), [0; 4]].concat();
    // A name of up to four letters stands within its tag.
    let name = match name.len() {
        1..=4 => {
            let mut small = [1u16.to_le_bytes(), (name.len() as u16).to_le_bytes()].concat();
            small.extend(name.as_bytes());
            small.resize(8, 0);
            small
        }
        _ => element(1, name.as_bytes()),
    };
    let sizes = [rows.to_le_bytes(), columns.to_le_bytes()].concat();
    let content = [element(6, &flags), element(5, &sizes), name, element(kind, numbers)];
    element(14, &content.concat())
}

fn file(elements: &[Vec<u8>]) -> Vec<u8> {
    let mut bytes = format!("{:124}", "MATLAB 5.0 MAT-file, made by a test").into_bytes();
    bytes.extend(b"\x00\x01IM");
    bytes.extend(elements.concat());
    bytes
}

/// Column after column, of two rows.
const MAP: [f64; 6] = [1.0, 4.0, 2.0, f64::NAN, 3.0, 6.0];

fn map(name: &str) -> Vec<u8> {
    matrix(name, 6, [2, 3], 9, &MAP.map(f64::to_le_bytes).concat())
}

fn packed(element: &[u8]) -> Vec<u8> {
    let mut zlib = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::fast());
    zlib.write_all(element).unwrap();
    let packed = zlib.finish().unwrap();
    [15u32.to_le_bytes().to_vec(), (packed.len() as u32).to_le_bytes().to_vec(), packed].concat()
}

/// A structure with a field `z`.
fn structure() -> Vec<u8> {
    let flags = [2u32.to_le_bytes(), [0; 4]].concat();
    let fields = [
        element(6, &flags),
        element(5, &[1u32.to_le_bytes(), 1u32.to_le_bytes()].concat()),
        element(1, b"data of a scan"),
        [5u16.to_le_bytes(), 4u16.to_le_bytes()].concat(),
        8u32.to_le_bytes().to_vec(),
        element(1, b"note\0\0\0\0z\0\0\0\0\0\0\0"),
        matrix("", 4, [1, 2], 4, &[65, 0, 66, 0]),
        map(""),
    ];
    element(14, &fields.concat())
}

pub fn samples() -> Vec<Sample> {
    let small = matrix("counts", 6, [2, 2], 2, &[1, 2, 3, 4]);
    vec![
        Sample { name: "plain", bytes: file(&[map("z"), small]) },
        Sample { name: "packed", bytes: file(&[packed(&map("heights")), structure()]) },
    ]
}

fn read(bytes: &[u8], channel: Option<&str>) -> ScanFile {
    let options = ScanOptions {
        unit: "um".parse().ok(),
        size: Some(ScanSize { x_m: 3e-6, y_m: Some(2e-6) }),
        channel: channel.map(str::to_owned),
        ..ScanOptions::default()
    };
    read_scans(bytes, "scan", &options).unwrap().remove(0)
}

#[test]
fn rows_of_a_matrix_are_those_of_the_map() {
    let expected = [Some(1e-6), Some(2e-6), Some(3e-6), Some(4e-6), None, Some(6e-6)];
    let samples = samples();
    for (sample, channel) in
        [(0, None), (0, Some("z")), (1, None), (1, Some("heights")), (1, Some("data of a scan.z"))]
    {
        let file = read(&samples[sample].bytes, channel);
        assert_holds(&file.scan, (3e-6, Some(2e-6)), &expected, 1e-19);
        assert_eq!(file.notes, ["the rows of the matrix are taken for those of the map"]);
    }
    assert_eq!(read(&samples[1].bytes, None).channels, ["heights", "data of a scan.z"]);
    assert_holds(
        &read(&samples[0].bytes, Some("counts")).scan,
        (3e-6, Some(2e-6)),
        &[1e-6, 3e-6, 2e-6, 4e-6].map(Some),
        1e-19,
    );
    refused!(refusal(&samples[0].bytes), NoUnit { what: scans::Unitless::Heights });
}

#[test]
fn vectors_are_lines_where_there_is_no_map() {
    let line = matrix("profile", 7, [4, 1], 7, &[1f32, 2.0, 3.0, 4.0].map(f32::to_le_bytes).concat());
    assert_eq!(read(&file(std::slice::from_ref(&line)), None).scan.points(), (4, None));
    assert_eq!(read(&file(&[line, map("z")]), None).channels, ["z"]);
    // Truth values and complex numbers are no heights.
    let flagged = |flag: u32| file(&[matrix("flag", 6 | flag, [2, 2], 2, &[1, 2, 3, 4])]);
    refused!(refusal(&flagged(0x200)), NoHeightChannel {});
    refused!(refusal(&flagged(0x800)), NoHeightChannel {});
}

#[test]
fn damage_is_told() {
    let whole = file(&[map("z")]);
    refused!(refusal(&whole[..whole.len() - 8]), Truncated { what: "an element" });
    let options = ScanOptions { max_unpacked_bytes: Some(64), ..ScanOptions::default() };
    let bounded = read_scans(&file(&[packed(&map("z"))]), "scan", &options).unwrap_err();
    refused!(bounded, ArchiveTooLarge { bound: 64 });
    let odd = file(&[matrix("z", 6, [2, 2], 11, &[0; 32])]);
    refused!(refusal(&odd), BadField { field: "the type of the numbers", value: "11" });
}
