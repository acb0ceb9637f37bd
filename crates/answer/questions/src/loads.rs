//! Nominal pressures of a question.

use std::str::FromStr;

use serde::{Deserialize, Serialize};
use study::material::Material;
use study::plan::{Load, LoadRange, NominalPressure};
use units::{Pressure, PressureRange, QuantityError};

use crate::QuestionError;

/// A nominal pressure and the words it was typed in.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LoadInput {
    /// The pressure, in Pa or in units of the hardness.
    pub pressure: Pressure,
    /// Its label.
    pub label: String,
}

impl LoadInput {
    /// Parses a pressure with its unit that pulls if a minus sign stands before it, such as `-5kPa`.
    ///
    /// # Errors
    /// [`QuantityError`] for text that is not a pressure.
    pub fn parse_signed(text: &str) -> Result<Self, QuantityError> {
        Ok(LoadInput { pressure: Pressure::parse_signed(text)?, label: text.trim().to_owned() })
    }
}

impl FromStr for LoadInput {
    type Err = QuantityError;

    fn from_str(text: &str) -> Result<Self, QuantityError> {
        Ok(LoadInput { pressure: text.parse()?, label: text.trim().to_owned() })
    }
}

/// A nominal pressure in Pa; `label` is the text it was typed in, if the error should name it.
pub(crate) fn nominal_pressure(
    option: &'static str,
    label: Option<&str>,
    pressure: Pressure,
    material: &Material,
) -> Result<NominalPressure, QuestionError> {
    let label = || label.map(str::to_owned);
    let error = |error| QuestionError::Load { option, label: label(), error };
    material.nominal_pressure(pressure).map_err(error)
}

/// Loads with labels, and ranges without.
pub(crate) fn resolved(
    pressures: &[LoadInput],
    ranges: &[PressureRange],
    material: &Material,
) -> Result<(Vec<Load>, Vec<LoadRange>), QuestionError> {
    let load = |LoadInput { pressure, label }: &LoadInput| {
        let nominal_pressure = nominal_pressure("pressure", Some(label), *pressure, material)?;
        Ok(Load { nominal_pressure, label: label.clone() })
    };
    let range = |range: &PressureRange| {
        let [from, to] = [range.from, range.to].map(|end| nominal_pressure("pressures", None, end, material));
        Ok(LoadRange::new(from?, to?, range.points))
    };
    let loads = pressures.iter().map(load).collect::<Result<_, QuestionError>>()?;
    Ok((loads, ranges.iter().map(range).collect::<Result<_, QuestionError>>()?))
}

/// All nominal pressures \[Pa\], ranges last.
pub(crate) fn pressures_pa(
    pressures: &[LoadInput],
    ranges: &[PressureRange],
    material: &Material,
) -> Result<Vec<f64>, QuestionError> {
    let (loads, ranges) = resolved(pressures, ranges, material)?;
    let of_ranges = ranges.into_iter().flat_map(LoadRange::pressures);
    Ok(loads.iter().map(|load| load.nominal_pressure).chain(of_ranges).map(NominalPressure::pa).collect())
}
