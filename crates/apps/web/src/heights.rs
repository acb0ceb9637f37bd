//! Heights of a map, few enough to be drawn by the page in colours of its reader's choice.

use elements::Relief;
use report::chart::palette::map_colour;
use scans::ScanFile;
use serde::Serialize;
use units::display::length;

/// The most points along the longer side of a map.
const MOST_POINTS: usize = 512;

/// The number of colours.
const COLOURS: usize = 256;

/// The heights of a map.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MapHeights {
    /// Points along x.
    pub columns: usize,
    /// Points along y.
    pub rows: usize,
    /// Height over width of the map.
    pub aspect: f64,
    /// Heights row by row, from 0 at the lowest to 65534 at the highest; 65535 for a missing point.
    pub heights: Vec<u16>,
    /// The difference of the highest and the lowest in print.
    pub range: String,
    /// Difference of the highest and the lowest \[m\].
    pub range_m: f64,
    /// Red, green and blue of the colours from the lowest to the highest.
    pub colours: Vec<[u8; 3]>,
}

impl MapHeights {
    /// Takes every few points of a map; `None` for a line and for a map without heights.
    pub(crate) fn new(file: &ScanFile) -> Option<Self> {
        let scan = &file.scan;
        let (columns, Some(rows)) = scan.points() else { return None };
        let (x_m, y_m) = scan.size_m();
        let aspect = y_m.unwrap_or(x_m) / x_m;
        Self::thinned([columns, rows], aspect, scan.heights_m().flatten(), |at| scan.height_m(at))
    }

    /// Takes every few points of heights that are pressed; `None` if they are not numbers.
    pub(crate) fn of_relief(relief: &Relief) -> Option<Self> {
        let heights_m = &relief.heights_m;
        let aspect = relief.length_y_m / relief.length_x_m;
        let of = |at: usize| heights_m.get(at).copied();
        Self::thinned([relief.columns, relief.rows], aspect, heights_m.iter().copied(), of)
    }

    fn thinned(
        [columns, rows]: [usize; 2],
        aspect: f64,
        all_m: impl Iterator<Item = f64>,
        height_m: impl Fn(usize) -> Option<f64>,
    ) -> Option<Self> {
        let step = columns.max(rows).div_ceil(MOST_POINTS);
        let (lowest, highest) = all_m.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), height| {
            (low.min(height), high.max(height))
        });
        let range_m = highest - lowest;
        if !range_m.is_finite() {
            return None;
        }
        let level =
            |height_m: f64| (65534.0 * (height_m - lowest) / range_m.max(f64::MIN_POSITIVE)).round() as u16;
        let heights = (0..rows)
            .step_by(step)
            .flat_map(|row| (0..columns).step_by(step).map(move |column| row * columns + column))
            .map(|at| height_m(at).map_or(u16::MAX, level))
            .collect();
        Some(MapHeights {
            columns: columns.div_ceil(step),
            rows: rows.div_ceil(step),
            aspect,
            heights,
            range: length(range_m),
            range_m,
            colours: (0..COLOURS).map(|at| map_colour(at as f64 / (COLOURS - 1) as f64)).collect(),
        })
    }
}
