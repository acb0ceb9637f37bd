//! The conventions in which power spectra are published, and the exact factors between them.

use std::f64::consts::PI;
use units::display::{length, three_digits};

use serde::{Deserialize, Serialize};
use thiserror::Error;

use units::named;

/// Convention of the values of a power spectrum, stated through the variance sigma^2 of the heights.
///
/// q = 2 pi/lambda is the angular wavevector in rad/m and f = 1/lambda the spatial frequency in 1/m. The
/// first three describe profiles and differ by constant factors; so do the last two, which describe areas.
/// See Jacobs, Junge & Pastewka (2017), Surf. Topogr.: Metrol. Prop. 5:013001, for the first and fourth,
/// Persson (2001), J. Chem. Phys. 115:3840, for the last.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Convention {
    /// sigma^2 = (1/pi) Int_0^inf C dq, in m^3 (contact.engineering, SurfaceTopography).
    #[default]
    C1D,
    /// sigma^2 = Int_0^inf W dq, in m^3 (Gwyddion): W = C1D/pi.
    W1,
    /// sigma^2 = Int_0^inf S df, one-sided, in m^3 (ISO 10110-8, optics): S = 2 C1D.
    Frequency,
    /// sigma^2 = (1/2 pi) Int_0^inf q C dq, the radial mean of the two-dimensional spectrum, in m^4.
    Ciso,
    /// sigma^2 = 2 pi Int_0^inf q C dq, in m^4 (Persson): C = Ciso/(4 pi^2).
    Persson,
}

named!(Convention, "convention", {
    C1D => "c1d", W1 => "w1", Frequency => "frequency", Ciso => "ciso", Persson => "persson",
});

/// Errors of converting a spectrum to another convention.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ConversionError {
    /// No pointwise factor exists between line and area spectra.
    #[error(
        "no factor converts values of a spectrum from {from} (m^{}) to {to} (m^{}); convert the whole spectrum",
        from.metre_power(), to.metre_power()
    )]
    NoFactor {
        /// The convention of the data.
        from: Convention,
        /// The requested convention.
        to: Convention,
    },
    /// Fewer than three samples for the Abel integral.
    #[error("converting a spectrum from {from} (m^4) to c1d (m^3): {samples} samples; give at least 3")]
    TooFewSamples {
        /// The convention of the data.
        from: Convention,
        /// Number of samples.
        samples: usize,
    },
    /// A value near the limits of doubles.
    #[error(
        "converting a spectrum from {from} (m^4) to c1d (m^3): {} at {} is not a density; check the units of the spectrum",
        three_digits(*.c1d_m3), length(*.wavelength_m)
    )]
    OutOfRange {
        /// The convention of the data.
        from: Convention,
        /// Wavelength in m.
        wavelength_m: f64,
        /// The value of C1D \[m^3\].
        c1d_m3: f64,
    },
}

impl Convention {
    /// Power of metres in the unit of the values: 3 for profiles, 4 for areas.
    pub const fn metre_power(self) -> i32 {
        match self {
            Self::C1D | Self::W1 | Self::Frequency => 3,
            Self::Ciso | Self::Persson => 4,
        }
    }

    /// Returns the dimensionless factor that converts values of this convention to `to`.
    ///
    /// # Errors
    /// [`ConversionError::NoFactor`] between a profile and an area convention.
    pub fn factor_to(self, to: Self) -> Result<f64, ConversionError> {
        if self == to {
            Ok(1.0)
        } else if self.metre_power() == to.metre_power() {
            Ok(to.per_reference() / self.per_reference())
        } else {
            Err(ConversionError::NoFactor { from: self, to })
        }
    }

    /// Value in this convention per unit of the reference convention of its group (C1D or Ciso).
    fn per_reference(self) -> f64 {
        match self {
            Self::C1D | Self::Ciso => 1.0,
            Self::W1 => 1.0 / PI,
            Self::Frequency => 2.0,
            Self::Persson => 1.0 / (4.0 * PI * PI),
        }
    }
}

#[cfg(test)]
mod tests {
    use serde::de::value::{Error as ValueError, StrDeserializer};
    use serde::de::{Deserialize, IntoDeserializer};

    use super::*;

    #[test]
    fn factors_are_the_defining_ones() {
        let factor = |from: Convention, to| from.factor_to(to).unwrap();
        assert_eq!(factor(Convention::C1D, Convention::W1), 1.0 / PI);
        assert_eq!(factor(Convention::W1, Convention::C1D), PI);
        assert_eq!(factor(Convention::C1D, Convention::Frequency), 2.0);
        assert_eq!(factor(Convention::Frequency, Convention::C1D), 0.5);
        assert_eq!(factor(Convention::W1, Convention::Frequency), 2.0 * PI);
        assert_eq!(factor(Convention::Ciso, Convention::Persson), 0.025330295910584444);
        assert_eq!(factor(Convention::Persson, Convention::Ciso), 4.0 * PI * PI);
    }

    #[test]
    fn no_factor_joins_profile_and_area_conventions() {
        let error = Convention::Ciso.factor_to(Convention::C1D).unwrap_err();
        assert_eq!(
            error.to_string(),
            "no factor converts values of a spectrum from ciso (m^4) to c1d (m^3); convert the whole spectrum"
        );
        for &from in Convention::ALL {
            for &to in Convention::ALL {
                assert_eq!(from.factor_to(to).is_ok(), from.metre_power() == to.metre_power());
            }
        }
    }

    #[test]
    fn serde_display_and_from_str_agree_on_every_name() {
        for &convention in Convention::ALL {
            let name = convention.to_string();
            assert_eq!(name.parse(), Ok(convention));
            let deserializer: StrDeserializer<'_, ValueError> = name.as_str().into_deserializer();
            assert_eq!(Convention::deserialize(deserializer), Ok(convention));
        }
        assert_eq!(
            "C2D".parse::<Convention>().unwrap_err().to_string(),
            "reading the convention: 'C2D' is not one of c1d, w1, frequency, ciso, persson"
        );
    }
}
