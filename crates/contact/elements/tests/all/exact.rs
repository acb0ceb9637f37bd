//! Solutions that are known in closed form, and one that is tabulated.

use std::f64::consts::{PI, SQRT_2, TAU};

use crate::common::{CLOSING, elastic, flowing, heights, press, rough};
use elements::half_space::{Contact, Elements, Grid, OpenPaths, Sides, open_paths};
use numerics::parallel::Unobserved;

/// One wave of height 1 and length 1 on a line.
fn wave(points: usize, share_of_closing: f64) -> (Elements, Contact) {
    let heights_m = heights(1, points, |x, _| (TAU * x).cos());
    let mut elements = Elements::periodic(Grid::new(1, points, 1.0, 1.0).unwrap(), &heights_m).unwrap();
    let contact = elements.press(&elastic(share_of_closing * CLOSING, 1e-10), &Unobserved).unwrap();
    (elements, contact)
}

#[test]
fn westergaards_wave_on_a_line() {
    for share in [0.01f64, 0.1, 0.25, 0.5, 0.9] {
        let (mut elements, contact) = wave(4096, share);
        let area = 2.0 / PI * share.sqrt().asin();
        assert!(
            (contact.numbers.area_fraction - area).abs() <= 1.5 / 4096.0,
            "{share}: {} {area}",
            contact.numbers.area_fraction
        );
        assert_eq!(contact.numbers.area_fraction_corrected, contact.numbers.area_fraction);
        let largest = 2.0 * share * CLOSING / share.sqrt();
        assert!((contact.numbers.largest_pressure_pa / largest - 1.0).abs() < 2e-4, "{share}");
        let gap = 1.0 - share + share * share.ln();
        assert!(
            (contact.numbers.mean_gap_m - gap).abs() < 1e-6,
            "{share}: {} {gap}",
            contact.numbers.mean_gap_m
        );
        // The energy is what the load has done on its way: of p du.
        let energy = CLOSING * (share.powi(2) / 4.0 - share.powi(2) / 2.0 * share.ln());
        assert!(
            (contact.energy_j_per_m2 / (energy) - 1.0).abs() < 1e-5,
            "{share}: {} {energy}",
            contact.energy_j_per_m2
        );
        let stiffness = CLOSING / -share.ln();
        let found = elements.stiffness_pa_per_m(&contact, 1.0, &Unobserved).unwrap().unwrap();
        assert!((found / stiffness - 1.0).abs() < 3e-3, "{share}: {found} {stiffness}");
    }
}

#[test]
fn a_wave_along_either_side_of_any_rectangle_is_the_same_wave() {
    let (_, line) = wave(135, 0.3);
    for (rows, columns) in [(135, 1), (135, 6), (135, 7)] {
        let heights_m = heights(rows, columns, |_, y| (TAU * y).cos());
        let grid = Grid::new(rows, columns, 0.3, 1.0).unwrap();
        let contact = Elements::periodic(grid, &heights_m)
            .unwrap()
            .press(&elastic(0.3 * CLOSING, 1e-10), &Unobserved)
            .unwrap();
        assert!((contact.numbers.area_fraction - line.numbers.area_fraction).abs() < 1e-12);
        assert!((contact.numbers.mean_gap_m / line.numbers.mean_gap_m - 1.0).abs() < 1e-8);
        assert!((contact.numbers.largest_pressure_pa / line.numbers.largest_pressure_pa - 1.0).abs() < 1e-7);
    }
}

#[test]
fn full_contact_is_a_wave_of_pressure_for_every_wave_of_height() {
    let (rows, columns) = (90, 63);
    let grid = Grid::new(rows, columns, 1.4, 2.0).unwrap();
    let waves = [(1.0, 0.0, 0.5), (3.0, 5.0, 0.03), (0.0, 7.0, 0.02)];
    let sum = |x: f64, y: f64, weight: &dyn Fn(f64) -> f64| {
        waves.iter().fold(0.0, |sum, &(kx, ky, height)| {
            let wave_number = TAU * f64::hypot(kx / 1.4, ky / 2.0);
            sum + height * weight(wave_number) * (TAU * (kx * x + ky * y)).cos()
        })
    };
    let heights_m = heights(rows, columns, |x, y| sum(x, y, &|_| 1.0));
    let exact = heights(rows, columns, |x, y| 3.0 + sum(x, y, &|q| 0.5 * q));
    let mut elements = Elements::periodic(grid, &heights_m).unwrap();
    let contact = elements.press(&elastic(3.0, 1e-12), &Unobserved).unwrap();
    assert_eq!(contact.numbers.area_fraction, 1.0);
    assert_eq!(contact.numbers.area_fraction_corrected, 1.0);
    for (found, exact) in contact.pressures_pa.iter().zip(&exact) {
        assert!((found - exact).abs() < 1e-10, "{found} {exact}");
    }
    let energy: f64 = waves
        .iter()
        .map(|&(kx, ky, height)| 0.125 * TAU * f64::hypot(kx / 1.4, ky / 2.0) * height * height)
        .sum();
    assert!((contact.energy_j_per_m2 / energy - 1.0).abs() < 1e-11);
    assert!(contact.numbers.mean_gap_m < 1e-10);
    assert_eq!(elements.stiffness_pa_per_m(&contact, 1.0, &Unobserved).unwrap(), None);
}

/// Johnson, Greenwood & Higginson (1985): p/p*, area on 1024^2 points, mean gap over the height of the wave, largest pressure
/// over p*, of `data/jgh_bem.csv`, made with other code.
const BISINUSOID: [[f64; 4]; 6] = [
    [0.001, 0.007665, 0.956117, 0.1966],
    [0.05, 0.112945, 0.556371, 0.7094],
    [0.2, 0.345096, 0.204634, 1.0955],
    [0.5, 0.704183, 0.045078, 1.4793],
    [0.8, 0.897616, 0.003847, 1.7983],
    [0.99, 0.995199, 0.000002, 1.99],
];

#[test]
fn the_bisinusoid() {
    let points = 256;
    let heights_m = heights(points, points, |x, y| (TAU * x).cos() * (TAU * y).cos());
    for [share, area, gap, largest] in BISINUSOID {
        let contact = press(&heights_m, &elastic(share * SQRT_2 * CLOSING, 1e-9));
        assert!(
            (contact.numbers.area_fraction_corrected - area).abs() < 0.01 * area.min(1.0 - area) + 2e-4,
            "{share}: {} {area}",
            contact.numbers.area_fraction_corrected
        );
        assert!(
            (contact.numbers.mean_gap_m - gap).abs() < 2e-6 + 2e-4 * gap,
            "{share}: {}",
            contact.numbers.mean_gap_m
        );
        let found = contact.numbers.largest_pressure_pa / (SQRT_2 * CLOSING);
        assert!((found / largest - 1.0).abs() < 2e-3, "{share}: {found} {largest}");
    }
    // Near full contact, 1 - A = (3/(2 pi))(1 - p/p*), of which the perimeter's correction is a part.
    let contact = press(&heights_m, &elastic(0.97 * SQRT_2 * CLOSING, 1e-9));
    let open = 1.0 - contact.numbers.area_fraction_corrected;
    assert!((open / (1.5 / PI * 0.03) - 1.0).abs() < 0.06, "{open}");
}

#[test]
fn hertz_in_a_wide_box_and_alone_on_the_half_space() {
    // A sphere of radius 1 whose contact has a radius of 40 points.
    let (points, spacing) = (128usize, 1e-4);
    let radius = 40.0 * spacing;
    let length = points as f64 * spacing;
    let middle = 0.5 * (points as f64 - 1.0);
    let heights_m = heights(points, points, |x, y| {
        let [x, y] = [x, y].map(|at| (at * points as f64 - middle) * spacing);
        -0.5 * (x * x + y * y)
    });
    let grid = Grid::new(points, points, length, length).unwrap();
    let force = 4.0 / 3.0 * radius.powi(3);
    let mut elements = Elements::free(grid, &heights_m).unwrap();
    let contact = elements.press(&elastic(force / length.powi(2), 1e-8), &Unobserved).unwrap();
    let found = (contact.numbers.area_fraction_corrected * length.powi(2) / PI).sqrt();
    assert!((found / radius - 1.0).abs() < 0.01, "{found} {radius}");
    let largest = 2.0 * radius / PI;
    assert!((contact.numbers.largest_pressure_pa / largest - 1.0).abs() < 0.01);
    // The top lies at 0, so that the offset is the approach a^2/R.
    assert!(
        (contact.offset_m / radius.powi(2) - 1.0).abs() < 0.01,
        "{} {}",
        contact.offset_m,
        radius.powi(2)
    );
    // dF/d(approach) = 2 E* a.
    let stiffness =
        elements.stiffness_pa_per_m(&contact, 1.0, &Unobserved).unwrap().unwrap() * length.powi(2);
    assert!((stiffness / (2.0 * radius) - 1.0).abs() < 0.01, "{stiffness}");
    // A saturation above the largest pressure changes nothing; one below it flows in the middle.
    let same = elements.press(&flowing(force / length.powi(2), 1.1 * largest, 1e-8), &Unobserved).unwrap();
    assert_eq!(same.numbers.plastic_area_fraction_corrected, 0.0);
    assert!((same.numbers.area_fraction - contact.numbers.area_fraction).abs() < 1e-12);
    let flat = elements.press(&flowing(force / length.powi(2), 0.5 * largest, 1e-6), &Unobserved).unwrap();
    assert_eq!(flat.numbers.largest_pressure_pa, 0.5 * largest);
    assert!(
        flat.numbers.plastic_area_fraction > 0.1 * flat.numbers.area_fraction
            && flat.numbers.area_fraction > contact.numbers.area_fraction
    );

    // In a periodic box of twenty radii: area within the count of points, and the largest pressure.
    let (points, spacing) = (512usize, 1e-3);
    let radius = 25.0 * spacing;
    let length = points as f64 * spacing;
    let heights_m =
        heights(points, points, |x, y| -0.5 * ((x - 0.5).powi(2) + (y - 0.5).powi(2)) * length * length);
    let grid = Grid::new(points, points, length, length).unwrap();
    let contact = Elements::periodic(grid, &heights_m)
        .unwrap()
        .press(&elastic(4.0 / 3.0 * radius.powi(3) / length.powi(2), 1e-8), &Unobserved)
        .unwrap();
    let found = (contact.numbers.area_fraction_corrected * length.powi(2) / PI).sqrt();
    assert!((found / radius - 1.0).abs() < 0.01, "{found} {radius}");
    assert!((contact.numbers.largest_pressure_pa / (2.0 * radius / PI) - 1.0).abs() < 0.01);
}

#[test]
fn a_square_punch_alone_on_the_half_space() {
    // Flat, so that heights lend no unit. The stiffness of a square of side L is about 1.15 E* L (Borodachev; Dempsey & Li
    // 1989: 1.1505), and the pressure is least in the middle.
    let points = 96;
    let grid = Grid::new(points, points, 2.0, 2.0).unwrap();
    let mut elements = Elements::free(grid, &vec![5.0; points * points]).unwrap();
    let contact = elements.press(&elastic(1e-3, 1e-9), &Unobserved).unwrap();
    assert_eq!(contact.numbers.area_fraction, 1.0);
    let approach = contact.offset_m + 5.0;
    assert!((1e-3 * 4.0 / approach / (1.1505 * 2.0) - 1.0).abs() < 0.02, "{approach}");
    let stiffness = elements.stiffness_pa_per_m(&contact, 1.0, &Unobserved).unwrap().unwrap();
    assert!((stiffness * approach / 1e-3 - 1.0).abs() < 1e-6);
}

#[test]
fn the_stiffness_is_the_slope_of_pressure_over_separation() {
    let heights_m = rough(96, 2.0, 6, 3);
    let grid = Grid::new(96, 96, 1.0, 1.0).unwrap();
    let mut elements = Elements::periodic(grid, &heights_m).unwrap();
    for pressure in [0.01, 0.1, 0.4] {
        let at = elements.press(&elastic(pressure, 1e-11), &Unobserved).unwrap();
        let stiffness = elements.stiffness_pa_per_m(&at, 1.0, &Unobserved).unwrap().unwrap();
        let [less, more] = [0.999, 1.001]
            .map(|factor| elements.press(&elastic(factor * pressure, 1e-11), &Unobserved).unwrap().offset_m);
        let slope = 2e-3 * pressure / (more - less);
        assert!((stiffness / slope - 1.0).abs() < 5e-3, "{pressure}: {stiffness} {slope}");
    }
}

#[test]
fn half_a_wave_flows_as_a_line_of_constant_pressure() {
    // If all of the contact flows, the area is p/H.
    let heights_m = heights(1, 2048, |x, _| (TAU * x).cos());
    let grid = Grid::new(1, 2048, 1.0, 1.0).unwrap();
    let mut elements = Elements::periodic(grid, &heights_m).unwrap();
    let contact = elements.press(&flowing(0.01, 0.04, 1e-8), &Unobserved).unwrap();
    assert!(
        contact.numbers.area_fraction >= 0.25 && contact.numbers.area_fraction < 0.26,
        "{}",
        contact.numbers.area_fraction
    );
    assert!((contact.numbers.plastic_area_fraction_corrected / 0.25 - 1.0).abs() < 0.02);
    assert!(contact.numbers.mean_plastic_depth_m > 0.0);
}

#[test]
fn a_fluid_passes_along_waves_and_not_across_them() {
    let heights_m = heights(32, 64, |x, _| (TAU * 2.0 * x).cos());
    let contact = |share_of_closing: f64| {
        let grid = Grid::new(32, 64, 1.0, 1.0).unwrap();
        let loading = elastic(2.0 * share_of_closing * CLOSING, 1e-10);
        let contact = Elements::periodic(grid, &heights_m).unwrap().press(&loading, &Unobserved).unwrap();
        let touching = contact.touching();
        let share = touching.iter().filter(|&&touches| touches).count() as f64 / touching.len() as f64;
        assert_eq!(share, contact.numbers.area_fraction);
        open_paths(&grid, Sides::Periodic, &touching).unwrap()
    };
    assert_eq!(contact(0.3), OpenPaths { along_x: false, along_y: true });
    assert_eq!(contact(1.1), OpenPaths { along_x: false, along_y: false });
}
