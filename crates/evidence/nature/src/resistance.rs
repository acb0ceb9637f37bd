//! Measured thermal resistances, as rows with types.

use std::io::Read;
use std::str::FromStr;

use interface::gas::NamedGas;
use serde::Deserialize;

use crate::NatureError;

/// A measured thermal contact.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredResistance {
    /// Number of the row in the data base.
    pub id: u32,
    /// Material of both bodies.
    pub solids: [Solid; 2],
    /// Name of the material between the faces; `None` for bare faces.
    pub interstitial: Option<String>,
    /// Gas around the joint.
    pub gas: NamedGas,
    /// Pressure of the gas.
    pub gas_pressure: GasPressure,
    /// Lower and higher Ra that the row states for its faces \[m\].
    pub ra_m: [f64; 2],
    /// Nominal pressure \[Pa\].
    pub pressure_pa: f64,
    /// Temperature of the joint \[K\].
    pub temperature_k: f64,
    /// Measured conductance \[W/(m^2 K)\].
    pub measured_w_per_m2_k: f64,
}

/// Solid of the data base.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solid {
    /// Aluminium 6061.
    Aluminium6061,
    /// Stainless steel 304.
    Steel304,
    /// Stainless steel 316L.
    Steel316L,
    /// Alumina.
    Alumina,
    /// Silicon.
    Silicon,
}

/// Pressure of the gas, which the data base stores in mixed units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GasPressure {
    /// Stored in Pa, or decoded from mPa to a pressure far below 1 atm \[Pa\].
    Known(f64),
    /// Stored in what would be mPa of 1 atm, which other rows store in Pa.
    Doubtful {
        /// Number in the data base.
        stored: f64,
    },
}

impl Solid {
    /// Every solid.
    pub const ALL: [Self; 5] =
        [Self::Aluminium6061, Self::Steel304, Self::Steel316L, Self::Alumina, Self::Silicon];

    /// Returns the name in the data base.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Aluminium6061 => "al6061",
            Self::Steel304 => "ss304",
            Self::Steel316L => "ss316l",
            Self::Alumina => "al2o3",
            Self::Silicon => "si",
        }
    }
}

impl FromStr for Solid {
    type Err = NatureError;

    fn from_str(name: &str) -> Result<Self, NatureError> {
        Self::ALL
            .into_iter()
            .find(|solid| solid.name() == name)
            .ok_or_else(|| NatureError::Material(name.to_owned()))
    }
}

impl GasPressure {
    /// Decodes a stored number by the guess beside it \[Pa\].
    ///
    /// # Errors
    /// [`NatureError::GasPressure`] if the guess is neither the number nor a thousandth of it.
    pub fn decode(stored: f64, guess_pa: f64) -> Result<Self, NatureError> {
        let near = |one: f64, other: f64| (one / other - 1.0).abs() < 1e-3;
        if near(stored, guess_pa) {
            Ok(GasPressure::Known(guess_pa))
        } else if !near(stored, 1e3 * guess_pa) {
            Err(NatureError::GasPressure { stored, decoded_pa: guess_pa })
        } else if guess_pa > 0.5 * NamedGas::REFERENCE_PRESSURE_PA {
            Ok(GasPressure::Doubtful { stored })
        } else {
            Ok(GasPressure::Known(guess_pa))
        }
    }
}

/// Row of the file.
#[derive(Deserialize)]
struct Record {
    id: u32,
    material_1: String,
    material_2: String,
    interstitial: String,
    gas: String,
    ra_low_um: f64,
    ra_high_um: f64,
    pressure_mpa: f64,
    gas_pressure_as_stored: f64,
    gas_pressure_pa_guess: f64,
    temperature_c: f64,
    conductance_w_per_m2k: f64,
}

/// Reads `tcr.csv`.
///
/// # Errors
/// [`NatureError`] for missing columns, unknown materials and gases, and gas pressures of unknown units.
pub fn read(from: impl Read) -> Result<Vec<MeasuredResistance>, NatureError> {
    csv::Reader::from_reader(from).into_deserialize().map(|record| typed(record?)).collect()
}

fn typed(record: Record) -> Result<MeasuredResistance, NatureError> {
    let gas = match record.gas.as_str() {
        "air" => NamedGas::Air,
        "n2" => NamedGas::Nitrogen,
        "he" => NamedGas::Helium,
        _ => return Err(NatureError::Gas(record.gas)),
    };
    Ok(MeasuredResistance {
        id: record.id,
        solids: [record.material_1.parse()?, record.material_2.parse()?],
        interstitial: (record.interstitial != "none").then_some(record.interstitial),
        gas,
        gas_pressure: GasPressure::decode(record.gas_pressure_as_stored, record.gas_pressure_pa_guess)?,
        ra_m: [1e-6 * record.ra_low_um, 1e-6 * record.ra_high_um],
        pressure_pa: 1e6 * record.pressure_mpa,
        temperature_k: 273.15 + record.temperature_c,
        measured_w_per_m2_k: record.conductance_w_per_m2k,
    })
}
