//! Advice on what to measure next, from the same draws.

use scene::UncertaintySettings;
use study::Progress;
use study::plan::{Cutoffs, Results, Work};
use study::student::{half_width, normal_half_width};

use spectrum::ProfilePsd;
use stacked_contact::convergence;

use crate::areas::Areas;
use crate::draws::Drawn;
use crate::group::{Group, Indices};
use crate::influence::Influence;
use crate::inputs::Inputs;
use crate::light_draws::{Contributions, LIGHT_DRAWS, LightDraw};
use crate::quantiles::interval;
use crate::results::{Advice, DecadeOfVariance, Resampled, Settling, Step, StepKind};
use crate::shares::first_order;
use crate::spectrum_ends::{End, PowerLaw, prolonged, prolonged_to_m};
use crate::surface_scatter::{DrawOf, SpectrumSource, SurfaceScatter};

/// Draws of a prolonged spectrum.
const PROLONGED_DRAWS: usize = 64;

/// The numbers of added scans that are tried.
const ADDED_SCANS: [usize; 3] = [1, 3, 10];

/// The fewest scans whose interval is not a guess.
pub const MIN_SCANS: usize = 3;

/// The mean square slope has a limit where the spectrum falls more steeply than this.
const STEEP_FOR_SLOPES: f64 = -3.0;

/// The mean square curvature, which sets the radius of asperities, has a limit if the spectrum falls more steeply than
/// this.
const STEEP_FOR_RADII: f64 = -5.0;

/// An area that moves by less than this when the spectrum goes on has settled.
const SETTLED_WITHIN: f64 = 0.01;

/// The inputs of the advice.
pub(crate) struct Adviser<'p> {
    pub inputs: &'p Inputs,
    pub areas: &'p Areas,
    pub results: &'p Results,
    pub settings: UncertaintySettings,
    pub drawn: &'p Drawn,
    pub indices: &'p [Vec<Indices>],
}

impl Adviser<'_> {
    /// The most steps of progress that the advice takes.
    pub fn steps(inputs: &Inputs) -> usize {
        match single(&inputs.surface) {
            Some(psd) => Influence::parts_of(&psd) + 2 * PROLONGED_DRAWS,
            None => 0,
        }
    }

    /// Computes the advice for every area that has some. Empty if the surface is certain or a sum of two, or if the
    /// work was cancelled.
    pub fn advice(&self, progress: &dyn Progress) -> (Vec<Advice>, Work, usize) {
        let nothing = || (Vec::new(), Work::default(), 0);
        let Some(psd) = single(&self.inputs.surface).filter(|_| self.inputs.surface_scatters()) else {
            return nothing();
        };
        let Some(influence) = Influence::new(self.areas, &psd, progress) else { return nothing() };
        let prolongations = [End::Long, End::Short].map(|end| self.prolongation(end, &psd, progress));
        if progress.is_cancelled() {
            return nothing();
        }
        let (mut work, mut plans) = (influence.work, influence.plans);
        for prolongation in prolongations.iter().flatten() {
            work += prolongation.work;
            plans += PROLONGED_DRAWS;
        }
        let light = LightDraw::all(self.inputs, &influence);
        let of_area = |area: usize| self.of_area(area, &psd, &influence, &light, &prolongations);
        let at_its_place = |(area, advice): (usize, Option<Advice>)| {
            let (curve, load) = self.areas.curve_and_load(area);
            Some(Advice { curve, load, ..advice? })
        };
        let found = self.areas.map_distinct(of_area).into_iter().enumerate();
        (found.filter_map(at_its_place).collect(), work, plans)
    }

    fn of_area(
        &self,
        area: usize,
        psd: &ProfilePsd,
        influence: &Influence,
        light: &[LightDraw],
        prolongations: &[Option<Drawn>; 2],
    ) -> Option<Advice> {
        let (curve, load) = self.areas.curve_and_load(area);
        let width = self.width(&self.drawn.of(area))?;
        if width == 0.0 {
            return None;
        }
        let contributions = Contributions::new(area, influence, light);
        let steps = self.steps_of(area, width, &contributions, psd, prolongations);
        Some(Advice {
            curve,
            load,
            decades: decades(psd, influence, &contributions.parts),
            instruments: self.instruments(area, &contributions),
            steps,
            settling: self.settling(curve, load, psd),
        })
    }

    /// ln(high/low) of draws of ln A.
    fn width(&self, ln_areas: &[f64]) -> Option<f64> {
        let found = interval(ln_areas, self.settings.level)?;
        Some(found.high.value - found.low.value)
    }

    /// ln(high/low) of draws of ln A; 0 without draws.
    fn width_of(&self, draws: &[f64]) -> f64 {
        self.width(draws).unwrap_or(0.0)
    }

    /// The shares of the variance of ln A that the scans and the height scale of every instrument carry.
    fn instruments(&self, area: usize, contributions: &Contributions) -> Vec<[f64; 2]> {
        let share =
            |group| first_order(&self.inputs.groups, &self.indices[area], group).unwrap_or(0.0).max(0.0);
        let squares = |draws: &[Vec<f64>]| -> Vec<f64> {
            draws.iter().map(|of_instrument| self.width_of(of_instrument).powi(2)).collect()
        };
        let (places, gains) = (squares(&contributions.places), squares(&contributions.gains));
        let part = |squares: &[f64], at: usize| {
            let sum: f64 = squares.iter().sum();
            if sum > 0.0 { squares[at] / sum } else { 0.0 }
        };
        (0..gains.len())
            .map(|at| [share(Group::Scans) * part(&places, at), share(Group::Instruments) * part(&gains, at)])
            .collect()
    }

    /// The possible steps, the one that shrinks the interval most first.
    fn steps_of(
        &self,
        area: usize,
        width: f64,
        contributions: &Contributions,
        psd: &ProfilePsd,
        prolongations: &[Option<Drawn>; 2],
    ) -> Vec<Step> {
        let mut steps = Vec::new();
        let shrunk = |before: f64, after: f64| {
            ((width * width - before * before + after * after).max(0.0)).sqrt() / width
        };
        if let Some(SpectrumSource::Scans(scans)) = self.inputs.surface.single_source() {
            let of_all_gains: Vec<f64> = (0..LIGHT_DRAWS)
                .map(|draw| contributions.gains.iter().map(|draws| draws[draw]).sum())
                .collect();
            let all_gains = self.width_of(&of_all_gains).min(width);
            for (instrument, description) in scans.descriptions.iter().enumerate() {
                let own = self.width_of(&contributions.places[instrument]).min(width);
                for added in ADDED_SCANS {
                    let kind = StepKind::MoreScans { instrument, added };
                    let ratio = self
                        .width_of_more(description.resampled, added)
                        .map(|ratio| shrunk(own, ratio * own));
                    steps.extend(ratio.map(|width_ratio| Step { kind, width_ratio, area_ratio: 1.0 }));
                }
                let without = self.width_of(&contributions.gains_without[instrument]).min(all_gains);
                steps.push(Step {
                    kind: StepKind::Calibration { instrument },
                    width_ratio: shrunk(all_gains, without),
                    area_ratio: 1.0,
                });
            }
        }
        for group in [Group::Material, Group::Strength, Group::Holes] {
            let share =
                first_order(&self.inputs.groups, &self.indices[area], group).filter(|share| *share > 0.0);
            steps.extend(share.map(|share| Step {
                kind: StepKind::KnownExactly { group },
                width_ratio: (1.0 - share.clamp(0.0, 1.0)).sqrt(),
                area_ratio: 1.0,
            }));
        }
        for (end, prolongation) in [End::Long, End::Short].into_iter().zip(prolongations) {
            steps.extend(prolongation.as_ref().and_then(|found| self.prolonged_step(area, end, psd, found)));
        }
        steps.sort_by(|a, b| a.width_ratio.total_cmp(&b.width_ratio));
        steps
    }

    /// The factor on the width of the interval of scans when `added` are made; `None` if it would still be a guess.
    fn width_of_more(&self, resampled: Resampled, added: usize) -> Option<f64> {
        let level = self.settings.level;
        let width = |scans: usize| half_width(level, scans) / (scans as f64).sqrt();
        let (before, scans) = match resampled {
            Resampled::Scans(scans) => (width(scans), scans),
            Resampled::BlocksOfLines(_) | Resampled::SingleLine => (normal_half_width(level), 1),
        };
        (scans + added >= MIN_SCANS).then(|| width(scans + added) / before)
    }

    fn prolonged_step(&self, area: usize, end: End, psd: &ProfilePsd, prolongation: &Drawn) -> Option<Step> {
        let (before, after): (Vec<f64>, Vec<f64>) = self
            .drawn
            .ln_areas
            .iter()
            .zip(&prolongation.ln_areas)
            .filter_map(|(before, after)| before[area].zip(after[area]))
            .unzip();
        let (width_before, width_after) = (self.width(&before)?, self.width(&after)?);
        let moved: Vec<f64> = before.iter().zip(&after).map(|(before, after)| after - before).collect();
        let area_ratio = interval(&moved, self.settings.level)?.median.value.exp();
        let to_m = prolonged_to_m(psd, end);
        let kind = match end {
            End::Long => StepKind::LongerWavelengths { to_m },
            End::Short => StepKind::ShorterWavelengths { to_m },
        };
        (width_before > 0.0).then(|| Step { kind, width_ratio: width_after / width_before, area_ratio })
    }

    /// Draws with the spectrum prolonged at an end by a power law, whose exponent scatters as the end does; `None` if
    /// the scene does not use wavelengths beyond that end.
    fn prolongation(&self, end: End, psd: &ProfilePsd, progress: &dyn Progress) -> Option<Drawn> {
        let law = PowerLaw::at(end, psd)?;
        if end == End::Short && self.areas.cutoff_m().is_some() {
            return None;
        }
        let count = PROLONGED_DRAWS.min(self.drawn.ln_areas.len());
        let numbers: Vec<u64> = (0..count as u64).collect();
        let draws = numerics::parallel::map(&numbers, |&draw| {
            if progress.is_cancelled() {
                return self.areas.nothing();
            }
            let of = DrawOf::all(draw);
            let slope = law.slope + law.standard_error * self.inputs.streams.deviate_beside(draw);
            let longer = self.inputs.psd(of).flatten().and_then(|drawn| prolonged(&drawn, end, slope));
            let found = match longer {
                Some(longer) => {
                    self.areas.at_the_end(Some(&longer), self.inputs.curves(self.areas.distinct_curves(), of))
                }
                None => self.areas.nothing(),
            };
            progress.advance(1);
            found
        });
        Some(Drawn::from_iter(draws))
    }

    fn settling(&self, curve: usize, load: usize, psd: &ProfilePsd) -> Settling {
        let followed = self.areas.curves[curve].cutoffs == Cutoffs::Every;
        let points = self.results.curves[curve].area_fractions(load);
        let settled = convergence(&points, SETTLED_WITHIN).is_some_and(|found| found.converged);
        let entry = self.areas.curves[curve].model.entry;
        let steep = if entry.takes_asperities() { STEEP_FOR_RADII } else { STEEP_FOR_SLOPES };
        match PowerLaw::at(End::Short, psd) {
            _ if followed && settled => Settling::HasSettled,
            Some(PowerLaw { slope, standard_error }) if slope < steep => {
                Settling::WillSettle { slope, standard_error }
            }
            Some(PowerLaw { slope, standard_error }) => Settling::CannotSettle { slope, standard_error },
            None => Settling::Unknown,
        }
    }
}

/// The spectrum of a single uncertain surface.
fn single(surface: &SurfaceScatter) -> Option<ProfilePsd> {
    match surface.single_source()? {
        SpectrumSource::Scans(scans) => scans.psd(&scans.ln_c1d),
        SpectrumSource::Errors(errors) => Some(errors.centre().clone()),
        SpectrumSource::Certain(..) => None,
    }
}

/// The share of each decade in the variance of the totals, from long to short wavelengths. The outermost totals of
/// heavy tails are left out, which would outweigh all others.
fn decades(psd: &ProfilePsd, influence: &Influence, parts: &[Vec<f64>]) -> Vec<DecadeOfVariance> {
    let totals: Vec<f64> = parts.iter().map(|parts| parts.iter().sum()).collect();
    let Some(kept) = interval(&totals, 0.95) else { return Vec::new() };
    let inside =
        || parts.iter().zip(&totals).filter(|(_, total)| (kept.low.value..=kept.high.value).contains(*total));
    let count = inside().count() as f64;
    let mean = inside().map(|(_, total)| total).sum::<f64>() / count;
    let variance = inside().map(|(_, total)| (total - mean).powi(2)).sum::<f64>() / count;
    if variance == 0.0 {
        return Vec::new();
    }
    let wavelengths_m = psd.wavelengths_m();
    let starts: Vec<f64> = influence.starts().map(|sample| wavelengths_m[sample]).collect();
    // A wavelength at the end of a decade is its longest.
    let decade = |wavelength_m: f64| (wavelength_m.log10() - 1e-9).ceil();
    let mut found: Vec<DecadeOfVariance> = Vec::new();
    for (part, start_m) in starts.iter().enumerate() {
        let share =
            inside().map(|(parts, total)| parts[part] * (total - mean)).sum::<f64>() / count / variance;
        let longest_m = 10f64.powf(decade(*start_m));
        match found.last_mut() {
            Some(last) if last.longest_m == longest_m => last.share += share,
            _ => found.push(DecadeOfVariance { longest_m, shortest_m: 0.1 * longest_m, share }),
        }
    }
    found
}
