//! Share of contact at which the last open channel across a randomly rough surface closes as the load rises: ten
//! surfaces of 512^2 points by boundary elements, each in both directions. Takes a minute on one processor.
//!
//! Result: 0.416 of the nominal area with a standard deviation of 0.029 from channel to channel (0.432 counted in
//! points, the perimeter of the spots included), so that the mean of twenty is known to 0.007. Single channels of
//! eight roll-off wavelengths closed from 0.35 to 0.48.

use elements::half_space::{Contact, Elements, Grid, Loading, OpenPaths, Sides, open_paths};
use numerics::parallel::Unobserved;
use spectrum::random_surfaces::{AreaSpectrum, Phases, RandomSurface, SelfAffine, Size, Synthesis};

const POINTS: usize = 512;
const SURFACES: u64 = 10;
const SEED: u64 = 1;
const BOX_M: f64 = 1e-3;
/// Longest wave, with a plateau between it and the roll-off, so that many waves of the roll-off fit side by side.
const LONGEST_M: f64 = BOX_M / 2.0;
const ROLLOFF_M: f64 = BOX_M / 8.0;
/// Shortest wave: eight points.
const SHORTEST_M: f64 = BOX_M / 64.0;
const RMS_GRADIENT: f64 = 0.05;
const CONTACT_MODULUS_PA: f64 = 100e9;
/// Bracket of p/(E* h'): channels are open at the first value, and shut at the second.
const OPEN_TO_SHUT: [f64; 2] = [0.08, 0.48];
/// Halvings of that bracket, down to a hundredth of the nominal area in contact.
const HALVINGS: usize = 6;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let spectrum = AreaSpectrum::self_affine(&SelfAffine {
        hurst_exponent: 0.8,
        longest_m: LONGEST_M,
        rolloff_m: ROLLOFF_M,
        shortest_m: SHORTEST_M,
        size: Size::RmsGradient(RMS_GRADIENT),
    })?;
    println!(
        "surface, share of points in contact where the channel is lost along x, along y, less their perimeter"
    );
    let mut lost = Vec::new();
    for number in 0..SURFACES {
        let synthesis = Synthesis::square(POINTS, BOX_M, SEED, Phases::FixedModulus);
        let [x, y] = TriedSurface::new(&spectrum.surface(&synthesis, number)?)?.lost()?;
        println!(
            "{number}, {:.4}, {:.4}, {:.4}, {:.4}",
            x.share_of_points, y.share_of_points, x.area_fraction, y.area_fraction
        );
        lost.extend([x, y]);
    }
    for (name, of) in [
        ("share of points", (|lost| lost.share_of_points) as fn(&ClosingArea) -> f64),
        ("less their perimeter", |lost| lost.area_fraction),
    ] {
        let shares: Vec<f64> = lost.iter().map(of).collect();
        let (mean, deviation) = mean_and_deviation(&shares);
        let least = shares.iter().copied().fold(1.0, f64::min);
        let most = shares.iter().copied().fold(0.0, f64::max);
        println!("{name}: mean {mean:.4}, standard deviation {deviation:.4}, {least:.4} to {most:.4}");
    }
    Ok(())
}

/// Surface with its results under the loads so far.
struct TriedSurface {
    elements: Elements,
    /// Results by p/(E* h'): area in contact, and open directions.
    known: Vec<(f64, ClosingArea, OpenPaths)>,
}

/// Area in contact when a channel closes.
#[derive(Clone, Copy)]
struct ClosingArea {
    share_of_points: f64,
    area_fraction: f64,
}

impl TriedSurface {
    fn new(surface: &RandomSurface) -> Result<Self, Box<dyn std::error::Error>> {
        let grid = Grid::new(surface.points_y, surface.points_x, surface.length_x_m, surface.length_y_m)?;
        Ok(TriedSurface { elements: Elements::periodic(grid, &surface.heights_m)?, known: Vec::new() })
    }

    /// Areas at which the channels along x and along y close.
    fn lost(&mut self) -> Result<[ClosingArea; 2], Box<dyn std::error::Error>> {
        Ok([self.lost_along(|paths| paths.along_x)?, self.lost_along(|paths| paths.along_y)?])
    }

    fn lost_along(
        &mut self,
        is_open: fn(OpenPaths) -> bool,
    ) -> Result<ClosingArea, Box<dyn std::error::Error>> {
        let [mut open, mut shut] = OPEN_TO_SHUT;
        let (mut before, paths) = self.under(open)?;
        let (mut after, shut_paths) = self.under(shut)?;
        if !is_open(paths) || is_open(shut_paths) {
            return Err("the bracket of loads does not hold the one at which the channel is lost".into());
        }
        for _ in 0..HALVINGS {
            let load = 0.5 * (open + shut);
            let (areas, paths) = self.under(load)?;
            if is_open(paths) {
                (open, before) = (load, areas);
            } else {
                (shut, after) = (load, areas);
            }
        }
        Ok(ClosingArea {
            share_of_points: 0.5 * (before.share_of_points + after.share_of_points),
            area_fraction: 0.5 * (before.area_fraction + after.area_fraction),
        })
    }

    fn under(&mut self, load: f64) -> Result<(ClosingArea, OpenPaths), Box<dyn std::error::Error>> {
        if let Some(&(_, areas, paths)) = self.known.iter().find(|(known, ..)| *known == load) {
            return Ok((areas, paths));
        }
        let loading = Loading {
            contact_modulus_pa: CONTACT_MODULUS_PA,
            nominal_pressure_pa: load * CONTACT_MODULUS_PA * RMS_GRADIENT,
            saturation_pa: None,
            tolerance: 1e-6,
        };
        let contact: Contact = self.elements.press(&loading, &Unobserved)?;
        let paths = open_paths(self.elements.grid(), Sides::Periodic, &contact.touching())?;
        let areas = ClosingArea {
            share_of_points: contact.numbers.area_fraction,
            area_fraction: contact.numbers.area_fraction_corrected,
        };
        self.known.push((load, areas, paths));
        Ok((areas, paths))
    }
}

fn mean_and_deviation(values: &[f64]) -> (f64, f64) {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let squares: f64 = values.iter().map(|value| (value - mean) * (value - mean)).sum();
    (mean, (squares / (count - 1.0)).sqrt())
}
