//! States of statistical models, in runs: one after the other from its neighbour, run beside run.

use asperity::MaterialPair;
use parallel::Progress;
use spectrum::AsperityParameters;
use stat_contact::{AsperityLaw, ContactState, Population, StatisticalContact};

use super::ground::Cutoff;
use super::{CutoffState, PlanError, Tolerance, Work};

/// The states of a run at most. A run starts with nothing known, which costs some evaluations and no digit.
const RUN: usize = 256;

/// What a state is asked at.
#[derive(Clone, Copy)]
pub(super) enum Given {
    Pressure(f64),
    Separation(f64),
}

impl Given {
    /// Equal where the states of one population are.
    pub fn key(self) -> (bool, u64) {
        match self {
            Given::Pressure(pressure_pa) => (true, pressure_pa.to_bits()),
            Given::Separation(separation_m) => (false, separation_m.to_bits()),
        }
    }
}

/// A model that is asked for states.
pub(super) struct Statistical<'a> {
    pub pair: MaterialPair,
    pub law: AsperityLaw,
    pub tolerance: Tolerance,
    /// Watches the states, one step each.
    pub progress: &'a dyn Progress,
}

impl Statistical<'_> {
    /// A block of rows for everything given, a row for every cutoff.
    pub fn over_cutoffs(
        &self,
        cutoffs: &[Cutoff],
        givens: &[Given],
    ) -> Result<(Vec<Vec<CutoffState>>, Work), PlanError> {
        let run = |given: Given, cutoffs: &[Cutoff]| {
            let asked = cutoffs.iter().filter_map(|cutoff| Some((cutoff.asperities?, given)));
            let (states, work) = self.run(asked)?;
            let mut states = states.into_iter();
            let row = |cutoff: &Cutoff| CutoffState {
                wavelength_m: cutoff.wavelength_m,
                contact: cutoff.asperities.and_then(|asperities| Some((asperities, states.next()?))),
            };
            Ok::<_, PlanError>((cutoffs.iter().map(row).collect::<Vec<_>>(), work))
        };
        let runs: Vec<&[Cutoff]> = cutoffs.chunks(RUN).collect();
        let block = |&given: &Given| parallel::try_map(&runs, |cutoffs| run(given, cutoffs)).map(joined);
        let blocks = parallel::try_map(givens, block)?;
        let mut work = Work::default();
        let rows = |(rows, of_block)| {
            work += of_block;
            rows
        };
        Ok((blocks.into_iter().map(rows).collect(), work))
    }

    /// The states of one population, one for every pressure \[Pa\], which are distinct.
    pub fn over_loads(
        &self,
        asperities: &AsperityParameters,
        pressures_pa: &[f64],
    ) -> Result<(Vec<ContactState>, Work), PlanError> {
        let [radius_m, density_per_m2, sigma_s_m] = population(asperities);
        let population = Population::new(radius_m, density_per_m2, sigma_s_m)?;
        let contact = StatisticalContact::new(&self.pair, &population, &self.law);
        let run = |pressures_pa: &[f64]| {
            let mut sweep = contact.sweep(self.tolerance.value());
            let mut work = Work::default();
            let state = |&pressure_pa: &f64| {
                self.go_on()?;
                let state = sweep.at_pressure(pressure_pa)?;
                self.progress.advance(1);
                work.statistical_states += 1;
                work.law_evaluations += state.evaluations;
                Ok(state)
            };
            let states = pressures_pa.iter().map(state).collect::<Result<Vec<_>, PlanError>>()?;
            Ok((states, work))
        };
        let runs: Vec<&[f64]> = pressures_pa.chunks(RUN).collect();
        parallel::try_map(&runs, |pressures_pa| run(pressures_pa)).map(joined)
    }

    /// States, each found from the one before it, which saves work. Where a cutoff has left the asperities as they were, so
    /// is the state.
    fn run(
        &self,
        asked: impl Iterator<Item = (AsperityParameters, Given)>,
    ) -> Result<(Vec<ContactState>, Work), PlanError> {
        let mut states: Vec<ContactState> = Vec::with_capacity(asked.size_hint().1.unwrap_or(0));
        let mut work = Work::default();
        let mut before = None;
        for (asperities, given) in asked {
            let population = population(&asperities);
            let question = (population.map(f64::to_bits), given.key());
            let known = states.last().filter(|_| before == Some(question)).copied();
            let state = match known {
                Some(state) => {
                    work.shared_states += 1;
                    state
                }
                None => {
                    self.go_on()?;
                    let state = self.state(population, given, states.last())?;
                    self.progress.advance(1);
                    work.statistical_states += 1;
                    work.law_evaluations += state.evaluations;
                    state
                }
            };
            states.push(state);
            before = Some(question);
        }
        Ok((states, work))
    }

    fn go_on(&self) -> Result<(), PlanError> {
        if self.progress.is_cancelled() { Err(PlanError::Cancelled) } else { Ok(()) }
    }

    /// `neighbour` saves work and changes no digit.
    fn state(
        &self,
        [radius_m, density_per_m2, sigma_s_m]: [f64; 3],
        given: Given,
        neighbour: Option<&ContactState>,
    ) -> Result<ContactState, PlanError> {
        let population = Population::new(radius_m, density_per_m2, sigma_s_m)?;
        let contact = StatisticalContact::new(&self.pair, &population, &self.law);
        let tolerance = self.tolerance.value();
        Ok(match given {
            Given::Pressure(pressure_pa) => contact.at_pressure(pressure_pa, tolerance, neighbour)?,
            Given::Separation(separation_m) => contact.at_separation(separation_m, tolerance)?,
        })
    }
}

/// What a state depends on of the asperities: their radius \[m\], density \[1/m^2\] and height spread \[m\].
pub(super) fn population(asperities: &AsperityParameters) -> [f64; 3] {
    [asperities.radius_m, asperities.density_per_m2, asperities.sigma_s_m]
}

/// The rows of all runs, in their order, and the work of them.
fn joined<T>(runs: Vec<(Vec<T>, Work)>) -> (Vec<T>, Work) {
    let mut work = Work::default();
    let mut all = Vec::with_capacity(runs.iter().map(|(rows, _)| rows.len()).sum());
    for (rows, of_run) in runs {
        work += of_run;
        all.extend(rows);
    }
    (all, work)
}
