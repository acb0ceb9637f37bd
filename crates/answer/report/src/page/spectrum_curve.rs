//! The spectrum of a surface over those of its scans: wavevectors below, wavelengths above, the trusted band of each scan
//! with its limit, and holes in grey.

use std::f64::consts::TAU;

use maud::{PreEscaped, html};
use serde::Serialize;
use spectrum::ProfilePsd;
use study::figure::pieces;
use study::surface::Surface;
use topography::{BinMean, DEFAULT_BINS_PER_DECADE, ScanSpectrum, log_binned};
use units::display::{length, typeset_digits};
use units::printable::printable;

use super::reading::{Reading, ReadingLine};
use crate::chart::canvas::{Anchor, Canvas, Rect, Stroke};
use crate::chart::palette::{self, NEUTRAL, of_page};
use crate::chart::ruler::{Ruler, TickWords};

/// Width and frame in units of the drawing, and the height below the frame.
const WIDTH: f64 = 560.0;
const FRAME: Rect = Rect { left: 50.0, top: 42.0, right: WIDTH - 18.0, bottom: 312.0 };
const BELOW: f64 = 44.0;

/// The size of letters.
const LETTERS: f64 = 11.0;

/// The height of the row of a scan below the axis, and the most rows.
const ROW: f64 = 18.0;
const MOST_ROWS: usize = 12;

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
        SpectrumCurve { figure: drawing.figure(), reading: drawing.reading() }
    }
}

struct Drawing<'s> {
    /// Wavevectors of the ends of holes \[rad/m\].
    holes: Vec<(f64, f64)>,
    composite: Line,
    scans: Vec<Scan<'s>>,
    /// Wavevectors from the least to the largest \[rad/m\].
    wavevectors: [f64; 2],
    axes: Canvas,
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
        let holes = surface.holes.iter().map(|hole| (TAU / hole.longest_m, TAU / hole.shortest_m)).collect();
        let points =
            || scans.iter().flat_map(|scan| scan.whole.iter().chain(&scan.trusted)).chain(&composite);
        let range = |of: fn(&(f64, f64)) -> f64, room: f64| {
            let (least, most) =
                points().map(of).fold((f64::INFINITY, 0.0), |(least, most): (f64, f64), value| {
                    (least.min(value), most.max(value))
                });
            [least / room, most * room]
        };
        let wavevectors = range(|point| point.0, 1.05);
        let x = Ruler::tight(wavevectors, TickWords::Number);
        let y = Ruler::tight(range(|point| point.1, 2.0), TickWords::Number);
        Drawing { holes, composite, scans, wavevectors, axes: Canvas::new(x, y, FRAME) }
    }

    fn figure(&self) -> String {
        let rows = self.scans.len().min(MOST_ROWS);
        let height = FRAME.bottom + BELOW + ROW * rows as f64;
        let mut canvas = self.axes.clone();
        self.background(&mut canvas);
        for (at, scan) in self.scans.iter().enumerate() {
            let (colour, look) = (palette::colour(at % NEUTRAL), look(at));
            canvas.group(&format!("class=\"{} line\" {look}", class(at)), &scan.name, |canvas| {
                let thin = Stroke { colour: &colour, width_px: 1.0, dash: "2 3" };
                canvas.svg += "<g class=\"untrusted\">";
                self.line(canvas, &scan.whole, thin);
                canvas.svg += "</g>";
                self.line(canvas, &scan.trusted, Stroke { width_px: 1.4, dash: "", ..thin });
            });
        }
        canvas.group(&format!("class=\"{COMPOSITE} line\""), "whole surface", |canvas| {
            let colour = palette::colour(NEUTRAL);
            for piece in pieces(&self.composite, &self.holes) {
                self.line(canvas, &piece, Stroke { colour: &colour, width_px: 2.4, dash: "" });
            }
        });
        (0..rows).for_each(|at| self.row(&mut canvas, at));
        if rows < self.scans.len() {
            let more = format!("and {} more", self.scans.len() - rows);
            canvas.text((FRAME.right, height - 2.0), Anchor::End, LETTERS, &more);
        }
        html! {
            svg.area.spectrum viewBox=(format!("0 0 {WIDTH} {height}")) role="img" xmlns="http://www.w3.org/2000/svg"
                aria-label="Power spectrum of profiles against wavevector, with wavelengths above" {
                (PreEscaped(canvas.svg))
            }
        }
        .into_string()
    }

    /// Grey holes, grid lines, and the labels of three axes.
    fn background(&self, canvas: &mut Canvas) {
        for (from, to) in &self.holes {
            let hole = canvas.hole(*from, *to);
            let middle = (0.5 * (hole.left + hole.right), hole.top + 14.0);
            canvas.text(middle, Anchor::Middle, LETTERS, "not measured");
        }
        canvas.grid();
        canvas.tick_labels();
        canvas.rect(FRAME, "class=\"frame\" fill=\"none\" stroke=\"black\"");
        let [least, most] = self.wavevectors;
        let wavelengths =
            Ruler::tight([TAU / most, TAU / least], TickWords::Length).over([FRAME.right, FRAME.left]);
        for (at, label) in &wavelengths.ticks {
            let x = wavelengths.place_px(*at);
            canvas.svg += &format!("<path class=\"tick\" d=\"M{x:.2} {}v-4\" stroke=\"black\"/>", FRAME.top);
            canvas.text((x, FRAME.top - 8.0), Anchor::Middle, LETTERS, label);
        }
        canvas.text((FRAME.right, 12.0), Anchor::End, LETTERS, "wavelength");
        canvas.text((FRAME.right, FRAME.bottom + 31.0), Anchor::End, LETTERS, "wavevector (rad/m)");
        canvas.text((FRAME.left, 12.0), Anchor::Start, LETTERS, "C1D (m³)");
    }

    /// Draws the trusted band of a scan as a bar below the axis, with its name and the limit of its short end.
    fn row(&self, canvas: &mut Canvas, at: usize) {
        let scan = &self.scans[at];
        let reliable = &scan.spectrum.reliable;
        let (longest_m, shortest_m) = (reliable.longest_wavelength_m(), reliable.shortest_wavelength_m());
        let [from, to] = [longest_m, shortest_m].map(|wavelength_m| canvas.x.px_or_first(TAU / wavelength_m));
        let middle = FRAME.bottom + BELOW + ROW * (at as f64 + 0.5) - 3.0;
        let words = format!(
            "{}: {} to {}, ends at {}",
            scan.name,
            length(longest_m),
            length(shortest_m),
            scan.spectrum.band_end
        );
        // Words begin on the side that has more room.
        let is_early = 0.5 * (from + to) < 0.5 * (FRAME.left + FRAME.right);
        let (place, anchor) =
            if is_early { (FRAME.left.max(from), Anchor::Start) } else { (to, Anchor::End) };
        let colour = palette::colour(at % NEUTRAL);
        canvas.group(&format!("class=\"{} line band\" {}", class(at), look(at)), &scan.name, |canvas| {
            canvas.line(&[(from, middle), (to, middle)], Stroke { colour: &colour, width_px: 4.0, dash: "" });
            canvas.styled_text((place, middle - 6.0), anchor, "class=\"name\"", &words);
        });
    }

    fn line(&self, canvas: &mut Canvas, line: &[(f64, f64)], stroke: Stroke<'_>) {
        let place =
            |(q, c1d_m3): &(f64, f64)| (self.axes.x.px_or_first(*q), self.axes.y.px_or_first(*c1d_m3));
        canvas.line(&line.iter().map(place).collect::<Vec<_>>(), stroke);
    }

    fn reading(&self) -> Reading {
        let Canvas { x, y, .. } = &self.axes;
        let points = |line: &Line| {
            let point = |(q, c1d_m3): &(f64, f64)| {
                (x.px_or_first(*q), y.px_or_first(*c1d_m3), format!("{} m³", typeset_digits(*c1d_m3)))
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
            (x.px_or_first(*q), format!("{}, {} rad/m", length(TAU / q), typeset_digits(*q)))
        };
        let Rect { left, top, right, bottom } = FRAME;
        Reading {
            frame: [left, top, right, bottom],
            places: self.composite.iter().map(place).collect(),
            lines: std::iter::once(whole).chain(scans).collect(),
        }
    }
}

/// The class of the elements of a scan.
fn class(at: usize) -> String {
    format!("s{at}")
}

/// The colours of a scan as an attribute.
fn look(at: usize) -> String {
    format!("style=\"{}\"", of_page(at))
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
    let samples = scan.spectrum.wavelengths_m().zip(scan.spectrum.c1d_m3.iter().copied());
    let (wavelengths_m, c1d_m3) = samples.filter(|(_, c1d_m3)| *c1d_m3 > 0.0).unzip();
    ProfilePsd::new(wavelengths_m, c1d_m3).map_or_else(
        |_| Vec::new(),
        |psd| line(&log_binned(&psd, DEFAULT_BINS_PER_DECADE, BinMean::Arithmetic)),
    )
}
