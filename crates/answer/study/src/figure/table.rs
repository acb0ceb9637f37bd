//! The data of a figure as a table.

use std::collections::BTreeSet;

use tables::Table;

use super::{BandKind, FigureBand, FigureData, Mark, Series};

impl FigureData {
    /// Returns all that is drawn as a table: every abscissa, a column per line and kind of marks, and columns for the ends of
    /// bands and of the bars of marks, with `low` and `high` after their names.
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
        let table = self.named_bands().fold(table, |table, (column, band)| {
            [(0, "low"), (1, "high")].into_iter().fold(table, |table, (end, name)| {
                let points = &mut band.points.iter().map(|(x, ends)| (*x, ends[end]));
                with(table, &format!("{column} {name}"), points)
            })
        });
        self.mark_columns().into_iter().fold(table, |table, column| {
            let numbers = |table: Table, name: &str, of: fn(&Mark) -> f64| {
                let cell =
                    |x: &f64| self.marks.iter().find(|mark| mark.column == column && mark.x == *x).map(of);
                table.with_numbers(&format!("{column}{name}"), abscissas.iter().map(cell))
            };
            let table = numbers(table, "", |mark| mark.y);
            numbers(numbers(table, " low", |mark| mark.low), " high", |mark| mark.high)
        })
    }

    /// Returns the columns of the marks, each once.
    fn mark_columns(&self) -> Vec<&str> {
        let mut columns: Vec<&str> = self.marks.iter().map(|mark| mark.column.as_str()).collect();
        let mut seen = BTreeSet::new();
        columns.retain(|column| seen.insert(*column));
        columns
    }

    /// Returns the bands with the names of their columns: an interval is called like its line, a yardstick by its label and load.
    pub fn named_bands(&self) -> impl Iterator<Item = (String, &FigureBand)> {
        self.bands.iter().filter_map(|band| {
            let is_its = |line: &&Series| match band.kind {
                BandKind::Interval => (line.curve_index, line.load) == (band.curve_index, band.load),
                BandKind::Yardstick => line.load == band.load,
            };
            let line = self.series.iter().find(is_its)?;
            let column = match band.kind {
                BandKind::Interval => line.column.clone(),
                BandKind::Yardstick => format!("{} at {}", band.label, line.condition),
            };
            Some((column, band))
        })
    }

    /// The abscissas of all lines, each once, in the direction in which the lines run.
    fn abscissas(&self) -> Vec<f64> {
        let of_lines = self.series.iter().flat_map(|series| series.points.iter().map(|(x, _)| *x));
        let of_bands = self.named_bands().flat_map(|(_, band)| band.points.iter().map(|(x, _)| *x));
        let of_marks = self.marks.iter().map(|mark| mark.x);
        let mut all: Vec<f64> = of_lines.chain(of_bands).chain(of_marks).collect();
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

    use crate::figure::{Axis, BandKind, FigureBand, FigureData, Mark, Series, Shows};

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
        let mark = Mark {
            label: String::new(),
            column: "elements".to_owned(),
            is_ring: false,
            condition_index: None,
            x: 1.5,
            y: 0.6,
            low: 0.5,
            high: 0.7,
        };
        let (bands, marks) = (vec![interval], vec![mark]);
        let figure = FigureData { bands, marks, ..FigureData::new("f", Shows::Area, WAVELENGTH, "", series) };
        let table = figure.table();
        let column = |name: &str| match table.column(name) {
            Some(Cells::Numbers(cells)) => cells.clone(),
            other => panic!("{other:?}"),
        };
        assert_eq!(column("wavelength_m"), [Some(3.0), Some(2.0), Some(1.5), Some(1.0), Some(0.5)]);
        assert_eq!(column("a"), [Some(0.3), Some(0.2), None, Some(0.1), None]);
        assert_eq!(column("b"), [None, Some(0.5), None, None, Some(0.4)]);
        assert_eq!(column("a low"), [None, Some(0.1), None, None, None]);
        assert_eq!(column("a high"), [None, Some(0.3), None, None, None]);
        for (name, value) in [("elements", 0.6), ("elements low", 0.5), ("elements high", 0.7)] {
            assert_eq!(column(name), [None, None, Some(value), None, None], "{name}");
        }
    }
}
