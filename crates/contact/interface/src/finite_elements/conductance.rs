//! Thermal or electrical conductance against pressure, as cards of finite element codes and as a plain table.

use std::fmt::Write;

use thiserror::Error;
use units::{named, number};

use crate::finite_elements::fields::field;
use crate::finite_elements::{Dialect, UnitSystem};

/// Longest line of comments; Abaqus reads 256 characters.
const WIDTH: usize = 100;

/// Flow across an interface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Flow {
    /// Heat, with conductances per nominal area in W/(m^2 K).
    Heat,
    /// Electrical current, with conductances per nominal area in S/m^2.
    Current,
}

named!(Flow, "flow", { Heat => "heat", Current => "current" });

/// Conductances per nominal area under a nominal pressure, in the SI unit of the flow: W/(m^2 K) or S/m^2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConductancePoint {
    /// Nominal pressure \[Pa\].
    pub pressure_pa: f64,
    /// Conductance of the spots that touch.
    pub contact_si: f64,
    /// Conductance of the gas beside them; 0 in vacuum.
    pub gas_si: f64,
}

impl ConductancePoint {
    /// Conductance of spots and gas together, which conduct side by side.
    #[must_use]
    pub fn total_si(&self) -> f64 {
        self.contact_si + self.gas_si
    }
}

/// Conductance per nominal area against pressure, linear between its points.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ConductanceTable {
    /// Flow of the table.
    pub flow: Flow,
    /// Points by rising pressure; the first pressure is 0.
    pub points: Vec<ConductancePoint>,
    /// Largest relative error of the conductance found halfway between two points of a sampled table, from the first
    /// pressure above 0 on; 0 for a table from given points.
    pub interpolation_error: f64,
}

/// Reason why a table of conductances cannot be made or written.
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
    #[error("a table of conductances needs at least one row")]
    Empty,
    /// The table has more rows than the code takes.
    #[error(
        "the table has {rows} rows, and calculix takes {most} at one temperature; take a larger tolerance or a narrower \
         range of pressures"
    )]
    TooManyRows {
        /// Number of rows.
        rows: usize,
        /// Largest number of rows.
        most: usize,
    },
}

impl ConductanceTable {
    /// Creates a table from points of rising pressure above 0. A point at the pressure 0 is added in front: there the
    /// spots conduct nothing, and the gas as much as at the first pressure.
    ///
    /// # Errors
    /// [`ConductanceError`] for pressures that do not rise and values out of their bounds.
    pub fn new(flow: Flow, points: &[ConductancePoint]) -> Result<Self, ConductanceError> {
        let first = points.first().ok_or(ConductanceError::Empty)?;
        let mut table = vec![ConductancePoint { pressure_pa: 0.0, contact_si: 0.0, gas_si: first.gas_si }];
        for (at, point) in points.iter().enumerate() {
            let is_conductance = |value: f64| value.is_finite() && value >= 0.0;
            let rises = point.pressure_pa.is_finite() && point.pressure_pa > table[at].pressure_pa;
            if !(rises && is_conductance(point.contact_si) && is_conductance(point.gas_si)) {
                return Err(ConductanceError::Row { row: at + 1 });
            }
            table.push(*point);
        }
        Ok(Self { flow, points: table, interpolation_error: 0.0 })
    }

    /// Conductance at a pressure \[Pa\] in the SI unit of the flow, as codes read the table: linear between points,
    /// constant beyond the last.
    #[must_use]
    pub fn conductance_si(&self, pressure_pa: f64) -> f64 {
        let above = self.points.partition_point(|point| point.pressure_pa < pressure_pa);
        match (above.checked_sub(1).map(|below| self.points[below]), self.points.get(above)) {
            (Some(low), Some(high)) => between(&low, high, pressure_pa),
            (Some(last), None) => last.total_si(),
            (None, _) => self.points[0].total_si(),
        }
    }

    /// Writes the card that follows the mechanical law of the same surface interaction, or a plain table for
    /// [`Dialect::Csv`], with comments in front that begin with the lines of `provenance`.
    ///
    /// # Errors
    /// [`ConductanceError::TooManyRows`] if the code has no room for the rows.
    pub fn to_text(
        &self,
        dialect: Dialect,
        units: UnitSystem,
        provenance: &[String],
    ) -> Result<String, ConductanceError> {
        let rows = self.points.len();
        if dialect == Dialect::Calculix && rows > Dialect::MOST_CALCULIX_ROWS {
            return Err(ConductanceError::TooManyRows { rows, most: Dialect::MOST_CALCULIX_ROWS });
        }
        let sign = if dialect == Dialect::Csv { "#" } else { "**" };
        let mut text = String::new();
        let of_table = self.description(units);
        let of_code = comments(dialect, self.flow).iter().map(|line| (*line).to_owned());
        for paragraph in provenance.iter().cloned().chain(of_table).chain(of_code) {
            for line in paragraph.lines().flat_map(|line| textwrap::wrap(line, WIDTH)) {
                writeln!(text, "{sign} {line}").expect("a string grows");
            }
        }
        text += &self.header(dialect, units);
        // Power is force times length over time: both conductances have the unit of pressure times length.
        let conductance = |si: f64| si / (units.pressure_pa() * units.length_m());
        for point in &self.points {
            let pressure = units.pressure(point.pressure_pa);
            let total = conductance(point.total_si());
            let cells: Vec<String> = match (dialect, self.flow) {
                (Dialect::Abaqus | Dialect::Calculix, _) => vec![field(total), field(pressure)],
                (Dialect::Csv, Flow::Current) => [pressure, total].map(number).to_vec(),
                (Dialect::Csv, Flow::Heat) => {
                    let [contact, gas] = [point.contact_si, point.gas_si].map(conductance);
                    [pressure, total, contact, gas].map(number).to_vec()
                }
            };
            text += &cells.join(if dialect == Dialect::Csv { "," } else { ", " });
            text.push('\n');
        }
        Ok(text)
    }

    /// Describes the rows and their units.
    fn description(&self, units: UnitSystem) -> [String; 2] {
        let pressure = units.pressure_symbol();
        let [first, last] = [1, self.points.len() - 1]
            .map(|at| format!("{} {pressure}", number(units.pressure(self.points[at].pressure_pa))));
        let (what, gas) = match self.flow {
            Flow::Heat => ("Thermal", "the gas conducts alone, nothing in vacuum"),
            Flow::Current => ("Electrical", "nothing conducts"),
        };
        [
            format!(
                "{what} conductance per nominal area against nominal pressure: {} rows, straight between them. At no pressure \
                 {gas}; up to {first} the spots follow a straight line from there, and beyond {last} the last row holds.",
                self.points.len()
            ),
            format!(
                "Units {units}: conductance in {}, pressure in {pressure}. {}; the model has to have the same.",
                symbol(self.flow, units),
                flow_units(self.flow, units)
            ),
        ]
    }

    /// Keyword of a card, or names of columns.
    fn header(&self, dialect: Dialect, units: UnitSystem) -> String {
        match (dialect, self.flow) {
            (Dialect::Csv, flow) => {
                let (pressure, unit) = (units.pressure_symbol(), column_unit(flow, units));
                let parts = match flow {
                    Flow::Heat => format!(",contact_{unit},gas_{unit}"),
                    Flow::Current => String::new(),
                };
                format!("pressure_{pressure},conductance_{unit}{parts}\n")
            }
            (Dialect::Calculix, _) => "*GAP CONDUCTANCE\n".to_owned(),
            (Dialect::Abaqus, Flow::Heat) => "*GAP CONDUCTANCE, PRESSURE\n".to_owned(),
            (Dialect::Abaqus, Flow::Current) => "*GAP ELECTRICAL CONDUCTANCE, PRESSURE\n".to_owned(),
        }
    }
}

/// Conductance on the straight line between two points.
pub(crate) fn between(low: &ConductancePoint, high: &ConductancePoint, pressure_pa: f64) -> f64 {
    let share = (pressure_pa - low.pressure_pa) / (high.pressure_pa - low.pressure_pa);
    low.total_si() + (high.total_si() - low.total_si()) * share
}

/// Symbol of the unit of a conductance per area.
fn symbol(flow: Flow, units: UnitSystem) -> &'static str {
    match (flow, units) {
        (Flow::Heat, UnitSystem::Si) => "W/(m^2 K)",
        (Flow::Heat, UnitSystem::Millimetres) => "mW/(mm^2 K)",
        (Flow::Heat, UnitSystem::Micrometres) => "pW/(um^2 K)",
        (Flow::Heat, UnitSystem::Inches) => "lbf/(in s K)",
        (Flow::Current, UnitSystem::Si) => "S/m^2",
        (Flow::Current, UnitSystem::Millimetres) => "mS/mm^2",
        (Flow::Current, UnitSystem::Micrometres) => "pS/um^2",
        (Flow::Current, UnitSystem::Inches) => "lbf/(in s V^2)",
    }
}

/// Unit of a conductance per area in the name of a column: `W_per_m2_K`.
fn column_unit(flow: Flow, units: UnitSystem) -> String {
    symbol(flow, units).replace(['^', '(', ')'], "").replace('/', "_per_").replace(' ', "_")
}

/// Units of the flow and of the conductivity that fit the conductance.
fn flow_units(flow: Flow, units: UnitSystem) -> &'static str {
    match (flow, units) {
        (Flow::Heat, UnitSystem::Si) => "Heat flows in W, conductivities in W/(m K)",
        (Flow::Heat, UnitSystem::Millimetres) => "Heat flows in mW, conductivities in mW/(mm K)",
        (Flow::Heat, UnitSystem::Micrometres) => "Heat flows in pW, conductivities in pW/(um K)",
        (Flow::Heat, UnitSystem::Inches) => "Heat flows in lbf in/s, conductivities in lbf/(s K)",
        (Flow::Current, UnitSystem::Si) => "Potentials in V, currents in A, conductivities in S/m",
        (Flow::Current, UnitSystem::Millimetres) => {
            "Potentials in V, currents in mA, conductivities in mS/mm"
        }
        (Flow::Current, UnitSystem::Micrometres) => {
            "Potentials in V, currents in pA, conductivities in pS/um"
        }
        (Flow::Current, UnitSystem::Inches) => {
            "Potentials in V, powers in lbf in/s, conductivities in lbf/(s V^2)"
        }
    }
}

/// Describes how a code reads the card.
fn comments(dialect: Dialect, flow: Flow) -> &'static [&'static str] {
    match (dialect, flow) {
        (Dialect::Csv, _) => &[],
        (Dialect::Abaqus, _) => &ABAQUS,
        (Dialect::Calculix, Flow::Heat) => &CALCULIX_HEAT,
        (Dialect::Calculix, Flow::Current) => &CALCULIX_CURRENT,
    }
}

/// Order of the columns and place of the card, in every code.
const ORDER: &str = "A line has the conductance, then the pressure. Append this card to the mechanical law: it stands under \
                     *SURFACE INTERACTION, behind *SURFACE BEHAVIOR and before the first *STEP.";

/// Combinations that CalculiX 2.20 obeys, each found by running it.
const OBEYED: &str = "CalculiX 2.20 obeys this table with PRESSURE-OVERCLOSURE=EXPONENTIAL in *CONTACT PAIR, TYPE=NODE TO SURFACE \
                      and *STEP, NLGEOM, or with PRESSURE-OVERCLOSURE=LINEAR in TYPE=SURFACE TO SURFACE.";

/// Combinations that CalculiX 2.20 does not obey, each found by running it.
const WRONG_ROWS: &str = "With TABULAR, with LINEAR in NODE TO SURFACE, or without NLGEOM it takes a wrong row, and says nothing; with \
                          EXPONENTIAL in SURFACE TO SURFACE it makes no contact at a clearance.";

const CALCULIX_HEAT: [&str; 4] = [
    ORDER,
    OBEYED,
    WRONG_ROWS,
    "Open surfaces exchange no heat in CalculiX: gas between them needs another card.",
];

const CALCULIX_CURRENT: [&str; 4] = [
    "CalculiX has no electrical card: it warns of *GAP ELECTRICAL CONDUCTANCE and goes on without it. This is its thermal card, \
     for a heat analysis with potentials as temperatures, electrical conductivities as thermal ones, and currents as heat flows.",
    ORDER,
    OBEYED,
    WRONG_ROWS,
];

const ABAQUS: [&str; 3] = [ORDER, ABAQUS_PRESSURE, ABAQUS_NOT_RUN];

const ABAQUS_PRESSURE: &str = "Without the parameter PRESSURE Abaqus reads the second number as a clearance.";

const ABAQUS_NOT_RUN: &str = "This card follows the manual of Abaqus, and was not run there: compare a contact at one pressure with the table.";
