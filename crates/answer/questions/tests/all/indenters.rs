//! Balls and cylinders on maps and random surfaces.

use std::f64::consts::{PI, TAU};

use elements::{Boundary, Indenter, IndenterPressing, IndenterShape, IndenterState, Pressing};
use numerics::parallel::Unobserved;
use questions::{Answer, IndenterQuestion, MaterialInput, RandomInput};
use study::figure::AxisScale;
use units::RemarkCode;

use crate::common::{
    Counted, STEEL_MODULUS_PA, assert_all_near, assert_near, filled, hard, has, numbers_of, spectrum_of,
    steel,
};
use crate::elements::map;

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
