//! Answers to what a scene asks besides the area: values with the errors of theory, map and inputs, in the unit of the question.

use conclusions::{AnswerUnderLoad, AskedValue, PeakState};
use interface::sealed_fluid::LeakUnit;
use judge::Reference;
use study::interface::{Quantity, Slot};

use crate::drawn_scenes::Answered;

const CONDUCTORS: &str = "material = { youngs_modulus = \"70 GPa\", poisson_ratio = 0.33, HARDNESS thermal_conductivity = \"150 W/(m K)\", resistivity = \
                          \"3e-8 ohm m\" }\n[counterface]\nthermal_conductivity = \"20 W/(m K)\"\nresistivity = \"7e-7 ohm m\"\n";

fn scene(hardness: &str, loads: &str, rest: &str) -> Answered {
    let bodies = CONDUCTORS.replace("HARDNESS", hardness);
    Answered::new(&format!(
        "surface = {{ psd = \"plain.csv\" }}\n{bodies}[loads]\n{loads}\n[judge]\noff = true\n[[curve]]\nmodel = \"persson\"\n{rest}"
    ))
}

fn asked(load: &AnswerUnderLoad, quantity: Quantity) -> AskedValue {
    *load.asked.iter().find(|asked| asked.quantity == quantity).unwrap_or_else(|| panic!("{:?}", load.asked))
}

/// The value of the theory.
fn value(answered: &Answered, load: usize, quantity: Quantity) -> f64 {
    let states = answered.scene.interface_states(&answered.results).unwrap();
    states.value(Slot { quantity, load: Some(load), curve: None }).unwrap().unwrap()
}

fn is_near(found: f64, expected: f64) -> bool {
    (found / expected - 1.0).abs() < 1e-9
}

#[test]
fn values_of_known_inputs_have_the_error_of_their_theory() {
    let answered = scene("", "pressures = [\"100 kPa\", \"20 GPa\"]", "[interface]\n");
    let conclusions = answered.conclusions();
    for load in &conclusions.loads {
        for (quantity, within) in [
            (Quantity::MeanGap, 1.15),
            (Quantity::Stiffness, 1.25),
            (Quantity::ThermalConductance, 1.25),
            (Quantity::ElectricalConductance, 1.25),
        ] {
            let found = asked(load, quantity);
            let of_theory = value(&answered, load.load, quantity);
            assert_eq!(found.value, Some(of_theory));
            assert!(
                is_near(found.high, within * of_theory) && is_near(found.low, of_theory / within),
                "{found:?}"
            );
            assert_eq!(found.state.is_none(), quantity == Quantity::Stiffness);
        }
    }
}

#[test]
fn intervals_of_inputs_add_to_the_error_of_the_theory_as_squares_of_logarithms_and_hold_that_of_light_loads()
{
    let bodies = "material = { youngs_modulus = \"70 GPa +- 20 %\", poisson_ratio = 0.33 }";
    let answered = Answered::new(&format!(
        "surface = {{ psd = \"errors.csv\" }}\n{bodies}\n[loads]\npressures = [\"100 kPa\", \"20 GPa\"]\n[judge]\noff = true\n[[curve]]\nmodel = \
         \"persson\"\n[interface]\n[uncertainty]\ndraws = 100\n"
    ));
    let states = answered.scene.interface_states(&answered.results).unwrap();
    assert!(states.light_contact_factor(0) > 1.0 && states.light_contact_factor(1) == 1.0);
    for load in &answered.conclusions().loads {
        for (quantity, within) in
            [(Quantity::MeanGap, 1.15_f64), (Quantity::Stiffness, [1.0, 1.25][load.load])]
        {
            let slot = Slot { quantity, load: Some(load.load), curve: None };
            let inputs = answered.uncertainty.as_ref().unwrap().quantity(slot).unwrap();
            let found = asked(load, quantity);
            let best = found.value.unwrap();
            let whole = |of_inputs: f64| (of_inputs.ln().powi(2) + within.ln().powi(2)).sqrt().exp();
            let high = best * whole((inputs.high / best).max(1.0));
            let low = best / whole((best / inputs.low).max(1.0));
            assert!(is_near(found.high, high) && is_near(found.low, low), "{found:?} {inputs:?}");
        }
    }
}

#[test]
fn peaks_that_flow_have_their_own_gap_and_conductance_with_the_error_of_the_theory() {
    let mut partly = 0;
    for hardness in [
        "",
        "indentation_hardness = \"100 GPa\",",
        "indentation_hardness = \"3 GPa\",",
        "indentation_hardness = \"1 GPa\",",
        "indentation_hardness = \"100 MPa\",",
    ] {
        let answered = scene(hardness, "pressures = [\"20 MPa\"]", "[interface]\ngas = \"air\"\n");
        let share =
            answered.scene.interface_states(&answered.results).unwrap().plastic_share(0).unwrap_or(0.0);
        let expected = match share {
            _ if share <= 0.03 => PeakState::Elastic,
            _ if share <= 0.9 => PeakState::Partly,
            _ => PeakState::Flowed,
        };
        partly += usize::from(expected == PeakState::Partly);
        let found = asked(&answered.conclusions().loads[0], Quantity::ThermalConductanceWithGas);
        let theory = value(&answered, 0, Quantity::ThermalConductanceWithGas);
        assert_eq!((found.state, found.value), (Some(expected), Some(theory)), "{share}");
        assert!(is_near(found.low, theory / 1.25) && is_near(found.high, theory * 1.25), "{found:?}");
        // Flow conducts better, and closes the gap.
        let bodies = answered.scene.interface_states(&answered.results).unwrap();
        let elastic = bodies.with_hardness(None);
        let of = |states: &study::interface::InterfaceStates<'_>, quantity| {
            states.value(Slot { quantity, load: Some(0), curve: None }).unwrap().unwrap()
        };
        let heat = |states: &_| of(states, Quantity::ThermalConductance);
        let gap = |states: &_| of(states, Quantity::MeanGap);
        if expected != PeakState::Elastic {
            assert!(heat(&bodies) > heat(&elastic) && gap(&bodies) <= gap(&elastic), "{hardness}");
        }
    }
    assert!(partly > 0);
}

#[test]
fn a_nominal_area_gives_resistances_in_place_of_conductances() {
    let answered = scene("", "force = \"20 N\"\nnominal_area = \"4 mm^2\"", "");
    let load = &answered.conclusions().loads[0];
    for (resistance, conductance) in [
        (Quantity::ThermalResistance, Quantity::ThermalConductance),
        (Quantity::ElectricalResistance, Quantity::ElectricalConductance),
    ] {
        let found = asked(load, resistance);
        let of_theory = 1.0 / (4e-6 * value(&answered, 0, conductance));
        assert!(is_near(found.value.unwrap(), of_theory), "{found:?} {of_theory}");
        assert!(is_near(found.low, of_theory / 1.25) && is_near(found.high, of_theory * 1.25), "{found:?}");
    }
}

#[test]
fn gas_conducts_between_bodies_whose_conductivity_nobody_gave() {
    let answered = Answered::new(
        "surface = { psd = \"plain.csv\" }\nmaterial = { youngs_modulus = \"70 GPa\", poisson_ratio = 0.33 }\n[loads]\nforce = \"20 \
         N\"\nnominal_area = \"4 mm^2\"\n[judge]\noff = true\n[[curve]]\nmodel = \"persson\"\n[interface]\ngas = \"air\"\n",
    );
    let found = asked(&answered.conclusions().loads[0], Quantity::GasConductance);
    assert_eq!(found.value, Some(value(&answered, 0, Quantity::GasConductance)));
}

#[test]
fn friction_is_that_of_both_ends_of_the_area() {
    let text = "surface = { psd = \"plain.csv\" }\nmaterial = { youngs_modulus = \"70 GPa\", poisson_ratio = 0.33 }\n[loads]\npressures = [\"20 \
                MPa\"]\n[judge]\ngrid = 32\nrealisations = 2\n[[curve]]\nmodel = \"persson\"\n[interface]\nshear_strength = \"50 MPa\"\n";
    let load = Answered::new(text).conclusions().loads[0].clone();
    let found = asked(&load, Quantity::FrictionCoefficient);
    let coefficient = |area_fraction: f64| 50e6 * area_fraction / 20e6;
    assert!(is_near(found.value.unwrap(), coefficient(load.area.area_fraction.unwrap())), "{found:?}");
    assert!(
        is_near(found.low, coefficient(load.area.low)) && is_near(found.high, coefficient(load.area.high))
    );
}

#[test]
fn a_leak_of_gas_is_in_its_unit_and_a_narrow_seal_is_named() {
    let joint = |length: &str| {
        format!(
            "[seal]\npressure_drop = \"100 kPa\"\ngas = \"helium\"\nleak_unit = \"mbar l/s\"\nbreadth = \"100 mm\"\nlength = \"{length}\"\n"
        )
    };
    let answered = |length: &str| scene("", "pressures = [\"1 MPa\"]", &joint(length)).conclusions();
    let wide = answered("90 mm");
    let seal = wide.loads[0].seal.unwrap();
    let ([low, high], leak) = (seal.leak_rate_m3_per_s.unwrap(), seal.leak_rate.unwrap());
    // 1 atm at the outlet is 1013.25 mbar, and 1 m^3 1000 l.
    assert!(is_near(leak.low, 1_013_250.0 * low) && is_near(leak.high, 1_013_250.0 * high), "{leak:?}");
    assert_eq!((leak.unit, wide.seal.unwrap().few_waves), (LeakUnit::MillibarLitrePerSecond, None));
    let narrow = answered("0.1 mm");
    let few = narrow.seal.unwrap().few_waves.unwrap();
    assert!(few < 4.0, "{few}");
    // 900 times as short a way, and a lower low end than that.
    let through = narrow.loads[0].seal.unwrap().leak_rate.unwrap();
    assert!(through.low < 0.9999 * 900.0 * leak.low, "{through:?} {leak:?}");
}

#[test]
fn leaks_and_shear_are_those_of_the_interface() {
    let joint = "[seal]\npressure_drop = \"100 kPa\"\nviscosity = \"1 mPa s\"\nbreadth = \"100 mm\"\nlength = \"2 mm\"\n";
    let shear = "[interface]\ntangential_stress = \"1 MPa\"\nfriction = 0.2\n";
    let answered = scene("", "pressures = [\"1 MPa\", \"20 MPa\"]", &format!("{shear}{joint}"));
    let conclusions = answered.conclusions();
    let seal = conclusions.loads[0].seal.unwrap();
    let rates = [Quantity::LeakRateLow, Quantity::LeakRateHigh].map(|rate| value(&answered, 0, rate));
    assert_eq!((seal.leak_rate_m3_per_s, seal.open_share), (Some(rates), None));
    let in_unit = seal.leak_rate.unwrap();
    assert_eq!(([in_unit.low, in_unit.high], in_unit.unit), (rates, LeakUnit::CubicMetrePerSecond));
    // Friction times pressure is below the stress under the lighter load.
    let [slides, sticks] = conclusions.shear[..] else { panic!() };
    assert_eq!((slides.load, slides.displacement_m, slides.damping_ratio), (0, None, None));
    assert!(
        is_near(slides.share_of_sliding, 1e6 / (0.2 * 1e6))
            && is_near(sticks.share_of_sliding, 1e6 / (0.2 * 20e6))
    );
    for (found, quantity) in [
        (sticks.stiffness_pa_per_m, Quantity::TangentialStiffness),
        (sticks.displacement_m, Quantity::TangentialDisplacement),
        (sticks.stuck_area_fraction, Quantity::StuckAreaFraction),
        (sticks.dissipation_j_per_m2, Quantity::TangentialDissipation),
        (sticks.damping_ratio, Quantity::DampingRatio),
    ] {
        assert_eq!(found, Some(value(&answered, 1, quantity)), "{quantity:?}");
    }
}

#[test]
fn elements_that_do_not_flow_leave_open_how_much_does() {
    let mut answered =
        scene("indentation_hardness = \"100 MPa\",", "pressures = [\"20 MPa\"]", "[interface]\n");
    let scene = Answered::new(&answered.text.replace("off = true", "grid = 32\nrealisations = 2"));
    answered.judgement = scene.judgement;
    let states = answered.scene.interface_states(&answered.results).unwrap();
    let value = |states: &study::interface::InterfaceStates<'_>| {
        states.value(Slot { quantity: Quantity::MeanGap, load: Some(0), curve: None }).unwrap().unwrap()
    };
    let [flowed_m, elastic_m] = [value(&states), value(&states.with_hardness(None))];
    assert!(flowed_m < elastic_m);
    drop(states);
    for (reference, state, high_m) in [
        (Reference::Elastic, PeakState::Partly, 1.15 * flowed_m),
        (Reference::Growing, PeakState::Unknown, 1.15 * elastic_m),
        (Reference::Yielding { hardness_pa: 1e8 }, PeakState::Flowed, 1.15 * flowed_m),
    ] {
        headline_basis(&mut answered, reference);
        let found = asked(&answered.conclusions().loads[0], Quantity::MeanGap);
        assert_eq!(found.state, Some(state), "{reference:?}");
        assert!(is_near(found.high, high_m) && is_near(found.low, flowed_m / 1.15), "{found:?}");
    }
}

fn headline_basis(answered: &mut Answered, reference: Reference) {
    answered.judgement.as_mut().unwrap().headlines[0].basis = judge::Basis::Elements(reference);
}
