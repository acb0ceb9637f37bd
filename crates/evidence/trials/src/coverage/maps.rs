//! Maps of a Gaussian surface that are not periodic.

use std::f64::consts::TAU;

use numerics::transforms::Complex64;
use spectrum::random_surfaces::{AreaSpectrum, Phases, Synthesis};

use super::instrument::Instrument;
use super::random::Normals;
use super::surface::KnownSurface;
use crate::TrialError;

/// Length of a side of the periodic map, in sides of a map cut from its corner.
const PERIODS: usize = 2;

/// Ratio of the sides of successive boxes, whose waves make up all waves longer than the periodic map.
const BOX_RATIO: f64 = 5.0;

/// Generator of maps.
#[derive(Debug, Clone)]
pub(crate) struct MapMaker {
    points: usize,
    spacing_m: f64,
    fine: AreaSpectrum,
    long: Vec<Wave>,
}

/// Wave longer than the periodic map.
#[derive(Debug, Clone, Copy)]
struct Wave {
    x_rad_per_m: f64,
    y_rad_per_m: f64,
    /// Root mean square modulus of its complex amplitude \[m\].
    modulus_m: f64,
}

impl MapMaker {
    pub(crate) fn new(surface: &KnownSurface, instrument: &Instrument) -> Result<Self, TrialError> {
        let period_m = PERIODS as f64 * instrument.length_m;
        let fine = surface.area.cut(period_m, surface.area.shortest_m())?;
        let mut long = Vec::new();
        let mut shortest_m = period_m;
        while shortest_m < surface.longest_m {
            let longest_m = (BOX_RATIO * shortest_m).min(surface.longest_m);
            long.extend(waves_of_box(&surface.area, longest_m, shortest_m));
            shortest_m = longest_m;
        }
        Ok(MapMaker { points: instrument.points, spacing_m: instrument.spacing_m(), fine, long })
    }

    /// Heights \[m\], row by row: the short waves depend on a seed, the long ones on the numbers drawn.
    pub(crate) fn map(&self, seed: u64, number: u64, normals: &mut Normals) -> Result<Vec<f64>, TrialError> {
        let side = PERIODS * self.points;
        let synthesis = Synthesis::square(side, side as f64 * self.spacing_m, seed, Phases::Gaussian);
        let periodic = self.fine.surface(&synthesis, number)?;
        let rows = periodic.heights_m.chunks_exact(side).take(self.points);
        let mut heights_m: Vec<f64> = rows.flat_map(|row| row[..self.points].iter().copied()).collect();
        for wave in &self.long {
            let amplitude_m =
                Complex64::new(normals.next(), normals.next()) * (wave.modulus_m * 0.5f64.sqrt());
            let along = |rad_per_m: f64| -> Vec<Complex64> {
                (0..self.points)
                    .map(|point| Complex64::cis(rad_per_m * point as f64 * self.spacing_m))
                    .collect()
            };
            let along_x = along(wave.x_rad_per_m);
            let rows = heights_m.chunks_exact_mut(self.points).zip(along(wave.y_rad_per_m));
            for (row, of_row) in rows {
                let of_row = 2.0 * amplitude_m * of_row;
                row.iter_mut().zip(&along_x).for_each(|(height_m, of_column)| {
                    *height_m += of_row.re * of_column.re - of_row.im * of_column.im;
                });
            }
        }
        Ok(heights_m)
    }
}

/// Waves of a square box, one half of the plane, from its own length down to, but excluding, a shortest one \[m\].
fn waves_of_box(area: &AreaSpectrum, box_m: f64, shortest_m: f64) -> Vec<Wave> {
    let most = (box_m / shortest_m).ceil() as i64;
    let step = TAU / box_m;
    let half_plane =
        (0..=most).flat_map(|m| (-most..=most).map(move |n| (m, n))).filter(|&(m, n)| m > 0 || n > 0);
    let wave = |(m, n): (i64, i64)| {
        let (x_rad_per_m, y_rad_per_m) = (m as f64 * step, n as f64 * step);
        let q_rad_per_m = x_rad_per_m.hypot(y_rad_per_m);
        let is_long = q_rad_per_m * shortest_m < TAU * (1.0 - 1e-9);
        let modulus_m = area.ciso_m4(q_rad_per_m.max(TAU / area.longest_m())).sqrt() / box_m;
        is_long.then_some(Wave { x_rad_per_m, y_rad_per_m, modulus_m })
    };
    half_plane.filter_map(wave).collect()
}
