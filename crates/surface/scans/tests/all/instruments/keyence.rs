//! Keyence files, plain and packed.

use crate::instruments::bytes::Bytes;
use crate::instruments::refusal;
use crate::instruments::{Sample, assert_holds, channels, heights};
use crate::support::zip_file::zipped;
use scans::{Measure, Probe, ScanOptions, read_scans};

fn image(bits: u32, compression: u32, data: &[u8]) -> Vec<u8> {
    let mut image = Bytes::default();
    for word in [3, 2, bits, compression, data.len() as u32, 0, 0] {
        image.put(word.to_le_bytes());
    }
    image.zeros(768).put(data);
    image.0
}

/// A file of 3 x 2 pixels of 1 x 2 µm with heights in nm, and an image of intensity.
fn plain(magic: &str, heights: &[u8], second: Option<&[u8]>, intensity: &[u8]) -> Vec<u8> {
    let entries: usize = if magic == "VK4_" { 18 } else { 17 };
    let conditions = 12 + 4 * entries;
    let height = conditions + 300;
    let light = height + heights.len();
    let mut table = vec![0u32; entries];
    (table[0], table[6], table[3]) = (conditions as u32, height as u32, light as u32);
    table[7] = second.map_or(0, |_| (light + intensity.len()) as u32);
    let mut file = Bytes::default();
    file.put(magic).zeros(8);
    table.iter().for_each(|place| {
        file.put(place.to_le_bytes());
    });
    file.zeros(168);
    for length_pm in [1_000_000u32, 2_000_000, 1000] {
        file.put(length_pm.to_le_bytes());
    }
    file.pad_to(height).put(heights).put(intensity).put(second.unwrap_or_default());
    file.0
}

fn map() -> Vec<u8> {
    image(32, 0, &[1u32, 2, 3, 4, 5, 6].map(u32::to_le_bytes).concat())
}

fn packed(magic: &str) -> Vec<u8> {
    let content = plain("VK4_", &map(), None, &image(8, 0, &[9; 6]));
    [magic.as_bytes(), b" a preview and more", &zipped(&[("Vk4File", &content)])].concat()
}

pub fn samples() -> Vec<Sample> {
    let sample = |name, bytes| Sample { name, bytes };
    vec![
        sample("plain", plain("VK4_", &map(), Some(&image(16, 0, &[7; 12])), &image(8, 0, &[9; 6]))),
        sample("packed", packed("VK6")),
    ]
}

const HEIGHTS: [Option<f64>; 6] = [Some(1e-9), Some(2e-9), Some(3e-9), Some(4e-9), Some(5e-9), Some(6e-9)];

#[test]
fn plain_files_are_read() {
    for magic in ["VK4_", "VK3_"] {
        let found =
            channels(&plain(magic, &map(), Some(&image(16, 0, &[7; 12])), &image(8, 0, &[9; 6])), true);
        let found: Vec<_> = found.into_iter().map(Result::unwrap).collect();
        let names: Vec<_> = found.iter().filter_map(|file| file.channel.as_deref()).collect();
        assert_eq!(names, ["Height", "Height 2", "Intensity"]);
        assert_holds(&found[0].scan, (3e-6, Some(4e-6)), &HEIGHTS, 1e-22);
        assert_eq!(
            (found[0].probe, &found[2].measure),
            (Some(Probe::Microscope), &Measure::Other(String::new()))
        );
    }
}

#[test]
fn packed_files_are_read() {
    for magic in ["VK6", "VK7"] {
        assert_holds(&heights(&packed(magic))[0].scan, (3e-6, Some(4e-6)), &HEIGHTS, 1e-22);
    }
    // The letters alone may begin a text.
    let text = read_scans(
        b"VK6 1\n0 1\n1 2\n",
        "scan",
        &ScanOptions { unit: "nm".parse().ok(), ..ScanOptions::default() },
    );
    assert_eq!(text.unwrap()[0].scan.points(), (2, None));
}

#[test]
fn damage_is_told() {
    let with = |image: &[u8]| refusal(&plain("VK4_", image, None, &[]));
    refused!(with(&image(24, 0, &[0; 18])), BadField { field: "the bits of a number", value: "24" });
    refused!(with(&image(16, 1, &[0; 12])), Unsupported { found: "compression 1" });
    refused!(with(&image(16, 0, &[0; 11])), Truncated { needed: 12, available: 11 });
    refused!(refusal(b"VK4_"), Truncated { needed: 4, available: 0 });
}
