//! Rms gradient and curvature of all roughness down to each wavelength, from the spectrum and from heights.
//!
//! From the spectrum: the sum of the squares over all waves that are not shorter than the wavelength. From heights: differences at
//! half the wavelength, the least distance at which two points show a wave. Such differences weigh a wave of the wavenumber q with
//! \[sin(q d/2)/(q d/2)\]^2 and see shorter waves too, so that both columns agree on rough surfaces but not to all digits.

use std::f64::consts::TAU;

use scans::{HeightMap, NonuniformLineScan, Scan, UniformLineScan};
use topography::{Detrend, Preparation, Window, areal_spectrum, line_spectrum};

use crate::relief::ScaleLimitedSurface;
use crate::slopes::{rms_curvature_at, rms_gradient_at};

/// Growth of the distance from one row to the next, at least.
const GROWTH: f64 = 1.18;
/// Share of the shorter side that the longest distance takes at most.
const LONGEST_DISTANCE: f64 = 0.25;
/// Relative rounding of a wavelength.
const ROUNDING: f64 = 1e-9;

/// Gradient and curvature of all roughness down to a wavelength.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ScaleParameters {
    /// The wavelength \[m\].
    pub wavelength_m: f64,
    /// From the waves of the spectrum that are not shorter; absent if points lack heights.
    pub from_spectrum: Option<GradientAndCurvature>,
    /// From heights half the wavelength apart; absent for unevenly spaced points.
    pub from_heights: Option<GradientAndCurvature>,
}

/// Rms gradient and curvature of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GradientAndCurvature {
    /// Rms gradient of a map, h'^2 = <h_x^2 + h_y^2>, or slope of a profile; 1.
    pub rms_gradient: f64,
    /// Rms curvature \[1/m\] of a profile, or of the profiles of a map averaged over directions.
    pub rms_curvature_per_m: f64,
}

/// Computes the parameters down to each of some wavelengths, from long to short: from half of the shorter side to the distance of
/// two points, at most 14 per decade.
///
/// `is_periodic` says that the heights repeat themselves. Others are windowed (Hann) for the spectrum, after a plane or a straight
/// line has been subtracted.
#[must_use]
pub fn scale_parameters(relief: &ScaleLimitedSurface, is_periodic: bool) -> Vec<ScaleParameters> {
    let spectrum = Waves::new(relief, is_periodic);
    let (spacing_x_m, spacing_y_m) = relief.spacing_m();
    let spacing_m = spacing_y_m.map_or(spacing_x_m, |spacing_y_m| spacing_y_m.max(spacing_x_m));
    let row = |points: usize| {
        let distance_m = points as f64 * spacing_m;
        let along = |spacing_m: f64| ((distance_m / spacing_m).round() as usize).max(1);
        let steps = [along(spacing_x_m), along(spacing_y_m.unwrap_or(spacing_x_m))];
        let from_heights = rms_gradient_at(relief, steps).zip(rms_curvature_at(relief, steps));
        ScaleParameters {
            wavelength_m: 2.0 * distance_m,
            from_spectrum: spectrum.as_ref().map(|waves| waves.down_to(2.0 * distance_m)),
            from_heights: from_heights.map(|(rms_gradient, rms_curvature_per_m)| GradientAndCurvature {
                rms_gradient,
                rms_curvature_per_m,
            }),
        }
    };
    distances(relief, spacing_m).into_iter().rev().map(row).collect()
}

/// Distances in points, from short to long.
fn distances(relief: &ScaleLimitedSurface, spacing_m: f64) -> Vec<usize> {
    let (columns, rows) = relief.points();
    let (spacing_x_m, spacing_y_m) = relief.spacing_m();
    let along_x_m = columns as f64 * spacing_x_m;
    let along_y_m = rows.zip(spacing_y_m).map(|(rows, spacing_m)| rows as f64 * spacing_m);
    let longest =
        LONGEST_DISTANCE * along_y_m.map_or(along_x_m, |along_y_m| along_y_m.min(along_x_m)) / spacing_m;
    let next = |points: &usize| Some(((*points as f64 * GROWTH).round() as usize).max(points + 1));
    std::iter::successors(Some(1), next).take_while(|points| *points as f64 <= longest.max(1.0)).collect()
}

/// Waves of a relief from long to short.
struct Waves {
    waves: Vec<Wave>,
    /// Mean square curvature of profiles over <q^4 h^2>: 1 of a profile, 3/8 averaged over the directions of a map.
    of_curvature: f64,
    /// Half the width \[rad/m\] of the rings of a map, whose modes lie on both sides of their wavenumber; 0 of a profile.
    half_width_rad_per_m: f64,
}

/// Waves of about one wavenumber.
struct Wave {
    wavenumber_rad_per_m: f64,
    /// Mean square <q^2 h^2>, mode by mode.
    slope: f64,
    /// Mean square <q^4 h^2> \[1/m^2\], mode by mode.
    curvature_per_m2: f64,
}

impl Waves {
    /// Transforms a relief; `None` if points lack heights.
    fn new(relief: &ScaleLimitedSurface, is_periodic: bool) -> Option<Self> {
        let preparation = match is_periodic {
            true => Preparation::PERIODIC,
            false => Preparation { detrend: Detrend::Plane, window: Window::Hann },
        };
        let scan = scan(relief)?;
        if let Scan::Map(map) = &scan {
            let found = areal_spectrum(map, preparation);
            let [length_x_m, length_y_m] = found.sizes_m;
            let area_m2 = length_x_m * length_y_m;
            let waves = found.bins.iter().skip(found.flagged_bins).map(|bin| Wave {
                wavenumber_rad_per_m: bin.wavevector_rad_per_m,
                slope: bin.slope_sum_m2 / area_m2,
                curvature_per_m2: bin.curvature_sum / area_m2,
            });
            return Some(Waves {
                waves: waves.collect(),
                of_curvature: 0.375,
                half_width_rad_per_m: 0.5 * TAU / length_x_m.max(length_y_m),
            });
        }
        let found = line_spectrum(&scan, preparation);
        let bins = found.wavevectors_rad_per_m().zip(found.mean_squares_m2());
        let waves = bins.skip(found.flagged_bins).map(|(wavenumber_rad_per_m, square_m2)| {
            let slope = wavenumber_rad_per_m.powi(2) * square_m2;
            Wave { wavenumber_rad_per_m, slope, curvature_per_m2: wavenumber_rad_per_m.powi(2) * slope }
        });
        Some(Waves { waves: waves.collect(), of_curvature: 1.0, half_width_rad_per_m: 0.0 })
    }

    fn down_to(&self, wavelength_m: f64) -> GradientAndCurvature {
        let last_rad_per_m =
            TAU / wavelength_m * (1.0 + ROUNDING) + (1.0 - ROUNDING) * self.half_width_rad_per_m;
        let longer = self.waves.iter().take_while(|wave| wave.wavenumber_rad_per_m <= last_rad_per_m);
        let (slope, curvature_per_m2) = longer.fold((0.0, 0.0), |(slope, curvature_per_m2), wave| {
            (slope + wave.slope, curvature_per_m2 + wave.curvature_per_m2)
        });
        GradientAndCurvature {
            rms_gradient: slope.sqrt(),
            rms_curvature_per_m: (self.of_curvature * curvature_per_m2).sqrt(),
        }
    }
}

/// The relief as a scan; `None` if points lack heights.
fn scan(relief: &ScaleLimitedSurface) -> Option<Scan> {
    let (heights_m, measured) = relief.parts();
    if measured.is_some() {
        return None;
    }
    let heights_m = heights_m.to_vec();
    let (spacing_x_m, spacing_y_m) = relief.spacing_m();
    match (&relief.positions_m, spacing_y_m) {
        (Some(positions_m), _) => {
            NonuniformLineScan::new(positions_m.clone(), heights_m).ok().map(Scan::NonuniformLine)
        }
        (None, None) => UniformLineScan::new(spacing_x_m, heights_m).ok().map(Scan::UniformLine),
        (None, Some(spacing_y_m)) => {
            let columns = relief.points().0;
            HeightMap::new(columns, spacing_x_m, spacing_y_m, heights_m).ok().map(Scan::Map)
        }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;
    use scans::MeasuredScan;

    use crate::relief::{Evaluation, FormRemoval};
    use crate::slopes::{Differences, rms_gradient};

    use super::*;

    fn relief(scan: Scan) -> ScaleLimitedSurface {
        let evaluation = Evaluation { form: FormRemoval::None, ..Evaluation::default() };
        ScaleLimitedSurface::new(&MeasuredScan::from(scan), &evaluation).unwrap()
    }

    /// Waves of 16 and 4 points along x, and of 8 points along y, on a periodic map.
    fn map() -> ScaleLimitedSurface {
        let height_m = |at: usize| {
            let (x, y) = ((at % 64) as f64, (at / 64) as f64);
            1e-9 * (TAU * x / 16.0).sin()
                + 3e-10 * (TAU * x / 4.0 + 0.3).sin()
                + 4e-10 * (TAU * y / 8.0).cos()
        };
        let heights_m = (0..64 * 64).map(height_m).collect();
        relief(Scan::Map(HeightMap::new(64, 1e-8, 1e-8, heights_m).unwrap()))
    }

    #[test]
    fn the_spectrum_counts_each_wave_down_to_the_wavelength() {
        let waves = [(16.0, 1e-9), (8.0, 4e-10), (4.0, 3e-10)];
        for row in scale_parameters(&map(), true) {
            let points = row.wavelength_m / 1e-8;
            let squares =
                waves.iter().filter(|(length, _)| *length >= points - 1e-6).map(|(length, height_m)| {
                    let wavenumber = TAU / (length * 1e-8);
                    (0.5 * (wavenumber * height_m).powi(2), wavenumber * wavenumber)
                });
            let (gradient, curvature) =
                squares.fold((0.0, 0.0), |sums, (square, q2)| (sums.0 + square, sums.1 + q2 * square));
            let found = row.from_spectrum.unwrap();
            let expected_per_m = (0.375 * curvature).sqrt();
            let [gradient_unit, curvature_unit] = [1e-9, 1e-3];
            assert_relative_eq!(
                found.rms_gradient,
                gradient.sqrt(),
                max_relative = 1e-9,
                epsilon = gradient_unit
            );
            assert_relative_eq!(
                found.rms_curvature_per_m,
                expected_per_m,
                max_relative = 1e-9,
                epsilon = curvature_unit
            );
        }
    }

    #[test]
    fn heights_of_a_wave_give_its_slope_times_the_sine_over_its_argument() {
        let heights_m = (0..640).map(|x| 1e-9 * (TAU * f64::from(x) / 64.0).sin()).collect();
        let line = relief(Scan::UniformLine(UniformLineScan::new(1e-8, heights_m).unwrap()));
        for row in scale_parameters(&line, true) {
            let (argument, wavenumber) = (0.25 * row.wavelength_m * TAU / 64e-8, TAU / 64e-8);
            let share = (argument.sin() / argument).abs();
            let found = row.from_heights.unwrap();
            let slope = wavenumber * 1e-9 / 2f64.sqrt();
            assert_relative_eq!(found.rms_gradient, slope * share, max_relative = 0.06, epsilon = 1e-6);
            assert_relative_eq!(
                found.rms_curvature_per_m,
                wavenumber * slope * share * share,
                max_relative = 0.1,
                epsilon = 1e-6 * wavenumber
            );
        }
    }

    #[test]
    fn neighbours_give_the_gradient_of_the_standards_and_rows_run_from_long_to_short() {
        let map = map();
        let rows = scale_parameters(&map, true);
        assert!(rows.windows(2).all(|pair| pair[1].wavelength_m < pair[0].wavelength_m));
        assert_relative_eq!(rows[0].wavelength_m, 32e-8, max_relative = 0.2);
        let last = rows.last().unwrap();
        assert_relative_eq!(last.wavelength_m, 2e-8, max_relative = 1e-12);
        let sdq = rms_gradient(&map, Differences::Neighbours).unwrap();
        assert_relative_eq!(last.from_heights.unwrap().rms_gradient, sdq, max_relative = 1e-12);
    }

    #[test]
    fn uneven_profiles_have_a_spectrum_and_missing_points_differences() {
        let positions_m: Vec<f64> =
            (0..200).map(|x| 1e-8 * (f64::from(x) + 0.2 * f64::from(x % 3))).collect();
        let heights_m = positions_m.iter().map(|x_m| 1e-9 * (x_m * TAU / 2e-7).sin()).collect();
        let uneven = relief(Scan::NonuniformLine(NonuniformLineScan::new(positions_m, heights_m).unwrap()));
        let rows = scale_parameters(&uneven, false);
        assert!(rows.iter().all(|row| row.from_heights.is_none() && row.from_spectrum.is_some()));
        let heights_m = (0..200).map(|x| 1e-9 * f64::from(x % 7)).collect();
        let line = Scan::UniformLine(UniformLineScan::new(1e-8, heights_m).unwrap());
        let holed = MeasuredScan::with_missing_points(line, [3, 77].into_iter().collect());
        let rows =
            scale_parameters(&ScaleLimitedSurface::new(&holed, &Evaluation::default()).unwrap(), false);
        assert!(rows.iter().all(|row| row.from_heights.is_some() && row.from_spectrum.is_none()));
    }
}
