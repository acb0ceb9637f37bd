//! The two bodies of a scene: materials by name, the body that yields, and conductivities.

use scans::{ForeignFile, ScanFormat};
use scene::{FileContent, Overrides, Scene, SceneError, SceneProblem};
use study::NoFiles;
use study::bodies::{Body, Transport};
use study::body_properties::BodyProperty;
use study::material::MaterialError;

/// A scene with these sections on its bodies, of elastic-plastic asperities.
fn of_bodies(sections: &str) -> Result<Scene, SceneError> {
    let text = format!(
        "[surface]\npsd = \"builtin:uncd-measured\"\n{sections}\n[loads]\npressures = [\"1 MPa\"]\n[[curve]]\n\
         model = \"elastic-plastic\"\n"
    );
    Scene::parse(&text, &NoFiles, &Overrides::default())
}

fn strength_pa(scene: &Scene) -> f64 {
    scene.needs.curves[0].model.strength().unwrap().macroscopic_strength_pa()
}

const STEEL: &str = "[material]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n";
const ALUMINIUM: &str = "[counterface]\nyoungs_modulus = \"70 GPa\"\npoisson_ratio = 0.33\n";

#[test]
fn a_named_material_fills_the_keys_left_out_and_says_from_where() {
    let scene = of_bodies("[material]\nname = \"Steel 100Cr6\"\npoisson_ratio = 0.29\n").unwrap();
    let body = scene.material.unwrap().pair.body();
    assert_eq!((body.youngs_modulus_pa(), body.poisson_ratio()), (210e9, 0.29));
    assert_eq!(scene.hardness_pa(), Some(700.0 * 9.80665e6));
    let from_table = scene.bodies.from_table.as_ref().unwrap();
    use BodyProperty::{IndentationHardness, Resistivity, YoungsModulus};
    assert_eq!(from_table.properties, [YoungsModulus, IndentationHardness, Resistivity]);
    assert!(from_table.gives_strength());
    let choices = scene.choices();
    let told = choices.iter().find(|line| line.starts_with("the rough body is steel 100Cr6")).unwrap();
    assert!(
        told.contains("youngs_modulus, indentation_hardness, resistivity from the table")
            && told.contains("SKF")
    );
    // Another name of it, and a strength that takes the place of the hardness.
    let own = of_bodies("[material]\nname = \"52100\"\nyield_strength = \"2 GPa\"\n").unwrap();
    assert_eq!((strength_pa(&own), own.hardness_pa()), (2e9, Some(6e9)));
    assert!(!own.bodies.from_table.unwrap().gives_strength());
}

#[test]
fn a_name_that_the_table_does_not_have_is_told_with_what_was_meant() {
    let error = of_bodies("[material]\nname = \"steel C54\"\n").unwrap_err();
    let SceneProblem::UnknownValue { known, meant, .. } = &error.problem else { panic!("{error}") };
    assert_eq!(meant.as_deref(), Some("steel C45"));
    assert_eq!(known, &["steel C45"]);
    let missing = of_bodies("[material]\npoisson_ratio = 0.3\nyield_strength = \"1 GPa\"\n").unwrap_err();
    assert!(
        matches!(&missing.problem, SceneProblem::MissingKey { key } if key == "youngs_modulus"),
        "{missing}"
    );
    // Diamond has no hardness, which is said where a model needs one.
    let soft = of_bodies("[material]\nname = \"diamond\"\n").unwrap_err();
    assert!(matches!(soft.problem, SceneProblem::Material(MaterialError::Missing(_))), "{soft}");
}

#[test]
fn the_softer_body_flows_and_it_is_said_which() {
    let both = |own: &str, other: &str| of_bodies(&format!("{STEEL}{own}\n{ALUMINIUM}{other}\n")).unwrap();
    let line = |scene: &Scene| scene.bodies.describe(scene.softer(), &scene.spreads).join("|");
    let hard = "indentation_hardness = \"700 HV\"";
    let counterface = both(hard, "yield_strength = \"276 MPa\"");
    assert_eq!((strength_pa(&counterface), counterface.hardness_pa()), (276e6, Some(828e6)));
    assert_eq!(counterface.softer().unwrap().flows, Body::Counterface);
    assert_eq!(
        line(&counterface),
        "the counterface flows, which is the softer: its hardness is 828 MPa, that of the rough body 6.86 GPa"
    );
    let rough = both("yield_strength = \"205 MPa\"", "indentation_hardness = \"95 HBW\"");
    assert_eq!(strength_pa(&rough), 205e6);
    assert!(line(&rough).starts_with("the rough body flows, which is the softer"), "{}", line(&rough));
    let alone = both("", "yield_strength = \"276 MPa\"");
    assert_eq!(strength_pa(&alone), 276e6);
    assert_eq!(
        line(&alone),
        "the counterface flows, at a hardness of 828 MPa: the rough body was given no strength and is taken not to yield"
    );
    assert!(
        line(&both("yield_strength = \"1 GPa\"", "yield_strength = \"1 GPa\""))
            .starts_with("both bodies have")
    );
    // Where the counterface has no strength, nothing has changed.
    let before = both(hard, "");
    assert_eq!((before.softer(), line(&before)), (None, String::new()));
}

/// Every digit of four models that yield, for two bodies that are both as rough as the diamond.
fn yielding_curves(material: &str, counterface: &str) -> String {
    let models = ["elastic-plastic", "ep-sine", "ep-sphere", "persson-plastic"];
    let curves: String = models.iter().map(|model| format!("[[curve]]\nmodel = \"{model}\"\n")).collect();
    let text = format!(
        "[surface]\npsd = \"builtin:uncd-measured\"\n[material]\n{material}\n[counterface]\n{counterface}\n\
         [counterface.surface]\npsd = \"builtin:uncd-measured\"\n[loads]\npressures = [\"10 MPa\"]\n{curves}"
    );
    let scene = Scene::parse(&text, &NoFiles, &Overrides::default()).unwrap();
    format!("{:?}", scene.plan().compute().unwrap().curves)
}

#[test]
fn exchanging_the_names_of_two_equally_rough_bodies_changes_no_digit() {
    let body = |modulus, ratio, strength| {
        format!(
            "youngs_modulus = \"{modulus} GPa\"\npoisson_ratio = {ratio}\nyield_strength = \"{strength} GPa\""
        )
    };
    let glass = body(73.0, 0.17, 5.0);
    for gold in [body(78.0, 0.44, 0.2), body(78.0, 0.44, 4.5), body(200.0, 0.0, 5.2)] {
        assert_eq!(yielding_curves(&glass, &gold), yielding_curves(&gold, &glass), "{gold}");
    }
}

#[test]
fn the_smaller_critical_pressure_decides_not_the_smaller_strength() {
    // C(0.17) 5 GPa = 7.34 GPa is less than C(0.44) 4.5 GPa = 8.05 GPa.
    let scene = of_bodies(
        "[material]\nyoungs_modulus = \"73 GPa\"\npoisson_ratio = 0.17\nyield_strength = \"5 GPa\"\n\
         [counterface]\nyoungs_modulus = \"78 GPa\"\npoisson_ratio = 0.44\nyield_strength = \"4.5 GPa\"\n",
    )
    .unwrap();
    assert_eq!(scene.softer().unwrap().flows, Body::Rough);
    assert_eq!(strength_pa(&scene), 5e9);
    let line = scene.bodies.describe(scene.softer(), &scene.spreads).join("|");
    assert!(line.contains("Poisson's ratio lets the rough body yield"), "{line}");
}

#[test]
fn of_uncertain_strengths_the_medians_decide_and_the_softer_scatters() {
    let scene = of_bodies(&format!(
        "{STEEL}yield_strength = \"300 MPa +- 100 MPa\"\n{ALUMINIUM}yield_strength = \"276 MPa +- 10 %\"\n"
    ))
    .unwrap();
    assert_eq!(scene.softer().unwrap().flows, Body::Counterface);
    assert!((scene.spreads.strength.as_ref().unwrap().standard_uncertainty() - 0.1).abs() < 1e-9);
    let lines = scene.bodies.describe(scene.softer(), &scene.spreads);
    assert!(lines[0].ends_with("that of the rough body 900 MPa; medians decide, in every draw"), "{lines:?}");
}

#[test]
fn the_strain_gradient_length_is_that_of_the_body_that_flows() {
    let with = |own: &str, other: &str| {
        let sections = format!(
            "{STEEL}yield_strength = \"2 GPa\"\n{own}\n{ALUMINIUM}yield_strength = \"276 MPa\"\n{other}\n[loads]\n\
             pressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"elastic-plastic\"\nstrain_gradient = true\n"
        );
        let text = format!("[surface]\npsd = \"builtin:uncd-measured\"\n{sections}");
        Scene::parse(&text, &NoFiles, &Overrides::default())
    };
    let length = "strain_gradient_length = \"5 um\"";
    let scene = with("", length).unwrap();
    let strength = scene.needs.curves[0].model.strength().unwrap();
    assert_eq!(strength.strain_gradient_length_m(), Some(5e-6));
    assert!(with(length, "").unwrap_err().span.is_some());
    let missing = with("", "").unwrap_err();
    assert!(matches!(missing.problem, SceneProblem::Material(MaterialError::Missing(_))), "{missing}");
}

#[test]
fn a_counterface_that_yields_is_not_rigid_and_one_from_outside_has_no_strength() {
    for section in
        ["[counterface]\nyield_strength = \"1 GPa\"\n", &format!("{ALUMINIUM}yield_strength = \"1 H\"\n")]
    {
        assert!(of_bodies(&format!("{STEEL}yield_strength = \"1 GPa\"\n{section}")).is_err(), "{section}");
    }
    let text = format!(
        "[surface]\npsd = \"builtin:uncd-measured\"\n{STEEL}yield_strength = \"1 GPa\"\n[counterface]\nname = \"gold\"\n[loads]\n\
         pressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"elastic-plastic\"\n"
    );
    let parse = |overrides: &Overrides| Scene::parse(&text, &NoFiles, overrides).unwrap();
    assert_eq!(strength_pa(&parse(&Overrides::default())), 72e6);
    let body = asperity::ElasticBody::new(400e9, 0.2).unwrap();
    let replaced = parse(&Overrides { counterface: Some(body), ..Overrides::default() });
    assert_eq!(strength_pa(&replaced), 1e9);
    assert_eq!(replaced.bodies.counterface_transport, Transport::default());
}

#[test]
fn conductivity_and_resistivity_are_read_of_both_bodies() {
    let scene = of_bodies(&format!(
        "{STEEL}yield_strength = \"1 GPa\"\nthermal_conductivity = \"46 W/(m K)\"\nresistivity = \"22 µΩ cm\"\n[counterface]\n\
         name = \"copper, hard\"\nresistivity = \"1.72e-8 ohm m\"\n"
    ))
    .unwrap();
    let transport = |conductivity, resistivity| Transport {
        thermal_conductivity_w_per_m_k: Some(conductivity),
        resistivity_ohm_m: Some(resistivity),
    };
    assert_eq!(scene.bodies.transport, transport(46.0, 22e-8));
    assert_eq!(scene.bodies.counterface_transport, transport(401.0, 1.72e-8));
    for (key, value) in [("thermal_conductivity", "\"-46 W/(m K)\""), ("resistivity", "1e-8")] {
        let error = of_bodies(&format!("{STEEL}yield_strength = \"1 GPa\"\n{key} = {value}\n")).unwrap_err();
        assert_eq!(error.key().unwrap(), format!("material.{key}"));
    }
    // A rigid body may conduct.
    let rigid = of_bodies(&format!(
        "{STEEL}yield_strength = \"1 GPa\"\n[counterface]\nresistivity = \"1e-8 ohm m\"\n"
    ))
    .unwrap();
    assert!(rigid.material.unwrap().counterface().is_none());
}

#[test]
fn a_material_in_several_grades_is_refused_with_them() {
    for name in ["steel", "Stahl"] {
        let error = of_bodies(&format!("[material]\nname = \"{name}\"\n")).unwrap_err();
        let SceneProblem::UnknownValue { known, meant, .. } = &error.problem else { panic!("{error}") };
        assert_eq!((known.len(), meant), (3, &None), "{error}");
    }
}

#[test]
fn a_modulus_with_a_mistaken_prefix_is_refused() {
    let of_name = of_bodies("[material]\nname = \"steel C45\"\nyoungs_modulus = \"210 MPa\"\n").unwrap_err();
    assert!(
        matches!(&of_name.problem, SceneProblem::Value { key, .. } if key == "material.youngs_modulus"),
        "{of_name}"
    );
    let body = "[material]\nyoungs_modulus = \"210 MPa\"\npoisson_ratio = 0.3\nyield_strength = ";
    let of_strength = of_bodies(&format!("{body}\"1 GPa\"\n")).unwrap_err();
    assert!(
        matches!(
            &of_strength.problem,
            SceneProblem::Material(MaterialError::ModulusBelowStrength { yield_strength_pa, .. })
                if *yield_strength_pa == 1e9
        ),
        "{of_strength}"
    );
    let of_steel = of_bodies(&format!("{}\"300 GPa\"\n", body.replace("MPa", "GPa"))).unwrap_err();
    assert!(of_steel.to_string().contains("300 MPa"), "{of_steel}");
    assert!(of_strength.span.is_some() && of_bodies(&format!("{body}\"100 MPa\"\n")).is_ok());
}

#[test]
fn a_file_that_is_no_scene_is_named_as_what_it_is() {
    let content = |text: &str| match Scene::parse(text, &NoFiles, &Overrides::default()).unwrap_err().problem
    {
        SceneProblem::NotAScene(content) => content,
        other => panic!("{text}: {other}"),
    };
    assert_eq!(content("X (mm),Z (um)\n0,0.5\n0.1,0.25\n"), FileContent::Scan(ScanFormat::Text));
    assert_eq!(content("wavelength_m,C1D_m3\n1e-5,1e-20\n1e-6,1e-23\n"), FileContent::Spectrum);
    assert_eq!(content("<!DOCTYPE html>\n"), FileContent::Foreign(ForeignFile::WebPage));
    assert_eq!(FileContent::recognise(b"\x89PNG"), Some(FileContent::Foreign(ForeignFile::Picture("PNG"))));
    assert_eq!(FileContent::recognise(b"[surface]\npsd = \"a\"\n"), None);
}

#[test]
fn a_list_of_one_pressure_may_lack_its_brackets_only_with_advice() {
    let text = "[surface]\npsd = \"builtin:uncd-measured\"\n[loads]\npressures = \"1 MPa\"\n";
    let error = Scene::parse(text, &NoFiles, &Overrides::default()).unwrap_err();
    assert!(matches!(&error.problem, SceneProblem::WrongType { .. }), "{error}");
    assert!(error.to_string().contains("[\"1 MPa\"]"), "{error}");
}

#[test]
fn models_answer_to_the_names_that_reports_print() {
    let model = |name: &str| {
        let text = format!(
            "[surface]\npsd = \"builtin:uncd-measured\"\n{STEEL}[loads]\npressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"{name}\"\n"
        );
        Scene::parse(&text, &NoFiles, &Overrides::default()).map(|scene| scene.needs.curves[0].name.clone())
    };
    assert_eq!(model("GW").unwrap(), "hertz");
    assert_eq!(model("Persson's theory, elastic").unwrap(), "persson");
    assert!(model("rigid").is_err());
}
