//! Thermal conductance against pressure as a card of finite element codes.

use thiserror::Error;

use crate::fields::field;
use crate::{Dialect, UnitSystem};

/// Thermal conductance per nominal area against pressure, linear between its points.
#[derive(Debug, Clone, PartialEq)]
pub struct ConductanceTable {
    /// Pressure \[Pa\] and conductance \[W/(m^2 K)\]; the first pressure is 0.
    points: Vec<[f64; 2]>,
}

/// Reason why a table of conductances cannot be written.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ConductanceError {
    /// Pressures do not rise from above 0, or a conductance is negative or not finite.
    #[error("row {row} of the conductances: pressures rise from above 0, and conductances are at least 0")]
    Row {
        /// Number of the row, from 1.
        row: usize,
    },
    /// The table is empty.
    #[error("a table of conductances needs a row at least")]
    Empty,
    /// The table has more rows than the code takes.
    #[error("{rows} rows of conductances; calculix takes {most} at one temperature: widen the tolerance")]
    TooManyRows {
        /// Number of rows.
        rows: usize,
        /// Largest number of rows.
        most: usize,
    },
    /// The format is no finite element code.
    #[error("csv has no cards; take abaqus or calculix")]
    NoCard,
}

impl ConductanceTable {
    /// Creates a table from rising pressures \[Pa\] with the conductances of the solid spots \[W/(m^2 K)\], and the
    /// conductance of gas, 0 in vacuum, which acts beside the spots and alone at the pressure 0.
    ///
    /// # Errors
    /// [`ConductanceError`] for pressures that do not rise and values out of their bounds.
    pub fn new(spots: &[[f64; 2]], gas_w_per_m2_k: f64) -> Result<Self, ConductanceError> {
        if spots.is_empty() {
            return Err(ConductanceError::Empty);
        }
        let mut points = vec![[0.0, gas_w_per_m2_k]];
        for (at, [pressure_pa, spots_w_per_m2_k]) in spots.iter().enumerate() {
            let before_pa = points[at][0];
            let conductance = spots_w_per_m2_k + gas_w_per_m2_k;
            let is_valid = pressure_pa.is_finite() && conductance.is_finite();
            if !is_valid || *pressure_pa <= before_pa || *spots_w_per_m2_k < 0.0 || gas_w_per_m2_k < 0.0 {
                return Err(ConductanceError::Row { row: at + 1 });
            }
            points.push([*pressure_pa, conductance]);
        }
        Ok(Self { points })
    }

    /// Conductance at a pressure \[Pa\], as codes read the table: linear between points, constant beyond the last
    /// \[W/(m^2 K)\].
    #[must_use]
    pub fn conductance_w_per_m2_k(&self, pressure_pa: f64) -> f64 {
        let above = self.points.partition_point(|point| point[0] < pressure_pa);
        match (above.checked_sub(1).map(|below| self.points[below]), self.points.get(above)) {
            (Some([low_pa, low]), Some([high_pa, high])) => {
                low + (high - low) * (pressure_pa - low_pa) / (high_pa - low_pa)
            }
            (Some([_, last]), None) => last,
            (None, _) => self.points[0][1],
        }
    }

    /// Writes the card that follows the mechanical law of the same surface interaction, with comments in front.
    ///
    /// # Errors
    /// [`ConductanceError`] if the code has no such card, or no room for the rows.
    pub fn card(&self, dialect: Dialect, units: UnitSystem) -> Result<String, ConductanceError> {
        let (comments, keyword): (&[&str], &str) = match dialect {
            Dialect::Csv => return Err(ConductanceError::NoCard),
            Dialect::Abaqus => (&ABAQUS, "*GAP CONDUCTANCE, PRESSURE\n"),
            Dialect::Calculix => (&CALCULIX, "*GAP CONDUCTANCE\n"),
        };
        let rows = self.points.len();
        if dialect == Dialect::Calculix && rows > Dialect::MOST_CALCULIX_ROWS {
            return Err(ConductanceError::TooManyRows { rows, most: Dialect::MOST_CALCULIX_ROWS });
        }
        // Power is force times length over time, so a conductance has the unit of pressure times length.
        let unit_w_per_m2_k = units.pressure_pa() * units.length_m();
        let mut text: String = comments.iter().map(|line| format!("** {line}\n")).collect();
        text += &format!(
            "** Conductance in {force} {length}/s per {length}^2 and K, pressure in {pressure}.\n",
            force = units.force_symbol(),
            length = units.length_symbol(),
            pressure = units.pressure_symbol()
        );
        text += keyword;
        for [pressure_pa, conductance] in &self.points {
            text += &format!(
                "{}, {}\n",
                field(conductance / unit_w_per_m2_k),
                field(units.pressure(*pressure_pa))
            );
        }
        Ok(text)
    }
}

/// Traps of CalculiX 2.20, each found by running it.
const CALCULIX: [&str; 7] = [
    "Thermal conductance per nominal area, then pressure; between rows linear, beyond the last constant.",
    "CalculiX 2.20 obeys this table with *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL in",
    "*CONTACT PAIR, TYPE=NODE TO SURFACE and *STEP, NLGEOM, or with LINEAR in TYPE=SURFACE TO SURFACE.",
    "With TABULAR, with LINEAR in NODE TO SURFACE, or without NLGEOM it takes a wrong row, and says nothing.",
    "The card stands behind *SURFACE BEHAVIOR and before the first *STEP.",
    "Open surfaces exchange no heat: gas between them needs another card.",
    "For electricity use this card in a heat analysis, with potentials as temperatures.",
];

const ABAQUS: [&str; 2] = [
    "Thermal conductance per nominal area, then pressure; without PRESSURE Abaqus reads clearances.",
    "The card stands under *SURFACE INTERACTION.",
];
