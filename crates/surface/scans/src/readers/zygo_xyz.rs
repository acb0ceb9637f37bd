//! Zygo's XYZ text, `.xyz`: fourteen lines of numbers, then a line for each point, between two lines of `#`.
//!
//! The fourth line holds the corner and the size of the map in points, the seventh number of the eighth the distance of
//! points in m; heights are in um, and `No Data` marks points without one. Public programs that read and write these
//! files agree on it.

use std::str::SplitWhitespace;

use crate::channel::{Channel, Lateral, Quantity, Samples};
use crate::error::{FilePlace, ScanReadError, quoted};
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::numbers;
use crate::options::ScanOptions;
use crate::raster::Decoded;
use crate::readers::Reader;
use crate::readers::text::decode;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::ZygoXyz;
const MAGIC: &str = "Zygo XYZ Data File";
/// The line of the corner and the size, and that of the distance of points.
const MAP_LINE: usize = 4;
const OPTICS_LINE: usize = 8;
/// The place of the distance of points in its line.
const DISTANCE: usize = 6;
/// Above the points and below them.
const FENCE: &str = "#";
/// The mark of points without a height, which may be two words.
const NO_DATA: &str = "no";
/// Most points of the map for each line of the file: more would be no map, and two lines could demand a vast one.
const SPARSEST: usize = 4;
const MEND: &str = "export the file again";

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC.as_bytes())
}

fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let text = decode(bytes)?;
    let mut lines = text.lines().enumerate().map(|(index, line)| (index + 1, line.trim()));
    let header: Vec<&str> = lines.by_ref().map(|(_, line)| line).take_while(|line| *line != FENCE).collect();
    let map = Map::read(&header, text.lines().count())?;
    let mut heights: Vec<Option<f64>> = vec![None; map.columns * map.rows];
    let mut is_closed = false;
    let mut points = 0;
    for (line, point) in lines.filter(|(_, line)| !line.is_empty()) {
        if point == FENCE {
            is_closed = true;
            break;
        }
        let (index, height) = map.point(line, point)?;
        heights[index] = height;
        points += 1;
    }
    if !is_closed && points < heights.len() {
        let bound = format!("{}, or a line of {FENCE} behind the last", heights.len());
        return Err(FORMAT.bad(FilePlace::File, "the number of points", points, bound, MEND));
    }
    let decoded: Decoded = heights.into_iter().collect();
    let samples = Samples::Decoded { columns: map.columns, decoded };
    let quantity = Quantity::Heights(Some(LengthUnit::MICROMETRE));
    Ok(vec![Channel { probe: Some(Probe::Microscope), ..Channel::new(None, quantity, map.lateral, samples) }])
}

/// The map that the points lie on.
struct Map {
    corner: [usize; 2],
    columns: usize,
    rows: usize,
    lateral: Lateral,
}

impl Map {
    fn read(header: &[&str], lines: usize) -> Result<Self, ScanReadError> {
        let line = |number: usize| {
            let found = header.get(number - 1).filter(|line| !line.is_empty());
            found.ok_or_else(|| FORMAT.missing(FilePlace::Line(number), "line of the header", MEND))
        };
        let mut fields = line(MAP_LINE)?.split_whitespace();
        let mut whole = |what: &str| whole(&mut fields, MAP_LINE, what);
        let corner = [whole("the first column")?, whole("the first row")?];
        let (columns, rows) = (whole("the number of columns")?, whole("the number of rows")?);
        let points = columns.checked_mul(rows).filter(|points| (1..=lines * SPARSEST).contains(points));
        points.ok_or_else(|| {
            let (size, bound) =
                (format!("{columns} x {rows}"), format!("above 0 and filled by {lines} lines"));
            FORMAT.bad(FilePlace::Line(MAP_LINE), "the number of points", size, bound, MEND)
        })?;
        let distance = line(OPTICS_LINE)?.split_whitespace().nth(DISTANCE);
        let distance_m = distance.and_then(numbers::finite).and_then(numbers::positive);
        let lateral = distance_m.map_or(Lateral::Unknown, |distance_m| Lateral::Spacing {
            x_m: distance_m,
            y_m: Some(distance_m),
        });
        Ok(Self { corner, columns, rows, lateral })
    }

    /// The place of a point in the map, and its height where it has one.
    fn point(&self, line: usize, point: &str) -> Result<(usize, Option<f64>), ScanReadError> {
        let mut fields = point.split_whitespace();
        let at = [whole(&mut fields, line, "the column")?, whole(&mut fields, line, "the row")?];
        let place = |axis: usize, count: usize| {
            at[axis].checked_sub(self.corner[axis]).filter(|place| *place < count)
        };
        let (Some(column), Some(row)) = (place(0, self.columns), place(1, self.rows)) else {
            let bound = format!("within the {} x {} points of line {MAP_LINE}", self.columns, self.rows);
            let found = format!("{} {}", at[0], at[1]);
            return Err(FORMAT.bad(FilePlace::Line(line), "the place of a point", found, bound, MEND));
        };
        let height = fields.next().unwrap_or_default();
        let is_missing = height.to_ascii_lowercase().starts_with(NO_DATA);
        match numbers::finite(height) {
            None if !is_missing => Err(ScanReadError::NotANumber { line, column: 3, text: quoted(height) }),
            height => Ok((row * self.columns + column, height)),
        }
    }
}

/// The next whole number of a line.
fn whole(fields: &mut SplitWhitespace<'_>, line: usize, what: &str) -> Result<usize, ScanReadError> {
    let field = fields.next().unwrap_or_default();
    let bad = |_| FORMAT.bad(FilePlace::Line(line), what, quoted(field), "a whole number from 0 on", MEND);
    field.parse().map_err(bad)
}
