//! A contact whose real pressure exceeds the hardness: every question that presses it says so, and none below the hardness.

use std::collections::BTreeMap;

use elements::IndenterShape;
use numerics::parallel::Unobserved;
use questions::rows::{RowRoughness, StateRequest};
use questions::{
    AdhesionQuestion, CurveQuestion, ElementsLoad, ElementsQuestion, GapModel, GapQuestion, IndenterQuestion,
    LawAnswer, LawQuantity, LawQuestion, LawTableQuestion, LoadInput, MaterialInput, QuestionError,
    RandomInput, StatesQuestion, TangentialQuestion, TransportInput,
};
use spectrum::ReadOptions;
use stat_contact::Condition;
use study::models::{Choice, Framework, MODELS, ModelEntry};
use study::surface::Surface;
use units::{Pressure, PressureRange, Remark, RemarkCode, SceneKeys};

const SILVER_PA: f64 = 251e6;
const PRESSURE_PA: f64 = 200e6;

fn silver(hardness_pa: f64) -> MaterialInput {
    MaterialInput {
        youngs_modulus_pa: Some(83e9),
        poisson_ratio: Some(0.37),
        indentation_hardness_pa: Some(hardness_pa),
        ..MaterialInput::default()
    }
}

fn surface() -> Surface {
    let row = |i: i32| {
        let wavelength_m = 1e-4 * 10f64.powf(f64::from(-i) / 10.0);
        format!("{wavelength_m:e},{:e}\n", 2e-23 * (wavelength_m / 1e-6).powf(2.6))
    };
    let text = format!("wavelength_m,C1D_m3\n{}", (0..=20).map(row).collect::<String>());
    let files = BTreeMap::from([("rough.csv".to_owned(), text.into_bytes())]);
    Surface::load("rough.csv", &files, &ReadOptions::default()).unwrap()
}

fn random() -> RandomInput {
    RandomInput { grid: Some(64), realisations: Some(1), shortest_m: Some(8e-6), ..RandomInput::default() }
}

fn loads() -> Vec<LoadInput> {
    vec![LoadInput { pressure: Pressure::Pascals(PRESSURE_PA), label: "200 MPa".to_owned() }]
}

fn gap_model(model: Option<&'static ModelEntry>, hardness_pa: f64) -> GapModel {
    GapModel { model, material: silver(hardness_pa), ..GapModel::default() }
}

/// Asks every question of a material of a hardness \[Pa\], and returns its notes with its name.
fn said(hardness_pa: f64) -> Vec<(String, Result<Vec<Remark>, QuestionError>)> {
    let (surface, material) = (surface(), silver(hardness_pa));
    let mut said = Vec::new();
    for entry in MODELS.iter() {
        let curve =
            CurveQuestion { model: Some(entry), material, pressures: loads(), ..CurveQuestion::default() };
        said.push((format!("curve {entry}"), curve.answer(&surface, &Unobserved).map(|answer| answer.notes)));
        if entry.framework == Framework::Stacked {
            continue;
        }
        let by = gap_model(Some(entry), hardness_pa);
        let gap = GapQuestion { by: by.clone(), pressures: loads(), ..GapQuestion::default() };
        said.push((format!("gap {entry}"), gap.answer(&surface, &Unobserved).map(|answer| answer.notes)));
        let law =
            LawQuestion { by: by.clone(), from: Pressure::Pascals(1e6), to: Pressure::Pascals(PRESSURE_PA) };
        let transport = TransportInput {
            thermal_conductivity_w_per_m_k: Some(400.0),
            counterface_thermal_conductivity_w_per_m_k: Some(400.0),
            ..TransportInput::default()
        };
        for (quantity, transport) in
            [(LawQuantity::Pressure, TransportInput::default()), (LawQuantity::Heat, transport)]
        {
            let question =
                LawTableQuestion { law: law.clone(), quantity, transport, ..LawTableQuestion::default() };
            let notes = question.answer(&surface, &Unobserved).map(|answer| {
                let (notes, lines) = match answer {
                    LawAnswer::Pressure(found) => (found.notes.clone(), found.description(&SceneKeys)),
                    LawAnswer::Conductance(found) => (found.notes.clone(), found.description(&SceneKeys)),
                };
                let caution = |note: &Remark| note.words(&SceneKeys);
                for note in notes.iter().filter(|note| note.code == RemarkCode::RealAboveHardness) {
                    assert!(lines.iter().any(|line| line.contains(&caution(note))), "{lines:?}");
                }
                notes
            });
            said.push((format!("law {quantity} {entry}"), notes));
        }
        if !entry.has(Choice::Strength) {
            let sheared = TangentialQuestion {
                by,
                friction: Some(0.3),
                pressures: loads(),
                ..TangentialQuestion::default()
            };
            let notes = sheared.answer(&surface, &Unobserved).map(|answer| answer.notes);
            said.push((format!("tangential {entry}"), notes));
        }
    }
    let by = gap_model(None, hardness_pa);
    let sheared = TangentialQuestion {
        by: by.clone(),
        friction: Some(0.3),
        pressures: loads(),
        random: random(),
        ..TangentialQuestion::default()
    };
    said.push((
        "tangential bem".to_owned(),
        sheared.answer(&surface, &Unobserved).map(|answer| answer.notes),
    ));
    let gap = GapQuestion { by, pressures: loads(), random: random(), ..GapQuestion::default() };
    said.push(("gap bem".to_owned(), gap.answer(&surface, &Unobserved).map(|answer| answer.notes)));
    for saturation in [None, Some(Pressure::Hardnesses(1.0))] {
        let flat = ElementsQuestion {
            material,
            loads: loads().into_iter().map(ElementsLoad::Pressure).collect(),
            saturation,
            random: random(),
            ..ElementsQuestion::default()
        };
        let pressed = flat.on(&surface).and_then(|flat| {
            flat.answer::<elements::ElementsError>(|_| Ok(()), &Unobserved).map_err(QuestionError::from)
        });
        said.push((format!("bem {saturation:?}"), pressed.map(|(_, notes)| notes)));
    }
    for (shape, force) in [(IndenterShape::Ball, 0.02), (IndenterShape::Cylinder, 1e3)] {
        let indenter = IndenterQuestion {
            material,
            shape,
            radius_m: 1e-3,
            force,
            random: random(),
            ..IndenterQuestion::default()
        };
        let notes =
            indenter.on(&surface).and_then(|flat| flat.answer(&Unobserved)).map(|answer| answer.notes);
        said.push((format!("bem {shape}"), notes));
    }
    let adhesive = AdhesionQuestion {
        material,
        pressure_ranges: vec!["100 MPa:200 MPa:2".parse::<PressureRange>().unwrap()],
        work_of_adhesion_j_per_m2: 0.05,
        range_m: 2e-9,
        random: random(),
        ..AdhesionQuestion::default()
    };
    let notes = adhesive.on(&surface).and_then(|flat| flat.answer(&Unobserved)).map(|answer| answer.notes);
    said.push(("bem adhesive".to_owned(), notes));
    said
}

/// Returns true if a question counts the yielding.
fn yields(question: &str) -> bool {
    let model = question.rsplit(' ').next().unwrap();
    question.contains("Some(")
        || question == "gap bem"
        || MODELS.iter().any(|entry| entry.name == model && entry.has(Choice::Strength))
}

#[test]
fn whatever_presses_a_contact_that_yields_says_so() {
    let said = said(SILVER_PA);
    assert!(said.len() > 40, "{}", said.len());
    for (question, notes) in said {
        let notes = notes.unwrap_or_else(|error| panic!("{question}: {error}"));
        let doubt = notes.iter().find(|note| note.code == RemarkCode::RealAboveHardness);
        if !yields(&question) {
            let doubt = doubt.unwrap_or_else(|| panic!("{question} is silent: {notes:?}"));
            assert_eq!(doubt.number("hardness_pa"), Some(SILVER_PA), "{question}");
            assert!(doubt.number("in_hardnesses").unwrap() > 1.0, "{question}");
        }
    }
}

#[test]
fn no_question_doubts_a_contact_below_its_hardness() {
    for (question, notes) in said(1e15) {
        let notes = notes.unwrap_or_else(|error| panic!("{question}: {error}"));
        assert!(notes.iter().all(|note| note.code != RemarkCode::RealAboveHardness), "{question}: {notes:?}");
    }
}

#[test]
fn rows_of_populations_count_pressures_above_the_hardness() {
    let counted = |model: &str, hardness_pa: f64| {
        let material = silver(hardness_pa).material().unwrap();
        let entry = MODELS.iter().find(|entry| entry.name == model).unwrap();
        let question = StatesQuestion { model: Some(entry), ..StatesQuestion::default() };
        let asked = |row: usize| StateRequest {
            material: &material,
            // Sharper asperities press harder.
            roughness: RowRoughness([10f64.powi(-3 - row as i32), 1e12, 1e-8]),
            at: Condition::Pressure(1e3),
        };
        let (_, found) = question.states().unwrap().compute(8, asked, &Unobserved).unwrap();
        let notes = question.notes_on(std::iter::once(&material), &found, 8);
        let note = notes.iter().find(|note| note.code == RemarkCode::RowsAboveHardness);
        assert_eq!(note.is_some(), found.above_hardness > 0);
        found.above_hardness
    };
    assert_eq!(counted("hertz", 1e15), 0);
    assert_eq!(counted("hertz", 1e6), 8);
    assert!((1..8).contains(&counted("hertz", 2e9)));
    assert_eq!(counted("ep-sphere", SILVER_PA), 0);
}
