//! MountainsMap: a document of tagged entries in a compound file, its heights in packed blocks.

use std::io::{Cursor, Write};

use crate::instruments::refusal;
use scans::ScanFormat;

use crate::instruments::{Sample, assert_holds, heights};

fn entry(tag: u16, content: &[u8]) -> Vec<u8> {
    [&tag.to_le_bytes()[..], &(content.len() as u64).to_le_bytes(), content].concat()
}

/// An entry of entries.
fn group(tag: u16, entries: &[Vec<u8>]) -> Vec<u8> {
    entry(tag, &entries.concat())
}

fn text(tag: u16, text: &str) -> Vec<u8> {
    let units = text.encode_utf16().flat_map(u16::to_le_bytes);
    entry(tag, &[4].into_iter().chain(units).collect::<Vec<_>>())
}

fn number(tag: u16, number: u32) -> Vec<u8> {
    entry(tag, &number.to_le_bytes())
}

fn class(class: u32) -> Vec<u8> {
    group(1, &[number(1, class)])
}

fn scale(step: f64, unit: &str, shown: &str, origin: f64) -> Vec<u8> {
    let entries =
        [entry(1, &step.to_le_bytes()), text(2, unit), text(3, shown), entry(5, &origin.to_le_bytes())];
    group(0xffff, &entries)
}

fn lateral(tag: u16, spacing: f64, unit: &str, points: u32) -> Vec<u8> {
    group(tag, &[group(0xffff, &[scale(spacing, unit, "mm", 0.0), number(1, points)])])
}

/// Blocks of elements, the last one first.
fn array(bytes: &[u8], element_bytes: usize, block_elements: usize) -> Vec<u8> {
    let mut data = (bytes.len() as u64).to_le_bytes().to_vec();
    let blocks: Vec<_> = bytes.chunks(block_elements * element_bytes).enumerate().collect();
    for (index, block) in blocks.into_iter().rev() {
        let mut packed = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
        packed.write_all(block).unwrap();
        let packed = packed.finish().unwrap();
        data.extend(((index * block_elements) as u64).to_le_bytes());
        data.extend(((block.len() / element_bytes) as u32).to_le_bytes());
        data.extend((packed.len() as u32).to_le_bytes());
        data.extend(packed);
    }
    group(2, &[number(1, (bytes.len() / element_bytes) as u32), entry(2, &data)])
}

/// Parts that differ between documents.
#[derive(Clone)]
struct Document {
    counts: Vec<i32>,
    unit: &'static str,
    columns: u32,
    class: u32,
    has_mask: bool,
}

/// 3 x 2 points every 2 µm by 3 µm, of 0.5 nm a count about 1 µm; the fifth point was not measured.
fn map() -> Document {
    Document { counts: vec![-4, 2, 4, 6, 0, 10], unit: "nm", columns: 3, class: 9012, has_mask: true }
}

impl Document {
    fn bytes(&self) -> Vec<u8> {
        let counts: Vec<u8> = self.counts.iter().flat_map(|count| count.to_le_bytes()).collect();
        let mut marks = [0; 5 * 4];
        [6, 7, 8, 11, 12, 13].iter().for_each(|&at| marks[at] = 9);
        marks[12] = 22;
        let mask = group(2, &[number(1, 3), number(2, 2), group(5, &[class(9048), array(&marks, 1, 7)])]);
        let mut grid = vec![
            group(0xffff, &[group(0xffff, &[text(1, "Topography")])]),
            lateral(1, 2.0, "\u{b5}m", self.columns),
            lateral(2, 3.0, "\u{b5}m", 2),
        ];
        if self.has_mask {
            grid.push(group(3, &[class(9056), mask]));
        }
        let measurement = group(
            0xffff,
            &[
                group(0xffff, &grid),
                group(1, &[class(9049), array(&counts, 4, 4)]),
                group(2, &[scale(0.5, self.unit, "\u{b5}m", 1.0)]),
            ],
        );
        let data = group(1, &[class(9062), group(2, &[measurement])]);
        let body = group(2, &[group(0xffff, &[text(4, "ground steel")]), data]);
        let objects = [
            7u64.to_le_bytes().to_vec(),
            group(1, &[class(1), group(2, &[])]),
            7u64.to_le_bytes().to_vec(),
            group(1, &[class(self.class), body]),
        ];
        let tree = group(1, &[number(0xcb, 0), group(0x2bd, &[group(2, &[group(1, &objects)])])]);
        let stream = [(tree.len() as u64).to_le_bytes().to_vec(), tree].concat();
        compound(&stream)
    }
}

fn compound(stream: &[u8]) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    let mut file = cfb::CompoundFile::create_with_version(cfb::Version::V3, &mut bytes).unwrap();
    file.create_stream("ScopedContents").unwrap().write_all(stream).unwrap();
    file.flush().unwrap();
    drop(file);
    bytes.into_inner()
}

pub fn samples() -> Vec<Sample> {
    vec![
        Sample { name: "map", bytes: map().bytes() },
        Sample { name: "whole", bytes: Document { has_mask: false, ..map() }.bytes() },
    ]
}

#[test]
fn the_measured_surface_is_read_without_what_was_not_measured() {
    let [scan] = heights(&map().bytes()).try_into().unwrap();
    let heights_m =
        [998.0, 1001.0, 1002.0, 1003.0, 0.0, 1005.0].map(|nm| Some(nm * 1e-9).filter(|_| nm != 0.0));
    assert_holds(&scan.scan, (6e-6, Some(6e-6)), &heights_m, 1e-20);
    assert_eq!((scan.channel.as_deref(), scan.free_text.as_str()), (Some("Topography"), "ground steel"));
    let note = "the surface is as it was measured; what the document derives from it is not stored";
    assert_eq!(scan.notes[0], note);
    let [whole] = heights(&Document { has_mask: false, ..map() }.bytes()).try_into().unwrap();
    assert!(whole.scan.missing_points().is_empty());
}

#[test]
fn other_compound_files_are_not_told_to_be_documents() {
    let mut bytes = Cursor::new(Vec::new());
    let mut file = cfb::CompoundFile::create(&mut bytes).unwrap();
    file.create_stream("Workbook").unwrap();
    file.flush().unwrap();
    drop(file);
    assert_eq!(ScanFormat::recognise(&bytes.into_inner()), None);
}

#[test]
fn damage_is_told() {
    refused!(
        refusal(&Document { class: 4, ..map() }.bytes()),
        Unsupported { found: "a document without a measured surface" }
    );
    let fewer = refusal(&Document { columns: 4, ..map() }.bytes());
    refused!(fewer, BadField { field: "the number of elements of an array", value: "6" });
    let current = Document { unit: "V", ..map() }.bytes();
    assert!(heights(&current).is_empty());
    let short = compound(&[0; 4]);
    refused!(refusal(&short), Truncated { needed: 8, available: 4 });
    let empty = compound(&[0; 8]);
    refused!(refusal(&empty), MissingField { field: "entry [1, 2bd, 2, 1] in this part of the document" });
}
