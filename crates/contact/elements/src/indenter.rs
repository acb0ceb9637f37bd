//! A smooth ball or cylinder pressed onto a rough flat.

use std::f64::consts::PI;

use crate::half_space::{Contact, HalfSpaceError, Loading};
use numerics::parallel::Progress;
use spectrum::random_surfaces::RandomSurfaceError;
use tables::Table;
use thiserror::Error;
use units::display::length;
use units::{Bound, OutOfBounds, Remark, RemarkCode};

use crate::boundary::Boundary;
use crate::placed::{LARGEST_EXTENT, PressureProfile, RINGS, RINGS_PER_RADIUS};
use crate::relief::Relief;
use crate::surfaces::Surfaces;

/// Shape of an indenter.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum IndenterShape {
    /// A parabola of revolution, on a flat that is surrounded by an unloaded half-space.
    #[default]
    Ball,
    /// A parabola along x, its axis along y, on a flat that repeats itself along and across. A cylinder of finite length would
    /// carry several times Hertz's pressure at its ends.
    Cylinder,
}

units::named!(IndenterShape, "shape of the indenter", { Ball => "ball", Cylinder => "cylinder" });

/// Smooth indenter under a force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Indenter {
    /// Shape.
    pub shape: IndenterShape,
    /// Radius R \[m\].
    pub radius_m: f64,
    /// Force F \[N\]; force per length F' \[N/m\] of a cylinder.
    pub force: f64,
}

/// Material and tolerance of a solve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IndenterPressing {
    /// Contact modulus E* \[Pa\]; 1/E* is the sum of (1 - nu^2)/E over both bodies.
    pub contact_modulus_pa: f64,
    /// Largest residual, above 0 and at most 0.1.
    pub tolerance: f64,
}

/// Indenter on a rough flat in equilibrium. The radius of the contact of a cylinder is its half-width.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct IndenterState {
    /// Shape of the indenter.
    pub shape: IndenterShape,
    /// Force F \[N\]; force per length F' \[N/m\] of a cylinder.
    pub force: f64,
    /// Points with a pressure above 1e-10 of the largest one, times the area of an element \[m^2\]; over the length of the map
    /// \[m\] for a cylinder, so that a smooth one has twice the half-width.
    pub real_area: f64,
    /// Real area less the staircase around each spot (Yastrebov, Anciaux & Molinari 2017), in the same unit.
    pub real_area_corrected: f64,
    /// Effective radius \[m\], Hertz's if the pressure is his: (16/(3 pi)) sum p r/sum p, or (3 pi/4) sum p |x|/sum p.
    pub effective_radius_m: f64,
    /// Contact radius of the smooth indenter by Hertz \[m\].
    pub hertz_radius_m: f64,
    /// Largest mean pressure over rings around the axis, each an eighth of Hertz's radius wide \[Pa\].
    pub peak_mean_pressure_pa: f64,
    /// Largest pressure of the smooth indenter by Hertz \[Pa\].
    pub hertz_pressure_pa: f64,
    /// Share of the force within half of Hertz's radius; 1 - (3/4)^(3/2) for a smooth ball, 1/3 + sqrt(3)/(2 pi) for a smooth
    /// cylinder.
    pub force_share: f64,
    /// Largest distance of a point in contact from the axis \[m\].
    pub outermost_contact_m: f64,
    /// Roughness number sigma R/a^2 with Hertz's radius a (Greenwood & Tripp 1967); sigma is the rms height.
    pub roughness_number: f64,
    /// Points of the grid along Hertz's radius.
    pub points_per_radius: f64,
    /// Width of the map over Hertz's radius.
    pub radii_across_map: f64,
    /// Hertz's radius over the radius of the indenter.
    pub radius_share: f64,
    /// Residual of the solver.
    pub residual: f64,
    /// Mean pressure \[Pa\] over rings around the axis, each an eighth of Hertz's radius wide; none for a ring without points.
    pub ring_pressures_pa: [Option<f64>; RINGS],
}

impl IndenterState {
    /// Lists the reasons to doubt the state.
    #[must_use]
    pub fn remarks(&self) -> Vec<Remark> {
        let Self { points_per_radius: points, radii_across_map: radii, radius_share: share, .. } = *self;
        let (least_radii, [coarse, narrow, large]) = match self.shape {
            IndenterShape::Ball => {
                (4.0, [RemarkCode::BallCoarseGrid, RemarkCode::BallNarrowMap, RemarkCode::BallLargeContact])
            }
            IndenterShape::Cylinder => (
                10.0,
                [
                    RemarkCode::CylinderCoarseGrid,
                    RemarkCode::CylinderNarrowBox,
                    RemarkCode::CylinderLargeContact,
                ],
            ),
        };
        let narrow = Remark::new(narrow).with("radii_across_map", radii);
        let found = [
            (points < 8.0, Remark::new(coarse).with("points_per_radius", points)),
            (radii < least_radii, narrow.with("pressure_excess", (PI / radii).powi(2) / 12.0)),
            (share >= 0.1, Remark::new(large).with("radius_share", share)),
        ];
        found.into_iter().filter_map(|(is_found, remark)| is_found.then_some(remark)).collect()
    }

    /// Returns the distance from the axis \[m\] of the middle of a ring.
    #[must_use]
    pub fn ring_radius_m(&self, ring: usize) -> f64 {
        (ring as f64 + 0.5) / RINGS_PER_RADIUS * self.hertz_radius_m
    }
}

/// Table of states under indenters of one shape, a row for each: `realisation, force_n, real_area_m2, effective_radius_m,
/// hertz_radius_m, peak_mean_pressure_pa, hertz_pressure_pa, force_share, outermost_contact_m, real_area_corrected_m2,
/// roughness_number, residual`; for cylinders `force_n_per_m`, `real_width_m`, `effective_half_width_m`,
/// `hertz_half_width_m` and `real_width_corrected_m` stand for their like.
#[must_use]
pub fn indenter_table(shape: IndenterShape, states: &[IndenterState]) -> Table {
    let [force, area, effective, hertz, corrected] = match shape {
        IndenterShape::Ball => {
            ["force_n", "real_area_m2", "effective_radius_m", "hertz_radius_m", "real_area_corrected_m2"]
        }
        IndenterShape::Cylinder => [
            "force_n_per_m",
            "real_width_m",
            "effective_half_width_m",
            "hertz_half_width_m",
            "real_width_corrected_m",
        ],
    };
    let column = |of: fn(&IndenterState) -> f64| states.iter().map(of);
    Table::default()
        .with_numbers("realisation", (1..=states.len()).map(|number| number as f64))
        .with_numbers(force, column(|state| state.force))
        .with_numbers(area, column(|state| state.real_area))
        .with_numbers(effective, column(|state| state.effective_radius_m))
        .with_numbers(hertz, column(|state| state.hertz_radius_m))
        .with_numbers("peak_mean_pressure_pa", column(|state| state.peak_mean_pressure_pa))
        .with_numbers("hertz_pressure_pa", column(|state| state.hertz_pressure_pa))
        .with_numbers("force_share", column(|state| state.force_share))
        .with_numbers("outermost_contact_m", column(|state| state.outermost_contact_m))
        .with_numbers(corrected, column(|state| state.real_area_corrected))
        .with_numbers("roughness_number", column(|state| state.roughness_number))
        .with_numbers("residual", column(|state| state.residual))
}

/// Reason why an indenter was not pressed onto a flat.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum IndenterError {
    /// A number is out of its bounds.
    #[error("pressing a {shape}: {error}")]
    OutOfBounds {
        /// Shape of the indenter.
        shape: IndenterShape,
        /// The number and its bounds.
        error: OutOfBounds,
    },
    /// The contact reaches, or would reach, the edges of the map or the next image of a cylinder.
    #[error(
        "pressing a {shape}: the contact reaches {} from the axis, and the map ends at {}; take a map at least {} wide, a \
         smaller {shape} or less force",
        length(*.reach_m), length(*.half_side_m), length(*.least_side_m)
    )]
    BeyondMap {
        /// Shape of the indenter.
        shape: IndenterShape,
        /// Hertz's radius before the solve, or the outermost contact after it \[m\].
        reach_m: f64,
        /// Half of the width of the map \[m\].
        half_side_m: f64,
        /// Width of a map that would hold the contact \[m\].
        least_side_m: f64,
    },
    /// The surface cannot be made.
    #[error(transparent)]
    Surface(#[from] RandomSurfaceError),
    /// The surface cannot be pressed.
    #[error(transparent)]
    HalfSpace(#[from] HalfSpaceError),
}

impl Indenter {
    /// Contact radius on a smooth flat by Hertz \[m\]: (3 F R/(4 E*))^(1/3), or sqrt(4 F' R/(pi E*)).
    #[must_use]
    pub fn hertz_radius_m(&self, contact_modulus_pa: f64) -> f64 {
        match self.shape {
            IndenterShape::Ball => (0.75 * self.force * self.radius_m / contact_modulus_pa).cbrt(),
            IndenterShape::Cylinder => (4.0 * self.force * self.radius_m / (PI * contact_modulus_pa)).sqrt(),
        }
    }

    /// Largest pressure on a smooth flat by Hertz \[Pa\]: 3 F/(2 pi a^2), or sqrt(F' E*/(pi R)).
    #[must_use]
    pub fn hertz_pressure_pa(&self, contact_modulus_pa: f64) -> f64 {
        match self.shape {
            IndenterShape::Ball => 1.5 * self.force / (PI * self.hertz_radius_m(contact_modulus_pa).powi(2)),
            IndenterShape::Cylinder => (self.force * contact_modulus_pa / (PI * self.radius_m)).sqrt(),
        }
    }

    /// Presses the indenter onto the middle of a rough flat, whatever the boundary of the relief. Returns the state and the
    /// contact point by point.
    ///
    /// Under a cylinder on a smooth flat the pressure is Hertz's times 1 + (pi a/L)^2/12, for a half-width a and a length L
    /// across.
    ///
    /// # Errors
    /// [`IndenterError`] for numbers out of their bounds, for a contact that reaches the edges of the map, and if
    /// `progress` cancels.
    pub fn press(
        &self,
        flat: &Relief,
        pressing: &IndenterPressing,
        progress: &dyn Progress,
    ) -> Result<(IndenterState, Contact), IndenterError> {
        let Indenter { shape, radius_m, force } = *self;
        let [radius_in, force_in] = match shape {
            IndenterShape::Ball => ["radius of the ball in m", "force in N"],
            IndenterShape::Cylinder => ["radius of the cylinder in m", "force per length in N/m"],
        };
        let checked = [
            (radius_in, radius_m),
            (force_in, force),
            ("contact modulus in Pa", pressing.contact_modulus_pa),
        ];
        for (name, number) in checked {
            Bound::Magnitude
                .check(name, number)
                .map_err(|error| IndenterError::OutOfBounds { shape, error })?;
        }
        flat.check_whole()?;
        self.check_extent(flat, self.hertz_radius_m(pressing.contact_modulus_pa))?;
        let (loaded, nominal_pressure_pa) = match shape {
            IndenterShape::Ball => {
                let parabola = |x_m: f64, y_m: f64| (x_m * x_m + y_m * y_m) / (2.0 * radius_m);
                (flat.less(Boundary::Free, parabola), force / (flat.length_x_m * flat.length_y_m))
            }
            IndenterShape::Cylinder => {
                let parabola = |x_m: f64, _| x_m * x_m / (2.0 * radius_m);
                (flat.less(Boundary::Periodic, parabola), force / flat.length_x_m)
            }
        };
        let loading = Loading {
            contact_modulus_pa: pressing.contact_modulus_pa,
            nominal_pressure_pa,
            saturation_pa: None,
            tolerance: pressing.tolerance,
        };
        let contact = loaded.press(&loading, progress)?;
        let state = self.state(flat, pressing.contact_modulus_pa, &contact);
        self.check_extent(flat, state.outermost_contact_m)?;
        Ok((state, contact))
    }

    /// Presses the indenter onto every surface: on as many threads as there are, and with the same digits on any number of
    /// them. Places differ widely, so conclusions need several surfaces and their scatter.
    ///
    /// # Errors
    /// The first of the errors of [`Indenter::press`], and [`IndenterError::Surface`] for surfaces that cannot be made.
    pub fn press_all(
        &self,
        surfaces: &Surfaces,
        pressing: &IndenterPressing,
        progress: &dyn Progress,
    ) -> Result<Vec<IndenterState>, IndenterError> {
        let states = numerics::parallel::map_indices(surfaces.count(), |surface| {
            if progress.is_cancelled() {
                return Err(HalfSpaceError::Cancelled.into());
            }
            let relief = surfaces.relief(surface)?;
            self.press(&relief, pressing, progress).map(|(state, _)| state)
        });
        states.into_iter().collect()
    }

    fn state(&self, flat: &Relief, contact_modulus_pa: f64, contact: &Contact) -> IndenterState {
        let Indenter { shape, radius_m, force } = *self;
        let hertz_radius_m = self.hertz_radius_m(contact_modulus_pa);
        let distances_m = flat.places_m().map(|(x_m, y_m)| match shape {
            IndenterShape::Ball => x_m.hypot(y_m),
            IndenterShape::Cylinder => x_m.abs(),
        });
        let profile = PressureProfile::new(distances_m, contact, hertz_radius_m);
        let [spacing_x_m, spacing_y_m] = flat.spacings_m();
        let touching_m2 = profile.touching as f64 * spacing_x_m * spacing_y_m;
        let corrected_m = contact.numbers.area_fraction_corrected * flat.length_x_m;
        let (real_area, real_area_corrected, over_mean_distance, spacing_m) = match shape {
            IndenterShape::Ball => {
                (touching_m2, corrected_m * flat.length_y_m, 16.0 / (3.0 * PI), spacing_x_m.max(spacing_y_m))
            }
            IndenterShape::Cylinder => (touching_m2 / flat.length_y_m, corrected_m, 0.75 * PI, spacing_x_m),
        };
        IndenterState {
            shape,
            force,
            real_area,
            real_area_corrected,
            effective_radius_m: over_mean_distance * profile.mean_distance_m,
            hertz_radius_m,
            peak_mean_pressure_pa: profile.peak_pa(),
            hertz_pressure_pa: self.hertz_pressure_pa(contact_modulus_pa),
            force_share: profile.force_share,
            outermost_contact_m: profile.outermost_contact_m,
            roughness_number: flat.rms_height_m() * radius_m / hertz_radius_m.powi(2),
            points_per_radius: hertz_radius_m / spacing_m,
            radii_across_map: self.width_m(flat) / hertz_radius_m,
            radius_share: hertz_radius_m / radius_m,
            residual: contact.numbers.residual,
            ring_pressures_pa: profile.ring_pressures_pa,
        }
    }

    /// Width of a map \[m\] that the contact must leave room in: its shorter side, or across the cylinder.
    fn width_m(&self, flat: &Relief) -> f64 {
        match self.shape {
            IndenterShape::Ball => flat.length_x_m.min(flat.length_y_m),
            IndenterShape::Cylinder => flat.length_x_m,
        }
    }

    fn check_extent(&self, flat: &Relief, reach_m: f64) -> Result<(), IndenterError> {
        let (shape, half_side_m) = (self.shape, 0.5 * self.width_m(flat));
        if reach_m < LARGEST_EXTENT * half_side_m {
            return Ok(());
        }
        let least_side_m = 2.0 * reach_m / LARGEST_EXTENT;
        Err(IndenterError::BeyondMap { shape, reach_m, half_side_m, least_side_m })
    }
}
