//! Column names: a recognised quantity and an optional unit.

use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};

use crate::read::unit::Unit;
use units::named;

/// Quantity of the abscissa of a spectrum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Abscissa {
    /// Wavelength lambda in m.
    Wavelength,
    /// Angular wavevector q = 2 pi/lambda in rad/m.
    Wavevector,
    /// Spatial frequency f = 1/lambda in 1/m.
    Frequency,
}

named!(Abscissa, "abscissa", { Wavelength => "wavelength", Wavevector => "wavevector", Frequency => "frequency" });

impl Abscissa {
    /// Converts a value in SI units to a wavelength \[m\].
    pub(crate) fn wavelength_m(self, value: f64) -> f64 {
        match self {
            Self::Wavelength => value,
            Self::Wavevector => TAU / value,
            Self::Frequency => 1.0 / value,
        }
    }

    /// Returns true if a unit measures this quantity.
    pub(crate) fn fits(self, unit: Unit) -> bool {
        match self {
            Self::Wavelength => unit.metre_power == 1,
            Self::Wavevector => unit.metre_power == -1,
            Self::Frequency => unit.metre_power == -1 && !unit.angular,
        }
    }

    pub(crate) const fn si(self) -> Unit {
        match self {
            Self::Wavelength => Unit::si(1),
            Self::Wavevector | Self::Frequency => Unit::si(-1),
        }
    }
}

/// Names of columns with a spectrum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DensityName {
    C1d,
    W1,
    Ciso,
    /// `C`, only in m^4: Persson's.
    C,
    /// A two-dimensional spectrum, of either convention of areas.
    C2d,
    /// A spectrum whose convention follows from its abscissa and unit.
    Psd,
    /// Gwyddion's name.
    Psdf,
}

/// A quantity that a column may hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Quantity {
    Abscissa(Abscissa),
    Density(DensityName),
    /// The standard error of a spectrum.
    StandardError(DensityName),
}

/// A name for both 2 pi/lambda and 1/lambda.
const WAVENUMBER: &str = "wavenumber";

/// Known names; a name that contains another as its beginning comes before it.
const NAMES: [(&str, Quantity); 23] = [
    ("standard error of psd", Quantity::StandardError(DensityName::Psd)),
    ("psd_se", Quantity::StandardError(DensityName::Psd)),
    ("c1d_se", Quantity::StandardError(DensityName::C1d)),
    ("ciso_se", Quantity::StandardError(DensityName::Ciso)),
    ("wavelength", Quantity::Abscissa(Abscissa::Wavelength)),
    ("lambda", Quantity::Abscissa(Abscissa::Wavelength)),
    ("λ", Quantity::Abscissa(Abscissa::Wavelength)),
    ("wavevector", Quantity::Abscissa(Abscissa::Wavevector)),
    (WAVENUMBER, Quantity::Abscissa(Abscissa::Wavevector)),
    ("q", Quantity::Abscissa(Abscissa::Wavevector)),
    ("k", Quantity::Abscissa(Abscissa::Wavevector)),
    ("frequency", Quantity::Abscissa(Abscissa::Frequency)),
    ("f", Quantity::Abscissa(Abscissa::Frequency)),
    ("spatial frequency", Quantity::Abscissa(Abscissa::Frequency)),
    ("spatial_frequency", Quantity::Abscissa(Abscissa::Frequency)),
    ("psd", Quantity::Density(DensityName::Psd)),
    ("psdf", Quantity::Density(DensityName::Psdf)),
    ("c1d", Quantity::Density(DensityName::C1d)),
    ("w1", Quantity::Density(DensityName::W1)),
    ("ciso", Quantity::Density(DensityName::Ciso)),
    ("c2d", Quantity::Density(DensityName::C2d)),
    ("c", Quantity::Density(DensityName::C)),
    ("Λ", Quantity::Abscissa(Abscissa::Wavelength)),
];

/// A recognised column name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Heading<'h> {
    pub(crate) quantity: Quantity,
    /// Text in the place of the unit, not necessarily a unit.
    pub(crate) unit: Option<&'h str>,
}

impl<'h> Heading<'h> {
    /// Recognises a name in any case, alone or with a unit: `q`, `Lambda_nm`, `PSD (µm³)`, `f [1/mm]`, `λ / nm`.
    ///
    /// A name that continues in words, such as `PSD_error_m3` or `Ciso_approx_m4`, is another quantity.
    pub(crate) fn parse(name: &'h str) -> Option<Self> {
        NAMES.iter().find_map(|&(base, quantity)| {
            let (start, rest) = name.split_at_checked(base.len())?;
            let unit = if start.eq_ignore_ascii_case(base) { unit_suffix(rest)? } else { return None };
            is_meant(quantity, base, unit).then_some(Self { quantity, unit })
        })
    }
}

impl Heading<'_> {
    /// Returns true for the name of a wavenumber, in radians or cycles per length, whose unit does not tell which.
    pub(crate) fn may_count_cycles(name: &str) -> bool {
        let is_wavenumber = name.to_lowercase().starts_with(WAVENUMBER);
        is_wavenumber && !trailing_unit(name).is_some_and(|unit| unit.angular)
    }
}

/// Returns false for an ambiguous one-letter name without the unit of its quantity.
fn is_meant(quantity: Quantity, base: &str, unit: Option<&str>) -> bool {
    let power = unit.map(|unit| Unit::parse(unit).map(|unit| unit.metre_power));
    match (quantity, base) {
        (Quantity::Density(DensityName::C), _) => power == Some(Some(4)),
        (_, "k") => power == Some(Some(-1)),
        _ => true,
    }
}

/// Parses the unit at the end of any name: in brackets, after a slash or after an underscore.
pub(crate) fn trailing_unit(name: &str) -> Option<Unit> {
    name.match_indices(['(', '[', '/', '_', ' '])
        .find_map(|(at, _)| unit_suffix(&name[at..]).flatten().and_then(Unit::parse))
}

/// Returns the text in the place of a unit; `Some(None)` for a bare name, `None` if the name continues.
fn unit_suffix(rest: &str) -> Option<Option<&str>> {
    let trimmed = rest.trim();
    if trimmed.is_empty() {
        return Some(None);
    }
    let in_brackets = |open, close| trimmed.strip_prefix(open)?.strip_suffix(close);
    let unit = in_brackets('(', ')')
        .or_else(|| in_brackets('[', ']'))
        .or_else(|| trimmed.strip_prefix('/'))
        .or_else(|| rest.strip_prefix('_').filter(|unit| is_unit_like(unit)))
        .or_else(|| rest.strip_prefix(' ').filter(|unit| Unit::parse(unit).is_some()))?;
    Some(Some(unit.trim()))
}

/// Returns true for one word, known as a unit or not, and for several words that are a unit.
fn is_unit_like(text: &str) -> bool {
    let is_rate = ["rad_per_", "per_"].iter().any(|start| text.to_ascii_lowercase().starts_with(start));
    is_rate || !text.contains(['_', ' ']) || Unit::parse(text).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wavelength(unit: Option<&str>) -> Option<Heading<'_>> {
        Some(Heading { quantity: Quantity::Abscissa(Abscissa::Wavelength), unit })
    }

    #[test]
    fn names_are_recognised_in_any_case_and_with_any_unit() {
        assert_eq!(Heading::parse("wavelength"), wavelength(None));
        assert_eq!(Heading::parse("LAMBDA_NM"), wavelength(Some("NM")));
        assert_eq!(Heading::parse("λ / nm"), wavelength(Some("nm")));
        assert_eq!(Heading::parse("Λ"), wavelength(None));
        assert_eq!(Heading::parse("wavelength nm"), wavelength(Some("nm")));
        for (name, abscissa, unit) in [
            ("Wavevector (µm⁻¹)", Abscissa::Wavevector, "µm⁻¹"),
            ("q_rad_per_m", Abscissa::Wavevector, "rad_per_m"),
            ("Q[1/m]", Abscissa::Wavevector, "1/m"),
            ("f_per_m", Abscissa::Frequency, "per_m"),
            ("Frequency [1/mm]", Abscissa::Frequency, "1/mm"),
            ("Spatial frequency (1/um)", Abscissa::Frequency, "1/um"),
            ("wavenumber (rad/m)", Abscissa::Wavevector, "rad/m"),
        ] {
            let expected = Heading { quantity: Quantity::Abscissa(abscissa), unit: Some(unit) };
            assert_eq!(Heading::parse(name), Some(expected), "{name}");
        }
        for (name, density, unit) in [
            ("PSD (m³)", DensityName::Psd, Some("m³")),
            ("c1d", DensityName::C1d, None),
            ("Ciso_um4", DensityName::Ciso, Some("um4")),
            ("C1D_furlong", DensityName::C1d, Some("furlong")),
            ("W1 [m^3]", DensityName::W1, Some("m^3")),
            ("PSDF", DensityName::Psdf, None),
            ("C (m^4)", DensityName::C, Some("m^4")),
        ] {
            let expected = Heading { quantity: Quantity::Density(density), unit };
            assert_eq!(Heading::parse(name), Some(expected), "{name}");
        }
    }

    #[test]
    fn standard_errors_are_those_of_a_spectrum() {
        for (name, density, unit) in [
            ("standard error of PSD (m³)", DensityName::Psd, Some("m³")),
            ("C1D_se_m3", DensityName::C1d, Some("m3")),
            ("psd_se", DensityName::Psd, None),
        ] {
            let expected = Heading { quantity: Quantity::StandardError(density), unit };
            assert_eq!(Heading::parse(name), Some(expected), "{name}");
        }
    }

    #[test]
    fn names_that_continue_are_other_names() {
        for name in [
            "PSD_error_m3",
            "Ciso_approx_m4",
            "quality",
            "kurtosis",
            "k_factor",
            "k",
            "C (m^3)",
            "C",
            "column",
            "PSD error",
            "λmax",
            "F0",
            "",
        ] {
            assert_eq!(Heading::parse(name), None, "{name}");
        }
    }

    #[test]
    fn any_name_may_end_in_a_unit() {
        assert_eq!(trailing_unit("Ciso_approx_m4"), Some(Unit::si(4)));
        assert_eq!(trailing_unit("C (m^4)"), Some(Unit::si(4)));
        assert_eq!(trailing_unit("power, smoothed [m^3]"), Some(Unit::si(3)));
        assert_eq!(trailing_unit("column_7"), None);
        assert_eq!(trailing_unit("C"), None);
    }
}
