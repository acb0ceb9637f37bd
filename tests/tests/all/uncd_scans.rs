//! The real UNCD scans, from the files of the instruments to the contact area: "Demo UNCD data", L. Pastewka, CC BY
//! 4.0, and MIT-licensed test scans of SurfaceTopography.

use std::collections::BTreeMap;

use measurements::{CompositeOfFiles, ScanRequest};
use scene::{Overrides, Scene};
use study::NoFiles;
use study::surface::Surface;
use tests::shared_file;
use topography::{Average, CompositeSpectrum, Recipe};

const SCANS: [&str; 7] = [
    "uncd_scans/uncd_stylus_300um_5mar_3_k0HpKJt.txt:shortest=2.07um",
    "uncd_scans/gain_control_uncd_35_z03tr3R.001:shortest=46nm",
    "uncd_scans/80_Scale10.472_FIXEDv2p1_D7eHXiT.asc",
    "afm_tem_mit/di-1.di:shortest=70nm",
    "afm_tem_mit/di-6.di:shortest=300nm",
    "afm_tem_mit/nonuniform.asc:unit=nm",
    "afm_tem_mit/xy-1.txt:unit=nm",
];

/// The composite with the average of the study that the measured spectrum is of.
fn composite() -> CompositeSpectrum {
    let recipe = Recipe { average: Average::Log, ..Recipe::default() };
    let requests: Vec<ScanRequest> = SCANS.iter().map(|scan| scan.parse().unwrap()).collect();
    CompositeOfFiles::read(&requests, &files(), &recipe).unwrap().spectrum
}

/// The scans, and what lies beside them.
fn files() -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    for folder in ["uncd_scans", "afm_tem_mit"] {
        for file in std::fs::read_dir(shared_file("data").join(folder)).unwrap() {
            let file = file.unwrap();
            let name = format!("{folder}/{}", file.file_name().to_string_lossy());
            files.insert(name, std::fs::read(file.path()).unwrap());
        }
    }
    files
}

#[test]
#[ignore = "needs the shared folder"]
fn the_composite_is_the_measured_spectrum() {
    let found = composite();
    let measured = Surface::load("builtin:uncd-measured", &NoFiles, &Default::default()).unwrap().psd;
    let profile = found.composite.profile();
    let decades: Vec<f64> = measured
        .wavelengths_m()
        .iter()
        .zip(measured.c1d_m3())
        .filter_map(|(&wavelength_m, c1d_m3)| Some((profile.value_at(wavelength_m)? / c1d_m3).log10()))
        .collect();
    assert!(decades.len() >= 44, "{}", decades.len());
    let rms = (decades.iter().map(|off| off * off).sum::<f64>() / decades.len() as f64).sqrt();
    assert!(rms < 0.065, "{rms} decades");
    // All but a few bins, where one scan more or less reaches them, agree within the reference's six digits and its
    // arithmetic mean of wavevectors.
    let mut sizes: Vec<f64> = decades.iter().map(|off| off.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    assert!(sizes[sizes.len() * 9 / 10] < 0.025, "{sizes:?}");
}

#[test]
#[ignore = "needs the shared folder"]
fn slopes_agree_in_real_and_in_fourier_space() {
    let found = composite();
    let map = &found.scans[1];
    assert_eq!(map.name, "gain_control_uncd_35.001");
    let spectral = map.checks.spectral_slope.unwrap();
    assert!((spectral / map.checks.real_slope - 1.0).abs() < 0.02, "{:?}", map.checks);
    for scan in &found.scans {
        assert!(
            !scan.checks.evenly_spaced || (scan.checks.parseval_share - 1.0).abs() < 1e-12,
            "{}",
            scan.name
        );
    }
    // The AFM file carries its own scale; that of the metadata must not be applied.
    assert!(map.notes.iter().any(|note| note.contains("height_scale")), "{:?}", map.notes);
}

#[test]
#[ignore = "needs the shared folder"]
fn one_scene_leads_from_the_scans_to_stacked_and_statistical_areas() {
    let entry = |scan: &&str| {
        let request: ScanRequest = scan.parse().unwrap();
        let mut entry = format!("{{ file = \"{}\"", request.path);
        if let Some(shortest_m) = request.shortest_m {
            entry += &format!(", shortest_wavelength = \"{shortest_m:e} m\"");
        }
        if let Some(unit) = request.unit {
            entry += &format!(", unit = \"{unit}\"");
        }
        entry + " }"
    };
    let text = format!(
        "[surface]\nscans = [{}]\naverage = \"log\"\n[material]\nyoungs_modulus = \"463 GPa\"\npoisson_ratio = 0.2\nyield_strength = \"1.8 GPa\"\n\
         [loads]\npressures = [\"1e-3 H\"]\n[[curve]]\nmodel = \"elastic-plastic\"\n[[curve]]\nmodel = \"ep-sphere\"\n",
        SCANS.iter().map(entry).collect::<Vec<_>>().join(", ")
    );
    let files = files();
    let areas = |text: &str| -> Vec<f64> {
        let scene = Scene::parse(text, &files, &Overrides::default()).unwrap();
        let results = scene.plan().compute().unwrap();
        results.curves.iter().map(|curve| curve.area_fractions(0).last().unwrap().1).collect()
    };
    let from_scans = areas(&text);
    let scans = text.find("scans = [").unwrap()..text.find("[material]").unwrap();
    let mut from_spectrum = text.clone();
    from_spectrum.replace_range(scans, "psd = \"builtin:uncd-measured\"\n");
    for (scans, spectrum) in from_scans.iter().zip(areas(&from_spectrum)) {
        assert!((scans / spectrum).ln().abs() < 0.05, "{scans} {spectrum}");
    }
}
