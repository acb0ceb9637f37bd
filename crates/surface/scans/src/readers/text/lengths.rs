//! Lengths and units as the headers of text files write them.

use super::style::{FORMAT, shortened};
use crate::error::{FilePlace, ScanReadError};
use units::LengthUnit;

/// A length as written; without a unit it is in that of the lateral positions.
#[derive(Clone, Copy)]
pub(super) struct Length {
    pub(super) value: f64,
    pub(super) unit: Option<LengthUnit>,
}

/// Points that spacings are given for.
const PER_POINT: [&str; 6] = ["/pixel", "/px", "/point", "/pt", "/sample", "/cell"];

/// A number with or without a unit; none for what is not a number, the key of something else.
pub(super) fn length(text: &str, line: usize) -> Result<Option<Length>, ScanReadError> {
    let unit_at = text.find(|c: char| !c.is_ascii_digit() && !"+-.,eE".contains(c)).unwrap_or(text.len());
    let (number, name) = text.split_at(unit_at);
    let number = number.trim_end_matches(',').replace(',', ".");
    let Ok(value) = number.parse::<f64>() else { return Ok(None) };
    if !(value.is_finite() && value > 0.0) {
        return Err(bad_field(line, "the length", text, "finite and above 0".to_owned()));
    }
    // Of `0.5 um/pixel` and `138.4,nm`.
    let name = name.trim_matches(|c: char| c.is_whitespace() || ",;".contains(c));
    let name = PER_POINT.iter().find_map(|point| name.strip_suffix(point)).unwrap_or(name).trim_end();
    Ok(Some(Length { value, unit: if name.is_empty() { None } else { Some(unit(name, line)?) } }))
}

/// The factor of heights, and their unit where it follows.
pub(super) fn factor(text: &str, line: usize) -> Result<(f64, Option<LengthUnit>), ScanReadError> {
    let (number, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    let rest = rest.trim();
    Ok((numbered_factor(number, line)?, if rest.is_empty() { None } else { Some(unit(rest, line)?) }))
}

/// A factor, which is finite and not 0.
pub(super) fn numbered_factor(number: &str, line: usize) -> Result<f64, ScanReadError> {
    let parsed =
        number.replace(',', ".").parse().ok().filter(|factor: &f64| factor.is_finite() && *factor != 0.0);
    let bound = || "a finite number other than 0".to_owned();
    parsed.ok_or_else(|| bad_field(line, "the factor of heights", number, bound()))
}

/// A unit of length.
pub(super) fn unit(text: &str, line: usize) -> Result<LengthUnit, ScanReadError> {
    let text = text.trim_matches(|c: char| c.is_whitespace() || "()[]".contains(c));
    LengthUnit::parse_instrument(text)
        .ok_or_else(|| bad_field(line, "the unit", text, format!("one of {}", LengthUnit::accepted())))
}

pub(super) fn bad_field(line: usize, field: &str, value: &str, bound: String) -> ScanReadError {
    let mend = "export a channel of heights, or correct the header";
    FORMAT.bad(FilePlace::Line(line), field, format!("'{}'", shortened(value)), bound, mend)
}

/// The radius in a line on the stylus, as Dektak exports write it: `Stylus,Radius: 2.5 µm`.
pub(super) fn stylus_radius_m(line: &str) -> Option<f64> {
    let line = line.to_lowercase();
    let (_, radius) = line.strip_prefix("stylus")?.split_once("radius")?;
    let radius = radius.trim_start_matches([':', '=', ' ']).trim_end_matches([',', ';', ' ']);
    let length = length(radius, 0).ok()??;
    Some(length.unit?.to_m(length.value))
}

/// The unit at the end of a column's name: `X_(microns)`, `Lateral um`, `h/nm`, `x_mm`. A bare A is a name more often
/// than a unit.
pub(super) fn trailing_unit(name: &str) -> Option<LengthUnit> {
    let name = name.trim();
    if let Some((_, unit)) = name.strip_suffix([')', ']']).and_then(|name| name.rsplit_once(['(', '['])) {
        return LengthUnit::parse_instrument(unit);
    }
    let (_, word) = name.rsplit_once([' ', '/', '_'])?;
    LengthUnit::parse_instrument(word).filter(|_| word != "A")
}
