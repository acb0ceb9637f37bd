//! Leak rate of a seal, from the narrowest place of its last channel: Persson & Yang (2008), J. Phys.: Condens.
//! Matter 20:315011.
//!
//! Were all of the pressure to drop at that place, a slit about as long as it is wide, Q = (L_y/L_x) u_c^3 dp/(12 eta). But
//! flow meets many constrictions in a row: by Reynolds flow solved through the gaps of boundary elements (eight spectra, 48
//! flows), Q is 1.4 to 2.3 times too high at area fractions of 0.003 to 0.03, 2.3 to 15 times at 0.065 to 0.3, and 0.26 to
//! 43 times from there to the percolation threshold, near which a single constriction decides (Dapp & Mueser 2016, Sci.
//! Rep. 6:19513). So the rate is a range.

use units::{Bound, OutOfBounds};

/// Viscosity \[Pa s\] between those of gases, at most 3e-5 in common ones at room temperature, and of liquids, at least 2e-4.
const MOST_VISCOUS_GAS_PA_S: f64 = 8e-5;
/// Pressure of the atmosphere \[Pa\].
const ATMOSPHERE_PA: f64 = 1e5;

/// Joint, pressure drop and fluid.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct SealedJoint {
    breadth_over_length: f64,
    pressure_drop_pa: f64,
    viscosity_pa_s: f64,
}

/// Range of volumes per time \[m^3/s\] that holds solved flows through the gaps of boundary elements.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct LeakRate {
    /// Low end.
    pub low_m3_per_s: f64,
    /// High end.
    pub high_m3_per_s: f64,
}

/// Shares of the formula's rate between which solved flows lie, up to an area fraction and above the one before.
const SHARES: [(f64, [f64; 2]); 3] = [(0.05, [0.25, 1.0]), (0.3, [0.05, 0.5]), (f64::INFINITY, [0.02, 4.0])];

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

    /// Returns how many times the volume at the mean pressure a gas leaves with into the atmosphere, 1 + dp/(2 p); `None` if the
    /// viscosity is that of a liquid.
    #[must_use]
    pub fn gas_expansion(&self) -> Option<f64> {
        let is_gas = self.viscosity_pa_s < MOST_VISCOUS_GAS_PA_S;
        is_gas.then_some(1.0 + 0.5 * self.pressure_drop_pa / ATMOSPHERE_PA)
    }

    /// Computes the range of the leak rate, shares of Q = (L_y/L_x) u_c^3 dp/(12 eta), of a constriction of the height u_c
    /// \[m\] where `area_fraction` of the joint is in contact.
    ///
    /// # Errors
    /// [`OutOfBounds`] unless the height is positive and within thirty decades of 1.
    pub fn leak_rate(&self, height_m: f64, area_fraction: f64) -> Result<LeakRate, OutOfBounds> {
        let height_m = Bound::Magnitude.check("height of the constriction in m", height_m)?;
        let conductance_m3 = self.breadth_over_length * height_m.powi(3) / 12.0;
        let of_formula = conductance_m3 * self.pressure_drop_pa / self.viscosity_pa_s;
        let (_, [low, high]) = SHARES[SHARES.partition_point(|(up_to, _)| *up_to < area_fraction)];
        Ok(LeakRate { low_m3_per_s: low * of_formula, high_m3_per_s: high * of_formula })
    }

    /// Computes the volume per time \[m^3/s\] through an open gap, Q = (L_y/L_x) <g^3> dp/(12 eta), with the mean cube of the gap \[m^3\]
    /// over the joint: all of it open along the flow, which is the most that passes.
    #[must_use]
    pub fn open_rate_m3_per_s(&self, mean_cube_m3: f64) -> f64 {
        self.breadth_over_length * mean_cube_m3 / 12.0 * self.pressure_drop_pa / self.viscosity_pa_s
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_range_of_rates_goes_with_the_cube_of_the_gap() {
        let joint = SealedJoint::new(0.1, 1e-3, 1e5, 1e-3).unwrap();
        let rate = |height_m: f64, area: f64| joint.leak_rate(height_m, area).unwrap();
        // (0.1/1e-3) (1e-7)^3 1e5/(12 1e-3) = 8.33e-13 m^3/s.
        let formula = 1e-11 / 12.0;
        for (area, low, high) in [(0.01, 0.25, 1.0), (0.06, 0.05, 0.5), (0.29, 0.05, 0.5), (0.31, 0.02, 4.0)]
        {
            let LeakRate { low_m3_per_s, high_m3_per_s } = rate(1e-7, area);
            assert!((low_m3_per_s / (formula * low) - 1.0).abs() < 1e-14, "{area}");
            assert!((high_m3_per_s / (formula * high) - 1.0).abs() < 1e-14, "{area}");
        }
        assert!((rate(2e-7, 0.1).low_m3_per_s / rate(1e-7, 0.1).low_m3_per_s - 8.0).abs() < 1e-13);
    }

    #[test]
    fn a_gas_expands_and_a_liquid_does_not() {
        let joint = |viscosity_pa_s| SealedJoint::new(0.1, 1e-3, 5e5, viscosity_pa_s).unwrap();
        assert_eq!(joint(1.8e-5).gas_expansion(), Some(3.5));
        assert_eq!(joint(1e-3).gas_expansion(), None);
    }

    #[test]
    fn extremes_are_finite() {
        for (wide, narrow) in [(1e30, 1e-30), (1e-30, 1e30)] {
            let joint = SealedJoint::new(wide, narrow, wide, narrow).unwrap();
            let LeakRate { low_m3_per_s, high_m3_per_s } = joint.leak_rate(wide, 0.1).unwrap();
            assert!(low_m3_per_s > 0.0 && high_m3_per_s.is_finite());
        }
        let joint = SealedJoint::new(0.1, 1e-3, 1e5, 1e-3).unwrap();
        assert!(joint.leak_rate(0.0, 0.1).is_err() && SealedJoint::new(0.1, 1e-3, 1e5, -1.0).is_err());
    }
}
