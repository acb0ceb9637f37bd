//! The hardness and the yield strength of the rough body: H = 3 S0 (Tabor 1951), so that either gives the other.

use units::display::pressure;
use units::{IndentationHardness, Pressure, number};

/// H/S0.
pub const HARDNESS_OVER_STRENGTH: f64 = 3.0;

/// The share by which H/S0 may differ from 3 if both are given, so that rounded values of a data sheet pass.
const MISFIT: f64 = 0.01;

/// A hardness and a yield strength that do not belong to one body, by more than 1 % of H = 3 S0.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error(
    "the hardness {} is {} times the yield strength {}; where both are given it must be 3 times it within {} %",
    pressure(*hardness_pa),
    five_digits(*hardness_pa / *yield_strength_pa),
    pressure(*yield_strength_pa),
    100.0 * MISFIT
)]
pub struct HardnessOffStrength {
    /// The indentation hardness H \[Pa\].
    pub hardness_pa: f64,
    /// The yield strength S0 \[Pa\].
    pub yield_strength_pa: f64,
}

/// Formats a ratio with five digits, which shows a deviation of 1 % from 3.
fn five_digits(ratio: f64) -> String {
    format!("{ratio:.4e}").parse().map_or_else(|_| number(ratio), number)
}

/// The hardness and the strength as given; if both are given, their ratio is 3 : 1 within 1 %.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct HardnessAndStrength {
    hardness_pa: Option<f64>,
    yield_strength: Option<Pressure>,
}

impl HardnessAndStrength {
    /// Takes the hardness H > 0 and the yield strength S0; either may be absent.
    ///
    /// # Errors
    /// [`HardnessOffStrength`] if both are given and H/S0 is more than 1 % off 3.
    pub fn new(
        hardness: Option<IndentationHardness>,
        yield_strength: Option<Pressure>,
    ) -> Result<Self, HardnessOffStrength> {
        let given = HardnessAndStrength { hardness_pa: hardness.map(|hardness| hardness.pa), yield_strength };
        let strength_pa = yield_strength.and_then(|strength| strength.pascals(None));
        match given.hardness_pa.zip(strength_pa) {
            Some((hardness_pa, yield_strength_pa))
                if (hardness_pa / (HARDNESS_OVER_STRENGTH * yield_strength_pa) - 1.0).abs() > MISFIT =>
            {
                Err(HardnessOffStrength { hardness_pa, yield_strength_pa })
            }
            _ => Ok(given),
        }
    }

    /// Returns the indentation hardness H \[Pa\]: as given, or else 3 S0.
    #[must_use]
    pub fn hardness_pa(&self) -> Option<f64> {
        let of_strength = || Some(HARDNESS_OVER_STRENGTH * self.yield_strength?.pascals(None)?);
        self.hardness_pa.or_else(of_strength)
    }

    /// Returns the yield strength S0 \[Pa\]: as given, or else H/3. `None` also if it was given in units of the
    /// hardness.
    #[must_use]
    pub fn yield_strength_pa(&self) -> Option<f64> {
        match self.yield_strength {
            Some(strength) => strength.pascals(None),
            None => self.assumed_yield_strength_pa(),
        }
    }

    /// Returns the hardness H \[Pa\] if it was given.
    #[must_use]
    pub fn given_hardness_pa(&self) -> Option<f64> {
        self.hardness_pa
    }

    /// Returns the yield strength S0 \[Pa\] that follows from the hardness, H/3, if no strength was given.
    #[must_use]
    pub fn assumed_yield_strength_pa(&self) -> Option<f64> {
        let hardness_pa = self.hardness_pa.filter(|_| self.yield_strength.is_none())?;
        Some(hardness_pa / HARDNESS_OVER_STRENGTH)
    }

    /// Returns true if the strength was given in units of the hardness, and so cannot yield the hardness.
    #[must_use]
    pub fn strength_is_in_hardnesses(&self) -> bool {
        matches!(self.yield_strength, Some(Pressure::Hardnesses(_)))
    }
}
