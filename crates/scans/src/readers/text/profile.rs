//! Profiles `x h`.

use super::Found;
use super::columns::{Columns, line_of_row};
use super::header::Header;
use super::style::FORMAT;
use crate::channel::Lateral;
use crate::choice_of_units::Units;
use crate::error::ScanReadError;
use crate::options::ScanOptions;

/// The share of the spacing that the rounding of printed positions may take up before even spacing is a guess.
const DISCERNIBLE: f64 = 0.25;

/// A profile at even spacing where the printed positions agree with one, else at uneven spacing.
pub(super) fn read(
    text: &str,
    columns: Columns,
    header: &Header,
    options: &ScanOptions,
    notes: &mut Vec<String>,
) -> Result<Found, ScanReadError> {
    let units = Units::of(options, header.column_unit(0), header.height_unit(1), notes);
    let height_to_m = units.height_to_m(FORMAT)?;
    let length_to_m = units.length_to_m(FORMAT)?;
    columns.refuse_gaps(text, 0)?;
    let mut positions: Vec<f64> = columns.column(0).collect();
    let mut heights_m: Vec<Option<f64>> = columns.measured(1).map(|height| height.map(&height_to_m)).collect();
    if positions.first() > positions.last() && positions.is_sorted_by(|a, b| a > b) {
        notes.push("positions fall from line to line: the profile is read from its end".to_owned());
        positions.reverse();
        heights_m.reverse();
    }
    if let Some(row) = positions.windows(2).position(|pair| pair[0] >= pair[1]) {
        return Err(ScanReadError::PositionsDoNotRise {
            line: line_of_row(text, row + 1),
            position: positions[row + 1],
            before: positions[row],
        });
    }
    let lateral = match even_spacing(&positions, columns.rounding(0)) {
        Some(spacing) => Lateral::Spacing { x_m: length_to_m(spacing), y_m: None },
        None => Lateral::Positions(positions.into_iter().map(length_to_m).collect()),
    };
    Ok(Found { columns: heights_m.len(), lateral, heights_m: heights_m.into_iter().collect() })
}

/// The spacing of rising positions that are evenly spaced within the rounding of their digits.
pub(crate) fn even_spacing(positions: &[f64], rounding: f64) -> Option<f64> {
    let (&first, &last) = (positions.first()?, positions.last()?);
    let spacing = (last - first) / (positions.len() - 1) as f64;
    let bound = rounding.min(DISCERNIBLE * spacing);
    let is_even =
        |(index, position): (usize, &f64)| (position - (first + index as f64 * spacing)).abs() <= bound;
    (positions.len() > 1 && positions.iter().enumerate().all(is_even)).then_some(spacing)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spacings_are_even_within_the_printed_digits() {
        let rounded: Vec<f64> = (0..1000).map(|i| (f64::from(i) * 99.56).round() / 1e6).collect();
        assert!((even_spacing(&rounded, 1e-6).unwrap() / 99.56e-6 - 1.0).abs() < 1e-5);
        assert_eq!(even_spacing(&rounded, 1e-7), None);
        let cut_off: Vec<f64> = (0..1000).map(|i| (f64::from(i) * 99.56).floor() / 1e6).collect();
        assert!(even_spacing(&cut_off, 1e-6).is_some());
        // Whole numbers that are not evenly spaced are no rounded thirds.
        assert_eq!(even_spacing(&[0.0, 1.0, 3.0, 4.0], 1.0), None);
        assert_eq!(even_spacing(&[0.0, 1.0, 2.0, 3.0], 1.0), Some(1.0));
        assert_eq!(even_spacing(&[1.0], 1.0), None);
    }
}
