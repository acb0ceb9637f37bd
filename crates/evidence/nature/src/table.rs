//! The committed tables, and what they say: shares inside, widths, exponents in pressure.

use std::collections::BTreeMap;
use std::io::{Read, Write};

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::NatureError;
use crate::prediction::predict;
use crate::resistance::{GasPressure, MeasuredResistance};

/// A measured conductance beside its prediction \[W/(m^2 K)\].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ResistanceRow {
    /// Number of the row in the data base.
    pub id: u32,
    /// Both materials, by their names in the data base.
    pub pair: String,
    /// Gas.
    pub gas: String,
    /// Pressure of the gas \[Pa\].
    pub gas_pressure_pa: f64,
    /// Lower and higher Ra of the faces \[um\].
    pub ra_low_um: f64,
    /// Higher one.
    pub ra_high_um: f64,
    /// Temperature \[C\].
    pub temperature_c: f64,
    /// Nominal pressure \[MPa\].
    pub pressure_mpa: f64,
    /// Measured value.
    pub measured: f64,
    /// Predicted value.
    pub predicted: f64,
    /// Lower end of the predicted range.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// Lower end of the range from what the row states.
    pub stated_low: f64,
    /// Upper end.
    pub stated_high: f64,
    /// Predicted value without gas.
    pub without_gas: f64,
    /// Predicted value if flatness is a long wave.
    pub long_wave: f64,
    /// Predicted value if flatness is a cap.
    pub cap: f64,
}

/// Predicts all bare joints whose gas pressure is known; also returns the number of bare rows where it is doubtful.
///
/// # Errors
/// [`NatureError`] for rows that cannot be predicted.
pub fn resistance_rows(measured: &[MeasuredResistance]) -> Result<(Vec<ResistanceRow>, usize), NatureError> {
    let (mut rows, mut doubtful) = (Vec::new(), 0);
    for row in measured.iter().filter(|row| row.interstitial.is_none()) {
        let (Some(prediction), GasPressure::Known(gas_pressure_pa)) = (predict(row)?, row.gas_pressure)
        else {
            doubtful += 1;
            continue;
        };
        rows.push(ResistanceRow {
            id: row.id,
            pair: row.solids.map(|solid| solid.name).join("-"),
            gas: row.gas.to_string(),
            gas_pressure_pa,
            ra_low_um: rounded(1e6 * row.ra_m[0]),
            ra_high_um: rounded(1e6 * row.ra_m[1]),
            temperature_c: rounded(row.temperature_k - 273.15),
            pressure_mpa: rounded(1e-6 * row.pressure_pa),
            measured: rounded(row.measured_w_per_m2_k),
            predicted: rounded(prediction.central),
            low: rounded(prediction.range[0]),
            high: rounded(prediction.range[1]),
            stated_low: rounded(prediction.stated[0]),
            stated_high: rounded(prediction.stated[1]),
            without_gas: rounded(prediction.without_gas),
            long_wave: rounded(prediction.limits[0]),
            cap: rounded(prediction.limits[1]),
        });
    }
    Ok((rows, doubtful))
}

/// Four significant digits, which all platforms agree on.
pub(crate) fn rounded(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}

impl ResistanceRow {
    /// Returns true if the measured value lies in the predicted range.
    #[must_use]
    pub fn is_inside(&self) -> bool {
        (self.low..=self.high).contains(&self.measured)
    }

    /// Upper over lower end of the range.
    #[must_use]
    pub fn width(&self) -> f64 {
        self.high / self.low
    }

    /// Upper over lower end of the range from what the row states.
    #[must_use]
    pub fn stated_width(&self) -> f64 {
        self.stated_high / self.stated_low
    }
}

/// Value that a share of the values does not exceed; `None` of none.
#[must_use]
pub fn percentile(values: impl Iterator<Item = f64>, share: f64) -> Option<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    let rank = (share * values.len() as f64).ceil() as usize;
    values.get(rank.max(1) - 1).copied()
}

/// Exponents n of conductance ~ p^n, measured, predicted, predicted without gas, and by both limits of flatness: one
/// slope each through all groups of rows that differ in pressure alone. `None` if no group has two pressures.
#[must_use]
pub fn exponents<'r>(rows: impl Iterator<Item = &'r ResistanceRow>) -> Option<[f64; 5]> {
    let mut groups: BTreeMap<String, Vec<&ResistanceRow>> = BTreeMap::new();
    for row in rows {
        let ResistanceRow { pair, gas, gas_pressure_pa, ra_low_um, ra_high_um, temperature_c, .. } = row;
        let key = format!("{pair} {gas} {gas_pressure_pa} {ra_low_um} {ra_high_um} {temperature_c}");
        groups.entry(key).or_default().push(row);
    }
    groups.retain(|_, group| group.iter().any(|row| row.pressure_mpa != group[0].pressure_mpa));
    let slope = |of: fn(&ResistanceRow) -> f64| {
        let [mut products, mut squares] = [0.0; 2];
        for group in groups.values() {
            let mean = |of: &dyn Fn(&ResistanceRow) -> f64| {
                group.iter().map(|row| of(row)).sum::<f64>() / group.len() as f64
            };
            let (x, y) = (mean(&|row| row.pressure_mpa.ln()), mean(&|row| of(row).ln()));
            for row in group {
                let apart = row.pressure_mpa.ln() - x;
                products += apart * (of(row).ln() - y);
                squares += apart * apart;
            }
        }
        products / squares
    };
    let of: [fn(&ResistanceRow) -> f64; 5] =
        [|row| row.measured, |row| row.predicted, |row| row.without_gas, |row| row.long_wave, |row| row.cap];
    (!groups.is_empty()).then(|| of.map(slope))
}

/// Reads a table.
///
/// # Errors
/// [`NatureError::Table`] for text that is no such table.
pub fn read<R: DeserializeOwned>(from: impl Read) -> Result<Vec<R>, NatureError> {
    Ok(csv::Reader::from_reader(from).into_deserialize().collect::<Result<_, _>>()?)
}

/// Writes a table.
///
/// # Errors
/// [`NatureError::Table`] of writing.
pub fn write<R: Serialize>(rows: &[R], to: impl Write) -> Result<(), NatureError> {
    let mut writer = csv::Writer::from_writer(to);
    rows.iter().try_for_each(|row| writer.serialize(row))?;
    Ok(writer.flush().map_err(csv::Error::from)?)
}
