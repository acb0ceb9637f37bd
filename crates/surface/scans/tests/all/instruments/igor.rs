//! Binary waves of Igor.

use scans::{Measure, Probe, ScanAxis, ScanOptions, Unitless, read_scans};

use super::bytes::Bytes;
use super::{Sample, assert_holds, channels, heights};

/// A wave of version 5.
struct Wave {
    is_big_endian: bool,
    type_code: u16,
    points: [u32; 4],
    steps: [f64; 2],
    units: [&'static str; 3],
    long_unit: &'static str,
    note: &'static str,
    labels: &'static [&'static str],
    /// The dimension that has them.
    labelled: usize,
    /// As the file holds them.
    numbers: Vec<u8>,
}

impl Wave {
    /// Two layers of 3 x 2 points in single precision, as an instrument saves them.
    fn scan() -> Self {
        Self {
            is_big_endian: false,
            type_code: 2,
            points: [3, 2, 2, 0],
            steps: [1e-6, 2e-6],
            units: ["m", "m", "m"],
            long_unit: "",
            note: "ScanSize: 2e-06\rFastScanSize: 2e-06\rImageNote: sharp tip\r",
            labels: &["HeightTrace", "AmplitudeTrace"],
            labelled: 2,
            numbers: (0..12u8).flat_map(|value| f32::from(value).to_le_bytes()).collect(),
        }
    }

    fn bytes(&self) -> Vec<u8> {
        let order =
            |bytes: Vec<u8>| if self.is_big_endian { bytes.into_iter().rev().collect() } else { bytes };
        let short = |value: u16| order(value.to_le_bytes().to_vec());
        let long = |value: usize| order((value as u32).to_le_bytes().to_vec());
        let double = |value: f64| order(value.to_le_bytes().to_vec());
        let labels = if self.labels.is_empty() { 0 } else { 32 * (self.labels.len() + 1) };
        let mut bytes = Bytes::default();
        bytes
            .put(short(5))
            .put(short(0))
            .put(long(320 + self.numbers.len()))
            .put(long(4))
            .put(long(self.note.len()));
        bytes.put(long(self.long_unit.len())).zeros(16);
        (0..4).for_each(|dimension| {
            bytes.put(long(if dimension == self.labelled { labels } else { 0 }));
        });
        bytes.zeros(12);
        let count: u32 = self.points.iter().take_while(|points| **points > 0).product();
        bytes
            .zeros(12)
            .put(long(count as usize))
            .put(short(self.type_code))
            .zeros(10)
            .text("wave0", 32)
            .zeros(8);
        self.points.iter().for_each(|points| {
            bytes.put(long(*points as usize));
        });
        [self.steps[0], self.steps[1], 1.0, 1.0, 5.0, 6.0, 0.0, 0.0].iter().for_each(|value| {
            bytes.put(double(*value));
        });
        let [value, x, y] = self.units;
        bytes.text(value, 4).text(x, 4).text(y, 4).zeros(8).pad_to(64 + 320).put(&self.numbers).put(b"x=1\0");
        bytes.put(self.note).put(self.long_unit);
        if labels > 0 {
            bytes.zeros(32);
            self.labels.iter().for_each(|label| {
                bytes.text(label, 32);
            });
        }
        let mut bytes = bytes.0;
        let sum = checksum(&bytes[..384], self.is_big_endian);
        bytes[2..4].copy_from_slice(&short(sum));
        bytes
    }
}

/// Number that makes the sum of the words 0.
fn checksum(headers: &[u8], is_big_endian: bool) -> u16 {
    let word = |pair: &[u8]| {
        let pair = [pair[0], pair[1]];
        if is_big_endian { u16::from_be_bytes(pair) } else { u16::from_le_bytes(pair) }
    };
    headers.chunks_exact(2).map(word).fold(0u16, u16::wrapping_add).wrapping_neg()
}

/// A line of version 2 in double precision.
fn old() -> Vec<u8> {
    let heights: Vec<u8> = [1.0f64, 3.0, 2.0].iter().flat_map(|value| value.to_be_bytes()).collect();
    let mut bytes = Bytes::default();
    bytes
        .put(2u16.to_be_bytes())
        .put((110 + heights.len() as u32 + 16).to_be_bytes())
        .put(4u32.to_be_bytes())
        .zeros(6);
    bytes.put(4u16.to_be_bytes()).zeros(4).text("line", 20).zeros(8).text("nm", 4).text("um", 4);
    bytes
        .put(3u32.to_be_bytes())
        .zeros(2)
        .put(0.5f64.to_be_bytes())
        .pad_to(16 + 110)
        .put(heights)
        .zeros(16)
        .put(b"mine");
    let mut bytes = bytes.0;
    let sum = checksum(&bytes[..126], true);
    bytes[14..16].copy_from_slice(&sum.to_be_bytes());
    bytes
}

/// An image of 16-bit counts in Å, big-endian, without names.
fn image() -> Wave {
    Wave {
        is_big_endian: true,
        type_code: 0x50,
        points: [2, 2, 0, 0],
        units: ["", "um", "um"],
        long_unit: "angstrom",
        note: "polished",
        labels: &[],
        numbers: [1u16, 2, 3, 60000].iter().flat_map(|value| value.to_be_bytes()).collect(),
        ..Wave::scan()
    }
}

/// Lines side by side.
fn table() -> Wave {
    Wave {
        points: [6, 2, 0, 0],
        labels: &["Left", "Right"],
        labelled: 1,
        note: "",
        units: ["m", "mm", ""],
        steps: [1.0, 1.0],
        ..Wave::scan()
    }
}

pub fn samples() -> Vec<Sample> {
    vec![
        Sample { name: "scan", bytes: Wave::scan().bytes() },
        Sample { name: "image", bytes: image().bytes() },
        Sample { name: "table", bytes: table().bytes() },
        Sample { name: "version 2", bytes: old() },
    ]
}

#[test]
fn channels_of_a_scan_have_their_names_and_units() {
    let all: Vec<_> = channels(&Wave::scan().bytes(), true).into_iter().map(Result::unwrap).collect();
    let expected = [3.0, 4.0, 5.0, 0.0, 1.0, 2.0].map(Some);
    assert_holds(&all[0].scan, (3e-6, Some(4e-6)), &expected, 0.0);
    assert_eq!(all[0].channel.as_deref(), Some("HeightTrace"));
    assert_eq!((all[0].probe, all[0].fast_axis), (Some(Probe::Tip), Some(ScanAxis::X)));
    assert_eq!(all[0].free_text, "ImageNote: sharp tip\n");
    assert_eq!((all[1].channel.as_deref(), &all[1].measure), (Some("AmplitudeTrace"), &Measure::Length));
    assert_eq!(all[0].channels, ["HeightTrace"]);
    assert_eq!(all[1].channels, ["HeightTrace"]);
    let phase = Wave { labels: &["PhaseTrace", "HeightRetrace"], ..Wave::scan() };
    let found = heights(&phase.bytes());
    assert_eq!((found.len(), found[0].channel.as_deref()), (1, Some("HeightRetrace")));
}

#[test]
fn lengths_that_are_no_heights_are_read_with_a_note_where_they_are_asked_for() {
    let options = ScanOptions { channel: Some("AmplitudeTrace".to_owned()), ..ScanOptions::default() };
    let [amplitude] = read_scans(&Wave::scan().bytes(), "scan", &options).unwrap().try_into().unwrap();
    assert_eq!(amplitude.measure, Measure::Length);
    let note = "channel 'AmplitudeTrace' holds lengths that are not heights of the surface: they are read as asked for";
    assert!(amplitude.notes.iter().any(|told| told == note), "{:?}", amplitude.notes);
}

#[test]
fn images_in_the_other_order_of_bytes_are_read() {
    let found = &heights(&image().bytes())[0];
    let expected = [3e-10, 60000e-10, 1e-10, 2e-10].map(Some);
    assert_holds(&found.scan, (2e-12, Some(4e-12)), &expected, 1e-22);
    assert_eq!((found.channel.as_deref(), found.free_text.as_str()), (Some("wave0"), "polished"));
    assert_eq!((found.probe, found.fast_axis), (None, None));
}

#[test]
fn columns_of_a_table_and_waves_of_one_dimension_are_lines() {
    let lines = heights(&table().bytes());
    assert_eq!(
        lines.iter().map(|line| line.channel.as_deref()).collect::<Vec<_>>(),
        [Some("Left"), Some("Right")]
    );
    assert_holds(&lines[1].scan, (6e-3, None), &[6.0, 7.0, 8.0, 9.0, 10.0, 11.0].map(Some), 0.0);
    let line = &heights(&old())[0];
    assert_holds(&line.scan, (1.5e-6, None), &[1e-9, 3e-9, 2e-9].map(Some), 0.0);
    assert_eq!((line.channel.as_deref(), line.free_text.as_str()), (Some("line"), "mine"));
}

#[test]
fn what_holds_no_heights_is_refused() {
    let message = |wave: Wave| read_scans(&wave.bytes(), "scan", &ScanOptions::default()).unwrap_err();
    refused!(
        message(Wave { type_code: 0, ..Wave::scan() }),
        BadField { field: "the type of the numbers", value: "0", place: scans::FilePlace::Byte(80) }
    );
    refused!(
        message(Wave { points: [2, 2, 2, 1], ..Wave::scan() }),
        Unsupported { found: "a wave of four dimensions" }
    );
    refused!(
        message(Wave { points: [3, 2, 20, 0], ..Wave::scan() }),
        Truncated { needed: 480, available: 205 }
    );
    refused!(
        message(Wave { points: [0, 2, 3, 0], ..Wave::scan() }),
        BadField { field: "the number of points of the dimensions", value: "[0, 2, 3, 0]" }
    );
    let over_time = Wave { units: ["m", "s", ""], ..table() };
    refused!(message(over_time), NoHeightChannel { channels: ["Left", "Right"] });
    let without_unit = Wave { units: ["", "um", "um"], note: "", labels: &[], ..Wave::scan() };
    refused!(message(without_unit), NoUnit { what: Unitless::Heights });
}
