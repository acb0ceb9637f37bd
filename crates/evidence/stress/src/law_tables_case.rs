//! Contact laws as tables of finite element codes: their numbers, and the promises of every table.

use interface::finite_elements::{
    Column, ConductancePoint, ConductanceTable, ContactLaw, ContactLawError, Dialect, Flow, Heading,
    LawPoint, SamplingError, UnitSystem,
};

use crate::tally::{Case, Refused, Trial};
use crate::{Draw, Reach};

/// Shape of a law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// u = -u0 ln p.
    Exponential,
    /// u = u0 p^-n.
    Power(f64),
    /// Exponential with another decay length, times this factor, from a pressure over the first one on.
    Kink(f64, f64),
    /// Exponential whose gap falls at once, by this share of u0, at a pressure over the first one.
    Step(f64, f64),
    /// Exponential whose gap stays beyond a pressure over the first one.
    Plateau(f64),
    /// Exponential without a gap beyond a pressure over the first one.
    Missing(f64),
}

/// Law, range and units; printed, it is a literal that recreates it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LawTablesCase {
    /// Shape.
    pub shape: Shape,
    /// Length u0 \[m\].
    pub length_m: f64,
    /// Range of pressures \[Pa\].
    pub range_pa: [f64; 2],
    /// Relative error of the pressure.
    pub tolerance: f64,
    /// Units of the tables.
    pub units: UnitSystem,
}

impl LawTablesCase {
    fn gap_m(&self, pressure_pa: f64) -> Option<f64> {
        let ratio = pressure_pa / self.range_pa[0];
        let exponential_m = -self.length_m * ratio.ln();
        Some(match self.shape {
            Shape::Exponential => exponential_m,
            Shape::Power(exponent) => self.length_m * ratio.powf(-exponent),
            Shape::Kink(at, factor) if ratio > at => -self.length_m * (at.ln() + factor * (ratio / at).ln()),
            Shape::Step(at, share) if ratio > at => exponential_m - share * self.length_m,
            Shape::Plateau(at) if ratio > at => -self.length_m * at.ln(),
            Shape::Missing(at) if ratio > at => return None,
            _ => exponential_m,
        })
    }

    fn sample(&self) -> Result<ContactLaw, SamplingError<()>> {
        ContactLaw::sample(self.range_pa, self.tolerance, |pressure_pa| {
            let point = |mean_gap_m| LawPoint { pressure_pa, mean_gap_m, area_fraction: 0.1 };
            Ok(self.gap_m(pressure_pa).map(point))
        })
    }

    /// True if rounding decides the fall of the gap between two pressures \[Pa\].
    fn is_lost(&self, from_pa: f64, to_pa: f64) -> bool {
        let gap_m = |pressure_pa: f64| self.gap_m(pressure_pa).unwrap_or(0.0);
        let largest_m = gap_m(0.36 * self.range_pa[0]).abs().max(gap_m(to_pa).abs()).max(f64::MIN_POSITIVE);
        gap_m(from_pa) - gap_m(to_pa) < 20.0 * f64::EPSILON * largest_m / self.tolerance
    }

    fn is_smooth(&self) -> bool {
        matches!(self.shape, Shape::Exponential | Shape::Power(_))
    }
}

impl Case for LawTablesCase {
    fn draw(draw: &mut Draw) -> (Self, Reach) {
        let reach = Reach::draw(draw);
        let from_pa = reach.number(draw, 0.0, 9.0);
        let decades = if reach == Reach::Usual { (-2.0, 4.0) } else { (-12.0, 10.0) };
        let to_pa = from_pa * (1.0 + draw.decades(decades.0, decades.1));
        let ratio = draw.decades(-1.0, 5.0);
        let exponent = draw.decades(-3.0, 0.5);
        let size = draw.decades(-6.0, 2.0);
        let shape = draw.one_of(&[
            Shape::Exponential,
            Shape::Power(exponent),
            Shape::Kink(ratio, size),
            Shape::Step(ratio, size),
            Shape::Plateau(ratio),
            Shape::Missing(ratio),
        ]);
        let case = LawTablesCase {
            shape,
            length_m: reach.number(draw, -9.0, -5.0),
            range_pa: [from_pa, to_pa],
            tolerance: draw.decades(-5.0, -0.31),
            units: draw.one_of(UnitSystem::ALL),
        };
        (case, reach)
    }

    fn test(trial: &mut Trial<Self>) -> Result<(), Refused> {
        let case = trial.case;
        conductance(trial);
        let law = match case.sample() {
            Ok(law) => law,
            Err(error) => {
                let is_its_own = match error {
                    SamplingError::NotClosing { from_pa, to_pa } => {
                        !case.is_smooth() || case.is_lost(from_pa, to_pa)
                    }
                    SamplingError::NoGap { .. } => {
                        matches!(case.shape, Shape::Missing(_)) || trial.reach == Reach::Edge
                    }
                    SamplingError::EmptyRange { from_pa, to_pa } => from_pa >= to_pa,
                    SamplingError::Value(_) => trial.reach == Reach::Edge || case.length_m > 1e25,
                    _ => trial.reach == Reach::Edge,
                };
                trial.hold("a law is refused for what it is", is_its_own);
                return Err(Refused);
            }
        };
        let points = &law.points;
        trial.hold("pressures rise", points.is_sorted_by(|low, high| low.pressure_pa < high.pressure_pa));
        trial.hold("gaps fall", points.is_sorted_by(|low, high| low.mean_gap_m > high.mean_gap_m));
        let ends = points.len() > 2 && points[1].pressure_pa == case.range_pa[0];
        trial.hold("range of the table", ends && points[points.len() - 1].pressure_pa == case.range_pa[1]);
        trial.bound("number of points", points.len() as f64, 1e5);
        if case.is_smooth() {
            trial.bound("interpolation error within the tolerance", law.interpolation_error, case.tolerance);
        }
        for point in &points[1..] {
            let back_pa = law.pressure_pa(law.overclosure_m(point.mean_gap_m));
            // Overclosures lose the digits that the first gap has beyond theirs.
            let allowed =
                if case.is_lost(0.9 * point.pressure_pa, point.pressure_pa) { case.tolerance } else { 1e-9 };
            trial.bound("p -> gap -> p at a point", (back_pa / point.pressure_pa - 1.0).abs(), allowed);
        }
        let share = trial.draw.between(0.0, 1.0);
        let pressure_pa = case.range_pa[0] * (case.range_pa[1] / case.range_pa[0]).powf(share);
        if let (Some(gap_m), true) = (case.gap_m(pressure_pa), case.is_smooth()) {
            let first_m = points[1].mean_gap_m.abs().max(gap_m.abs());
            let slope_m = (points[0].mean_gap_m - points[points.len() - 1].mean_gap_m).abs();
            let back_pa = law.pressure_pa(law.overclosure_m(gap_m));
            let rounding = 1e-14 * first_m / slope_m.max(f64::MIN_POSITIVE) * points.len() as f64;
            let allowed = 1.1 * case.tolerance + rounding;
            trial.bound("table within its tolerance", (back_pa / pressure_pa - 1.0).abs(), allowed);
        }
        texts(&law, trial);
        Ok(())
    }
}

/// Rows of numbers of a text, without comments, keywords and names.
fn numbers(text: &str) -> Vec<Vec<f64>> {
    let rows = text.lines().filter(|line| !line.starts_with(['*', '#']));
    rows.filter_map(|line| line.split(',').map(|cell| cell.trim().parse().ok()).collect()).collect()
}

/// Checks what codes read.
fn texts(law: &ContactLaw, trial: &mut Trial<LawTablesCase>) {
    let case = trial.case;
    let heading = Heading { name: "rough".to_owned(), provenance: vec!["a law".to_owned()] };
    for dialect in Dialect::ALL {
        let text = match dialect.table(law, case.units, &heading, &[]) {
            Ok(text) => text,
            Err(ContactLawError::TooClose { step_m, .. }) => {
                let length_m = case.units.length_m() * Dialect::LEAST_CALCULIX_STEP;
                let is_close =
                    step_m <= 0.0 || (*dialect == Dialect::Calculix && step_m < length_m * (1.0 + 1e-9));
                trial.hold("a table is refused for its steps", is_close);
                continue;
            }
            Err(ContactLawError::TooManyRows { rows, most, .. }) => {
                trial.hold("a table is refused for its rows", rows > most);
                continue;
            }
            Err(_) => {
                trial.hold("a table is refused for its steps", false);
                continue;
            }
        };
        let rows = numbers(&text);
        trial.hold("a line for each point", rows.len() == law.points.len());
        let wanted: Vec<(f64, f64)> = law.rows(case.units).collect();
        let largest = wanted.iter().fold(0.0f64, |most, row| most.max(row.1.abs()));
        let off = rows.iter().zip(&wanted).map(|(read, (pressure, overclosure))| {
            let of_pressure = if *pressure == 0.0 { read[0].abs() } else { (read[0] / pressure - 1.0).abs() };
            of_pressure.max((read[1] - overclosure).abs() / largest.max(f64::MIN_POSITIVE))
        });
        trial.bound("codes read the points", off.fold(0.0, f64::max), 1e-11);
        let rises = rows.is_sorted_by(|low, high| low[0] < high[0] && low[1] < high[1]);
        trial.hold("what codes read rises", rises);
    }
    let column = Column { name: "stiffness".to_owned(), values: vec![None] };
    let refused = Dialect::Csv.table(law, case.units, &heading, &[column]);
    let is_length = matches!(refused, Err(ContactLawError::ColumnLength { .. }));
    trial.hold("a column of another length is refused", is_length);
}

/// Checks a table of conductances in proportion to the load, plus gas.
fn conductance(trial: &mut Trial<LawTablesCase>) {
    let case = trial.case;
    let exponent = match case.shape {
        Shape::Power(exponent) => exponent,
        _ => 1.0,
    };
    let gas_si = trial.draw.one_of(&[0.0, 1.0, 1e6]);
    let at = |pressure_pa: f64| ConductancePoint {
        pressure_pa,
        contact_si: 1e3 * (pressure_pa / case.range_pa[0]).powf(exponent),
        gas_si,
    };
    let flow = trial.draw.one_of(Flow::ALL);
    let table = match ConductanceTable::sample(flow, case.range_pa, case.tolerance, |p_pa| {
        Ok::<_, ()>(at(p_pa))
    }) {
        Ok(table) => table,
        Err(error) => {
            let is_empty = case.range_pa[0] >= case.range_pa[1] || matches!(error, SamplingError::Value(_));
            trial.hold("conductances are refused for their range", is_empty || trial.reach == Reach::Edge);
            return;
        }
    };
    let points = &table.points;
    trial.hold("pressures of conductances rise", points.is_sorted_by(|a, b| a.pressure_pa < b.pressure_pa));
    trial.bound("conductance within its tolerance, halfway", table.interpolation_error, case.tolerance);
    let share = trial.draw.between(0.0, 1.0);
    let pressure_pa = case.range_pa[0] * (case.range_pa[1] / case.range_pa[0]).powf(share);
    let off = (table.conductance_si(pressure_pa) / at(pressure_pa).total_si() - 1.0).abs();
    trial.bound("conductance within its tolerance", off, 1.1 * case.tolerance + 1e-12);
    for dialect in Dialect::ALL {
        let Ok(text) = table.to_text(*dialect, case.units, &[]) else {
            trial.hold("conductances are refused for their rows", points.len() > Dialect::MOST_CALCULIX_ROWS);
            continue;
        };
        trial.hold("a line for each conductance", numbers(&text).len() == points.len());
    }
}
