//! Pictures of measured heights, or of other channels: maps in colours with missing points in grey, a line, and the
//! histogram of all values.

use std::iter::once;
use std::ops::Range;

use scans::{Measure, MeasuredScan, ScanFile};
use units::LengthUnit;
use units::display::{length, three_digits};

use crate::field_picture::{FieldPicture, colour};
use crate::plot::Panel;

/// The most points along the longer side of a picture; of larger maps, points between are not drawn.
const MAX_POINTS: usize = 1024;
/// The share of the points at either end of the values beyond the colours, so that a spike does not leave one colour to
/// the rest.
const BEYOND: f64 = 0.002;
const GAP: [u8; 3] = [150; 3];
/// Classes of a histogram.
const CLASSES: usize = 64;
/// Sizes of panels in px: of a line, and of one of several panels beside a map.
const WIDE: [f64; 2] = [860.0, 380.0];
const SMALL: [f64; 2] = [480.0, 285.0];

/// A picture of heights.
#[derive(Debug, Clone, PartialEq)]
pub enum HeightsPicture {
    /// A map: colours over a frame, beside it the line through the middle and the histogram.
    Map(FieldPicture),
    /// A line above its histogram: an SVG document.
    Line(String),
}

/// Draws the heights of a scan, or the values of another channel in their own unit; `None` if no point has a value.
#[must_use]
pub fn of_heights(file: &ScanFile) -> Option<HeightsPicture> {
    let name = match &file.channel {
        Some(channel) => format!("{}: {channel}", file.name),
        None => file.name.clone(),
    };
    match file.scan.points() {
        (columns, Some(rows)) => {
            let beside = row_and_histogram(file, columns, rows)?;
            map(&name, file, columns, rows, Some(&beside)).map(HeightsPicture::Map)
        }
        (columns, None) => line(&name, file, 0..columns, WIDE)
            .and_then(|line| Some(line.above(&histogram(file, [WIDE[0], SMALL[1]])?)))
            .map(|panel| HeightsPicture::Line(panel.document())),
    }
}

/// Draws a map in colours, with another panel beside it.
pub(crate) fn map(
    name: &str,
    file: &ScanFile,
    columns: usize,
    rows: usize,
    beside: Option<&Panel>,
) -> Option<FieldPicture> {
    let ScanFile { scan, measure, .. } = file;
    let [lowest, highest] = coloured(scan)?;
    let step = columns.max(rows).div_ceil(MAX_POINTS);
    let across = (0..columns).step_by(step);
    let colour_of = |value: f64| colour((value - lowest) / (highest - lowest).max(f64::MIN_POSITIVE));
    let colours = (0..rows).step_by(step).flat_map(|row| {
        across.clone().map(move |column| scan.height_m(row * columns + column).map_or(GAP, colour_of))
    });
    let (x_m, y_m) = scan.size_m();
    let title = match scan.missing_points().count() {
        0 => name.to_owned(),
        count => format!("{name}; grey: {count} without a {}", noun(measure)),
    };
    let ends = ["0", &difference(measure, highest - lowest)];
    let size_m = [x_m, y_m.unwrap_or(x_m)];
    Some(FieldPicture::new(&title, size_m, ends, across.len(), colours.collect(), beside))
}

/// Draws the middle row of a map above the histogram of all its values.
fn row_and_histogram(file: &ScanFile, columns: usize, rows: usize) -> Option<Panel> {
    let row = middle_row(&file.scan, columns, rows)?;
    let line = line(&format!("row {} of {rows}", row + 1), file, row * columns..(row + 1) * columns, SMALL)?;
    Some(line.above(&histogram(file, SMALL)?))
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

/// Draws the points of a line, above the lowest point of the scan.
fn line(title: &str, file: &ScanFile, points: Range<usize>, size: [f64; 2]) -> Option<Panel> {
    let scan = &file.scan;
    let (spacing_m, _) = scan.spacing_m();
    let position_m = |index: usize| match scan.positions_m() {
        Some(positions_m) => positions_m[index] - positions_m[0],
        None => index as f64 * spacing_m,
    };
    let (lowest, up) = above_lowest(file)?;
    let along = fitting_unit(scan.size_m().0);
    let mut runs = vec![Vec::new()];
    for (index, at) in points.enumerate() {
        match (scan.height_m(at), runs.last_mut()) {
            (Some(value), Some(run)) => {
                run.push((position_m(index) / along.to_m(1.0), (value - lowest) / up.one));
            }
            (None, Some(run)) if !run.is_empty() => runs.push(Vec::new()),
            _ => {}
        }
    }
    Some(Panel::lines("line", title, [&format!("position ({along})"), &up.label], &runs, size))
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
    Some(Panel::lines("histogram", "", [&up.label, "share of the points (%)"], &[closed], size))
}

/// The lowest value of a scan, and the axis for values above it.
fn above_lowest(ScanFile { scan, measure, .. }: &ScanFile) -> Option<(f64, Scale)> {
    let values = || scan.heights_m().flatten();
    let lowest = values().reduce(f64::min)?;
    Some((lowest, Scale::fitting(measure, values().reduce(f64::max)? - lowest)))
}

/// The noun for the value of a point.
fn noun(measure: &Measure) -> &'static str {
    match measure {
        Measure::Height => "height",
        Measure::Length | Measure::Other(_) => "value",
    }
}

/// A difference of values, with an SI prefix if the values are lengths.
fn difference(measure: &Measure, value: f64) -> String {
    match measure {
        Measure::Height | Measure::Length => length(value),
        Measure::Other(unit) => format!("{} {unit}", three_digits(value)).trim_end().to_owned(),
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
        of_heights(&file(text)).unwrap()
    }

    /// The picture of values, in nm, that are none.
    fn picture_in(unit: &str, text: &str) -> HeightsPicture {
        let mut file = file(text);
        file.measure = Measure::Other(unit.to_owned());
        of_heights(&file).unwrap()
    }

    #[test]
    fn gaps_of_maps_are_grey_and_the_ends_of_the_scale_stand_for_the_ends_of_the_heights() {
        let HeightsPicture::Map(map) = picture("0 1 2 3\n4 5 nan 7\n0 1 2 3\n0 1 2 3\n") else {
            panic!("a map")
        };
        assert_eq!((map.columns, map.colours.len(), map.colours[6]), (4, 16, GAP));
        assert_eq!((map.colours[0], map.colours[7]), (colour(0.0), colour(1.0)));
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
