//! Places on a relief from its middle, where balls and cylinders stand, and the pressure over the distance from there.

use crate::half_space::Contact;

use crate::boundary::Boundary;
use crate::relief::Relief;

/// Largest distance of a contact from the axis, as a share of half the shorter side: beyond it the edges of a map carry load
/// like those of a punch, and images in a box are felt.
pub const LARGEST_EXTENT: f64 = 0.9;

/// Least pressure of a point in contact, as a share of the largest pressure.
const TOUCHING: f64 = 1e-10;

/// Rings in Hertz's radius or half-width, over which pressures are averaged.
pub(crate) const RINGS_PER_RADIUS: f64 = 8.0;

/// Rings of the averaged pressure, out to four of Hertz's radii.
pub(crate) const RINGS: usize = 32;

/// Rings among which the peak of the averaged pressure is searched.
const SEARCHED_RINGS: usize = 16;

/// Pressure of a contact over the distance from its middle.
pub(crate) struct PressureProfile {
    /// Mean pressure \[Pa\] over rings, each an eighth of Hertz's radius wide; none for a ring without points.
    pub ring_pressures_pa: [Option<f64>; RINGS],
    /// Mean distance of the load \[m\], sum p r/sum p.
    pub mean_distance_m: f64,
    /// Share of the load within half of Hertz's radius.
    pub force_share: f64,
    /// Number of points in contact.
    pub touching: usize,
    /// Largest distance of a point in contact \[m\].
    pub outermost_contact_m: f64,
}

impl PressureProfile {
    /// Averages the pressures of points at distances \[m\] from the middle, with Hertz's radius or half-width \[m\].
    pub fn new(distances_m: impl Iterator<Item = f64>, contact: &Contact, hertz_m: f64) -> Self {
        let least_pa = TOUCHING * contact.numbers.largest_pressure_pa;
        let mut rings = [(0.0, 0usize); RINGS];
        let (mut sum_pa, mut moment, mut inner_pa) = (0.0, 0.0, 0.0);
        let (mut touching, mut outermost_contact_m) = (0usize, 0.0f64);
        for (distance_m, &pressure_pa) in distances_m.zip(&contact.pressures_pa) {
            let ring = (RINGS_PER_RADIUS * distance_m / hertz_m) as usize;
            if let Some((sum, count)) = rings.get_mut(ring) {
                *sum += pressure_pa;
                *count += 1;
            }
            sum_pa += pressure_pa;
            moment += pressure_pa * distance_m;
            if distance_m < 0.5 * hertz_m {
                inner_pa += pressure_pa;
            }
            if pressure_pa > least_pa {
                touching += 1;
                outermost_contact_m = outermost_contact_m.max(distance_m);
            }
        }
        PressureProfile {
            ring_pressures_pa: rings.map(|(sum_pa, count)| (count > 0).then(|| sum_pa / count as f64)),
            mean_distance_m: moment / sum_pa,
            force_share: inner_pa / sum_pa,
            touching,
            outermost_contact_m,
        }
    }

    /// Largest mean pressure over a ring within two of Hertz's radii \[Pa\].
    pub fn peak_pa(&self) -> f64 {
        self.ring_pressures_pa[..SEARCHED_RINGS].iter().copied().flatten().fold(0.0, f64::max)
    }
}

impl Relief {
    /// Spacings along x and y \[m\].
    pub(crate) fn spacings_m(&self) -> [f64; 2] {
        [self.length_x_m / self.columns as f64, self.length_y_m / self.rows as f64]
    }

    /// Places of the points from the middle of the map, row by row \[m\].
    pub(crate) fn places_m(&self) -> impl Iterator<Item = (f64, f64)> + use<> {
        let (rows, columns) = (self.rows, self.columns);
        let [spacing_x_m, spacing_y_m] = self.spacings_m();
        let place_m = |at: usize, count: usize, spacing_m| (at as f64 + 0.5 - 0.5 * count as f64) * spacing_m;
        (0..rows * columns).map(move |point| {
            (place_m(point % columns, columns, spacing_x_m), place_m(point / columns, rows, spacing_y_m))
        })
    }

    /// Returns the relief less a shape over the places from its middle.
    pub(crate) fn less(&self, boundary: Boundary, shape_m: impl Fn(f64, f64) -> f64) -> Self {
        let heights_m = self.heights_m.iter().zip(self.places_m());
        let heights_m = heights_m.map(|(height_m, (x_m, y_m))| height_m - shape_m(x_m, y_m)).collect();
        Self { heights_m, boundary, is_missing: self.is_missing.clone(), ..*self }
    }

    /// Rms height about the mean \[m\].
    pub(crate) fn rms_height_m(&self) -> f64 {
        let count = self.heights_m.len() as f64;
        let mean_m = self.heights_m.iter().sum::<f64>() / count;
        let squares = self.heights_m.iter().map(|height_m| (height_m - mean_m).powi(2));
        (squares.sum::<f64>() / count).sqrt()
    }
}
