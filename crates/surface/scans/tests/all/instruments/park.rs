//! Images of Park Systems.

use scans::{Measure, Probe, ScanAxis, ScanOptions, read_scans};

use super::bytes::Bytes;
use super::tiff_file::{Tag, tiff};
use super::{Sample, assert_holds, channels, heights};

fn wide(text: &str, letters: usize) -> Vec<u8> {
    let bytes: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
    Bytes::default().put(&bytes).zeros(2 * letters - bytes.len()).0.clone()
}

struct Image {
    version: u32,
    kind: u32,
    name: &'static str,
    is_swapped: bool,
    scale: f64,
    unit: &'static str,
    data_type: u32,
    numbers: Vec<u8>,
}

impl Image {
    /// Heights of version 1: 3 x 2 counts.
    fn first() -> Self {
        Self {
            version: 0x0100_0001,
            kind: 0,
            name: "Topography",
            is_swapped: false,
            scale: 2.0,
            unit: "nm",
            data_type: 0,
            numbers: [1i16, 2, 3, 4, 5, -6].map(i16::to_le_bytes).concat(),
        }
    }

    /// Version 2 with floating-point numbers.
    fn second() -> Self {
        Self {
            version: 0x0100_0002,
            data_type: 2,
            scale: 0.0,
            unit: "",
            is_swapped: true,
            numbers: [1.0f32, 2.0, 3.0, 4.0, f32::NAN, -6.0].map(f32::to_le_bytes).concat(),
            ..Self::first()
        }
    }

    fn bytes(&self) -> Vec<u8> {
        let double = f64::to_le_bytes;
        let mut header = Bytes::default();
        header.put(self.kind.to_le_bytes()).put(wide(self.name, 32)).put(wide("Contact", 8)).zeros(16);
        header
            .put(3u32.to_le_bytes())
            .put(2u32.to_le_bytes())
            .zeros(28)
            .put(u32::from(self.is_swapped).to_le_bytes());
        header
            .put(double(1.5))
            .put(double(0.5))
            .zeros(64)
            .put(double(-10.0))
            .put(double(self.scale))
            .put(double(1.0));
        header.put(wide(self.unit, 8)).pad_to(348).put(self.data_type.to_le_bytes()).pad_to(580);
        tiff(&[vec![
            Tag::long(256, 1),
            Tag::long(50_432, 235_082_497),
            Tag::long(50_433, self.version),
            Tag::bytes(50_434, self.numbers.clone()),
            Tag::bytes(50_435, header.0),
            Tag::text(50_436, "tip radius 7 nm"),
        ]])
    }
}

pub fn samples() -> Vec<Sample> {
    vec![
        Sample { name: "version 1", bytes: Image::first().bytes() },
        Sample { name: "version 2", bytes: Image::second().bytes() },
    ]
}

const SIZE: (f64, Option<f64>) = (1.5e-6, Some(0.5e-6));

#[test]
fn numbers_are_scaled_and_read_from_their_bottom() {
    let found = &heights(&Image::first().bytes())[0];
    assert_holds(&found.scan, SIZE, &[-90e-9, -110e-9, 110e-9, -30e-9, -50e-9, -70e-9].map(Some), 1e-20);
    assert_eq!((found.channel.as_deref(), found.free_text.as_str()), (Some("Topography"), "tip radius 7 nm"));
    assert_eq!((found.probe, found.fast_axis), (Some(Probe::Tip), Some(ScanAxis::X)));
    let found = &heights(&Image::second().bytes())[0];
    let expected = [Some(-50e-6), None, Some(50e-6), Some(-20e-6), Some(-30e-6), Some(-40e-6)];
    assert_holds(&found.scan, SIZE, &expected, 1e-18);
    assert_eq!(found.fast_axis, Some(ScanAxis::Y));
    let numbers = [1i32, 2, 3, 4, 5, 6].map(i32::to_le_bytes).concat();
    let found = heights(&Image { data_type: 1, numbers, ..Image::second() }.bytes());
    assert_eq!(found[0].scan.heights_m().next(), Some(Some(-50e-6)));
}

#[test]
fn other_signals_are_told() {
    let signal = |name, unit| {
        let bytes = Image { name, unit, ..Image::first() }.bytes();
        channels(&bytes, true).remove(0).unwrap().measure
    };
    assert_eq!(signal("Phase", "deg"), Measure::Other("deg".to_owned()));
    assert_eq!(signal("Error Signal", "nm"), Measure::Length);
    assert_eq!(signal("Z Height", "um"), Measure::Height);
}

#[test]
fn what_is_damaged_is_refused() {
    let message = |image: Image| read_scans(&image.bytes(), "scan", &ScanOptions::default()).unwrap_err();
    let profile = message(Image { kind: 1, ..Image::first() });
    refused!(profile, BadField { field: "the kind of the image", value: "1" });
    let odd = message(Image { data_type: 9, ..Image::second() });
    refused!(odd, BadField { field: "the type of the numbers", value: "9" });
    let cut = message(Image { numbers: vec![0; 8], ..Image::first() });
    refused!(cut, Truncated { needed: 12, available: 8 });
}
