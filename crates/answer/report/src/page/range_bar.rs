//! The range of an area as a bar: the best estimate as a disc, models as ticks.

use std::fmt::Write;

use conclusions::{AnswerUnderLoad, Source};
use judge::{Reference, Verdict};
use maud::{Markup, PreEscaped};
use study::interface::Seal;

use super::SceneReport;
use crate::chart::canvas::escaped;
use crate::chart::palette::{ModelStyle, variables};
use crate::listing::{share, share_range};

const WIDTH_PX: f64 = 190.0;
const HEIGHT_PX: f64 = 58.0;
/// The distance of the axis from the upper edge, and of the bar's edges.
const AXIS_PX: f64 = 40.0;
const BAR_PX: [f64; 2] = [22.0, 34.0];
const MARK_PX: f64 = 12.0;
/// Room for half a label at either end.
const MARGIN_PX: f64 = 18.0;
/// The least distance between labels.
const APART_PX: f64 = 48.0;
/// Models within this factor of the range are drawn.
const NEAR: f64 = 5.0;
/// Room beyond the outermost mark, as a factor.
const ROOM: f64 = 1.15;
/// Ranges from this share of the surface on have a linear axis.
pub(super) const LINEAR_FROM: f64 = 0.2;

/// The axis of a bar.
struct Axis {
    low: f64,
    high: f64,
    is_linear: bool,
}

impl Axis {
    fn over(low: f64, high: f64, marks: &[f64]) -> Self {
        if low >= LINEAR_FROM {
            return Axis { low: 0.0, high: 1.0, is_linear: true };
        }
        let near = || marks.iter().copied().filter(|mark| (low / NEAR..=high * NEAR).contains(mark));
        Axis {
            low: near().fold(low, f64::min) / ROOM,
            high: (near().fold(high, f64::max) * ROOM).min(1.0),
            is_linear: false,
        }
    }

    /// The place of an area fraction; `None` beyond the ends.
    fn place(&self, area_fraction: f64) -> Option<f64> {
        let part = match self.is_linear {
            true => (area_fraction - self.low) / (self.high - self.low),
            false => (area_fraction / self.low).ln() / (self.high / self.low).ln(),
        };
        (0.0..=1.0).contains(&part).then_some(MARGIN_PX + part * (WIDTH_PX - 2.0 * MARGIN_PX))
    }

    /// Round area fractions, with their places, as many as have room for a label.
    fn ticks(&self) -> Vec<(f64, f64)> {
        let candidates: Vec<f64> = match self.is_linear {
            true => (0..=4).map(|quarter| 0.25 * f64::from(quarter)).collect(),
            false => {
                let decades = self.low.log10().floor() as i32..=self.high.log10().ceil() as i32;
                // One number alone tells no scale: shorter axes than five times may hold one of the roundest only.
                let is_long = self.high / self.low > 5.0;
                let round: &[f64] =
                    if is_long { &[1.0, 2.0, 5.0] } else { &[1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0] };
                decades.flat_map(|power| round.iter().map(move |step| step * 10f64.powi(power))).collect()
            }
        };
        let mut ticks: Vec<(f64, f64)> = Vec::new();
        for area_fraction in candidates {
            let Some(x) = self.place(area_fraction) else { continue };
            if ticks.last().is_none_or(|(_, last)| x - last >= APART_PX) {
                ticks.push((area_fraction, x));
            }
        }
        ticks
    }
}

/// Draws the range of a load.
pub(super) fn range_bar(report: &SceneReport<'_>, load: &AnswerUnderLoad, styles: &[ModelStyle]) -> Markup {
    let area = &load.area;
    let models: Vec<(usize, f64)> = load
        .references
        .first()
        .into_iter()
        .flat_map(|group| &group.models)
        .filter(|cell| cell.verdict != Verdict::OutOfRange)
        .filter_map(|cell| Some((cell.curve, cell.area_fraction?)))
        .collect();
    let flowed = match area.source {
        Source::Elements(Reference::Yielding { hardness_pa }) => {
            Some((load.nominal_pressure_pa / hardness_pa, "p/H"))
        }
        _ => None,
    };
    let seal = report.scene.interface.as_ref().and_then(|request| request.seal.as_ref());
    let closes = |seal: &Seal| (seal.threshold.area_fraction(), "seals");
    let marks: Vec<(f64, &str)> = flowed.into_iter().chain(seal.map(closes)).collect();
    let values: Vec<f64> =
        models.iter().map(|(_, value)| *value).chain(marks.iter().map(|(value, _)| *value)).collect();
    let axis = Axis::over(area.low, area.high, &values);
    let mut drawn = String::new();
    let [left, right] = [MARGIN_PX, WIDTH_PX - MARGIN_PX];
    let _ = write!(drawn, "<path class=\"axis\" d=\"M{left} {AXIS_PX}H{right}\"/>");
    for (value, x) in axis.ticks() {
        let _ = write!(
            drawn,
            "<path class=\"axis\" d=\"M{x:.1} {AXIS_PX}v3\"/><text x=\"{x:.1}\" y=\"{}\">{}</text>",
            HEIGHT_PX - 3.0,
            if value == 0.0 { "0".to_owned() } else { escaped(&share(value)) }
        );
    }
    let mut seen: Vec<(f64, &str)> =
        marks.into_iter().filter_map(|(value, name)| Some((axis.place(value)?, name))).collect();
    seen.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (at, (x, name)) in seen.iter().enumerate() {
        // Two names turn away from each other.
        let anchor = match (seen.len(), at) {
            (1, _) => "middle",
            (_, 0) => "end",
            _ => "start",
        };
        let _ = write!(
            drawn,
            "<path class=\"mark\" d=\"M{x:.1} {MARK_PX}V{AXIS_PX}\"/><text x=\"{x:.1}\" y=\"10\" style=\"text-anchor:{anchor}\">{name}</text>"
        );
    }
    let [top, bottom] = BAR_PX;
    if let [Some(low), Some(high)] = [area.low, area.high].map(|end| axis.place(end)) {
        let width = (high - low).max(2.0);
        let _ = write!(
            drawn,
            "<rect class=\"range\" x=\"{low:.1}\" y=\"{top}\" width=\"{width:.1}\" height=\"{}\" rx=\"3\"/>",
            bottom - top
        );
    }
    for (curve, value) in models {
        if let Some(x) = axis.place(value) {
            let style = &styles[curve];
            let _ = write!(
                drawn,
                "<path class=\"line\" style=\"{}\" d=\"M{x:.1} {}v8\"><title>{}: {}</title></path>",
                variables(style.colour, style.dark_colour),
                AXIS_PX - 4.0,
                escaped(&report.short_curve(curve)),
                escaped(&share(value))
            );
        }
    }
    if let Some(x) = area.area_fraction.and_then(|best| axis.place(best)) {
        let _ = write!(drawn, "<circle cx=\"{x:.1}\" cy=\"{}\" r=\"5\"/>", 0.5 * (top + bottom));
    }
    PreEscaped(format!(
        "<svg class=\"range-bar\" xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"Range {}\" viewBox=\"0 0 {WIDTH_PX} \
         {HEIGHT_PX}\">{drawn}</svg>",
        escaped(&share_range(area.low, area.high))
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_span_the_range_and_what_lies_near_it() {
        let axis = Axis::over(0.01, 0.02, &[0.05, 0.5, 0.001]);
        assert!(
            (axis.low * ROOM / 0.01 - 1.0).abs() < 1e-12 && (axis.high / ROOM / 0.05 - 1.0).abs() < 1e-12
        );
        let middle = axis.place((axis.low * axis.high).sqrt()).unwrap();
        assert!((middle - 0.5 * WIDTH_PX).abs() < 1e-9);
        assert_eq!((axis.place(0.5), axis.place(0.001)), (None, None));
        assert!(Axis::over(0.1, 0.15, &[0.6]).high <= 0.15 * NEAR * ROOM);
        assert_eq!(Axis::over(0.15, 0.19, &[0.9]).high, 1.0);
    }

    #[test]
    fn large_areas_have_a_linear_axis() {
        let axis = Axis::over(0.3, 0.5, &[0.01]);
        assert_eq!(axis.place(0.0), Some(MARGIN_PX));
        assert!((axis.place(0.25).unwrap() - MARGIN_PX - 0.25 * (WIDTH_PX - 2.0 * MARGIN_PX)).abs() < 1e-9);
        let values: Vec<f64> = axis.ticks().into_iter().map(|(value, _)| value).collect();
        assert_eq!(values, [0.0, 0.5, 1.0]);
    }

    #[test]
    fn ticks_are_round_and_have_room() {
        let narrow = Axis::over(0.0027, 0.0033, &[]).ticks();
        assert!(
            narrow.len() > 1 && narrow.iter().any(|(value, _)| (value * 1e3 - 3.0).abs() < 1e-9),
            "{narrow:?}"
        );
        let ticks = Axis::over(0.0011, 0.009, &[]).ticks();
        let values: Vec<f64> = ticks.iter().map(|(value, _)| value * 1e3).collect();
        assert!(
            values.iter().all(|value| [1.0, 2.0, 5.0, 10.0].iter().any(|round| (value - round).abs() < 1e-9)),
            "{values:?}"
        );
        assert!(ticks.len() >= 2 && ticks.windows(2).all(|pair| pair[1].1 - pair[0].1 >= APART_PX));
    }
}
