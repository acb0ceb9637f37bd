//! Quantities of a spectrum alone: moments, amplitudes, a self-affine fit.

use findings::doubts;
use numerics::parallel::Progress;
use serde::{Deserialize, Serialize};
use spectrum::{AmplitudeDefinition, Normalisation};
use study::figure::{Figure, Shows};
use study::plan::{Needs, Plan, Results};
use study::result_tables;
use study::surface::Surface;
use units::{Remark, RemarkCode};

use crate::{Answer, QuestionError, SamplingInput};

/// A quantity of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SpectrumQuantity {
    /// Spectral moments and McCool's asperity parameters for every cutoff.
    Moments {
        /// Normalisation.
        normalisation: Normalisation,
    },
    /// Amplitude and aspect ratio of every scale.
    Amplitude {
        /// Definition.
        definition: AmplitudeDefinition,
    },
    /// Hurst exponent and roll-off of a self-affine spectrum.
    Fit {
        /// One end of the band that is fitted \[m\]; the longest wavelength if absent.
        from_m: Option<f64>,
        /// The other end \[m\]; the shortest wavelength if absent. If both ends are given, either may be the longer
        /// one.
        to_m: Option<f64>,
    },
}

/// A quantity of a spectrum.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct SpectrumQuestion {
    /// The quantity.
    pub quantity: SpectrumQuantity,
    /// Scales that take part.
    pub sampling: SamplingInput,
    /// True draws the quantity against the wavelength as well; a fit has no figure.
    pub figure: bool,
}

impl Default for SpectrumQuestion {
    fn default() -> Self {
        SpectrumQuestion {
            quantity: SpectrumQuantity::Moments { normalisation: Normalisation::default() },
            sampling: SamplingInput::default(),
            figure: false,
        }
    }
}

impl SpectrumQuestion {
    /// Number of steps that the progress counts: quantity, table, doubts.
    pub const STEPS: usize = 3;

    /// Computes the quantity.
    ///
    /// # Errors
    /// [`QuestionError`] for a cutoff that leaves nothing or nothing out, and a fit with too few samples.
    pub fn answer(&self, surface: &Surface, progress: &dyn Progress) -> Result<Answer, QuestionError> {
        self.sampling.check(surface)?;
        let needs = match self.quantity {
            SpectrumQuantity::Moments { normalisation } => {
                Needs { moments: Some(normalisation), asperities: true, ..Needs::default() }
            }
            SpectrumQuantity::Amplitude { definition } => {
                Needs { amplitudes: Some(definition), ..Needs::default() }
            }
            SpectrumQuantity::Fit { from_m, to_m } => {
                Needs { fit_band_m: Some(band_m(from_m, to_m)), ..Needs::default() }
            }
        };
        let plan = Plan { psd: &surface.psd, sampling: self.sampling.sampling(), needs };
        let results = plan.compute_observed(progress)?;
        progress.advance(1);
        let (table, shows) = match self.quantity {
            SpectrumQuantity::Moments { .. } => (result_tables::moments(&results), Some(Shows::Moments)),
            SpectrumQuantity::Amplitude { .. } => {
                (result_tables::amplitude(&results), Some(Shows::Amplitude))
            }
            SpectrumQuantity::Fit { .. } => (result_tables::fit(&results), None),
        };
        progress.advance(1);
        let figure = shows.filter(|_| self.figure).map(|shows| {
            let of = Figure { shows, ..Figure::area_of_all(Vec::new()) };
            of.data(&results, &plan.needs, None)
        });
        let mut notes = surface.notes.clone();
        if let SpectrumQuantity::Moments { .. } = self.quantity {
            notes.extend(not_gaussian(&results));
        }
        notes.extend(of_fit(&results));
        notes.extend(doubts::of_spectrum(&surface.psd));
        progress.advance(1);
        Ok(Answer { table, notes, figure })
    }
}

/// The band between two ends, the shorter first; a missing end is left open.
fn band_m(from_m: Option<f64>, to_m: Option<f64>) -> (f64, f64) {
    match (from_m, to_m) {
        (Some(from_m), Some(to_m)) => (from_m.min(to_m), from_m.max(to_m)),
        (Some(longest_m), None) => (0.0, longest_m),
        (None, Some(shortest_m)) => (shortest_m, f64::INFINITY),
        (None, None) => (0.0, f64::INFINITY),
    }
}

/// Cutoffs with moments of no Gaussian isotropic surface, for which McCool's parameters are derived.
fn not_gaussian(results: &Results) -> Option<Remark> {
    let offenders: Vec<_> = results
        .moments
        .iter()
        .filter_map(|(moments, parameters)| Some((moments.wavelength_m, parameters.as_ref()?)))
        .filter(|(_, parameters)| !parameters.is_gaussian_isotropic())
        .collect();
    let alphas = offenders.iter().map(|(_, parameters)| parameters.nayak_alpha);
    let remark = Remark::new(RemarkCode::NotGaussianMoments)
        .with("least_alpha", thousandths(alphas.fold(f64::INFINITY, f64::min)));
    let (longest_m, shortest_m) = (offenders.first()?.0, offenders.last()?.0);
    Some(match offenders.len() {
        1 => remark.with("wavelength_m", longest_m),
        cutoffs => {
            remark.with("cutoffs", cutoffs).with("longest_m", longest_m).with("shortest_m", shortest_m)
        }
    })
}

/// A number rounded to thousandths.
fn thousandths(value: f64) -> f64 {
    (value * 1000.0).round() / 1000.0
}

/// A fit without a roll-off, or of no self-affine surface.
fn of_fit(results: &Results) -> Vec<Remark> {
    let Some(fit) = &results.fit else { return Vec::new() };
    let hurst_exponent = fit.hurst_exponent;
    let power_law = fit.rolloff.is_none().then(|| Remark::new(RemarkCode::PurePowerLaw));
    let remark = Remark::new(RemarkCode::HurstOutOfRange).with("hurst_exponent", thousandths(hurst_exponent));
    let out_of_range = (!(0.0..=1.0).contains(&hurst_exponent)).then_some(remark);
    power_law.into_iter().chain(out_of_range).collect()
}
