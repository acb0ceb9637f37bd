//! Laws by boundary elements, and what laws by closed forms say of contact that flows.

use interface::finite_elements::{Column, ContactLaw, Dialect, SamplingError, UnitSystem};
use interface::gas::GapGas;
use numerics::parallel::{Unobserved, on_this_thread};
use questions::{
    ElementsLaw, ElementsLawAnswer, ElementsLawQuestion, GapModel, GapQuestion, GasInput, LawForm,
    LawQuantity, LawQuestion, LawTableQuestion, MaterialInput, QuestionError, RandomInput, TransportInput,
};
use study::surface::Surface;
use units::{Pressure, RemarkCode, SceneKeys};

use crate::common::{
    STEEL_MODULUS_PA, assert_near, by, column, hard, has, loads, missing, small, steel, surface, unused,
};

const RANGE_PA: [f64; 2] = [3e7, 3e9];
const TRANSPORT: TransportInput = TransportInput {
    thermal_conductivity_w_per_m_k: Some(50.0),
    counterface_thermal_conductivity_w_per_m_k: Some(150.0),
    resistivity_ohm_m: None,
    counterface_resistivity_ohm_m: None,
};

fn question(material: MaterialInput) -> ElementsLawQuestion {
    let [from, to] = RANGE_PA.map(Pressure::Pascals);
    let law = LawQuestion { by: GapModel { material, ..by(None) }, from, to };
    let table = LawTableQuestion { law, dialect: Some(Dialect::Csv), ..LawTableQuestion::default() };
    // Light loads of small surfaces press a few asperities, whose laws have kinks.
    let random = RandomInput { grid: Some(64), ..small(4) };
    ElementsLawQuestion { table, random, error: Some(0.05) }
}

fn found(question: &ElementsLawQuestion) -> ElementsLaw {
    match question.answer(&surface(), &Unobserved).unwrap() {
        ElementsLawAnswer::Pressure(law) => *law,
        ElementsLawAnswer::Conductance(conductance) => panic!("{conductance:?}"),
    }
}

/// Values of the column whose name begins so.
fn values(columns: &[Column], name: &str) -> Vec<f64> {
    let found = columns.iter().find(|column| column.name.starts_with(name));
    found.unwrap().values.iter().map(|value| value.unwrap()).collect()
}

/// Mean gaps, stiffness and distances of the mean planes by single loads.
fn alone(material: MaterialInput, pressures_pa: &[f64], surface: &Surface) -> [Vec<f64>; 2] {
    let question = GapQuestion {
        by: GapModel { material, ..by(None) },
        pressures: loads(pressures_pa),
        random: RandomInput { grid: Some(64), ..small(4) },
        ..GapQuestion::default()
    };
    let table = question.answer(surface, &Unobserved).unwrap().table;
    ["mean_gap_m", "stiffness_pa_per_m"]
        .map(|name| column(&table, name).into_iter().map(Option::unwrap).collect())
}

#[test]
fn an_elastic_law_closes_as_single_loads_do_and_its_slope_is_their_stiffness() {
    let law = found(&question(steel()));
    let (sampled, columns) = law.sampled(0.05, UnitSystem::Si).unwrap();
    assert_eq!((sampled.points[1].pressure_pa, sampled.points.last().unwrap().pressure_pa), (3e7, 3e9));
    assert!(sampled.tolerance == 0.05 && sampled.interpolation_error <= 0.05);
    let pressures_pa: Vec<f64> = sampled.points.iter().map(|point| point.pressure_pa).collect();
    let [gaps_m, stiffnesses] = alone(steel(), &pressures_pa, &surface());
    let [loading, unloading, mean_gaps_m] =
        ["loading", "unloading", "mean_gap"].map(|name| values(&columns, name));
    for (at, point) in sampled.points.iter().enumerate() {
        let off = (point.mean_gap_m - gaps_m[at]) * stiffnesses[at] / point.pressure_pa;
        assert!(off.abs() < 0.05, "at {}: {off}", point.pressure_pa);
        // Nothing flows: the mean planes are a mean gap apart.
        assert!((mean_gaps_m[at] - point.mean_gap_m).abs() < 1e-5 * law.rms_height_m);
        assert_near(unloading[at], stiffnesses[at], 0.1);
        if 0 < at && at + 1 < sampled.points.len() {
            assert_near(loading[at], stiffnesses[at], 0.2);
        }
    }
    // The scatter is about the table.
    let [low, high] = ["overclosure_low", "overclosure_high"].map(|name| values(&columns, name));
    for (at, point) in sampled.points.iter().enumerate().skip(1) {
        let overclosure_m = sampled.overclosure_m(point.mean_gap_m);
        assert!(low[at] < overclosure_m && overclosure_m < high[at], "{at}");
    }
}

#[test]
fn a_metal_is_stiffer_on_unloading_and_its_mean_planes_are_closer_than_its_gap() {
    let law = found(&question(hard(8e9)));
    let (sampled, columns) = law.sampled(0.05, UnitSystem::Millimetres).unwrap();
    let names: Vec<&str> = columns.iter().map(|column| column.name.as_str()).collect();
    let expected = [
        "mean_gap_mm",
        "loading_stiffness_MPa_per_mm",
        "unloading_stiffness_MPa_per_mm",
        "overclosure_low_mm",
        "overclosure_high_mm",
    ];
    assert_eq!(names, expected);
    let [loading, unloading, gaps_mm] =
        ["loading", "unloading", "mean_gap"].map(|name| values(&columns, name));
    let last = sampled.points.len() - 1;
    assert!(1.2 * loading[last] < unloading[last], "{} {}", loading[last], unloading[last]);
    for (gap_mm, point) in gaps_mm.iter().zip(&sampled.points) {
        assert!(1e-3 * gap_mm > point.mean_gap_m);
    }
    let state = law.at(RANGE_PA[1]);
    assert_near(1e-3 * gaps_mm[last], state.mean_gap_m.unwrap(), 1e-12);
    // 1 MPa/mm is 1e9 Pa/m.
    assert_near(1e9 * unloading[last], state.stiffness_pa_per_m.unwrap(), 1e-12);
    assert_near(1e9 * loading[last], law.loading_stiffness_pa_per_m(RANGE_PA[1]), 1e-12);
    // Single loads yield as the law does.
    let [gaps_m, stiffnesses] = alone(hard(8e9), &[3e9], &surface());
    assert_near(state.mean_gap_m.unwrap(), gaps_m[0], 1e-3);
    assert_near(state.stiffness_pa_per_m.unwrap(), stiffnesses[0], 1e-3);
    assert!(has(&law.notes, RemarkCode::RandomSurfaces));
    // Every note stands among the comments, and five lines of the elements.
    let lines = law.description(&SceneKeys);
    assert_eq!(lines.len(), 5 + law.notes.len());
    let elastic = found(&question(steel()));
    assert_ne!(elastic.description(&SceneKeys)[1], lines[1]);
}

#[test]
fn heat_follows_the_stiffness_on_unloading_and_gas_the_mean_gap() {
    let gas = GasInput { conductivity_w_per_m_k: Some(0.03), parameter_m: Some(4e-7), ..GasInput::default() };
    let mut heat = question(hard(8e9));
    heat.error = Some(0.1);
    let law = found(&heat);
    heat.table = LawTableQuestion { quantity: LawQuantity::Heat, transport: TRANSPORT, gas, ..heat.table };
    let ElementsLawAnswer::Conductance(conductance) = heat.answer(&surface(), &Unobserved).unwrap() else {
        panic!("no conductance")
    };
    let table = conductance.sampled(0.1, &Unobserved).unwrap();
    let last = table.points.last().unwrap();
    // k_s of 50 and 150 W/(m K) is 75.
    let stiffness = law.at(last.pressure_pa).stiffness_pa_per_m.unwrap();
    assert_near(last.contact_si, 75.0 * stiffness / STEEL_MODULUS_PA, 1e-9);
    let gap_m = law.at(last.pressure_pa).mean_gap_m.unwrap();
    let of_gas = GapGas::new(0.03, 4e-7).unwrap().conductance_w_per_m2_k(gap_m, law.rms_height_m);
    assert_near(last.gas_si, of_gas, 1e-9);
    // The analogy, clean bodies, and the gas.
    assert_eq!(conductance.description(&SceneKeys).len(), law.description(&SceneKeys).len() + 3);
    heat.table.transport = TransportInput::default();
    assert_eq!(missing(heat.answer(&surface(), &Unobserved)), ["thermal_conductivity"]);
}

#[test]
fn more_loads_are_pressed_where_the_error_needs_them_and_threads_change_no_digit() {
    let coarse = question(hard(8e9));
    let fine = ElementsLawQuestion { error: Some(0.01), ..coarse.clone() };
    let [coarse_law, fine_law] = [&coarse, &fine].map(found);
    let rows = |law: &ElementsLaw, error: f64| law.sampled(error, UnitSystem::Si).unwrap().0;
    let [rough, smooth] = [rows(&coarse_law, 0.05), rows(&fine_law, 0.01)];
    assert!(smooth.points.len() > rough.points.len() && smooth.interpolation_error <= 0.01);
    // The coarse law is within its error of the fine one.
    for point in &rough.points[1..] {
        let off = smooth.pressure_pa(smooth.overclosure_m(point.mean_gap_m)) / point.pressure_pa - 1.0;
        assert!(off.abs() < 0.06, "at {}: {off}", point.pressure_pa);
    }
    assert_eq!(rough, on_this_thread(|| rows(&found(&coarse), 0.05)));
}

#[test]
fn options_without_effect_and_ranges_that_do_not_rise_are_refused() {
    let refused = |question: ElementsLawQuestion| question.answer(&surface(), &Unobserved).map(drop);
    let fine = || question(steel());
    let mut exponential = fine();
    exponential.table.form = Some(LawForm::Exponential);
    assert_eq!(unused(refused(exponential)).as_deref(), Some("form"));
    let mut capped = fine();
    capped.table.law.by.material.strength_cap = Some(Pressure::Pascals(1e9));
    assert_eq!(unused(refused(capped)).as_deref(), Some("strength_cap"));
    let mut falling = fine();
    falling.table.law.to = Pressure::Pascals(RANGE_PA[0]);
    let falling = refused(falling);
    assert!(matches!(falling, Err(QuestionError::Sampling(SamplingError::EmptyRange { .. }))), "{falling:?}");
    let above = refused(question(hard(2e9)));
    assert!(matches!(above, Err(QuestionError::Elements(_))), "{above:?}");
    for error in [1e-6, 0.6] {
        let refused = refused(ElementsLawQuestion { error: Some(error), ..fine() });
        assert!(matches!(refused, Err(QuestionError::Value { option: "error", .. })), "{refused:?}");
    }
}

#[test]
fn an_elastic_closed_form_says_by_how_much_it_is_off_where_the_contact_flows() {
    let lines = |name: &str, material: MaterialInput| {
        let by = GapModel { material, ..by(Some(name)) };
        let law = LawQuestion { by, from: Pressure::Pascals(1e6), to: Pressure::Pascals(1e7) };
        let found = law.answer(&surface(), &Unobserved).unwrap();
        let described = found.description(&SceneKeys).len();
        let sampled: Result<ContactLaw, _> = found.sampled(0.05, &Unobserved);
        (
            described - found.notes.iter().filter(|note| note.level == units::RemarkLevel::Caution).count(),
            sampled.is_ok(),
        )
    };
    for name in ["persson", "hertz", "bgt", "elastic-sine"] {
        assert_eq!(lines(name, steel()), (1, true), "{name}");
        assert_eq!(lines(name, hard(2e9)), (2, true), "{name}");
        // Next to nothing flows.
        assert_eq!(lines(name, hard(90e9)), (1, true), "{name}");
    }
    assert_eq!(lines("ep-sphere", hard(2e9)).0, 1);
}

#[test]
fn a_closed_form_that_yields_has_columns_of_its_gap_and_of_unloading() {
    let law = |name: &str| {
        let by = GapModel { material: hard(3e9), ..by(Some(name)) };
        let law = LawQuestion { by, from: Pressure::Pascals(1e6), to: Pressure::Pascals(1e8) };
        let found = law.answer(&surface(), &Unobserved).unwrap();
        let sampled = found.sampled(0.05, &Unobserved).unwrap();
        let columns = found.columns(&sampled, UnitSystem::Si);
        (found, sampled, columns)
    };
    let (found, sampled, columns) = law("persson-plastic");
    let [gaps_m, stiffnesses] =
        ["mean_gap_m", "unloading_stiffness_Pa_per_m"].map(|name| values(&columns, name));
    for ((gap_m, stiffness), point) in gaps_m.iter().zip(&stiffnesses).zip(&sampled.points) {
        let state = found.law.at(point.pressure_pa).unwrap();
        assert_eq!((Some(*gap_m), Some(*stiffness)), (state.mean_gap_m, state.stiffness_pa_per_m));
        assert!(*gap_m >= point.mean_gap_m);
    }
    assert!(law("persson").2.is_empty());
}
