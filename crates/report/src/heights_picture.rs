//! Pictures of measured heights: maps in colours, gaps in grey; lines as lines.

use scans::{Measured, ScanFile};
use units::LengthUnit;
use units::display::length;

use crate::field_picture::{FieldPicture, colour};
use crate::plot::line_of_heights;

/// Points along the longer side of a picture; of larger maps, points that lie between are not drawn.
const MOST_POINTS: usize = 1024;
/// The share of the points at either end of the heights that lie beyond the colours: a spike would leave one colour to the rest.
const BEYOND: f64 = 0.002;
const GAP: [u8; 3] = [150; 3];

/// A picture of heights.
#[derive(Debug, Clone, PartialEq)]
pub enum HeightsPicture {
    /// Of a map: colours over a frame.
    Map(FieldPicture),
    /// Of a line: an SVG document.
    Line(String),
}

/// The heights of a scan; none where no point has one.
#[must_use]
pub fn of_heights(file: &ScanFile) -> Option<HeightsPicture> {
    let name = match &file.channel {
        Some(channel) => format!("{}: {channel}", file.name),
        None => file.name.clone(),
    };
    match file.scan.points() {
        (columns, Some(rows)) => map(&name, &file.scan, columns, rows).map(HeightsPicture::Map),
        (_, None) => line(&name, &file.scan).map(HeightsPicture::Line),
    }
}

fn map(name: &str, scan: &Measured, columns: usize, rows: usize) -> Option<FieldPicture> {
    let [lowest_m, highest_m] = coloured_m(scan)?;
    let step = columns.max(rows).div_ceil(MOST_POINTS);
    let across = (0..columns).step_by(step);
    let colour_of =
        |height_m: f64| colour((height_m - lowest_m) / (highest_m - lowest_m).max(f64::MIN_POSITIVE));
    let colours = (0..rows).step_by(step).flat_map(|row| {
        across.clone().map(move |column| scan.height_m(row * columns + column).map_or(GAP, colour_of))
    });
    let (x_m, y_m) = scan.size_m();
    let title = match scan.gaps().count() {
        0 => name.to_owned(),
        count => format!("{name}; grey: {count} without a height"),
    };
    let ends = ["0", &length(highest_m - lowest_m)];
    Some(FieldPicture::new(&title, [x_m, y_m.unwrap_or(x_m)], ends, across.len(), colours.collect()))
}

/// The heights in m that the first and the last colour stand for.
fn coloured_m(scan: &Measured) -> Option<[f64; 2]> {
    let mut heights_m: Vec<f64> = scan.heights_m().flatten().collect();
    let last = heights_m.len().checked_sub(1)?;
    let beyond = (BEYOND * last as f64) as usize;
    let (_, lowest_m, _) = heights_m.select_nth_unstable_by(beyond, f64::total_cmp);
    let lowest_m = *lowest_m;
    let (_, highest_m, _) = heights_m.select_nth_unstable_by(last - beyond, f64::total_cmp);
    Some([lowest_m, *highest_m])
}

fn line(name: &str, scan: &Measured) -> Option<String> {
    let (spacing_m, _) = scan.spacing_m();
    let position_m = |index: usize| match scan.positions_m() {
        Some(positions_m) => positions_m[index] - positions_m[0],
        None => index as f64 * spacing_m,
    };
    let heights_m = || scan.heights_m().flatten();
    let lowest_m = heights_m().reduce(f64::min)?;
    let highest_m = heights_m().reduce(f64::max)?;
    let [along, up] = [scan.size_m().0, highest_m - lowest_m].map(fitting_unit);
    let mut runs = vec![Vec::new()];
    for (index, height_m) in scan.heights_m().enumerate() {
        match (height_m, runs.last_mut()) {
            (Some(height_m), Some(run)) => {
                run.push((position_m(index) / along.to_m(1.0), (height_m - lowest_m) / up.to_m(1.0)));
            }
            (None, Some(run)) if !run.is_empty() => runs.push(Vec::new()),
            _ => {}
        }
    }
    let labels = [format!("position ({along})"), format!("height above the lowest point ({up})")];
    Some(line_of_heights(name, [&labels[0], &labels[1]], &runs))
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

    fn picture(text: &str) -> HeightsPicture {
        let options = ScanOptions {
            unit: Some(LengthUnit::NANOMETRE),
            fallback_size: Some(scans::ScanSize { x_m: 1e-6, y_m: None }),
            ..ScanOptions::default()
        };
        of_heights(&read_scans(text.as_bytes(), "a <b>", &options).unwrap()[0]).unwrap()
    }

    #[test]
    fn gaps_of_maps_are_grey_and_the_ends_of_the_scale_stand_for_the_ends_of_the_heights() {
        let HeightsPicture::Map(map) = picture("0 1 2 3\n4 5 nan 7\n0 1 2 3\n0 1 2 3\n") else {
            panic!("a map")
        };
        assert_eq!((map.columns, map.colours.len(), map.colours[6]), (4, 16, GAP));
        assert_eq!((map.colours[0], map.colours[7]), (colour(0.0), colour(1.0)));
        assert!(map.svg.contains("a &lt;b>") && map.svg.contains(">7 nm</text>"), "{}", map.svg);
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
}
