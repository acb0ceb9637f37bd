//! Maps and random surfaces under boundary elements: flats, balls, cylinders and adhesion.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

use elements::{
    Boundary, ElementsError, Indenter, IndenterPressing, IndenterShape, IndenterState, PressedLoad, Pressing,
    Relief, SpecimenCompliance,
};
use numerics::parallel::Unobserved;
use questions::{
    AdhesionQuestion, Answer, BranchChoice, ElementsLoad, ElementsQuestion, GapQuestion, IndenterQuestion,
    MapQuestion, MaterialInput, QuestionError, RandomInput, relief,
};
use scene::{Overrides, Scene};
use study::figure::{AxisScale, FigureData};
use tables::Cells;
use units::{Pressure, PressureRange, Remark, RemarkCode, display};

use crate::common::{
    Counted, STEEL_MODULUS_PA, assert_all_near, assert_near, by, column, filled, hard, has, load, loads,
    numbers_of, small, spectrum_of, steel, surface, text_of,
};

const POINTS: usize = 32;
const SIDE_M: f64 = 3.2e-5;
const AMPLITUDE_M: f64 = 1e-8;
/// Mean pressure that flattens [`ridge`] \[Pa\]: pi E* times amplitude over wavelength.
const FLATTENS_PA: f64 = PI * STEEL_MODULUS_PA * AMPLITUDE_M / SIDE_M;

/// A map of heights over x and y in sides of the map.
fn map(boundary: Boundary, height_m: impl Fn(f64, f64) -> f64) -> Relief {
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
fn ridge() -> Relief {
    map(Boundary::Periodic, |x, _| AMPLITUDE_M * (TAU * x).cos())
}

/// One ridge along x.
fn ridge_along_x() -> Relief {
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

const BALL_RADIUS_M: f64 = 1e-3;
const FORCE_N: f64 = 1e-3;

fn ball(material: MaterialInput) -> IndenterQuestion {
    IndenterQuestion {
        material,
        radius_m: BALL_RADIUS_M,
        force: FORCE_N,
        random: RandomInput {
            grid: Some(32),
            realisations: Some(3),
            shortest_m: Some(4e-6),
            ..RandomInput::default()
        },
        ..IndenterQuestion::default()
    }
}

/// A spectrum of waves from 16 to 4 um, low enough for a ball.
fn fine() -> study::surface::Surface {
    let row = |i: i32| {
        let wavelength_m = 1.6e-5 * 0.25f64.powf(f64::from(i) / 10.0);
        format!("{wavelength_m:e},{:e}\n", 1e-23 * (wavelength_m / 1e-6).powf(2.6))
    };
    spectrum_of(&(0..=10).map(row).collect::<String>())
}

#[test]
fn the_pressure_under_a_ball_is_averaged_over_places_beside_that_of_hertz() {
    let question = ball(steel());
    let prepared = question.on(&fine()).unwrap();
    let found = prepared.answer(&Unobserved).unwrap();
    let a_m = (0.75 * FORCE_N * BALL_RADIUS_M / STEEL_MODULUS_PA).cbrt();
    let p0_pa = 1.5 * FORCE_N / (PI * a_m * a_m);
    let figure = found.figure.unwrap();
    assert_eq!((figure.x_scale, figure.y_scale), (AxisScale::Linear, AxisScale::Linear));
    assert_ne!(figure.title, figure.y_label);
    let [hertz, rough] = &figure.series[..] else { panic!("{} lines", figure.series.len()) };
    assert_eq!(hertz.points.len(), 101);
    assert_eq!(hertz.points[0], (0.0, hertz.points[0].1));
    assert_near(hertz.points[0].1, p0_pa, 1e-9);
    assert_near(hertz.points[100].0, a_m, 1e-9);
    for (r_m, pressure_pa) in &hertz.points {
        assert!((pressure_pa - p0_pa * (1.0 - (r_m / a_m).powi(2)).max(0.0).sqrt()).abs() < 1e-6 * p0_pa);
    }
    let indenter = Indenter { shape: IndenterShape::Ball, radius_m: BALL_RADIUS_M, force: FORCE_N };
    let pressing = IndenterPressing { contact_modulus_pa: STEEL_MODULUS_PA, tolerance: Pressing::TOLERANCE };
    let states = indenter.press_all(&prepared.surfaces, &pressing, &Unobserved).unwrap();
    let reach_m = states.iter().fold(a_m, |reach_m, state| reach_m.max(state.outermost_contact_m));
    // Rings of an eighth of the radius, up to a fifth beyond the outermost contact.
    let mut expected = Vec::new();
    for ring in 0..states[0].ring_pressures_pa.len() {
        let radius_m = a_m * (ring as f64 + 0.5) / 8.0;
        let pressures: Vec<f64> = states.iter().filter_map(|state| state.ring_pressures_pa[ring]).collect();
        if radius_m < 1.2 * reach_m && !pressures.is_empty() {
            let n = pressures.len() as f64;
            let mean = pressures.iter().sum::<f64>() / n;
            let squares = pressures.iter().map(|pressure| (pressure - mean).powi(2)).sum::<f64>();
            expected.push((radius_m, mean, (squares / (n - 1.0).max(1.0)).sqrt()));
        }
    }
    assert_eq!(rough.points.len(), expected.len());
    let [band] = &figure.bands[..] else { panic!("{} bands", figure.bands.len()) };
    for ((point, (band_m, [low, high])), (radius_m, mean, deviation)) in
        rough.points.iter().zip(&band.points).zip(&expected)
    {
        assert_all_near(&[point.0, *band_m], &[*radius_m; 2], 1e-9);
        let near = |found: f64, expected: f64| {
            assert!((found - expected).abs() < 1e-6 * p0_pa, "{found} {expected}")
        };
        near(point.1, *mean);
        near(*low, (mean - deviation).max(0.0));
        near(*high, mean + deviation);
    }
    assert!(expected.iter().any(|(_, mean, deviation)| deviation > mean));
    // Places differ by the standard deviation of their areas over the mean.
    let areas: Vec<f64> = states.iter().map(|state: &IndenterState| state.real_area).collect();
    assert_all_near(&filled(&found.table, "real_area_m2"), &areas, 1e-9);
    let mean = areas.iter().sum::<f64>() / 3.0;
    let scatter = (areas.iter().map(|area| (area - mean).powi(2)).sum::<f64>() / 2.0).sqrt() / mean;
    assert_near(numbers_of(&found.notes, RemarkCode::Places, ["scatter"])[0], scatter, 1e-9);
    // The real pressure is three forces over the sum of the areas.
    let real_pa = 3.0 * FORCE_N / areas.iter().sum::<f64>();
    let doubts =
        |hardness_pa: f64| ball(hard(hardness_pa)).on(&fine()).unwrap().answer(&Unobserved).unwrap().notes;
    assert!(!has(&doubts(1.01 * real_pa), RemarkCode::RealAboveHardness));
    let [times] = numbers_of(&doubts(0.5 * real_pa), RemarkCode::RealAboveHardness, ["in_hardnesses"]);
    assert_near(times, 2.0, 1e-9);
}

#[test]
fn one_place_has_no_band_and_a_cylinder_repeats_a_map_with_free_edges() {
    let flat = |boundary| map(boundary, |x, y| 1e-10 * (TAU * (3.0 * x + 2.0 * y)).cos());
    let answer = |shape, boundary| -> Answer {
        let force = if shape == IndenterShape::Ball { FORCE_N } else { 1e2 };
        let question = IndenterQuestion { shape, force, ..ball(steel()) };
        question.on_map(flat(boundary)).unwrap().answer(&Unobserved).unwrap()
    };
    let notes = |shape, boundary| {
        let question = IndenterQuestion { shape, ..ball(steel()) };
        has(&question.on_map(flat(boundary)).unwrap().notes, RemarkCode::RepeatedMap)
    };
    let found = answer(IndenterShape::Ball, Boundary::Free);
    assert!(found.figure.unwrap().bands.is_empty() && has(&found.notes, RemarkCode::OnePlace));
    assert!(answer(IndenterShape::Cylinder, Boundary::Free).figure.is_none());
    assert!(
        notes(IndenterShape::Cylinder, Boundary::Free) && !notes(IndenterShape::Cylinder, Boundary::Periodic)
    );
    assert!(!notes(IndenterShape::Ball, Boundary::Free) && !notes(IndenterShape::Ball, Boundary::Periodic));
    let layer = questions::LayerInput {
        thickness_m: Some(1e-6),
        youngs_modulus_pa: Some(1e9),
        poisson_ratio: Some(0.4),
        ..questions::LayerInput::default()
    };
    let layered = ball(MaterialInput { layer: Some(layer), ..steel() });
    assert_eq!(crate::common::unused(layered.check()).as_deref(), Some("layer_thickness"));
    let stopped = ball(steel()).on(&fine()).unwrap().answer(&Counted::cancelled());
    assert!(stopped.is_err_and(|error| error.is_cancelled()));
}

/// Rubber of 1 MPa.
fn rubber() -> MaterialInput {
    MaterialInput { youngs_modulus_pa: Some(0.75e6), poisson_ratio: Some(0.5), ..MaterialInput::default() }
}

fn sticky(pressures_pa: &[f64]) -> AdhesionQuestion {
    AdhesionQuestion {
        material: rubber(),
        pressures: loads(pressures_pa),
        work_of_adhesion_j_per_m2: 0.01,
        range_m: 2e-7,
        branch: BranchChoice::Both,
        random: RandomInput {
            grid: Some(32),
            realisations: Some(2),
            shortest_m: Some(8e-6),
            ..RandomInput::default()
        },
        ..AdhesionQuestion::default()
    }
}

/// Waves from 32 to 8 um whose gradient of about 0.05 rubber follows only in part.
fn bumpy() -> study::surface::Surface {
    let row = |i: i32| {
        let wavelength_m = 3.2e-5 * 0.25f64.powf(f64::from(i) / 10.0);
        format!("{wavelength_m:e},{:e}\n", 6e-20 * (wavelength_m / 8e-6).powf(2.6))
    };
    spectrum_of(&(0..=10).map(row).collect::<String>())
}

fn sticking(question: &AdhesionQuestion) -> (Vec<Remark>, Answer) {
    let prepared = question.on(&bumpy()).unwrap();
    (prepared.notes.clone(), prepared.answer(&Unobserved).unwrap())
}

fn line(figure: &FigureData, at: usize) -> (Vec<f64>, Vec<f64>) {
    figure.series[at].points.iter().copied().unzip()
}

#[test]
fn both_branches_of_a_sticky_contact_are_followed_and_their_widest_difference_is_named() {
    // A ridge of 200 nm, which rubber that has not been pressed touches at its summit alone.
    let pressures_pa = [1e3, 3e3, 0.0];
    let deep = || map(Boundary::Periodic, |x, _| 2e-7 * (TAU * x).cos());
    let question =
        AdhesionQuestion { work_of_adhesion_j_per_m2: 1e-3, range_m: 5e-8, ..sticky(&pressures_pa) };
    let found = question.on_maps(vec![deep(), deep()]).unwrap().answer(&Unobserved).unwrap();
    let areas = filled(&found.table, "area_fraction");
    let (apart, contact) = areas.split_at(3);
    assert_all_near(&filled(&found.table, "nominal_pressure_pa")[..2], &pressures_pa[..2], 1e-9);
    let Some(Cells::Words(branches)) = found.table.column("branch") else { panic!("no branches") };
    assert_eq!(branches[..], ["apart", "apart", "apart", "contact", "contact", "contact"]);
    let widest =
        (0..3).max_by(|a, b| (contact[*a] - apart[*a]).total_cmp(&(contact[*b] - apart[*b]))).unwrap();
    assert!(contact[widest] - apart[widest] > 1e-2, "{apart:?} {contact:?}");
    let names =
        ["hysteresis_pressure_pa", "hysteresis_apart_area_fraction", "hysteresis_contact_area_fraction"];
    let hysteresis = numbers_of(&found.notes, RemarkCode::Hysteresis, names);
    assert_eq!(hysteresis, [pressures_pa[widest], apart[widest], contact[widest]]);
    assert!(!has(&found.notes, RemarkCode::Metastable));
    // Lines by branch, from the least pressure on; logarithms have no place for 0.
    let figure = found.figure.unwrap();
    assert_eq!(line(&figure, 0), (vec![0.0, 1e3, 3e3], vec![apart[2], apart[0], apart[1]]));
    assert_eq!(line(&figure, 1), (vec![0.0, 1e3, 3e3], vec![contact[2], contact[0], contact[1]]));
    assert_eq!(figure.x_scale, AxisScale::Linear);
    assert_ne!(figure.title, figure.y_label);
    // A low surface touches by as much whichever way it came.
    let (before, found) = sticking(&sticky(&[2e3, 8e3]));
    assert!(!has(&found.notes, RemarkCode::Hysteresis));
    assert!(numbers_of(&before, RemarkCode::AdhesionIndicators, ["pastewka_robbins"])[0] > 0.0);
}

#[test]
fn one_branch_has_no_hysteresis_and_a_pull_is_metastable() {
    for (branch, pressures_pa, name) in
        [(BranchChoice::Apart, [2e3, 8e3], "apart"), (BranchChoice::Contact, [-1.0, 8e3], "contact")]
    {
        let question = AdhesionQuestion { branch, per_realisation: true, ..sticky(&pressures_pa) };
        let (_, found) = sticking(&question);
        assert!(!has(&found.notes, RemarkCode::Hysteresis));
        assert_eq!(has(&found.notes, RemarkCode::Metastable), pressures_pa[0] < 0.0);
        let Some(Cells::Words(branches)) = found.table.column("branch") else { panic!("no branches") };
        assert_eq!(branches[..], [name; 4]);
        assert_eq!(filled(&found.table, "realisation"), [1.0, 1.0, 2.0, 2.0]);
        // The figure has the mean of both surfaces.
        let areas = filled(&found.table, "area_fraction");
        let figure = found.figure.unwrap();
        assert_eq!(figure.series.len(), 1);
        assert_all_near(
            &line(&figure, 0).1,
            &[0.5 * (areas[0] + areas[2]), 0.5 * (areas[1] + areas[3])],
            1e-12,
        );
        let expected = if pressures_pa[0] < 0.0 { AxisScale::Linear } else { AxisScale::Logarithmic };
        assert_eq!(figure.x_scale, expected);
    }
}

#[test]
fn the_pull_off_is_the_largest_pull_of_every_surface() {
    for realisations in [1, 2] {
        let mut question = AdhesionQuestion { pull_off: true, ..sticky(&[]) };
        question.random.realisations = Some(realisations);
        let (_, found) = sticking(&question);
        let [pressures, gaps, areas] =
            ["nominal_pressure_pa", "mean_gap_m", "area_fraction"].map(|name| filled(&found.table, name));
        let surface_of = match realisations {
            1 => vec![1.0; pressures.len()],
            _ => filled(&found.table, "realisation"),
        };
        let strongest: Vec<usize> = (1..=realisations)
            .map(|surface| {
                let rows = (0..pressures.len()).filter(|row| surface_of[*row] == surface as f64);
                rows.min_by(|a, b| pressures[*a].total_cmp(&pressures[*b])).unwrap()
            })
            .collect();
        let mean =
            |column: &[f64]| strongest.iter().map(|row| column[*row]).sum::<f64>() / realisations as f64;
        let names = ["pull_off_pressure_pa", "pull_off_mean_gap_m", "pull_off_area_fraction"];
        let pull_off = numbers_of(&found.notes, RemarkCode::PullOff, names);
        assert_all_near(&pull_off, &[mean(&pressures), mean(&gaps), mean(&areas)], 1e-12);
        assert!(pull_off[0] < 0.0);
        let figure = found.figure.unwrap();
        assert_eq!((figure.series.len(), figure.x_scale), (realisations, AxisScale::Linear));
        let marks: Vec<(f64, f64)> = figure.marks.iter().map(|mark| (mark.x, mark.y)).collect();
        assert_eq!(marks, strongest.iter().map(|row| (gaps[*row], pressures[*row])).collect::<Vec<_>>());
        assert!(
            figure
                .marks
                .iter()
                .enumerate()
                .all(|(at, mark)| { mark.condition_index == (realisations > 1).then_some(at) })
        );
        let points: Vec<(f64, f64)> = figure.series.iter().flat_map(|line| line.points.clone()).collect();
        assert_eq!(points, gaps.iter().copied().zip(pressures.iter().copied()).collect::<Vec<_>>());
        assert_eq!(figure.series[0].column == "nominal_pressure_pa", realisations == 1);
        for shown in [display::pressure(-pull_off[0]), display::length(pull_off[1])] {
            assert!(figure.title.contains(&shown), "{}", figure.title);
        }
        assert_eq!(figure.title.contains('2') && figure.title.contains("surfaces"), realisations == 2);
    }
}

#[test]
fn a_grid_with_less_than_two_points_in_the_process_zone_is_called_coarse() {
    // E* rho^2/w over the spacing of 1 um.
    let points = |points: f64| {
        let range_m = (points * 1e-6 * 0.01 / 1e6f64).sqrt();
        let question = AdhesionQuestion { range_m, ..sticky(&[1e3]) };
        question.on_maps(vec![ridge()]).unwrap().notes
    };
    assert!(!has(&points(2.1), RemarkCode::ProcessZoneCoarse));
    let [found] = numbers_of(&points(1.5), RemarkCode::ProcessZoneCoarse, ["process_zone_points"]);
    assert_near(found, 1.5, 1e-9);
    let free = Relief { boundary: Boundary::Free, ..ridge() };
    assert!(matches!(sticky(&[1e3]).on_maps(vec![free]), Err(QuestionError::Adhesion(_))));
    let in_hardnesses = AdhesionQuestion { pressures: vec!["0.1 H".parse().unwrap()], ..sticky(&[]) };
    assert!(matches!(in_hardnesses.check(), Err(QuestionError::Load { option: "pressure", .. })));
    let stopped = sticky(&[1e3]).on(&bumpy()).unwrap().answer(&Counted::cancelled());
    assert!(stopped.is_err_and(|error| error.is_cancelled()));
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
