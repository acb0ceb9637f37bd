//! Deterministic numbers and surfaces of known spectrum.
#![allow(dead_code, reason = "each test file takes what it needs")]

pub mod files;
pub mod holes;

use std::f64::consts::TAU;

/// Splitmix64: numbers between 0 and 1, the same on every machine.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((bits ^ (bits >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn numbers(&mut self, count: usize) -> Vec<f64> {
        (0..count).map(|_| self.next() - 0.5).collect()
    }
}

/// A self-affine spectrum in m^3 with Hurst exponent 0.8 and a roll-off at 2 um.
pub fn self_affine_c1d_m3(q_rad_per_m: f64) -> f64 {
    1e-22 * (1.0 + (q_rad_per_m * 2e-6 / TAU).powi(2)).powf(-1.3)
}

/// A periodic profile with that spectrum at every q = 2 pi n/L below the Nyquist one: fixed amplitudes, random phases.
pub fn periodic_profile_m(points: usize, spacing_m: f64, random: &mut Random) -> Vec<f64> {
    let length_m = spacing_m * points as f64;
    let mut values = vec![numerics::transforms::Complex::new(0.0, 0.0); points];
    for (n, value) in values.iter_mut().enumerate().take(points.div_ceil(2)).skip(1) {
        // a^2/2 = C dq/pi
        let amplitude_m = 2.0 * (self_affine_c1d_m3(TAU * n as f64 / length_m) / length_m).sqrt();
        *value = numerics::transforms::Complex::from_polar(amplitude_m, TAU * random.next());
    }
    numerics::transforms::inverse(points).process(&mut values);
    values.iter().map(|value| value.re).collect()
}
