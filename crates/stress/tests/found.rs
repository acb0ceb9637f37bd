//! States that once broke a promise, as `cargo xtask stress` printed them.

use asperity::Hardness::{Cosine, JacksonGreen2005};
use stress::Kind::{ElasticSine, EpSine, EpSphere, GradientSine, Hertz};
use stress::Question::{Pressure, Separation};
use stress::{Draw, Material, Reach, Sample, StatisticalCase, Tally, Trial, try_state};

/// Puts states to every test there is.
fn assert_sound(cases: &[StatisticalCase]) {
    let everything = Sample { quadrature: true, finest: true, conditions: true };
    for case in cases {
        let mut tally = Tally::default();
        let mut trial = Trial::of(&mut tally, case.kind.name(), 0, (case, Reach::Wide));
        try_state(case, Reach::Wide, everything, &mut Draw::of(0, 0), &mut trial);
        assert!(tally.refused.is_empty(), "{case:?}");
        for ((_, promise), record) in &tally.records {
            assert_eq!(record.broken, 0, "{promise}: {:?}", record.worst);
        }
    }
}

/// Slopes of ln p that drown in the error of the quadrature led searches astray.
#[test]
fn far_below_at_a_loose_tolerance() {
    assert_sound(&[
        StatisticalCase {
            kind: Hertz,
            material: Material {
                youngs_modulus_pa: 28.337347231564557,
                poisson_ratio: -0.4706251301622505,
                counterface: None,
                strength_pa: 545.2641054060883,
                strain_gradient_length_m: None,
                strength_cap_pa: Some(571.6769204147898),
            },
            hardness: Cosine,
            radius_m: 2.136707110769364,
            density_per_m2: 13868.701830458376,
            sigma_s_m: 0.1835822378117563,
            tolerance: 2.640937090475099e-7,
            question: Separation(-183582.237811753),
        },
        StatisticalCase {
            kind: Hertz,
            material: Material {
                youngs_modulus_pa: 1416859360.5475278,
                poisson_ratio: -0.8539027776723553,
                counterface: None,
                strength_pa: 577130.580029538,
                strain_gradient_length_m: None,
                strength_cap_pa: None,
            },
            hardness: JacksonGreen2005,
            radius_m: 2.1486163483115338e-11,
            density_per_m2: 2372215091481639.5,
            sigma_s_m: 2.6844399483090226e-14,
            tolerance: 0.00011553188097852843,
            question: Pressure(17033200.047269616),
        },
    ]);
}

/// A plateau that starts with an infinite slope.
#[test]
fn just_before_complete_contact_far_below() {
    assert_sound(&[
        StatisticalCase {
            kind: ElasticSine,
            material: Material {
                youngs_modulus_pa: 12559814904986.008,
                poisson_ratio: -0.7515225882625681,
                counterface: None,
                strength_pa: 15.193850206811064,
                strain_gradient_length_m: None,
                strength_cap_pa: None,
            },
            hardness: Cosine,
            radius_m: 2.7253694053976665e-11,
            density_per_m2: 4634808.205027687,
            sigma_s_m: 3.232021215698081e-14,
            tolerance: 7.282519110814621e-10,
            question: Separation(-401.06347787629613),
        },
        StatisticalCase {
            kind: EpSine,
            material: Material {
                youngs_modulus_pa: 1966.0632867104887,
                poisson_ratio: 0.05376747128323828,
                counterface: None,
                strength_pa: 1.6348463431013236e-7,
                strain_gradient_length_m: None,
                strength_cap_pa: None,
            },
            hardness: JacksonGreen2005,
            radius_m: 0.04121694422876172,
            density_per_m2: 865707646.351722,
            sigma_s_m: 1.0579236740729699e-15,
            tolerance: 1e-10,
            question: Separation(-1.4197870640310234e-9),
        },
    ]);
}

/// Parabolas that do not converge, and loads that no separation carries.
#[test]
fn near_a_maximum_of_the_pressure() {
    assert_sound(&[
        StatisticalCase {
            kind: EpSphere,
            material: Material {
                youngs_modulus_pa: 139322.0404456576,
                poisson_ratio: 0.04638200725323788,
                counterface: None,
                strength_pa: 491584.5928041908,
                strain_gradient_length_m: None,
                strength_cap_pa: None,
            },
            hardness: JacksonGreen2005,
            radius_m: 3.4832296441800944e-10,
            density_per_m2: 58886218180017.06,
            sigma_s_m: 1.1327605837548632e-9,
            tolerance: 1e-10,
            question: Separation(-3.634564921005582e-8),
        },
        StatisticalCase {
            kind: EpSphere,
            material: Material {
                youngs_modulus_pa: 81778336818779.63,
                poisson_ratio: 0.49999999999999994,
                counterface: None,
                strength_pa: 6218036.924110888,
                strain_gradient_length_m: None,
                strength_cap_pa: None,
            },
            hardness: JacksonGreen2005,
            radius_m: 0.0010031876285022164,
            density_per_m2: 8141782.68558826,
            sigma_s_m: 1.5790041876709055e-8,
            tolerance: 0.040576767186779716,
            question: Pressure(11.838430833363292),
        },
        StatisticalCase {
            kind: GradientSine,
            material: Material {
                youngs_modulus_pa: 9925425807.470863,
                poisson_ratio: -0.999999,
                counterface: None,
                strength_pa: 11188129.960159257,
                strain_gradient_length_m: Some(1.1205453872463217e-10),
                strength_cap_pa: None,
            },
            hardness: Cosine,
            radius_m: 2.403494293687091e-9,
            density_per_m2: 61711113284780.59,
            sigma_s_m: 7.519581548623936e-9,
            tolerance: 1e-10,
            question: Separation(-3.3233213822632703e-7),
        },
        StatisticalCase {
            kind: GradientSine,
            material: Material {
                youngs_modulus_pa: 244589536337.43088,
                poisson_ratio: -0.912975821150555,
                counterface: None,
                strength_pa: 654924057.2352675,
                strain_gradient_length_m: Some(4.4874780618634397e-8),
                strength_cap_pa: Some(766788505.865262),
            },
            hardness: JacksonGreen2005,
            radius_m: 1.1681734577907799e-8,
            density_per_m2: 2309991123459978.0,
            sigma_s_m: 3.3773199106688056e-9,
            tolerance: 2.0154348471210893e-13,
            question: Pressure(179466229010.81644),
        },
    ]);
}

/// Its state held NaN.
#[test]
fn a_search_that_ran_past_the_heights_that_have_digits() {
    assert_sound(&[
        StatisticalCase {
            kind: EpSphere,
            material: Material {
                youngs_modulus_pa: 175206875.63602,
                poisson_ratio: -0.999999,
                counterface: None,
                strength_pa: 14944965.911863424,
                strain_gradient_length_m: None,
                strength_cap_pa: None,
            },
            hardness: JacksonGreen2005,
            radius_m: 0.01977433760676362,
            density_per_m2: 15375.2284974351,
            sigma_s_m: 6.306129001457656e-6,
            tolerance: 0.020998599124403942,
            question: Separation(-6.306129001457656),
        },
        StatisticalCase {
            kind: GradientSine,
            material: Material {
                youngs_modulus_pa: 127025.46112141229,
                poisson_ratio: -0.999999,
                counterface: None,
                strength_pa: 0.0004003769454661435,
                strain_gradient_length_m: Some(2.343981186243204e-10),
                strength_cap_pa: Some(0.0016062359065999996),
            },
            hardness: JacksonGreen2005,
            radius_m: 0.000119444554619228,
            density_per_m2: 3.044603963821113,
            sigma_s_m: 0.0045069094152002005,
            tolerance: 5.255962983835036e-13,
            question: Separation(-139.32187186688085),
        },
    ]);
}

#[test]
fn numbers_that_no_law_can_hold_are_refused() {
    let usual = |youngs_modulus_pa: f64, radius_m: f64| StatisticalCase {
        kind: Hertz,
        material: Material {
            youngs_modulus_pa,
            poisson_ratio: 0.3,
            counterface: None,
            strength_pa: 1e9,
            strain_gradient_length_m: None,
            strength_cap_pa: None,
        },
        hardness: Cosine,
        radius_m,
        density_per_m2: 1e12,
        sigma_s_m: 1e-8,
        tolerance: 1e-10,
        question: Separation(0.0),
    };
    assert!(usual(1e11, 1e-6).state().is_ok());
    for (modulus_pa, radius_m) in [(5e-324, 1e-6), (1e200, 1e-6), (1e11, 1e-300), (1e11, f64::MAX)] {
        assert!(usual(modulus_pa, radius_m).state().is_err(), "{modulus_pa:e}, {radius_m:e}");
    }
}

#[test]
fn a_pressure_keeps_its_digits_where_the_density_alone_is_below_the_normal_doubles() {
    let material = Material {
        youngs_modulus_pa: 1e14,
        poisson_ratio: 0.3,
        counterface: None,
        strength_pa: 1e9,
        strain_gradient_length_m: None,
        strength_cap_pa: None,
    };
    let case = StatisticalCase {
        kind: Hertz,
        material,
        hardness: JacksonGreen2005,
        radius_m: 1e3,
        density_per_m2: 1e20,
        sigma_s_m: 1e-5,
        tolerance: 1e-12,
        question: Separation(38.2e-5),
    };
    let state = case.state().unwrap();
    assert!(state.pressure_pa.is_normal());
    assert!((state.pressure_pa.ln() - state.ln_pressure_pa).abs() < 1e-11, "{state:?}");
}
