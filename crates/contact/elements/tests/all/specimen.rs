//! Outlines of specimens, and their own compliance.

use std::f64::consts::PI;

use elements::half_space::{Elements, Grid, HalfSpaceError, Loading};
use elements::{Boundary, Outline, SpecimenCompliance, stiffness_without};
use numerics::parallel::Unobserved;

const MODULUS_PA: f64 = 5e9;

/// Missing points of a map in which they are `.`.
fn missing(rows: &[&str]) -> (Grid, Vec<bool>) {
    let grid = Grid::new(rows.len(), rows[0].len(), 1.0, 1.0).unwrap();
    (grid, rows.iter().flat_map(|row| row.bytes().map(|point| point == b'.')).collect())
}

/// A disc that touches the middles of the sides of its frame.
fn disc(points: usize) -> Outline {
    let grid = Grid::new(points, points, 0.3, 0.3).unwrap();
    let from_middle = |at: usize| (at as f64 + 0.5) / points as f64 - 0.5;
    let is_missing: Vec<bool> = (0..points * points)
        .map(|point| from_middle(point / points).hypot(from_middle(point % points)) > 0.5)
        .collect();
    Outline::new(grid, Boundary::Free, &is_missing).unwrap()
}

fn rectangle(rows: usize, columns: usize, spacing_m: f64) -> Outline {
    let grid = Grid::new(rows, columns, columns as f64 * spacing_m, rows as f64 * spacing_m).unwrap();
    Outline::new(grid, Boundary::Free, &vec![false; rows * columns]).unwrap()
}

fn stiffness_pa_per_m(outline: &Outline, kind: SpecimenCompliance) -> f64 {
    1.0 / outline.compliance_m_per_pa(kind, MODULUS_PA, &Unobserved).unwrap()
}

#[test]
fn missing_points_that_reach_the_edge_are_outside_and_others_are_holes() {
    let map = ["..##.", ".#.##", ".####", "..#..", "#.#.#"];
    let (grid, is_missing) = missing(&map);
    let outline = Outline::new(grid, Boundary::Free, &is_missing).unwrap();
    let inside: Vec<String> = outline
        .is_inside()
        .chunks(5)
        .map(|row| row.iter().map(|&is_inside| if is_inside { '#' } else { '.' }).collect())
        .collect();
    // Corners do not connect: the point in the second row is a hole.
    assert_eq!(inside, ["..##.", ".####", ".####", "..#..", "#.#.#"]);
    assert_eq!(outline.share(), 14.0 / 25.0);
    assert_eq!(outline.area_m2(), 14.0 / 25.0);
    let periodic = Outline::new(grid, Boundary::Periodic, &is_missing).unwrap();
    assert_eq!(periodic.share(), 1.0);
    for kind in SpecimenCompliance::ALL {
        assert_eq!(periodic.compliance_m_per_pa(*kind, MODULUS_PA, &Unobserved).unwrap(), 0.0);
    }
}

#[test]
fn a_map_without_heights_has_no_specimen() {
    let (grid, is_missing) = missing(&["..", ".."]);
    assert_eq!(Outline::new(grid, Boundary::Free, &is_missing).unwrap_err(), HalfSpaceError::NoSpecimen);
    let error = Outline::new(grid, Boundary::Free, &[true]).unwrap_err();
    assert_eq!(error, HalfSpaceError::Size { given: 1, expected: 4 });
}

#[test]
fn a_disc_sinks_as_known() {
    // Johnson (1985), sections 3.4 and 3.6: a rigid punch by F/(2 E* a), even pressure on average by 16 p a/(3 pi E*). The
    // radius is that of the area of the points.
    let mut errors = Vec::new();
    for points in [64, 128, 256] {
        let outline = disc(points);
        let radius_m = (outline.area_m2() / PI).sqrt();
        let punch = 2.0 * MODULUS_PA / (PI * radius_m);
        let even = 3.0 * PI * MODULUS_PA / (16.0 * radius_m);
        errors.push(stiffness_pa_per_m(&outline, SpecimenCompliance::Punch) / punch - 1.0);
        let error = stiffness_pa_per_m(&outline, SpecimenCompliance::Even) / even - 1.0;
        assert!(error.abs() < 0.2 / points as f64, "{points}: {error}");
    }
    // The infinite pressure at the edge makes the error one of first order in the spacing.
    assert!(errors[0].abs() < 0.02 && errors[2].abs() < 0.005, "{errors:?}");
    assert!((2.0 * errors[2] - errors[1]).abs() < 1e-3, "{errors:?}");
    assert_eq!(disc(64).compliance_m_per_pa(SpecimenCompliance::None, MODULUS_PA, &Unobserved).unwrap(), 0.0);
}

#[test]
fn rectangles_sink_as_known() {
    // Punch: F = pi E* C times the approach, with the electrostatic capacitance C of the plate in units of length; 0.36679 L
    // for a square (Read 1997, J. Comput. Phys. 133:1; Mascagni & Simonov 2004, J. Comput. Phys. 195:465).
    let of_square = |points: usize| {
        stiffness_pa_per_m(&rectangle(points, points, 0.01), SpecimenCompliance::Punch) * 0.01 * points as f64
    };
    let square = 2.0 * of_square(128) - of_square(64);
    assert!((square / (PI * MODULUS_PA * 0.36679) - 1.0).abs() < 5e-4, "{square}");
    // Even pressure: the mean over a and b of the integral of 1/r over a and b, in closed form.
    for (rows, columns) in [(64, 64), (40, 120)] {
        let [a, b] = [columns as f64 * 0.01, rows as f64 * 0.01];
        let integral = 2.0 * a * b * (a * (b / a).asinh() + b * (a / b).asinh())
            - 2.0 / 3.0 * (a.hypot(b).powi(3) - a.powi(3) - b.powi(3));
        let known = PI * MODULUS_PA * a * b / integral;
        let found = stiffness_pa_per_m(&rectangle(rows, columns, 0.01), SpecimenCompliance::Even);
        assert!((found / known - 1.0).abs() < 2e-4, "{rows} x {columns}: {found} {known}");
    }
}

#[test]
fn nothing_is_left_of_a_contact_that_touches_everywhere() {
    let (points, spacing_m) = (48, 1e-3);
    let outline = rectangle(points, points, spacing_m);
    let compliance = outline.compliance_m_per_pa(SpecimenCompliance::Punch, MODULUS_PA, &Unobserved).unwrap();
    let side_m = points as f64 * spacing_m;
    let grid = Grid::new(points, points, side_m, side_m).unwrap();
    let loading = Loading {
        contact_modulus_pa: MODULUS_PA,
        nominal_pressure_pa: 1e6,
        saturation_pa: None,
        tolerance: 1e-8,
    };
    let stiffness_of = |depth_m: f64| {
        // Every second row is too deep to touch.
        let heights_m: Vec<f64> =
            (0..points * points).map(|point| -depth_m * ((point / points) % 2) as f64).collect();
        let mut elements = Elements::free(grid, &heights_m).unwrap();
        let contact = elements.press(&loading, &Unobserved).unwrap();
        elements.stiffness_pa_per_m(&contact, MODULUS_PA, &Unobserved).unwrap().unwrap()
    };
    assert_eq!(stiffness_without(compliance, stiffness_of(0.0)), None);
    let ridges = stiffness_of(1e-3);
    let rest = stiffness_without(compliance, ridges).unwrap();
    assert!((1.0 / rest + compliance - 1.0 / ridges).abs() < 1e-12 / ridges);
    assert_eq!(stiffness_without(0.0, ridges), Some(ridges));
}
