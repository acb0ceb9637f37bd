//! Surfaces pressed to a distance in place of a load.

use crate::common::{elastic, flowing, heights, rough};
use elements::half_space::{Approach, Closing, Contact, Elements, Grid, HalfSpaceError, Loading};
use numerics::parallel::Unobserved;

const POINTS: usize = 64;

fn elements(heights_m: &[f64], periodic: bool) -> Elements {
    let points = heights_m.len().isqrt();
    let grid = Grid::new(points, points, 1.0, 1.0).unwrap();
    if periodic { Elements::periodic(grid, heights_m) } else { Elements::free(grid, heights_m) }.unwrap()
}

fn closing(approach: Approach, loading: &Loading) -> Closing {
    let Loading { contact_modulus_pa, saturation_pa, tolerance, .. } = *loading;
    Closing { contact_modulus_pa, approach, saturation_pa, tolerance }
}

/// Asserts that a contact is the one under a load.
fn assert_same(found: &Contact, expected: &Contact, rtol: f64) {
    let ratio = found.numbers.nominal_pressure_pa / expected.numbers.nominal_pressure_pa;
    assert!((ratio - 1.0).abs() < rtol, "{ratio}");
    assert!(
        (found.numbers.area_fraction - expected.numbers.area_fraction).abs()
            <= 2.0 / (POINTS * POINTS) as f64
    );
    assert!(
        (found.numbers.largest_pressure_pa / expected.numbers.largest_pressure_pa - 1.0).abs() < 10.0 * rtol
    );
    let mean_pa: f64 = found.pressures_pa.iter().sum::<f64>() / found.pressures_pa.len() as f64;
    assert!((mean_pa / found.numbers.nominal_pressure_pa - 1.0).abs() < 1e-12);
}

#[test]
fn a_held_distance_is_that_of_the_load_that_it_takes() {
    for seed in [1, 2, 3] {
        let heights_m = rough(POINTS, 2.0, 8, seed);
        let highest_m = heights_m.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        for periodic in [true, false] {
            let mut elements = elements(&heights_m, periodic);
            for pressure_pa in [1e-4, 0.01, 0.1, 0.3] {
                for loading in [elastic(pressure_pa, 1e-9), flowing(pressure_pa, 0.8, 1e-9)] {
                    let expected = elements.press(&loading, &Unobserved).unwrap();
                    // The heights have a mean of 0, so that this is the distance of the mean planes.
                    let distance_m = -expected.offset_m;
                    let indentation = Approach::IndentationM(highest_m - distance_m);
                    let found = elements.press_to(&closing(indentation, &loading), &Unobserved).unwrap();
                    assert_same(&found, &expected, 1e-6);
                    if periodic {
                        let gap_m = expected.numbers.mean_gap_m - expected.numbers.mean_plastic_depth_m;
                        assert!((gap_m - distance_m).abs() < 1e-9 * highest_m);
                        let mean_gap = closing(Approach::MeanGapM(gap_m), &loading);
                        let found = elements.press_to(&mean_gap, &Unobserved).unwrap();
                        assert_same(&found, &expected, 1e-6);
                        let stepped = found.numbers.iterations as f64 / expected.numbers.iterations as f64;
                        assert!(
                            stepped < 4.0,
                            "{} steps for {}",
                            found.numbers.iterations,
                            expected.numbers.iterations
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn a_paraboloid_carries_the_force_of_hertz() {
    let (points, radius_m, depth_m) = (256, 20.0, 1e-3);
    let heights_m =
        heights(points, points, |x, y| -((x - 0.5).powi(2) + (y - 0.5).powi(2)) / (2.0 * radius_m));
    let indentation = closing(Approach::IndentationM(depth_m), &elastic(1.0, 1e-8));
    let found = elements(&heights_m, false).press_to(&indentation, &Unobserved).unwrap();
    let force_n = 4.0 / 3.0 * radius_m.sqrt() * depth_m.powf(1.5);
    let ratio = found.numbers.nominal_pressure_pa / force_n;
    assert!((ratio - 1.0).abs() < 2e-3, "{ratio}");
}

#[test]
fn distances_without_an_answer_are_refused() {
    let heights_m = rough(POINTS, 2.0, 8, 1);
    let highest_m = heights_m.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let (mut periodic, mut free) = (elements(&heights_m, true), elements(&heights_m, false));
    let press = |elements: &mut Elements, approach| {
        elements.press_to(&closing(approach, &elastic(1.0, 1e-6)), &Unobserved).unwrap_err()
    };
    let apart = press(&mut periodic, Approach::MeanGapM(1.01 * highest_m));
    assert!(
        matches!(apart, HalfSpaceError::Apart { highest_m: told_m, .. } if (told_m / highest_m - 1.0).abs() < 1e-9)
    );
    let closed = press(&mut periodic, Approach::IndentationM(1.01 * highest_m));
    assert!(matches!(closed, HalfSpaceError::Closed { .. }));
    assert_eq!(press(&mut free, Approach::MeanGapM(0.1 * highest_m)), HalfSpaceError::NoMeanGap);
    for wrong_m in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        for approach in [Approach::MeanGapM(wrong_m), Approach::IndentationM(wrong_m)] {
            assert!(matches!(press(&mut periodic, approach), HalfSpaceError::OutOfBounds(_)));
        }
    }
}
