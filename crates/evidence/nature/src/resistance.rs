//! Measured thermal resistances, as rows with types.

use std::io::Read;

use interface::gas::NamedGas;
use serde::Deserialize;

use crate::NatureError;

/// A measured thermal contact.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredResistance {
    /// Number of the row in the data base.
    pub id: u32,
    /// Material of both bodies.
    pub solids: [&'static Solid; 2],
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
#[derive(Debug, PartialEq)]
pub struct Solid {
    /// Name in the data base.
    pub name: &'static str,
    /// Name in the table of materials.
    pub tabled: &'static str,
    /// Range of the microhardness of machined faces over the hardness of the table, which is three times a strength.
    pub hardening: [f64; 2],
}

/// Solids of the data base, and how much harder their faces are than the table has them:
/// * aluminium 6061-T6 hardly hardens: 1, to 2 of shallow indents;
/// * the table has the least strength of annealed steel, which hardens: 2 at 8 % of strain (Tabor 1951), to 6 of indents of 10 um
///   (Hegazy 1985: 6.27 GPa (d/um)^-0.229 for steel 304). Steel 316L has the row of 304, which conducts alike within 10 %;
/// * ceramics have a hardness of their own in the table: 1, to 1.2.
pub static SOLIDS: [Solid; 5] = [
    Solid { name: "al6061", tabled: "6061-T6", hardening: [1.0, 2.0] },
    Solid { name: "ss304", tabled: "304", hardening: [2.0, 6.0] },
    Solid { name: "ss316l", tabled: "304", hardening: [2.0, 6.0] },
    Solid { name: "al2o3", tabled: "alumina", hardening: [1.0, 1.2] },
    Solid { name: "si", tabled: "silicon", hardening: [1.0, 1.2] },
];

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

/// Finds a solid by its name in the data base.
///
/// # Errors
/// [`NatureError::Unknown`] for other names.
pub fn solid(name: &str) -> Result<&'static Solid, NatureError> {
    let found = SOLIDS.iter().find(|solid| solid.name == name);
    found.ok_or_else(|| NatureError::Unknown("material", name.to_owned()))
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
            Err(NatureError::GasPressure(stored, guess_pa))
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
        _ => return Err(NatureError::Unknown("gas", record.gas)),
    };
    Ok(MeasuredResistance {
        id: record.id,
        solids: [solid(&record.material_1)?, solid(&record.material_2)?],
        interstitial: (record.interstitial != "none").then_some(record.interstitial),
        gas,
        gas_pressure: GasPressure::decode(record.gas_pressure_as_stored, record.gas_pressure_pa_guess)?,
        ra_m: [1e-6 * record.ra_low_um, 1e-6 * record.ra_high_um],
        pressure_pa: 1e6 * record.pressure_mpa,
        temperature_k: 273.15 + record.temperature_c,
        measured_w_per_m2_k: record.conductance_w_per_m2k,
    })
}
