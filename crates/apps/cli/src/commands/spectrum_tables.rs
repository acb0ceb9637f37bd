//! `moments`, `amplitude` and `fit`: what a spectrum alone tells.

use super::{Context, Drawn, Spectrum};
use crate::args::{AmplitudeArgs, FitArgs, MomentsArgs};
use crate::failure::Failure;
use study::figure::Shows;
use study::plan::{Needs, Results};
use study::result_tables;
use units::display::length;
use units::number;

pub(super) fn moments(args: &MomentsArgs, context: &Context<'_>) -> Result<(), Failure> {
    let normalisation = args.normalisation.normalisation.unwrap_or_default();
    let needs = Needs { moments: Some(normalisation), asperities: true, ..Needs::default() };
    let spectrum = Spectrum {
        psd: &args.psd.psd,
        reading: &args.psd.reading,
        sampling: args.sampling.sampling(),
        figure: Drawn::against_wavelength(Shows::Moments, &args.figure),
    };
    context.spectrum_to_table(&spectrum, needs, result_tables::moments, not_gaussian)
}

/// Where the surface cannot be a Gaussian isotropic one, for which McCool's parameters are derived.
fn not_gaussian(results: &Results) -> Vec<String> {
    let offenders: Vec<_> = results
        .moments
        .iter()
        .filter_map(|(moments, parameters)| Some((moments.wavelength_m, parameters.as_ref()?)))
        .filter(|(_, parameters)| !parameters.is_gaussian_isotropic())
        .collect();
    let (Some((longest_m, _)), Some((shortest_m, _))) = (offenders.first(), offenders.last()) else {
        return Vec::new();
    };
    let least = offenders.iter().map(|(_, parameters)| parameters.nayak_alpha).fold(f64::INFINITY, f64::min);
    let cutoffs = match offenders.len() {
        1 => format!("the cutoff {}", length(*longest_m)),
        many => format!("{many} cutoffs between {} and {}", length(*longest_m), length(*shortest_m)),
    };
    vec![format!(
        "nayak_alpha lies below 1.5 (down to {}) at {cutoffs}: no Gaussian isotropic surface has such moments, for which \
         the asperity parameters are derived",
        number((least * 1000.0).round() / 1000.0)
    )]
}

pub(super) fn amplitude(args: &AmplitudeArgs, context: &Context<'_>) -> Result<(), Failure> {
    let needs = Needs { amplitudes: Some(args.amplitude.amplitude.unwrap_or_default()), ..Needs::default() };
    let spectrum = Spectrum {
        psd: &args.psd.psd,
        reading: &args.psd.reading,
        sampling: args.sampling.sampling(),
        figure: Drawn::against_wavelength(Shows::Amplitude, &args.figure),
    };
    context.spectrum_to_table(&spectrum, needs, result_tables::amplitude, |_| Vec::new())
}

pub(super) fn fit(args: &FitArgs, context: &Context<'_>) -> Result<(), Failure> {
    let (from_m, to_m) = (args.from.map(|end| end.m), args.to.map(|end| end.m));
    // Either end may be the longer one.
    let band = match (from_m, to_m) {
        (Some(from_m), Some(to_m)) => (from_m.min(to_m), from_m.max(to_m)),
        (Some(longest_m), None) => (0.0, longest_m),
        (None, Some(shortest_m)) => (shortest_m, f64::INFINITY),
        (None, None) => (0.0, f64::INFINITY),
    };
    let needs = Needs { fit_band_m: Some(band), ..Needs::default() };
    let spectrum = Spectrum {
        psd: &args.psd.psd,
        reading: &args.psd.reading,
        sampling: args.sampling.sampling(),
        figure: None,
    };
    context.spectrum_to_table(&spectrum, needs, result_tables::fit, fit_notes)
}

fn fit_notes(results: &Results) -> Vec<String> {
    let Some(fit) = &results.fit else { return Vec::new() };
    let mut notes = Vec::new();
    if fit.rolloff.is_none() {
        notes.push("no roll-off can be identified: the fit is a pure power law".to_owned());
    }
    if !(0.0..=1.0).contains(&fit.hurst_exponent) {
        let hurst_exponent = number((fit.hurst_exponent * 1000.0).round() / 1000.0);
        notes
            .push(format!("the Hurst exponent {hurst_exponent} lies outside 0 to 1: no self-affine surface"));
    }
    notes
}
