//! Quantities as people type them: a number and its unit, `463 GPa`, `5um`, `1e-3 H`.

use std::str::FromStr;

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::hardness_scale::{HardnessScale, pascals_per_rockwell_c};
use crate::quantity_error::QuantityError;
use crate::quantity_kind::{
    AREA, FORCE, FORCE_PER_LENGTH, HARDNESS, HARDNESS_UNIT, LENGTH, MODULUS, PRESSURE, RESISTIVITY,
    SPECIFIC_RESISTANCE, TEMPERATURE, THERMAL_CONDUCTIVITY, VISCOSITY, WORK_OF_ADHESION, scaled,
};
use crate::unit_scale::UnitScale;

/// Defines quantities that are positive values of one kind, each with the unit of its value.
macro_rules! positive {
    ($($(#[$doc:meta])* $type:ident { $field:ident: $unit:literal } of $kind:ident,)+) => {
        $($(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct $type {
            #[doc = $unit]
            pub $field: f64,
        }

        impl FromStr for $type {
            type Err = QuantityError;

            fn from_str(text: &str) -> Result<Self, QuantityError> {
                Ok($type { $field: $kind.parse(text)? })
            }
        })+
    };
}

positive!(
    /// A length > 0.
    Length { m: "In metres." } of LENGTH,
    /// A force > 0.
    Force { n: "In newtons." } of FORCE,
    /// A force per length > 0.
    ForcePerLength { n_per_m: "In newtons per metre." } of FORCE_PER_LENGTH,
    /// An area > 0.
    Area { m2: "In square metres." } of AREA,
    /// A modulus > 0.
    Modulus { pa: "In pascals." } of MODULUS,
    /// An absolute temperature > 0.
    Temperature { k: "In kelvins." } of TEMPERATURE,
    /// A thermal conductivity > 0.
    ThermalConductivity { w_per_m_k: "In watts per metre and kelvin." } of THERMAL_CONDUCTIVITY,
    /// An electrical resistivity > 0.
    Resistivity { ohm_m: "In ohm metres." } of RESISTIVITY,
    /// A specific resistance of an interface > 0, per area.
    SpecificResistance { ohm_m2: "In ohm square metres." } of SPECIFIC_RESISTANCE,
    /// A dynamic viscosity > 0.
    Viscosity { pa_s: "In pascal seconds." } of VISCOSITY,
    /// A work of adhesion > 0.
    WorkOfAdhesion { j_per_m2: "In joules per square metre." } of WORK_OF_ADHESION,
);

/// A length of either sign, or zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SignedLength {
    /// In metres.
    pub m: f64,
}

/// An indentation hardness > 0: a pressure or a Vickers, Brinell or Rockwell C number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IndentationHardness {
    /// In pascals. A Vickers or Brinell number is the load over the area of the indent itself, 9.80665 MPa for 1 HV
    /// (ISO 6507) or 1 HBW (ISO 6506); a Rockwell C number is first converted to a Vickers number.
    pub pa: f64,
}

impl IndentationHardness {
    /// Converts a standard uncertainty in Rockwell C steps of a Rockwell C hardness to \[Pa\]; `None` for any other
    /// unit of the uncertainty.
    ///
    /// The conversion needs the hardness: a step is worth more pressure the harder the body is.
    ///
    /// # Errors
    /// [`QuantityError::WrongUnit`] if the hardness is not in HRC, [`QuantityError::Uncertainty`] for steps below 0.
    pub fn uncertainty_of_steps(hardness: &str, uncertainty: &str) -> Result<Option<f64>, QuantityError> {
        let is_steps = |unit| HardnessScale::parse(unit) == Some(HardnessScale::RockwellC);
        let Ok((steps, unit)) = HARDNESS.split(uncertainty) else { return Ok(None) };
        if !is_steps(unit) {
            return Ok(None);
        }
        let (number, unit) = HARDNESS.split(hardness)?;
        if !is_steps(unit) {
            return Err(HARDNESS.wrong_unit(uncertainty, "HRC"));
        }
        let steps = scaled(steps, UnitScale::ONE);
        if !(steps >= 0.0 && steps.is_finite()) {
            return Err(QuantityError::Uncertainty { text: uncertainty.to_owned() });
        }
        Ok(Some(steps * pascals_per_rockwell_c(scaled(number, UnitScale::ONE))))
    }
}

/// A pressure > 0, in Pa or as a multiple of the hardness H = 3 S0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pressure {
    /// In pascals.
    Pascals(f64),
    /// In units of the hardness.
    Hardnesses(f64),
}

impl Pressure {
    /// Returns the pressure \[Pa\]; `None` for a multiple of the hardness without `hardness_pa`.
    #[must_use]
    pub fn pascals(self, hardness_pa: Option<f64>) -> Option<f64> {
        match self {
            Pressure::Pascals(pa) => Some(pa),
            Pressure::Hardnesses(share) => hardness_pa.map(|hardness_pa| share * hardness_pa),
        }
    }
}

impl FromStr for SignedLength {
    type Err = QuantityError;

    fn from_str(text: &str) -> Result<Self, QuantityError> {
        let m = LENGTH.parse_signed(text)?;
        if m.is_finite() {
            Ok(SignedLength { m })
        } else {
            Err(QuantityError::NotFinite { text: text.to_owned() })
        }
    }
}

impl FromStr for IndentationHardness {
    type Err = QuantityError;

    fn from_str(text: &str) -> Result<Self, QuantityError> {
        let (number, unit) = HARDNESS.split(text)?;
        let pa = match HardnessScale::parse(unit) {
            Some(scale) => scale.pascals(text, number)?,
            None => HARDNESS.parse(text)?,
        };
        Ok(IndentationHardness { pa })
    }
}

impl Pressure {
    /// Parses a pressure that a minus sign in front makes a pull.
    ///
    /// # Errors
    /// The errors of parsing a pressure; zero is refused.
    pub fn parse_signed(text: &str) -> Result<Self, QuantityError> {
        match text
            .trim_start()
            .strip_prefix('-')
            .filter(|size| size.starts_with(|c: char| c.is_ascii_digit() || c == '.'))
        {
            Some(size) => size.parse().map(|pressure| match pressure {
                Pressure::Pascals(pa) => Pressure::Pascals(-pa),
                Pressure::Hardnesses(hardnesses) => Pressure::Hardnesses(-hardnesses),
            }),
            None => text.parse(),
        }
    }
}

impl FromStr for Pressure {
    type Err = QuantityError;

    fn from_str(text: &str) -> Result<Self, QuantityError> {
        let (number, unit) = PRESSURE.split(text)?;
        if unit == HARDNESS_UNIT {
            return Ok(Pressure::Hardnesses(PRESSURE.positive(text, scaled(number, UnitScale::ONE))?));
        }
        Ok(Pressure::Pascals(PRESSURE.parse(text)?))
    }
}

impl Serialize for Pressure {
    /// Writes the pressure with its unit; the digits survive the way there and back.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Pressure::Pascals(pa) => serializer.collect_str(&format_args!("{pa} Pa")),
            Pressure::Hardnesses(multiple) => serializer.collect_str(&format_args!("{multiple} H")),
        }
    }
}

impl<'de> Deserialize<'de> for Pressure {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(D::Error::custom)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn metres(text: &str) -> f64 {
        text.parse::<Length>().unwrap().m
    }

    #[test]
    fn a_minus_sign_makes_a_pull_where_it_is_asked_for() {
        assert_eq!(Pressure::parse_signed("-5kPa"), Ok(Pressure::Pascals(-5e3)));
        assert_eq!(Pressure::parse_signed("5kPa"), Ok(Pressure::Pascals(5e3)));
        for refused in ["--5kPa", "0Pa", "-0Pa", "- 5kPa", "-"] {
            assert!(Pressure::parse_signed(refused).is_err(), "{refused}");
        }
        assert!("-5kPa".parse::<Pressure>().is_err());
    }

    #[test]
    fn units_move_the_decimal_point_and_round_once() {
        for (text, expected) in [
            ("5um", 5e-6),
            ("5 µm", 5e-6),
            ("9.8 nm", 9.8e-9),
            ("5.65e0nm", 5.65e-9),
            ("3 Å", 3e-10),
            ("2e-3 mm", 2e-6),
            ("5 microns", 5e-6),
            ("1 inch", 0.0254),
            ("0.1 in", 2.54e-3),
            ("32 uin", 8.128e-7),
            ("3 Angstrom", 3e-10),
        ] {
            assert_eq!(metres(text), expected, "{text}");
        }
        assert_eq!("463 GPa".parse::<Pressure>(), Ok(Pressure::Pascals(463e9)));
        assert_eq!("1.8e9 Pa".parse::<Pressure>(), Ok(Pressure::Pascals(1.8e9)));
        assert_eq!("1e-3 H".parse::<Pressure>(), Ok(Pressure::Hardnesses(1e-3)));
        assert_eq!("1e-3H".parse::<Pressure>().unwrap().pascals(Some(5.4e9)), Some(1e-3 * 5.4e9));
        assert_eq!("1e-3H".parse::<Pressure>().unwrap().pascals(None), None);
        assert_eq!("1 psi".parse(), Ok(Pressure::Pascals(6_894.757293168361)));
        assert_eq!("50 ksi".parse::<Modulus>().unwrap().pa, 344_737_864.65841805);
        assert_eq!("2.5 cm^2".parse::<Area>().unwrap().m2, 2.5e-4);
        assert_eq!("10 mN".parse::<Force>().unwrap().n, 10e-3);
        assert_eq!("10 N/mm".parse::<ForcePerLength>().unwrap().n_per_m, 1e4);
        assert!("10 N".parse::<ForcePerLength>().is_err() && "0 N/m".parse::<ForcePerLength>().is_err());
    }

    #[test]
    fn a_hardness_is_a_pressure_or_a_vickers_number_and_no_multiple_of_itself() {
        let pascals = |text: &str| text.parse::<IndentationHardness>().map(|hardness| hardness.pa);
        assert_eq!(pascals("3 GPa"), Ok(3e9));
        assert_eq!(pascals("300 HV"), Ok(2_941_995_000.0));
        assert_eq!(pascals("0.1HV"), Ok(980_665.0));
        for (text, vickers) in [
            ("120 HV 1", 120.0),
            ("640 HV30", 640.0),
            ("640 HV 30/20", 640.0),
            ("200 HBW 10/3000", 200.0),
            ("350HBW5/750/15", 350.0),
        ] {
            assert_eq!(pascals(text).map(|pa| (pa / 9.80665e6 * 1e9).round()), Ok(vickers * 1e9), "{text}");
        }
        for text in ["120 HV 0", "120 HV x", "120 HV 1/", "60 HRC 1", "90 HRB"] {
            assert!(matches!(pascals(text), Err(QuantityError::WrongUnit { .. })), "{text}");
        }
        assert_eq!(
            pascals("1 H").unwrap_err().to_string(),
            "'1 H' has the unit 'H'; a hardness needs one of Pa, hPa, kPa, bar, MPa, GPa, TPa, psi, ksi, HV, HBW, HRC"
        );
        assert_eq!(
            pascals("300").unwrap_err().to_string(),
            "'300' has no unit; a hardness needs one of Pa, hPa, kPa, bar, MPa, GPa, TPa, psi, ksi, HV, HBW, HRC, as in '3 GPa'"
        );
        assert!(matches!(pascals("-1 HV"), Err(QuantityError::NotPositive { what: "hardness", .. })));
        assert!("300 HV".parse::<Pressure>().is_err() && "300 HV".parse::<Modulus>().is_err());
    }

    #[test]
    fn an_uncertainty_in_steps_of_rockwell_c_needs_a_hardness_of_that_scale() {
        let found = |hardness, steps| IndentationHardness::uncertainty_of_steps(hardness, steps);
        // (223 x 40 + 223 x 60 + 14500)/40^2 of a Vickers number.
        assert_eq!(found("60 HRC", "1 HRC"), Ok(Some(23.0 * 9.80665e6)));
        assert_eq!(found("60 HRC", "0 HRC"), Ok(Some(0.0)));
        assert_eq!(found("60 HRC", "20 HV"), Ok(None));
        assert!(matches!(found("7 GPa", "1 HRC"), Err(QuantityError::WrongUnit { .. })));
        assert!(matches!(found("60 HRC", "-1 HRC"), Err(QuantityError::Uncertainty { .. })));
    }

    #[test]
    fn conductivities_and_resistivities_have_units_of_their_own() {
        for (text, expected) in [
            ("46 W/(m K)", 46.0),
            ("46 W/m/K", 46.0),
            ("46W/(mK)", 46.0),
            ("0.46 W/(cm K)", 46.0),
            ("25 mW/mK", 0.025),
        ] {
            assert_eq!(text.parse::<ThermalConductivity>().unwrap().w_per_m_k, expected, "{text}");
        }
        for (text, expected) in [
            ("1.7e-8 ohm m", 1.7e-8),
            ("1.7 uohm cm", 1.7e-8),
            ("1.7 µΩ·cm", 1.7e-8),
            ("17 nΩ m", 1.7e-8),
            ("0.017 Ω mm²/m", 1.7e-8),
        ] {
            assert_eq!(text.parse::<Resistivity>().unwrap().ohm_m, expected, "{text}");
        }
        let conductivity = |text: &str| text.parse::<ThermalConductivity>().unwrap_err();
        assert!(matches!(conductivity("46"), QuantityError::NoUnit { what: "thermal conductivity", .. }));
        assert!(matches!(conductivity("-46 W/(m K)"), QuantityError::NotPositive { .. }));
        for (text, expected) in [("2 ohm m^2", 2.0), ("3e-9 Ω cm²", 3e-13), ("4 uohm mm^2", 4e-12)] {
            let found = text.parse::<SpecificResistance>().unwrap().ohm_m2;
            assert!((found / expected - 1.0).abs() < 1e-14, "{text}: {found}");
        }
        assert!("1e-12".parse::<SpecificResistance>().is_err());
        let resistance = "5 ohm".parse::<Resistivity>().unwrap_err();
        assert!(matches!(resistance, QuantityError::WrongUnit { unit, .. } if unit == "ohm"));
    }

    #[test]
    fn viscosities_and_works_of_adhesion_have_units_of_their_own() {
        for (text, expected) in
            [("1 mPa s", 1e-3), ("1.8e-5 Pa s", 1.8e-5), ("18 µPa·s", 1.8e-5), ("1 cP", 1e-3)]
        {
            assert_eq!(text.parse::<Viscosity>().unwrap().pa_s, expected, "{text}");
        }
        for (text, expected) in [("50 mJ/m^2", 0.05), ("0.05 J/m²", 0.05), ("50 mN/m", 0.05)] {
            assert_eq!(text.parse::<WorkOfAdhesion>().unwrap().j_per_m2, expected, "{text}");
        }
        assert!("1".parse::<Viscosity>().is_err() && "-1 J/m^2".parse::<WorkOfAdhesion>().is_err());
    }

    #[test]
    fn a_slip_of_the_keyboard_is_refused_with_what_may_be_meant() {
        let refused = |text: &str| text.parse::<Pressure>().unwrap_err();
        let meant = |text: &str| match refused(text) {
            QuantityError::UnitCase { meant, .. } => meant,
            QuantityError::Comma { meant, .. } | QuantityError::PowerOfTen { meant, .. } => vec![meant],
            other => panic!("{text}: {other}"),
        };
        assert_eq!(meant("10 mpa"), ["10 MPa", "10e-3 Pa"]);
        assert_eq!(meant("10 mPa"), ["10 MPa", "10e-3 Pa"]);
        assert_eq!(meant("2gpa"), ["2 GPa"]);
        assert_eq!(meant("0.1 h"), ["0.1 H"]);
        assert_eq!(meant("10,5 mpa"), ["10.5 mpa"]);
        assert_eq!(meant("5x10^9 Pa"), ["5e9 Pa"]);
        let length = |text: &str| match text.parse::<Length>().unwrap_err() {
            QuantityError::UnitCase { meant, .. } => meant,
            other => panic!("{text}: {other}"),
        };
        assert_eq!((length("5 NM"), length("5 Um")), (vec!["5 nm".to_owned()], vec!["5 um".to_owned()]));
        let force = "5 mn".parse::<Force>().unwrap_err();
        assert!(matches!(force, QuantityError::UnitCase { meant, .. } if meant == ["5 mN", "5 MN"]));
        assert_eq!("2 kN/mm2".parse::<Modulus>().unwrap().pa, 2e9);
        assert_eq!("10 mbar".parse::<Pressure>(), Ok(Pressure::Pascals(1e3)));
    }

    #[test]
    fn an_invalid_quantity_is_refused_with_a_valid_example() {
        let error = |text: &str| text.parse::<Pressure>().unwrap_err();
        assert!(matches!(error("463e9"), QuantityError::NoUnit { example: "5.4 MPa", .. }));
        assert!(matches!(error("463 um"), QuantityError::WrongUnit { unit, .. } if unit == "um"));
        for text in ["-5 MPa", "1e999 Pa", "1e99999999999999999999 Pa"] {
            assert!(matches!(error(text), QuantityError::NotPositive { what: "pressure", .. }), "{text}");
        }
        for text in ["GPa", "inf Pa"] {
            assert!(matches!(error(text), QuantityError::NoNumber { example: "5.4 MPa", .. }), "{text}");
        }
        let ampere = "5 A".parse::<Length>().unwrap_err();
        assert!(matches!(ampere, QuantityError::WrongUnit { what: "length", unit, .. } if unit == "A"));
        assert!("5".parse::<Length>().is_err());
        assert!("0 m".parse::<Length>().is_err());
    }

    #[test]
    fn lists_and_forces_are_no_pressures() {
        let error = |text: &str| text.parse::<Pressure>().unwrap_err();
        for list in ["10MPa,20MPa", "10 MPa; 1e-3 H", "1 MPa,"] {
            let several = matches!(error(list), QuantityError::Several { values, .. } if values.len() == 2);
            assert_eq!(several, !list.ends_with(','), "{list}");
        }
        let ends = |text: &str| match error(text) {
            QuantityError::Several { values, .. } => values,
            other => panic!("{other}"),
        };
        assert_eq!(ends("1-50MPa"), ["1 MPa", "50 MPa"]);
        assert!(matches!(error("1e-3m"), QuantityError::WrongUnit { .. }));
        let celsius = "20 °C".parse::<Temperature>().unwrap_err();
        assert!(matches!(celsius, QuantityError::UnitCase { meant, .. } if meant == ["293.15 K"]));
        assert!(matches!(error("10N"), QuantityError::Force { text } if text == "10N"));
        assert!(matches!("10N".parse::<Length>(), Err(QuantityError::WrongUnit { .. })));
    }
}
