//! The data of a figure as a table.

use tables::Table;

use super::FigureData;

impl FigureData {
    /// Returns the lines as a table: every abscissa of any line, and a column per line.
    pub fn table(&self) -> Table {
        let abscissas = self.abscissas();
        let table = Table::default().with_numbers(self.x.column, abscissas.iter().copied());
        self.series.iter().fold(table, |table, series| {
            let mut points = series.points.iter().peekable();
            let cell = |x: &f64| points.next_if(|(at, _)| at == x).map(|(_, value)| *value);
            table.with_numbers(&series.column, abscissas.iter().map(cell).collect::<Vec<_>>())
        })
    }

    /// The abscissas of all lines, each once, in the direction in which the lines run.
    fn abscissas(&self) -> Vec<f64> {
        let mut all: Vec<f64> =
            self.series.iter().flat_map(|series| series.points.iter().map(|(x, _)| *x)).collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        let falling =
            self.series.iter().any(|series| matches!(series.points[..], [(a, _), .., (b, _)] if a > b));
        if falling {
            all.reverse();
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use tables::Cells;

    use crate::figure::{Axis, FigureData, Series, Shows};

    const WAVELENGTH: Axis = Axis { column: "wavelength_m", label: "wavelength (m)" };

    #[test]
    fn lines_of_different_abscissas_share_a_table() {
        let series = vec![
            Series::under("a", 0, vec![(3.0, 0.3), (2.0, 0.2), (1.0, 0.1)]),
            Series::under("b", 0, vec![(2.0, 0.5), (0.5, 0.4)]),
        ];
        let figure = FigureData::new("f", Shows::Area, WAVELENGTH, "", series);
        let table = figure.table();
        let column = |name: &str| match table.column(name) {
            Some(Cells::Numbers(cells)) => cells.clone(),
            other => panic!("{other:?}"),
        };
        assert_eq!(column("wavelength_m"), [Some(3.0), Some(2.0), Some(1.0), Some(0.5)]);
        assert_eq!(column("a"), [Some(0.3), Some(0.2), Some(0.1), None]);
        assert_eq!(column("b"), [None, Some(0.5), None, Some(0.4)]);
    }
}
