//! Bodies, layers and loads of a question, and a report on them.

use questions::{
    BodyInput, BodyText, LayerInput, LoadInput, MaterialInput, QuestionError, ReportQuestion, ReportSurface,
};
use scene::{Overrides, Scene, SceneText};
use study::bodies::Body;
use study::growth_law::GrowthLaw;
use study::layer_base::LayerBase;
use study::materials;
use study::models::ModelOptions;
use study::surface::SurfaceError;
use units::{Pressure, RemarkCode};

use crate::common::{STEEL_MODULUS_PA, assert_near, hard, missing, steel, unused};

const SOFT: BodyInput = BodyInput { youngs_modulus_pa: 100e9, poisson_ratio: 0.25 };

fn layer() -> LayerInput {
    LayerInput {
        thickness_m: Some(1e-6),
        youngs_modulus_pa: Some(400e9),
        poisson_ratio: Some(0.2),
        base: LayerBase::Material,
    }
}

#[test]
fn properties_that_are_not_given_come_from_the_table_of_materials() {
    let [steel, copper] = ["100Cr6", "annealed copper"].map(|name| materials::named(name).unwrap());
    let filled = |given: MaterialInput| given.filled_from(Some(&steel), Some(&copper));
    let all = filled(MaterialInput::default());
    assert_eq!((all.youngs_modulus_pa, all.poisson_ratio), (Some(210e9), Some(0.3)));
    // 700 HV, and a modulus of copper above 100 GPa.
    let hardness_pa = all.indentation_hardness_pa.unwrap();
    assert!((6.8e9..7.6e9).contains(&hardness_pa) && all.yield_strength.is_none(), "{hardness_pa}");
    assert!((100e9..140e9).contains(&all.counterface.unwrap().youngs_modulus_pa));
    let of_counterface = (all.counterface_yield_strength, all.counterface_indentation_hardness_pa);
    assert_ne!(of_counterface, (None, None));
    // A strength of one's own replaces the hardness of the table, and the reverse.
    let strength = Some(Pressure::Pascals(1e9));
    let strong = filled(MaterialInput { yield_strength: strength, ..MaterialInput::default() });
    assert_eq!((strong.yield_strength, strong.indentation_hardness_pa), (strength, None));
    let hard = filled(MaterialInput { indentation_hardness_pa: Some(1e9), ..MaterialInput::default() });
    assert_eq!((hard.yield_strength, hard.indentation_hardness_pa), (None, Some(1e9)));
    for given in [
        MaterialInput { counterface_yield_strength: strength, ..MaterialInput::default() },
        MaterialInput { counterface_indentation_hardness_pa: Some(1e9), ..MaterialInput::default() },
    ] {
        let found = filled(given);
        let keys =
            |of: MaterialInput| (of.counterface_yield_strength, of.counterface_indentation_hardness_pa);
        assert_eq!(keys(found), keys(given));
    }
    // Under a layer they would be the layer's.
    let layered = filled(MaterialInput { layer: Some(layer()), ..MaterialInput::default() });
    assert_eq!((layered.youngs_modulus_pa, layered.indentation_hardness_pa), (Some(210e9), None));
    let own = MaterialInput { counterface: Some(SOFT), ..crate::common::steel() };
    assert_eq!((filled(own).youngs_modulus_pa, filled(own).counterface), (Some(200e9), Some(SOFT)));
    assert_eq!(own.filled_from(None, None), own);
}

#[test]
fn properties_of_a_growing_strength_are_left_out_where_nothing_grows() {
    let given = MaterialInput {
        strain_gradient_length_m: Some(1e-6),
        strength_cap: Some(Pressure::Pascals(4e9)),
        ..hard(3e9)
    };
    let [gradient, law] = [
        ModelOptions { strain_gradient: true, ..ModelOptions::default() },
        ModelOptions { hardness_law: Some(GrowthLaw::Power(0.2)), ..ModelOptions::default() },
    ];
    assert_eq!([given.used_with(&gradient), given.used_with(&law)], [given; 2]);
    assert_eq!(given.used_with(&ModelOptions::default()), hard(3e9));
}

#[test]
fn a_material_has_the_bodies_the_strength_and_the_growth_that_are_given() {
    let given = MaterialInput {
        counterface: Some(SOFT),
        strain_gradient_length_m: Some(1e-6),
        strength_cap: Some(Pressure::Pascals(4e9)),
        ..hard(3e9)
    };
    let material = given.material().unwrap();
    let other = 100e9 / (1.0 - 0.25 * 0.25);
    assert_near(material.pair.composite_modulus_pa(), 1.0 / (1.0 / STEEL_MODULUS_PA + 1.0 / other), 1e-12);
    assert_eq!((material.hardness_pa(), material.assumed_yield_strength_pa()), (Some(3e9), Some(1e9)));
    assert_eq!((material.strength_cap_pa(), material.strain_gradient_length_m()), (Some(4e9), Some(1e-6)));
    let rigid = steel().material().unwrap();
    assert_near(rigid.pair.composite_modulus_pa(), STEEL_MODULUS_PA, 1e-12);
    assert!(rigid.hardness_pa().is_none() && rigid.softer().is_none());
    let body = BodyInput { youngs_modulus_pa: 200e9, poisson_ratio: 0.3 };
    assert_eq!((steel().body(), MaterialInput::default().body()), (Some(body), None));
    assert!(steel().counterface().unwrap().is_none());
    assert_eq!(given.counterface().unwrap().unwrap().youngs_modulus_pa(), 100e9);
    for lacking in [
        MaterialInput { youngs_modulus_pa: None, ..steel() },
        MaterialInput { poisson_ratio: None, ..steel() },
    ] {
        assert!(matches!(lacking.material(), Err(QuestionError::ElasticConstant(_))));
    }
    let rubber = MaterialInput { poisson_ratio: Some(0.6), ..steel() };
    assert!(matches!(rubber.material(), Err(QuestionError::Value { option: "poisson_ratio", .. })));
    let impossible = MaterialInput { counterface: Some(BodyInput { poisson_ratio: 0.6, ..SOFT }), ..steel() };
    assert!(matches!(
        impossible.material(),
        Err(QuestionError::Value { option: "counterface_poisson_ratio", .. })
    ));
    let contradictory = MaterialInput { yield_strength: Some(Pressure::Pascals(2e9)), ..hard(3e9) };
    assert!(matches!(contradictory.material(), Err(QuestionError::Material(_))));
}

#[test]
fn the_softer_body_yields() {
    let pair = |own_pa: Option<f64>, other_pa: Option<f64>| MaterialInput {
        indentation_hardness_pa: own_pa,
        counterface: Some(SOFT),
        counterface_indentation_hardness_pa: other_pa,
        ..steel()
    };
    for (own_pa, other_pa, hardness_pa, counterface_yields) in [
        (Some(3e9), Some(1e9), Some(1e9), true),
        (Some(1e9), Some(3e9), Some(1e9), false),
        (Some(1e9), None, Some(1e9), false),
        (None, None, None, false),
    ] {
        let given = pair(own_pa, other_pa);
        let material = given.material().unwrap();
        assert_eq!(material.hardness_pa(), hardness_pa);
        assert_eq!(given.counterface_yields().unwrap(), counterface_yields);
        assert_eq!(material.flows() == Body::Counterface, counterface_yields);
        assert_eq!(material.softer().is_some(), other_pa.is_some());
    }
    let layered = MaterialInput { layer: Some(layer()), ..pair(Some(3e9), Some(1e9)) };
    assert!(layered.counterface_yields().unwrap());
    assert!(!MaterialInput::default().counterface_yields().unwrap());
    let out = MaterialInput { poisson_ratio: Some(0.6), ..pair(Some(3e9), Some(1e9)) };
    assert!(matches!(out.counterface_yields(), Err(QuestionError::Value { .. })));
}

#[test]
fn a_layer_lies_on_the_rough_body_or_on_a_rigid_base() {
    assert_eq!((LayerInput::default().given(), layer().given()), (None, Some(layer())));
    let on = |layer: LayerInput, body: MaterialInput| MaterialInput { layer: Some(layer), ..body }.material();
    let nothing = MaterialInput::default();
    let material = on(layer(), steel()).unwrap();
    let found = material.pair.layer().unwrap();
    assert_eq!((found.body().youngs_modulus_pa(), found.thickness_m()), (400e9, 1e-6));
    assert_eq!(found.base().map(|base| base.youngs_modulus_pa()), Some(200e9));
    // The layer carries the roughness.
    assert_near(material.pair.composite_modulus_pa(), 400e9 / 0.96, 1e-12);
    let rigid = LayerInput { base: LayerBase::Rigid, ..layer() };
    assert!(on(rigid, nothing).unwrap().pair.layer().unwrap().base().is_none());
    for (body, option) in
        [(steel(), "youngs_modulus"), (MaterialInput { youngs_modulus_pa: None, ..steel() }, "poisson_ratio")]
    {
        assert_eq!(unused(on(rigid, body)).as_deref(), Some(option));
    }
    assert_eq!(missing(on(layer(), nothing)), ["youngs_modulus", "layer_base"]);
    let half = MaterialInput { poisson_ratio: None, ..steel() };
    assert!(matches!(on(layer(), half), Err(QuestionError::ElasticConstant("poisson_ratio"))));
    for (lacking, option) in [
        (LayerInput { thickness_m: None, ..layer() }, "layer_thickness"),
        (LayerInput { youngs_modulus_pa: None, ..layer() }, "layer_youngs_modulus"),
        (LayerInput { poisson_ratio: None, ..layer() }, "layer_poisson_ratio"),
    ] {
        assert_eq!(missing(on(lacking, steel())), [option]);
    }
    for (bad, named) in [
        (LayerInput { thickness_m: Some(-1.0), ..layer() }, "layer_thickness"),
        (LayerInput { youngs_modulus_pa: Some(-1.0), ..layer() }, "layer_youngs_modulus"),
        (LayerInput { poisson_ratio: Some(-0.1), ..layer() }, "layer_poisson_ratio"),
    ] {
        assert!(matches!(on(bad, steel()), Err(QuestionError::Value { option, .. }) if option == named));
    }
}

#[test]
fn a_load_keeps_the_words_it_was_typed_in() {
    let load: LoadInput = " 5 kPa ".parse().unwrap();
    assert_eq!((load.pressure, load.label.as_str()), (Pressure::Pascals(5e3), "5 kPa"));
    let pull = LoadInput::parse_signed(" -5kPa ").unwrap();
    assert_eq!((pull.pressure, pull.label.as_str()), (Pressure::Pascals(-5e3), "-5kPa"));
    assert!("-5 kPa".parse::<LoadInput>().is_err() && "5".parse::<LoadInput>().is_err());
}

#[test]
fn an_error_of_another_kind_is_no_cancellation() {
    let remark = units::Remark::new(RemarkCode::Replaced);
    for error in
        [QuestionError::Unused(Box::new(remark)), QuestionError::NoLoop, QuestionError::NothingScatters]
    {
        assert!(!error.is_cancelled());
    }
}

#[test]
fn a_body_is_written_into_a_scene_and_read_from_one() {
    assert!(BodyText::default().is_empty());
    // Numbers are typed without quotes.
    let body: BodyText =
        toml::from_str("youngs_modulus = \"200 GPa\"\npoisson_ratio = 0.3\nconductivity = 1\n").unwrap();
    assert!(!body.is_empty());
    assert_eq!(
        (body.youngs_modulus.as_deref(), body.poisson_ratio.as_deref()),
        (Some("200 GPa"), Some("0.3"))
    );
    let mut text = SceneText::default();
    body.write("material", &mut text).unwrap();
    let table: toml::Table = text.to_string().parse().unwrap();
    assert_eq!(table["material"]["poisson_ratio"].as_float(), Some(0.3));
    assert_eq!(table["material"]["youngs_modulus"].as_str(), Some("200 GPa"));
    // A ratio with an uncertainty stays text.
    let spread = BodyText { poisson_ratio: Some("0.3 +- 0.02".to_owned()), ..body };
    spread.write("material", &mut text).unwrap();
    let table: toml::Table = text.to_string().parse().unwrap();
    assert_eq!(table["material"]["poisson_ratio"].as_str(), Some("0.3 +- 0.02"));
}

#[test]
fn a_report_asks_for_the_interface_of_known_bodies_for_a_seal_and_for_its_cap() {
    let section = |material: BodyText, seal: bool| {
        let question = ReportQuestion {
            surface: ReportSurface::Psd("builtin:uncd-measured".to_owned()),
            material,
            pressures: vec!["10 MPa".to_owned()],
            seal,
            strength_cap: Some("4 GPa".to_owned()),
            ..ReportQuestion::default()
        };
        let table: toml::Table = question.scene_text().parse().unwrap();
        assert_eq!(table["options"]["strength_cap"].as_str(), Some("4 GPa"));
        (table.contains_key("interface"), table.contains_key("seal"))
    };
    let text = |text: &str| Some(text.to_owned());
    assert_eq!(section(BodyText::default(), false), (false, false));
    assert_eq!(section(BodyText { name: text("100Cr6"), ..BodyText::default() }, true), (true, true));
    assert_eq!(
        section(BodyText { youngs_modulus: text("200 GPa"), ..BodyText::default() }, false),
        (true, false)
    );
}

#[test]
fn lengths_of_a_scan_reach_the_scene_of_its_report() {
    let heights: String = (0..200).map(|at| format!("{}\n", (at * at) % 7)).collect();
    let files = std::collections::BTreeMap::from([("line.txt".to_owned(), heights.into_bytes())]);
    let question = ReportQuestion {
        surface: ReportSurface::Scans(vec!["line.txt:unit=um,size=400um,shortest=5um".parse().unwrap()]),
        material: BodyText { name: Some("100Cr6".to_owned()), ..BodyText::default() },
        pressures: vec!["10 MPa".to_owned()],
        ..ReportQuestion::default()
    };
    let scene = Scene::parse(&question.scene_text(), &files, &Overrides::default()).unwrap();
    let psd = &scene.surface.psd;
    assert!((4.9e-6..7e-6).contains(&psd.shortest_wavelength_m()), "{}", psd.shortest_wavelength_m());
    assert!((1e-4..4.1e-4).contains(&psd.longest_wavelength_m()), "{}", psd.longest_wavelength_m());
    let of_files = ReportSurface::of_files(vec!["line.txt:unit=um".parse().unwrap()], &files).unwrap();
    assert!(matches!(of_files, ReportSurface::Scans(scans) if scans.len() == 1));
    for (rows, at) in [("1e-4,1e-20\n1e-5,-1e-23", 3), ("1e-4,1e-20\n1e-4,1e-23", 3), ("1e-4,1e-20\n1e-5", 3)]
    {
        let text = format!("wavelength_m,C1D_m3\n{rows}\n").into_bytes();
        let files = std::collections::BTreeMap::from([("psd.csv".to_owned(), text)]);
        let refused = ReportSurface::of_files(vec!["psd.csv".parse().unwrap()], &files).unwrap_err();
        assert!(
            matches!(&refused, SurfaceError::Spectrum { error, .. } if error.line() == Some(at)),
            "{refused}"
        );
    }
}
