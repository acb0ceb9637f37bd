//! A stack of 100,000 scales under five loads: `cargo bench -p truearea-stacked-contact`.
//!
//! The answer is checked first: a dense stack reaches the limit of its law. Then the fastest of several runs is
//! printed, in nanoseconds per level, because the fastest run is the least disturbed.

use std::time::Instant;

use asperity::{ElasticBody, MaterialPair, NixGao};
use stacked_contact::{Scale, StackedModel, largest_full_contact_pressure_pa, levels, levels_under_loads};

const SCALES: usize = 100_000;
const LOADS_PA: [f64; 5] = [5.4e5, 5.4e6, 5.4e7, 5.4e8, 5.4e9];
const RUNS: usize = 30;

fn main() {
    let scales: Vec<Scale> = (0..SCALES).map(scale).collect();
    let pair = MaterialPair::against_rigid(ElasticBody::new(463e9, 0.2).expect("diamond"));
    let strength = NixGao::constant(1.8e9).expect("diamond");
    let gradient = strength.with_strain_gradient(5e-6).expect("diamond");
    for (name, model) in [
        ("elastic", StackedModel::Elastic { pair }),
        ("elastic-plastic", StackedModel::ElasticPlastic { pair, strength, area: Default::default() }),
        (
            "elastic-plastic, strain gradient",
            StackedModel::ElasticPlastic { pair, strength: gradient, area: Default::default() },
        ),
    ] {
        if let Some(limit_pa) = largest_full_contact_pressure_pa(&model, scales.iter().copied()) {
            let reached = final_pressure_pa(&model, LOADS_PA[1], &scales) / limit_pa;
            assert!((0.999..1.0 + 1e-9).contains(&reached), "{name} reaches {reached} of its limit");
        }
        let together = fastest_ns_per_level(|| last_pressures_pa(&model, &scales));
        let apart =
            fastest_ns_per_level(|| LOADS_PA.map(|load_pa| final_pressure_pa(&model, load_pa, &scales)));
        println!("{name:33} {together:5.1} ns per level, {apart:5.1} ns with one load after the other");
    }
}

/// Scale of a spectrum whose aspect ratio peaks at 10 nm, between 1 cm and 0.5 nm.
fn scale(index: usize) -> Scale {
    let wavelength_m = 1e-2 * 10f64.powf(-7.3 * index as f64 / (SCALES - 1) as f64);
    let decades_off_peak = (wavelength_m / 1e-8).log10();
    Scale {
        wavelength_m,
        amplitude_m: wavelength_m * 0.04 * (-0.3 * decades_off_peak * decades_off_peak).exp(),
    }
}

fn final_pressure_pa(model: &StackedModel, load_pa: f64, scales: &[Scale]) -> f64 {
    levels(model, load_pa, scales.iter().copied()).last().map_or(load_pa, |level| level.real_pressure_pa)
}

/// Final pressures of all loads, which go down the stack together.
fn last_pressures_pa(model: &StackedModel, scales: &[Scale]) -> [f64; LOADS_PA.len()] {
    let mut last_pa = LOADS_PA;
    let mut load = 0;
    for level in levels_under_loads(model, &LOADS_PA, scales.iter().copied()) {
        last_pa[load] = level.real_pressure_pa;
        load = (load + 1) % LOADS_PA.len();
    }
    last_pa
}

fn fastest_ns_per_level(pressures_pa: impl Fn() -> [f64; LOADS_PA.len()]) -> f64 {
    let run = |_| {
        let start = Instant::now();
        std::hint::black_box(pressures_pa());
        start.elapsed().as_secs_f64()
    };
    let fastest_s = (0..RUNS).map(run).fold(f64::INFINITY, f64::min);
    fastest_s / (SCALES * LOADS_PA.len()) as f64 * 1e9
}
