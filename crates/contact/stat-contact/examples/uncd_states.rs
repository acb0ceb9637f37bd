//! The statistical states of the scene `data/scenes/uncd-reconstructed.toml` alone, for counting instructions:
//!
//! ```text
//! cargo build --release -p truearea-stat-contact --example uncd_states
//! valgrind --tool=callgrind --toggle-collect='*counted_states*' target/release/examples/uncd_states 1e-10 [curve]
//! ```
//!
//! Prints the mean law evaluations of each curve; with `--digits` every state instead, to compare two builds.

use asperity::{ElasticBody, Hardness, MaterialPair, NixGao};
use stat_contact::{AsperityLaw, ContactState, InterferenceLaw, Population, StatisticalContact};

const SPECTRUM: &str = include_str!("../../../../data/uncd_psd_reconstructed.csv");
const HARDNESS_PA: f64 = 5.4e9;

/// State to compute: a population and a load. The search starts from the state of the previous population at the same
/// load.
struct StateRequest {
    population: Population,
    pressure_pa: f64,
    first_of_its_curve: bool,
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let digits = arguments.iter().any(|argument| argument == "--digits");
    let tolerance = arguments.first().and_then(|text| text.parse().ok()).unwrap_or(1e-10);
    let pair = MaterialPair::against_rigid(ElasticBody::new(463e9, 0.2).expect("diamond"));
    for (name, law, asked) in curves() {
        if arguments.iter().skip(1).any(|wanted| wanted != "--digits" && wanted != name) {
            continue;
        }
        // The quadrature rules are built at their first use, which is not counted.
        uncounted(&pair, &law, &asked, tolerance);
        let states = counted_states(&pair, &law, &asked, tolerance);
        if digits {
            for state in &states {
                let d = state.separation_m.unwrap_or(f64::NAN);
                println!(
                    "{name} {d:.12e} {:.12e} {:.12e} {:.2e} {}",
                    state.ln_pressure_pa, state.ln_area_fraction, state.error_estimate, state.evaluations
                );
            }
        } else {
            let evaluations: usize = states.iter().map(|state| state.evaluations).sum();
            let worst = states.iter().map(|state| state.error_estimate).fold(0.0, f64::max);
            let mean = evaluations as f64 / states.len() as f64;
            println!(
                "{name:30} {:5} states, {mean:6.1} evaluations each, estimated error at most {worst:.1e}",
                states.len()
            );
        }
    }
}

#[inline(never)]
fn counted_states(
    pair: &MaterialPair,
    law: &AsperityLaw,
    asked: &[StateRequest],
    tolerance: f64,
) -> Vec<ContactState> {
    states(pair, law, asked, tolerance)
}

#[inline(never)]
fn uncounted(pair: &MaterialPair, law: &AsperityLaw, asked: &[StateRequest], tolerance: f64) {
    std::hint::black_box(states(pair, law, asked, tolerance));
}

#[inline(never)]
fn states(
    pair: &MaterialPair,
    law: &AsperityLaw,
    asked: &[StateRequest],
    tolerance: f64,
) -> Vec<ContactState> {
    let mut neighbour: Option<ContactState> = None;
    asked
        .iter()
        .map(|asked| {
            let start = neighbour.filter(|_| !asked.first_of_its_curve);
            let contact = StatisticalContact::new(pair, &asked.population, law);
            let state =
                contact.at_pressure(asked.pressure_pa, tolerance, start.as_ref()).expect("a positive load");
            neighbour = Some(state);
            state
        })
        .collect()
}

/// Six curves over cutoffs at four loads, and the two sweeps over 41 loads at three cutoffs of figure 5.
fn curves() -> Vec<(&'static str, AsperityLaw, Vec<StateRequest>)> {
    let strength = NixGao::constant(1.8e9).expect("diamond");
    let gradient = strength.with_strain_gradient(5e-6).expect("diamond");
    let hardness = Hardness::default();
    let interference = InterferenceLaw::RostamiJackson;
    let populations = populations();
    let curve = |pressure_pa: f64| {
        populations.iter().enumerate().map(move |(i, &(_, population))| StateRequest {
            population,
            pressure_pa,
            first_of_its_curve: i == 0,
        })
    };
    let cutoffs =
        || [1e-4, 1e-3, 1e-2, 1e-1].into_iter().flat_map(|share| curve(share * HARDNESS_PA)).collect();
    let loads = || {
        let shortest_m = populations.last().expect("a spectrum").0;
        let cut = [1.0, 10.0, 100.0].map(|multiple| {
            populations
                .iter()
                .rev()
                .find(|p| p.0 >= multiple * shortest_m * (1.0 - 1e-9))
                .expect("a cutoff")
                .1
        });
        let at = |population: Population| {
            (0..41).map(move |i| StateRequest {
                population,
                pressure_pa: HARDNESS_PA * 10f64.powf(-6.0 + 0.15 * f64::from(i)),
                first_of_its_curve: i == 0,
            })
        };
        cut.into_iter().flat_map(at).collect()
    };
    vec![
        ("hertz", AsperityLaw::Hertz, cutoffs()),
        ("ep-sphere", AsperityLaw::EpSphere { strength, hardness, held_from: None }, cutoffs()),
        ("elastic-sine", AsperityLaw::ElasticSine { interference }, cutoffs()),
        ("ep-sine", AsperityLaw::EpSine { strength }, cutoffs()),
        (
            "ep-sphere-gradient",
            AsperityLaw::EpSphere { strength: gradient, hardness, held_from: None },
            cutoffs(),
        ),
        ("ep-sine-gradient", AsperityLaw::EpSine { strength: gradient }, cutoffs()),
        ("hertz-loads", AsperityLaw::Hertz, loads()),
        ("ep-sphere-loads", AsperityLaw::EpSphere { strength, hardness, held_from: None }, loads()),
    ]
}

/// Returns McCool's parameters at every cutoff from the third sample on (`docs/theory/models.md`, sections 1.4 and 1.5),
/// with the cutoff.
fn populations() -> Vec<(f64, Population)> {
    let samples: Vec<[f64; 3]> = SPECTRUM
        .lines()
        .filter(|line| line.starts_with(|c: char| c.is_ascii_digit()))
        .map(|line| {
            let cell = |i: usize| {
                line.split(',').nth(i).and_then(|text| text.parse::<f64>().ok()).expect("a number")
            };
            [cell(0), cell(1), cell(2)]
        })
        .collect();
    let mut moments = [0.0; 3];
    let mut populations = Vec::new();
    for pair in samples.windows(2) {
        let ([_, q, c], [wavelength_m, q_next, c_next]) = (pair[0], pair[1]);
        let log_ratio = (q_next / q).ln();
        let alpha = (c_next / c).ln() / log_ratio;
        for (moment, k) in moments.iter_mut().zip([0, 2, 4]) {
            let a = f64::from(k + 1) + alpha;
            let integral = if a.abs() < 1e-12 { log_ratio } else { (a * log_ratio).exp_m1() / a };
            *moment += c * q.powi(k + 1) * integral / std::f64::consts::PI;
        }
        let [m0, m2, m4] = moments;
        let radius_m = 0.375 * (std::f64::consts::PI / m4).sqrt();
        let density_per_m2 = m4 / (6.0 * std::f64::consts::PI * 3f64.sqrt() * m2);
        let sigma_s_m = (m0 - 3.717e-4 / (density_per_m2 * radius_m).powi(2)).sqrt();
        populations
            .extend(Population::new(radius_m, density_per_m2, sigma_s_m).ok().map(|p| (wavelength_m, p)));
    }
    populations
}
