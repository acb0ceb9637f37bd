//! Pictures of measured heights, pressures and gaps: maps in colours, lines, and histograms.

use std::fmt::Write;
use std::iter::once;
use std::ops::Range;

use elements::ContactField;
use scans::{Measure, MeasuredScan, ScanFile};
use units::LengthUnit;
use units::display::{length, percent, pressure, three_digits};

use super::canvas::{Point, Rect, escaped, path};
use super::palette::{MISSING, map_colour};
use super::panel::Panel;
use super::plain_lines;
use super::raster::{Pixels, image, png};

/// Width of the longer side of a map, and the distances around it.
const FRAME_PX: f64 = 400.0;
const MARGIN_PX: f64 = 24.0;
const TITLE_PX: f64 = 30.0;
const SCALE_PX: f64 = 46.0;
/// Steps of the scale of colours.
const STEPS: usize = 64;
/// The most points along the longer side of a map; of larger maps, points between are not drawn.
const MOST_POINTS: usize = 1024;
/// The share of the points at either end of the values beyond the colours, so that a spike does not leave one colour to
/// the rest.
const BEYOND: f64 = 0.002;
/// The flow over its mean that has the first colour, as has any smaller one.
const LEAST_FLOW: f64 = 0.01;
/// Classes of a histogram.
const CLASSES: usize = 64;
/// Sizes of panels in px: of a line, and of one of several panels beside a map.
const WIDE: [f64; 2] = [860.0, 380.0];
const SMALL: [f64; 2] = [480.0, 285.0];
/// The longer side of a thumbnail of a map, and the width and height of one of a profile, in px.
const MAP_PX: f64 = 160.0;
const PROFILE_PX: [f64; 2] = [320.0, 90.0];

/// A map in two parts: the colours of its points are drawn over its frame.
#[derive(Debug, Clone, PartialEq)]
pub struct FieldPicture {
    /// Title, frame and scale.
    pub svg: String,
    /// The rectangle of the points in the picture: left, top, width and height in px.
    pub place: [f64; 4],
    /// Points along x.
    pub columns: usize,
    /// The colour of each point, red, green and blue, row by row from the top.
    pub colours: Vec<[u8; 3]>,
}

impl FieldPicture {
    /// Draws pressures, white where there is no contact.
    #[must_use]
    pub fn of_pressure(field: &ContactField<'_>) -> Self {
        let relief = field.relief;
        let size_m = [relief.length_x_m, relief.length_y_m];
        Self::of_pressures(field.nominal_pressure_pa, field.pressures_pa, relief.columns, size_m)
    }

    /// Draws pressures \[Pa\] row by row on a rectangle of a size in m, white where there is no contact.
    #[must_use]
    pub fn of_pressures(
        nominal_pressure_pa: f64,
        pressures_pa: &[f64],
        columns: usize,
        size_m: [f64; 2],
    ) -> Self {
        let title = format!("pressure at {}", pressure(nominal_pressure_pa));
        Self::of_values(&title, pressures_pa, 1e-10 * nominal_pressure_pa, size_m, columns, pressure)
    }

    /// Draws gaps, white in contact, grey at missing points.
    #[must_use]
    pub fn of_gap(field: &ContactField<'_>) -> Self {
        // In contact the gap is zero within the tolerance; the pressure tells which points those are.
        let touches = 1e-10 * field.nominal_pressure_pa;
        let open = field.gaps_m.iter().zip(field.pressures_pa);
        let open_m: Vec<f64> =
            open.map(|(gap_m, pressure_pa)| if *pressure_pa > touches { 0.0 } else { *gap_m }).collect();
        let title = format!("gap at {}", pressure(field.nominal_pressure_pa));
        let relief = field.relief;
        Self::of_values(&title, &open_m, 0.0, [relief.length_x_m, relief.length_y_m], relief.columns, length)
    }

    /// Draws the flow along an axis through each point of a gap \[m\], perhaps under a nominal pressure: logarithms of the flow over its
    /// mean, grey where the gap is closed, white where nothing flows.
    #[must_use]
    pub fn of_flow(
        axis: &str,
        nominal_pressure_pa: Option<f64>,
        flux: &[[f64; 2]],
        gaps_m: &[f64],
        columns: usize,
        size_m: [f64; 2],
    ) -> Self {
        let flow = |at: usize| flux.get(at).map_or(0.0, |[x, y]| x.hypot(*y));
        let largest = (0..flux.len()).map(flow).fold(1.0, f64::max);
        let colour_of = |(at, gap_m): (usize, &f64)| match flow(at) {
            _ if !(*gap_m > 0.0 && gap_m.is_finite()) => MISSING,
            0.0 => [255; 3],
            flow => map_colour((flow / LEAST_FLOW).ln() / (largest / LEAST_FLOW).ln()),
        };
        let colours = gaps_m.iter().enumerate().map(colour_of).collect();
        let load = nominal_pressure_pa.map_or_else(String::new, |pa| format!(" at {}", pressure(pa)));
        let title = format!("flow along {axis}{load} (grey: contact)");
        let ends =
            [format!("{} of its mean", percent(LEAST_FLOW)), format!("{} times", three_digits(largest))];
        Self::new(&title, size_m, [&ends[0], &ends[1]], columns, colours, None)
    }

    /// Draws the share of the current through the spot of each point, white between spots.
    #[must_use]
    pub fn of_current(field: &ContactField<'_>, shares: &[f64]) -> Self {
        let title =
            format!("share of the current through each spot at {}", pressure(field.nominal_pressure_pa));
        let relief = field.relief;
        Self::of_values(&title, shares, 0.0, [relief.length_x_m, relief.length_y_m], relief.columns, percent)
    }

    /// Colours values above `nothing` up to the largest finite one, on a rectangle of a size in m.
    fn of_values(
        title: &str,
        values: &[f64],
        nothing: f64,
        size_m: [f64; 2],
        columns: usize,
        in_words: fn(f64) -> String,
    ) -> Self {
        let finite = values.iter().copied().filter(|value| value.is_finite());
        let largest = finite.fold(0.0, f64::max);
        let colour_of = |&value: &f64| match value {
            f64::INFINITY => MISSING,
            value if value > nothing => map_colour(value / largest),
            _ => [255; 3],
        };
        let colours = values.iter().map(colour_of).collect();
        Self::new(title, size_m, ["0", &in_words(largest)], columns, colours, None)
    }

    /// Draws points in their colours on a rectangle of a size in m; `ends` label the first and the last colour. Another
    /// panel may lie beside.
    fn new(
        title: &str,
        [x_m, y_m]: [f64; 2],
        ends: [&str; 2],
        columns: usize,
        colours: Vec<[u8; 3]>,
        beside: Option<&Panel>,
    ) -> Self {
        let scale = FRAME_PX / x_m.max(y_m);
        let place = [MARGIN_PX, MARGIN_PX + TITLE_PX, (x_m * scale).max(1.0), (y_m * scale).max(1.0)];
        let frame = frame(title, place, &length(x_m), ends);
        let panel = match beside {
            Some(other) => frame.beside(other),
            None => frame,
        };
        FieldPicture { svg: panel.document(&[], None), place, columns, colours }
    }

    /// Returns the map as one SVG document, with its points as an image over the frame.
    #[must_use]
    pub fn document(&self) -> String {
        let [left, top, width, height] = self.place;
        let place = Rect { left, top, right: left + width, bottom: top + height };
        let image = self.image(place, " style=\"image-rendering:pixelated\"").unwrap_or_default();
        self.svg.replace("</svg>", &format!("{image}\n</svg>"))
    }

    /// The points as an image.
    fn image(&self, place: Rect, more: &str) -> Option<String> {
        let size = [self.columns, self.colours.len() / self.columns];
        let png = png(size, Pixels::Colours, self.colours.as_flattened())?;
        Some(image(&png, place, more))
    }
}

/// Title, frame and scale of a map.
fn frame(title: &str, [left, top, width, height]: [f64; 4], side: &str, [least, most]: [&str; 2]) -> Panel {
    let [title, least, most] = [title, least, most].map(escaped);
    let size = [left + width.max(0.6 * FRAME_PX) + MARGIN_PX, top + height + SCALE_PX + MARGIN_PX];
    let mut elements = format!(
        "<text x=\"{left}\" y=\"{}\">{title}; {side} wide</text>\n\
         <rect x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" fill=\"none\" stroke=\"black\"/>\n",
        top - 0.4 * TITLE_PX
    );
    let bar = top + height + 14.0;
    let step = 0.5 * FRAME_PX / STEPS as f64;
    for at in 0..STEPS {
        let [red, green, blue] = map_colour(at as f64 / (STEPS - 1) as f64);
        let x = left + at as f64 * step;
        let _ = writeln!(
            elements,
            "<rect x=\"{x}\" y=\"{bar}\" width=\"{}\" height=\"12\" fill=\"rgb({red},{green},{blue})\"/>",
            step + 0.3
        );
    }
    let under = bar + 27.0;
    let _ = writeln!(
        elements,
        "<text x=\"{left}\" y=\"{under}\">{least}</text>\n<text x=\"{}\" y=\"{under}\" text-anchor=\"end\">{most}</text>",
        left + 0.5 * FRAME_PX
    );
    Panel { size, elements }
}

/// A picture of heights.
#[derive(Debug, Clone, PartialEq)]
pub enum HeightsPicture {
    /// A map: colours over a frame, beside it the line through the middle and the histogram.
    Map(FieldPicture),
    /// A line above its histogram: an SVG document.
    Line(String),
}

impl HeightsPicture {
    /// Draws the heights of a scan, or the values of another channel in their own unit; `None` if no point has a value.
    #[must_use]
    pub fn new(file: &ScanFile) -> Option<Self> {
        let name = match &file.channel {
            Some(channel) => format!("{}: {channel}", file.name),
            None => file.name.clone(),
        };
        match file.scan.points() {
            (columns, Some(rows)) => {
                let row = middle_row(&file.scan, columns, rows)?;
                let title = format!("row {} of {rows}", row + 1);
                let line = line(&title, file, row * columns..(row + 1) * columns, SMALL)?;
                let beside = line.above(&histogram(file, SMALL)?);
                map(&name, file, [columns, rows], Some(&beside)).map(HeightsPicture::Map)
            }
            (columns, None) => {
                let line = line(&name, file, 0..columns, WIDE)?;
                let both = line.above(&histogram(file, [WIDE[0], SMALL[1]])?);
                Some(HeightsPicture::Line(both.document(&[], None)))
            }
        }
    }

    /// Returns the picture as one SVG document.
    #[must_use]
    pub fn document(&self) -> String {
        match self {
            HeightsPicture::Map(map) => map.document(),
            HeightsPicture::Line(svg) => svg.clone(),
        }
    }
}

/// Draws a scan as a small element of a page; `None` if no point has a height. `words` describe it to readers who cannot
/// see it.
pub(crate) fn thumbnail(file: &ScanFile, words: &str) -> Option<String> {
    let ([width, height], content) = match file.scan.points() {
        (columns, Some(rows)) => {
            let picture = map(&file.name, file, [columns, rows], None)?;
            let [_, _, x, y] = picture.place;
            let size = [x, y].map(|side| (side * MAP_PX / x.max(y)).round());
            (size, picture.image(Rect { left: 0.0, top: 0.0, right: size[0], bottom: size[1] }, "")?)
        }
        (points, None) => (PROFILE_PX, profile(file, points)?),
    };
    let words = escaped(words);
    Some(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{words}\" viewBox=\"0 0 {width} {height}\" \
         width=\"{width}\" height=\"{height}\">{content}</svg>"
    ))
}

/// The path of a profile, interrupted where points are missing.
fn profile(file: &ScanFile, points: usize) -> Option<String> {
    let (lowest_m, highest_m) = ends(file.scan.heights_m())?;
    let [width, height] = PROFILE_PX;
    let runs = runs(file, 0..points, |along_m, height_m| {
        let up = (height_m - lowest_m) / (highest_m - lowest_m).max(f64::MIN_POSITIVE);
        (width * along_m / file.scan.size_m().0, height * (0.98 - 0.96 * up))
    });
    let d: String = runs.iter().map(|run| path(run)).collect();
    Some(format!("<path d=\"{d}\" fill=\"none\" stroke=\"currentColor\"/>"))
}

/// Draws a map in colours, with another panel beside it.
fn map(
    name: &str,
    file: &ScanFile,
    [columns, rows]: [usize; 2],
    beside: Option<&Panel>,
) -> Option<FieldPicture> {
    let ScanFile { scan, measure, .. } = file;
    let [lowest, highest] = coloured(scan)?;
    let step = columns.max(rows).div_ceil(MOST_POINTS);
    let across = (0..columns).step_by(step);
    let colour_of = |value: f64| map_colour((value - lowest) / (highest - lowest).max(f64::MIN_POSITIVE));
    let colours = (0..rows).step_by(step).flat_map(|row| {
        across.clone().map(move |column| scan.height_m(row * columns + column).map_or(MISSING, colour_of))
    });
    let (x_m, y_m) = scan.size_m();
    let title = match scan.missing_points().count() {
        0 => name.to_owned(),
        count => format!("{name}; grey: {count} without a {}", noun(measure)),
    };
    let range = match measure {
        Measure::Height | Measure::Length => length(highest - lowest),
        Measure::Other(unit) => format!("{} {unit}", three_digits(highest - lowest)).trim_end().to_owned(),
    };
    let size_m = [x_m, y_m.unwrap_or(x_m)];
    Some(FieldPicture::new(&title, size_m, ["0", &range], across.len(), colours.collect(), beside))
}

/// The row with a value that is nearest the middle.
fn middle_row(scan: &MeasuredScan, columns: usize, rows: usize) -> Option<usize> {
    let has_value = |row: &usize| (row * columns..(row + 1) * columns).any(|at| scan.height_m(at).is_some());
    (0..rows).filter(has_value).min_by_key(|row| row.abs_diff(rows / 2))
}

/// The values of the first and the last colour.
fn coloured(scan: &MeasuredScan) -> Option<[f64; 2]> {
    let mut values: Vec<f64> = scan.heights_m().flatten().collect();
    let last = values.len().checked_sub(1)?;
    let beyond = (BEYOND * last as f64) as usize;
    let (_, lowest, _) = values.select_nth_unstable_by(beyond, f64::total_cmp);
    let lowest = *lowest;
    let (_, highest, _) = values.select_nth_unstable_by(last - beyond, f64::total_cmp);
    Some([lowest, *highest])
}

/// The lowest and the highest value.
fn ends(values: impl Iterator<Item = Option<f64>>) -> Option<(f64, f64)> {
    values.flatten().fold(None, |ends: Option<(f64, f64)>, value| {
        Some(ends.map_or((value, value), |(low, high)| (low.min(value), high.max(value))))
    })
}

/// The points with a value, from their positions \[m\] and values; a run ends where a point is missing.
fn runs(file: &ScanFile, points: Range<usize>, place: impl Fn(f64, f64) -> Point) -> Vec<Vec<Point>> {
    let scan = &file.scan;
    let (spacing_m, _) = scan.spacing_m();
    let position_m = |index: usize| match scan.positions_m() {
        Some(positions_m) => positions_m[index] - positions_m[0],
        None => index as f64 * spacing_m,
    };
    let values: Vec<Option<Point>> = points
        .enumerate()
        .map(|(index, at)| scan.height_m(at).map(|value| place(position_m(index), value)))
        .collect();
    values
        .split(Option::is_none)
        .filter(|run| !run.is_empty())
        .map(|run| run.iter().flatten().copied().collect())
        .collect()
}

/// Draws the points of a line, above the lowest point of the scan.
fn line(title: &str, file: &ScanFile, points: Range<usize>, size: [f64; 2]) -> Option<Panel> {
    let (lowest, up) = above_lowest(file)?;
    let along = fitting_unit(file.scan.size_m().0);
    let runs = runs(file, points, |along_m, value| (along_m / along.to_m(1.0), (value - lowest) / up.one));
    Some(plain_lines(title, [&format!("position ({along})"), &up.label], &runs, size))
}

/// Draws the share of the points in each class of values, without those that the colours of a map leave out.
fn histogram(file: &ScanFile, size: [f64; 2]) -> Option<Panel> {
    let (lowest, up) = above_lowest(file)?;
    let [first, last] = coloured(&file.scan)?;
    let width = (last - first) / CLASSES as f64;
    let mut counts = [0_usize; CLASSES];
    let mut points = 0_usize;
    for value in file.scan.heights_m().flatten() {
        points += 1;
        if (first..=last).contains(&value) {
            counts[(((value - first) / width) as usize).min(CLASSES - 1)] += 1;
        }
    }
    let edge = |class: usize| (first + class as f64 * width - lowest) / up.one;
    let outline = counts.iter().enumerate().flat_map(|(class, count)| {
        let percent = 100.0 * *count as f64 / points as f64;
        [(edge(class), percent), (edge(class + 1), percent)]
    });
    let closed = once((edge(0), 0.0)).chain(outline).chain(once((edge(CLASSES), 0.0))).collect();
    Some(plain_lines("", [&up.label, "share of the points (%)"], &[closed], size))
}

/// The lowest value of a scan, and the axis for values above it.
fn above_lowest(ScanFile { scan, measure, .. }: &ScanFile) -> Option<(f64, Scale)> {
    let (lowest, highest) = ends(scan.heights_m())?;
    Some((lowest, Scale::fitting(measure, highest - lowest)))
}

/// The noun for the value of a point.
fn noun(measure: &Measure) -> &'static str {
    match measure {
        Measure::Height => "height",
        Measure::Length | Measure::Other(_) => "value",
    }
}

/// The axis of values above the lowest point.
struct Scale {
    label: String,
    /// The value of one unit.
    one: f64,
}

impl Scale {
    /// A length in the unit that fits the largest length, or another value in its own unit.
    fn fitting(measure: &Measure, largest: f64) -> Self {
        let (unit, one) = match measure {
            Measure::Height | Measure::Length => {
                let unit = fitting_unit(largest);
                (unit.to_string(), unit.to_m(1.0))
            }
            Measure::Other(unit) => (unit.clone(), 1.0),
        };
        let bracket = if unit.is_empty() { String::new() } else { format!(" ({unit})") };
        Self { label: format!("{} above the lowest point{bracket}", noun(measure)), one }
    }
}

/// The unit in which a length has one to three digits before its point.
fn fitting_unit(length_m: f64) -> LengthUnit {
    let units = [LengthUnit::METRE, LengthUnit::MILLIMETRE, LengthUnit::MICROMETRE, LengthUnit::NANOMETRE];
    units.into_iter().find(|unit| length_m >= unit.to_m(1.0)).unwrap_or(LengthUnit::PICOMETRE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use scans::{ScanOptions, read_scans};

    fn file(text: &str) -> ScanFile {
        let options = ScanOptions {
            unit: Some(LengthUnit::NANOMETRE),
            fallback_size: Some(scans::ScanSize { x_m: 1e-6, y_m: None }),
            ..ScanOptions::default()
        };
        read_scans(text.as_bytes(), "a <b>", &options).unwrap().remove(0)
    }

    fn picture(text: &str) -> HeightsPicture {
        HeightsPicture::new(&file(text)).unwrap()
    }

    /// The picture of values, in nm, that are none.
    fn picture_in(unit: &str, text: &str) -> HeightsPicture {
        let mut file = file(text);
        file.measure = Measure::Other(unit.to_owned());
        HeightsPicture::new(&file).unwrap()
    }

    #[test]
    fn gaps_of_maps_are_grey_and_the_ends_of_the_scale_stand_for_the_ends_of_the_heights() {
        let HeightsPicture::Map(map) = picture("0 1 2 3\n4 5 nan 7\n0 1 2 3\n0 1 2 3\n") else {
            panic!("a map")
        };
        assert_eq!((map.columns, map.colours.len(), map.colours[6]), (4, 16, MISSING));
        assert_eq!((map.colours[0], map.colours[7]), (map_colour(0.0), map_colour(1.0)));
        assert!(map.svg.contains("a &lt;b&gt;") && map.svg.contains(">7 nm</text>"), "{}", map.svg);
    }

    #[test]
    fn beside_a_map_are_the_line_nearest_its_middle_and_the_histogram_of_the_values() {
        for (text, row) in [
            ("0 1 2 3\n4 5 6 7\n0 1 2 3\n0 9 8 7\n", "row 3 of 4"),
            ("0 1 2 3\n4 5 6 7\nnan nan nan nan\n0 9 8 7\n", "row 2 of 4"),
        ] {
            let HeightsPicture::Map(map) = picture(text) else { panic!("a map") };
            assert!(map.svg.contains(row) && map.svg.matches("</svg>").count() == 1, "{}", map.svg);
            assert_eq!(map.svg.matches("share of the points (%)").count(), 1);
        }
        // A plane has one height.
        assert!(matches!(picture("3 3 3 3\n3 3 3 3\n"), HeightsPicture::Map(_)));
    }

    #[test]
    fn lines_are_broken_at_gaps() {
        let HeightsPicture::Line(svg) = picture("0\n1\nnan\n2\n1\n") else { panic!("a line") };
        let HeightsPicture::Line(whole) = picture("0\n1\n3\n2\n1\n") else { panic!("a line") };
        assert!(svg.contains("position (µm)") && svg.contains("(nm)"), "{svg}");
        assert_eq!(
            svg.matches("stroke-width=\"1.2\"").count(),
            whole.matches("stroke-width=\"1.2\"").count() + 1
        );
    }

    #[test]
    fn values_that_are_no_lengths_have_their_own_unit() {
        let HeightsPicture::Map(map) = picture_in("V", "0 1 2 3\n4 5 nan 7e7\n0 1 2 3\n0 1 2 3\n") else {
            panic!("a map")
        };
        assert!(
            map.svg.contains("grey: 1 without a value") && map.svg.contains(">0.07 V</text>"),
            "{}",
            map.svg
        );
        let HeightsPicture::Map(map) = picture_in("", "0 1 2 3\n4 5 6 7e9\n0 1 2 3\n0 1 2 3\n") else {
            panic!("a map")
        };
        assert!(map.svg.contains(">7</text>"), "{}", map.svg);
        let HeightsPicture::Line(svg) = picture_in("°", "0\n1e9\n3e9\n2e9\n1e9\n") else { panic!("a line") };
        assert!(svg.contains("value above the lowest point (°)") && !svg.contains("height above"), "{svg}");
        let HeightsPicture::Line(svg) = picture_in("", "0\n1e9\n3e9\n2e9\n1e9\n") else { panic!("a line") };
        assert!(svg.contains("value above the lowest point<"), "{svg}");
    }
}
