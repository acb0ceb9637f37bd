//! Conductances of an interface against closed forms.

use interface::conductance::{
    Conductivities, CutSurface, PlasticCorrelation, PressureRatio, RelativeStiffness, Resistivities, Spot,
};

const MODULUS_PA: f64 = 115e9;

fn off(found: f64, expected: f64) -> f64 {
    (found / expected - 1.0).abs()
}

#[test]
fn one_hertz_contact_conducts_as_a_circular_spot() {
    let resistivities = Resistivities::new(1.7e-8, 6.9e-8).unwrap();
    let conductivities = Conductivities::new(400.0, 16.0).unwrap();
    for (radius_m, indentation_m) in [(1e-3f64, 1e-6f64), (1e-6, 1e-9), (0.2, 3e-7)] {
        // F = (4/3) E* sqrt(R) delta^(3/2), whose slope is 2 E* a with a = sqrt(R delta): by differences of high order.
        let force_n = |delta_m: f64| 4.0 / 3.0 * MODULUS_PA * radius_m.sqrt() * delta_m * delta_m.sqrt();
        let contact_radius_m = (radius_m * indentation_m).sqrt();
        let step_m = 0.01 * indentation_m;
        let difference = |k: f64| {
            (force_n(indentation_m + k * step_m) - force_n(indentation_m - k * step_m)) / (2.0 * k * step_m)
        };
        let stiffness_n_per_m = (15.0 * difference(1.0) - 6.0 * difference(2.0) + difference(3.0)) / 10.0;
        let spot = Spot::new(0.5 * stiffness_n_per_m / MODULUS_PA).unwrap();
        assert!(off(stiffness_n_per_m, 2.0 * MODULUS_PA * contact_radius_m) < 1e-10);
        assert!(off(spot.radius_m(), contact_radius_m) < 1e-10);
        // Holm: R = (rho1 + rho2)/(4 a).
        let holm_ohm = 8.6e-8 / (4.0 * contact_radius_m);
        assert!(off(spot.electrical_resistance_ohm(&resistivities), holm_ohm) < 1e-10);
        assert!(off(spot.electrical_conductance_s(&resistivities), 1.0 / holm_ohm) < 1e-10);
        // Heat: half of each resistance on either side, 1/(4 k1 a) + 1/(4 k2 a).
        let k_per_w = (1.0 / 400.0 + 1.0 / 16.0) / (4.0 * contact_radius_m);
        assert!(off(spot.thermal_resistance_k_per_w(&conductivities), k_per_w) < 1e-10);
        // The values per nominal area agree with those of the spot.
        let area_m2 = 3e-4;
        let relative = RelativeStiffness::new(stiffness_n_per_m / area_m2, MODULUS_PA).unwrap();
        let s_per_m2 = relative.electrical_conductance_s_per_m2(&resistivities);
        assert!(off(s_per_m2 * area_m2 * holm_ohm, 1.0) < 1e-10);
        let w_per_m2_k = relative.thermal_conductance_w_per_m2_k(&conductivities);
        assert!(off(w_per_m2_k * area_m2 * k_per_w, 1.0) < 1e-10);
        assert!(off(relative.equivalent_spot(area_m2).unwrap().radius_m(), contact_radius_m) < 1e-10);
    }
}

#[test]
fn heat_and_current_obey_one_law() {
    // A conductivity for heat is the reciprocal of a resistivity.
    let (k1, k2) = (7.0, 0.3);
    let conductivities = Conductivities::new(k1, k2).unwrap();
    let resistivities = Resistivities::new(1.0 / k1, 1.0 / k2).unwrap();
    let stiffness = RelativeStiffness::new(3e13, MODULUS_PA).unwrap();
    assert!(
        off(
            stiffness.thermal_conductance_w_per_m2_k(&conductivities),
            stiffness.electrical_conductance_s_per_m2(&resistivities)
        ) < 1e-14
    );
}

#[test]
fn a_light_load_conducts_in_proportion() {
    let light =
        |pressure_pa: f64| RelativeStiffness::from_light_load(pressure_pa, MODULUS_PA, 0.4e-6).unwrap();
    assert!(
        off(light(1e6).per_m(), RelativeStiffness::new(1e6 / 0.4e-6, MODULUS_PA).unwrap().per_m()) < 1e-15
    );
    assert!(off(light(2e6).per_m(), 2.0 * light(1e6).per_m()) < 1e-15);
    assert!(RelativeStiffness::from_light_load(1e6, MODULUS_PA, 0.0).is_err());
    assert!(light(1e6).equivalent_spot(-1.0).is_err());
    assert!(RelativeStiffness::new(f64::INFINITY, MODULUS_PA).is_err());
}

#[test]
fn the_correlations_have_the_values_worked_out_by_hand() {
    let conductivities = Conductivities::new(20.0, 20.0).unwrap();
    let surface = CutSurface::new(1e-6, 0.1).unwrap();
    let load = PressureRatio::new(1e6, 3e9).unwrap();
    let of =
        |correlation: PlasticCorrelation| correlation.conductance_w_per_m2_k(&conductivities, &surface, load);
    assert!(off(of(PlasticCorrelation::Yovanovich), 1243.583115) < 5e-10);
    assert!(off(of(PlasticCorrelation::CooperMikicYovanovich), 1090.01773) < 5e-10);
    // Gaussian heights: m = sqrt(2/pi) of the rms slope.
    let rms = CutSurface::from_rms_slope(1e-6, 0.1 * std::f64::consts::FRAC_PI_2.sqrt()).unwrap();
    assert!(off(rms.mean_absolute_slope(), surface.mean_absolute_slope()) < 1e-15);
}
