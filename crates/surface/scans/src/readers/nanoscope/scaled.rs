//! Values with units in the header of a Nanoscope file.

use super::header::Value;
use crate::error::ScanReadError;
use units::LengthUnit;

/// A value such as `V [Sens. Zsens] (0.0067 V/LSB) 2.125 V`.
pub(super) struct Scaled {
    /// The name in square brackets, that of a sensitivity in another section.
    pub(super) soft_scale: Option<String>,
    rest: String,
}

impl Scaled {
    pub(super) fn parse(text: &str) -> Option<Self> {
        let mut rest = text.strip_prefix(['V', 'C', 'S'])?.trim_start();
        let mut soft_scale = None;
        if let Some(inner) = rest.strip_prefix('[') {
            let (name, after) = inner.split_once(']')?;
            (soft_scale, rest) =
                (Some(name.trim().to_owned()).filter(|name| !name.is_empty()), after.trim_start());
        }
        if rest.starts_with('(') {
            // Units hold brackets of their own: log(Arb).
            let mut depth = 0;
            let end = rest.find(|character| {
                depth += i32::from(character == '(') - i32::from(character == ')');
                depth == 0
            })?;
            rest = rest[end + 1..].trim_start();
        }
        Some(Self { soft_scale, rest: rest.to_owned() })
    }

    /// The number and its unit.
    pub(super) fn number(&self) -> Option<(f64, String)> {
        let (number, unit) = self.rest.split_once(char::is_whitespace).unwrap_or((&self.rest, ""));
        Some((number.parse().ok().filter(|value: &f64| value.is_finite())?, unit.trim().to_owned()))
    }
}

/// Value of a unit of voltage in V.
pub(super) fn volt(unit: &str) -> Option<f64> {
    Some(match unit.trim() {
        "V" => 1.0,
        "mV" => 1e-3,
        "µV" | "uV" | "~V" => 1e-6,
        _ => return None,
    })
}

/// Parses one or two lengths with a unit; one counts for both.
pub(super) fn lengths(value: &Value) -> Result<[f64; 2], ScanReadError> {
    let bad = || value.bad("one or two lengths above 0 with their unit, such as '500 500 nm'");
    let mut words: Vec<&str> = value.text.split_whitespace().collect();
    let unit = words.pop().and_then(LengthUnit::parse_instrument).ok_or_else(bad)?;
    let sizes: Option<Vec<f64>> =
        words.iter().map(|word| word.parse().ok().map(|size| unit.to_m(size))).collect();
    match sizes.as_deref() {
        Some(&[x] | &[x, _]) if !(x.is_finite() && x > 0.0) => Err(bad()),
        Some(&[x]) => Ok([x, x]),
        Some(&[x, y]) if y.is_finite() && y > 0.0 => Ok([x, y]),
        _ => Err(bad()),
    }
}
