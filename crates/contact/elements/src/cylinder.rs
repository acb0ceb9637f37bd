//! A smooth cylinder pressed onto a rough flat that repeats itself.

use std::f64::consts::PI;

use crate::half_space::{Contact, HalfSpaceError, Loading};
use numerics::parallel::Progress;
use spectrum::random_surfaces::RandomSurfaceError;
use tables::Table;
use thiserror::Error;
use units::display::length;
use units::{Bound, OutOfBounds};

use crate::ball::BallPressing;
use crate::placed::{LARGEST_EXTENT, PressureProfile};
use crate::relief::{Boundary, Relief};
use crate::surfaces::Surfaces;

/// Smooth cylinder along y, a parabola along x, under a force per length.
///
/// The box repeats itself along and across. A cylinder of finite length would carry several times Hertz's pressure at its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// Radius R \[m\].
    pub radius_m: f64,
    /// Force per length F' \[N/m\].
    pub force_n_per_m: f64,
}

/// Cylinder on a rough flat in equilibrium.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct CylinderState {
    /// Force per length F' \[N/m\].
    pub force_n_per_m: f64,
    /// Real area per length \[m\]: points with a pressure above 1e-10 of the largest one, times the area of an element, over the
    /// length of the box. A smooth cylinder has twice the half-width.
    pub real_width_m: f64,
    /// Real area per length less the staircase around each spot (Yastrebov, Anciaux & Molinari 2017) \[m\].
    pub real_width_corrected_m: f64,
    /// Effective half-width (3 pi/4) sum p |x|/sum p \[m\]: Hertz's half-width if the pressure is his.
    pub effective_half_width_m: f64,
    /// Half-width of the contact of the smooth cylinder by Hertz, sqrt(4 F' R/(pi E*)) \[m\].
    pub hertz_half_width_m: f64,
    /// Largest mean pressure over strips along the axis, each an eighth of Hertz's half-width wide on both sides \[Pa\].
    pub peak_mean_pressure_pa: f64,
    /// Largest pressure of the smooth cylinder by Hertz, sqrt(F' E*/(pi R)) \[Pa\].
    pub hertz_pressure_pa: f64,
    /// Share of the force within half of Hertz's half-width; 1/3 + sqrt(3)/(2 pi) = 0.609 for a smooth cylinder.
    pub force_share: f64,
    /// Largest distance of a point in contact from the axis \[m\].
    pub outermost_contact_m: f64,
    /// Roughness number sigma R/a^2 with Hertz's half-width a; sigma is the rms height.
    pub roughness_number: f64,
    /// Points of the grid across Hertz's half-width.
    pub points_per_half_width: f64,
    /// Length of the box across the cylinder over Hertz's half-width.
    pub half_widths_across_box: f64,
    /// Hertz's half-width over the radius of the cylinder.
    pub half_width_share: f64,
    /// Residual of the solver.
    pub residual: f64,
}

/// Reason to doubt the state of a cylinder.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum CylinderCaution {
    /// Hertz's half-width has fewer than 8 points.
    CoarseGrid {
        /// Points across Hertz's half-width.
        points_per_half_width: f64,
    },
    /// The box is less than ten of Hertz's half-widths wide, so that its images are felt.
    NarrowBox {
        /// Length across the cylinder over Hertz's half-width.
        half_widths_across_box: f64,
        /// Relative excess (pi a/L)^2/12 of the largest pressure of a smooth cylinder over Hertz's.
        pressure_excess: f64,
    },
    /// Hertz's half-width is at least a tenth of the radius, and a cylinder is no longer a parabola.
    LargeContact {
        /// Hertz's half-width over the radius of the cylinder.
        half_width_share: f64,
    },
}

impl CylinderState {
    /// Returns the reasons to doubt the state.
    #[must_use]
    pub fn cautions(&self) -> Vec<CylinderCaution> {
        let Self { points_per_half_width, half_widths_across_box, half_width_share, .. } = *self;
        let pressure_excess = (PI / half_widths_across_box).powi(2) / 12.0;
        let coarse =
            (points_per_half_width < 8.0).then_some(CylinderCaution::CoarseGrid { points_per_half_width });
        let narrow = (half_widths_across_box < 10.0)
            .then_some(CylinderCaution::NarrowBox { half_widths_across_box, pressure_excess });
        let large = (half_width_share >= 0.1).then_some(CylinderCaution::LargeContact { half_width_share });
        [coarse, narrow, large].into_iter().flatten().collect()
    }
}

/// Table with a row per state: `realisation, force_n_per_m, real_width_m, effective_half_width_m, hertz_half_width_m,
/// peak_mean_pressure_pa, hertz_pressure_pa, force_share, outermost_contact_m, real_width_corrected_m, roughness_number,
/// residual`.
#[must_use]
pub fn cylinder_table(states: &[CylinderState]) -> Table {
    let column = |of: fn(&CylinderState) -> f64| states.iter().map(of);
    Table::default()
        .with_numbers("realisation", (1..=states.len()).map(|number| number as f64))
        .with_numbers("force_n_per_m", column(|state| state.force_n_per_m))
        .with_numbers("real_width_m", column(|state| state.real_width_m))
        .with_numbers("effective_half_width_m", column(|state| state.effective_half_width_m))
        .with_numbers("hertz_half_width_m", column(|state| state.hertz_half_width_m))
        .with_numbers("peak_mean_pressure_pa", column(|state| state.peak_mean_pressure_pa))
        .with_numbers("hertz_pressure_pa", column(|state| state.hertz_pressure_pa))
        .with_numbers("force_share", column(|state| state.force_share))
        .with_numbers("outermost_contact_m", column(|state| state.outermost_contact_m))
        .with_numbers("real_width_corrected_m", column(|state| state.real_width_corrected_m))
        .with_numbers("roughness_number", column(|state| state.roughness_number))
        .with_numbers("residual", column(|state| state.residual))
}

/// Reason why a cylinder was not pressed onto a flat.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum CylinderError {
    /// A number is out of its bounds.
    #[error("pressing a cylinder: {0}")]
    OutOfBounds(#[from] OutOfBounds),
    /// The contact reaches, or would reach, the next image of the cylinder.
    #[error(
        "pressing a cylinder: the contact reaches {} from the axis, and the box ends at {}; take a surface at least {} wide, a \
         smaller cylinder or less force",
        length(*.reach_m), length(*.half_side_m), length(*.least_side_m)
    )]
    BeyondBox {
        /// Hertz's half-width before the solve, or the outermost contact after it \[m\].
        reach_m: f64,
        /// Half of the length of the box across the cylinder \[m\].
        half_side_m: f64,
        /// Length of a box that would hold the contact \[m\].
        least_side_m: f64,
    },
    /// The surface cannot be made.
    #[error(transparent)]
    Surface(#[from] RandomSurfaceError),
    /// The surface cannot be pressed.
    #[error(transparent)]
    HalfSpace(#[from] HalfSpaceError),
}

impl Cylinder {
    /// Half-width of the contact with a smooth flat by Hertz \[m\].
    #[must_use]
    pub fn hertz_half_width_m(&self, contact_modulus_pa: f64) -> f64 {
        (4.0 * self.force_n_per_m * self.radius_m / (PI * contact_modulus_pa)).sqrt()
    }

    /// Largest pressure on a smooth flat by Hertz \[Pa\].
    #[must_use]
    pub fn hertz_pressure_pa(&self, contact_modulus_pa: f64) -> f64 {
        (self.force_n_per_m * contact_modulus_pa / (PI * self.radius_m)).sqrt()
    }

    /// Presses the cylinder, its axis along y in the middle of the map, onto a rough flat that repeats itself along
    /// and across, whatever the boundary of the relief. Returns the state and the contact point by point.
    ///
    /// On a smooth flat the pressure is Hertz's times 1 + (pi a/L)^2/12, for a half-width a and a length L across.
    ///
    /// # Errors
    /// [`CylinderError`] for numbers out of their bounds, for a contact that reaches the edges of the box, and if
    /// `progress` cancels.
    pub fn press(
        &self,
        flat: &Relief,
        pressing: &BallPressing,
        progress: &dyn Progress,
    ) -> Result<(CylinderState, Contact), CylinderError> {
        Bound::Magnitude.check("radius of the cylinder in m", self.radius_m)?;
        Bound::Magnitude.check("force per length in N/m", self.force_n_per_m)?;
        Bound::Magnitude.check("contact modulus in Pa", pressing.contact_modulus_pa)?;
        check_reach(flat, self.hertz_half_width_m(pressing.contact_modulus_pa))?;
        let loaded = flat.less(Boundary::Periodic, |x_m, _| x_m * x_m / (2.0 * self.radius_m));
        let loading = Loading {
            contact_modulus_pa: pressing.contact_modulus_pa,
            nominal_pressure_pa: self.force_n_per_m / flat.length_x_m,
            saturation_pa: None,
            tolerance: pressing.tolerance,
        };
        let contact = loaded.press(&loading, progress)?;
        let state = self.state(flat, pressing.contact_modulus_pa, &contact);
        check_reach(flat, state.outermost_contact_m)?;
        Ok((state, contact))
    }

    /// Presses the cylinder onto every surface: on as many threads as there are, and with the same digits on any number of
    /// them.
    ///
    /// # Errors
    /// The first of the errors of [`Cylinder::press`], and [`CylinderError::Surface`] for surfaces that cannot be made.
    pub fn press_all(
        &self,
        surfaces: &Surfaces,
        pressing: &BallPressing,
        progress: &dyn Progress,
    ) -> Result<Vec<CylinderState>, CylinderError> {
        let states = numerics::parallel::map_indices(surfaces.count(), |surface| {
            if progress.is_cancelled() {
                return Err(HalfSpaceError::Cancelled.into());
            }
            let relief = surfaces.relief(surface)?;
            self.press(&relief, pressing, progress).map(|(state, _)| state)
        });
        states.into_iter().collect()
    }

    fn state(&self, flat: &Relief, contact_modulus_pa: f64, contact: &Contact) -> CylinderState {
        let hertz_half_width_m = self.hertz_half_width_m(contact_modulus_pa);
        let distances_m = flat.places_m().map(|(x_m, _)| x_m.abs());
        let profile = PressureProfile::new(distances_m, contact, hertz_half_width_m);
        let [spacing_x_m, spacing_y_m] = flat.spacings_m();
        CylinderState {
            force_n_per_m: self.force_n_per_m,
            real_width_m: profile.touching as f64 * spacing_x_m * spacing_y_m / flat.length_y_m,
            real_width_corrected_m: contact.area_fraction_corrected * flat.length_x_m,
            effective_half_width_m: 0.75 * PI * profile.mean_distance_m,
            hertz_half_width_m,
            peak_mean_pressure_pa: profile.peak_pa(),
            hertz_pressure_pa: self.hertz_pressure_pa(contact_modulus_pa),
            force_share: profile.force_share,
            outermost_contact_m: profile.outermost_contact_m,
            roughness_number: flat.rms_height_m() * self.radius_m / hertz_half_width_m.powi(2),
            points_per_half_width: hertz_half_width_m / spacing_x_m,
            half_widths_across_box: flat.length_x_m / hertz_half_width_m,
            half_width_share: hertz_half_width_m / self.radius_m,
            residual: contact.residual,
        }
    }
}

fn check_reach(flat: &Relief, reach_m: f64) -> Result<(), CylinderError> {
    let half_side_m = 0.5 * flat.length_x_m;
    if reach_m < LARGEST_EXTENT * half_side_m {
        return Ok(());
    }
    Err(CylinderError::BeyondBox { reach_m, half_side_m, least_side_m: 2.0 * reach_m / LARGEST_EXTENT })
}
