//! Surfaces to press.

use std::f64::consts::{PI, TAU};

use elements::half_space::{Contact, Elements, Grid, Loading};
use numerics::parallel::Unobserved;

/// Heights row by row, of x and y in periods.
pub fn heights(rows: usize, columns: usize, height: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    let points = (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
    points.map(|(row, column)| height(column as f64 / columns as f64, row as f64 / rows as f64)).collect()
}

/// Waves of all directions up to `shortest` to a side, their heights falling as those of a self-affine surface of Hurst
/// exponent 0.8 beyond `rolloff`, their phases by chance; its gradient has a mean square of 1 over a square of side 1.
pub fn rough(points: usize, rolloff: f64, shortest: i32, seed: u64) -> Vec<f64> {
    let mut state = seed;
    let mut chance = move || {
        // Steele, Lea & Flood (2014), SplitMix.
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((bits ^ (bits >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    };
    let angles: Vec<(f64, f64)> = (0..points).map(|k| (TAU * k as f64 / points as f64).sin_cos()).collect();
    let mut sum = vec![0.0; points * points];
    let mut gradient = 0.0;
    for kx in 0..=shortest {
        for ky in -shortest..=shortest {
            let wave_number = f64::from(kx * kx + ky * ky).sqrt();
            if wave_number > f64::from(shortest) || kx == 0 && ky <= 0 {
                continue;
            }
            let amplitude = wave_number.max(rolloff).powf(-1.8);
            gradient += 0.5 * (amplitude * TAU * wave_number).powi(2);
            let (sin, cos) = (TAU * chance()).sin_cos();
            for row in 0..points {
                let (sy, cy) = angles[(row as i64 * i64::from(ky)).rem_euclid(points as i64) as usize];
                let (s, c) = (amplitude * (sy * cos + cy * sin), amplitude * (cy * cos - sy * sin));
                for column in 0..points {
                    let (sx, cx) = angles[column * kx as usize % points];
                    sum[row * points + column] += cx * c - sx * s;
                }
            }
        }
    }
    sum.iter().map(|height| height / gradient.sqrt()).collect()
}

/// An elastic load on a body of modulus 1.
pub fn elastic(nominal_pressure_pa: f64, tolerance: f64) -> Loading {
    Loading { contact_modulus_pa: 1.0, nominal_pressure_pa, saturation_pa: None, tolerance }
}

/// A load on a body of modulus 1 that yields at `saturation_pa`.
pub fn flowing(nominal_pressure_pa: f64, saturation_pa: f64, tolerance: f64) -> Loading {
    Loading { saturation_pa: Some(saturation_pa), ..elastic(nominal_pressure_pa, tolerance) }
}

/// A square of side 1 pressed once.
pub fn press(heights_m: &[f64], loading: &Loading) -> Contact {
    let points = heights_m.len().isqrt();
    let grid = Grid::new(points, points, 1.0, 1.0).unwrap();
    Elements::periodic(grid, heights_m).unwrap().press(loading, &Unobserved).unwrap()
}

/// The pressure that closes a wave of height 1 and length 1 between bodies of modulus 1.
pub const CLOSING: f64 = PI;
