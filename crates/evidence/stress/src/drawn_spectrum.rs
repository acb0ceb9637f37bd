//! Spectra of every shape, as wavelengths and densities.

use crate::{Draw, Reach};

/// Draws a spectrum C1D: wavelengths \[m\] that fall strictly, and densities \[m^3\].
///
/// Steps are a unit in the last place, a usual ratio, or a hole of decades. Densities fall or rise by a power that may
/// change at every sample, and jump.
pub(crate) fn drawn_spectrum(draw: &mut Draw, reach: Reach) -> Vec<(f64, f64)> {
    const MOST_SAMPLES: f64 = 25.0;
    let ([longest, density, slope], jumps) = match reach {
        Reach::Usual => ([(-6.0, -2.0), (-9.0, -2.0), (0.5, 3.2)], 0.05),
        _ => ([(-12.0, 3.0), (-30.0, 10.0), (-6.0, 9.0)], 0.15),
    };
    let mut wavelength_m = reach.number(draw, longest.0, longest.1);
    let mut c1d_m3 = wavelength_m.powi(3) * draw.decades(density.0, density.1);
    let steady = draw.between(slope.0, slope.1);
    let is_steady = draw.chance(0.5);
    let count = draw.between(1.0, MOST_SAMPLES) as usize;
    let mut samples = vec![(wavelength_m, c1d_m3)];
    for _ in 1..count {
        let next_m = match draw.between(0.0, 1.0) {
            share if share < 0.02 => wavelength_m.next_down(),
            share if share < 0.04 => wavelength_m * (1.0 - draw.decades(-14.0, -3.0)),
            share if share < 0.10 => wavelength_m * draw.decades(-4.0, -0.5),
            _ => wavelength_m * draw.decades(-0.4, -0.01),
        };
        let power = if is_steady { steady } else { draw.between(slope.0, slope.1) };
        c1d_m3 *= (next_m / wavelength_m).powf(power);
        if draw.chance(jumps) {
            c1d_m3 *= draw.decades(-3.0, 3.0);
        }
        if reach == Reach::Edge && draw.chance(0.1) {
            c1d_m3 = draw.edge();
        }
        wavelength_m = next_m;
        samples.push((wavelength_m, c1d_m3));
    }
    samples
}
