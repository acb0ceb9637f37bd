//! Descriptions of the channels of a file.

use std::collections::BTreeMap;

use crate::nanoscope::{Image, NanoscopeFile};
use measurements::{Channels, ScanRequest, read_channels};
use tables::Cells;

const HEIGHTS_M: [f64; 8] = [0.0, 1e-9, 3e-9, 2e-9, 0.0, 4e-9, 1e-9, 5e-9];

/// Three images of heights, of which those counted here cannot be read.
fn images(damaged: &[usize]) -> Vec<u8> {
    let image = |direction| Image { name: "Height", direction, heights_m: &HEIGHTS_M };
    let images = ["Trace", "Retrace", "Trace"].map(image).into();
    let mut bytes = NanoscopeFile { images, ..NanoscopeFile::new(4, 2, &HEIGHTS_M) }.to_bytes();
    let field = b"\\Bytes/pixel: 2";
    let fields: Vec<usize> = (0..bytes.len()).filter(|&at| bytes[at..].starts_with(field)).collect();
    for image in damaged {
        bytes[fields[*image] + field.len() - 1] = b'3';
    }
    bytes
}

fn found(bytes: Vec<u8>) -> Channels {
    found_in("scan.001", bytes)
}

fn found_in(path: &str, bytes: Vec<u8>) -> Channels {
    let files = BTreeMap::from([(path.to_owned(), bytes)]);
    let request = ScanRequest { path: path.to_owned(), ..ScanRequest::default() };
    let Ok(found) = read_channels::<()>(&[request], &files, false, |_, _| Ok(())) else { panic!("no way") };
    found
}

fn texts(found: &Channels, column: &str) -> Vec<String> {
    match found.table().column(column) {
        Some(Cells::Typed(cells)) => cells.iter().map(|cell| cell.text().into_owned()).collect(),
        _ => panic!("there is no column {column} of texts"),
    }
}

#[test]
fn every_channel_that_cannot_be_read_has_its_row_in_the_order_of_the_file() {
    let told = found(images(&[0, 2]));
    assert!(told.unreadable.is_empty());
    assert_eq!(texts(&told, "channel"), ["", "Height (Retrace)", ""]);
    let notes = texts(&told, "note");
    assert!(notes[0].contains("'Bytes/pixel' is '3', it must be 2 or 4"), "{notes:?}");
    assert!(!notes[1].contains("Bytes/pixel") && notes[2].contains("Bytes/pixel"), "{notes:?}");
    assert_ne!(notes[0], notes[2], "each tells its own place");
}

#[test]
fn a_file_is_unreadable_where_none_of_its_channels_can_be_read() {
    let told = found(images(&[0, 1, 2]));
    assert_eq!((told.table().rows(), told.unreadable.len()), (0, 1));
}

#[test]
fn descriptions_have_a_paragraph_per_channel_and_no_control_characters() {
    let text = found_in("\u{1b}[2J.001", images(&[1])).describe();
    assert!(!text.contains('\u{1b}') && text.matches("[2J.001").count() == 3, "{text}");
    // The second channel cannot be read: a note, and no numbers.
    for (words, count) in
        [(" 4 x 2 points, none missing\n", 2), ("\n  Sa ", 2), (" Sq ", 2), ("Bytes/pixel", 1)]
    {
        assert_eq!(text.matches(words).count(), count, "{words} in {text}");
    }
}
