//! Doubts that physics raises about scenes and their results; the answer and its doubts as data.

use findings::answer::SceneAnswer;
use findings::doubts;
use scene::{Overrides, Scene};
use study::NoFiles;
use units::{Remark, RemarkCode, RemarkValue};

fn scene(sections: &str) -> Scene {
    let text = format!(
        "[surface]\npsd = \"builtin:uncd-measured\"\n[material]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n\
         yield_strength = \"1 GPa\"\n{sections}"
    );
    Scene::parse(&text, &NoFiles, &Overrides::default()).unwrap()
}

#[test]
fn an_answer_and_its_doubts_serialise() {
    let scene = scene(
        "[loads]\npressures = [\"1 MPa\", \"1 H\"]\n[[curve]]\nmodel = \"hertz\"\n[[curve]]\nmodel = \"elastic\"\n",
    );
    let results = scene.plan().compute().unwrap();
    let answer = SceneAnswer::from_results(&scene, &results);
    let found = doubts::of_scene(&scene, &answer);
    let all = serde_json::json!({ "answer": answer, "doubts": found });
    let area = results.curves[1].area_fractions(0).last().map(|(_, area_fraction)| *area_fraction);
    assert_eq!(all["answer"]["curves"][1][0]["area_fraction"].as_f64(), area);
    assert!(!found.is_empty());
    assert_eq!(all["doubts"].as_array().map(Vec::len), Some(found.len()));
}

fn found(sections: &str) -> Vec<Remark> {
    let scene = scene(sections);
    let results = scene.plan().compute().unwrap();
    doubts::of_scene(&scene, &SceneAnswer::from_results(&scene, &results))
}

#[test]
fn pressures_above_what_the_body_bears_are_doubted_with_their_places() {
    let found = found("[loads]\npressures = [\"1 MPa\", \"2 H\", \"4 H\"]\n[[curve]]\nmodel = \"hertz\"\n");
    let codes: Vec<RemarkCode> = found.iter().map(|doubt| doubt.code).collect();
    assert_eq!(
        codes,
        [RemarkCode::NominalAboveHardness, RemarkCode::RealAboveHardness, RemarkCode::RealAboveThirdModulus]
    );
    let has_text = |at: usize, name, text: &str| found[at].numbers.contains(&(name, RemarkValue::from(text)));
    assert!(has_text(0, "load", "4 H") && has_text(1, "curve", "hertz") && has_text(1, "load", "4 H"));
    assert_eq!(found[0].number("others"), Some(1.0));
    assert!(found[2].number("bound_pa").unwrap() < 210e9 / 2.0);
}

#[test]
fn a_spectrum_in_the_wrong_unit_and_a_body_too_strong_are_doubted() {
    let file = "wavelength_m,C1D_m3\n1e-4,1e-7\n1e-5,1e-9\n1e-6,1e-11\n";
    let files = std::collections::BTreeMap::from([("psd.csv".to_owned(), file.as_bytes().to_vec())]);
    let text = "[surface]\npsd = \"psd.csv\"\n[material]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n\
                yield_strength = \"30 GPa\"\n[loads]\npressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"elastic\"\n";
    let scene = Scene::parse(text, &files, &Overrides::default()).unwrap();
    let found = doubts::of_spectrum(&scene.surface.psd);
    let [surface, scale] = &found[..] else { panic!("{found:?}") };
    assert_eq!((surface.code, scale.code), (RemarkCode::FarTooSteepSurface, RemarkCode::SteepScale));
    assert!(surface.number("rms_slope") > Some(1e3) && scale.number("aspect_ratio") > Some(1e3));
    let material = scene.material.as_ref().and_then(doubts::of_material);
    let expected = Remark::new(RemarkCode::StrongerThanSolids).with("yield_strength_pa", 30e9);
    assert_eq!(material, Some(expected.with("bound_pa", 21e9)));
}

#[test]
fn a_modulus_of_a_polymer_with_the_ratio_of_a_metal_is_doubted() {
    let doubt = |modulus: &str, ratio: f64| {
        let text = format!(
            "[surface]\npsd = \"builtin:uncd-measured\"\n[material]\nyoungs_modulus = \"{modulus}\"\npoisson_ratio = {ratio}\n\
             [loads]\npressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"elastic\"\n"
        );
        let scene = Scene::parse(&text, &NoFiles, &Overrides::default()).unwrap();
        scene.material.as_ref().and_then(doubts::of_material)
    };
    for (modulus, youngs_modulus_pa) in [("210 MPa", 210e6), ("210 Pa", 210.0)] {
        let expected = Remark::new(RemarkCode::SofterThanItsRatio)
            .with("youngs_modulus_pa", youngs_modulus_pa)
            .with("probable_pa", 210e9)
            .with("poisson_ratio", 0.3);
        assert_eq!(doubt(modulus, 0.3), Some(expected));
    }
    for (modulus, ratio) in [("210 GPa", 0.3), ("500 MPa", 0.46), ("5.5 MPa", 0.3), ("1 GPa", 0.3)] {
        assert_eq!(doubt(modulus, ratio), None, "{modulus}");
    }
}

#[test]
fn nothing_is_doubted_where_physics_has_nothing_against_it() {
    assert_eq!(
        found(
            "[loads]\npressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"elastic-plastic\"\n\
                       [cutoffs]\nshortest_wavelength = \"20 um\"\n"
        ),
        []
    );
}

#[test]
fn a_layer_is_thin_by_the_power_of_its_modulus() {
    let of_layer = |thickness: &str, ratio: f64, base: &str| {
        let text = format!(
            "[surface]\npsd = \"builtin:uncd-measured\"\n[material]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n\
             [material.layer]\nthickness = \"{thickness}\"\nyoungs_modulus = \"3 GPa\"\npoisson_ratio = {ratio}\n\
             base = \"{base}\"\n[loads]\npressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"persson\"\n"
        );
        let text = match base {
            "rigid" => text.replace("youngs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n", ""),
            _ => text,
        };
        let scene = Scene::parse(&text, &NoFiles, &Overrides::default()).unwrap();
        let found = doubts::of_layer(scene.material.as_ref().unwrap(), &scene.surface.psd).unwrap();
        (found.code, found.number("exponent").unwrap())
    };
    for (thickness, ratio, base, code, expected) in [
        ("1 mm", 0.4, "rigid", RemarkCode::ModulusOfLayer, 0.0),
        ("0.1 nm", 0.4, "rigid", RemarkCode::ThinLayer, -1.0),
        ("0.1 nm", 0.5, "rigid", RemarkCode::ThinLayer, -3.0),
        // So thin that the waves feel the base alone.
        ("0.001 nm", 0.4, "material", RemarkCode::ModulusOfLayer, 0.0),
    ] {
        let (found, exponent) = of_layer(thickness, ratio, base);
        assert!(
            found == code && (exponent - expected).abs() < 0.05,
            "{thickness} {ratio} {base}: {exponent}"
        );
    }
}
