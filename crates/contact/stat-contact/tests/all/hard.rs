//! States that once were wrong, against twenty digits by mpmath (`tests/reference/statistical.py` of the repository).

use crate::support::rows;
use asperity::{ElasticBody, Hardness, MaterialPair, NixGao};
use stat_contact::{AsperityLaw, Population, StatisticalContact};

/// Model, E, nu, S0, h*, R, eta, sigma_s, d, pressure and area fraction, in SI units.
///
/// In turn: separations at the far end of a quadrature's cell; forces over many decades of the interference, with
/// features at h* or at w_c far below sigma_s; a panel of very little load; and a short stretch of plastic flow between two
/// of elasticity.
const HARD: &str = "\
hertz,1e+11,0.3,1e+08,,2.53303e-07,2e+12,1e-07,9.48e-07,2.6055104465340891089e-13,2.0894591625460305995e-23
hertz,1e+11,0.3,1e+08,,2.53303e-07,2e+12,1e-07,1.057e-06,3.5968141001673384985e-18,3.0374589294496047189e-28
ep-sphere,1e+11,0,1.30462e+07,,3.31201e-07,2e+12,4.89197e-07,2.73587e-06,0.10803337085329846949,5.7968149775901220139e-9
ep-sphere,1e+11,0,2.30775e+07,,3.47459e-07,2e+12,1.49356e-07,2.34706e-07,818585.26182788362105,0.029493432135748830096
ep-sphere,1e+11,0,4.12031e+06,8.226e-10,6.7274e-07,2e+12,1.15176e-07,2.03851e-09,3415231.7010247555314,1.0
ep-sphere,1e+11,0.49,5.12435e+06,5.74786e-10,3.31307e-07,2e+12,1.68078e-06,1.05995e-05,0.001648424336060066263,9.1138215983606516445e-11
ep-sine,1e+11,0.49,8.95315e+08,,7.01332e-06,2e+12,1.03303e-09,8.82445e-09,4.967176520127508755e-12,1.9801320212851679644e-20
ep-sine,1e+11,0,6.19823e+06,3.53972e-08,1.28472e-07,2e+12,1.65736e-08,1.2885e-07,1.1717986468632293597e-8,1.1820353034216639118e-16
ep-sine,1e+11,0.2,7.05064e+06,1.60864e-09,3.20454e-07,2e+12,5.67191e-09,2.19346e-08,175.37491948848930695,2.9793800127809766347e-6";

/// States in which hardly an asperity is short of complete contact.
const NEARLY_COMPLETE: &str = "\
elastic-sine,33111800000.0,0.0,25205000.0,,1.19518e-06,77896400000.0,1.63245e-06,-1.30596e-05,15798320175.756941556,0.99999999999999417953
ep-sine,1018110000.0,0.2,5873250.0,,1.17839e-07,2.7018e+16,4.77363e-11,-3.8189e-10,8714186.1519577726688,0.99999999999999431079";

#[test]
fn hard_states_keep_their_digits() {
    for row in rows(HARD) {
        let bar = if row.gradient { 1e-11 } else { 1e-12 };
        let state = row.contact.at_separation(row.separation_m, 1e-12).unwrap();
        let off = [state.pressure_pa / row.pressure_pa - 1.0, state.area_fraction / row.area_fraction - 1.0];
        assert!(off.iter().all(|off| off.abs() < bar), "{}: {off:?}", row.what);
        let back = row.contact.at_pressure(row.pressure_pa, 1e-12, None).unwrap();
        let off = (back.separation_m.unwrap() - row.separation_m) / row.sigma_s_m;
        assert!(off.abs() < 1e-10, "{}: {off:e}", row.what);
        assert!((back.area_fraction / row.area_fraction - 1.0).abs() < 1e-10, "{}", row.what);
    }
}

#[test]
fn near_complete_contact_the_separation_is_found_to_a_few_units_of_the_pressure() {
    const SLOPES: [f64; 2] = [5.37e-14, 5.37e-14];
    for (row, slope) in rows(NEARLY_COMPLETE).zip(SLOPES) {
        let state = row.contact.at_pressure(row.pressure_pa, 1e-12, None).unwrap();
        let u = [row.separation_m, state.separation_m.unwrap()].map(|d| d / row.sigma_s_m);
        // d ln p/du there, from mpmath: four units of the pressure are up to 0.02 sigma_s of the separation.
        assert!((u[1] - u[0]).abs() < 4.0 * f64::EPSILON / slope, "{}: u = {u:?}", row.what);
    }
}

#[test]
fn the_highest_pressure_tells_the_pressures_that_have_a_separation() {
    for row in rows(NEARLY_COMPLETE) {
        let highest_pa = row.contact.highest_pressure_pa();
        let at = row.contact.at_pressure(highest_pa, 1e-12, None).unwrap();
        assert_eq!(at.separation_m, None, "{}", row.what);
        let below = highest_pa * (1.0 - f64::EPSILON);
        assert!(row.contact.at_pressure(below, 1e-12, None).unwrap().separation_m.is_some(), "{}", row.what);
    }
}

/// A load that a search has to find far below the mean plane, from any start.
fn assert_found_from_any_start(
    pair: &MaterialPair,
    population: &Population,
    law: &AsperityLaw,
    pressure_pa: f64,
) {
    let contact = StatisticalContact::new(pair, population, law);
    for u in [0.0, -50.0, 30.0] {
        let start = contact.at_separation(u * population.sigma_s_m(), 1e-4).unwrap();
        let found = contact.at_pressure(pressure_pa, 1e-10, Some(&start)).unwrap();
        let back = contact.at_separation(found.separation_m.unwrap(), 1e-10).unwrap();
        assert!((back.pressure_pa / pressure_pa - 1.0).abs() < 1e-9, "from {u} sigma: {found:?}");
    }
}

#[test]
fn a_start_on_the_plateau_beyond_complete_contact_leads_back_to_the_load() {
    let pair = MaterialPair::against_rigid(ElasticBody::new(57137239.36245765, 0.5).unwrap());
    let strength =
        NixGao::constant(3971003277.1571417).unwrap().with_strain_gradient(1.052320138125748e-11).unwrap();
    let population = Population::new(2.020710825948861e-9, 935013.2786687512, 0.01).unwrap();
    assert_found_from_any_start(&pair, &population, &AsperityLaw::EpSine { strength }, 89088780190.01233);
}

#[test]
fn a_load_inside_the_upward_step_of_the_force_is_found() {
    let pair = MaterialPair::against_rigid(ElasticBody::new(553372164246.9137, -0.433998672525858).unwrap());
    let strength = NixGao::constant(3622739742.092883).unwrap();
    let population = Population::new(6.079833933072042e-5, 9433997128577.81, 4.692731816388255e-12).unwrap();
    let law = AsperityLaw::EpSphere { strength, hardness: Hardness::JacksonGreen2005, held_from: None };
    assert_found_from_any_start(&pair, &population, &law, 45226120943.106514);
}

#[test]
fn a_load_above_a_highest_pressure_far_below_has_no_separation() {
    let pair = MaterialPair::against_rigid(ElasticBody::new(1000.0, -0.8796629611429538).unwrap());
    let strength = NixGao::constant(8963.536859717526).unwrap().with_strain_gradient(1e-6).unwrap();
    let population =
        Population::new(0.0006460497878631737, 1.6591675613594667, 8.169668794634305e-6).unwrap();
    let contact = StatisticalContact::new(&pair, &population, &AsperityLaw::EpSine { strength });
    let state = contact.at_pressure(349591.27867093385, 1e-10, None).unwrap();
    assert_eq!((state.separation_m, state.area_fraction), (None, 1.0));
}
