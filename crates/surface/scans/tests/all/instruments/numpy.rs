//! Arrays of NumPy, with unit and size told by the caller.

use scans::{MeasuredScan, ScanOptions, ScanReadError, ScanSize, Unitless, read_scans};

use crate::instruments::{Sample, assert_holds};
use crate::support::zip_file::zipped;

/// An array with its header padded as NumPy pads it.
pub fn array(version: u8, described: &str, is_fortran: bool, shape: &str, data: &[u8]) -> Vec<u8> {
    let order = if is_fortran { "True" } else { "False" };
    let header = format!("{{'descr': {described}, 'fortran_order': {order}, 'shape': {shape}, }}");
    let header = format!("{header:<117}\n");
    let mut bytes = [b"\x93NUMPY".as_slice(), &[version, 0]].concat();
    match version {
        1 => bytes.extend((header.len() as u16).to_le_bytes()),
        _ => bytes.extend((header.len() as u32).to_le_bytes()),
    }
    [bytes, header.into_bytes(), data.to_vec()].concat()
}

const MAP: [f64; 6] = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];

fn map(described: &str, to_bytes: impl Fn(f64) -> Vec<u8>) -> Vec<u8> {
    array(1, described, false, "(2, 3)", &MAP.into_iter().flat_map(to_bytes).collect::<Vec<_>>())
}

pub fn samples() -> Vec<Sample> {
    let sample = |name, bytes| Sample { name, bytes };
    let map = map("'<f8'", |value| value.to_le_bytes().to_vec());
    let line = array(2, "'>i2'", false, "(3,)", &[0, 1, 0, 2, 0, 3]);
    let half = array(1, "'<f2'", true, "(2, 2)", &[0, 0x3c, 0, 0x40, 0, 0xc0, 0, 0x7e]);
    vec![
        sample("archive", zipped(&[("x.npy", &line), ("z.npy", &map)])),
        sample("half", half),
        sample("line", line),
        sample("map", map),
    ]
}

fn read(bytes: &[u8], channel: Option<&str>) -> Result<MeasuredScan, ScanReadError> {
    let size = ScanSize { x_m: 3e-6, y_m: Some(2e-6) };
    let channel = channel.map(str::to_owned);
    let unit = "nm".parse().ok();
    let options = ScanOptions { unit, size: Some(size), channel, ..ScanOptions::default() };
    read_scans(bytes, "scan", &options).map(|mut scans| scans.remove(0).scan)
}

#[test]
fn numbers_of_every_type_are_read() {
    let expected = MAP.map(|value| Some(value * 1e-9));
    for bytes in [
        map("'|i1'", |value| vec![value as u8]),
        map("'|u1'", |value| vec![value as u8]),
        map("'<i2'", |value| (value as i16).to_le_bytes().to_vec()),
        map("'>u2'", |value| (value as u16).to_be_bytes().to_vec()),
        map("'<i4'", |value| (value as i32).to_le_bytes().to_vec()),
        map("'>u4'", |value| (value as u32).to_be_bytes().to_vec()),
        map("'>i8'", |value| (value as i64).to_be_bytes().to_vec()),
        map("'<u8'", |value| (value as u64).to_le_bytes().to_vec()),
        map("'>f4'", |value| (value as f32).to_be_bytes().to_vec()),
        map("'<f8'", |value| value.to_le_bytes().to_vec()),
    ] {
        assert_holds(&read(&bytes, None).unwrap(), (3e-6, Some(2e-6)), &expected, 1e-22);
    }
}

#[test]
fn columns_first_and_axes_of_one_point() {
    let half = &samples().remove(1).bytes;
    let expected = [Some(1e-9), Some(-2e-9), Some(2e-9), None];
    assert_holds(&read(half, None).unwrap(), (3e-6, Some(2e-6)), &expected, 1e-22);
    let line = array(3, "'|u1'", false, "(1, 3, 1)", &[1, 2, 3]);
    assert_holds(&read(&line, None).unwrap(), (3e-6, None), &[Some(1e-9), Some(2e-9), Some(3e-9)], 1e-22);
}

#[test]
fn every_array_of_an_archive_is_a_channel() {
    let text = array(1, "'<U4'", false, "()", &[0; 16]);
    let map = map("'<f8'", |value| value.to_le_bytes().to_vec());
    let line = array(1, "'|u1'", false, "(3,)", &[7, 8, 9]);
    let archive = zipped(&[("x.npy", &line), ("unit.npy", &text), ("z.npy", &map), ("second.npy", &line)]);
    assert_eq!(read(&archive, None).unwrap().points(), (3, Some(2)));
    assert_eq!(read(&archive, Some("second")).unwrap().points(), (3, None));
}

#[test]
fn what_is_no_line_or_map_is_refused() {
    let message = |bytes: &[u8]| read(bytes, None).unwrap_err();
    refused!(
        message(&array(1, "'<f8'", false, "(2, 2, 2)", &[0; 64])),
        Unsupported { found: "an array of the shape [2, 2, 2]" }
    );
    refused!(
        message(&array(1, "'<c16'", false, "(2,)", &[0; 32])),
        Unsupported { found: "an array of the type '<c16'" }
    );
    refused!(
        message(&array(1, "[('a', '<f8')]", false, "(2,)", &[0; 16])),
        Unsupported { found: "an array of the type 'a structure'" }
    );
    refused!(message(&array(1, "'<f8'", false, "(2, 3)", &[0; 47])), Truncated { needed: 48, available: 47 });
    refused!(
        message(&array(4, "'<f8'", false, "(2, 3)", &[0; 48])),
        BadField { field: "the version", value: "4" }
    );
    let vast = array(1, "'<f8'", false, "(99999999999, 99999999999)", &[]);
    refused!(message(&vast), BadField { field: "the shape", value: "(99999999999, 99999999999)" });
    let unit = read_scans(&array(1, "'|u1'", false, "(3,)", &[1, 2, 3]), "scan", &ScanOptions::default());
    refused!(unit.unwrap_err(), NoUnit { what: Unitless::Heights });
}
