//! Profiles `x h`.

use super::Found;
use super::body::Body;
use super::columns::Columns;
use super::even_columns::is_counting;
use super::header::Header;
use super::line::line_of_heights;
use super::roles::Mask;
use super::style::FORMAT;
use crate::channel::Lateral;
use crate::choice_of_units::Units;
use crate::error::ScanReadError;
use crate::options::ScanOptions;
use crate::raster::Decoded;
use crate::readers::even_axis::evenly_spaced;

/// The note on positions that may be no lengths.
pub(super) const COUNTED: &str = "the positions are whole numbers without a unit in the file: if they only count the points, give the size of the scan";

/// The columns of a profile, from 0.
#[derive(Clone, Copy)]
pub(super) struct ProfileColumns {
    pub(super) position: usize,
    pub(super) height: usize,
    pub(super) mask: Option<Mask>,
}

/// A profile at even spacing where the printed positions agree with one, else at uneven spacing.
pub(super) fn read(
    body: &Body<'_>,
    columns: &Columns,
    roles: ProfileColumns,
    header: &Header,
    options: &ScanOptions,
    notes: &mut Vec<String>,
) -> Result<Found, ScanReadError> {
    let ProfileColumns { position, height, mask } = roles;
    header.refuse_no_length(position)?;
    header.refuse_no_length(height)?;
    let heights: Vec<Option<f64>> = counting_heights(columns, height, mask);
    let has_unit = header.column_unit(position).is_some();
    if is_counting(columns, position) && (!has_unit || header.is_spaced()) {
        if header.is_spaced() || options.size.or(options.fallback_size).is_some() {
            notes.push(format!("{} counts the points, whose distance is known", header.heads.name(position)));
            let heights: Decoded = heights.into_iter().collect();
            return line_of_heights(heights, header.height_unit(height), None, header, options, notes);
        }
        if options.metadata.is_none() {
            notes.push(COUNTED.to_owned());
        }
    }
    let units = Units::choose(options, header.column_unit(position), header.height_unit(height), notes);
    units.refuse_bare_points(FORMAT)?;
    let (height_to_m, factor) = (units.height_to_m(FORMAT)?, header.table_factor());
    let length_to_m = units.length_to_m(FORMAT)?;
    columns.refuse_missing_points(body, position, height)?;
    let mut rows: Vec<(usize, f64)> =
        columns.measured(position).enumerate().filter_map(|(row, position)| Some((row, position?))).collect();
    let mut heights_m: Vec<Option<f64>> =
        heights.into_iter().map(|height| height.map(|height| height_to_m(height * factor))).collect();
    if rows.len() > 1 && rows.is_sorted_by(|a, b| a.1 > b.1) {
        notes.push("positions fall from line to line: the profile is read from its end".to_owned());
        let last = heights_m.len().saturating_sub(1);
        rows = rows.into_iter().rev().map(|(row, position)| (last - row, position)).collect();
        heights_m.reverse();
    }
    if let Some(pair) = rows.windows(2).find(|pair| pair[0].1 >= pair[1].1) {
        let line = columns.line_of_row(body, pair[1].0);
        return Err(ScanReadError::PositionsDoNotRise { line, position: pair[1].1, before: pair[0].1 });
    }
    let (first, end) = (rows.first().map_or(0, |row| row.0), rows.last().map_or(0, |row| row.0 + 1));
    if let Some(spacing) = spacing_of_rows(&rows, columns.rounding(position)) {
        let heights_m: Decoded = heights_m.into_iter().take(end).skip(first).collect();
        let lateral = Lateral::Spacing { x_m: length_to_m(spacing), y_m: None };
        return Ok(Found { columns: end - first, lateral, heights_m });
    }
    let heights_m: Decoded = rows.iter().map(|&(row, _)| heights_m.get(row).copied().flatten()).collect();
    let positions_m = rows.into_iter().map(|(_, position)| length_to_m(position)).collect();
    Ok(Found { columns: heights_m.values.len(), lateral: Lateral::Positions(positions_m), heights_m })
}

/// Heights without those that a mask says do not count.
fn counting_heights(columns: &Columns, height: usize, mask: Option<Mask>) -> Vec<Option<f64>> {
    let Some(mask) = mask else { return columns.measured(height).collect() };
    let counts =
        columns.measured(mask.column).map(|mark| mark.is_some_and(|mark| (mark != 0.0) == mask.marks_valid));
    columns.measured(height).zip(counts).map(|(height, counts)| height.filter(|_| counts)).collect()
}

/// The spacing of rows with a position, where it is even; rows without one count as missing points.
fn spacing_of_rows(rows: &[(usize, f64)], rounding: f64) -> Option<f64> {
    let (first, last) = (rows.first()?, rows.last()?);
    evenly_spaced(
        rows.iter().map(|&(row, position)| (row - first.0, position)),
        (first.1, last.1),
        last.0 - first.0,
        rounding,
    )
}
