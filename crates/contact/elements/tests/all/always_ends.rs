//! The solver ends in equilibrium on every surface, within a known amount of work.

use crate::common::{elastic, flowing, heights, press, rough};
use elements::half_space::{Contact, Elements, Ending, Grid, HalfSpaceError, Loading, PROGRESS_STEPS};
use numerics::parallel::{Progress, Unobserved};

/// Asserts that the pressures carry the load within their bounds and that the gaps agree with them.
fn assert_balanced(contact: &Contact, loading: &Loading, rms_m: f64) {
    let Loading { nominal_pressure_pa, saturation_pa, tolerance, .. } = *loading;
    assert_eq!(
        contact.numbers.ending,
        Ending::Converged,
        "{loading:?}: residual {}",
        contact.numbers.residual
    );
    assert!(contact.numbers.residual < tolerance);
    let mean = contact.pressures_pa.iter().sum::<f64>() / contact.pressures_pa.len() as f64;
    assert!((mean / nominal_pressure_pa - 1.0).abs() < 1e-11, "{loading:?}: {mean}");
    let cap = saturation_pa.unwrap_or(f64::INFINITY);
    for (&pressure, &gap) in contact.pressures_pa.iter().zip(&contact.gaps_m) {
        assert!((0.0..=cap * (1.0 + 1e-15)).contains(&pressure));
        assert!(pressure > 0.0 || gap > -10.0 * tolerance * rms_m);
        assert!(pressure < cap * (1.0 - 1e-12) || gap < 10.0 * tolerance * rms_m);
    }
}

fn rms(heights_m: &[f64]) -> f64 {
    let mean = heights_m.iter().sum::<f64>() / heights_m.len() as f64;
    (heights_m.iter().map(|height| (height - mean).powi(2)).sum::<f64>() / heights_m.len() as f64).sqrt()
}

#[test]
fn loads_from_tiny_to_closing_and_hardness_from_just_above_the_load() {
    let rough = rough(96, 2.0, 12, 5);
    let stepped: Vec<f64> = rough.iter().map(|height| (height * 200.0).round() / 200.0).collect();
    let one_spike: Vec<f64> = (0..96 * 96).map(|point| if point == 5000 { 1.0 } else { 0.0 }).collect();
    let board = heights(96, 96, |x, y| (((x * 96.0) as usize + (y * 96.0) as usize) % 2) as f64);
    for map in [&rough, &stepped, &one_spike, &board] {
        let rms_m = rms(map);
        for pressure in [1e-9, 1e-5, 1e-2, 0.3, 3.0, 1e4] {
            for loading in [
                elastic(pressure, 1e-8),
                flowing(pressure, pressure * (1.0 + 1e-6), 1e-6),
                flowing(pressure, pressure * 1.5, 1e-8),
                flowing(pressure, pressure * 30.0, 1e-8),
                flowing(pressure, 1.0f64.max(2.0 * pressure), 1e-8),
            ] {
                assert_balanced(&press(map, &loading), &loading, rms_m);
            }
        }
    }
}

#[test]
fn a_tolerance_below_rounding_is_told() {
    let contact = press(&rough(64, 2.0, 12, 6), &elastic(0.1, 1e-300));
    assert_eq!(contact.numbers.ending, Ending::Rounding);
    assert!(contact.numbers.residual < 1e-12, "{}", contact.numbers.residual);
}

#[test]
fn flat_maps_touch_everywhere() {
    for loading in [elastic(0.1, 1e-10), flowing(0.1, 0.2, 1e-10)] {
        let contact = press(&vec![3.0; 60 * 60], &loading);
        assert_eq!((contact.numbers.area_fraction, contact.numbers.ending), (1.0, Ending::Converged));
        assert!(
            contact.numbers.mean_gap_m < 1e-15 && (contact.numbers.largest_pressure_pa - 0.1).abs() < 1e-15
        );
    }
    let single = Elements::periodic(Grid::new(1, 1, 1.0, 1.0).unwrap(), &[2.0])
        .unwrap()
        .press(&elastic(1.0, 1e-3), &Unobserved);
    assert_eq!(single.unwrap().numbers.area_fraction, 1.0);
}

/// Iterations and operators of the hard cases, exactly: a change that needs more work is seen here.
#[test]
fn work() {
    let map = rough(128, 4.0, 24, 7);
    let grid = Grid::new(128, 128, 1.0, 1.0).unwrap();
    let mut elements = Elements::periodic(grid, &map).unwrap();
    let mut work = Vec::new();
    for pressure in [0.003, 0.01, 0.03, 0.1, 0.5, 0.9] {
        let contact = elements.press(&elastic(pressure, 1e-8), &Unobserved).unwrap();
        work.push(("elastic", pressure, contact.numbers.iterations, contact.numbers.operators));
    }
    for (pressure, saturation) in [(0.03, 0.1), (0.03, 0.5), (0.03, 1.0), (0.1, 1.5), (0.3, 0.5), (0.3, 1.5)]
    {
        let contact = elements.press(&flowing(pressure, saturation, 1e-6), &Unobserved).unwrap();
        work.push(("flowing", pressure, contact.numbers.iterations, contact.numbers.operators));
    }
    let found: Vec<String> = work
        .iter()
        .map(|(kind, pressure, steps, operators)| format!("{kind} {pressure}: {steps} {operators}"))
        .collect();
    assert_eq!(found, WORK);
}

const WORK: [&str; 12] = [
    "elastic 0.003: 14 16",
    "elastic 0.01: 16 18",
    "elastic 0.03: 22 24",
    "elastic 0.1: 21 23",
    "elastic 0.5: 23 25",
    "elastic 0.9: 17 19",
    "flowing 0.03: 11 13",
    "flowing 0.03: 16 18",
    "flowing 0.03: 17 19",
    "flowing 0.1: 16 18",
    "flowing 0.3: 21 23",
    "flowing 0.3: 20 22",
];

#[test]
fn what_cannot_be_pressed_is_refused() {
    let grid = Grid::new(8, 8, 1.0, 1.0).unwrap();
    let mut elements = Elements::periodic(grid, &heights(8, 8, |x, y| x * y)).unwrap();
    let mut refused = |loading: Loading| elements.press(&loading, &Unobserved).unwrap_err();
    for loading in [
        elastic(1.0, 0.0),
        elastic(1.0, f64::NAN),
        elastic(0.0, 1e-6),
        elastic(-1.0, 1e-6),
        Loading { contact_modulus_pa: f64::INFINITY, ..elastic(1.0, 1e-6) },
    ] {
        let HalfSpaceError::OutOfBounds(out) = refused(loading) else { panic!("{loading:?}") };
        let given = [loading.tolerance, loading.nominal_pressure_pa, loading.contact_modulus_pa];
        assert!(given.iter().any(|value| value.to_bits() == out.value.to_bits()), "{out}");
    }
    for saturation_pa in [1.0, 0.5] {
        let carried = HalfSpaceError::CannotBeCarried { nominal_pressure_pa: 1.0, saturation_pa };
        assert_eq!(refused(flowing(1.0, saturation_pa, 1e-6)), carried);
    }
    let gap =
        Elements::periodic(grid, &heights(8, 8, |x, _| if x == 0.0 { f64::NAN } else { x })).err().unwrap();
    assert!(matches!(gap, HalfSpaceError::OutOfBounds(out) if out.value.is_nan()));
    assert_eq!(Elements::free(grid, &[1.0]).err(), Some(HalfSpaceError::Size { given: 1, expected: 64 }));
    assert!(matches!(
        Grid::new(0, 8, 1.0, 1.0),
        Err(HalfSpaceError::Points { along: "y (rows)", points: 0, .. })
    ));
    assert!(matches!(Grid::new(8, 8, 1.0, 0.0), Err(HalfSpaceError::OutOfBounds(out)) if out.value == 0.0));
}

/// Cancels the work after this number of steps.
struct EndsAfter(usize, std::sync::atomic::AtomicUsize);

impl Progress for EndsAfter {
    fn advance(&self, steps: usize) {
        self.1.fetch_add(steps, std::sync::atomic::Ordering::Relaxed);
    }
    fn is_cancelled(&self) -> bool {
        self.1.load(std::sync::atomic::Ordering::Relaxed) >= self.0
    }
}

#[test]
fn work_is_watched_and_ended() {
    let grid = Grid::new(64, 64, 1.0, 1.0).unwrap();
    let mut elements = Elements::periodic(grid, &rough(64, 2.0, 12, 8)).unwrap();
    let whole = EndsAfter(usize::MAX, 0.into());
    elements.press(&elastic(0.1, 1e-8), &whole).unwrap();
    assert_eq!(whole.1.into_inner(), PROGRESS_STEPS);
    let half = EndsAfter(50, 0.into());
    assert_eq!(elements.press(&elastic(0.1, 1e-8), &half).err(), Some(HalfSpaceError::Cancelled));
    assert!((50..PROGRESS_STEPS).contains(&half.1.into_inner()));
}
