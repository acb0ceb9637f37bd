//! A smooth ball pressed onto a rough flat.

use std::f64::consts::PI;

use crate::half_space::{Contact, HalfSpaceError, Loading};
use numerics::parallel::Progress;
use spectrum::random_surfaces::RandomSurfaceError;
use tables::Table;
use thiserror::Error;
use units::display::length;
use units::{Bound, OutOfBounds};

use crate::placed::{LARGEST_EXTENT, PressureProfile, RINGS, RINGS_PER_RADIUS};
use crate::relief::{Boundary, Relief};
use crate::surfaces::Surfaces;

/// Smooth ball, a parabola of revolution, under a force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// Radius R \[m\].
    pub radius_m: f64,
    /// Force F \[N\].
    pub force_n: f64,
}

/// Material and tolerance of a solve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallPressing {
    /// Contact modulus E* \[Pa\]; 1/E* is the sum of (1 - nu^2)/E over both bodies.
    pub contact_modulus_pa: f64,
    /// Largest residual, above 0 and at most 0.1.
    pub tolerance: f64,
}

/// Ball on a rough flat in equilibrium.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct BallState {
    /// Force F \[N\].
    pub force_n: f64,
    /// Points with a pressure above 1e-10 of the largest one, times the area of an element \[m^2\].
    pub real_area_m2: f64,
    /// Real area less the staircase around each spot (Yastrebov, Anciaux & Molinari 2017) \[m^2\].
    pub real_area_corrected_m2: f64,
    /// Effective radius (16/(3 pi)) sum p r/sum p \[m\]: Hertz's radius if the pressure is his.
    pub effective_radius_m: f64,
    /// Contact radius of the smooth ball by Hertz \[m\].
    pub hertz_radius_m: f64,
    /// Largest mean pressure over rings around the axis, each an eighth of Hertz's radius wide \[Pa\].
    pub peak_mean_pressure_pa: f64,
    /// Largest pressure of the smooth ball by Hertz \[Pa\].
    pub hertz_pressure_pa: f64,
    /// Share of the force within half of Hertz's radius; 1 - (3/4)^(3/2) for a smooth ball.
    pub force_share: f64,
    /// Largest distance of a point in contact from the axis \[m\].
    pub outermost_contact_m: f64,
    /// Roughness number sigma R/a^2 with Hertz's radius a (Greenwood & Tripp 1967); sigma is the rms height.
    pub roughness_number: f64,
    /// Points of the grid along Hertz's radius.
    pub points_per_radius: f64,
    /// Shorter side of the map over Hertz's radius.
    pub radii_across_map: f64,
    /// Hertz's radius over the radius of the ball.
    pub radius_share: f64,
    /// Residual of the solver.
    pub residual: f64,
    /// Mean pressure \[Pa\] over rings around the axis, each an eighth of Hertz's radius wide; none for a ring without points.
    pub ring_pressures_pa: [Option<f64>; RINGS],
}

/// Reason to doubt the state of a ball.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum BallCaution {
    /// Hertz's radius has fewer than 8 points.
    CoarseGrid {
        /// Points along Hertz's radius.
        points_per_radius: f64,
    },
    /// The map is less than four of Hertz's radii wide.
    NarrowMap {
        /// Shorter side over Hertz's radius.
        radii_across_map: f64,
    },
    /// Hertz's radius is at least a tenth of the ball's, and a sphere is no longer a parabola.
    LargeContact {
        /// Hertz's radius over the radius of the ball.
        radius_share: f64,
    },
}

impl BallState {
    /// Returns the reasons to doubt the state.
    #[must_use]
    pub fn cautions(&self) -> Vec<BallCaution> {
        let Self { points_per_radius, radii_across_map, radius_share, .. } = *self;
        let coarse = (points_per_radius < 8.0).then_some(BallCaution::CoarseGrid { points_per_radius });
        let narrow = (radii_across_map < 4.0).then_some(BallCaution::NarrowMap { radii_across_map });
        let large = (radius_share >= 0.1).then_some(BallCaution::LargeContact { radius_share });
        [coarse, narrow, large].into_iter().flatten().collect()
    }

    /// Returns the distance from the axis \[m\] of the middle of a ring.
    #[must_use]
    pub fn ring_radius_m(&self, ring: usize) -> f64 {
        (ring as f64 + 0.5) / RINGS_PER_RADIUS * self.hertz_radius_m
    }
}

/// Table with a row per state: `realisation, force_n, real_area_m2, effective_radius_m, hertz_radius_m,
/// peak_mean_pressure_pa, hertz_pressure_pa, force_share, outermost_contact_m, real_area_corrected_m2,
/// roughness_number, residual`.
#[must_use]
pub fn ball_table(states: &[BallState]) -> Table {
    let column = |of: fn(&BallState) -> f64| states.iter().map(of);
    Table::default()
        .with_numbers("realisation", (1..=states.len()).map(|number| number as f64))
        .with_numbers("force_n", column(|state| state.force_n))
        .with_numbers("real_area_m2", column(|state| state.real_area_m2))
        .with_numbers("effective_radius_m", column(|state| state.effective_radius_m))
        .with_numbers("hertz_radius_m", column(|state| state.hertz_radius_m))
        .with_numbers("peak_mean_pressure_pa", column(|state| state.peak_mean_pressure_pa))
        .with_numbers("hertz_pressure_pa", column(|state| state.hertz_pressure_pa))
        .with_numbers("force_share", column(|state| state.force_share))
        .with_numbers("outermost_contact_m", column(|state| state.outermost_contact_m))
        .with_numbers("real_area_corrected_m2", column(|state| state.real_area_corrected_m2))
        .with_numbers("roughness_number", column(|state| state.roughness_number))
        .with_numbers("residual", column(|state| state.residual))
}

/// Reason why a ball was not pressed onto a map.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum BallError {
    /// A number is out of its bounds.
    #[error("pressing a ball: {0}")]
    OutOfBounds(#[from] OutOfBounds),
    /// The contact reaches, or would reach, the edges of the map.
    #[error(
        "pressing a ball: the contact reaches {} from the axis, and the map ends at {}; take a map at least {} wide, a \
         smaller ball or less force",
        length(*.reach_m), length(*.half_side_m), length(*.least_side_m)
    )]
    BeyondMap {
        /// Hertz's radius before the solve, or the outermost contact after it \[m\].
        reach_m: f64,
        /// Half of the shorter side of the map \[m\].
        half_side_m: f64,
        /// Shorter side of a map that would hold the contact \[m\].
        least_side_m: f64,
    },
    /// The surface cannot be made.
    #[error(transparent)]
    Surface(#[from] RandomSurfaceError),
    /// The surface cannot be pressed.
    #[error(transparent)]
    HalfSpace(#[from] HalfSpaceError),
}

impl Ball {
    /// Contact radius on a smooth flat by Hertz \[m\].
    #[must_use]
    pub fn hertz_radius_m(&self, contact_modulus_pa: f64) -> f64 {
        (0.75 * self.force_n * self.radius_m / contact_modulus_pa).cbrt()
    }

    /// Largest pressure on a smooth flat by Hertz \[Pa\].
    #[must_use]
    pub fn hertz_pressure_pa(&self, contact_modulus_pa: f64) -> f64 {
        1.5 * self.force_n / (PI * self.hertz_radius_m(contact_modulus_pa).powi(2))
    }

    /// Presses the ball onto the middle of a rough flat that is surrounded by an unloaded half-space, whatever the
    /// boundary of the relief. Returns the state and the contact point by point.
    ///
    /// # Errors
    /// [`BallError`] for numbers out of their bounds, for a contact that reaches the edges of the map, and if
    /// `progress` cancels.
    pub fn press(
        &self,
        flat: &Relief,
        pressing: &BallPressing,
        progress: &dyn Progress,
    ) -> Result<(BallState, Contact), BallError> {
        Bound::Magnitude.check("radius of the ball in m", self.radius_m)?;
        Bound::Magnitude.check("force in N", self.force_n)?;
        Bound::Magnitude.check("contact modulus in Pa", pressing.contact_modulus_pa)?;
        let hertz_radius_m = self.hertz_radius_m(pressing.contact_modulus_pa);
        check_extent(flat, hertz_radius_m)?;
        let parabola = |x_m: f64, y_m: f64| (x_m * x_m + y_m * y_m) / (2.0 * self.radius_m);
        let loaded = flat.less(Boundary::Free, parabola);
        let contact = loaded.press(
            &Loading {
                contact_modulus_pa: pressing.contact_modulus_pa,
                nominal_pressure_pa: self.force_n / (flat.length_x_m * flat.length_y_m),
                saturation_pa: None,
                tolerance: pressing.tolerance,
            },
            progress,
        )?;
        let state = self.state(flat, pressing.contact_modulus_pa, &contact);
        check_extent(flat, state.outermost_contact_m)?;
        Ok((state, contact))
    }

    /// Presses the ball onto every surface: on as many threads as there are, and with the same digits on any number of
    /// them. Places differ widely, so conclusions need several surfaces and their scatter.
    ///
    /// # Errors
    /// The first of the errors of [`Ball::press`], and [`BallError::Surface`] for surfaces that cannot be made.
    pub fn press_all(
        &self,
        surfaces: &Surfaces,
        pressing: &BallPressing,
        progress: &dyn Progress,
    ) -> Result<Vec<BallState>, BallError> {
        let states = numerics::parallel::map_indices(surfaces.count(), |surface| {
            if progress.is_cancelled() {
                return Err(HalfSpaceError::Cancelled.into());
            }
            let relief = surfaces.relief(surface)?;
            self.press(&relief, pressing, progress).map(|(state, _)| state)
        });
        states.into_iter().collect()
    }

    fn state(&self, flat: &Relief, contact_modulus_pa: f64, contact: &Contact) -> BallState {
        let hertz_radius_m = self.hertz_radius_m(contact_modulus_pa);
        let distances_m = flat.places_m().map(|(x_m, y_m)| x_m.hypot(y_m));
        let profile = PressureProfile::new(distances_m, contact, hertz_radius_m);
        let [spacing_x_m, spacing_y_m] = flat.spacings_m();
        BallState {
            force_n: self.force_n,
            real_area_m2: profile.touching as f64 * spacing_x_m * spacing_y_m,
            real_area_corrected_m2: contact.area_fraction_corrected * flat.length_x_m * flat.length_y_m,
            effective_radius_m: 16.0 / (3.0 * PI) * profile.mean_distance_m,
            hertz_radius_m,
            peak_mean_pressure_pa: profile.peak_pa(),
            hertz_pressure_pa: self.hertz_pressure_pa(contact_modulus_pa),
            force_share: profile.force_share,
            outermost_contact_m: profile.outermost_contact_m,
            roughness_number: flat.rms_height_m() * self.radius_m / hertz_radius_m.powi(2),
            points_per_radius: hertz_radius_m / spacing_x_m.max(spacing_y_m),
            radii_across_map: flat.length_x_m.min(flat.length_y_m) / hertz_radius_m,
            radius_share: hertz_radius_m / self.radius_m,
            residual: contact.residual,
            ring_pressures_pa: profile.ring_pressures_pa,
        }
    }
}

fn check_extent(flat: &Relief, reach_m: f64) -> Result<(), BallError> {
    let half_side_m = 0.5 * flat.length_x_m.min(flat.length_y_m);
    if reach_m < LARGEST_EXTENT * half_side_m {
        return Ok(());
    }
    Err(BallError::BeyondMap { reach_m, half_side_m, least_side_m: 2.0 * reach_m / LARGEST_EXTENT })
}
