//! Laws in the input formats of finite element codes.

use units::{named, number};

use crate::finite_elements::error::ContactLawError;
use crate::finite_elements::fields::field;
use crate::finite_elements::{ContactLaw, ExponentialLaw, Heading, UnitSystem};

/// Format of a law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Dialect {
    /// Abaqus: keywords, and one row per line.
    Abaqus,
    /// CalculiX: the keywords of Abaqus, with limits of its own.
    Calculix,
    /// Comma-separated values under a header.
    Csv,
}

named!(Dialect, "dialect", { Abaqus => "abaqus", Calculix => "calculix", Csv => "csv" });

/// Additional quantity of every point, for plain tables only.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Name, with the unit.
    pub name: String,
    /// Values, one for each of [`ContactLaw::points`]; `None` where there is none.
    pub values: Vec<Option<f64>>,
}

impl Dialect {
    /// Largest number of rows of a CalculiX table: its node-to-surface contact takes that many at one temperature.
    pub const MOST_CALCULIX_ROWS: usize = 200;
    /// Smallest difference of overclosures, in units of length; CalculiX moves closer ones apart.
    pub const LEAST_CALCULIX_STEP: f64 = 1e-10;

    /// Writes a law as a table, with comments in front.
    ///
    /// # Errors
    /// [`ContactLawError`] if the code has no room for the table, or takes no additional columns.
    pub fn table(
        self,
        law: &ContactLaw,
        units: UnitSystem,
        heading: &Heading,
        columns: &[Column],
    ) -> Result<String, ContactLawError> {
        if self == Dialect::Csv {
            return csv(law, units, heading, columns);
        }
        if !columns.is_empty() {
            return Err(ContactLawError::NoColumns(self.name()));
        }
        let mut text = self.commented(&heading.of_table(law, units, of_code(self, law, units)));
        text += &interaction(heading, "TABULAR");
        let mut before: Option<f64> = None;
        for ((pressure, overclosure), point) in law.rows(units).zip(&law.points) {
            let row = [field(pressure), field(overclosure)];
            // Uses the overclosure as the code reads it.
            let overclosure = row[1].parse().unwrap_or(overclosure);
            let step = before.map_or(f64::INFINITY, |before| overclosure - before);
            if step <= 0.0 || (self == Dialect::Calculix && step < Self::LEAST_CALCULIX_STEP) {
                return Err(ContactLawError::TooClose {
                    code: self.name(),
                    pressure_pa: point.pressure_pa,
                    step_m: step * units.length_m(),
                    least: if self == Dialect::Calculix { Self::LEAST_CALCULIX_STEP } else { 0.0 },
                    unit: units.length_symbol(),
                });
            }
            before = Some(overclosure);
            text += &format!("{}, {}\n", row[0], row[1]);
        }
        let rows = law.points.len();
        if self == Dialect::Calculix && rows > Self::MOST_CALCULIX_ROWS {
            let most = Self::MOST_CALCULIX_ROWS;
            return Err(ContactLawError::TooManyRows { code: self.name(), rows, most });
        }
        Ok(text)
    }

    /// Writes the limit of light loads as two numbers, with comments in front.
    ///
    /// # Errors
    /// [`ContactLawError::NoExponential`] for a code without this form.
    pub fn exponential(
        self,
        law: &ExponentialLaw,
        units: UnitSystem,
        heading: &Heading,
    ) -> Result<String, ContactLawError> {
        if self != Dialect::Calculix {
            return Err(ContactLawError::NoExponential(self.name()));
        }
        let mut text = self.commented(&heading.of_exponential(law, units));
        text += &interaction(heading, "EXPONENTIAL");
        let [clearance, pressure] = law.calculix(units).map(field);
        Ok(text + &format!("{clearance}, {pressure}\n"))
    }

    fn commented(self, lines: &[String]) -> String {
        let sign = match self {
            Dialect::Abaqus | Dialect::Calculix => "**",
            Dialect::Csv => "#",
        };
        lines.iter().map(|line| format!("{sign} {line}\n")).collect()
    }
}

/// Keywords in front of the numbers.
fn interaction(heading: &Heading, form: &str) -> String {
    let name = &heading.name;
    format!("*SURFACE INTERACTION, NAME={name}\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE={form}\n")
}

/// Pressure, overclosure, distance of the mean planes, area fraction, and additional columns; numbers with all their digits. The
/// distance is called the mean gap unless an additional column is.
fn csv(
    law: &ContactLaw,
    units: UnitSystem,
    heading: &Heading,
    columns: &[Column],
) -> Result<String, ContactLawError> {
    let rows = law.points.len();
    if let Some(column) = columns.iter().find(|column| column.values.len() != rows) {
        let (name, values) = (column.name.clone(), column.values.len());
        return Err(ContactLawError::ColumnLength { name, values, rows });
    }
    let (pressure, length) = (units.pressure_symbol(), units.length_symbol());
    let mut text = Dialect::Csv.commented(&heading.of_table(law, units, Vec::new()));
    let mean_gap = format!("mean_gap_{length}");
    let has_mean_gap = columns.iter().any(|column| column.name == mean_gap);
    let distance = if has_mean_gap { format!("mean_plane_distance_{length}") } else { mean_gap };
    text += &format!("pressure_{pressure},overclosure_{length},{distance},area_fraction");
    columns.iter().for_each(|column| text += &format!(",{}", column.name));
    text.push('\n');
    for (at, ((pressure, overclosure), point)) in law.rows(units).zip(&law.points).enumerate() {
        let cells = [pressure, overclosure, units.length(point.mean_gap_m), point.area_fraction];
        text += &cells.map(number).join(",");
        for column in columns {
            text.push(',');
            text += &column.values[at].map(number).unwrap_or_default();
        }
        text.push('\n');
    }
    Ok(text)
}

const NODE_TO_SURFACE: &str = "Take it with *CONTACT PAIR, TYPE=NODE TO SURFACE: in face-to-face contact CalculiX 2.20 finds \
                               no pressure in a table, and says nothing of it.";

/// Describes how a code reads the table.
fn of_code(dialect: Dialect, law: &ContactLaw, units: UnitSystem) -> Vec<String> {
    let last_pa = law.points.last().map_or(0.0, |point| point.pressure_pa);
    let last = format!("{} {}", number(units.pressure(last_pa)), units.pressure_symbol());
    match dialect {
        Dialect::Csv => Vec::new(),
        Dialect::Abaqus => vec![format!("Beyond {last} Abaqus goes on along the last line.")],
        Dialect::Calculix => vec![
            NODE_TO_SURFACE.to_owned(),
            format!("Beyond the last row CalculiX holds the pressure at {last}: no more load is carried."),
            "CalculiX looks at a table below a clearance of 1e-3 of the root of the slave area alone; this one has no \
             pressure at a clearance."
                .to_owned(),
        ],
    }
}
