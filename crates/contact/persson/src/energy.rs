//! Elastic energy that the waves in contact store, over that of full contact: the choice that separates the forms of
//! Persson's mean gap.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Deserializer, Serialize, Serializer};
use units::{Bound, OutOfBounds};

/// Elastic energy of the waves in contact over that of full contact, W = g + (1 - g) P^n at an area fraction P.
///
/// As text it is the number g, with n = 2, or `fitted`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnergyFactor {
    /// g.
    pub(crate) light: f64,
    /// n.
    pub(crate) power: f64,
}

impl EnergyFactor {
    /// g = 0.45 and n = 2: Yang & Persson (2008), J. Phys.: Condens. Matter 20:215214; Almqvist et al. (2011), J. Mech. Phys.
    /// Solids 59:2355. The default.
    pub const ALMQVIST: Self = EnergyFactor { light: 0.45, power: 2.0 };

    /// g = 0.45 and n = 2.25, fitted to boundary elements on random spectra of every kind (`docs/develop/trials.md`).
    pub const FITTED: Self = EnergyFactor { light: 0.45, power: 2.25 };

    /// Name of [`FITTED`](Self::FITTED) as text.
    pub const FITTED_NAME: &'static str = "fitted";

    /// Returns the factor with n = 2 and 0 < g <= 1; g = 1 is Persson (2007), Phys. Rev. Lett. 99:125502.
    ///
    /// # Errors
    /// [`OutOfBounds`] for another g.
    pub fn new(light: f64) -> Result<Self, OutOfBounds> {
        let bound = Bound::LeftOpen { above: 0.0, at_most: 1.0 };
        let light = bound.check("the elastic energy factor", light)?;
        Ok(EnergyFactor { light, power: Self::ALMQVIST.power })
    }
}

impl Default for EnergyFactor {
    fn default() -> Self {
        Self::ALMQVIST
    }
}

impl fmt::Display for EnergyFactor {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if *self == Self::FITTED { f.write_str(Self::FITTED_NAME) } else { self.light.fmt(f) }
    }
}

/// Text that is not an energy factor.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EnergyFactorError {
    /// Neither a number nor the name of a form.
    #[error("'{0}' is neither a number nor {fitted}", fitted = EnergyFactor::FITTED_NAME)]
    Unknown(String),
    /// A number out of (0, 1].
    #[error(transparent)]
    OutOfBounds(#[from] OutOfBounds),
}

impl FromStr for EnergyFactor {
    type Err = EnergyFactorError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        if text == Self::FITTED_NAME {
            return Ok(Self::FITTED);
        }
        let light = text.parse().map_err(|_| EnergyFactorError::Unknown(text.to_owned()))?;
        Ok(Self::new(light)?)
    }
}

/// A factor in files: a number, or a name.
#[derive(Serialize, Deserialize)]
#[serde(untagged)]
enum Written {
    Number(f64),
    Name(String),
}

impl Serialize for EnergyFactor {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let written = match *self == Self::FITTED {
            true => Written::Name(self.to_string()),
            false => Written::Number(self.light),
        };
        written.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for EnergyFactor {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let found = match Written::deserialize(deserializer)? {
            Written::Number(light) => Self::new(light).map_err(EnergyFactorError::OutOfBounds),
            Written::Name(name) => name.parse(),
        };
        found.map_err(serde::de::Error::custom)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_are_numbers_or_the_name_of_the_fit() {
        for factor in [EnergyFactor::ALMQVIST, EnergyFactor::FITTED, EnergyFactor::new(1.0).unwrap()] {
            assert_eq!(factor.to_string().parse(), Ok(factor));
        }
        assert!(matches!("0".parse::<EnergyFactor>(), Err(EnergyFactorError::OutOfBounds(_))));
        assert!(matches!("fit".parse::<EnergyFactor>(), Err(EnergyFactorError::Unknown(_))));
    }
}
