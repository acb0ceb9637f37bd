//! Operators of periodic and free surfaces, in units of the grid's longest wave.

use std::f64::consts::{PI, TAU};

use crate::half_space::Grid;
use crate::half_space::love::LoveFactors;
use crate::half_space::problem::Operators;
use crate::half_space::transform::Convolution;

/// Operators of a periodic surface: displacements of pressures and pressures of displacements.
pub(crate) fn periodic(grid: &Grid) -> Operators {
    periodic_on(grid, |_| 1.0)
}

/// Operators of a periodic surface on a body that a wave of a wave number, in units of the longest wave, displaces by
/// `relative_displacement` times as much as the half-space.
pub(crate) fn periodic_on(grid: &Grid, relative_displacement: impl Fn(f64) -> f64) -> Operators {
    let map = [grid.rows(), grid.columns()];
    let wave_number = wave_number(*grid);
    let displacement = |row, column| {
        let wave_number = wave_number(row, column);
        if wave_number > 0.0 { relative_displacement(wave_number) / wave_number } else { 0.0 }
    };
    let pressure = |row, column| match displacement(row, column) {
        displacement if displacement > 0.0 => 1.0 / displacement,
        _ => 0.0,
    };
    Operators {
        compliance: Convolution::new(map, map, displacement),
        rough_compliance: Convolution::new(map, map, displacement),
        preconditioner: Convolution::new(map, map, pressure),
        uniform_displaces: false,
    }
}

/// Operators of a surface alone on the half-space: displacements by Love's coefficients; directions are preconditioned
/// by the waves of the grid, without padding.
pub(crate) fn free(grid: &Grid) -> Operators {
    let map = [grid.rows(), grid.columns()];
    let period = LoveFactors::period(grid);
    // The unit of pressure makes one wave of the unit's height along the longer side: E* q/2, in which E* cancels.
    let love = LoveFactors::new(grid, 2.0 * PI / grid.unit_wave_number_per_m());
    Operators {
        compliance: Convolution::new(map, period, |row, column| love.factor(row, column)),
        rough_compliance: Convolution::new(map, period, |row, column| love.factor(row, column)),
        preconditioner: Convolution::new(map, map, wave_number(*grid)),
        uniform_displaces: true,
    }
}

/// Wave number |q| of a wave with given periods along y and x, in units of the longest wave.
pub(crate) fn wave_number(grid: Grid) -> impl Fn(usize, usize) -> f64 + Copy {
    let unit_per_m = grid.unit_wave_number_per_m();
    let along_y = TAU / grid.length_y_m() / unit_per_m;
    let along_x = TAU / grid.length_x_m() / unit_per_m;
    move |row, column| (row as f64 * along_y).hypot(column as f64 * along_x)
}
