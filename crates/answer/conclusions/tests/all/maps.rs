//! Answers of measured maps, and the load that stands for all.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use conclusions::{AskedValue, NextStep, PeakState, Trust, foremost};
use judge::MapVerdict;
use study::interface::{Quantity, Slot};
use units::RemarkCode;

use crate::drawn_scenes::Answered;

const POINTS: usize = 64;

/// A map of ridges along y, with peaks that are worn off.
fn map() -> Vec<u8> {
    let height_m = |x: f64, y: f64| {
        let wave =
            |m: f64, n: f64| 40e-9 * m.hypot(n).powf(-1.5) * (TAU * (m * x + n * y) + 7.0 * m * m + n).cos();
        let waves = (1..=9).flat_map(|m| (-2..=2).map(move |n| (f64::from(m), f64::from(n))));
        waves.map(|(m, n)| wave(m, n)).sum::<f64>().min(25e-9)
    };
    let row = |y: usize| {
        let at = |point: usize| point as f64 / POINTS as f64;
        (0..POINTS).map(|x| format!("{:e} ", height_m(at(x), at(y)))).collect::<String>() + "\n"
    };
    (0..POINTS).map(row).collect::<String>().into_bytes()
}

fn answered(rest: &str) -> Answered {
    answered_with("[counterface]\n", rest)
}

/// Answers a map between bodies; `bodies` goes on with the rough one and begins the counterface.
fn answered_with(bodies: &str, rest: &str) -> Answered {
    let files = BTreeMap::from([("map.txt".to_owned(), map())]);
    let text = format!(
        "[surface]\nscans = [{{ file = \"map.txt\", unit = \"m\", size = \"6.4 um\" }}]\n[material]\nyoungs_modulus = \"70 GPa\"\npoisson_ratio = \
         0.3\nresistivity = \"2e-8 ohm m\"\n{bodies}resistivity = \"2e-8 ohm m\"\n[[curve]]\nmodel = \"persson\"\n[judge]\n{rest}"
    );
    Answered::with_files(&text, &files)
}

#[test]
fn gap_stiffness_and_current_of_a_map_are_its_own() {
    let answered = answered("[interface]\n[loads]\npressures = [\"100 MPa\"]\n");
    let conclusions = answered.conclusions();
    let [load] = &conclusions.loads[..] else { panic!() };
    let maps = load.area.maps.unwrap();
    assert_eq!(load.area.factor_of_spectrum_end, 1.0);
    let asked = |quantity: Quantity| -> AskedValue {
        *load.asked.iter().find(|asked| asked.quantity == quantity).unwrap()
    };
    let theory = |quantity: Quantity| {
        let states = answered.scene.interface_states(&answered.results).unwrap();
        states.value(Slot { quantity, load: Some(0), curve: None }).unwrap().unwrap()
    };
    for (quantity, expected) in [
        (Quantity::MeanGap, maps.mean_gap_m.unwrap()),
        (Quantity::Stiffness, maps.stiffness_pa_per_m.unwrap()),
        (
            Quantity::ElectricalConductance,
            theory(Quantity::ElectricalConductance) * maps.stiffness_pa_per_m.unwrap()
                / theory(Quantity::Stiffness),
        ),
    ] {
        let found = asked(quantity);
        assert!((found.value.unwrap() / expected - 1.0).abs() < 1e-9, "{found:?} {expected}");
        assert!(found.low < expected && expected < found.high && found.high < 1.2 * found.low, "{found:?}");
        assert!((theory(quantity) / expected).ln().abs() > 0.1, "{quantity:?}: the theory knows it as well");
    }
}

#[test]
fn the_gap_of_a_map_that_flows_is_its_own() {
    let yields = "indentation_hardness = \"300 MPa\"\n[counterface]\n";
    let answered = answered_with(yields, "[interface]\n[loads]\npressures = [\"100 MPa\"]\n");
    let [load] = &answered.conclusions().loads[..] else { panic!() };
    let gap = load.asked.iter().find(|asked| asked.quantity == Quantity::MeanGap).unwrap();
    let of_map_m = load.area.maps.unwrap().mean_gap_m.unwrap();
    assert!((gap.value.unwrap() / of_map_m - 1.0).abs() < 1e-9, "{gap:?} {of_map_m}");
    assert!(gap.high < 1.2 * gap.low, "{gap:?}");
}

#[test]
fn gas_and_spots_of_a_map_have_the_gap_and_the_stiffness_of_that_map_each() {
    let [elastic, yields] = ["", "indentation_hardness = \"300 MPa\"\n"];
    for bodies in [elastic, yields] {
        let bodies = format!(
            "{bodies}thermal_conductivity = \"50 W/(m K)\"\n[counterface]\nthermal_conductivity = \"50 W/(m K)\"\n"
        );
        let answered =
            answered_with(&bodies, "[interface]\ngas = \"helium\"\n[loads]\npressures = [\"100 MPa\"]\n");
        let conclusions = answered.conclusions();
        let [load] = &conclusions.loads[..] else { panic!() };
        let maps = load.area.maps.unwrap();
        let states = answered.scene.interface_states(&answered.results).unwrap();
        let theory = |quantity: Quantity| {
            states.value(Slot { quantity, load: Some(0), curve: None }).unwrap().unwrap()
        };
        let stiffer = maps.stiffness_pa_per_m.unwrap() / theory(Quantity::Stiffness);
        let of_gas = states.gas_over(maps.mean_gap_m.unwrap()).unwrap();
        let expected = stiffer * theory(Quantity::ThermalConductance) + of_gas;
        let all = Quantity::ThermalConductanceWithGas;
        let found = load.asked.iter().find(|asked| asked.quantity == all).unwrap();
        assert!((found.value.unwrap() / expected - 1.0).abs() < 1e-9, "{found:?} {expected}");
        assert!(found.low > of_gas / 1.1, "no less than the gas alone: {found:?} {of_gas}");
    }
}

#[test]
fn the_shear_of_a_map_follows_the_stiffness_of_that_map() {
    let answered = answered(
        "[interface]\nfriction = 0.3\ntangential_stress = \"3 MPa\"\n[loads]\npressures = [\"100 MPa\"]\n",
    );
    let conclusions = answered.conclusions();
    let ([load], [shear]) = (&conclusions.loads[..], &conclusions.shear[..]) else { panic!() };
    let states = answered.scene.interface_states(&answered.results).unwrap();
    let theory =
        |quantity: Quantity| states.value(Slot { quantity, load: Some(0), curve: None }).unwrap().unwrap();
    let stiffer = load.area.maps.unwrap().stiffness_pa_per_m.unwrap() / theory(Quantity::Stiffness);
    assert!(stiffer.ln().abs() > 0.1, "the theory knows it as well");
    for (found, quantity, factor) in [
        (shear.stiffness_pa_per_m, Quantity::TangentialStiffness, stiffer),
        (shear.displacement_m, Quantity::TangentialDisplacement, 1.0 / stiffer),
        (shear.dissipation_j_per_m2, Quantity::TangentialDissipation, 1.0 / stiffer),
    ] {
        assert!((found.unwrap() / (factor * theory(quantity)) - 1.0).abs() < 1e-12, "{quantity:?}");
    }
}

#[test]
fn the_peaks_of_a_map_are_in_the_state_of_its_elements() {
    let yields = "indentation_hardness = \"300 MPa\"\n[counterface]\n";
    let mut answered = answered_with(yields, "[interface]\n[loads]\npressures = [\"100 MPa\"]\n");
    let theory_m = {
        let states = answered.scene.interface_states(&answered.results).unwrap();
        assert!(states.plastic_share(0).unwrap() > 0.9);
        let slot = Slot { quantity: Quantity::MeanGap, load: Some(0), curve: None };
        states.value(slot).unwrap().unwrap()
    };
    let mut gap = |plastic_share: Option<f64>| -> AskedValue {
        let headline = &mut answered.judgement.as_mut().unwrap().headlines[0];
        headline.maps.as_mut().unwrap().plastic_share = plastic_share;
        let [load] = &answered.conclusions().loads[..] else { panic!() };
        *load.asked.iter().find(|asked| asked.quantity == Quantity::MeanGap).unwrap()
    };
    for (share, state) in [(0.029, PeakState::Elastic), (0.5, PeakState::Partly), (0.91, PeakState::Flowed)] {
        assert_eq!(gap(Some(share)).state, Some(state));
    }
    // An elastic map says nothing of peaks that have flowed.
    let of_spectrum = gap(None);
    assert_eq!(of_spectrum.state, Some(PeakState::Flowed));
    assert!((of_spectrum.value.unwrap() / theory_m - 1.0).abs() < 1e-9, "{of_spectrum:?} {theory_m}");
}

#[test]
fn the_range_of_a_map_leaves_out_what_other_places_would_change() {
    let draws = "[loads]\npressures = [\"100 MPa\"]\n[uncertainty]\ndraws = 400\nshares_draws = 512\n";
    let mut answered = answered(draws);
    let [load] = &answered.conclusions().loads[..] else { panic!() };
    let of_inputs = load.area.of_inputs.unwrap();
    let uncertainty = answered.uncertainty.as_ref().unwrap();
    let interval = uncertainty.interval(0, 0).unwrap();
    let whole = (interval.high / interval.low).ln();
    assert!(of_inputs.share_of_scans > 0.3, "{of_inputs:?}");
    let left = (1.0 - of_inputs.share_of_scans).sqrt() * whole;
    assert!((of_inputs.factor.ln() / left - 1.0).abs() < 1e-9, "{of_inputs:?} {whole}");
    assert!(!answered.conclusions().next.iter().any(|step| matches!(step, NextStep::MoreScans { .. })));
    // Of Gaussian surfaces other places are a part.
    answered.judgement.as_mut().unwrap().headlines[0].maps = None;
    let [load] = &answered.conclusions().loads[..] else { panic!() };
    let of_inputs = load.area.of_inputs.unwrap();
    assert_eq!(of_inputs.share_of_scans, 0.0);
    assert!((of_inputs.factor.ln() / whole - 1.0).abs() < 1e-12, "{of_inputs:?} {whole}");
}

#[test]
fn maps_that_touch_otherwise_lower_trust_and_tell_why_and_which_way() {
    let mut answered = answered("[loads]\npressures = [\"100 MPa\"]\n");
    let judgement = answered.judgement.as_mut().unwrap();
    let twins = judgement.references[0].elements.unwrap();
    let map = |ratio: f64, gradient_over_spectrum: f64| MapVerdict {
        map: format!("{ratio}"),
        load: 0,
        pressure_over_gradient: 0.1,
        gradient_over_spectrum,
        area_fraction: ratio * twins.area_fraction,
        twins,
    };
    let mut found = |maps: Vec<MapVerdict>| {
        answered.judgement.as_mut().unwrap().maps = maps;
        let conclusions = answered.conclusions();
        let codes = [RemarkCode::NotGaussianMap, RemarkCode::SlopesByDirection];
        let caution = conclusions.cautions.iter().find(|caution| codes.contains(&caution.code)).cloned();
        assert!(caution.is_none() || conclusions.trust <= Trust::Fair);
        caution.map(|caution| (caution.code, (100.0 * caution.number("ratio").unwrap()).round()))
    };
    assert_eq!(found(vec![map(1.05, 2.0), map(0.97, 1.0)]), None);
    // The map that differs most counts.
    let both = found(vec![map(2.0, 1.0), map(0.4, 2.0)]);
    assert_eq!(both, Some((RemarkCode::SlopesByDirection, 40.0)));
    assert_eq!(found(vec![map(3.0, 1.1), map(0.4, 2.0)]), Some((RemarkCode::NotGaussianMap, 300.0)));
}

#[test]
fn the_load_that_stands_for_all_was_judged() {
    let loads = "pressures = [\"10 MPa\", \"20 MPa\", \"30 MPa\"]\n";
    let of = |rest: &str| answered(&format!("{rest}[loads]\n{loads}")).conclusions();
    let judged = of("");
    assert_eq!(foremost(&judged.loads).map(|load| load.load), Some(1));
    let mut partly = of("");
    let unjudged = of("off = true\n");
    assert_eq!(foremost(&unjudged.loads).map(|load| load.load), Some(1));
    partly.loads[0] = unjudged.loads[0].clone();
    partly.loads[1] = unjudged.loads[1].clone();
    assert_eq!(foremost(&partly.loads).map(|load| load.load), Some(2));
    assert!(foremost(&[]).is_none());
}
