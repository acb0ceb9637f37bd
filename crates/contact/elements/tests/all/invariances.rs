//! Changes of the input that leave an answer unchanged, or change it in a known way.

use crate::common::{elastic, flowing, press, rough};
use elements::half_space::{Contact, Elements, Grid, Loading};
use numerics::parallel::Unobserved;

const POINTS: usize = 96;

/// The largest difference of two pressure maps, in shares of the largest pressure, the second looked up by `at`.
fn difference(one: &Contact, other: &Contact, factor: f64, at: impl Fn(usize, usize) -> usize) -> f64 {
    let points = (0..POINTS).flat_map(|row| (0..POINTS).map(move |column| (row, column)));
    points.enumerate().fold(0.0, |largest, (point, (row, column))| {
        let off = other.pressures_pa[at(row, column)] - factor * one.pressures_pa[point];
        largest.max(off.abs() / (factor * one.numbers.largest_pressure_pa))
    })
}

fn loadings() -> [Loading; 2] {
    [elastic(0.08, 1e-13), flowing(0.08, 0.6, 1e-13)]
}

#[test]
fn shifts_mirrors_and_turns() {
    let heights_m = rough(POINTS, 2.0, 9, 1);
    let moved = |at: &dyn Fn(usize, usize) -> usize| -> Vec<f64> {
        (0..POINTS * POINTS).map(|point| heights_m[at(point / POINTS, point % POINTS)]).collect()
    };
    type Place = fn(usize, usize) -> usize;
    // Index in the map that a point of the moved map comes from, and the index that a point of the map moves to.
    let moves: [(Place, Place); 3] = [
        (
            |row, column| ((row + 31) % POINTS) * POINTS + (column + 17) % POINTS,
            |row, column| ((row + POINTS - 31) % POINTS) * POINTS + (column + POINTS - 17) % POINTS,
        ),
        (
            |row, column| row * POINTS + (POINTS - 1 - column),
            |row, column| row * POINTS + (POINTS - 1 - column),
        ),
        (|row, column| column * POINTS + row, |row, column| column * POINTS + row),
    ];
    for loading in loadings() {
        let contact = press(&heights_m, &loading);
        for (from, to) in moves {
            let other = press(&moved(&from), &loading);
            assert_eq!(other.numbers.area_fraction, contact.numbers.area_fraction);
            assert_eq!(
                other.numbers.plastic_area_fraction_corrected,
                contact.numbers.plastic_area_fraction_corrected
            );
            let off = difference(&contact, &other, 1.0, to);
            assert!(off < 1e-11, "{off}");
        }
    }
}

#[test]
fn units_of_modulus_and_height() {
    let heights_m = rough(POINTS, 2.0, 9, 2);
    let higher: Vec<f64> = heights_m.iter().map(|height_m| 3e-7 * height_m + 0.01).collect();
    for loading in loadings() {
        let contact = press(&heights_m, &loading);
        let times = |factor: f64, modulus: f64| Loading {
            contact_modulus_pa: modulus,
            nominal_pressure_pa: factor * loading.nominal_pressure_pa,
            saturation_pa: loading.saturation_pa.map(|saturation_pa| factor * saturation_pa),
            ..loading
        };
        for (heights_m, loading, pressures, gaps) in [
            (&heights_m, times(7e11, 7e11), 7e11, 1.0),
            (&higher, times(3e-7, 1.0), 3e-7, 3e-7),
            (&higher, times(3e5, 1e12), 3e5, 3e-7),
        ] {
            let other = press(heights_m, &loading);
            assert_eq!(other.numbers.area_fraction, contact.numbers.area_fraction);
            assert_eq!(
                other.numbers.plastic_area_fraction_corrected,
                contact.numbers.plastic_area_fraction_corrected
            );
            assert!((other.numbers.mean_gap_m / (gaps * contact.numbers.mean_gap_m) - 1.0).abs() < 1e-10);
            assert!(
                (other.energy_j_per_m2 / (gaps * pressures * contact.energy_j_per_m2) - 1.0).abs() < 1e-10
            );
            let off = difference(&contact, &other, pressures, |row, column| row * POINTS + column);
            assert!(off < 1e-9, "{off}");
        }
    }
}

#[test]
fn the_same_map_gives_the_same_digits_whatever_was_pressed_before() {
    let heights_m = rough(POINTS, 2.0, 9, 3);
    let grid = Grid::new(POINTS, POINTS, 1.0, 1.0).unwrap();
    let mut elements = Elements::periodic(grid, &heights_m).unwrap();
    for loading in loadings() {
        let first = press(&heights_m, &loading);
        elements.press(&elastic(0.9, 1e-6), &Unobserved).unwrap();
        assert_eq!(elements.press(&loading, &Unobserved).unwrap(), first);
    }
}

#[test]
fn heights_of_one_period_beside_each_other_are_pressed_alike() {
    let heights_m = rough(POINTS, 2.0, 9, 4);
    let twice: Vec<f64> = heights_m.chunks(POINTS).flat_map(|row| row.iter().chain(row)).copied().collect();
    let grid = Grid::new(POINTS, 2 * POINTS, 2.0, 1.0).unwrap();
    for loading in loadings() {
        let one = press(&heights_m, &loading);
        let two = Elements::periodic(grid, &twice).unwrap().press(&loading, &Unobserved).unwrap();
        assert_eq!(two.numbers.area_fraction, one.numbers.area_fraction);
        assert_eq!(two.numbers.area_fraction_corrected, one.numbers.area_fraction_corrected);
        assert!((two.numbers.mean_gap_m / one.numbers.mean_gap_m - 1.0).abs() < 1e-10);
    }
}

#[test]
fn free_elements_know_no_left_and_right_on_odd_rectangles() {
    let (rows, columns) = (31, 45);
    let heights_m = crate::common::heights(rows, columns, |x, y| {
        -(x - 0.3).powi(2) - 0.5 * (y - 0.6).powi(2) - 0.1 * x * y
    });
    let mirrored: Vec<f64> = heights_m.chunks(columns).flat_map(|row| row.iter().rev()).copied().collect();
    let grid = Grid::new(rows, columns, 1.0, 0.7).unwrap();
    let [one, other] = [&heights_m, &mirrored]
        .map(|map| Elements::free(grid, map).unwrap().press(&elastic(0.02, 1e-12), &Unobserved).unwrap());
    assert_eq!(one.numbers.area_fraction, other.numbers.area_fraction);
    for (row, mirror) in one.pressures_pa.chunks(columns).zip(other.pressures_pa.chunks(columns)) {
        for (pressure, mirrored) in row.iter().zip(mirror.iter().rev()) {
            assert!((pressure - mirrored).abs() < 1e-9 * one.numbers.largest_pressure_pa);
        }
    }
}
