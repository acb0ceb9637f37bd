//! The draws of a scene, from its inputs to the result.

use scene::{Scene, UncertaintySettings};
use study::Progress;
use study::plan::{Cutoffs, PlanError, Results, Work};
use units::{Remark, RemarkCode};

use crate::advice::{Adviser, MIN_SCANS};
use crate::areas::{Areas, Points, map_distinct};
use crate::bands::{self, band};
use crate::draws::{self, Along, Drawn};
use crate::group::Indices;
use crate::inputs::Inputs;
use crate::quantiles::{area_interval_about, interval};
use crate::quantities::{Quantities, QuantityDraws};
use crate::results::{AreaBand, AreaInterval, InstrumentName, Uncertainty};
use crate::shares::Design;
use crate::surface_scatter::{DrawOf, SpectrumSource};

/// The plan of an uncertainty analysis.
#[derive(Debug)]
pub struct UncertaintyPlan<'p> {
    results: &'p Results,
    settings: UncertaintySettings,
    inputs: Inputs,
    areas: Areas,
    quantities: Option<Quantities<'p>>,
    area_fractions: Vec<Option<f64>>,
}

/// The fewest draws that give a result.
const MIN_DRAWS: usize = 20;

/// The relative Monte Carlo error of an interval above which it is a guess.
const MAX_MONTE_CARLO_ERROR: f64 = 0.25;

/// The smallest share of draws that must have an area for it to have an interval.
const MIN_SHARE_WITH_AREA: f64 = 0.9;

/// The level of the narrower interval: one standard uncertainty of a normal distribution.
const ONE_STANDARD_UNCERTAINTY: f64 = 0.68;

impl<'p> UncertaintyPlan<'p> {
    /// Plans the analysis of a scene and its results; `None` if nothing in the scene is uncertain, or if it has no
    /// areas.
    #[must_use]
    pub fn new(scene: &'p Scene, results: &'p Results, settings: &UncertaintySettings) -> Option<Self> {
        let inputs = Inputs::from_scene(scene, settings.seed)?;
        let areas = Areas::new(scene, results);
        let shortest_m = results.psd.shortest_wavelength_m();
        let last = |curve: usize, load| {
            // Moments end at the cutoff itself, other models at the last sample before it.
            let cutoff_m =
                scene.sampling.cutoff_m.filter(|_| scene.needs.curves[curve].model.takes_separations());
            let last = results.curves[curve].area_fractions(load).last().copied();
            last.filter(|(wavelength_m, _)| {
                (*wavelength_m / cutoff_m.unwrap_or(shortest_m) - 1.0).abs() < 1e-9
            })
            .map(|(_, area_fraction)| area_fraction)
        };
        let area_fractions: Vec<Option<f64>> = (0..areas.curves.len())
            .flat_map(|curve| (0..areas.loads()).map(move |load| last(curve, load)))
            .collect();
        let has_areas = area_fractions.iter().any(Option::is_some);
        let quantities = Quantities::from_scene(scene, results);
        has_areas.then_some(UncertaintyPlan {
            results,
            settings: *settings,
            inputs,
            areas,
            quantities,
            area_fractions,
        })
    }

    /// The most steps of progress, most of which are draws.
    #[must_use]
    pub fn steps(&self) -> usize {
        let draws = self.settings.draws;
        let further = self.design().further_draws(draws, self.inputs.groups.len());
        draws + self.draws_of_bands() + further + Adviser::steps(&self.inputs)
    }

    /// Runs the analysis. `progress` may end the draws early: the result then rests on the draws made so far, without
    /// shares and advice.
    ///
    /// # Errors
    /// [`PlanError::Cancelled`] if fewer than 20 draws were made by then.
    pub fn run(&self, progress: &dyn Progress) -> Result<Uncertainty, PlanError> {
        let drawn = self.drawn(self.quantities.as_ref(), progress)?;
        let draws = drawn.ln_areas.len();
        let mut work = drawn.work;
        let mut plans = draws;
        let (along, of_bands) = self.along(progress);
        work += of_bands;
        plans += along.len();
        let mut bands = Vec::new();
        let are_all = along.len() == self.draws_of_bands();
        if let Some((best, of_best)) = self.best_along().filter(|_| are_all) {
            bands = self.bands(&along, &best);
            work += of_best;
            plans += 1;
        }
        let shares = self.design().run(&self.inputs, &self.areas, &drawn, progress);
        let is_incomplete = draws < self.settings.draws || shares.is_none() || progress.is_cancelled();
        let (indices, of_shares, plans_of_shares) = shares.unwrap_or_default();
        work += of_shares;
        plans += plans_of_shares;
        let (advice, of_advice, plans_of_advice) = match is_incomplete {
            true => (Vec::new(), Work::default(), 0),
            false => self.adviser(&drawn, &indices).advice(progress),
        };
        let ended_early = is_incomplete || progress.is_cancelled();
        work += of_advice;
        plans += plans_of_advice;
        let (areas, of_best) = self.intervals_of(&drawn, &indices);
        work += of_best;
        plans += 1;
        let mut found = Uncertainty {
            settings: self.settings,
            draws,
            ended_early,
            groups: self.inputs.groups.clone(),
            instruments: Vec::new(),
            overlaps: Vec::new(),
            spectrum_errors: Vec::new(),
            guesses: Vec::new(),
            areas,
            quantities: Vec::new(),
            open_channels: Vec::new(),
            bands,
            advice,
            work,
            plans,
        };
        let QuantityDraws { intervals, open_channels } = self.quantities_of(&drawn, &found.areas);
        (found.quantities, found.open_channels) = (intervals, open_channels);
        self.describe_inputs(&mut found);
        let beyond_an_end = 0.5 * (1.0 - self.settings.level) * draws as f64;
        let are_ends_loose = found.areas.iter().any(|area| area.monte_carlo_error > MAX_MONTE_CARLO_ERROR);
        if draws < self.settings.draws || beyond_an_end < 1.0 || are_ends_loose {
            found.guesses.push(Remark::new(RemarkCode::FewDraws).with("draws", draws));
        }
        let without =
            |area: &AreaInterval| draws - drawn.of(area.curve * self.areas.loads() + area.load).len();
        let most_without = found.areas.iter().map(without).max().unwrap_or(0);
        if most_without > 0 {
            let without = Remark::new(RemarkCode::DrawsWithoutArea).with("draws", most_without);
            found.guesses.push(without.with("of", draws));
        }
        Ok(found)
    }

    /// Computes the intervals only, without indices, bands and advice. `progress` advances once per draw.
    ///
    /// # Errors
    /// [`PlanError::Cancelled`] where fewer than 20 draws were made by then.
    pub fn intervals(&self, progress: &dyn Progress) -> Result<Vec<AreaInterval>, PlanError> {
        let drawn = self.drawn(None, progress)?;
        Ok(self.intervals_of(&drawn, &[]).0)
    }

    /// Makes the draws, fewer if they are cancelled.
    fn drawn(
        &self,
        quantities: Option<&Quantities<'_>>,
        progress: &dyn Progress,
    ) -> Result<Drawn, PlanError> {
        let wanted = self.settings.draws;
        let drawn = draws::all(&self.inputs, &self.areas, quantities, wanted, DrawOf::all, progress);
        if drawn.ln_areas.len() < MIN_DRAWS.min(wanted) {
            return Err(PlanError::Cancelled);
        }
        Ok(drawn)
    }

    /// The interval of every area that has one, centred on the best estimates.
    fn intervals_of(&self, drawn: &Drawn, indices: &[Vec<Indices>]) -> (Vec<AreaInterval>, Work) {
        let best = match self.inputs.best_psd() {
            Some(psd) => self.areas.at_the_end(psd.as_ref(), self.areas.distinct_curves().to_vec()),
            None => self.areas.nothing(),
        };
        let interval = |area: usize| self.interval(area, drawn, best.ln_areas[area], indices);
        let at_its_place = |area: usize, interval: AreaInterval| {
            let (curve, load) = self.areas.curve_and_load(area);
            AreaInterval { curve, load, ..interval }
        };
        let found = self.areas.map_distinct(interval).into_iter().enumerate();
        (found.filter_map(|(area, found)| Some(at_its_place(area, found?))).collect(), best.work)
    }

    fn quantities_of(&self, drawn: &Drawn, areas: &[AreaInterval]) -> QuantityDraws {
        let best = self.inputs.best_psd().flatten();
        let level = self.settings.level;
        let intervals = |quantities: &Quantities<'_>| {
            quantities.intervals(&drawn.quantities, best.as_ref(), level, areas)
        };
        self.quantities.as_ref().map(intervals).unwrap_or_default()
    }

    fn design(&self) -> Design {
        Design::new(self.settings.draws, self.settings.shares_draws)
    }

    fn adviser<'a>(&'a self, drawn: &'a Drawn, indices: &'a [Vec<Indices>]) -> Adviser<'a> {
        let (inputs, areas, results) = (&self.inputs, &self.areas, self.results);
        Adviser { inputs, areas, results, settings: self.settings, drawn, indices }
    }

    fn follows_any(&self) -> bool {
        self.areas.curves.iter().any(|curve| curve.cutoffs == Cutoffs::Every)
    }

    fn draws_of_bands(&self) -> usize {
        if self.follows_any() { self.settings.draws.min(bands::MAX_DRAWS) } else { 0 }
    }

    fn along(&self, progress: &dyn Progress) -> (Vec<Along>, Work) {
        draws::along(&self.inputs, &self.areas, self.draws_of_bands(), progress)
    }

    /// The areas of the best estimates along the cutoff; `None` if no curve is followed.
    fn best_along(&self) -> Option<(Along, Work)> {
        let psd = self.inputs.best_psd().filter(|_| self.follows_any())?;
        self.areas.along(psd.as_ref(), self.areas.distinct_curves().to_vec())
    }

    fn bands(&self, along: &[Along], best: &Along) -> Vec<AreaBand> {
        let followed =
            (0..self.areas.curves.len()).filter(|&at| self.areas.curves[at].cutoffs == Cutoffs::Every);
        let places: Vec<(usize, usize)> =
            followed.flat_map(|curve| (0..self.areas.loads()).map(move |load| (curve, load))).collect();
        let place = |at: usize| {
            let (curve, load) = places[at];
            self.areas.place(curve, load)
        };
        let band = |at: usize| {
            let ((curve, load), (own_curve, own_load)) = (places[at], place(at));
            let draws: Vec<&Points> = along.iter().map(|draw| &draw[own_curve][own_load]).collect();
            band(curve, load, &draws, &best[own_curve][own_load], self.settings.level)
        };
        let found = map_distinct(places.len(), place, band).into_iter().zip(&places);
        found.filter_map(|(found, &(curve, load))| Some(AreaBand { curve, load, ..found? })).collect()
    }

    fn interval(
        &self,
        area: usize,
        drawn: &Drawn,
        best: Option<f64>,
        indices: &[Vec<Indices>],
    ) -> Option<AreaInterval> {
        let ln_areas = drawn.of(area);
        if (ln_areas.len() as f64) < MIN_SHARE_WITH_AREA * drawn.ln_areas.len() as f64 {
            return None;
        }
        // A certain surface needs no correction for bias.
        let best = best.filter(|_| self.inputs.surface_scatters());
        let at_level = |level| match best {
            Some(best) => area_interval_about(best, &ln_areas, level),
            None => interval(&ln_areas, level),
        };
        let found = at_level(self.settings.level)?;
        let within = at_level(ONE_STANDARD_UNCERTAINTY)?;
        let (curve, load) = self.areas.curve_and_load(area);
        Some(AreaInterval {
            curve,
            load,
            area_fraction: self.area_fractions[area]?,
            median: found.median.value.exp(),
            low: found.low.value.exp(),
            high: found.high.value.exp(),
            within_68: [within.low.value.exp(), within.high.value.exp()],
            monte_carlo_error: found.relative_error(),
            ln_area_sd: standard_deviation(&ln_areas, found.median.value),
            indices: indices.get(area).cloned().unwrap_or_default(),
        })
    }

    fn describe_inputs(&self, found: &mut Uncertainty) {
        for source in self.inputs.surface.sources() {
            match source {
                SpectrumSource::Scans(scans) => {
                    let first = found.instruments.len();
                    let few = (0..scans.descriptions.len()).filter_map(|at| {
                        let places = scans.places_in_a_bin(at);
                        let few = Remark::new(RemarkCode::FewScans);
                        let few = few.with("instrument", scans.descriptions[at].name.text());
                        (places < MIN_SCANS).then(|| few.with("scans", places))
                    });
                    found.guesses.extend(few);
                    found.guesses.extend(scans.descriptions.iter().filter_map(|instrument| {
                        let InstrumentName::Shared(name) = &instrument.name else { return None };
                        let shared = Remark::new(RemarkCode::OneInstrument).with("instrument", name.as_str());
                        Some(shared.with("scans", instrument.scans))
                    }));
                    found.instruments.extend(scans.descriptions.iter().cloned());
                    found.overlaps.extend(scans.overlaps.iter().cloned().map(|mut overlap| {
                        overlap.instruments = overlap.instruments.map(|instrument| first + instrument);
                        overlap
                    }));
                }
                SpectrumSource::Errors(errors) => found.spectrum_errors.push(errors.description.clone()),
                SpectrumSource::Certain(_, name) => {
                    let without = Remark::new(RemarkCode::SpectrumWithoutErrors);
                    found.guesses.push(without.with("name", name.as_str()));
                }
            }
        }
    }
}

/// The standard deviation of draws about their mean, from their distances from their median: of equal draws it is 0.
fn standard_deviation(draws: &[f64], median: f64) -> f64 {
    let count = draws.len() as f64;
    let mean = draws.iter().map(|draw| draw - median).sum::<f64>() / count;
    let squares = draws.iter().map(|draw| (draw - median).powi(2)).sum::<f64>();
    (squares / count - mean * mean).max(0.0).sqrt()
}
