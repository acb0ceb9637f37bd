//! Columns without names, assigned by the caller's options and units.

use crate::convention::Convention;
use crate::read::error::{LineProblem, ReadError};
use crate::read::header::Abscissa;
use crate::read::layout::{AbscissaColumn, DensityColumn, ErrorColumn, Layout};
use crate::read::options::{GivenUnit, GivenUnits, ReadOptions, UnitError};
use crate::read::series::{ColumnKind, Columns};
use units::UnitScale;

/// Assigns an abscissa, a spectrum and, in JSON, its standard errors.
///
/// Missing quantities follow from the given units; missing units default to SI. Notes state both.
pub(crate) fn nameless(
    columns: &Columns,
    options: &ReadOptions,
    units: &GivenUnits<'_>,
    notes: &mut Vec<String>,
) -> Result<Layout, ReadError> {
    let (line, count) = (columns.line, columns.names.len());
    if let Some(column) = &options.column {
        return Err(
            LineProblem::UnknownColumn { column: column.clone(), found: columns.names.clone() }.at(line)
        );
    }
    let is_json = columns.kind != ColumnKind::Numbered;
    if is_json && (units.x.is_none() || units.psd.is_none()) {
        return Err(UnitError::Missing { line }.into());
    }
    let mut assumed = Vec::new();
    let quantity = options
        .x
        .or_else(|| units.x.map(|given| abscissa_in(given.unit.metre_power, given.text, &mut assumed)));
    let convention = options.convention.or_else(|| {
        units.psd.map(|given| convention_in(given.unit.metre_power, given.text, quantity, &mut assumed))
    });
    let (Some(quantity), Some(convention)) = (quantity, convention) else {
        return Err(LineProblem::NoHeader.at(line));
    };
    if count != 2 && !is_json {
        return Err(LineProblem::HeaderlessColumns { columns: count }.at(line));
    }
    notes.append(&mut assumed);
    match (units.x, units.psd) {
        (Some(_), Some(_)) => {}
        (None, None) => notes.push("the file states no units; its columns are read in SI units".to_owned()),
        (None, _) => {
            notes.push(format!("the file states no unit of the {quantity}, which is read in SI units"))
        }
        (_, None) => {
            notes.push("the file states no unit of the spectrum, which is read in SI units".to_owned())
        }
    }
    let scale = |given: Option<GivenUnit>| given.map_or(UnitScale::ONE, |given| given.unit.scale());
    let density_scale = scale(units.psd);
    Ok(Layout {
        abscissa: AbscissaColumn { index: 0, quantity, scale: scale(units.x) },
        checks: Vec::new(),
        density: DensityColumn { index: 1, scale: density_scale, convention },
        standard_error: (count > 2).then_some(ErrorColumn { index: 2, scale: density_scale }),
    })
}

fn abscissa_in(metre_power: i32, unit: &str, notes: &mut Vec<String>) -> Abscissa {
    let quantity = if metre_power == 1 { Abscissa::Wavelength } else { Abscissa::Wavevector };
    notes.push(format!("the first column, in {unit}, is read as the {quantity}"));
    quantity
}

fn convention_in(
    metre_power: i32,
    unit: &str,
    abscissa: Option<Abscissa>,
    notes: &mut Vec<String>,
) -> Convention {
    let (convention, meaning) = match (metre_power, abscissa) {
        (3, Some(Abscissa::Frequency)) => (
            Convention::Frequency,
            "is given against frequency and is read as the one-sided spectrum S of frequency, sigma^2 = Int S df",
        ),
        (3, _) => (Convention::C1D, "is read as C1D, sigma^2 = (1/pi) Int C dq"),
        _ => (Convention::Ciso, "is read as Ciso, sigma^2 = (1/2 pi) Int q C dq"),
    };
    notes.push(format!("the second column, in {unit}, {meaning}"));
    convention
}
