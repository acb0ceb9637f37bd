//! What to measure next, in plain words.

use scene::Scene;
use uncertainty::{Advice, Settling, Step, StepKind, Uncertainty};
use units::display::{length, three_digits};

use crate::curve_names::in_full;
use crate::listing::number_word;
use crate::uncertainty_words::group_in_words;

/// A ratio this close to 1 is none.
const SAME: f64 = 0.005;

/// A standard error this small beside its value is that of arithmetic.
const NO_ERROR: f64 = 1e-9;

/// `Greenwood-Williamson (Hertz) at 5 MPa`: what the advice is for.
pub(crate) fn subject(advice: &Advice, scene: &Scene) -> String {
    format!("{} at {}", in_full(&scene.needs.curves[advice.curve]), scene.needs.loads[advice.load].label)
}

/// The step that shrinks the interval most, and whether the area can settle at all.
pub(crate) fn in_short(uncertainty: &Uncertainty, advice: &Advice, scene: &Scene) -> Vec<String> {
    let best = advice.steps.iter().find(|step| narrows(step));
    let best = best.map(|step| {
        format!("What to measure next, for {}: {}.", subject(advice, scene), in_a_line(uncertainty, step))
    });
    best.into_iter().chain([settling(advice)]).collect()
}

/// Whether a step is worth taking for the interval.
pub(crate) fn narrows(step: &Step) -> bool {
    step.width_ratio < 1.0 - SAME
}

/// A step and what it does: `three more AFM scans at other places narrow the interval to 74 % of its width`.
#[must_use]
pub fn in_a_line(uncertainty: &Uncertainty, step: &Step) -> String {
    let percent = three_digits((100.0 * step.width_ratio).round());
    let width = if narrows(step) {
        format!("the interval narrows to {percent} % of its width")
    } else if step.width_ratio > 1.0 + SAME {
        format!("the interval widens to {percent} % of its width")
    } else {
        "the interval stays as wide as it is".to_owned()
    };
    let area = if (step.area_ratio - 1.0).abs() > SAME {
        format!(", and the area is expected to become {} times what it is", three_digits(step.area_ratio))
    } else {
        String::new()
    };
    format!("{}: {width}{area}", step_in_words(uncertainty, &step.kind))
}

/// What could be measured.
pub(crate) fn step_in_words(uncertainty: &Uncertainty, kind: &StepKind) -> String {
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
        StepKind::KnownExactly { group } => format!("{} known exactly", group_in_words(*group, true)),
        StepKind::LongerWavelengths { to_m } => format!("wavelengths up to {}", length(*to_m)),
        StepKind::ShorterWavelengths { to_m } => format!("wavelengths down to {}", length(*to_m)),
        other => other.key().replace('-', " "),
    }
}

/// Whether more of the spectrum would settle the area.
pub(crate) fn settling(advice: &Advice) -> String {
    let falls = |slope: f64, standard_error: f64| {
        // That of a spectrum that was made as a power law is rounding.
        let is_known = standard_error > NO_ERROR * slope.abs();
        let error = is_known.then(|| format!(" (standard error {})", three_digits(standard_error)));
        let slope = three_digits(slope);
        format!(
            "at its short end the spectrum goes as wavevector to the power {slope}{}",
            error.unwrap_or_default()
        )
    };
    match advice.settling {
        Settling::HasSettled => "The area has settled: shorter wavelengths would not move it.".to_owned(),
        Settling::WillSettle { slope, standard_error } => format!(
            "A spectrum to shorter wavelengths would settle the area: {}, steep enough for a limit.",
            falls(slope, standard_error)
        ),
        Settling::CannotSettle { slope, standard_error } => format!(
            "No longer spectrum would settle the area: {}, too flat for a limit; the area is that of its cutoff.",
            falls(slope, standard_error)
        ),
        Settling::Unknown => {
            "Whether a longer spectrum would settle the area is not known: its short end has too few samples."
                .to_owned()
        }
    }
}
