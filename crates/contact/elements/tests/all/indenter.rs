//! Balls and cylinders on flats compared with Hertz, Greenwood & Tripp's trend and an independent program.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use elements::half_space::HalfSpaceError;
use elements::{
    Boundary, Indenter, IndenterError, IndenterPressing, IndenterShape, IndenterState, RandomSurfaces,
    Relief, Surfaces, indenter_table,
};
use numerics::parallel::{Progress, Unobserved};
use spectrum::random_surfaces::{AreaSpectrum, Phases, SelfAffine, Size, Synthesis};
use units::RemarkCode;

/// E* of 1 Pa.
const PRESSING: IndenterPressing = IndenterPressing { contact_modulus_pa: 1.0, tolerance: 1e-10 };

fn smooth(rows: usize, columns: usize, spacing_m: f64) -> Relief {
    Relief {
        rows,
        columns,
        length_x_m: columns as f64 * spacing_m,
        length_y_m: rows as f64 * spacing_m,
        heights_m: vec![0.0; rows * columns],
        boundary: Boundary::Free,
        is_missing: Vec::new(),
    }
}

/// Ball whose contact radius on a smooth flat is `radius_m` at E* = 1 Pa.
fn ball(radius_m: f64, contact_radius_m: f64) -> Indenter {
    Indenter {
        shape: IndenterShape::Ball,
        radius_m,
        force: 4.0 * contact_radius_m.powi(3) / (3.0 * radius_m),
    }
}

/// Cylinder whose half-width of contact on a smooth flat is `half_width_m` at E* = 1 Pa.
fn cylinder(radius_m: f64, half_width_m: f64) -> Indenter {
    let force = PI * half_width_m.powi(2) / (4.0 * radius_m);
    Indenter { shape: IndenterShape::Cylinder, radius_m, force }
}

fn pressed(ball: Indenter, flat: &Relief) -> IndenterState {
    ball.press(flat, &PRESSING, &Unobserved).unwrap().0
}

fn reference_file(name: &str) -> Vec<u8> {
    std::fs::read(format!("{}/../../../tests/reference/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn reference_map(name: &str) -> Relief {
    let file = format!("adhesion_{name}.nc");
    let read = scans::read_scans(&reference_file(&file), &file, &scans::ScanOptions::default()).unwrap();
    let scans::Scan::Map(map) = read[0].scan.clone().complete().unwrap() else { panic!("{name}: no map") };
    Relief {
        rows: map.rows(),
        columns: map.columns(),
        length_x_m: map.columns() as f64 * map.spacing_x_m(),
        length_y_m: map.rows() as f64 * map.spacing_y_m(),
        heights_m: map.heights_m().to_vec(),
        boundary: Boundary::Periodic,
        is_missing: Vec::new(),
    }
}

#[test]
fn rows_are_those_of_an_independent_program() {
    let table = reference_file("ball.csv");
    let mut reader = csv::Reader::from_reader(table.as_slice());
    let headers = reader.headers().unwrap().clone();
    let mut rows = 0;
    for record in reader.records() {
        let record = record.unwrap();
        let field = |name: &str| {
            let at = headers.iter().position(|header| header == name).unwrap();
            record[at].parse::<f64>().unwrap()
        };
        let flat = reference_map(&record[0]);
        let ball = Indenter {
            shape: IndenterShape::Ball,
            radius_m: 1e-6 * field("ball_radius_um"),
            force: 1e-12 * field("force_over_e_star_um2"),
        };
        let state = pressed(ball, &flat);
        let of_points_m2 = flat.length_x_m / flat.columns as f64 * flat.length_y_m / flat.rows as f64;
        assert!((state.real_area - 1e-12 * field("real_area_um2")).abs() < 1.01 * of_points_m2, "{state:?}");
        for (ours, theirs) in [
            (state.hertz_radius_m, 1e-6 * field("hertz_radius_um")),
            (state.hertz_pressure_pa, field("hertz_pressure_over_e_star")),
            (state.effective_radius_m, 1e-6 * field("effective_radius_um")),
            (state.peak_mean_pressure_pa, field("peak_mean_pressure_over_e_star")),
            (state.force_share, field("force_share_inside_half_hertz_radius")),
            (state.outermost_contact_m, 1e-6 * field("outermost_contact_um")),
            (state.roughness_number, field("greenwood_tripp_alpha")),
        ] {
            assert_relative_eq!(ours, theirs, max_relative = 1e-6);
        }
        rows += 1;
    }
    assert_eq!(rows, 9);
}

#[test]
fn smooth_ball_is_hertz() {
    // Points along the contact radius, and errors of the radius, of the ring average and of the force share.
    for (points, radius, share) in [(12.8, 4e-4, 0.04), (25.6, 2e-4, 0.02)] {
        let state = pressed(ball(1.0, 1e-2), &smooth(128, 128, 1e-2 / points));
        assert_relative_eq!(state.effective_radius_m, state.hertz_radius_m, max_relative = radius);
        let peak = state.peak_mean_pressure_pa / state.hertz_pressure_pa;
        assert!((0.994..0.997).contains(&peak), "{points}: {peak}");
        assert_relative_eq!(state.force_share, 1.0 - 0.75f64.powf(1.5), max_relative = share);
        let area_m2 = PI * state.hertz_radius_m.powi(2);
        assert_relative_eq!(state.real_area, area_m2, max_relative = 0.02);
        assert_relative_eq!(state.points_per_radius, points, max_relative = 1e-12);
    }
}

#[test]
fn roughness_widens_the_contact_and_lowers_its_pressure() {
    let map = reference_map("a");
    let rms_m = (map.heights_m.iter().map(|h| h * h).sum::<f64>() / map.heights_m.len() as f64).sqrt();
    let contact_radius_m = 0.15 * map.length_x_m;
    // Means over four places of the effective radius and of the peak, over Hertz's.
    let means = |roughness_number: f64| {
        let ball = ball(roughness_number * contact_radius_m.powi(2) / rms_m, contact_radius_m);
        let places = [0, 24, 48, 72].map(|shift| {
            let mut flat = map.clone();
            flat.heights_m.rotate_left(shift * flat.columns + shift);
            let state = pressed(ball, &flat);
            assert_relative_eq!(state.roughness_number, roughness_number, max_relative = 1e-3);
            [
                state.effective_radius_m / state.hertz_radius_m,
                state.real_area / (PI * contact_radius_m.powi(2)),
            ]
        });
        [0, 1].map(|row| places.iter().map(|place| place[row]).sum::<f64>() / 4.0)
    };
    let [[radius, area], [rough_radius, rough_area]] = [means(0.01), means(0.5)];
    assert!((radius - 1.0).abs() < 0.005 && (area - 1.0).abs() < 0.02, "{radius}, {area}");
    assert!((1.1..1.6).contains(&rough_radius) && rough_area < 0.5, "{rough_radius}, {rough_area}");
}

#[test]
fn cylinder_in_a_periodic_box_is_hertz_with_the_share_of_its_neighbours() {
    let flat = smooth(1, 1024, 1.0 / 1024.0);
    for share in [0.05, 0.1, 0.2] {
        let radius_m = 10.0;
        let cylinder = cylinder(radius_m, share);
        assert_relative_eq!(cylinder.hertz_radius_m(1.0), share, max_relative = 1e-12);
        let (state, contact) = cylinder.press(&flat, &PRESSING, &Unobserved).unwrap();
        let ratio = contact.numbers.largest_pressure_pa / cylinder.hertz_pressure_pa(1.0);
        assert!((ratio - 1.0 - (PI * share).powi(2) / 12.0).abs() < 1e-3, "{share}: {ratio}");
        let half_width_m = 0.5 * contact.numbers.area_fraction;
        let narrower = share * (1.0 - (PI * share).powi(2) / 12.0);
        assert!((half_width_m - narrower).abs() < 2.5 / 1024.0, "{share}: {half_width_m}");
        assert!((state.effective_radius_m / narrower - 1.0).abs() < 2e-3, "{share}: {state:?}");
        assert_relative_eq!(state.real_area, contact.numbers.area_fraction, max_relative = 1e-12);
        // The first strip has a width.
        assert!((0.99..1.04).contains(&(state.peak_mean_pressure_pa / state.hertz_pressure_pa)), "{state:?}");
        let expected = 1.0 / 3.0 + 3f64.sqrt() / (2.0 * PI);
        assert!((state.force_share - expected).abs() < 0.02, "{share}: {}", state.force_share);
        let narrow = state.remarks().iter().any(|remark| remark.code == RemarkCode::CylinderNarrowBox);
        assert_eq!(narrow, share > 0.1 + 1e-9, "{state:?}");
    }
}

#[test]
fn a_rough_flat_widens_the_contact_of_a_cylinder_and_leaves_less_of_it() {
    let spectrum = AreaSpectrum::self_affine(&SelfAffine {
        hurst_exponent: 0.8,
        longest_m: 0.1,
        rolloff_m: 0.1,
        shortest_m: 0.02,
        size: Size::RmsHeightM(5e-5),
    })
    .unwrap();
    let surfaces = Surfaces::Random(RandomSurfaces {
        band: spectrum,
        synthesis: Synthesis::square(256, 1.0, 7, Phases::FixedModulus),
        realisations: 2,
    });
    let (radius_m, half_width_m): (f64, f64) = (40.0, 0.08);
    let cylinder = cylinder(radius_m, half_width_m);
    let pressing = IndenterPressing { tolerance: 1e-6, ..PRESSING };
    let states = cylinder.press_all(&surfaces, &pressing, &Unobserved).unwrap();
    for state in &states {
        assert!(state.effective_radius_m > 1.02 * half_width_m, "{state:?}");
        assert!(state.real_area < 1.9 * half_width_m, "{state:?}");
        assert_relative_eq!(
            state.roughness_number,
            5e-5 * radius_m / half_width_m.powi(2),
            max_relative = 0.05
        );
    }
    assert_eq!(indenter_table(IndenterShape::Cylinder, &states).rows(), 2);
}

#[test]
fn a_cylinder_that_meets_its_image_is_refused_before_and_after() {
    let flat = smooth(8, 64, 1.0);
    let before = cylinder(1000.0, 29.0).press(&flat, &PRESSING, &Unobserved).unwrap_err();
    assert!(
        matches!(before, IndenterError::BeyondMap { half_side_m, .. } if half_side_m == 32.0),
        "{before:?}"
    );
    let mut bumpy = flat.clone();
    bumpy.heights_m[64 + 62] = 5.0;
    let after = cylinder(1000.0, 6.0).press(&bumpy, &PRESSING, &Unobserved).unwrap_err();
    assert!(matches!(after, IndenterError::BeyondMap { reach_m, .. } if reach_m > 28.8), "{after:?}");
    let wrong =
        Indenter { radius_m: -1.0, ..cylinder(1.0, 1.0) }.press(&flat, &PRESSING, &Unobserved).unwrap_err();
    assert!(matches!(wrong, IndenterError::OutOfBounds { .. }), "{wrong:?}");
}

#[test]
fn contacts_that_reach_the_edges_are_refused_before_and_after() {
    struct Unstarted;
    impl Progress for Unstarted {
        fn advance(&self, _: usize) {}
        fn is_cancelled(&self) -> bool {
            true
        }
    }
    let flat = smooth(32, 64, 1.0);
    let before = ball(100.0, 14.5).press(&flat, &PRESSING, &Unstarted).unwrap_err();
    let IndenterError::BeyondMap { half_side_m, least_side_m, .. } = before else { panic!("{before:?}") };
    assert_relative_eq!(half_side_m, 16.0);
    assert!(least_side_m > 32.0);
    // A high point near the edge carries load beyond the contact that Hertz expects.
    let mut bumpy = flat.clone();
    bumpy.heights_m[64 + 32] = 5.0;
    let after = ball(100.0, 4.0).press(&bumpy, &PRESSING, &Unobserved).unwrap_err();
    assert!(matches!(after, IndenterError::BeyondMap { reach_m, .. } if reach_m > 14.4), "{after:?}");
    let ended = ball(100.0, 4.0).press(&flat, &PRESSING, &Unstarted).unwrap_err();
    assert_eq!(ended, IndenterError::HalfSpace(HalfSpaceError::Cancelled));
    let ball = ball(1.0, 1.0);
    for wrong in [Indenter { radius_m: 0.0, ..ball }, Indenter { force: f64::NAN, ..ball }] {
        let refused = wrong.press(&flat, &PRESSING, &Unobserved).unwrap_err();
        assert!(matches!(refused, IndenterError::OutOfBounds { .. }), "{refused:?}");
    }
}

#[test]
fn surfaces_of_a_spectrum_give_a_row_each_and_scatter() {
    let band = AreaSpectrum::self_affine(&SelfAffine {
        hurst_exponent: 0.8,
        longest_m: 1.0 / 8.0,
        rolloff_m: 1.0 / 8.0,
        shortest_m: 1.0 / 16.0,
        size: Size::RmsGradient(0.05),
    })
    .unwrap();
    let synthesis = Synthesis::square(64, 1.0, 1, Phases::FixedModulus);
    let surfaces = Surfaces::Random(RandomSurfaces { band, synthesis, realisations: 3 });
    let states = ball(20.0, 0.25).press_all(&surfaces, &PRESSING, &Unobserved).unwrap();
    assert_eq!(states.len(), 3);
    assert!(states[0].effective_radius_m != states[1].effective_radius_m);
    let table = indenter_table(IndenterShape::Ball, &states);
    let names: Vec<&str> = table.columns().map(|(name, _)| name).collect();
    assert_eq!(names[..3], ["realisation", "force_n", "real_area_m2"]);
}

#[test]
fn coarse_grids_narrow_maps_and_large_contacts_are_doubted() {
    let state = pressed(ball(4.0, 0.25), &smooth(64, 64, 1.0 / 64.0));
    assert_eq!(state.remarks(), []);
    let state = pressed(ball(2.0, 0.3), &smooth(16, 16, 1.0 / 16.0));
    let codes: Vec<RemarkCode> = state.remarks().iter().map(|remark| remark.code).collect();
    assert_eq!(codes, [RemarkCode::BallCoarseGrid, RemarkCode::BallNarrowMap, RemarkCode::BallLargeContact]);
}
