//! Conversion of the spectrum of profiles to that of their surface, and its treatment of noise.

use std::f64::consts::TAU;

use crate::{AbelIntegral, PowerLaw, ProfilePsd};
use serde::Serialize;

use crate::random_surfaces::error::RandomSurfaceError;
use crate::random_surfaces::grading::before_knot;
use crate::random_surfaces::monotone::not_rising;

/// Share of negative roughness up to which it is only clipped; the error of a spectrum is larger.
const CLIPPED_AT_MOST: f64 = 0.01;
/// Range of ln q over which a spectrum is continued: the integral beyond falls at least as 1/q, and e^-37 is the
/// rounding of doubles.
const CONTINUED: f64 = 37.0;

/// The widest step in ln q at which Ciso is sampled.
const WIDEST_STEP: f64 = 0.1;

/// Treatment of wavevectors at which Ciso comes out negative: where C1D rises steeply, as noise makes it, no isotropic
/// surface has these profiles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Conversion {
    /// Negative share of the roughness, 0 to 1: the larger of the shares in Int q |Ciso| and Int q^3 |Ciso|.
    pub negative_share: f64,
    /// True if C1D was replaced by the nearest spectrum that does not rise and has the same m2.
    pub smoothed: bool,
    /// Share of the roughness that was still negative and set to zero.
    pub clipped_share: f64,
}

/// Computes the pieces of Ciso between the first and the last wavevector of a spectrum of profiles.
pub(crate) fn of_profile(profile: &ProfilePsd) -> Result<(Vec<PowerLaw>, Conversion), RandomSurfaceError> {
    if profile.len() < 2 {
        return Err(RandomSurfaceError::TooFewSamples { samples: profile.len() });
    }
    let wavevectors: Vec<f64> =
        profile.wavelengths_m().iter().map(|wavelength_m| TAU / wavelength_m).collect();
    let raw = ciso(&wavevectors, profile.c1d_m3());
    let negative_share = negative_share(&raw);
    if negative_share <= CLIPPED_AT_MOST {
        let conversion = Conversion { negative_share, smoothed: false, clipped_share: negative_share };
        return Ok((positive_pieces(&raw), conversion));
    }
    let smooth = ciso(&wavevectors, &smoothed(&wavevectors, profile.c1d_m3()));
    let conversion =
        Conversion { negative_share, smoothed: true, clipped_share: self::negative_share(&smooth) };
    Ok((positive_pieces(&smooth), conversion))
}

/// Replaces samples where C1D rises by levels with their share of m2 = (1/pi) Int q^2 C1D dq, which decides the area of
/// contact: a narrow peak, as turning leaves it, keeps its slopes. Samples that fall stay as they are.
fn smoothed(wavevectors: &[f64], c1d_m3: &[f64]) -> Vec<f64> {
    let samples = wavevectors.len();
    let (mut slopes, mut widths) = (vec![0.0; samples], vec![0.0; samples]);
    for i in 0..samples - 1 {
        let (start, end) = (wavevectors[i], wavevectors[i + 1]);
        let middle = (start * end).sqrt();
        let law = PowerLaw::through((start, c1d_m3[i]), (end, c1d_m3[i + 1]));
        let level = PowerLaw { at_start: 1.0, exponent: 0.0, ..law };
        for (sample, least, largest) in [(i, start, middle), (i + 1, middle, end)] {
            let part = |of: PowerLaw| of.between(least, largest).map_or(0.0, |part| part.integral(2));
            slopes[sample] += part(law);
            widths[sample] += part(level);
        }
    }
    let means: Vec<f64> = slopes.iter().zip(&widths).map(|(slopes, width)| slopes / width).collect();
    let levels = not_rising(&means, &widths);
    let kept = levels.iter().zip(means).zip(c1d_m3).map(|((level, mean), c1d_m3)| match *level == mean {
        true => *c1d_m3,
        false => *level,
    });
    kept.collect()
}

/// Computes Ciso at the samples and between them, as (wavevector, value).
fn ciso(wavevectors: &[f64], c1d_m3: &[f64]) -> Vec<(f64, f64)> {
    let last = wavevectors.len() - 1;
    let sample = |i: usize| (wavevectors[i], c1d_m3[i]);
    let mut pieces: Vec<PowerLaw> = (0..last).map(|i| PowerLaw::through(sample(i), sample(i + 1))).collect();
    let exponent = pieces[last - 1].exponent.min(0.0);
    let (start_rad_per_m, at_start) = sample(last);
    let end_rad_per_m = start_rad_per_m * (CONTINUED / (1.0 - exponent)).exp();
    pieces.push(PowerLaw { start_rad_per_m, end_rad_per_m, at_start, exponent });
    // -2 C1D', itself a power law.
    let integrand = |piece: PowerLaw| PowerLaw {
        at_start: -2.0 * piece.exponent * piece.at_start / piece.start_rad_per_m,
        exponent: piece.exponent - 1.0,
        ..piece
    };
    let integral = AbelIntegral::new(pieces.into_iter().map(integrand));
    let mut points = vec![wavevectors[0]];
    for pair in wavevectors.windows(2) {
        points.extend(before_knot(pair[0], pair[1], WIDEST_STEP));
        points.push(pair[1]);
    }
    points.into_iter().map(|q| (q, integral.from(q))).collect()
}

/// Computes the larger of the negative shares of height and gradient, by trapezia in ln q.
fn negative_share(ciso: &[(f64, f64)]) -> f64 {
    let share = |power: i32| {
        let (mut all, mut negative) = (0.0, 0.0);
        for pair in ciso.windows(2) {
            let width = (pair[1].0 / pair[0].0).ln();
            for (q, value) in pair {
                let weight = width * q.powi(power);
                all += weight * value.abs();
                negative += weight * (-value).max(0.0);
            }
        }
        if all > 0.0 { negative / all } else { 0.0 }
    };
    share(2).max(share(4))
}

/// Joins neighbours that are both positive by power laws; the rest is left out.
fn positive_pieces(ciso: &[(f64, f64)]) -> Vec<PowerLaw> {
    let positive = ciso.windows(2).filter(|pair| pair.iter().all(|(_, value)| *value > 0.0));
    positive.map(|pair| PowerLaw::through(pair[0], pair[1])).collect()
}
