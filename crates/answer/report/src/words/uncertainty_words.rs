//! The uncertainty of areas in words: coverage intervals, their sources, and what was assumed.

use uncertainty::{
    AreaInterval, Group, InstrumentInput, InstrumentName, OverlapMisfit, Resampled, SpectrumErrors,
    Uncertainty,
};
use units::display::{counted, length, percent, three_digits};
use units::{RemarkLevel, SceneKeys};

use crate::listing::{capital, listed, number_word};

/// The share above which an input carries most of the interval.
const MAJORITY: f64 = 0.5;

/// The largest misfit, in standard uncertainties, that is as expected.
const EXPECTED: f64 = 2.0;

/// `95 %`, the probability that intervals cover.
pub(crate) fn level(uncertainty: &Uncertainty) -> String {
    format!("{} %", three_digits(100.0 * uncertainty.settings.level))
}

/// `0.0011 to 0.0024`, both ends of an interval.
pub(crate) fn ends(area: &AreaInterval) -> String {
    format!("{} to {}", three_digits(area.low), three_digits(area.high))
}

/// The basis of the intervals: draws, guesses, overlaps of instruments, and assumptions; each with its code and weight.
#[must_use]
pub fn sentences(uncertainty: &Uncertainty) -> Vec<(String, String, RemarkLevel)> {
    let note = |kind: &str, text: String| (text, format!("uncertainty.{kind}"), RemarkLevel::Note);
    let mut sentences = vec![note("draws", drawn_inputs(uncertainty))];
    if uncertainty.ended_early {
        let (text, code, _) = note("ended-early", format!("{}.", capital(&ended_early(uncertainty))));
        sentences.push((text, code, RemarkLevel::Caution));
    }
    let guesses = uncertainty.guesses.iter();
    sentences.extend(guesses.map(|guess| (guess.words(&SceneKeys), guess.code_name(), guess.level)));
    for overlap in &uncertainty.overlaps {
        let is_expected = is_as_expected(overlap);
        let level = if is_expected { RemarkLevel::Note } else { RemarkLevel::Caution };
        let found = misfit(uncertainty, overlap).map(|text| (text, "uncertainty.overlap".to_owned(), level));
        sentences.extend(found);
    }
    sentences.extend(uncertainty.spectrum_errors.iter().map(|of| note("spectrum", errors_of_spectrum(of))));
    sentences.extend(assumed_calibrations(&uncertainty.instruments).map(|text| note("calibration", text)));
    sentences.extend(guessed_instruments(&uncertainty.instruments).map(|text| note("instruments", text)));
    sentences
}

/// The number of draws and their inputs, by type A and type B of the Guide to the expression of uncertainty in measurement.
fn drawn_inputs(uncertainty: &Uncertainty) -> String {
    let of = |is_meant: fn(&Group) -> bool| -> Vec<String> {
        uncertainty
            .groups
            .iter()
            .filter(|group| is_meant(group))
            .map(|group| input(uncertainty, *group))
            .collect()
    };
    let by_type = |kind: &str, inputs: Vec<String>| {
        let names: Vec<&str> = inputs.iter().map(String::as_str).collect();
        (!names.is_empty()).then(|| format!("{kind}: {}", listed(&names)))
    };
    // An assumed spectrum has no statistical error.
    let errors = &uncertainty.spectrum_errors;
    let is_assumed = uncertainty.instruments.is_empty()
        && !errors.is_empty()
        && errors.iter().all(|errors| errors.are_assumed);
    let kinds = if is_assumed {
        [None, by_type("type B", of(|_| true))]
    } else {
        [
            by_type("type A", of(|group| *group == Group::Scans)),
            by_type("type B", of(|group| *group != Group::Scans)),
        ]
    };
    let kinds: Vec<String> = kinds.into_iter().flatten().collect();
    format!(
        "{} coverage intervals from {}; {}.",
        level(uncertainty),
        counted(uncertainty.draws, "draw"),
        kinds.join("; ")
    )
}

/// A group of inputs in words; without scans the scatter is that of the standard errors of the spectrum.
pub(crate) fn describe_group(group: Group, is_of_scans: bool) -> &'static str {
    match group {
        Group::Scans if is_of_scans => "the scatter of scans between places",
        Group::Scans => "the standard errors of the spectrum",
        Group::Instruments => "the height scales of instruments",
        Group::Material => "the elastic constants",
        Group::Strength => "the hardness",
        Group::Holes => "the holes in the spectrum",
    }
}

fn input(uncertainty: &Uncertainty, group: Group) -> String {
    describe_group(group, !uncertainty.instruments.is_empty()).to_owned()
}

/// The note on draws that were stopped early.
#[must_use]
pub fn ended_early(uncertainty: &Uncertainty) -> String {
    let (made, wanted) = (uncertainty.draws, uncertainty.settings.draws);
    if made < wanted {
        format!(
            "the draws were stopped after {made} of {wanted}: intervals rest on these, and there is no advice"
        )
    } else {
        "the draws for shares and advice were stopped early: intervals rest on all draws".to_owned()
    }
}

/// The misfit of two instruments at the wavelengths that both measure.
fn misfit(uncertainty: &Uncertainty, overlap: &OverlapMisfit) -> Option<String> {
    let [first, second] = overlap.instruments;
    let [first, second] = [uncertainty.instruments.get(first)?, uncertainty.instruments.get(second)?];
    let found = match is_as_expected(overlap) {
        true => "as expected",
        false => "more than scatter and calibration explain",
    };
    Some(format!(
        "{} and {} differ by a factor {} {}, where both measure (standard uncertainty: a factor {}): {found}.",
        first.name.text(),
        second.name.text(),
        three_digits(overlap.misfit.abs().exp()),
        match overlap.longest_m == overlap.shortest_m {
            true => format!("at {}", length(overlap.longest_m)),
            false => format!("from {} to {}", length(overlap.longest_m), length(overlap.shortest_m)),
        },
        three_digits(overlap.expected.exp())
    ))
}

/// Returns true if the stated uncertainties of both instruments explain their misfit.
pub(crate) fn is_as_expected(overlap: &OverlapMisfit) -> bool {
    overlap.misfit.abs() <= EXPECTED * overlap.expected
}

fn errors_of_spectrum(errors: &SpectrumErrors) -> String {
    let others = if errors.samples < errors.of { ", the others take that of their neighbours" } else { "" };
    let assumed = if errors.are_assumed { " from assumptions" } else { "" };
    format!(
        "{}: {} of {} have a standard error{assumed}{others}; errors are taken as correlated over {} decades of wavelength.",
        errors.name,
        errors.samples,
        counted(errors.of, "sample"),
        three_digits(errors.correlation_decades)
    )
}

fn assumed_calibrations(instruments: &[InstrumentInput]) -> Option<String> {
    let assumed: Vec<&InstrumentInput> =
        instruments.iter().filter(|instrument| instrument.z_calibration_is_assumed).collect();
    let share = assumed.first()?.z_calibration;
    let names: Vec<&str> = assumed.iter().map(|instrument| instrument.name.text()).collect();
    Some(format!(
        "Height calibration of {} unknown, {} assumed (set z_calibration).",
        listed(&names),
        percent(share)
    ))
}

fn guessed_instruments(instruments: &[InstrumentInput]) -> Option<String> {
    let guessed: Vec<String> = instruments
        .iter()
        .filter(|instrument| !matches!(instrument.name, InstrumentName::Given(_)))
        .map(|instrument| format!("{} ({})", instrument.name.text(), counted(instrument.scans, "scan")))
        .collect();
    let names: Vec<&str> = guessed.iter().map(String::as_str).collect();
    (!names.is_empty())
        .then(|| format!("Instruments guessed from format and maker: {} (set instrument).", listed(&names)))
}

/// The source of the interval, if its share is known well enough: `mostly from the scatter of three AFM scans`.
pub(crate) fn carried_by(uncertainty: &Uncertainty, area: &AreaInterval) -> Option<String> {
    if let [only] = uncertainty.groups[..] {
        return Some(format!("from {}", source(uncertainty, area, only)));
    }
    let known: Vec<(Group, f64)> = uncertainty
        .groups
        .iter()
        .filter_map(|group| Some((*group, uncertainty.share(area, *group)?)))
        .collect();
    let (group, share) = known.iter().copied().reduce(|a, b| if b.1 > a.1 { b } else { a })?;
    let from = source(uncertainty, area, group);
    if share > MAJORITY {
        Some(format!("mostly from {from}"))
    } else if known.len() == uncertainty.groups.len() {
        Some(format!("the largest part ({:.0} %) from {from}", 100.0 * share))
    } else {
        None
    }
}

/// A group of inputs, narrowed to the instrument that leads for an area.
fn source(uncertainty: &Uncertainty, area: &AreaInterval, group: Group) -> String {
    let by_instrument = match group {
        Group::Scans => leading(uncertainty, area, 0).map(scatter_of),
        Group::Instruments => leading(uncertainty, area, 1)
            .map(|instrument| format!("the height scale of {}", instrument.name.text())),
        Group::Material | Group::Strength | Group::Holes => None,
    };
    by_instrument.unwrap_or_else(|| input(uncertainty, group))
}

/// The instrument with most of the share of all instruments, by the scatter of scans (0) or by height scales (1).
fn leading<'u>(
    uncertainty: &'u Uncertainty,
    area: &AreaInterval,
    part: usize,
) -> Option<&'u InstrumentInput> {
    // The spectrum of a second surface may carry as much.
    if !uncertainty.spectrum_errors.is_empty() {
        return None;
    }
    if let [only] = &uncertainty.instruments[..] {
        return Some(only);
    }
    let shares = &uncertainty.advice_for(area.curve, area.load)?.instruments;
    let of_part = || shares.iter().map(move |shares| shares[part]);
    let (at, largest) = of_part().enumerate().reduce(|a, b| if b.1 > a.1 { b } else { a })?;
    (largest > MAJORITY * of_part().sum::<f64>()).then(|| uncertainty.instruments.get(at))?
}

/// `the scatter of three AFM scans`.
fn scatter_of(instrument: &InstrumentInput) -> String {
    let name = instrument.name.text();
    match instrument.resampled {
        Resampled::Scans(1) => format!("the scatter of one {name} scan"),
        Resampled::Scans(scans) => format!("the scatter of {} {name} scans", number_word(scans)),
        Resampled::BlocksOfLines(_) => format!("the scatter along the one {name} map"),
        Resampled::SingleLine => format!("the scatter of the one {name} scan"),
    }
}
