//! Counters of what was computed.

use std::ops::AddAssign;

use serde::Serialize;

/// Counters of the work done, which show that nothing is computed twice or without need.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Work {
    /// Cutoffs for which moments were computed.
    pub moment_cutoffs: usize,
    /// Cutoffs for which asperity parameters were computed.
    pub asperity_cutoffs: usize,
    /// Scales whose amplitude was computed.
    pub amplitude_scales: usize,
    /// Levels of stacked curves.
    pub stacked_levels: usize,
    /// States of statistical curves.
    pub statistical_states: usize,
    /// Evaluations of the law of one asperity that these states took.
    pub law_evaluations: usize,
    /// Samples that took part in a fit.
    pub fitted_samples: usize,
    /// Levels that were needed and found among those of an equal stack under an equal load.
    pub shared_levels: usize,
    /// States that were wanted and found among the others: of an equal model and population, at an equal load.
    pub shared_states: usize,
}

impl AddAssign for Work {
    fn add_assign(&mut self, other: Self) {
        let Work {
            moment_cutoffs,
            asperity_cutoffs,
            amplitude_scales,
            stacked_levels,
            statistical_states,
            law_evaluations,
            fitted_samples,
            shared_levels,
            shared_states,
        } = other;
        self.moment_cutoffs += moment_cutoffs;
        self.asperity_cutoffs += asperity_cutoffs;
        self.amplitude_scales += amplitude_scales;
        self.stacked_levels += stacked_levels;
        self.statistical_states += statistical_states;
        self.law_evaluations += law_evaluations;
        self.fitted_samples += fitted_samples;
        self.shared_levels += shared_levels;
        self.shared_states += shared_states;
    }
}

/// Results beside the work that each took, as results and the sum of the work.
pub(crate) fn counted<T>(parts: impl IntoIterator<Item = (T, Work)>) -> (Vec<T>, Work) {
    let mut work = Work::default();
    let results = parts
        .into_iter()
        .map(|(result, of_part)| {
            work += of_part;
            result
        })
        .collect();
    (results, work)
}
