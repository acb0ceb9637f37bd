//! Persson's options in a scene: in its table, figure, verdict, first line, interval and sensitivities.

use std::collections::BTreeMap;

use findings::sensitivity::sensitivities;
use judge::{JudgePlan, Verdict};
use persson::Band;
use persson::EnergyFactor;
use persson::corrections::Correction;
use report::curve_names::in_full;
use scene::{Overrides, Scene};
use study::gap_law::{GapChoices, GapLaw};
use study::plan::Tolerance;
use study::{Unobserved, result_tables};
use tables::Cells;
use uncertainty::UncertaintyPlan;

const CURVES: &str = r#"
    surface = { psd = "s.csv" }
    material = { youngs_modulus = "200 GPa", poisson_ratio = 0.3 }
    loads = { pressures = ["300 MPa"] }
    [[curve]]
    model = "persson"
    correction = "algebraic-nayak"
    [[curve]]
    model = "persson"
    [[figure]]
    name = "area"
    shows = "area"
"#;

const CORRECTED: usize = 0;
const PLAIN: usize = 1;

/// A self-affine spectrum of 0.9 decades with standard errors.
fn scene(text: &str) -> Scene {
    let mut psd = "wavelength_m,C1D_m3,C1D_se_m3\n".to_owned();
    for at in 0..=11 {
        let wavelength_m = 1e-6 * 10f64.powf(-0.9 * f64::from(at) / 11.0);
        let c1d_m3 = 1e-24 * (wavelength_m / 1e-6).powf(2.6);
        psd += &format!("{wavelength_m:e},{c1d_m3:e},{:e}\n", 0.1 * c1d_m3);
    }
    let files = BTreeMap::from([("s.csv".to_owned(), psd.into_bytes())]);
    Scene::parse(text, &files, &Overrides::default()).unwrap()
}

#[test]
fn a_corrected_curve_is_in_table_figure_verdict_first_line_and_interval() {
    let scene = scene(CURVES);
    assert!(scene.notes.is_empty());
    let names: Vec<&str> = scene.needs.curves.iter().map(|curve| curve.name.as_str()).collect();
    assert_eq!(names, ["persson-algebraic-nayak", "persson"]);
    assert_ne!(in_full(&scene.needs.curves[0]), in_full(&scene.needs.curves[1]));
    let plan = scene.plan();
    let results = plan.compute().unwrap();
    let last_area = |curve: usize| results.curves[curve].area_fractions(0).last().unwrap().1;
    assert!(last_area(CORRECTED) > 1.1 * last_area(PLAIN));

    // The digits of the gap law, which the command prints.
    let choices = GapChoices {
        energy_factor: EnergyFactor::default(),
        band: Band::default(),
        tolerance: Tolerance::default(),
    };
    let law = GapLaw::of(&scene.needs.curves[CORRECTED].model, &plan, &results, &choices).unwrap();
    let state = law.at(300e6).unwrap();
    assert_eq!(state.area_fraction, last_area(CORRECTED));

    let table = result_tables::curve(&results.curves[CORRECTED], &scene.needs.loads, false);
    let Some(Cells::Numbers(areas)) = table.column("area_fraction") else { panic!("{table:?}") };
    assert_eq!(areas.last().copied().flatten(), Some(last_area(CORRECTED)));
    let Some(Cells::Numbers(gaps)) = table.column("mean_gap_m") else { panic!("{table:?}") };
    assert_eq!(gaps.last().copied().flatten(), state.mean_gap_m);

    let figure = scene.figures[0].data(&results, &scene.needs, None);
    let series = figure.series.iter().find(|series| series.curve == "persson-algebraic-nayak").unwrap();
    assert_eq!(series.points.last().map(|point| point.1), Some(last_area(CORRECTED)));

    let settings = judge::JudgeSettings { grid: Some(64), realisations: Some(4), ..Default::default() };
    let judgement = JudgePlan::new(&scene, &results, &settings).run(&Unobserved).unwrap();
    let of_corrected = &judgement.curves[CORRECTED];
    assert_eq!(of_corrected.verdict, Verdict::Agrees, "{of_corrected:?}");
    let off = |curve: usize| (judgement.curves[curve].ratio().unwrap() - 1.0).abs();
    // The first sample is rough already: its waves have profiles below it, which a spectrum of 0.9 decades misses.
    assert!(off(CORRECTED) < 0.1 && off(PLAIN) > 0.15, "{} {}", off(CORRECTED), off(PLAIN));
    assert_eq!(judgement.headline(0).unwrap().best_curve, Some(CORRECTED));

    let drawn = UncertaintyPlan::new(&scene, &results, &uncertainty::UncertaintySettings::default()).unwrap();
    let found = drawn.run(&Unobserved).unwrap();
    let interval = found.interval(CORRECTED, 0).unwrap();
    assert!(interval.low < last_area(CORRECTED) && last_area(CORRECTED) < interval.high, "{interval:?}");
    assert!(interval.high > found.interval(PLAIN, 0).unwrap().high);
}

#[test]
fn correction_and_band_are_choices_that_sensitivities_make_another_way() {
    let scene = scene(CURVES);
    let results = scene.plan().compute().unwrap();
    let varied = sensitivities(&scene, &results, &Unobserved).unwrap();
    let of = |choice: &str, setting: &str| {
        varied.iter().find(|varied| varied.choice == choice && varied.setting == setting).unwrap()
    };
    let curve = |at: usize| results.curves[at].area_fractions(0).last().unwrap().1;
    let correction = "correction of Persson's theory";
    let none: Vec<_> = of(correction, "none").rows.iter().map(|row| (row.curve, row.area_fraction)).collect();
    assert_eq!(none, [(CORRECTED, curve(PLAIN))]);
    let nayak = &of(correction, Correction::AlgebraicNayak.name()).rows;
    assert_eq!(
        nayak.iter().map(|row| (row.curve, row.area_fraction)).collect::<Vec<_>>(),
        [(PLAIN, curve(CORRECTED))]
    );
    assert_eq!(of(correction, "wang-muser").rows.len(), 2);
    let profile = &of("spectrum that a cutoff ends", "1d").rows;
    assert!(profile.len() == 2 && profile.iter().all(|row| row.ratio != 1.0));
}
