//! Leak rate of a seal, from the narrowest place of its last channel: Persson & Yang (2008), J. Phys.: Condens.
//! Matter 20:315011.
//!
//! Almost all of the pressure drops at that place, a slit about as long as it is wide: Q = (L_y/L_x) u_c^3 dp/(12
//! eta). u_c enters by its cube and depends on a percolation threshold, near which a single constriction decides
//! (Dapp & Mueser 2016, Sci. Rep. 6:19513): the rate is an order of magnitude.

use units::{Bound, OutOfBounds};

/// Joint, pressure drop and fluid.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct SealedJoint {
    breadth_over_length: f64,
    pressure_drop_pa: f64,
    viscosity_pa_s: f64,
}

/// Narrowest place of the last channel, of the height u_c.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Constriction {
    height_m: f64,
}

/// Volume per time, to an order of magnitude.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct LeakRate {
    m3_per_s: f64,
}

impl SealedJoint {
    /// Creates a nominal contact of the breadth L_y across the flow and the length L_x along it \[m\], with a
    /// pressure drop dp \[Pa\] of a fluid of the dynamic viscosity eta \[Pa s\].
    ///
    /// # Errors
    /// [`OutOfBounds`] unless all are positive and within thirty decades of 1.
    pub fn new(
        breadth_m: f64,
        length_m: f64,
        pressure_drop_pa: f64,
        viscosity_pa_s: f64,
    ) -> Result<Self, OutOfBounds> {
        let breadth_m = Bound::Magnitude.check("breadth across the flow in m", breadth_m)?;
        let length_m = Bound::Magnitude.check("length along the flow in m", length_m)?;
        Ok(SealedJoint {
            breadth_over_length: breadth_m / length_m,
            pressure_drop_pa: Bound::Magnitude.check("pressure drop in Pa", pressure_drop_pa)?,
            viscosity_pa_s: Bound::Magnitude.check("viscosity in Pa s", viscosity_pa_s)?,
        })
    }

    /// Pressure drop dp \[Pa\].
    #[must_use]
    pub fn pressure_drop_pa(&self) -> f64 {
        self.pressure_drop_pa
    }

    /// Leak rate Q = (L_y/L_x) u_c^3 dp/(12 eta).
    #[must_use]
    pub fn leak_rate(&self, constriction: Constriction) -> LeakRate {
        let conductance_m3 = self.breadth_over_length * constriction.height_m.powi(3) / 12.0;
        LeakRate { m3_per_s: conductance_m3 * self.pressure_drop_pa / self.viscosity_pa_s }
    }
}

impl Constriction {
    /// Creates a constriction of a height u_c \[m\].
    ///
    /// # Errors
    /// [`OutOfBounds`] unless it is positive and within thirty decades of 1.
    pub fn new(height_m: f64) -> Result<Self, OutOfBounds> {
        Ok(Constriction { height_m: Bound::Magnitude.check("height of the constriction in m", height_m)? })
    }

    /// Height u_c \[m\].
    #[must_use]
    pub fn height_m(self) -> f64 {
        self.height_m
    }
}

impl LeakRate {
    /// Leak rate Q \[m^3/s\]; only its order of magnitude has a meaning.
    #[must_use]
    pub fn m3_per_s(self) -> f64 {
        self.m3_per_s
    }

    /// Nearest power of ten on a logarithmic scale.
    #[must_use]
    pub fn power_of_ten(self) -> i32 {
        // Inputs are within thirty decades of 1, so that the rate is neither zero nor infinite, and its power has at
        // most three digits.
        self.m3_per_s.log10().round() as i32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rate_goes_with_the_cube_of_the_gap() {
        let joint = SealedJoint::new(0.1, 1e-3, 1e5, 1e-3).unwrap();
        let rate = |height_m: f64| joint.leak_rate(Constriction::new(height_m).unwrap());
        // (0.1/1e-3) (1e-7)^3 1e5/(12 1e-3) = 8.33e-13 m^3/s.
        assert!((rate(1e-7).m3_per_s() / (1e-11 / 12.0) - 1.0).abs() < 1e-14);
        assert!((rate(2e-7).m3_per_s() / rate(1e-7).m3_per_s() - 8.0).abs() < 1e-13);
        assert_eq!((rate(1e-7).power_of_ten(), rate(1e-6).power_of_ten()), (-12, -9));
    }

    #[test]
    fn extremes_have_a_power_of_ten() {
        let joint = SealedJoint::new(1e-30, 1e30, 1e-30, 1e30).unwrap();
        assert_eq!(joint.leak_rate(Constriction::new(1e-30).unwrap()).power_of_ten(), -211);
        let joint = SealedJoint::new(1e30, 1e-30, 1e30, 1e-30).unwrap();
        assert_eq!(joint.leak_rate(Constriction::new(1e30).unwrap()).power_of_ten(), 209);
        assert!(Constriction::new(0.0).is_err() && SealedJoint::new(0.1, 1e-3, 1e5, -1.0).is_err());
    }
}
