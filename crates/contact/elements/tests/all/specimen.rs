//! Outlines of specimens, and their own compliance.

use std::f64::consts::PI;
use std::sync::Mutex;

use crate::common::rough;
use elements::half_space::{Elements, Grid, HalfSpaceError, Loading};
use elements::{
    Boundary, ContactField, ElementsError, ImposedLoad, Indenter, IndenterError, IndenterPressing,
    IndenterShape, Outline, PointState, PressedLoad, Pressing, Relief, SpecimenCompliance, Surfaces, press,
    stiffness_without,
};
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

/// A rough disc with a hole, in a frame of missing points.
fn rough_disc() -> Relief {
    let (points, side_m) = (48, 3e-3);
    let is_missing = (0..points * points).map(|point| {
        let [y, x] = [point / points, point % points].map(|at| at as f64 - 23.5);
        x.hypot(y) > 20.0 || (x - 5.0).hypot(y) < 3.0
    });
    Relief {
        rows: points,
        columns: points,
        length_x_m: side_m,
        length_y_m: side_m,
        heights_m: rough(points, 2.0, 6, 11).iter().map(|height| 1e-6 * height).collect(),
        boundary: Boundary::Free,
        is_missing: is_missing.collect(),
    }
}

fn pressed(relief: &Relief, pressing: &Pressing) -> PressedLoad {
    let surfaces = Surfaces::Maps(vec![relief.clone()]);
    let mut loads = press::<ElementsError>(&surfaces, pressing, |_| Ok(()), &Unobserved).unwrap();
    loads.pop().unwrap()
}

fn at_pressure(pressure_pa: f64) -> Pressing {
    Pressing {
        loads: vec![ImposedLoad::PressurePa(pressure_pa)],
        tolerance: 1e-9,
        stiffness: true,
        ..Pressing::elastic(MODULUS_PA)
    }
}

#[test]
fn missing_points_never_touch_and_loads_are_over_the_specimen() {
    let disc = rough_disc();
    let (outline, missing) = (disc.outline().unwrap(), disc.is_missing.iter().filter(|is| **is).count());
    let holes = missing - (disc.is_missing.len() - outline.points());
    assert!(holes > 20 && outline.share() < 0.6);
    // The same disc with points that are far too deep to touch in place of missing ones.
    let deep = |&(height_m, is_missing): &(f64, bool)| if is_missing { -1.0 } else { height_m };
    let heights_m = disc.heights_m.iter().copied().zip(disc.is_missing.iter().copied());
    let sunk = Relief {
        heights_m: heights_m.map(|point| deep(&point)).collect(),
        is_missing: Vec::new(),
        ..disc.clone()
    };
    let share = outline.share();
    for pressure_pa in [2e6, 2e7, 2e8] {
        let (of_disc, of_sunk) = (
            pressed(&disc, &at_pressure(pressure_pa)),
            pressed(&sunk, &Pressing { tolerance: 1e-13, ..at_pressure(share * pressure_pa) }),
        );
        let [state, other] = [&of_disc, &of_sunk].map(|load| load.states[0]);
        assert_eq!(of_disc.nominal_pressure_pa, pressure_pa);
        let points = |area: f64| area * 48.0 * 48.0;
        assert!(
            (points(share * state.numbers.area_fraction) - points(other.numbers.area_fraction)).abs() < 0.1
        );
        let corrected = share * state.numbers.area_fraction_corrected / other.numbers.area_fraction_corrected;
        assert!((corrected - 1.0).abs() < 1e-12, "{corrected}");
        let stiffness = share * state.stiffness_pa_per_m.unwrap() / other.stiffness_pa_per_m.unwrap();
        assert!((stiffness - 1.0).abs() < 1e-6, "{stiffness}");
        assert!((state.numbers.largest_pressure_pa / other.numbers.largest_pressure_pa - 1.0).abs() < 1e-4);
    }
}

#[test]
fn nothing_but_the_missing_points_keeps_a_flat_disc_from_touching() {
    let disc = Relief { heights_m: vec![0.0; 48 * 48], ..rough_disc() };
    let flat = pressed(&disc, &at_pressure(1e6)).states[0];
    let measured = disc.is_missing.iter().filter(|is| !**is).count();
    assert_eq!(flat.numbers.area_fraction, measured as f64 / disc.outline().unwrap().points() as f64);
    assert!(flat.numbers.mean_gap_m < 1e-15);
    // The hole lets the flat closer than the whole disc as a punch.
    let punch = Pressing { compliance: SpecimenCompliance::Punch, ..at_pressure(1e6) };
    let without = pressed(&disc, &punch).states[0].stiffness_pa_per_m.unwrap();
    assert!(without > 10.0 * flat.stiffness_pa_per_m.unwrap(), "{without}");
    let whole = Relief {
        is_missing: disc.outline().unwrap().is_inside().iter().map(|inside| !inside).collect(),
        ..disc
    };
    assert_eq!(pressed(&whole, &punch).states[0].stiffness_pa_per_m, None);
}

#[test]
fn the_compliance_is_taken_out_of_each_stiffness() {
    let disc = rough_disc();
    let stiffness = |compliance| {
        pressed(&disc, &Pressing { compliance, ..at_pressure(2e5) }).states[0].stiffness_pa_per_m.unwrap()
    };
    let whole = stiffness(SpecimenCompliance::None);
    for kind in [SpecimenCompliance::Punch, SpecimenCompliance::Even] {
        let own = disc.outline().unwrap().compliance_m_per_pa(kind, MODULUS_PA, &Unobserved).unwrap();
        assert!(((1.0 / whole - own) * stiffness(kind) - 1.0).abs() < 1e-12);
    }
    assert!(stiffness(SpecimenCompliance::Punch) < stiffness(SpecimenCompliance::Even));
}

#[test]
fn loads_that_the_points_left_cannot_carry_are_refused() {
    let disc = rough_disc();
    let outline = disc.outline().unwrap();
    let measured = disc.is_missing.iter().filter(|is| !**is).count() as f64;
    let share = measured / outline.points() as f64;
    let carried = |pressure_pa: f64| {
        let pressing = Pressing { saturation_pa: Some(1e8), stiffness: false, ..at_pressure(pressure_pa) };
        let surfaces = Surfaces::Maps(vec![disc.clone()]);
        press::<ElementsError>(&surfaces, &pressing, |_| Ok(()), &Unobserved)
    };
    assert!(carried(0.999 * share * 1e8).unwrap()[0].states[0].numbers.plastic_area_fraction > 0.9 * share);
    assert!(matches!(
        carried(1.001 * share * 1e8).unwrap_err(),
        ElementsError::HalfSpace(HalfSpaceError::CannotBeCarried { .. })
    ));
}

#[test]
fn holes_of_a_periodic_map_stay_open() {
    let disc = Relief { boundary: Boundary::Periodic, ..rough_disc() };
    assert_eq!(disc.outline().unwrap().share(), 1.0);
    let load = pressed(&disc, &at_pressure(2e8));
    let touching = Mutex::new(Vec::new());
    let see = |field: &ContactField<'_>| {
        *touching.lock().unwrap() = field.states().map(|state| state != PointState::Open).collect();
        assert!(
            field
                .gaps_m
                .iter()
                .zip(&disc.is_missing)
                .all(|(gap_m, is_missing)| gap_m.is_finite() != *is_missing)
        );
        let mut file = Vec::new();
        field.write_netcdf(&[], &mut file).unwrap();
        Ok(())
    };
    press::<ElementsError>(&Surfaces::Maps(vec![disc.clone()]), &at_pressure(2e8), see, &Unobserved).unwrap();
    let touching = touching.into_inner().unwrap();
    assert!(touching.iter().zip(&disc.is_missing).all(|(touches, is_missing)| !(touches & is_missing)));
    let count = touching.iter().filter(|touches| **touches).count();
    assert_eq!(load.states[0].numbers.area_fraction, count as f64 / (48.0 * 48.0));
}

#[test]
fn paths_lead_from_edge_to_edge_of_the_specimen() {
    // Ridges along y on a square in a frame: open along y, shut along x.
    let (points, is_inside) = (32, 8..24);
    let at = |point: usize| (point / points, point % points);
    let framed = Relief {
        rows: points,
        columns: points,
        length_x_m: 1e-3,
        length_y_m: 1e-3,
        heights_m: (0..points * points).map(|point| if at(point).1 % 8 < 3 { 1e-5 } else { 0.0 }).collect(),
        boundary: Boundary::Free,
        is_missing: (0..points * points)
            .map(|point| !is_inside.contains(&at(point).0) || !is_inside.contains(&at(point).1))
            .collect(),
    };
    let state = pressed(&framed, &at_pressure(1e6)).states[0];
    assert!(state.open.along_y && !state.open.along_x);
}

#[test]
fn only_a_flat_meets_missing_points() {
    let disc = rough_disc();
    let indenter = Indenter { shape: IndenterShape::Ball, radius_m: 0.1, force: 1e-3 };
    let pressing = IndenterPressing { contact_modulus_pa: MODULUS_PA, tolerance: 1e-6 };
    let missing = disc.is_missing.iter().filter(|is| **is).count();
    let expected = HalfSpaceError::MissingPoints { missing };
    assert_eq!(
        indenter.press(&disc, &pressing, &Unobserved).unwrap_err(),
        IndenterError::HalfSpace(expected)
    );
}
