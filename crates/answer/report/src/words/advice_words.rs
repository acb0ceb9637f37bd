//! The advice on what to measure next, in words.

use conclusions::{AnswerUnderLoad, Conclusions, Evidence};
use scene::Scene;
use uncertainty::{Advice, Settling, Step, StepKind, Uncertainty};
use units::display::{length, three_digits};

use crate::curve_names::in_full;
use crate::listing::number_word;
use crate::uncertainty_words::describe_group;

/// A ratio this close to 1 is not a change.
const NO_CHANGE: f64 = 0.005;

/// A relative standard error this small is rounding.
const NO_ERROR: f64 = 1e-9;

/// The advice for the curve that stands for the answer, under the first load that has some; or else the first advice.
pub(crate) fn foremost_advice<'a>(evidence: &Evidence<'a>, conclusions: &Conclusions) -> Option<&'a Advice> {
    let uncertainty = evidence.uncertainty?;
    let of_load = |load: &AnswerUnderLoad| uncertainty.advice_for(load.nearest_curve()?, load.load);
    conclusions.loads.iter().find_map(of_load).or_else(|| uncertainty.advice.first())
}

/// The subject of the advice: `Spheres, elastic at 5 MPa`.
pub(crate) fn subject(advice: &Advice, scene: &Scene) -> String {
    format!("{} at {}", in_full(&scene.needs.curves[advice.curve]), scene.needs.loads[advice.load].label)
}

/// Returns true if a step narrows the interval.
pub(crate) fn narrows(step: &Step) -> bool {
    step.width_ratio < 1.0 - NO_CHANGE
}

/// A step and its effect: `three more AFM scans, at other places: narrows the interval to 74 % of its width`.
#[must_use]
pub fn in_a_line(uncertainty: &Uncertainty, step: &Step) -> String {
    let percent = three_digits((100.0 * step.width_ratio).round());
    let width = if narrows(step) {
        format!("narrows the interval to {percent} % of its width")
    } else if step.width_ratio > 1.0 + NO_CHANGE {
        format!("widens the interval to {percent} % of its width")
    } else {
        "leaves the interval as wide as it is".to_owned()
    };
    let area = if (step.area_ratio - 1.0).abs() > NO_CHANGE {
        format!(", and is expected to change the area by a factor {}", three_digits(step.area_ratio))
    } else {
        String::new()
    };
    format!("{}: {width}{area}", describe_step(uncertainty, &step.kind))
}

/// A step in words.
pub(crate) fn describe_step(uncertainty: &Uncertainty, kind: &StepKind) -> String {
    let name = |instrument: &usize| {
        uncertainty.instruments.get(*instrument).map_or("the instrument", |instrument| instrument.name.text())
    };
    match kind {
        StepKind::MoreScans { instrument, added: 1 } => {
            format!("one more {} scan, at another place", name(instrument))
        }
        StepKind::MoreScans { instrument, added } => {
            format!("{} more {} scans, at other places", number_word(*added), name(instrument))
        }
        StepKind::Calibration { instrument } => {
            format!("the height scale of {} calibrated", name(instrument))
        }
        StepKind::KnownExactly { group } => format!("{} known exactly", describe_group(*group, true)),
        StepKind::LongerWavelengths { to_m } => format!("wavelengths up to {}", length(*to_m)),
        StepKind::ShorterWavelengths { to_m } => format!("wavelengths down to {}", length(*to_m)),
        other => other.key().replace('-', " "),
    }
}

/// The outlook for settling the area with more of the spectrum.
pub(crate) fn settling(advice: &Advice) -> String {
    let falls = |slope: f64, standard_error: f64| {
        // The error of a spectrum made as a power law is rounding.
        let is_known = standard_error > NO_ERROR * slope.abs();
        let error = is_known.then(|| format!(" (standard error {})", three_digits(standard_error)));
        let slope = three_digits(slope);
        format!(
            "the spectrum falls as the wavevector to the power {slope}{} at its short end",
            error.unwrap_or_default()
        )
    };
    match advice.settling {
        Settling::HasSettled => "The area has settled: shorter wavelengths would not change it.".to_owned(),
        Settling::WillSettle { slope, standard_error } => format!(
            "Shorter wavelengths would settle the area: {}, steep enough for a limit.",
            falls(slope, standard_error)
        ),
        Settling::CannotSettle { slope, standard_error } => format!(
            "No spectrum can settle the area: {}, too flat for a limit; the area depends on the cutoff.",
            falls(slope, standard_error)
        ),
        Settling::Unknown => {
            "The short end of the spectrum has too few samples to tell whether shorter wavelengths would settle the area."
                .to_owned()
        }
    }
}
