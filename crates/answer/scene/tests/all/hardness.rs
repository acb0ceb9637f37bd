//! The indentation hardness of a scene's material: its consequences, assumptions and errors.

use scene::{Overrides, Scene, SceneError, SceneProblem};
use study::NoFiles;
use study::hardness_and_strength::HardnessOffStrength;
use study::material::MaterialError;

/// A scene of steel with these keys of its material, and a load in H.
fn of_material(keys: &str, model: &str) -> Result<Scene, SceneError> {
    let text = format!(
        "[surface]\npsd = \"builtin:uncd-measured\"\n[material]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n\
         {keys}[options]\nstrength_cap = \"2 H\"\n[loads]\npressures = [\"1e-3 H\"]\n[[curve]]\nmodel = \"{model}\"\n\
         strain_gradient = true\n"
    );
    Scene::parse(&text, &NoFiles, &Overrides::default())
}

const LENGTH: &str = "strain_gradient_length = \"5 um\"\n";

#[test]
fn loads_caps_and_laws_follow_the_hardness_that_is_given() {
    let scene = |keys: &str| of_material(&format!("{LENGTH}{keys}"), "elastic-plastic").unwrap();
    let of = |scene: &Scene| {
        let strength = scene.needs.curves[0].model.strength().unwrap();
        (scene.needs.loads[0].nominal_pressure_pa(), strength.macroscopic_strength_pa(), strength.cap_pa())
    };
    let alone = scene("indentation_hardness = \"4.5 GPa\"\n");
    assert_eq!(of(&alone), (4.5e6, 1.5e9, Some(9e9)));
    assert_eq!(of(&alone), of(&scene("yield_strength = \"1.5 GPa\"\n")));
    let both = scene("indentation_hardness = \"4.53 GPa\"\nyield_strength = \"1.5 GPa\"\n");
    assert_eq!(of(&both), (1e-3 * 4.53e9, 1.5e9, Some(2.0 * 4.53e9)));
    let vickers = scene("indentation_hardness = \"300 HV\"\n");
    assert_eq!(vickers.hardness_pa(), Some(300.0 * 9.80665e6));
    assert_eq!(scene("indentation_hardness = \"200 HBW\"\n").hardness_pa(), Some(200.0 * 9.80665e6));
    let rockwell = scene("indentation_hardness = \"60 HRC\"\n").hardness_pa().unwrap();
    assert!((rockwell / (697.0 * 9.80665e6) - 1.0).abs() < 1e-12);
}

#[test]
fn how_well_a_hardness_is_known_may_be_told_in_steps_of_its_scale() {
    let scene =
        |hardness: &str| of_material(&format!("{LENGTH}indentation_hardness = \"{hardness}\"\n"), "elastic");
    let relative = |hardness: &str| scene(hardness).unwrap().spreads.strength.unwrap().standard_uncertainty();
    // One step at 60 HRC is 23 HV.
    assert!((relative("60 HRC +- 1 HRC") - 23.0 / 697.0).abs() < 1e-9);
    assert!((relative("200 HBW +- 10 HBW") - 0.05).abs() < 1e-9);
    assert!(relative("58 HRC to 62 HRC") > 0.03);
    assert_eq!(scene("700 HV +- 1 HRC").unwrap_err().key(), Some("material.indentation_hardness"));
}

#[test]
fn what_was_assumed_is_told_beside_the_number() {
    let told = |keys: &str| {
        let scene = of_material(keys, "elastic").unwrap();
        let properties = scene.material.as_ref().unwrap().properties();
        let named = |word: &str| properties.iter().find(|(name, _)| name.contains(word)).cloned().unwrap();
        (named("yield strength S₀"), named("hardness H"), scene.choices()[0].clone())
    };
    let (strength, hardness, record) = told("indentation_hardness = \"4.5 GPa\"\n");
    assert_eq!(strength, ("yield strength S₀, none given and H/3 assumed", "1.5 GPa".to_owned()));
    assert_eq!(hardness, ("indentation hardness H", "4.5 GPa".to_owned()));
    assert!(record.contains("S0 = H/3 = 1500000000 Pa, H = 4500000000 Pa"), "{record}");
    let (strength, hardness, record) = told("yield_strength = \"1.5 GPa\"\n");
    assert_eq!(strength, ("yield strength S₀", "1.5 GPa".to_owned()));
    assert_eq!(hardness, ("hardness H = 3 S₀", "4.5 GPa".to_owned()));
    assert!(record.contains("S0 = 1500000000 Pa") && !record.contains("H ="), "{record}");
}

#[test]
fn a_hardness_and_a_strength_of_two_bodies_are_refused_with_both_values() {
    let keys = "yield_strength = \"1 GPa\"\nindentation_hardness = \"4 GPa\"\n";
    // Elastic models look at neither of them, and a load in H does.
    for model in ["elastic", "elastic-plastic"] {
        let error = of_material(keys, model).unwrap_err();
        let SceneProblem::Material(MaterialError::HardnessOffStrength(off)) = error.problem else {
            panic!("{error}")
        };
        assert_eq!(off, HardnessOffStrength { hardness_pa: 4e9, yield_strength_pa: 1e9 });
        assert_eq!(error.span.map(|span| span.len()), Some("\"4 GPa\"".len()));
    }
    assert_eq!(of_material("", "elastic").unwrap_err().key(), Some("loads.pressures"));
    let error = of_material("indentation_hardness = \"1 H\"\n", "elastic").unwrap_err();
    assert_eq!(error.key(), Some("material.indentation_hardness"));
}
