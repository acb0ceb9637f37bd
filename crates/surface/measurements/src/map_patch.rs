//! The middle of a measured map, for boundary elements.

use scans::{HeightMap, MissingPoints, Scan, ScanFile};
use topography::{Detrend, Direction, Recipe, detrended_m};
use units::{Remark, RemarkCode};

use crate::facing::PartialMap;

/// The mean square of the steps across opposite edges over that of the steps between neighbours up to which a map repeats itself.
/// A map of rough skin that does not has tens or hundreds.
const STEPS_OF_REPEATING: f64 = 3.0;

/// Rms slope of the sum of two faces over that of two faces that do not know each other, below which they fit.
const FITTING: f64 = 0.8;

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
    /// The rms gradient over that of isotropic surfaces with its spectrum, which runs along its lines: not 1 where slopes differ by
    /// direction.
    pub gradient_over_spectrum: f64,
    /// Axis along which its lines run.
    direction: Direction,
}

impl MapPatch {
    /// Takes the map of a file, at most so many points along each side. A map whose opposite edges fit as neighbours do repeats
    /// itself, whatever its file says, and keeps its tilt.
    pub(crate) fn from_file(file: &ScanFile<Scan>, recipe: &Recipe, most_points: usize) -> Option<Self> {
        let Scan::Map(map) = &file.scan else { return None };
        let [along_x, along_y] = [steps(map), steps(&map.turned())];
        let is_periodic = file.is_periodic || (along_x.repeat() && along_y.repeat());
        let direction = recipe.direction;
        Some(MapPatch {
            name: file.name.clone(),
            map: map.middle(most_points),
            is_periodic: is_periodic && map.columns().max(map.rows()) <= most_points,
            points_of_whole: [map.columns(), map.rows()],
            detrend: recipe.preparation(is_periodic).detrend,
            gradient_over_spectrum: gradient_over_spectrum([&along_x, &along_y], direction),
            direction,
        })
    }

    /// Adds the heights of a map that [faces](PartialMap::facing) this one; notes what was done. `None` if the sums are no heights.
    #[must_use]
    pub fn facing(&self, other: &Self) -> Option<(Self, Vec<Remark>)> {
        let [own, faced] = [self, other]
            .map(|patch| PartialMap { map: patch.map.clone(), missing: MissingPoints::default() });
        let sum = own.facing(&faced).ok()?;
        let mut remarks = sum.remarks_on_sum((&self.name, &own), (&other.name, &faced));
        let both = [steps(&sum.map), steps(&sum.map.turned())];
        let [of_sum, of_own, of_faced] =
            [&sum, &own, &faced].map(|map| mean_slope_squared(&steps(&map.map), &steps(&map.map.turned())));
        let share = (of_sum / (of_own + of_faced)).sqrt();
        if share < FITTING {
            remarks.push(Remark::new(RemarkCode::FacesFit).with("share", share));
        }
        let is_periodic = self.is_periodic && other.is_periodic && own.has_grid_of(&faced);
        let is_cropped = |patch: &Self| patch.points_of_whole != [patch.map.columns(), patch.map.rows()];
        let is_part = is_cropped(self) || is_cropped(other);
        let patch = MapPatch {
            name: format!("{} against {}", self.name, other.name),
            is_periodic,
            points_of_whole: if is_part { self.points_of_whole } else { [sum.map.columns(), sum.map.rows()] },
            detrend: if self.is_periodic && !is_periodic { other.detrend } else { self.detrend },
            gradient_over_spectrum: gradient_over_spectrum([&both[0], &both[1]], self.direction),
            direction: self.direction,
            map: sum.map,
        };
        Some((patch, remarks))
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

/// Mean square of the slopes along x and along y.
fn mean_slope_squared(along_x: &Steps, along_y: &Steps) -> f64 {
    0.5 * (along_x.slope_squared + along_y.slope_squared)
}

/// Rms gradient of a map over that of isotropic surfaces with its spectrum along lines of a direction.
fn gradient_over_spectrum([along_x, along_y]: [&Steps; 2], direction: Direction) -> f64 {
    let both = mean_slope_squared(along_x, along_y);
    let of_spectrum = match direction {
        Direction::X => along_x.slope_squared,
        Direction::Y => along_y.slope_squared,
        Direction::Both => both,
    };
    if of_spectrum > 0.0 { (both / of_spectrum).sqrt() } else { 1.0 }
}

/// Mean squares of the steps along the rows of a map.
struct Steps {
    /// Those between neighbours \[m^2\].
    inside_m2: f64,
    /// Those across opposite edges \[m^2\].
    edges_m2: f64,
    /// The mean square of the slope between neighbours.
    slope_squared: f64,
}

impl Steps {
    fn repeat(&self) -> bool {
        self.edges_m2 <= STEPS_OF_REPEATING * self.inside_m2
    }
}

fn steps(map: &HeightMap) -> Steps {
    let rows = || map.heights_m().chunks_exact(map.columns());
    let inside: f64 = rows().flat_map(|row| row.windows(2)).map(|pair| (pair[1] - pair[0]).powi(2)).sum();
    let edges: f64 = rows().map(|row| (row[0] - row[row.len() - 1]).powi(2)).sum();
    let inside_m2 = inside / (map.rows() * (map.columns() - 1)) as f64;
    Steps {
        inside_m2,
        edges_m2: edges / map.rows() as f64,
        slope_squared: inside_m2 / map.spacing_x_m().powi(2),
    }
}
