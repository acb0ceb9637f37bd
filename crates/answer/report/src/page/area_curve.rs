//! The area against the cutoff under one load: every model, boundary elements with their errors, and holes of the spectrum.

use conclusions::{AnswerUnderLoad, foremost};
use maud::{Markup, PreEscaped, html};
use study::figure::{Mark, pieces};
use units::display::{length, typeset};
use units::printable::printable;

use super::SceneReport;
use super::range_bar::LINEAR_FROM;
use super::reading::{Reading, ReadingLine};
use crate::chart::canvas::{Anchor, Canvas, Point, Rect, Stroke, disc, text_width_px, thinned};
use crate::chart::labels::{self, Track};
use crate::chart::palette::{self, ModelStyle, NEUTRAL, variables};
use crate::chart::ruler::{Ruler, TickWords, floor_below};
use crate::judged::element_marks;
use crate::listing::{decade_name, share};

/// Size and frame in units of the drawing.
const WIDTH: f64 = 520.0;
const HEIGHT: f64 = 360.0;
const FRAME: Rect = Rect { left: 58.0, top: 10.0, right: WIDTH - 26.0, bottom: HEIGHT - 66.0 };

/// Top and height of the strip of decisive scales, below the axis.
const STRIP_TOP: f64 = FRAME.bottom + 23.0;
const STRIP_HEIGHT: f64 = 16.0;

/// The least width of a decade whose share is written into the strip.
const STRIP_TEXT: f64 = 26.0;

/// The size of letters.
const LETTERS: f64 = 11.0;

/// The size of the names of models, which are bold.
const NAMES: f64 = 14.0;

/// The most names below each other.
const MOST_NAMES: u32 = 4;

/// The room for the words beside a disc.
const KIND_WIDTH: f64 = 110.0;

/// The most points of a piece of a line.
const MOST_POINTS: usize = 160;

/// Draws the figure of a load below its title; `None` if no curve was followed along the cutoff.
pub(super) fn figure(report: &SceneReport<'_>, load: usize, styles: &[ModelStyle]) -> Option<Markup> {
    let psd = &report.results.psd;
    let band_m = [psd.shortest_wavelength_m(), psd.longest_wavelength_m()];
    let curve = AreaCurve::new(report, load, band_m)?;
    Some(html! { h3 { (typeset(&curve.title())) } (curve.figure(styles)) })
}

/// The curves of a load on their axes.
pub(super) struct AreaCurve<'r, 's> {
    report: &'r SceneReport<'s>,
    load: usize,
    holes_m: Vec<(f64, f64)>,
    /// Wavelength \[m\] and area fraction along each curve, by its index.
    curves: Vec<(usize, Vec<(f64, f64)>)>,
    marks: Vec<Mark>,
    /// The smallest area on the axis.
    floor: f64,
    axes: Canvas,
}

impl<'r, 's> AreaCurve<'r, 's> {
    /// Takes the curves of a load, with an axis from one wavelength \[m\] to another; `None` if no curve was followed.
    pub fn new(report: &'r SceneReport<'s>, load: usize, band_m: [f64; 2]) -> Option<Self> {
        let holes_m =
            report.scene.surface.holes.iter().map(|hole| (hole.shortest_m, hole.longest_m)).collect();
        let curves: Vec<(usize, Vec<(f64, f64)>)> = report
            .answers()
            .filter(|(_, answers)| answers.iter().any(|(at, answer)| *at == load && answer.followed))
            .map(|(curve, _)| (curve, report.results.curves[curve].area_fractions(load)))
            .collect();
        let shortest_m = report.results.psd.shortest_wavelength_m();
        let judgement = report.evidence.judgement;
        let marks = judgement.map_or_else(Vec::new, |found| element_marks(found, load, shortest_m));
        let areas = curves
            .iter()
            .flat_map(|(_, points)| points.iter().map(|(_, area)| *area))
            .chain(marks.iter().map(|mark| mark.low));
        let least = areas.filter(|area| *area > 0.0).fold(1.0, f64::min);
        if curves.is_empty() || least >= 1.0 {
            return None;
        }
        let of_load = report.conclusions.loads.iter().find(|of| of.load == load);
        let is_linear = of_load.is_some_and(|of| of.area.low > LINEAR_FROM);
        let x = Ruler::tight(band_m, TickWords::Length);
        let (floor, y) = match is_linear {
            true => (0.0, Ruler::steps([0.0, 1.0].into_iter(), TickWords::Share, "", 5.0)),
            false => (floor_below(least), Ruler::tight([floor_below(least), 1.0], TickWords::Share)),
        };
        Some(AreaCurve { report, load, holes_m, curves, marks, floor, axes: Canvas::new(x, y, FRAME) })
    }

    /// States what the figure shows: without which waves twice as much would touch, by the model nearest to the elements.
    pub fn title(&self) -> String {
        let load = self.report.conclusions.loads.iter().find(|of| of.load == self.load);
        let nearest = load.and_then(AnswerUnderLoad::nearest_curve);
        let along = self.curves.iter().find(|(curve, _)| Some(*curve) == nearest);
        let finding = along.and_then(|(_, points)| doubled_from_m(points)).map_or_else(
            || "Contact area as finer roughness is included".to_owned(),
            |from_m| format!("Without waves shorter than {} twice as much would touch", length(from_m)),
        );
        format!("{finding}, at {}", self.report.scene.needs.loads[self.load].label)
    }

    /// Draws the figure.
    pub fn figure(&self, styles: &[ModelStyle]) -> Markup {
        let report = self.report;
        let load = &report.scene.needs.loads[self.load].label;
        let label = format!("Contact area at {load} as finer roughness is included");
        let mut canvas = self.axes.clone();
        for (shortest_m, longest_m) in &self.holes_m {
            let hole = canvas.hole(*shortest_m, *longest_m);
            let middle = (0.5 * (hole.left + hole.right), hole.top + 12.0);
            canvas.text(middle, Anchor::Middle, LETTERS, "not measured");
        }
        canvas.grid();
        canvas.tick_labels();
        canvas.text(
            (FRAME.right, HEIGHT - 8.0),
            Anchor::End,
            LETTERS,
            "shortest wavelength included (finer ←)",
        );
        for (curve, points) in &self.curves {
            let ModelStyle { colour, dark_colour, dash } = &styles[*curve];
            let look =
                format!("class=\"{} line\" style=\"{}\"", class(*curve), variables(colour, dark_colour));
            canvas.group(&look, &report.curve(*curve), |canvas| {
                for piece in pieces(points, &self.holes_m) {
                    let places = piece.iter().map(|(wavelength_m, area)| self.place(*wavelength_m, *area));
                    let run = thinned(places.collect(), MOST_POINTS);
                    canvas.line(&run, Stroke { colour, width_px: 2.0, dash });
                }
            });
        }
        self.elements(&mut canvas);
        self.strip(&mut canvas);
        self.names(&mut canvas, styles);
        html! {
            svg.area viewBox=(format!("0 0 {WIDTH} {HEIGHT}")) role="img" aria-label=(label) xmlns="http://www.w3.org/2000/svg" {
                (PreEscaped(canvas.svg))
            }
        }
    }

    /// The values along the curves, in print.
    pub fn reading(&self) -> Reading {
        // Wavelengths rise from left to right, and curves run from long to short ones.
        let points = |points: &[(f64, f64)]| {
            let inside = points.iter().rev().filter(|(_, area)| *area >= self.floor);
            let value = |(wavelength_m, area): &(f64, f64)| {
                let (x, y) = self.place(*wavelength_m, *area);
                (x, y, share(*area))
            };
            inside.map(value).collect()
        };
        let lines = self.curves.iter().map(|(curve, along)| ReadingLine {
            class: class(*curve),
            name: printable(&self.report.short_curve(*curve)).into_owned(),
            points: points(along),
        });
        let finest = self.curves.iter().map(|(_, along)| along).max_by_key(|along| along.len());
        let places = finest.into_iter().flatten().rev();
        let place =
            |(wavelength_m, area): &(f64, f64)| (self.place(*wavelength_m, *area).0, length(*wavelength_m));
        let Rect { left, top, right, bottom } = FRAME;
        Reading {
            frame: [left, top, right, bottom],
            places: places.map(place).collect(),
            lines: lines.collect(),
        }
    }

    /// The place of an area, which lies no lower than the axis.
    fn place(&self, wavelength_m: f64, area: f64) -> Point {
        (self.axes.x.px_or_first(wavelength_m), self.axes.y.px_or_first(area.max(self.floor)))
    }

    /// Draws the areas of the elements with their errors, and the kinds of elements below.
    fn elements(&self, canvas: &mut Canvas) {
        let black = palette::colour(NEUTRAL);
        let class = |yields| if yields { "class=\"elements yielding\"" } else { "class=\"elements\"" };
        for Mark { label, is_ring, x, y, low, high, .. } in &self.marks {
            canvas.group(class(*is_ring), &format!("{label}: {}", share(*y)), |canvas| {
                let _ = canvas.mark(*x, [low.max(self.floor), *y, *high], &black, *is_ring);
            });
        }
        let mut across = FRAME.left + 4.0;
        for (yields, words) in [(false, "elastic elements"), (true, "yielding")] {
            if self.marks.iter().any(|mark| mark.is_ring == yields) {
                let at = (across, HEIGHT - 12.0);
                canvas.group(class(yields), words, |canvas| canvas.svg += &disc(at, &black, yields));
                canvas.text((across + 8.0, HEIGHT - 8.0), Anchor::Start, LETTERS, words);
                across += 8.0 + KIND_WIDTH;
            }
        }
    }

    /// Draws the share of each decade in the answer, on the axis of wavelengths: that of the model nearest to the elements.
    fn strip(&self, canvas: &mut Canvas) {
        let (report, load) = (self.report, self.load);
        let mut loads = report.conclusions.loads.iter();
        let own = loads.find(|of| of.load == load && of.cause.has_scales());
        let nearest = own.and_then(|of| of.nearest_curve());
        let answer = nearest.and_then(|curve| report.answer.curves[curve][load].as_ref());
        let Some(answer) = answer.filter(|answer| !answer.decades.is_empty()) else { return };
        let middle = STRIP_TOP + 0.5 * STRIP_HEIGHT + 4.0;
        canvas.text((FRAME.left - 5.0, middle), Anchor::End, LETTERS, "lost on");
        for decade in &answer.decades {
            let [left, right] =
                [decade.shortest_m, decade.longest_m].map(|edge_m| canvas.x.px_within(edge_m));
            let percent = format!("{:.0} %", 100.0 * decade.share);
            let words = format!("{} decides {percent}", decade_name(decade, &report.results.psd));
            canvas.group("class=\"share\"", &words, |canvas| {
                let place = Rect { left, top: STRIP_TOP, right, bottom: STRIP_TOP + STRIP_HEIGHT };
                canvas.rect(place, &format!("style=\"--share:{:.2}\"", decade.share.clamp(0.0, 1.0)));
                if right - left >= STRIP_TEXT {
                    canvas.text((0.5 * (left + right), middle), Anchor::Middle, 10.0, &percent);
                }
            });
        }
    }

    /// Writes the names of the models: of the lines that are drawn at first where nothing is in the way, else at their short ends.
    fn names(&self, canvas: &mut Canvas, styles: &[ModelStyle]) {
        let first = drawn_at_first(&self.report.conclusions.loads);
        let track = |(curve, points): &(usize, Vec<(f64, f64)>)| Track {
            label: self.report.short_curve(*curve),
            group: *curve,
            points: points.iter().map(|(wavelength_m, area)| self.place(*wavelength_m, *area)).collect(),
        };
        let tracks: Vec<Track> =
            self.curves.iter().filter(|(curve, _)| first.contains(curve)).map(track).collect();
        let placed = labels::place(&tracks, FRAME, NAMES);
        let mut taken: Vec<Rect> = placed.iter().map(|label| label.place).collect();
        for (curve, points) in &self.curves {
            let Some((wavelength_m, area)) = points.last() else { continue };
            let (x, y) = self.place(*wavelength_m, *area);
            let name = self.report.short_curve(*curve);
            let below = |lines: u32| {
                let (left, bottom) = (x + 6.0, (y + f64::from(1 + lines) * NAMES).min(FRAME.bottom - 3.0));
                Rect { left, top: bottom - NAMES, right: left + text_width_px(&name, NAMES), bottom }
            };
            // Names of lines that nobody ticked yet may overlap.
            let is_drawn = first.contains(curve);
            let is_free = |place: &Rect| !is_drawn || !taken.iter().any(|other| place.overlaps(other));
            let own = placed.iter().find(|label| label.group == *curve).map(|label| label.place);
            let place = own.or_else(|| (0..MOST_NAMES).map(below).find(is_free)).unwrap_or_else(|| below(0));
            taken.extend(is_drawn.then_some(place));
            let at = (place.left, place.bottom - 3.0);
            let ModelStyle { colour, dark_colour, .. } = &styles[*curve];
            let look =
                format!("class=\"{} line name\" style=\"{}\"", class(*curve), variables(colour, dark_colour));
            canvas.styled_text(at, Anchor::Start, &look, &name);
        }
    }
}

/// The models whose lines are drawn before anybody ticks one: the nearest of each group.
pub(super) fn drawn_at_first(loads: &[AnswerUnderLoad]) -> Vec<usize> {
    let Some(load) = foremost(loads) else { return Vec::new() };
    let nearest = load.references.iter().filter_map(|group| group.models.first()).map(|cell| cell.curve);
    nearest.chain(load.best_model.map(|cell| cell.curve)).collect()
}

/// Finds the wavelength \[m\] down to which waves leave twice the area of all, along points from long to short ones; `None` if nothing or
/// more than half touches.
fn doubled_from_m(points: &[(f64, f64)]) -> Option<f64> {
    let doubled = 2.0 * points.last()?.1;
    let before = points.iter().rposition(|(_, area)| *area >= doubled)?;
    let [(longer_m, larger), (shorter_m, smaller)] = [points[before], *points.get(before + 1)?];
    let part = (larger / doubled).ln() / (larger / smaller).ln();
    (doubled > 0.0).then(|| longer_m * (shorter_m / longer_m).powf(part))
}

/// The class of the elements of a curve.
fn class(curve: usize) -> String {
    format!("m{curve}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_waves_that_halve_the_area_lie_between_points() {
        // 0.2 on a straight line in logarithms from 0.4 at 4 um to 0.1 at 1 um.
        let points = [(1e-4, 1.0), (4e-6, 0.4), (1e-6, 0.1)];
        assert!((doubled_from_m(&points).unwrap() / 2e-6 - 1.0).abs() < 1e-12);
        assert_eq!(doubled_from_m(&[(1e-4, 1.0), (1e-6, 0.6)]), None);
        assert_eq!(doubled_from_m(&[(1e-4, 1.0), (1e-6, 0.0)]), None);
        assert_eq!(doubled_from_m(&[]), None);
    }
}
