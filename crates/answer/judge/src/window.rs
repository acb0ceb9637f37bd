//! Windows of a spectrum: bands that a grid can hold, half a decade apart.

use spectrum::ProfilePsd;

use crate::JudgeError;
use crate::waves::Waves;

/// The distance between the beginnings of neighbouring windows, in decades.
const STEP_DECADES: f64 = 0.5;
/// Points of the grid on the shortest wavelength.
pub(crate) const POINTS_PER_SHORTEST: f64 = 4.0;
/// Those on surfaces of one range of waves: with four, elements find 9 % too much area on a white band under light loads.
const POINTS_PER_SHORTEST_OF_ONE_RANGE: f64 = 8.0;
/// Nayak's alpha of the last window below which a surface counts as one range of waves.
const ALPHA_OF_ONE_RANGE: f64 = 4.0;
/// The least side of the box over the longest wavelength.
pub(crate) const LENGTHS_IN_BOX: f64 = 2.0;
/// Decades by which the spectrum of profiles extends beyond the longest wave of the surface: profiles see long waves where
/// the surface has none. Less than a hundredth of their variance lies farther out.
const FLAT_DECADES: f64 = 1.0;
/// The fewest scales that a model takes.
const MIN_SCALES: usize = 3;
/// Scales per decade of the spectrum for moments, which falls to zero at the last wavelength like a square root.
const FINE_PER_DECADE: f64 = 40.0;

/// The band of a window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Band {
    pub longest_m: f64,
    pub shortest_m: f64,
}

impl Band {
    /// The wavelength \[m\] in the middle of the band's decades.
    pub fn middle_m(self) -> f64 {
        (self.longest_m * self.shortest_m).sqrt()
    }
}

/// A part of the surface: all its waves within a band, and no others.
#[derive(Debug, Clone)]
pub(crate) struct Window {
    pub band: Band,
    /// The surface's own waves, cut.
    pub waves: Waves,
    /// Twice the rms pressure of their full contact over E*: on half-spaces the rms gradient of the surface.
    pub flattening_gradient: f64,
    /// Points along each side of its grid.
    pub points: usize,
    /// The side \[m\] of the box in which it is pressed: longer where the grid has more points than the band needs, since light loads
    /// rest on few summits of the longest waves.
    pub box_m: f64,
}

/// Points of a grid with `grid` points along a side on the shortest wavelength of a surface: more if the waves of the last window
/// are of one range.
pub(crate) fn points_per_shortest(waves: &Waves, whole: Band, grid: usize) -> f64 {
    let longest_m = whole.shortest_m * 10f64.powf(decades_held(grid, POINTS_PER_SHORTEST));
    let last = waves.cut(longest_m.min(whole.longest_m), whole.shortest_m);
    match last.is_ok_and(|last| last.alpha() < ALPHA_OF_ONE_RANGE) {
        true => POINTS_PER_SHORTEST_OF_ONE_RANGE,
        false => POINTS_PER_SHORTEST,
    }
}

/// The decades of wavelength that a grid with `grid` points along a side holds.
pub(crate) fn decades_held(grid: usize, points_per_shortest: f64) -> f64 {
    (grid as f64 / (points_per_shortest * LENGTHS_IN_BOX)).log10()
}

/// The bands of the windows, from long to short wavelengths; one where the grid holds the whole band.
pub(crate) fn bands(whole: Band, decades: f64) -> Vec<Band> {
    let surplus = (whole.longest_m / whole.shortest_m).log10() - decades;
    if surplus <= 0.0 {
        return vec![whole];
    }
    let steps = (surplus / STEP_DECADES).ceil();
    let band = |step: usize| {
        let behind = (STEP_DECADES * step as f64).min(surplus);
        let longest_m = whole.longest_m * 10f64.powf(-behind);
        let shortest_m = (longest_m * 10f64.powf(-decades)).max(whole.shortest_m);
        Band { longest_m, shortest_m }
    };
    (0..=steps as usize).map(band).collect()
}

impl Window {
    /// Cuts the surface to a band, to be pressed on a grid with `points` along each side, `per_shortest` of them on the shortest wave.
    pub fn new(whole: &Waves, band: Band, points: usize, per_shortest: f64) -> Result<Self, JudgeError> {
        let waves = whole.cut(band.longest_m, band.shortest_m)?;
        let flattening_gradient = waves.flattening_gradient();
        let box_m = (points as f64 / per_shortest * band.shortest_m).max(LENGTHS_IN_BOX * band.longest_m);
        Ok(Window { band, waves, flattening_gradient, points, box_m })
    }

    /// The window prolonged towards longer waves, as far as a grid with `points` along each side holds it and the whole band
    /// of the surface has waves.
    pub fn prolonged(&self, whole: &Waves, longest_m: f64, points: usize) -> Result<Self, JudgeError> {
        let Band { shortest_m, longest_m: held_m } = self.band;
        let held_m = held_m * points as f64 / self.points as f64;
        let per_shortest = self.points as f64 * shortest_m / self.box_m;
        Window::new(whole, Band { longest_m: held_m.min(longest_m), shortest_m }, points, per_shortest)
    }

    /// The number of points of its grid.
    pub fn grid_points(&self) -> f64 {
        (self.points * self.points) as f64
    }

    /// The spectrum of the window's profiles, dense enough for its moments.
    pub fn fine_profile(&self) -> Result<ProfilePsd, JudgeError> {
        self.profile(FINE_PER_DECADE, true)
    }

    /// The spectrum of the window's profiles at `scales_per_decade`, for models that stack scales.
    pub fn stacked_profile(&self, scales_per_decade: f64) -> Result<ProfilePsd, JudgeError> {
        self.profile(scales_per_decade, false)
    }

    fn profile(&self, per_decade: f64, to_the_end: bool) -> Result<ProfilePsd, JudgeError> {
        let Band { longest_m, shortest_m } = self.band;
        let decades = FLAT_DECADES + (longest_m / shortest_m).log10();
        let steps = (per_decade * decades).round().max(2.0);
        let from_m = longest_m * 10f64.powf(FLAT_DECADES);
        let place = |step: usize| from_m * 10f64.powf(-decades * step as f64 / steps);
        let mut wavelengths_m: Vec<f64> = (0..steps as usize).map(place).collect();
        if to_the_end {
            let last_step = 10f64.powf(decades / steps) - 1.0;
            let closer = |halvings: i32| shortest_m * (1.0 + last_step * 0.5f64.powi(halvings));
            wavelengths_m.extend((1..=12).map(closer));
        }
        // Noise may leave a surface no waves at its short end; there its profiles have no spectrum.
        loop {
            match self.waves.surface.profile(&wavelengths_m) {
                Err(_) if wavelengths_m.len() > MIN_SCALES => wavelengths_m.truncate(wavelengths_m.len() - 1),
                found => return Ok(found?),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use spectrum::random_surfaces::AreaSpectrum;
    use spectrum::{Convention, Psd};

    use super::*;

    #[test]
    fn windows_begin_half_a_decade_apart_and_end_with_the_spectrum() {
        let whole = Band { longest_m: 1e-4, shortest_m: 1e-8 };
        let bands = bands(whole, 1.2);
        assert_eq!(bands.len(), 7);
        assert_eq!(bands[0].longest_m, 1e-4);
        for pair in bands.windows(2) {
            let apart = (pair[0].longest_m / pair[1].longest_m).log10();
            assert!(apart > 0.0 && apart < STEP_DECADES + 1e-9, "{apart}");
        }
        for band in &bands {
            assert!(((band.longest_m / band.shortest_m).log10() - 1.2).abs() < 1e-9);
        }
        assert!((bands[6].shortest_m / 1e-8 - 1.0).abs() < 1e-9);
    }

    #[test]
    fn a_short_spectrum_is_one_window() {
        let whole = Band { longest_m: 1e-6, shortest_m: 1e-7 };
        assert_eq!(bands(whole, 1.0), [whole]);
        assert_eq!(decades_held(256, 4.0), 32f64.log10());
    }

    /// The waves of an area whose spectrum is the same everywhere from 1 um down to 10 nm.
    fn white() -> Waves {
        let wavelengths_m = (0..=20).map(|at| 1e-6 * 10f64.powf(-0.1 * f64::from(at))).collect();
        let psd = Psd::new(wavelengths_m, vec![1e-36; 21], Convention::Ciso).unwrap();
        Waves::new(AreaSpectrum::from_psd(&psd).unwrap(), None)
    }

    #[test]
    fn a_window_has_a_box_of_two_longest_waves_or_more_and_is_prolonged_as_far_as_more_points_hold() {
        let near = |found: f64, expected: f64| (found / expected - 1.0).abs() < 1e-9;
        let band = |longest_m, shortest_m| Band { longest_m, shortest_m };
        let whole = white();
        let window = Window::new(&whole, band(1e-7, 2e-8), 64, 4.0).unwrap();
        assert!(near(window.box_m, 3.2e-7) && window.grid_points() == 4096.0);
        assert!(near(window.band.middle_m(), 2e-9f64.sqrt() * 1e-3));
        assert!(near(Window::new(&whole, band(2e-7, 2e-8), 64, 4.0).unwrap().box_m, 4e-7));
        // A gradient of a spectrum C from q0 to q1 has the mean square C (q1^4 - q0^4)/(8 pi).
        let fourth = |wavelength_m: f64| (2.0 * PI / wavelength_m).powi(4);
        let mean_square = 1e-36 * (fourth(2e-8) - fourth(1e-7)) / (8.0 * PI);
        assert!(near(window.flattening_gradient, mean_square.sqrt()));
        for (points, longest_m) in [(128, 2e-7), (320, 5e-7), (1024, 6e-7)] {
            let longer = window.prolonged(&whole, 6e-7, points).unwrap();
            assert!(near(longer.band.longest_m, longest_m) && longer.band.shortest_m == 2e-8);
            // The spacing stays that of the window.
            assert!(near(longer.box_m, 3.2e-7 / 64.0 * points as f64) && longer.points == points);
        }
        // One range of waves has twice the points.
        assert_eq!(points_per_shortest(&whole, band(1e-6, 1e-8), 64), 8.0);
        let steep: Vec<f64> = (0..=20).map(|at| 1e-36 * 10f64.powf(-0.36 * f64::from(at))).collect();
        let psd = Psd::new(
            (0..=20).map(|at| 1e-6 * 10f64.powf(-0.1 * f64::from(at))).collect(),
            steep,
            Convention::Ciso,
        );
        let steep = Waves::new(AreaSpectrum::from_psd(&psd.unwrap()).unwrap(), None);
        assert_eq!(points_per_shortest(&steep, band(1e-6, 1e-8), 512), 4.0);
        assert_eq!(points_per_shortest(&steep, band(1e-6, 1e-8), 24), 8.0);
        // A white area from q0 to q1 = 10 q0: alpha = 2 (1 - r^2) (1 - r^6)/(1 - r^4)^2.
        let alpha = whole.cut(1e-7, 1e-8).unwrap().alpha();
        assert!(near(alpha, 2.0 * 0.99 * (1.0 - 1e-6) / (1.0 - 1e-4f64).powi(2)), "{alpha}");
    }

    #[test]
    fn profiles_of_a_window_begin_a_decade_above_it_and_end_near_its_last_wave() {
        let window = Window::new(&white(), Band { longest_m: 1e-6, shortest_m: 1e-7 }, 64, 4.0).unwrap();
        let near = |found: f64, expected: f64| (found / expected - 1.0).abs() < 1e-9;
        let stacked = window.stacked_profile(10.0).unwrap();
        let fine = window.fine_profile().unwrap();
        // Two decades, without the last wave, at which the spectrum is 0.
        for (profile, per_decade, steps) in [(&stacked, 10.0, 20), (&fine, 40.0, 80)] {
            for (at, wavelength_m) in profile.wavelengths_m()[..steps].iter().enumerate() {
                assert!(
                    near(*wavelength_m, 1e-5 * 10f64.powf(-(at as f64) / per_decade)),
                    "{at} {wavelength_m}"
                );
            }
        }
        assert_eq!((stacked.len(), fine.len()), (20, 92));
        // Twelve more halve the distance to it.
        for (at, wavelength_m) in fine.wavelengths_m()[80..].iter().enumerate() {
            let beyond = (10f64.powf(0.025) - 1.0) * 0.5f64.powi(at as i32 + 1);
            assert!(near(*wavelength_m, 1e-7 * (1.0 + beyond)), "{at} {wavelength_m}");
        }
        assert_eq!(window.stacked_profile(0.1).unwrap().len(), 2);
    }
}
