//! Leak rate of a seal, by the effective medium of its gaps.
//!
//! A medium of the conductance s, the cube of the parallel slot that lets as much through, passes Q = (L_y/L_x) s dp/(12 eta). Reynolds
//! flow solved through the gaps of boundary elements tells how far that is off (`docs/develop/trials.md`): the rate is a range, which
//! holds single pieces of a surface four of its longest waves long and wide. Narrower ones scatter more.

use units::{Bound, OutOfBounds};

use crate::sealed_fluid::SealedFluid;

/// Joint, pressure drop and fluid.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct SealedJoint {
    breadth_m: f64,
    length_m: f64,
    pressure_drop_pa: f64,
    fluid: SealedFluid,
}

/// Range of volumes per time \[m^3/s\] that holds solved flows through the gaps of boundary elements.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct LeakRate {
    /// Low end.
    pub low_m3_per_s: f64,
    /// High end.
    pub high_m3_per_s: f64,
}

/// Longest waves that fit into the shorter side of a joint for which [`RANGES`] hold.
const WAVES: f64 = 4.0;
/// Longest waves that a joint counts with if it has fewer.
const FEWEST_WAVES: f64 = 1.0;
/// Growth of half of the width with the share in contact, and with the inverse of the waves on the square of the shorter side over that
/// of [`WAVES`].
const SCATTER: f64 = 1.25;

/// Area fraction, and the low and the high end of solved flows over that of the effective medium. Their logarithms are straight in between.
const RANGES: [(f64, [f64; 2]); 5] = [
    (0.0, [0.75, 1.3]),
    (0.15, [0.83, 1.45]),
    (0.29, [0.62, 2.4]),
    (0.34, [0.28, 4.2]),
    (0.40, [0.02, 15.0]),
];

impl SealedJoint {
    /// Creates a nominal contact of the breadth L_y across the flow and the length L_x along it \[m\], with a
    /// pressure drop dp \[Pa\] of a fluid.
    ///
    /// # Errors
    /// [`OutOfBounds`] unless all, and the viscosity of the fluid, are positive and within thirty decades of 1.
    pub fn new(
        breadth_m: f64,
        length_m: f64,
        pressure_drop_pa: f64,
        fluid: SealedFluid,
    ) -> Result<Self, OutOfBounds> {
        Bound::Magnitude.check("viscosity in Pa s", fluid.viscosity_pa_s())?;
        Ok(SealedJoint {
            breadth_m: Bound::Magnitude.check("breadth across the flow in m", breadth_m)?,
            length_m: Bound::Magnitude.check("length along the flow in m", length_m)?,
            pressure_drop_pa: Bound::Magnitude.check("pressure drop in Pa", pressure_drop_pa)?,
            fluid,
        })
    }

    /// Pressure drop dp \[Pa\].
    #[must_use]
    pub fn pressure_drop_pa(&self) -> f64 {
        self.pressure_drop_pa
    }

    /// The fluid.
    #[must_use]
    pub fn fluid(&self) -> &SealedFluid {
        &self.fluid
    }

    /// Number of waves of a length \[m\] that fit into the shorter of length and breadth.
    #[must_use]
    pub fn waves(&self, wavelength_m: f64) -> f64 {
        self.length_m.min(self.breadth_m) / wavelength_m
    }

    /// Returns true if few of the longest waves of a roughness \[m\] fit into the joint, so that chance decides its leak rate.
    #[must_use]
    pub fn is_narrow(&self, longest_wave_m: f64) -> bool {
        self.waves(longest_wave_m) < WAVES
    }

    /// Computes the range of the leak rate of gaps whose effective medium, and all of which side by side, have the conductances
    /// \[m^3\], where `area_fraction` of the joint is in contact, of a roughness with the longest wave \[m\]. No more passes than side by
    /// side. The volume of a gas is that at the outlet.
    #[must_use]
    pub fn leak_rate(
        &self,
        [medium_m3, parallel_m3]: [f64; 2],
        area_fraction: f64,
        longest_wave_m: f64,
    ) -> LeakRate {
        let rate = self.rate_m3_per_s(medium_m3);
        let [low, high] = shares(area_fraction, self.waves(longest_wave_m));
        let most = self.rate_m3_per_s(parallel_m3).max(rate);
        LeakRate { low_m3_per_s: low * rate, high_m3_per_s: (high * rate).min(most) }
    }

    /// Computes the volume per time \[m^3/s\] through gaps of a conductance \[m^3\], the cube of the parallel slot that lets as much
    /// through. With the mean cube of an open gap it is the most that passes.
    #[must_use]
    pub fn rate_m3_per_s(&self, cube_m3: f64) -> f64 {
        let incompressible = (self.breadth_m / self.length_m) * (cube_m3 / 12.0) * self.pressure_drop_pa
            / self.fluid.viscosity_pa_s();
        incompressible * self.fluid.volume_factor(self.pressure_drop_pa, cube_m3.cbrt())
    }
}

/// Shares of the rate of the medium between which solved flows lie, of a joint into which so many of the longest waves fit.
fn shares(area_fraction: f64, waves: f64) -> [f64; 2] {
    let end = RANGES.partition_point(|(area, _)| *area < area_fraction).clamp(1, RANGES.len() - 1);
    let [(from, low), (to, high)] = [RANGES[end - 1], RANGES[end]];
    let part = ((area_fraction - from) / (to - from)).clamp(0.0, 1.0);
    let [low, high] = [0, 1].map(|side: usize| low[side].ln() + part * (high[side] / low[side]).ln());
    let fewer = ((WAVES / waves.max(FEWEST_WAVES)).powi(2) - 1.0).max(0.0);
    let wider = SCATTER * area_fraction * fewer;
    [(low - wider).exp(), (high + wider).exp()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gas::NamedGas;
    use crate::sealed_fluid::LeakingGas;

    const WATER: SealedFluid = SealedFluid::Incompressible { viscosity_pa_s: 1e-3 };

    #[test]
    fn a_rate_is_that_of_a_slot_and_its_range_goes_with_the_area() {
        let joint = SealedJoint::new(0.1, 1e-3, 1e5, WATER).unwrap();
        // (0.1/1e-3) (1e-7)^3 1e5/(12 1e-3) = 8.33e-13 m^3/s.
        let rate = 1e-11 / 12.0;
        assert!((joint.rate_m3_per_s(1e-21) / rate - 1.0).abs() < 1e-14);
        assert_eq!(joint.pressure_drop_pa(), 1e5);
        let between = (0.62 * 0.28f64).sqrt();
        for (area, low) in
            [(0.0, 0.75), (0.15, 0.83), (0.29, 0.62), (0.315, between), (0.40, 0.02), (0.42, 0.02)]
        {
            let found = joint.leak_rate([1e-21, 1e-18], area, 1e-4);
            assert!((found.low_m3_per_s / (low * rate) - 1.0).abs() < 1e-12, "{area}: {found:?}");
        }
        let high = joint.leak_rate([1e-21, 1e-18], 0.34, 1e-4).high_m3_per_s;
        assert!((high / (4.2 * rate) - 1.0).abs() < 1e-12, "{high}");
    }

    #[test]
    fn few_waves_scatter_more() {
        let joint = SealedJoint::new(0.1, 1e-3, 1e5, WATER).unwrap();
        let width = |longest_m: f64| {
            let found = joint.leak_rate([1e-21, 1e-15], 0.2, longest_m);
            (found.high_m3_per_s / found.low_m3_per_s).ln()
        };
        assert_eq!(width(1e-5), width(2.5e-4));
        // Twice 1.25 A (16/n^2 - 1).
        assert!((width(5e-4) - width(1e-5) - 2.0 * 1.25 * 0.2 * 3.0).abs() < 1e-12);
        assert!(
            (width(1e-3) - width(1e-5) - 2.0 * 1.25 * 0.2 * 15.0).abs() < 1e-12 && width(1e-2) == width(1e-3)
        );
        // No more than all gaps side by side, and not less than the medium.
        let capped = |parallel_m3| joint.leak_rate([1e-21, parallel_m3], 0.2, 1e-3).high_m3_per_s;
        assert_eq!(capped(2e-21), joint.rate_m3_per_s(2e-21));
        assert_eq!(capped(1e-22), joint.rate_m3_per_s(1e-21));
        // Breadth counts as length does.
        let turned = SealedJoint::new(1e-3, 0.1, 1e5, WATER).unwrap();
        assert!(turned.is_narrow(5e-4) && !turned.is_narrow(2.5e-4) && turned.waves(5e-4) == 2.0);
    }

    #[test]
    fn a_gas_expands_to_the_outlet_and_slips() {
        let air = LeakingGas::new(NamedGas::Air, 288.15, 101_325.0).unwrap();
        let of = |fluid| SealedJoint::new(0.1, 1e-3, 202_650.0, fluid).unwrap().rate_m3_per_s(1e-18);
        let fluid = SealedFluid::Gas(air);
        let incompressible = of(SealedFluid::Incompressible { viscosity_pa_s: fluid.viscosity_pa_s() });
        // Twice the volume of the mean pressure of 2 atm, where the free path is 32 nm: 1 + 6 0.032.
        assert!((of(fluid) / incompressible - 2.0 * (1.0 + 6.0 * 0.032)).abs() < 1e-9);
    }

    #[test]
    fn extremes_are_finite() {
        for (wide, narrow) in [(1e30, 1e-30), (1e-30, 1e30)] {
            let joint =
                SealedJoint::new(wide, narrow, wide, SealedFluid::Incompressible { viscosity_pa_s: narrow })
                    .unwrap();
            let LeakRate { low_m3_per_s, high_m3_per_s } = joint.leak_rate([wide, wide], 0.1, wide);
            assert!(low_m3_per_s > 0.0 && high_m3_per_s.is_finite());
        }
        for fluid in [
            SealedFluid::Incompressible { viscosity_pa_s: -1.0 },
            SealedFluid::Incompressible { viscosity_pa_s: 0.0 },
        ] {
            assert!(SealedJoint::new(0.1, 1e-3, 1e5, fluid).is_err());
        }
        assert!(SealedJoint::new(0.1, 1e-3, 0.0, WATER).is_err());
    }
}
