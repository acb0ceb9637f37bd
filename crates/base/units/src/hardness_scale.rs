//! Hardness numbers of the scales that certificates use, as pressures.
//!
//! Vickers and Brinell numbers are loads in kgf over the area in mm^2 of the indent itself (ISO 6507-1, ISO 6506-1) and
//! are used unchanged: 9.80665 MPa for 1 HV or 1 HBW. A Rockwell C number is a depth; it becomes a pressure through the
//! Vickers number.

use crate::bound::Bound;
use crate::quantity_error::QuantityError;
use crate::quantity_kind::{HARDNESS, scaled};
use crate::unit_scale::UnitScale;

/// A scale of hardness.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum HardnessScale {
    /// HV.
    Vickers,
    /// HBW, also written HB.
    Brinell,
    /// HRC.
    RockwellC,
}

/// 1 kgf/mm^2 = 9.80665 MPa.
const KGF_PER_MM2: UnitScale = UnitScale::decimal(980_665, 1);

/// Brinell numbers with a ball of hard metal end at 650 (ISO 6506-1): beyond, the ball yields as well.
const BRINELL: Bound = Bound::LeftOpen { above: 0.0, at_most: 650.0 };

/// Range of the Rockwell C scale in table 1 of ASTM E140 (steels that are not austenitic).
const ROCKWELL_C: Bound = Bound::Within { at_least: 20.0, at_most: 68.0 };

impl HardnessScale {
    /// Parses the name of a scale, behind which ISO 6507 and ISO 6506 write the test: `HV 1`, `HV30/20`, `HBW 10/3000`.
    pub(crate) fn parse(unit: &str) -> Option<Self> {
        let (name, test) = unit.split_at(unit.find(|c: char| c.is_ascii_digit()).unwrap_or(unit.len()));
        let is_number = |text: &str| text.parse().is_ok_and(|number: f64| number > 0.0);
        let is_test = test.is_empty() || test.split('/').all(is_number);
        match name.trim_end() {
            "HV" if is_test => Some(HardnessScale::Vickers),
            "HBW" | "HB" if is_test => Some(HardnessScale::Brinell),
            "HRC" if test.is_empty() => Some(HardnessScale::RockwellC),
            _ => None,
        }
    }

    /// Converts `number`, the first part of `text`, to a pressure \[Pa\].
    pub(crate) fn pascals(self, text: &str, number: &str) -> Result<f64, QuantityError> {
        let within = |bound: Bound, quantity: &'static str| {
            let value = scaled(number, UnitScale::ONE);
            bound
                .check(quantity, value)
                .map_err(|error| QuantityError::OffScale { text: text.to_owned(), error })
        };
        match self {
            HardnessScale::Vickers => {}
            HardnessScale::Brinell => {
                // A number <= 0 is not a hardness on any scale; report that first.
                HARDNESS.positive(text, scaled(number, UnitScale::ONE))?;
                within(BRINELL, "Brinell's number")?;
            }
            HardnessScale::RockwellC => {
                let vickers = vickers_of_rockwell_c(within(ROCKWELL_C, "the number of Rockwell's C scale")?);
                return Ok(KGF_PER_MM2.to_si(vickers));
            }
        }
        HARDNESS.positive(text, scaled(number, KGF_PER_MM2))
    }
}

/// Converts a Rockwell C number of a steel to a Vickers number: (223 HRC + 14500)/(100 - HRC).
///
/// Simulations of heat treatment use this closed form. It is within 1.5 % of table 1 of ASTM E140 (steels that are not
/// austenitic) over the whole range; the tests compare it. The pole is where the depth of the cone is 0.
pub(crate) fn vickers_of_rockwell_c(hrc: f64) -> f64 {
    (223.0 * hrc + 14_500.0) / (100.0 - hrc)
}

/// Slope of the hardness \[Pa\] per Rockwell C step at the number `hrc`.
pub(crate) fn pascals_per_rockwell_c(hrc: f64) -> f64 {
    let left = 100.0 - hrc;
    KGF_PER_MM2.to_si((223.0 * left + 223.0 * hrc + 14_500.0) / (left * left))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::IndentationHardness;

    fn pascals(text: &str) -> Result<f64, QuantityError> {
        text.parse::<IndentationHardness>().map(|hardness| hardness.pa)
    }

    #[test]
    fn rockwell_c_becomes_the_vickers_number_of_astm_e140() {
        // Pairs of table 1: HRC, HV.
        for (hrc, vickers) in [
            (20, 238.0),
            (25, 266.0),
            (30, 302.0),
            (40, 392.0),
            (50, 513.0),
            (60, 697.0),
            (65, 832.0),
            (68, 940.0),
        ] {
            let found = pascals(&format!("{hrc} HRC")).unwrap() / 9.80665e6;
            assert!((found / vickers - 1.0f64).abs() < 0.015, "{hrc} HRC: {found}, not {vickers}");
        }
        assert_eq!(pascals("60HRC"), Ok(697.0 * 9.80665e6));
    }

    #[test]
    fn one_step_of_rockwell_c_is_the_slope_of_the_conversion() {
        for hrc in [20.0, 45.0, 68.0] {
            let off = 1e-4;
            let rise = vickers_of_rockwell_c(hrc + off) - vickers_of_rockwell_c(hrc - off);
            let slope = pascals_per_rockwell_c(hrc) / 9.80665e6;
            assert!((rise / (2.0 * off) / slope - 1.0).abs() < 1e-8, "{hrc}");
        }
    }

    #[test]
    fn brinell_is_a_load_over_the_indent_like_vickers() {
        assert_eq!(pascals("200 HBW"), Ok(1_961_330_000.0));
        assert_eq!(pascals("200 HB"), pascals("200 HV"));
    }

    #[test]
    fn numbers_beyond_their_scale_are_refused_with_the_bound() {
        for (text, number) in [("15 HRC", 15.0), ("70 HRC", 70.0), ("-60 HRC", -60.0), ("700 HBW", 700.0)] {
            let Err(QuantityError::OffScale { error, .. }) = pascals(text) else { panic!("{text}") };
            assert_eq!(error.value, number);
        }
        assert!(matches!(pascals("-1 HBW"), Err(QuantityError::NotPositive { what: "hardness", .. })));
    }
}
