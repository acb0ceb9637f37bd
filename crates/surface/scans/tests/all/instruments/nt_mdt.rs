//! Files of NT-MDT.

use crate::instruments::refusal;
use scans::{Measure, Probe, ScanOptions, read_scans};

use super::bytes::Bytes;
use super::{Sample, assert_holds, channels};

/// A frame of 3 x 2 counts, of a signal and a unit by their numbers.
fn frame(kind: u16, signal: u8, unit: i16, dots: u16, points: [u16; 2]) -> Vec<u8> {
    let mut body = Bytes::default();
    for (origin, step, unit) in [(5.0f32, 0.25f32, -2i16), (5.0, -0.5, -2), (1.0, 2.0, unit)] {
        body.put(origin.to_le_bytes()).put(step.to_le_bytes()).put(unit.to_le_bytes());
    }
    body.put([signal, 0]).zeros(8);
    let variables = body.0.len() as u16;
    body.zeros(2).put(points[0].to_le_bytes()).put(points[1].to_le_bytes()).put(dots.to_le_bytes());
    body.zeros(if dots > 0 { 14 + 16 * usize::from(dots) } else { 0 });
    body.put([1i16, 2, 3, 4, 5, -6].map(i16::to_le_bytes).concat())
        .put(6u32.to_le_bytes())
        .put(b"Cell\xff\x0a<xml");
    let mut frame = Bytes::default();
    frame.put((22 + body.0.len() as u32).to_le_bytes()).put(kind.to_le_bytes()).zeros(14);
    frame.put(variables.to_le_bytes()).put(&body.0).0.clone()
}

fn file(frames: &[Vec<u8>]) -> Vec<u8> {
    let mut bytes = Bytes::default();
    bytes.put([0x01, 0xb0, 0x93, 0xff]).zeros(8).put((frames.len() as u16 - 1).to_le_bytes()).pad_to(33);
    bytes.put(frames.concat()).0.clone()
}

fn whole() -> Vec<u8> {
    let points = [3, 2];
    file(&[
        frame(0, 11, 5, 0, points),
        frame(106, 0, -1, 0, points),
        frame(0, 0, -1, 2, points),
        frame(0, 0, -1, 0, [0, 0]),
        frame(0, 40, 0, 0, points),
    ])
}

pub fn samples() -> Vec<Sample> {
    vec![Sample { name: "several frames", bytes: whole() }]
}

#[test]
fn scanned_images_are_read_from_their_bottom() {
    let all: Vec<_> = channels(&whole(), true).into_iter().map(Result::unwrap).collect();
    let names: Vec<_> = all.iter().map(|file| file.channel.as_deref().unwrap()).collect();
    assert_eq!(names, ["Phase1 (Cellя)", "Height (Cellя)", "signal 40 (Cellя)"]);
    assert_eq!(all[0].measure, Measure::Other("deg".to_owned()));
    let expected = [9e-9, 11e-9, -11e-9, 3e-9, 5e-9, 7e-9].map(Some);
    assert_holds(&all[1].scan, (0.75e-6, Some(1e-6)), &expected, 1e-22);
    assert_holds(
        &all[2].scan,
        (0.75e-6, Some(1e-6)),
        &expected.map(|value| value.map(|nm| nm / 10.0)),
        1e-22,
    );
    assert_eq!(all[1].probe, Some(Probe::Tip));
}

#[test]
fn what_is_damaged_is_refused() {
    refused!(
        refusal(&file(&[frame(106, 0, -1, 0, [3, 2])])),
        Unsupported { found: "a file without a frame of a scanned image" }
    );
    let large = file(&[frame(0, 0, -1, 0, [30, 20])]);
    refused!(refusal(&large), Truncated { needed: 1200, available: 26 });
    let mut small = whole();
    small[33..37].copy_from_slice(&[7, 0, 0, 0]);
    refused!(refusal(&small), BadField { field: "the size of a frame", value: "7" });
    let mut cut = whole();
    cut.truncate(300);
    refused!(refusal(&cut), Truncated { needed: 46, available: 5 });
}

#[test]
fn frames_of_one_name_are_numbered() {
    let points = [3, 2];
    let bytes = file(&[
        frame(0, 0, 2, 0, points),
        frame(0, 0, -1, 0, points),
        frame(0, 0, -2, 0, points),
        frame(0, 11, 5, 0, points),
    ]);
    let all: Vec<_> = channels(&bytes, true).into_iter().map(Result::unwrap).collect();
    let names: Vec<_> = all.iter().map(|file| file.channel.as_deref().unwrap()).collect();
    assert_eq!(names, ["Height (Cellя) #1", "Height (Cellя)", "Height (Cellя) #3", "Phase1 (Cellя)"]);
    let choose = |name: &str| {
        let options = ScanOptions { channel: Some(name.to_owned()), ..ScanOptions::default() };
        read_scans(&bytes, "scan", &options).map(|mut files| files.remove(0).channel.unwrap_or_default())
    };
    assert_eq!(choose("Height").unwrap(), "Height (Cellя)");
    assert_eq!(choose("Height (Cellя) #3").unwrap(), "Height (Cellя) #3");
    refused!(choose("Height (Cellя) #1").unwrap_err(), NoHeights { unit: "V" });
    refused!(choose("Phase1").unwrap_err(), NoHeights { unit: "deg" });
    refused!(choose("Height (Cellя) #4").unwrap_err(), NoChannel { wanted: "channel 'Height (Cellя) #4'" });
}
