//! Resistances of spots with a closed form or a resolved solution, and their symmetries.

use elements::half_space::{Elements, Grid, Loading};
use elements::{Boundary, ImposedLoad, PointState, Pressing, RandomSurfaces, Surfaces, press};
use interface::conductance::Resistivities;
use numerics::parallel::Unobserved;
use spectrum::random_surfaces::{AreaSpectrum, Phases, SelfAffine, Size, Synthesis};
use std::f64::consts::PI;
use std::sync::Mutex;
use transport::spots::{
    ContactResistance, FieldSpots, SpotConduction, Spots, SpotsError, spots_table, with_resistances,
};

/// Bodies with a sum of resistivities of 1 ohm m.
fn bodies() -> SpotConduction {
    SpotConduction::new(Resistivities::new(0.25, 0.75).unwrap())
}

fn drawn(rows: usize, columns: usize, is_contact: impl Fn(f64, f64) -> bool) -> (Grid, Vec<bool>) {
    let grid = Grid::new(rows, columns, columns as f64, rows as f64).unwrap();
    let is_contact = (0..rows * columns)
        .map(|point| is_contact((point % columns) as f64, (point / columns) as f64))
        .collect();
    (grid, is_contact)
}

fn solved((grid, is_contact): &(Grid, Vec<bool>), boundary: Boundary) -> Spots {
    Spots::solve(grid, boundary, is_contact, 1.0, &bodies()).unwrap()
}

/// Resistance at rho_1 + rho_2 = 1 from the stiffness of the elements, with the points of contact held together.
fn resistance_of_elements((grid, is_contact): &(Grid, Vec<bool>)) -> f64 {
    let heights_m: Vec<f64> =
        is_contact.iter().map(|&is_contact| if is_contact { 0.0 } else { -1.0 }).collect();
    let mut elements = Elements::free(*grid, &heights_m).unwrap();
    let loading =
        Loading { contact_modulus_pa: 1.0, nominal_pressure_pa: 1e-6, saturation_pa: None, tolerance: 1e-8 };
    let contact = elements.press(&loading, &Unobserved).unwrap();
    assert_eq!(&contact.touching(), is_contact);
    let stiffness = elements.stiffness_pa_per_m(&contact, 1.0, &Unobserved).unwrap().unwrap();
    1.0 / (2.0 * stiffness * grid.length_x_m() * grid.length_y_m())
}

#[test]
fn a_disc_has_holms_resistance() {
    let disc = drawn(65, 65, |x, y| (x - 32.0).hypot(y - 32.0) < 20.0);
    let found = solved(&disc, Boundary::Free);
    assert_eq!((found.spots.len(), found.discs, found.largest_share()), (1, 1, 1.0));
    let spot = found.spots[0];
    assert!((found.resistance_ohm * 4.0 * spot.radius_m() - 1.0).abs() < 1e-12);
    assert!((spot.radius_m() / 20.0 - 1.0).abs() < 0.03);
    assert!((spot.x_m - 32.0).abs() < 1e-9 && (spot.y_m - 32.0).abs() < 1e-9);
}

#[test]
fn two_discs_have_the_resistance_of_a_resolved_solution() {
    // Over one disc on the same points, so that the staircase of its outline cancels.
    let radius = 6.5;
    for (over_radius, bound) in [(4, 0.004), (10, 0.001), (40, 0.001)] {
        let distance = f64::from(over_radius) * radius;
        let columns = distance as usize + 20;
        let disc = |x: f64, y: f64, middle: f64| (x - middle).hypot(y - 8.0) < radius;
        let both = drawn(17, columns, |x, y| disc(x, y, 8.0) || disc(x, y, 8.0 + distance));
        let one = drawn(17, columns, |x, y| disc(x, y, 8.0));
        let [found, found_one] = [&both, &one].map(|map| solved(map, Boundary::Free).resistance_ohm);
        let resolved = resistance_of_elements(&both) / resistance_of_elements(&one);
        let error = found / found_one / resolved - 1.0;
        assert!(error.abs() < bound, "{over_radius}: {error}");
    }
}

#[test]
fn ellipses_split_into_discs_are_within_five_percent() {
    for aspect in [1.5, 2.0, 3.0, 5.0, 10.0] {
        let (long, short) = (60.0, 60.0 / aspect);
        let ellipse = drawn(129, 129, |x, y| ((x - 64.0) / long).hypot((y - 64.0) / short) < 1.0);
        let found = solved(&ellipse, Boundary::Free);
        // R = rho/(2 pi a) K, with the complete elliptic integral K = pi/(2 agm(1, b/a)).
        let (mut one, mut other) = (1.0, 1.0 / aspect);
        for _ in 0..20 {
            (one, other) = (0.5 * (one + other), f64::sqrt(one * other));
        }
        let exact = 1.0 / (4.0 * long * one);
        let area_ratio = found.spots[0].area_m2 / (PI * long * short);
        let error = found.resistance_ohm * area_ratio.sqrt() / exact - 1.0;
        assert!(error.abs() < 0.05, "{aspect}: {error}");
    }
}

#[test]
fn a_ring_around_a_disc_carries_the_current() {
    let ring = drawn(129, 129, |x, y| {
        let radius = (x - 64.0).hypot(y - 64.0);
        radius < 15.0 || (45.0..60.0).contains(&radius)
    });
    let found = solved(&ring, Boundary::Free);
    let resolved = resistance_of_elements(&ring);
    assert!((found.resistance_ohm / resolved - 1.0).abs() < 0.03, "{} {resolved}", found.resistance_ohm);
    assert_eq!(found.spots.len(), 2);
    // The disc is shielded: the ring carries far more than by its area.
    assert!(found.spots[0].current_share > 0.9 && found.spots[1].current_share > 0.0);
}

#[test]
fn a_periodic_map_does_not_care_for_its_origin_or_its_number_of_cells() {
    let pattern = |x: f64, y: f64| {
        let (x, y) = (x.rem_euclid(40.0), y.rem_euclid(30.0));
        (x - 10.0).hypot(y - 11.0) < 4.0
            || (x - 30.0).hypot(y - 21.0) < 2.5
            || (x - 21.0).hypot(y - 3.0) < 1.5
    };
    let cell = solved(&drawn(30, 40, pattern), Boundary::Periodic);
    let shifted = solved(&drawn(30, 40, |x, y| pattern(x + 9.0, y + 12.0)), Boundary::Periodic);
    let six = solved(&drawn(90, 80, pattern), Boundary::Periodic);
    assert!((shifted.resistance_ohm / cell.resistance_ohm - 1.0).abs() < 1e-12);
    assert!((6.0 * six.resistance_ohm / cell.resistance_ohm - 1.0).abs() < 1e-5);
    assert_eq!((cell.spots.len(), six.spots.len()), (3, 18));
    for (at, spot) in six.spots.iter().enumerate() {
        assert!((6.0 * spot.current_share - cell.spots[at / 6].current_share).abs() < 1e-5);
    }
}

#[test]
fn a_spot_in_a_large_cell_is_alone() {
    let spot = drawn(600, 600, |x, y| (x - 300.0).hypot(y - 300.0) < 3.0);
    let [periodic, free] = [Boundary::Periodic, Boundary::Free].map(|boundary| solved(&spot, boundary));
    // The images and the nominal flow of a square lattice: -3.9002649/(2 pi L).
    let images = -3.900_264_92 / (2.0 * PI * 600.0);
    assert!(((periodic.resistance_ohm - images) / free.resistance_ohm - 1.0).abs() < 1e-8);
}

#[test]
fn films_and_ballistic_electrons_add_their_terms() {
    let disc = drawn(65, 65, |x, y| (x - 32.0).hypot(y - 32.0) < 20.0);
    let of = |conduction: &SpotConduction| {
        Spots::solve(&disc.0, Boundary::Free, &disc.1, 1.0, conduction).unwrap().resistance_ohm
    };
    let area = solved(&disc, Boundary::Free).spots[0].area_m2;
    let film = bodies().with_film(3.0).unwrap();
    assert!(((of(&film) - of(&bodies())) * area / 3.0 - 1.0).abs() < 1e-12);
    // 4 rho l/(3 pi a^2) with rho = 1/2.
    let ballistic = bodies().with_mean_free_path(7.0).unwrap();
    assert!(((of(&ballistic) - of(&bodies())) * area / (4.0 * 0.5 * 7.0 / 3.0) - 1.0).abs() < 1e-12);
    assert!(bodies().with_film(0.0).is_err() && bodies().with_mean_free_path(f64::NAN).is_err());
}

#[test]
fn maps_without_spots_and_lines_are_refused() {
    let refused = |rows, is_contact: bool| {
        let (grid, is_contact) = drawn(rows, 8, |_, _| is_contact);
        Spots::solve(&grid, Boundary::Periodic, &is_contact, 1.0, &bodies()).unwrap_err()
    };
    assert_eq!(refused(8, false), SpotsError::NoContact);
    assert_eq!(refused(1, true), SpotsError::Line);
    // Discs of a contact that is complete would drive current backwards.
    assert_eq!(refused(8, true), SpotsError::Indefinite { spots: 1 });
}

/// A random surface under two loads.
fn random_fields(boundary: Boundary, pressures: &[f64]) -> (Vec<elements::PressedLoad>, Vec<FieldSpots>) {
    let band = AreaSpectrum::self_affine(&SelfAffine {
        hurst_exponent: 0.8,
        longest_m: 0.5,
        rolloff_m: 0.25,
        shortest_m: 1.0 / 16.0,
        size: Size::RmsGradient(1.0),
    })
    .unwrap();
    let synthesis = Synthesis::square(128, 1.0, 3, Phases::FixedModulus);
    let random = Surfaces::Random(RandomSurfaces { band, synthesis, realisations: 2 });
    let reliefs = (0..2).map(|number| {
        let mut relief = random.relief(number).unwrap().into_owned();
        relief.boundary = boundary;
        relief
    });
    let loads = pressures.iter().map(|&pressure| ImposedLoad::ReducedPressure(pressure)).collect();
    let pressing = Pressing { loads, stiffness: true, ..Pressing::elastic(1.0) };
    let fields = Mutex::new(Vec::new());
    let pressed = press::<elements::ElementsError>(
        &Surfaces::Maps(reliefs.collect()),
        &pressing,
        |field| {
            assert!(field.states().any(|state| state != PointState::Open));
            fields.lock().unwrap().push(FieldSpots::new(field, bodies()).unwrap());
            Ok(())
        },
        &Unobserved,
    )
    .unwrap();
    (pressed, fields.into_inner().unwrap())
}

#[test]
fn rough_contacts_have_barbers_resistance_and_beyond_the_range_it_is_the_answer() {
    for boundary in [Boundary::Periodic, Boundary::Free] {
        let (pressed, fields) = random_fields(boundary, &[0.02, 0.05, 0.3]);
        assert_eq!(fields.len(), 6);
        for field in &fields {
            let stiffness = pressed[field.load].states[field.surface].stiffness_pa_per_m;
            let from_stiffness = field.resistance_from_stiffness_ohm(stiffness.unwrap()).unwrap();
            let answer = field.resistance(stiffness).unwrap().unwrap();
            if field.load == 2 {
                assert_eq!(answer, ContactResistance::Stiffness(from_stiffness));
                assert_eq!(field.resistance(None).unwrap(), None);
                continue;
            }
            let spots = field.solved.as_ref().unwrap();
            assert_eq!(answer, ContactResistance::Spots(spots.resistance_ohm));
            assert!((answer.ohm() / from_stiffness - 1.0).abs() < 0.1, "{answer:?} {from_stiffness}");
            let sum: f64 = spots.spots.iter().map(|spot| spot.current_share).sum();
            assert!((sum - 1.0).abs() < 1e-12 && spots.spots.iter().all(|spot| spot.current_share > 0.0));
        }
        let table = spots_table(&fields);
        let count: usize = fields
            .iter()
            .filter_map(|field| field.solved.as_ref().ok())
            .map(|solved| solved.spots.len())
            .sum();
        assert_eq!(table.rows(), count);
        for (per_realisation, rows) in [(true, 6), (false, 3)] {
            let table = match per_realisation {
                true => elements::states_table(&pressed),
                false => elements::means_table(&pressed),
            };
            let table = with_resistances(table, &pressed, per_realisation, &fields).unwrap();
            assert_eq!(table.rows(), rows);
            assert!(table.column("resistance_ohm").is_some());
        }
    }
}
