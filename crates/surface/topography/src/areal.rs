//! The two-dimensional transform of a map, in blocks of rows and then of columns.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use numerics::transforms::{Complex, Fft};

use crate::detrend::Trend;
use crate::lines::RowTransform;
use crate::preparation::Preparation;
use crate::radial::{ArealSpectrum, RadialBin};
use crate::rows::{BLOCK_ROWS, Rows};
use crate::sums::Spread;
use scans::HeightMap;

/// Columns transformed together: a cache line per row, and the block stays in the cache.
const BLOCK_COLUMNS: usize = 16;

/// Computes the two-dimensional spectrum of a map, averaged over directions; with the feature `parallel` on all
/// threads.
///
/// Needs as much additional memory as the map itself.
pub fn areal_spectrum(map: &HeightMap, preparation: Preparation) -> ArealSpectrum {
    let transform = ArealTransform::new(map, preparation);
    let rows: Vec<ArealRows> =
        numerics::parallel::map_indices(transform.row_blocks(), |block| transform.rows(block));
    let sums: Vec<ArealSums> =
        numerics::parallel::map_indices(transform.column_blocks(), |block| transform.columns(&rows, block));
    transform.spectrum(&rows, &sums)
}

/// The two steps of the areal transform in blocks, for any order and any number of threads. Sums are added in the order
/// of the map, so every digit of the spectrum is the same.
pub struct ArealTransform<'a> {
    map: &'a HeightMap,
    preparation: Preparation,
    trend: Trend,
    row_factors: Vec<f64>,
    row_transform: RowTransform,
    column_plan: Arc<dyn Fft<f64>>,
}

/// A block of rows, transformed along x.
#[derive(Clone, Debug)]
pub struct ArealRows {
    values: Vec<Complex<f64>>,
    spread: Spread,
}

/// Contribution of a block of columns to the rings.
#[derive(Clone, Debug)]
pub struct ArealSums {
    rings: Vec<Ring>,
}

#[derive(Clone, Copy, Debug, Default)]
struct Ring {
    modes: f64,
    radii: f64,
    power_m2: f64,
    /// Power times the square and the fourth power of the radius, mode by mode.
    power_of_slope_m2: f64,
    power_of_curvature_m2: f64,
}

/// Rings of modes: ring k holds k - 1/2 <= radius < k + 1/2, in units of the width.
struct Rings {
    /// Steps between neighbouring modes along x and y in units of 2 pi/max(Lx, Ly).
    steps: [f64; 2],
    /// Width in units of 2 pi/max(Lx, Ly): 1, or more to keep within `MAX_RINGS`.
    width: f64,
    count: usize,
}

/// Largest number of rings; bounds the memory for maps whose pixels are much longer one way than the other.
const MAX_RINGS: f64 = 1e6;

impl<'a> ArealTransform<'a> {
    /// Fits the trend and plans both transforms.
    pub fn new(map: &'a HeightMap, preparation: Preparation) -> Self {
        Self {
            map,
            preparation,
            trend: Trend::from_map(map, preparation.detrend),
            row_factors: preparation.window.factors(map.rows()),
            row_transform: RowTransform::new(map.columns(), preparation),
            column_plan: numerics::transforms::forward(map.rows()),
        }
    }

    /// Number of blocks of rows.
    pub fn row_blocks(&self) -> usize {
        self.map.rows().div_ceil(BLOCK_ROWS)
    }

    /// Transforms a block of rows, counted from 0; empty beyond the last.
    pub fn rows(&self, block: usize) -> ArealRows {
        let mut transform = self.row_transform.clone();
        let mut rows = ArealRows { values: Vec::new(), spread: Spread::default() };
        rows.values.reserve_exact(BLOCK_ROWS.min(self.map.rows()) * self.half_columns());
        for (row, heights_m) in Rows::from_map(self.map).block(block) {
            let factor = self.row_factors[row];
            rows.spread = rows.spread.joined(transform.run(&self.trend, row, heights_m).times(factor));
            rows.values.extend(transform.output.iter().map(|value| value * factor));
        }
        rows
    }

    /// Number of blocks of columns.
    pub fn column_blocks(&self) -> usize {
        self.half_columns().div_ceil(BLOCK_COLUMNS)
    }

    /// Sums a block of columns, counted from 0, over all blocks of rows in their order.
    pub fn columns(&self, rows: &[ArealRows], block: usize) -> ArealSums {
        let height = self.map.rows();
        let first = (block * BLOCK_COLUMNS).min(self.half_columns());
        let columns = first..(first + BLOCK_COLUMNS).min(self.half_columns());
        let mut values = vec![Complex::default(); columns.len() * height];
        let lines = rows.iter().flat_map(|rows| rows.values.chunks_exact(self.half_columns()));
        for (row, line) in lines.enumerate() {
            for (column, &value) in line[columns.clone()].iter().enumerate() {
                values[column * height + row] = value;
            }
        }
        let mut scratch = vec![Complex::default(); self.column_plan.get_inplace_scratch_len()];
        self.column_plan.process_with_scratch(&mut values, &mut scratch);

        let geometry = self.rings();
        let mut sums = ArealSums { rings: vec![Ring::default(); geometry.count] };
        for (column, values) in columns.zip(values.chunks_exact(height)) {
            sums.add_column(&geometry, column, self.is_its_own_mirror(column), values);
        }
        sums
    }

    /// Assembles the spectrum from all blocks of rows and the sums of all blocks of columns, both in their order.
    pub fn spectrum(&self, rows: &[ArealRows], sums: &[ArealSums]) -> ArealSpectrum {
        let map = self.map;
        let spacings_m = [map.spacing_x_m(), map.spacing_y_m()];
        let sizes_m = [spacings_m[0] * map.columns() as f64, spacings_m[1] * map.rows() as f64];
        let mut rings = vec![Ring::default(); self.rings().count];
        for sums in sums {
            rings.iter_mut().zip(&sums.rings).for_each(|(total, part)| total.add(*part));
        }
        // (dx dy)^2 |F|^2/(Lx Ly)
        let unit_m2 = (spacings_m[0] / map.columns() as f64) * (spacings_m[1] / map.rows() as f64);
        let step_rad_per_m = TAU / sizes_m[0].max(sizes_m[1]);
        let filled = rings.iter().filter(|ring| ring.modes > 0.0);
        let bins = filled.map(|ring| RadialBin {
            wavevector_rad_per_m: step_rad_per_m * (ring.radii / ring.modes),
            modes: ring.modes as u64,
            sum_m4: unit_m2 * ring.power_m2,
            slope_sum_m2: unit_m2 * ring.power_of_slope_m2 * step_rad_per_m.powi(2),
            curvature_sum: unit_m2 * ring.power_of_curvature_m2 * step_rad_per_m.powi(4),
        });
        ArealSpectrum {
            sizes_m,
            nyquist_rad_per_m: PI / spacings_m[0].max(spacings_m[1]),
            bins: bins.collect(),
            variance_m2: rows.iter().fold(Spread::default(), |all, rows| all.joined(rows.spread)).variance(),
            flagged_bins: self.preparation.flagged_bins(),
        }
    }

    /// Number of columns kept of the transform along x: those at q_x >= 0; the others mirror them.
    fn half_columns(&self) -> usize {
        self.map.columns() / 2 + 1
    }

    fn is_its_own_mirror(&self, column: usize) -> bool {
        column == 0 || 2 * column == self.map.columns()
    }

    fn rings(&self) -> Rings {
        let (columns, rows) = (self.map.columns(), self.map.rows());
        let (length_x_m, length_y_m) =
            (self.map.spacing_x_m() * columns as f64, self.map.spacing_y_m() * rows as f64);
        let longest_m = length_x_m.max(length_y_m);
        let steps = [longest_m / length_x_m, longest_m / length_y_m];
        let corner = (steps[0] * (columns / 2) as f64).hypot(steps[1] * (rows / 2) as f64);
        let width = (corner / MAX_RINGS).max(1.0);
        Rings { steps, width, count: nearest(corner / width) + 1 }
    }
}

/// Rounds a radius >= 0 to the nearest ring. A radius halfway between two rings, as maps of 3:2 have it, belongs to the
/// outer one whatever the last bits of the sides are.
fn nearest(radius: f64) -> usize {
    (radius * (1.0 + 1e-12) + 0.5) as usize
}

impl ArealSums {
    /// Adds the transform of a column and its mirror image at -q_x, without q = 0.
    fn add_column(&mut self, geometry: &Rings, column: usize, own_mirror: bool, values: &[Complex<f64>]) {
        let rows = values.len();
        let images = if own_mirror { 1.0 } else { 2.0 };
        for row in usize::from(column == 0)..=rows / 2 {
            let (modes, power_m2) = if row == 0 || 2 * row == rows {
                (images, values[row].norm_sqr())
            } else {
                (2.0 * images, values[row].norm_sqr() + values[rows - row].norm_sqr())
            };
            let (ring, radius) = geometry.place(column, row);
            let (power_m2, square) = (images * power_m2, radius * radius);
            self.rings[ring].add(Ring {
                modes,
                radii: modes * radius,
                power_m2,
                power_of_slope_m2: square * power_m2,
                power_of_curvature_m2: square * square * power_m2,
            });
        }
    }
}

impl Ring {
    fn add(&mut self, other: Self) {
        self.modes += other.modes;
        self.radii += other.radii;
        self.power_m2 += other.power_m2;
        self.power_of_slope_m2 += other.power_of_slope_m2;
        self.power_of_curvature_m2 += other.power_of_curvature_m2;
    }
}

impl Rings {
    /// Returns the ring of a mode and its radius in units of 2 pi/max(Lx, Ly).
    fn place(&self, column: usize, row: usize) -> (usize, f64) {
        let (x, y) = (self.steps[0] * column as f64, self.steps[1] * row as f64);
        let radius = (x * x + y * y).sqrt();
        (nearest(radius / self.width).clamp(1, self.count - 1), radius)
    }
}
