//! Adhesive contacts compared with two independent programs, with Johnson's wave and with limits of the theory.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use elements::half_space::{
    Adhesion, AdhesionError, AdhesiveContact, AdhesiveElements, Control, Grid, Start,
};
use elements::half_space::{Elements, Loading};
use elements::{AdhesiveError, AdhesivePressing, Boundary, Branch, Relief, Surfaces, adhesive_means};
use numerics::parallel::Unobserved;

fn reference_file(name: &str) -> Vec<u8> {
    std::fs::read(format!("{}/../../../tests/reference/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

/// Grid and heights of a reference map.
fn reference_map(name: &str) -> (Grid, Vec<f64>) {
    let file = format!("adhesion_{name}.nc");
    let read = scans::read_scans(&reference_file(&file), &file, &scans::ScanOptions::default()).unwrap();
    let scans::Scan::Map(map) = read[0].scan.clone().complete().unwrap() else { panic!("{name}: no map") };
    let [length_x_m, length_y_m] =
        [map.columns() as f64 * map.spacing_x_m(), map.rows() as f64 * map.spacing_y_m()];
    (Grid::new(map.rows(), map.columns(), length_x_m, length_y_m).unwrap(), map.heights_m().to_vec())
}

/// Rows of a table of references as functions from names to values.
fn each_row(name: &str, mut see: impl FnMut(&str, &dyn Fn(&str) -> f64)) {
    let table = reference_file(name);
    let mut reader = csv::Reader::from_reader(table.as_slice());
    let headers = reader.headers().unwrap().clone();
    for record in reader.records() {
        let record = record.unwrap();
        see(&record[0], &|name| {
            let at = headers.iter().position(|header| header == name).unwrap();
            record[at].parse().unwrap()
        });
    }
}

fn adhesion_of(field: &dyn Fn(&str) -> f64) -> Adhesion {
    Adhesion {
        work_j_per_m2: 1e-6 * field("work_of_adhesion_over_e_star_um"),
        range_m: 1e-6 * field("range_um"),
    }
}

fn solved(elements: &mut AdhesiveElements, control: Control, start: Start) -> AdhesiveContact {
    elements.solve(control, start, 1e-9, &Unobserved).unwrap()
}

#[test]
fn rows_are_those_of_two_independent_programs_from_both_starts() {
    let mut rows = 0;
    each_row("adhesion.csv", |map, field| {
        if map == "c" {
            return;
        }
        let (grid, heights_m) = reference_map(map);
        let pixel = 1.01 / grid.points() as f64;
        let mut elements = AdhesiveElements::new(grid, &heights_m, 1.0, adhesion_of(field)).unwrap();
        for start in [Start::Apart, Start::Contact] {
            let state = solved(&mut elements, Control::PressurePa(field("pressure_over_e_star")), start);
            assert!((state.numbers.area_fraction - field("area_fraction")).abs() < pixel, "{map} {start:?}");
            assert!((state.numbers.repulsive_area_fraction - field("repulsive_area_fraction")).abs() < pixel);
            assert_relative_eq!(state.numbers.mean_gap_m, 1e-6 * field("mean_gap_um"), max_relative = 1e-6);
            assert_relative_eq!(
                state.numbers.mean_attraction_pa,
                field("mean_attraction_over_e_star"),
                max_relative = 1e-6
            );
            assert_relative_eq!(
                state.numbers.largest_contact_pressure_pa,
                field("largest_contact_pressure_over_e_star"),
                max_relative = 1e-5
            );
        }
        rows += 1;
    });
    assert_eq!(rows, 18);
}

#[test]
fn held_mean_gaps_give_the_pressures_of_the_reference() {
    let mut rows = 0;
    each_row("adhesion_pull_off.csv", |map, field| {
        let (grid, heights_m) = reference_map(map);
        let mut elements = AdhesiveElements::new(grid, &heights_m, 1.0, adhesion_of(field)).unwrap();
        let state = solved(&mut elements, Control::MeanGapM(1e-6 * field("mean_gap_um")), Start::Apart);
        assert_relative_eq!(
            state.numbers.nominal_pressure_pa,
            field("pressure_over_e_star"),
            max_relative = 1e-6
        );
        assert_relative_eq!(state.numbers.area_fraction, field("area_fraction"), epsilon = 1.01 / 9216.0);
        assert!(state.numbers.nominal_pressure_pa < 0.0);
        rows += 1;
    });
    assert_eq!(rows, 7);
}

/// Map a as a periodic surface, with the attraction of the reference curve of its pull-off and E* = 1 Pa.
fn sticky(pressures_pa: &[f64]) -> (Surfaces, AdhesivePressing) {
    let (grid, heights_m) = reference_map("a");
    let relief = Relief {
        rows: grid.rows(),
        columns: grid.columns(),
        length_x_m: grid.length_x_m(),
        length_y_m: grid.length_y_m(),
        heights_m,
        boundary: Boundary::Periodic,
        is_missing: Vec::new(),
    };
    let pressing = AdhesivePressing {
        contact_modulus_pa: 1.0,
        adhesion: Adhesion { work_j_per_m2: 3.75e-11, range_m: 1.25e-9 },
        pressures_pa: pressures_pa.to_vec(),
        branches: vec![Branch::Apart, Branch::Contact],
        tolerance: 1e-8,
    };
    (Surfaces::Maps(vec![relief]), pressing)
}

#[test]
fn surfaces_pulled_apart_have_the_pull_off_of_the_reference() {
    let (surfaces, pressing) = sticky(&[]);
    let states = pressing.pull_apart(&surfaces, &Unobserved).unwrap();
    let strongest = states
        .iter()
        .min_by(|a, b| a.numbers.nominal_pressure_pa.total_cmp(&b.numbers.nominal_pressure_pa))
        .unwrap();
    assert_relative_eq!(strongest.numbers.nominal_pressure_pa, -7.62846e-4, max_relative = 2e-3);
    assert!(states.windows(2).all(|pair| pair[0].numbers.mean_gap_m < pair[1].numbers.mean_gap_m));
    assert!(
        states[0].numbers.nominal_pressure_pa == 0.0
            && states[0].numbers.area_fraction > strongest.numbers.area_fraction
    );
    let last = states.last().unwrap();
    assert!(last.numbers.nominal_pressure_pa > 0.2 * strongest.numbers.nominal_pressure_pa, "{last:?}");
}

#[test]
fn branches_are_in_the_order_of_the_loads_and_meet_where_the_state_is_unique() {
    let (surfaces, pressing) = sticky(&[0.005, -5e-4, 0.001]);
    let states = pressing.press(&surfaces, &Unobserved).unwrap();
    let loads: Vec<f64> = states.iter().map(|state| state.numbers.nominal_pressure_pa).collect();
    assert_eq!(loads, [0.005, -5e-4, 0.001, 0.005, -5e-4, 0.001]);
    let (apart, contact) = states.split_at(3);
    assert!(apart.iter().all(|state| state.branch == Branch::Apart));
    for (apart, contact) in apart.iter().zip(contact) {
        assert_relative_eq!(apart.numbers.mean_gap_m, contact.numbers.mean_gap_m, max_relative = 1e-5);
    }
    assert!(
        apart[1].numbers.area_fraction < apart[2].numbers.area_fraction
            && apart[2].numbers.area_fraction < apart[0].numbers.area_fraction
    );
    assert_eq!(adhesive_means(&states), states);
}

#[test]
fn free_edges_no_load_and_a_pull_that_nothing_bears_are_refused() {
    let (surfaces, pressing) = sticky(&[0.001, -2e-3]);
    let error = pressing.press(&surfaces, &Unobserved).unwrap_err();
    let AdhesiveError::PulledOff { nominal_pressure_pa, held_pa } = error else { panic!("{error}") };
    assert!((-2e-3..-7.6e-4).contains(&nominal_pressure_pa) && nominal_pressure_pa < held_pa);
    let (_, idle) = sticky(&[]);
    assert_eq!(idle.press(&surfaces, &Unobserved).unwrap_err(), AdhesiveError::NoLoad);
    let Surfaces::Maps(maps) = surfaces else { panic!("a map") };
    let free = Relief { boundary: Boundary::Free, ..maps[0].clone() };
    assert_eq!(pressing.resolution(&free).unwrap_err(), AdhesiveError::FreeEdges);
}

/// Wave along a line with E* = 1, lambda = 1 and the work of adhesion of the contract.
fn wave(points: usize, process_zone: f64) -> AdhesiveElements {
    let heights: Vec<f64> =
        (0..points).map(|at| 0.01 * (2.0 * PI * at as f64 / points as f64).cos()).collect();
    let work_j_per_m2 = PI * PI / 4.0 * 1e-5;
    let adhesion = Adhesion { work_j_per_m2, range_m: (process_zone * work_j_per_m2).sqrt() };
    let grid = Grid::new(1, points, 1.0, 1.0).unwrap();
    AdhesiveElements::new(grid, &heights, 1.0, adhesion).unwrap()
}

/// Areas while the load falls, with the process zone at the edges counted as Johnson does: 0.7 of it on either side.
#[test]
fn wave_is_that_of_johnson() {
    let full_pa = 0.01 * PI;
    for process_zone in [0.001, 0.003, 0.01] {
        let mut elements = wave(4096, process_zone);
        solved(&mut elements, Control::PressurePa(0.4 * full_pa), Start::Apart);
        for (share, johnson) in [(0.25, 0.4784), (0.1, 0.3519), (0.0, 0.2468)] {
            let state = solved(&mut elements, Control::PressurePa(share * full_pa), Start::Last);
            let area = state.numbers.area_fraction + 1.4 * process_zone;
            assert!((area - johnson).abs() < 0.001, "{process_zone} {share}: {area} and {johnson}");
        }
    }
}

/// Largest pull on a parabola of the radius 1 m in a box, over pi w R: the mean gap is held and grows from that of first touch by
/// some parts of the range.
fn parabola_pull_off(points: usize, side_m: f64, adhesion: Adhesion, parts: &[f64]) -> f64 {
    let place = |at: usize| (at as f64 - 0.5 * points as f64) * side_m / points as f64;
    let heights: Vec<f64> = (0..points * points)
        .map(|at| -0.5 * (place(at / points).powi(2) + place(at % points).powi(2)))
        .collect();
    let touching_m = -heights.iter().sum::<f64>() / heights.len() as f64;
    let grid = Grid::new(points, points, side_m, side_m).unwrap();
    let mut elements = AdhesiveElements::new(grid, &heights, 1.0, adhesion).unwrap();
    let mut largest: f64 = 0.0;
    let mut start = Start::Apart;
    for part in parts {
        let gap_m = touching_m + part * adhesion.range_m;
        let state = solved(&mut elements, Control::MeanGapM(gap_m), start);
        largest = largest.max(-state.numbers.nominal_pressure_pa * side_m * side_m);
        start = Start::Last;
    }
    largest / (PI * adhesion.work_j_per_m2)
}

/// Adhesion of a Tabor number (R w^2/(E*^2 rho^3))^(1/3) for R = 1 m and E* = 1 Pa.
fn of_tabor(number: f64, range_m: f64) -> Adhesion {
    Adhesion { work_j_per_m2: (number * range_m).powf(1.5), range_m }
}

#[test]
fn stiff_parabola_pulls_off_as_a_rigid_one() {
    let parts: Vec<f64> = (-12..=12).map(|step| 0.005 * f64::from(step)).collect();
    for (tabor, expected) in [(0.05, 1.984), (0.02, 1.992)] {
        let found = parabola_pull_off(96, 0.1, of_tabor(tabor, 1e-4), &parts);
        assert!((found / expected - 1.0).abs() < 0.005, "{tabor}: {found}");
    }
}

#[test]
fn soft_parabola_pulls_off_as_johnson_kendall_and_roberts_have_it() {
    let parts: Vec<f64> = (-4..=8).map(|step| 0.5 * f64::from(step)).collect();
    for (tabor, expected) in [(1.78, 1.598), (2.52, 1.559)] {
        let found = parabola_pull_off(160, 0.02, of_tabor(tabor, 1e-6), &parts);
        assert!((found / expected - 1.0).abs() < 0.02, "{tabor}: {found}");
    }
}

#[test]
fn full_contact_outlives_the_load_at_which_it_forms() {
    let full_pa = 0.01 * PI;
    let mut elements = wave(1024, 0.01);
    let least_pa = elements.full_contact_pressure_pa();
    assert!(least_pa < 0.1 * full_pa, "{least_pa}");
    let apart = solved(&mut elements, Control::PressurePa(0.1 * full_pa), Start::Apart);
    let contact = solved(&mut elements, Control::PressurePa(0.1 * full_pa), Start::Contact);
    assert!((apart.numbers.area_fraction - 0.34).abs() < 0.005 && contact.numbers.area_fraction == 1.0);
}

fn plain_mean_gap_m(grid: Grid, heights_m: &[f64], pressure_pa: f64) -> (f64, Vec<f64>) {
    let loading = Loading {
        contact_modulus_pa: 1.0,
        nominal_pressure_pa: pressure_pa,
        saturation_pa: None,
        tolerance: 1e-12,
    };
    let contact = Elements::periodic(grid, heights_m).unwrap().press(&loading, &Unobserved).unwrap();
    (contact.numbers.mean_gap_m, contact.gaps_m)
}

#[test]
fn weak_adhesion_is_plain_contact() {
    let (grid, heights_m) = reference_map("a");
    let (plain_m, gaps_m) = plain_mean_gap_m(grid, &heights_m, 0.005);
    for (work, share) in [(1e-13, 3e-3), (1e-14, 3e-4)] {
        let adhesion = Adhesion { work_j_per_m2: work, range_m: 1e-9 };
        let mut elements = AdhesiveElements::new(grid, &heights_m, 1.0, adhesion).unwrap();
        let state = solved(&mut elements, Control::PressurePa(0.005), Start::Apart);
        assert_relative_eq!(state.numbers.mean_gap_m, plain_m, max_relative = share);
        let attraction = |gap_m: &f64| work / 1e-9 * (-gap_m.max(0.0) / 1e-9).exp();
        let mean_pa = gaps_m.iter().map(attraction).sum::<f64>() / gaps_m.len() as f64;
        assert_relative_eq!(state.numbers.mean_attraction_pa, mean_pa, max_relative = share);
    }
}

#[test]
fn attraction_of_a_long_range_is_a_load() {
    let (grid, heights_m) = reference_map("a");
    let strength_pa = 0.003;
    let (plain_m, _) = plain_mean_gap_m(grid, &heights_m, 0.005 + strength_pa);
    for ratio in [100.0, 1000.0] {
        let range_m = ratio * plain_m;
        let adhesion = Adhesion { work_j_per_m2: strength_pa * range_m, range_m };
        let mut elements = AdhesiveElements::new(grid, &heights_m, 1.0, adhesion).unwrap();
        let state = solved(&mut elements, Control::PressurePa(0.005), Start::Apart);
        let off = (state.numbers.mean_gap_m / plain_m - 1.0) * ratio;
        assert!(off.abs() < 2.0, "{ratio}: {off}");
    }
}

#[test]
fn unresolved_process_zones_and_loads_beyond_pull_off_are_refused() {
    let (grid, heights_m) = reference_map("a");
    let tight = Adhesion { work_j_per_m2: 3.75e-11, range_m: 1.25e-10 };
    let error = AdhesiveElements::new(grid, &heights_m, 1.0, tight).err().unwrap();
    let AdhesionError::Unresolved { points, process_zone_m, .. } = error else { panic!("{error}") };
    assert_eq!(points, (2.0 * grid.length_x_m() / process_zone_m).ceil() as usize);
    let adhesion = Adhesion { work_j_per_m2: 3.75e-11, range_m: 1.25e-9 };
    let mut elements = AdhesiveElements::new(grid, &heights_m, 1.0, adhesion).unwrap();
    assert!(elements.solve(Control::PressurePa(-7e-4), Start::Contact, 1e-8, &Unobserved).is_ok());
    let error = elements.solve(Control::PressurePa(-2e-3), Start::Contact, 1e-8, &Unobserved).unwrap_err();
    assert_eq!(error, AdhesionError::PulledOff { nominal_pressure_pa: -2e-3 });
}
