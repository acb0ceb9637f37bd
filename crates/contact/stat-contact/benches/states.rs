//! Cost of a state: checks the answers, then prints time and law evaluations against tolerance.
//!
//! The first states are unrelated, in a shuffled order, on one thread, with nothing carried over: each builds its
//! contact anew and finds the separation at a given load. Populations are spread over six decades of scale and loads
//! over nine. Sweeps of one population follow.

use std::hint::black_box;
use std::time::Instant;

use asperity::{ElasticBody, Hardness, MaterialPair, NixGao};
use stat_contact::{AsperityLaw, InterferenceLaw, Population, StatisticalContact};

const STATES: usize = 200;
const REPETITIONS: usize = 20;
const TOLERANCES: [f64; 5] = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12];
const KINDS: [&str; 7] = [
    "hertz",
    "ep-sphere",
    "elastic-sine",
    "ep-sine",
    "ep-sphere, strain gradient",
    "ep-sine, strain gradient",
    "elastic-sine, bem",
];

/// Material, population and law, with the separation in standard deviations at which the load is taken.
struct Case {
    pair: MaterialPair,
    population: Population,
    law: AsperityLaw,
    sigma_s_m: f64,
    u: f64,
    pressure_pa: f64,
}

fn main() {
    let mut sum_of_four_s = vec![0.0; TOLERANCES.len()];
    println!("{:28} tolerance  us/state  evaluations  worst error of d/sigma  of area", "");
    for (kind, name) in KINDS.iter().enumerate() {
        let cases = cases(kind);
        for (tolerance, sum_s) in TOLERANCES.into_iter().zip(&mut sum_of_four_s) {
            let (separation_error, area_error, evaluations) = check(&cases, tolerance);
            let seconds = time(&cases, tolerance);
            *sum_s += if kind < 4 { seconds } else { 0.0 };
            println!(
                "{name:28} {tolerance:9.0e}  {:8.2}  {evaluations:11.1}  {separation_error:22.1e}  {area_error:7.1e}",
                seconds * 1e6
            );
        }
    }
    println!("one Hertz pair at a separation, to 1e-12: {:.0} ns", hertz_pair_s() * 1e9);
    for (tolerance, sum_s) in TOLERANCES.into_iter().zip(sum_of_four_s) {
        println!("mean of the four models at {tolerance:.0e}: {:.2} us", sum_s / 4.0 * 1e6);
    }
    sweeps();
}

/// Nanoseconds per state of a thousand states of one population over -3 to 20 standard deviations, and of the
/// corresponding loads, in one sweep and one by one.
fn sweeps() {
    const SWEPT: u32 = 1000;
    println!("{:28} tolerance  ns/state at d: sweep  single  at p: sweep  single", "a sweep");
    for (kind, name) in KINDS.iter().enumerate().take(4) {
        let Case { pair, population, law, sigma_s_m, .. } = &cases(kind)[0];
        let contact = StatisticalContact::new(pair, population, law);
        let separations_m: Vec<f64> =
            (0..SWEPT).map(|at| sigma_s_m * (-3.0 + 23.0 * f64::from(at) / f64::from(SWEPT - 1))).collect();
        let pressure = |&d: &f64| contact.at_separation(d, 1e-13).unwrap().pressure_pa;
        let pressures_pa: Vec<f64> = separations_m.iter().map(pressure).collect();
        for tolerance in [1e-3, 1e-6, 1e-10] {
            let ns = [
                best_s(|| {
                    let mut sweep = contact.sweep(tolerance);
                    for &d in &separations_m {
                        black_box(sweep.at_separation(black_box(d)).unwrap());
                    }
                }),
                best_s(|| {
                    for &d in &separations_m {
                        black_box(contact.at_separation(black_box(d), tolerance).unwrap());
                    }
                }),
                best_s(|| {
                    let mut sweep = contact.sweep(tolerance);
                    for &pressure_pa in &pressures_pa {
                        black_box(sweep.at_pressure(black_box(pressure_pa)).unwrap());
                    }
                }),
                best_s(|| {
                    for &pressure_pa in &pressures_pa {
                        black_box(contact.at_pressure(black_box(pressure_pa), tolerance, None).unwrap());
                    }
                }),
            ];
            let [d, single_d, p, single_p] = ns.map(|seconds| seconds * 1e9 / f64::from(SWEPT));
            println!("{name:28} {tolerance:9.0e}  {d:20.0}  {single_d:6.0}  {p:11.0}  {single_p:6.0}");
        }
    }
}

/// Seconds of a pass, the best of the repetitions.
fn best_s(mut pass: impl FnMut()) -> f64 {
    let mut once = || {
        let start = Instant::now();
        pass();
        start.elapsed().as_secs_f64()
    };
    (0..REPETITIONS).map(|_| once()).fold(f64::INFINITY, f64::min)
}

/// Worst deviations from the state at which the load was taken, and mean law evaluations.
fn check(cases: &[Case], tolerance: f64) -> (f64, f64, f64) {
    let mut worst = (0f64, 0f64, 0.0);
    for case in cases {
        let contact = StatisticalContact::new(&case.pair, &case.population, &case.law);
        let exact = contact.at_separation(case.u * case.sigma_s_m, 1e-13).unwrap();
        let state = contact.at_pressure(case.pressure_pa, tolerance, None).unwrap();
        let separation_m = state.separation_m.expect("a load below complete contact");
        let off = (separation_m / case.sigma_s_m - case.u).abs();
        let area_off = (state.ln_area_fraction - exact.ln_area_fraction).abs();

        assert!(
            off < 100.0 * tolerance && area_off < 100.0 * tolerance,
            "{off:e}, {area_off:e} at {tolerance:e}"
        );
        worst = (worst.0.max(off), worst.1.max(area_off), worst.2 + state.evaluations as f64);
    }
    (worst.0, worst.1, worst.2 / cases.len() as f64)
}

/// Seconds per state, the best of the repetitions: the machine is shared.
fn time(cases: &[Case], tolerance: f64) -> f64 {
    let pass = || {
        let start = Instant::now();
        for case in cases {
            let contact = StatisticalContact::new(&case.pair, &case.population, &case.law);
            black_box(contact.at_pressure(black_box(case.pressure_pa), tolerance, None).unwrap());
        }
        start.elapsed().as_secs_f64() / cases.len() as f64
    };
    (0..REPETITIONS).map(|_| pass()).fold(f64::INFINITY, f64::min)
}

/// Seconds for pressure and area of Hertz's spheres at a given separation, the contact built anew each time.
fn hertz_pair_s() -> f64 {
    let cases = cases(0);
    let pass = || {
        let start = Instant::now();
        for case in &cases {
            let contact = StatisticalContact::new(&case.pair, &case.population, &case.law);
            black_box(contact.at_separation(black_box(case.u * case.sigma_s_m), 1e-12).unwrap());
        }
        start.elapsed().as_secs_f64() / cases.len() as f64
    };
    (0..10 * REPETITIONS).map(|_| pass()).fold(f64::INFINITY, f64::min)
}

fn cases(kind: usize) -> Vec<Case> {
    let mut random = Random(0x9e37_79b9_7f4a_7c15 ^ kind as u64);
    (0..STATES).map(|_| case(kind, &mut random)).collect()
}

fn case(kind: usize, random: &mut Random) -> Case {
    let modulus_pa = random.decades(9.0, 12.0);
    let pair = MaterialPair::against_rigid(ElasticBody::new(modulus_pa, random.between(0.0, 0.45)).unwrap());
    let sigma_s_m = random.decades(-9.0, -6.0);
    let radius_m = sigma_s_m * random.decades(-1.0, 3.0);
    let density_per_m2 = random.decades(-2.5, -1.0) / (radius_m * sigma_s_m);
    let mut strength = NixGao::constant(modulus_pa * random.decades(-3.3, -1.7)).unwrap();
    if kind == 4 || kind == 5 {
        strength = strength.with_strain_gradient(sigma_s_m * random.decades(-1.0, 3.0)).unwrap();
    }
    let law = match kind {
        0 => AsperityLaw::Hertz,
        1 | 4 => AsperityLaw::EpSphere { strength, hardness: Hardness::default(), held_from: None },
        2 => AsperityLaw::ElasticSine { interference: InterferenceLaw::RostamiJackson },
        6 => AsperityLaw::ElasticSine { interference: InterferenceLaw::Bem },
        _ => AsperityLaw::EpSine { strength },
    };
    let population = Population::new(radius_m, density_per_m2, sigma_s_m).unwrap();
    let u = random.between(-1.0, 5.0);
    let contact = StatisticalContact::new(&pair, &population, &law);
    let pressure_pa = contact.at_separation(u * sigma_s_m, 1e-13).unwrap().pressure_pa;
    Case { pair, population, law, sigma_s_m, u, pressure_pa }
}

/// Xorshift: the same states in every run.
struct Random(u64);

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        low + (high - low) * (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn decades(&mut self, low: f64, high: f64) -> f64 {
        10f64.powf(self.between(low, high))
    }
}
