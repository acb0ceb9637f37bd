//! Tables and `answer.json` of thirty scenes hold what their conclusions hold.

use std::collections::BTreeMap;

use conclusions::Evidence;
use questions::{RunOptions, SceneOutcome, Unwatched, run_scene};
use report::products::{ANSWER, Product, SceneProducts};
use report::run_stamp::RunStamp;
use scene::{Overrides, Scene};

/// Spectra without errors, with them, with a hole of 1.3 decades, from roughness parameters; and two bodies.
const SURFACES: [&str; 4] = [
    "surface = { psd = \"plain.csv\" }",
    "surface = { psd = \"errors.csv\" }",
    "surface = { psd = \"hole.csv\" }",
    "surface = { rms_height = \"1.2 um\", rms_slope = 0.2, hurst = 0.8, rolloff_wavelength = \"60 um\" }",
];

/// Bodies that never yield, yield at a constant hardness, or at one that grows; soft and hard, one against another.
const BODIES: [&str; 6] = [
    "material = { youngs_modulus = \"200 GPa\", poisson_ratio = 0.3 }",
    "material = { name = \"100Cr6\" }",
    "material = { name = \"diamond\", yield_strength = \"1.8 GPa\", strain_gradient_length = \"5 um\" }",
    "material = { youngs_modulus = \"5 MPa +- 10 %\", poisson_ratio = 0.49 }",
    "material = { name = \"100Cr6\" }\ncounterface = { name = \"gold\" }",
    "material = { youngs_modulus = \"70 GPa\", poisson_ratio = 0.33, yield_strength = \"100 MPa\", strain_gradient_length = \"2 um\" }",
];

/// Few points and few draws: what is said of them must agree all the same.
const SMALL: &str = "[judge]\ngrid = 64\n[uncertainty]\ndraws = 200\n";

const SEAL: &str =
    "[seal]\npressure_drop = \"1 MPa\"\nviscosity = \"1 mPa s\"\nbreadth = \"100 mm\"\nlength = \"2 mm\"\n";

/// The scenes that come with the program.
const SHIPPED: [&str; 6] = [
    "bolted-joint",
    "contact-challenge",
    "electrical-contact",
    "gasket",
    "uncd-measured",
    "uncd-reconstructed",
];

#[test]
fn tables_and_json_hold_what_the_conclusions_hold() {
    let files = spectra();
    let mut texts = generated();
    for name in SHIPPED {
        let path = format!("{}/../../../data/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
        texts.push(std::fs::read_to_string(path).unwrap());
    }
    assert!(texts.len() >= 30);
    for text in &texts {
        let scene = Scene::parse(text, &files, &Overrides::default())
            .unwrap_or_else(|error| panic!("{error:?}\n{text}"));
        let options = RunOptions { report: true, judge: None, uncertainty: None };
        let outcome =
            run_scene(&scene, options, &Unwatched).unwrap_or_else(|error| panic!("{error:?}\n{text}"));
        println!("{text}");
        check_products(&scene, &outcome);
    }
}

/// The table of verdicts and `answer.json` hold what the conclusions hold.
fn check_products(scene: &Scene, outcome: &SceneOutcome) {
    let evidence = Evidence {
        scene,
        results: &outcome.results,
        answer: &outcome.answer,
        judgement: outcome.judgement.as_ref(),
        uncertainty: outcome.uncertainty.as_ref(),
    };
    let products = SceneProducts {
        evidence,
        conclusions: &outcome.conclusions,
        sensitivities: outcome.sensitivities.as_deref(),
        run_stamp: &RunStamp { date: None, command: None },
    };
    let mut tables = 0;
    let taken: Result<(), ()> = products.each(tables::Format::Csv, |name, product| {
        match product {
            Product::Table { table, .. } if name == "report-models" => {
                tables += 1;
                let column = |wanted| table.columns().find(|(name, _)| *name == wanted).unwrap().1;
                let (tables::Cells::Numbers(ratios), tables::Cells::Typed(verdicts)) =
                    (column("ratio_to_judge"), column("verdict"))
                else {
                    panic!("ratios are numbers, verdicts text")
                };
                let rows = &outcome.judgement.as_ref().unwrap().curves;
                for ((row, ratio), verdict) in rows.iter().zip(ratios).zip(verdicts) {
                    assert_eq!((row.ratio(), row.verdict.name()), (*ratio, &*verdict.text()));
                }
            }
            Product::Text(text) if name == ANSWER => {
                tables += 1;
                let answer: serde_json::Value = serde_json::from_str(text).unwrap();
                for (load, found) in outcome.conclusions.loads.iter().zip(answer["loads"].as_array().unwrap())
                {
                    let agrees = |key: &str, value: f64| {
                        let written = found["area"][key].as_f64().unwrap();
                        assert!((written / value - 1.0).abs() < 1e-14, "{key}: {written} and {value}");
                    };
                    load.area.area_fraction.into_iter().for_each(|value| agrees("area_fraction", value));
                    agrees("low", load.area.low);
                    agrees("high", load.area.high);
                }
            }
            _ => {}
        }
        Ok(())
    });
    assert_eq!((taken, tables), (Ok(()), 2));
}

/// Scenes of all bodies on all surfaces, with loads, seals and lists of curves in turn; one more shows a seal that
/// closes.
fn generated() -> Vec<String> {
    let mut texts = Vec::new();
    for (body, bodies) in BODIES.iter().enumerate() {
        for (surface, surfaces) in SURFACES.iter().enumerate() {
            let pressures = match (body + surface) % 3 {
                0 => "\"10 MPa\"",
                1 => "\"1 MPa\", \"30 MPa\"",
                _ => "\"100 kPa\", \"5 MPa\", \"200 MPa\"",
            };
            let pressures = if body == 3 { "\"10 kPa\", \"100 kPa\"" } else { pressures };
            let seal = if (body + surface) % 2 == 0 { SEAL } else { "[interface]\n" };
            let curves = match (body + 2 * surface) % 4 {
                0 => "[[curve]]\nmodel = \"persson\"\n[[curve]]\nmodel = \"elastic\"\n",
                _ => "",
            };
            texts.push(format!(
                "{surfaces}\n{bodies}\nloads = {{ pressures = [{pressures}] }}\n{seal}{curves}{SMALL}"
            ));
        }
    }
    texts.push(format!(
        "{}\n{}\nloads = {{ pressures = [\"1 MPa\", \"60 MPa\"] }}\n{SEAL}",
        SURFACES[3], BODIES[3]
    ));
    texts
}

/// The spectra that the scenes name: C1D falls as q^-2.6 below 50 um, down to 10 nm.
fn spectra() -> BTreeMap<String, Vec<u8>> {
    let spectrum = |head: &str, tail: &dyn Fn(f64) -> String, keeps: &dyn Fn(f64) -> bool| {
        let row = |at: i32| {
            let wavelength_m = 10f64.powf(-3.9 - 0.1 * f64::from(at));
            let c1d_m3 = 2e-17 * (1.0 + (50e-6 / wavelength_m).powi(2)).powf(-1.3);
            keeps(wavelength_m).then(|| format!("{wavelength_m:e},{c1d_m3:e}{}\n", tail(c1d_m3)))
        };
        let rows: String = (0..=41).filter_map(row).collect();
        format!("wavelength_m,C1D_m3{head}\n{rows}").into_bytes()
    };
    let plain = |_: f64| String::new();
    let is_measured = |wavelength_m: f64| !(1.1e-7..2.2e-6).contains(&wavelength_m);
    BTreeMap::from([
        ("plain.csv".to_owned(), spectrum("", &plain, &|_| true)),
        (
            "errors.csv".to_owned(),
            spectrum(",C1D_se_m3", &|c1d_m3| format!(",{:e}", 0.2 * c1d_m3), &|_| true),
        ),
        ("hole.csv".to_owned(), spectrum("", &plain, &is_measured)),
    ])
}
