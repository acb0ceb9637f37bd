//! Points `x y h` on a regular grid, in any order.

use crate::choice_of_size;
use crate::choice_of_units::Units;
use crate::error::ScanReadError;
use crate::heights::{HeightMap, Scan};
use crate::options::ScanOptions;
use crate::scan_size::ScanSize;
use crate::text::columns::{Columns, line_of_row};
use crate::text::header::Header;
use crate::text::profile::even_spacing;
use crate::text::style::FORMAT;

/// One axis of a grid.
struct Axis {
    first: f64,
    spacing: f64,
    count: usize,
}

/// A map with its rows in the order of rising y.
pub(crate) fn read(
    text: &str,
    columns: &Columns,
    header: &Header,
    options: &ScanOptions,
    notes: &mut Vec<String>,
) -> Result<Scan, ScanReadError> {
    let units = Units::of(options, header.column_unit(0), header.height_unit(2), notes);
    let height_to_m = units.height_to_m(FORMAT)?;
    let x_to_m = units.length_to_m(FORMAT)?;
    let y_to_m = Units { lateral: options.unit.or(header.column_unit(1)).or(units.lateral), ..units }
        .length_to_m(FORMAT)?;
    let x = Axis::find(text, columns, 0)?;
    let y = Axis::find(text, columns, 1)?;
    let mut heights_m = fill(text, columns, &x, &y)?;
    heights_m.iter_mut().for_each(|height| *height = height_to_m(*height));
    let spacings_m = (x_to_m(x.spacing), y_to_m(y.spacing));
    let stated = ScanSize { x_m: spacings_m.0 * x.count as f64, y_m: Some(spacings_m.1 * y.count as f64) };
    match choice_of_size::size(options, Some(stated), notes) {
        Some(size) if size != stated => size.map(x.count, heights_m, notes),
        _ => Ok(Scan::Map(HeightMap::new(x.count, spacings_m.0, spacings_m.1, heights_m)?)),
    }
}

impl Axis {
    fn find(text: &str, columns: &Columns, column: usize) -> Result<Self, ScanReadError> {
        let rounding = columns.rounding(column);
        let mut values: Vec<f64> = columns.column(column).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        let (first, last) = (values[0], values[values.len() - 1]);
        if values.len() == 1 {
            // One column or row, which the map refuses with its own words.
            return Ok(Self { first, spacing: 1.0, count: 1 });
        }
        if let Some(spacing) = even_spacing(&values, rounding) {
            return Ok(Self { first, spacing, count: values.len() });
        }
        // Instruments print the same position with a last digit that varies. The first of a group stands for it, so
        // that a creeping sequence of close values does not merge into one; groups must lie well apart.
        let mut groups = values.clone();
        groups.dedup_by(|value, group| *value - *group <= 2.0 * rounding);
        if let Some(spacing) = even_spacing(&groups, 3.0 * rounding)
            && spacing > 8.0 * rounding
        {
            return Ok(Self { first, spacing, count: groups.len() });
        }
        let count = values.len();
        let axis = Self { first, spacing: (last - first) / (count - 1) as f64, count };
        let off = |value: f64| (value - axis.position(axis.index(value))).abs();
        let (row, position) = (columns.column(column).enumerate())
            .reduce(|worst, next| if off(next.1) > off(worst.1) { next } else { worst })
            .unwrap_or((0, first));
        let (line, axis) = (line_of_row(text, row), ['x', 'y'][column]);
        Err(ScanReadError::NotAGrid { line, axis, position, count, first, last })
    }

    fn index(&self, position: f64) -> usize {
        // A saturating conversion; the bound holds for positions between the first and the last.
        (((position - self.first) / self.spacing).round() as usize).min(self.count - 1)
    }

    fn position(&self, index: usize) -> f64 {
        self.first + index as f64 * self.spacing
    }
}

fn fill(text: &str, columns: &Columns, x: &Axis, y: &Axis) -> Result<Vec<f64>, ScanReadError> {
    // As many grid points as points leave no gap; more would also let two scattered points demand a vast grid.
    let points = columns.rows();
    let size = x.count.checked_mul(y.count).filter(|&size| size <= points);
    let Some(size) = size else { return Err(missing(columns, x, y)) };
    let mut heights = vec![f64::NAN; size];
    for (row, point) in columns.values.chunks_exact(3).enumerate() {
        let height = &mut heights[y.index(point[1]) * x.count + x.index(point[0])];
        if !height.is_nan() {
            let same = |other: &[f64]| {
                x.index(other[0]) == x.index(point[0]) && y.index(other[1]) == y.index(point[1])
            };
            let first = columns.values.chunks_exact(3).position(same).unwrap_or(0);
            let (line, first_line) = (line_of_row(text, row), line_of_row(text, first));
            return Err(ScanReadError::RepeatedPoint { line, first_line, x: point[0], y: point[1] });
        }
        *height = point[2];
    }
    if heights.iter().any(|height| height.is_nan()) { Err(missing(columns, x, y)) } else { Ok(heights) }
}

/// Which points are missing, found from the sorted indices of those that are there.
fn missing(columns: &Columns, x: &Axis, y: &Axis) -> ScanReadError {
    let mut present: Vec<(usize, usize)> =
        columns.values.chunks_exact(3).map(|point| (y.index(point[1]), x.index(point[0]))).collect();
    present.sort_unstable();
    present.dedup();
    let expected = |index: usize| (index / x.count, index % x.count);
    let first = present.iter().enumerate().find(|&(index, &at)| at != expected(index));
    let (row, column) = expected(first.map_or(present.len(), |(index, _)| index));
    ScanReadError::MissingPoints {
        missing: x.count.saturating_mul(y.count).saturating_sub(present.len()),
        columns: x.count,
        rows: y.count,
        x: x.position(column),
        y: y.position(row),
    }
}
