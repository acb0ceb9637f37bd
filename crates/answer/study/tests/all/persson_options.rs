//! Persson's options in a plan, against the theory computed by hand.

use std::num::NonZeroU32;

use asperity::ElasticBody;
use persson::Band;
use persson::corrections::Correction;
use persson::hardness_laws::HardnessTable;
use persson::{EnergyFactor, PerssonModel};
use spectrum::{Normalisation, ProfilePsd};
use study::growth_law::GrowthLaw;
use study::hardness_and_strength::HardnessAndStrength;
use study::material::{GivenMaterial, Material};
use study::models::{Choice, MODELS, ModelEntry, ModelOptions};
use study::persson_law::PlasticLaw;
use study::plan::{Curve, CurveResult, Cutoffs, Load, Needs, NominalPressure, PlanError, Sampling};
use study::{Unobserved, gap_law, plan::Plan};

/// Spectrum of a hyperbola from 100 um to 10 nm.
fn spectrum() -> ProfilePsd {
    let wavelengths_m: Vec<f64> = (0..=40).map(|at| 1e-4 * 10f64.powf(-0.1 * f64::from(at))).collect();
    let c1d_m3 = |wavelength_m: &f64| 1e-22 * (wavelength_m / 1e-6).powf(2.4) / (1.0 + wavelength_m / 1e-5);
    let c1d_m3 = wavelengths_m.iter().map(c1d_m3).collect();
    ProfilePsd::new(wavelengths_m, c1d_m3).unwrap()
}

fn material(yield_strength: Option<&str>) -> Material {
    let strength = yield_strength.map(|text| text.parse().unwrap());
    Material::new(GivenMaterial {
        hardness_and_strength: HardnessAndStrength::new(None, strength).unwrap(),
        strength_cap: Some("40 GPa".parse().unwrap()),
        strain_gradient_length_m: Some(1e-7),
        ..GivenMaterial::new(ElasticBody::new(210e9, 0.3).unwrap())
    })
}

fn table() -> GrowthLaw {
    GrowthLaw::Table(HardnessTable::new([(1e-4, 3e9), (1e-6, 5e9), (1e-8, 30e9)]).unwrap())
}

fn entry(name: &str) -> &'static ModelEntry {
    MODELS.iter().find(|entry| entry.name == name).unwrap()
}

#[test]
fn a_curve_of_a_plan_and_its_stream_equal_the_theory_bit_for_bit() {
    let psd = spectrum();
    let strong = material(Some("0.7 GPa"));
    let elastic = |correction, band, gamma| {
        ("persson", ModelOptions { correction, band, gamma, ..ModelOptions::default() }, &strong)
    };
    let measured = material(None);
    let grows = |law: &GrowthLaw, material| {
        let options = ModelOptions { hardness_law: Some(law.clone()), ..ModelOptions::default() };
        ("persson-plastic", options, material)
    };
    let mut cases = vec![
        elastic(None, None, None),
        elastic(None, Some(Band::Profile), EnergyFactor::new(1.0).ok()),
        ("persson-plastic", ModelOptions::default(), &strong),
        grows(&GrowthLaw::NixGao, &strong),
        grows(&GrowthLaw::Power(0.3), &strong),
        grows(&table(), &strong),
        grows(&table(), &measured),
    ];
    cases.extend(Correction::ALL.iter().map(|correction| elastic(Some(*correction), None, None)));
    let per_decade = NonZeroU32::new(7);
    let samplings = [
        Sampling::default(),
        Sampling { scales_per_decade: per_decade, cutoff_m: Some(3.3e-7) },
        Sampling { scales_per_decade: None, cutoff_m: Some(3.3e-7) },
    ];
    for (sampling, (name, options, material)) in
        samplings.iter().flat_map(|sampling| cases.iter().map(move |case| (*sampling, case)))
    {
        let load = |pa| Load { nominal_pressure: NominalPressure::new(pa).unwrap(), label: String::new() };
        let model = entry(name).build(material, options).unwrap();
        let curve = Curve { name: String::new(), model, cutoffs: Cutoffs::Every };
        let needs = Needs {
            moments: Some(Normalisation::Parseval),
            amplitudes: Some(Default::default()),
            curves: vec![curve.clone()],
            loads: vec![load(1e6), load(3e8)],
            ..Needs::default()
        };
        let plan = Plan { psd: &psd, sampling, needs };
        let results = plan.compute().unwrap();

        let roughness =
            gap_law::roughness(&results, Normalisation::Parseval, options.band.unwrap_or_default());
        let contact_modulus_pa = material.pair.composite_modulus_pa();
        let theory = match *name {
            "persson" => PerssonModel::Elastic { contact_modulus_pa, correction: options.correction },
            _ => {
                let hardness = PlasticLaw::new(material, options).unwrap().hardness().unwrap();
                PerssonModel::ElasticPlastic { contact_modulus_pa, hardness }
            }
        };
        let gamma = options.gamma.unwrap_or_default();
        let separation = theory.separation(&roughness, gamma);
        let along = |pa| theory.along(&roughness, &separation, pa).unwrap();
        let by_hand = vec![along(1e6), along(3e8)];

        let CurveResult::Persson(cuts) = &results.curves[0] else { panic!("{name}") };
        assert_eq!(cuts.blocks, by_hand, "{name}, {options:?}, {sampling:?}");
        let mut streamed = Vec::new();
        let each = |part: study::plan::Part| {
            let CurveResult::Persson(cuts) = part.rows else { panic!("{name}") };
            streamed.extend(cuts.blocks);
            Ok::<(), PlanError>(())
        };
        plan.stream().unwrap().parts(&curve, &Unobserved, each).unwrap();
        assert_eq!(streamed, by_hand, "{name}, {options:?}, {sampling:?}");
    }
}

#[test]
fn every_option_changes_the_model_its_name_and_nothing_else() {
    let strong = material(Some("0.7 GPa"));
    for entry in MODELS.iter() {
        let plain = entry.build(&strong, &ModelOptions::default()).unwrap();
        assert_eq!(plain.options(), ModelOptions::default(), "{entry}");
        let mut ways = vec![
            ModelOptions { strain_gradient: true, ..ModelOptions::default() },
            ModelOptions { correction: Some(Correction::WangMuser), ..ModelOptions::default() },
            ModelOptions { band: Some(Band::Profile), ..ModelOptions::default() },
            ModelOptions { gamma: EnergyFactor::new(0.3).ok(), ..ModelOptions::default() },
            ModelOptions {
                interference_law: Some(stat_contact::InterferenceLaw::Bem),
                ..ModelOptions::default()
            },
        ];
        let laws = [GrowthLaw::Power(0.5), GrowthLaw::NixGao, table()];
        ways.extend(laws.map(|law| ModelOptions { hardness_law: Some(law), ..ModelOptions::default() }));
        for given in ways {
            let model = entry.build(&strong, &given).unwrap();
            let is_ignored = !given.ignored_by(entry).is_empty();
            assert_eq!(model == plain, is_ignored, "{entry}: {given:?}");
            assert_eq!(entry.curve_name(&given), entry.curve_name(&model.options()), "{entry}: {given:?}");
            assert_eq!(entry.curve_name(&given) == entry.name, is_ignored, "{entry}: {given:?}");
            // Other bodies and strengths keep the options.
            assert_eq!(model.with_pair(plain.pair()), model);
            if let Some(strength) = model.strength() {
                assert_eq!(model.with_strength(strength), Some(model.clone()), "{entry}: {given:?}");
            }
            let yields = entry.has(Choice::Strength);
            assert_eq!((model.strength().is_some(), model.hardness_pa().is_some()), (yields, yields));
        }
    }
}

#[test]
fn a_measured_hardness_stays_where_the_strength_is_drawn() {
    let options = ModelOptions { hardness_law: Some(table()), ..ModelOptions::default() };
    let model = entry("persson-plastic").build(&material(None), &options).unwrap();
    let drawn = model.with_strength(asperity::NixGao::constant(5e9).unwrap()).unwrap();
    assert_eq!(drawn.options(), options);
    assert!(model.strength_grows() && !model.needs_amplitudes());
}
