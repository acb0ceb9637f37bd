//! A drawing with axes, written as SVG from back to front. Every element has its look as attributes, for documents of
//! their own, and a class, for pages with a style sheet.

use std::fmt::Write;

use units::printable::printable;

use super::palette::{GRID, HOLE, ZERO};
use super::ruler::Ruler;

/// The size of the labels of ticks and in legends, of the labels of axes, and the length of ticks.
pub(crate) const LETTERS_PX: f64 = 12.0;
const AXIS_LETTERS_PX: f64 = 13.0;
const TICK_PX: f64 = 5.0;
const MINOR_TICK_PX: f64 = 3.0;
/// The height of a line of an axis's label, and the room for ticks and their labels below the frame.
const LINE_PX: f64 = 16.0;
const BELOW_PX: f64 = 36.0;
/// The radius of discs.
const DISC_PX: f64 = 3.0;
/// The most points of a line in a figure: a few for each pixel of its width.
pub(crate) const MOST_POINTS: usize = 2000;

/// A point in pixels.
pub(crate) type Point = (f64, f64);

/// Left, top, right and bottom in pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rect {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
}

impl Rect {
    pub fn grown(self, by: f64) -> Self {
        Rect { left: self.left - by, top: self.top - by, right: self.right + by, bottom: self.bottom + by }
    }

    pub fn holds(&self, (x, y): Point) -> bool {
        (self.left..=self.right).contains(&x) && (self.top..=self.bottom).contains(&y)
    }

    pub fn overlaps(&self, other: &Rect) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }

    pub fn within(&self, other: &Rect) -> bool {
        self.left >= other.left
            && self.right <= other.right
            && self.top >= other.top
            && self.bottom <= other.bottom
    }
}

/// The side of a text that is at its abscissa.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

impl Anchor {
    fn name(self) -> &'static str {
        match self {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        }
    }
}

/// The stroke of a line.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stroke<'a> {
    pub colour: &'a str,
    pub width_px: f64,
    /// The dash pattern of SVG; empty for a solid line.
    pub dash: &'a str,
}

/// A drawing with axes.
#[derive(Debug, Clone)]
pub(crate) struct Canvas {
    pub x: Ruler,
    pub y: Ruler,
    /// The rectangle between the axes.
    pub frame: Rect,
    /// The elements so far.
    pub svg: String,
    /// The lines of the labels of both axes.
    labels: [Vec<String>; 2],
}

impl Canvas {
    /// Lays axes over a rectangle.
    pub fn new(x: Ruler, y: Ruler, frame: Rect) -> Self {
        let (x, y) = (x.over([frame.left, frame.right]), y.over([frame.bottom, frame.top]));
        Canvas { x, y, frame, svg: String::new(), labels: [Vec::new(), Vec::new()] }
    }

    /// Lays axes with labels into a picture of a size, below a header of a height, with room for all labels.
    pub fn in_picture(x: Ruler, y: Ruler, [width, height]: [f64; 2], top: f64) -> Self {
        let widest = |ruler: &Ruler| {
            ruler.ticks.iter().map(|(_, label)| text_width_px(label, LETTERS_PX)).fold(0.0, f64::max)
        };
        let y_label = wrapped(&y.label, AXIS_LETTERS_PX, height - top - BELOW_PX);
        let left = widest(&y) + LINE_PX * y_label.len() as f64 + TICK_PX + 10.0;
        let last = x.ticks.last().map_or(0.0, |(_, label)| 0.5 * text_width_px(label, LETTERS_PX));
        let right = width - last.max(18.0) - 4.0;
        let x_label = wrapped(&x.label, AXIS_LETTERS_PX, right - left);
        let bottom = height - BELOW_PX - LINE_PX * x_label.len() as f64;
        Canvas { labels: [x_label, y_label], ..Canvas::new(x, y, Rect { left, top, right, bottom }) }
    }

    /// Draws lines across the frame at all labelled ticks.
    pub fn grid(&mut self) {
        let Rect { left, top, right, bottom } = self.frame;
        let across: String = self
            .y
            .ticks
            .iter()
            .map(|(at, _)| format!("M{left:.2} {:.2}H{right:.2}", self.y.place_px(*at)))
            .collect();
        let upwards: String = self
            .x
            .ticks
            .iter()
            .map(|(at, _)| format!("M{:.2} {bottom:.2}V{top:.2}", self.x.place_px(*at)))
            .collect();
        let _ = writeln!(
            self.svg,
            "<path class=\"grid\" d=\"{across}{upwards}\" fill=\"none\" stroke=\"{GRID}\"/>"
        );
    }

    /// Draws lines at the zeros of axes that cross it.
    pub fn zeros(&mut self) {
        let Rect { left, top, right, bottom } = self.frame;
        let across = self.y.zero_px().map(|at| [(left, at), (right, at)]);
        let upwards = self.x.zero_px().map(|at| [(at, bottom), (at, top)]);
        for ends in across.into_iter().chain(upwards) {
            self.line(&ends, Stroke { colour: ZERO, width_px: 0.7, dash: "" });
        }
    }

    /// Draws the labels of all ticks below and left of the frame.
    pub fn tick_labels(&mut self) {
        let Rect { left, bottom, .. } = self.frame;
        let size = LETTERS_PX;
        let _ = write!(self.svg, "<g class=\"ticks\" font-size=\"{size}\" text-anchor=\"middle\">");
        for (at, label) in &self.x.ticks {
            let _ = write!(
                self.svg,
                "<text x=\"{:.2}\" y=\"{:.2}\">{label}</text>",
                self.x.place_px(*at),
                bottom + TICK_PX + size
            );
        }
        let _ = write!(self.svg, "</g>\n<g class=\"ticks\" font-size=\"{size}\" text-anchor=\"end\">");
        for (at, label) in &self.y.ticks {
            let y = self.y.place_px(*at) + 0.35 * size;
            let _ = write!(self.svg, "<text x=\"{:.2}\" y=\"{y:.2}\">{label}</text>", left - TICK_PX - 3.0);
        }
        self.svg += "</g>\n";
    }

    /// Draws the frame, all ticks, and the labels of ticks and axes.
    pub fn axes(&mut self) {
        let Rect { left, top, right, bottom } = self.frame;
        let mut ticks = [String::new(), String::new()];
        let both = [(TICK_PX, true), (MINOR_TICK_PX, false)];
        for (path, (length, is_labelled)) in ticks.iter_mut().zip(both) {
            let places = |ruler: &Ruler| match is_labelled {
                true => ruler.ticks.iter().map(|(at, _)| ruler.place_px(*at)).collect::<Vec<_>>(),
                false => ruler.minor_ticks.iter().map(|at| ruler.place_px(*at)).collect(),
            };
            places(&self.x).iter().for_each(|at| *path += &format!("M{at:.2} {bottom:.2}v-{length}"));
            places(&self.y).iter().for_each(|at| *path += &format!("M{left:.2} {at:.2}h{length}"));
        }
        let _ = writeln!(
            self.svg,
            "<g class=\"axes\" fill=\"none\" stroke=\"black\"><path d=\"M{left:.2} {top:.2}H{right:.2}V{bottom:.2}H{left:.2}Z{}\"/>\
             <path d=\"{}\" stroke-width=\"0.7\"/></g>",
            ticks[0], ticks[1]
        );
        self.tick_labels();
        let [x_label, y_label] = std::mem::take(&mut self.labels);
        for (at, line) in x_label.iter().enumerate() {
            let place =
                (0.5 * (left + right), bottom + BELOW_PX - 6.0 + LINE_PX * at as f64 + 0.7 * AXIS_LETTERS_PX);
            self.text(place, Anchor::Middle, AXIS_LETTERS_PX, line);
        }
        let _ = write!(self.svg, "<g transform=\"translate(0 {:.2}) rotate(-90)\">", 0.5 * (top + bottom));
        for (at, line) in y_label.iter().enumerate() {
            self.text((0.0, LINE_PX * (at + 1) as f64), Anchor::Middle, AXIS_LETTERS_PX, line);
        }
        self.svg += "</g>\n";
    }

    /// Shades a stretch of the abscissa without a measurement, as far as it lies in the frame.
    pub fn hole(&mut self, from: f64, to: f64) -> Rect {
        let [one, other] = [self.x.px_within(from), self.x.px_within(to)];
        let hole = Rect { left: one.min(other), right: one.max(other), ..self.frame };
        let (fill, opacity) = HOLE;
        self.rect(hole, &format!("class=\"hole\" fill=\"{fill}\" fill-opacity=\"{opacity}\""));
        hole
    }

    /// Writes a text in the letters of a size.
    pub fn text(&mut self, at: Point, anchor: Anchor, size: f64, content: &str) {
        self.styled_text(at, anchor, &format!("font-size=\"{size}\""), content);
    }

    /// Writes a text with some attributes.
    pub fn styled_text(&mut self, (x, y): Point, anchor: Anchor, attributes: &str, content: &str) {
        let (anchor, content) = (anchor.name(), escaped(content));
        let _ = writeln!(
            self.svg,
            "<text x=\"{x:.2}\" y=\"{y:.2}\" text-anchor=\"{anchor}\" {attributes}>{content}</text>"
        );
    }

    /// Draws elements in a group with some attributes, which has a title for pointers.
    pub fn group(&mut self, attributes: &str, title: &str, draw: impl FnOnce(&mut Self)) {
        let _ = writeln!(self.svg, "<g {attributes}>");
        draw(self);
        let _ = writeln!(self.svg, "<title>{}</title></g>", escaped(title));
    }

    /// Draws a rectangle with some attributes.
    pub fn rect(&mut self, Rect { left, top, right, bottom }: Rect, attributes: &str) {
        let (width, height) = (right - left, bottom - top);
        let _ = writeln!(
            self.svg,
            "<rect x=\"{left:.2}\" y=\"{top:.2}\" width=\"{width:.2}\" height=\"{height:.2}\" {attributes}/>"
        );
    }

    /// Draws a line through points, or a disc where there is one.
    pub fn line(&mut self, points: &[Point], Stroke { colour, width_px, dash }: Stroke<'_>) {
        if let [point] = points {
            let _ = writeln!(self.svg, "{}", circle(*point, &format!("fill=\"{colour}\"")));
            return;
        }
        let dash = if dash.is_empty() { String::new() } else { format!(" stroke-dasharray=\"{dash}\"") };
        let _ = writeln!(
            self.svg,
            "<path class=\"line\" d=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width_px}\"{dash}/>",
            path(points)
        );
    }

    /// Draws a value with a bar from its lower to its upper limit; `None` if one of them has no place.
    pub fn mark(&mut self, x: f64, [low, value, high]: [f64; 3], colour: &str, is_ring: bool) -> Option<()> {
        const CAP_PX: f64 = 3.0;
        let (x, y) = (self.x.px(x)?, self.y.px(value)?);
        let ends = [self.y.px(low)?, self.y.px(high)?];
        let caps: String = ends.map(|end| format!("M{:.2} {end:.2}H{:.2}", x - CAP_PX, x + CAP_PX)).concat();
        let _ = writeln!(
            self.svg,
            "<path d=\"M{x:.2} {:.2}V{:.2}{caps}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.2\"/>{}",
            ends[0],
            ends[1],
            disc((x, y), colour, is_ring)
        );
        Some(())
    }
}

/// A disc with a white rim, which is seen on top of lines, or a ring.
pub(crate) fn disc(at: Point, colour: &str, is_ring: bool) -> String {
    let (fill, rim, rim_px) = if is_ring { ("white", colour, 1.4) } else { (colour, "white", 0.8) };
    circle(at, &format!("fill=\"{fill}\" stroke=\"{rim}\" stroke-width=\"{rim_px}\""))
}

fn circle((x, y): Point, attributes: &str) -> String {
    format!("<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{DISC_PX}\" {attributes}/>")
}

/// Returns the path from each point to the next.
pub(crate) fn path(points: &[Point]) -> String {
    let step = |(at, (x, y)): (usize, &Point)| format!("{}{x:.2} {y:.2}", if at == 0 { 'M' } else { 'L' });
    points.iter().enumerate().map(step).collect()
}

/// Returns a text as it stands within an element or an attribute.
pub(crate) fn escaped(text: &str) -> String {
    printable(text).replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Estimates the width of a text in the usual fonts from above.
pub(crate) fn text_width_px(text: &str, size_px: f64) -> f64 {
    let width = |c: char| match c {
        'm' | 'M' | 'W' => 0.98,
        '\u{2212}' => 0.84,
        ' ' => 0.35,
        c if c.is_ascii() || c == '×' => 0.62,
        _ => 0.48,
    };
    size_px * text.chars().map(width).sum::<f64>()
}

/// Breaks a text that is wider than its room between words.
pub(crate) fn wrapped(text: &str, size_px: f64, room_px: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if text_width_px(&format!("{line} {word}"), size_px) <= room_px => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Thins more points than `most` whose abscissas run one way: each narrow column keeps its first, lowest, highest and last
/// point, so that no peak and no dip is lost.
pub(crate) fn thinned(points: Vec<Point>, most: usize) -> Vec<Point> {
    let (Some(&(first, _)), Some(&(last, _))) = (points.first(), points.last()) else { return points };
    if points.len() <= most || first == last {
        return points;
    }
    let columns = most / 4;
    let column = |(x, _): &Point| (((x - first) / (last - first) * columns as f64) as usize).min(columns - 1);
    points.chunk_by(|a, b| column(a) == column(b)).flat_map(outline).collect()
}

/// The first, lowest, highest and last of some points, each once and in order.
fn outline(column: &[Point]) -> Vec<Point> {
    let by_height = |a: &usize, b: &usize| column[*a].1.total_cmp(&column[*b].1);
    let lowest = (0..column.len()).min_by(by_height);
    let highest = (0..column.len()).max_by(by_height);
    let mut kept: Vec<usize> = lowest.into_iter().chain(highest).chain([0, column.len() - 1]).collect();
    kept.sort_unstable();
    kept.dedup();
    kept.into_iter().map(|at| column[at]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dense_line_keeps_its_ends_peaks_and_dips() {
        let mut points: Vec<Point> =
            (0..100_000).map(|i| (-f64::from(i), (f64::from(i) / 1e4).sin())).collect();
        points[54_321].1 = -7.0;
        points[76_543].1 = 9.0;
        let drawn = thinned(points.clone(), MOST_POINTS);
        assert!(drawn.len() <= MOST_POINTS, "{}", drawn.len());
        for kept in [points[0], points[54_321], points[76_543], points[99_999]] {
            assert!(drawn.contains(&kept));
        }
        assert!(drawn.windows(2).all(|pair| pair[0].0 > pair[1].0), "the order stays");
        let few: Vec<Point> = points.into_iter().take(MOST_POINTS).collect();
        assert_eq!(thinned(few.clone(), MOST_POINTS), few);
        assert_eq!(thinned(Vec::new(), MOST_POINTS), []);
    }

    #[test]
    fn a_text_wider_than_its_room_is_broken_between_words() {
        let label = "Sinusoids, elastic-plastic, growing hardness";
        assert_eq!(wrapped(label, LETTERS_PX, 1000.0), [label]);
        let lines = wrapped(label, LETTERS_PX, 200.0);
        assert!(
            lines.len() > 1 && lines.iter().all(|line| text_width_px(line, LETTERS_PX) <= 200.0),
            "{lines:?}"
        );
        assert_eq!(lines.join(" "), label);
    }
}
