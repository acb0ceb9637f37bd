//! Sensofar: topographies and profiles behind a header that begins with the time.

use crate::instruments::refusal;
use scans::{Probe, ScanFormat};

use crate::instruments::bytes::Bytes;
use crate::instruments::{Sample, assert_holds, heights};

/// The type of a measurement, how many pictures follow each layer, and the layers with their columns.
#[derive(Clone)]
struct Measurement {
    kind: u32,
    spacings: [f32; 2],
    pictures: u8,
    columns: usize,
    layers: Vec<Vec<f32>>,
}

const TOPOGRAPHY: u32 = 3;

fn topography() -> Measurement {
    Measurement {
        kind: TOPOGRAPHY,
        spacings: [0.5, 0.25],
        pictures: 1,
        columns: 2,
        layers: vec![vec![1.0, -2.0, 1_000_001.0, 4.0], vec![0.0; 4]],
    }
}

fn profile() -> Measurement {
    Measurement {
        kind: 1,
        pictures: 0,
        columns: 4,
        layers: vec![vec![1.0, 2.0, 1_000_001.0, 4.0]],
        ..topography()
    }
}

fn profiles() -> Measurement {
    Measurement { kind: 2, ..topography() }
}

impl Measurement {
    fn bytes(&self) -> Vec<u8> {
        let mut file = Bytes::default();
        file.text("Fri Mar 10 16:35:59 2023", 128).zeros(4).text("ground glass", 256).zeros(12);
        for number in [8.0, self.spacings[0], self.spacings[1], 0.0, 0.0, 1.0, 0.0] {
            file.put(number.to_le_bytes());
        }
        file.put(self.kind.to_le_bytes()).pad_to(489);
        file.put([self.layers.len() as u8, 0xfb, 6, self.pictures]).pad_to(500);
        for layer in &self.layers {
            file.put(((layer.len() / self.columns) as u32).to_le_bytes())
                .put((self.columns as u32).to_le_bytes());
            layer.iter().for_each(|point| {
                file.put(point.to_le_bytes());
            });
            file.put((-2f32).to_le_bytes()).put(4f32.to_le_bytes());
            file.zeros(3 * layer.len() * usize::from(self.pictures));
        }
        file.0
    }
}

pub fn samples() -> Vec<Sample> {
    vec![
        Sample { name: "topography", bytes: topography().bytes() },
        Sample { name: "profile", bytes: profile().bytes() },
        Sample { name: "profiles", bytes: profiles().bytes() },
    ]
}

const HEIGHTS_M: [Option<f64>; 4] = [Some(1e-6), Some(-2e-6), None, Some(4e-6)];

#[test]
fn every_layer_of_a_topography_is_a_channel() {
    let [first, second] = heights(&topography().bytes()).try_into().unwrap();
    assert_holds(&first.scan, (1e-6, Some(0.5e-6)), &HEIGHTS_M, 1e-20);
    assert_holds(&second.scan, (1e-6, Some(0.5e-6)), &[Some(0.0); 4], 0.0);
    assert_eq!(first.channels, ["layer0", "layer1"]);
    assert_eq!((first.probe, first.free_text.as_str()), (Some(Probe::Microscope), "ground glass"));
}

#[test]
fn every_profile_is_a_line() {
    let [line] = heights(&profile().bytes()).try_into().unwrap();
    let heights_m = [Some(1e-6), Some(2e-6), None, Some(4e-6)];
    assert_holds(&line.scan, (2e-6, None), &heights_m, 1e-20);
    let several = heights(&profiles().bytes());
    assert_eq!(several.len(), 4);
    assert_holds(&several[0].scan, (1e-6, None), &HEIGHTS_M[..2], 1e-20);
    assert_holds(&several[1].scan, (1e-6, None), &HEIGHTS_M[2..], 1e-20);
    assert_eq!(several[1].channel.as_deref(), Some("profile 2 of layer0"));
}

#[test]
fn thicknesses_and_images_are_no_heights() {
    for kind in [0, 5] {
        assert!(heights(&Measurement { kind, ..topography() }.bytes()).is_empty());
    }
}

#[test]
fn only_a_time_with_zero_bytes_behind_it_tells_the_format() {
    let mut bytes = topography().bytes();
    bytes[24] = b' ';
    assert_eq!(ScanFormat::recognise(&bytes), None);
}

#[test]
fn damage_is_told() {
    refused!(
        refusal(&Measurement { kind: 4, ..topography() }.bytes()),
        Unsupported { found: "a measurement of type 4", place: scans::FilePlace::Byte(428) }
    );
    let no_size = Measurement { spacings: [0.0, f32::NAN], ..topography() }.bytes();
    refused!(refusal(&no_size), NoSize { what: "how large the map is" });
    let mut many = profiles().bytes();
    many[502] = 1;
    refused!(refusal(&many), BadField { field: "the number of profiles", value: "65538" });
    let profile = profile().bytes();
    refused!(refusal(&profile[..520]), Truncated { needed: 16, available: 12 });
}
