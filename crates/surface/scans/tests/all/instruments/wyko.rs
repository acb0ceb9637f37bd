//! Wyko: arrays of floating-point numbers, counts and bytes behind a directory.

use crate::instruments::refusal;
use scans::Probe;

use crate::instruments::bytes::Bytes;
use crate::instruments::{Sample, assert_holds, channels, heights};

/// Name, type and content of a block.
type Block = (&'static str, u16, Vec<u8>);

const ARRAY: u16 = 3;
const TEXT: u16 = 5;
const SHORT: u16 = 6;
const FLOAT: u16 = 7;

fn float(value: f32) -> Vec<u8> {
    value.to_le_bytes().to_vec()
}

fn array(columns: u16, rows: u16, point_bytes: u16, points: Vec<u8>) -> Vec<u8> {
    let mut block = Bytes::default();
    [columns, rows, point_bytes].iter().for_each(|field| {
        block.put(field.to_le_bytes());
    });
    block.put(points);
    block.0
}

/// Two columns of three rows, each from the bottom; one point is bad.
fn raw() -> Block {
    let points = [1f32, 2.0, 3.0, 4.0, 1e38, 6.0];
    ("Raw", ARRAY, array(2, 3, 4, points.iter().flat_map(|point| point.to_le_bytes()).collect()))
}

fn map() -> Vec<Block> {
    vec![
        ("Title", TEXT, b"lapped steel\0\0".to_vec()),
        ("Wavelength", FLOAT, float(500.0)),
        ("Aspect", FLOAT, float(2.0)),
        ("Pixel_size", FLOAT, float(0.25)),
        raw(),
        ("Image", ARRAY, array(2, 3, 1, vec![1, 2, 3, 4, 5, 6])),
    ]
}

/// Counts of two bytes, of a quarter of a wavelength each.
fn counts() -> Vec<Block> {
    let points = [-4i16, 8, 32766, 32767];
    let mut blocks = map();
    blocks.truncate(4);
    blocks.push(("Mult", SHORT, 4i16.to_le_bytes().to_vec()));
    blocks.push(("RAW_DATA", ARRAY, array(2, 2, 2, points.iter().flat_map(|p| p.to_le_bytes()).collect())));
    blocks
}

fn file(blocks: &[Block]) -> Vec<u8> {
    let mut file = Bytes::default();
    let mut entry = |name: &str, kind: u16, length: usize, flags: u16| {
        file.text(name, 16).put(kind.to_le_bytes()).put((length as u32).to_le_bytes());
        file.put(flags.to_le_bytes());
    };
    entry("Directory", 1, 24 * (blocks.len() + 2), 0xffff);
    blocks.iter().for_each(|(name, kind, content)| entry(name, *kind, content.len(), 8));
    entry("", 0, 0, 0);
    let mut whole = Bytes(vec![1, 0]);
    whole.put(file.0);
    blocks.iter().for_each(|(_, _, content)| {
        whole.put(content);
    });
    whole.0
}

fn without(name: &str) -> Vec<u8> {
    file(&map().into_iter().filter(|(own, ..)| *own != name).collect::<Vec<_>>())
}

pub fn samples() -> Vec<Sample> {
    vec![
        Sample { name: "map", bytes: file(&map()) },
        Sample { name: "counts", bytes: file(&counts()) },
        Sample { name: "without a size", bytes: without("Pixel_size") },
    ]
}

#[test]
fn columns_are_stored_from_the_bottom_in_wavelengths() {
    let [scan] = heights(&file(&map())).try_into().unwrap();
    let heights_m = [Some(1.5e-6), Some(3e-6), Some(1e-6), None, Some(0.5e-6), Some(2e-6)];
    assert_holds(&scan.scan, (0.5e-3, Some(1.5e-3)), &heights_m, 1e-18);
    assert_eq!((scan.channel.as_deref(), scan.probe), (Some("Raw"), Some(Probe::Microscope)));
    assert_eq!(scan.free_text, "lapped steel");
}

#[test]
fn counts_are_scaled_by_the_factor() {
    let [scan] = heights(&file(&counts())).try_into().unwrap();
    let heights_m = [Some(1e-6), None, Some(-0.5e-6), None];
    assert_holds(&scan.scan, (0.5e-3, Some(1e-3)), &heights_m, 1e-18);
}

#[test]
fn intensities_are_no_heights() {
    let [_, image] = channels(&file(&map()), true).try_into().unwrap();
    let image = image.unwrap();
    assert_eq!(
        (image.channel.as_deref(), image.measure.to_string()),
        (Some("Image"), "no length".to_owned())
    );
    let values: Vec<_> = image.scan.heights_m().map(Option::unwrap).collect();
    assert_eq!(values, [3.0, 6.0, 2.0, 5.0, 1.0, 4.0]);
}

#[test]
fn what_is_missing_is_told() {
    refused!(
        refusal(&without("Wavelength")),
        MissingField { field: "block 'Wavelength', which scales the heights" }
    );
    refused!(refusal(&without("Pixel_size")), NoSize { what: "how large the map is" });
    refused!(refusal(&without("Raw")), NoHeightChannel { channels: ["Image"] });
}

#[test]
fn damage_is_told() {
    let mut directory = file(&map());
    directory[20] += 1;
    refused!(
        refusal(&directory),
        BadField { field: "the length of the directory", value: "193", place: scans::FilePlace::Byte(20) }
    );
    let mut blocks = map();
    blocks.truncate(5);
    let cut = file(&blocks);
    refused!(refusal(&cut[..cut.len() - 3]), Truncated { needed: 24, available: 21 });
    blocks[4].2[4] = 8;
    refused!(refusal(&file(&blocks)), BadField { field: "the number of bytes of a point", value: "8" });
}
