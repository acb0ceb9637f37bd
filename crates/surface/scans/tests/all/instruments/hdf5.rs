//! HDF5 files of the oldest kind: a superblock of version 0, links and datasets in object headers of version 1.

use crate::instruments::bytes::Bytes;
use crate::instruments::{Sample, assert_holds, channels};
use scans::{Probe, ScanFile, ScanOptions, ScanSize, Unitless, read_scans};

/// A message of an object header.
fn message(kind: u16, content: &[u8]) -> Vec<u8> {
    let mut message = Bytes::default();
    let size = content.len().next_multiple_of(8);
    message
        .put(kind.to_le_bytes())
        .put((size as u16).to_le_bytes())
        .zeros(4)
        .put(content)
        .zeros(size - content.len());
    message.0
}

fn header(messages: &[Vec<u8>]) -> Vec<u8> {
    let content = messages.concat();
    let mut header = Bytes::default();
    header.put([1, 0]).put((messages.len() as u16).to_le_bytes()).put(1u32.to_le_bytes());
    header.put((content.len() as u32).to_le_bytes()).zeros(4).put(content);
    header.0
}

fn dataspace(lengths: &[u64]) -> Vec<u8> {
    let mut space = vec![1, lengths.len() as u8, 0, 0, 0, 0, 0, 0];
    lengths.iter().for_each(|length| space.extend(length.to_le_bytes()));
    space
}

const DOUBLE: [u8; 20] = [0x11, 0x20, 0x3f, 0, 8, 0, 0, 0, 0, 0, 64, 0, 52, 11, 0, 52, 0xff, 3, 0, 0];

fn text_type(bytes: usize) -> Vec<u8> {
    [&[0x13, 0, 0, 0][..], &(bytes as u32).to_le_bytes()].concat()
}

fn attribute(name: &str, kind: &[u8], space: &[u8], value: &[u8]) -> Vec<u8> {
    let padded = |bytes: &[u8]| {
        let mut padded = bytes.to_vec();
        padded.resize(bytes.len().next_multiple_of(8), 0);
        padded
    };
    let name = format!("{name}\0");
    let mut attribute = vec![1, 0];
    for size in [name.len(), kind.len(), space.len()] {
        attribute.extend((size as u16).to_le_bytes());
    }
    message(0x0c, &[attribute, padded(name.as_bytes()), padded(kind), padded(space), value.to_vec()].concat())
}

fn number(name: &str, value: f64) -> Vec<u8> {
    attribute(name, &DOUBLE, &dataspace(&[]), &value.to_le_bytes())
}

fn text(name: &str, value: &str) -> Vec<u8> {
    attribute(name, &text_type(value.len()), &dataspace(&[]), value.as_bytes())
}

/// A category, a unit and parameters, as texts and numbers of fixed length.
fn converter(name: &str, unit: &str, length_m: f64) -> Vec<u8> {
    let field = |name: &str, offset: u32, kind: &[u8]| {
        let mut name = name.as_bytes().to_vec();
        name.resize((name.len() + 1).next_multiple_of(8), 0);
        [name, offset.to_le_bytes().to_vec(), vec![0; 28], kind.to_vec()].concat()
    };
    // An array of three doubles, in the second version of its type.
    let array =
        [&[0x2a, 0, 0, 0][..], &24u32.to_le_bytes(), &[1, 0, 0, 0], &3u32.to_le_bytes(), &[0; 4], &DOUBLE]
            .concat();
    let kind = [
        vec![0x16, 3, 0, 0],
        56u32.to_le_bytes().to_vec(),
        field("Category", 0, &text_type(16)),
        field("BaseUnit", 16, &text_type(16)),
        field("Parameters", 32, &array),
    ];
    let mut value = Bytes::default();
    value.text("LateralCat", 16).text(unit, 16);
    for parameter in [0.0, length_m, 0.0] {
        value.put(f64::to_le_bytes(parameter));
    }
    attribute(name, &kind.concat(), &dataspace(&[1]), &value.0)
}

struct Part {
    /// Names of the groups it lies in, then its own.
    path: &'static [&'static str],
    lengths: &'static [u64],
    values: Vec<f64>,
    attributes: Vec<Vec<u8>>,
}

/// A file; parts that share a group follow each other.
fn file(parts: &[Part]) -> Vec<u8> {
    file_with(parts, &[])
}

/// A file with attributes of groups.
fn file_with(parts: &[Part], groups: &[(&[&str], Vec<Vec<u8>>)]) -> Vec<u8> {
    let mut file = Bytes::default();
    file.put(b"\x89HDF\r\n\x1a\n")
        .put([0, 0, 0, 0, 0, 8, 8, 0])
        .put(4u16.to_le_bytes())
        .put(16u16.to_le_bytes())
        .zeros(4);
    // The base, no free space, the end of the file, no driver, and the entry of the root, filled in below.
    file.put(0u64.to_le_bytes()).put([0xff; 8]).zeros(8).put([0xff; 8]).zeros(40);
    let mut children: Vec<(&[&str], u64)> = Vec::new();
    for part in parts {
        let data = file.0.len() as u64;
        part.values.iter().for_each(|value| {
            file.put(value.to_le_bytes());
        });
        let layout =
            [vec![3, 1], data.to_le_bytes().to_vec(), (8 * part.values.len() as u64).to_le_bytes().to_vec()];
        let messages = [
            vec![message(1, &dataspace(part.lengths)), message(3, &DOUBLE), message(8, &layout.concat())],
            part.attributes.clone(),
        ];
        children.push((part.path, file.0.len() as u64));
        file.put(header(&messages.concat()));
    }
    // Groups from the deepest up, each a header of links to what lies in it.
    while children.iter().any(|(path, _)| !path.is_empty()) {
        let deepest = children.iter().map(|(path, _)| path.len()).max().unwrap();
        let parent = children
            .iter()
            .find(|(path, _)| path.len() == deepest)
            .map(|(path, _)| &path[..deepest - 1])
            .unwrap();
        let (inside, others): (Vec<_>, Vec<_>) =
            children.into_iter().partition(|(path, _)| path.len() == deepest && path.starts_with(parent));
        let links = inside.iter().map(|(path, address)| {
            let name = path[deepest - 1];
            message(6, &[&[1, 0, name.len() as u8][..], name.as_bytes(), &address.to_le_bytes()].concat())
        });
        children = others;
        children.push((parent, file.0.len() as u64));
        let own = groups.iter().filter(|(path, _)| *path == parent).flat_map(|(_, own)| own.clone());
        file.put(header(&links.chain(own).collect::<Vec<_>>()));
    }
    let (end, root) = (file.0.len() as u64, children[0].1);
    file.0[40..48].copy_from_slice(&end.to_le_bytes());
    file.0[64..72].copy_from_slice(&root.to_le_bytes());
    file.0
}

const MAP: [f64; 6] = [1.0, 2.0, 3.0, 4.0, f64::NAN, 6.0];

fn plain() -> Vec<u8> {
    let part = |path, lengths, values: &[f64]| Part {
        path,
        lengths,
        values: values.to_vec(),
        attributes: Vec::new(),
    };
    file(&[
        part(&["line"], &[2], &[0.0, 1.0]),
        part(&["scans", "first"], &[2, 3], &MAP),
        part(&["scans", "second"], &[2, 3], &[7.0; 6]),
    ])
}

fn datx(unit: &str) -> Vec<u8> {
    let mut values = MAP.to_vec();
    values[4] = f64::MAX;
    let attributes = vec![
        text("Unit", "NanoMeters"),
        number("No Data", f64::MAX),
        converter("X Converter", unit, 1e-6),
        converter("Y Converter", unit, 2e-6),
    ];
    file(&[Part { path: &["Data", "Surface", "{1}"], lengths: &[2, 3], values, attributes }])
}

/// x is the slow axis: 2 points along x, 3 along y.
fn netcdf4(is_uneven: bool) -> Vec<u8> {
    let axis = |name: &'static [&'static str], lengths, values: &[f64], length: f64| Part {
        path: name,
        lengths,
        values: values.to_vec(),
        attributes: vec![text("unit", "um"), number("length", length), number("periodic", 1.0)],
    };
    let heights = |lengths, values: &[f64]| Part {
        path: &["heights"],
        lengths,
        values: values.to_vec(),
        attributes: vec![text("unit", "nm"), number("_FillValue", 4.0)],
    };
    if is_uneven {
        let n = Part { path: &["n"], lengths: &[3], values: vec![0.0; 3], attributes: Vec::new() };
        return file(&[heights(&[3], &[1.0, 2.0, 3.0]), n, axis(&["x"], &[3], &[0.0, 1.0, 4.0], 4.0)]);
    }
    let mask = Part {
        path: &["mask"],
        lengths: &[2, 3],
        values: vec![0.0, 1.0, 0.0, 0.0, 0.0, 0.0],
        attributes: Vec::new(),
    };
    let x = axis(&["x"], &[2], &[0.0, 1.0], 2.0);
    file(&[heights(&[2, 3], &MAP), mask, x, axis(&["y"], &[3], &[0.0, 2.0, 4.0], 6.0)])
}

/// Two frames of 3 x 2 counts as columns, with a thumbnail beside them.
fn jpk(is_reflected: bool) -> Vec<u8> {
    let scan = [
        number("position-pattern.grid.ilength", 3.0),
        number("position-pattern.grid.jlength", 2.0),
        number("position-pattern.grid.ulength", 6e-8),
        number("position-pattern.grid.vlength", 4e-8),
        text("position-pattern.grid.reflect", if is_reflected { "true" } else { "false" }),
    ];
    let channel = [
        text("channel.name", "height"),
        text("channel.fancy-name", "Height"),
        text("retrace", "true"),
        text("net-encoder.scaling.type", "linear"),
        text("net-encoder.scaling.unit.unit", "m"),
        number("net-encoder.scaling.multiplier", -1e-9),
        number("net-encoder.scaling.offset", 5e-9),
    ];
    let part =
        |path, lengths, values: &[f64]| Part { path, lengths, values: values.to_vec(), attributes: vec![] };
    let counts = [1.0, 10.0, 2.0, 20.0, 3.0, 30.0, 4.0, 40.0, 5.0, 50.0, 6.0, 60.0];
    let parts = [
        part(&["Measurement_000", "Channel_001", "Height"], &[6, 2], &counts),
        part(&["Measurement_000", "Channel_001", "thumbnail"], &[4, 1], &[0.0; 4]),
        part(&["Measurement_000", "Position_Values"], &[6, 2], &counts),
    ];
    let groups: [(&[&str], _); 2] =
        [(&["Measurement_000"], scan.to_vec()), (&["Measurement_000", "Channel_001"], channel.to_vec())];
    file_with(&parts, &groups)
}

pub fn samples() -> Vec<Sample> {
    let sample = |name, bytes| Sample { name, bytes };
    vec![
        sample("plain", plain()),
        sample("zygo", datx("Pixels")),
        sample("netcdf4", netcdf4(false)),
        sample("jpk", jpk(false)),
    ]
}

fn read(bytes: &[u8]) -> ScanFile {
    read_scans(bytes, "scan", &ScanOptions::default()).unwrap().remove(0)
}

#[test]
fn any_map_is_a_channel() {
    let options = ScanOptions {
        unit: "nm".parse().ok(),
        size: Some(ScanSize { x_m: 3e-6, y_m: Some(2e-6) }),
        ..ScanOptions::default()
    };
    let file = read_scans(&plain(), "scan", &options).unwrap().remove(0);
    let expected = MAP.map(|height| height.is_finite().then_some(height * 1e-9));
    assert_holds(&file.scan, (3e-6, Some(2e-6)), &expected, 1e-22);
    assert_eq!((file.channel.as_deref(), file.channels.len()), (Some("scans/first"), 2));
    assert_eq!(file.notes, ["the first index of the dataset is taken to count the rows of the map"]);
    refused!(
        read_scans(&plain(), "scan", &ScanOptions::default()).unwrap_err(),
        NoUnit { what: Unitless::Heights }
    );
}

#[test]
fn files_of_zygo_tell_unit_size_and_missing_points() {
    let found: Vec<_> = channels(&datx("Pixels"), true).into_iter().map(Result::unwrap).collect();
    assert_eq!((found.len(), found[0].probe), (1, Some(Probe::Microscope)));
    let expected = MAP.map(|height| height.is_finite().then_some(height * 1e-9));
    assert_holds(&found[0].scan, (3e-6, Some(4e-6)), &expected, 1e-22);
    let refused = read_scans(&datx("Volts"), "scan", &ScanOptions::default()).unwrap_err();
    refused!(refused, BadField { field: "'X Converter'", value: "in 'Volts'" });
}

#[test]
fn fast_scans_of_jpk_have_a_channel_a_frame() {
    let all: Vec<_> = channels(&jpk(false), true).into_iter().map(Result::unwrap).collect();
    let names: Vec<_> = all.iter().map(|file| file.channel.as_deref().unwrap()).collect();
    assert_eq!(names, ["Height (Retrace frame 1)", "Height (Retrace frame 2)"]);
    let size = (6e-8, Some(4e-8));
    assert_holds(&all[0].scan, size, &[1e-9, 0.0, -1e-9, 4e-9, 3e-9, 2e-9].map(Some), 1e-22);
    assert_holds(&all[1].scan, size, &[-35e-9, -45e-9, -55e-9, -5e-9, -15e-9, -25e-9].map(Some), 1e-22);
    assert_eq!(all[0].probe, Some(Probe::Tip));
    assert_holds(&read(&jpk(true)).scan, size, &[4e-9, 3e-9, 2e-9, 1e-9, 0.0, -1e-9].map(Some), 1e-22);
}

#[test]
fn netcdf4_is_read_as_netcdf3_is() {
    let map = read(&netcdf4(false));
    let expected = [Some(1e-9), None, None, None, Some(3e-9), Some(6e-9)];
    assert_holds(&map.scan, (2e-6, Some(6e-6)), &expected, 1e-22);
    assert!(map.is_periodic && map.notes.is_empty());
    let line = read(&netcdf4(true));
    assert_eq!(line.scan.positions_m().unwrap(), [0.0, 1e-6, 4e-6]);
}

#[test]
fn bounds_and_damage_are_told() {
    let bounded =
        ScanOptions { max_unpacked_bytes: Some(40), unit: "nm".parse().ok(), ..ScanOptions::default() };
    let refused = read_scans(&plain(), "scan", &bounded).unwrap_err();
    refused!(refused, ArchiveTooLarge { what: "'scans/first'", bound: 40 });
    let cut = read_scans(&plain()[..100], "scan", &ScanOptions::default()).unwrap_err();
    refused!(cut, Syntax { file: "HDF5" });
}
