//! The transform of unevenly spaced heights joined by straight lines, without resampling.

use std::f64::consts::{PI, TAU};

use numerics::transforms::Complex;

use crate::detrend::Detrend;
use crate::line::LineSpectrum;
use crate::preparation::Preparation;
use crate::preparation::Window;
use crate::scattered_sums::ScatteredSums;
use crate::segment::{mean_over_unit, sinc_and_derivative};
use crate::sums::sum_of;
use numerics::GaussLegendre;
use scans::NonuniformLineScan;

/// Number of wavevectors for which a phase is multiplied on before it is recomputed; its error stays below 2e-15.
const PHASE_STEPS: usize = 16;
/// Segments times wavevectors up to which each pair is computed; some 30 ms of work.
const DIRECT_PAIRS: usize = 1 << 22;
/// Nodes of the rule that integrates a piece of a segment, over which q x changes by half pi at most; to rounding.
const PIECE_NODES: usize = 7;

/// Computes the spectrum C1D of heights at uneven positions, at q = 2 pi n/L up to pi over the mean spacing.
///
/// The profile joins the heights by straight lines. Its transform is exact, also with the Hann window: the window has
/// three harmonics, so the transform of the product at n combines those of the profile at n - 1, n and n + 1. L is the
/// distance from the first to the last point. On evenly spaced data C1D is sinc^4(q dx/2) times that of
/// [`uniform_line_spectrum`](crate::uniform_line_spectrum), an effect of the straight lines, plus a small difference in
/// the window.
///
/// Detrending minimises the integral of the square along the profile, not the sum over its points. Up to some 2,900
/// points the work grows as points times wavevectors, and each bin has its own fourteen digits. A longer scan takes a fast
/// transform, good to 1e-14 of the mean height in each amplitude: a bin that lies eight decades below the largest in C1D
/// keeps nine digits.
pub fn nonuniform_line_spectrum(scan: &NonuniformLineScan, preparation: Preparation) -> LineSpectrum {
    nonuniform_line_spectrum_to(scan, preparation, (scan.heights_m().len() - 1) / 2)
}

/// Computes the spectrum C1D of heights at uneven positions in a given number of bins, at least 1.
///
/// Bins beyond pi over the mean spacing show the corners of the straight lines, q^-4, rather than the surface; with
/// more bins [`LineSpectrum::parseval_share`] tends to 1.
pub fn nonuniform_line_spectrum_to(
    scan: &NonuniformLineScan,
    preparation: Preparation,
    bins: usize,
) -> LineSpectrum {
    let bins = bins.max(1);
    let profile = Profile::new(scan, preparation.detrend);
    let plain = profile.transforms(bins + 2);
    let transform = |n: usize| match preparation.window {
        Window::None => plain[n],
        Window::Hann => hann_amplitude() * (plain[n] - 0.5 * (plain[n + 1] + before(&plain, n))),
    };
    LineSpectrum {
        length_m: profile.length_m,
        spacing_m: None,
        c1d_m3: (1..=bins).map(|n| transform(n).norm_sqr() / profile.length_m).collect(),
        ends_at_nyquist: false,
        variance_m2: profile.variance_m2(preparation.window, transform(0).re / profile.length_m),
        lines: 1,
        flagged_bins: preparation.flagged_bins(),
        parts_m3: Vec::new(),
        independent: Vec::new(),
    }
}

/// Computes the slope of the trend of a scan.
pub(crate) fn fitted_slope(scan: &NonuniformLineScan) -> f64 {
    Profile::new(scan, Detrend::Mean).slope()
}

/// Returns the transform at n - 1; at -1 the conjugate of that at 1.
fn before(transforms: &[Complex<f64>], n: usize) -> Complex<f64> {
    if n == 0 { transforms[1].conj() } else { transforms[n - 1] }
}

/// Factor of 1 - cos(2 pi x/L) for a window with mean square 1.
fn hann_amplitude() -> f64 {
    (2.0 / 3.0f64).sqrt()
}

/// A detrended profile with positions from its first point.
struct Profile {
    positions_m: Vec<f64>,
    heights_m: Vec<f64>,
    length_m: f64,
}

/// A straight piece of a profile.
struct Segment {
    start_m: f64,
    length_m: f64,
    heights_m: [f64; 2],
}

impl Profile {
    fn new(scan: &NonuniformLineScan, detrend: Detrend) -> Self {
        let (origin_m, pivot_m) = (scan.positions_m()[0], scan.heights_m()[0]);
        let mut profile = Self {
            positions_m: scan.positions_m().iter().map(|position_m| position_m - origin_m).collect(),
            heights_m: scan.heights_m().iter().map(|height_m| height_m - pivot_m).collect(),
            length_m: scan.length_m(),
        };
        // In the second pass the trend, and with it its rounding, is as small as the roughness.
        profile.subtract_trend(detrend);
        profile.subtract_trend(detrend);
        profile
    }

    fn subtract_trend(&mut self, detrend: Detrend) {
        let level_m = self.integral(|segment| segment.length_m * segment.mean_m()) / self.length_m;
        let middle_m = 0.5 * self.length_m;
        let slope = if detrend == Detrend::Mean { 0.0 } else { self.slope() };
        for (height_m, position_m) in self.heights_m.iter_mut().zip(&self.positions_m) {
            *height_m = (-slope).mul_add(position_m - middle_m, *height_m - level_m);
        }
    }

    /// Computes the slope of the least-squares line through the profile.
    fn slope(&self) -> f64 {
        let first_moment_m3 = self.integral(|segment| {
            let lever_m = segment.start_m + 0.5 * (segment.length_m - self.length_m);
            segment.length_m * (lever_m * segment.mean_m() + segment.length_m * segment.rise_m() / 12.0)
        });
        12.0 * first_moment_m3 / self.length_m.powi(3)
    }

    fn segments(&self) -> impl Iterator<Item = Segment> {
        self.positions_m.windows(2).zip(self.heights_m.windows(2)).map(|(positions_m, heights_m)| Segment {
            start_m: positions_m[0],
            length_m: positions_m[1] - positions_m[0],
            heights_m: [heights_m[0], heights_m[1]],
        })
    }

    fn integral(&self, of_segment: impl Fn(&Segment) -> f64) -> f64 {
        let parts: Vec<f64> = self.segments().map(|segment| of_segment(&segment)).collect();
        sum_of(&parts, |part| part)
    }

    /// Computes Int h e^(-iqx) dx at q = 2 pi n/L for n from 0 to `count` - 1.
    fn transforms(&self, count: usize) -> Vec<Complex<f64>> {
        if self.positions_m.len().saturating_mul(count) <= DIRECT_PAIRS {
            self.transforms_of_pairs(count)
        } else {
            self.fast_transforms(count)
        }
    }

    /// Integrates by a rule of points, and sums over these points by a fast transform.
    fn fast_transforms(&self, count: usize) -> Vec<Complex<f64>> {
        let rule = GaussLegendre::new(PIECE_NODES);
        let mut sums = ScatteredSums::new(count);
        for segment in self.segments() {
            let pieces = (4.0 * count as f64 * (segment.length_m / self.length_m)).ceil().max(1.0);
            for piece in 0..pieces as usize {
                let (from, to) = (piece as f64 / pieces, (piece + 1) as f64 / pieces);
                for (fraction, weight) in rule.over(from, to) {
                    let turns = (segment.start_m + fraction * segment.length_m) / self.length_m;
                    sums.add(turns, weight * segment.length_m * segment.height_m(fraction));
                }
            }
        }
        sums.finish()
    }

    /// Sums the exact transforms of all segments.
    fn transforms_of_pairs(&self, count: usize) -> Vec<Complex<f64>> {
        let mut sums = vec![Complex::default(); count];
        for segment in self.segments() {
            let turns = (segment.start_m + 0.5 * segment.length_m) / self.length_m;
            let step = phase(1.0, turns);
            let half_angle = PI * (segment.length_m / self.length_m);
            let (mean, half_rise) =
                (segment.length_m * segment.mean_m(), 0.5 * segment.length_m * segment.rise_m());
            for (chunk, sums) in sums.chunks_mut(PHASE_STEPS).enumerate() {
                let first = chunk * PHASE_STEPS;
                let mut carried = phase(first as f64, turns);
                for (n, sum) in (first..).zip(sums) {
                    let (sinc, derivative) = sinc_and_derivative(n as f64 * half_angle);
                    *sum += carried * Complex::new(mean * sinc, half_rise * derivative);
                    carried *= step;
                }
            }
        }
        sums
    }

    /// Computes the variance of the windowed profile about its mean, integrated exactly.
    fn variance_m2(&self, window: Window, mean_m: f64) -> f64 {
        let squares = self.integral(|segment| {
            let mean_square_m2 = match window {
                Window::None => mean_over_unit(1, |fraction| (segment.height_m(fraction) - mean_m).powi(2)),
                Window::Hann => {
                    let angle = TAU * (segment.length_m / self.length_m);
                    mean_over_unit((2.0 * angle).ceil().max(1.0) as usize, |fraction| {
                        let x_m = segment.start_m + fraction * segment.length_m;
                        // 1 - cos(2 pi x/L) without cancellation at the ends
                        let factor = hann_amplitude() * 2.0 * (PI * (x_m / self.length_m)).sin().powi(2);
                        (factor * segment.height_m(fraction) - mean_m).powi(2)
                    })
                }
            };
            segment.length_m * mean_square_m2
        });
        squares / self.length_m
    }
}

impl Segment {
    fn mean_m(&self) -> f64 {
        0.5 * (self.heights_m[0] + self.heights_m[1])
    }

    fn rise_m(&self) -> f64 {
        self.heights_m[1] - self.heights_m[0]
    }

    /// Returns the height at a fraction of the length.
    fn height_m(&self, fraction: f64) -> f64 {
        self.heights_m[0] + fraction * self.rise_m()
    }
}

/// Computes e^(-2 pi i n t); whole turns are removed from the exact product, so that a large n costs no digits.
fn phase(n: f64, turns: f64) -> Complex<f64> {
    let product = n * turns;
    let part = (product - product.round()) + n.mul_add(turns, -product);
    let (sin, cos) = (TAU * part).sin_cos();
    Complex::new(cos, -sin)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fast_transform_is_that_of_the_pairs() {
        for (points, gap_m) in [(2, 0.0), (40, 0.0), (40, 1e3), (900, 0.0), (900, 50.0)] {
            let (mut position_m, mut height_m) = (0.0, 0.0);
            let (positions_m, heights_m) = (0..points)
                .map(|i| {
                    let angle = f64::from(i * i);
                    position_m += 1.01 + angle.sin() + if i == points / 2 { gap_m } else { 0.0 };
                    height_m += (1.3 * angle).cos();
                    (position_m, height_m)
                })
                .unzip();
            let profile =
                Profile::new(&NonuniformLineScan::new(positions_m, heights_m).unwrap(), Detrend::Line);
            let larger_m = |segment: &Segment| segment.heights_m[0].abs().max(segment.heights_m[1].abs());
            let size = profile.integral(|segment| segment.length_m * larger_m(segment));
            for count in [3, 20, 450] {
                let pairs = profile.transforms_of_pairs(count);
                for (found, expected) in profile.fast_transforms(count).into_iter().zip(pairs) {
                    let error = (found - expected).norm();
                    assert!(
                        error <= 3e-14 * size.max(1e-3 * profile.length_m),
                        "{points}, {count}: {error} {size}"
                    );
                }
            }
        }
    }
}
