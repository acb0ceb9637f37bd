//! Surfaces that are sheared.

use asperity::{ElasticBody, MaterialPair};
use interface::tangential::ShearedPair;
use numerics::parallel::Unobserved;
use questions::{
    Answer, BodyInput, GapQuestion, LawQuestion, MaterialInput, QuestionError, TangentialQuestion,
};
use study::figure::AxisScale;
use study::gap_law::GapLaw;
use study::interface::sheared_pair;
use units::{Pressure, RemarkCode, display};

use crate::common::{
    Counted, assert_all_near, assert_near, by, column, filled, has, load, loads, missing, numbers_of, small,
    steel, surface, unused,
};

const FRICTION: f64 = 0.3;
const SHARES: [f64; 11] = [0.01, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.99];

fn question(model: Option<&str>, pressures_pa: &[f64], stresses_pa: &[f64]) -> TangentialQuestion {
    TangentialQuestion {
        by: by(model),
        friction: Some(FRICTION),
        pressures: loads(pressures_pa),
        stresses: loads(stresses_pa),
        random: if model.is_none() { small(1) } else { questions::RandomInput::default() },
        ..TangentialQuestion::default()
    }
}

fn answer(question: &TangentialQuestion) -> Answer {
    question.answer(&surface(), &Unobserved).unwrap()
}

fn steel_pair() -> ShearedPair {
    let body = ElasticBody::new(200e9, 0.3).unwrap();
    sheared_pair(FRICTION, &MaterialPair::against_rigid(body)).unwrap()
}

/// The normal law of Persson's theory.
fn law() -> GapLaw {
    let law = LawQuestion { by: by(Some("persson")), ..LawQuestion::default() };
    law.answer(&surface(), &Unobserved).unwrap().law
}

/// A number of a row by its pressure \[Pa\] and its share of sliding.
type OfRow<'o> = &'o dyn Fn(f64, f64) -> f64;

#[test]
fn every_row_is_the_response_of_the_pair_to_its_share_of_sliding() {
    let pressures_pa = [1e6, 1e7];
    let found = answer(&question(Some("persson"), &pressures_pa, &[]));
    let (law, pair) = (law(), steel_pair());
    let stiffness = |pressure_pa: f64| -> Result<f64, QuestionError> {
        Ok(law.at(pressure_pa)?.stiffness_pa_per_m.unwrap())
    };
    let expected = |of: OfRow| -> Vec<f64> {
        pressures_pa.iter().flat_map(|p| SHARES.map(|share| of(*p, share))).collect()
    };
    let area = |pressure_pa: f64| law.at(pressure_pa).unwrap().area_fraction;
    let response = |p: f64, share: f64| pair.respond(p, share, stiffness).unwrap();
    let columns: [(&str, OfRow); 10] = [
        ("nominal_pressure_pa", &|p, _| p),
        ("tangential_stress_pa", &|p, share| share * FRICTION * p),
        ("share_of_sliding", &|_, share| share),
        ("displacement_m", &|p, share| response(p, share).displacement_m),
        ("initial_stiffness_pa_per_m", &|p, _| stiffness(p).unwrap() / pair.compliance_ratio()),
        ("tangent_stiffness_pa_per_m", &|p, share| {
            stiffness(p * (1.0 - share)).unwrap() / pair.compliance_ratio()
        }),
        ("dissipation_j_per_m2", &|p, share| response(p, share).dissipation_j_per_m2),
        ("damping_ratio", &|p, share| response(p, share).damping_ratio),
        ("area_fraction", &|p, _| area(p)),
        ("stuck_area_fraction", &|p, share| area(p * (1.0 - share))),
    ];
    for (name, of) in columns {
        assert_all_near(&filled(&found.table, name), &expected(of), 1e-9);
    }
    assert!(found.figure.is_none() && !has(&found.notes, RemarkCode::Sliding));
    // Dundurs' beta of a compressible body on a rigid one is (1 - 2 nu)/(2 (1 - nu)).
    let [mismatch] = numbers_of(&found.notes, RemarkCode::CoupledTractions, ["mismatch"]);
    assert_near(mismatch, 0.4 / 1.4, 1e-12);
}

#[test]
fn tractions_of_equal_bodies_are_not_coupled() {
    let counterface = Some(BodyInput { youngs_modulus_pa: 200e9, poisson_ratio: 0.3 });
    let mut question = question(Some("persson"), &[1e6], &[1e5]);
    question.by.material = MaterialInput { counterface, ..steel() };
    assert!(!has(&answer(&question).notes, RemarkCode::CoupledTractions));
}

#[test]
fn a_stress_of_friction_times_pressure_and_more_slides() {
    let found = answer(&question(Some("persson"), &[1e6], &[1e5, FRICTION * 1e6, 1e6]));
    assert_all_near(&filled(&found.table, "share_of_sliding"), &[1.0 / 3.0, 1.0, 10.0 / 3.0], 1e-12);
    let displacements = column(&found.table, "displacement_m");
    assert!(displacements[0].is_some() && displacements[1..].iter().all(Option::is_none));
    assert_eq!(numbers_of(&found.notes, RemarkCode::Sliding, ["sliding", "all"]), [2.0, 3.0]);
    let area = law().at(1e6).unwrap().area_fraction;
    assert_all_near(&filled(&found.table, "area_fraction"), &[area; 3], 1e-9);
}

#[test]
fn loops_end_at_the_loads_of_the_table_under_labels_that_tell_them_apart() {
    let drawn = |pressures_pa: &[f64], stresses_pa: &[f64]| {
        let question =
            TangentialQuestion { figure: true, ..question(Some("persson"), pressures_pa, stresses_pa) };
        let found = answer(&question);
        let figure = found.figure.unwrap();
        assert_eq!((figure.x_scale, figure.y_scale), (AxisScale::Linear, AxisScale::Linear));
        let firsts = figure.series.iter().filter(|line| line.points.first() == Some(&(0.0, 0.0)));
        let firsts: Vec<_> =
            firsts.map(|line| (line.condition.clone(), *line.points.last().unwrap())).collect();
        (found.table, firsts)
    };
    let at = |table: &tables::Table, row: usize| {
        (column(table, "displacement_m")[row].unwrap(), filled(table, "tangential_stress_pa")[row])
    };
    // Each end of a loop, with the row of the table that it is.
    let check = |pressures_pa: &[f64], stresses_pa: &[f64], rows: &[usize]| {
        let (table, firsts) = drawn(pressures_pa, stresses_pa);
        assert_eq!(firsts.len(), rows.len());
        for ((_, (x, y)), row) in firsts.iter().zip(rows) {
            let (displacement_m, stress_pa) = at(&table, *row);
            assert_near(*x, displacement_m, 1e-6);
            assert_near(*y, stress_pa, 1e-12);
        }
        let labels: Vec<String> = firsts.into_iter().map(|(label, _)| label).collect();
        assert!(labels.iter().enumerate().all(|(at, label)| !labels[..at].contains(label)), "{labels:?}");
        labels
    };
    let [p, q] = [1e6, 1e7].map(display::pressure);
    // By themselves 0.3, 0.6 and 0.9 of sliding, and 0.9 under several pressures.
    check(&[1e6], &[], &[3, 6, 9]);
    assert_eq!(check(&[1e6, 1e7], &[], &[9, 20]), [p.clone(), q.clone()]);
    assert_eq!(check(&[1e6], &[1e5, 2e5], &[0, 1]), [1e5, 2e5].map(display::pressure));
    assert_eq!(check(&[1e6, 1e7], &[1e5], &[0, 1]), [p.clone(), q.clone()]);
    let four = check(&[1e6, 1e7], &[1e5, 2e5], &[0, 1, 2, 3]);
    assert!(four[0].contains(&p) && four[3].contains(&q));
    // A load that slides has no loop; a single loop is drawn way by way.
    let (table, firsts) = drawn(&[1e6, 1e7], &[FRICTION * 1e6]);
    assert_eq!(firsts.len(), 1);
    assert_near(firsts[0].1.0, at(&table, 1).0, 1e-6);
}

#[test]
fn figures_without_a_loop_or_with_too_many_are_refused() {
    let of = |pressures: usize, stresses_pa: &[f64], figure: bool| {
        let pressures_pa: Vec<f64> = (1..=pressures).map(|at| 1e6 * at as f64).collect();
        let question = TangentialQuestion { figure, ..question(Some("persson"), &pressures_pa, stresses_pa) };
        question.check()
    };
    assert!(of(8, &[1e5], true).is_ok() && of(9, &[1e5], false).is_ok());
    assert!(matches!(of(9, &[1e5], true), Err(QuestionError::TooManyLines { lines: 9, most: 8, .. })));
    assert!(matches!(of(5, &[1e5, 2e5], true), Err(QuestionError::TooManyLines { lines: 10, .. })));
    let slides = TangentialQuestion { figure: true, ..question(Some("persson"), &[1e6], &[1e6]) };
    assert!(matches!(slides.answer(&surface(), &Unobserved), Err(QuestionError::NoLoop)));
}

#[test]
fn what_cannot_be_sheared_is_refused() {
    let plastic = question(Some("persson-plastic"), &[1e6], &[]);
    assert!(
        matches!(plastic.check(), Err(QuestionError::NotElastic(entry)) if entry.name == "persson-plastic")
    );
    let frictionless = TangentialQuestion { friction: None, ..question(Some("persson"), &[1e6], &[]) };
    assert_eq!(missing(frictionless.check()), ["friction"]);
    let negative = TangentialQuestion { friction: Some(-1.0), ..question(Some("persson"), &[1e6], &[]) };
    assert!(matches!(negative.check(), Err(QuestionError::Value { option: "friction", .. })));
    let pulls = question(Some("persson"), &[1e6], &[-1e5]);
    assert!(matches!(pulls.check(), Err(QuestionError::Load { option: "tangential_stress", .. })));
    let random = TangentialQuestion { random: small(1), ..question(Some("persson"), &[1e6], &[]) };
    assert_eq!(unused(random.check()).as_deref(), Some("grid"));
    let layer = questions::LayerInput {
        thickness_m: Some(1e-6),
        youngs_modulus_pa: Some(1e9),
        poisson_ratio: Some(0.4),
        ..questions::LayerInput::default()
    };
    let mut layered = question(Some("persson"), &[1e6], &[]);
    layered.by.material.layer = Some(layer);
    assert_eq!(unused(layered.check()).as_deref(), Some("layer_thickness"));
    for model in [Some("persson"), None] {
        let stopped = question(model, &[1e6], &[]).answer(&surface(), &Counted::cancelled());
        assert!(stopped.is_err_and(|error| error.is_cancelled()), "{model:?}");
    }
}

/// Pressures, areas and stiffnesses of the elastic surfaces that boundary elements shear.
fn pressed(pressures_pa: &[f64]) -> [Vec<f64>; 3] {
    let question = GapQuestion {
        by: by(None),
        pressures: loads(pressures_pa),
        random: small(1),
        ..GapQuestion::default()
    };
    let table = question.answer(&surface(), &Unobserved).unwrap().table;
    ["nominal_pressure_pa", "area_fraction", "stiffness_pa_per_m"].map(|name| filled(&table, name))
}

#[test]
fn boundary_elements_are_pressed_eight_times_a_decade_down_to_the_least_pressure_that_sticks() {
    let steps = |pressures_pa: &[f64], stresses_pa: &[f64]| {
        let surface = surface();
        let one = GapQuestion {
            by: by(None),
            pressures: loads(&[1e8]),
            random: small(1),
            ..GapQuestion::default()
        };
        let sheared = question(None, pressures_pa, stresses_pa).steps(&surface).unwrap();
        sheared / one.steps(&surface).unwrap()
    };
    // A hundredth of the pressure sticks at a share of 0.99; the pressures are those between and both ends.
    assert_eq!(steps(&[1e8], &[]), 17);
    assert_eq!(steps(&[1e8, 1e7], &[]), 25);
    // Half of it sticks: 0.3 decades.
    assert_eq!(steps(&[1e8], &[0.15e8]), 4);
    assert_eq!(steps(&[1e8], &[0.15e8, 0.3e8]), 4);
    assert_eq!(question(Some("persson"), &[1e8], &[]).steps(&surface()).unwrap(), 0);

    let found = answer(&question(None, &[1e8], &[]));
    let shares = filled(&found.table, "share_of_sliding");
    assert_all_near(&shares, &SHARES, 1e-12);
    // Loads of an eighth of a decade, between which logarithms are straight.
    let step = |at: f64| 1e8 * 10f64.powf(-at / 8.0);
    let of_stuck = |stuck: f64| {
        let at = (-8.0 * (stuck / 1e8).log10()).floor().clamp(0.0, 15.0);
        let [pressures, areas, stiffnesses] = pressed(&[step(at), step(at + 1.0)]);
        let share = (stuck / pressures[1]).ln() / (pressures[0] / pressures[1]).ln();
        let between = |ends: &[f64]| ends[1] * (ends[0] / ends[1]).powf(share);
        (between(&areas), between(&stiffnesses))
    };
    let eta = steel_pair().compliance_ratio();
    let [stuck, tangent, initial, areas] =
        ["stuck_area_fraction", "tangent_stiffness_pa_per_m", "initial_stiffness_pa_per_m", "area_fraction"]
            .map(|name| filled(&found.table, name));
    for (row, share) in SHARES.into_iter().enumerate() {
        let (area, stiffness) = of_stuck(1e8 * (1.0 - share));
        assert_near(stuck[row], area, 1e-6);
        assert_near(tangent[row], stiffness / eta, 1e-6);
    }
    let [_, area, stiffness] = pressed(&[1e8]);
    assert_near(areas[0], area[0], 1e-9);
    assert_near(initial[0], stiffness[0] / eta, 1e-9);
}

#[test]
fn boundary_elements_find_the_area_where_every_load_slides() {
    for pressures_pa in [&[1e8][..], &[1e8, 5e7], &[1e8, 1e6]] {
        let found = answer(&question(None, pressures_pa, &[1e8]));
        let [_, areas, _] = pressed(pressures_pa);
        assert_all_near(&filled(&found.table, "area_fraction"), &areas, 1e-6);
    }
    // One pressure sticks, and the other slides.
    let found = answer(&question(None, &[1e8, 1e6], &[1e6]));
    let [_, areas, _] = pressed(&[1e8, 1e6]);
    assert_all_near(&filled(&found.table, "area_fraction"), &areas, 1e-6);
}

#[test]
fn a_hardness_does_not_yield_while_elements_are_sheared() {
    let [soft, elastic] = [Some(1e9), None].map(|indentation_hardness_pa| {
        let mut question = question(None, &[1e8], &[1e7]);
        question.by.material.indentation_hardness_pa = indentation_hardness_pa;
        answer(&question)
    });
    assert_eq!(filled(&soft.table, "area_fraction"), filled(&elastic.table, "area_fraction"));
    assert!(has(&soft.notes, RemarkCode::RealAboveHardness));
    let in_hardnesses = TangentialQuestion {
        stresses: vec![questions::LoadInput { pressure: Pressure::Hardnesses(1e-3), ..load(0.0) }],
        ..question(Some("persson"), &[1e8], &[])
    };
    assert!(matches!(in_hardnesses.check(), Err(QuestionError::Load { option: "tangential_stress", .. })));
}
