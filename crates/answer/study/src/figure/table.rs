//! The data of a figure as a table.

use tables::Table;

use super::{BandKind, FigureBand, FigureData, Series};

impl FigureData {
    /// Returns the lines as a table: every abscissa of any line, a column per line, and columns for the ends of intervals, called
    /// like their lines with `low` and `high` after it.
    pub fn table(&self) -> Table {
        let abscissas = self.abscissas();
        let table = Table::default().with_numbers(self.x.column, abscissas.iter().copied());
        let with = |table: Table, name: &str, points: &mut dyn Iterator<Item = (f64, f64)>| {
            let mut points = points.peekable();
            let cell = |x: &f64| points.next_if(|(at, _)| at == x).map(|(_, value)| value);
            table.with_numbers(name, abscissas.iter().map(cell).collect::<Vec<_>>())
        };
        let table = self
            .series
            .iter()
            .fold(table, |table, series| with(table, &series.column, &mut series.points.iter().copied()));
        self.intervals().fold(table, |table, (line, band)| {
            [(0, "low"), (1, "high")].into_iter().fold(table, |table, (end, name)| {
                let points = &mut band.points.iter().map(|(x, ends)| (*x, ends[end]));
                with(table, &format!("{line} {name}"), points)
            })
        })
    }

    /// The intervals of lines, each with the column of its line.
    fn intervals(&self) -> impl Iterator<Item = (&str, &FigureBand)> {
        let intervals = self.bands.iter().filter(|band| band.kind == BandKind::Interval);
        intervals.filter_map(|band| {
            let is_its = |line: &&Series| (line.curve_index, line.load) == (band.curve_index, band.load);
            Some((self.series.iter().find(is_its)?.column.as_str(), band))
        })
    }

    /// The abscissas of all lines, each once, in the direction in which the lines run.
    fn abscissas(&self) -> Vec<f64> {
        let of_lines = self.series.iter().flat_map(|series| series.points.iter().map(|(x, _)| *x));
        let of_bands = self.intervals().flat_map(|(_, band)| band.points.iter().map(|(x, _)| *x));
        let mut all: Vec<f64> = of_lines.chain(of_bands).collect();
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

    use crate::figure::{Axis, BandKind, FigureBand, FigureData, Series, Shows};

    const WAVELENGTH: Axis = Axis { column: "wavelength_m", label: "wavelength (m)" };

    #[test]
    fn lines_of_different_abscissas_share_a_table() {
        let series = vec![
            Series::under("a", 0, vec![(3.0, 0.3), (2.0, 0.2), (1.0, 0.1)]),
            Series::under("b", 0, vec![(2.0, 0.5), (0.5, 0.4)]),
        ];
        let interval = FigureBand {
            label: String::new(),
            kind: BandKind::Interval,
            load: None,
            curve_index: 0,
            points: vec![(2.0, [0.1, 0.3])],
        };
        let figure =
            FigureData { bands: vec![interval], ..FigureData::new("f", Shows::Area, WAVELENGTH, "", series) };
        let table = figure.table();
        let column = |name: &str| match table.column(name) {
            Some(Cells::Numbers(cells)) => cells.clone(),
            other => panic!("{other:?}"),
        };
        assert_eq!(column("wavelength_m"), [Some(3.0), Some(2.0), Some(1.0), Some(0.5)]);
        assert_eq!(column("a"), [Some(0.3), Some(0.2), Some(0.1), None]);
        assert_eq!(column("b"), [None, Some(0.5), None, Some(0.4)]);
        assert_eq!(column("a low"), [None, Some(0.1), None, None]);
        assert_eq!(column("a high"), [None, Some(0.3), None, None]);
    }
}
