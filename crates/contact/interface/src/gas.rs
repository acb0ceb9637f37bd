//! Heat through the gas in the gaps of an interface, beside that through the spots: Yovanovich (2005), IEEE Trans.
//! Compon. Packag. Technol. 28:182.
//!
//! A gas of the conductivity k_g carries h_g = k_g <1/(g + M)> over the nominal area, with the local gap g where
//! nothing touches. The gas parameter M is the length by which temperature jumps at both walls lengthen every gap.
//! Gaussian heights of the rms value sigma, with mean planes Y apart, have
//!
//! h_g = (k_g/sigma)/sqrt(2 pi) Int_0^inf exp(-(Y/sigma - t)^2/2)/(t + M/sigma) dt.

use std::f64::consts::PI;
use std::sync::LazyLock;

use numerics::GaussLegendre;
use numerics::gaussian::level_of_share;
use serde::{Deserialize, Serialize};
use units::{Bound, OutOfBounds, named};

use crate::conductance::PressureRatio;

/// Gauss-Legendre rule of one panel.
static RULE: LazyLock<GaussLegendre> = LazyLock::new(|| GaussLegendre::new(16));
/// Molar gas constant \[J/(mol K)\].
pub(crate) const GAS_CONSTANT_J_PER_MOL_K: f64 = 8.314_462_618;
/// Standard deviations beyond which a Gaussian is 0 to double precision.
const TAIL: f64 = 9.0;
/// Least number of panels of the integral over gaps.
const LEAST_PANELS: f64 = 32.0;
/// Panels per rms height, or per factor e of t + M/sigma.
const PANELS_PER_UNIT: f64 = 4.0;

/// Gas between two walls: its conductivity, and the gas parameter.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct GapGas {
    conductivity_w_per_m_k: f64,
    parameter_m: f64,
}

/// Gas with known properties.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum NamedGas {
    /// Dry air.
    Air,
    /// Nitrogen.
    Nitrogen,
    /// Helium.
    Helium,
    /// Argon.
    Argon,
    /// Hydrogen.
    Hydrogen,
}

named!(NamedGas, "gas", {
    Air => "air",
    Nitrogen => "nitrogen",
    Helium => "helium",
    Argon => "argon",
    Hydrogen => "hydrogen",
});

/// Properties of a gas near 1 atm.
struct GasProperties {
    /// Conductivities at 300 and at 400 K \[W/(m K)\].
    conductivities_w_per_m_k: [f64; 2],
    prandtl_number: f64,
    heat_capacity_ratio: f64,
    /// Mean free path at 15 C and 1 atm \[m\].
    mean_free_path_m: f64,
    /// Accommodation coefficient on either wall.
    accommodation: f64,
    molar_mass_kg_per_mol: f64,
}

impl NamedGas {
    /// Temperatures \[K\] between which the conductivities hold within 6 %.
    pub const TEMPERATURES_K: Bound = Bound::Within { at_least: 200.0, at_most: 600.0 };
    /// Temperature at which tables give mean free paths, 15 C \[K\].
    pub const REFERENCE_TEMPERATURE_K: f64 = 288.15;
    /// Pressure at which tables give mean free paths, 1 atm \[Pa\].
    pub const REFERENCE_PRESSURE_PA: f64 = 101_325.0;

    /// Returns the properties of the gas, from these sources:
    /// * conductivities, and Prandtl numbers eta c_p/k at 300 K with the viscosities of the same book: CRC Handbook of Chemistry
    ///   and Physics, section 6, "Viscosity of gases" and "Thermal conductivity of gases";
    /// * mean free paths at 15 C and 1 atm: E. H. Kennard (1938), Kinetic Theory of Gases, McGraw-Hill;
    /// * accommodation coefficients of engineering surfaces: S. Song & M. M. Yovanovich (1987), Correlation of thermal accommodation
    ///   coefficients for engineering surfaces, ASME HTD 69:107. At 0 C it is M/(6.8 + M) for any solid, with the molar mass M in
    ///   g/mol, 1.4 times that of molecules with more than one atom. Clean metals accommodate light gases far worse.
    fn properties(self) -> GasProperties {
        let (
            conductivities_w_per_m_k,
            prandtl_number,
            heat_capacity_ratio,
            mean_free_path_m,
            accommodation,
            grams,
        ) = match self {
            NamedGas::Air => ([0.0262, 0.0333], 0.71, 1.40, 64.0e-9, 0.86, 28.97),
            NamedGas::Nitrogen => ([0.0260, 0.0323], 0.72, 1.40, 62.8e-9, 0.85, 28.01),
            NamedGas::Helium => ([0.1567, 0.1906], 0.66, 1.67, 186.2e-9, 0.37, 4.003),
            NamedGas::Argon => ([0.0179, 0.0226], 0.67, 1.67, 66.6e-9, 0.85, 39.95),
            NamedGas::Hydrogen => ([0.1869, 0.2304], 0.69, 1.41, 117.7e-9, 0.29, 2.016),
        };
        GasProperties {
            conductivities_w_per_m_k,
            prandtl_number,
            heat_capacity_ratio,
            mean_free_path_m,
            accommodation,
            molar_mass_kg_per_mol: 1e-3 * grams,
        }
    }

    /// Molar mass \[kg/mol\].
    #[must_use]
    pub fn molar_mass_kg_per_mol(self) -> f64 {
        self.properties().molar_mass_kg_per_mol
    }

    /// Returns the dynamic viscosity Pr k/c_p \[Pa s\] at a temperature \[K\], with the heat capacity c_p = (R/M) gamma/(gamma - 1).
    ///
    /// # Errors
    /// [`OutOfBounds`] for a temperature outside of [`TEMPERATURES_K`](Self::TEMPERATURES_K).
    pub fn viscosity_pa_s(self, temperature_k: f64) -> Result<f64, OutOfBounds> {
        let GasProperties { prandtl_number, heat_capacity_ratio, molar_mass_kg_per_mol, .. } =
            self.properties();
        let heat_capacity_j_per_kg_k = GAS_CONSTANT_J_PER_MOL_K / molar_mass_kg_per_mol * heat_capacity_ratio
            / (heat_capacity_ratio - 1.0);
        Ok(prandtl_number * self.conductivity_w_per_m_k(temperature_k)? / heat_capacity_j_per_kg_k)
    }

    /// Returns the mean free path Lambda = Lambda_0 (T/T_0) (P_0/P) \[m\] at a temperature \[K\] and a pressure \[Pa\].
    #[must_use]
    pub fn mean_free_path_m(self, temperature_k: f64, pressure_pa: f64) -> f64 {
        let hotter = temperature_k / Self::REFERENCE_TEMPERATURE_K;
        self.properties().mean_free_path_m * hotter * (Self::REFERENCE_PRESSURE_PA / pressure_pa)
    }

    /// Returns the conductivity \[W/(m K)\] at a temperature \[K\], by the power law through the values at 300 and 400 K.
    ///
    /// # Errors
    /// [`OutOfBounds`] for a temperature outside of [`TEMPERATURES_K`](Self::TEMPERATURES_K).
    pub fn conductivity_w_per_m_k(self, temperature_k: f64) -> Result<f64, OutOfBounds> {
        let temperature_k = Self::TEMPERATURES_K.check("temperature of the gas in K", temperature_k)?;
        let [at_300, at_400] = self.properties().conductivities_w_per_m_k;
        let power = (at_400 / at_300).ln() / (400.0f64 / 300.0).ln();
        Ok(at_300 * (temperature_k / 300.0).powf(power))
    }

    /// Returns the gas parameter M = alpha beta Lambda \[m\] at a temperature \[K\] and a pressure \[Pa\], with alpha = 2 (2 - a)/a of
    /// walls that accommodate alike, beta = 2 gamma/(Pr (1 + gamma)), and the mean free path Lambda.
    ///
    /// # Errors
    /// [`OutOfBounds`] unless both, and the parameter, are positive and within thirty decades of 1.
    pub fn parameter_m(self, temperature_k: f64, pressure_pa: f64) -> Result<f64, OutOfBounds> {
        let temperature_k = Bound::Magnitude.check("temperature of the gas in K", temperature_k)?;
        let pressure_pa = Bound::Magnitude.check("pressure of the gas in Pa", pressure_pa)?;
        let gas = self.properties();
        let path_m = self.mean_free_path_m(temperature_k, pressure_pa);
        let alpha = 2.0 * ((2.0 - gas.accommodation) / gas.accommodation);
        let ratio = gas.heat_capacity_ratio;
        let parameter_m = alpha * (2.0 * ratio / (gas.prandtl_number * (1.0 + ratio))) * path_m;
        Bound::Magnitude.check("gas parameter in m", parameter_m)
    }
}

impl GapGas {
    /// Creates a gas from its conductivity k_g \[W/(m K)\] and the gas parameter M \[m\]. M is at least 0 in theory, but
    /// without it the conductance at the rims of the spots is infinite.
    ///
    /// # Errors
    /// [`OutOfBounds`] unless both are positive and within thirty decades of 1.
    pub fn new(conductivity_w_per_m_k: f64, parameter_m: f64) -> Result<Self, OutOfBounds> {
        let conductivity =
            Bound::Magnitude.check("conductivity of the gas in W/(m K)", conductivity_w_per_m_k)?;
        let parameter_m = Bound::Magnitude.check("gas parameter in m", parameter_m)?;
        Ok(GapGas { conductivity_w_per_m_k: conductivity, parameter_m })
    }

    /// Conductivity k_g \[W/(m K)\].
    #[must_use]
    pub fn conductivity_w_per_m_k(&self) -> f64 {
        self.conductivity_w_per_m_k
    }

    /// Gas parameter M \[m\].
    #[must_use]
    pub fn parameter_m(&self) -> f64 {
        self.parameter_m
    }

    /// States the error of the conductance over gaps with an rms height \[m\] if M is short beside it: 15 to 26 % at a tenth and 1 to
    /// 10 % at all of it (`docs/theory/gas.md`).
    #[must_use]
    pub fn caution(&self, rms_height_m: f64) -> Option<&'static str> {
        (self.parameter_m < 0.5 * rms_height_m).then_some(
            "boundary elements find up to 25 % more conductance of the gas: M is short beside the rms height, and gaps crowd at the \
             rims of the spots",
        )
    }

    /// Conductance of the gas per nominal area, k_g <1/(g + M)> over Gaussian heights \[W/(m^2 K)\], for mean planes at a
    /// distance Y of either sign and an rms height sigma > 0 \[m\].
    #[must_use]
    pub fn conductance_w_per_m2_k(&self, separation_m: f64, rms_height_m: f64) -> f64 {
        let (separation, parameter) = (separation_m / rms_height_m, self.parameter_m / rms_height_m);
        self.conductivity_w_per_m_k / rms_height_m * mean_inverse_gap(separation, parameter)
    }
}

/// Distance of the mean planes Y = sqrt(2) sigma erfcinv(2 P/H) of Gaussian heights that flow at the hardness H, so that
/// P/H of the nominal area touches \[m\]; `None` where everything touches. `rms_height_m` is sigma \[m\].
#[must_use]
pub fn plastic_separation_m(rms_height_m: f64, pressure: PressureRatio) -> Option<f64> {
    let touching = pressure.value();
    (touching < 1.0).then(|| rms_height_m * level_of_share(touching))
}

/// Integral of exp(-(separation - t)^2/2)/(t + parameter) over t > 0, over sqrt(2 pi).
fn mean_inverse_gap(separation: f64, parameter: f64) -> f64 {
    let from = (separation - TAIL).max(0.0);
    // With the mean plane below the flat, the tail begins at its value at t = 0.
    let to = if separation > 0.0 { separation + TAIL } else { separation + separation.hypot(TAIL) };
    let density = |t: f64| (-0.5 * (separation - t) * (separation - t)).exp();
    let integral = if from + parameter > 1.0 {
        over_panels([from, to], |t| density(t) / (t + parameter))
    } else {
        // In ln(t + parameter) the integrand is smooth however small the parameter is.
        over_panels([(from + parameter).ln(), (to + parameter).ln()], |log| density(log.exp() - parameter))
    };
    integral / (2.0 * PI).sqrt()
}

/// Integral of a smooth function over a range by Gauss-Legendre panels.
fn over_panels([from, to]: [f64; 2], f: impl Fn(f64) -> f64) -> f64 {
    let panels = LEAST_PANELS.max((PANELS_PER_UNIT * (to - from)).ceil());
    let width = (to - from) / panels;
    let panel = |at: u32| RULE.over(from + f64::from(at) * width, from + f64::from(at + 1) * width);
    (0..panels as u32).flat_map(panel).map(|(x, weight)| weight * f(x)).sum()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    fn gas(parameter_m: f64) -> GapGas {
        GapGas::new(1.0, parameter_m).unwrap()
    }

    #[test]
    fn the_mean_over_the_gaps_is_that_of_an_independent_quadrature() {
        // Y and M in rms heights, and the conductance in k_g/sigma, by independent quadrature.
        for (separation, parameter, mean) in [(3.0, 3.0, 0.171_247), (2.0, 0.3, 0.524_709)] {
            let gas = gas(parameter);
            assert!((gas.conductance_w_per_m2_k(separation, 1.0) - mean).abs() < 5e-7);
        }
    }

    #[test]
    fn short_parameters_state_their_error() {
        assert!(gas(0.1).caution(1.0).is_some_and(|words| words.contains("25 %")));
        assert_eq!(gas(1.0).caution(1.0), None);
    }

    #[test]
    fn wide_gaps_and_large_parameters_have_the_simple_form() {
        let near = |separation: f64, parameter: f64| {
            let gas = gas(parameter);
            gas.conductance_w_per_m2_k(separation, 1.0) * (separation + parameter) - 1.0
        };
        // <1/(g + M)> = (1 + sigma^2/(Y + M)^2 + 3 sigma^4/(Y + M)^4 ...)/(Y + M).
        assert!((near(1e3, 1.0) - 1.0 / (1001.0 * 1001.0)).abs() < 1e-11);
        assert!((near(1e6, 1e-6)).abs() < 2e-12);
        assert!((near(10.0, 90.0) - 1.000_3e-4).abs() < 1e-9);
        // Lengths scale.
        let scaled = GapGas::new(0.026, 0.3e-6).unwrap().conductance_w_per_m2_k(2e-6, 1e-6);
        assert!((scaled / (0.026 / 1e-6) / gas(0.3).conductance_w_per_m2_k(2.0, 1.0) - 1.0).abs() < 1e-13);
    }

    #[test]
    fn the_integral_holds_for_every_gap_and_parameter() {
        // By Simpson's rule in ln(t + M), as fine as it takes.
        let dense = |separation: f64, parameter: f64| {
            let (low, high) = (parameter.ln(), (separation.abs() + 40.0 + parameter).ln());
            let steps = 400_000;
            let width = (high - low) / f64::from(steps);
            let at = |step: i32| {
                let off = separation - ((low + width * f64::from(step)).exp() - parameter);
                (-0.5 * off * off).exp()
            };
            let inner: f64 = (1..steps).map(|step| f64::from(2 + 2 * (step % 2)) * at(step)).sum();
            width / 3.0 * (inner + at(0) + at(steps)) / (2.0 * PI).sqrt()
        };
        for separation in [-6.0, -1.0, 0.0, 0.5, 4.0, 12.0, 80.0] {
            for parameter in [1e-9, 1e-3, 1.0, 1e4] {
                let exact = dense(separation, parameter);
                let off = mean_inverse_gap(separation, parameter) / exact - 1.0;
                assert!(off.abs() < 1e-9, "{separation} {parameter}: {off:e}");
            }
        }
    }

    #[test]
    fn a_flowing_surface_touches_over_p_over_h() {
        let separation = |ratio: f64| plastic_separation_m(2e-6, PressureRatio::new(ratio, 1.0).unwrap());
        // The fit of Yovanovich (1986), good to 0.2 % up to P/H of 1e-3 and to 0.8 % at 0.02.
        for (ratio, within) in [(1e-6f64, 0.002), (1e-5, 0.002), (1e-4, 0.002), (1e-3, 0.002), (0.02, 0.008)]
        {
            let fit = 1.185 * 2e-6 * (-(3.132 * ratio).ln()).powf(0.547);
            assert!((fit / separation(ratio).unwrap() - 1.0).abs() < within, "{ratio}");
        }
        // The power law 1.53 sigma (P/H)^-0.097 is 23 % off at 1e-6, and 9 % at 0.02.
        for (ratio, off) in [(1e-6, 0.23), (1e-4, 0.005), (1e-3, -0.032), (0.02, 0.09)] {
            let fit = 1.53 * 2e-6 * f64::powf(ratio, -0.097);
            assert!((fit / separation(ratio).unwrap() - 1.0 - off).abs() < 0.006, "{ratio}");
        }
        assert!(separation(0.5).unwrap().abs() < 1e-20 && separation(0.9).unwrap() < 0.0);
        assert_eq!(separation(1.0), None);
    }

    #[test]
    fn the_properties_of_named_gases_are_those_of_tables() {
        // Accommodation coefficients by the correlation, and conductivities of the handbook at 500 K [mW/(m K)].
        for (gas, molar_mass, atoms, conductivity) in [
            (NamedGas::Air, 28.97, 2, 39.7),
            (NamedGas::Nitrogen, 28.01, 2, 38.3),
            (NamedGas::Helium, 4.003, 1, 222.3),
            (NamedGas::Argon, 39.95, 1, 26.8),
        ] {
            let mass = if atoms == 1 { molar_mass } else { 1.4 * molar_mass };
            assert!((gas.properties().accommodation - mass / (6.8 + mass)).abs() < 0.006, "{gas}");
            let found = 1e3 * gas.conductivity_w_per_m_k(500.0).unwrap();
            assert!((found / conductivity - 1.0).abs() < 0.02, "{gas}: {found}");
            assert!((1e3 * gas.molar_mass_kg_per_mol() / molar_mass - 1.0).abs() < 1e-12);
        }
        // Viscosities of the handbook at 300 and 400 K [uPa s].
        for (gas, viscosities) in [
            (NamedGas::Air, [18.5, 23.0]),
            (NamedGas::Nitrogen, [17.9, 22.2]),
            (NamedGas::Helium, [20.0, 24.4]),
            (NamedGas::Argon, [22.9, 28.8]),
            (NamedGas::Hydrogen, [9.0, 10.9]),
        ] {
            let found = [300.0, 400.0].map(|temperature_k| 1e6 * gas.viscosity_pa_s(temperature_k).unwrap());
            let off = [0, 1].map(|at| (found[at] / viscosities[at] - 1.0).abs());
            assert!(off[0] < 0.015 && off[1] < 0.03, "{gas}: {found:?}");
        }
        // alpha beta Lambda = 2 (1.14/0.86) (2.8/(0.71 2.4)) 64 nm, and twice that at half of the pressure.
        let [full, half] = [101_325.0, 50_662.5].map(|pa| NamedGas::Air.parameter_m(288.15, pa).unwrap());
        assert!((full / (2.0 * 1.14 / 0.86 * (2.8 / (0.71 * 2.4)) * 64e-9) - 1.0).abs() < 1e-12);
        assert!((half / full - 2.0).abs() < 1e-12);
        assert!((NamedGas::Air.parameter_m(576.3, 101_325.0).unwrap() / full - 2.0).abs() < 1e-12);
        assert!(NamedGas::Helium.conductivity_w_per_m_k(77.0).is_err());
    }

    #[test]
    fn values_out_of_their_range_are_refused() {
        assert!(GapGas::new(0.0, 1e-6).is_err() && GapGas::new(0.026, 0.0).is_err());
        assert!(
            NamedGas::Air.parameter_m(0.0, 1e5).is_err()
                && NamedGas::Air.parameter_m(300.0, f64::NAN).is_err()
        );
    }
}
