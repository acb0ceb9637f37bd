//! The gas in the gaps, as options of a command or keys of a scene give it.

use ::interface::gas::{GapGas, NamedGas};
use serde::{Deserialize, Serialize};
use units::{OutOfBounds, Pressure};

use crate::plan::NominalPressure;

/// Gas in the gaps: a gas by name with its temperature and pressure, or the conductivity and the gas parameter of any other.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct GasInput {
    /// Name of the gas.
    pub name: Option<NamedGas>,
    /// Temperature of the named gas \[K\]; 288.15 if absent.
    pub temperature_k: Option<f64>,
    /// Pressure of the named gas; 1 atm if absent.
    pub pressure: Option<Pressure>,
    /// Thermal conductivity k_g of another gas \[W/(m K)\].
    pub conductivity_w_per_m_k: Option<f64>,
    /// Gas parameter M of another gas \[m\].
    pub parameter_m: Option<f64>,
}

/// Error in the options of a gas, which have the names of their keys in a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GasError {
    /// An option has no effect beside another one.
    Beside(&'static str, &'static str),
    /// An option needs another one, which is missing.
    Needs(&'static str, &'static str),
    /// A value is out of bounds.
    Value(&'static str, OutOfBounds),
}

impl GasInput {
    /// Returns every option, and whether it is given.
    #[must_use]
    pub fn options(&self) -> [(&'static str, bool); 5] {
        [
            ("gas", self.name.is_some()),
            ("gas_temperature", self.temperature_k.is_some()),
            ("gas_pressure", self.pressure.is_some()),
            ("gas_conductivity", self.conductivity_w_per_m_k.is_some()),
            ("gas_parameter", self.parameter_m.is_some()),
        ]
    }

    /// Returns the gas at its pressure, if one is given; `None` for a vacuum, if no option is given.
    ///
    /// # Errors
    /// [`GasError`] for options that contradict or need each other, and for values out of bounds.
    pub fn resolve(&self, pressure: Option<NominalPressure>) -> Result<Option<GapGas>, GasError> {
        let [_, of_named @ .., conductivity, parameter] = self.options();
        let given = |options: &[(&'static str, bool)]| {
            options.iter().find(|(_, given)| *given).map(|(option, _)| *option)
        };
        if let Some(gas) = self.name {
            if let Some(option) = given(&[conductivity, parameter]) {
                return Err(GasError::Beside(option, "gas"));
            }
            let temperature_k = self.temperature_k.unwrap_or(NamedGas::REFERENCE_TEMPERATURE_K);
            let pressure_pa = pressure.map_or(NamedGas::REFERENCE_PRESSURE_PA, NominalPressure::pa);
            let conductivity = gas
                .conductivity_w_per_m_k(temperature_k)
                .map_err(|error| GasError::Value("gas_temperature", error))?;
            return gas
                .parameter_m(temperature_k, pressure_pa)
                .and_then(|parameter_m| GapGas::new(conductivity, parameter_m))
                .map(Some)
                .map_err(|error| GasError::Value("gas_pressure", error));
        }
        if let Some(option) = given(&of_named) {
            return Err(GasError::Needs(option, "gas"));
        }
        match (self.conductivity_w_per_m_k, self.parameter_m) {
            (Some(conductivity), Some(parameter_m)) => GapGas::new(conductivity, parameter_m)
                .map(Some)
                .map_err(|error| GasError::Value("gas_conductivity", error)),
            (Some(_), None) => Err(GasError::Needs("gas_conductivity", "gas_parameter")),
            (None, Some(_)) => Err(GasError::Needs("gas_parameter", "gas_conductivity")),
            (None, None) => Ok(None),
        }
    }
}
