//! Points `x y h` on a regular grid, in any order.

use super::Found;
use super::body::Body;
use super::columns::Columns;
use super::header::Header;
use super::profile::COUNTED;
use super::style::FORMAT;
use crate::channel::Lateral;
use crate::choice_of_units::Units;
use crate::error::ScanReadError;
use crate::options::ScanOptions;
use crate::raster::Decoded;
use crate::readers::even_axis::{ScanAxis, points_of_grid};

/// The columns of the points, from 0.
#[derive(Clone, Copy)]
pub(super) struct PointColumns {
    pub(super) x: usize,
    pub(super) y: usize,
    pub(super) height: usize,
}

/// A map with its rows in the order of rising y.
pub(super) fn read(
    body: &Body<'_>,
    columns: &Columns,
    places: PointColumns,
    header: &Header,
    options: &ScanOptions,
    notes: &mut Vec<String>,
) -> Result<Found, ScanReadError> {
    let PointColumns { x: at_x, y: at_y, height } = places;
    for column in [at_x, at_y, height] {
        header.refuse_no_length(column)?;
    }
    let units = Units::choose(options, header.column_unit(at_x), header.height_unit(height), notes);
    units.refuse_bare_points(FORMAT)?;
    let (height_to_m, factor) = (units.height_to_m(FORMAT)?, header.table_factor());
    let x_to_m = units.length_to_m(FORMAT)?;
    let y_to_m = Units { lateral: options.unit.or(header.column_unit(at_y)).or(units.lateral), ..units }
        .length_to_m(FORMAT)?;
    columns.refuse_missing_points(body, at_x, height)?;
    columns.refuse_missing_points(body, at_y, height)?;
    let x = axis(body, columns, at_x, 'x')?;
    let y = axis(body, columns, at_y, 'y')?;
    let counts = [&x, &y].iter().all(|axis| axis.spacing == 1.0 && [0.0, 1.0].contains(&axis.first));
    let is_counted = counts && [at_x, at_y].iter().all(|column| header.heads.unit(*column).is_none());
    let has_size = options.size.or(options.fallback_size).is_some();
    let lateral = if is_counted && header.is_spaced() {
        notes.push("the places count the points, whose distance the header states".to_owned());
        header.size(x.count, y.count, &units)?.map(Lateral::Size)
    } else if is_counted && header.column_unit(at_x).is_none() && has_size {
        notes.push("the places count the points of a map whose size is given".to_owned());
        Some(Lateral::Unknown)
    } else {
        notes.extend((counts && header.column_unit(at_x).is_none()).then(|| COUNTED.to_owned()));
        None
    };
    let heights = fill(body, columns, places, &x, &y)?;
    let heights_m = heights
        .into_iter()
        .map(|height| height.flatten().map(|height| height_to_m(height * factor)))
        .collect::<Decoded>();
    let spaced = Lateral::Spacing { x_m: x_to_m(x.spacing), y_m: Some(y_to_m(y.spacing)) };
    Ok(Found { columns: x.count, lateral: lateral.unwrap_or(spaced), heights_m })
}

/// The axis of a column of positions; the error tells which lies farthest off an even one.
fn axis(body: &Body<'_>, columns: &Columns, column: usize, axis: char) -> Result<ScanAxis, ScanReadError> {
    let values: Vec<f64> = columns.measured(column).flatten().collect();
    let rounding = columns.rounding(column);
    if let Some(found) = ScanAxis::fit(values.clone(), rounding) {
        return Ok(found);
    }
    let nearest = ScanAxis::nearest(values).ok_or(ScanReadError::NoRows)?;
    let off = |value: f64| (value - nearest.position(nearest.index(value))).abs();
    let known = |(row, value): (usize, Option<f64>)| Some((row, value?));
    let (row, position) = (columns.measured(column).enumerate().filter_map(known))
        .reduce(|worst, next| if off(next.1) > off(worst.1) { next } else { worst })
        .unwrap_or((0, nearest.first));
    let line = columns.line_of_row(body, row);
    let ScanAxis { first, count, .. } = nearest;
    Err(ScanReadError::NotAGrid { line, axis, position, count, first, last: nearest.position(count - 1) })
}

/// The height of every grid point that the file has a line for, which may say that it is missing.
fn fill(
    body: &Body<'_>,
    columns: &Columns,
    places: PointColumns,
    x: &ScanAxis,
    y: &ScanAxis,
) -> Result<Vec<Option<Option<f64>>>, ScanReadError> {
    let points = columns.rows();
    let size = points_of_grid(x, y, points).ok_or(ScanReadError::Scattered {
        points,
        columns: x.count,
        rows: y.count,
    })?;
    let mut heights = vec![None; size];
    // Lines without a position have no height either.
    let positions =
        || columns.measured(places.x).zip(columns.measured(places.y)).map(|(x, y)| Some((x?, y?)));
    let index = |(at_x, at_y): (f64, f64)| y.index(at_y) * x.count + x.index(at_x);
    for (row, (at, height)) in positions().zip(columns.measured(places.height)).enumerate() {
        let Some(at) = at else { continue };
        let place = &mut heights[index(at)];
        if place.is_some() {
            let first = positions().position(|other| other.map(index) == Some(index(at))).unwrap_or(0);
            let (line, first_line) = (columns.line_of_row(body, row), columns.line_of_row(body, first));
            return Err(ScanReadError::RepeatedPoint { line, first_line, x: at.0, y: at.1 });
        }
        *place = Some(height);
    }
    Ok(heights)
}
