//! Surfaces pressed as ensembles: their means, comparisons, and cancellation.

use approx::assert_relative_eq;
use elements::half_space::HalfSpaceError;
use elements::{
    Approach, Boundary, ContactField, ElementsError, ImposedLoad, Pressing, RandomSurfaces, Relief, Surfaces,
    press, progress_steps,
};
use numerics::parallel::{Progress, Unobserved};
use spectrum::random_surfaces::{AreaSpectrum, Phases, SelfAffine, Size, Synthesis};
use std::f64::consts::TAU;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Random surfaces of a gradient of 1 in a box of 1 m, by the waves that fit into it.
fn random(
    [longest, rolloff, shortest]: [f64; 3],
    hurst_exponent: f64,
    points: usize,
    realisations: usize,
) -> Surfaces {
    let band = AreaSpectrum::self_affine(&SelfAffine {
        hurst_exponent,
        longest_m: 1.0 / longest,
        rolloff_m: 1.0 / rolloff,
        shortest_m: 1.0 / shortest,
        size: Size::RmsGradient(1.0),
    })
    .unwrap();
    let synthesis = Synthesis::square(points, 1.0, 1, Phases::FixedModulus);
    Surfaces::Random(RandomSurfaces { band, synthesis, realisations })
}

fn elastic(pressures_pa: &[f64]) -> Pressing {
    under(pressures_pa.iter().map(|pressure_pa| ImposedLoad::PressurePa(*pressure_pa)).collect())
}

fn under(loads: Vec<ImposedLoad>) -> Pressing {
    Pressing { loads, ..Pressing::elastic(1.0) }
}

fn unseen(_: &ContactField<'_>) -> Result<(), ElementsError> {
    Ok(())
}

#[test]
fn areas_are_those_of_the_judges_table() {
    // Waves per box, Hurst exponent, pressure over E* h', corrected area and its standard error: rows of judge_table.csv at
    // eight points for the shortest wavelength, here at a quarter of its waves a box with as many points each.
    let rows: [([f64; 3], f64, f64, f64, f64); 4] = [
        ([4.0, 4.0, 16.0], 0.8, 0.15, 0.29876, 0.00034),
        ([4.0, 4.0, 16.0], 0.8, 0.5, 0.73897, 0.00037),
        ([2.0, 2.0, 16.0], 0.8, 0.15, 0.29361, 0.00224),
        ([2.0, 2.0, 16.0], 0.8, 0.5, 0.73622, 0.00204),
    ];
    for (waves, hurst, pressure, expected, error) in rows {
        let pressed =
            press(&random(waves, hurst, 128, 8), &elastic(&[pressure]), unseen, &Unobserved).unwrap();
        let mean = pressed[0].mean();
        let own = mean.standard_error.unwrap();
        let bound = 2.0 * ((2.0 * error).powi(2) + own.powi(2) + (0.007 * expected).powi(2)).sqrt();
        let area = mean.area_fraction_corrected;
        assert!(
            (area - expected).abs() < bound,
            "{waves:?} {pressure}: {area} +- {own}, {expected} +- {error}"
        );
        assert!(mean.area_fraction > area && mean.area_fraction_extrapolated.unwrap() > area);
    }
}

#[test]
fn every_surface_is_pressed_at_the_gradient_of_its_band() {
    // At E* = 1 and a gradient of 1 full contact has a pressure of rms 1/2 around its mean.
    let surfaces = random([2.0, 2.0, 8.0], 0.8, 64, 2);
    let seen = Mutex::new(Vec::new());
    let see = |field: &ContactField<'_>| -> Result<(), ElementsError> {
        let deviations = field.pressures_pa.iter().map(|pressure| (pressure - 50.0).powi(2));
        let rms = (deviations.sum::<f64>() / field.pressures_pa.len() as f64).sqrt();
        seen.lock().unwrap().push(((field.load, field.surface), rms));
        Ok(())
    };
    press(&surfaces, &elastic(&[50.0]), see, &Unobserved).unwrap();
    let mut seen = seen.into_inner().unwrap();
    seen.sort_by_key(|(pair, _)| *pair);
    assert_eq!(seen.iter().map(|(pair, _)| *pair).collect::<Vec<_>>(), [(0, 0), (0, 1)]);
    for (_, rms) in seen {
        assert_relative_eq!(rms, 0.5, max_relative = 1e-6);
    }
}

#[test]
fn a_light_load_is_not_extrapolated_from_a_grid_that_does_not_show_its_spots() {
    let coarse =
        press(&random([12.0, 12.0, 16.0], 0.8, 64, 2), &elastic(&[0.01, 0.5]), unseen, &Unobserved).unwrap();
    let fine =
        press(&random([12.0, 12.0, 16.0], 0.8, 256, 2), &elastic(&[0.01, 0.5]), unseen, &Unobserved).unwrap();
    for load in [0, 1] {
        let (few, many) = (coarse[load].mean(), fine[load].mean());
        assert!(!coarse[load].shows_spots());
        assert_eq!(few.area_fraction_extrapolated, Some(few.area_fraction_corrected));
        assert!(fine[load].shows_spots());
        let step = many.area_fraction_extrapolated.unwrap() / many.area_fraction_corrected - 1.0;
        assert!(step > 0.0 && step < 0.03, "{step}");
    }
}

#[test]
fn a_ball_under_a_free_boundary_is_that_of_hertz() {
    // Radius 1 m, contact radius 1/4 m: the force is (4/3) E* a^3/R.
    let (points, side_m) = (80, 1.0);
    let heights_m = (0..points * points).map(|at| {
        let [x, y] =
            [at % points, at / points].map(|i| (i as f64 + 0.5) / points as f64 * side_m - 0.5 * side_m);
        1.0 - 0.5 * (x * x + y * y)
    });
    let relief = Relief {
        rows: points,
        columns: points,
        length_x_m: side_m,
        length_y_m: side_m,
        heights_m: heights_m.collect(),
        boundary: Boundary::Free,
        is_missing: Vec::new(),
    };
    let pressing = Pressing { stiffness: true, ..elastic(&[4.0 / 3.0 * 0.25f64.powi(3)]) };
    let pressed = press(&Surfaces::Maps(vec![relief]), &pressing, unseen, &Unobserved).unwrap();
    let state = pressed[0].states[0];
    let radius_m = (state.numbers.area_fraction_corrected / std::f64::consts::PI).sqrt();
    assert_relative_eq!(radius_m, 0.25, max_relative = 0.01);
    assert_relative_eq!(
        state.numbers.largest_pressure_pa,
        2.0 / std::f64::consts::PI * 0.25,
        max_relative = 0.02
    );
    // dF/d(approach) = 2 E* a.
    assert_relative_eq!(state.stiffness_pa_per_m.unwrap(), 0.5, max_relative = 0.02);
    assert_eq!(pressed[0].mean().standard_error, None);
}

#[test]
fn waves_along_one_direction_shut_the_other_one() {
    // Ridges along y, as many columns as rows.
    let ridges = |boundary: Boundary| Relief {
        rows: 32,
        columns: 32,
        length_x_m: 1.0,
        length_y_m: 1.0,
        heights_m: (0..32 * 32).map(|at| 0.01 * (TAU * f64::from(at % 32) / 16.0).cos()).collect(),
        boundary,
        is_missing: Vec::new(),
    };
    for boundary in [Boundary::Periodic, Boundary::Free] {
        let pressed =
            press(&Surfaces::Maps(vec![ridges(boundary)]), &elastic(&[0.01, 10.0]), unseen, &Unobserved)
                .unwrap();
        let [light, complete] = [&pressed[0], &pressed[1]].map(|load| load.mean());
        assert_eq!([light.open_along_x, light.open_along_y], [0.0, 1.0], "{boundary}");
        assert_eq!([complete.open_along_x, complete.open_along_y], [0.0, 0.0], "{boundary}");
    }
}

#[test]
fn shares_of_open_surfaces_fall_with_the_load() {
    let surfaces = random([2.0, 2.0, 8.0], 0.8, 64, 8);
    let pressed = press(&surfaces, &elastic(&[0.02, 0.2, 2.0]), unseen, &Unobserved).unwrap();
    let shares: Vec<f64> = pressed.iter().map(|load| load.mean().open_along_x).collect();
    assert_eq!([shares[0], shares[2]], [1.0, 0.0]);
    assert!(0.0 < shares[1] && shares[1] < 1.0, "{shares:?}");
    let open = pressed[1].states.iter().filter(|state| state.open.along_x).count();
    assert_relative_eq!(shares[1], open as f64 / 8.0);
}

#[test]
fn fields_are_read_back_as_they_were_written() {
    let surfaces = random([2.0, 2.0, 8.0], 0.8, 24, 1);
    let written = Mutex::new(Vec::new());
    let heights = Mutex::new(Vec::new());
    let see = |field: &ContactField<'_>| -> Result<(), ElementsError> {
        field.write_netcdf(&[], &mut *written.lock().unwrap()).unwrap();
        *heights.lock().unwrap() = field.relief.heights_m.clone();
        Ok(())
    };
    press(&surfaces, &elastic(&[0.1]), see, &Unobserved).unwrap();
    let read = scans::read_scans(
        &written.into_inner().unwrap(),
        "field.nc",
        &scans::ScanOptions { channel: Some("heights".to_owned()), ..Default::default() },
    )
    .unwrap();
    let scans::Scan::Map(map) = &read[0].scan.clone().complete().unwrap() else { panic!("{read:?}") };
    assert_eq!(map.heights_m(), heights.into_inner().unwrap());
    assert_relative_eq!(map.spacing_x_m(), 1.0 / 24.0, max_relative = 1e-12);
}

#[test]
fn work_is_told_of_and_may_be_ended() {
    struct Counting(AtomicUsize, bool);
    impl Progress for Counting {
        fn advance(&self, steps: usize) {
            self.0.fetch_add(steps, Ordering::Relaxed);
        }
        fn is_cancelled(&self) -> bool {
            self.1
        }
    }
    let (surfaces, pressing) = (random([2.0, 2.0, 8.0], 0.8, 32, 3), elastic(&[0.1, 0.2]));
    let watched = Counting(AtomicUsize::new(0), false);
    press(&surfaces, &pressing, unseen, &watched).unwrap();
    assert_eq!(watched.0.into_inner(), progress_steps(&surfaces, &pressing));
    let ended = press(&surfaces, &pressing, unseen, &Counting(AtomicUsize::new(0), true));
    assert_eq!(ended.unwrap_err(), ElementsError::HalfSpace(HalfSpaceError::Cancelled));
}

#[test]
fn what_cannot_be_pressed_is_refused_before_it_is() {
    let surfaces = random([2.0, 2.0, 8.0], 0.8, 32, 1);
    let refused = |pressing: &Pressing| {
        let see = |_: &ContactField<'_>| -> Result<(), ElementsError> { panic!("nothing is pressed") };
        press(&surfaces, pressing, see, &Unobserved).unwrap_err()
    };
    assert_eq!(refused(&elastic(&[])), ElementsError::Nothing { surfaces: 1, loads: 0 });
    let soft = Pressing { saturation_pa: Some(0.2), ..elastic(&[0.1, 0.2]) };
    assert!(matches!(refused(&soft), ElementsError::HalfSpace(HalfSpaceError::CannotBeCarried { .. })));
    assert!(refused(&Pressing { tolerance: 0.0, ..elastic(&[0.1]) }).to_string().contains("tolerance"));
    let wide = random([2.0, 2.0, 20.0], 0.8, 32, 1);
    let error = press(&wide, &elastic(&[0.1]), unseen, &Unobserved).unwrap_err();
    assert!(error.to_string().contains("wider than the grid holds"), "{error}");
}

#[test]
fn maps_are_pressed_as_each_by_itself() {
    let surfaces = random([1.0, 2.0, 8.0], 0.8, 64, 3);
    let maps: Vec<Relief> = (0..3).map(|number| surfaces.relief(number).unwrap().into_owned()).collect();
    let pressing = elastic(&[0.02, 0.1]);
    let together = press(&Surfaces::Maps(maps.clone()), &pressing, unseen, &Unobserved).unwrap();
    for (number, map) in maps.into_iter().enumerate() {
        let alone = press(&Surfaces::Maps(vec![map]), &pressing, unseen, &Unobserved).unwrap();
        for (of_all, of_one) in together.iter().zip(&alone) {
            assert_eq!(of_all.states[number], of_one.states[0]);
        }
    }
}

#[test]
fn every_surface_takes_its_own_load_to_a_distance_and_in_units_of_its_gradient() {
    let surfaces = random([1.0, 2.0, 8.0], 0.8, 64, 3);
    let steeper: Vec<Relief> = (0..3)
        .map(|number| {
            let relief = surfaces.relief(number).unwrap().into_owned();
            let factor = (number + 1) as f64;
            Relief {
                heights_m: relief.heights_m.iter().map(|height_m| factor * height_m).collect(),
                ..relief
            }
        })
        .collect();
    let gradients: Vec<f64> = steeper.iter().map(Relief::rms_gradient).collect();
    let surfaces = Surfaces::Maps(steeper);
    let reduced =
        press(&surfaces, &under(vec![ImposedLoad::ReducedPressure(0.05)]), unseen, &Unobserved).unwrap();
    for (state, gradient) in reduced[0].states.iter().zip(gradients) {
        assert_relative_eq!(state.numbers.nominal_pressure_pa, 0.05 * gradient, max_relative = 1e-12);
    }
    for state in &reduced[0].states {
        let held = under(vec![ImposedLoad::Approach(Approach::MeanGapM(state.numbers.mean_gap_m))]);
        let found = press(&surfaces, &held, unseen, &Unobserved).unwrap();
        let same = found[0].states.iter().any(|other| {
            (other.numbers.nominal_pressure_pa / state.numbers.nominal_pressure_pa - 1.0).abs() < 1e-4
                && (other.numbers.area_fraction_corrected / state.numbers.area_fraction_corrected - 1.0).abs()
                    < 1e-3
        });
        assert!(same, "{state:?}");
        let mean_pa =
            found[0].states.iter().map(|state| state.numbers.nominal_pressure_pa).sum::<f64>() / 3.0;
        assert_relative_eq!(found[0].nominal_pressure_pa, mean_pa, max_relative = 1e-12);
    }
}
