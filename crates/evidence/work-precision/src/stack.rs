//! Cost of a scale of the stack under a load.

use asperity::{ElasticBody, MaterialPair, NixGao};
use stacked_contact::{Scale, StackedModel, largest_full_contact_pressure_pa, levels};

use crate::clock::seconds_per_call;

/// Number of scales: enough to hide start-up, few enough to stay in the cache.
const SCALES: usize = 10_000;
const LOADS_PA: [f64; 5] = [5.4e5, 5.4e6, 5.4e7, 5.4e8, 5.4e9];
const BUDGET_S: f64 = 0.5;

/// Cost of a law of the scales.
#[derive(Debug, Clone, PartialEq)]
pub struct StackCost {
    /// Name of the law.
    pub law: &'static str,
    /// Seconds per scale and load.
    pub seconds_per_scale: f64,
    /// Relative deviation of the last real pressure from the limit of dense stacks; `None` if the limit is unknown.
    pub off_limit: Option<f64>,
}

/// Law with a bar on its cost.
pub const BARRED_LAW: &str = "elastic-plastic";

/// Costs of every law of the stacked model, on diamond, under five loads.
pub fn costs() -> Vec<StackCost> {
    let scales = scales(SCALES);
    models().into_iter().map(|(law, model)| cost(law, &model, &scales)).collect()
}

/// Laws of the stacked model.
pub fn models() -> [(&'static str, StackedModel); 3] {
    let pair = MaterialPair::against_rigid(ElasticBody::new(463e9, 0.2).expect("diamond"));
    let strength = NixGao::constant(1.8e9).expect("diamond");
    let gradient = strength.with_strain_gradient(5e-6).expect("diamond");
    [
        ("elastic", StackedModel::Elastic { pair }),
        (BARRED_LAW, StackedModel::ElasticPlastic { pair, strength }),
        ("elastic-plastic, strain gradient", StackedModel::ElasticPlastic { pair, strength: gradient }),
    ]
}

/// Scales of a spectrum whose aspect ratio peaks at 10 nm, between 1 cm and 0.5 nm.
pub fn scales(count: usize) -> Vec<Scale> {
    let scale = |index: usize| {
        let wavelength_m = 1e-2 * 10f64.powf(-7.3 * index as f64 / (count - 1) as f64);
        let decades_off_peak = (wavelength_m / 1e-8).log10();
        let aspect_ratio = 0.04 * (-0.3 * decades_off_peak * decades_off_peak).exp();
        Scale { wavelength_m, amplitude_m: wavelength_m * aspect_ratio }
    };
    (0..count).map(scale).collect()
}

/// Real pressure below every scale.
pub fn final_pressure_pa(model: &StackedModel, load_pa: f64, scales: &[Scale]) -> f64 {
    levels(model, load_pa, scales.iter().copied()).last().map_or(load_pa, |level| level.real_pressure_pa)
}

fn cost(law: &'static str, model: &StackedModel, scales: &[Scale]) -> StackCost {
    let all_loads = || LOADS_PA.iter().map(|&load_pa| final_pressure_pa(model, load_pa, scales)).sum::<f64>();
    let limit_pa = largest_full_contact_pressure_pa(model, scales.iter().copied());
    StackCost {
        law,
        seconds_per_scale: seconds_per_call(BUDGET_S, all_loads) / (scales.len() * LOADS_PA.len()) as f64,
        off_limit: limit_pa
            .map(|limit_pa| (final_pressure_pa(model, LOADS_PA[1], scales) / limit_pa - 1.0).abs()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dense_stacks_come_to_their_limit() {
        let scales = scales(SCALES);
        for (law, model) in models() {
            if let Some(limit_pa) = largest_full_contact_pressure_pa(&model, scales.iter().copied()) {
                let reached = final_pressure_pa(&model, LOADS_PA[1], &scales) / limit_pa;
                assert!((0.999..1.0 + 1e-9).contains(&reached), "{law}: {reached}");
            }
        }
    }
}
