//! Small scans of every kind, with missing points.

use scans::{MissingPoints, ScanFile, ScanSize};

use crate::{Draw, Reach, SmallMap};

/// Line or map with missing points as plain numbers; printed, it is a literal that recreates it.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnScan {
    /// Number of points along x.
    pub columns: usize,
    /// Number of points along y, of a map.
    pub rows: Option<usize>,
    /// Length along x \[m\].
    pub length_x_m: f64,
    /// Length along y \[m\]; not used for a line.
    pub length_y_m: f64,
    /// Heights \[m\], row by row.
    pub heights_m: Vec<f64>,
    /// Missing points, in rising order.
    pub missing: Vec<usize>,
    /// Positions \[m\] of an uneven line, which has no missing points.
    pub positions_m: Option<Vec<f64>>,
}

impl DrawnScan {
    /// Draws a scan.
    pub(crate) fn draw(draw: &mut Draw, reach: Reach) -> Self {
        let map = SmallMap::draw(draw, reach);
        let is_line = map.rows == 1 || map.columns == 1;
        let points = map.heights_m.len();
        let missing = draw_missing(draw, points, map.columns);
        let is_uneven = is_line && draw.chance(0.3);
        let spacing_m = map.length_x_m / map.columns as f64;
        let positions_m = is_uneven.then(|| {
            let mut at_m = 0.0;
            let mut step = || {
                at_m += spacing_m * draw.decades(-3.0, 1.0);
                at_m
            };
            (0..points).map(|_| step()).collect()
        });
        DrawnScan {
            columns: if is_line { points } else { map.columns },
            rows: (!is_line).then_some(map.rows),
            length_x_m: if is_line { spacing_m * points as f64 } else { map.length_x_m },
            length_y_m: map.length_y_m,
            heights_m: map.heights_m,
            missing: if is_uneven { Vec::new() } else { missing },
            positions_m,
        }
    }

    /// File in memory whose missing points hold some value \[m\].
    pub(crate) fn file(&self, at_missing_m: f64) -> Option<ScanFile> {
        let missing = MissingPoints::from_iter(self.missing.iter().copied());
        let mut heights_m = self.heights_m.clone();
        self.missing.iter().for_each(|&point| heights_m[point] = at_missing_m);
        let size = ScanSize { x_m: self.length_x_m, y_m: self.rows.map(|_| self.length_y_m) };
        match self.rows {
            Some(_) => ScanFile::of_map("map".to_owned(), size, self.columns, heights_m, missing),
            None => ScanFile::of_line("line".to_owned(), size, heights_m, missing),
        }
        .ok()
    }

    /// Lengths and heights times some factors.
    pub(crate) fn scaled(&self, length: f64, height: f64) -> Self {
        let times = |factor: f64, values: &[f64]| values.iter().map(|value| factor * value).collect();
        DrawnScan {
            length_x_m: length * self.length_x_m,
            length_y_m: length * self.length_y_m,
            heights_m: times(height, &self.heights_m),
            positions_m: self.positions_m.as_ref().map(|positions_m| times(length, positions_m)),
            missing: self.missing.clone(),
            ..*self
        }
    }
}

/// Draws which points are missing: none, some, many, whole rows, all but one, all.
fn draw_missing(draw: &mut Draw, points: usize, columns: usize) -> Vec<usize> {
    let place = draw.between(0.0, points as f64) as usize;
    let share = draw.one_of(&[0.05, 0.15, 0.6]);
    match draw.between(0.0, 10.0) as usize {
        0..=2 => Vec::new(),
        3..=6 => (0..points).filter(|_| draw.chance(share)).collect(),
        7 => (0..points).filter(|point| point / columns == place / columns).collect(),
        8 => (0..points).filter(|point| *point != place).collect(),
        _ if draw.chance(0.5) => (0..points).collect(),
        _ => vec![place],
    }
}
