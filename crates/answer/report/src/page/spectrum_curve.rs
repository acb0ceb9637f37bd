//! The spectrum of a surface over those of its scans: wavevectors below, wavelengths above, the trusted band of each scan
//! with its limit, and holes in grey.

use std::f64::consts::TAU;
use std::fmt::Write;

use maud::{Markup, PreEscaped, html};
use serde::Serialize;
use spectrum::ProfilePsd;
use study::figure::pieces;
use study::surface::Surface;
use topography::{BinMean, DEFAULT_BINS_PER_DECADE, ScanSpectrum, log_binned};
use units::display::{length, power_of_ten, typeset_digits};
use units::printable::printable;

use super::axis::Axis;
use super::reading::{Reading, ReadingLine};
use crate::scan_words::band_end;

/// Width, height of the frame, and margins in units of the drawing.
const WIDTH: f64 = 560.0;
const FRAME: f64 = 270.0;
const LEFT: f64 = 50.0;
const RIGHT: f64 = 18.0;
const TOP: f64 = 42.0;
const BELOW: f64 = 44.0;

/// The height of the row of a scan below the axis, and the most rows.
const ROW: f64 = 18.0;
const MOST_ROWS: usize = 12;

/// Colours of scans on white and on a dark page; further scans begin again.
const COLOURS: [[&str; 2]; 5] = [
    ["#0072b2", "#5aa9e6"],
    ["#b4530a", "#f0883e"],
    ["#0b7a5a", "#3fbf8f"],
    ["#a6438c", "#e58ac8"],
    ["#7a6200", "#d4b833"],
];

/// The class of the line of the whole surface.
const COMPOSITE: &str = "composite";

/// The figure of a spectrum with its values.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SpectrumCurve {
    /// The figure, as SVG.
    pub figure: String,
    /// The values along its lines.
    pub reading: Reading,
}

/// A line of the figure: wavevector \[rad/m\] and spectrum \[m^3\], rising.
type Line = Vec<(f64, f64)>;

/// A scan on the figure.
struct Scan<'s> {
    name: String,
    spectrum: &'s ScanSpectrum,
    whole: Line,
    trusted: Line,
}

impl SpectrumCurve {
    /// Draws the spectrum of a surface.
    #[must_use]
    pub fn new(surface: &Surface) -> Self {
        let drawing = Drawing::new(surface);
        SpectrumCurve { figure: drawing.figure().into_string(), reading: drawing.reading() }
    }
}

struct Drawing<'s> {
    /// Wavevectors of the ends of holes \[rad/m\].
    holes: Vec<(f64, f64)>,
    composite: Line,
    scans: Vec<Scan<'s>>,
    x: Axis,
    y: Axis,
}

impl<'s> Drawing<'s> {
    fn new(surface: &'s Surface) -> Self {
        let composite = line(&surface.psd);
        let scans: Vec<Scan<'_>> = surface
            .each()
            .iter()
            .filter_map(|part| part.made_from.as_ref())
            .flat_map(|made_from| made_from.spectrum.scans.iter().zip(made_from.spectrum.series_names()))
            .map(|(spectrum, name)| Scan {
                name: printable(&name).into_owned(),
                spectrum,
                whole: whole(spectrum),
                trusted: line(&log_binned(&spectrum.reliable, DEFAULT_BINS_PER_DECADE, BinMean::Arithmetic)),
            })
            .collect();
        let holes =
            surface.holes().iter().map(|hole| (TAU / hole.longest_m, TAU / hole.shortest_m)).collect();
        let points =
            || scans.iter().flat_map(|scan| scan.whole.iter().chain(&scan.trusted)).chain(&composite);
        let range = |of: fn(&(f64, f64)) -> f64| {
            points().map(of).fold((f64::INFINITY, 0.0), |(least, most): (f64, f64), value| {
                (least.min(value), most.max(value))
            })
        };
        let ((q_least, q_most), (least, most)) = (range(|point| point.0), range(|point| point.1));
        let x = Axis { least: q_least / 1.05, most: q_most * 1.05, start: LEFT, end: WIDTH - RIGHT };
        let y = Axis { least: 0.5 * least, most: 2.0 * most, start: TOP + FRAME, end: TOP };
        Drawing { holes, composite, scans, x, y }
    }

    fn figure(&self) -> Markup {
        let rows = self.scans.len().min(MOST_ROWS);
        let height = TOP + FRAME + BELOW + ROW * rows as f64;
        html! {
            svg.area.spectrum viewBox=(format!("0 0 {WIDTH} {height}")) role="img" xmlns="http://www.w3.org/2000/svg"
                aria-label="Power spectrum of profiles against wavevector, with wavelengths above" {
                (PreEscaped(self.background()))
                @for (at, scan) in self.scans.iter().enumerate() {
                    g class=(format!("{} line", class(at))) style=(colours(at)) {
                        path.untrusted d=(self.path(&scan.whole)) {}
                        path d=(self.path(&scan.trusted)) {}
                        title { (scan.name) }
                    }
                }
                g.composite.line {
                    @for piece in pieces(&self.composite, &self.holes) { path d=(self.path(&piece)) {} }
                    title { "whole surface" }
                }
                @for at in 0..rows { (self.row(at)) }
                @if rows < self.scans.len() {
                    text.quiet x=(WIDTH - RIGHT) y=(height - 2.0) text-anchor="end" { "and " (self.scans.len() - rows) " more" }
                }
            }
        }
    }

    /// Grey holes, grid lines, and the labels of three axes.
    fn background(&self) -> String {
        let (x, y, bottom, right) = (self.x, self.y, TOP + FRAME, WIDTH - RIGHT);
        let mut text = String::new();
        for (from, to) in &self.holes {
            let (left, width) = (x.place(*from), x.place(*to) - x.place(*from));
            let _ = write!(
                text,
                "<rect class=\"hole\" x=\"{left:.1}\" y=\"{TOP}\" width=\"{width:.1}\" height=\"{FRAME}\"/>\
                 <text class=\"quiet\" x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">not measured</text>",
                left + 0.5 * width,
                TOP + 14.0
            );
        }
        for power in y.powers() {
            let place = y.place(10f64.powi(power));
            let _ = write!(
                text,
                "<path class=\"grid\" d=\"M{LEFT} {place:.1}H{right:.1}\"/><text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
                LEFT - 5.0,
                place + 3.5,
                power_of_ten(power)
            );
        }
        for power in x.powers() {
            let place = x.place(10f64.powi(power));
            let _ = write!(
                text,
                "<path class=\"grid\" d=\"M{place:.1} {TOP}V{bottom}\"/><text x=\"{place:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>",
                bottom + 14.0,
                power_of_ten(power)
            );
        }
        let wavelengths = Axis { least: TAU / x.most, most: TAU / x.least, start: x.end, end: x.start };
        for tick in wavelengths.ticks() {
            let place = wavelengths.place(tick);
            let _ = write!(
                text,
                "<path class=\"tick\" d=\"M{place:.1} {TOP}v-4\"/><text x=\"{place:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>",
                TOP - 8.0,
                length(tick)
            );
        }
        let _ = write!(
            text,
            "<rect class=\"frame\" x=\"{LEFT}\" y=\"{TOP}\" width=\"{:.1}\" height=\"{FRAME}\"/>\
             <text class=\"quiet\" x=\"{right:.1}\" y=\"12\" text-anchor=\"end\">wavelength</text>\
             <text class=\"quiet\" x=\"{right:.1}\" y=\"{:.1}\" text-anchor=\"end\">wavevector (rad/m)</text>\
             <text class=\"quiet\" x=\"{LEFT}\" y=\"12\">C1D (m³)</text>",
            right - LEFT,
            bottom + 29.0
        );
        text
    }

    /// The trusted band of a scan as a bar below the axis, with its name and the limit of its short end.
    fn row(&self, at: usize) -> Markup {
        let scan = &self.scans[at];
        let reliable = &scan.spectrum.reliable;
        let (longest_m, shortest_m) = (reliable.longest_wavelength_m(), reliable.shortest_wavelength_m());
        let [from, to] = [longest_m, shortest_m].map(|wavelength_m| self.x.place(TAU / wavelength_m));
        let middle = TOP + FRAME + BELOW + ROW * (at as f64 + 0.5) - 3.0;
        let words = format!(
            "{}: {} to {}, ends at {}",
            scan.name,
            length(longest_m),
            length(shortest_m),
            band_end(&scan.spectrum.band_end)
        );
        // Words begin on the side that has more room.
        let is_early = 0.5 * (from + to) < 0.5 * (LEFT + WIDTH - RIGHT);
        let (place, anchor) = if is_early { (LEFT.max(from), "start") } else { (to, "end") };
        html! {
            g class=(format!("{} line band", class(at))) style=(colours(at)) {
                path d=(format!("M{from:.1} {middle:.1}H{to:.1}")) {}
                text.name x=(format!("{place:.1}")) y=(format!("{:.1}", middle - 6.0)) text-anchor=(anchor) { (words) }
            }
        }
    }

    fn path(&self, points: &[(f64, f64)]) -> String {
        let step = |(at, (q, c1d_m3)): (usize, &(f64, f64))| {
            let command = if at == 0 { 'M' } else { 'L' };
            format!("{command}{:.1} {:.1}", self.x.place(*q), self.y.place(*c1d_m3))
        };
        points.iter().enumerate().map(step).collect()
    }

    fn reading(&self) -> Reading {
        let points = |line: &Line| {
            let point = |(q, c1d_m3): &(f64, f64)| {
                (self.x.place(*q), self.y.place(*c1d_m3), format!("{} m³", typeset_digits(*c1d_m3)))
            };
            line.iter().map(point).collect()
        };
        let whole = ReadingLine {
            class: COMPOSITE.to_owned(),
            name: if self.scans.is_empty() { "C1D" } else { "whole surface" }.to_owned(),
            points: points(&self.composite),
        };
        let scans = self.scans.iter().enumerate().map(|(at, scan)| ReadingLine {
            class: class(at),
            name: scan.name.clone(),
            points: points(&scan.trusted),
        });
        let place = |(q, _): &(f64, f64)| {
            (self.x.place(*q), format!("{}, {} rad/m", length(TAU / q), typeset_digits(*q)))
        };
        Reading {
            frame: [LEFT, TOP, WIDTH - RIGHT, TOP + FRAME],
            places: self.composite.iter().map(place).collect(),
            lines: std::iter::once(whole).chain(scans).collect(),
        }
    }
}

/// The class of the elements of a scan.
fn class(at: usize) -> String {
    format!("s{at}")
}

fn colours(at: usize) -> String {
    let [light, dark] = COLOURS[at % COLOURS.len()];
    format!("--light:{light};--dark:{dark}")
}

fn line(psd: &ProfilePsd) -> Line {
    psd.wavelengths_m()
        .iter()
        .map(|wavelength_m| TAU / wavelength_m)
        .zip(psd.c1d_m3().iter().copied())
        .collect()
}

/// The whole spectrum of a scan, trusted or not, in bins.
fn whole(scan: &ScanSpectrum) -> Line {
    let samples = scan.spectrum.wavelengths_m().zip(scan.spectrum.c1d_m3().iter().copied());
    let (wavelengths_m, c1d_m3) = samples.filter(|(_, c1d_m3)| *c1d_m3 > 0.0).unzip();
    ProfilePsd::new(wavelengths_m, c1d_m3).map_or_else(
        |_| Vec::new(),
        |psd| line(&log_binned(&psd, DEFAULT_BINS_PER_DECADE, BinMean::Arithmetic)),
    )
}
