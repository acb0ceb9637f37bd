//! Digital Surf: maps, profiles and series of 16 and 32 bits, plain and packed.

use std::io::Write;

use crate::instruments::refusal;
use scans::Probe;

use crate::instruments::bytes::Bytes;
use crate::instruments::{Sample, assert_holds, channels, heights};

/// Fields of a header that differ between samples.
#[derive(Clone)]
struct Object {
    format: u16,
    objects: u16,
    kind: u16,
    acquisition: u16,
    special: u16,
    lowest: i32,
    columns: u32,
    rows: u32,
    spacings: [f32; 2],
    scale: f32,
    axis: &'static str,
    units: [&'static [u8]; 3],
    inversion: u16,
    zero: f32,
    comment: &'static str,
    is_packed: bool,
    /// Counts of 16 or 32 bits.
    counts: Counts,
}

#[derive(Clone)]
enum Counts {
    I16(Vec<i16>),
    I32(Vec<i32>),
}

/// 3 x 2 points every 2 µm by 3 µm, of 0.5 nm a count about 1 µm.
fn map() -> Object {
    Object {
        format: 0,
        objects: 1,
        kind: 2,
        acquisition: 9,
        special: 1,
        lowest: -4,
        columns: 3,
        rows: 2,
        spacings: [2.0, 3.0],
        scale: 0.5,
        axis: "Height",
        units: [b"\xb5m", b"um", b"nm"],
        inversion: 0,
        zero: 1000.0,
        comment: "polished",
        is_packed: false,
        counts: Counts::I16(vec![-4, 2, 4, -6, 8, 10]),
    }
}

impl Object {
    fn bytes(&self) -> Vec<u8> {
        let is_big = self.format == 257;
        let u16_ = |value: u16| if is_big { value.to_be_bytes() } else { value.to_le_bytes() };
        let u32_ = |value: u32| if is_big { value.to_be_bytes() } else { value.to_le_bytes() };
        let f32_ = |value: f32| u32_(value.to_bits());
        let counts: Vec<u8> = match &self.counts {
            Counts::I16(counts) => counts.iter().flat_map(|&count| u16_(count as u16)).collect(),
            Counts::I32(counts) => counts.iter().flat_map(|&count| u32_(count as u32)).collect(),
        };
        let bits = if matches!(self.counts, Counts::I16(_)) { 16 } else { 32 };
        let data = if self.is_packed { packed(&counts) } else { counts };
        let mut file = Bytes::default();
        file.put(if self.is_packed { b"DSCOMPRESSED" } else { b"DIGITAL SURF" });
        for field in [self.format, self.objects, 1, self.kind] {
            file.put(u16_(field));
        }
        file.text("surface", 30).text("operator", 30);
        for field in [1, self.acquisition, 0, self.special, 1] {
            file.put(u16_(field));
        }
        file.zeros(8).put(u16_(bits)).put(u32_(self.lowest as u32)).put(u32_(10));
        file.put(u32_(self.columns)).put(u32_(self.rows)).put(u32_(self.columns * self.rows));
        file.put(f32_(self.spacings[0])).put(f32_(self.spacings[1])).put(f32_(self.scale));
        for text in ["X", "Y", self.axis] {
            file.text(text, 16);
        }
        for unit in self.units.iter().chain(&self.units) {
            file.put(unit).put(vec![b' '; 16 - unit.len()]);
        }
        file.put(f32_(1.0)).put(f32_(1.0)).put(f32_(1.0));
        file.put(u16_(0)).put(u16_(self.inversion)).put(u16_(0)).pad_to(324);
        file.put(u32_(data.len() as u32)).zeros(6);
        file.put(u16_(self.comment.len() as u16)).put(u16_(5)).pad_to(474);
        file.put(f32_(self.zero)).pad_to(512).put(self.comment).put("PRIVA").put(data);
        file.0
    }
}

/// Two streams, the first of which takes a third of the bytes.
fn packed(counts: &[u8]) -> Vec<u8> {
    let (first, second) = counts.split_at(counts.len() / 3);
    let deflated = |bytes: &[u8]| {
        let mut encoder = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
        encoder.write_all(bytes).unwrap();
        encoder.finish().unwrap()
    };
    let streams = [first, second].map(|raw| (raw.len(), deflated(raw)));
    let mut file = Bytes::default();
    file.put(2u32.to_le_bytes());
    for (length, stream) in &streams {
        file.put((*length as u32).to_le_bytes()).put((stream.len() as u32).to_le_bytes());
    }
    streams.iter().for_each(|(_, stream)| {
        file.put(stream);
    });
    file.0
}

fn profile() -> Object {
    Object {
        kind: 1,
        acquisition: 1,
        special: 0,
        columns: 4,
        rows: 1,
        spacings: [0.25, 0.0],
        scale: 1e-3,
        axis: "Z",
        units: [b"mm", b"", b"\xe6m"],
        zero: 0.0,
        counts: Counts::I32(vec![-100_000, 0, 100_000, 2]),
        ..map()
    }
}

/// Two surfaces, of which only the first says that it is one of a series.
fn series() -> Vec<u8> {
    let first = Object { kind: 5, objects: 2, ..map() };
    let second = Object { counts: Counts::I16(vec![0; 6]), comment: "", is_packed: true, ..map() };
    [first.bytes(), second.bytes()].concat()
}

pub fn samples() -> Vec<Sample> {
    let sample = |name, bytes| Sample { name, bytes };
    vec![
        sample("map", map().bytes()),
        sample("profile", profile().bytes()),
        sample("packed", Object { is_packed: true, ..map() }.bytes()),
        sample("series", series()),
        sample("macintosh", Object { format: 257, ..map() }.bytes()),
        sample("mirrored", Object { inversion: 2, ..map() }.bytes()),
    ]
}

const SIZE_M: (f64, Option<f64>) = (6e-6, Some(6e-6));

/// Heights of the map in nm.
const HEIGHTS_NM: [Option<f64>; 6] =
    [Some(998.0), Some(1001.0), Some(1002.0), None, Some(1004.0), Some(1005.0)];

fn in_m(heights_nm: &[Option<f64>]) -> Vec<Option<f64>> {
    heights_nm.iter().map(|height| height.map(|nm| nm * 1e-9)).collect()
}

#[test]
fn maps_are_read_plain_packed_and_of_either_byte_order() {
    for object in [map(), Object { is_packed: true, ..map() }, Object { format: 257, ..map() }] {
        let [file] = heights(&object.bytes()).try_into().unwrap();
        assert_holds(&file.scan, SIZE_M, &in_m(&HEIGHTS_NM), 1e-18);
        assert_eq!(file.channel.as_deref(), Some("Height"));
        assert_eq!(file.probe, Some(Probe::Microscope));
        assert_eq!(file.free_text, "polished");
        assert!(file.notes.is_empty(), "{:?}", file.notes);
    }
}

#[test]
fn profiles_are_lines_of_their_units() {
    let [file] = heights(&profile().bytes()).try_into().unwrap();
    let heights_m = [-1e-4, 0.0, 1e-4, 2e-9].map(Some);
    assert_holds(&file.scan, (1e-3, None), &heights_m, 1e-11);
    assert_eq!(file.probe, Some(Probe::Tip));
}

#[test]
fn every_surface_of_a_series_is_a_channel() {
    let [first, second] = heights(&series()).try_into().unwrap();
    assert_holds(&first.scan, SIZE_M, &in_m(&HEIGHTS_NM), 1e-18);
    assert_holds(&second.scan, SIZE_M, &[Some(1e-6); 6], 1e-18);
    assert_eq!((first.channel.as_deref(), second.channel.as_deref()), (Some("Height 1"), Some("Height 2")));
    let [cut] = heights(&Object { kind: 5, objects: 2, ..map() }.bytes()).try_into().unwrap();
    assert_eq!(cut.notes, ["the file announces 2 objects, but holds 1"]);
}

#[test]
fn inverted_heights_are_turned_back() {
    let turned = |order: [usize; 6]| order.map(|from| in_m(&HEIGHTS_NM)[from].map(|height| -height));
    for (inversion, order) in [(1, [0, 1, 2, 3, 4, 5]), (2, [2, 1, 0, 5, 4, 3]), (3, [3, 4, 5, 0, 1, 2])] {
        let [file] = heights(&Object { inversion, ..map() }.bytes()).try_into().unwrap();
        assert_holds(&file.scan, SIZE_M, &turned(order), 1e-18);
        assert_eq!(file.notes, ["the file marks its heights as inverted; they are turned back"]);
    }
}

#[test]
fn what_is_no_length_is_no_height() {
    let image = Object { units: [b"um", b"um", b"V"], axis: "Intensity", ..map() }.bytes();
    assert!(heights(&image).is_empty());
    let [file] = channels(&image, true).try_into().unwrap();
    assert_eq!(file.unwrap().measure.to_string(), "V");
    let grey = Object { kind: 10, ..map() }.bytes();
    assert!(heights(&grey).is_empty());
}

#[test]
fn without_a_spacing_the_size_is_asked_for() {
    let bytes = Object { spacings: [0.0, 1.0], ..map() }.bytes();
    refused!(refusal(&bytes), NoSize { what: "how large the map is" });
}

#[test]
fn damage_is_told() {
    refused!(
        refusal(&Object { kind: 20, ..map() }.bytes()),
        Unsupported { found: "a spectrum", place: scans::FilePlace::Byte(18) }
    );
    let mut bits = map().bytes();
    bits[98] = 24;
    refused!(refusal(&bits), BadField { field: "the bits of a point", value: "24" });
    let cut = map().bytes();
    refused!(refusal(&cut[..cut.len() - 1]), Truncated { needed: 12, available: 11, offset: 525 });
    let mut packed = Object { is_packed: true, ..map() }.bytes();
    packed[549] ^= 0xff;
    refused!(refusal(&packed), BadField { field: "the packed data", value: "corrupt deflate stream" });
    let mut long = Object { is_packed: true, ..map() }.bytes();
    long[529] = 200;
    refused!(refusal(&long), BadField { field: "the length of a stream", value: "200" });
    let mut huge = Object { is_packed: true, ..map() }.bytes();
    huge[108..116].fill(0x7f);
    refused!(
        refusal(&huge),
        ArchiveTooLarge { what: "the 2139062143 x 2139062143 points", bound: 1073741824 }
    );
}
