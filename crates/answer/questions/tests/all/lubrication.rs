//! Asperity pressures over separations, for mixed lubrication.

use numerics::parallel::Unobserved;
use questions::{
    GapModel, GapQuestion, GasInput, LawTableQuestion, LubricationQuestion, LubricationRange,
    PlasticCorrelation, QuestionError, SamplingInput, SummitInput,
};
use scene::{Overrides, Scene};
use spectrum::{AsperityParameters, Normalisation, cumulative_moments};
use stat_contact::{GreenwoodTripp, PartialMoment, Population};
use study::surface::Surface;
use tables::Table;
use units::{Pressure, SceneKeys};

use crate::common::{
    Counted, STEEL_MODULUS_PA, assert_all_near, assert_near, by, column, filled, hard, loads, small, steel,
    surface, unused,
};

const PARSEVAL: Normalisation = Normalisation::Parseval;

fn asks(by: GapModel, range: LubricationRange) -> LubricationQuestion {
    LubricationQuestion { by, range, random: Default::default(), as_scanned: false, summits: None }
}

fn separations(by: GapModel, from: f64, to: f64) -> LubricationQuestion {
    asks(by, LubricationRange::Separations([from, to]))
}

fn pressures(by: GapModel, from_pa: f64, to_pa: f64) -> LubricationQuestion {
    asks(by, LubricationRange::Pressures([from_pa, to_pa].map(Pressure::Pascals)))
}

fn table(question: &LubricationQuestion, surface: &Surface) -> Table {
    question.check(&LawTableQuestion::default()).unwrap();
    question.answer(surface, &Unobserved).unwrap().table
}

#[test]
fn separations_are_those_that_were_asked_and_carry_what_the_model_carries() {
    let surface = surface();
    for name in ["persson", "hertz", "bgt", "elastic-sine"] {
        let table = table(&separations(by(Some(name)), 0.5, 3.0), &surface);
        let over_rms = filled(&table, "separation_over_rms_height");
        assert_all_near(&over_rms, &(0..26).map(|at| 0.5 + 0.1 * f64::from(at)).collect::<Vec<_>>(), 1e-9);
        let pressures_pa = filled(&table, "nominal_pressure_pa");
        assert!(pressures_pa.windows(2).all(|pair| pair[0] > pair[1]), "{name}");
        let question =
            GapQuestion { by: by(Some(name)), pressures: loads(&pressures_pa), ..GapQuestion::default() };
        let gaps = question.answer(&surface, &Unobserved).unwrap().table;
        assert_all_near(&filled(&table, "nominal_separation_m"), &filled(&gaps, "mean_gap_m"), 1e-9);
        assert_all_near(&filled(&table, "area_fraction"), &filled(&gaps, "area_fraction"), 1e-9);
    }
}

#[test]
fn pressures_are_those_that_were_asked_from_the_closest_separation_on() {
    let table = table(&pressures(by(Some("persson")), 1e6, 1e8), &surface());
    let pressures_pa = filled(&table, "nominal_pressure_pa");
    assert_eq!((pressures_pa.len(), pressures_pa[0], pressures_pa[25]), (26, 1e8, 1e6));
    assert_all_near(&filled(&table, "mean_gap_m"), &filled(&table, "nominal_separation_m"), 0.0);
}

#[test]
fn flow_factors_of_the_medium_end_where_none_was_tried() {
    let table = table(&separations(by(Some("persson")), 0.2, 3.0), &surface());
    let [x, y, low, high] = ["flow_factor_x", "flow_factor_y", "flow_factor_low", "flow_factor_high"]
        .map(|name| column(&table, name));
    assert_eq!(x, y);
    let known: Vec<usize> = (0..26).filter(|row| x[*row].is_some()).collect();
    assert!(known.len() > 5 && known.len() < 26 && known.iter().enumerate().all(|(at, row)| at == *row));
    for row in known {
        assert!(low[row] < x[row] && x[row] < high[row] && low[row] > Some(0.0), "{row}");
    }
    let over_rms = filled(&table, "separation_over_rms_height");
    for (over_rms, factor) in over_rms.iter().zip(column(&table, "patir_cheng_flow_factor")) {
        assert_eq!(factor.is_some(), *over_rms >= 0.5);
        factor.iter().for_each(|factor| assert_near(*factor, 1.0 - 0.9 * (-0.56 * over_rms).exp(), 1e-12));
    }
    let tight = pressures(by(Some("persson")), 0.3 * STEEL_MODULUS_PA, 0.4 * STEEL_MODULUS_PA);
    assert!(filled(&self::table(&tight, &surface()), "flow_factor_x").iter().all(|factor| *factor == 0.0));
}

/// Greenwood & Williamson's formula with McCool's summits, from the mean plane of the surface.
#[test]
fn one_rough_face_on_a_plane_follows_f_three_halves() {
    let surface = surface();
    let moments = *cumulative_moments(&surface.psd, PARSEVAL).last().unwrap();
    let of = AsperityParameters::from_moments(&moments).unwrap();
    let table = table(&separations(by(Some("hertz")), 0.5, 3.0), &surface);
    for row in [0, 10, 25] {
        let [pressure_pa, mean_gap_m, separation_m] =
            ["nominal_pressure_pa", "mean_gap_m", "nominal_separation_m"]
                .map(|name| filled(&table, name)[row]);
        let x = (separation_m - of.offset_m) / of.sigma_s_m;
        let amplitude_pa =
            4.0 / 3.0 * of.density_per_m2 * STEEL_MODULUS_PA * of.radius_m.sqrt() * of.sigma_s_m.powf(1.5);
        assert_near(pressure_pa, amplitude_pa * PartialMoment::ThreeHalves.above(x), 1e-9);
        let over_rms = separation_m / moments.rms_height_m();
        assert_near(mean_gap_m, moments.rms_height_m() * PartialMoment::First.above(-over_rms), 1e-9);
        assert!(mean_gap_m > separation_m);
    }
    assert!(column(&table, "flow_factor_x").iter().all(Option::is_none));
}

/// sigma 0.2 um, beta 0.2 mm, eta 1.25e9 per m^2 and E* 217 GPa: 50.1, 6.55, 0.441 and 0.0139 MPa at h/sigma = 0, 1, 2, 3.
#[test]
fn three_numbers_have_their_own_law_and_find_themselves_again() {
    let summits = SummitInput { density_per_m2: 1.25e9, radius_m: 2e-4, rms_height_m: 2e-7 };
    let material =
        questions::MaterialInput { youngs_modulus_pa: Some(217e9), poisson_ratio: Some(0.0), ..steel() };
    let by = GapModel { material, ..GapModel::default() };
    let question = LubricationQuestion { summits: Some(summits), ..separations(by.clone(), 0.5, 3.0) };
    question.check(&LawTableQuestion::default()).unwrap();
    let found = question.answer_summits().unwrap();
    let pressures_pa = filled(&found.table, "nominal_pressure_pa");
    for (row, expected_pa) in [(5, 6.550e6), (15, 4.410e5), (25, 1.389e4)] {
        assert_near(pressures_pa[row], expected_pa, 5e-4);
    }
    assert_all_near(&filled(&found.table, "fitted_pressure_pa"), &pressures_pa, 1e-11);
    let fit = found.fit.unwrap();
    assert_near(fit.law.summits().density_per_m2(), 1.25e9, 1e-11);
    assert!(fit.ln_pressure_errors[1] < 1e-11 && fit.ln_area_errors[1] < 1e-11);
    let by_pressure = LubricationQuestion { summits: Some(summits), ..pressures(by, 6.0e5, 5.013e7) };
    let table = by_pressure.answer_summits().unwrap().table;
    assert!(filled(&table, "separation_over_rms_height")[0].abs() < 1e-3);
    assert_eq!(filled(&table, "nominal_pressure_pa").len(), 26);
    let bad = SummitInput { radius_m: -1.0, ..summits };
    assert!(LubricationQuestion { summits: Some(bad), ..question }.answer_summits().is_err());
}

#[test]
fn the_triple_of_two_faces_is_told_from_that_of_half_of_their_sum() {
    let (own, sum) = (surface(), surface().against(surface()));
    let question = separations(by(Some("persson")), 0.5, 3.0);
    let lines = |surface: &Surface| question.answer(surface, &Unobserved).unwrap().description(&SceneKeys);
    // Alike faces: half of the sum is each of them.
    let moments = *cumulative_moments(&own.psd, PARSEVAL).last().unwrap();
    let of = AsperityParameters::from_moments(&moments).unwrap();
    let face = Population::new(of.radius_m, of.density_per_m2, of.sigma_s_m).unwrap();
    let of_faces = GreenwoodTripp::from_faces(STEEL_MODULUS_PA, [&face, &face]).unwrap();
    let product =
        format!("eta beta sigma = {}", units::display::three_digits(of_faces.density_radius_sigma()));
    assert!(lines(&sum).iter().any(|line| line.contains(&product)), "{product}: {:#?}", lines(&sum));
    let of_sum = |line: &String| line.contains("if each has half of this roughness");
    assert!(lines(&own).iter().any(of_sum) && !lines(&sum).iter().any(of_sum));
}

#[test]
fn a_scene_has_the_bodies_and_the_scales_of_its_file() {
    let text = "[surface]\npsd = \"builtin:uncd-measured\"\n[cutoffs]\nshortest_wavelength = \"20 nm\"\n[material]\nyoungs_modulus = \"200 GPa\"\n\
                poisson_ratio = 0.3\n[loads]\npressures = [\"10 MPa\"]\n[[curve]]\nmodel = \"persson\"\n";
    let scene = Scene::parse(text, &study::NoFiles, &Overrides::default()).unwrap();
    let question = separations(GapModel { material: Default::default(), ..by(Some("persson")) }, 0.5, 3.0);
    let found = question.answer_scene(&scene, &Unobserved).unwrap();
    let sampling = SamplingInput { cutoff_m: Some(20e-9), ..SamplingInput::default() };
    let own = separations(GapModel { sampling, ..by(Some("persson")) }, 0.5, 3.0);
    let [of_scene, expected] =
        [found.table, table(&own, &scene.surface)].map(|table| filled(&table, "nominal_pressure_pa"));
    assert_all_near(&of_scene, &expected, 0.0);
    assert!(matches!(own.answer_scene(&scene, &Unobserved), Err(QuestionError::Other(_))));
}

#[test]
fn elements_are_pressed_to_separations_and_close_further_than_their_gap_where_they_flow() {
    let surface = surface();
    let random = small(2);
    let elastic = LubricationQuestion { random, ..separations(by(None), 0.5, 2.0) };
    let table_of = |question: &LubricationQuestion| table(question, &surface);
    let apart = table_of(&elastic);
    assert_all_near(&filled(&apart, "mean_gap_m"), &filled(&apart, "nominal_separation_m"), 1e-6);
    assert_near(filled(&apart, "separation_over_rms_height")[0], 0.5, 1e-6);
    let pressures_pa = filled(&apart, "nominal_pressure_pa");
    // The grid is that of `gap`, whose loads are the same on every surface.
    let question =
        GapQuestion { by: by(None), pressures: loads(&pressures_pa[..2]), random, ..GapQuestion::default() };
    let gaps = filled(&question.answer(&surface, &Unobserved).unwrap().table, "mean_gap_m");
    assert_all_near(&filled(&apart, "mean_gap_m")[..2], &gaps, 0.05);
    let hard =
        GapModel { material: hard(0.1 * pressures_pa[0] / filled(&apart, "area_fraction")[0]), ..by(None) };
    let flowed = table_of(&LubricationQuestion { random, ..separations(hard, 0.5, 2.0) });
    let [gap_m, separation_m] = ["mean_gap_m", "nominal_separation_m"].map(|name| filled(&flowed, name));
    assert_near(separation_m[0], filled(&apart, "nominal_separation_m")[0], 1e-6);
    assert!(gap_m[0] > 1.01 * separation_m[0], "{gap_m:?} {separation_m:?}");
    assert!(filled(&flowed, "nominal_pressure_pa")[0] < 0.9 * pressures_pa[0]);
    #[cfg(feature = "transport")]
    for row in 0..3 {
        let [x, y, low, high] = ["flow_factor_x", "flow_factor_y", "flow_factor_low", "flow_factor_high"]
            .map(|name| filled(&apart, name)[row]);
        assert!(low <= x.min(y) && x.max(y) <= high, "{row}: {low} {x} {y} {high}");
    }
    #[cfg(not(feature = "transport"))]
    assert!(column(&apart, "flow_factor_x").iter().all(Option::is_none));
}

#[test]
fn options_that_change_nothing_are_refused() {
    let law = LawTableQuestion::default();
    let persson = || separations(by(Some("persson")), 0.5, 3.0);
    let summits = Some(SummitInput { density_per_m2: 1e9, radius_m: 1e-4, rms_height_m: 1e-7 });
    let named = LawTableQuestion { name: Some("ROUGH".to_owned()), ..law.clone() };
    let gas = GasInput { temperature_k: Some(300.0), ..GasInput::default() };
    let with_gas = LawTableQuestion { gas, ..law.clone() };
    let sampling = SamplingInput { cutoff_m: Some(1e-6), ..SamplingInput::default() };
    let cases = [
        (persson(), &named, "name"),
        (persson(), &with_gas, "gas_temperature"),
        (LubricationQuestion { as_scanned: true, ..persson() }, &law, "as_scanned"),
        (LubricationQuestion { random: small(2), ..persson() }, &law, "grid"),
        (
            LubricationQuestion { as_scanned: true, random: small(2), ..separations(by(None), 0.5, 3.0) },
            &law,
            "grid",
        ),
        (separations(GapModel { sampling, ..by(None) }, 0.5, 3.0), &law, "cutoff"),
        (
            LubricationQuestion { summits, ..separations(GapModel { sampling, ..by(None) }, 0.5, 3.0) },
            &law,
            "cutoff",
        ),
        (LubricationQuestion { summits, random: small(1), ..separations(by(None), 0.5, 3.0) }, &law, "grid"),
    ];
    for (question, others, option) in cases {
        assert_eq!(unused(question.check(others)).as_deref(), Some(option), "{question:?}");
    }
    let correlation = LawTableQuestion { correlation: Some(PlasticCorrelation::Yovanovich), ..law.clone() };
    assert!(matches!(persson().check(&correlation), Err(QuestionError::ConductanceOnly(_))));
    for (from, to) in [(3.0, 0.5), (-0.1, 1.0), (f64::NAN, 1.0), (1.0, 50.0), (1.0, f64::NAN)] {
        let question = separations(by(Some("persson")), from, to);
        assert!(
            matches!(question.check(&law), Err(QuestionError::Value { option: "separation_range", .. })),
            "{from} {to}"
        );
    }
    let no_map = LubricationQuestion { as_scanned: true, ..separations(by(None), 0.5, 3.0) };
    assert!(matches!(no_map.answer(&surface(), &Unobserved), Err(QuestionError::Other(_))));
    let cancelled = persson().answer(&surface(), &Counted::cancelled()).unwrap_err();
    assert!(cancelled.is_cancelled());
}
