//! Two rough faces: the integrals F_n, the law, its triples, and its fit.

use asperity::{ElasticBody, MaterialPair};
use stat_contact::{
    AsperityLaw, GreenwoodTripp, PartialMoment, Population, SeparationPoint, StatisticalContact,
};

const MOMENTS: [(PartialMoment, f64); 5] = [
    (PartialMoment::Zeroth, 0.0),
    (PartialMoment::First, 1.0),
    (PartialMoment::ThreeHalves, 1.5),
    (PartialMoment::Second, 2.0),
    (PartialMoment::FiveHalves, 2.5),
];

/// F_n(x) by the trapezoidal rule in t, s = exp(t - exp(-t)): doubly exponential, so that halving the step squares the error.
fn by_quadrature(n: f64, x: f64) -> f64 {
    let term = |at: i32| {
        let t = f64::from(at) / 256.0;
        let s = (t - (-t).exp()).exp();
        s.powf(n + 1.0) * (1.0 + (-t).exp()) * (-0.5 * s * s - x * s).exp()
    };
    let sum: f64 = (-1800..1800).map(term).sum();
    sum / 256.0 * (-0.5 * x * x).exp() / std::f64::consts::TAU.sqrt()
}

#[test]
fn partial_moments_have_the_digits_of_their_series() {
    // Sum of (-x)^k/k! 2^((n+k-1)/2) Gamma((n+k+1)/2) times phi(x), in 160 digits.
    let rows = [
        (-12.0, [1.0, 12.0, 41.677_614_971_032_55, 145.0, 505.322_991_607_862_9]),
        (
            -5.0,
            [
                0.999_999_713_348_428_1,
                5.0000000534616556,
                11.349387798006594,
                25.999999980656703,
                60.083_558_764_240_68,
            ],
        ),
        (
            -2.5,
            [
                0.993_790_334_674_223_8,
                2.5020041371791284,
                4.199_895_952_398_184,
                7.248_800_677_622_044,
                12.812575630310187,
            ],
        ),
        (
            -0.5,
            [
                0.691_462_461_274_013_1,
                0.697_796_557_401_306_1,
                0.824_448_420_185_711_2,
                1.0403607399746662,
                1.3822283903477832,
            ],
        ),
        (0.0, [0.5, 0.398_942_280_401_432_7, 0.430_019_993_662_259_8, 0.5, 0.616_634_218_996_843_9]),
        (
            0.5,
            [
                0.308_537_538_725_986_9,
                0.19779655740130603,
                0.19520360374379064,
                0.20963926002533387,
                0.240_401_570_674_072_1,
            ],
        ),
        (
            1.0,
            [
                0.15865525393145705,
                0.083_315_470_587_686_3,
                0.075_668_177_390_975_07,
                0.075_339_783_343_770_76,
                0.080_562_335_570_811_47,
            ],
        ),
        (
            2.0,
            [
                0.022_750_131_948_179_21,
                0.008_490_702_616_829_637,
                0.006_648_177_623_587_093,
                0.005_768_726_714_519_932,
                0.005_423_705_197_484_414,
            ],
        ),
        (
            3.0,
            [
                0.0013498980316300946,
                0.000_382_154_317_047_723_6,
                0.000_263_967_554_269_467_3,
                0.00020343508048692373,
                0.00017087299621442438,
            ],
        ),
        (
            4.25,
            [
                1.068_852_577_493_442e-5,
                2.2924019977336587e-6,
                1.3905112557080341e-6,
                9.458_172_845_663_721e-7,
                7.043_209_368_119_122e-7,
            ],
        ),
        (
            6.0,
            [
                9.865_876_450_376_98e-10,
                1.5635697959709664e-10,
                8.203_580_589_815_166e-11,
                4.8445767455118286e-11,
                3.142_968_531_919_884e-11,
            ],
        ),
        (
            10.0,
            [
                7.619_853_024_160_525e-24,
                7.474_560_254_589_328e-25,
                3.101_206_508_673_169e-25,
                1.4529276957119804e-25,
                7.501_244_003_924_727e-26,
            ],
        ),
    ];
    for (x, exact) in rows {
        for ((moment, _), exact) in MOMENTS.into_iter().zip(exact) {
            let off = moment.above(x) / exact - 1.0;
            assert!(off.abs() < 1e-13, "{moment:?} at {x}: {off:e}");
        }
    }
}

#[test]
fn partial_moments_are_those_of_a_quadrature() {
    for at in -40..=160 {
        let x = 0.125 * f64::from(at);
        for (moment, n) in MOMENTS {
            let off = moment.above(x) / by_quadrature(n, x) - 1.0;
            assert!(off.abs() < 1e-12, "{moment:?} at {x}: {off:e}");
        }
    }
    assert!(PartialMoment::FiveHalves.above(60.0) == 0.0 && PartialMoment::FiveHalves.above(37.0) > 0.0);
}

/// Fits that public codes of bearings and piston rings use in place of the integrals; the first is attributed to Hu, Cheng, Arai,
/// Kobayashi & Aoyama (1994), J. Tribol. 116:470.
#[test]
fn the_usual_fits_of_the_integrals_fail_in_the_tail() {
    let five_halves = |x: f64| 4.4086e-5 * (4.0 - x).powf(6.804) / PartialMoment::FiveHalves.above(x) - 1.0;
    let second = |x: f64| 3.5e-5 * (4.0 - x).powf(6.9) / PartialMoment::Second.above(x) - 1.0;
    for (x, off) in [(0.0, -0.107), (1.0, -0.035), (2.0, -0.092), (3.0, -0.742)] {
        assert!((five_halves(x) - off).abs() < 1e-3, "{x}: {}", five_halves(x));
    }
    for (x, off) in [(0.0, -0.002), (1.0, -0.090), (2.0, -0.275), (3.0, -0.828)] {
        assert!((second(x) - off).abs() < 1e-3, "{x}: {}", second(x));
    }
}

fn alike(modulus_pa: f64, density_per_m2: f64, radius_m: f64, sigma_m: f64) -> GreenwoodTripp {
    GreenwoodTripp::new(modulus_pa, Population::new(radius_m, density_per_m2, sigma_m).unwrap()).unwrap()
}

/// A request for a cam and tappet code: sigma 0.2 um, beta 0.2 mm, eta 1.25e9 per m^2.
#[test]
fn a_cam_on_its_tappet_has_the_pressures_of_the_formula() {
    let law = alike(217e9, 1.25e9, 2e-4, 2e-7);
    assert!((law.density_radius_sigma() / 0.05 - 1.0).abs() < 1e-14);
    assert!((law.sigma_over_radius() / 0.001 - 1.0).abs() < 1e-14);
    for (over_sigma, pressure_pa) in [(0.0, 5.013e7), (1.0, 6.550e6), (2.0, 4.410e5), (3.0, 1.389e4)] {
        let found = law.pressure_pa(over_sigma * 2e-7);
        assert!((found / pressure_pa - 1.0).abs() < 5e-4, "{over_sigma}: {found:e}");
    }
    assert!(
        (law.area_fraction(2e-7) / (std::f64::consts::PI.powi(2) * 0.0025 * 0.075_339_783_343_770_76) - 1.0)
            .abs()
            < 1e-13
    );
    assert!(GreenwoodTripp::new(f64::NAN, *law.summits()).is_err());
}

/// Pairs of summits, one by one: Int over the distance r of both, and over the sum of their heights.
#[test]
fn two_faces_press_as_their_pairs_of_summits_do() {
    let faces = [Population::new(3e-5, 2e10, 1e-7).unwrap(), Population::new(8e-5, 5e9, 3e-7).unwrap()];
    let (modulus_pa, sigma_m) = (1e11, 1e-7f64.hypot(3e-7));
    let law = GreenwoodTripp::from_faces(modulus_pa, faces.each_ref()).unwrap();
    let [one_m, other_m] = [3e-5, 8e-5];
    let (radius_m, sum_m): (f64, f64) = (one_m * other_m / (one_m + other_m), one_m + other_m);
    let separation_m = 0.7 * sigma_m;
    let (mut pressure_pa, mut area) = (0.0, 0.0);
    let (heights, distances) = (4000, 2000);
    for height in 0..heights {
        let s = (f64::from(height) + 0.5) * 8.0 / f64::from(heights);
        let density =
            (-0.5 * (0.7 + s).powi(2)).exp() / std::f64::consts::TAU.sqrt() * 8.0 / f64::from(heights);
        let most_m2 = 2.0 * sum_m * s * sigma_m;
        for distance in 0..distances {
            // Equal parts of r^2.
            let square_m2 = (f64::from(distance) + 0.5) / f64::from(distances) * most_m2;
            let overlap_m = s * sigma_m - square_m2 / (2.0 * sum_m);
            let pairs = 2e10 * 5e9 * std::f64::consts::PI * most_m2 / f64::from(distances) * density;
            pressure_pa += pairs * 4.0 / 3.0 * modulus_pa * radius_m.sqrt() * overlap_m.powf(1.5);
            area += pairs * std::f64::consts::PI * radius_m * overlap_m;
        }
    }
    assert!((law.pressure_pa(separation_m) / pressure_pa - 1.0).abs() < 1e-4);
    assert!((law.area_fraction(separation_m) / area - 1.0).abs() < 1e-4);
}

#[test]
fn alike_faces_have_one_law_however_they_are_given() {
    let face = Population::new(4e-5, 1e10, 2e-7).unwrap();
    // The sum of two such faces has twice their moments.
    let sum = Population::new(4e-5 / 2f64.sqrt(), 1e10, 2e-7 * 2f64.sqrt()).unwrap();
    let [by_faces, by_sum] = [
        GreenwoodTripp::from_faces(2e11, [&face, &face]).unwrap(),
        GreenwoodTripp::from_sum(2e11, &sum).unwrap(),
    ];
    for separation_m in [0.0, 3e-7] {
        assert!((by_faces.pressure_pa(separation_m) / by_sum.pressure_pa(separation_m) - 1.0).abs() < 1e-13);
    }
    assert!(
        (by_sum.summits().radius_m() / 4e-5 - 1.0).abs() < 1e-14
            && (by_faces.summits().radius_m() / 4e-5 - 1.0).abs() < 1e-14
    );
}

#[test]
fn the_law_of_its_own_curve_is_found_again() {
    let law = alike(1e11, 3e10, 2e-5, 1.5e-7);
    let point = |at: i32| {
        let separation_m = 1.5e-7 * (0.2 + 0.031 * f64::from(at * at) / 10.0);
        let (pressure_pa, area_fraction) = (law.pressure_pa(separation_m), law.area_fraction(separation_m));
        SeparationPoint { separation_m, pressure_pa, area_fraction }
    };
    let points: Vec<SeparationPoint> = (0..40).rev().map(point).collect();
    let fit = GreenwoodTripp::fit(1e11, 1.5e-7, &points).unwrap();
    assert!((fit.law.summits().density_per_m2() / 3e10 - 1.0).abs() < 1e-11);
    assert!((fit.law.summits().radius_m() / 2e-5 - 1.0).abs() < 1e-11);
    assert!(fit.ln_pressure_errors[1] < 1e-12 && fit.ln_area_errors[1] < 1e-12);
    assert!(fit.range[0] >= 0.5 && fit.range[1] <= 3.0 && fit.range[1] - fit.range[0] > 2.2);
    let ends = [0.5 - 1e-9, 0.4, 3.0 + 1e-9, 3.1].map(|over_sigma| {
        let separation_m = over_sigma * 1.5e-7;
        SeparationPoint { separation_m, pressure_pa: law.pressure_pa(separation_m), ..points[20] }
    });
    assert_eq!(
        GreenwoodTripp::fit(1e11, 1.5e-7, &ends).unwrap().range.map(|end| (2.0 * end).round()),
        [1.0, 6.0]
    );
    assert!((GreenwoodTripp::fit(1e11, 1.5e-7, &ends).unwrap().range[0] - 0.5).abs() < 1e-6);
    assert_eq!(GreenwoodTripp::fit(1e11, 1e-9, &points), None);
    assert_eq!(GreenwoodTripp::fit(1e11, 1.5e-7, &[points[20], points[20]]), None);
}

/// No other amplitudes leave less, and errors are those of the points.
#[test]
fn the_fit_to_one_rough_face_leaves_the_least() {
    let pair = MaterialPair::against_rigid(ElasticBody::new(1e11, 0.0).unwrap());
    let population = Population::new(1e-5, 1e11, 1e-7).unwrap();
    let contact = StatisticalContact::new(&pair, &population, &AsperityLaw::Hertz);
    let point = |at: i32| {
        let separation_m = 1e-8 * f64::from(at);
        let state = contact.at_separation(separation_m, 1e-12).unwrap();
        SeparationPoint { separation_m, pressure_pa: state.pressure_pa, area_fraction: state.area_fraction }
    };
    let points: Vec<SeparationPoint> = (5..=30).map(point).collect();
    let fit = GreenwoodTripp::fit(1e11, 1e-7, &points).unwrap();
    let squares = |law: &GreenwoodTripp| -> f64 {
        let ends = |at: usize| if at == 0 || at == 25 { 0.5 } else { 1.0 };
        let of = |(at, point): (usize, &SeparationPoint)| {
            let pressure = (law.pressure_pa(point.separation_m) / point.pressure_pa).ln();
            let area = (law.area_fraction(point.separation_m) / point.area_fraction).ln();
            ends(at) * (pressure * pressure + area * area)
        };
        points.iter().enumerate().map(of).sum()
    };
    let least = squares(&fit.law);
    let rms = (fit.ln_pressure_errors[0].powi(2) + fit.ln_area_errors[0].powi(2)) * 25.0;
    assert!((rms / least - 1.0).abs() < 1e-12);
    for (density, radius) in [(1.01, 1.0), (0.99, 1.0), (1.0, 1.02), (1.0, 0.98), (1.02, 0.98)] {
        let (eta, beta) =
            (density * fit.law.summits().density_per_m2(), radius * fit.law.summits().radius_m());
        assert!(squares(&alike(1e11, eta, beta, 1e-7)) > least);
    }
    // F_3/2 falls more slowly than F_5/2.
    assert!(fit.ln_pressure_errors[1] > 0.1 && fit.ln_pressure_errors[1] < 1.0, "{fit:?}");
}
