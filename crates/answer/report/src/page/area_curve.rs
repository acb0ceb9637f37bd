//! The area against the cutoff under one load: every model, boundary elements with their errors, and holes of the spectrum.

use std::fmt::Write;

use drawings::model_style::ModelStyle;
use judge::Reference;
use maud::{Markup, PreEscaped, html};
use study::figure::pieces;
use units::display::length;
use units::printable::printable;

use super::SceneReport;
use super::axis::Axis;
use super::reading::{Reading, ReadingLine};
use crate::listing::{decade_name, share};

/// Size and margins in units of the drawing.
const WIDTH: f64 = 520.0;
const HEIGHT: f64 = 360.0;
const LEFT: f64 = 58.0;
const RIGHT: f64 = 26.0;
const TOP: f64 = 10.0;
const BOTTOM: f64 = 66.0;

/// Top and height of the strip of decisive scales, below the axis.
const STRIP_TOP: f64 = HEIGHT - BOTTOM + 22.0;
const STRIP_HEIGHT: f64 = 16.0;

/// The least width of a decade whose share is written into the strip.
const STRIP_TEXT: f64 = 26.0;

/// The room for the words beside a disc.
const KIND_WIDTH: f64 = 110.0;

/// The most points of a piece of a line.
const MAX_POINTS: usize = 90;

/// Draws the figure of a load; `None` if no curve was followed along the cutoff.
pub(super) fn figure(report: &SceneReport<'_>, load: usize, styles: &[ModelStyle]) -> Option<Markup> {
    let psd = &report.results.psd;
    let band_m = [psd.shortest_wavelength_m(), psd.longest_wavelength_m()];
    Some(AreaCurve::new(report, load, band_m)?.figure(styles))
}

/// The curves of a load on their axes.
pub(super) struct AreaCurve<'r, 's> {
    report: &'r SceneReport<'s>,
    load: usize,
    holes_m: Vec<(f64, f64)>,
    /// Wavelength \[m\] and area fraction along each curve, by its index.
    curves: Vec<(usize, Vec<(f64, f64)>)>,
    marks: Vec<ElementMark>,
    x: Axis,
    y: Axis,
}

impl<'r, 's> AreaCurve<'r, 's> {
    /// Takes the curves of a load, with an axis from one wavelength \[m\] to another; `None` if no curve was followed.
    pub fn new(report: &'r SceneReport<'s>, load: usize, [shortest_m, longest_m]: [f64; 2]) -> Option<Self> {
        let holes_m =
            report.scene.surface.holes().iter().map(|hole| (hole.shortest_m, hole.longest_m)).collect();
        let curves: Vec<(usize, Vec<(f64, f64)>)> = report
            .answers()
            .filter(|(_, answers)| answers.iter().any(|(at, answer)| *at == load && answer.followed))
            .map(|(curve, _)| (curve, report.results.curves[curve].area_fractions(load)))
            .collect();
        let marks = marks(report, load);
        let areas = curves
            .iter()
            .flat_map(|(_, points)| points.iter().map(|(_, area)| *area))
            .chain(marks.iter().map(|mark| mark.low));
        let least = areas.filter(|area| *area > 0.0).fold(1.0, f64::min);
        if curves.is_empty() || least >= 1.0 {
            return None;
        }
        let x = Axis { least: shortest_m, most: longest_m, start: LEFT, end: WIDTH - RIGHT };
        let floor = 10f64.powf((0.6 * least).log10().mul_add(2.0, 0.0).floor() / 2.0);
        let y = Axis { least: floor, most: 1.0, start: HEIGHT - BOTTOM, end: TOP };
        Some(AreaCurve { report, load, holes_m, curves, marks, x, y })
    }

    /// Draws the figure.
    pub fn figure(&self, styles: &[ModelStyle]) -> Markup {
        let AreaCurve { report, x, y, .. } = *self;
        let load = &report.scene.needs.loads[self.load].label;
        let label = format!("Contact area at {load} as finer roughness is included");
        html! {
            svg.area viewBox=(format!("0 0 {WIDTH} {HEIGHT}")) role="img" aria-label=(label) xmlns="http://www.w3.org/2000/svg" {
                (PreEscaped(background(report, x, y)))
                @for (curve, points) in &self.curves {
                    @let style = &styles[*curve];
                    g class=(format!("{} line", class(*curve))) style=(line_colours(style)) {
                        path d=(path(points, &self.holes_m, x, y)) stroke-dasharray=(style.dash) {}
                        title { (report.curve(*curve)) }
                    }
                }
                (PreEscaped(elements(&self.marks, x, y)))
                (PreEscaped(element_kinds(&self.marks)))
                (PreEscaped(strip(report, self.load, x)))
                (PreEscaped(labels(report, &self.curves, styles, x, y)))
            }
        }
    }

    /// The values along the curves, in print.
    pub fn reading(&self) -> Reading {
        let AreaCurve { report, x, y, .. } = *self;
        // Wavelengths rise from left to right, and curves run from long to short ones.
        let points = |points: &[(f64, f64)]| {
            let inside = points.iter().rev().filter(|(_, area)| *area >= y.least);
            inside
                .map(|(wavelength_m, area)| (x.place(*wavelength_m), y.place(*area), share(*area)))
                .collect()
        };
        let lines = self.curves.iter().map(|(curve, along)| ReadingLine {
            class: class(*curve),
            name: printable(&report.short_curve(*curve)).into_owned(),
            points: points(along),
        });
        let finest = self.curves.iter().map(|(_, along)| along).max_by_key(|along| along.len());
        let places = finest.into_iter().flatten().rev();
        Reading {
            frame: [LEFT, TOP, WIDTH - RIGHT, HEIGHT - BOTTOM],
            places: places.map(|(wavelength_m, _)| (x.place(*wavelength_m), length(*wavelength_m))).collect(),
            lines: lines.collect(),
        }
    }
}

/// The class of the elements of a curve.
fn class(curve: usize) -> String {
    format!("m{curve}")
}

/// Grey holes, grid lines and tick labels.
fn background(report: &SceneReport<'_>, x: Axis, y: Axis) -> String {
    let mut text = String::new();
    for hole in report.scene.surface.holes() {
        let (left, right) = (x.place(hole.shortest_m).max(LEFT), x.place(hole.longest_m).min(WIDTH - RIGHT));
        let _ = write!(
            text,
            "<rect class=\"hole\" x=\"{left:.1}\" y=\"{TOP}\" width=\"{:.1}\" height=\"{:.1}\"/><text class=\"quiet\" x=\"{:.1}\" \
             y=\"{:.1}\" text-anchor=\"middle\">not measured</text>",
            (right - left).max(0.0),
            HEIGHT - BOTTOM - TOP,
            0.5 * (left + right),
            TOP + 12.0
        );
    }
    for tick in y.ticks() {
        let place = y.place(tick);
        let _ = write!(
            text,
            "<path class=\"grid\" d=\"M{LEFT} {place:.1}H{:.1}\"/><text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
            WIDTH - RIGHT,
            LEFT - 5.0,
            place + 3.5,
            share(tick)
        );
    }
    for tick in x.ticks() {
        let place = x.place(tick);
        let _ = write!(
            text,
            "<path class=\"grid\" d=\"M{place:.1} {TOP}V{:.1}\"/><text x=\"{place:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>",
            HEIGHT - BOTTOM,
            HEIGHT - BOTTOM + 14.0,
            length(tick)
        );
    }
    let _ = write!(
        text,
        "<text class=\"quiet\" x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">shortest wavelength included (finer ←)</text>",
        WIDTH - RIGHT,
        HEIGHT - 8.0
    );
    text
}

/// The share of each decade in the answer, on the axis of wavelengths: that of the model nearest to the elements.
fn strip(report: &SceneReport<'_>, load: usize, x: Axis) -> String {
    let nearest =
        report.conclusions.loads.iter().find(|of| of.load == load).and_then(|of| of.nearest_curve());
    let answer = nearest.and_then(|curve| report.answer.curves[curve][load].as_ref());
    let Some(answer) = answer.filter(|answer| !answer.decades.is_empty()) else { return String::new() };
    let middle = STRIP_TOP + 0.5 * STRIP_HEIGHT + 4.0;
    let mut text =
        format!("<text x=\"{:.1}\" y=\"{middle:.1}\" text-anchor=\"end\">decides</text>", LEFT - 5.0);
    for decade in &answer.decades {
        let (left, right) = (x.place(decade.shortest_m).max(x.start), x.place(decade.longest_m).min(x.end));
        let percent = format!("{:.0} %", 100.0 * decade.share);
        let _ = write!(
            text,
            "<g class=\"share\"><rect x=\"{left:.1}\" y=\"{STRIP_TOP}\" width=\"{:.1}\" height=\"{STRIP_HEIGHT}\" \
             style=\"--share:{:.2}\"/><title>{} decides {percent}</title>",
            (right - left).max(0.0),
            decade.share.clamp(0.0, 1.0),
            decade_name(decade, &report.results.psd)
        );
        if right - left >= STRIP_TEXT {
            let _ = write!(
                text,
                "<text x=\"{:.1}\" y=\"{middle:.1}\" text-anchor=\"middle\">{percent}</text>",
                0.5 * (left + right)
            );
        }
        text += "</g>";
    }
    text
}

/// An area of boundary elements on the figure.
struct ElementMark {
    wavelength_m: f64,
    area_fraction: f64,
    low: f64,
    high: f64,
    reference: Reference,
}

/// The areas of the elements on each window, with the whole surface, and at the end of the spectrum.
fn marks(report: &SceneReport<'_>, load: usize) -> Vec<ElementMark> {
    let Some(judgement) = report.evidence.judgement else { return Vec::new() };
    let shortest_m = report.results.psd.shortest_wavelength_m();
    let whole = judgement
        .references
        .iter()
        .filter(|area| area.load == load)
        .filter_map(|area| Some((area.reference, shortest_m, area.elements?)));
    let on_windows = judgement.windows.iter().filter(|on| on.load == load && !on.is_whole_band);
    let on_windows = on_windows.filter_map(|on| {
        let reference = judgement.curves.iter().find(|curve| curve.curve == on.curve)?.reference;
        Some((reference, on.shortest_m, on.elements_of_whole?))
    });
    let mut marks: Vec<ElementMark> = Vec::new();
    for (reference, wavelength_m, elements) in whole.chain(on_windows) {
        let is_drawn = |mark: &ElementMark| {
            mark.reference == reference && (mark.wavelength_m / wavelength_m - 1.0).abs() < 0.01
        };
        // Curves of one body share their elements, and the last window ends where the spectrum does.
        if !marks.iter().any(is_drawn) {
            let (low, high) = (elements.low(), elements.high());
            marks.push(ElementMark {
                wavelength_m,
                area_fraction: elements.area_fraction,
                low,
                high,
                reference,
            });
        }
    }
    marks
}

fn elements(marks: &[ElementMark], x: Axis, y: Axis) -> String {
    let mut text = String::new();
    for mark in marks {
        let class = match mark.reference {
            Reference::Elastic => "elements",
            Reference::Yielding { .. } | Reference::Growing => "elements yielding",
        };
        let (across, up) = (x.place(mark.wavelength_m), y.place(mark.area_fraction));
        let _ = write!(
            text,
            "<g class=\"{class}\"><path d=\"M{across:.1} {:.1}V{:.1}\"/><circle cx=\"{across:.1}\" cy=\"{up:.1}\" r=\"3.5\"/>\
             <title>boundary elements, {}: {}</title></g>",
            y.place(mark.low.max(y.least)),
            y.place(mark.high),
            mark.reference.name(),
            share(mark.area_fraction)
        );
    }
    text
}

/// The kinds of elements that are drawn, each with its disc or ring.
fn element_kinds(marks: &[ElementMark]) -> String {
    let mut text = String::new();
    let mut across = LEFT + 4.0;
    let up = HEIGHT - 12.0;
    for (yields, words) in [(false, "elastic elements"), (true, "yielding")] {
        if marks.iter().any(|mark| (mark.reference != Reference::Elastic) == yields) {
            let class = if yields { "elements yielding" } else { "elements" };
            let _ = write!(
                text,
                "<g class=\"{class}\"><circle cx=\"{across}\" cy=\"{up}\" r=\"3.5\"/></g>\
                 <text class=\"quiet\" x=\"{}\" y=\"{}\">{words}</text>",
                across + 8.0,
                up + 4.0
            );
            across += 8.0 + KIND_WIDTH;
        }
    }
    text
}

/// The colours of a model's lines on light and dark pages, as variables of the style sheet.
pub(super) fn line_colours(style: &ModelStyle) -> String {
    format!("--light:{};--dark:{}", style.colour, style.dark_colour)
}

/// The names of the models at the short ends of their lines, moved apart.
fn labels(
    report: &SceneReport<'_>,
    curves: &[(usize, Vec<(f64, f64)>)],
    styles: &[ModelStyle],
    x: Axis,
    y: Axis,
) -> String {
    let mut text = String::new();
    for (curve, points) in curves {
        let Some((wavelength_m, area)) = points.last() else { continue };
        let name = html! { (report.short_curve(*curve)) }.into_string();
        let _ = write!(
            text,
            "<text class=\"m{curve} line name\" x=\"{:.1}\" y=\"{:.1}\" style=\"{}\">{name}</text>",
            x.place(*wavelength_m) + 6.0,
            (y.place(*area) + 14.0).min(HEIGHT - BOTTOM - 3.0),
            line_colours(&styles[*curve])
        );
    }
    text
}

/// A path along the points that breaks at holes.
fn path(points: &[(f64, f64)], holes: &[(f64, f64)], x: Axis, y: Axis) -> String {
    let mut text = String::new();
    for piece in pieces(points, holes) {
        for (at, (wavelength_m, area)) in thinned(piece).into_iter().enumerate() {
            let command = if at == 0 { 'M' } else { 'L' };
            let _ = write!(text, "{command}{:.1} {:.1}", x.place(wavelength_m), y.place(area.max(y.least)));
        }
    }
    text
}

/// Every point, or evenly chosen ones with both ends.
fn thinned(points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    if points.len() <= MAX_POINTS {
        return points;
    }
    let last = points.len() - 1;
    (0..MAX_POINTS).map(|at| points[at * last / (MAX_POINTS - 1)]).collect()
}
