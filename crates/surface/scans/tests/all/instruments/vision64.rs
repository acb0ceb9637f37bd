//! Vision64: profiles and maps in a tree of typed values.

use crate::instruments::refusal;
use scans::Probe;

use crate::instruments::bytes::Bytes;
use crate::instruments::{Sample, assert_holds, channels, heights};

/// A name behind its length.
fn name(text: &str) -> Vec<u8> {
    [&(text.len() as u32).to_le_bytes(), text.as_bytes()].concat()
}

/// Content behind its length, of as few bytes as hold it.
fn counted(content: &[u8]) -> Vec<u8> {
    let length = match content.len() {
        length @ 0..0x100 => vec![1, length as u8],
        length @ 0x100..0x1_0000 => [&[2][..], &(length as u16).to_le_bytes()].concat(),
        length => [&[4][..], &(length as u32).to_le_bytes()].concat(),
    };
    [length, content.to_vec()].concat()
}

fn item(own: &str, kind: u8, content: Vec<u8>) -> Vec<u8> {
    [name(own), vec![kind], content].concat()
}

fn text(own: &str, value: &str) -> Vec<u8> {
    item(own, 0x12, counted(value.as_bytes()))
}

fn quantity(own: &str, value: f64, unit: &str) -> Vec<u8> {
    let content = [value.to_le_bytes().to_vec(), name("Unit"), name(unit), vec![0; 12]].concat();
    item(own, 0x13, counted(&content))
}

fn u32_item(own: &str, value: u32) -> Vec<u8> {
    item(own, 0x07, value.to_le_bytes().to_vec())
}

/// A group ends with a value without a name and two bytes of no known meaning.
fn group(own: &str, kind: u8, items: &[Vec<u8>]) -> Vec<u8> {
    item(own, kind, counted(&[items.concat(), item("", 0x7f, vec![0xff, 0xff])].concat()))
}

fn file(items: &[Vec<u8>]) -> Vec<u8> {
    let mut file = Bytes::default();
    file.put(b"VCA DATA\x01\x00\x00\x55").put(items.concat()).put(item("", 0x7f, vec![0xff, 0xff]));
    file.0
}

/// Points of a line of 1.5 µm from the first to the last, in steps of 2 nm.
fn profile_data(count: u32) -> Vec<u8> {
    let numbers: Vec<u8> = [1f64, -2.0, f64::NAN, 4.5].iter().flat_map(|v| v.to_le_bytes()).collect();
    let array = [name("Array<double>"), counted(&[vec![0x0d, 4, 0, 0, 0], numbers].concat())].concat();
    let raw = group(
        "Raw",
        0x46,
        &[
            text("DataKind", "Height"),
            item("ValueTypeID", 0x0e, [name("ID"), counted(&[0x0d, 0, 0, 0])].concat()),
            quantity("Extent", 1.5, "\u{b5}m"),
            u32_item("NumPoints", count),
            quantity("DataScale", 2.0, "nm"),
            item("Array", 0x40, array),
        ],
    );
    group("1D_Data", 0x7d, &[raw])
}

fn stylus() -> Vec<u8> {
    let settings = group(
        "MeasurementSettings",
        0x7d,
        &[text("InstrumentType", "Stylus Profiler"), text("StylusType", "Radius: 2 \u{3bc}m")],
    );
    let time = item("TimeStamp", 0x15, vec![1; 9]);
    group("MetaData", 0x7d, &[settings, time, text("Notes", "worn side")])
}

fn profile() -> Vec<u8> {
    file(&[profile_data(4), stylus()])
}

/// A map with its kind, unit of heights and numbers row after row.
fn map_data(own: &str, kind: &str, unit: &str, rows: &[[f32; 3]], is_named: bool) -> Vec<u8> {
    let points: Vec<u8> = rows.iter().flatten().flat_map(|point| point.to_le_bytes()).collect();
    let size = [(rows.len() as u32).to_le_bytes(), 3u32.to_le_bytes()].concat();
    let matrix = counted(&[size, points].concat());
    let (number, matrix) = match is_named {
        true => (0x00, [name("Matrix"), vec![0; 4], name("float"), matrix].concat()),
        false => (0x45, [name("Matrix<float>"), matrix].concat()),
    };
    group(
        own,
        0x47,
        &[
            text("DataKind", kind),
            quantity("Dimension1Extent", 2.0 * (rows.len() - 1) as f64, "\u{b5}m"),
            quantity("Dimension2Extent", 1e-3, "mm"),
            quantity("DataScale", 0.5, unit),
            item("Matrix", number, matrix),
        ],
    )
}

const ROWS: [[f32; 3]; 2] = [[1.0, 2.0, 3.0], [4.0, f32::NAN, 6.0]];

fn maps() -> Vec<u8> {
    let data = group(
        "2D_Data",
        0x7d,
        &[
            map_data("Image", "Intensity", "", &ROWS, false),
            map_data("Levelled", "Height", "nm", &[[0.0; 3]; 2], false),
            map_data("Raw", "Height", "nm", &ROWS, true),
        ],
    );
    let settings = group("MeasurementSettings", 0x7d, &[text("MeasMode", "VSI")]);
    file(&[data, group("MetaData", 0x7d, &[text("PrimaryData2D", "Raw"), settings])])
}

pub fn samples() -> Vec<Sample> {
    vec![Sample { name: "profile", bytes: profile() }, Sample { name: "maps", bytes: maps() }]
}

#[test]
fn profiles_of_a_stylus_tell_its_radius() {
    let [scan] = heights(&profile()).try_into().unwrap();
    let heights_m = [Some(2e-9), Some(-4e-9), None, Some(9e-9)];
    assert_holds(&scan.scan, (2e-6, None), &heights_m, 1e-22);
    assert_eq!((scan.channel.as_deref(), scan.probe), (Some("Height"), Some(Probe::Tip)));
    assert_eq!((scan.tip_radius_m, scan.free_text.as_str()), (Some(2e-6), "worn side"));
}

#[test]
fn the_primary_map_comes_first_and_names_are_told_apart() {
    let [raw, levelled] = heights(&maps()).try_into().unwrap();
    let heights_m = [0.5, 1.0, 1.5, 2.0, 0.0, 3.0].map(|nm| Some(nm * 1e-9).filter(|_| nm != 0.0));
    assert_holds(&raw.scan, (1.5e-6, Some(4e-6)), &heights_m, 1e-22);
    assert_holds(&levelled.scan, (1.5e-6, Some(4e-6)), &[Some(0.0); 6], 1e-22);
    assert_eq!(raw.channels, ["Height (Raw)", "Height (Levelled)"]);
    assert_eq!(raw.probe, Some(Probe::Microscope));
    assert_eq!(channels(&maps(), true).len(), 3);
}

#[test]
fn damage_is_told() {
    refused!(refusal(&file(&[profile_data(5)])), BadField { field: "'/1D_Data/Raw/NumPoints'", value: "5" });
    let unknown = file(&[item("What", 0x33, vec![])]);
    refused!(
        refusal(&unknown),
        BadField { field: "the type of a value", value: "0x33", place: scans::FilePlace::Byte(20) }
    );
    let cut = profile();
    refused!(refusal(&cut[..100]), Truncated { needed: 255, available: 74 });
    let deep = (0..40).fold(Vec::new(), |inner, _| item("a", 0x7d, counted(&inner)));
    refused!(refusal(&file(&[deep])), BadField { field: "the depth of nested values", value: "33" });
    let short = map_data("Raw", "Height", "nm", &ROWS, false);
    let mut short = file(&[group("2D_Data", 0x7d, &[short])]);
    let rows = short.windows(8).position(|part| part == [2, 0, 0, 0, 3, 0, 0, 0]).unwrap();
    short[rows] = 3;
    refused!(refusal(&short), BadField { field: "the length of '/2D_Data/Raw/Matrix'", value: "24" });
}
