//! Scenes before the judge.

use std::sync::atomic::{AtomicUsize, Ordering};

use judge::{Basis, JudgePlan, JudgeSettings, Judgement, Reference, Verdict};
use scene::Scene;
use study::{Progress, Unobserved};
use units::RemarkCode;

use crate::scenes::{ELASTIC, SelfAffine, White, coarse, judged, layered, scene, scene_on};

#[derive(Default)]
struct Counted(AtomicUsize);

impl Progress for Counted {
    fn advance(&self, steps: usize) {
        self.0.fetch_add(steps, Ordering::Relaxed);
    }
}

struct Cancelled;

impl Progress for Cancelled {
    fn advance(&self, _: usize) {}

    fn is_cancelled(&self) -> bool {
        true
    }
}

#[test]
fn a_band_that_the_grid_holds_is_solved_whole_and_its_bracket_is_that_of_the_elements() {
    let scene = scene(0.9, "", "\"300 MPa\"", &ELASTIC);
    let (_, judgement) = judged(&scene, &coarse(64, 4));
    let extent = judgement.extent.as_ref().unwrap();
    assert_eq!((extent.windows, extent.grid, extent.realisations), (1, 64, 4));
    for curve in &judgement.curves {
        assert!(curve.elements.is_some_and(|judged| judged.standard_error > 0.0), "{curve:?}");
    }
    // Persson's theory is 15 to 31 % low below a third of contact (Dapp, Prodanov & Mueser 2014).
    let persson = &judgement.curves[1];
    assert!((0.65..0.9).contains(&persson.ratio().unwrap()), "{persson:?}");
    let headline = judgement.headline(0).unwrap();
    assert_eq!(headline.basis, Basis::Elements(Reference::Elastic));
    // The number is that of the elements, in the middle of their bracket.
    let judged = persson.elements.unwrap();
    assert_eq!(headline.area_fraction, Some(judged.area_fraction));
    assert!(headline.low < judged.area_fraction && judged.area_fraction < headline.high);
    // Cut off in the surface or in its profiles: the gradient differs by 4 %.
    let window = persson.worst_window.unwrap();
    assert!((window.ratio / persson.ratio().unwrap() - 1.0).abs() < 0.05, "{window:?}");
}

#[test]
fn an_area_is_carried_down_to_a_light_load() {
    let scene = scene(0.9, "", "\"10 kPa\", \"20 MPa\"", &["model = \"persson\""]);
    let areas = |grid: usize| {
        let judgement = judged(&scene, &coarse(grid, 4)).1;
        [0, 1].map(|load| judgement.references[load].elements.unwrap())
    };
    // On the finer grid elements press the heavier load itself.
    let ([lightest, carried], [_, pressed]) = (areas(64), areas(384));
    let (ratio, error) = (carried.area_fraction / pressed.area_fraction, carried.relative_error());
    assert!(error > 0.03 && pressed.relative_error() < 0.03, "{carried:?} {pressed:?}");
    assert!((ratio - 1.0).abs() < 2.0 * error, "{ratio} {error}");
    // Over 3.3 further decades of load the area is nearly proportional, and the error grows.
    let ratio = lightest.area_fraction / pressed.area_fraction * 2000.0;
    assert!((0.9..1.2).contains(&ratio) && lightest.relative_error() > 0.1, "{ratio} {lightest:?}");
}

#[test]
fn an_area_that_flows_is_carried_down_from_below_the_hardness_on_a_coarse_grid() {
    let curves = ["model = \"persson-plastic\""];
    let scene = scene(0.9, "yield_strength = \"100 MPa\"", "\"10 MPa\"", &curves);
    let elements = |grid: usize| judged(&scene, &coarse(grid, 4)).1.curves[0].elements.unwrap();
    let (carried, pressed) = (elements(32), elements(192));
    let ratio = carried.area_fraction / pressed.area_fraction;
    assert!((ratio - 1.0).abs() < 2.0 * carried.relative_error(), "{ratio} {carried:?}");
}

#[test]
fn a_white_band_has_eight_points_a_wave_and_its_true_area() {
    let windows = |scene: &Scene| judged(scene, &coarse(64, 2)).1.extent.unwrap().windows;
    let load = format!("\"{} Pa\"", 0.01 * 0.05 * 200e9 / (1.0 - 0.3f64.powi(2)));
    assert_eq!(windows(&scene(0.8, "", &load, &ELASTIC)), 1);
    assert_eq!(windows(&scene_on(&White(0.8), "", &load, &ELASTIC)), 2);
    // Other surfaces of 1.5 decades, with 8 points a wave in a box of 4 longest waves: 0.02342 (0.2 %).
    let white = scene_on(&White(1.5), "", &load, &ELASTIC);
    let elements = judged(&white, &JudgeSettings::default()).1.references[0].elements.unwrap();
    assert!((elements.area_fraction / 0.02342 - 1.0).abs() < 0.03, "{elements:?}");
    assert!(elements.low() < 0.02342 && 0.02342 < elements.high(), "{elements:?}");
}

#[test]
fn windows_step_by_half_a_decade_and_the_widest_is_the_whole_band() {
    let [stack, persson, hertz] = ELASTIC;
    let corrected = "model = \"persson\"\ncorrection = \"algebraic-nayak\"\nband = \"2d\"";
    let scene = scene(2.2, "", "\"300 MPa\"", &[stack, persson, hertz, corrected]);
    let (results, judgement) = judged(&scene, &coarse(64, 4));
    let of_persson: Vec<_> = judgement.windows.iter().filter(|on| on.curve == 1).collect();
    let (whole, windows) = of_persson.split_last().unwrap();
    assert!(whole.is_whole_band && windows.iter().all(|on| !on.is_whole_band));
    assert!(
        (whole.longest_m / 1e-6 - 1.0).abs() < 1e-9
            && (whole.shortest_m / windows.last().unwrap().shortest_m - 1.0).abs() < 1e-9
    );
    assert_eq!(whole.area_fraction, results.curves[1].area_fractions(0).last().map(|(_, area)| *area));
    // The mean pressure on windows rises as roughness is taken in.
    assert!(windows.windows(2).all(|pair| pair[1].pressure_pa > pair[0].pressure_pa));
    for row in &judgement.curves {
        assert_eq!(row.reason.code, RemarkCode::ComparedAreas);
        assert_eq!(row.reason.number("windows"), Some(4.0), "{row:?}");
        assert!(row.windows == 4 && row.worst_window.is_some());
        assert_eq!(row.elements, judgement.references[0].elements);
    }
    let best = judgement.headline(0).unwrap().best_curve.unwrap();
    assert!(judgement.curves[best].holds());
}

#[test]
fn the_verdict_on_a_number_is_that_of_the_whole_band_and_the_worst_window_stands_beside_it() {
    let scene = scene(2.2, "", "\"300 MPa\"", &ELASTIC);
    let (_, judgement) = judged(&scene, &coarse(64, 2));
    for row in &judgement.curves {
        let ratio = row.area_fraction.unwrap() / row.elements.unwrap().area_fraction;
        assert_eq!(row.ratio(), Some(ratio));
        assert_eq!(row.verdict, Verdict::from_ratio(ratio, row.elements.unwrap().relative_error()));
        let own = judgement.windows.iter().filter(|on| on.curve == row.curve && !on.is_whole_band);
        let worst = row.worst_window.unwrap();
        assert!(own.clone().any(|on| (on.shortest_m, on.ratio()) == (worst.shortest_m, Some(worst.ratio))));
        assert_eq!(row.agreeing, own.filter(|on| on.verdict == Verdict::Agrees).count());
    }
}

#[test]
fn elements_are_those_of_the_material_whichever_curves_are_listed() {
    let headline = |curves: &[&str]| {
        let scene = scene(0.9, "yield_strength = \"300 MPa\"", "\"300 MPa\"", curves);
        *judged(&scene, &coarse(64, 3)).1.headline(0).unwrap()
    };
    let (one, three) = (
        headline(&["model = \"elastic\""]),
        headline(&["model = \"elastic\"", "model = \"persson-plastic\""]),
    );
    assert!(
        matches!(one.basis, Basis::Elements(Reference::Yielding { hardness_pa }) if (hardness_pa / 900e6 - 1.0).abs() < 1e-12)
    );
    assert_eq!(
        (one.basis, one.area_fraction, one.low, one.high),
        (three.basis, three.area_fraction, three.low, three.high)
    );
    assert_eq!((one.best_curve, three.best_curve), (None, Some(1)));
}

#[test]
fn a_range_reaches_to_what_flowing_peaks_add_where_no_scale_yields_on_average() {
    let judgement = |material: &str| {
        judged(&scene(0.9, material, "\"20 MPa\"", &["model = \"persson\""]), &coarse(64, 3)).1
    };
    let elastic = judgement("");
    let mean_pa = elastic.yielding[0].elastic_pressure_pa;
    let [barely, hardly] =
        [1.01, 2.0].map(|over| judgement(&format!("yield_strength = \"{} Pa\"", over * mean_pa / 3.0)));
    let [elastic, barely, hardly] = [&elastic, &barely, &hardly].map(|of| *of.headline(0).unwrap());
    // Elements limited to such a hardness touch 6 to 9 % more (light loads, Hurst exponent 0.8).
    let reach = barely.high / elastic.high;
    assert!(reach > 1.06 && reach < 1.09, "{reach}");
    assert_eq!((barely.area_fraction, barely.low), (elastic.area_fraction, elastic.low));
    assert!(hardly.high / elastic.high < 1.005, "{hardly:?}");
}

#[test]
fn a_hardness_that_may_grow_leaves_two_areas_side_by_side() {
    let headline = |length: &str| {
        let material = format!("yield_strength = \"100 MPa\"\nstrain_gradient_length = \"{length}\"");
        let scene = scene(0.9, &material, "\"200 MPa\"", &["model = \"elastic\""]);
        *judged(&scene, &coarse(64, 3)).1.headline(0).unwrap()
    };
    // Grown beyond every pressure, the contact stays elastic; at the constant hardness it touches more.
    let grown = headline("1 mm");
    let Some(otherwise) = grown.otherwise else { panic!("{grown:?}") };
    assert_eq!(grown.basis, Basis::Elements(Reference::Elastic));
    assert!(otherwise.elements.area_fraction > grown.high, "{grown:?}");
    // Grown a little, it still yields: the range reaches up to elements with the constant hardness, and has no middle.
    let little = headline("1 nm");
    assert_eq!((little.basis, little.otherwise), (Basis::Elements(Reference::Growing), None));
    assert_eq!((little.area_fraction, little.best_curve), (None, None));
    assert!(little.low < otherwise.elements.area_fraction, "{little:?}");
    assert!(otherwise.elements.area_fraction < little.high, "{little:?}");
}

#[test]
fn what_yields_while_it_hardens_touches_as_much_as_elastic_bodies_at_least() {
    for length in ["10 nm", "50 nm", "200 nm"] {
        let material = format!("yield_strength = \"100 MPa\"\nstrain_gradient_length = \"{length}\"");
        let scene = scene(2.2, &material, "\"100 MPa\"", &["model = \"elastic\""]);
        let judgement = judged(&scene, &coarse(64, 3)).1;
        let elastic = judgement.references.iter().find(|area| area.reference == Reference::Elastic);
        let least = elastic.and_then(|area| area.range).unwrap().low;
        assert!(judgement.headline(0).unwrap().low >= least, "{:?} {least}", judgement.headline(0));
    }
}

#[test]
fn what_yields_is_held_against_saturated_elements_and_elastic_curves_are_out_of_range() {
    let curves = ["model = \"elastic\"", "model = \"persson-plastic\"", "model = \"elastic-plastic\""];
    let scene = scene(0.9, "yield_strength = \"300 MPa\"", "\"300 MPa\"", &curves);
    let (_, judgement) = judged(&scene, &coarse(64, 3));
    assert_eq!(judgement.curves[0].verdict, Verdict::OutOfRange, "{:?}", judgement.curves[0]);
    assert_eq!(judgement.curves[0].reason.code, RemarkCode::AssumesNoYielding);
    let plastic = &judgement.curves[1];
    assert_eq!(plastic.verdict, Verdict::Agrees, "{plastic:?}");
    // The load over the hardness is the least that can touch.
    let elements = plastic.elements.unwrap();
    assert!(elements.area_fraction >= 300.0 / 900.0 && elements.low() >= 300.0 / 900.0, "{elements:?}");
    let headline = judgement.headline(0).unwrap();
    assert!(matches!(headline.basis, Basis::Elements(Reference::Yielding { .. })));
    assert!(matches!(headline.best_curve, Some(1 | 2)), "{headline:?}");
}

#[test]
fn a_strength_that_grows_beyond_every_pressure_is_held_against_elastic_elements() {
    let curves = ["model = \"persson-plastic\"\nstrain_gradient = true"];
    let material = "yield_strength = \"100 GPa\"\nstrain_gradient_length = \"1 nm\"";
    let hard = judged(&scene(0.9, material, "\"300 MPa\"", &curves), &coarse(48, 4)).1.curves;
    assert!(hard[0].reference == Reference::Elastic && hard[0].verdict.compares(), "{hard:?}");
}

#[test]
fn a_hardness_law_of_its_own_is_not_judged_unless_it_never_matters() {
    let curves = ["model = \"persson-plastic\"\nhardness_law = \"power:0.1\"", "model = \"persson\""];
    let verdict = |strength: &str| {
        let scene = scene(0.9, &format!("yield_strength = \"{strength}\""), "\"300 MPa\"", &curves);
        let curve = judged(&scene, &coarse(48, 2)).1.curves.swap_remove(0);
        (curve.verdict, curve.reason)
    };
    let yields = verdict("200 MPa");
    assert_eq!((yields.0, yields.1.code), (Verdict::NotJudged, RemarkCode::OwnHardnessLaw), "{yields:?}");
    assert!(verdict("100 GPa").0.compares(), "{:?}", verdict("100 GPa"));
}

#[test]
fn a_hardness_that_grows_gives_the_range_from_its_own_area_to_that_of_the_constant_one() {
    let curves = ["model = \"persson-plastic\"\nstrain_gradient = true", "model = \"persson-plastic\""];
    let scene = scene(
        2.2,
        "yield_strength = \"1 GPa\"\nstrain_gradient_length = \"1e-4 pm\"",
        "\"300 MPa\"",
        &curves,
    );
    let (_, judgement) = judged(&scene, &coarse(48, 2));
    let [growing, constant] = [0, 1].map(|curve| judgement.curves[curve].range.unwrap());
    assert_eq!((judgement.curves[0].reference, judgement.curves[0].elements), (Reference::Growing, None));
    assert_eq!(growing.high, constant.high);
    assert!(
        (growing.low / 0.1 - 1.0).abs() < 1e-4 && growing.low <= constant.low,
        "{growing:?} {constant:?}"
    );
    let headline = judgement.headline(0).unwrap();
    assert_eq!((headline.area_fraction, headline.low, headline.high), (None, growing.low, growing.high));
}

#[test]
fn a_curve_between_the_growing_and_the_constant_hardness_is_not_judged() {
    let curves = [
        "model = \"persson-plastic\"\nstrain_gradient = true",
        "model = \"elastic-plastic\"\nstrain_gradient = true",
    ];
    let scene =
        scene(2.2, "yield_strength = \"100 MPa\"\nstrain_gradient_length = \"3 nm\"", "\"30 MPa\"", &curves);
    let (_, judgement) = judged(&scene, &coarse(48, 2));
    let mut between = 0;
    for curve in &judgement.curves {
        let (range, area_fraction) = (curve.range.unwrap(), curve.area_fraction.unwrap());
        let is_between = area_fraction * 4.0 / 3.0 > range.low && area_fraction < range.high * 4.0 / 3.0;
        assert_eq!(curve.reason.code == RemarkCode::BetweenHardnesses, is_between, "{curve:?}");
        between += usize::from(is_between);
    }
    assert!(between > 0, "{:?}", judgement.curves);
}

#[test]
fn the_budget_fixes_the_work_and_what_is_cancelled_is_not_judged() {
    let scene = scene(1.6, "", "\"1 MPa\", \"20 MPa\", \"30 MPa\", \"50 MPa\"", &ELASTIC);
    let results = scene.plan().compute().unwrap();
    let plan =
        |budget: f64| JudgePlan::new(&scene, &results, &JudgeSettings { budget, ..JudgeSettings::default() });
    let extents = [3e6, 3e7].map(|budget| plan(budget).run(&Unobserved).unwrap().extent.unwrap());
    for (extent, budget) in extents.iter().zip([3e6, 3e7]) {
        assert!(extent.estimated <= budget && extent.spent <= 1.2 * budget, "{extent:?}");
    }
    assert!(extents[0].grid < extents[1].grid);
    let nothing = plan(1e3);
    assert_eq!(nothing.solutions(), 0);
    let judgement = nothing.run(&Unobserved).unwrap();
    assert!(judgement.curves.iter().all(|curve| curve.reason.code == RemarkCode::BeyondBudget));
    let cancelled = plan(3e6).run(&Cancelled).unwrap();
    assert!(cancelled.curves.iter().all(|curve| curve.verdict == Verdict::NotJudged));
    assert!(cancelled.windows.iter().any(|on| on.reason.code == RemarkCode::NotSolved));
    assert!(matches!(cancelled.headline(0).unwrap().basis, Basis::RangeOfModels { .. }));
}

#[test]
fn a_last_window_that_would_be_pressed_flat_reaches_to_longer_waves() {
    let spectrum = SelfAffine { decades: 2.0, has_step: true };
    let scene = scene_on(&spectrum, "", "\"300 MPa\"", &ELASTIC);
    let elements = |judgement: &Judgement| judgement.references[0].elements.unwrap();
    let shortest = |judgement: &Judgement| {
        let last = judgement.windows.iter().rfind(|on| !on.is_whole_band).unwrap();
        (last.longest_m, last.elements.unwrap().area_fraction)
    };
    let (_, fixed) = judged(&scene, &JudgeSettings { grid: Some(96), ..JudgeSettings::default() });
    let extent = fixed.extent.as_ref().unwrap();
    assert_eq!((extent.grid, extent.grid_of_last), (96, 96));
    let (longest_m, flat) = shortest(&fixed);
    assert!(flat > 0.9, "{flat}");
    let (_, longer) = judged(&scene, &JudgeSettings { budget: 6e6, ..JudgeSettings::default() });
    let extent = longer.extent.as_ref().unwrap();
    assert!(extent.grid_of_last > extent.grid && extent.estimated <= 6e6, "{extent:?}");
    let (from_m, area) = shortest(&longer);
    assert!(from_m > longest_m && area < flat, "{from_m} {area}");
    let error = elements(&fixed).relative_error().hypot(elements(&longer).relative_error());
    let ratio = elements(&longer).area_fraction / elements(&fixed).area_fraction;
    assert!(ratio.ln().abs() < 3.0 * error, "{ratio} {error}");
}

/// Elements on the whole band of 6.5 decades, pressed in pairs on all windows but the last unless the number of surfaces is given.
#[test]
fn windows_that_know_their_scatter_together_are_pressed_in_pairs_and_leave_the_whole_band_as_it_was() {
    let scene = scene(6.5, "", "\"30 kPa\", \"3 MPa\"", &ELASTIC);
    let results = scene.plan().compute().unwrap();
    let run = |realisations| {
        let settings = JudgeSettings { grid: Some(48), realisations, ..JudgeSettings::default() };
        let plan = JudgePlan::new(&scene, &results, &settings);
        let counted = Counted::default();
        let judgement = plan.run(&counted).unwrap();
        assert_eq!(counted.0.into_inner(), plan.solutions());
        judgement
    };
    let (pairs, fours) = (run(None), run(Some(4)));
    let surfaces = |judgement: &Judgement| {
        let extent = judgement.extent.as_ref().unwrap();
        (extent.realisations, extent.realisations_of_last)
    };
    assert_eq!((surfaces(&pairs), surfaces(&fours)), ((2, 4), (4, 4)));
    let spent = |judgement: &Judgement| judgement.extent.as_ref().unwrap().spent;
    assert!(spent(&pairs) < 0.6 * spent(&fours));
    for (pair, four) in pairs.curves.iter().zip(&fours.curves) {
        assert_eq!((pair.elements, pair.verdict), (four.elements, four.verdict));
    }
    // Areas on windows differ by their errors, and errors by little in the mean.
    let on_windows = || pairs.windows.iter().zip(&fours.windows).filter(|(on, _)| !on.is_whole_band);
    let areas: Vec<_> = on_windows().filter_map(|(pair, four)| pair.elements.zip(four.elements)).collect();
    let apart = |(pair, four): &&(judge::ElementArea, judge::ElementArea)| {
        let error = pair.relative_error().hypot(four.relative_error());
        (pair.area_fraction / four.area_fraction).ln().abs() < 2.0 * error
    };
    assert!(areas.iter().filter(apart).count() as f64 >= 0.95 * areas.len() as f64);
    let widened = areas.iter().map(|(pair, four)| pair.relative_error() / four.relative_error());
    let mean = widened.sum::<f64>() / areas.len() as f64;
    assert!(mean < 1.15, "{mean}");
}

#[test]
fn a_step_of_progress_is_a_surface_under_one_pressure() {
    let scene = scene(0.9, "", "\"100 MPa\", \"200 MPa\"", &["model = \"persson\""]);
    let results = scene.plan().compute().unwrap();
    let plan = JudgePlan::new(&scene, &results, &coarse(64, 4));
    let counted = Counted::default();
    plan.run(&counted).unwrap();
    assert_eq!(counted.0.into_inner(), plan.solutions());
    assert!(plan.solutions() > 0);
}

#[test]
fn a_hundred_pairs_of_seeds_differ_by_their_standard_errors() {
    // A spectrum of an area determines its end, and no area is carried down under this load.
    let scene = scene_on(&White(0.6), "", "\"4 GPa\"", &["model = \"persson\""]);
    let results = scene.plan().compute().unwrap();
    let area = |seed: u64| {
        let settings = JudgeSettings { seed, ..coarse(64, 4) };
        let judgement = JudgePlan::new(&scene, &results, &settings).run(&Unobserved).unwrap();
        judgement.curves[0].elements.unwrap()
    };
    let within = (0..100).filter(|pair| {
        let [one, other] = [area(2 * pair), area(2 * pair + 1)];
        // The error of the grid, 1.5 %, is the same under every seed.
        let of_surfaces = (one.standard_error.powi(2) - (0.015 * one.area_fraction).powi(2)).sqrt();
        (one.area_fraction - other.area_fraction).abs() <= 2.8 * of_surfaces
    });
    let within = within.count();
    assert!((90..=99).contains(&within), "{within}");
}

#[test]
fn a_layer_of_the_material_of_its_base_is_judged_as_a_half_space() {
    let steel = "youngs_modulus = \"200 GPa\"\npoisson_ratio = 0.3";
    let plain = scene(1.6, "", "\"300 MPa\"", &["model = \"persson\""]);
    let [plain, same] = [plain, layered(1.6, "30 nm", steel)].map(|scene| judged(&scene, &coarse(48, 2)).1);
    for (plain, same) in plain.windows.iter().zip(&same.windows) {
        let [plain, same] = [plain, same].map(|row| (row.elements.unwrap(), row.area_fraction.unwrap()));
        assert!((same.0.area_fraction / plain.0.area_fraction - 1.0).abs() < 1e-3, "{plain:?} {same:?}");
        assert!((same.1 / plain.1 - 1.0).abs() < 1e-3, "{plain:?} {same:?}");
    }
    let [plain, same] = [&plain, &same].map(|judgement| judgement.headline(0).unwrap());
    assert!((same.area_fraction.unwrap() / plain.area_fraction.unwrap() - 1.0).abs() < 1e-3);
}

#[test]
fn windows_of_a_layer_carry_over_to_the_whole_band() {
    // The base is felt by the long waves alone: the last windows are those of a half-space.
    for (constants, stiffer) in [("", true), ("youngs_modulus = \"20 GPa\"\npoisson_ratio = 0.3", false)] {
        let coated = layered(1.5, "50 nm", constants);
        let [whole, windows] = [256, 64].map(|grid| judged(&coated, &coarse(grid, 4)).1);
        assert_eq!(whole.extent.as_ref().unwrap().windows, 1);
        assert!(windows.extent.as_ref().unwrap().windows > 2);
        let [whole, windows] = [&whole, &windows].map(|judgement| judgement.references[0].elements.unwrap());
        let ratio = windows.area_fraction / whole.area_fraction;
        let errors = whole.relative_error().hypot(windows.relative_error());
        assert!((ratio - 1.0).abs() < 2.0 * errors, "{constants:?}: {ratio}, {errors}");
        let half_space = scene(1.5, "", "\"300 MPa\"", &["model = \"persson\""]);
        let half_space = judged(&half_space, &coarse(64, 4)).1.references[0].elements.unwrap();
        assert_eq!(windows.area_fraction < half_space.area_fraction, stiffer, "{windows:?} {half_space:?}");
    }
}

#[test]
fn a_smaller_budget_leaves_loads_out_and_then_surfaces() {
    // No area is carried down under loads that are so heavy.
    let loads = "\"10 GPa\", \"6 GPa\", \"8 GPa\", \"14 GPa\", \"12 GPa\"";
    let scene = scene(0.4, "", loads, &ELASTIC[1..2]);
    let results = scene.plan().compute().unwrap();
    let run = |budget: f64, realisations: Option<usize>| {
        let settings = JudgeSettings { budget, realisations, grid: Some(48), ..JudgeSettings::default() };
        JudgePlan::new(&scene, &results, &settings).run(&Unobserved).unwrap()
    };
    // Points times operators of a solution.
    let of_solution = 48.0 * 48.0 * 20.0 * 0.75f64.powf(0.3);
    let all = run(1e9, Some(4));
    let windows = all.extent.as_ref().unwrap().windows;
    let cost = |loads: usize, surfaces: usize| (windows * loads * surfaces) as f64 * of_solution;
    // From light to heavy the loads are 1, 2, 0, 4, 3.
    for (loads, surfaces, chosen) in [(5, 4, vec![0, 1, 2, 3, 4]), (3, 4, vec![0, 1, 3]), (1, 4, vec![0])] {
        let judgement = run(cost(loads, surfaces) * (1.0 + 1e-9), Some(surfaces));
        let extent = judgement.extent.as_ref().unwrap();
        assert_eq!((extent.loads, extent.realisations, extent.grid_of_last), (loads, surfaces, 48));
        assert_eq!(extent.solved, windows * loads);
        assert!((extent.estimated / cost(loads, surfaces) - 1.0).abs() < 1e-9, "{extent:?}");
        for curve in &judgement.curves {
            assert_eq!(curve.elements.is_some(), chosen.contains(&curve.load), "{curve:?}");
            let code =
                if curve.elements.is_some() { RemarkCode::ComparedAreas } else { RemarkCode::LoadNotChosen };
            assert_eq!(curve.reason.code, code);
        }
        let less = run(cost(loads, surfaces) * (1.0 - 1e-9), Some(surfaces)).extent;
        assert!(less.is_none_or(|less| less.loads < loads));
    }
    // Four surfaces unless a number is given, and two of the middle load where they are too many.
    let extents = [1e9, cost(1, 4) * (1.0 - 1e-9), cost(1, 2) * (1.0 + 1e-9)]
        .map(|budget| run(budget, None).extent.unwrap());
    assert_eq!(extents.each_ref().map(|of| (of.loads, of.realisations)), [(5, 4), (1, 2), (1, 2)]);
    assert!(run(cost(1, 2) * (1.0 - 1e-9), None).extent.is_none());
}

#[test]
fn models_alone_give_a_range_from_the_least_to_the_most_of_their_areas() {
    let scene = scene(0.9, "", "\"100 MPa\", \"1 GPa\"", &ELASTIC);
    let results = scene.plan().compute().unwrap();
    let settings = JudgeSettings { budget: 1.0, ..JudgeSettings::default() };
    let judgement = JudgePlan::new(&scene, &results, &settings).run(&Unobserved).unwrap();
    for load in [0, 1] {
        let mut areas: Vec<(f64, usize)> = (0..ELASTIC.len())
            .filter_map(|curve| Some((results.curves[curve].area_fractions(load).last()?.1, curve)))
            .collect();
        areas.sort_by(|a, b| a.0.total_cmp(&b.0));
        let ((low, least), (high, most)) = (areas[0], areas[areas.len() - 1]);
        let headline = judgement.headline(load).unwrap();
        assert_eq!((headline.load, headline.basis), (load, Basis::RangeOfModels { least, most }));
        assert_eq!((headline.low, headline.high, headline.area_fraction), (low, high, None));
        assert!(low < high);
    }
}

#[test]
fn an_elastic_curve_is_out_of_range_from_the_scale_at_which_its_own_pressure_exceeds_the_hardness() {
    let scene = scene(2.2, "yield_strength = \"1.5 GPa\"", "\"30 MPa\", \"1 GPa\"", &ELASTIC[..2]);
    let (results, judgement) = judged(&scene, &coarse(48, 2));
    let mut beyond = 0;
    for row in &judgement.curves {
        let nominal_pa = [30e6, 1e9][row.load];
        let areas = results.curves[row.curve].area_fractions(row.load);
        let above = areas.iter().find(|(_, area)| nominal_pa / area > 4.5e9);
        let broken = (row.reason.code == RemarkCode::AssumesNoYielding).then(|| {
            assert_eq!(row.verdict, Verdict::OutOfRange);
            let [wavelength_m, pressure_pa, hardness_pa] =
                ["wavelength_m", "pressure_pa", "hardness_pa"].map(|key| row.reason.number(key).unwrap());
            assert!((hardness_pa / 4.5e9 - 1.0).abs() < 1e-12);
            (wavelength_m, nominal_pa / pressure_pa)
        });
        assert_eq!(broken.map(|at| at.0), above.map(|at| at.0), "{row:?}");
        let Some((above_m, area)) = above else { continue };
        assert!((broken.unwrap().1 / area - 1.0).abs() < 1e-12);
        beyond += 1;
        // It is out of range on windows that hold such waves, and compared on those above.
        let own = judgement.windows.iter().filter(|on| (on.curve, on.load) == (row.curve, row.load));
        let holds_them = |shortest_m: f64| shortest_m <= above_m * (1.0 + 1e-6);
        let mut seen = [false; 2];
        for on in own.filter(|on| on.elements.is_some() && on.area_fraction.is_some()) {
            assert_eq!(on.verdict == Verdict::OutOfRange, holds_them(on.shortest_m), "{on:?}");
            seen[usize::from(holds_them(on.shortest_m))] = true;
        }
        assert!(seen[1], "{row:?}");
    }
    assert!((1..4).contains(&beyond), "{beyond}");
}

#[test]
fn a_law_of_asperities_is_out_of_range_where_a_twentieth_of_the_load_lies_beyond_its_fit() {
    let curves = ["model = \"ep-sphere\"", "model = \"hertz\""];
    let scene = scene(0.9, "yield_strength = \"2.5 GPa\"", "\"10 MPa\", \"300 MPa\", \"5 GPa\"", &curves);
    let results = scene.plan().compute().unwrap();
    let settings = JudgeSettings { budget: 1.0, ..JudgeSettings::default() };
    let judgement = JudgePlan::new(&scene, &results, &settings).run(&Unobserved).unwrap();
    let mut unfitted = 0;
    for row in judgement.curves.iter().filter(|row| row.curve == 0) {
        let states = &results.curves[0].statistical().unwrap()[row.load];
        let share = |at: usize| states[at].contact.map_or(0.0, |found| found.1.out_of_range_load_share);
        let first = (0..states.len()).find(|at| share(*at) > 0.05);
        assert_eq!(row.reason.code == RemarkCode::UnfittedLaw, first.is_some(), "{row:?}");
        if let Some(first) = first {
            assert_eq!(row.reason.number("wavelength_m"), Some(states[first].wavelength_m));
            assert_eq!(row.reason.number("load_share"), Some(share(first)));
            unfitted += 1;
        }
    }
    assert!((1..3).contains(&unfitted), "{unfitted}");
}
