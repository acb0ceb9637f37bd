//! The stiffness of populations, against differences of pressures that carry four times the digits.

use asperity::{ElasticBody, Hardness, MaterialPair, NixGao};
use stat_contact::{AsperityLaw, InterferenceLaw, NayakSummits, Population, StatisticalContact};

const TOLERANCE: f64 = 1e-12;

/// The columns of the project's tables of statistical states, the stiffness in place of the area fraction.
///
/// p and K are those of `tests/reference/statistical.py`, which shares no code with the crates: the pressure by its second
/// scheme of 44 digits, K = (p(d - h) - p(d + h))/(2 h) with h = 1e-9 sigma_s, whose error is about h^2. The first scheme of
/// 36 digits agrees on K to 1e-20. The integrals run from kink to kink and from jump to jump of the force, so that the
/// difference holds what the jumps contribute.
const STATES: &str = "\
hertz,463e9,0.2,1.8e9,,45.6e-9,26e12,6.66e-9,-2e-9,1252702629.6127199,2.3969201314282884e17
hertz,463e9,0.2,1.8e9,,45.6e-9,26e12,6.66e-9,1.5e-8,6180671.0624909733,2802037705732343.9
ep-sphere,463e9,0.2,1.8e9,,45.6e-9,26e12,6.66e-9,1e-8,6552149.4363569903,2216122458464341.5
ep-sphere,70e9,0.33,0.3e9,,2e-6,4e9,3e-7,-2e-7,8418824.6410666996,24194423004740.325
ep-sphere,200e9,0.3,1e9,5e-6,1e-6,1e10,5e-8,1e-7,203482.08241865807,11298987220936.451
elastic-sine,463e9,0.2,1.8e9,,45.6e-9,26e12,6.66e-9,1.2e-8,14467304.693027879,6121389184041456.5
elastic-sine,463e9,0.2,1.8e9,,45.6e-9,26e12,6.66e-9,-3e-9,1527163786.2197612,3.2849224634040752e17
ep-sine,463e9,0.2,1.8e9,,45.6e-9,26e12,6.66e-9,1.2e-8,4856184.1408052921,1959757206244361.7
ep-sine,200e9,0.3,1e9,,1e-6,1e11,1e-8,-4e-8,91611990.227310008,3396323926119818.0
ep-sine,200e9,0.3,1e9,5e-6,1e-6,1e10,5e-8,5e-8,413703.25425720993,18315826923889.523
";

/// alpha, d/sqrt(m0), p/(E* sqrt(m2)) and -dp/dd in its units over sqrt(m0): the same of the summits of a surface, by the
/// second scheme of `tests/reference/make_summits.py` with 40 digits.
const SUMMITS: [[f64; 4]; 2] = [
    [3.7, 1.7, 0.011_442_859_896_634_72, 0.024_104_857_866_951_65],
    [139.8, 2.0, 0.016_639_623_404_765_97, 0.044_753_897_197_481_7],
];

#[test]
fn the_stiffness_agrees_with_differences_of_many_digits() {
    let mut worst = 0.0f64;
    for row in crate::support::rows(STATES) {
        // The column of the area fraction holds the stiffness.
        let exact_pa_per_m = row.area_fraction;
        let state = row.contact.at_separation(row.separation_m, TOLERANCE).unwrap();
        assert!((state.pressure_pa / row.pressure_pa - 1.0).abs() < 1e-11, "{}: {state:?}", row.what);
        let off = (state.stiffness_pa_per_m().unwrap() / exact_pa_per_m - 1.0).abs();
        assert!(off < 1e-10, "{}: {off:e}", row.what);
        let carried = row.contact.at_pressure(row.pressure_pa, TOLERANCE, None).unwrap();
        let off_there = (carried.stiffness_pa_per_m().unwrap() / exact_pa_per_m - 1.0).abs();
        assert!(off_there < 1e-10, "{}: {off_there:e}", row.what);
        worst = worst.max(off).max(off_there);
    }
    println!("largest relative deviation {worst:e}");
}

#[test]
fn the_stiffness_of_summits_agrees_with_differences_of_many_digits() {
    // E* = 1, m0 = m2 = 1 and m4 = alpha: separations and pressures are those of the table.
    let pair = MaterialPair::against_rigid(ElasticBody::new(1.0, 0.0).unwrap());
    for [alpha, separation_m, pressure_pa, stiffness_pa_per_m] in SUMMITS {
        let summits = NayakSummits::new(1.0, 1.0, alpha).unwrap();
        let contact = StatisticalContact::from_summits(&pair, &summits);
        let state = contact.at_separation(separation_m, TOLERANCE).unwrap();
        assert!((state.pressure_pa / pressure_pa - 1.0).abs() < 1e-12, "alpha = {alpha}: {state:?}");
        let off = (state.stiffness_pa_per_m().unwrap() / stiffness_pa_per_m - 1.0).abs();
        assert!(off < 1e-11, "alpha = {alpha}: {off:e}");
    }
}

/// Every law on asperities that yield, the softest and the hardest of them among those that step and those that fall.
fn laws() -> Vec<AsperityLaw> {
    let strength = NixGao::constant(1e9).unwrap();
    let growing = strength.with_strain_gradient(5e-6).unwrap();
    let mut laws = vec![AsperityLaw::Hertz];
    laws.extend(InterferenceLaw::ALL.iter().map(|&interference| AsperityLaw::ElasticSine { interference }));
    for strength in [strength, growing] {
        laws.extend(Hardness::ALL.iter().map(|&hardness| AsperityLaw::EpSphere {
            strength,
            hardness,
            held_from: None,
        }));
        laws.push(AsperityLaw::EpSine { strength });
    }
    laws
}

#[test]
fn the_stiffness_of_every_law_is_what_pressures_of_neighbours_differ_by() {
    let pair = MaterialPair::against_rigid(ElasticBody::new(200e9, 0.3).unwrap());
    let population = Population::new(1e-6, 1e10, 5e-8).unwrap();
    let step_m = 1e-4 * population.sigma_s_m();
    for law in laws() {
        let contact = StatisticalContact::new(&pair, &population, &law);
        for separation_m in [-1.3e-7, -2e-8, 3e-8, 1.6e-7] {
            let at = |separation_m| contact.at_separation(separation_m, 1e-13).unwrap();
            let [nearer_pa, farther_pa] =
                [-step_m, step_m].map(|step_m| at(separation_m + step_m).pressure_pa);
            let difference_pa_per_m = (nearer_pa - farther_pa) / (2.0 * step_m);
            let off = at(separation_m).stiffness_pa_per_m().unwrap() / difference_pa_per_m - 1.0;
            assert!(off.abs() < 1e-7, "{law:?} at {separation_m}: {off:e}");
        }
    }
}

#[test]
fn complete_contact_and_heights_taken_as_one_have_no_stiffness() {
    let pair = MaterialPair::against_rigid(ElasticBody::new(200e9, 0.3).unwrap());
    let population = Population::new(1e-6, 1e10, 5e-8).unwrap();
    let law = AsperityLaw::ElasticSine { interference: InterferenceLaw::default() };
    let contact = StatisticalContact::new(&pair, &population, &law);
    let complete = contact.at_pressure(2.0 * contact.highest_pressure_pa(), TOLERANCE, None).unwrap();
    assert_eq!((complete.separation_m, complete.stiffness_pa_per_m()), (None, None));
    let far_m = -1.1e6 * population.sigma_s_m();
    assert_eq!(contact.at_separation(far_m, TOLERANCE).unwrap().stiffness_pa_per_m(), None);
}
