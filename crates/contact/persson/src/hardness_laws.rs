//! Laws of the hardness over the scale.
//!
//! None of these laws comes with Persson's theory; the user chooses one. A hardness may only grow towards short
//! wavelengths: if it fell, plastic contact would have to carry more than it can.

use thiserror::Error;
use units::{Bound, OutOfBounds};

use crate::hardness_path::{HardnessKnot, HardnessPath};
use crate::roughness::Roughness;

/// Hardness along a spectrum: a law and an optional cap.
#[derive(Debug, Clone, PartialEq)]
pub struct CappedHardness {
    growth: HardnessGrowth,
    /// Hardness at which its growth ends \[Pa\].
    cap_pa: Option<f64>,
}

/// Growth law of a hardness towards short wavelengths.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum HardnessGrowth {
    /// Constant hardness.
    Constant {
        /// H > 0 \[Pa\].
        hardness_pa: f64,
    },
    /// Power law H = H_0 (q/q_first)^n.
    Power {
        /// H_0 > 0 at the longest wavelength of the spectrum \[Pa\].
        hardness_pa: f64,
        /// n >= 0.
        exponent: f64,
    },
    /// Strain-gradient law H = H_0 sqrt(1 + h*/h_p); the depth h_p is the smallest amplitude so far (Nix & Gao 1998,
    /// J. Mech. Phys. Solids 46:411).
    NixGao {
        /// H_0 > 0 \[Pa\].
        hardness_pa: f64,
        /// The strain-gradient length h* > 0 \[m\].
        length_m: f64,
    },
    /// Table measured against the size of the contact; the wavelength is taken as that size.
    Table(HardnessTable),
}

/// Hardness over contact size, as measured by indentation: a power law between neighbours, constant beyond the ends.
#[derive(Debug, Clone, PartialEq)]
pub struct HardnessTable {
    /// Sizes \[m\] and hardnesses \[Pa\], by rising size.
    rows: Vec<(f64, f64)>,
}

/// Reason why a hardness cannot be used.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum HardnessError {
    /// A number is out of its range.
    #[error(transparent)]
    Bound(#[from] OutOfBounds),
    /// The table has no rows.
    #[error("the table of hardnesses is empty")]
    Empty,
    /// A size is given twice.
    #[error("the table of hardnesses gives the size {size_m:e} m twice")]
    Repeated {
        /// The size \[m\].
        size_m: f64,
    },
    /// The hardness falls towards short wavelengths.
    #[error(
        "the hardness falls from {before_pa:e} Pa to {hardness_pa:e} Pa at a wavelength of {wavelength_m:e} m; it may only grow towards short wavelengths"
    )]
    Falling {
        /// First wavelength \[m\] of the spectrum at which it is smaller than at the one before.
        wavelength_m: f64,
        /// Hardness at that wavelength \[Pa\].
        hardness_pa: f64,
        /// Hardness at the wavelength before \[Pa\].
        before_pa: f64,
    },
    /// The growing hardness cannot carry the load at the longest wavelength.
    #[error(
        "the nominal pressure {pressure_pa:e} Pa is not below the hardness {hardness_pa:e} Pa at the longest wavelength, {wavelength_m:e} m"
    )]
    Exceeded {
        /// The nominal pressure \[Pa\].
        pressure_pa: f64,
        /// The hardness \[Pa\] at the longest wavelength.
        hardness_pa: f64,
        /// The longest wavelength \[m\].
        wavelength_m: f64,
    },
}

impl HardnessTable {
    /// Creates the table from sizes \[m\] and hardnesses \[Pa\], in any order.
    ///
    /// # Errors
    /// [`HardnessError`] for an empty table, a repeated size, and numbers that are not finite and positive.
    pub fn new(rows: impl IntoIterator<Item = (f64, f64)>) -> Result<Self, HardnessError> {
        let mut rows: Vec<(f64, f64)> = rows.into_iter().collect();
        for &(size_m, hardness_pa) in &rows {
            Bound::Magnitude.check("the size of a contact in m", size_m)?;
            Bound::Magnitude.check("the hardness in Pa", hardness_pa)?;
        }
        rows.sort_by(|a, b| a.0.total_cmp(&b.0));
        if let Some(pair) = rows.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            return Err(HardnessError::Repeated { size_m: pair[0].0 });
        }
        if rows.is_empty() { Err(HardnessError::Empty) } else { Ok(HardnessTable { rows }) }
    }

    /// Returns the sizes \[m\] and hardnesses \[Pa\], by rising size.
    #[must_use]
    pub fn rows(&self) -> &[(f64, f64)] {
        &self.rows
    }

    /// Hardness \[Pa\] of a contact of a size \[m\].
    #[must_use]
    pub fn hardness_pa(&self, size_m: f64) -> f64 {
        let above = self.rows.partition_point(|row| row.0 <= size_m);
        let (lower, upper) = (self.rows[above.saturating_sub(1)], self.rows[above.min(self.rows.len() - 1)]);
        if above == 0 || above == self.rows.len() {
            return lower.1;
        }
        let share = (size_m / lower.0).ln() / (upper.0 / lower.0).ln();
        lower.1 * (upper.1 / lower.1).powf(share)
    }
}

impl CappedHardness {
    /// Creates a hardness that follows a law, up to `cap_pa` if given.
    ///
    /// # Errors
    /// [`HardnessError::Bound`] for numbers out of the range of the law, and for a cap below the hardness at long
    /// wavelengths.
    pub fn new(growth: HardnessGrowth, cap_pa: Option<f64>) -> Result<Self, HardnessError> {
        let least_pa = match growth {
            HardnessGrowth::Constant { hardness_pa } => hardness_pa,
            HardnessGrowth::Power { hardness_pa, exponent } => {
                Bound::AtLeast(0.0).check("the exponent of the hardness", exponent)?;
                hardness_pa
            }
            HardnessGrowth::NixGao { hardness_pa, length_m } => {
                Bound::Magnitude.check("the strain-gradient length in m", length_m)?;
                hardness_pa
            }
            HardnessGrowth::Table(ref table) => table.rows[table.rows.len() - 1].1,
        };
        Bound::Magnitude.check("the hardness in Pa", least_pa)?;
        if let Some(cap_pa) = cap_pa {
            Bound::AtLeast(least_pa).check("the upper limit of the hardness in Pa", cap_pa)?;
        }
        Ok(CappedHardness { growth, cap_pa })
    }

    /// Growth law of this hardness.
    #[must_use]
    pub fn growth(&self) -> &HardnessGrowth {
        &self.growth
    }

    /// Returns the hardness \[Pa\] at each wavevector of a roughness.
    ///
    /// # Errors
    /// [`HardnessError::Falling`] if it is smaller than at the wavevector before.
    pub fn along(&self, roughness: &Roughness) -> Result<Vec<f64>, HardnessError> {
        let mut all: Vec<f64> = Vec::with_capacity(roughness.places().len());
        let mut least_depth_m = f64::INFINITY;
        let first = roughness.places().first().map_or(1.0, |place| place.wavevector_rad_per_m);
        for place in roughness.places() {
            let hardness_pa = match &self.growth {
                HardnessGrowth::Constant { hardness_pa } => *hardness_pa,
                HardnessGrowth::Power { hardness_pa, exponent } => {
                    hardness_pa * (place.wavevector_rad_per_m / first).powf(*exponent)
                }
                HardnessGrowth::NixGao { hardness_pa, length_m } => {
                    least_depth_m = least_depth_m.min(place.amplitude_m);
                    hardness_pa * (1.0 + length_m / least_depth_m).sqrt()
                }
                HardnessGrowth::Table(table) => table.hardness_pa(place.wavelength_m),
            };
            if let Some(&before_pa) = all.last().filter(|&&before_pa| hardness_pa < before_pa) {
                return Err(HardnessError::Falling {
                    wavelength_m: place.wavelength_m,
                    hardness_pa,
                    before_pa,
                });
            }
            all.push(hardness_pa);
        }
        Ok(all)
    }

    /// Returns the hardness \[Pa\] at the longest wavelength of a roughness; infinite if there is none.
    ///
    /// # Errors
    /// [`HardnessError::Falling`] as in [`along`](Self::along).
    pub fn at_longest_pa(&self, roughness: &Roughness) -> Result<f64, HardnessError> {
        let first_pa = self.along(roughness)?.first().copied().unwrap_or(f64::INFINITY);
        Ok(self.cap_pa.map_or(first_pa, |cap_pa| first_pa.min(cap_pa)))
    }

    /// Returns the hardness as a function of the variance of the flattening pressure, for a contact modulus E* > 0
    /// \[Pa\].
    ///
    /// # Errors
    /// [`HardnessError::Falling`] as in [`along`](Self::along).
    pub fn path(
        &self,
        roughness: &Roughness,
        contact_modulus_pa: f64,
    ) -> Result<HardnessPath, HardnessError> {
        let knot = |(place, hardness_pa): (&crate::roughness::Place, f64)| HardnessKnot {
            wavevector_rad_per_m: place.wavevector_rad_per_m,
            variance_pa2: place.variance_pa2(contact_modulus_pa),
            hardness_pa,
            variance_exponent: place.variance_exponent,
        };
        let knots: Vec<HardnessKnot> =
            roughness.places().iter().zip(self.along(roughness)?).map(knot).collect();
        let path = HardnessPath::through(&knots);
        Ok(match self.cap_pa {
            Some(cap_pa) => path.capped(cap_pa),
            None => path,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::roughness::RoughnessSample;

    fn roughness(amplitudes_m: [f64; 4]) -> Roughness {
        let sample = |(i, amplitude_m): (usize, &f64)| RoughnessSample {
            wavelength_m: 10f64.powi(-(i as i32)),
            c1d_m3: 1e-3f64.powi(i as i32),
            moments: [i as f64; 3],
            amplitude_m: *amplitude_m,
        };
        let samples: Vec<RoughnessSample> = amplitudes_m.iter().enumerate().map(sample).collect();
        Roughness::new(&samples, None)
    }

    fn along(growth: HardnessGrowth) -> Result<Vec<f64>, HardnessError> {
        CappedHardness::new(growth, None)?.along(&roughness([1e-6, 1e-8, 4e-8, 1e-10]))
    }

    #[test]
    fn each_law_agrees_with_its_formula() {
        assert_eq!(along(HardnessGrowth::Constant { hardness_pa: 5.0 }), Ok(vec![5.0; 4]));
        let power = along(HardnessGrowth::Power { hardness_pa: 5.0, exponent: 0.5 }).unwrap();
        assert!((power[2] / 50.0 - 1.0).abs() < 1e-15);
        // The third amplitude is larger than the second: the depth stays at the smallest so far.
        let gradient = along(HardnessGrowth::NixGao { hardness_pa: 5.0, length_m: 3e-8 }).unwrap();
        assert!((gradient[1] / 10.0 - 1.0).abs() < 1e-15);
        assert_eq!(gradient[2], gradient[1]);
        let table = HardnessTable::new([(0.01, 8.0), (1.0, 2.0)]).unwrap();
        assert_eq!(along(HardnessGrowth::Table(table)), Ok(vec![2.0, 4.0, 8.0, 8.0]));
    }

    #[test]
    fn a_hardness_that_falls_is_refused_with_its_wavelength() {
        let table = HardnessTable::new([(0.01, 8.0), (0.1, 9.0), (1.0, 2.0)]).unwrap();
        let error = along(HardnessGrowth::Table(table)).unwrap_err();
        let HardnessError::Falling { wavelength_m, hardness_pa, before_pa } = error else {
            panic!("{error}")
        };
        assert!((wavelength_m / 0.01 - 1.0).abs() < 1e-12);
        assert!((hardness_pa / 8.0 - 1.0).abs() < 1e-12 && (before_pa / 9.0 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn hardnesses_out_of_bounds_are_refused() {
        let refused = |growth, cap_pa| CappedHardness::new(growth, cap_pa).unwrap_err().to_string();
        let power = |hardness_pa, exponent| HardnessGrowth::Power { hardness_pa, exponent };
        assert_eq!(
            refused(power(1.0, -0.1), None),
            "the exponent of the hardness is -0.1; it must be finite and at least 0"
        );
        assert_eq!(
            refused(power(0.0, 0.1), None),
            "the hardness in Pa is 0; it must be finite and greater than 0"
        );
        assert_eq!(
            refused(power(2.0, 0.1), Some(1.0)),
            "the upper limit of the hardness in Pa is 1; it must be finite and at least 2"
        );
        assert_eq!(HardnessTable::new([]), Err(HardnessError::Empty));
        let twice = HardnessTable::new([(1.0, 2.0), (1.0, 3.0)]);
        assert_eq!(twice, Err(HardnessError::Repeated { size_m: 1.0 }));
    }
}
