//! The gas in the gaps, as options of a command or keys of a scene give it.

use ::interface::gas::{GapGas, NamedGas, RarefiedGas};
use units::OutOfBounds;

/// Gas in the gaps: a gas by name with its temperature and pressure, or the conductivity and the gas parameter of any other.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct GivenGas {
    /// Name of the gas.
    pub name: Option<NamedGas>,
    /// Temperature of the named gas \[K\]; 288.15 if absent.
    pub temperature_k: Option<f64>,
    /// Pressure of the named gas \[Pa\]; 1 atm if absent.
    pub pressure_pa: Option<f64>,
    /// Thermal conductivity k_g of another gas \[W/(m K)\].
    pub conductivity_w_per_m_k: Option<f64>,
    /// Gas parameter M of another gas \[m\].
    pub parameter_m: Option<f64>,
}

/// Option that describes a gas.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GasOption {
    /// Name.
    Name,
    /// Temperature.
    Temperature,
    /// Pressure.
    Pressure,
    /// Thermal conductivity.
    Conductivity,
    /// Gas parameter.
    Parameter,
}

/// Error in the options of a gas.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GasError {
    /// An option has no effect beside another one.
    Beside(GasOption, GasOption),
    /// An option needs another one, which is missing.
    Needs(GasOption, GasOption),
    /// A value is out of bounds.
    Value(GasOption, OutOfBounds),
}

impl GasOption {
    /// Returns its key in scenes, which is also its name elsewhere but for hyphens.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            GasOption::Name => "gas",
            GasOption::Temperature => "gas_temperature",
            GasOption::Pressure => "gas_pressure",
            GasOption::Conductivity => "gas_conductivity",
            GasOption::Parameter => "gas_parameter",
        }
    }
}

impl GivenGas {
    /// Returns every option, and whether it is given.
    #[must_use]
    pub fn options(&self) -> [(GasOption, bool); 5] {
        [
            (GasOption::Name, self.name.is_some()),
            (GasOption::Temperature, self.temperature_k.is_some()),
            (GasOption::Pressure, self.pressure_pa.is_some()),
            (GasOption::Conductivity, self.conductivity_w_per_m_k.is_some()),
            (GasOption::Parameter, self.parameter_m.is_some()),
        ]
    }

    /// Returns the gas; `None` for a vacuum, if no option is given.
    ///
    /// # Errors
    /// [`GasError`] for options that contradict or need each other, and for values out of bounds.
    pub fn resolve(&self) -> Result<Option<GapGas>, GasError> {
        let [_, of_named @ .., conductivity, parameter] = self.options();
        let given = |options: &[(GasOption, bool)]| {
            options.iter().find(|(_, given)| *given).map(|(option, _)| *option)
        };
        if let Some(gas) = self.name {
            if let Some(option) = given(&[conductivity, parameter]) {
                return Err(GasError::Beside(option, GasOption::Name));
            }
            let temperature_k = self.temperature_k.unwrap_or(RarefiedGas::REFERENCE_TEMPERATURE_K);
            let pressure_pa = self.pressure_pa.unwrap_or(RarefiedGas::REFERENCE_PRESSURE_PA);
            let conductivity = gas
                .conductivity_w_per_m_k(temperature_k)
                .map_err(|error| GasError::Value(GasOption::Temperature, error))?;
            return gas
                .parameter_m(temperature_k, pressure_pa)
                .and_then(|parameter_m| GapGas::new(conductivity, parameter_m))
                .map(Some)
                .map_err(|error| GasError::Value(GasOption::Pressure, error));
        }
        if let Some(option) = given(&of_named) {
            return Err(GasError::Needs(option, GasOption::Name));
        }
        match (self.conductivity_w_per_m_k, self.parameter_m) {
            (Some(conductivity), Some(parameter_m)) => GapGas::new(conductivity, parameter_m)
                .map(Some)
                .map_err(|error| GasError::Value(GasOption::Conductivity, error)),
            (Some(_), None) => Err(GasError::Needs(GasOption::Conductivity, GasOption::Parameter)),
            (None, Some(_)) => Err(GasError::Needs(GasOption::Parameter, GasOption::Conductivity)),
            (None, None) => Ok(None),
        }
    }
}
