//! The middle of a measured map, for boundary elements.

use scans::{HeightMap, Scan, ScanFile};
use topography::{Detrend, Recipe, detrended_m};

/// The mean square of the steps across opposite edges over that of the steps between neighbours up to which a map repeats itself.
/// A map of rough skin that does not has tens or hundreds.
const STEPS_OF_REPEATING: f64 = 3.0;

/// The middle of a map, for boundary elements.
#[derive(Debug, Clone, PartialEq)]
pub struct MapPatch {
    /// The name of the measurement.
    pub name: String,
    /// Heights as measured.
    pub map: HeightMap,
    /// True if opposite edges match; false for a part of a periodic map.
    pub is_periodic: bool,
    /// Points of the whole map along x and along y.
    pub points_of_whole: [usize; 2],
    /// The trend to subtract from the heights, as for the spectrum.
    pub detrend: Detrend,
}

impl MapPatch {
    /// Takes the map of a file, at most so many points along each side. A map whose opposite edges fit as neighbours do repeats
    /// itself, whatever its file says, and keeps its tilt.
    pub(crate) fn from_file(file: &ScanFile<Scan>, recipe: &Recipe, most_points: usize) -> Option<Self> {
        let Scan::Map(map) = &file.scan else { return None };
        let is_periodic = file.is_periodic || repeats(map);
        let whole = MapPatch {
            name: file.name.clone(),
            map: map.middle(most_points),
            is_periodic: is_periodic && map.columns().max(map.rows()) <= most_points,
            points_of_whole: [map.columns(), map.rows()],
            detrend: recipe.preparation(is_periodic).detrend,
        };
        Some(whole)
    }

    /// Returns its middle, at most so many points along each side.
    #[must_use]
    pub fn middle(&self, most_points: usize) -> Self {
        let map = self.map.middle(most_points);
        MapPatch { is_periodic: self.is_periodic && map == self.map, map, ..self.clone() }
    }

    /// Returns the heights \[m\] without their trend.
    #[must_use]
    pub fn heights_m(&self) -> Vec<f64> {
        detrended_m(&self.map, self.detrend)
    }

    /// Returns the lengths of its sides \[m\] along x and along y.
    #[must_use]
    pub fn sides_m(&self) -> [f64; 2] {
        let map = &self.map;
        [map.columns() as f64 * map.spacing_x_m(), map.rows() as f64 * map.spacing_y_m()]
    }
}

/// Returns true if the heights of a map step across its opposite edges as they do between neighbours.
fn repeats(map: &HeightMap) -> bool {
    let (rows, columns, heights_m) = (map.rows(), map.columns(), map.heights_m());
    let along = |count: usize, across: usize, at: fn(usize, usize, usize) -> usize| {
        let step = |k: usize, i: usize, j: usize| (heights_m[at(i, k, columns)] - heights_m[at(j, k, columns)]).powi(2);
        let between: f64 = (0..across).flat_map(|k| (1..count).map(move |i| (k, i))).map(|(k, i)| step(k, i - 1, i)).sum();
        let edges: f64 = (0..across).map(|k| step(k, count - 1, 0)).sum();
        edges * (count - 1) as f64 <= STEPS_OF_REPEATING * between
    };
    along(columns, rows, |x, y, columns| y * columns + x) && along(rows, columns, |y, x, columns| y * columns + x)
}
