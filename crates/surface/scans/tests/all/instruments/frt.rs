//! MicroProf files: blocks of both widths, a topography of its own or in a list of images.

use crate::instruments::bytes::Bytes;
use crate::instruments::refusal;
use crate::instruments::{Sample, assert_holds, channels, heights};
use scans::{Measure, Probe};

fn file(version: &str, blocks: &[(u16, Vec<u8>)]) -> Vec<u8> {
    let mut file = Bytes::default();
    file.put("FRTM_GLIDERV").put(version).put((blocks.len() as u16).to_le_bytes());
    for (id, content) in blocks {
        file.put(id.to_le_bytes());
        match version {
            "1.00" => file.put((content.len() as u32).to_le_bytes()),
            _ => file.put((content.len() as u64).to_le_bytes()),
        };
        file.put(content);
    }
    file.0
}

fn words(words: &[u32]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}

fn doubles(values: &[f64]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

/// From the lowest row up; 1 is a missing point.
const TOPOGRAPHY: [u16; 6] = [40, 1, 60, 10, 20, 30];
const HEIGHTS: [Option<f64>; 6] = [Some(10e-9), Some(20e-9), Some(30e-9), Some(40e-9), None, Some(60e-9)];

fn shorts() -> Vec<u8> {
    TOPOGRAPHY.iter().flat_map(|value| value.to_le_bytes()).collect()
}

fn image(kind: u32, bits: u32, data: &[u8]) -> Vec<u8> {
    [words(&[kind, 3, 2, bits]), data.to_vec()].concat()
}

fn frame() -> Vec<(u16, Vec<u8>)> {
    vec![
        (0x65, b"on glass\0".to_vec()),
        (0x66, words(&[3, 2, 16])),
        (0x67, [doubles(&[3e-3, 1e-3, 0.0, 0.0, 1.0]), words(&[1])].concat()),
        (0x6c, [words(&[5]), doubles(&[1e-9])].concat()),
    ]
}

fn alone(version: &str) -> Vec<u8> {
    file(version, &[frame(), vec![(0x0b, shorts()), (0x99, vec![7])]].concat())
}

fn listed() -> Vec<u8> {
    let thickness: Vec<u8> = [-5i32, 6, 7, 8, 9, 10].iter().flat_map(|value| value.to_le_bytes()).collect();
    let images = [
        vec![0; 8],
        image(0x4, 16, &shorts()),
        image(0x2, 16, &[9; 12]),
        image(0x1000_0080, 32, &thickness),
        image(0x1004, 16, &[8; 12]),
    ];
    file("1.00", &[frame(), vec![(0x7d, images.concat())]].concat())
}

pub fn samples() -> Vec<Sample> {
    let sample = |name, bytes| Sample { name, bytes };
    vec![sample("alone", alone("1.00")), sample("wide", alone("1.01")), sample("listed", listed())]
}

#[test]
fn the_topography_has_a_block_of_its_own() {
    for version in ["1.00", "1.01"] {
        let file = &heights(&alone(version))[0];
        assert_holds(&file.scan, (3e-3, Some(1e-3)), &HEIGHTS, 1e-20);
        assert_eq!((file.channel.as_deref(), file.probe), (Some("Topography"), Some(Probe::Microscope)));
        assert_eq!(file.free_text, "on glass");
    }
}

#[test]
fn images_stand_in_a_list() {
    let found: Vec<_> = channels(&listed(), true).into_iter().map(Result::unwrap).collect();
    let names: Vec<_> = found.iter().filter_map(|file| file.channel.as_deref()).collect();
    assert_eq!(names, ["Topography", "Intensity", "Thickness (bottom sensor)", "Topography 2"]);
    assert_holds(&found[0].scan, (3e-3, Some(1e-3)), &HEIGHTS, 1e-20);
    assert_eq!((&found[1].measure, &found[2].measure), (&Measure::Other(String::new()), &Measure::Length));
    assert_eq!(found[2].scan.heights_m().nth(3), Some(Some(-5e-9)));
    // A copy in the list is not shown again.
    let images = [vec![0; 8], image(0x4, 16, &shorts())].concat();
    let both = file("1.00", &[frame(), vec![(0x0b, shorts()), (0x7d, images)]].concat());
    assert_eq!(channels(&both, true).len(), 1);
}

#[test]
fn damage_is_told() {
    let cut = alone("1.00");
    refused!(refusal(&cut[..cut.len() - 15]), Truncated { needed: 12, available: 4 });
    let empty = refusal(&file("1.00", &frame()));
    refused!(empty, MissingField { field: "block 0x0b, the heights" });
    refused!(refusal(&file("2.00", &frame())), BadField { field: "the version", value: "'2.00'" });
    let small = file("1.00", &[frame(), vec![(0x0b, vec![0; 10])]].concat());
    refused!(refusal(&small), BadField { field: "the size of the block", value: "10" });
}
