//! Image scans of JPK Instruments.

use scans::{IGNORED, LengthUnit, Measure, Probe, ScanAxis, ScanFile, ScanOptions, read_scans};

use super::tiff_file::{Tag, tiff};
use super::{Sample, assert_holds, channels, heights};

/// The page with the tags of the scan as a whole.
fn first(size_m: [f64; 2]) -> Vec<Tag> {
    vec![
        Tag::long(256, 1),
        Tag::text(0x8003, "2026-01-02 03:04:05"),
        Tag::text(0x8005, "PEG on mica"),
        Tag::text(0x8010, "tip radius 10 nm"),
        Tag::double(0x8042, size_m[0]),
        Tag::double(0x8043, size_m[1]),
        Tag::text(0x8052, "height"),
    ]
}

/// A page of 3 x 2 counts in two strips, with a slot of volts and one that is used.
fn page(name: &str, unit: &str, scaling: &str, is_retrace: bool, strips: [(u32, u32); 2]) -> Vec<Tag> {
    vec![
        Tag::long(256, 3),
        Tag::long(257, 2),
        Tag::short(258, 16),
        Tag::short(259, 1),
        Tag::short(262, 1),
        Tag::longs(273, &strips.map(|(offset, _)| offset)),
        Tag::short(277, 1),
        Tag::short(278, 1),
        Tag::longs(279, &strips.map(|(_, length)| length)),
        Tag::short(339, 2),
        Tag::short(0x8045, u16::from(is_retrace)),
        Tag::text(0x8050, "height"),
        Tag::short(0x8051, u16::from(is_retrace)),
        Tag::text(0x8052, name),
        Tag::long(0x8080, 2),
        Tag::text(0x8081, "absolute"),
        Tag::text(0x8090, "volts"),
        Tag::text(0x8090 + 0x12, "V"),
        Tag::text(0x80c0, "absolute"),
        Tag::text(0x80c0 + 0x12, unit),
        Tag::text(0x80c0 + 0x13, scaling),
        Tag::double(0x80c0 + 0x14, -2e-9),
        Tag::double(0x80c0 + 0x15, 1e-9),
    ]
}

/// The counts of every page stand at the end of the file, the second row first.
fn scan(scaling: &str) -> Vec<u8> {
    let build = |strips| {
        tiff(&[
            first([3e-6, 1e-6]),
            page("Height (measured)", "m", scaling, false, strips),
            page("Vertical Deflection", "m", "LinearScaling", false, strips),
            page("Height", "m", "LinearScaling", true, strips),
            page("Phase", "deg", "LinearScaling", true, strips),
        ])
    };
    let end = build([(0, 0); 2]).len() as u32;
    let mut bytes = build([(end + 6, 6), (end, 6)]);
    bytes.extend([4i16, 5, -6, 1, 2, 3].map(i16::to_le_bytes).concat());
    bytes
}

pub fn samples() -> Vec<Sample> {
    vec![Sample { name: "four channels", bytes: scan("LinearScaling") }]
}

#[test]
fn channels_are_scaled_by_their_default_slot() {
    let all: Vec<_> = channels(&scan("LinearScaling"), true).into_iter().map(Result::unwrap).collect();
    let size = (3e-6, Some(1e-6));
    assert_holds(&all[0].scan, size, &[-7e-9, -9e-9, 13e-9, -1e-9, -3e-9, -5e-9].map(Some), 1e-22);
    assert_holds(&all[2].scan, size, &[-1e-9, -3e-9, -5e-9, -7e-9, -9e-9, 13e-9].map(Some), 1e-22);
    let names: Vec<_> = all.iter().map(|file| file.channel.as_deref().unwrap()).collect();
    let expected =
        ["Height (measured) (Trace)", "Vertical Deflection (Trace)", "Height (Retrace)", "Phase (Retrace)"];
    assert_eq!(names, expected);
    let measures: Vec<_> = all.iter().map(|file| file.measure.clone()).collect();
    let phase = Measure::Other("deg".to_owned());
    assert_eq!(measures, [Measure::Height, Measure::Length, Measure::Height, phase]);
    assert_eq!((all[0].probe, all[0].fast_axis), (Some(Probe::Tip), Some(ScanAxis::X)));
    assert_eq!(all[0].free_text, "PEG on mica\ntip radius 10 nm\n");
}

#[test]
fn pictures_with_calibrations_are_no_channels() {
    let picture = |strips| page("Height", "m", "LinearScaling", false, strips);
    let marked = |tag: Tag| {
        let build = |strips| {
            let grid = [Tag::long(0x8046, 3), Tag::long(0x8047, 2)];
            let first = [first([3e-6, 1e-6]), grid.into()].concat();
            let height = page("Height", "m", "LinearScaling", true, strips);
            let mut thumbnail = picture(strips);
            thumbnail.retain(|other| other.number != tag.number);
            tiff(&[first, [vec![tag.clone()], thumbnail].concat(), height])
        };
        let end = build([(0, 0); 2]).len() as u32;
        let mut bytes = build([(end + 6, 6), (end, 6)]);
        bytes.extend([4i16, 5, -6, 1, 2, 3].map(i16::to_le_bytes).concat());
        heights(&bytes).into_iter().filter_map(|file| file.channel).collect::<Vec<_>>()
    };
    for tag in [Tag::long(254, 1), Tag::text(0x8050, "thumbnail"), Tag::long(256, 1), Tag::long(257, 1)] {
        assert_eq!(marked(tag), ["Height (Retrace)"]);
    }
    assert_eq!(marked(Tag::long(254, 0)), ["Height (Trace)", "Height (Retrace)"]);
}

#[test]
fn a_unit_is_noted_since_the_file_has_its_own() {
    let read = |fallback_unit| {
        let options = ScanOptions { fallback_unit, ..ScanOptions::default() };
        read_scans(&scan("LinearScaling"), "scan", &options).unwrap().remove(0)
    };
    let is_noted =
        |file: &ScanFile| file.notes.iter().any(|note| note.starts_with(IGNORED) && note.contains("unit nm"));
    let nanometre = read("nm".parse::<LengthUnit>().ok());
    assert!(is_noted(&nanometre) && !is_noted(&read(None)), "{:?}", nanometre.notes);
    assert_eq!(nanometre.scan, read(None).scan);
}

#[test]
fn what_cannot_be_read_is_told() {
    let odd = scan("QuadraticScaling");
    let error = channels(&odd, true).remove(0).unwrap_err();
    refused!(error, Unsupported { found: "a channel with the scaling 'QuadraticScaling'" });
    // The other direction is read instead.
    let read = read_scans(&odd, "scan", &ScanOptions::default()).unwrap();
    assert_eq!(read[0].channel.as_deref(), Some("Height (Retrace)"));
    let empty = tiff(&[
        first([1e-6, 1e-6]),
        page("Height", "m", "LinearScaling", false, [(0, 0); 2])
            .into_iter()
            .chain([Tag::long(256, 0)])
            .rev()
            .collect(),
    ]);
    let error = channels(&empty, true).remove(0).unwrap_err();
    refused!(error, BadField { field: "the size of the image", value: "0 x 2 points" });
    let mut cut = scan("LinearScaling");
    cut.truncate(cut.len() - 8);
    let error = channels(&cut, true).remove(0).unwrap_err();
    refused!(error, Truncated { needed: 6, available: 0 });
    assert_eq!(heights(&scan("LinearScaling")).len(), 2);
}
