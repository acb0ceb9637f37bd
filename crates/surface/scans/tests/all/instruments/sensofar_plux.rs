//! Sensofar PLUX: an index in XML and layers in a ZIP file.

use crate::instruments::refusal;
use scans::{Probe, ScanOptions, read_scans};

use crate::instruments::{Sample, assert_holds, heights};
use crate::support::zip_file;

fn zipped(files: &[(&str, Vec<u8>)]) -> Vec<u8> {
    let files = files.iter().map(|(path, bytes)| (*path, bytes.as_slice()));
    zip_file::zipped(&files.collect::<Vec<_>>())
}

fn index(rows: &str) -> Vec<u8> {
    let general = format!(
        "<DATE>Fri Mar 10 16:35:59 2023</DATE><IMAGE_SIZE_X>3</IMAGE_SIZE_X><IMAGE_SIZE_Y>{rows}</IMAGE_SIZE_Y>\
         <FOV_X>0.5</FOV_X><FOV_Y>0.25</FOV_Y>"
    );
    let info = "<ITEM_0><NAME>Device</NAME><VALUE>S neox</VALUE></ITEM_0>\
                <ITEM_1><NAME>Comment</NAME><VALUE>honed</VALUE></ITEM_1>";
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?><xml><GENERAL>{general}</GENERAL><INFO>{info}</INFO>\
         <LAYER_0><FILENAME_Z>LAYER_0.raw</FILENAME_Z></LAYER_0>\
         <LAYER_1><FILENAME_Z>LAYER_1.raw</FILENAME_Z></LAYER_1></xml>"
    )
    .into_bytes()
}

fn layer(points: &[f32]) -> Vec<u8> {
    points.iter().flat_map(|point| point.to_le_bytes()).collect()
}

const POINTS: [f32; 6] = [1.0, 2.0, 3.0, -4.0, f32::NAN, 6.0];

fn topography() -> Vec<u8> {
    zipped(&[("index.xml", index("2")), ("./LAYER_0.raw", layer(&POINTS)), ("LAYER_1.raw", layer(&[0.0; 6]))])
}

fn profile() -> Vec<u8> {
    zipped(&[("index.xml", index("1")), ("LAYER_0.raw", layer(&POINTS[..3]))])
}

pub fn samples() -> Vec<Sample> {
    vec![Sample { name: "topography", bytes: topography() }]
}

#[test]
fn every_layer_is_a_channel() {
    let [first, second] = heights(&topography()).try_into().unwrap();
    let heights_m = POINTS.map(|point| Some(f64::from(point) * 1e-6).filter(|height| height.is_finite()));
    assert_holds(&first.scan, (1.5e-6, Some(0.5e-6)), &heights_m, 1e-20);
    assert_holds(&second.scan, (1.5e-6, Some(0.5e-6)), &[Some(0.0); 6], 0.0);
    assert_eq!(first.channels, ["Layer 0", "Layer 1"]);
    assert_eq!((first.probe, first.free_text.as_str()), (Some(Probe::Microscope), "honed"));
}

#[test]
fn a_missing_layer_leaves_the_others() {
    let scans = read_scans(&profile(), "scan", &ScanOptions::default()).unwrap();
    assert_holds(&scans[0].scan, (1.5e-6, None), &[Some(1e-6), Some(2e-6), Some(3e-6)], 1e-20);
}

#[test]
fn damage_is_told() {
    let short = zipped(&[("index.xml", index("2")), ("LAYER_0.raw", layer(&POINTS[..5]))]);
    refused!(refusal(&short), Truncated { needed: 24, available: 20 });
    let no_rows = zipped(&[("index.xml", index("none")), ("LAYER_0.raw", layer(&POINTS))]);
    refused!(refusal(&no_rows), BadField { field: "the text", value: "'none'" });
    let no_general = zipped(&[("index.xml", b"<xml/>".to_vec()), ("LAYER_0.raw", layer(&POINTS))]);
    refused!(refusal(&no_general), MissingField { field: "element 'GENERAL'" });
}
