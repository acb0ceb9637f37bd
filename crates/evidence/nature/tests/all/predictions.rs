//! Predictions by the rules, on made rows.

use interface::gas::NamedGas;
use nature::prediction::{Positions, Unknown, conductances, predict};
use nature::resistance::{GasPressure, MeasuredResistance, solid};

fn row() -> MeasuredResistance {
    MeasuredResistance {
        id: 1,
        solids: [solid("al6061").unwrap(); 2],
        interstitial: None,
        gas: NamedGas::Nitrogen,
        gas_pressure: GasPressure::Known(1.0),
        ra_m: [1e-6, 2e-6],
        pressure_pa: 1e6,
        temperature_k: 293.0,
        measured_w_per_m2_k: f64::INFINITY,
    }
}

#[test]
fn a_prediction_knows_nothing_of_the_measurement() {
    let other = MeasuredResistance { measured_w_per_m2_k: 1.0, id: 9, ..row() };
    assert_eq!(predict(&row()).unwrap(), predict(&other).unwrap());
}

#[test]
fn flat_faces_in_vacuum_follow_yovanovich() {
    // 100 MPa press waves of 1 um on each face flat.
    let row = MeasuredResistance { pressure_pa: 1e8, ..row() };
    let mut at = Positions::only(Unknown::FlatnessLimit, -1.0);
    at = at.and(Unknown::FirstFlatness, -1.0).and(Unknown::SecondFlatness, -1.0);
    let [_, spots] = conductances(&row, 1.0, &at).unwrap();
    let faces_um = [1.0f64, 2.0].map(|ra_um| (std::f64::consts::FRAC_PI_2).sqrt() * ra_um);
    let sigma_um = faces_um[0].hypot(faces_um[1]);
    let slopes = faces_um.map(|sigma_um| (0.076 * sigma_um.sqrt() * 0.152 * sigma_um.powf(0.4)).sqrt());
    let slope = slopes[0].hypot(slopes[1]);
    // Three times 276 MPa, and the square root of twice that.
    let hardness_pa = 3.0 * 276e6 * 2f64.sqrt();
    let expected = 1.25 * 167.0 * (slope / (1e-6 * sigma_um)) * (1e8f64 / hardness_pa).powf(0.95);
    assert!((spots / expected - 1.0).abs() < 1e-9, "{spots} {expected}");
}

#[test]
fn each_unknown_moves_the_conductance_as_it_should() {
    let [central, _] = conductances(&row(), 1.0, &Positions::default()).unwrap();
    let moved = |unknown| {
        [-1.0, 1.0].map(|end| conductances(&row(), 1.0, &Positions::only(unknown, end)).unwrap()[0] / central)
    };
    for (unknown, rises) in [
        (Unknown::Ra, false),
        (Unknown::Conductivity, true),
        (Unknown::Hardness, false),
        (Unknown::Scatter, true),
        (Unknown::Slope, true),
        (Unknown::FirstFlatness, false),
        (Unknown::SecondFlatness, false),
        (Unknown::Repeatability, true),
    ] {
        let [low, high] = moved(unknown);
        assert!(if rises { low < 1.0 && 1.0 < high } else { high < 1.0 && 1.0 < low }, "{unknown:?}");
    }
    // Alike grades of both bodies scale everything in vacuum.
    assert!(
        moved(Unknown::Conductivity).iter().zip([1.0 / 1.1, 1.1]).all(|(a, b)| (a / b - 1.0).abs() < 1e-4)
    );
}

#[test]
fn squares_make_the_range_wider_than_any_unknown_and_narrower_than_corners() {
    let prediction = predict(&row()).unwrap().unwrap();
    let [low, high] = prediction.range;
    let changes: Vec<[f64; 2]> = Unknown::ALL
        .map(|unknown| {
            let both = [-1.0, 1.0].map(|end| {
                (conductances(&row(), 1.0, &Positions::only(unknown, end)).unwrap()[0] / prediction.central)
                    .ln()
            });
            [both[0].min(both[1]).min(0.0), both[0].max(both[1]).max(0.0)]
        })
        .to_vec();
    let down = (low / prediction.central).ln();
    assert!(changes.iter().all(|change| change[0] > down));
    assert!(changes.iter().map(|change| change[0]).sum::<f64>() < down);
    let [stated_low, stated_high] = prediction.stated;
    assert!(low < stated_low && stated_low < prediction.central);
    assert!(prediction.central < stated_high && stated_high < high);
}

#[test]
fn gas_adds_and_a_doubtful_pressure_makes_no_prediction() {
    let near_vacuum = predict(&row()).unwrap().unwrap();
    assert!(near_vacuum.central > near_vacuum.without_gas);
    assert!(near_vacuum.central < 1.01 * near_vacuum.without_gas);
    let filled = MeasuredResistance { gas_pressure: GasPressure::Known(101_325.0), ..row() };
    let filled = predict(&filled).unwrap().unwrap();
    assert!(filled.central > 1.1 * near_vacuum.central && filled.without_gas == near_vacuum.without_gas);
    let doubtful = MeasuredResistance { gas_pressure: GasPressure::Doubtful { stored: 1e8 }, ..row() };
    assert_eq!(predict(&doubtful).unwrap(), None);
}

#[test]
fn polished_hard_faces_stay_elastic() {
    let hard = MeasuredResistance {
        solids: [solid("al2o3").unwrap(); 2],
        ra_m: [0.1e-6; 2],
        gas_pressure: GasPressure::Known(1e-3),
        // Their waves are pressed flat.
        pressure_pa: 1e8,
        ..row()
    };
    let doubled = MeasuredResistance { pressure_pa: 2.0 * hard.pressure_pa, ..hard.clone() };
    let at = Positions::only(Unknown::FlatnessLimit, -1.0);
    let [_, one] = conductances(&hard, 1e-3, &at).unwrap();
    let [_, two] = conductances(&doubled, 1e-3, &at).unwrap();
    assert!((two / one - 2.0).abs() < 1e-9);
}
