//! Interfaces of scenes against the crates that compute them.

use std::collections::BTreeMap;

use scene::{Overrides, Scene};
use study::interface::InterfaceStates;
use study::interface::{Quantity, Slot};
use study::plan::Results;

/// A roll-off at 30 um, and waves down to 0.3 um.
fn psd() -> String {
    let row = |at: i32| {
        let wavelength_m = 10f64.powf(-4.0 - 0.05 * f64::from(at));
        let c1d_m3 = 1e-18 * (wavelength_m / 3e-5).min(1.0).powf(2.6);
        format!("{wavelength_m:e},{c1d_m3:e}\n")
    };
    std::iter::once("wavelength_m,C1D_m3\n".to_owned()).chain((0..=50).map(row)).collect()
}

const TEXT: &str = r#"
surface = { psd = "psd.csv" }
loads = { force = "1 kN", nominal_area = "10 cm^2" }
[material]
youngs_modulus = "100 GPa"
poisson_ratio = 0.3
indentation_hardness = "2 GPa"
thermal_conductivity = "20 W/(m K)"
resistivity = "1e-7 ohm m"
[counterface]
thermal_conductivity = "20 W/(m K)"
resistivity = "3e-7 ohm m"
[[curve]]
model = "persson"
"#;

fn parsed(text: &str) -> Result<Scene, String> {
    let files = BTreeMap::from([("psd.csv".to_owned(), psd().into_bytes())]);
    Scene::parse(text, &files, &Overrides::default()).map_err(|error| error.to_string())
}

fn carried_out(text: &str) -> (Scene, Results) {
    let scene = parsed(text).unwrap();
    let results = scene.plan().compute().unwrap();
    (scene, results)
}

fn under_the_load(states: &InterfaceStates<'_>, quantity: Quantity) -> Option<f64> {
    states.value(Slot { quantity, load: Some(0), curve: None }).unwrap()
}

#[test]
fn gas_in_the_gaps_conducts_beside_the_spots() {
    let air = "gas_conductivity = \"0.026 W/(m K)\"";
    let section = |keys: &str| format!("{TEXT}[interface]\n{keys}\n");
    let (scene, results) = carried_out(&section(&format!("{air}\ngas_parameter = \"0.4 um\"")));
    let states = scene.interface_states(&results).unwrap();
    let value = |quantity| under_the_load(&states, quantity).unwrap();
    let of_gas = value(Quantity::GasConductance);
    let simple = 0.026 / (value(Quantity::MeanGap) + 0.4e-6);
    assert!((1.0..1.3).contains(&(of_gas / simple)), "{of_gas} {simple}");
    let both = value(Quantity::ThermalConductance) + of_gas;
    assert_eq!(value(Quantity::ThermalConductanceWithGas), both);
    // M = alpha beta Lambda with alpha = 2 (2 - 0.86)/0.86 and beta = 2 1.4/(0.71 2.4), at twice 1 atm.
    let parameter_m = 2.0 * 1.14 / 0.86 * (2.8 / (0.71 * 2.4)) * 64e-9 / 2.0;
    let (scene, _) = carried_out(&section("gas = \"air\"\ngas_pressure = \"202650 Pa\""));
    let found = scene.interface.unwrap().gas.unwrap();
    assert!((found.parameter_m() / parameter_m - 1.0).abs() < 1e-12, "{found:?}");
    for wrong in ["gas_parameter = \"1 um\"", air, "gas_pressure = \"1 kPa\"", "gas = \"steam\""] {
        assert!(parsed(&section(wrong)).is_err(), "{wrong}");
    }
    assert!(parsed(&section(&format!("{air}\ngas_parameter = \"1 um\"\ngas = \"air\""))).is_err());
}

#[test]
fn heat_and_current_follow_the_stiffness() {
    let (scene, results) = carried_out(TEXT);
    let yields = scene.interface_states(&results).unwrap();
    let states = yields.with_hardness(None);
    let value = |quantity| under_the_load(&states, quantity).unwrap();
    let stiffness = value(Quantity::Stiffness);
    let found = states.separation_under(1e6);
    assert_eq!((stiffness, value(Quantity::MeanGap)), (found.stiffness_pa_per_m, found.mean_gap_m));
    assert!(under_the_load(&yields, Quantity::Stiffness).unwrap() > stiffness);
    // Barber (2003): h = k_s K/E*, G = 2 K/(E* (rho1 + rho2)), over an area of 1e-3 m^2.
    let relative_per_m = stiffness / (100e9 / 0.91);
    for (quantity, expected) in [
        (Quantity::ThermalConductance, 20.0 * relative_per_m),
        (Quantity::ThermalResistance, 1.0 / (20.0 * relative_per_m * 1e-3)),
        (Quantity::ElectricalConductance, 2.0 * relative_per_m / 4e-7),
        (Quantity::ElectricalResistance, 4e-7 / (2.0 * relative_per_m * 1e-3)),
    ] {
        assert!((value(quantity) / expected - 1.0).abs() < 1e-12, "{quantity:?}");
    }
    let (moments, _) = results.moments.last().unwrap();
    let slope_per_m = (2.0 / std::f64::consts::PI).sqrt() * moments.rms_slope() / moments.rms_height_m();
    let yovanovich = 1.25 * 20.0 * slope_per_m * (1e6f64 / 2e9).powf(0.95);
    let found = under_the_load(&yields, Quantity::YovanovichConductance).unwrap();
    assert!((found / yovanovich - 1.0).abs() < 1e-12);
}

#[test]
fn a_seal_has_a_channel_until_it_is_tight() {
    let (scene, results) = carried_out(&format!(
        "{TEXT}[seal]\npressure_drop = \"1 bar\"\nviscosity = \"1 mPa s\"\nbreadth = \"10 cm\"\nlength = \"1 mm\"\n"
    ));
    let states = scene.interface_states(&results).unwrap();
    let tight = Slot { quantity: Quantity::TightPressure, load: None, curve: None };
    let tight_pa = states.value(tight).unwrap().unwrap();
    assert!(tight_pa > 1e6, "{tight_pa}");
    // The slot that leaks as much, with the range of a joint of many waves, and below the narrowest place of the last channel.
    let slot_m = under_the_load(&states, Quantity::LeakGap).unwrap();
    assert!(slot_m < under_the_load(&states, Quantity::ChannelHeight).unwrap());
    let rate = 100.0 * slot_m.powi(3) * 1e5 / (12.0 * 1e-3);
    let [low, high] = [Quantity::LeakRateLow, Quantity::LeakRateHigh]
        .map(|end| under_the_load(&states, end).unwrap() / rate);
    assert!((0.7..0.9).contains(&low) && (1.2..1.5).contains(&high), "{low} {high}");

    let pressed = TEXT.replace("force = \"1 kN\", nominal_area = \"10 cm^2\"", "pressures = [\"50 GPa\"]");
    let (scene, results) = carried_out(&format!("{pressed}[seal]\n"));
    let states = scene.interface_states(&results).unwrap();
    assert!(states.value(tight).unwrap().unwrap() < 50e9);
    for quantity in [Quantity::ChannelWavelength, Quantity::LeakGap] {
        assert_eq!(under_the_load(&states, quantity), None);
    }
}

#[test]
fn friction_is_strength_times_area_and_adhesion_needs_its_keys() {
    let (scene, results) = carried_out(&format!(
        "{TEXT}[interface]\nshear_strength = \"1 GPa\"\nwork_of_adhesion = \"50 mJ/m^2\"\n"
    ));
    let states = scene.interface_states(&results).unwrap();
    let (_, area_fraction) = *results.curves[0].area_fractions(0).last().unwrap();
    let friction = states
        .value(Slot { quantity: Quantity::FrictionStress, load: Some(0), curve: Some(0) })
        .unwrap()
        .unwrap();
    assert!((friction / (1e9 * area_fraction) - 1.0).abs() < 1e-14);
    let quantities: Vec<Quantity> = states.slots().iter().map(|slot| slot.quantity).collect();
    assert!(quantities.contains(&Quantity::FullerTabor) && !quantities.contains(&Quantity::PastewkaRobbins));
}

const SHEARED: &str = "[interface]\nfriction = 0.3\nshare_of_sliding = 0.6\n";

#[test]
fn a_tangential_load_follows_the_normal_law_until_everything_slides() {
    let (scene, results) = carried_out(&format!("{TEXT}{SHEARED}"));
    let states = scene.interface_states(&results).unwrap();
    let value = |quantity| under_the_load(&states, quantity).unwrap();
    // Against a rigid counterface eta = (2 - nu)/(2 (1 - nu)).
    let eta = 1.7 / 1.4;
    let stiffness = states.separation_under(1e6).stiffness_pa_per_m;
    assert!((value(Quantity::TangentialStiffness) * eta / stiffness - 1.0).abs() < 1e-12);
    // d = f eta (u(p*) - u(p)) with the separations u under the load and the smaller load that sticks.
    let slack_m = states.separation_under(0.4e6).mean_gap_m - states.separation_under(1e6).mean_gap_m;
    assert!((value(Quantity::TangentialDisplacement) / (0.3 * eta * slack_m) - 1.0).abs() < 1e-3);
    let damping = value(Quantity::TangentialDissipation)
        / (2.0 * std::f64::consts::PI * 0.18e6 * value(Quantity::TangentialDisplacement));
    assert!((value(Quantity::DampingRatio) / damping - 1.0).abs() < 1e-12);
    let stuck = value(Quantity::StuckAreaFraction);
    assert!(stuck > 0.0 && stuck < results.curves[0].area_fractions(0).last().unwrap().1);
    let of_loop = states.shear_loop(0, "1 MPa", 20).unwrap();
    assert_eq!(of_loop.dissipation_j_per_m2, value(Quantity::TangentialDissipation));
    assert!((of_loop.cycle.first_loading[20].0 / value(Quantity::TangentialDisplacement) - 1.0).abs() < 1e-9);
    // The same load as a stress.
    let as_stress = SHEARED.replace("share_of_sliding = 0.6", "tangential_stress = \"0.18 MPa\"");
    let (scene, results) = carried_out(&format!("{TEXT}{as_stress}"));
    let same = scene.interface_states(&results).unwrap();
    let displacement_m = under_the_load(&same, Quantity::TangentialDisplacement).unwrap();
    assert!((displacement_m / value(Quantity::TangentialDisplacement) - 1.0).abs() < 1e-9);
    let beyond = SHEARED.replace("share_of_sliding = 0.6", "tangential_stress = \"0.4 MPa\"");
    let (scene, results) = carried_out(&format!("{TEXT}{beyond}"));
    let sliding = scene.interface_states(&results).unwrap();
    assert_eq!(sliding.sliding_loads(), [0]);
    assert!(under_the_load(&sliding, Quantity::TangentialStiffness).is_some());
    assert_eq!(under_the_load(&sliding, Quantity::TangentialDissipation), None);
    assert!(sliding.shear_loop(0, "1 MPa", 20).is_none());
}

#[test]
fn what_was_not_asked_for_is_not_there() {
    let plain = TEXT.replace(
        "thermal_conductivity = \"20 W/(m K)\"\nresistivity = \"3e-7 ohm m\"\n",
        "youngs_modulus = \"100 GPa\"\npoisson_ratio = 0.3\n",
    );
    let (scene, results) = carried_out(&plain);
    assert!(scene.interface.is_none() && scene.interface_states(&results).is_none());
    let (scene, results) = carried_out(&format!("{plain}[interface]\n"));
    let slots = scene.interface_states(&results).unwrap().slots();
    let quantities: Vec<Quantity> = slots.iter().map(|slot| slot.quantity).collect();
    assert_eq!(quantities, [Quantity::MeanGap, Quantity::Stiffness, Quantity::YovanovichGap]);
}

#[test]
fn wrong_keys_are_refused_with_the_mend() {
    for (more, expected) in [
        ("[interface]\ngamma = 2.0\n", "interface.gamma"),
        ("[interface]\nfriction = 0.3\n", "interface.friction"),
        ("[interface]\nfriction = -0.3\nshare_of_sliding = 0.5\n", "interface.friction"),
        ("[interface]\nfriction = 0.3\nshare_of_sliding = 1.5\n", "interface.share_of_sliding"),
        ("[interface]\ntangential_stress = \"1 MPa\"\n", "friction"),
        ("[interface]\nfriction = 0.3\nshare_of_sliding = 0.5\ntangential_stress = \"1 MPa\"\n", "leave one"),
        ("[interface]\nrange_of_attraction = \"1 nm\"\n", "work_of_adhesion"),
        ("[interface]\nshear_strength = \"-1 GPa\"\n", "interface.shear_strength"),
        ("[seal]\npressure_drop = \"1 bar\"\nviscosity = \"1 mPa s\"\nlength = \"1 mm\"\n", "all four"),
        ("[seal]\npercolation_threshold = 1.5\n", "seal.percolation_threshold"),
        ("[seal]\nviscosity = \"1 Pa\"\n", "viscosity"),
        ("[seal]\nviscosity = \"1 Pa s\"\ngas = \"air\"\n", "seal.gas"),
        ("[seal]\noutlet_pressure = \"1 bar\"\n", "seal.outlet_pressure"),
        ("[seal]\nviscosity = \"1 Pa s\"\ngas_temperature = \"20 C\"\n", "seal.gas_temperature"),
        ("[seal]\ngas = \"air\"\ngas_temperature = \"20 K\"\n", "seal.gas_temperature"),
        ("[seal]\nleak_unit = \"ml/min\"\n", "seal.leak_unit"),
        (
            "[seal]\npressure_drop = \"1 bar\"\nviscosity = \"1 mPa s\"\nbreadth = \"1 m\"\nlength = \"1 mm\"\nleak_unit = \"g/year\"\n",
            "seal.leak_unit",
        ),
    ] {
        let message = parsed(&format!("{TEXT}{more}")).unwrap_err();
        assert!(message.contains(expected), "{more}: {message}");
    }
    let negative = TEXT.replace("resistivity = \"1e-7 ohm m\"", "resistivity = \"-1e-7 ohm m\"");
    assert!(parsed(&negative).unwrap_err().contains("material.resistivity"));
}
