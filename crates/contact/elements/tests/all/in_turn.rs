//! Loads that go on from each other, compared with loads pressed by themselves.

use crate::common::{elastic, rough};
use elements::half_space::{Elements, Ending, Grid, HalfSpaceError, Loading};
use elements::{
    ContactField, ElementsError, ImposedLoad, PressedLoad, Pressing, RandomSurfaces, Surfaces, press,
    press_in_turn,
};
use numerics::parallel::{Progress, Unobserved, on_this_thread};
use spectrum::random_surfaces::{AreaSpectrum, Phases, SelfAffine, Size, Synthesis};

/// Surfaces of a gradient of 1.
fn surfaces() -> RandomSurfaces {
    let band = AreaSpectrum::self_affine(&SelfAffine {
        hurst_exponent: 0.8,
        longest_m: 1.0 / 2.0,
        rolloff_m: 1.0 / 4.0,
        shortest_m: 1.0 / 24.0,
        size: Size::RmsGradient(1.0),
    })
    .unwrap();
    RandomSurfaces { band, synthesis: Synthesis::square(128, 1.0, 3, Phases::FixedModulus), realisations: 2 }
}

/// Twelve loads from 0.001 to 0.2 E* h', but for two that have changed places.
fn pressing(saturation_pa: Option<f64>) -> Pressing {
    let pressure_pa = |at: usize| 1e-3 * 200f64.powf(at as f64 / 11.0);
    let mut loads: Vec<_> = (0..12).map(|at| ImposedLoad::PressurePa(pressure_pa(at))).collect();
    loads.swap(3, 7);
    Pressing { loads, stiffness: true, saturation_pa, ..Pressing::elastic(1.0) }
}

fn alone(pressing: &Pressing) -> Vec<PressedLoad> {
    let unseen = |_: &ContactField<'_>| -> Result<(), ElementsError> { Ok(()) };
    press(&Surfaces::Random(surfaces()), pressing, unseen, &Unobserved).unwrap()
}

#[test]
fn loads_in_turn_are_those_by_themselves_in_fewer_steps() {
    for saturation_pa in [None, Some(0.9), Some(0.25)] {
        let pressing = pressing(saturation_pa);
        let (alone, in_turn) =
            (alone(&pressing), press_in_turn(&surfaces(), &pressing, &Unobserved).unwrap());
        let [mut steps_alone, mut steps_in_turn] = [0, 0];
        for (alone, in_turn) in alone.iter().zip(&in_turn) {
            assert_eq!(alone.nominal_pressure_pa, in_turn.nominal_pressure_pa);
            for (alone, in_turn) in alone.states.iter().zip(&in_turn.states) {
                let [one, other] = [alone, in_turn].map(|state| state.numbers);
                let stiffness = alone.stiffness_pa_per_m.unwrap();
                // Distances are compared as pressures, and the residual is a share of those.
                let distance_m = [one, other].map(|state| state.mean_gap_m - state.mean_plastic_depth_m);
                let off = (distance_m[0] - distance_m[1]) * stiffness / one.nominal_pressure_pa;
                assert!(off.abs() < 3e-5, "{saturation_pa:?} at {}: {off:e}", one.nominal_pressure_pa);
                let points = (one.area_fraction - other.area_fraction) * 128.0 * 128.0;
                assert!(points.abs() < 2.5, "{saturation_pa:?} at {}: {points}", one.nominal_pressure_pa);
                assert!((in_turn.stiffness_pa_per_m.unwrap() / stiffness - 1.0).abs() < 0.01);
                assert!(other.residual < Pressing::TOLERANCE && in_turn.area_fraction_coarser.is_none());
                steps_alone += one.operators;
                steps_in_turn += other.operators;
            }
        }
        println!("{saturation_pa:?}: {steps_in_turn} of {steps_alone} operators");
        assert!(steps_in_turn < steps_alone, "{saturation_pa:?}: {steps_in_turn} of {steps_alone}");
    }
}

#[test]
fn any_contact_is_a_start() {
    let heights_m = rough(128, 4.0, 24, 5);
    let grid = Grid::new(128, 128, 1.0, 1.0).unwrap();
    let mut elements = Elements::periodic(grid, &heights_m).unwrap();
    let loads = [1e-5, 1e-3, 0.03, 0.3];
    for saturation_pa in [None, Some(0.5)] {
        let load = |pressure_pa| Loading { saturation_pa, ..elastic(pressure_pa, 1e-6) };
        let alone = loads.map(|pressure_pa| elements.press(&load(pressure_pa), &Unobserved).unwrap());
        for start in &alone {
            for (pressure_pa, alone) in loads.into_iter().zip(&alone) {
                let found = elements.press_from(Some(start), &load(pressure_pa), &Unobserved).unwrap();
                let [one, other] = [alone, &found].map(|contact| contact.numbers);
                println!(
                    "{saturation_pa:?} from {} to {pressure_pa}: {} for {} operators, {:?}",
                    start.numbers.nominal_pressure_pa, other.operators, one.operators, other.ending
                );
                assert_eq!(other.ending, Ending::Converged, "{saturation_pa:?} at {pressure_pa}");
                let points = (one.area_fraction - other.area_fraction) * heights_m.len() as f64;
                assert!(points.abs() < 2.5, "{saturation_pa:?} at {pressure_pa}: {points}");
                assert!((one.mean_gap_m / other.mean_gap_m - 1.0).abs() < 1e-5);
            }
        }
    }
}

#[test]
fn digits_do_not_depend_on_the_number_of_threads() {
    let pressing = pressing(Some(0.5));
    let many = press_in_turn(&surfaces(), &pressing, &Unobserved).unwrap();
    assert_eq!(many, on_this_thread(|| press_in_turn(&surfaces(), &pressing, &Unobserved)).unwrap());
}

#[test]
fn nothing_and_loads_above_the_saturation_are_refused_and_work_is_cancelled() {
    struct Cancelled;
    impl Progress for Cancelled {
        fn advance(&self, _: usize) {}
        fn is_cancelled(&self) -> bool {
            true
        }
    }
    let refused = |pressing: &Pressing| press_in_turn(&surfaces(), pressing, &Unobserved).unwrap_err();
    let none = Pressing { loads: Vec::new(), ..pressing(None) };
    assert!(matches!(refused(&none), ElementsError::Nothing { surfaces: 2, loads: 0 }));
    let soft = refused(&pressing(Some(0.1)));
    assert!(matches!(soft, ElementsError::HalfSpace(HalfSpaceError::CannotBeCarried { .. })), "{soft:?}");
    let [small, large] = [8, 16].map(|points| rough(points, 1.0, 2, 1));
    let grid = Grid::new(8, 8, 1.0, 1.0).unwrap();
    let start = crate::common::press(&large, &elastic(0.1, 1e-6));
    let other =
        Elements::periodic(grid, &small).unwrap().press_from(Some(&start), &elastic(0.1, 1e-6), &Unobserved);
    assert!(matches!(other, Err(HalfSpaceError::Size { .. })), "{other:?}");
    let cancelled = press_in_turn(&surfaces(), &pressing(None), &Cancelled).unwrap_err();
    assert!(matches!(cancelled, ElementsError::HalfSpace(HalfSpaceError::Cancelled)), "{cancelled:?}");
}
