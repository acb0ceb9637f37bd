//! Persson's theory row by row: a nominal pressure, the spread of the pressure that would flatten the roughness, and a
//! hardness.

use numerics::parallel::Progress;
use persson::{ContactAreas, constant_hardness, elastic, growing_hardness};
use tables::{Cells, InputTable, Refusal, Row};
use units::{Bound, Remark, RemarkCode};

use super::{RowByRow, RowsError, rows_of};

/// A table of pressures and spreads, with the option that holds for all of its rows.
#[derive(Debug, Default)]
pub struct Flattened {
    yields: Option<bool>,
    /// True if a row checked so far has a hardness that counts.
    any_yields: bool,
    rows: usize,
    flowing: usize,
}

/// A row of the table, in Pa.
#[derive(Clone, Copy)]
struct RowRequest {
    pressure: f64,
    spread: f64,
    /// H at the longest wavelength, and dH^2/dV.
    hardness: Option<(f64, f64)>,
}

const REQUIRED_COLUMNS: [&str; 2] = ["pressure_pa", "rms_pressure_pa"];

impl Flattened {
    /// A table whose hardnesses count or not; if `yields` is `None`, a row with a hardness yields.
    #[must_use]
    pub fn new(yields: Option<bool>) -> Self {
        Flattened { yields, ..Flattened::default() }
    }

    /// The requests of all rows.
    fn asked(&self, block: &InputTable) -> Result<Vec<RowRequest>, Refusal> {
        block.rows(&REQUIRED_COLUMNS, |row| self.read(row))
    }

    fn read(&self, row: &Row<'_>) -> Result<RowRequest, String> {
        let pressure = row.number("pressure_pa", Bound::Magnitude)?;
        let spread = row.number("rms_pressure_pa", Bound::AtLeast(0.0))?;
        if spread > 0.0 {
            row.number("rms_pressure_pa", Bound::Magnitude)?;
        }
        let hardness = match self.yields {
            Some(false) => None,
            Some(true) => Some(row.number("hardness_pa", Bound::Magnitude)?),
            None => row.optional_number("hardness_pa", Bound::Magnitude)?,
        };
        let growth = row.optional_number("hardness_growth", Bound::AtLeast(0.0))?;
        let hardness = match (hardness, growth.unwrap_or(0.0)) {
            (Some(hardness), growth) if growth > 0.0 && pressure >= hardness => {
                return Err(format!(
                    "column pressure_pa: {pressure} is not below hardness_pa, {hardness}, and a hardness that grows cannot \
                     carry it at the longest wavelength"
                ));
            }
            (None, growth) if growth > 0.0 && self.yields.is_none() => {
                return Err("column hardness_growth: there is no hardness_pa that could grow".to_owned());
            }
            (hardness, growth) => hardness.map(|hardness| (hardness, growth)),
        };
        Ok(RowRequest { pressure, spread, hardness })
    }
}

impl RowRequest {
    fn areas(&self) -> ContactAreas {
        let RowRequest { pressure, spread, hardness } = *self;
        match hardness {
            None => ContactAreas {
                elastic: elastic::area_fraction(pressure, spread),
                plastic: 0.0,
                gap: elastic::gap_fraction(pressure, spread),
            },
            Some((hardness, 0.0)) => constant_hardness::areas(pressure, spread, hardness),
            Some((hardness, growth)) => {
                growing_hardness::areas_of_squared_growth(pressure, spread, hardness, growth)
            }
        }
    }
}

impl RowByRow for Flattened {
    fn check(&mut self, block: &InputTable) -> Result<(), Refusal> {
        self.any_yields |= self.asked(block)?.iter().any(|asked| asked.hardness.is_some());
        Ok(())
    }

    fn fill_in(&mut self, block: &mut InputTable, progress: &dyn Progress) -> Result<Vec<Remark>, RowsError> {
        let asked = self.asked(block)?;
        let areas = numerics::parallel::try_map(&asked, |asked| {
            if progress.is_cancelled() {
                return Err(RowsError::Cancelled);
            }
            let areas = asked.areas();
            progress.advance(1);
            Ok(areas)
        })?;
        self.rows += asked.len();
        self.flowing += asked
            .iter()
            .filter(|asked| asked.hardness.is_some_and(|(hardness, _)| asked.pressure >= hardness))
            .count();
        let mut set = |name: &str, of: fn(&ContactAreas) -> f64| {
            block.table.set(name, Cells::Numbers(areas.iter().map(|areas| Some(of(areas))).collect()));
        };
        set("area_fraction", ContactAreas::contact);
        set("elastic_area_fraction", |areas| areas.elastic);
        set("plastic_area_fraction", |areas| areas.plastic);
        Ok(Vec::new())
    }

    fn knows(&self, column: &str) -> bool {
        ["hardness_pa", "hardness_growth"].contains(&column)
    }

    fn depends_on(&self, column: &str) -> bool {
        REQUIRED_COLUMNS.contains(&column) || self.any_yields
    }

    fn notes(&self) -> Vec<Remark> {
        rows_of(RemarkCode::FlowingRows, self.flowing, self.rows).into_iter().collect()
    }
}
