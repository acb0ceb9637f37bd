//! Last level of a stack, for callers who need no cutoff but the shortest.

use crate::descent::{Descent, Step};
use crate::{Level, Scale, StackedModel};

/// Last level of a stack, under any number of loads. It equals the last of [`levels`](crate::levels) to the last
/// digit, but the descent ends as soon as all that is left is flattened: with a strain gradient, flattened
/// elastically, because the strength further down is not known before.
#[derive(Debug, Clone)]
pub struct FinalLevels<'s> {
    model: StackedModel,
    scales: &'s [Scale],
    /// Largest aspect ratio among the scales from each on.
    steepest_from: Vec<f64>,
}

/// Last level of a stack.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct FinalLevel {
    /// Level of the scale of the shortest wavelength.
    pub level: Level,
    /// Number of levels computed for it, at least 1 and at most one per scale.
    pub visited: usize,
}

impl<'s> FinalLevels<'s> {
    /// Prepares scales that come from long to short wavelengths. Visits each of them once, for all loads.
    pub fn new(model: &StackedModel, scales: &'s [Scale]) -> Self {
        let mut steepest_from: Vec<f64> = scales.iter().map(Scale::aspect_ratio).collect();
        for i in (1..steepest_from.len()).rev() {
            steepest_from[i - 1] = steepest_from[i - 1].max(steepest_from[i]);
        }
        FinalLevels { model: *model, scales, steepest_from }
    }

    /// Returns the last level under a nominal pressure p > 0 \[Pa\]; `None` without scales.
    #[must_use]
    pub fn under(&self, nominal_pressure_pa: f64) -> Option<FinalLevel> {
        let (&last, above) = self.scales.split_last()?;
        let mut descent = Descent::new(&self.model, nominal_pressure_pa);
        let mut visited = 0;
        while visited < above.len() && !descent.flattens(self.steepest_from[visited]) {
            descent.press(&mut Step::new(above[visited]));
            visited += 1;
        }
        if let Some(&neighbour) = above[visited..].last() {
            descent.pass_flattened(neighbour);
        }
        let level = descent.level_below(&mut Step::new(last));
        Some(FinalLevel { level, visited: visited + 1 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Regime, YieldingAreaLaw, levels};
    use asperity::{ElasticBody, MaterialPair, NixGao};

    fn models() -> [StackedModel; 6] {
        let pair = MaterialPair::against_rigid(ElasticBody::new(463e9, 0.2).unwrap());
        let strength = NixGao::constant(1.8e9).unwrap();
        let gradient = strength.with_strain_gradient(5e-6).unwrap();
        let capped = strength.with_strain_gradient(1e-9).unwrap().with_cap(4e9).unwrap();
        let yielding = |area| move |strength| StackedModel::ElasticPlastic { pair, strength, area };
        let [a, b, c] = [strength, gradient, capped].map(yielding(YieldingAreaLaw::Blended));
        let [d, e] = [strength, gradient].map(yielding(YieldingAreaLaw::ElasticShape));
        [StackedModel::Elastic { pair }, a, b, c, d, e]
    }

    /// Scales whose aspect ratio peaks at 0.04 at 100 nm, and falls to a tenth of that at 1 nm.
    fn scales(per_decade_above_peak: usize, per_decade_below_peak: usize) -> Vec<Scale> {
        let above = (0..5 * per_decade_above_peak).map(|i| -5.0 + i as f64 / per_decade_above_peak as f64);
        let below = (0..=2 * per_decade_below_peak).map(|i| i as f64 / per_decade_below_peak as f64);
        above
            .chain(below)
            .map(|decades_below_peak| {
                let wavelength_m = 1e-7 * 10f64.powf(-decades_below_peak);
                let aspect_ratio = 0.04 * 10f64.powf(-0.25 * decades_below_peak * decades_below_peak);
                Scale { wavelength_m, amplitude_m: aspect_ratio * wavelength_m }
            })
            .collect()
    }

    #[test]
    fn the_final_level_is_the_last_of_all_levels_in_every_digit() {
        let scales = scales(20, 30);
        for model in models() {
            for nominal_pressure_pa in [1e-3, 5.4e5, 5.4e7, 5.4e9, 1e12] {
                for count in [1, 2, 3, 50, 100, 110, 120, 140, scales.len()] {
                    let scales = &scales[..count];
                    let last = levels(&model, nominal_pressure_pa, scales.iter().copied()).last();
                    let found = FinalLevels::new(&model, scales).under(nominal_pressure_pa).unwrap();
                    assert_eq!(Some(found.level), last, "{model:?} {nominal_pressure_pa} {count}");
                }
            }
        }
    }

    #[test]
    fn scales_of_the_converged_part_are_not_visited() {
        for model in &models()[..3] {
            for nominal_pressure_pa in [5.4e5, 5.4e7] {
                let visited = |below| {
                    let scales = scales(20, below);
                    let found = FinalLevels::new(model, &scales).under(nominal_pressure_pa).unwrap();
                    assert_eq!(found.level.regime, Regime::Flattened);
                    found.visited
                };
                let (few, many) = (visited(100), visited(1000));
                assert!(many as f64 <= 1.1 * few as f64, "{model:?}: {few} {many}");
            }
        }
    }

    #[test]
    fn a_load_that_flattens_everything_visits_the_last_scale_alone() {
        for model in models() {
            let scales = scales(20, 20);
            assert_eq!(FinalLevels::new(&model, &scales).under(1e12).unwrap().visited, 1);
        }
    }

    #[test]
    fn a_stack_without_scales_has_no_last_level() {
        assert_eq!(FinalLevels::new(&models()[0], &[]).under(1e6), None);
    }
}
