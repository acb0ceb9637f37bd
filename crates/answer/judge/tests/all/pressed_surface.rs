//! The pressed surface to look at.

use elements::half_space::{Elements, Grid, Loading};
use judge::PressedSurface;
use numerics::parallel::Unobserved;

use crate::scenes::{ELASTIC, coarse, judged, scene};

/// Modulus of the bodies \[Pa\].
const CONTACT_MODULUS_PA: f64 = 200e9 / (1.0 - 0.3 * 0.3);

/// The points that touch, by elements of a finer tolerance than the judge's.
fn pressed(surface: &PressedSurface, nominal_pressure_pa: f64, saturation_pa: Option<f64>) -> Vec<bool> {
    let rows = surface.heights_m.len() / surface.columns;
    let grid = Grid::new(rows, surface.columns, surface.length_x_m, surface.length_y_m).unwrap();
    let mut elements = Elements::periodic(grid, &surface.heights_m).unwrap();
    let loading = Loading {
        contact_modulus_pa: CONTACT_MODULUS_PA,
        nominal_pressure_pa,
        saturation_pa,
        tolerance: 1e-6,
    };
    elements.press(&loading, &Unobserved).unwrap().touching()
}

/// The share of points that touch in one picture alone.
fn differing(a: &[bool], b: &[bool]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).filter(|(a, b)| a != b).count() as f64 / a.len() as f64
}

#[test]
fn longest_waves_of_a_spectrum_touch_as_elements_say_under_each_load() {
    let scene = scene(3.0, "", "\"50 MPa\", \"400 MPa\"", &ELASTIC);
    let (_, judgement) = judged(&scene, &coarse(64, 2));
    let surface = judgement.surface.as_ref().unwrap();
    let [light, heavy] = &surface.contacts[..] else { panic!() };
    assert_eq!((light.load, heavy.load, &surface.map), (0, 1, &None));
    for (contact, nominal_pressure_pa) in [(light, 50e6), (heavy, 400e6)] {
        let apart = differing(&contact.touching, &pressed(surface, nominal_pressure_pa, None));
        assert!(apart < 0.002, "{apart}");
        // Waves that are left out take contact away.
        let headline = judgement.headline(contact.load).unwrap();
        assert!(contact.area_fraction() > headline.area_fraction.unwrap());
    }
    assert!(heavy.area_fraction() > 3.0 * light.area_fraction());
    let shortest_m = surface.shortest_m.unwrap();
    assert!(shortest_m > 1.01e-9 && shortest_m < 0.1 * surface.length_x_m);
}

#[test]
fn equal_pressures_share_a_contact_and_many_loads_have_a_coarser_picture() {
    let of = |loads: &str| judged(&scene(3.0, "", loads, &ELASTIC[..1]), &coarse(48, 2)).1.surface.unwrap();
    let same = of("\"400 MPa\", \"401 MPa\", \"402 MPa\", \"403 MPa\"");
    assert_eq!((same.columns, same.contacts.len()), (256, 4));
    assert!(same.contacts.iter().all(|contact| contact.touching == same.contacts[0].touching));
    assert!(same.contacts.iter().map(|contact| contact.load).eq(0..4));
    let many = of("\"100 MPa\", \"200 MPa\", \"300 MPa\", \"400 MPa\"");
    assert_eq!((many.columns, many.contacts.len()), (128, 4));
    assert!(many.contacts.windows(2).all(|pair| pair[0].area_fraction() < pair[1].area_fraction()));
}

#[test]
fn a_spectrum_that_the_picture_holds_whole_touches_as_the_best_estimate() {
    let scene = scene(1.0, "", "\"400 MPa\"", &ELASTIC);
    let (_, judgement) = judged(&scene, &coarse(128, 4));
    let surface = judgement.surface.as_ref().unwrap();
    let best = judgement.headline(0).unwrap().area_fraction.unwrap();
    assert_eq!(surface.shortest_m, None);
    assert!((surface.contacts[0].area_fraction() / best - 1.0).abs() < 0.3);
}

#[test]
fn bodies_that_flow_touch_at_their_hardness_and_loads_that_flatten_all_have_no_contact_to_see() {
    let scene = scene(
        3.0,
        "indentation_hardness = \"2 GPa\"",
        "\"300 MPa\", \"1.99 GPa\"",
        &["model = \"persson-plastic\""],
    );
    let (_, judgement) = judged(&scene, &coarse(64, 2));
    let surface = judgement.surface.as_ref().unwrap();
    let [contact] = &surface.contacts[..] else { panic!() };
    let apart = differing(&contact.touching, &pressed(surface, 300e6, Some(2e9)));
    assert!(contact.load == 0 && apart < 0.002, "{apart}");
    let elastic = differing(&contact.touching, &pressed(surface, 300e6, None));
    assert!(elastic > 0.01, "{elastic}");
}
