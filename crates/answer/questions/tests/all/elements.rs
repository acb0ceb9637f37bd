//! Maps and random surfaces that a flat is pressed onto.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

use elements::{Boundary, ElementsError, PressedLoad, Relief, SpecimenCompliance};
use numerics::parallel::Unobserved;
use questions::{
    ElementsLoad, ElementsQuestion, GapQuestion, MapQuestion, QuestionError, RandomInput, relief,
};
use scene::{Overrides, Scene};
use units::{Pressure, PressureRange, Remark, RemarkCode, display};

use crate::common::{
    Counted, STEEL_MODULUS_PA, assert_all_near, assert_near, by, column, hard, has, load, loads, numbers_of,
    small, spectrum_of, steel, surface, text_of,
};

const POINTS: usize = 32;
const SIDE_M: f64 = 3.2e-5;
const AMPLITUDE_M: f64 = 1e-8;
/// Mean pressure that flattens [`ridge`] \[Pa\]: pi E* times amplitude over wavelength.
const FLATTENS_PA: f64 = PI * STEEL_MODULUS_PA * AMPLITUDE_M / SIDE_M;

/// A map of heights over x and y in sides of the map.
pub fn map(boundary: Boundary, height_m: impl Fn(f64, f64) -> f64) -> Relief {
    let at =
        |point: usize| ((point % POINTS) as f64 / POINTS as f64, (point / POINTS) as f64 / POINTS as f64);
    Relief {
        rows: POINTS,
        columns: POINTS,
        length_x_m: SIDE_M,
        length_y_m: SIDE_M,
        heights_m: (0..POINTS * POINTS).map(at).map(|(x, y)| height_m(x, y)).collect(),
        boundary,
        is_missing: Vec::new(),
    }
}

/// One ridge along y.
pub fn ridge() -> Relief {
    map(Boundary::Periodic, |x, _| AMPLITUDE_M * (TAU * x).cos())
}

/// One ridge along x.
pub fn ridge_along_x() -> Relief {
    map(Boundary::Periodic, |_, y| AMPLITUDE_M * (TAU * y).cos())
}

fn flat(pressures_pa: &[f64]) -> ElementsQuestion {
    let loads = loads(pressures_pa).into_iter().map(ElementsLoad::from).collect();
    ElementsQuestion { material: steel(), loads, random: small(2), ..ElementsQuestion::default() }
}

fn press(question: &ElementsQuestion, maps: Vec<Relief>) -> (Vec<PressedLoad>, Vec<Remark>) {
    question.on_maps(maps).unwrap().answer::<ElementsError>(|_| Ok(()), &Unobserved).unwrap()
}

#[test]
fn a_ridge_is_flattened_as_westergaard_has_it_under_loads_of_every_unit() {
    // A = (2/pi) asin(sqrt(p/p*)).
    let area = |share: f64| 2.0 / PI * share.sqrt().asin();
    let rms_gradient = ridge().rms_gradient();
    for share in [0.25, 0.5, 0.75] {
        let pressure_pa = share * FLATTENS_PA;
        let loads = [
            ElementsLoad::Pressure(load(pressure_pa)),
            ElementsLoad::Moduli { moduli: pressure_pa / STEEL_MODULUS_PA },
            ElementsLoad::ReducedModuli { reduced_moduli: pressure_pa / STEEL_MODULUS_PA / rms_gradient },
            format!("{pressure_pa} Pa").parse().unwrap(),
            format!("{} E*", pressure_pa / STEEL_MODULUS_PA).parse().unwrap(),
            format!("{} E* h'", pressure_pa / STEEL_MODULUS_PA / rms_gradient).parse().unwrap(),
        ];
        let count = loads.len();
        let question = ElementsQuestion { loads: loads.into(), ..flat(&[]) };
        for pressed in press(&question, vec![ridge()]).0 {
            assert_near(pressed.nominal_pressure_pa, pressure_pa, 1e-9);
            assert!((pressed.states[0].numbers.area_fraction - area(share)).abs() < 0.07);
            assert!(pressed.states[0].stiffness_pa_per_m.is_some());
        }
        let prepared = question.on_maps(vec![ridge(), ridge()]).unwrap();
        let progress = Counted::new();
        prepared.answer::<ElementsError>(|_| Ok(()), &progress).unwrap();
        assert_eq!((prepared.loads(), prepared.steps()), (count, progress.count()));
    }
    let [gap, way] =
        [ElementsLoad::MeanGap { mean_gap_m: 5e-9 }, ElementsLoad::Indentation { indentation_m: 5e-9 }].map(
            |load| {
                press(&ElementsQuestion { loads: vec![load], ..flat(&[]) }, vec![ridge()]).0[0]
                    .mean()
                    .mean_gap_m
            },
        );
    assert_near(gap, 5e-9, 1e-4);
    // Pressed by 5 nm from the summit, whose height is 10 nm.
    assert_near(way, 5e-9, 0.2);
}

#[test]
fn loads_that_cannot_be_pressed_are_refused() {
    let saturated = |saturation, material| ElementsQuestion { saturation, material, ..flat(&[1e8]) };
    let hardness = Some(Pressure::Hardnesses(1.0));
    assert!(matches!(saturated(hardness, steel()).check(), Err(QuestionError::SaturationWithoutHardness)));
    assert!(saturated(hardness, hard(2e8)).check().is_ok());
    assert!(matches!(saturated(hardness, hard(5e7)).check(), Err(QuestionError::Elements(_))));
    let loose = ElementsQuestion { tolerance: Some(0.2), ..flat(&[1e8]) };
    assert!(matches!(loose.check(), Err(QuestionError::Elements(_))));
    let in_hardnesses = ElementsQuestion { loads: vec!["0.1 H".parse().unwrap()], ..flat(&[]) };
    assert!(matches!(in_hardnesses.check(), Err(QuestionError::Load { option: "pressure", .. })));
    let range = "1 MPa:4 MPa:3".parse::<PressureRange>().unwrap();
    let ranged = ElementsQuestion { pressure_ranges: vec![range], ..flat(&[8e6]) };
    let pressures =
        press(&ranged, vec![ridge()]).0.iter().map(|load| load.nominal_pressure_pa).collect::<Vec<_>>();
    assert_all_near(&pressures, &[8e6, 1e6, 2e6, 4e6], 1e-9);
    let cancelled = flat(&[1e6]).on_maps(vec![ridge()]).unwrap();
    let stopped = cancelled.answer::<ElementsError>(|_| Ok(()), &Counted::cancelled());
    assert!(stopped.is_err_and(|error| QuestionError::from(error).is_cancelled()));
    let crowded = ElementsQuestion { random: RandomInput { grid: Some(3), ..small(1) }, ..flat(&[1e6]) };
    assert!(matches!(crowded.on(&surface()), Err(QuestionError::RandomSurfaces { .. })));
}

#[test]
fn every_choice_of_random_surfaces_is_known_by_its_option() {
    let names = ["grid", "realisations", "seed", "shortest", "longest", "side", "phases"];
    let all = RandomInput {
        grid: Some(16),
        realisations: Some(1),
        seed: Some(1),
        longest_m: Some(1.0),
        shortest_m: Some(1.0),
        side_m: Some(1.0),
        phases: Some(Default::default()),
    };
    assert_eq!(all.given(), names.map(|name| (name, true)));
    assert_eq!(RandomInput::default().given(), names.map(|name| (name, false)));
}

#[test]
fn ridges_close_the_paths_across_them_and_a_full_contact_all() {
    let share = 0.5 * FLATTENS_PA;
    let paths = |maps: Vec<Relief>, pressures_pa: &[f64]| {
        let notes = press(&flat(pressures_pa), maps).1;
        has(&notes, RemarkCode::ClosedPaths).then(|| text_of(&notes, RemarkCode::ClosedPaths, "paths"))
    };
    let summit = map(Boundary::Periodic, |x, y| AMPLITUDE_M * ((TAU * x).cos() + (TAU * y).cos()));
    assert_eq!(paths(vec![summit.clone()], &[1e-3 * share]), None);
    let along_y = paths(vec![ridge()], &[share]).unwrap();
    // Turned round, x and y change places.
    let along_x = paths(vec![ridge_along_x()], &[share]).unwrap();
    assert_eq!(along_x.replace(" x ", " y "), along_y);
    assert_ne!(along_x, along_y);
    let shut = paths(vec![ridge()], &[1.5 * FLATTENS_PA]).unwrap();
    let of_both = paths(vec![ridge()], &[share, 1.5 * FLATTENS_PA]).unwrap();
    assert!(of_both.contains(&along_y) && of_both.contains(&shut) && !shut.contains(&along_y));
    assert!(shut.contains(&display::pressure(1.5 * FLATTENS_PA)));
    // One surface of two that is open in both directions, and one in one.
    assert!(paths(vec![ridge(), summit.clone()], &[1e-3 * share]).is_some());
    assert_eq!(paths(vec![summit.clone(), summit], &[1e-3 * share]), None);
}

#[test]
fn remarks_on_pressed_maps_name_coarse_grids_rounding_and_loads_that_unload_nothing() {
    let codes = |question: &ElementsQuestion, map: Relief| -> Vec<RemarkCode> {
        press(question, vec![map]).1.into_iter().map(|note| note.code).collect()
    };
    let rough = || {
        map(Boundary::Periodic, |x, y| AMPLITUDE_M * ((37.0 * x * x + 91.0 * y + 53.0 * x * y) * 9.0).sin())
    };
    assert!(codes(&flat(&[1e7]), rough()).contains(&RemarkCode::CoarseForSpots));
    assert!(!codes(&flat(&[0.4 * FLATTENS_PA]), ridge()).contains(&RemarkCode::CoarseForSpots));
    // An odd side has no coarser grid to tell by.
    let mut odd = rough();
    (odd.columns, odd.rows) = (POINTS * POINTS, 1);
    odd.heights_m.truncate(POINTS * POINTS);
    assert!(!codes(&flat(&[1e7]), odd).contains(&RemarkCode::CoarseForSpots));
    assert!(!codes(&flat(&[1e7]), rough()).contains(&RemarkCode::RoundedResidual));
    let exact = ElementsQuestion { tolerance: Some(1e-16), ..flat(&[1e7]) };
    assert!(codes(&exact, rough()).contains(&RemarkCode::RoundedResidual));
    // Flowed peaks do not spring back.
    let [high, low] = [0.5 * FLATTENS_PA, 0.2 * FLATTENS_PA];
    let yields = |saturation_pa: Option<f64>, pressures_pa: &[f64]| {
        let saturation = saturation_pa.map(Pressure::Pascals);
        codes(&ElementsQuestion { saturation, ..flat(pressures_pa) }, ridge())
            .contains(&RemarkCode::Unloading)
    };
    let flows = Some(FLATTENS_PA);
    assert!(yields(flows, &[high, low]) && !yields(flows, &[low, high]) && !yields(flows, &[high, high]));
    assert!(!yields(None, &[high, low]) && !yields(Some(1e12), &[high, low]));
}

#[test]
fn the_compliance_of_a_specimen_is_noted_with_what_is_left() {
    let free = Relief { boundary: Boundary::Free, ..ridge() };
    let pressed_with = |compliance, map: &Relief| {
        let question = ElementsQuestion { compliance, ..flat(&[1e7]) };
        let prepared = question.on_maps(vec![map.clone()]).unwrap();
        let (loads, notes) = prepared.answer::<ElementsError>(|_| Ok(()), &Unobserved).unwrap();
        let codes = prepared.notes.iter().chain(&notes).map(|note| note.code).collect::<Vec<_>>();
        (loads[0].states[0], codes)
    };
    let (whole, noted) = pressed_with(None, &free);
    assert!(noted.contains(&RemarkCode::StiffnessOfPunch));
    let kinds = [
        (SpecimenCompliance::Punch, RemarkCode::StiffnessWithoutPunch),
        (SpecimenCompliance::Even, RemarkCode::StiffnessWithoutEven),
    ];
    for (kind, code) in kinds {
        let (state, noted) = pressed_with(Some(kind), &free);
        assert!(noted.contains(&code) && !noted.contains(&RemarkCode::StiffnessOfPunch));
        let sum = 1.0 / state.stiffness_pa_per_m.unwrap() + state.compliance_m_per_pa;
        assert!((sum * whole.stiffness_pa_per_m.unwrap() - 1.0).abs() < 1e-12);
    }
    assert!(pressed_with(Some(SpecimenCompliance::None), &free).0 == whole);
    let level = Relief { heights_m: vec![0.0; POINTS * POINTS], ..free };
    let (state, noted) = pressed_with(Some(SpecimenCompliance::Punch), &level);
    assert!(state.stiffness_pa_per_m.is_none() && noted.contains(&RemarkCode::NoStiffnessLeft));
    let question = ElementsQuestion { compliance: Some(SpecimenCompliance::Even), ..flat(&[1e7]) };
    let Err(QuestionError::Unused(idle)) = question.on_maps(vec![ridge()]) else { panic!("a periodic map") };
    assert_eq!((idle.code, idle.place.option.as_deref()), (RemarkCode::NoFreeEdges, Some("compliance")));
}

#[test]
fn missing_points_are_counted_by_kind() {
    let from_middle = |point: usize| {
        let [x, y] = [point % POINTS, point / POINTS].map(|at| at as f64 + 0.5 - 0.5 * POINTS as f64);
        x.hypot(y)
    };
    let ring = |point: usize| from_middle(point) > 0.45 * POINTS as f64 || from_middle(point) < 3.0;
    let map =
        Relief { boundary: Boundary::Free, is_missing: (0..POINTS * POINTS).map(ring).collect(), ..ridge() };
    let notes = flat(&[1e7]).on_maps(vec![map.clone()]).unwrap().notes;
    let note = notes.iter().find(|note| note.code == RemarkCode::MissingPointsOpen).unwrap();
    let holes = (0..POINTS * POINTS).filter(|&point| from_middle(point) < 3.0).count();
    let missing = map.is_missing.iter().filter(|is_missing| **is_missing).count();
    assert_eq!(note.number("holes"), Some(holes as f64));
    assert_eq!(note.number("outside"), Some((missing - holes) as f64));
}

#[test]
fn maps_are_doubted_for_steep_slopes_uneven_points_and_free_edges() {
    let codes = |maps: Vec<Relief>| -> Vec<RemarkCode> {
        flat(&[1e7]).on_maps(maps).unwrap().notes.iter().map(|note| note.code).collect()
    };
    assert!(codes(vec![ridge()]).is_empty());
    assert_eq!(codes(vec![Relief { boundary: Boundary::Free, ..ridge() }]), [RemarkCode::StiffnessOfPunch]);
    let half = Relief {
        rows: POINTS / 2,
        length_y_m: SIDE_M / 2.0,
        heights_m: vec![0.0; POINTS * POINTS / 2],
        ..ridge()
    };
    assert!(codes(vec![half.clone()]).is_empty());
    assert_eq!(codes(vec![Relief { length_y_m: SIDE_M, ..half }]), [RemarkCode::UnevenSpacing]);
    // A profile has no points across.
    let profile = Relief { rows: 1, length_y_m: 1.0, heights_m: vec![0.0; POINTS], ..ridge() };
    assert!(codes(vec![profile]).is_empty());
    let steep = map(Boundary::Periodic, |x, _| 2e-5 * (TAU * x).cos());
    assert_eq!(codes(vec![ridge(), steep]), [RemarkCode::SteepSurface]);
}

/// Waves from 100 to 20 um, with a factor on the spectrum.
fn narrow(factor: f64) -> study::surface::Surface {
    let row = |i: i32| {
        let wavelength_m = 1e-4 * 0.2f64.powf(f64::from(i) / 10.0);
        format!("{wavelength_m:e},{:e}\n", factor * 2e-23 * (wavelength_m / 1e-6).powf(2.6))
    };
    spectrum_of(&(0..=10).map(row).collect::<String>())
}

#[test]
fn random_surfaces_come_with_their_band_their_gradient_and_the_waves_they_leave_out() {
    let notes = |random: RandomInput, surface: &study::surface::Surface| {
        ElementsQuestion { random, ..flat(&[1e6]) }.on(surface).unwrap().notes
    };
    let whole = RandomInput { grid: Some(64), realisations: Some(3), ..RandomInput::default() };
    let found = notes(whole, &narrow(1.0));
    let [surfaces, points, side_m, longest_m, shortest_m, per_shortest, lengths] = numbers_of(
        &found,
        RemarkCode::RandomSurfaces,
        ["surfaces", "points", "side_m", "longest_m", "shortest_m", "points_per_shortest", "lengths"],
    );
    assert_eq!((surfaces, points), (3.0, 64.0));
    assert_all_near(&[longest_m, shortest_m], &[1e-4, 2e-5], 1e-6);
    assert_all_near(&[side_m / longest_m, 64.0 * shortest_m / side_m], &[lengths, per_shortest], 1e-9);
    let [gradient, reduced_pa] =
        numbers_of(&found, RemarkCode::RandomGradient, ["gradient", "reduced_modulus_pa"]);
    assert_near(reduced_pa, gradient * STEEL_MODULUS_PA, 1e-9);
    assert!(!has(&found, RemarkCode::WavesLeftOut) && !has(&found, RemarkCode::SteepWaves));
    for (longest_m, shortest_m) in [(Some(5e-5), None), (None, Some(3e-5))] {
        let cut = notes(RandomInput { longest_m, shortest_m, ..whole }, &narrow(1.0));
        let left_out = text_of(&cut, RemarkCode::WavesLeftOut, "where");
        assert_eq!(left_out.contains(&display::length(5e-5)), longest_m.is_some(), "{left_out}");
        assert_eq!(left_out.contains(&display::length(3e-5)), shortest_m.is_some(), "{left_out}");
    }
    // Slopes grow with the root of the spectrum; elements take them up to a pressure of E*/10.
    let steep = |gradient_wanted: f64| notes(whole, &narrow((gradient_wanted / gradient).powi(2)));
    assert!(!has(&steep(0.19), RemarkCode::SteepWaves));
    let [pressure] = numbers_of(&steep(0.21), RemarkCode::SteepWaves, ["pressure_over_modulus"]);
    assert_near(pressure, 0.105, 1e-9);
    assert!(has(&notes(whole, &narrow(1e9)), RemarkCode::FarTooSteepSurface));
}

#[test]
fn gaps_of_elements_yield_at_the_hardness_and_are_those_of_pressed_surfaces() {
    let gaps = |hardness_pa: f64| {
        let mut by = by(None);
        by.material = hard(hardness_pa);
        let question =
            GapQuestion { by, pressures: loads(&[1e8]), random: small(2), ..GapQuestion::default() };
        let progress = Counted::new();
        let table = question.answer(&surface(), &progress).unwrap().table;
        assert_eq!(question.steps(&surface()).unwrap(), progress.count());
        ["area_fraction", "mean_gap_m", "stiffness_pa_per_m"].map(|name| column(&table, name)[0].unwrap())
    };
    let pressed = |saturation: Option<Pressure>| {
        let question = ElementsQuestion { saturation, ..flat(&[1e8]) };
        let (pressed, _) =
            question.on(&surface()).unwrap().answer::<ElementsError>(|_| Ok(()), &Unobserved).unwrap();
        let mean = pressed[0].mean();
        [mean.best_area_fraction(), mean.mean_gap_m, mean.stiffness_pa_per_m.unwrap()]
    };
    assert_all_near(&gaps(1e12), &pressed(None), 1e-9);
    assert_all_near(&gaps(1e9), &pressed(Some(Pressure::Pascals(1e9))), 1e-9);
    assert!(gaps(1e9)[0] > 1.05 * gaps(1e12)[0]);
}

/// A scene with one map of `rows` and `columns` of points 1 um apart.
fn scene_of_map(rows: usize, columns: usize, body: &str) -> Scene {
    let height_nm = |row: usize, column: usize| {
        ((row * 7 + column * 13) % 29) as f64 + 10.0 * (column as f64 / 9.0).sin()
    };
    let text: String = (0..rows)
        .map(|row| {
            (0..columns).map(|column| format!("{} ", height_nm(row, column))).collect::<String>() + "\n"
        })
        .collect();
    let files = BTreeMap::from([("map.txt".to_owned(), text.into_bytes())]);
    let scene = format!(
        "[surface]\nscans = [{{ file = \"map.txt\", unit = \"nm\", size = \"{columns} um\" }}]\n[material]\n{body}\n\
         [loads]\npressures = [\"10 MPa\"]\n[[curve]]\nmodel = \"persson\"\n"
    );
    Scene::parse(&scene, &files, &Overrides::default()).unwrap_or_else(|error| panic!("{error:?}"))
}

#[test]
fn a_map_of_a_scene_is_pressed_as_it_was_scanned_between_the_bodies_of_the_scene() {
    let steel_text = "youngs_modulus = \"200 GPa\"\npoisson_ratio = 0.3\nindentation_hardness = \"0.5 GPa\"";
    let scene = scene_of_map(24, 24, steel_text);
    let question = MapQuestion::from_scene(&scene, 0).unwrap();
    assert!(question.is_whole() && MapQuestion::from_scene(&scene, 1).is_none());
    assert_near(question.contact_modulus_pa, STEEL_MODULUS_PA, 1e-12);
    assert_eq!(question.saturation_pa, Some(5e8));
    assert_all_near(&[question.relief.length_x_m, question.relief.length_y_m], &[2.4e-5; 2], 1e-9);
    let (pressed, _) = question.under(1e8).unwrap().answer::<ElementsError>(|_| Ok(()), &Unobserved).unwrap();
    // The map pressed by hand, with its hardness as the saturation.
    let by_hand = ElementsQuestion { saturation: Some(Pressure::Pascals(5e8)), ..flat(&[1e8]) };
    let (expected, _) = press(&by_hand, vec![question.relief.clone()]);
    assert_eq!(pressed, expected);
    assert!(
        pressed[0].mean().plastic_area_fraction > 0.0 && pressed[0].states[0].stiffness_pa_per_m.is_some()
    );
    assert!(question.under(3e9).is_err());
    // No more than 256 points along a side.
    let wide = MapQuestion::from_scene(&scene_of_map(16, 300, steel_text), 0).unwrap();
    assert_eq!((wide.is_whole(), wide.points_of_whole), (false, [300, 16]));
    assert_eq!((wide.relief.columns, wide.relief.rows), (256, 16));
    assert_all_near(&[wide.relief.length_x_m, wide.relief.length_y_m], &[2.56e-4, 1.6e-5], 1e-9);
    let map = &scene.surface.made_from.as_ref().unwrap().maps[0].map;
    let raised = relief(map, vec![1.0; 24 * 24], Boundary::Free);
    assert_eq!((raised.heights_m[0], raised.boundary), (1.0, Boundary::Free));
}
