//! Exponential heights, number of contacts and plasticity index.

use asperity::{ElasticBody, MaterialPair};
use proptest::prelude::*;
use stat_contact::{AsperityLaw, Condition, Population, StatisticalContact, SummitHeights};

/// A polishing pad: E* 1 GPa, R 5 um, eta 2e8 per m^2, sigma 0.3 um.
fn pad() -> (MaterialPair, Population) {
    (
        MaterialPair::against_rigid(ElasticBody::new(1e9, 0.0).unwrap()),
        Population::new(5e-6, 2e8, 0.3e-6).unwrap(),
    )
}

#[test]
fn exponential_summits_have_one_real_pressure_and_the_formulas_of_the_paper() {
    let (pair, population) = pad();
    let contact = StatisticalContact::from_exponential(&pair, &population);
    for pressure_pa in [1e-300, 7e3, 20.7e3, 96e3] {
        let state = contact.at_pressure(pressure_pa, 1e-12, None).unwrap();
        let real_pa = (state.ln_pressure_pa - state.ln_area_fraction).exp();
        assert!((real_pa / 138.197_659_788_534_2e6 - 1.0).abs() < 1e-12, "{real_pa:e}");
        // p = sqrt(pi) eta E* sqrt(R) sigma^(3/2) exp(-d/sigma).
        let amplitude_pa = std::f64::consts::PI.sqrt() * 2e8 * 1e9 * 5e-6f64.sqrt() * 0.3e-6f64.powf(1.5);
        let separation_m = 0.3e-6 * (amplitude_pa / pressure_pa).ln();
        assert!((state.separation_m.unwrap() / separation_m - 1.0).abs() < 1e-12);
        assert!((state.stiffness_pa_per_m().unwrap() / (pressure_pa / 0.3e-6) - 1.0).abs() < 1e-12);
        let contacts = population.contacts_per_m2(separation_m, SummitHeights::Exponential);
        assert!((contacts / (2e8 * pressure_pa / amplitude_pa) - 1.0).abs() < 1e-9);
    }
    for (hardness_pa, index) in [(7e9, 0.035), (0.2e9, 1.22)] {
        assert!((population.plasticity_index(1e9, hardness_pa) - index).abs() < 0.006 * index.max(0.1));
    }
}

#[test]
fn gaussian_contacts_are_the_heights_above_the_flat() {
    let (_, population) = pad();
    let at = |over_sigma: f64| population.contacts_per_m2(over_sigma * 0.3e-6, SummitHeights::Gaussian);
    assert!((at(0.0) - 1e8).abs() < 1e-6 && (at(-9.0) / 2e8 - 1.0).abs() < 1e-12);
    assert!((at(2.0) / (2e8 * 0.022_750_131_948_179_21) - 1.0).abs() < 1e-13);
    assert_eq!(population.contacts_per_m2(-1e-6, SummitHeights::Exponential), 2e8);
}

/// Spheres one by one: Int_0^inf F(z - d) exp(-z/sigma)/sigma dz, z = sigma t^2 so that the integrand is smooth at its start.
fn summed(contact_of_one: impl Fn(f64) -> f64, separation_m: f64) -> f64 {
    let (start, count) = (separation_m.max(0.0) / 0.3e-6, 40_000);
    let step = 7.0 / f64::from(count);
    let term = |at: i32| {
        let t = (f64::from(at) + 0.5) * step;
        let z = start + t * t;
        contact_of_one(z * 0.3e-6 - separation_m) * (-z).exp() * 2.0 * t
    };
    (0..count).map(term).sum::<f64>() * step
}

proptest! {
    #[test]
    fn any_flat_carries_the_sum_of_its_spheres(over_sigma in -30.0..20.0f64) {
        let (pair, population) = pad();
        let contact = StatisticalContact::from_exponential(&pair, &population);
        let separation_m = over_sigma * 0.3e-6;
        let state = contact.at_separation(separation_m, 1e-12).unwrap();
        let pressure_pa = 2e8 * summed(|w| 4.0 / 3.0 * 1e9 * 5e-6f64.sqrt() * w.powf(1.5), separation_m);
        let area = 2e8 * summed(|w| std::f64::consts::PI * 5e-6 * w, separation_m);
        prop_assert!((state.pressure_pa / pressure_pa - 1.0).abs() < 1e-5);
        prop_assert!((state.area_fraction / area - 1.0).abs() < 1e-5);
        let again = contact.at_pressure(state.pressure_pa, 1e-12, None).unwrap();
        prop_assert!((again.separation_m.unwrap() - separation_m).abs() < 1e-12 * 0.3e-6 * (1.0 + over_sigma.abs()));
        let [less, more] = [-1e-5, 1e-5].map(|step| {
            contact.at_separation(separation_m + step * 0.3e-6, 1e-12).unwrap().pressure_pa
        });
        let difference = (less - more) / (2e-5 * 0.3e-6);
        // The stiffness has a kink at z = 0, where the last spheres begin to touch.
        prop_assert!(over_sigma.abs() < 1e-4 || (state.stiffness_pa_per_m().unwrap() / difference - 1.0).abs() < 1e-6);
    }
}

#[test]
fn tables_and_sweeps_have_the_same_states_and_gaussian_spheres_stay_what_they_are() {
    let (pair, population) = pad();
    let exponential = StatisticalContact::from_exponential(&pair, &population);
    let table = exponential.table([Condition::Pressure(1e2), Condition::Pressure(1e6)], 1e-9).unwrap();
    let single = exponential.at_pressure(2e4, 1e-9, None).unwrap();
    assert_eq!(table.at_pressure(2e4).unwrap().separation_m, single.separation_m);
    assert_eq!(exponential.highest_pressure_pa(), f64::INFINITY);
    let gaussian = StatisticalContact::new(&pair, &population, &AsperityLaw::Hertz);
    assert!(
        (gaussian.at_pressure(20.7e3, 1e-12, None).unwrap().area_fraction / 2.0017e-4 - 1.0).abs() < 1e-4
    );
}
