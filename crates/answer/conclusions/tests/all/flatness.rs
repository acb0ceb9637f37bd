//! Parts that are not flat: values with the range of both limits, the part of the nominal contact that contact spreads over, and seals.

use conclusions::{AskedValue, Conclusions, NextStep, flatness_within};
use interface::flatness::Deviation;
use study::interface::{Quantity, Slot};
use units::RemarkCode;

use crate::cautions::caution;
use crate::drawn_scenes::Answered;

/// Conductors under a load, of a spectrum up to 10 um.
fn scene(hardness: &str, pressure: &str, rest: &str) -> Answered {
    Answered::new(&format!(
        "surface = {{ psd = \"plain.csv\" }}\nmaterial = {{ youngs_modulus = \"70 GPa\", poisson_ratio = 0.33, {hardness} \
         thermal_conductivity = \"150 W/(m K)\", resistivity = \"3e-8 ohm m\" }}\n[counterface]\nthermal_conductivity = \"20 W/(m \
         K)\"\nresistivity = \"7e-7 ohm m\"\n[loads]\npressures = [\"{pressure}\"]\n[judge]\noff = true\n[[curve]]\nmodel = \
         \"persson\"\n{rest}"
    ))
}

fn asked(conclusions: &Conclusions) -> Vec<AskedValue> {
    conclusions.loads[0].asked.clone()
}

fn section(flatness: &str, rest: &str) -> String {
    format!("[interface]\nflatness = \"{flatness}\"\n{rest}")
}

#[test]
fn the_range_spans_both_limits_and_names_flat_faces() {
    for (hardness, gas) in
        [("", ""), ("", "gas = \"air\"\n"), ("indentation_hardness = \"100 MPa\",", "gas = \"air\"\n")]
    {
        let flat = scene(hardness, "1 MPa", &format!("[interface]\n{gas}")).conclusions();
        let bowed = scene(hardness, "1 MPa", &section("4 um over 2 mm", gas));
        let states = bowed.scene.interface_states(&bowed.results).unwrap();
        let bowed = bowed.conclusions();
        assert!(!asked(&bowed).is_empty());
        for found in asked(&bowed) {
            let of_flat = asked(&flat).into_iter().find(|other| other.quantity == found.quantity).unwrap();
            assert_eq!((found.flat, of_flat.flat), (of_flat.value, None));
            let limits = states.with_flatness(found.quantity, 0, of_flat.value.unwrap()).unwrap().unwrap();
            let [low, high] = [limits.by_wave.min(limits.by_cap), limits.by_wave.max(limits.by_cap)];
            let value = found.value.unwrap();
            assert!((value / (low * high).sqrt() - 1.0).abs() < 1e-12);
            let of_theory: f64 = of_flat.high / of_flat.value.unwrap();
            let wider = of_theory.ln().hypot(flatness_within(of_flat.value.unwrap(), limits).ln()).exp();
            assert!((found.high / (wider * high) - 1.0).abs() < 1e-9, "{found:?}");
            // A deviation adds to the gap, and takes from all that passes.
            let is_gap = found.quantity == Quantity::MeanGap;
            assert_eq!(value > of_flat.value.unwrap(), is_gap, "{found:?}");
        }
    }
}

#[test]
fn a_deviation_that_is_small_or_pressed_flat_changes_nothing() {
    for (pressure, flatness) in [("1 MPa", "1e-6 nm over 1 m"), ("5 GPa", "10 nm over 1 m")] {
        let conclusions = scene("", pressure, &section(flatness, "")).conclusions();
        assert!(caution(&conclusions, RemarkCode::SpreadsOverPart).is_none());
        assert!(!asked(&conclusions).is_empty());
        for found in asked(&conclusions) {
            let ratio = found.value.unwrap() / found.flat.unwrap();
            assert!((ratio - 1.0).abs() < 0.01, "{found:?}");
        }
    }
}

#[test]
fn the_part_over_which_contact_spreads_is_that_of_the_cap_and_of_the_wave() {
    let bowed = scene("", "1 MPa", &section("1 um over 20 mm", ""));
    let states = bowed.scene.interface_states(&bowed.results).unwrap();
    let [wave, cap] = states.flatness_limits(0).unwrap();
    let modulus_pa = states.inputs.pair.composite_modulus_pa();
    // (a/b)^3 = p/p_flat by Hertz; the pressure that flattens a wave has the root mean square E* h/2.
    let flattening_pa = 16.0 / (3.0 * std::f64::consts::PI) * modulus_pa * 1e-6 / 20e-3;
    assert!((cap.share / (1e6 / flattening_pa).powf(2.0 / 3.0) - 1.0).abs() < 1e-9);
    // sin^2(pi a/lambda) = p/p_flat with p_flat = pi E* H/(4 L).
    let flat_pa = std::f64::consts::PI * modulus_pa * 1e-6 / 80e-3;
    let by_ridge = 2.0 / std::f64::consts::PI * (1e6 / flat_pa).sqrt().asin();
    assert!((wave.share / by_ridge - 1.0).abs() < 1e-9, "{} {by_ridge}", wave.share);
    let conclusions = bowed.conclusions();
    let found = caution(&conclusions, RemarkCode::SpreadsOverPart).unwrap();
    assert_eq!(found.number("low"), Some(wave.share.min(cap.share)));
    assert_eq!(found.number("high"), Some(wave.share.max(cap.share)));
}

#[test]
fn a_seal_that_is_not_flat_closes_later_and_leaks_more() {
    let seal =
        "[seal]\npressure_drop = \"1 bar\"\nviscosity = \"1 mPa s\"\nbreadth = \"1 m\"\nlength = \"5 mm\"\n";
    let flat = scene("", "100 MPa", seal).conclusions();
    let bowed = scene("", "100 MPa", &format!("{seal}{}", section("10 um over 5 mm", ""))).conclusions();
    let closes = |conclusions: &Conclusions| conclusions.seal.unwrap().closes.unwrap();
    assert!(closes(&bowed).high > closes(&flat).high);
    assert!(closes(&bowed).low <= closes(&bowed).nominal_pressure_pa);
    let rate = |conclusions: &Conclusions| conclusions.loads[0].seal.unwrap().leak_rate_m3_per_s.unwrap();
    assert_eq!(rate(&bowed)[0], rate(&flat)[0]);
    assert!(rate(&bowed)[1] > rate(&flat)[1]);
}

#[test]
fn a_few_numbers_say_nothing_of_longer_waves() {
    let conclusions = |interface: &str| {
        Answered::new(&format!(
            "surface = {{ rms_height = \"0.8 um\", rms_slope = 0.1, mean_width = \"60 um\" }}\nmaterial = {{ youngs_modulus = \"70 GPa\", \
             poisson_ratio = 0.33, thermal_conductivity = \"150 W/(m K)\" }}\n[counterface]\nthermal_conductivity = \"20 W/(m \
             K)\"\n[loads]\npressures = [\"1 MPa\"]\n[judge]\noff = true\n[[curve]]\nmodel = \"persson\"\n{interface}"
        ))
        .conclusions()
    };
    let unknown = conclusions("");
    assert!(caution(&unknown, RemarkCode::TakenAsFlat).is_some());
    assert!(unknown.next.iter().any(|step| matches!(step, NextStep::Flatness { .. })), "{:?}", unknown.next);
    let known = conclusions("[interface]\nflatness = \"1 um over 40 mm\"\n");
    assert!(caution(&known, RemarkCode::TakenAsFlat).is_none());
    assert!(!known.next.iter().any(|step| matches!(step, NextStep::Flatness { .. })));
}

#[test]
fn around_a_cap_more_leaks_than_through_the_channels_and_a_deviation_that_is_pressed_flat_adds_nothing() {
    let seal =
        "[seal]\npressure_drop = \"1 bar\"\nviscosity = \"1 mPa s\"\nbreadth = \"1 m\"\nlength = \"5 mm\"\n";
    let with = |pressure: &str, flatness: &str| {
        let answered = scene("", pressure, &format!("{seal}{}", section(flatness, "")));
        let states = answered.scene.interface_states(&answered.results).unwrap();
        let around = states.leak_around_m3_per_s(0);
        (answered.conclusions().loads[0].seal.unwrap().leak_rate_m3_per_s.unwrap()[1], around)
    };
    let (high, around) = with("10 MPa", "100 um over 5 mm");
    assert!(around.is_some_and(|around| high >= around), "{high} {around:?}");
    // A slit of the mean cube of an open cap, 100^3/4 um^3, is the most.
    assert!(around.unwrap() < 1.0 / 5e-3 * 1e-12 * 1e5 / 12.0 / 1e-3);
    let flat = scene("", "10 MPa", seal).conclusions().loads[0].seal.unwrap().leak_rate_m3_per_s.unwrap();
    let (high, around) = with("10 MPa", "1 nm over 5 mm");
    assert!((high / flat[1] - 1.0).abs() < 1e-6 && around.is_none(), "{high} {around:?}");
}

/// Asserts that two values agree to rounding.
fn assert_same(found: f64, expected: f64) {
    assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
}

#[test]
fn a_cap_adds_in_series_to_the_roughness_under_its_local_pressure_and_has_the_gas_around_it() {
    let answered = scene("", "1 MPa", &section("4 um over 2 mm", "gas = \"air\"\n"));
    let states = answered.scene.interface_states(&answered.results).unwrap();
    let modulus_pa = states.inputs.pair.composite_modulus_pa();
    let cap = states.request.flatness.unwrap().cap(1e6, modulus_pa);
    let under = |local_pa: f64| states.separation_under(local_pa);
    let by_cap = |quantity: Quantity| {
        let flat = states.value(Slot { quantity, load: Some(0), curve: None }).unwrap().unwrap();
        states.with_flatness(quantity, 0, flat).unwrap().unwrap().by_cap
    };
    let stiffness = cap.mean_inside(|local_pa| under(local_pa).stiffness_pa_per_m);
    let expected = 1.0 / (cap.compliance_m_per_pa() + 1.0 / stiffness);
    assert!(cap.share() < 0.9 && expected < 0.9 * under(1e6).stiffness_pa_per_m);
    assert_same(by_cap(Quantity::Stiffness), expected);
    // By Barber's analogy, with k_s = 2 150 20/170 W/(m K) and 2/(3e-8 + 7e-7) S/m.
    let spots = expected / modulus_pa * 6000.0 / 170.0;
    assert_same(by_cap(Quantity::ThermalConductance), spots);
    assert_same(by_cap(Quantity::ElectricalConductance), expected / modulus_pa * 2.0 / 7.3e-7);
    let flat_m = under(1e6).mean_gap_m;
    let gap_m =
        cap.mean_inside(|local_pa| under(local_pa).mean_gap_m) + cap.mean_outside(|gap_m| gap_m + flat_m);
    assert_same(by_cap(Quantity::MeanGap), gap_m);
    let gas = cap.mean_inside(|local_pa| states.gas_over(under(local_pa).mean_gap_m).unwrap())
        + cap.mean_outside(|gap_m| states.gas_over(gap_m + flat_m).unwrap());
    assert_same(by_cap(Quantity::GasConductance), gas);
    assert_same(by_cap(Quantity::ThermalConductanceWithGas), spots + gas);
}

#[test]
fn resistances_are_those_of_the_nominal_area() {
    let answered = Answered::new(
        "surface = { psd = \"plain.csv\" }\nmaterial = { youngs_modulus = \"70 GPa\", poisson_ratio = 0.33, thermal_conductivity = \"150 W/(m K)\", \
         resistivity = \"3e-8 ohm m\" }\n[counterface]\nthermal_conductivity = \"20 W/(m K)\"\nresistivity = \"7e-7 ohm m\"\n[loads]\nforce = \
         \"4 N\"\nnominal_area = \"4 mm^2\"\n[judge]\noff = true\n[[curve]]\nmodel = \"persson\"\n[interface]\nflatness = \"4 um over 2 mm\"\n",
    );
    let states = answered.scene.interface_states(&answered.results).unwrap();
    let limits = |quantity: Quantity| {
        let flat = states.value(Slot { quantity, load: Some(0), curve: None }).unwrap().unwrap();
        (flat, states.with_flatness(quantity, 0, flat).unwrap().unwrap())
    };
    for (resistance, conductance) in [
        (Quantity::ThermalResistance, Quantity::ThermalConductance),
        (Quantity::ElectricalResistance, Quantity::ElectricalConductance),
    ] {
        let ((flat, resists), (_, conducts)) = (limits(resistance), limits(conductance));
        assert!(resists.by_cap > 1.1 * flat && resists.by_wave > 1.1 * flat);
        assert_same(resists.by_cap, 1.0 / (conducts.by_cap * 4e-6));
        assert_same(resists.by_wave, 1.0 / (conducts.by_wave * 4e-6));
    }
}

#[test]
fn the_gap_of_the_roughness_adds_to_that_around_the_contact() {
    let seal =
        "[seal]\npressure_drop = \"1 bar\"\nviscosity = \"1 mPa s\"\nbreadth = \"1 m\"\nlength = \"5 mm\"\n";
    let answered = scene("", "10 MPa", &format!("{seal}{}", section("20 um over 5 mm", "")));
    let states = answered.scene.interface_states(&answered.results).unwrap();
    let (flatness, modulus_pa) =
        (states.request.flatness.unwrap(), states.inputs.pair.composite_modulus_pa());
    let gap_m = states.separation_under(1e7).mean_gap_m;
    let cube = |beyond_m: f64| (beyond_m + gap_m).powi(3);
    let [by_cap, by_ridge] = [
        flatness.cap(1e7, modulus_pa).mean_outside(cube),
        flatness.ridge(1e7, modulus_pa).mean_outside(cube),
    ];
    // (L_y/L_x) <g^3> dp/(12 eta).
    assert_same(states.leak_around_m3_per_s(0).unwrap(), 200.0 * by_cap.max(by_ridge) * 1e5 / 12e-3);
}
