//! One question, answered through the struct and as a scene's curve. The answers and the names of all choices are written for the
//! tests of the Python package, which asks the questions once more and repeats the names as types.

use std::collections::BTreeMap;

use asperity::Hardness;
use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};
use interface::finite_elements::{Dialect, UnitSystem};
use measurements::Conventions;
use numerics::parallel::Unobserved;
use persson::Band;
use persson::EnergyFactor;
use persson::corrections::Correction;
use questions::{
    BodyInput, BranchChoice, CurveQuestion, GapModel, GapQuestion, LawForm, LawQuantity, LawQuestion,
    LoadInput, MaterialInput, NamedGas, PlasticCorrelation, PreparedCurve, QuestionError, SamplingInput,
};
use roughness::FormRemoval;
use scene::{Overrides, Scene, Template};
use serde_json::{Map, Value, json};
use spectrum::random_surfaces::Phases;
use spectrum::{Abscissa, AmplitudeDefinition, Convention, Normalisation, ReadOptions};
use stat_contact::InterferenceLaw;
use study::NoFiles;
use study::growth_law::GrowthLaw;
use study::models::{self, Choice, Framework, MODELS, ModelEntry, ModelOptions};
use study::plan::Tolerance;
use study::result_tables;
use study::surface::Surface;
use tables::{Cell, Cells, Table};
use topography::{Average, Detrend, Direction, GapTreatment, Window};
use units::{Length, Pressure, RemarkLevel};

const SPECTRUM: &str = "builtin:uncd-measured";

/// Random choices with a seed.
struct Dice(ChaCha8Rng);

impl Dice {
    fn below(&mut self, count: usize) -> usize {
        (self.0.next_u64() % count as u64) as usize
    }

    fn one<T: Clone>(&mut self, of: &[T]) -> T {
        of[self.below(of.len())].clone()
    }

    fn perhaps<T: Clone>(&mut self, of: &[T]) -> Option<T> {
        (self.below(2) == 0).then(|| self.one(of))
    }
}

/// A question, and a scene in which it is the only curve.
fn random(dice: &mut Dice) -> (CurveQuestion, String) {
    let entry = dice.one(&MODELS.iter().collect::<Vec<_>>());
    let (framework, yields) = (entry.framework, entry.has(Choice::Strength));
    let youngs_modulus_gpa = dice.one(&[1.0, 70.0, 463.0]);
    let poisson_ratio = dice.one(&[0.2, 0.33, 0.45]);
    let mut material = MaterialInput {
        youngs_modulus_pa: Some(youngs_modulus_gpa * 1e9),
        poisson_ratio: Some(poisson_ratio),
        ..MaterialInput::default()
    };
    let mut of_material =
        format!("youngs_modulus = \"{youngs_modulus_gpa} GPa\"\npoisson_ratio = {poisson_ratio}\n");
    // A strength above the modulus is refused.
    let strength_gpa = dice.one(&[0.5, 1.0, 60.0f64]).min(youngs_modulus_gpa);
    if yields || dice.below(3) == 0 {
        if dice.below(2) == 0 {
            material.yield_strength = Some(Pressure::Pascals(strength_gpa * 1e9));
            of_material += &format!("yield_strength = \"{strength_gpa} GPa\"\n");
        } else {
            material.indentation_hardness_pa = Some(strength_gpa * 1e9);
            of_material += &format!("indentation_hardness = \"{strength_gpa} GPa\"\n");
        }
    }
    let mut options = ModelOptions::default();
    let (mut of_curve, mut of_options) = (String::new(), String::new());
    if entry.has(Choice::StrainGradient) && dice.below(2) == 0 {
        options.strain_gradient = true;
        material.strain_gradient_length_m = Some(metres("5 um"));
        of_material += "strain_gradient_length = \"5 um\"\n";
        of_curve += "strain_gradient = true\n";
    }
    if entry.has(Choice::Hardness) {
        options.hardness = dice.perhaps(asperity::Hardness::ALL);
        of_options += &options
            .hardness
            .map_or(String::new(), |form| format!("hardness_formula = \"{}\"\n", form.name()));
    }
    if entry.has(Choice::Flattening) {
        options.flattening = dice.perhaps(stat_contact::Flattening::ALL);
        of_options += &options.flattening.map_or(String::new(), |held| format!("flattening = \"{held}\"\n"));
    }
    if entry.has(Choice::YieldingArea) {
        options.elastic_plastic_area = dice.perhaps(stacked_contact::YieldingAreaLaw::ALL);
        of_options += &options
            .elastic_plastic_area
            .map_or(String::new(), |law| format!("elastic_plastic_area = \"{law}\"\n"));
    }
    if entry.has(Choice::Interference) {
        options.interference_law = dice.perhaps(stat_contact::InterferenceLaw::ALL);
        of_curve +=
            &options.interference_law.map_or(String::new(), |law| format!("interference_law = \"{law}\"\n"));
    }
    if entry.has(Choice::Correction) {
        options.correction = dice.perhaps(Correction::ALL);
        of_curve += &options
            .correction
            .map_or(String::new(), |correction| format!("correction = \"{correction}\"\n"));
    }
    if framework == Framework::Persson {
        options.band = dice.perhaps(Band::ALL);
        options.gamma = dice.perhaps(&["0.4", "1", "fitted"]).map(|factor| factor.parse().unwrap());
        of_curve += &options.band.map_or(String::new(), |band| format!("band = \"{band}\"\n"));
        of_curve += &options.gamma.map_or(String::new(), |gamma| format!("gamma = {}\n", json!(gamma)));
    }
    if entry.has(Choice::HardnessLaw) && !options.strain_gradient && dice.below(2) == 0 {
        options.hardness_law = Some(GrowthLaw::Power(0.2));
        of_curve += "hardness_law = \"power:0.2\"\n";
    }
    let counterface = dice.perhaps(&[(210.0, 0.3), (3.0, 0.4)]);
    let mut sections = String::new();
    if let Some((modulus_gpa, poisson_ratio)) = counterface {
        material.counterface = Some(BodyInput { youngs_modulus_pa: modulus_gpa * 1e9, poisson_ratio });
        sections += &format!(
            "[counterface]\nyoungs_modulus = \"{modulus_gpa} GPa\"\npoisson_ratio = {poisson_ratio}\n"
        );
    }
    let mut pressures: Vec<LoadInput> = Vec::new();
    for _ in 0..=dice.below(2) {
        let pressure_pa = dice.one(&[1e3, 1e6, 5.4e6, 1e8, 1e9]);
        let load = LoadInput { pressure: Pressure::Pascals(pressure_pa), label: format!("{pressure_pa} Pa") };
        if !pressures.contains(&load) {
            pressures.push(load);
        }
    }
    let texts: Vec<String> = pressures.iter().map(|load| format!("\"{}\"", load.label)).collect();
    let mut sampling = SamplingInput { scales_per_decade: dice.perhaps(&[3, 7].map(count)), cutoff_m: None };
    of_options += &sampling.scales_per_decade.map_or(String::new(), |n| format!("scales_per_decade = {n}\n"));
    let normalisation = match framework {
        Framework::Statistical => dice.perhaps(Normalisation::ALL),
        _ => None,
    };
    of_options += &normalisation.map_or(String::new(), |norm| format!("normalisation = \"{norm}\"\n"));
    sampling.cutoff_m = dice.perhaps(&[metres("300 nm")]);
    sections += sampling.cutoff_m.map_or("", |_| "[cutoffs]\nshortest_wavelength = \"300 nm\"\n");
    let question = CurveQuestion {
        model: Some(entry),
        options,
        material,
        pressures,
        sampling,
        normalisation,
        ..CurveQuestion::default()
    };
    let scene = format!(
        "[surface]\npsd = \"{SPECTRUM}\"\n[material]\n{of_material}{sections}[loads]\npressures = [{}]\n\
         [options]\n{of_options}[[curve]]\nmodel = \"{entry}\"\n{of_curve}",
        texts.join(", ")
    );
    (question, scene)
}

fn metres(text: &str) -> f64 {
    text.parse::<Length>().unwrap().m
}

fn count(count: u32) -> std::num::NonZeroU32 {
    std::num::NonZeroU32::new(count).unwrap()
}

#[test]
fn two_hundred_random_questions_have_the_same_digits_notes_and_doubts_as_curves_of_scenes() {
    let mut dice = Dice(ChaCha8Rng::seed_from_u64(23));
    let surface = Surface::load(SPECTRUM, &NoFiles, &ReadOptions::default()).unwrap();
    let (mut answered, mut doubted) = (0, 0);
    let mut for_python = Vec::new();
    for at in 0..200 {
        let (question, text) = random(&mut dice);
        let written = serde_json::to_value(&question).unwrap();
        let question: CurveQuestion = serde_json::from_value(written.clone()).unwrap();
        let scene = Scene::parse(&text, &NoFiles, &Overrides::default())
            .unwrap_or_else(|error| panic!("{at}: {error:?}\n{text}"));
        let of_scene = PreparedCurve::of_scene(&scene, 0).answer(&Unobserved);
        match (question.answer(&surface, &Unobserved), of_scene) {
            (Ok(asked), Ok(found)) => {
                assert_eq!(format!("{:?}", asked.table), format!("{:?}", found.table), "{at}: {text}");
                assert_eq!(asked.notes, found.notes, "{at}: {text}");
                let results = scene.plan().compute().unwrap();
                let table = result_tables::curve(&results.curves[0], &scene.needs.loads, false);
                assert_eq!(format!("{:?}", asked.table), format!("{table:?}"), "{at}: {text}");
                let facts: Vec<String> = asked.notes.iter().map(|note| format!("{note:?}")).collect();
                for_python
                    .push(json!({ "question": written, "columns": columns(&asked.table), "facts": facts }));
                answered += 1;
                doubted += usize::from(asked.notes.iter().any(|note| note.level == RemarkLevel::Caution));
            }
            (Err(asked), Err(found)) => {
                assert_eq!(asked.to_string(), found.to_string(), "{at}: {text}");
                for_python.push(json!({ "question": written }));
            }
            (asked, found) => panic!("{at}: {:?} and {:?}\n{text}", asked.err(), found.err()),
        }
    }
    assert!(answered > 150 && doubted > 20, "{answered} answered, {doubted} doubted");
    write_for_python("questions.json", &json!(for_python));
}

#[test]
fn every_name_of_a_choice_is_unique() {
    let entries = |entries: &mut dyn Iterator<Item = &ModelEntry>| entries.map(|entry| entry.name).collect();
    let mut known = BTreeMap::<&str, Vec<&str>>::from([
        ("StackedModel", entries(&mut models::of_framework(Framework::Stacked))),
        ("StatisticalModel", entries(&mut models::of_framework(Framework::Statistical))),
        ("PerssonModel", entries(&mut models::of_framework(Framework::Persson))),
        ("CurveModel", entries(&mut MODELS.iter())),
        ("LawModel", entries(&mut models::with_gaps())),
    ]);
    macro_rules! add {
        ($($key:literal: $choice:ty),+ $(,)?) => {
            $(known.insert($key, <$choice>::ALL.iter().map(|one| one.name()).collect());)+
        };
    }
    add!(
        "HardnessFormula": Hardness, "Band": Band, "Correction": Correction, "InterferenceLaw": InterferenceLaw,
        "Flattening": stat_contact::Flattening, "SummitHeights": stat_contact::SummitHeights, "YieldingAreaLaw": stacked_contact::YieldingAreaLaw,
        "Normalisation": Normalisation, "AmplitudeDefinition": AmplitudeDefinition, "Convention": Convention,
        "Abscissa": Abscissa, "Detrend": Detrend, "Window": Window, "Average": Average, "Gaps": GapTreatment,
        "Direction": Direction, "Phases": Phases, "Dialect": Dialect, "UnitSystem": UnitSystem, "LawForm": LawForm,
        "LawQuantity": LawQuantity, "Gas": NamedGas, "ConductanceCorrelation": PlasticCorrelation, "Form": FormRemoval,
        "Conventions": Conventions, "Template": Template, "Branch": BranchChoice,
        "Compliance": elements::SpecimenCompliance,
    );
    #[cfg(feature = "transport")]
    add!("FlowEdges": questions::flow::FlowEdges);
    // Checks that were passed are not shown.
    known.insert("NoteLevel", RemarkLevel::ALL[1..].iter().map(|level| level.name()).collect());
    for names in known.values() {
        assert!(names.iter().enumerate().all(|(at, name)| !names[..at].contains(name)), "{names:?}");
    }
    write_for_python("choices.json", &json!(known));
}

/// Writes a file that the tests of the Python package read.
fn write_for_python(name: &str, content: &Value) {
    let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(path, content.to_string()).unwrap();
}

/// The columns of a table by their names; null where a cell is empty.
fn columns(table: &Table) -> Map<String, Value> {
    let value = |cells: &Cells| match cells {
        Cells::Numbers(numbers) => json!(numbers),
        Cells::Words(words) => json!(words),
        Cells::Typed(cells) => json!(cells.iter().map(Cell::text).collect::<Vec<_>>()),
    };
    table.columns().map(|(name, cells)| (name.to_owned(), value(cells))).collect()
}

#[test]
fn a_tolerance_is_refused_by_gaps_and_laws_without_statistical_states() {
    let material = MaterialInput {
        youngs_modulus_pa: Some(463e9),
        poisson_ratio: Some(0.2),
        ..MaterialInput::default()
    };
    let pressures = vec![LoadInput { pressure: Pressure::Pascals(1e6), label: "1 MPa".to_owned() }];
    for model in models::with_gaps().map(Some).chain([None]) {
        let by = GapModel {
            model,
            material,
            tolerance: Some(Tolerance::new(1e-6).unwrap()),
            ..GapModel::default()
        };
        let is_statistical = model.is_some_and(|entry| entry.framework == Framework::Statistical);
        let gap = GapQuestion { by: by.clone(), pressures: pressures.clone(), ..GapQuestion::default() };
        let law = LawQuestion { by, ..LawQuestion::default() };
        for checked in [gap.check(), law.check()] {
            assert_eq!(matches!(checked, Err(QuestionError::Unused(_))), !is_statistical, "{model:?}");
        }
    }
}

#[test]
fn every_option_that_a_model_ignores_is_found_and_none_that_it_heeds() {
    let given = [
        ModelOptions { strain_gradient: true, ..ModelOptions::default() },
        ModelOptions { hardness: Some(asperity::Hardness::Cosine), ..ModelOptions::default() },
        ModelOptions {
            interference_law: Some(stat_contact::InterferenceLaw::Bem),
            ..ModelOptions::default()
        },
        ModelOptions {
            summit_heights: Some(stat_contact::SummitHeights::Exponential),
            ..ModelOptions::default()
        },
        ModelOptions { correction: Correction::ALL.first().copied(), ..ModelOptions::default() },
        ModelOptions { band: Some(Band::Profile), ..ModelOptions::default() },
        ModelOptions { gamma: EnergyFactor::new(0.4).ok(), ..ModelOptions::default() },
        ModelOptions { hardness_law: Some(GrowthLaw::Power(0.2)), ..ModelOptions::default() },
    ];
    let material = MaterialInput {
        youngs_modulus_pa: Some(463e9),
        poisson_ratio: Some(0.2),
        yield_strength: Some(Pressure::Pascals(1.8e9)),
        strain_gradient_length_m: Some(5e-6),
        ..MaterialInput::default()
    };
    for entry in MODELS.iter() {
        let asked = |change: &dyn Fn(&mut CurveQuestion)| {
            let mut question = CurveQuestion {
                model: Some(entry),
                material,
                pressures: vec![LoadInput { pressure: Pressure::Pascals(1e6), label: "1 MPa".to_owned() }],
                ..CurveQuestion::default()
            };
            change(&mut question);
            matches!(question.check(), Err(QuestionError::Unused(_)))
        };
        assert!(!asked(&|_| ()), "{entry}");
        for options in &given {
            let choice = options.given().next().unwrap();
            let is_refused = asked(&|question| question.options = options.clone());
            assert_eq!(is_refused, !entry.has(choice), "{entry} {choice:?}");
        }
        let of = |framework| entry.framework == framework;
        let statistical = of(Framework::Statistical);
        assert_eq!(asked(&|question| question.normalisation = Some(Normalisation::Parseval)), !statistical);
        assert_eq!(
            asked(&|question| question.tolerance = Some(Tolerance::new(1e-6).unwrap())),
            !statistical,
            "{entry}"
        );
        assert_eq!(asked(&|question| question.separations_m = vec![1e-9]), !statistical, "{entry}");
        let is_refused = asked(&|question| question.amplitude = Some(AmplitudeDefinition::Parseval));
        assert_eq!(is_refused, !of(Framework::Stacked), "{entry}: no hardness grows by nix-gao");
        let cap = |question: &mut CurveQuestion| {
            question.material.strength_cap = Some(Pressure::Pascals(3e9));
        };
        assert!(asked(&cap), "{entry}: nothing grows");
        let grows = asked(&|question| {
            cap(question);
            question.options.strain_gradient = entry.has(Choice::StrainGradient);
        });
        assert_eq!(grows, !entry.has(Choice::Strength), "{entry}");
    }
}
