//! Positions or numbers of columns and rows in the first line and the first column of a map.

use super::columns::Columns;
use super::heads::Heads;

/// Fewest labels that are no heights by chance.
const TELLING: usize = 4;

/// The labels of a map.
pub(super) struct Labels {
    has_row: bool,
    has_column: bool,
    /// Distances of columns and rows in the unit of lengths, where the labels are positions.
    pub(super) spacings: Option<[f64; 2]>,
}

impl Labels {
    /// Finds labels: even steps where no heights have them. Those above may stand in the line of names.
    pub(super) fn find(columns: &Columns, heads: &Heads) -> Option<Self> {
        let rows = columns.rows();
        if rows < TELLING + 1 {
            return None;
        }
        let first_row: Vec<f64> = (1..columns.count).filter_map(|column| columns.at(0, column)).collect();
        let second_row: Vec<f64> = (1..columns.count).filter_map(|column| columns.at(1, column)).collect();
        let in_names: Option<Vec<f64>> =
            (1..columns.count).map(|column| heads.of(column)?.name.parse().ok()).collect();
        let above =
            step(&first_row).filter(|_| first_row.len() + 1 == columns.count && step(&second_row).is_none());
        let (across, has_row) = match in_names.as_deref().and_then(step) {
            Some(across) => (Some(across), false),
            None => (above, true),
        };
        let across = across?;
        let beside: Vec<f64> = (usize::from(has_row)..rows).filter_map(|row| columns.at(row, 0)).collect();
        let others: Vec<f64> = (usize::from(has_row)..rows).filter_map(|row| columns.at(row, 1)).collect();
        let is_full = beside.len() + usize::from(has_row) == rows;
        let down = step(&beside).filter(|_| is_full && step(&others).is_none());
        let has_column = down.is_some();
        if !has_column && !has_row {
            return None;
        }
        // Without labels beside the rows the first of those above stands over heights.
        let corner = columns.at(0, 0).zip(first_row.first());
        let continues =
            corner.is_some_and(|(corner, first)| (first - corner - across).abs() <= 1e-6 * across.abs());
        if !has_column && !continues {
            return None;
        }
        let are_numbers = across == 1.0 && down.is_none_or(|down| down == 1.0);
        let spacings = down.filter(|_| !are_numbers).map(|down| [across.abs(), down.abs()]);
        Some(Self { has_row, has_column, spacings })
    }

    /// Takes the labels away.
    pub(super) fn take_off(&self, columns: &mut Columns, notes: &mut Vec<String>) {
        columns.drop_edges(self.has_row, self.has_column);
        let where_they_stand = match (self.has_row, self.has_column) {
            (true, true) => "the first line and the first column",
            (true, false) => "the first line",
            _ => "the names and the first column",
        };
        let what = if self.spacings.is_some() { "positions" } else { "numbers of columns and rows" };
        notes.push(format!("{where_they_stand} rise evenly: they are taken for {what}, not for heights"));
    }
}

/// The step of numbers that rise or fall evenly; none where they do not, or are too few.
fn step(numbers: &[f64]) -> Option<f64> {
    let (first, last) = (numbers.first()?, numbers.last()?);
    let step = (last - first) / (numbers.len() - 1) as f64;
    let is_even =
        |(at, number): (usize, &f64)| (number - first - at as f64 * step).abs() <= 1e-3 * step.abs();
    (numbers.len() >= TELLING && step != 0.0 && numbers.iter().enumerate().all(is_even)).then_some(step)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_even_over_four_numbers_or_more() {
        assert_eq!(step(&[0.0, 0.5, 1.0, 1.5]), Some(0.5));
        assert_eq!(step(&[3.0, 2.0, 1.0, 0.0]), Some(-1.0));
        assert_eq!(
            (step(&[0.0, 0.5, 1.0]), step(&[0.0, 0.5, 1.0, 1.6]), step(&[1.0; 5]), step(&[])),
            (None, None, None, None)
        );
    }
}
