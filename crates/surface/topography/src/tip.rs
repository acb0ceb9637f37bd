//! The wavelength below which the finite radius of a tip affects a scan.

use crate::rows::Lines;
use scans::{NonuniformLineScan, Probe, Scan, ScanFile};

/// Fraction of the curvature 1/R, the sharpest peak that a tip of radius R can trace, at which artefacts set in; found
/// on simulated scans by Sanner et al. (2022).
pub(crate) const CURVATURE_FRACTION: f64 = 0.5;
/// Trial steps per octave in the search from long steps to short ones.
const STEPS_PER_OCTAVE: f64 = 4.0;
/// Relative width at which the search ends.
const TOLERANCE: f64 = 1e-9;

/// Computes the wavelength \[m\] below which a tip of radius `tip_radius_m` > 0 affects a scan; `None` if it does not.
///
/// After Sanner, Noehring, Thimons, Jacobs & Pastewka (2022), Appl. Surf. Sci. Adv. 7:100190: the second difference
/// (h(x+s) - 2 h(x) + h(x-s))/s^2 at the step s, the heights interpolated linearly, must not fall below -1/(2R)
/// anywhere on the scan lines; the cutoff is the length 2s of the longest stencil that does. If even s = L/4 does,
/// nothing is reliable and the cutoff is the length of the scan. The shortest step is the (mean) distance of
/// neighbouring points.
///
/// The search tries four steps per octave from L/4 down and bisects below the first one that fails; it can miss two
/// crossings closer than that.
pub fn tip_cutoff_m(scan: &Scan, tip_radius_m: f64) -> Option<f64> {
    let lines = Lines::from_scan(scan);
    let (spacing_m, length_m) = spacing_and_length_m(&lines);
    let fails = |step_m: f64| sharpest_peak_per_m(&lines, 1, step_m) < -CURVATURE_FRACTION / tip_radius_m;
    let mut passing_m = length_m / 4.0;
    if passing_m <= spacing_m {
        return None; // four points or fewer: no step to try
    }
    if fails(passing_m) {
        return Some(length_m);
    }
    while passing_m > spacing_m {
        let next_m = (passing_m * 2f64.powf(-1.0 / STEPS_PER_OCTAVE)).max(spacing_m);
        if fails(next_m) {
            return Some(2.0 * numerics::bisect(next_m, passing_m, TOLERANCE, |step_m| !fails(step_m)));
        }
        passing_m = next_m;
    }
    None
}

fn spacing_and_length_m(lines: &Lines) -> (f64, f64) {
    match lines {
        Lines::Even(rows) => (rows.spacing_m, rows.length_m()),
        Lines::Uneven(line) => (line.mean_spacing_m(), line.length_m()),
    }
}

/// Largest number of lines of a map used for an indication.
const FEW_LINES: usize = 256;

/// Returns the step between lines such that at most `most` lines, spread over the scan, are used.
fn every_line(lines: &Lines, most: usize) -> usize {
    match lines {
        Lines::Even(rows) => rows.count().div_ceil(most).max(1),
        Lines::Uneven(_) => 1,
    }
}

/// Computes the steps \[m\] of the search in [`tip_cutoff_m`], from long to short, each with the smallest second
/// difference \[1/m\] on a sample of the lines.
pub(crate) fn trial_steps(lines: &Lines) -> Vec<(f64, f64)> {
    let (spacing_m, length_m) = spacing_and_length_m(lines);
    let longest_m = length_m / 4.0;
    let octaves = (longest_m / spacing_m).log2();
    let count = if octaves > 0.0 { (octaves * STEPS_PER_OCTAVE).floor() as usize + 1 } else { 0 };
    let every = every_line(lines, FEW_LINES);
    let step_m = |at: usize| longest_m * 2f64.powf(-(at as f64) / STEPS_PER_OCTAVE);
    (0..count)
        .map(step_m)
        .chain((octaves > 0.0).then_some(spacing_m))
        .map(|step_m| (step_m, sharpest_peak_per_m(lines, every, step_m)))
        .collect()
}

/// Computes the curvatures \[1/m\], positive on peaks, of neighbouring points on a sample of the lines.
pub(crate) fn peak_curvatures_per_m(lines: &Lines) -> Vec<f64> {
    let every = every_line(lines, FEW_LINES);
    match lines {
        Lines::Even(rows) => {
            let square_m2 = rows.spacing_m * rows.spacing_m;
            let curvature_per_m = |near: &[f64]| -((near[2] - near[1]) + (near[0] - near[1])) / square_m2;
            rows.iter().step_by(every).flat_map(|row_m| row_m.windows(3).map(curvature_per_m)).collect()
        }
        Lines::Uneven(line) => {
            let near = line.positions_m().windows(3).zip(line.heights_m().windows(3));
            let curvature_per_m = |(at_m, height_m): (&[f64], &[f64])| {
                let slope =
                    |from: usize| (height_m[from + 1] - height_m[from]) / (at_m[from + 1] - at_m[from]);
                -(slope(1) - slope(0)) / (0.5 * (at_m[2] - at_m[0]))
            };
            near.map(curvature_per_m).collect()
        }
    }
}

/// Computes the smallest second difference \[1/m\] at a step \[m\]; infinite if the step fits nowhere.
fn sharpest_peak_per_m(lines: &Lines, every: usize, step_m: f64) -> f64 {
    let sharpest_m = match lines {
        Lines::Even(rows) => rows
            .iter()
            .step_by(every)
            .map(|row_m| sharpest_even_m(row_m, step_m / rows.spacing_m))
            .fold(f64::INFINITY, f64::min),
        Lines::Uneven(line) => sharpest_uneven_m(line, step_m),
    };
    sharpest_m / (step_m * step_m)
}

/// Computes the smallest h(i+s) - 2 h(i) + h(i-s) of a row, s >= 1 in points.
fn sharpest_even_m(heights_m: &[f64], step: f64) -> f64 {
    let (whole, fraction) = (step.floor() as usize, step.fract());
    let reach = whole + usize::from(fraction > 0.0);
    let Some(centres) = heights_m.len().checked_sub(2 * reach).filter(|&centres| centres > 0) else {
        return f64::INFINITY;
    };
    let from = |offset: usize| &heights_m[offset..offset + centres];
    let (far_left, left) = (from(0), from(reach - whole));
    let (centre, right, far_right) = (from(reach), from(reach + whole), from(2 * reach));
    let difference_m = |[far_left, left, centre, right, far_right]: [f64; 5]| {
        let near_m = (right - centre) + (left - centre);
        let far_m = (far_right - centre) + (far_left - centre);
        near_m + fraction * (far_m - near_m)
    };
    smallest([far_left, left, centre, right, far_right], difference_m)
}

/// Computes the smallest value of a function over slices of equal length, in lanes that the processor compares
/// together.
fn smallest<const K: usize>(inputs: [&[f64]; K], value: impl Fn([f64; K]) -> f64) -> f64 {
    const LANES: usize = 8;
    let inputs = inputs.map(|input| input.as_chunks::<LANES>());
    let mut lanes = [f64::INFINITY; LANES];
    let mut keep = |lane: usize, value: f64| {
        lanes[lane] = if value < lanes[lane] { value } else { lanes[lane] };
    };
    for group in 0..inputs[0].0.len() {
        let inputs = inputs.map(|(groups, _)| &groups[group]);
        for lane in 0..LANES {
            keep(lane, value(inputs.map(|input| input[lane])));
        }
    }
    for lane in 0..inputs[0].1.len() {
        keep(lane, value(inputs.map(|(_, rest)| rest[lane])));
    }
    lanes.into_iter().fold(f64::INFINITY, f64::min)
}

/// Computes the smallest h(x+s) - 2 h(x) + h(x-s) over the points x of an unevenly spaced scan, s in m.
fn sharpest_uneven_m(line: &NonuniformLineScan, step_m: f64) -> f64 {
    let (positions_m, heights_m) = (line.positions_m(), line.heights_m());
    let height_at = |position_m: f64| {
        let end = positions_m.partition_point(|&known_m| known_m < position_m);
        if end == 0 || end == positions_m.len() {
            return (end == 0 && position_m == positions_m[0]).then(|| heights_m[0]);
        }
        let fraction = (position_m - positions_m[end - 1]) / (positions_m[end] - positions_m[end - 1]);
        Some(heights_m[end - 1] + fraction * (heights_m[end] - heights_m[end - 1]))
    };
    let second_difference_m = |(&position_m, height_m): (&f64, &f64)| {
        let (left_m, right_m) = (height_at(position_m - step_m)?, height_at(position_m + step_m)?);
        Some((right_m - height_m) + (left_m - height_m))
    };
    positions_m.iter().zip(heights_m).filter_map(second_difference_m).fold(f64::INFINITY, f64::min)
}

/// Returns true if a tip may have touched the surface: false for a microscope, and for periodic heights, which were
/// computed.
pub(crate) fn may_have_a_tip<S>(file: &ScanFile<S>) -> bool {
    file.probe != Some(Probe::Microscope) && !file.is_periodic
}
